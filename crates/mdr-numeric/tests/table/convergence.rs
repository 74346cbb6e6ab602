//! Profiles that the interpolant reproduces exactly, and its order of convergence otherwise.

use std::f64::consts::FRAC_PI_2;

use mdr_core::contact::Transform;
use mdr_core::number::Real;
use mdr_numeric::table::{MeasuredProfile, Table};

use super::sample::{Points, magnitude, radii, sampled};

#[test]
fn a_paraboloid_is_reproduced() {
    for rows in [5, 9, 33, 257] {
        // Multiples of 2⁻²⁰: r² is exact.
        let grid = |r: f64| (r * 1048576.0).round() / 1048576.0;
        let radii: Vec<f64> = radii(rows, 1.0, 0.4).into_iter().map(grid).collect();
        let with_tip = sampled(&radii, |r| r * r);
        let without = with_tip[1..].to_vec();
        for points in [with_tip.clone(), without] {
            let profile = MeasuredProfile::new(points).unwrap();
            let unit = 1f64.unit_roundoff() * (16.0 + 2.0 * (rows as f64).log2());
            for x in [1e-9, 0.2, radii[2], 0.77, 1.0] {
                let slopes = magnitude(&with_tip, x, |_| 1.0);
                let bends = magnitude(&with_tip, x, |aspect| 1.0 + aspect);
                // The closed forms themselves are accurate to 2 ulp.
                let check = |value: f64, exact: f64, magnitude: f64| {
                    let allowed = unit * magnitude + 4.0 * 1f64.unit_roundoff() * exact;
                    assert!((value - exact).abs() <= allowed, "{rows} rows at {x}: {value} for {exact}");
                };
                check(profile.g(&x).unwrap(), 2.0 * x * x, x * slopes);
                check(profile.slope(&x).unwrap(), 4.0 * x, bends);
                check(profile.integral(&x).unwrap(), 2.0 * x.powi(3) / 3.0, x * x * slopes);
            }
        }
    }
}

/// Errors of g(x) for 2ᵏ pieces of equal width.
fn errors(f: impl Fn(f64) -> f64, x: f64, exact: f64, pieces: impl Iterator<Item = u32>) -> Vec<f64> {
    let error = |k: u32| {
        let points: Points = sampled(&radii((1 << k) + 1, 1.0, 0.0), &f);
        (MeasuredProfile::new(points).unwrap().g(&x).unwrap() - exact).abs()
    };
    pieces.map(error).collect()
}

fn assert_order(errors: &[f64], order: f64, slack: f64) {
    for pair in errors.windows(2) {
        let observed = (pair[0] / pair[1]).log2();
        assert!((observed - order).abs() < slack, "order {observed} instead of {order}: {errors:?}");
    }
}

#[test]
fn a_sphere_converges_with_order_five_halves() {
    // R = 2, x = 3/4 on a row: the error is that of f' (h²) in the last pieces, on an arc of √h.
    let exact = 0.75 * 0.375f64.atanh();
    let errors = errors(|r| r * r / (2.0 + (4.0 - r * r).sqrt()), 0.75, exact, 5..10);
    assert_order(&errors, 2.5, 0.1);
}

#[test]
fn a_cone_is_rounded_at_its_tip_only() {
    // Its first piece has zero slope at the tip: at x ≫ h the effect is the second moment of that, h³.
    let errors = errors(|r| r, 0.5, FRAC_PI_2 * 0.5, 3..9);
    assert_order(&errors, 3.0, 0.1);
    let profile = MeasuredProfile::new(sampled(&radii(65, 1.0, 0.0), |r| r)).unwrap();
    let ratio = |x: f64| profile.g(&x).unwrap() / (FRAC_PI_2 * x);
    assert!(ratio(1e-6) < 1e-3, "flat at the very tip");
    assert!((ratio(0.5) - 1.0).abs() < 1e-5);
}

#[test]
fn the_synthetic_tip_is_its_hyperboloid_within_the_noise() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scenes/tip.csv");
    let table = Table::from_csv(std::fs::File::open(path).unwrap()).unwrap();
    assert_eq!(table.rows().len(), 301);
    let tip = table.profile::<f64>(()).unwrap();
    let slope = 20f64.to_radians().tan();
    for x in [5e-9, 20e-9, 44e-9] {
        // g = x cot α arctan(x/A), A tan α = 20 nm.
        let exact = x / slope * (x * slope / 20e-9).atan();
        // Noise of 0.05 nm over a correlation length ℓ of 1 nm changes g by about its rms times √(x/ℓ) at most.
        let noise = 0.05e-9 * (x / 1e-9).sqrt();
        assert!((tip.g(&x).unwrap() - exact).abs() < 3.0 * noise, "{x}: {} for {exact}", tip.g(&x).unwrap());
    }
}
