//! `Real` for extended precision.

use super::Extended;
use super::tables::PI;
use crate::number::{Literal, Real};

/// Functions of one number, each with its name among those of extended precision.
macro_rules! functions {
    ($($name:ident: $function:ident),*) => {$(
        fn $name(&self) -> Self {
            self.$function()
        }
    )*};
}

impl<const N: usize> Real for Extended<N> {
    type Ctx = ();

    #[inline]
    fn ctx(&self) {}
    #[inline]
    fn from_int((): (), value: i64) -> Self {
        Self::from_integer(value < 0, value.unsigned_abs())
    }
    #[inline]
    fn from_f64((): (), value: f64) -> Self {
        Self::from_double(value)
    }
    fn from_literal((): (), literal: &Literal) -> Self {
        let integer = |digits: &str| {
            digits
                .bytes()
                .fold(Self::ZERO, |sum, digit| sum.times(10) + Self::from_integer(false, (digit - b'0').into()))
        };
        let power = Self::from_double(10.0).whole_power(literal.exponent.abs());
        let digits = integer(&literal.digits);
        let magnitude = if literal.exponent < 0 { digits / power } else { digits * power };
        (magnitude / integer(&literal.denominator)).flipped(literal.negative)
    }
    #[inline]
    fn pi(&self) -> Self {
        Self::constant(PI)
    }
    #[inline]
    fn times(self, k: i64) -> Self {
        self.times_int(k)
    }
    #[inline]
    fn over(self, k: i64) -> Self {
        self.over_int(k)
    }
    #[inline]
    fn abs(&self) -> Self {
        Extended { negative: false, ..*self }
    }
    #[inline]
    fn square(&self) -> Self {
        self.product(self)
    }
    #[inline]
    fn sqrt(&self) -> Self {
        self.root()
    }
    functions!(exp: exponential, exp_m1: exponential_minus_one, ln: logarithm, ln_1p: logarithm_of_one_plus);
    fn pow(&self, exponent: &Self) -> Self {
        self.power(exponent)
    }
    fn pow_m1(&self, exponent: &Self) -> Self {
        let power = self.power(exponent);
        if power.is_exact() { power - self.lit(1) } else { self.logarithm().product(exponent).exponential_minus_one() }
    }
    fn powi(&self, exponent: i64) -> Self {
        self.whole_power(exponent)
    }
    fn precision(&self) -> u32 {
        64 * N as u32
    }
    fn unit_roundoff(&self) -> Self {
        Self::from_double(1.0).scaled(-Self::BITS)
    }
    fn approx(&self) -> f64 {
        self.to_double()
    }
    #[inline]
    fn is_finite(&self) -> bool {
        !self.is_nothing()
    }
    fn inflate(self, bound: &Self) -> Self {
        if bound.is_zero() { self } else { self.blurred(bound.exponent.saturating_add(1)) }
    }
    fn midpoint(&self) -> Self {
        self.exactly()
    }
}

/// Any double is represented exactly.
impl<const N: usize> From<f64> for Extended<N> {
    fn from(value: f64) -> Self {
        Self::from_double(value)
    }
}
