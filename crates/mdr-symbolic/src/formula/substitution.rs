//! The values that may be substituted for a symbol.
//!
//! Normal forms assume that every symbol is positive: √(a²) is a. That is an identity for positive values of a. A value
//! of any sign may be substituted only if no such rule was used, which is certain if only the four operations and
//! integer powers act on the symbol.

use super::{Formula, Variable};
use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::quotient::Quotient;
use crate::symbol::Symbol;

impl Formula {
    /// The normal form of a value, if it may be substituted for a symbol of this formula.
    ///
    /// # Errors
    /// [`Error::Substitution`]; as [`Formula::normalise`].
    pub(super) fn admitted(&self, symbol: Symbol, value: &Formula, domain: Domain) -> Result<Quotient> {
        let normal = value.normalise(domain)?;
        let positive = || normal.sign_on(domain).is_some_and(|sign| sign.is_gt());
        if self.is_rational_in(symbol, domain) || positive() {
            return Ok(normal);
        }
        Err(Error::Substitution { symbol: symbol.text(), value: value.text(), domain: domain.text() })
    }

    /// Refuses to replace or vary a symbol while one of its `relatives` occurs, as g' and ∫g are of g: a value for one of
    /// them would leave the others those of another function. Both the formula as written and its normal form are searched,
    /// as only the latter has the derivatives.
    ///
    /// # Errors
    /// [`Error::Related`]; errors of [`Formula::normalise`].
    pub(super) fn refuse_relatives(
        &self,
        symbol: Symbol,
        relatives: impl Iterator<Item = Symbol>,
        domain: Domain,
    ) -> Result<()> {
        let mut relatives = relatives.peekable();
        if relatives.peek().is_none() {
            return Ok(());
        }
        let normal = Formula::from(&self.normalise(domain)?);
        match relatives.find(|relative| self.contains(*relative) || normal.contains(*relative)) {
            Some(relative) => Err(Error::Related { symbol: symbol.text(), relative: relative.text() }),
            None => Ok(()),
        }
    }

    /// Whether only the four operations and integer powers act on a symbol.
    fn is_rational_in(&self, symbol: Symbol, domain: Domain) -> bool {
        let rational = |formula: &Formula| formula.is_rational_in(symbol, domain);
        // A value substituted for a variable of the inner formula.
        let composed = |inner: &Formula, variable: Symbol, value: &Formula| {
            (variable == symbol || rational(inner))
                && (!value.contains(symbol) || rational(value) && inner.is_rational_in(variable, domain))
        };
        match self {
            Formula::Name(definition) => definition.formula().is_ok_and(rational),
            Formula::Negative(inner) | Formula::Derivative(inner, _) => rational(inner),
            Formula::Sum(parts) | Formula::Product(parts) => parts.iter().all(rational),
            Formula::Quotient(above, below) => rational(above) && rational(below),
            Formula::Power(base, exponent) => {
                !self.contains(symbol) || rational(base) && exponent.integer(domain).is_some()
            }
            Formula::Integral(inner, variable, upper) => composed(inner, *variable, upper),
            Formula::At(inner, Variable::Symbol(variable), value) => composed(inner, *variable, value),
            Formula::At(inner, Variable::N, _) => rational(inner),
            _ => *self == Formula::Symbol(symbol) || !self.contains(symbol),
        }
    }

    /// Whether the value of this formula may depend on a symbol.
    fn contains(&self, symbol: Symbol) -> bool {
        match self {
            Formula::Symbol(other) => *other == symbol,
            Formula::At(inner, Variable::N, _) => inner.contains(symbol),
            Formula::Integral(inner, variable, value) | Formula::At(inner, Variable::Symbol(variable), value) => {
                *variable != symbol && inner.contains(symbol) || value.contains(symbol)
            }
            other => other.parts().into_iter().any(|part| part.contains(symbol)),
        }
    }
}
