//! The curve of equilibria cut at its folds: what a loading path needs to know of a contact, in any arithmetic.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Equilibrium, Error, FoldKind, Instability, Outcome, Quantity, Result, Stability};
use mdr_core::number::Real;

use crate::admissible::{Admissibility, Ring, Touch};
use crate::curve::Curve;

/// The curve of equilibria cut at its folds. Between two folds the controlled quantity is monotone, so each branch holds
/// at most one equilibrium at a value.
///
/// Branches are counted by increasing radius: branch i lies between fold i − 1 and fold i, branch 0 begins at a = 0 and
/// the last one ends where the profile does. Minima and maxima of the controlled quantity alternate; a branch is stable
/// from a minimum up to the next maximum.
///
/// In a rigorous arithmetic comparisons are partial. What is not certain is [`Error::Undecided`], never a guess.
pub trait Branched<R: Real> {
    /// What is controlled.
    fn control(&self) -> &Control<R>;

    /// The folds, by increasing radius. A pole, where g is infinite, is one among them whose indentation and force are
    /// infinite; no value is beyond it.
    fn folds(&self) -> &[Instability<R>];

    /// The equilibrium at `value` of the controlled quantity on a branch, its ends excluded. On the last branch of a
    /// profile with a [wall](mdr_core::contact::Transform::wall) the contact may rest at the wall. A branch that does not
    /// exist holds none.
    ///
    /// # Errors
    /// Those of the transform; [`Error::Undecided`].
    fn on_branch(&self, branch: usize, value: &R) -> Result<Option<Equilibrium<R>>>;

    /// `value` against that of the fold; equal where they cannot be told apart in this arithmetic.
    ///
    /// # Errors
    /// Those of the transform; [`Error::Undecided`].
    fn compare(&self, value: &R, fold: &Instability<R>) -> Result<Ordering> {
        let at_fold = self.control().controlled(&fold.indentation, &fold.force);
        value.partial_cmp(&at_fold).ok_or_else(|| unordered(self.control(), value))
    }

    /// How contact begins at the tip; [`onset`] finds out.
    ///
    /// # Errors
    /// Those of the transform; [`Error::Undecided`].
    fn onset(&self) -> Result<Onset>;

    /// Which states are admissible.
    fn admissibility(&self) -> &Admissibility<'_>;

    /// Where surfaces apart first touch, when that is not the tip.
    ///
    /// # Errors
    /// As [`first_touch`](crate::admissible::first_touch); [`Error::Unproved`] over enclosures.
    fn first_touch(&self) -> Result<Option<Touch<R>>>;

    /// The last admissible state on the stable branch between two contact radii, and the ring on which the surfaces touch.
    ///
    /// # Errors
    /// As [`last_admissible`](crate::admissible::last_admissible); [`Error::Unproved`] over enclosures.
    fn last_admissible(&self, radii: [&R; 2]) -> Result<Option<(Equilibrium<R>, Ring<R>)>>;

    /// Whether the edge of a contact that grows at a held value is pressed so hard at a radius, g − d < −Δl, that to grow costs
    /// energy.
    ///
    /// # Errors
    /// Those of the transform.
    fn is_pushed_back(&self, radius: &R, value: &R) -> Result<bool>;

    /// Where the last branch ends.
    ///
    /// # Errors
    /// Those of the transform; [`Error::Undecided`] over enclosures in place of [`End::Unknown`], as more bits may find the
    /// equilibrium that was not found before it.
    fn end(&self) -> Result<End<R>>;

    /// All equilibria at `value`, by increasing radius; none is an empty list. At a fold itself the double root is one,
    /// [`Neutral`](mdr_core::contact::Stability::Neutral).
    ///
    /// # Errors
    /// As [`Branched::on_branch`]; [`Error::Domain`] unless the value is finite.
    fn equilibria(&self, value: &R) -> Result<Vec<Equilibrium<R>>> {
        self.control().check_value(value)?;
        let mut found = Vec::new();
        for branch in 0..=self.folds().len() {
            found.extend(self.on_branch(branch, value)?);
            let Some(fold) = self.folds().get(branch) else { continue };
            if self.compare(value, fold)? == Ordering::Equal {
                found.push(fold.clone().into());
            }
        }
        Ok(found)
    }

    /// Whether equilibria on a branch are stable; none where no fold bounds it.
    fn is_stable(&self, branch: usize) -> Option<bool> {
        let below = branch.checked_sub(1).and_then(|fold| self.folds().get(fold));
        let above = self.folds().get(branch);
        below.map(|fold| fold.kind == FoldKind::Minimum).or(above.map(|fold| fold.kind == FoldKind::Maximum))
    }

    /// The equilibrium that the contact reaches from a fold, given by its index, when the controlled quantity goes a little
    /// beyond it, and its branch: the next one in the direction of change, smaller past a minimum, larger past a maximum.
    ///
    /// # Errors
    /// As [`Branched::on_branch`].
    fn landing(&self, fold: usize) -> Result<Option<(usize, Equilibrium<R>)>> {
        let Some(start) = self.folds().get(fold) else { return Ok(None) };
        let value = self.control().controlled(&start.indentation, &start.force);
        match start.kind {
            FoldKind::Minimum => seek(self, &value, fold.checked_sub(1), Way::Smaller),
            FoldKind::Maximum => seek(self, &value, Some(fold + 2), Way::Larger),
        }
    }

