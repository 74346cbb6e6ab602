//! `Real` and `Special` for intervals of doubles, monotone piece by monotone piece.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::DoubleInterval;
use crate::number::{Interval, Literal, Precision, Real, Special};

/// The ends of an elementary function are widened by so many units in the last place, of which its error takes one at most.
const WIDENED: f64 = 4.0 * f64::EPSILON;
/// and by an absolute amount, which is 64 of the smallest numbers: a value that has underflowed keeps few bits.
const SMALLEST: f64 = 64.0 * 5e-324;
/// Beyond so large arguments sin and cos are enclosed by [−1, 1].
const LARGEST: f64 = 1e6;
/// How far a turning point of sin and cos may be from where doubles see it, in half turns: far more than its rounding up to there.
const BESIDE: f64 = 1e-8;

/// A value rounded down; one that has overflowed is beyond the largest number.
fn down(value: f64) -> f64 {
    if value.is_infinite() { value.next_down() } else { (value - (value.abs() * WIDENED + SMALLEST)).next_down() }
}

fn up(value: f64) -> f64 {
    -down(-value)
}

impl DoubleInterval {
    /// `image` if the interval is `inside` the domain, else (and for the entire line) the entire line.
    fn within(&self, inside: bool, image: impl FnOnce(&Self) -> Self) -> Self {
        if inside && !self.is_entire() { image(self) } else { Self::ENTIRE }
    }

    /// The image under an increasing function with an error below one unit in the last place.
    fn increasing(&self, function: impl Fn(f64) -> f64) -> Self {
        let lo = down(function(self.lo));
        Self::new(lo, if self.is_point() { up(function(self.lo)) } else { up(function(self.hi)) })
    }

    /// The image under an increasing function which takes zero to zero and keeps signs.
    fn odd(&self, function: impl Fn(f64) -> f64) -> Self {
        let Self { lo, hi } = self.increasing(function);
        let lo = if self.lo >= 0.0 { lo.max(0.0) } else { lo };
        let hi = if self.hi <= 0.0 { hi.min(0.0) } else { hi };
        if self.lo == 0.0 && self.hi == 0.0 { *self } else { Self::new(lo, hi) }
    }

    /// The part of an image that is not below a number.
    fn at_least(self, least: f64) -> Self {
        Self::new(self.lo.max(least), self.hi.max(least))
    }

    /// √(x² + y²) for x, y ≥ 0.
    pub(in crate::number) fn hypot(&self, other: &Self) -> Self {
        self.within(!other.is_entire(), |x| {
            let least = down(pxfm::f_hypot(x.lo, other.lo));
            let greatest = pxfm::f_hypot(x.hi, other.hi);
            Self::new(least.max(0.0), if greatest == 0.0 { 0.0 } else { up(greatest) })
        })
    }

    /// The angle of the point x + iy, with y = `self`.
    pub(in crate::number) fn angle(&self, x: &Self) -> Self {
        let angle = pxfm::f_atan2(self.lo, x.lo);
        Self::new(down(angle), up(angle))
    }

    /// The image under sin or cos, whose turning points are at whole numbers of `half_turns`: maxima at the even ones.
    ///
    /// A whole number that is nearly inside counts as inside, which only widens the image.
    fn oscillating(&self, function: impl Fn(f64) -> f64, half_turns: impl Fn(f64) -> f64) -> Self {
        let unit = DoubleInterval { lo: -1.0, hi: 1.0 };
        if self.lo < -LARGEST || self.hi > LARGEST || self.hi - self.lo >= TAU {
            return unit;
        }
        let (first, last) = ((half_turns(self.lo) - BESIDE).ceil(), (half_turns(self.hi) + BESIDE).floor());
        let (one, other) = (function(self.lo), function(self.hi));
        let turns = |even: bool| first <= last && (first < last || (first.rem_euclid(2.0) == 0.0) == even);
        let lo = if turns(false) { -1.0 } else { down(one.min(other)).max(-1.0) };
        let hi = if turns(true) { 1.0 } else { up(one.max(other)).min(1.0) };
        Self::new(lo, hi)
    }
}

/// Increasing functions by their names, those of `pxfm`, and their domains.
macro_rules! functions {
    ($($how:ident $name:ident: $function:ident, |$x:pat_param| $inside:expr;)*) => {$(
        fn $name(&self) -> Self {
            let $x = self;
            self.within($inside, |x| x.$how(pxfm::$function))
        }
    )*};
}

impl Real for DoubleInterval {
    type Ctx = ();

