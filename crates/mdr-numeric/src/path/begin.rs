//! The states in which a path can begin.

use std::cmp::Ordering;

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

use super::position::{Position, certain, state};
use super::{ContactState, Start};
use crate::branch::{End, EquilibriumBranches, FirstContact, beyond_reach};

/// The position and the state in which a path begins at its first way point.
pub(super) fn begin<R: Real, B: EquilibriumBranches<R>>(
    branches: &B,
    start: &Start<R>,
    value: &R,
) -> Result<(Position, ContactState<R>)> {
    branches.control().check_value(value)?;
    let count = branches.folds().len();
    let found = match start {
        Start::Detached => is_apart(branches, value)?.then_some((Position::Detached, ContactState::Detached)),
        Start::Smallest => {
            first_at_rest(branches, (0..=count).flat_map(|i| [Position::Branch(i), Position::Fold(i)]), value)?
        }
        Start::Largest => {
            first_at_rest(branches, (0..=count).rev().flat_map(|i| [Position::Fold(i), Position::Branch(i)]), value)?
        }
        Start::Nearest(radius) => nearest(branches, radius, value)?,
    };
    found.ok_or_else(|| Error::no_equilibrium(branches.control().quantity(), value))
}

/// Whether the surfaces are apart at `value`, or just touch.
fn is_apart<R: Real, B: EquilibriumBranches<R>>(branches: &B, value: &R) -> Result<bool> {
    let zero = value.lit(0);
    let reaches = |depth: &R| certain(value, &branches.control().controlled(depth, &zero), branches);
    if let Some(bound) = still_apart(branches, &zero) {
        return match reaches(&bound)? {
            Ordering::Greater if *value > zero => Ok(false),
            Ordering::Greater => branches.first_touch().map(|_| false),
            _ => Ok(true),
        };
    }
    let depth = branches.first_touch()?.map_or(zero.clone(), |touch| touch.indentation);
    Ok(reaches(&depth)? != Ordering::Greater)
}

/// An indentation at which separated surfaces do not touch yet, if the indentation at which they first touch is not decided.
pub(super) fn still_apart<R: Real, B: EquilibriumBranches<R>>(branches: &B, like: &R) -> Option<R> {
    let bound = branches.admissibility().open_touch()?;
    Some(R::from_f64(like.ctx(), if bound.is_finite() { bound } else { -f64::MAX }))
}

/// The first of the positions at which a contact is in stable equilibrium at `value`.
fn first_at_rest<R: Real, B: EquilibriumBranches<R>>(
    branches: &B,
    places: impl Iterator<Item = Position>,
    value: &R,
) -> Result<Option<(Position, ContactState<R>)>> {
    for place in places {
        if let Some(state) = at_rest(branches, place, value)? {
            return Ok(Some((place, state)));
        }
    }
    Ok(None)
}

/// The position in stable equilibrium whose radius is nearest to `radius`, in ratio.
fn nearest<R: Real, B: EquilibriumBranches<R>>(
    branches: &B,
    radius: &R,
    value: &R,
) -> Result<Option<(Position, ContactState<R>)>> {
    let radius = Error::require_positive(Quantity::ContactRadius, radius.clone())?;
    let mut best: Option<(R, Position, ContactState<R>)> = None;
    for place in (0..=branches.folds().len()).flat_map(|i| [Position::Branch(i), Position::Fold(i)]) {
        let Some(ContactState::Contact(rest)) = at_rest(branches, place, value)? else { continue };
        let distance = (rest.contact_radius.ln() - radius.ln()).abs();
        let nearer = match &best {
            Some((least, ..)) => certain(&distance, least, branches)? == Ordering::Less,
            None => true,
        };
        if nearer {
            best = Some((distance, place, ContactState::Contact(rest)));
        }
    }
    Ok(best.map(|(_, place, state)| (place, state)))
}

/// The state at a position, if the position is stable and has a state at `value`.
fn at_rest<R: Real, B: EquilibriumBranches<R>>(
    branches: &B,
    place: Position,
    value: &R,
) -> Result<Option<ContactState<R>>> {
    let side = |fold: Option<usize>| -> Result<Option<Ordering>> {
        fold.and_then(|fold| branches.folds().get(fold)).map(|fold| branches.compare(value, fold)).transpose()
    };
    let holds = match place {
        Position::Branch(branch) => {
            let stable = match branches.is_stable(branch) {
                Some(stable) => stable,
                None => branches.onset()? == FirstContact::Smooth,
            };
            // The ends of a stable branch are a minimum and a maximum.
            stable
                && side(branch.checked_sub(1))?.is_none_or(|side| side == Ordering::Greater)
                && side(Some(branch))?.is_none_or(|side| side == Ordering::Less)
        }
        Position::Fold(fold) => side(Some(fold))? == Some(Ordering::Equal),
        Position::Detached | Position::Ended => false,
    };
    let found = if holds { state(branches, place, value)? } else { None };
    // The controlled quantity increases along the last stable branch to the end of the profile, so the branch has an
    // equilibrium unless it ends below the value.
    let rises_to_it = |branch: usize| branch == branches.folds().len() && (branch > 0 || *value > value.lit(0));
    let missed = holds && found.is_none() && matches!(place, Position::Branch(branch) if rises_to_it(branch));
    if missed && branches.end()? == End::Unknown {
        return Err(beyond_reach(branches.control(), value));
    }
    Ok(found)
}
