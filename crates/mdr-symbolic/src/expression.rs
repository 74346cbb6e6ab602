//! Finite sums of terms, in normal form.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::{Add, Mul, Neg, Sub};

use rug::Rational;

use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::monomial::{Base, Monomial, Term};
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// The largest number of products of terms that is expanded.
const LARGEST_PRODUCT: usize = 1 << 14;
/// The largest exponent of a sum that is expanded.
const LARGEST_EXPONENT: u32 = 64;

/// A finite sum Σ c(n) Π base^e(n) in normal form: each monomial once, no coefficient 0. Equal functions are equal values.
///
/// ```
/// use mdr_symbolic::{Domain, Expression, RationalFunction};
/// let n = RationalFunction::n();
/// let four = Expression::integer(4).power(&n, Domain::Positive)?;
/// let two = Expression::integer(2).power(&(&n + &n), Domain::Positive)?;
/// assert_eq!(four, two); // 4ⁿ = 2²ⁿ
/// # Ok::<(), mdr_symbolic::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Expression(BTreeMap<Monomial, RationalFunction>);

impl Expression {
    /// 0.
    pub fn zero() -> Self {
        Self::default()
    }

    /// An integer.
    pub fn integer(value: i64) -> Self {
        RationalFunction::constant(value).into()
    }

    /// A symbol.
    pub fn symbol(symbol: Symbol) -> Self {
        Self::from_term((RationalFunction::constant(1), Monomial::of(Base::Symbol(symbol))))
    }

    /// π.
    pub fn pi() -> Self {
        Self::from_term((RationalFunction::constant(1), Monomial::of(Base::Pi)))
    }

    pub(crate) fn from_term((coefficient, monomial): Term) -> Self {
        let mut sum = Self::zero();
        sum.add_term(monomial, &coefficient);
        sum
    }

    pub(crate) fn add_term(&mut self, monomial: Monomial, coefficient: &RationalFunction) {
        let total = self.0.entry(monomial.clone()).or_insert_with(|| RationalFunction::constant(0));
        *total = total.add(coefficient);
        if total.is_zero() {
            self.0.remove(&monomial);
        }
    }

    /// The terms in a fixed order.
    pub fn terms(&self) -> impl Iterator<Item = (&RationalFunction, &Monomial)> {
        self.0.iter().map(|(monomial, coefficient)| (coefficient, monomial))
    }

    /// The number of terms.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Coefficient and monomial, if there is exactly one term.
    pub fn as_term(&self) -> Option<(&RationalFunction, &Monomial)> {
        let mut terms = self.terms();
        terms.next().filter(|_| terms.next().is_none())
    }

    /// The expression as an element of Q(n), if it is one.
    pub fn as_function(&self) -> Option<RationalFunction> {
        match self.as_term() {
            None => self.is_zero().then(|| RationalFunction::constant(0)),
            Some((coefficient, monomial)) => (*monomial == Monomial::one()).then(|| coefficient.clone()),
        }
    }

    /// The product.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for too many terms, or too large an exponent.
    pub fn times(&self, other: &Self) -> Result<Self> {
        if self.len().saturating_mul(other.len()) > LARGEST_PRODUCT {
            return Err(Error::TooLarge(format!("a product of {} and {} terms", self.len(), other.len())));
        }
        let mut product = Self::zero();
        for (left, above) in &self.0 {
            for (right, below) in &other.0 {
                let (split, monomial) = left.times(right)?;
                product.add_term(monomial, &(&(above * below) * &split));
            }
        }
        Ok(product)
    }

    /// The product with an element of Q(n).
    pub fn scaled(&self, factor: &RationalFunction) -> Self {
        let mut scaled = Self::zero();
        self.0.iter().for_each(|(monomial, coefficient)| scaled.add_term(monomial.clone(), &coefficient.mul(factor)));
        scaled
    }