    fn ctx(&self) {}
    fn from_int((): (), value: i64) -> Self {
        let nearest = value as f64;
        let is_exact = value.unsigned_abs() <= 1 << f64::MANTISSA_DIGITS;
        if is_exact { Self::point(nearest) } else { Self::new(nearest.next_down(), nearest.next_up()) }
    }
    fn from_f64((): (), value: f64) -> Self {
        Self::point(value)
    }
    fn from_literal((): (), literal: &Literal) -> Self {
        Self::around(&Interval::from_literal(Precision::new(64), literal))
    }
    /// The double nearest to π is below it.
    fn pi(&self) -> Self {
        DoubleInterval { lo: PI, hi: PI.next_up() }
    }
    fn times(self, k: i64) -> Self {
        self * Self::from_int((), k)
    }
    fn over(self, k: i64) -> Self {
        self / Self::from_int((), k)
    }
    fn abs(&self) -> Self {
        if self.is_entire() || self.lo >= 0.0 {
            *self
        } else if self.hi <= 0.0 {
            -*self
        } else {
            DoubleInterval { lo: 0.0, hi: self.hi.max(-self.lo) }
        }
    }
    fn square(&self) -> Self {
        let size = self.abs();
        size * size
    }
    fn sqrt(&self) -> Self {
        let end = |x: f64| x.sqrt();
        self.within(self.lo >= 0.0, |x| {
            let lo = if x.lo == 0.0 { 0.0 } else { end(x.lo).next_down() };
            Self::new(lo, if x.hi == 0.0 { 0.0 } else { end(x.hi).next_up() })
        })
    }
    fn exp(&self) -> Self {
        self.within(true, |x| x.increasing(pxfm::f_exp).at_least(0.0))
    }
    functions! {
        odd exp_m1: f_expm1, |_| true;
        increasing ln: f_log, |x| x.lo > 0.0;
        odd ln_1p: f_log1p, |x| x.lo > -1.0;
    }
    /// The extreme corners of e^(y ln x) are those of a product.
    fn pow(&self, exponent: &Self) -> Self {
        let inside = self.lo > 0.0 || self.lo == 0.0 && exponent.lo > 0.0;
        self.within(inside && !exponent.is_entire(), |base| {
            let corner = |x: f64, y: f64| if x == 0.0 { 0.0 } else { pxfm::f_pow(x, y) };
            let corners = [
                corner(base.lo, exponent.lo),
                corner(base.lo, exponent.hi),
                corner(base.hi, exponent.lo),
                corner(base.hi, exponent.hi),
            ];
            let least = corners.into_iter().fold(f64::INFINITY, f64::min);
            let greatest = corners.into_iter().fold(0.0, f64::max);
            Self::new(
                if base.lo == 0.0 { 0.0 } else { down(least).max(0.0) },
                if base.hi == 0.0 { 0.0 } else { up(greatest) },
            )
        })
    }
    fn powi(&self, exponent: i64) -> Self {
        self.within(exponent >= 0 || !self.contains_zero(), |x| match exponent {
            0 => Self::from_int((), 1),
            1 => *x,
            k if k < 0 => k.checked_neg().map_or(Self::ENTIRE, |k| num_traits::Inv::inv(x.powi(k))),
            k if k % 2 == 0 => x.powi(k / 2).square(),
            k => x.powi(k - 1) * x,
        })
    }
    fn precision(&self) -> u32 {
        f64::MANTISSA_DIGITS
    }
    fn unit_roundoff(&self) -> Self {
        Self::point(f64::EPSILON / 2.0)
    }
    fn approx(&self) -> f64 {
        let sum = self.lo + self.hi;
        if sum.is_finite() { sum / 2.0 } else { self.lo / 2.0 + self.hi / 2.0 }
    }
    fn is_finite(&self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }
    fn inflate(self, bound: &Self) -> Self {
        let most = bound.abs().hi;
        self + DoubleInterval { lo: -most, hi: most }
    }
    fn greater(&self, other: &Self) -> Self {
        Self::new(self.lo.max(other.lo), self.hi.max(other.hi))
    }
    fn either(&self, other: &Self) -> Self {
        self.hull(other)
    }
    fn midpoint(&self) -> Self {
        Self::point(self.approx())
    }
}

impl Special for DoubleInterval {
    fn sin(&self) -> Self {
        // Turning points are at π/2 + kπ, maxima at even k.
        let image = self.within(true, |x| x.oscillating(pxfm::f_sin, |x| (x - FRAC_PI_2) / PI));
        // Zero stays exact, and sin keeps the sign of x up to 3 < π.
        match (self.lo == 0.0 && self.hi == 0.0, self.lo >= 0.0 && self.hi < 3.0) {
            (true, _) => *self,
            (_, true) => image.at_least(0.0),
            _ => image,
        }
    }
    fn cos(&self) -> Self {
        self.within(true, |x| x.oscillating(pxfm::f_cos, |x| x / PI))
    }
    functions! {
        odd atan: f_atan, |_| true;
        odd asin: f_asin, |x| x.lo >= -1.0 && x.hi <= 1.0;
        odd sinh: f_sinh, |_| true;
        odd tanh: f_tanh, |_| true;
        odd atanh: f_atanh, |x| x.lo > -1.0 && x.hi < 1.0;
        increasing log10: f_log10, |x| x.lo > 0.0;
    }
    fn acos(&self) -> Self {
        self.within(self.lo >= -1.0 && self.hi <= 1.0, |x| (-*x).increasing(|x| pxfm::f_acos(-x)).at_least(0.0))
    }
    fn cosh(&self) -> Self {
        self.within(true, |x| x.abs().increasing(pxfm::f_cosh).at_least(1.0))
    }
}
