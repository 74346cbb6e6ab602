//! Instabilities: the folds of the controlled quantity along the curve of equilibria.

use std::ops::Deref;
use std::sync::Arc;

use mdr_core::calculus::roots::{self, Bracket};
use mdr_core::contact::{Control, Error, Fold, FoldKind, Material, Quantity, Result, Transform};
use mdr_core::number::Real;

use crate::contact::Contact;
use crate::equator;
use crate::survey::{self, Crossing, Range};

/// How far beyond two radii [`find_between`] looks, in ln a.
const BEYOND: f64 = 0.5;

/// The quality of a search. Neither is a proof, which needs enclosures of g over intervals of radii.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SearchQuality {
    /// Not proved; but the function was resolved everywhere in the range of radii, or stayed away from the condition by
    /// a margin.
    Resolved,
    /// Not proved, and the function was not resolved or could not be evaluated somewhere: folds may be missing.
    Doubtful,
}

/// The folds of one contact under one control.
#[derive(Clone, Debug, PartialEq)]
pub struct Folds<R> {
    /// The folds, by increasing radius.
    pub folds: Vec<Fold<R>>,
    /// Radii where g, and with it the controlled quantity, diverges: the curve of equilibria is cut there as by a fold.
    /// By increasing radius; indentation and force are infinite.
    pub poles: Vec<Fold<R>>,
    /// Folds whose force overflows or underflows, by increasing radius; only the radius is computed.
    pub out_of_range: Vec<OutOfRangeFold<R>>,
    /// Radii where there is a fold, or a place where g has no value, that could not be located: g' is too inaccurate there.
    pub unlocated: Vec<R>,
    /// Whether there may be more.
    pub completeness: SearchQuality,
}

/// A fold whose force is out of the range of the arithmetic.
#[derive(Clone, Debug, PartialEq)]
pub struct OutOfRangeFold<R> {
    /// a, in m.
    pub contact_radius: R,
    /// Whether the controlled quantity has its minimum or its maximum there.
    pub kind: FoldKind,
    /// The quantity that is out of range, and its log₁₀.
    pub error: Error,
}

impl<R: Real> Folds<R> {
    fn add(&mut self, curve: &Contact<R>, contact_radius: R, kind: FoldKind) -> Result<()> {
        match curve.state(&contact_radius) {
            Ok((indentation, force)) => self.folds.push(Fold { contact_radius, indentation, force, kind }),
            Err(error @ Error::OutOfRange { .. }) => {
                self.out_of_range.push(OutOfRangeFold { contact_radius, kind, error })
            }
            Err(error) => return Err(error),
        }
        Ok(())
    }
}

/// The folds that have a state.
impl<R> Deref for Folds<R> {
    type Target = [Fold<R>];

    fn deref(&self) -> &[Fold<R>] {
        &self.folds
    }
}

/// All folds by tangency: g'(a) = Δl'(a) (1.10) under controlled indentation, g' = 3Δl' under controlled force, and
/// g' = Δl'(1 + (q/p)/(1 + k/S)) on a machine of stiffness k, with S, q and p of the [medium](crate::medium). By increasing
/// radius.
///
/// If the curve is unstable up to a [vertical edge](Transform::vertical_edge), the last fold is a minimum at the vertical edge:
/// the contact edge stays there when the controlled quantity is larger.
///
/// At a fold the relative error of the radius is the error of g' over |d ln(g'/Δl')/d ln a|, n − 1/2 for a power law;
/// indentation and force are more accurate.
///
/// ```
/// use mdr_core::contact::{Control, Material, Shape};
/// use mdr_numeric::{folds::folds, transform::Quadrature};
/// use std::sync::Arc;
/// // The pull-off force of JKR, −(3/2)πwR (Johnson, Kendall, Roberts 1971).
/// let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?);
/// let rubber = Material::new(1e6, 0.05)?;
/// let pull_off = &folds(&ball, &rubber, &Control::Force)?[0];
/// assert!((pull_off.force / (-1.5 * 0.05 * std::f64::consts::PI) - 1.0).abs() < 1e-13);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// Errors of the transform at a fold; [`Error::Domain`] unless the stiffness of a machine is positive and finite;
/// [`Error::Undecided`] at a threshold of n = 1/2; [`OutOfRange`](Error::OutOfRange) if the force of a fold is not representable.
/// See [`find`].
pub fn folds<R, T>(transform: &Arc<T>, material: &Material<R>, control: &Control<R>) -> Result<Folds<R>>
where
    R: Real,
    T: Transform<R> + ?Sized + 'static,
{
    let found = find(&Contact::half_space(transform, material, control))?;
    match found.out_of_range.first() {
        Some(fold) => Err(fold.error.clone()),
        None => Ok(found),
    }
}

