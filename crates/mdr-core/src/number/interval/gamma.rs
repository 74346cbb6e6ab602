//! `Gamma` for intervals. Γ and ln Γ decrease up to their minimum at x₀ = 1.4616…, the zero of ψ, and then increase.

use std::cmp::Ordering;
use std::mem::replace;

use rug::Float;
use rug::float::Round;

use super::Interval;
use crate::number::{Gamma, Real};

/// x₀ rounded down and up.
const MINIMUM: [f64; 2] = [1.461_632_144_968_362, 1.461_632_144_968_363];

/// ψ'(x₀), the slope for the secant's first step.
const TRIGAMMA: f64 = 0.967_672_045_446_862_2;

impl Interval {
    /// The image of an interval x > 0 under Γ or ln Γ, both convex with their least value at x₀.
    fn around_minimum(
        &self,
        function: impl Fn(&mut Float, Round) -> Ordering + Copy,
        least: impl FnOnce(&Self) -> Float,
    ) -> Interval {
        if self.lies_right() {
            self.increasing(function)
        } else if self.lies_left() {
            self.decreasing(function)
        } else {
            let (mut first, mut last) = (self.lo.clone(), self.hi.clone());
            function(&mut first, Round::Up);
            function(&mut last, Round::Up);
            Interval { lo: least(self), hi: first.max(&last) }
        }
    }

    /// Whether the interval lies to the right of x₀. ψ decides only where a double is not precise enough.
    fn lies_right(&self) -> bool {
        self.lo >= MINIMUM[1] || (self.lo > MINIMUM[0] && digamma_sign(&self.lo) != Ordering::Less)
    }

    /// Whether the interval lies to the left of x₀.
    fn lies_left(&self) -> bool {
        self.hi <= MINIMUM[0] || (self.hi < MINIMUM[1] && digamma_sign(&self.hi) != Ordering::Greater)
    }
}

/// The sign of ψ: a correctly rounded value has the sign of the exact one.
fn digamma_sign(x: &Float) -> Ordering {
    Float::with_val(32, x.digamma_ref()).cmp0().unwrap_or(Ordering::Equal)
}

/// A point close to x₀ together with a bound ε on (x − x₀)·ψ(x), small against 2^−precision.
///
/// By convexity, ln Γ(x₀) ≥ ln Γ(x) + ψ(x)(x₀ − x) and Γ(x₀) ≥ Γ(x)·(1 + ψ(x)(x₀ − x)); and |x − x₀| ≤ |ψ(x)|/ψ'(3/2)
/// for 1 < x < 3/2 with ψ'(3/2) = π²/2 − 4 > 1/2, so that ε = 2ψ(x)² will do. Half the bits of x₀ are enough.
fn near_minimum(precision: u32) -> (Float, Float) {
    let bits = precision + 16;
    let digamma = |x: &Float| Float::with_val(bits, x.digamma_ref());
    let mut before = Float::with_val(bits, MINIMUM[0]);
    let mut digamma_before = digamma(&before);
    let mut x = Float::with_val(bits, &before - Float::with_val(bits, &digamma_before / TRIGAMMA));
    let mut value = digamma(&x);
    while value.get_exp().is_some_and(|exponent| 2 * i64::from(exponent) > -i64::from(bits)) {
        let step = (x.clone() - &before) * &value / (value.clone() - &digamma_before);
        let next = x.clone() - step;
        before = replace(&mut x, next);
        digamma_before = replace(&mut value, digamma(&x));
    }
    value.square_round(Round::Up);
    (x, value * 2u32)
}

impl Gamma for Interval {
    fn gamma(&self) -> Interval {
        self.within(self.lo > 0, |x| {
            x.around_minimum(Float::gamma_round, |x| {
                let (mut near, excess) = near_minimum(x.precision());
                near.gamma_round(Round::Down);
                let (factor, _) = Float::with_val_round(near.prec(), 1u32 - &excess, Round::Down);
                Float::with_val_round(x.precision(), &near * &factor, Round::Down).0
            })
        })
    }
    fn ln_gamma(&self) -> Interval {
        self.within(self.lo > 0, |x| {
            x.around_minimum(Float::ln_gamma_round, |x| {
                let (mut near, excess) = near_minimum(x.precision());
                near.ln_gamma_round(Round::Down);
                Float::with_val_round(x.precision(), &near - &excess, Round::Down).0
            })
        })
    }
    fn digamma(&self) -> Interval {
        self.within(self.lo > 0, |x| x.increasing(Float::digamma_round))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bound exceeds what it bounds, and is small against the last place.
    #[test]
    fn minimum_of_gamma() {
        for precision in [10, 24, 53, 100, 200, 400] {
            let (near, excess) = near_minimum(precision);
            let (exact, _) = near_minimum(4 * precision + 100);
            let bounded = (Float::with_val(exact.prec(), &near) - &exact) * near.digamma();
            assert!(excess >= bounded && bounded >= 0, "{excess} below {bounded}");
            assert!(excess < Float::with_val(10, 1) >> (precision + 8));
        }
    }
}