    /// What becomes of the contact at a fold when the controlled quantity goes a little beyond it: the radius of its
    /// [landing](Branched::landing), or where there is none it has detached past a minimum, and covers the whole surface
    /// past a maximum.
    ///
    /// # Errors
    /// As [`Branched::on_branch`]; [`Error::Undecided`] past a maximum where the profile ends. An index that does not exist has [`Outcome::Detached`].
    fn outcome(&self, fold: usize) -> Result<Outcome<R>> {
        let kind = self.folds().get(fold).map(|fold| fold.kind);
        Ok(match (self.landing(fold)?, kind) {
            (Some((_, rest)), _) => Outcome::Jump { to: rest.contact_radius },
            (None, Some(FoldKind::Maximum)) if self.end()? == End::Open => Outcome::CompleteContact,
            (None, Some(FoldKind::Maximum)) => {
                return Err(beyond_reach(self.control(), &self.folds()[fold].contact_radius));
            }
            (None, _) => Outcome::Detached,
        })
    }
}

/// Where the last branch ends.
#[derive(Clone, Debug, PartialEq)]
pub enum End<R> {
    /// At no radius: the contact can grow for ever.
    Open,
    /// At the outer radius, in this state.
    Profile(Equilibrium<R>),
    /// At an outer radius of which no state is known: at a wall, where g is infinite, or where it cannot be had.
    Unknown,
}

/// The end of the last branch of a curve.
///
/// # Errors
/// Those of the transform.
pub(crate) fn end<R: Real>(curve: &Curve<'_, R>) -> Result<End<R>> {
    let Some(contact_radius) = curve.transform().outer_radius() else { return Ok(End::Open) };
    if curve.wall().is_some() {
        return Ok(End::Unknown);
    }
    match curve.state(&contact_radius) {
        Ok((indentation, force)) if indentation.is_finite() && force.is_finite() => {
            Ok(End::Profile(Equilibrium { contact_radius, indentation, force, stability: Stability::Stable }))
        }
        Ok(_) | Err(Error::Domain { .. } | Error::OutOfRange { .. } | Error::NoConvergence { .. }) => Ok(End::Unknown),
        Err(error) => Err(error),
    }
}

/// How a contact begins, a = d = F = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Onset {
    /// The controlled quantity grows with the radius: contact grows smoothly from a point.
    Smooth,
    /// It falls: once they touch, the surfaces jump into contact.
    Abrupt,
    /// The tip is the deepest point of a dimple, g < 0 near it: the surfaces cannot touch there first.
    Dimple,
}

/// How contact begins on a curve with the given first fold: from the sign of g close to the tip, and from whether the first
/// branch is stable.
///
/// "Close" is the unit roundoff times w/E* or times the radius of the fold, whichever is smaller.
///
/// # Errors
/// Those of the transform; [`Error::Undecided`] over enclosures that do not tell.
pub fn onset<R: Real>(curve: &Curve<'_, R>, first: Option<&Instability<R>>) -> Result<Onset> {
    let length = curve.material_length();
    let radius = first.map(|fold| fold.contact_radius.clone()).filter(|radius| *radius < length).unwrap_or(length);
    let close = (radius.unit_roundoff() * &radius).steer();
    let undecided = |what| Error::Undecided { quantity: Quantity::ContactRadius, bits: radius.precision(), what };
    let g = curve.transform().g(&close)?;
    if g < g.lit(0) {
        return Ok(Onset::Dimple);
    }
    if !(g >= g.lit(0)) {
        return Err(undecided("whether the profile has a dimple at its tip"));
    }
    let stable = match first {
        Some(fold) => fold.kind == FoldKind::Maximum,
        None => match curve.tangency(&close)?.partial_cmp(&curve.threshold_at(&close)) {
            Some(order) => order == Ordering::Greater,
            None => return Err(undecided("whether contact grows smoothly from a point")),
        },
    };
    Ok(if stable { Onset::Smooth } else { Onset::Abrupt })
}

/// An equilibrium that is not found, although the contact grows as far as can be seen and its profile ends further out.
pub(crate) fn beyond_reach<R: Real>(control: &Control<R>, like: &R) -> Error {
    let what = "where beyond the radii that were looked at the equilibrium lies";
    Error::Undecided { quantity: control.quantity(), bits: like.precision(), what }
}

/// A value that is neither below that of a fold nor above it.
pub fn unordered<R: Real>(control: &Control<R>, value: &R) -> Error {
    let what = "whether it is below or above its value at a fold";
    Error::Undecided { quantity: control.quantity(), bits: value.precision(), what }
}

/// Which way the radius goes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Way {
    Smaller,
    Larger,
}

/// The first equilibrium at `value` on a stable branch, from branch `next` on.
///
/// The near end of each branch is known to be on this side of the value; it is on the branch if it does not reach the far
/// end.
pub(crate) fn seek<R: Real, B: Branched<R> + ?Sized>(
    branches: &B,
    value: &R,
    mut next: Option<usize>,
    way: Way,
) -> Result<Option<(usize, Equilibrium<R>)>> {
    while let Some(branch) = next.filter(|branch| *branch <= branches.folds().len()) {
        let (far_end, within) = match way {
            Way::Smaller => (branch.checked_sub(1), Ordering::Greater),
            Way::Larger => (Some(branch), Ordering::Less),
        };
        let holds = match far_end.and_then(|end| branches.folds().get(end)) {
            Some(end) => branches.compare(value, end)? == within,
            None => true,
        };
        if holds && let Some(rest) = branches.on_branch(branch, value)? {
            return Ok(Some((branch, rest)));
        }
        next = match way {
            Way::Smaller => branch.checked_sub(2),
            Way::Larger => Some(branch + 2),
        };
    }
    Ok(None)
}
