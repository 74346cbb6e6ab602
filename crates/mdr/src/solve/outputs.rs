//! Outputs from the curve of equilibria, once for every arithmetic.

use std::cmp::Ordering;

use mdr_core::contact::{self, Error, Quantity, Result, Stability};
use mdr_core::number::Literal;
use mdr_numeric::admissible::Admissibility;

use super::model::{Model, SceneReal};
use crate::answer::{Admission, CurvePoint, CurveStability, Equilibrium, Fold, TransformSample, Value};

/// g, g' and ∫₀ˣ g at the radii x.
///
/// # Errors
/// Errors that concern the whole computation, not one value.
pub(crate) fn transform<R: SceneReal>(model: &Model<R>, radii: &[Literal]) -> Result<Vec<TransformSample<R>>> {
    let transform = model.transform();
    let at = |literal: &Literal| {
        let x = model.number(literal);
        Ok(TransformSample {
            x: literal.clone(),
            g: Value::from_result(transform.g(&x))?,
            slope: Value::from_result(transform.slope(&x))?,
            integral: Value::from_result(transform.integral(&x))?,
        })
    };
    radii.iter().map(at).collect()
}

/// The equilibria with the given contact radii.
///
/// # Errors
/// Errors that concern the whole computation, not one value.
pub(crate) fn curve<R: SceneReal>(
    model: &Model<R>,
    radii: &[Literal],
    admissibility: &Admissibility,
) -> Result<Vec<CurvePoint<R>>> {
    let curve = model.contact();
    let at = |literal: &Literal| {
        let a = model.size(literal)?;
        let (indentation, force) = match curve.state(&a) {
            Ok((indentation, force)) => (Ok(indentation), Ok(force)),
            Err(error) => (curve.indentation(&a), Err(error)),
        };
        let stability = curve.tangency(&a).and_then(|ratio| Ok(ratio.partial_cmp(&curve.critical_ratio(&a)?)));
        let stability = match stability {
            Ok(Some(Ordering::Greater)) => Value::Known(Stability::Stable),
            Ok(Some(Ordering::Less)) => Value::Known(Stability::Unstable),
            Ok(Some(Ordering::Equal)) => Value::Known(Stability::Neutral),
            Ok(None) => {
                let what = "whether the equilibrium is stable";
                return Err(Error::undecided(Quantity::ContactRadius, &a, what));
            }
            Err(error) => Value::from_result(Err(error))?,
        };
        let verdict = indentation.as_ref().ok().map(|d| admissibility.of(a.approx(), d.approx()));
        Ok(CurvePoint {
            contact_radius: literal.clone(),
            indentation: Value::from_result(indentation)?,
            force: Value::from_result(force)?,
            stability: CurveStability(stability),
            admissible: verdict.map(Admission::of),
        })
    };
    radii.iter().map(at).collect()
}

/// A fold by its contact radius, and whether it is admissible.
pub(crate) fn fold<R: SceneReal>(model: &Model<R>, fold: contact::Fold<R>, admissibility: &Admissibility) -> Fold<R> {
    let verdict = admissibility.of(fold.contact_radius.approx(), fold.indentation.approx());
    let contact_radius = model.contact_radius(&fold.contact_radius);
    Fold::new(contact::Fold { contact_radius, ..fold }, verdict)
}

/// An equilibrium by its contact radius, and whether it is admissible.
pub(crate) fn equilibrium<R: SceneReal>(
    model: &Model<R>,
    state: contact::Equilibrium<R>,
    admissibility: &Admissibility,
) -> Equilibrium<R> {
    let verdict = admissibility.of(state.contact_radius.approx(), state.indentation.approx());
    Equilibrium::new(model.shown(state), verdict)
}
