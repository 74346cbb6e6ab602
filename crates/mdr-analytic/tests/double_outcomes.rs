//! Guarantees of the `f64` closed forms beyond accuracy: exact zeros, scaling, domains, folds. Runs without GMP.
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]

use mdr_analytic::{Kappa, State, double};
use mdr_core::contact::{Control, Error, FoldKind, Material, Quantity, Ranged};
use proptest::prelude::*;

fn material(e: f64, w: f64) -> Material<f64> {
    Material::new(e, w).unwrap()
}

/// x within one ulp of y.
fn close(x: f64, y: f64) -> bool {
    (x - y).abs() <= f64::EPSILON * y.abs()
}

fn value(answer: Ranged<f64>) -> f64 {
    answer.value(Quantity::Force).unwrap()
}

#[test]
fn exact_zeros_are_zero() {
    for (e, w, c) in [(1e6, 0.05, 3.0), (1e200, 1e-100, 1e-7), (7e-3, 1e30, 1e9)] {
        let critical = double::critical(1.5, c, &material(e, w), &Control::Force).unwrap();
        assert_eq!(critical.indentation, Ranged::Value(0.0));
    }
    // ã^{n−1/2} = 2n and ã^{n−1/2} = 2(n+1).
    for (n, ratio) in [(1.0, 4.0), (0.25, 16.0), (0.125, 2f64.powf(16.0 / 3.0))] {
        let d = double::universal_indentation(n, ratio).unwrap();
        assert_eq!(d == Ranged::Value(0.0), n != 0.125, "n = {n}: {d:?}");
    }
    for (n, ratio) in [(1.0, 16.0), (1.5, 5.0), (3.0, 2f64.powf(1.2))] {
        let f = double::universal_force(n, ratio).unwrap();
        assert_eq!(f == Ranged::Value(0.0), n != 3.0, "n = {n}: {f:?}");
    }
    // The critical state itself.
    for n in [0.1, 0.3, 0.7, 2.0, 1e9] {
        let sign = if n < 0.5 { 1.0 } else { -1.0 };
        assert_eq!(double::universal_indentation(n, 1.0).unwrap(), Ranged::Value(sign));
        assert_eq!(double::universal_force(n, 1.0).unwrap(), Ranged::Value(-1.0));
    }
}

#[test]
fn known_values() {
    assert_eq!(double::kappa(2.0).unwrap(), 2.0);
    assert_eq!(double::kappa(4.0).unwrap(), 8.0 / 3.0);
    assert_eq!(double::kappa(1.0).unwrap(), std::f64::consts::FRAC_PI_2);
    assert_eq!(f64::kappa(&0.5), 1.311_028_777_146_059_8);
    // JKR: a³ = πwR²/(8E*), F = −(5/6)πwR.
    let (e, w, radius) = (1e6, 0.05, 1e-3);
    let jkr = double::critical(2.0, 500.0, &material(e, w), &Control::Indentation).unwrap();
    assert!(close(value(jkr.force), -5.0 / 6.0 * std::f64::consts::PI * w * radius));
    let elongation = value(double::detachment_elongation(&material(e, w), 1e-4).unwrap());
    assert!(close(elongation, (2.0 * std::f64::consts::PI * 1e-4 * w / e).sqrt()));
    let threshold =
        value(double::threshold(&material(1.0, 0.5 / std::f64::consts::PI), &Control::Indentation).unwrap());
    assert!(close(threshold, 0.762_759_763_501_813_2));
}

#[test]
fn outside_the_domain() {
    let rubber = material(1e6, 0.05);
    let refused = |result: Result<Ranged<f64>, Error>, message: &str| {
        assert_eq!(result.unwrap_err().to_string(), message);
    };
    let critical = |n, c, control| double::critical(n, c, &rubber, &control).map(|state| state.force);
    refused(critical(f64::NAN, 1.0, Control::Force), "the exponent n must be positive and finite, got NaN");
    refused(critical(-1.0, 1.0, Control::Force), "the exponent n must be positive and finite, got -1");
    refused(critical(2.0, f64::INFINITY, Control::Force), "the coefficient C must be positive and finite, got inf");
    refused(
        critical(2.0, 1.0, Control::Machine { stiffness: 0.0 }),
        "the machine stiffness k must be positive and finite, got 0",
    );
    assert!(matches!(critical(0.5, 1.0, Control::Force), Err(Error::Domain { quantity: Quantity::Exponent, .. })));
    refused(double::force(2.0, 1.0, &rubber, 0.0), "the contact radius a must be positive and finite, got 0");
    refused(double::energy(2.0, 1.0, &rubber, 1.0, f64::NAN), "the indentation depth d must be finite, got NaN");
    assert!(double::energy_lost_at_pull_off(0.3, 1.0, &rubber).is_err());
    assert!(double::kappa(0.0).is_err() && double::kappa(f64::INFINITY).is_err());
}

