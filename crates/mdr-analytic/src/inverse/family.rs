//! The function Φ of the family, and its roots in any arithmetic.

use mdr_core::contact::{Regime, Result};
use mdr_core::number::Real;

use super::start::Seed;
use super::{Branch, Held};
use crate::contact::PowerLawContact;
use crate::newton::undecided;

/// The parameter m of the family of a contact under one control.
#[derive(Clone, Debug)]
pub(crate) struct Family<R> {
    pub(crate) regime: Regime,
    /// m > 1: p/q, or its reciprocal for n < 1/2.
    parameter: R,
    /// μ = m − 1.
    pub(crate) excess: R,
}

/// A point of the family. The smaller of τ and z = 1 − τ is known to its own precision.
#[derive(Clone, Debug)]
pub(super) struct Place<R> {
    /// τ.
    pub(super) distance: R,
    /// z.
    pub(super) value: R,
}

/// v, and Φ there.
struct Point<R> {
    v: R,
    terms: Terms<R>,
}

/// The terms of Φ and Φ'. D = (e^{μv} − 1)/μ.
enum Terms<R> {
    /// Close to the fold, where the other terms cancel: both by their series.
    Series { value: R, slope: R },
    /// e^v − 1, e^v and D: Φ = e^v D − (e^v − 1).
    Near { less_one: R, power: R, growth: R },
    /// e^v and D: 1 − Φ = e^v(1 − D).
    Far { power: R, growth: R },
}

/// Below this τ the series at the fold is accurate to all digits of a double.
const TINY: f64 = 1e-20;

/// A slight offset of the guess, so that with few words the last step is a number and not noise; beyond
/// [`OFFSET_LIMIT`] it would change the radius, which depends on e^v, too much.
const OFFSET: f64 = 1.0 + 1.0 / (1_u64 << 36) as f64;
const OFFSET_LIMIT: f64 = 4096.0;

/// From here on the error of e^v is 2⁻²⁰ and more if v is a double.
const FAR: f64 = (1_u64 << 33) as f64;

impl<R: Real> Family<R> {
    #[inline(always)]
    pub(super) fn new(contact: &PowerLawContact<R>, held: Held, regime: Regime) -> Self {
        let excess = contact.profile().excess();
        // p/q and p/q − 1.
        let (parameter, excess) = match held {
            Held::Indentation => (contact.profile().exponent().clone().times(2), excess),
            Held::Force => ((contact.profile().exponent().clone() + excess.lit(1)).times(2).over(3), excess.over(3)),
        };
        if regime == Regime::PullOff {
            return Family { regime, parameter, excess };
        }
        Family { regime, excess: -excess / &parameter, parameter: parameter.inv() }
    }

    /// μ.
    pub(super) fn mu(&self) -> f64 {
        self.excess.approx()
    }

    /// 2u of a = a_λ e^{2u}, from v.
    #[inline(always)]
    pub(super) fn ln_growth(&self, held: Held, v: R) -> R {
        let v = if self.regime == Regime::PullOff { v } else { v * &self.parameter };
        v.times(2).over(held.critical_ratio())
    }

    /// A first approximation of the root v, without uncertainty: accurate to half the digits of a double or more.
    #[inline(always)]
    pub(super) fn first(&self, distance: &R, seed: Seed, branch: Branch) -> R {
        if seed.tau < TINY {
            // ±t − (m+1)t²/6, t = √(2τ/m), whose next term is of the order of t³.
            let t = (distance.clone().times(2) / &self.parameter).sqrt();
            let second = (self.parameter.clone() + t.lit(1)) * t.square() / t.lit(6);
            let first = if branch == Branch::Larger { t } else { -t };
            return (first - &second).midpoint();
        }
        let v = match branch {
            Branch::Larger => seed.larger(),
            Branch::Smaller => seed.smaller(),
        };
        R::from_f64(self.excess.ctx(), if v.abs() < OFFSET_LIMIT { v * OFFSET } else { v })
    }

    /// A first approximation of a root so far out that a double does not determine e^v: v = ln|z| − ln|1 − D|, where D
    /// changes slowly.
    pub(super) fn first_of_far(&self, ln_z: &R, v: R) -> R {
        if v.approx().abs() < FAR {
            return v;
        }
        let growth = (v.clone() * &self.excess).exp_m1() / &self.excess;
        let closer = (ln_z.clone() - (v.lit(1) - growth).abs().ln()).midpoint();
        if closer.is_finite() { closer } else { v }
    }

    /// The seed of a place. z itself may be out of the range of `f64`, as it is near n = 1/2.
    #[inline(always)]
    pub(super) fn seed(&self, place: &Place<R>) -> Seed {
        let z = place.value.approx();
        let ln_z = if z.is_normal() { pxfm::f_log(z.abs()) } else { place.value.abs().ln().approx() };
        Seed { mu: self.mu(), tau: place.distance.approx(), z, ln_z }
    }

