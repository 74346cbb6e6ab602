//! Formulas at one value of n, and formulas in which all abbreviations are written out.

use rug::Rational;

use super::{Definition, Formula, Function, Variable};

impl Formula {
    /// The immediate parts, in the order in which they are written; of a name the formula that it abbreviates.
    pub(crate) fn parts(&self) -> Vec<&Formula> {
        match self {
            Formula::N | Formula::Number(_) | Formula::Pi | Formula::Symbol(_) => Vec::new(),
            Formula::Name(definition) => definition.formula().into_iter().collect(),
            Formula::Negative(inner) | Formula::Root(inner) | Formula::QuarterTurn(inner) => vec![inner],
            Formula::Derivative(inner, _) => vec![inner],
            Formula::Sum(parts) | Formula::Product(parts) | Formula::Function(_, parts) => parts.iter().collect(),
            Formula::Quotient(left, right) | Formula::Power(left, right) => vec![left, right],
            Formula::Integral(inner, _, value) | Formula::At(inner, _, value) => vec![inner, value],
        }
    }

    /// The formula with each of its immediate parts replaced, one after the other.
    pub(super) fn rebuilt(&self, mut part: impl FnMut(&Formula) -> Formula) -> Formula {
        let mut boxed = |formula: &Formula| Box::new(part(formula));
        match self {
            Formula::N | Formula::Number(_) | Formula::Pi | Formula::Symbol(_) | Formula::Name(_) => self.clone(),
            Formula::Negative(inner) => Formula::Negative(boxed(inner)),
            Formula::Sum(terms) => Formula::Sum(terms.iter().map(part).collect()),
            Formula::Product(factors) => Formula::Product(factors.iter().map(part).collect()),
            Formula::Quotient(above, below) => Formula::Quotient(boxed(above), boxed(below)),
            Formula::Power(base, exponent) => Formula::Power(boxed(base), boxed(exponent)),
            Formula::Root(inner) => Formula::Root(boxed(inner)),
            Formula::Derivative(inner, along) => Formula::Derivative(boxed(inner), *along),
            Formula::Integral(inner, along, to) => Formula::Integral(boxed(inner), *along, boxed(to)),
            Formula::At(inner, variable, value) => Formula::At(boxed(inner), *variable, boxed(value)),
            Formula::Function(function, arguments) => {
                Formula::Function(*function, arguments.iter().map(part).collect())
            }
            Formula::QuarterTurn(inner) => Formula::QuarterTurn(boxed(inner)),
        }
    }

    /// The formula at a positive n: the number is substituted for n before anything else. κ_n and the other symbols
    /// stay symbols.
    pub(crate) fn at_exponent(&self, n: &Rational) -> Formula {
        match self {
            Formula::N => Formula::Number(n.clone()),
            Formula::Name(definition) => definition.formula().map_or_else(|_| self.clone(), |it| it.at_exponent(n)),
            // n already has a value there.
            Formula::At(inner, Variable::N, value) => {
                Formula::At(inner.clone(), Variable::N, Box::new(value.at_exponent(n)))
            }
            other => other.rebuilt(|part| part.at_exponent(n)),
        }
    }

    /// The formula with its names replaced by their definitions, including κ of a number, and values put in where nothing has
    /// to be calculated.
    pub(crate) fn unfolded(&self) -> Formula {
        let inner = |definition: Definition| definition.formula().map_or_else(|_| self.clone(), |it| it.unfolded());
        match (self, Definition::named("κ_Γ")) {
            (Formula::Name(definition), _) => inner(*definition),
            (Formula::Function(Function::Kappa, n), Some(kappa)) => inner(kappa).with(Variable::N, &n[0].unfolded()),
            (Formula::At(formula, variable, value), _) => formula.unfolded().with(*variable, &value.unfolded()),
            (other, _) => other.rebuilt(Formula::unfolded),
        }
    }

    /// The formula with a value in the place of a variable; below a derivative or an integral it stays to be substituted.
    fn with(&self, variable: Variable, value: &Formula) -> Formula {
        match (self, variable) {
            (Formula::N, Variable::N) => value.clone(),
            (Formula::Symbol(symbol), Variable::Symbol(other)) if *symbol == other => value.clone(),
            (Formula::Derivative(..) | Formula::Integral(..) | Formula::At(..) | Formula::QuarterTurn(_), _) => {
                Formula::At(Box::new(self.clone()), variable, Box::new(value.clone()))
            }
            (other, _) => other.rebuilt(|part| part.with(variable, value)),
        }
    }
}
