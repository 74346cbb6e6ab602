//! Formulas that divide by zero.

use super::Formula;
use crate::domain::Domain;
use crate::error::Error;

impl Formula {
    /// Whether a divisor of the formula, as written, has the normal form 0: the formula then has a value nowhere on the
    /// domain.
    pub(crate) fn divides_by_zero(&self, domain: Domain) -> bool {
        let by_zero = |formula: &Formula| formula.divides_by_zero(domain);
        let is_zero = |formula: &Formula| formula.normalise(domain).is_ok_and(|normal| normal.numerator().is_zero());
        match self {
            Formula::Number(_) | Formula::N | Formula::Pi | Formula::Symbol(_) => false,
            Formula::Negative(inner) | Formula::Root(inner) | Formula::QuarterTurn(inner) => by_zero(inner),
            Formula::Name(definition) => definition.formula().is_ok_and(|formula| by_zero(&formula)),
            Formula::Sum(parts) | Formula::Product(parts) | Formula::Function(_, parts) => parts.iter().any(by_zero),
            Formula::Quotient(above, below) => by_zero(above) || by_zero(below) || is_zero(below),
            Formula::Power(base, exponent) => {
                let negative = || exponent.integer(domain).is_some_and(|exponent| exponent < 0);
                by_zero(base) || by_zero(exponent) || negative() && is_zero(base)
            }
            // Expanded before it has a value.
            Formula::Derivative(..) | Formula::Integral(..) | Formula::At(..) => {
                matches!(self.normalise(domain), Err(Error::DivisionByZero))
            }
        }
    }
}
