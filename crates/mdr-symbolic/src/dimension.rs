//! Dimensions: powers of length and force, which may depend on n.

use rug::Rational;

use crate::domain::Domain;
use crate::formula::{Formula, Variable};
use crate::polynomial::Polynomial;
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// Powers of metre and newton.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dimension {
    /// The power of length.
    pub length: RationalFunction,
    /// The power of force.
    pub force: RationalFunction,
}

impl Dimension {
    pub(crate) fn new(length: i64, length_slope: i64, force: i64) -> Self {
        Dimension { length: Polynomial::linear(length_slope, length).into(), force: RationalFunction::constant(force) }
    }

    /// That of a number.
    fn none() -> Self {
        Self::new(0, 0, 0)
    }

    /// This dimension multiplied by a power of another one.
    fn with_power(&self, other: &Self, exponent: &RationalFunction) -> Self {
        Dimension {
            length: &self.length + &(&other.length * exponent),
            force: &self.force + &(&other.force * exponent),
        }
    }

    fn times(&self, other: &Self) -> Self {
        self.with_power(other, &RationalFunction::constant(1))
    }

    fn over(&self, other: &Self) -> Self {
        self.with_power(other, &RationalFunction::constant(-1))
    }

    /// At one n; `None` where a power has a pole.
    fn at(&self, n: &Rational) -> Option<Self> {
        let at = |power: &RationalFunction| power.evaluate(n).ok().map(RationalFunction::constant);
        Some(Dimension { length: at(&self.length)?, force: at(&self.force)? })
    }

    /// As powers of m and N.
    pub(crate) fn text(&self) -> String {
        self.powers("·", |unit, power| format!("{unit}^({})", power.text()))
    }

    /// As powers of m and N, in TeX.
    pub(crate) fn tex(&self) -> String {
        self.powers(" ", |unit, power| format!(r"\mathrm{{{unit}}}^{{{}}}", power.tex()))
    }

    fn powers(&self, joint: &str, write: impl Fn(&str, &Formula) -> String) -> String {
        let powers = [("m", &self.length), ("N", &self.force)];
        let shown = powers.into_iter().filter(|(_, power)| !power.is_zero());
        let parts: Vec<_> = shown.map(|(unit, power)| write(unit, &Formula::from(power))).collect();
        if parts.is_empty() { "1".to_owned() } else { parts.join(joint) }
    }
}

impl Formula {
    /// The dimension of the formula as it is written, also where a part of it cancels: x + a² − a² has none. `None` when
    /// the terms of a sum differ in theirs, or an exponent or the argument of a function is no pure number.
    pub fn dimension(&self, domain: Domain) -> Option<Dimension> {
        let dimension = Units { domain, values: &[] }.of(self)?;
        if domain.is_point() { dimension.at(&domain.sample()) } else { Some(dimension) }
    }
}

/// The dimensions of the values that stand for symbols, the innermost last.
#[derive(Clone, Copy)]
struct Units<'a> {
    domain: Domain,
    values: &'a [(Symbol, Dimension)],
}

impl Units<'_> {
    fn of(&self, formula: &Formula) -> Option<Dimension> {
        match formula {
            Formula::Number(_) | Formula::N | Formula::Pi => Some(Dimension::none()),
            Formula::Symbol(symbol) => Some(self.symbol(*symbol)),
            Formula::Name(definition) => self.of(definition.formula().ok()?),
            Formula::Negative(inner) | Formula::QuarterTurn(inner) => self.of(inner),
            Formula::Sum(terms) => {
                let mut terms = terms.iter().map(|term| self.of(term));
                let first = terms.next()??;
                terms.all(|other| other.as_ref() == Some(&first)).then_some(first)
            }
            Formula::Product(factors) => {
                factors.iter().try_fold(Dimension::none(), |product, factor| Some(product.times(&self.of(factor)?)))
            }
            Formula::Quotient(above, below) => Some(self.of(above)?.over(&self.of(below)?)),
            Formula::Root(inner) => {
                Some(Dimension::none().with_power(&self.of(inner)?, &RationalFunction::ratio(1, 2)))
            }
            Formula::Power(base, exponent) => self.power(base, exponent),
            Formula::Derivative(inner, variable) => Some(self.of(inner)?.over(&self.symbol(*variable))),
            Formula::Integral(inner, variable, upper) => {
                let upper = self.of(upper)?;
                Some(self.with(*variable, upper.clone(), inner)?.times(&upper))
            }
            Formula::At(inner, Variable::Symbol(symbol), value) => self.with(*symbol, self.of(value)?, inner),
            Formula::At(inner, Variable::N, value) => {
                self.of(inner)?.at(&value.normalise(self.domain).ok()?.as_function()?.as_constant()?)
            }
            Formula::Function(_, arguments) => {
                arguments.iter().all(|argument| self.is_number(argument)).then(Dimension::none)
            }
        }
    }

    fn symbol(&self, symbol: Symbol) -> Dimension {
        let value = self.values.iter().rev().find(|(other, _)| *other == symbol);
        value.map_or_else(|| symbol.dimension(), |(_, dimension)| dimension.clone())
    }

    /// The dimension of a formula in which a symbol has another one.
    fn with(&self, symbol: Symbol, dimension: Dimension, formula: &Formula) -> Option<Dimension> {
        let values: Vec<_> = self.values.iter().cloned().chain([(symbol, dimension)]).collect();
        Units { values: &values, ..*self }.of(formula)
    }

    fn is_number(&self, formula: &Formula) -> bool {
        self.of(formula) == Some(Dimension::none())
    }

    fn power(&self, base: &Formula, exponent: &Formula) -> Option<Dimension> {
        let base = self.of(base)?;
        if !self.is_number(exponent) || base == Dimension::none() {
            return self.is_number(exponent).then_some(base);
        }
        Some(Dimension::none().with_power(&base, &exponent.normalise(self.domain).ok()?.as_function()?))
    }
}
