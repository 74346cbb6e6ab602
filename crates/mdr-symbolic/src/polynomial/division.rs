//! Division with remainder, the greatest common divisor, the primitive part.

use rug::{Integer, Rational};

use super::Polynomial;
use crate::error::{Error, Result};

impl Polynomial {
    /// Quotient and remainder of a lower degree than the divisor.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub fn divide(&self, divisor: &Self) -> Result<(Self, Self)> {
        if divisor.is_zero() {
            return Err(Error::DivisionByZero);
        }
        let mut rest = self.0.clone();
        let mut quotient = vec![Rational::new(); (self.0.len() + 1).saturating_sub(divisor.0.len())];
        let leading = divisor.leading();
        for shift in (0..quotient.len()).rev() {
            let factor = Rational::from(&rest[shift + divisor.degree()] / &leading);
            for (c, below) in divisor.0.iter().zip(&mut rest[shift..]) {
                *below -= Rational::from(c * &factor);
            }
            quotient[shift] = factor;
        }
        Ok((Self::new(quotient), Self::new(rest)))
    }

    /// The quotient, if the remainder is zero.
    pub(crate) fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        let (quotient, rest) = self.divide(divisor).ok()?;
        rest.is_zero().then_some(quotient)
    }

    /// The monic greatest common divisor, by Euclid's algorithm; 0 when both are 0.
    pub fn gcd(&self, other: &Self) -> Self {
        if [self, other].iter().any(|side| side.degree() == 0 && !side.is_zero()) {
            return Self::constant(1);
        }
        let (mut greater, mut less) = (self.clone(), other.clone());
        while let Ok((_, rest)) = greater.divide(&less) {
            (greater, less) = (less, rest);
        }
        greater.monic()
    }

    /// The polynomial divided by its leading coefficient.
    pub(crate) fn monic(&self) -> Self {
        if self.is_zero() { Self::default() } else { self.scaled(&self.leading().recip()) }
    }

    /// The content, which carries the sign, and the primitive part: integer coefficients without a common factor, the
    /// leading one positive.
    pub fn primitive(&self) -> (Rational, Self) {
        let numerator = self.0.iter().fold(Integer::new(), |gcd, c| gcd.gcd(c.numer()));
        let denominator = self.0.iter().fold(Integer::from(1), |lcm, c| lcm.lcm(c.denom()));
        if numerator == 0 {
            return (Rational::new(), Self::constant(1));
        }
        let mut content = Rational::from((numerator, denominator));
        if self.leading() < 0 {
            content = -content;
        }
        let part = self.scaled(&Rational::from(content.recip_ref()));
        (content, part)
    }
}
