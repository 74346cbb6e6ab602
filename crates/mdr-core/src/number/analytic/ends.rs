//! Intervals of real numbers by their ends, over which formulas and complex rectangles are made.

use std::cmp::Ordering;

use rug::Float;
use rug::float::Round;

use super::{Analytic, NearZero, Rectangle};
use crate::number::{DoubleInterval, Interval, Precision, Real, Special};

/// An interval of real numbers, in hardware or in any precision. Each one is [`Analytic`].
pub trait Ends: Special {
    /// See [`Analytic::WORK`].
    const WORK: u64;

    /// An enclosure of an interval in the context of another.
    fn around(ctx: Self::Ctx, interval: &Interval) -> Self;

    /// The signs of the lower and of the upper end.
    fn signs(&self) -> [Ordering; 2];

    /// The lower and the upper end, as points.
    fn ends(&self) -> [Self; 2];

    /// The smallest interval that contains both.
    fn hull(&self, other: &Self) -> Self;

    /// √(x² + y²) for x, y ≥ 0.
    fn hypot(&self, other: &Self) -> Self;

    /// The angle of the point x + iy, with y = `self`: between −π and π.
    fn angle(&self, x: &Self) -> Self;

    /// The upper end in a precision that holds it.
    fn most(&self) -> Float;

    /// Whether both ends are within (−1/2, 1/2).
    fn is_within_half(&self) -> bool;

    /// Whether 0 lies in the interval.
    fn has_zero(&self) -> bool {
        let [lower, upper] = self.signs();
        lower != Ordering::Greater && upper != Ordering::Less
    }
}

impl Ends for Interval {
    const WORK: u64 = 8;

    fn around(ctx: Precision, interval: &Interval) -> Self {
        interval.rounded(ctx)
    }
    fn signs(&self) -> [Ordering; 2] {
        [self.lower(), self.upper()].map(|end| end.cmp0().unwrap_or(Ordering::Equal))
    }
    fn ends(&self) -> [Self; 2] {
        [self.lower(), self.upper()].map(|end| Interval::point(end.clone()))
    }
    fn is_within_half(&self) -> bool {
        *self.lower() > -0.5 && *self.upper() < 0.5
    }
    fn hull(&self, other: &Self) -> Self {
        Interval::hull(self, other)
    }
    fn most(&self) -> Float {
        self.upper().clone()
    }
    fn hypot(&self, other: &Self) -> Self {
        let bits = self.precision();
        let end = |x: &Float, y: &Float, round| Float::with_val_round(bits, x.hypot_ref(y), round).0;
        Interval::new(end(self.lower(), other.lower(), Round::Down), end(self.upper(), other.upper(), Round::Up))
    }
    fn angle(&self, x: &Self) -> Self {
        let end = |round| Float::with_val_round(self.precision(), self.lower().atan2_ref(x.lower()), round).0;
        Interval::new(end(Round::Down), end(Round::Up))
    }
}

impl Ends for DoubleInterval {
    const WORK: u64 = 2;

    fn around((): (), interval: &Interval) -> Self {
        DoubleInterval::around(interval)
    }
    fn signs(&self) -> [Ordering; 2] {
        [self.lower(), self.upper()].map(|end| end.partial_cmp(&0.0).unwrap_or(Ordering::Equal))
    }
    fn ends(&self) -> [Self; 2] {
        [self.lower(), self.upper()].map(DoubleInterval::point)
    }
    fn is_within_half(&self) -> bool {
        self.lower() > -0.5 && self.upper() < 0.5
    }
    fn hull(&self, other: &Self) -> Self {
        DoubleInterval::hull(self, other)
    }
    fn most(&self) -> Float {
        Float::with_val(f64::MANTISSA_DIGITS, self.upper())
    }
    fn hypot(&self, other: &Self) -> Self {
        DoubleInterval::hypot(self, other)
    }
    fn angle(&self, x: &Self) -> Self {
        DoubleInterval::angle(self, x)
    }
}

