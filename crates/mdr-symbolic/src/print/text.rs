//! Formulas as a line of text.

use super::{Strength, number, of, sum};
use crate::formula::{Formula, Function};
use crate::symbol::Symbol;

impl Formula {
    /// The formula as one line of text.
    pub fn text(&self) -> String {
        match self {
            Formula::Number(value) => number(value),
            Formula::N => "n".to_owned(),
            Formula::Pi => "π".to_owned(),
            Formula::Symbol(symbol) => symbol.text().to_owned(),
            Formula::Name(definition) => definition.text().to_owned(),
            Formula::Negative(inner) => format!("−{}", within(inner, Strength::Product)),
            Formula::Sum(terms) => sum(terms, "−", within),
            Formula::Product(factors) => product(factors),
            Formula::Quotient(above, below) => {
                format!("{}/{}", within(above, Strength::Product), within(below, Strength::Power))
            }
            Formula::Power(base, exponent) => format!("{}{}", within(base, Strength::Atom), raised(exponent)),
            Formula::Root(inner) => format!("√{}", within(inner, Strength::Atom)),
            Formula::Derivative(inner, variable) => format!("d/d{} {}", variable.text(), within(inner, Strength::Atom)),
            Formula::Integral(inner, variable, upper) => {
                let upper = within(upper, Strength::Atom);
                format!("∫₀^{upper} {} d{}", within(inner, Strength::Product), variable.text())
            }
            Formula::At(inner, variable, value) => {
                format!("[{}]({} = {})", inner.text(), of(*variable, Symbol::text), value.text())
            }
            Formula::Function(Function::Hypergeometric, arguments) => {
                format!("₂F₁(1, {}; {}; 1/2)", arguments[0].text(), arguments[1].text())
            }
            Formula::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(Formula::text).collect();
                format!("{}({})", function.spelling().text, arguments.join(", "))
            }
            Formula::QuarterTurn(inner) => format!("∫₀^(π/2) {} dθ", within(inner, Strength::Product)),
        }
    }

    fn strength(&self) -> Strength {
        match self {
            Formula::Sum(_) | Formula::Negative(_) => Strength::Sum,
            Formula::Number(value) if number(value).contains('/') => Strength::Product,
            Formula::Product(_) | Formula::Quotient(..) | Formula::Integral(..) | Formula::QuarterTurn(_) => {
                Strength::Product
            }
            Formula::Derivative(..) => Strength::Product,
            Formula::Power(..) | Formula::Root(_) => Strength::Power,
            _ => Strength::Atom,
        }
    }
}

fn within(formula: &Formula, needed: Strength) -> String {
    if formula.strength() < needed { format!("({})", formula.text()) } else { formula.text() }
}

/// A leading fraction needs no brackets: a/b·c is (a/b)·c.
fn product(factors: &[Formula]) -> String {
    let needed = |i: usize| if i == 0 { Strength::Product } else { Strength::Power };
    factors.iter().enumerate().map(|(i, factor)| within(factor, needed(i))).collect::<Vec<_>>().join("·")
}

/// An exponent, as a superscript if it is a short natural number.
fn raised(exponent: &Formula) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match exponent {
        Formula::N => "ⁿ".to_owned(),
        Formula::Number(value) if value.is_integer() && *value < 10 => {
            value.numer().to_usize().and_then(|digit| DIGITS.get(digit)).map(char::to_string).unwrap_or_default()
        }
        other => format!("^{}", within(other, Strength::Atom)),
    }
}
