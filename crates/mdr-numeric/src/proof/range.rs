//! The range of radii for a proof.

use mdr_core::contact::Fold;

use crate::contact::Contact;
use crate::folds::Folds;

/// The factor by which the range extends beyond radii that a contact is known to visit.
const MARGIN: f64 = 4.0;

/// A range for [`EnclosedCurve::folds`](super::EnclosedCurve::folds): the kinks of g and the results of the search in
/// `f64` (folds, poles, folds whose force is out of range and those not located), extended by a factor `reach` on both sides. Around w/E*
/// if nothing was found, or around half the outer radius if that is smaller. It includes the radii `visited`, by a
/// factor of four, and the outer radius.
pub fn range(curve: &Contact<f64>, found: &Folds<f64>, reach: f64, visited: &[f64]) -> (f64, f64) {
    let transform = curve.transform();
    let radius = |fold: &Fold<f64>| fold.contact_radius;
    let mut radii: Vec<f64> = found.folds.iter().chain(&found.poles).map(radius).collect();
    radii.extend(found.out_of_range.iter().map(|fold| fold.contact_radius).chain(found.unlocated.iter().copied()));
    if radii.is_empty() {
        let length = curve.material_length();
        radii.push(transform.outer_radius().map_or(length, |outer| length.min(outer / 2.0)));
    }
    radii.extend(transform.kinks());
    let lower = radii.iter().map(|a| a / reach).chain(visited.iter().map(|a| a / MARGIN));
    // A profile with an end is included up to its end.
    let far = visited.iter().copied().chain(transform.outer_radius()).map(|a| a * MARGIN);
    let upper = radii.iter().map(|a| a * reach).chain(far);
    (lower.fold(f64::MAX, f64::min).max(f64::MIN_POSITIVE), upper.fold(0.0, f64::max).min(f64::MAX))
}
