//! Tests of the private items of `mdr::diagram::sampling`.

use mdr_analytic::profiles::{EllipticalDimple, WavyParaboloid};
use mdr_core::contact::{Control, Material};

use super::*;

#[test]
fn a_singular_radius_is_passed_by() {
    let dimple = std::sync::Arc::new(EllipticalDimple::new(1e-6, 1e-4).unwrap());
    let material = Material::new(1e6, 0.05).unwrap();
    let curve = Contact::half_space(&dimple, &material, &Control::Indentation);
    assert!(curve.state(&1e-4).is_err());
    let samples = samples(&curve, 1e-7, 3e-4, &[]).unwrap();
    assert!(samples.iter().all(|sample| sample.indentation.is_finite()));
}

#[test]
fn the_polyline_stays_with_the_curve_and_passes_through_the_nodes() {
    let wavy = std::sync::Arc::new(WavyParaboloid::new(1.0, 2e-4, 0.03).unwrap());
    let material = Material::new(1.0, 1e-4).unwrap();
    let curve = Contact::half_space(&wavy, &material, &Control::Indentation);
    let nodes = [0.0275, 0.0834567];
    let samples = samples(&curve, 1e-6, 0.11, &nodes).unwrap();
    assert!(samples.len() < 3000, "{}", samples.len());
    for node in nodes {
        assert!(samples.iter().any(|sample| sample.contact_radius == node));
    }
    let range = ranges(&samples);
    for pair in samples.windows(2) {
        assert!(pair[0].contact_radius < pair[1].contact_radius);
        for quarter in [0.25, 0.75] {
            let a = pair[0].contact_radius + quarter * (pair[1].contact_radius - pair[0].contact_radius);
            let d = pair[0].indentation + quarter * (pair[1].indentation - pair[0].indentation);
            let off = (curve.indentation(&a).unwrap() - d).abs() / range[1];
            // A parabola is off by 3/4 of its middle there; the wave is nearly one within a piece.
            assert!(off < 1.5 * TOLERANCE, "{off} at {a}");
        }
    }
}
