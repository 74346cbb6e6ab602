//! Critical states as products of powers, with counted roundings.
//!
//! With B = πw/2E* and the critical ratio λ (1 under fixed grips, 3 under a dead load)
//!
//! √a = (λ√B/(nκ_nC))^{1/(2n−1)},  |d| = |(λ−2n)/n| √B √a,  |F| = |2(λ−2(n+1))/(n+1)| E* √B √a a.
//!
//! For n = p/q the exponent is q/(2p−q): an integer power and a root. If both are of moderate degree, this is several
//! times faster than the logarithm and exponential of the general formula,
//! [`PowerLawContact::critical`](crate::PowerLawContact::critical).
//!
//! A cone has κ_1 = π/2, and √(Ba) is rational: a and F are rationals over π.

use mdr_core::contact::Control;
use mdr_core::number::{Interval, Precision, RoundingCount};
use rug::{Float, Rational};

use super::{Question, exact};
use crate::kappa::rational_kappa;

/// The largest degree of a power or a root.
const LARGEST: i64 = 500;

/// The factors of a critical state.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Monomials {
    /// w/2E*
    edge: Rational,
    /// λ/(nC)
    softness: Rational,
    /// 1/(2n−1), numerator and denominator.
    exponent: (i32, u32),
    /// |(λ−2n)/n|
    indentation: Rational,
    /// |2(λ−2(n+1))/(n+1)| E*
    force: Rational,
    /// Whether d and F are negative.
    negative: [bool; 2],
    /// |d|, πa and π|F|, for n = 1.
    cone: Option<[Rational; 3]>,
}

impl Monomials {
    /// `None` on a machine, at n = 1/2, for an exponent with long numbers, and for d = 0.
    pub(super) fn new(
        n: &Rational,
        c: &Rational,
        e_star: &Rational,
        work: &Rational,
        control: &Control<Rational>,
    ) -> Option<Self> {
        let critical_ratio = match control {
            Control::Indentation => 1,
            Control::Force => 3,
            Control::Machine { .. } => return None,
        };
        let excess = Rational::from(n * 2u32) - 1u32;
        if excess.is_zero() {
            return None;
        }
        let inverse = excess.recip();
        let [up, down] = [inverse.numer().to_i64()?, inverse.denom().to_i64()?];
        if up.abs() > LARGEST || down > LARGEST {
            return None;
        }
        let indentation: Rational = (critical_ratio - Rational::from(n * 2u32)) / n;
        let next = Rational::from(n + 1u32);
        let force: Rational = (critical_ratio - Rational::from(&next * 2u32)) * 2u32 / next * e_star;
        if indentation.is_zero() || force.is_zero() {
            return None;
        }
        let negative = [indentation < 0, force < 0];
        let (indentation, force) = (indentation.abs(), force.abs());
        let (edge, softness) = (Rational::from(work / e_star) / 2u32, critical_ratio / Rational::from(n * c));
        let cone = (*n == 1).then(|| {
            // √(Ba) with a = B(softness/κ_1)²
            let root = Rational::from(&edge * &softness) * 2u32;
            let radius = Rational::from(&root * &softness) * 2u32;
            let force = Rational::from(&force * &root) * &radius;
            [root * &indentation, radius, force]
        });
        let exponent = (i32::try_from(up).ok()?, u32::try_from(down).ok()?);
        Some(Monomials { edge, softness, exponent, negative, indentation, force, cone })
    }

    /// κ_n, a, d and F. `None` if a value leaves the exponent range.
    fn state(&self, kappa: RoundingCount, working: Precision, precision: Precision) -> Option<[Interval; 4]> {
        let [radius, indentation, force] = match &self.cone {
            Some(cone) => cone_state(cone, working),
            None => self.power_state(&kappa, working),
        };
        let enclose = |number: &RoundingCount, negative| {
            let magnitude = number.enclosure(precision);
            let known = !magnitude.is_entire() && !magnitude.contains_zero();
            known.then_some(if negative { -magnitude } else { magnitude })
        };
        let [d_negative, f_negative] = self.negative;
        Some([
            enclose(&kappa, false)?,
            enclose(&radius, false)?,
            enclose(&indentation, d_negative)?,
            enclose(&force, f_negative)?,
        ])
    }

    /// a, |d| and |F|.
    fn power_state(&self, kappa: &RoundingCount, working: Precision) -> [RoundingCount; 3] {
        let root_edge = RoundingCount::pi(working).scaled(&self.edge).sqrt();
        let (up, down) = self.exponent;
        let ratio = root_edge.clone().scaled(&self.softness);
        // Square roots give a positive power directly, other roots a negative one; the opposite sign costs one more
        // quotient.
        let root = if (up > 0) == matches!(down, 1 | 2 | 4) {
            ratio.over(kappa).power(up, down)
        } else {
            kappa.clone().over(&ratio).power(-up, down)
        };
        let product = root_edge.times(&root);
        let radius = root.power(2, 1);
        let force = product.clone().times(&radius).scaled(&self.force);
        [radius, product.scaled(&self.indentation), force]
    }
}

/// a, |d| and |F| of a cone.
fn cone_state([indentation, radius, force]: &[Rational; 3], working: Precision) -> [RoundingCount; 3] {
    let one = RoundingCount::new(Float::with_val(working.bits(), 1), 0);
    let per_pi = one.clone().over(&RoundingCount::pi(working));
    [per_pi.clone().scaled(radius), one.scaled(indentation), per_pi.scaled(force)]
}

impl Question {
    /// κ_n, a, d and F by counted roundings; `None` if only the general formula applies.
    pub(super) fn counted(&self, precision: Precision) -> Option<[Interval; 4]> {
        let monomials = self.monomials.as_ref()?;
        let (up, down) = monomials.exponent;
        // Roundings of κ: fewer than its bits; twice for a, and magnified by the exponent.
        let magnified = up.unsigned_abs().div_ceil(down);
        let guard = 2 * u32::BITS - precision.bits().leading_zeros() - magnified.leading_zeros() + 4;
        let working = Precision::new(precision.bits() + guard);
        let kappa = match exact::kappa(&self.exponent) {
            Some(kappa) => RoundingCount::new(Float::with_val(working.bits(), kappa), 1),
            None => rational_kappa(working, &self.exponent),
        };
        monomials.state(kappa, working, precision)
    }
}

#[cfg(test)]
#[path = "../../tests/private/monomial.rs"]
mod tests;