/// All folds of a contact by tangency, including those whose force is out of range; [`folds`] states the condition.
///
/// # Errors
/// Errors of the transform at a fold; [`Error::Domain`] unless the stiffness of a machine is positive and finite;
/// [`Error::Undecided`] if the condition is satisfied, up to rounding, over a whole range of radii: n = 1/2 with C at a threshold
/// (1.19).
pub fn find<R: Real>(curve: &Contact<R>) -> Result<Folds<R>> {
    search(curve, [survey::REACH; 2], survey::HEIGHTS)
}

/// The folds of a contact as [`find`] finds them, from the tip outwards, until so many heights of the profile are evaluated: those of waves
/// without end are ever more work. Where the search ends there, [`Folds::completeness`] is doubtful.
///
/// ```
/// use mdr_core::contact::{Control, Expression, Material};
/// use mdr_numeric::contact::Contact;
/// use mdr_numeric::folds::{SearchQuality, find_within};
/// use mdr_numeric::transform::Quadrature;
/// use std::sync::Arc;
/// let (formula, none): (Expression, _) = ("1 - cos(r)".parse()?, Default::default());
/// let waves = Arc::new(Quadrature::new(formula.bind((), &none)?));
/// let found = find_within(&Contact::half_space(&waves, &Material::new(1.0, 1e-4)?, &Control::Indentation), 100_000)?;
/// assert!(found.folds.len() > 3 && found.completeness == SearchQuality::Doubtful);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of [`find`].
pub fn find_within<R: Real>(curve: &Contact<R>, heights: u64) -> Result<Folds<R>> {
    search(curve, [survey::REACH; 2], heights)
}

/// The folds of a contact at radii between two, with some beyond them; [`Folds::completeness`] is about those between alone. Waves
/// without end beyond the larger radius leave nothing open.
///
/// # Errors
/// Errors of [`find`].
pub fn find_between<R: Real>(curve: &Contact<R>, least: &R, greatest: &R) -> Result<Folds<R>> {
    let length = curve.material_length();
    let reach = [length.clone() / least, greatest.clone() / &length];
    search(curve, reach.map(|ratio| (ratio.ln().approx() + BEYOND).clamp(BEYOND, survey::REACH)), survey::HEIGHTS)
}

/// The folds at radii e^(−reach\[0\]) to e^(reach\[1\]) times the length w/E*.
fn search<R: Real>(curve: &Contact<R>, reach: [f64; 2], heights: u64) -> Result<Folds<R>> {
    curve.control().check()?;
    let length = curve.material_length();
    if !(length.is_finite() && length.unit_roundoff() * &length > length.lit(0)) {
        let value = format!("a length w/E* of {}", length.approx());
        let requirement = "of a ratio to E* within the range of this arithmetic, where the search for states begins";
        return Err(Error::Domain { quantity: Quantity::WorkOfAdhesion, value, requirement });
    }
    let range = Range { reach, heights, ..Range::whole(curve.transform(), length) };
    let ratio = |a: &R| curve.fold_ratio(a);
    let mut survey = survey::survey(&range, ratio)?;
    let outer_edge = curve.vertical_edge();
    if let Some(outer_edge) = &outer_edge {
        survey.crossings.extend(before_vertical_edge(outer_edge, ratio)?);
    }
    survey.resolved &= extend_to_end(curve, ratio, &mut survey.crossings)?;
    let completeness = if survey.resolved { SearchQuality::Resolved } else { SearchQuality::Doubtful };
    let (folds, poles) = (Vec::with_capacity(survey.crossings.len()), Vec::new());
    let mut found = Folds { folds, poles, out_of_range: Vec::new(), unlocated: Vec::new(), completeness };
    for crossing in &survey.crossings {
        // The derivative of the controlled quantity has the sign of ratio − 1.
        let kind = if crossing.rising { FoldKind::Minimum } else { FoldKind::Maximum };
        if let Some(radius) = edge_within(crossing, curve, &range.kinks) {
            found.poles.push(pole(radius, kind));
            continue;
        }
        let added = match radius_of(crossing, curve, ratio) {
            Ok(Some(radius)) => found.add(curve, radius, kind),
            Ok(None) => Ok(()),
            Err(error) => Err(error),
        };
        match added {
            // Neither a fold nor a known pole; or g' is too inaccurate to locate the fold.
            Err(Error::Domain { .. } | Error::NoConvergence { .. }) => {
                found.unlocated.push(crossing.lower.clone());
                found.completeness = SearchQuality::Doubtful;
            }
            added => added?,
        }
    }
    if let Some(outer_edge) = outer_edge
        && ratio(&outer_edge)? < outer_edge.lit(1)
    {
        found.add(curve, outer_edge, FoldKind::Minimum)?;
    }
    Ok(found)
}

