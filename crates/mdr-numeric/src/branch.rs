//! The curve of equilibria cut at its folds: what a loading path needs to know of a contact, in any arithmetic.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Equilibrium, Error, FoldKind, Instability, Outcome, Result};
use mdr_core::number::Real;

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

    /// The folds, by increasing radius.
    fn folds(&self) -> &[Instability<R>];

    /// The equilibrium at `value` of the controlled quantity on a branch, its ends excluded. On the last branch of a
    /// profile with a [wall](mdr_core::contact::Transform::wall) the contact may rest at the wall.
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
        value.partial_cmp(&at_fold).ok_or(Error::Undecided {
            quantity: self.control().quantity(),
            bits: value.precision(),
            what: "whether it is below or above its value at a fold",
        })
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
        let shrinks = start.kind == FoldKind::Minimum;
        let mut next = if shrinks { fold.checked_sub(1) } else { Some(fold + 2) };
        while let Some(branch) = next.filter(|branch| *branch <= self.folds().len()) {
            // The near end of a stable branch is passed by; the value is on it if it does not reach the far end.
            let far_end = if shrinks { branch.checked_sub(1) } else { Some(branch) };
            let holds = match far_end.and_then(|end| self.folds().get(end)) {
                Some(end) if shrinks => self.compare(&value, end)? == Ordering::Greater,
                Some(end) => self.compare(&value, end)? == Ordering::Less,
                None => true,
            };
            if holds && let Some(rest) = self.on_branch(branch, &value)? {
                return Ok(Some((branch, rest)));
            }
            next = if shrinks { branch.checked_sub(2) } else { Some(branch + 2) };
        }
        Ok(None)
    }

    /// What becomes of the contact at a fold when the controlled quantity goes a little beyond it: the radius of its
    /// [landing](Branched::landing), or where there is none it has detached past a minimum, and covers the whole surface
    /// past a maximum.
    ///
    /// # Errors
    /// As [`Branched::on_branch`]. An index that does not exist has [`Outcome::Detached`].
    fn outcome(&self, fold: usize) -> Result<Outcome<R>> {
        let kind = self.folds().get(fold).map(|fold| fold.kind);
        Ok(match (self.landing(fold)?, kind) {
            (Some((_, rest)), _) => Outcome::Jump { to: rest.contact_radius },
            (None, Some(FoldKind::Maximum)) => Outcome::CompleteContact,
            (None, _) => Outcome::Detached,
        })
    }
}
