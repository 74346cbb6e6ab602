//! All folds of a closed form, each digit proved: power laws by their own closed forms, the others by enclosures of the
//! tangency condition over a whole range of radii.

use mdr_analytic::certified::{Elasticity, Question};
use mdr_core::contact::{Body, Control, FoldKind, Instability, Regime, Result};
use mdr_core::number::certify::{Decimal, Enclosure};
use mdr_core::number::{Dual, Interval, Literal, Precision};
use mdr_numeric::proof::{EnclosedCurve, ProvedFolds};
use rug::{Float, Rational};

use super::answer::{Complete, Output, Promise};
use super::certified::Certified;
use super::contact::Contact;
use super::digits::proved;
use super::{outputs, sample};
use crate::number::Number;
use crate::scene::{Bodies, HeldBy, Scene, Shape, Slope, Want};

/// Bits in which folds are isolated; they are sharpened afterwards.
const ISOLATION: u32 = 64;
/// Evaluations that the isolation may spend.
const BUDGET: usize = 4_000_000;

pub(super) fn folds(certified: &Certified<'_>) -> Result<Output> {
    match power_law(&certified.scene.profile) {
        Some((exponent, coefficient)) => power_law_folds(certified, &exponent, &coefficient),
        None => enclosed_folds(certified),
    }
}

/// n and C of f = C rⁿ where the profile is one with rational constants.
fn power_law(shape: &Shape) -> Option<(Literal, Literal)> {
    let literal = |value: &Rational| value.to_string().parse().ok();
    match shape {
        Shape::Power { n, c } => Some((n.clone(), c.clone())),
        Shape::Cone { slope: Slope::Tangent(slope) } => Some((literal(&Rational::from(1))?, slope.clone())),
        Shape::Paraboloid { radius } => {
            let curvature = (radius.to_rational() * 2u32).recip();
            Some((literal(&Rational::from(2))?, literal(&curvature)?))
        }
        _ => None,
    }
}

fn power_law_folds(certified: &Certified<'_>, exponent: &Literal, coefficient: &Literal) -> Result<Output> {
    let question = question(certified.scene, exponent, coefficient)?;
    let answer = question.answer(certified.digits)?;
    let kind = match answer.regime {
        Regime::CompleteContact => FoldKind::Maximum,
        _ => FoldKind::Minimum,
    };
    let folds = match &certified.scene.held.by {
        HeldBy::Machine { .. } => answer.folds,
        _ => answer
            .critical
            .map(|c| Instability { contact_radius: c.contact_radius, indentation: c.indentation, force: c.force, kind })
            .into_iter()
            .collect(),
    };
    let complete =
        Complete { proved: true, from: Some("0".to_owned()), to: None, why: "closed form of a power law".to_owned() };
    let written = |decimal: Decimal| Number::Decimal(decimal.to_string());
    let records = folds.into_iter().map(|fold| outputs::fold(fold).convert(written)).collect();
    Ok(Output::new(Want::Folds, Promise::Certified, records).complete(complete))
}

fn question(scene: &Scene, exponent: &Literal, coefficient: &Literal) -> Result<Question> {
    let elasticity = match &scene.bodies {
        Bodies::Effective(modulus) => Elasticity::Effective(modulus.clone()),
        Bodies::Pair(bodies) => {
            let body = |(e, nu): &(Literal, Literal)| Body { youngs_modulus: e.clone(), poissons_ratio: nu.clone() };
            let [first, second] = bodies.as_ref().each_ref().map(body);
            Elasticity::bodies(first, second)
        }
    };
    let control = match &scene.held.by {
        HeldBy::Indentation => Control::Indentation,
        HeldBy::Force => Control::Force,
        HeldBy::Machine { stiffness } => Control::Machine { stiffness: stiffness.clone() },
    };
    Question::new(exponent, coefficient, &elasticity, &scene.work_of_adhesion, &control)
}

/// The contact over enclosures, and over enclosures with derivatives.
struct Enclosed {
    plain: Contact<Interval>,
    moving: Contact<Dual<Interval>>,
}

impl Enclosed {
    fn new(certified: &Certified<'_>, precision: Precision) -> Result<Self> {
        Ok(Enclosed { plain: certified.contact(precision)?, moving: certified.contact(precision)? })
    }

    fn curve(&self) -> EnclosedCurve<'_> {
        EnclosedCurve::new(self.plain.curve(), self.moving.curve())
    }
}

fn enclosed_folds(certified: &Certified<'_>) -> Result<Output> {
    let range = match &certified.scene.output.range {
        Some(range) => range.clone(),
        None => {
            let rough = certified.rough()?;
            sample::range(rough.contact(), rough.folds()?)?
        }
    };
    let isolated = isolate(certified, &range)?;
    let records = proved(certified.digits, |precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let sharp = isolated
            .folds
            .iter()
            .map(|fold| Ok(outputs::fold(enclosed.curve().sharpen(fold)?).convert(Enclosure::from)));
        sharp.collect()
    })?;
    Ok(Output::new(Want::Folds, Promise::Certified, records).complete(completeness(&isolated, &range)))
}

fn isolate(certified: &Certified<'_>, range: &[Literal; 2]) -> Result<ProvedFolds> {
    let precision = Precision::new(ISOLATION);
    let [lower, upper] = range.each_ref().map(|end| <Interval as mdr_core::number::Real>::from_literal(precision, end));
    Enclosed::new(certified, precision)?.curve().folds(lower.lower(), upper.upper(), BUDGET)
}

fn completeness(isolated: &ProvedFolds, [from, to]: &[Literal; 2]) -> Complete {
    let why = match isolated.undecided.as_slice() {
        [] => "enclosures of the tangency condition leave no room for another fold".to_owned(),
        gaps => {
            let gap = |(lower, upper): &(Float, Float)| format!("{:.8e} to {:.8e}", lower.to_f64(), upper.to_f64());
            let shown: Vec<_> = gaps.iter().take(3).map(gap).collect();
            let more = if gaps.len() > 3 { format!(" and {} more", gaps.len() - 3) } else { String::new() };
            format!("undecided at contact radii {}{more}", shown.join(", "))
        }
    };
    Complete { proved: isolated.is_complete(), from: Some(from.to_string()), to: Some(to.to_string()), why }
}
