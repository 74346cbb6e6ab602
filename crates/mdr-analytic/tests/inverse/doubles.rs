//! One value in `f64`: every quantity within an ulp.

use mdr_analytic::double;
use mdr_analytic::double::grid::InstructionSet;
use mdr_core::contact::{Ranged, Stability};
use proptest::prelude::*;

use super::bisection::{Scene, float};
use super::rows::{Many, check_many};
use crate::common::mpfr::ulps;

/// The functions for f64 against bisection: every quantity within an ulp, or beyond the range with its logarithm.
#[track_caller]
fn check_double(scene: Scene, value: f64) {
    let found = double::equilibria(scene.n, scene.c, &scene.material(), &scene.control(), value).unwrap();
    let truth = scene.truth();
    let radii = truth.equilibria(value);
    assert_eq!(found.as_slice().len(), radii.len(), "{scene:?} at {value:e}");
    let ready = scene.inverse();
    for path in InstructionSet::available() {
        check_many(&Many::of(&ready.clone().with_instructions(path), &[value]), 0, &truth, value, &radii);
    }
    for (state, ln_a) in found.as_slice().iter().zip(&radii) {
        let [d, f] = truth.state(ln_a);
        let (held, other) = if scene.by_force { (state.force, d) } else { (state.indentation, f) };
        assert_eq!(held, Ranged::Value(value));
        let found = if scene.by_force { state.indentation } else { state.force };
        for (what, found, exact) in [("a", state.contact_radius, ln_a.clone().exp()), ("d or F", found, other)] {
            match found {
                Ranged::Value(found) => {
                    let ulps = ulps(found, &exact);
                    assert!(
                        ulps <= 1.0 && (found != 0.0 || exact.is_zero()),
                        "{what} = {found:e} is {ulps} ulp off: {scene:?} at {value:e}"
                    );
                }
                Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => {
                    let exact = exact.abs().log10().to_f64();
                    assert!((log10 / exact - 1.0).abs() < 1e-12 && exact.abs() > 307.0, "{what}: {log10}, {exact}");
                }
            }
        }
        let larger = *ln_a > truth.ln_fold;
        let expected = if larger == (scene.n > 0.5) { Stability::Stable } else { Stability::Unstable };
        assert_eq!(state.stability, expected, "{scene:?} at {value:e}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 150 / 256))]

    #[test]
    fn doubles_between_the_fold_and_zero(
        n in 0.05..6.0f64, a in -9.0..0.0f64, e in 3.0..11.0f64, w in -3.0..0.0f64, k in 0..52i32, f in 0.5..1.0f64,
        by_force in any::<bool>(),
    ) {
        prop_assume!((n - 0.5).abs() > 1e-3);
        let scene = Scene::with_fold(n, 10f64.powf(a), 10f64.powf(e), 10f64.powf(w), by_force);
        let at_fold = scene.truth().at_fold();
        check_double(scene, at_fold * (1.0 - f * 2f64.powi(-k)));
        check_double(scene, at_fold * f * 2f64.powi(-k));
    }

    #[test]
    fn doubles_of_the_other_sign(
        n in 0.05..6.0f64, a in -9.0..0.0f64, e in 3.0..11.0f64, w in -3.0..0.0f64, far in -12.0..12.0f64,
        by_force in any::<bool>(),
    ) {
        prop_assume!((n - 0.5).abs() > 1e-3);
        let scene = Scene::with_fold(n, 10f64.powf(a), 10f64.powf(e), 10f64.powf(w), by_force);
        let at_fold = scene.truth().at_fold();
        check_double(scene, -at_fold * 10f64.powf(far));
        check_double(scene, 0.0);
    }

    /// 1/2 ± 2⁻ᵏ, and exponents and scales far out.
    #[test]
    fn doubles_near_one_half_and_far(
        k in 2..40i32, above in any::<bool>(), n in -4.0..4.0f64, f in 0.01..0.99f64, scale in -40.0..40.0f64,
        by_force in any::<bool>(),
    ) {
        let near = if above { 0.5 + 2f64.powi(-k) } else { 0.5 - 2f64.powi(-k) };
        for n in [near, 10f64.powf(n)] {
            let scene = Scene::with_fold(n, 10f64.powf(scale / (n + 1.0)), 1e6, 0.05, by_force);
            prop_assume!(scene.c.is_normal());
            let at_fold = scene.truth().at_fold();
            prop_assume!(at_fold.is_normal());
            for factor in [f, 1.0 - 1e-9 * f, -f, -1e30] {
                check_double(scene, at_fold * factor);
            }
        }
    }
}

/// Near n = 1/2 the fold of an ordinary contact is far out of range, and the equilibria at ordinary values are not: at
/// a(1 ± 2u) the residual has opposite signs.
#[test]
fn ordinary_equilibria_far_from_a_fold_out_of_range() {
    let mut answered = 0;
    for (k, sign) in (6..=54).flat_map(|k| [(k, 1.0), (k, -1.0)]) {
        let n = 0.5 + sign * 2f64.powi(-k);
        for (c, value, by_force) in [(2.0, 0.5, false), (0.1, -0.5, false), (5.0, 0.5, true), (0.1, -0.5, true)] {
            let scene = Scene { n, c, e: 2.0, w: 1.0, by_force };
            let truth = scene.truth();
            let found = double::equilibria(n, c, &scene.material(), &scene.control(), value).unwrap();
            for state in found.as_slice() {
                let Ranged::Value(a) = state.contact_radius else { continue };
                let residual = |factor: f64| {
                    let [d, f] = truth.state(&(float(a) * factor).ln());
                    if by_force { f - value } else { d - value }
                };
                let [below, above] = [1.0 - f64::EPSILON, 1.0 + f64::EPSILON].map(residual);
                assert!(below * above < 0, "{scene:?} at {value}: {a:e}");
                answered += 1;
            }
        }
    }
    assert!(answered >= 4 * 2 * 49, "{answered}");
}

/// Around the depth at which F vanishes, where a^{n−1/2} is 2(n + 1) times that of the fold: F is a difference there.
#[test]
fn where_the_force_vanishes() {
    for n in [0.3, 0.75, 1.0, 2.0, 4.0] {
        let scene = Scene::with_fold(n, 1e-6, 1e6, 0.05, false);
        let truth = scene.truth();
        let ln_growth = (float(n) + 1u32).ln() + float(2.0).ln();
        let zero = truth.held(&(truth.ln_fold.clone() + ln_growth * 2u32 / (2.0 * n - 1.0))).to_f64();
        for k in [4, 10, 20, 30, 36, 40, 44, 48, 52] {
            check_double(scene, zero * (1.0 - 2f64.powi(-k)));
            check_double(scene, zero * (1.0 + 2f64.powi(-k)));
        }
    }
}

/// Where squares or products of ordinary lengths leave the range, or become subnormal.
#[test]
fn at_the_ends_of_the_range() {
    for (n, a, e, w, by_force, share) in [
        // The root of a/a_fold is 10⁻¹⁵⁵.
        (0.75, 1e85, 1e80, 1e160, false, 1e-155),
        // F = 10³³², and F = 10⁻³⁴⁴.
        (4.0, 1.0, 1e85, 1e85, false, -1e198),
        (2.0, 1e-85, 1e-85, 1e-85, false, 1e-44),
        // F/E* = 10⁻³¹⁰.
        (1.0, 1e-89, 1e89, 1.0, true, 1e-132),
    ] {
        let scene = Scene::with_fold(n, a, e, w, by_force);
        check_double(scene, scene.truth().at_fold() * share);
    }
}
