//! Products of positive bases raised to exponents in Q(n).

use std::collections::BTreeMap;
use std::ops::Add;

use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::polynomial::{Factors, Polynomial, prime_factors};
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// The base of a power. Each is positive on the domain.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Base {
    /// A prime number.
    Prime(u32),
    /// An irreducible polynomial in n, with the sign that makes it positive on the domain.
    Factor(Polynomial),
    /// π.
    Pi,
    /// A symbol.
    Symbol(Symbol),
}

/// A product of powers. The exponents of primes and polynomials have a constant part in [0, 1); their integer powers
/// belong to the coefficient.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(BTreeMap<Base, RationalFunction>);

/// A coefficient and a monomial.
pub(crate) type Term = (RationalFunction, Monomial);

impl Monomial {
    /// The empty product.
    pub fn one() -> Self {
        Self::default()
    }

    /// The first power of π or of a symbol; these belong to no coefficient.
    pub(crate) fn of(base: Base) -> Self {
        Monomial(BTreeMap::from([(base, RationalFunction::constant(1))]))
    }

    /// Bases and exponents, in a fixed order.
    pub fn powers(&self) -> impl Iterator<Item = (&Base, &RationalFunction)> {
        self.0.iter()
    }

    /// The exponent of a symbol.
    pub fn exponent(&self, symbol: Symbol) -> RationalFunction {
        self.0.get(&Base::Symbol(symbol)).cloned().unwrap_or_else(|| RationalFunction::constant(0))
    }

    /// The monomial without a symbol.
    pub(crate) fn without(&self, symbol: Symbol) -> Self {
        let mut rest = self.clone();
        rest.0.remove(&Base::Symbol(symbol));
        rest
    }

    /// The product, with the coefficient that splits off.
    pub(crate) fn times(&self, other: &Self) -> Result<Term> {
        let mut powers = self.0.clone();
        for (base, exponent) in &other.0 {
            add_power(&mut powers, base.clone(), exponent);
        }
        split_off_integers(powers)
    }

    /// All exponents times an element of Q(n).
    pub(crate) fn raised(&self, exponent: &RationalFunction) -> Result<Term> {
        split_off_integers(self.0.iter().map(|(base, power)| (base.clone(), power * exponent)).collect())
    }

    /// A positive element of Q(n) raised to an exponent in Q(n).
    ///
    /// # Errors
    /// [`Error::NotPositive`] when it is not known to be positive on the domain, [`Error::Unfactored`].
    pub(crate) fn power_of(value: &RationalFunction, exponent: &RationalFunction, domain: Domain) -> Result<Term> {
        if value.is_zero() {
            return Err(not_positive(value, domain));
        }
        let mut powers = BTreeMap::new();
        let mut positive = true;
        for (polynomial, sense) in [(value.numerator(), 1), (value.denominator(), -1)] {
            let Factors { content, factors } = polynomial.factors()?;
            positive ^= content < 0;
            let along = |multiplicity: u32| exponent * &RationalFunction::constant(sense * i64::from(multiplicity));
            for (number, side) in [(content.numer(), 1), (content.denom(), -1)] {
                for (prime, multiplicity) in prime_factors(&number.clone().abs())? {
                    let power = along(multiplicity);
                    add_power(&mut powers, Base::Prime(prime), &if side < 0 { -&power } else { power });
                }
            }
            for (factor, multiplicity) in factors {
                let sign = factor.sign_on(domain).filter(|sign| sign.is_ne());
                let sign = sign.ok_or_else(|| not_positive(value, domain))?;
                positive ^= sign.is_lt() && multiplicity % 2 == 1;
                let factor = if sign.is_lt() { -&factor } else { factor };
                add_power(&mut powers, Base::Factor(factor), &along(multiplicity));
            }
        }
        if positive { split_off_integers(powers) } else { Err(not_positive(value, domain)) }
    }
}

pub(crate) fn not_positive(value: &RationalFunction, domain: Domain) -> Error {
    Error::NotPositive { base: crate::print::function_text(value), domain: domain.text() }
}

fn add_power(powers: &mut BTreeMap<Base, RationalFunction>, base: Base, exponent: &RationalFunction) {
    let total = powers.entry(base).or_insert_with(|| RationalFunction::constant(0));
    *total = total.add(exponent);
}

/// The normal form of a product of powers: no exponent 0, and integer powers of primes and polynomials split off.
fn split_off_integers(powers: BTreeMap<Base, RationalFunction>) -> Result<Term> {
    let mut coefficient = RationalFunction::constant(1);
    let mut rest = BTreeMap::new();
    for (base, exponent) in powers {
        let value = match &base {
            Base::Prime(prime) => Some(RationalFunction::constant(*prime)),
            Base::Factor(polynomial) => Some(polynomial.clone().into()),
            Base::Pi | Base::Symbol(_) => None,
        };
        let exponent = match value {
            Some(value) => {
                let whole = exponent.constant_part().floor();
                let power = whole.numer().to_i32().ok_or_else(|| Error::TooLarge(format!("a power {whole}")))?;
                coefficient = &coefficient * &value.power(power)?;
                &exponent - &RationalFunction::constant(whole)
            }
            None => exponent,
        };
        if !exponent.is_zero() {
            rest.insert(base, exponent);
        }
    }
    Ok((coefficient, Monomial(rest)))
}
