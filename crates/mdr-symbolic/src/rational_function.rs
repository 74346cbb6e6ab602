//! Q(n): quotients of polynomials in n, in lowest terms.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use rug::{Integer, Rational};

use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::polynomial::Polynomial;

/// An element of Q(n). Numerator and denominator have no common factor and the denominator is monic: equal functions
/// are equal values.
///
/// ```
/// use mdr_symbolic::{Polynomial, RationalFunction};
/// let n = RationalFunction::n();
/// let quotient = (&n * &n).divide(&n)?;
/// assert_eq!(quotient, n);
/// # Ok::<(), mdr_symbolic::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RationalFunction {
    numerator: Polynomial,
    denominator: Polynomial,
}

/// The most bits of a numerator or denominator for which a power is expanded, including 64 for each coefficient.
pub(crate) const LARGEST_POWER: u64 = 1 << 16;

impl RationalFunction {
    /// The quotient of two polynomials.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub fn new(numerator: Polynomial, denominator: Polynomial) -> Result<Self> {
        if denominator.is_zero() {
            return Err(Error::DivisionByZero);
        }
        let common = numerator.gcd(&denominator);
        let (numerator, denominator) = match common.degree() {
            0 => (numerator, denominator),
            _ => (numerator.divide(&common)?.0, denominator.divide(&common)?.0),
        };
        let scale = denominator.leading().recip();
        Ok(RationalFunction { numerator: numerator.scaled(&scale), denominator: denominator.scaled(&scale) })
    }

    /// The number `value`.
    pub fn constant(value: impl Into<Rational>) -> Self {
        Polynomial::constant(value).into()
    }

    /// The fraction `numerator/denominator`, for a positive denominator.
    pub fn ratio(numerator: i32, denominator: u32) -> Self {
        Self::constant(Rational::from((numerator, denominator)))
    }

    /// n itself.
    pub fn n() -> Self {
        Polynomial::linear(1, 0).into()
    }

    /// The numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The monic denominator.
    pub fn denominator(&self) -> &Polynomial {
        &self.denominator
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        self.as_constant().is_some_and(|value| value == 1)
    }

    /// The constant value, if it does not depend on n.
    pub fn as_constant(&self) -> Option<Rational> {
        // A monic constant denominator is 1.
        if self.denominator.degree() == 0 { self.numerator.as_constant() } else { None }
    }

    /// The integer value, if it is an integer.
    pub fn as_integer(&self) -> Option<Integer> {
        self.as_constant().filter(Rational::is_integer).map(|value| value.into_numer_denom().0)
    }

    /// The constant term of the polynomial part: the unique q with self − q = n·(a polynomial) + (a proper fraction).
    /// Adding a number to the function adds it to q.
    pub(crate) fn constant_part(&self) -> Rational {
        let whole = self.numerator.divide(&self.denominator).map(|(quotient, _)| quotient).unwrap_or_default();
        whole.coefficients().first().cloned().unwrap_or_default()
    }

    /// The reciprocal.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub fn inverse(&self) -> Result<Self> {
        Self::new(self.denominator.clone(), self.numerator.clone())
    }

    /// The quotient.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub fn divide(&self, divisor: &Self) -> Result<Self> {
        Ok(self * &divisor.inverse()?)
    }

    /// The integer power.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`]; [`Error::TooLarge`] if the result exceeds 2¹⁶ bits.
    pub fn power(&self, exponent: i32) -> Result<Self> {
        let base = if exponent < 0 { self.inverse()? } else { self.clone() };
        let natural = exponent.unsigned_abs();
        if [&base.numerator, &base.denominator].into_iter().any(|part| part.bits_of_power(natural) > LARGEST_POWER) {
            return Err(Error::TooLarge(format!("({})^{exponent}", crate::print::function_text(self))));
        }
        // Powers of polynomials without a common factor have no common factor.
        Ok(RationalFunction { numerator: base.numerator.power(natural), denominator: base.denominator.power(natural) })
    }

    /// The value at n.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`] at a pole.
    pub fn evaluate(&self, n: &Rational) -> Result<Rational> {
        let below = self.denominator.evaluate(n);
        if below.is_zero() { Err(Error::DivisionByZero) } else { Ok(self.numerator.evaluate(n) / below) }
    }

    /// The sign on the whole domain; `None` when it changes, vanishes or has a pole there.
    pub fn sign_on(&self, domain: Domain) -> Option<Ordering> {
        let below = self.denominator.sign_on(domain).filter(|sign| sign.is_ne())?;
        let above = self.numerator.sign_on(domain)?;
        Some(if below.is_lt() { above.reverse() } else { above })
    }
}

impl From<Polynomial> for RationalFunction {
    fn from(numerator: Polynomial) -> Self {
        RationalFunction { numerator, denominator: Polynomial::constant(1) }
    }
}

/// The quotient in lowest terms, for a nonzero denominator.
fn lowest_terms(numerator: Polynomial, denominator: Polynomial) -> RationalFunction {
    RationalFunction::new(numerator, denominator).unwrap_or_else(|_| RationalFunction::constant(0))
}

impl Add for &RationalFunction {
    type Output = RationalFunction;
    fn add(self, other: &RationalFunction) -> RationalFunction {
        if self.is_zero() {
            return other.clone();
        }
        let numerator = &(&self.numerator * &other.denominator) + &(&other.numerator * &self.denominator);
        lowest_terms(numerator, &self.denominator * &other.denominator)
    }
}

impl Neg for &RationalFunction {
    type Output = RationalFunction;
    fn neg(self) -> RationalFunction {
        RationalFunction { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }
}

impl Sub for &RationalFunction {
    type Output = RationalFunction;
    fn sub(self, other: &RationalFunction) -> RationalFunction {
        self + &-other
    }
}

impl Mul for &RationalFunction {
    type Output = RationalFunction;
    fn mul(self, other: &RationalFunction) -> RationalFunction {
        if self.is_one() {
            return other.clone();
        }
        if other.is_one() {
            return self.clone();
        }
        lowest_terms(&self.numerator * &other.numerator, &self.denominator * &other.denominator)
    }
}
