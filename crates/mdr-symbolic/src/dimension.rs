//! Dimensions: powers of length and force, which may depend on n.

use std::ops::{Add, Mul};

use crate::expression::Expression;
use crate::formula::Formula;
use crate::monomial::Base;
use crate::polynomial::Polynomial;
use crate::quotient::Quotient;
use crate::rational_function::RationalFunction;

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

    /// This dimension multiplied by a power of another one.
    fn with_power(&self, other: &Self, exponent: &RationalFunction) -> Self {
        Dimension {
            length: self.length.add(&other.length.mul(exponent)),
            force: self.force.add(&other.force.mul(exponent)),
        }
    }
}

impl Dimension {
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

impl Expression {
    /// The dimension of every term; `None` when the terms differ, or there is none.
    pub fn dimension(&self) -> Option<Dimension> {
        let mut dimensions = self.terms().map(|(_, monomial)| {
            monomial.powers().fold(Dimension::new(0, 0, 0), |total, (base, exponent)| match base {
                Base::Symbol(symbol) => total.with_power(&symbol.dimension(), exponent),
                _ => total,
            })
        });
        let first = dimensions.next()?;
        dimensions.all(|other| other == first).then_some(first)
    }
}

impl Quotient {
    /// The dimension; `None` when the terms of the numerator or of the denominator differ in theirs.
    pub fn dimension(&self) -> Option<Dimension> {
        let below = self.denominator().dimension()?;
        Some(self.numerator().dimension()?.with_power(&below, &RationalFunction::constant(-1)))
    }
}
