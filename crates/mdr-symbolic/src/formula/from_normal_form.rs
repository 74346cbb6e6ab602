//! Conversion of normal forms to formulas, for printing.

use rug::Rational;

use super::Formula;
use crate::expression::Expression;
use crate::monomial::{Base, Monomial};
use crate::polynomial::Polynomial;
use crate::quotient::Quotient;
use crate::rational_function::RationalFunction;

impl From<&Polynomial> for Formula {
    fn from(polynomial: &Polynomial) -> Self {
        let power = |i: usize| match i {
            0 => None,
            1 => Some(Formula::N),
            i => Some(Formula::Power(Box::new(Formula::N), Box::new(Formula::Number(Rational::from(i))))),
        };
        let coefficients = polynomial.coefficients().iter().enumerate().rev().filter(|(_, c)| !c.is_zero());
        sum(coefficients.map(|(i, c)| scaled(c, power(i).into_iter().collect())).collect())
    }
}

impl From<&RationalFunction> for Formula {
    fn from(function: &RationalFunction) -> Self {
        of_term(function, &Monomial::one())
    }
}

impl From<&Expression> for Formula {
    fn from(expression: &Expression) -> Self {
        sum(expression.terms().map(|(coefficient, monomial)| of_term(coefficient, monomial)).collect())
    }
}

impl From<&Quotient> for Formula {
    fn from(quotient: &Quotient) -> Self {
        let above = quotient.numerator().into();
        match quotient.as_expression() {
            Some(_) => above,
            None => Formula::Quotient(Box::new(above), Box::new(quotient.denominator().into())),
        }
    }
}

/// A term as a fraction: negative exponents and the denominator of the coefficient are in the denominator.
fn of_term(coefficient: &RationalFunction, monomial: &Monomial) -> Formula {
    let (content_above, above) = factored(coefficient.numerator());
    let (content_below, below) = factored(coefficient.denominator());
    let content = content_above / content_below;
    let (mut above, mut below) = (above, below);
    for (base, exponent) in monomial.powers() {
        let base = match base {
            Base::Prime(prime) => Formula::Number(Rational::from(*prime)),
            Base::Factor(polynomial) => polynomial.into(),
            Base::Pi => Formula::Pi,
            Base::Symbol(symbol) => Formula::Symbol(*symbol),
        };
        if exponent.as_constant().is_some_and(|constant| constant < 0) {
            below.push(power(base, &-exponent));
        } else {
            above.push(power(base, exponent));
        }
    }
    if content.denom() != &1u32 {
        below.insert(0, Formula::Number(Rational::from(content.denom())));
    }
    let above = scaled(&Rational::from(content.numer()), above);
    if below.is_empty() {
        return above;
    }
    match above {
        Formula::Negative(above) => Formula::Negative(Box::new(Formula::Quotient(above, Box::new(product(below))))),
        above => Formula::Quotient(Box::new(above), Box::new(product(below))),
    }
}

/// The content and the factors of a polynomial; the whole primitive part if it could not be split.
fn factored(polynomial: &Polynomial) -> (Rational, Vec<Formula>) {
    match polynomial.factors() {
        Ok(split) => {
            let power = |(factor, multiplicity): &(Polynomial, u32)| {
                power(factor.into(), &RationalFunction::constant(*multiplicity))
            };
            (split.content.clone(), split.factors.iter().map(power).collect())
        }
        Err(_) => {
            let (content, part) = polynomial.primitive();
            (content, vec![Formula::from(&part)])
        }
    }
}

fn power(base: Formula, exponent: &RationalFunction) -> Formula {
    if exponent.is_one() { base } else { Formula::Power(Box::new(base), Box::new(exponent.into())) }
}

fn product(mut factors: Vec<Formula>) -> Formula {
    match factors.len() {
        0 => Formula::Number(Rational::from(1)),
        1 => factors.remove(0),
        _ => Formula::Product(factors),
    }
}

fn sum(mut terms: Vec<Formula>) -> Formula {
    match terms.len() {
        0 => Formula::Number(Rational::new()),
        1 => terms.remove(0),
        _ => Formula::Sum(terms),
    }
}

/// A number times factors; a factor 1 is omitted and the sign comes first.
fn scaled(number: &Rational, mut factors: Vec<Formula>) -> Formula {
    let size = number.clone().abs();
    if size != 1 || factors.is_empty() {
        factors.insert(0, fraction(&size));
    }
    let product = product(factors);
    if *number < 0 { Formula::Negative(Box::new(product)) } else { product }
}

fn fraction(value: &Rational) -> Formula {
    let whole = |integer: &rug::Integer| Box::new(Formula::Number(Rational::from(integer)));
    if value.is_integer() {
        Formula::Number(value.clone())
    } else {
        Formula::Quotient(whole(value.numer()), whole(value.denom()))
    }
}
