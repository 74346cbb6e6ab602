//! The equilibria of a power law as branches for a path: closed forms, at any scale.

use std::cmp::Ordering;

use mdr_analytic::certified::{CertifiedPoint, Curve, PathPoint};
use mdr_core::contact::{Control, Equilibrium, Fold, FoldKind, Result};
use mdr_core::number::{Interval, Real};
use mdr_numeric::admissible::{Admissibility, Ring, Touch};
use mdr_numeric::branch::{End, EquilibriumBranches, FirstContact, unordered};
use rug::Rational;

/// The branches of a power law for a path with some way points, which values of folds may equal exactly.
pub(crate) struct LawBranches<'a> {
    pub(crate) curve: &'a Curve,
    way: Vec<Rational>,
    folds: Vec<Fold<Interval>>,
}

impl<'a> LawBranches<'a> {
    pub(crate) fn new(curve: &'a Curve, way: Vec<Rational>) -> Self {
        let fold = |(point, kind): &(CertifiedPoint, FoldKind)| {
            let Equilibrium { contact_radius, indentation, force, .. } = state(curve, point);
            Fold { contact_radius, indentation, force, kind: *kind }
        };
        LawBranches { curve, way, folds: curve.folds().iter().map(fold).collect() }
    }

    pub(crate) fn enclose(&self, value: &Rational) -> Interval {
        Interval::from_rational(self.curve.precision(), value)
    }

    /// The state at a value that a path has found.
    ///
    /// # Errors
    /// A precision that does not tell it from others.
    pub(crate) fn at(&self, value: &Rational, rest: &Equilibrium<Interval>) -> Result<PathPoint> {
        let found = self.curve.state_near(value, rest.stability, &rest.contact_radius.ln())?;
        found.ok_or_else(|| unordered(self.control(), &rest.contact_radius))
    }
}

/// A state over intervals, of which an end is 0 or ∞ where they cannot hold it.
fn state(curve: &Curve, point: &CertifiedPoint) -> Equilibrium<Interval> {
    Equilibrium {
        contact_radius: point.radius().interval(),
        indentation: point.indentation().interval(),
        force: curve.force(point).interval(),
        stability: point.stability,
    }
}

impl EquilibriumBranches<Interval> for LawBranches<'_> {
    fn control(&self) -> &Control<Interval> {
        self.curve.control()
    }

    fn folds(&self) -> &[Fold<Interval>] {
        &self.folds
    }

    fn on_branch(&self, branch: usize, value: &Interval) -> Result<Option<Equilibrium<Interval>>> {
        let point = self.curve.on_branch(branch, &value.clone().into())?;
        Ok(point.map(|point| state(self.curve, &point)))
    }

    fn compare(&self, value: &Interval, fold: &Fold<Interval>) -> Result<Ordering> {
        let unordered = || unordered(self.control(), value);
        let index = self.folds.iter().position(|other| std::ptr::eq(other, fold)).ok_or_else(unordered)?;
        let mut met = self.way.iter().filter(|point| value.lower() <= *point && value.upper() >= *point).peekable();
        if met.peek().is_some() && met.all(|point| Some(point) == self.curve.exact_fold(index)) {
            return Ok(Ordering::Equal);
        }
        self.curve.compare(&value.clone().into(), &self.curve.folds()[index].0)
    }

    fn onset(&self) -> Result<FirstContact> {
        Ok(if self.curve.begins_smoothly()? { FirstContact::Smooth } else { FirstContact::Abrupt })
    }

    fn end(&self) -> Result<End<Interval>> {
        Ok(End::Open)
    }

    fn admissibility(&self) -> &Admissibility {
        Admissibility::rising()
    }

    fn first_touch(&self) -> Result<Option<Touch<Interval>>> {
        Ok(None)
    }

    fn last_admissible(&self, _radii: [&Interval; 2]) -> Result<Option<(Equilibrium<Interval>, Ring<Interval>)>> {
        Ok(None)
    }

    fn is_pushed_back(&self, _radius: &Interval, _value: &Interval) -> Result<bool> {
        Ok(false)
    }

    fn after_jump(&self, fold: usize) -> Result<Option<(usize, Equilibrium<Interval>)>> {
        Ok(self.curve.past_fold(fold)?.map(|(branch, rest)| (branch, state(self.curve, rest.point()))))
    }
}
