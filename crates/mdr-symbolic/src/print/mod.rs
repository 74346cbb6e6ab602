//! Output of formulas: as text, and in TeX for Markdown and LaTeX.

mod coq;
mod tex;
mod text;

pub(crate) use tex::square;

use rug::Rational;

use crate::formula::{Formula, Variable};
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// An element of Q(n) as text.
pub(crate) fn function_text(function: &RationalFunction) -> String {
    Formula::from(function).text()
}

/// The binding strength of a formula: one weaker than its surroundings needs brackets.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Strength {
    Sum,
    Product,
    Power,
    Atom,
}

/// A number as a decimal if it terminates, else as a fraction.
fn number(value: &Rational) -> String {
    let (mut scaled, mut places) = (value.clone(), 0usize);
    while !scaled.is_integer() && places < 30 {
        scaled *= 10u32;
        places += 1;
    }
    if places == 0 || !scaled.is_integer() {
        return value.to_string();
    }
    let digits = format!("{:0>width$}", scaled.numer().to_string(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    format!("{whole}.{fraction}")
}

/// Terms behind their signs, which the first has only where it is a minus.
fn sum(terms: &[Formula], minus: &str, within: fn(&Formula, Strength) -> String) -> String {
    let signed = |(i, term): (usize, &Formula)| {
        let (sign, part) = match term {
            Formula::Negative(inner) => (minus, &**inner),
            term => (if i == 0 { "" } else { "+" }, term),
        };
        let blank = if i == 0 { "" } else { " " };
        format!("{blank}{sign}{blank}{}", within(part, Strength::Product))
    };
    terms.iter().enumerate().map(signed).collect()
}

/// The name of a variable.
fn of(variable: Variable, symbol: fn(Symbol) -> &'static str) -> &'static str {
    match variable {
        Variable::N => "n",
        Variable::Symbol(variable) => symbol(variable),
    }
}
