//! A computed value, its error estimate and its cost.

use std::ops::AddAssign;

use crate::contact::{Error, Quantity, Result};
use crate::number::Real;

/// A value, an estimate of its absolute error, and the evaluations of the integrand spent on it.
///
/// The error is an estimate, not an enclosure: it is extrapolated from the changes between successive refinements and
/// is never smaller than the rounding level of the sum. For a [`Dual`](crate::number::Dual) it refers to the value.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate<R> {
    /// The value.
    pub value: R,
    /// Estimated absolute error of the value.
    pub error: R,
    /// Number of evaluations of the integrand.
    pub evaluations: usize,
}

impl<R: Real> Estimate<R> {
    /// A value without an error of its own.
    pub fn exact(value: R) -> Self {
        Estimate { error: value.lit(0), value, evaluations: 0 }
    }

    /// The estimate of the integral times a positive factor, which is taken to be exact.
    #[must_use]
    pub fn scaled(self, factor: &R) -> Self {
        Estimate { value: self.value * factor, error: self.error * factor, ..self }
    }

    fn is_within(&self, tolerance: &R, magnitude: &R) -> bool {
        self.error <= tolerance.clone() * magnitude.midpoint()
    }
}

/// Adds the values, the errors and the evaluations.
impl<R: Real> AddAssign<&Self> for Estimate<R> {
    fn add_assign(&mut self, other: &Self) {
        self.value += &other.value;
        self.error += &other.error;
        self.evaluations += other.evaluations;
    }
}

/// The tightest relative tolerance of a quadrature in the precision of `like`: 32 unit roundoffs.
pub fn roundoff_tolerance<R: Real>(like: &R) -> R {
    like.unit_roundoff().times(32)
}

/// The accuracy required of an integral, relative to the integral of the absolute value.
///
/// By default the goal must be met. An integrand that cancels, or is itself a quadrature, carries noise that may exceed
/// the goal; the changes between refinements then no longer shrink to a quarter. With a `limit`, a value at that noise
/// level is accepted with its error estimate as long as the error is below the limit. The value of the finest rule is
/// accepted under the same condition, whatever its last change.
///
/// ```
/// use mdr_core::calculus::{Tolerance, quadrature::tanh_sinh, roundoff_tolerance};
/// // ∫₀¹ (1 + x/10⁶ − 1) dx = 1/(2·10⁶), where ten digits are left of the integrand.
/// let cancels = |x: &f64| Ok(1.0 + 1e-6 * x - 1.0);
/// let goal = roundoff_tolerance(&1.0);
/// assert!(tanh_sinh(&0.0, &1.0, &goal, cancels).is_err());
/// let integral = tanh_sinh(&0.0, &1.0, Tolerance::new(&goal).or_noise_below(1e-8), cancels)?;
/// assert!((integral.value - 5e-7).abs() <= integral.error && integral.error < 5e-7 * 1e-8);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Tolerance<R> {
    goal: R,
    limit: R,
    /// The limit that applies to the finest rule.
    last: R,
    noise: R,
    /// An absolute error that is always small enough.
    absolute: R,
}

impl<R: Real> Tolerance<R> {
    /// A goal that must be met; one below the rounding level ([`roundoff_tolerance`]) is raised to it.
    pub fn new(goal: &R) -> Self {
        let goal = larger(goal.midpoint(), roundoff_tolerance(goal));
        let (noise, absolute) = (goal.unit_roundoff().times(8), goal.lit(0));
        Tolerance { limit: goal.clone(), last: goal.clone(), noise, absolute, goal }
    }

    /// The tightest for an integrand whose terms may cancel: an error of 4096 times the goal is accepted at the noise level.
    pub fn of_cancelling(like: &R) -> Self {
        let goal = roundoff_tolerance(like);
        Tolerance::new(&goal).or_noise_below(goal.times(4096))
    }

    /// The largest relative error that is accepted at the noise level of the integrand.
    pub fn limit(&self) -> &R {
        &self.limit
    }

    /// Accepts an error below `limit` at the noise level of the integrand; the goal is unchanged.
    pub fn or_noise_below(self, limit: R) -> Self {
        let limit = larger(limit.midpoint(), self.goal.clone());
        Tolerance { last: limit.clone(), limit, ..self }
    }

    /// Accepts the value of the finest rule when its error misses the goal but is below `limit`; the goal is unchanged. Slow
    /// convergence is not taken for noise.
    pub fn or_finest_below(self, limit: R) -> Self {
        Tolerance { last: larger(limit.midpoint(), self.limit.clone()), ..self }
    }

    /// Accepts any absolute error below `absolute`, even if it misses the relative goal.
    pub fn or_error_below(self, absolute: &R) -> Self {
        Tolerance { absolute: absolute.midpoint(), ..self }
    }