#[test]
fn folds_of_a_machine() {
    let unit = material(1.0, 1.0);
    let folds = double::machine_folds(0.6, 2.4829, &unit, 1.0).unwrap();
    let kinds: Vec<FoldKind> = folds.iter().map(|fold| fold.kind).collect();
    assert_eq!(kinds, [FoldKind::Minimum, FoldKind::Maximum, FoldKind::Minimum]);
    // Both sides of N a^{n−1/2} = √B (k+6E*a)/(k+2E*a); the derivative of its logarithm there is of order 0.1.
    for fold in &folds {
        let a = value(fold.contact_radius);
        let left = 0.6 * double::kappa(0.6).unwrap() * 2.4829 * a.powf(0.1);
        let right = (std::f64::consts::PI / 2.0).sqrt() * (1.0 + 6.0 * a) / (1.0 + 2.0 * a);
        assert!((left / right - 1.0).abs() < 8.0 * f64::EPSILON, "a = {a}: {left} {right}");
    }
    // A machine much stiffer than the contact, much softer, and at n = 1/2.
    for (stiffness, control) in [(1e60, Control::Indentation), (1e-60, Control::Force)] {
        let fold = double::critical(2.0, 0.5, &unit, &Control::Machine { stiffness }).unwrap();
        assert_eq!(fold, double::critical(2.0, 0.5, &unit, &control).unwrap());
    }
    let fold = &double::machine_folds(0.5, 3.0, &unit, 7.0).unwrap()[0];
    let rho = value(double::ratio(3.0, &unit).unwrap());
    assert!((value(fold.contact_radius) / (3.5 * (rho - 1.0) / (3.0 - rho)) - 1.0).abs() < 8.0 * f64::EPSILON);
}

/// A cone whose fold comes close to d = 0 (s = 1, a = 4a_c): d is a small difference, ln s is nearly 0, and at any word
/// length the terms of the condition for the fold are uncertain at its root.
#[test]
fn folds_where_everything_cancels_are_decided() {
    let (c, e, w) = (2.080_928_347_144_029_7e-25, 5.592_452_198_508_288e24, 4.818_464_280_684_792e-23);
    let glue = material(e, w);
    let critical = double::critical(1.0, c, &glue, &Control::Indentation).unwrap();
    let at_zero = 8.0 * e * value(critical.contact_radius);
    for step in -200..=200_i32 {
        // Close to the zero in powers of two, further off in steps.
        let off = if step % 2 == 0 {
            f64::from(step) * 4e-3
        } else {
            f64::from(step.signum()) * 2f64.powi(-2 - step.abs() / 4)
        };
        let fold = &double::machine_folds(1.0, c, &glue, at_zero * (1.0 + off)).unwrap()[0];
        let (a, d) = (value(fold.contact_radius), value(fold.indentation));
        // d = (λ−2)√(Ba), and a stiffer machine has the smaller radius and λ.
        if off != 0.0 && off.abs() > 8.0 * f64::EPSILON {
            assert!((d < 0.0) == (off > 0.0), "off by {off}: a = {a}, d = {d}");
        }
    }
}

proptest! {
    /// With lengths in units of 2^−p and moduli of 2^q every result scales by a power of two. Each of the two is within
    /// one ulp of the same true value; not bit for bit equal, since results are not all correctly rounded.
    #[test]
    fn powers_of_two_only_move_the_exponent(n in 1..7i32, c in 0.5..2.0f64, w in 0.5..2.0f64, p in -60..60i32, q in -60..60i32) {
        let two = |power: i32| 2f64.powi(power);
        for control in [Control::Indentation, Control::Force] {
            let State { contact_radius, indentation, force } =
                double::critical(n.into(), c, &material(1.0, w), &control).unwrap();
            // C in m^(1−n), w in Pa·m, F in Pa·m².
            let scaled =
                double::critical(n.into(), c * two(p * (1 - n)), &material(two(q), w * two(p + q)), &control).unwrap();
            for (scaled, original, power) in
                [(scaled.contact_radius, contact_radius, p), (scaled.indentation, indentation, p), (scaled.force, force, q + 2 * p)]
            {
                let expected = value(original) * two(power);
                prop_assert!((value(scaled) - expected).abs() <= 2.0 * f64::EPSILON * expected.abs());
            }
        }
    }

    /// The critical state lies on the curves, up to the rounding of a itself: d' = 0 there, and F' = −2E*Δl.
    #[test]
    fn critical_states_lie_on_the_curves(n in 0.05..4.0f64, c in 0.1..10.0f64, e in 1e3..1e9f64) {
        prop_assume!((n - 0.5).abs() > 0.1);
        let m = material(e, 0.05);
        let critical = double::critical(n, c, &m, &Control::Indentation).unwrap();
        let a = value(critical.contact_radius);
        prop_assert!(close(value(double::indentation(n, c, &m, a).unwrap()), value(critical.indentation)));
        let force = value(double::force(n, c, &m, a).unwrap());
        prop_assert!((force / value(critical.force) - 1.0).abs() < 4.0 * f64::EPSILON);
    }
}
