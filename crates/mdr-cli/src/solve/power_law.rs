//! The folds of power laws, by their own closed forms: all of them, on all radii.

use mdr_analytic::certified::{Elasticity, Question};
use mdr_core::contact::{Control, FoldKind, Instability, Regime, Result};
use mdr_core::number::Literal;
use mdr_core::number::certify::{Decimal, Enclosure};
use rug::Rational;

use super::answer::{Complete, Output, Promise};
use super::outputs;
use super::record::{Field, Record};
use crate::number::Number;
use crate::scene::{HeldBy, Scene, Shape, Slope, Want, exactly};

/// Enough to count folds, and to see an exact zero.
const DIGITS: u32 = 10;

/// Correctly rounded folds, where the profile is a power law with rational constants.
///
/// # Errors
/// As [`Question::answer`].
pub(super) fn folds(scene: &Scene, digits: u32) -> Result<Option<Output>> {
    let Some((exponent, coefficient)) = power_law(&scene.profile) else { return Ok(None) };
    let answer = question(scene, &exponent, &coefficient)?.answer(digits)?;
    let kind = match answer.regime {
        Regime::CompleteContact => FoldKind::Maximum,
        _ => FoldKind::Minimum,
    };
    let folds = match &scene.held.by {
        HeldBy::Machine { .. } => answer.folds,
        _ => answer
            .critical
            .map(|c| Instability { contact_radius: c.contact_radius, indentation: c.indentation, force: c.force, kind })
            .into_iter()
            .collect(),
    };
    let written = |decimal: Decimal| Number::Decimal(decimal.to_string());
    let records = folds.into_iter().map(|fold| outputs::fold(fold).convert(written)).collect();
    Ok(Some(Output::new(Want::Folds, Promise::Certified, records).complete(complete())))
}

/// The same to a few digits.
pub(super) fn roughly(scene: &Scene) -> Option<Vec<Record<Number>>> {
    Some(folds(scene, DIGITS).ok().flatten()?.records)
}

/// An event at a fold of which the closed form knows that a quantity is exactly zero.
pub(super) fn with_zeros(event: Record<Enclosure>, fold: &Record<Number>) -> Record<Enclosure> {
    let is_zero = |key: &&str| matches!(fold.get(key), Some(Field::Number(number)) if number.to_string() == "0");
    let exact = || Field::Number(Enclosure::Exact(Rational::new()));
    ["indentation", "force"].iter().filter(|key| is_zero(key)).fold(event, |event, key| event.replacing(key, exact()))
}

/// All folds, on all radii.
pub(super) fn complete() -> Complete {
    Complete { proved: true, from: Some("0".to_owned()), to: None, why: "closed form of a power law".to_owned() }
}

/// n and C of f = C rⁿ where the profile is one with rational constants.
pub(super) fn power_law(shape: &Shape) -> Option<(Literal, Literal)> {
    match shape {
        Shape::Power { n, c } => Some((n.clone(), c.clone())),
        Shape::Cone { slope: Slope::Tangent(slope) } => Some((exactly(&Rational::from(1))?, slope.clone())),
        Shape::Paraboloid { radius } => {
            let curvature = (radius.to_rational() * 2u32).recip();
            Some((exactly(&Rational::from(2))?, exactly(&curvature)?))
        }
        _ => None,
    }
}

fn question(scene: &Scene, exponent: &Literal, coefficient: &Literal) -> Result<Question> {
    let elasticity = Elasticity::Effective(scene.effective_modulus.clone());
    let control = match &scene.held.by {
        HeldBy::Indentation => Control::Indentation,
        HeldBy::Force => Control::Force,
        HeldBy::Machine { stiffness } => Control::Machine { stiffness: stiffness.clone() },
    };
    Question::new(exponent, coefficient, &elasticity, &scene.work_of_adhesion, &control)
}
