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
pub use evaluate::{Evaluator, evaluate};

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
        match self {
            Formula::N | Formula::Symbol(_) | Formula::Derivative(..) | Formula::QuarterTurn(_) => false,
            Formula::Integral(..) | Formula::At(..) => false,
            other => other.parts().into_iter().all(Formula::is_number),
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

/// How a function is written.
pub(crate) struct Spelling {
    /// In a formula that is parsed.
    parsed: &'static str,
    /// In a line of text.
    pub(crate) text: &'static str,
    /// In TeX.
    pub(crate) tex: &'static str,
    /// In Coq.
    pub(crate) coq: &'static str,
    /// How many arguments it has.
    arity: usize,
}

impl Function {
    const ALL: [Function; 6] =
        [Function::Gamma, Function::Kappa, Function::Agm, Function::Sine, Function::StruveH0, Function::Hypergeometric];

    pub(crate) fn spelling(self) -> Spelling {
        let (parsed, text, tex, coq, arity) = match self {
            Function::Gamma => ("Γ", "Γ", r"\Gamma", "Gamma", 1),
            Function::Kappa => ("kappa", "κ", r"\kappa", "Definitions.kappa", 1),
            Function::Agm => ("agm", "agm", r"\operatorname{agm}", "Agm.agm", 2),
            Function::Sine => ("sin", "sin", r"\sin", "sin", 1),
            Function::StruveH0 => ("H0", "H₀", r"\mathbf{H}_0", "Profiles.struve", 1),
            Function::Hypergeometric => ("f", "f", "f", "KappaSeries.f", 2),
        };
        Spelling { parsed, text, tex, coq, arity }
    }
}
