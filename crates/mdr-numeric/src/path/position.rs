//! The position of the contact on a path.

use std::cmp::Ordering;

use mdr_core::contact::{Error, Fold, Result};
use mdr_core::number::Real;

use super::ContactState;
use crate::branch::EquilibriumBranches;

/// The position of the contact, apart from the value of the controlled quantity.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Position {
    Detached,
    /// On a stable branch.
    Branch(usize),
    /// At rest at a fold.
    Fold(usize),
    /// The path has ended.
    Ended,
}

/// The state at `value`, with the contact at a position; `None` if it would be beyond the end of the last branch.
pub(super) fn state<R: Real, B: EquilibriumBranches<R>>(
    branches: &B,
    place: Position,
    value: &R,
) -> Result<Option<ContactState<R>>> {
    Ok(match place {
        Position::Detached => Some(ContactState::Detached),
        Position::Branch(branch) => branches.on_branch(branch, value)?.map(ContactState::Contact),
        Position::Fold(fold) => branches.folds().get(fold).map(at_fold),
        Position::Ended => None,
    })
}

/// The equilibrium at a fold.
pub(super) fn at_fold<R: Real>(fold: &Fold<R>) -> ContactState<R> {
    ContactState::Contact(fold.clone().into())
}

/// The order of two values of the controlled quantity, if it is certain.
pub(super) fn certain<R: Real, B: EquilibriumBranches<R>>(one: &R, other: &R, branches: &B) -> Result<Ordering> {
    let undecided = || Error::undecided(branches.control().quantity(), one, "which of two values of it is larger");
    one.partial_cmp(other).ok_or_else(undecided)
}
