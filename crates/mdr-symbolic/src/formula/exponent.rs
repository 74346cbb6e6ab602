//! Formulas at one value of n.

use rug::Rational;

use super::{Formula, Variable};

impl Formula {
    /// The formula at a positive n: the number is substituted for n before anything else. κ_n and the other symbols
    /// stay symbols.
    pub(crate) fn at_exponent(&self, n: &Rational) -> Formula {
        let boxed = |formula: &Formula| Box::new(formula.at_exponent(n));
        let all = |parts: &[Formula]| parts.iter().map(|part| part.at_exponent(n)).collect::<Vec<_>>();
        match self {
            Formula::N => Formula::Number(n.clone()),
            Formula::Number(_) | Formula::Pi | Formula::Symbol(_) => self.clone(),
            Formula::Name(definition) => definition.formula().map_or_else(|_| self.clone(), |it| it.at_exponent(n)),
            Formula::Negative(inner) => Formula::Negative(boxed(inner)),
            Formula::Sum(terms) => Formula::Sum(all(terms)),
            Formula::Product(factors) => Formula::Product(all(factors)),
            Formula::Quotient(above, below) => Formula::Quotient(boxed(above), boxed(below)),
            Formula::Power(base, exponent) => Formula::Power(boxed(base), boxed(exponent)),
            Formula::Root(inner) => Formula::Root(boxed(inner)),
            Formula::Derivative(inner, along) => Formula::Derivative(boxed(inner), *along),
            Formula::Integral(inner, along, to) => Formula::Integral(boxed(inner), *along, boxed(to)),
            // n already has a value there.
            Formula::At(inner, Variable::N, value) => Formula::At(inner.clone(), Variable::N, boxed(value)),
            Formula::At(inner, variable, value) => Formula::At(boxed(inner), *variable, boxed(value)),
            Formula::Function(function, arguments) => Formula::Function(*function, all(arguments)),
            Formula::QuarterTurn(inner) => Formula::QuarterTurn(boxed(inner)),
        }
    }
}
