//! The curve of equilibria cut at its folds, in any arithmetic: the interface that a loading path uses.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Equilibrium, Error, Fold, FoldKind, Outcome, Quantity, Result, Stability, Transform};
use mdr_core::number::Real;

use crate::admissible::{Admissibility, GapVerdict, Ring, Touch};
use crate::contact::Contact;

/// The curve of equilibria cut at its folds. Between two folds the controlled quantity is monotone, so each branch
/// contains at most one equilibrium at a value.
///
/// Branches are counted by increasing radius: branch i lies between fold i − 1 and fold i, branch 0 begins at a = 0 and
/// the last one ends with the profile. Minima and maxima of the controlled quantity alternate; a branch is stable from
/// a minimum up to the next maximum.
///
/// In a rigorous arithmetic comparisons are partial. A decision that is not certain is [`Error::Undecided`].
pub trait EquilibriumBranches<R: Real> {
    /// The controlled quantity.
    fn control(&self) -> &Control<R>;

    /// The folds, by increasing radius. A pole, where g diverges, is included as a fold with infinite indentation and
    /// force; no value lies beyond it.
    fn folds(&self) -> &[Fold<R>];

    /// The equilibrium at `value` of the controlled quantity on a branch, its ends excluded. On the last branch of a
    /// profile with a [vertical edge](mdr_core::contact::Transform::vertical_edge) the contact edge may be at the vertical edge.
    /// `None` on a branch that does not exist.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Undecided`] if the arithmetic does not decide.
    fn on_branch(&self, branch: usize, value: &R) -> Result<Option<Equilibrium<R>>>;

    /// The equilibrium as [`on_branch`](EquilibriumBranches::on_branch) finds it, looked for first near a radius at which it is expected;
    /// the second radius is at the distance of a first step from that one.
    ///
    /// # Errors
    /// Errors of [`on_branch`](EquilibriumBranches::on_branch).
    fn on_branch_near(&self, branch: usize, value: &R, _near: [&R; 2]) -> Result<Option<Equilibrium<R>>> {
        self.on_branch(branch, value)
    }

    /// The order of `value` and the value of the fold; equal if this arithmetic does not distinguish them.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Undecided`] if the arithmetic does not decide.
    fn compare(&self, value: &R, fold: &Fold<R>) -> Result<Ordering> {
        let at_fold = self.control().controlled(&fold.indentation, &fold.force);
        value.partial_cmp(&at_fold).ok_or_else(|| unordered(self.control(), value))
    }

    /// Whether two radii are one number; over enclosures, copies of one enclosure, as those of a kink or a vertical edge are.
    fn is_same(&self, one: &R, other: &R) -> bool {
        one == other
    }

    /// The limit of the controlled quantity at the tip, where the first branch begins.
    fn tip_value(&self, like: &R) -> R {
        like.lit(0)
    }

