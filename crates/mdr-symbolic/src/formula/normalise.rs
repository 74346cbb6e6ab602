//! Conversion of a formula to its normal form.

use rug::Rational;

use super::{Formula, Function, Variable};
use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::expression::Expression;
use crate::quotient::Quotient;
use crate::rational_function::RationalFunction;
use crate::special::{gamma, kappa, sine};

impl Formula {
    /// The normal form on a domain.
    ///
    /// A value substituted for a symbol must be positive on the domain, as is assumed of the symbol, unless only the
    /// four operations and integer powers act on the symbol. A value of n must lie in the domain. At neither may a divisor,
    /// as written, be 0, nor a base whose exponent is not certainly positive, nor Γ have a pole. What belongs to the symbol,
    /// as g' does to g, must not occur beside it, where a value is put in and where the symbol is the variable of a
    /// derivative or of an integral.
    ///
    /// # Errors
    /// [`Error::Substitution`], [`Error::OutsideDomain`], [`Error::DivisionByZero`], [`Error::Divisor`] and
    /// [`Error::Related`] for such values, [`Error::Transcendental`] for functions outside the algebra, and the other limits of the algebra.
    pub fn normalise(&self, domain: Domain) -> Result<Quotient> {
        let of = |formula: &Formula| formula.normalise(domain);
        match self {
            Formula::Number(value) => Ok(constant(value.clone())),
            // On a domain of one point n is that number.
            Formula::N if domain.is_point() => Ok(constant(domain.sample())),
            Formula::N => Ok(Expression::from(RationalFunction::n()).into()),
            Formula::Pi => Ok(Expression::pi().into()),
            Formula::Symbol(symbol) => Ok(Expression::symbol(*symbol).into()),
            Formula::Name(definition) => of(definition.formula()?),
            Formula::Negative(inner) => Ok(of(inner)?.negated()),
            Formula::Sum(terms) => terms.iter().try_fold(constant(Rational::new()), |sum, term| sum.plus(&of(term)?)),
            Formula::Product(factors) => {
                factors.iter().try_fold(constant(Rational::from(1)), |product, factor| product.times(&of(factor)?))
            }
            Formula::Quotient(above, below) => of(above)?.over(&of(below)?),
            Formula::Power(base, exponent) => {
                let value = of(exponent)?.as_function().ok_or_else(|| Error::Exponent(exponent.text()))?;
                of(base)?.power(&value, domain)
            }
            Formula::Root(inner) => of(inner)?.power(&RationalFunction::ratio(1, 2), domain),
            Formula::Derivative(inner, variable) => {
                // What the chain rule knows is no obstacle.
                let other = variable.relatives().filter(|relative| relative.slope_along(*variable).is_none());
                inner.refuse_relatives(*variable, other, domain)?;
                of(inner)?.derivative(*variable)
            }
            Formula::Integral(inner, variable, upper) => {
                inner.refuse_relatives(*variable, variable.relatives(), domain)?;
                let integrand = of(inner)?;
                let integrand = integrand.as_expression().ok_or_else(|| Error::Transcendental(self.text()))?;
                let integral = Quotient::from(integrand.integral_from_zero(*variable, domain)?);
                integral.substitute(*variable, &inner.admitted(*variable, upper, domain)?, domain)
            }
            Formula::At(inner, Variable::Symbol(symbol), value) => {
                inner.refuse_relatives(*symbol, symbol.relatives(), domain)?;
                let admitted = inner.admitted(*symbol, value, domain)?;
                let put_in = |normal: &Quotient| normal.substitute(*symbol, &admitted, domain);
                inner.refuse_poles(domain, &[vec![*symbol], value.symbols()].concat(), put_in)?;
                put_in(&of(inner)?)
            }
            Formula::At(inner, Variable::N, value) => {
                let n = of(value)?.as_function().and_then(|function| function.as_constant());
                let n = n.ok_or_else(|| Error::Exponent(self.text()))?;
                // On a domain of one point it has already been substituted.
                let put_in = |normal: &Quotient| match domain.is_point() && domain.contains(&n) {
                    true => Ok(normal.clone()),
                    false => normal.at_n(&n, domain),
                };
                inner.refuse_poles(domain, &value.symbols(), put_in)?;
                put_in(&of(inner)?)
            }
            Formula::Function(function @ (Function::Gamma | Function::Kappa), arguments) => {
                let argument = of(&arguments[0])?.as_function();
                let argument = argument.ok_or_else(|| Error::Transcendental("this Γ".to_owned()))?;
                let value = if *function == Function::Gamma { gamma } else { kappa };
                Ok(value(&argument, domain)?.into())
            }
            Formula::Function(Function::Sine, arguments) => sine(&of(&arguments[0])?, domain),
            Formula::Function(..) | Formula::QuarterTurn(_) => Err(Error::Transcendental(self.text())),
        }
    }
}

fn constant(value: Rational) -> Quotient {
    Expression::from(RationalFunction::constant(value)).into()
}
