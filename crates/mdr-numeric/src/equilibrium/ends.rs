//! The ends of branches that are not folds: poles, the tip, and radii outside the searched range.

use std::cmp::Ordering;

use mdr_core::contact::{Error, Fold, FoldKind, Quantity, Result};
use mdr_core::number::Real;

use super::{SearchedBranches, sign};

impl<R: Real> SearchedBranches<R> {
    /// Whether the direction of change at the tip, where d, F and D have their limits, differs from that at the end of the first
    /// branch.
    pub(super) fn is_open_inwards(&self, value: &R) -> Result<bool> {
        let tip = self.curve.tip_value(value);
        let at_end = match self.folds.first() {
            Some(fold) => self.beside(fold, value)?,
            None => sign(&self.curve.direction_at(&self.start(), value)?),
        };
        Ok(if at_end == Ordering::Less { *value < tip } else { *value > tip })
    }

    /// Whether the controlled quantity tends to `value` from the beginning of the last branch to the end of the
    /// searched range, and may reach it further out.
    pub(super) fn is_open_outwards(&self, value: &R) -> Result<bool> {
        if self.curve.vertical_edge().is_some() {
            return Ok(false);
        }
        let (at_beginning, rising) = match self.folds.last() {
            Some(fold) => (self.beside(fold, value)?, fold.kind == FoldKind::Minimum),
            None => {
                let start = self.start();
                let rising = self.curve.tangency(&start)? > self.curve.critical_ratio_at(&start);
                (sign(&self.curve.direction_at(&start, value)?), rising)
            }
        };
        let tends = rising == (at_beginning == Ordering::Less);
        // If g is known at the outer radius itself, the search includes the end.
        let outer = self.curve.transform().outer_radius();
        let at_outer = match outer.map(|outer| self.curve.direction_at(&outer, value)) {
            Some(Err(error)) if error.is_interruption() => return Err(error),
            direction => direction.and_then(Result::ok),
        };
        Ok(tends && at_outer.is_none_or(|direction| sign(&direction) != at_beginning))
    }

    /// Whether g does not converge at a radius to which the search of the last branch steps: then it may have an equilibrium further out.
    ///
    /// # Errors
    /// An interruption.
    pub(super) fn is_lost_outwards(&self) -> Result<bool> {
        let mut radius = self.folds.last().map_or_else(|| self.start(), |fold| fold.contact_radius.clone());
        let mut octaves = 1;
        while self.is_within_reach(&radius) {
            match self.curve.transform().g(&radius) {
                Err(Error::NoConvergence { .. }) => return Ok(true),
                Err(error) if error.is_interruption() => return Err(error),
                Err(_) => return Ok(false),
                Ok(_) => radius = radius.lit(2).powi(octaves) * &radius,
            }
            octaves *= 2;
        }
        Ok(false)
    }

    /// A radius between a pole and another radius, from which on the direction of change is that at the pole.
    pub(super) fn beside_pole(&self, pole: &Fold<R>, other: &R, direction: Ordering, value: &R) -> Result<R> {
        let edge = &pole.contact_radius;
        let mut step = (other.clone() - edge).over(2);
        loop {
            let a = edge.clone() + &step;
            if a == *edge {
                let what = "where exactly the equilibrium lies beside an edge where g is infinite";
                return Err(Error::undecided(Quantity::ContactRadius, value, what));
            }
            if sign(&self.curve.direction_at(&a, value)?) == direction {
                return Ok(a);
            }
            step = step.over(2);
        }
    }
}

/// Whether the controlled quantity is unbounded there.
pub(super) fn is_pole<R: Real>(fold: &Fold<R>) -> bool {
    !fold.indentation.is_finite()
}
