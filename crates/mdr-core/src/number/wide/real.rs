//! `Real` for extended precision.

use super::Wide;
use super::tables::PI;
use crate::number::{Literal, Real};

impl<const N: usize> Real for Wide<N> {
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
        parse(&literal.to_string())
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
        Wide { negative: false, ..*self }
    }
    #[inline]
    fn square(&self) -> Self {
        self.product(self)
    }
    #[inline]
    fn sqrt(&self) -> Self {
        self.root()
    }
    fn exp(&self) -> Self {
        self.exponential()
    }
    fn exp_m1(&self) -> Self {
        self.exponential_minus_one()
    }
    fn ln(&self) -> Self {
        self.logarithm()
    }
    fn ln_1p(&self) -> Self {
        self.logarithm_of_one_plus()
    }
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
    fn steer(&self) -> Self {
        self.exactly()
    }
}

/// Any double is represented exactly.
impl<const N: usize> From<f64> for Wide<N> {
    fn from(value: f64) -> Self {
        Self::from_double(value)
    }
}

/// The value of the text of a [`Literal`], whose grammar has been checked.
fn parse<const N: usize>(text: &str) -> Wide<N> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        return parse::<N>(numerator) / parse::<N>(denominator);
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.bytes().chain(fraction.bytes()).filter(u8::is_ascii_digit);
    let integer = digits.fold(Wide::ZERO, |sum: Wide<N>, digit| sum.times(10) + sum.lit(i64::from(digit - b'0')));
    let exponent = exponent.parse().unwrap_or(0_i64) - fraction.len() as i64;
    let power = Wide::from_double(10.0).whole_power(exponent.abs());
    let magnitude = if exponent < 0 { integer / power } else { integer * power };
    if text.starts_with('-') { -magnitude } else { magnitude }
}
