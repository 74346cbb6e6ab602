//! The range of radii for a proof.

use std::sync::Arc;

use mdr_core::contact::{Control, Material, Result, Shape};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds;
use mdr_numeric::proof::range;
use mdr_numeric::transform::Quadrature;

/// The fold of JKR at a³ = πwR²/8E*, whose force −(5/6)πwR is no double, is in the range nevertheless.
#[test]
fn folds_out_of_range_are_looked_at() -> Result<()> {
    let (material, control) = (Material::new(1e300, 1e296)?, Control::Indentation);
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1e20 }])?);
    let curve = Contact::half_space(&ball, &material, &control);
    let found = folds::find(&curve)?;
    assert_eq!((found.folds.len(), found.out_of_range.len()), (0, 1));
    let (lower, upper) = range(&curve, &found, 8.0, &[]);
    let fold = (std::f64::consts::PI * 1e-4 * 1e40 / 8.0).cbrt();
    assert!((lower * 8.0 / fold - 1.0).abs() < 1e-6 && (upper / 8.0 / fold - 1.0).abs() < 1e-6, "{lower} {upper}");
    Ok(())
}

#[test]
fn visited_radii_are_within() -> Result<()> {
    let (material, control) = (Material::new(1.0, 1e-3)?, Control::Indentation);
    let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?);
    let curve = Contact::half_space(&ball, &material, &control);
    let found = folds::find(&curve)?;
    let alone = range(&curve, &found, 8.0, &[]);
    assert_eq!(range(&curve, &found, 8.0, &[1e-9, 1e9]), (1e-9 / 4.0, 4e9));
    assert_eq!(range(&curve, &found, 8.0, &[found[0].contact_radius]), alone);
    Ok(())
}
