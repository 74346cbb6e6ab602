//! Independence of units, and numbers near the ends of the range of the arithmetic: correct or an error.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;
use std::sync::Arc;

use approx::assert_relative_eq;
use mdr_core::contact::{Control, Error, Material, Profile, Shape};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::{SearchedBranches, equilibria};
use mdr_numeric::folds::{find, folds};
use mdr_numeric::profiles::Heights;
use mdr_numeric::transform::Quadrature;
use proptest::prelude::*;

/// The fold of a paraboloid: g' and Δl' are accurate to about 16u, d ln(g'/Δl')/d ln a is 3/2, and F is proportional to
/// a^(3/2).
const ROUNDING: f64 = 80.0 * f64::EPSILON;

#[test]
fn extreme_scales() {
    // a_c³ = πwR²/(8E*) with lengths of 10^±200 and forces of order one.
    for scale in [1e-200, 1e-100, 1e100, 1e200] {
        let ball = Arc::new(Quadrature::of([Shape::Paraboloid { radius: scale }]).unwrap());
        let material = Material::new(1.0 / scale, 1.0).unwrap();
        let fold = &folds(&ball, &material, &Control::Indentation).unwrap()[0];
        assert_relative_eq!(fold.contact_radius / scale, (PI / 8.0).cbrt(), max_relative = ROUNDING);
        assert_relative_eq!(fold.force / scale, -5.0 / 6.0 * PI, max_relative = ROUNDING);
        let pulled = equilibria(&ball, &material, &Control::Indentation, &(0.9 * fold.indentation)).unwrap();
        assert_eq!(pulled.len(), 2);
        assert!(equilibria(&ball, &material, &Control::Indentation, &(1.1 * fold.indentation)).unwrap().is_empty());
    }
    // A force that is not representable in f64 is an error with its logarithm, not 0.
    let (ball, material) = (
        Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1e-200 }]).unwrap()),
        Material::new(1.0, 1e-200).unwrap(),
    );
    match folds(&ball, &material, &Control::Indentation) {
        Err(Error::OutOfRange { log10, .. }) => assert_relative_eq!(log10, -399.582, epsilon = 1e-3),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_fold_whose_force_is_out_of_range_keeps_its_radius() {
    // JKR with R = w/E* = 10²⁰⁰: a = (π/8)^(1/3) 10²⁰⁰ and F of the order of −10³⁵⁰.
    let (ball, material) = (
        Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1e200 }]).unwrap()),
        Material::new(1e-50, 1e150).unwrap(),
    );
    let found = find(&Contact::half_space(&ball, &material, &Control::Indentation)).unwrap();
    assert!(found.folds.is_empty());
    let [fold] = found.out_of_range.as_slice() else { panic!("{found:?}") };
    assert_relative_eq!(fold.contact_radius, f64::cbrt(PI / 8.0) * 1e200, max_relative = ROUNDING);
    assert!(matches!(fold.error, Error::OutOfRange { log10, .. } if (350.0..351.0).contains(&log10)), "{fold:?}");
    assert!(folds(&ball, &material, &Control::Indentation).is_err());
}

/// JKR at d = 0 with R = 10¹⁰⁰: a³ = 2πwR²/E*, and the force is −(2/3)E*a³/R = −(4/3)πwR, of the order of −10³⁴⁵. The
/// method by energy meets such a force at the fold, −(5/6)πwR.
#[test]
fn an_equilibrium_whose_force_is_out_of_range_is_refused() {
    let (ball, material) = (
        Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1e100 }]).unwrap()),
        Material::new(1e250, 1e245).unwrap(),
    );
    let (control, d) = (Control::Indentation, 0.0);
    let by_forces = equilibria(&ball, &material, &control, &d).map(|found| found.equilibria);
    let by_energy =
        Energy::new(Contact::half_space(&ball, &material, &Control::Indentation)).unwrap().equilibria(&control, &d);
    for (found, factor) in [(by_forces, 5.0 / 6.0), (by_energy, 4.0 / 3.0)] {
        match found {
            Err(Error::OutOfRange { log10, .. }) => {
                assert_relative_eq!(log10, 345.0 + f64::log10(factor * PI), max_relative = 1e-12);
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn a_power_may_leave_the_range_where_the_height_does_not() {
    // rⁿ is 10⁻³⁶⁴ or 10³⁶⁴; rounding 10^∓14 to f64 changes it by 26 roundings.
    for (r, c, height) in [(1e-14, 1e250, 1e-114), (1e14, 1e-250, 1e114)] {
        assert_relative_eq!(
            Heights::new([Shape::Power { n: 26.0, c }]).unwrap().height(&r),
            height,
            max_relative = 64.0 * f64::EPSILON
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 6 / 256))]

    /// A change of the units of length and force by powers of two changes no bit.
    #[test]
    fn units_do_not_matter(
        length in -80..80_i32,
        modulus in -80..80_i32,
        w in 1e-4..1.0_f64,
        share in 0.1..0.9_f64,
        which in 0..3,
    ) {
        let solve = |length: f64, modulus: f64| {
            let profile = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: length, amplitude: 5e-4 * length, wavelength: 0.1 * length }]).unwrap());
            let material = Material::new(modulus, w * modulus * length).unwrap();
            let control = Arc::new(match which {
                0 => Control::Indentation,
                1 => Control::Force,
                _ => Control::machine(0.3 * modulus * length).unwrap(),
            });
            let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control)).unwrap();
            let fold = branches.folds()[0].clone();
            let value = share * control.controlled(&fold.indentation, &fold.force);
            let force = modulus * length * length;
            let mut numbers = vec![fold.contact_radius / length, fold.indentation / length, fold.force / force];
            for state in branches.equilibria(&value).unwrap() {
                numbers.extend([state.contact_radius / length, state.indentation / length, state.force / force]);
            }
            numbers
        };
        prop_assert_eq!(solve(1.0, 1.0), solve(f64::powi(2.0, length), f64::powi(2.0, modulus)));
    }
}
