//! The critical state in f64.

use mdr_analytic::{State, double};
use mdr_core::contact::{self, Body, Control, Elasticity, Error, Material, Quantity, Ranged, Regime, Result};
use mdr_core::number::Literal;
use mdr_numeric::admissible::GapVerdict;

use super::{CriticalAnswer, PowerLaw, Threshold, out_of_doubles};
use crate::answer::record::Numbers;
use crate::answer::{Fold, Number, Value};
use crate::outputs::folds;
use crate::scene::Arithmetic;

pub(super) fn answer(law: &PowerLaw) -> Result<CriticalAnswer> {
    let n = in_range(Quantity::Exponent, &law.n)?;
    let c = in_range(Quantity::Coefficient, &law.c)?;
    let e_star = effective_modulus(law)?;
    let material = Material::new(e_star, in_range(Quantity::WorkOfAdhesion, &law.work_of_adhesion)?)?;
    let control = law
        .control
        .try_map(|stiffness| Error::require_positive(Quantity::Stiffness, in_range(Quantity::Stiffness, stiffness)?))?;
    let regime = match n {
        0.5 => Regime::ScaleFree,
        _ if n > 0.5 => Regime::PullOff,
        _ => Regime::CompleteContact,
    };
    let found = match control {
        Control::Machine { stiffness } => double::machine_folds(n, c, &material, stiffness),
        _ if regime == Regime::ScaleFree => Ok(Vec::new()),
        _ => double::critical(n, c, &material, &control).map(|critical| {
            let State { contact_radius, indentation, force } = critical;
            vec![contact::Fold { contact_radius, indentation, force, kind: folds::kind(regime) }]
        }),
    };
    let folds = match found {
        Err(error @ Error::Undecided { .. }) => in_digits(error, n, c, &material, &control)?,
        found => found?.into_iter().map(|fold| Fold::new(fold, GapVerdict::Admissible).resolve(ranged)).collect(),
    };
    let threshold = match regime {
        Regime::ScaleFree => {
            let [c, ratio] = [double::threshold(&material, &control)?, ratio(c, &material, &control)?].map(ranged);
            Some(Threshold { c, ratio })
        }
        _ => None,
    };
    let known = |value: f64| Value::Known(Number::F64(value));
    let inputs = law.inputs(|literal| known(literal.nearest_f64()), || known(e_star));
    let kappa = Number::F64(double::kappa(n)?);
    Ok(CriticalAnswer::new(law, Arithmetic::F64, regime, inputs, kappa, folds, threshold))
}

/// The folds in digits, for a state that takes more words than hardware arithmetic has, or exponents beyond its range.
#[cfg(feature = "mp")]
fn in_digits(_: Error, n: f64, c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Vec<Fold>> {
    /// Digits that fix the nearest double.
    const ENOUGH: u32 = 40;
    let literal = |value: &f64| {
        let exact = rug::Rational::from_f64(*value).as_ref().and_then(crate::scene::exactly);
        exact.ok_or_else(|| Error::domain(Quantity::Parameter("an input"), value, "a number"))
    };
    let law = PowerLaw {
        n: literal(&n)?,
        c: literal(&c)?,
        elasticity: Elasticity::Effective(literal(material.effective_modulus())?),
        work_of_adhesion: literal(material.work_of_adhesion())?,
        control: control.try_map(literal)?,
    };
    let answer = super::certified(&law, ENOUGH)?;
    let folds = answer.folds.unwrap_or_else(|| answer.state.into_iter().collect());
    Ok(folds.resolve(rounded))
}

/// Without certified digits it stays undecided.
#[cfg(not(feature = "mp"))]
fn in_digits(error: Error, _: f64, _: f64, _: &Material<f64>, _: &Control<f64>) -> Result<Vec<Fold>> {
    Err(error)
}

/// C over the threshold of (1.19): ρ, or a third of it under a dead load.
fn ratio(c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Ranged<f64>> {
    Ok(match (control, double::ratio(c, material)?) {
        (Control::Force, Ranged::Value(ratio)) => Ranged::Value(ratio / 3.0),
        (_, ratio) => ratio,
    })
}

/// The double nearest to an input.
fn in_range(quantity: Quantity, literal: &Literal) -> Result<f64> {
    representable(literal.nearest_f64()).ok_or_else(|| out_of_doubles(quantity, literal))
}

/// The double nearest to E*.
fn effective_modulus(law: &PowerLaw) -> Result<f64> {
    match &law.elasticity {
        Elasticity::Effective(e_star) => in_range(Quantity::EffectiveModulus, e_star),
        Elasticity::Bodies(bodies) => of_bodies(law, bodies),
    }
}

/// E* of two bodies, derived exactly.
#[cfg(feature = "mp")]
fn of_bodies(law: &PowerLaw, bodies: &[Body<Literal>; 2]) -> Result<f64> {
    use mdr_core::number::certify::Enclosure;
    let exact = law.question()?.effective_modulus().clone();
    let nearest = Enclosure::Exact(exact).round(40).map_or(f64::NAN, |decimal| decimal.to_f64());
    representable(nearest).ok_or_else(|| out_of_doubles(Quantity::YoungsModulus, &bodies[0].youngs_modulus))
}

#[cfg(not(feature = "mp"))]
fn of_bodies(_: &PowerLaw, bodies: &[Body<Literal>; 2]) -> Result<f64> {
    let body = |body: &Body<Literal>| {
        let modulus = in_range(Quantity::YoungsModulus, &body.youngs_modulus)?;
        Body::new(modulus, body.poissons_ratio.nearest_f64())
    };
    let material = Material::from_bodies(&body(&bodies[0])?, &body(&bodies[1])?, 1.0)?;
    Ok(*material.effective_modulus())
}

fn representable(value: f64) -> Option<f64> {
    (value.is_finite() && value != 0.0).then_some(value)
}

fn ranged(value: Ranged<f64>) -> Value {
    match value {
        Ranged::Value(value) => Value::Known(Number::F64(value)),
        Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => Value::out_of_range(log10),
    }
}

/// The double nearest to a decimal.
#[cfg(feature = "mp")]
fn rounded(number: Number) -> Value {
    match (representable(number.to_f64()), number) {
        (Some(value), _) => Value::Known(Number::F64(value)),
        (None, Number::Certified(decimal)) if !decimal.is_zero() => Value::out_of_range(decimal.log10_f64()),
        (None, _) => Value::Known(Number::F64(0.0)),
    }
}