    /// How contact begins at the tip; see [`onset`].
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Undecided`] if the arithmetic does not decide.
    fn onset(&self) -> Result<FirstContact>;

    /// The admissibility of states.
    fn admissibility(&self) -> &Admissibility;

    /// Whether a state is admissible.
    ///
    /// # Errors
    /// [`Error::Undecided`] where a proof is asked for, and enclosures of the gap do not decide it.
    fn verdict(&self, state: &Equilibrium<R>) -> Result<GapVerdict> {
        Ok(self.admissibility().of(state.contact_radius.approx(), state.indentation.approx()))
    }

    /// The first contact of separated surfaces, if it is not at the tip.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::Undecided`] for a formula whose first contact is not decided, see
    /// [`first_touch`](crate::admissible::first_touch); [`Error::Unproved`] over enclosures.
    fn first_touch(&self) -> Result<Option<Touch<R>>>;

    /// The last admissible state on the stable branch between two contact radii, and the ring on which the surfaces
    /// touch.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::NoConvergence`], see
    /// [`last_admissible`](crate::admissible::last_admissible); [`Error::Unproved`] over enclosures.
    fn last_admissible(&self, radii: [&R; 2]) -> Result<Option<(Equilibrium<R>, Ring<R>)>>;

    /// Whether growth of the contact at a fixed controlled value would require energy at this radius: g − d < −Δl, the
    /// edge is in compression.
    ///
    /// # Errors
    /// Errors of the transform.
    fn is_pushed_back(&self, radius: &R, value: &R) -> Result<bool>;

    /// The end of the last branch.
    ///
    /// # Errors
    /// Errors of the transform; over enclosures [`Error::Undecided`] in place of [`End::Unknown`], because more bits may find the
    /// missing equilibrium.
    fn end(&self) -> Result<End<R>>;

    /// All equilibria at `value`, by increasing radius; the list may be empty. At a fold the double root counts as one,
    /// [`Neutral`](mdr_core::contact::Stability::Neutral).
    ///
    /// # Errors
    /// [`Error::Domain`] unless the value is finite; errors of the transform; [`Error::Undecided`] if the arithmetic does not
    /// decide.
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

    /// Whether equilibria on a branch are stable; `None` if no fold bounds it.
    fn is_stable(&self, branch: usize) -> Option<bool> {
        let below = branch.checked_sub(1).and_then(|fold| self.folds().get(fold));
        let above = self.folds().get(branch);
        below.map(|fold| fold.kind == FoldKind::Minimum).or(above.map(|fold| fold.kind == FoldKind::Maximum))
    }

    /// The equilibrium reached from a fold, given by its index, when the controlled quantity passes it, and its branch:
    /// the next one in the direction of change, smaller after a minimum, larger after a maximum.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Undecided`] if the arithmetic does not decide.
    fn after_jump(&self, fold: usize) -> Result<Option<(usize, Equilibrium<R>)>> {
        let Some(start) = self.folds().get(fold) else { return Ok(None) };
        let value = self.control().controlled(&start.indentation, &start.force);
        match start.kind {
            FoldKind::Minimum => next_stable(self, &value, fold.checked_sub(1), Towards::Smaller),
            FoldKind::Maximum => next_stable(self, &value, Some(fold + 2), Towards::Larger),
        }
    }

    /// The outcome at a fold when the controlled quantity passes it: the radius of the [equilibrium](EquilibriumBranches::after_jump)
    /// that is reached; if there is none, detachment after a minimum, complete contact after a maximum.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Undecided`] if the arithmetic does not decide, and after a maximum if the profile ends.
    /// An index that does not exist gives [`Outcome::Detached`].
    fn outcome(&self, fold: usize) -> Result<Outcome<R>> {
        let kind = self.folds().get(fold).map(|fold| fold.kind);
        Ok(match (self.after_jump(fold)?, kind) {
            (Some((_, rest)), _) => Outcome::Jump { to: rest.contact_radius },
            (None, Some(FoldKind::Maximum)) if self.end()? == End::Open => Outcome::CompleteContact,
            (None, Some(FoldKind::Maximum)) => {
                return Err(beyond_reach(self.control(), &self.folds()[fold].contact_radius));
            }
            (None, _) => Outcome::Detached,
        })
    }
}

/// The end of the last branch.
#[derive(Clone, Debug, PartialEq)]
pub enum End<R> {
    /// No end: the contact can grow without limit.
    Open,
    /// The outer radius, in this state.
    Profile(Equilibrium<R>),
    /// An outer radius without a state: at a vertical edge, where g diverges, or where it cannot be computed.
    Unknown,
}