    /// Sets the relative `noise` of the integrand: a change no larger than that counts as rounding.
    /// Without it, the changes of two more refinements must be as small before they are trusted. The error estimate
    /// does not include the effect of the noise on the integral.
    pub fn with_noise(self, noise: &R) -> Self {
        Tolerance { noise: larger(noise.midpoint(), self.noise), ..self }
    }
}

impl<R: Real> From<&R> for Tolerance<R> {
    fn from(goal: &R) -> Self {
        Tolerance::new(goal)
    }
}

/// Values of one integral, each from a rule twice as fine as the one before.
pub(super) struct Refinement<R> {
    values: Vec<R>,
    tolerance: Tolerance<R>,
}

impl<R: Real> Refinement<R> {
    pub(super) fn new(tolerance: Tolerance<R>) -> Self {
        Refinement { values: Vec::new(), tolerance }
    }

    /// Takes the next value, with the integral `magnitude` of the absolute value and a lower bound `known` of the
    /// error. Returns the estimate and whether it meets the tolerance, relative to the magnitude.
    pub(super) fn push(&mut self, value: R, magnitude: &R, known: &R, evaluations: usize) -> (Estimate<R>, bool) {
        self.values.push(value.clone());
        let remainder = self.remainder(magnitude);
        let enough = remainder.is_some();
        let error = (remainder.unwrap_or_else(|| magnitude.midpoint()) + known).midpoint();
        let estimate = Estimate { value, error, evaluations };
        let within = |tolerance: &R| enough && estimate.is_within(tolerance, magnitude);
        let negligible = enough && estimate.error <= self.tolerance.absolute;
        let done = negligible || within(&self.tolerance.goal) || (within(&self.tolerance.limit) && self.is_noise());
        (estimate, done)
    }

    /// The estimate of the finest rule, which missed the goal, if it is still acceptable.
    ///
    /// # Errors
    /// [`NoConvergence`](Error::NoConvergence) unless its error is below the limit.
    pub(super) fn exhausted(&self, last: Estimate<R>, magnitude: &R) -> Result<Estimate<R>> {
        let negligible = last.error <= self.tolerance.absolute;
        let good = negligible || last.is_within(&self.tolerance.last, magnitude);
        if good { Ok(last) } else { Err(no_convergence(&last, magnitude)) }
    }

    /// Whether the last change is not much smaller than the one before.
    fn is_noise(&self) -> bool {
        let [.., v1, v2, v3] = self.values.as_slice() else { return false };
        let change = |new: &R, old: &R| (new.clone() - old).abs().midpoint();
        change(v3, v2).times(4) >= change(v2, v1)
    }

    /// The error of the last of at least four values, from the last changes e₁, e₂, e₃ relative to the magnitude.
    ///
    /// A rule whose digits double with each refinement has e₁ ≈ e₂² ≈ e₃⁴ and a remaining error of e₁². If the changes
    /// follow this with a margin (e₁ ≤ e₂^1.5/8, e₂ ≤ e₃^1.5/8), the error is estimated as e₁·max(e₁/e₂, e₂/e₃);
    /// otherwise as the largest change, because a single one may be small by chance.
    fn remainder(&self, magnitude: &R) -> Option<R> {
        let [.., v0, v1, v2, v3] = self.values.as_slice() else { return None };
        let change = |new: &R, old: &R| ((new.clone() - old).abs() / magnitude).midpoint();
        let (e1, e2, e3) = (change(v3, v2), change(v2, v1), change(v1, v0));
        let doubles = |new: &R, old: &R| new.square().times(64) <= old.clone() * old.square();
        let relative = if *magnitude == e1.lit(0) {
            magnitude.clone()
        } else if e1 <= self.tolerance.noise {
            e1
        } else if doubles(&e1, &e2) && doubles(&e2, &e3) {
            larger(e1.clone() / &e2, e2 / &e3) * e1
        } else {
            larger(larger(e1, e2), e3.over(4))
        };
        Some((relative * magnitude).times(2))
    }
}

/// The larger of two.
fn larger<R: Real>(x: R, y: R) -> R {
    if x > y { x } else { y }
}

/// `count` unit roundoffs of `magnitude`.
pub(super) fn rounding<R: Real>(magnitude: &R, count: i64) -> R {
    magnitude.unit_roundoff().times(count) * magnitude
}

/// The error for an integral that did not converge.
fn no_convergence<R: Real>(last: &Estimate<R>, magnitude: &R) -> Error {
    let error = (last.error.clone() / magnitude).approx();
    Error::NoConvergence { quantity: Quantity::Integral, evaluations: last.evaluations, error }
}

/// The value of an integrand, if it is finite.
pub(super) fn finite<R: Real>(value: R) -> Result<R> {
    if value.is_finite() { Ok(value) } else { Err(Error::domain(Quantity::Integrand, &value, "finite")) }
}

/// Σ terms by pairwise summation: rounding errors grow with the logarithm of their number.
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