/// The value, if every step was in its domain.
fn defined<I: Ends>(value: I) -> Option<I> {
    Real::is_finite(&value).then_some(value)
}

impl<I: Ends> Analytic for I {
    const WORK: u64 = <I as Ends>::WORK;
    type Complex = Rectangle<I>;

    /// On a rectangle that reaches beyond the interval by half of its length on each side.
    fn by_boundary(
        &self,
        is_analytic: impl Fn(&Rectangle<I>) -> bool,
        values: impl Fn(&Rectangle<I>) -> Option<Vec<Rectangle<I>>>,
    ) -> Option<Vec<Self>> {
        let [lower, upper] = self.ends();
        let length = upper - lower;
        let around = self.clone().inflate(&length.clone().over(2));
        let values = Rectangle::new(around, length.lit(0).hull(&length)).by_boundary(is_analytic, values)?;
        Some(values.into_iter().map(|value| value.re().clone()).collect())
    }
    fn beside_zero(&self) -> Option<NearZero<Self>> {
        let begins_at_zero = self.signs() == [Ordering::Equal, Ordering::Greater];
        if begins_at_zero { NearZero::up_to(&self.lit(1), &Interval::point(self.most())) } else { None }
    }
    fn bits(&self) -> u32 {
        self.precision()
    }
    fn constant(&self, value: &Interval) -> Self {
        I::around(self.ctx(), value)
    }
    fn plus(&self, other: &Self) -> Self {
        self.clone() + other
    }
    fn minus(&self, other: &Self) -> Self {
        self.clone() - other
    }
    fn product(&self, other: &Self) -> Self {
        self.clone() * other
    }
    fn scaled(&self, factor: &Interval) -> Self {
        self.clone() * I::around(self.ctx(), factor)
    }
    fn squared(&self) -> Self {
        Real::square(self)
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        if divisor.has_zero() { None } else { defined(self.clone() / divisor) }
    }
    fn raised(&self, exponent: i64) -> Option<Self> {
        defined(self.powi(exponent))
    }
    fn power(&self, exponent: &Interval) -> Option<Self> {
        defined(self.pow(&I::around(self.ctx(), exponent)))
    }
    fn sqrt(&self) -> Option<Self> {
        defined(Real::sqrt(self))
    }
    fn exp(&self) -> Self {
        Real::exp(self)
    }
    fn ln(&self) -> Option<Self> {
        defined(Real::ln(self))
    }
    fn sin_cos(&self) -> (Self, Self) {
        self.sin_and_cos()
    }
    fn sinh_cosh(&self) -> (Self, Self) {
        (Special::sinh(self), Special::cosh(self))
    }
    fn tanh(&self) -> Option<Self> {
        defined(Special::tanh(self))
    }
    fn atan(&self) -> Option<Self> {
        defined(Special::atan(self))
    }
    fn asin(&self) -> Option<Self> {
        defined(Special::asin(self))
    }
    fn atanh(&self) -> Option<Self> {
        defined(Special::atanh(self))
    }
    fn is_bounded(&self) -> bool {
        Real::is_finite(self)
    }
    fn positive_part(&self) -> Self {
        self.greater(&Analytic::integer(self, 0))
    }
    fn side(&self) -> Option<Ordering> {
        match self.signs() {
            [Ordering::Greater | Ordering::Equal, _] => Some(Ordering::Greater),
            [_, Ordering::Less | Ordering::Equal] => Some(Ordering::Less),
            _ => None,
        }
    }
    fn is_small(&self) -> bool {
        self.is_within_half()
    }
    fn integer(&self, value: i64) -> Self {
        self.lit(value)
    }
    fn half_turn(&self) -> Self {
        self.pi()
    }
    fn multiplied(&self, k: i64) -> Self {
        self.clone().times(k)
    }
    fn divided(&self, k: i64) -> Self {
        self.clone().over(k)
    }
    fn negated(&self) -> Self {
        -self.clone()
    }
}