    /// The power with an exponent in Q(n): of a sum for a natural exponent, of a single term for any. Real powers need a
    /// coefficient that is positive on the domain.
    ///
    /// # Errors
    /// [`Error::PowerOfSum`], [`Error::NotPositive`], [`Error::DivisionByZero`], [`Error::Unfactored`],
    /// [`Error::TooLarge`].
    pub fn power(&self, exponent: &RationalFunction, domain: Domain) -> Result<Self> {
        let whole = exponent.as_integer().and_then(|integer| integer.to_i32());
        if let (Some(natural), true) = (whole.and_then(|whole| u32::try_from(whole).ok()), self.len() != 1) {
            return match natural {
                0 => Ok(Self::integer(1)),
                _ if self.is_zero() => Ok(Self::zero()),
                1..=LARGEST_EXPONENT => (1..natural).try_fold(self.clone(), |product, _| product.times(self)),
                _ => Err(Error::TooLarge(format!("a power {natural} of {} terms", self.len()))),
            };
        }
        let Some((coefficient, monomial)) = self.as_term() else {
            if self.is_zero() {
                return Err(Error::DivisionByZero);
            }
            return Err(Error::PowerOfSum { exponent: crate::print::function_text(exponent) });
        };
        let (split, raised) = monomial.raised(exponent)?;
        let (factor, constants) = match whole {
            Some(whole) => (coefficient.power(whole)?, Monomial::one()),
            None => Monomial::power_of(coefficient, exponent, domain)?,
        };
        let (more, product) = raised.times(&constants)?;
        Ok(Self::from_term((&(&factor * &split) * &more, product)))
    }

    /// The expression at an n of the domain on which it was formed. κ_n and the Gamma functions are known where
    /// their arguments are multiples of 1/4.
    ///
    /// # Errors
    /// [`Error::OutsideDomain`], [`Error::DivisionByZero`] at a pole, [`Error::NotPositive`] where the expression was not
    /// formed on the domain, [`Error::Transcendental`].
    pub fn at_n(&self, n: &Rational, domain: Domain) -> Result<Self> {
        if !domain.contains(n) {
            return Err(Error::OutsideDomain { n: n.to_string(), domain: domain.text() });
        }
        let mut sum = Self::zero();
        for (coefficient, monomial) in self.terms() {
            let mut term = Self::from(RationalFunction::constant(coefficient.evaluate(n)?));
            for (base, exponent) in monomial.powers() {
                let exponent = RationalFunction::constant(exponent.evaluate(n)?);
                term = term.times(&base.at_n(n)?.power(&exponent, Domain::Positive)?)?;
            }
            sum = &sum + &term;
        }
        Ok(sum)
    }

    /// The sign on the whole domain, for all positive values of the symbols, if all coefficients have the same sign
    /// there: bases are positive.
    pub fn sign_on(&self, domain: Domain) -> Option<Ordering> {
        let mut signs = self.0.values().map(|coefficient| coefficient.sign_on(domain));
        let Some(first) = signs.next() else { return Some(Ordering::Equal) };
        let first = first?;
        signs.all(|sign| sign == Some(first)).then_some(first)
    }
}

impl From<RationalFunction> for Expression {
    fn from(function: RationalFunction) -> Self {
        Self::from_term((function, Monomial::one()))
    }
}

impl Add for &Expression {
    type Output = Expression;
    fn add(self, other: &Expression) -> Expression {
        let mut sum = self.clone();
        other.0.iter().for_each(|(monomial, coefficient)| sum.add_term(monomial.clone(), coefficient));
        sum
    }
}

impl Neg for &Expression {
    type Output = Expression;
    fn neg(self) -> Expression {
        Expression(self.0.iter().map(|(monomial, coefficient)| (monomial.clone(), -coefficient)).collect())
    }
}

impl Sub for &Expression {
    type Output = Expression;
    fn sub(self, other: &Expression) -> Expression {
        self + &-other
    }
}
