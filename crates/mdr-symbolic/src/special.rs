//! Special values of Γ, κ and the sine, and of all bases at a number n.

use rug::Rational;

use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::expression::Expression;
use crate::monomial::{Base, not_positive};
use crate::quotient::Quotient;
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

/// The most steps of Γ(z+1) = zΓ(z) that are expanded.
const LARGEST_SHIFT: u32 = 500;

/// Γ(z) for z = n/2 or (n+1)/2 plus an integer, by Γ(z+1) = zΓ(z); for multiples of 1/4 with the values of Γ(1) and
/// Γ(1/2), and Γ(1/4)Γ(3/4) = π√2.
pub(crate) fn gamma(argument: &RationalFunction, domain: Domain) -> Result<Expression> {
    let outside = || Error::Transcendental("this Γ".to_owned());
    let half_n = RationalFunction::n().divide(&RationalFunction::constant(2))?;
    let (base, start) = match argument.as_constant() {
        Some(value) => gamma_of_quarter(&(&value - value.clone().floor()), domain)?,
        None => {
            let offset = (argument - &half_n).as_constant().ok_or_else(outside)?;
            match (offset * 2u32).into_numer_denom() {
                (twice, unit) if unit == 1 && twice.is_even() => (Expression::symbol(Symbol::GAMMA_LOWER), half_n),
                (_, unit) if unit == 1 => {
                    (Expression::symbol(Symbol::GAMMA_UPPER), &half_n + &RationalFunction::ratio(1, 2))
                }
                _ => return Err(outside()),
            }
        }
    };
    let steps = (argument - &start).as_integer().and_then(|steps| steps.to_i32()).ok_or_else(outside)?;
    if steps.unsigned_abs() > LARGEST_SHIFT {
        return Err(Error::TooLarge(format!("Γ shifted by {steps}")));
    }
    let mut product = RationalFunction::constant(1);
    for step in steps.min(0)..steps.max(0) {
        let factor = &start + &RationalFunction::constant(step);
        product = if steps > 0 { &product * &factor } else { product.divide(&factor)? };
    }
    Ok(base.scaled(&product))
}

/// Γ of a fraction in [0, 1), with 1 instead of 0, and that argument.
fn gamma_of_quarter(fraction: &Rational, domain: Domain) -> Result<(Expression, RationalFunction)> {
    let three_quarters = Expression::symbol(Symbol::GAMMA_THREE_QUARTERS);
    let value = match (Rational::from(fraction * 4u32)).into_numer_denom() {
        (quarters, unit) if unit == 1 => quarters.to_u32(),
        _ => None,
    };
    let root = |value: &Expression| value.power(&RationalFunction::ratio(1, 2), domain);
    let gamma = match value {
        Some(0) => return Ok((Expression::integer(1), RationalFunction::constant(1))),
        Some(1) => {
            let above = Expression::pi().times(&root(&Expression::integer(2))?)?;
            above.times(&three_quarters.power(&RationalFunction::constant(-1), domain)?)?
        }
        Some(2) => root(&Expression::pi())?,
        Some(3) => three_quarters,
        _ => return Err(Error::Transcendental(format!("Γ({fraction})"))),
    };
    Ok((gamma, RationalFunction::constant(fraction.clone())))
}

/// κ_n = (√π/2) n Γ(n/2)/Γ((n+1)/2), the definition (1.12), for another n.
pub(crate) fn kappa(n: &RationalFunction, domain: Domain) -> Result<Expression> {
    let half = RationalFunction::ratio(1, 2);
    let half_n = n * &half;
    let below = gamma(&(&half_n + &half), domain)?.power(&RationalFunction::constant(-1), domain)?;
    let above = gamma(&half_n, domain)?.times(&Expression::pi().power(&half, domain)?)?;
    Ok(above.times(&below)?.scaled(&half_n))
}

impl Base {
    /// The base at an n of the domain on which it is positive, by the special values of Γ.
    pub(crate) fn at_n(&self, n: &Rational) -> Result<Expression> {
        let half = RationalFunction::ratio(1, 2);
        let half_n = RationalFunction::constant(n.clone() / 2u32);
        match self {
            Base::Prime(prime) => Ok(Expression::integer((*prime).into())),
            Base::Factor(polynomial) => {
                let value = RationalFunction::constant(polynomial.evaluate(n));
                let positive = value.sign_on(Domain::Positive).is_some_and(|sign| sign.is_gt());
                if positive { Ok(value.into()) } else { Err(not_positive(&value, Domain::Positive)) }
            }
            Base::Pi => Ok(Expression::pi()),
            Base::Symbol(Symbol::KAPPA) => kappa(&RationalFunction::constant(n.clone()), Domain::Positive),
            Base::Symbol(Symbol::GAMMA_LOWER) => gamma(&half_n, Domain::Positive),
            Base::Symbol(Symbol::GAMMA_UPPER) => gamma(&(&half_n + &half), Domain::Positive),
            Base::Symbol(symbol) => Ok(Expression::symbol(*symbol)),
        }
    }
}

/// sin z for multiples z of π/6 and π/4.
pub(crate) fn sine(argument: &Quotient, domain: Domain) -> Result<Quotient> {
    let outside = || Error::Transcendental("this sine".to_owned());
    let turns = argument.over(&Expression::pi().into())?.as_function().and_then(|function| function.as_constant());
    let turns = turns.ok_or_else(outside)? / 2u32;
    let turns = &turns - turns.clone().floor();
    // The second half of a turn repeats the first with the opposite sign, the second quarter the first one reversed.
    let half = Rational::from((1, 2));
    let (negative, turns) = if turns < half { (false, turns) } else { (true, turns - &half) };
    let turns = turns.clone().min(half - turns);
    // In twelfths of a quarter; 4, 6 and 8 are π/6, π/4 and π/3.
    let (twelfths, unit) = (turns * 48u32).into_numer_denom();
    let square = match twelfths.to_u32().filter(|_| unit == 1) {
        Some(0) => return Ok(Expression::zero().into()),
        Some(4) => (1, 4),
        Some(6) => (1, 2),
        Some(8) => (3, 4),
        Some(12) => (1, 1),
        _ => return Err(outside()),
    };
    let square = Expression::from(RationalFunction::constant(Rational::from(square)));
    let value = square.power(&RationalFunction::ratio(1, 2), domain)?;
    Ok(if negative { -&value } else { value }.into())
}
