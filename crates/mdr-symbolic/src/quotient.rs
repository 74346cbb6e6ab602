//! Quotients of sums.

use std::cmp::Ordering;

use rug::Rational;

use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::expression::Expression;
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// A quotient of two expressions, compared by cross-multiplication. A denominator of one term is divided out.
///
/// The expressions are analytic functions on a connected domain, so their ring has no divisors of zero and
/// P/Q = S/T exactly when PT = SQ.
#[derive(Clone, Debug)]
pub struct Quotient {
    numerator: Expression,
    denominator: Expression,
}

impl Quotient {
    /// The quotient of two expressions.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub fn new(numerator: Expression, denominator: Expression) -> Result<Self> {
        if denominator.is_zero() {
            return Err(Error::DivisionByZero);
        }
        if denominator.len() > 1 || denominator == Expression::integer(1) {
            return Ok(Quotient { numerator, denominator });
        }
        // An integer power needs no sign.
        let inverse = denominator.power(&RationalFunction::constant(-1), Domain::Positive)?;
        Ok(numerator.times(&inverse)?.into())
    }

    /// The numerator.
    pub fn numerator(&self) -> &Expression {
        &self.numerator
    }

    /// The denominator: 1, or a sum of several terms.
    pub fn denominator(&self) -> &Expression {
        &self.denominator
    }

    /// The quotient as an expression, if it has no denominator.
    pub fn as_expression(&self) -> Option<&Expression> {
        (self.denominator == Expression::integer(1)).then_some(&self.numerator)
    }

    /// The quotient as an element of Q(n), if it is one.
    pub fn as_function(&self) -> Option<RationalFunction> {
        self.as_expression().and_then(Expression::as_function)
    }

    /// The sum.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for too many terms, or too large an exponent.
    pub fn plus(&self, other: &Self) -> Result<Self> {
        if self.denominator == other.denominator {
            return Quotient::new(&self.numerator + &other.numerator, self.denominator.clone());
        }
        let numerator = &self.numerator.times(&other.denominator)? + &other.numerator.times(&self.denominator)?;
        Quotient::new(numerator, self.denominator.times(&other.denominator)?)
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        Quotient { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }

    /// The difference.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for too many terms, or too large an exponent.
    pub fn minus(&self, other: &Self) -> Result<Self> {
        self.plus(&other.negated())
    }

    /// The product.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for too many terms, or too large an exponent.
    pub fn times(&self, other: &Self) -> Result<Self> {
        let numerator = self.numerator.times(&other.numerator)?;
        Quotient::new(numerator, self.denominator.times(&other.denominator)?)
    }

    /// This divided by another quotient.
    ///
    /// # Errors
    /// [`Error::DivisionByZero`].
    pub fn over(&self, other: &Self) -> Result<Self> {
        self.times(&Quotient::new(other.denominator.clone(), other.numerator.clone())?)
    }

    /// The power with an exponent in Q(n).
    ///
    /// # Errors
    /// Errors of [`Expression::power`] for the numerator or the denominator.
    pub fn power(&self, exponent: &RationalFunction, domain: Domain) -> Result<Self> {
        let negative = exponent.as_integer().is_some_and(|integer| integer < 0);
        if negative {
            let one = Quotient::from(Expression::integer(1));
            return one.over(self)?.power(&-exponent, domain);
        }
        Quotient::new(self.numerator.power(exponent, domain)?, self.denominator.power(exponent, domain)?)
    }

    /// The derivative with respect to a symbol.
    ///
    /// # Errors
    /// Errors of [`Expression::derivative`] for the numerator or the denominator; [`Error::TooLarge`].
    pub fn derivative(&self, variable: Symbol) -> Result<Self> {
        let rising = self.numerator.derivative(variable)?.times(&self.denominator)?;
        let falling = self.numerator.times(&self.denominator.derivative(variable)?)?;
        Quotient::new(&rising - &falling, self.denominator.times(&self.denominator)?)
    }

    /// This, as its current sums of powers, with `value` substituted for a symbol. Whether the value may have any sign in a
    /// formula from which the sums were simplified is decided by [`crate::Formula::normalise`].
    ///
    /// # Errors
    /// Errors of [`Expression::power`] for powers of `value`; [`Error::Transcendental`] when another symbol here is a function of
    /// the replaced one.
    pub fn substitute(&self, symbol: Symbol, value: &Quotient, domain: Domain) -> Result<Self> {
        let above = self.numerator.substitute(symbol, value, domain)?;
        above.over(&self.denominator.substitute(symbol, value, domain)?)
    }

    /// This at an n of the domain on which it was formed.
    ///
    /// # Errors
    /// Errors of [`Expression::at_n`] for the numerator or the denominator.
    pub fn at_n(&self, n: &Rational, domain: Domain) -> Result<Self> {
        Quotient::new(self.numerator.at_n(n, domain)?, self.denominator.at_n(n, domain)?)
    }

    /// Whether the two are the same function; always decided.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for too many terms, or too large an exponent.
    pub fn equals(&self, other: &Self) -> Result<bool> {
        Ok(self.numerator.times(&other.denominator)? == other.numerator.times(&self.denominator)?)
    }

    /// The sign on the whole domain, if the signs of the coefficients decide it.
    pub fn sign_on(&self, domain: Domain) -> Option<Ordering> {
        let below = self.denominator.sign_on(domain).filter(|sign| sign.is_ne())?;
        let above = self.numerator.sign_on(domain)?;
        Some(if below.is_lt() { above.reverse() } else { above })
    }
}

impl Expression {
    /// The expression with a quotient substituted for a symbol.
    fn substitute(&self, symbol: Symbol, value: &Quotient, domain: Domain) -> Result<Quotient> {
        if let Some(function) = self.function_of(symbol) {
            return Err(Error::Transcendental(format!("{} elsewhere", function.text())));
        }
        let mut sum = Quotient::from(Expression::zero());
        for (coefficient, monomial) in self.terms() {
            let rest = Expression::from_term((coefficient.clone(), monomial.without(symbol)));
            let power = value.power(&monomial.exponent(symbol), domain)?;
            sum = sum.plus(&Quotient::from(rest).times(&power)?)?;
        }
        Ok(sum)
    }
}

impl From<Expression> for Quotient {
    fn from(numerator: Expression) -> Self {
        Quotient { numerator, denominator: Expression::integer(1) }
    }
}
