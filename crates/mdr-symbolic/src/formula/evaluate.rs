//! Evaluation in any arithmetic; the crate itself contains none.

use rug::Rational;

use super::{Formula, Function};
use crate::domain::Domain;
use crate::error::Result;
use crate::symbol::Symbol;

/// An arithmetic with a point: values for n and for every symbol. With rigorous intervals the result is an enclosure.
pub trait Evaluator {
    /// A number.
    type Value: Clone;

    /// An exact rational.
    fn rational(&self, value: &Rational) -> Self::Value;
    /// π.
    fn pi(&self) -> Self::Value;
    /// n.
    fn n(&self) -> Self::Value;
    /// The value of a symbol.
    fn symbol(&self, symbol: Symbol) -> Self::Value;
    /// left + right.
    fn add(&self, left: &Self::Value, right: &Self::Value) -> Self::Value;
    /// left · right.
    fn multiply(&self, left: &Self::Value, right: &Self::Value) -> Self::Value;
    /// left / right.
    fn divide(&self, left: &Self::Value, right: &Self::Value) -> Self::Value;
    /// base^exponent for an integer exponent.
    fn integer_power(&self, base: &Self::Value, exponent: i32) -> Self::Value;
    /// base^exponent for a positive base.
    fn power(&self, base: &Self::Value, exponent: &Self::Value) -> Self::Value;
    /// A function outside the algebra.
    fn function(&self, function: Function, arguments: &[Self::Value]) -> Self::Value;
    /// ∫₀^{π/2} integrand dθ.
    fn quarter_turn(&self, integrand: &Formula) -> Self::Value;

    /// The value of a derivative, an integral or a formula with a value substituted. By default the operation is first
    /// carried out exactly, by normal forms.
    ///
    /// # Errors
    /// Errors of [`Formula::normalise`].
    fn operation(&self, formula: &Formula, domain: Domain) -> Result<Self::Value>
    where
        Self: Sized,
    {
        evaluate(&Formula::from(&formula.normalise(domain)?), domain, self)
    }
}

/// The value of a formula, part by part as it is written.
///
/// # Errors
/// Errors of [`Evaluator::operation`].
pub fn evaluate<A: Evaluator>(formula: &Formula, domain: Domain, arithmetic: &A) -> Result<A::Value> {
    let of = |formula: &Formula| evaluate(formula, domain, arithmetic);
    let combine = |parts: &[Formula], start: i32, join: fn(&A, &A::Value, &A::Value) -> A::Value| {
        parts.iter().try_fold(arithmetic.rational(&Rational::from(start)), |total, part| {
            Ok(join(arithmetic, &total, &of(part)?))
        })
    };
    Ok(match formula {
        Formula::Number(value) => arithmetic.rational(value),
        Formula::N => arithmetic.n(),
        Formula::Pi => arithmetic.pi(),
        Formula::Symbol(symbol) => arithmetic.symbol(*symbol),
        Formula::Name(definition) => of(definition.formula()?)?,
        Formula::Negative(inner) => arithmetic.multiply(&arithmetic.rational(&Rational::from(-1)), &of(inner)?),
        Formula::Sum(terms) => combine(terms, 0, A::add)?,
        Formula::Product(factors) => combine(factors, 1, A::multiply)?,
        Formula::Quotient(above, below) => arithmetic.divide(&of(above)?, &of(below)?),
        Formula::Power(base, exponent) => match exponent.written_integer() {
            Some(exponent) => arithmetic.integer_power(&of(base)?, exponent),
            None => arithmetic.power(&of(base)?, &of(exponent)?),
        },
        Formula::Root(inner) => arithmetic.power(&of(inner)?, &arithmetic.rational(&Rational::from((1, 2)))),
        Formula::Derivative(..) | Formula::Integral(..) | Formula::At(..) => arithmetic.operation(formula, domain)?,
        Formula::Function(function, arguments) => {
            let arguments = arguments.iter().map(of).collect::<Result<Vec<_>>>()?;
            arithmetic.function(*function, &arguments)
        }
        Formula::QuarterTurn(integrand) => arithmetic.quarter_turn(integrand),
    })
}

impl Formula {
    /// The rational number that is written here, by the four operations alone.
    pub fn number(&self) -> Option<Rational> {
        let all = |parts: &[Formula]| parts.iter().map(Formula::number).collect::<Option<Vec<_>>>();
        match self {
            Formula::Number(value) => Some(value.clone()),
            Formula::Negative(inner) => Some(-inner.number()?),
            Formula::Sum(terms) => Some(all(terms)?.iter().sum()),
            Formula::Product(factors) => Some(all(factors)?.iter().product()),
            Formula::Quotient(above, below) => {
                below.number().filter(|below| !below.is_zero()).and_then(|below| Some(above.number()? / below))
            }
            _ => None,
        }
    }

    /// The integer that is written here.
    pub(crate) fn written_integer(&self) -> Option<i32> {
        self.number().filter(Rational::is_integer)?.numer().to_i32()
    }

    /// The integer value of an exponent, if it is an integer.
    pub(super) fn integer(&self, domain: Domain) -> Option<i32> {
        self.normalise(domain).ok()?.as_function()?.as_integer()?.to_i32()
    }
}
