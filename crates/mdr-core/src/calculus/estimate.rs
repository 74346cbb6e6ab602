//! A computed value, its error and its price.

use crate::contact::{Error, Quantity, Result};
use crate::number::Real;

/// A value, an estimate of its absolute error, and the evaluations of the integrand spent on it.
///
/// The error is an estimate, not an enclosure: it is extrapolated from the changes between successive refinements and is
/// never smaller than the rounding level of the sum. For a [`Dual`](crate::number::Dual) it speaks of the value.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate<R> {
    /// The value.
    pub value: R,
    /// Estimated absolute error of the value.
    pub error: R,
    /// How often the integrand was evaluated.
    pub evaluations: usize,
}

/// The tightest relative tolerance that a quadrature in the precision of `like` can be asked for: 32 unit roundoffs.
pub fn roundoff_tolerance<R: Real>(like: &R) -> R {
    like.unit_roundoff().times(32)
}

/// Values of one integral, each from a rule twice as fine as the one before.
pub(super) struct Refinement<R> {
    values: Vec<R>,
    tolerance: R,
}

impl<R: Real> Refinement<R> {
    /// A tolerance below the rounding level is raised to it.
    pub(super) fn new(tolerance: &R) -> Self {
        let floor = roundoff_tolerance(tolerance);
        let tolerance = if tolerance.steer() > floor { tolerance.steer() } else { floor };
        Refinement { values: Vec::new(), tolerance }
    }

    /// Takes the next value, the integral `magnitude` of the absolute value, and an error `known` to be there besides.
    /// Returns the estimate and whether it meets the tolerance, which is relative to the magnitude.
    pub(super) fn push(&mut self, value: R, magnitude: &R, known: &R, evaluations: usize) -> (Estimate<R>, bool) {
        self.values.push(value.clone());
        let rounding = magnitude.unit_roundoff().times(4) * magnitude;
        let refinement = self.remainder().unwrap_or_else(|| magnitude.steer());
        let error = (refinement + known + &rounding).steer();
        let converged = error <= self.tolerance.clone() * magnitude.steer();
        (Estimate { value, error, evaluations }, converged)
    }

    /// The error of the last of at least four values.
    ///
    /// With changes d₁ (the last), d₂, d₃, refinement gains at least the factor r = max(d₁/d₂, (d₂/d₃)²): what is left is
    /// d₁r/(1−r). A rule that doubles its digits at each refinement has left only d₁²; one lucky change is not believed.
    fn remainder(&self) -> Option<R> {
        let [.., v0, v1, v2, v3] = self.values.as_slice() else { return None };
        let change = |new: &R, old: &R| (new.clone() - old).abs().steer();
        let (d1, d2, d3) = (change(v3, v2), change(v2, v1), change(v1, v0));
        if d1 == d1.lit(0) {
            return Some(d1);
        }
        let (gain, earlier) = (d1.clone() / &d2, (d2 / d3).square());
        let half = d1.ratio(1, 2);
        let converging = gain < half && earlier < half;
        let ratio = if gain > earlier { gain } else { earlier };
        Some(if converging { (d1 * ratio).times(2) } else { d1.times(4) })
    }
}

/// The error for an integral that did not converge.
pub(super) fn no_convergence<R: Real>(last: &Estimate<R>, magnitude: &R) -> Error {
    let error = (last.error.clone() / magnitude).approx();
    Error::NoConvergence { quantity: Quantity::Integral, evaluations: last.evaluations, error }
}

/// Passes the value of an integrand on when it is a number.
pub(super) fn finite<R: Real>(value: R) -> Result<R> {
    if value.is_finite() { Ok(value) } else { Err(Error::domain(Quantity::Integrand, &value, "finite")) }
}

/// Σ terms by halves, so that rounding errors grow as the logarithm of their number.
pub(super) fn sum<R: Real>(terms: &[R], zero: &R) -> R {
    match terms {
        [] => zero.clone(),
        [term] => term.clone(),
        _ => {
            let (first, second) = terms.split_at(terms.len() / 2);
            sum(first, zero) + sum(second, zero)
        }
    }
}
