//! Instabilities: the folds of the controlled quantity along the curve of equilibria.

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{Control, Error, FoldKind, Instability, Material, Result, Transform};
use mdr_core::number::Real;

use crate::curve::Curve;
use crate::survey::{self, Crossing, Range};

/// How far a search can be trusted. Neither is a proof: that needs enclosures of g over intervals of radii.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Completeness {
    /// Not proved; but the function was resolved everywhere in the range of radii, or kept a margin from the condition.
    Resolved,
    /// Not proved, and somewhere the function could not be resolved or evaluated: folds may be missing.
    Doubtful,
}

/// The folds of one contact under one control.
#[derive(Clone, Debug, PartialEq)]
pub struct Folds<R> {
    /// By increasing radius.
    pub folds: Vec<Instability<R>>,
    /// Whether there may be more.
    pub completeness: Completeness,
}

/// All folds by tangency: g'(a) = Δl'(a) (1.10) under controlled indentation, g' = 3Δl' under controlled force, and
/// g' = Δl'·(k+6E*a)/(k+2E*a) on a machine. By increasing radius.
///
/// Where the curve is unstable up to a [wall](Transform::wall), the last fold is a minimum at the wall: the contact edge
/// rests there when the controlled quantity is larger.
///
/// At a fold the relative error of the radius is the error of g' over |d ln(g'/Δl')/d ln a|, n − 1/2 for a power law;
/// indentation and force lose less.
///
/// ```
/// use mdr_core::contact::{Control, Material};
/// use mdr_numeric::{folds::folds, profiles::Paraboloid, transform::Quadrature};
/// // The pull-off force of JKR, −(3/2)πwR (Johnson, Kendall, Roberts 1971).
/// let (ball, rubber) = (Quadrature::new(Paraboloid::new(1.0)?), Material::new(1e6, 0.05)?);
/// let pull_off = &folds(&ball, &rubber, &Control::Force)?[0];
/// assert!((pull_off.force / (-1.5 * 0.05 * std::f64::consts::PI) - 1.0).abs() < 1e-13);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// Those of the transform at a fold; [`OutOfRange`](mdr_core::contact::Error::OutOfRange) when a force is no number of
/// this arithmetic.
pub fn folds<R: Real>(
    transform: &dyn Transform<R>,
    material: &Material<R>,
    control: &Control<R>,
) -> Result<Vec<Instability<R>>> {
    Ok(find(&Curve::new(transform, material, control))?.folds)
}

/// As [`folds`], with a statement on completeness.
///
/// # Errors
/// As [`folds`].
pub fn find<R: Real>(curve: &Curve<'_, R>) -> Result<Folds<R>> {
    let range = Range {
        scale: curve.material_length(),
        kinks: curve.transform().kinks(),
        outer: curve.transform().outer_radius(),
    };
    let ratio = |a: &R| Ok(curve.tangency(a)? / curve.threshold(a));
    let mut survey = survey::survey(&range, ratio);
    let wall = curve.wall();
    if let Some(wall) = &wall {
        survey.crossings.extend(before_wall(wall, ratio)?);
    }
    let mut folds = Vec::with_capacity(survey.crossings.len());
    for crossing in &survey.crossings {
        match at_crossing(curve, crossing, ratio) {
            Ok(found) => folds.extend(found),
            // A pole of g, which no fold lies on.
            Err(Error::Domain { .. }) => survey.resolved = false,
            Err(error) => return Err(error),
        }
    }
    if let Some(wall) = wall
        && ratio(&wall)? < wall.lit(1)
    {
        folds.push(fold(curve, wall, FoldKind::Minimum)?);
    }
    let completeness = if survey.resolved { Completeness::Resolved } else { Completeness::Doubtful };
    Ok(Folds { folds, completeness })
}

/// The fold at a crossing.
fn at_crossing<R: Real>(
    curve: &Curve<'_, R>,
    crossing: &Crossing<R>,
    ratio: impl Fn(&R) -> Result<R>,
) -> Result<Option<Instability<R>>> {
    let excess = |a: &R| Ok(ratio(a)? - a.lit(1));
    let Some(bracket) = Bracket::new(&crossing.lower, &crossing.upper, excess)? else { return Ok(None) };
    let contact_radius = roots::refine(bracket, &crossing.lower.unit_roundoff(), excess)?.value;
    // The derivative of the controlled quantity has the sign of ratio − 1.
    let kind = if crossing.rising { FoldKind::Minimum } else { FoldKind::Maximum };
    fold(curve, contact_radius, kind).map(Some)
}

fn fold<R: Real>(curve: &Curve<'_, R>, contact_radius: R, kind: FoldKind) -> Result<Instability<R>> {
    let (indentation, force) = curve.state(&contact_radius)?;
    Ok(Instability { contact_radius, indentation, force, kind })
}

/// The crossing between a wall and where the survey ends, if there is one.
fn before_wall<R: Real>(wall: &R, ratio: impl Fn(&R) -> Result<R>) -> Result<Option<Crossing<R>>> {
    let surveyed = wall.clone() - R::from_f64(wall.ctx(), survey::OUTER_MARGIN) * wall;
    let [before, after] = [ratio(&surveyed)?, ratio(wall)?].map(|ratio| ratio >= ratio.lit(1));
    Ok((before != after).then(|| Crossing { lower: surveyed, upper: wall.clone(), rising: after }))
}