/// The end of the last branch of a curve.
///
/// # Errors
/// Errors of the transform.
pub(crate) fn end<R: Real>(curve: &Contact<R>) -> Result<End<R>> {
    let Some(contact_radius) = curve.transform().outer_radius() else { return Ok(End::Open) };
    if curve.vertical_edge().is_some() {
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

/// How contact begins at a = d = F = 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FirstContact {
    /// The controlled quantity increases with the radius: the contact grows continuously from a point.
    Smooth,
    /// The controlled quantity decreases: the surfaces jump into contact at first touch.
    Abrupt,
    /// The tip is the deepest point of a dimple, g < 0 near it: the surfaces cannot first touch there.
    Dimple,
}

/// How many more radii close to the tip are tried where the closest decides nothing.
const CLOSE_RADII: usize = 5;

/// How contact begins on a curve with the given first fold: from the sign of g close to the tip, and from the stability
/// of the first branch.
///
/// "Close" is the unit roundoff times w/E* or times the radius of the fold, whichever is smaller; where the arithmetic does not decide there,
/// since terms of the profile cancel, it is a root of the unit roundoff times the radius of the fold, the 32nd at most.
///
/// # Errors
/// Errors of the transform; [`Error::Undecided`] over enclosures that do not decide.
pub fn onset<R: Real>(curve: &Contact<R>, first: Option<&Fold<R>>) -> Result<FirstContact> {
    let length = curve.material_length();
    let fold = first.map_or_else(|| length.clone(), |fold| fold.contact_radius.clone());
    let radius = if fold < length { fold.clone() } else { length };
    let radii = [&radius, &fold];
    let undecided = |what| Error::undecided(Quantity::ContactRadius, &radius, what);
    match at_a_close_radius(radii, |close| begins_below(curve.transform(), close))? {
        Some(true) => return Ok(FirstContact::Dimple),
        Some(false) => {}
        None => return Err(undecided("whether the profile has a dimple at its tip")),
    }
    let grows = |close: &R| {
        let order = known(curve.tangency(close))?.and_then(|ratio| ratio.partial_cmp(&curve.critical_ratio_at(close)));
        Ok(order.map(|order| order == Ordering::Greater))
    };
    let stable = match first {
        Some(fold) => fold.kind == FoldKind::Maximum,
        None => {
            at_a_close_radius(radii, grows)?.ok_or_else(|| undecided("whether contact grows smoothly from a point"))?
        }
    };
    Ok(if stable { FirstContact::Smooth } else { FirstContact::Abrupt })
}

/// The answer at the closest of some radii at which there is one: shares of the first radius, then of the second.
fn at_a_close_radius<R: Real>(
    [radius, wider]: [&R; 2],
    answer: impl Fn(&R) -> Result<Option<bool>>,
) -> Result<Option<bool>> {
    let mut share = radius.unit_roundoff();
    for of in std::iter::once(radius).chain(std::iter::repeat_n(wider, CLOSE_RADII)) {
        if let Some(known) = answer(&(share.clone() * of).midpoint())? {
            return Ok(Some(known));
        }
        share = share.sqrt();
    }
    Ok(None)
}

/// `None` of a value that is lost in the roundings of a difference, or not enclosed.
fn known<T>(value: Result<T>) -> Result<Option<T>> {
    match value {
        Err(Error::Unproved { .. } | Error::NoConvergence { .. }) => Ok(None),
        value => value.map(Some),
    }
}

/// Whether g falls from its value 0 at the tip, by its sign at a radius close to it; `None` where that is open. Where g is lost in the
/// roundings of a difference, as r² is in R − √(R² − r²), the sign of g' decides.
fn begins_below<R: Real>(transform: &dyn Transform<R>, close: &R) -> Result<Option<bool>> {
    let is_negative = |value: R| {
        let zero = value.lit(0);
        if value < zero { Some(true) } else { (value >= zero).then_some(false) }
    };
    Ok(match known(transform.g(close))?.and_then(is_negative) {
        None => known(transform.slope(close))?.and_then(is_negative),
        sign => sign,
    })
}

/// The error for an equilibrium outside the searched range of contact radii.
pub(crate) fn beyond_reach<R: Real>(control: &Control<R>, like: &R) -> Error {
    let what = "the equilibrium lies outside the searched range of contact radii";
    Error::undecided(control.quantity(), like, what)
}

/// The error for a value that is neither certainly below nor certainly above that of a fold.
pub fn unordered<R: Real>(control: &Control<R>, value: &R) -> Error {
    let what = "whether it is below or above its value at a fold";
    Error::undecided(control.quantity(), value, what)
}

/// The direction of a search over radii.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Towards {
    Smaller,
    Larger,
}

/// The first equilibrium at `value` on a stable branch, from branch `next` on.
///
/// The caller ensures that the near end of each branch is on this side of the value; the equilibrium is on the branch
/// unless the value lies beyond the far end.
pub(crate) fn next_stable<R: Real, B: EquilibriumBranches<R> + ?Sized>(
    branches: &B,
    value: &R,
    mut next: Option<usize>,
    way: Towards,
) -> Result<Option<(usize, Equilibrium<R>)>> {
    while let Some(branch) = next.filter(|branch| *branch <= branches.folds().len()) {
        let (far_end, within) = match way {
            Towards::Smaller => (branch.checked_sub(1), Ordering::Greater),
            Towards::Larger => (Some(branch), Ordering::Less),
        };
        let holds = match far_end.and_then(|end| branches.folds().get(end)) {
            Some(end) => branches.compare(value, end)? == within,
            None => true,
        };
        if holds && let Some(rest) = branches.on_branch(branch, value)? {
            return Ok(Some((branch, rest)));
        }
        next = match way {
            Towards::Smaller => branch.checked_sub(2),
            Towards::Larger => Some(branch + 2),
        };
    }
    Ok(None)
}
