//! Derivatives and integrals.

use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::expression::Expression;
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

impl Expression {
    /// The derivative with respect to a symbol, by the chain rule for the symbols that are functions of it: g' = dg/da,
    /// g = dG/da, g² = dQ/da, the slopes of S and Δl of any medium, and sine and cosine of θ.
    ///
    /// # Errors
    /// [`Error::Transcendental`] if a derivative has no symbol, such as g''.
    pub fn derivative(&self, variable: Symbol) -> Result<Self> {
        let mut total = self.partial(variable)?;
        for symbol in Symbol::all() {
            let Some(slope) = symbol.slope_along(variable) else { continue };
            let partial = self.partial(symbol)?;
            if partial.is_zero() {
                continue;
            }
            let Some((sign, base, power)) = slope else {
                return Err(Error::Transcendental(format!("the derivative of {}", symbol.text())));
            };
            let power = RationalFunction::constant(power);
            let slope = Expression::symbol(base).power(&power, Domain::Positive)?;
            let slope = slope.scaled(&RationalFunction::constant(sign));
            total = &total + &partial.times(&slope)?;
        }
        Ok(total)
    }

    /// The derivative with all other symbols held fixed.
    fn partial(&self, variable: Symbol) -> Result<Self> {
        self.each_power(variable, |exponent| Ok((exponent.clone(), exponent - &RationalFunction::constant(1))))
    }

    /// ∫₀^X of the expression over `variable`, as an expression in which `variable` represents X.
    ///
    /// # Errors
    /// [`Error::Integral`] when a power of the variable is not known to be above −1 on the domain;
    /// [`Error::Transcendental`] when another symbol of the expression is a function of the variable.
    pub fn integral_from_zero(&self, variable: Symbol, domain: Domain) -> Result<Self> {
        if let Some(function) = self.function_of(variable) {
            let integral = format!("the integral of {} over {}", function.text(), variable.text());
            return Err(Error::Transcendental(integral));
        }
        self.each_power(variable, |exponent| {
            let next = exponent + &RationalFunction::constant(1);
            if next.sign_on(domain).is_some_and(|sign| sign.is_gt()) {
                return Ok((next.inverse()?, next));
            }
            let exponent = crate::print::function_text(exponent);
            Err(Error::Integral { symbol: variable.text(), exponent })
        })
    }

    /// Replaces variable^e by factor·variable^f in each term.
    fn each_power(
        &self,
        variable: Symbol,
        change: impl Fn(&RationalFunction) -> Result<(RationalFunction, RationalFunction)>,
    ) -> Result<Self> {
        let mut sum = Expression::zero();
        for (coefficient, monomial) in self.terms() {
            let (factor, exponent) = change(&monomial.exponent(variable))?;
            let rest = Expression::from_term((coefficient * &factor, monomial.without(variable)));
            if !rest.is_zero() {
                sum = &sum + &rest.times(&Expression::symbol(variable).power(&exponent, Domain::Positive)?)?;
            }
        }
        Ok(sum)
    }

    /// A symbol of the expression that is a function of `variable`.
    pub(crate) fn function_of(&self, variable: Symbol) -> Option<Symbol> {
        let occurs = |symbol: &Symbol| self.terms().any(|(_, monomial)| !monomial.exponent(*symbol).is_zero());
        Symbol::all().filter(|symbol| symbol.slope_along(variable).is_some()).find(occurs)
    }
}
