//! Polynomials in n with rational coefficients.

mod division;
mod factor;
mod sign;

use std::ops::{Add, Mul, Neg, Sub};

use rug::Rational;

pub(crate) use factor::{Factors, prime_factors};

/// A polynomial in n over Q. Coefficients are in ascending order, the last one nonzero: equal polynomials are equal
/// values.
///
/// ```
/// use mdr_symbolic::Polynomial;
/// let (sum, difference) = (Polynomial::linear(1, 1), Polynomial::linear(1, -1)); // n + 1, n − 1
/// assert_eq!(&sum * &difference, Polynomial::from_integers(&[-1, 0, 1]));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Polynomial(Vec<Rational>);

impl Polynomial {
    /// From coefficients in ascending order.
    pub fn new(mut coefficients: Vec<Rational>) -> Self {
        while coefficients.last().is_some_and(Rational::is_zero) {
            coefficients.pop();
        }
        Polynomial(coefficients)
    }

    /// From integer coefficients in ascending order.
    pub fn from_integers(coefficients: &[i64]) -> Self {
        Self::new(coefficients.iter().map(|c| Rational::from(*c)).collect())
    }

    /// The number `value`.
    pub fn constant(value: impl Into<Rational>) -> Self {
        Self::new(vec![value.into()])
    }

    /// slope·n + offset.
    pub fn linear(slope: i64, offset: i64) -> Self {
        Self::from_integers(&[offset, slope])
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The degree; 0 for the zero polynomial.
    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// The coefficients in ascending order.
    pub fn coefficients(&self) -> &[Rational] {
        &self.0
    }

    /// The coefficient of the highest power; 0 for the zero polynomial.
    pub fn leading(&self) -> Rational {
        self.0.last().cloned().unwrap_or_default()
    }

    /// The constant value, if the degree is 0.
    pub fn as_constant(&self) -> Option<Rational> {
        (self.0.len() <= 1).then(|| self.leading())
    }

    /// The value at n.
    pub fn evaluate(&self, n: &Rational) -> Rational {
        self.0.iter().rev().fold(Rational::new(), |sum, c| sum * n + c)
    }

    /// The derivative with respect to n.
    pub fn derivative(&self) -> Self {
        Self::new(self.0.iter().zip(0u32..).skip(1).map(|(c, i)| Rational::from(c * i)).collect())
    }

    /// The polynomial times a number.
    pub fn scaled(&self, factor: &Rational) -> Self {
        Self::new(self.0.iter().map(|c| Rational::from(c * factor)).collect())
    }

    /// The natural power, by squaring.
    pub fn power(&self, exponent: u32) -> Self {
        let bits = (0..u32::BITS - exponent.leading_zeros()).rev();
        bits.fold(Self::constant(1), |power, bit| {
            let square = &power * &power;
            if (exponent >> bit) & 1 == 1 { &square * self } else { square }
        })
    }

    /// A bound on the bits of a natural power, including 64 for each coefficient.
    pub(crate) fn bits_of_power(&self, exponent: u32) -> u64 {
        let bits = |integer: &rug::Integer| u64::from(integer.significant_bits().saturating_sub(1));
        let largest = self.0.iter().map(|c| bits(c.numer()) + bits(c.denom())).max().unwrap_or(0);
        let carry = u64::from(usize::BITS - self.degree().leading_zeros());
        let coefficients = (self.degree() as u64).saturating_mul(exponent.into()).saturating_add(1);
        coefficients.saturating_mul((largest + carry).saturating_mul(exponent.into()).saturating_add(64))
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: &Polynomial) -> Polynomial {
        let (long, short) = if self.0.len() < other.0.len() { (other, self) } else { (self, other) };
        let mut sum = long.0.clone();
        sum.iter_mut().zip(&short.0).for_each(|(total, c)| *total += c);
        Polynomial::new(sum)
    }
}

impl Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.scaled(&Rational::from(-1))
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: &Polynomial) -> Polynomial {
        self + &-other
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: &Polynomial) -> Polynomial {
        if self.is_zero() || other.is_zero() {
            return Polynomial::default();
        }
        let mut product = vec![Rational::new(); self.0.len() + other.0.len() - 1];
        for (i, left) in self.0.iter().enumerate() {
            for (j, right) in other.0.iter().enumerate() {
                product[i + j] += Rational::from(left * right);
            }
        }
        Polynomial::new(product)
    }
}
