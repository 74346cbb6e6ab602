//! The answer in f64.

use mdr_analytic::certified::{Answer as Certified, Elasticity as ExactElasticity, Question};
use mdr_analytic::double;
use mdr_core::contact::{Control, Error, Instability, Material, Quantity, Ranged, Regime, Status};
use mdr_core::number::Literal;
use mdr_core::number::certify::{Decimal, Enclosure};
use rug::Rational;

use super::answer::{Answer, Entry, Fold, State, Threshold};
use super::ask::{SCHEMA, question};
use super::{Checked, ControlKind};
use crate::error::{Failure, Result};
use crate::number::Number;
use crate::scene::exactly;

/// Digits that fix the nearest double.
const ENOUGH_DIGITS: u32 = 40;

pub(super) fn answer(checked: &Checked) -> Result<Answer> {
    let n = in_range("--n", &checked.n)?;
    let c = in_range("--c", &checked.c)?;
    let e_star = effective_modulus(checked)?;
    let material = Material::new(e_star, in_range("--work", &checked.work)?)?;
    let control = match (checked.control, &checked.stiffness) {
        (ControlKind::Force, _) => Control::Force,
        (ControlKind::Machine, Some(stiffness)) => Control::machine(in_range("--stiffness", stiffness)?)?,
        _ => Control::Indentation,
    };
    let regime = match n {
        0.5 => Regime::ScaleFree,
        _ if n > 0.5 => Regime::PullOff,
        _ => Regime::CompleteContact,
    };
    // What takes more words than hardware arithmetic has, or exponents beyond theirs, takes digits.
    let in_digits = || -> Result<Certified> {
        let literal = |value: f64| {
            let exact = Rational::from_f64(value).as_ref().and_then(exactly);
            exact.ok_or_else(|| Error::domain(Quantity::Parameter("an input"), &value, "a number"))
        };
        let control = match control {
            Control::Indentation => Control::Indentation,
            Control::Force => Control::Force,
            Control::Machine { stiffness } => Control::Machine { stiffness: literal(stiffness)? },
        };
        let elasticity = ExactElasticity::Effective(literal(e_star)?);
        let work = literal(*material.work_of_adhesion())?;
        Ok(Question::new(&literal(n)?, &literal(c)?, &elasticity, &work, &control)?.answer(ENOUGH_DIGITS)?)
    };
    let folds: Option<Vec<_>> = match control {
        Control::Machine { stiffness } => Some(match double::machine_folds(n, c, &material, stiffness) {
            Err(Error::Undecided { .. }) => in_digits()?.folds.into_iter().map(rounded_fold).collect(),
            folds => folds?.into_iter().map(fold).collect(),
        }),
        _ => None,
    };
    let state = match &folds {
        Some(folds) => {
            let first = if regime == Regime::PullOff { folds.last() } else { folds.first() };
            first.map_or_else(State::absent, |fold| fold.state.clone())
        }
        None if regime == Regime::ScaleFree => State::absent(),
        None => match double::critical(n, c, &material, &control) {
            Err(Error::Undecided { .. }) => in_digits()?.critical.map_or_else(State::absent, |critical| {
                State::new([critical.contact_radius, critical.indentation, critical.force].map(rounded))
            }),
            critical => {
                let critical = critical?;
                State::new([critical.contact_radius, critical.indentation, critical.force].map(entry))
            }
        },
    };
    let threshold = match regime {
        Regime::ScaleFree => {
            Threshold::new(entry(double::threshold(&material, &control)?), entry(ratio(c, &material, &control)?))
        }
        _ => Threshold::absent(),
    };
    Ok(Answer {
        schema: SCHEMA,
        arithmetic: "f64",
        digits: None,
        control: checked.control.name(),
        regime,
        inputs: checked.inputs(|literal| Number::Double(literal.nearest_f64()), || Number::Double(e_star)),
        kappa: Number::Double(double::kappa(n)?),
        status: if state.status() == Status::Ok { threshold.status() } else { state.status() },
        state,
        threshold,
        folds,
    })
}

/// C over the threshold of (1.19): ρ, or a third of it under a dead load.
fn ratio(c: f64, material: &Material<f64>, control: &Control<f64>) -> Result<Ranged<f64>> {
    Ok(match (control, double::ratio(c, material)?) {
        (Control::Force, Ranged::Value(ratio)) => Ranged::Value(ratio / 3.0),
        (_, ratio) => ratio,
    })
}

/// The double nearest to an input.
fn in_range(flag: &'static str, literal: &Literal) -> Result<f64> {
    representable(literal.nearest_f64())
        .ok_or_else(|| Failure::flag(flag, "out of the range of f64 (leave out --f64)", &literal.to_string()))
}

/// The double nearest to E*, derived exactly when two bodies are given.
fn effective_modulus(checked: &Checked) -> Result<f64> {
    if let super::Elasticity::Effective(e_star) = &checked.elasticity {
        return in_range("--e-star", e_star);
    }
    let exact = question(checked)?.effective_modulus().clone();
    let nearest = Enclosure::Exact(exact).round(ENOUGH_DIGITS).map_or(f64::NAN, |decimal| decimal.to_f64());
    representable(nearest).ok_or_else(|| {
        let why = "with the other constants of the two bodies, E* is out of the range of f64 (leave out --f64)";
        Failure::flag("--e1", why, &checked.elasticity.first_modulus())
    })
}

fn representable(value: f64) -> Option<f64> {
    (value.is_finite() && value != 0.0).then_some(value)
}

fn entry(value: Ranged<f64>) -> Entry {
    match value {
        Ranged::Value(value) => Entry::Value(Number::Double(value)),
        Ranged::Overflow { log10 } => Entry::Beyond { status: Status::Overflow, log10 },
        Ranged::Underflow { log10 } => Entry::Beyond { status: Status::Underflow, log10 },
    }
}

/// The double nearest to a decimal.
fn rounded(decimal: Decimal) -> Entry {
    let (value, log10) = (decimal.to_f64(), decimal.log10_f64());
    entry(match representable(value) {
        None if decimal.is_zero() => Ranged::Value(0.0),
        None if log10 > 0.0 => Ranged::Overflow { log10 },
        None => Ranged::Underflow { log10 },
        Some(value) => Ranged::Value(value),
    })
}

fn rounded_fold(fold: Instability<Decimal>) -> Fold {
    let state = State::new([fold.contact_radius, fold.indentation, fold.force].map(rounded));
    Fold { status: state.status(), state, kind: fold.kind }
}

fn fold(fold: Instability<Ranged<f64>>) -> Fold {
    let state = State::new([fold.contact_radius, fold.indentation, fold.force].map(entry));
    Fold { status: state.status(), state, kind: fold.kind }
}
