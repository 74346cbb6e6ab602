//! The range of radii on which a proof is worth asking for.

use mdr_core::contact::Result;

use crate::curve::Curve;
use crate::folds;

/// How far the range goes beyond what was found: 2²⁰ in both directions.
const REACH: f64 = 1_048_576.0;

/// A range for [`EnclosedCurve::folds`](super::EnclosedCurve::folds): everything that the search in `f64` found, the kinks
/// of g and the length w/E*, and a factor 2²⁰ beyond on both sides.
///
/// # Errors
/// As [`folds::find`].
pub fn range(curve: &Curve<'_, f64>) -> Result<(f64, f64)> {
    let found = folds::find(curve)?.folds;
    let transform = curve.transform();
    let radii = found.iter().map(|fold| fold.contact_radius).chain(transform.kinks()).chain(transform.outer_radius());
    let length = curve.material_length();
    let (least, greatest) = radii.fold((length, length), |(least, greatest), a| (a.min(least), a.max(greatest)));
    let upper = transform.outer_radius().unwrap_or(greatest * REACH);
    Ok(((least / REACH).max(f64::MIN_POSITIVE), upper.min(f64::MAX)))
}
