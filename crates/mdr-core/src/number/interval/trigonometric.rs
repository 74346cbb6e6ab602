//! `Special` for intervals.

use std::cmp::Ordering;
// Both doubles are just below the exact value.
use std::f64::consts::{PI, TAU};

use rug::Float;
use rug::float::Round;

use super::Interval;
use super::elementary::increasing;
use crate::number::{Real, Special};

/// Arguments beyond 2^LARGEST would need as many bits of π; there sin and cos are enclosed by [−1, 1].
const LARGEST: i32 = 1 << 17;

impl Interval {
    /// The image under sin or cos, from the function and, at a point, the sign of its derivative.
    ///
    /// Over less than half a turn the derivative changes its sign at most once, over less than a whole turn at least
    /// once and at most twice: its signs just inside the two ends decide which.
    fn oscillating(
        &self,
        function: impl Fn(&mut Float, Round) -> Ordering,
        slope: impl Fn(&Float) -> Ordering,
    ) -> Interval {
        let exponent = self.lo.get_exp().max(self.hi.get_exp());
        let width = self.width();
        if exponent.is_some_and(|exponent| exponent > LARGEST) || width > TAU {
            return self.between(-1, 1);
        }
        if self.is_point() {
            return self.increasing(function);
        }
        // The derivative of cos vanishes at 0, the only such floating-point number; cos increases before it and
        // decreases after it.
        match (slope(&self.lo).is_gt(), slope(&self.hi).is_ge()) {
            (true, false) => self.across_extremum(function, true),
            (false, true) => self.across_extremum(function, false),
            _ if width > PI => self.between(-1, 1),
            (true, true) => self.increasing(function),
            (false, false) => self.decreasing(function),
        }
    }

    /// The image across one interior maximum 1, or minimum −1: the other extreme value is at one of the ends.
    fn across_extremum(&self, function: impl Fn(&mut Float, Round) -> Ordering, maximum: bool) -> Interval {
        let (mut first, mut last) = (self.lo.clone(), self.hi.clone());
        let round = if maximum { Round::Down } else { Round::Up };
        function(&mut first, round);
        function(&mut last, round);
        let extremum = Float::with_val(self.lo.prec(), if maximum { 1 } else { -1 });
        if maximum {
            Interval { lo: first.min(&last), hi: extremum }
        } else {
            Interval { lo: extremum, hi: first.max(&last) }
        }
    }

    /// [lower, upper] in the precision of `self`.
    fn between(&self, lower: i32, upper: i32) -> Interval {
        let end = |value| Float::with_val(self.lo.prec(), value);
        Interval { lo: end(lower), hi: end(upper) }
    }
}

/// Enough bits for the sign of a correctly rounded function.
const SIGN_BITS: u32 = 32;
/// Up to here the nearest double is within 2⁻³³ of a number, and sin and cos move by no more.
const NEAR: f64 = 1_048_576.0;
/// A value there that is larger than this, 2⁻³⁰, has the sign of the value at the number.
const CERTAIN: f64 = 1.0 / 1_073_741_824.0;

/// The sign of sin or cos: that of its value at the nearest double where that is certain, else that of the value itself.
fn sign(x: &Float, in_doubles: impl Fn(f64) -> f64, exact: impl Fn(&Float) -> Float) -> Ordering {
    let nearest = x.to_f64();
    let value = in_doubles(nearest);
    if nearest.abs() <= NEAR && value.abs() > CERTAIN {
        value.total_cmp(&0.0)
    } else {
        exact(x).cmp0().unwrap_or(Ordering::Equal)
    }
}

/// The sign of sin.
fn sign_of_sin(x: &Float) -> Ordering {
    sign(x, pxfm::f_sin, |x| Float::with_val(SIGN_BITS, x.sin_ref()))
}

/// The sign of cos.
fn sign_of_cos(x: &Float) -> Ordering {
    sign(x, pxfm::f_cos, |x| Float::with_val(SIGN_BITS, x.cos_ref()))
}

impl Special for Interval {
    /// Tight for arguments up to 2^131072 in magnitude, [−1, 1] beyond.
    fn sin(&self) -> Interval {
        self.within(true, |x| x.oscillating(Float::sin_round, sign_of_cos))
    }
    /// Tight for arguments up to 2^131072 in magnitude, [−1, 1] beyond.
    fn cos(&self) -> Interval {
        self.within(true, |x| x.oscillating(Float::cos_round, |x| sign_of_sin(x).reverse()))
    }
    increasing! {
        atan: atan_round, |_| true;
        asin: asin_round, |x| x.lo >= -1 && x.hi <= 1;
        sinh: sinh_round, |_| true;
        tanh: tanh_round, |_| true;
        atanh: atanh_round, |x| x.lo > -1 && x.hi < 1;
        log10: log10_round, |x| x.lo > 0;
    }
    fn acos(&self) -> Interval {
        self.within(self.lo >= -1 && self.hi <= 1, |x| x.decreasing(Float::acos_round))
    }
    fn cosh(&self) -> Interval {
        self.within(true, |x| x.abs().increasing(Float::cosh_round))
    }
}
