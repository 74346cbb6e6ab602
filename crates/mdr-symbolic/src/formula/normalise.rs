//! Conversion of a formula to its normal form.

use rug::Rational;

use super::{Formula, Function, Variable};
use crate::domain::Domain;
use crate::error::{Error, Result};
use crate::expression::Expression;
use crate::quotient::Quotient;
use crate::rational_function::RationalFunction;
use crate::symbol::Symbol;

impl Formula {
    /// The normal form on a domain.
    ///
    /// A value substituted for a symbol must be positive on the domain, as is assumed of the symbol, unless only the
    /// four operations and integer powers act on the symbol. A value of n must lie in the domain. At neither may a divisor,
    /// as written, be 0. What belongs to the symbol, as g' does to g, must not occur beside it.
    ///
    /// # Errors
    /// [`Error::Substitution`], [`Error::OutsideDomain`], [`Error::DivisionByZero`] and [`Error::Related`] for such values,
    /// [`Error::Transcendental`] for functions outside the algebra, and the other limits of the algebra.
    pub fn normalise(&self, domain: Domain) -> Result<Quotient> {
        let of = |formula: &Formula| formula.normalise(domain);
        match self {
            Formula::Number(value) => Ok(constant(value.clone())),
            // On a domain of one point n is that number.
            Formula::N if domain.is_point() => Ok(constant(domain.sample())),
            Formula::N => Ok(Expression::from(RationalFunction::n()).into()),
            Formula::Pi => Ok(Expression::pi().into()),
            Formula::Symbol(symbol) => Ok(Expression::symbol(*symbol).into()),
            Formula::Name(definition) => of(&definition.formula()?),
            Formula::Negative(inner) => Ok(of(inner)?.negated()),
            Formula::Sum(terms) => terms.iter().try_fold(constant(Rational::new()), |sum, term| sum.plus(&of(term)?)),
            Formula::Product(factors) => {
                factors.iter().try_fold(constant(Rational::from(1)), |product, factor| product.times(&of(factor)?))
            }
            Formula::Quotient(above, below) => of(above)?.over(&of(below)?),
            Formula::Power(base, exponent) => {
                let value = of(exponent)?.as_function().ok_or_else(|| Error::Exponent(exponent.text()))?;
                of(base)?.power(&value, domain)
            }
            Formula::Root(inner) => of(inner)?.power(&RationalFunction::ratio(1, 2), domain),
            Formula::Derivative(inner, variable) => of(inner)?.derivative(*variable),
            Formula::Integral(inner, variable, upper) => {
                let integrand = of(inner)?;
                let integrand = integrand.as_expression().ok_or_else(|| Error::Transcendental(self.text()))?;
                let integral = Quotient::from(integrand.integral_from_zero(*variable, domain)?);
                integral.substitute(*variable, &inner.admitted(*variable, upper, domain)?, domain)
            }
            Formula::At(inner, Variable::Symbol(symbol), value) => {
                inner.refuse_relatives(*symbol, domain)?;
                let value = inner.admitted(*symbol, value, domain)?;
                let put_in = |normal: &Quotient| normal.substitute(*symbol, &value, domain);
                inner.refuse_poles(domain, put_in)?;
                put_in(&of(inner)?)
            }
            Formula::At(inner, Variable::N, value) => {
                let n = of(value)?.as_function().and_then(|function| function.as_constant());
                let n = n.ok_or_else(|| Error::Exponent(self.text()))?;
                // On a domain of one point it has already been substituted.
                let put_in = |normal: &Quotient| match domain.is_point() && domain.contains(&n) {
                    true => Ok(normal.clone()),
                    false => normal.at_n(&n, domain),
                };
                inner.refuse_poles(domain, put_in)?;
                put_in(&of(inner)?)
            }
            Formula::Function(Function::Gamma, arguments) => gamma(&of(&arguments[0])?, domain),
            Formula::Function(Function::Kappa, arguments) => kappa(&of(&arguments[0])?, domain),
            Formula::Function(Function::Sine, arguments) => sine(&of(&arguments[0])?, domain),
            Formula::Function(..) | Formula::QuarterTurn(_) => Err(Error::Transcendental(self.text())),
        }
    }
}

/// The most steps of Γ(z+1) = zΓ(z) that are expanded.
const LARGEST_SHIFT: u32 = 200;

fn constant(value: Rational) -> Quotient {
    Expression::from(RationalFunction::constant(value)).into()
}

/// Γ(z) for z = n/2 or (n+1)/2 plus an integer, by Γ(z+1) = zΓ(z); for multiples of 1/4 with the values of Γ(1) and
/// Γ(1/2), and Γ(1/4)Γ(3/4) = π√2.
fn gamma(argument: &Quotient, domain: Domain) -> Result<Quotient> {
    let outside = || Error::Transcendental("this Γ".to_owned());
    let argument = argument.as_function().ok_or_else(outside)?;
    let half_n = RationalFunction::n().divide(&RationalFunction::constant(2))?;
    let (base, start) = match argument.as_constant() {
        Some(value) => gamma_of_quarter(&(&value - value.clone().floor()), domain)?,
        None => {
            let offset = (&argument - &half_n).as_constant().ok_or_else(outside)?;
            match (offset * 2u32).into_numer_denom() {
                (twice, unit) if unit == 1 && twice.is_even() => (Expression::symbol(Symbol::GAMMA_LOWER), half_n),
                (_, unit) if unit == 1 => {
                    (Expression::symbol(Symbol::GAMMA_UPPER), &half_n + &RationalFunction::ratio(1, 2))
                }
                _ => return Err(outside()),
            }
        }
    };
    let steps = (&argument - &start).as_integer().and_then(|steps| steps.to_i32()).ok_or_else(outside)?;
    if steps.unsigned_abs() > LARGEST_SHIFT {
        return Err(Error::TooLarge(format!("Γ shifted by {steps}")));
    }
    let mut product = RationalFunction::constant(1);
    for step in steps.min(0)..steps.max(0) {
        let factor = &start + &RationalFunction::constant(step);
        product = if steps > 0 { &product * &factor } else { product.divide(&factor)? };
    }
    Ok(base.scaled(&product).into())
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
fn kappa(n: &Quotient, domain: Domain) -> Result<Quotient> {
    let half = constant(Rational::from((1, 2)));
    let upper = gamma(&n.times(&half)?.plus(&half)?, domain)?;
    let lower = gamma(&n.times(&half)?, domain)?;
    let root = Quotient::from(Expression::pi()).power(&RationalFunction::ratio(1, 2), domain)?;
    half.times(&root)?.times(n)?.times(&lower)?.over(&upper)
}

/// sin z for multiples z of π/6 and π/4.
fn sine(argument: &Quotient, domain: Domain) -> Result<Quotient> {
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
        Some(0) => return Ok(constant(Rational::new())),
        Some(4) => (1, 4),
        Some(6) => (1, 2),
        Some(8) => (3, 4),
        Some(12) => (1, 1),
        _ => return Err(outside()),
    };
    let value = constant(Rational::from(square)).power(&RationalFunction::ratio(1, 2), domain)?;
    Ok(if negative { value.negated() } else { value })
}