/// A fold with infinite indentation and force, where g diverges.
pub fn pole<R: Real>(contact_radius: R, kind: FoldKind) -> Fold<R> {
    let sign = if kind == FoldKind::Minimum { -1 } else { 1 };
    let infinite = contact_radius.lit(sign).over(0);
    Fold { contact_radius, indentation: infinite.clone(), force: infinite, kind }
}

/// The kink at a crossing, if g has no value there.
fn edge_within<R: Real>(crossing: &Crossing<R>, curve: &Contact<R>, kinks: &[R]) -> Option<R> {
    let singular = |kink: &R| matches!(curve.transform().g(kink), Err(Error::Domain { .. }));
    let mut within = kinks.iter().filter(|kink| **kink > crossing.lower && **kink < crossing.upper);
    within.find(|kink| singular(kink)).cloned()
}

/// The radius of the fold at a crossing. If folds lie where g' = 0, that of a flat is exactly its end.
fn radius_of<R: Real>(
    crossing: &Crossing<R>,
    curve: &Contact<R>,
    ratio: impl Fn(&R) -> Result<R>,
) -> Result<Option<R>> {
    let zero = crossing.lower.lit(0);
    let flat = if curve.critical_ratio_at(&crossing.lower) == zero { curve.flat()? } else { None };
    match flat.filter(|end| *end >= crossing.lower && *end <= crossing.upper) {
        Some(end) => Ok(Some(end)),
        None => radius_at(crossing, ratio),
    }
}

/// The radius of the fold at a crossing.
fn radius_at<R: Real>(crossing: &Crossing<R>, ratio: impl Fn(&R) -> Result<R>) -> Result<Option<R>> {
    let excess = |a: &R| Ok(ratio(a)? - a.lit(1));
    let Some(bracket) = Bracket::new(&crossing.lower, &crossing.upper, excess)? else { return Ok(None) };
    Ok(Some(roots::refine(bracket, &crossing.lower.unit_roundoff(), excess)?.value))
}

/// Adds the crossing between the end of the survey and the end of a profile without a vertical edge. Returns whether it
/// is certain that there is no other: if g diverges the ratio ends above one.
fn extend_to_end<R: Real>(
    curve: &Contact<R>,
    ratio: impl Fn(&R) -> Result<R>,
    crossings: &mut Vec<Crossing<R>>,
) -> Result<bool> {
    let Some(outer) = curve.transform().outer_radius().filter(|_| curve.vertical_edge().is_none()) else {
        return Ok(true);
    };
    let lower = survey::surveyed_to(&outer);
    let equator = curve.equator()?.is_some();
    let upper = if equator { equator::last_before(&outer) } else { outer };
    match [ratio(&lower), ratio(&upper)] {
        [Ok(before), Ok(after)] => {
            let ends_above = after >= after.lit(1);
            crossings.extend(between([lower, upper], [before, after]));
            Ok(ends_above || !equator)
        }
        // The survey has already reported that it could not reach the end.
        [Err(error), _] | [_, Err(error)] if error.is_interruption() => Err(error),
        [Ok(before), Err(_)] => Ok(before > before.lit(1)),
        [Err(_), _] => Ok(true),
    }
}

/// The crossing between the end of the survey and a vertical edge, if there is one.
fn before_vertical_edge<R: Real>(outer_edge: &R, ratio: impl Fn(&R) -> Result<R>) -> Result<Option<Crossing<R>>> {
    let surveyed = survey::surveyed_to(outer_edge);
    let ratios = [ratio(&surveyed)?, ratio(outer_edge)?];
    Ok(between([surveyed, outer_edge.clone()], ratios))
}

/// The crossing between two radii, if the ratios there show one.
fn between<R: Real>([lower, upper]: [R; 2], ratios: [R; 2]) -> Option<Crossing<R>> {
    let [before, after] = ratios.map(|ratio| ratio >= ratio.lit(1));
    (before != after).then_some(Crossing { lower, upper, rising: after })
}
