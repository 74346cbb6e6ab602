//! Formulas in TeX, in the subset that GitHub renders.

use super::{Strength, number, of, sum};
use crate::formula::{Formula, Function};
use crate::symbol::Symbol;

impl Formula {
    /// The formula in TeX, without the dollars.
    pub fn tex(&self) -> String {
        match self {
            Formula::Number(value) => tex_number(&number(value)),
            Formula::N => "n".to_owned(),
            Formula::Pi => r"\pi".to_owned(),
            Formula::Symbol(symbol) => symbol.tex().to_owned(),
            Formula::Name(definition) => definition.tex().to_owned(),
            Formula::Negative(inner) => format!("-{}", within(inner, Strength::Product)),
            Formula::Sum(terms) => sum(terms, "-", within),
            Formula::Product(factors) => product(factors),
            Formula::Quotient(above, below) => format!(r"\frac{{{}}}{{{}}}", above.tex(), below.tex()),
            Formula::Power(base, exponent) => power(base, exponent),
            Formula::Root(inner) => format!(r"\sqrt{{{}}}", inner.tex()),
            Formula::Derivative(inner, variable) => derivative(inner, variable.tex()),
            Formula::Integral(inner, variable, upper) => {
                let integrand = within(inner, Strength::Product);
                format!(r"\int_0^{{{}}} {integrand} \, d{}", upper.tex(), variable.tex())
            }
            Formula::At(inner, variable, value) => {
                at(inner, format!("{} = {}", of(*variable, Symbol::tex), small(value)))
            }
            Formula::Function(Function::Hypergeometric, arguments) => {
                let [b, c] = [&arguments[0], &arguments[1]].map(Formula::tex);
                format!("{{}}_2F_1{}", round(&format!(r"1, {b}; {c}; \tfrac12")))
            }
            Formula::Function(Function::Kappa, arguments) => format!(r"\kappa_{{{}}}", small(&arguments[0])),
            Formula::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(Formula::tex).collect();
                format!("{}{}", function.spelling().tex, round(&arguments.join(", ")))
            }
            Formula::QuarterTurn(inner) => {
                format!(r"\int_0^{{\pi/2}} {} \, d\theta", within(inner, Strength::Product))
            }
        }
    }

    fn tex_strength(&self) -> Strength {
        match self {
            Formula::Sum(_) | Formula::Negative(_) => Strength::Sum,
            Formula::Product(_) | Formula::Integral(..) | Formula::QuarterTurn(_) => Strength::Product,
            Formula::Derivative(..) => Strength::Product,
            // A fraction needs no brackets in a product, but does under an exponent.
            Formula::Quotient(..) | Formula::Power(..) | Formula::Function(..) | Formula::At(..) => Strength::Power,
            Formula::Symbol(symbol) if decorated(*symbol) => Strength::Power,
            Formula::Name(definition) if definition.tex().ends_with(')') => Strength::Power,
            _ => Strength::Atom,
        }
    }
}

/// Whether the operand of a derivative needs no brackets: a name, or a derivative of one.
fn is_named(formula: &Formula) -> bool {
    match formula {
        Formula::Name(_) | Formula::Symbol(_) => true,
        Formula::Derivative(inner, _) => is_named(inner),
        _ => false,
    }
}

/// Whether a derivative is a partial one.
fn is_of_two_variables(formula: &Formula) -> bool {
    match formula {
        Formula::Name(definition) => definition.tex().contains(','),
        Formula::Derivative(inner, _) => is_of_two_variables(inner),
        _ => false,
    }
}

/// Symbols that already carry a superscript, or arguments.
fn decorated(symbol: Symbol) -> bool {
    symbol.tex().contains(['^', '\'', '(']) || symbol.tex().starts_with(r"\sin") || symbol.tex().starts_with(r"\cos")
}

fn within(formula: &Formula, needed: Strength) -> String {
    if formula.tex_strength() < needed { round(&formula.tex()) } else { formula.tex() }
}

fn tex_number(text: &str) -> String {
    match text.split_once('/') {
        Some((above, below)) => format!(r"\frac{{{above}}}{{{below}}}"),
        None => text.to_owned(),
    }
}

/// Factors side by side, with a dot before a digit.
fn product(factors: &[Formula]) -> String {
    let mut tex = String::new();
    for (i, factor) in factors.iter().enumerate() {
        // Everything to the right of an operator belongs to it, so it needs no brackets at the end only.
        let open = matches!(factor, Formula::Integral(..) | Formula::QuarterTurn(_) | Formula::Derivative(..));
        let part = if open && i + 1 == factors.len() { factor.tex() } else { within(factor, Strength::Power) };
        if !tex.is_empty() {
            tex += if part.starts_with(|c: char| c.is_ascii_digit()) { r" \cdot " } else { " " };
        }
        tex += &part;
    }
    tex
}

fn power(base: &Formula, exponent: &Formula) -> String {
    format!("{}^{{{}}}", within(base, Strength::Atom), small(exponent))
}

/// An exponent or index: a fraction of two flat parts is easier to read on one line.
fn small(formula: &Formula) -> String {
    match formula {
        Formula::Negative(inner) if matches!(**inner, Formula::Quotient(..)) => format!("-{}", small(inner)),
        Formula::Quotient(above, below) => {
            let line = format!("{}/{}", within(above, Strength::Product), within(below, Strength::Atom));
            if is_tall(&line) { formula.tex() } else { line }
        }
        formula => formula.tex(),
    }
}

/// Whether a formula is higher than a line, so that its brackets have to grow.
fn is_tall(tex: &str) -> bool {
    [r"\frac", r"\int", r"\sqrt", r"\left"].iter().any(|part| tex.contains(part))
}

/// In round brackets. Those that need not grow do not: browsers set a gap on both sides of brackets that may.
fn round(tex: &str) -> String {
    if is_tall(tex) { format!(r"\left({tex}\right)") } else { format!("({tex})") }
}

/// In square brackets.
pub(crate) fn square(tex: &str) -> String {
    if is_tall(tex) { format!(r"\left[{tex}\right]") } else { format!("[{tex}]") }
}

/// A derivative, repeated ones as one.
fn derivative(inner: &Formula, variable: &str) -> String {
    let (mut inner, mut order) = (inner, 1);
    while let Formula::Derivative(deeper, again) = inner
        && again.tex() == variable
    {
        (inner, order) = (deeper, order + 1);
    }
    let d = if is_of_two_variables(inner) { r"\partial" } else { "d" };
    let blank = if d == "d" { "" } else { " " };
    let power = if order == 1 { String::new() } else { format!("^{order}") };
    let inner = if is_named(inner) { inner.tex() } else { within(inner, Strength::Atom) };
    format!(r"\frac{{{d}{power}}}{{{d}{blank}{variable}{power}}} \, {inner}")
}

/// A formula at a value, and at those that were put in before.
fn at(inner: &Formula, value: String) -> String {
    match inner {
        Formula::At(deeper, variable, first) => {
            at(deeper, format!(r"{} = {},\; {value}", of(*variable, Symbol::tex), small(first)))
        }
        inner => format!("{}_{{{value}}}", square(&inner.tex())),
    }
}
