//! Formulas as written: printing, normal forms, evaluation and mutation use one and the same tree.

mod definition;
mod divisor;
mod evaluate;
mod exponent;
mod from_normal_form;
mod mutate;
mod normalise;
mod parse;
mod substitution;

use rug::Rational;

use crate::symbol::Symbol;

pub use definition::Definition;
pub use evaluate::{Arithmetic, evaluate, evaluate_expression, evaluate_quotient};

/// A formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Formula {
    /// A nonnegative number.
    Number(Rational),
    /// n, the exponent of the profile.
    N,
    /// π.
    Pi,
    /// A symbol.
    Symbol(Symbol),
    /// A named formula.
    Name(Definition),
    /// The negative.
    Negative(Box<Formula>),
    /// A sum.
    Sum(Vec<Formula>),
    /// A product.
    Product(Vec<Formula>),
    /// A quotient.
    Quotient(Box<Formula>, Box<Formula>),
    /// Base and exponent.
    Power(Box<Formula>, Box<Formula>),
    /// A square root.
    Root(Box<Formula>),
    /// A derivative with respect to a symbol.
    Derivative(Box<Formula>, Symbol),
    /// ∫₀ over a symbol up to a bound.
    Integral(Box<Formula>, Symbol, Box<Formula>),
    /// A formula with a value substituted for a variable.
    At(Box<Formula>, Variable, Box<Formula>),
    /// A function outside the algebra, apart from some special values.
    Function(Function, Vec<Formula>),
    /// ∫₀^{π/2} of a formula in sinθ and cosθ over θ, improper where the formula is infinite at an end: for enclosures only.
    QuarterTurn(Box<Formula>),
}

/// A variable that can be replaced in a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// n.
    N,
    /// A symbol.
    Symbol(Symbol),
}

impl Formula {
    /// Whether the formula has a value without values for n or any symbol.
    pub fn is_number(&self) -> bool {
        let all = |parts: &[Formula]| parts.iter().all(Formula::is_number);
        match self {
            Formula::Number(_) | Formula::Pi => true,
            Formula::N | Formula::Symbol(_) | Formula::Derivative(..) | Formula::QuarterTurn(_) => false,
            Formula::Name(definition) => definition.formula().is_ok_and(|formula| formula.is_number()),
            Formula::Negative(inner) | Formula::Root(inner) => inner.is_number(),
            Formula::Sum(parts) | Formula::Product(parts) | Formula::Function(_, parts) => all(parts),
            Formula::Quotient(left, right) | Formula::Power(left, right) => left.is_number() && right.is_number(),
            Formula::Integral(..) | Formula::At(..) => false,
        }
    }
}

/// Functions beyond powers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// Euler's Γ: in normal form for n/2 plus a multiple of 1/2, and for multiples of 1/4.
    Gamma,
    /// κ of another exponent, which the algebra resolves into Γ.
    Kappa,
    /// The arithmetic-geometric mean of two numbers.
    Agm,
    /// The sine: in normal form for multiples of π/6 and π/4.
    Sine,
    /// The Struve function of order 0.
    StruveH0,
    /// ₂F₁(1, b; c; 1/2).
    Hypergeometric,
}

impl Function {
    /// The names of functions in a formula, with the number of their arguments.
    const NAMES: [(&'static str, Function, usize); 6] = [
        ("Γ", Function::Gamma, 1),
        ("kappa", Function::Kappa, 1),
        ("agm", Function::Agm, 2),
        ("sin", Function::Sine, 1),
        ("H0", Function::StruveH0, 1),
        ("f", Function::Hypergeometric, 2),
    ];
}