    /// The root v on a branch, from a first approximation; in a rigorous arithmetic an enclosure of it.
    #[inline(always)]
    pub(super) fn root(&self, place: &Place<R>, first: R) -> Result<R> {
        let mut point = self.point(first);
        let mut step = self.newton(place, &point);
        let mut last = point.v.abs();
        while !self.is_last(&point, &step) && step.abs() < last {
            last = step.abs().over(2);
            point = self.point((point.v - &step).midpoint());
            step = self.newton(place, &point);
        }
        // An interval Newton step over a neighbourhood that contains its own image.
        let defect = self.defect(place, &point);
        let mut radius = step.abs().times(4) + point.v.abs() * point.v.unit_roundoff().times(8);
        for _ in 0..point.v.precision().div_ceil(8) {
            let image = defect.clone() / self.slope_within(&point, &radius);
            if image.abs() <= radius {
                return Ok(point.v - image);
            }
            radius = radius.times(8);
        }
        Err(undecided(&point.v, "where exactly the equilibrium lies"))
    }

    /// Repeats the last step on a root, with the derivatives of a dual number.
    pub(super) fn polish(&self, place: &Place<R>, v: R) -> R {
        let point = self.point(v);
        let step = self.defect(place, &point) / self.slope(&point);
        point.v - step
    }

    /// Whether the square of the step, which bounds the next one, is below rounding: Φ''/2Φ' ≤ 1 + m + 1/|v|.
    #[inline(always)]
    fn is_last(&self, point: &Point<R>, step: &R) -> bool {
        if step.precision() < 500 {
            let (step, v) = (step.approx(), point.v.approx());
            return step * step * (1.0 + self.parameter.approx() + v.abs().recip())
                <= step_allowed(point.v.precision());
        }
        let curvature = point.v.abs().inv() + step.lit(1) + &self.parameter;
        (step.square() * curvature).midpoint() <= step.unit_roundoff()
    }

    #[inline(always)]
    fn point(&self, v: R) -> Point<R> {
        let size = v.approx().abs();
        if size * self.parameter.approx() < 1.0 / 16.0 {
            let terms = self.series(&v);
            return Point { v, terms };
        }
        let growth = (v.clone() * &self.excess).exp_m1() / &self.excess;
        let terms = if size < 0.5 {
            let less_one = v.exp_m1();
            Terms::Near { power: less_one.clone() + v.lit(1), less_one, growth }
        } else {
            Terms::Far { power: v.exp(), growth }
        };
        Point { v, terms }
    }

    /// Φ = Σ cₖvᵏ/k! and Φ' = Σ cₖvᵏ⁻¹/(k−1)! from k = 2, where c₂ = m and cₖ₊₁ = m(cₖ + 1), for m|v| < 1/16.
    fn series(&self, v: &R) -> Terms<R> {
        // cₖ₊₁ ≤ 2mcₖ: each term is below 1/16 of the previous one, and the remainder below the last.
        let bits = -(v.abs() * &self.parameter).approx().max(f64::MIN_POSITIVE).log2();
        let terms = (f64::from(v.precision()) / bits) as i64 + 4;
        let (mut coefficient, mut power) = (self.parameter.clone(), v.clone());
        let (mut value, mut slope, mut last) = (v.lit(0), v.lit(0), v.lit(0));
        for k in 2..=terms {
            last = coefficient.clone() * &power;
            value += &(last.clone() * v).over(k);
            slope += &last;
            coefficient = (coefficient + v.lit(1)) * &self.parameter;
            power = (power * v).over(k);
        }
        Terms::Series { value: value.inflate(&(last.clone() * v)), slope: slope.inflate(&last) }
    }

    /// Φ(v) − τ.
    #[inline(always)]
    fn defect(&self, place: &Place<R>, point: &Point<R>) -> R {
        match &point.terms {
            Terms::Series { value, .. } => value.clone() - &place.distance,
            Terms::Near { less_one, power, growth } => power.clone() * growth - less_one - &place.distance,
            Terms::Far { power, growth } => place.value.clone() - (power.lit(1) - growth) * power,
        }
    }

    /// Φ' = m e^v D.
    #[inline(always)]
    fn slope(&self, point: &Point<R>) -> R {
        match &point.terms {
            Terms::Series { slope, .. } => slope.clone(),
            Terms::Near { power, growth, .. } | Terms::Far { power, growth } => {
                power.clone() * growth * &self.parameter
            }
        }
    }

    #[inline(always)]
    fn newton(&self, place: &Place<R>, point: &Point<R>) -> R {
        (self.defect(place, point) / self.slope(point)).midpoint()
    }

    /// Φ' on [v − r, v + r] for mr ≤ 1/16.
    #[inline(always)]
    fn slope_within(&self, point: &Point<R>, radius: &R) -> R {
        let twice = if radius.clone() * &self.parameter <= radius.ratio(1, 16) {
            radius.clone().times(2)
        } else {
            // Nothing is known on so large a neighbourhood.
            return radius.lit(0).inv();
        };
        match &point.terms {
            // |Φ''| = m e^v|1 + mD| < 2m for m|v| < 1/8.
            Terms::Series { slope, .. } => slope.clone().inflate(&(twice * &self.parameter)),
            // e^v changes by a relative 2r at most, and D by less than 2r(1 + μD).
            Terms::Near { power, growth, .. } | Terms::Far { power, growth } => {
                let change = (self.excess.clone() * growth + radius.lit(1)) * &twice;
                let power = power.clone().inflate(&(power.clone() * &twice));
                power * growth.clone().inflate(&change) * &self.parameter
            }
        }
    }
}

/// 2^−p.
fn step_allowed(precision: u32) -> f64 {
    f64::from_bits(u64::from(1023 - precision.min(1022)) << 52)
}
