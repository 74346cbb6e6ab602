//! The range of radii for a proof.

use mdr_core::contact::Instability;

use crate::curve::Curve;
use crate::folds::Folds;

/// The factor by which the range extends beyond radii that a contact is known to visit.
const MARGIN: f64 = 4.0;

/// A range for [`EnclosedCurve::folds`](super::EnclosedCurve::folds): the kinks of g and the results of the search in
/// `f64` (folds, poles and folds whose force is out of range), extended by a factor `reach` on both sides. Around w/E*
/// if nothing was found, or around half the outer radius if that is smaller. It includes the radii `visited`, by a
/// factor of four, and the outer radius.
pub fn range(curve: &Curve<'_, f64>, found: &Folds<f64>, reach: f64, visited: &[f64]) -> (f64, f64) {
    let transform = curve.transform();
    let radius = |fold: &Instability<f64>| fold.contact_radius;
    let mut radii: Vec<f64> = found.folds.iter().chain(&found.poles).map(radius).collect();
    radii.extend(found.beyond.iter().map(|fold| fold.contact_radius));
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

#[cfg(test)]
mod tests {
    use mdr_core::contact::{Control, Material, Result, Shape};

    use super::*;
    use crate::folds;
    use crate::transform::Quadrature;

    /// The fold of JKR at a³ = πwR²/8E*, whose force −(5/6)πwR is no double, is in the range nevertheless.
    #[test]
    fn folds_out_of_range_are_looked_at() -> Result<()> {
        let (material, control) = (Material::new(1e300, 1e296)?, Control::Indentation);
        let ball = Quadrature::of([Shape::Paraboloid { radius: 1e20 }])?;
        let curve = Curve::new(&ball, &material, &control);
        let found = folds::find(&curve)?;
        assert_eq!((found.folds.len(), found.beyond.len()), (0, 1));
        let (lower, upper) = range(&curve, &found, 8.0, &[]);
        let fold = (std::f64::consts::PI * 1e-4 * 1e40 / 8.0).cbrt();
        assert!((lower * 8.0 / fold - 1.0).abs() < 1e-6 && (upper / 8.0 / fold - 1.0).abs() < 1e-6, "{lower} {upper}");
        Ok(())
    }

    #[test]
    fn visited_radii_are_within() -> Result<()> {
        let (material, control) = (Material::new(1.0, 1e-3)?, Control::Indentation);
        let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
        let curve = Curve::new(&ball, &material, &control);
        let found = folds::find(&curve)?;
        let alone = range(&curve, &found, 8.0, &[]);
        assert_eq!(range(&curve, &found, 8.0, &[1e-9, 1e9]), (1e-9 / 4.0, 4e9));
        assert_eq!(range(&curve, &found, 8.0, &[found[0].contact_radius]), alone);
        Ok(())
    }
}
