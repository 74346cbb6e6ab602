//! Enclosures of numbers of any magnitude.

use std::cmp::Ordering;

use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Real, order};

/// Up to this |unit| an enclosure is given by value, beyond by its logarithm; e^±NEAR are within the range of MPFR.
const NEAR: f64 = 7e8;

/// factor · e^unit: no sum, product or quotient leaves the range, and only an exact zero is a point at zero.
#[derive(Clone, Debug)]
pub struct Scaled {
    factor: Interval,
    unit: Interval,
}

impl From<Interval> for Scaled {
    fn from(factor: Interval) -> Self {
        Scaled { unit: factor.lit(0), factor }
    }
}

impl Scaled {
    /// e^ln.
    pub(super) fn exp(ln: Interval) -> Self {
        Scaled { factor: ln.lit(1), unit: ln }
    }

    /// The order of the number and zero; `None` if it is not certain.
    pub fn sign(&self) -> Option<Ordering> {
        self.factor.partial_cmp(&self.factor.lit(0))
    }

    fn is_zero(&self) -> bool {
        self.sign() == Some(Ordering::Equal)
    }

    /// ln of the magnitude; the entire line if the number may be zero.
    pub(super) fn ln_magnitude(&self) -> Interval {
        self.factor.abs().ln() + &self.unit
    }

    pub(super) fn by(&self, factor: &Interval) -> Self {
        Scaled { factor: self.factor.clone() * factor, unit: self.unit.clone() }
    }

    pub(super) fn times(&self, other: &Self) -> Self {
        Scaled { factor: self.factor.clone() * &other.factor, unit: self.unit.clone() + &other.unit }
    }

    pub(super) fn over(&self, other: &Self) -> Self {
        Scaled { factor: self.factor.clone() / &other.factor, unit: self.unit.clone() - &other.unit }
    }

    /// The sum, in the larger of the two units.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other.clone() } else { self.clone() };
        }
        let (less, greater) = if order(&self.unit, &other.unit).is_lt() { (self, other) } else { (other, self) };
        let share = (less.unit.clone() - &greater.unit).exp();
        Scaled { factor: share * &less.factor + &greater.factor, unit: greater.unit.clone() }
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&Scaled { factor: -other.factor.clone(), unit: other.unit.clone() })
    }

    /// The number times an integer.
    #[must_use]
    pub fn multiple(&self, k: i64) -> Self {
        Scaled { factor: self.factor.clone().times(k), unit: self.unit.clone() }
    }

    /// The number as an interval; beyond the exponent range of MPFR one of its ends is 0 or ∞.
    pub fn interval(&self) -> Interval {
        if self.is_zero() { self.factor.clone() } else { self.unit.exp() * &self.factor }
    }

    /// The number as an enclosure for rounding to decimals.
    pub fn enclosure(&self) -> Enclosure {
        if self.factor.contains_zero() || !self.factor.is_finite() {
            return Enclosure::Value(self.factor.clone());
        }
        if self.unit.approx().abs() < NEAR {
            return Enclosure::Value(self.interval());
        }
        Enclosure::Log { negative: self.sign() == Some(Ordering::Less), ln_magnitude: self.ln_magnitude() }
    }
}
