//! Irreducible factors over Q, for the small polynomials of this theory.

use rug::{Integer, Rational};

use super::Polynomial;
use crate::error::{Error, Result};

/// A content and irreducible primitive polynomials with their multiplicities, in a fixed order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Factors {
    pub(crate) content: Rational,
    pub(crate) factors: Vec<(Polynomial, u32)>,
}

/// The limit of trial division: the integers of the theory are products of small primes.
const LARGEST_PRIME: u32 = 10_000;

/// The primes of a positive integer, with their multiplicities.
///
/// # Errors
/// [`Error::Unfactored`] for 0 and if a factor beyond the trial division remains.
pub(crate) fn prime_factors(number: &Integer) -> Result<Vec<(u32, u32)>> {
    if number.is_zero() {
        return Err(Error::Unfactored("0".to_owned()));
    }
    let mut rest = number.clone();
    let mut primes = Vec::new();
    for candidate in 2..=LARGEST_PRIME {
        if rest == 1 {
            break;
        }
        let mut multiplicity = 0;
        while rest.is_divisible_u(candidate) {
            rest.div_exact_u_mut(candidate);
            multiplicity += 1;
        }
        if multiplicity > 0 {
            primes.push((candidate, multiplicity));
        }
    }
    if rest == 1 { Ok(primes) } else { Err(Error::Unfactored(number.to_string())) }
}

impl Polynomial {
    /// The content and the irreducible factors.
    ///
    /// Square-free parts come from Yun's algorithm, linear factors from the rational roots. The remainder has no
    /// rational root, so it is irreducible up to degree 3.
    ///
    /// # Errors
    /// [`Error::Unfactored`] if a part of degree 4 or more remains, which might still be reducible.
    pub(crate) fn factors(&self) -> Result<Factors> {
        let (content, primitive) = self.primitive();
        let mut factors = Vec::new();
        for (part, multiplicity) in primitive.square_free_parts() {
            factors.extend(part.split()?.into_iter().map(|factor| (factor, multiplicity)));
        }
        factors.sort();
        Ok(Factors { content, factors })
    }

    /// Pairs of a square-free primitive polynomial and the power in which it divides this one (Yun's algorithm).
    fn square_free_parts(&self) -> Vec<(Self, u32)> {
        let exact = |above: &Self, below: &Self| above.exact_quotient(below).unwrap_or_default();
        let slope = self.derivative();
        let common = self.gcd(&slope);
        let (mut product, mut rest) = (exact(self, &common), exact(&slope, &common));
        let mut parts = Vec::new();
        let mut multiplicity = 1;
        while product.degree() > 0 {
            rest = &rest - &product.derivative();
            let part = product.gcd(&rest);
            (product, rest) = (exact(&product, &part), exact(&rest, &part));
            if part.degree() > 0 {
                parts.push((part.primitive().1, multiplicity));
            }
            multiplicity += 1;
        }
        parts
    }

    /// The irreducible factors of a square-free primitive polynomial.
    fn split(&self) -> Result<Vec<Self>> {
        let mut rest = self.clone();
        let mut factors = Vec::new();
        for root in self.rational_roots()? {
            let factor = Polynomial::new(vec![-root, Rational::from(1)]).primitive().1;
            rest = rest.exact_quotient(&factor).unwrap_or(rest);
            factors.push(factor);
        }
        match rest.degree() {
            0 => Ok(factors),
            1..=3 => {
                factors.push(rest.primitive().1);
                Ok(factors)
            }
            _ => Err(Error::Unfactored(format!("a polynomial of degree {}", rest.degree()))),
        }
    }

    /// The rational roots of a square-free primitive polynomial: ± a divisor of the last over one of the first
    /// coefficient.
    fn rational_roots(&self) -> Result<Vec<Rational>> {
        let lowest = self.coefficients().iter().position(|c| !c.is_zero()).unwrap_or(0);
        let mut roots = if lowest > 0 { vec![Rational::new()] } else { Vec::new() };
        let coefficient = |c: &Rational| c.numer().clone().abs();
        let numerators = divisors(&coefficient(&self.coefficients()[lowest]))?;
        let denominators = divisors(&coefficient(&self.leading()))?;
        for numerator in &numerators {
            for denominator in &denominators {
                let candidate = Rational::from((numerator, denominator));
                for candidate in [-candidate.clone(), candidate] {
                    if self.evaluate(&candidate).is_zero() && !roots.contains(&candidate) {
                        roots.push(candidate);
                    }
                }
            }
        }
        roots.sort();
        Ok(roots)
    }
}

/// All divisors of a positive integer.
fn divisors(number: &Integer) -> Result<Vec<Integer>> {
    let mut divisors = vec![Integer::from(1)];
    for (prime, multiplicity) in prime_factors(number)? {
        let smaller = divisors.clone();
        let mut power = Integer::from(1);
        for _ in 0..multiplicity {
            power *= prime;
            divisors.extend(smaller.iter().map(|divisor| Integer::from(divisor * &power)));
        }
    }
    Ok(divisors)
}
