//! Power laws on graded half-spaces and on Winkler foundations.

use approx::assert_relative_eq;
use mdr_analytic::media::{GradedContact, GradedHalfSpace, graded_kappa, graded_threshold};
use mdr_analytic::{PowerLaw, PowerLawContact};
use mdr_core::contact::{Control, Error, FoldKind, Material, Regime, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};

use super::{number, prove};

fn medium(k: f64) -> GradedHalfSpace<f64> {
    if k == 1.0 {
        GradedHalfSpace::winkler(1.0 / std::f64::consts::PI, 0.01)
    } else {
        GradedHalfSpace::new(k, 1.0, 0.01)
    }
    .unwrap()
}

fn contact(n: f64, k: f64) -> GradedContact<f64> {
    GradedContact::new(n, 1.0, medium(k)).unwrap()
}

fn enclosed(precision: Precision, n: &str, k: &str, c: &str) -> Result<GradedContact<Interval>> {
    let [n, k, c, work] = [n, k, c, "0.01"].map(|text| number(precision, text));
    GradedContact::new(n, c, GradedHalfSpace::new(k, work.lit(1), work)?)
}

#[test]
fn the_paraboloid_on_a_graded_half_space() {
    let state = |precision: Precision, control: &Control<Interval>| {
        let state = enclosed(precision, "2", "0.3", "1")?.critical(control)?;
        Ok([state.contact_radius, state.indentation, state.force])
    };
    let grips = [
        "0.115787430901046546678802709324",
        "-0.0972356180448203840687689439159",
        "-0.00982937701464079248094751300981",
    ];
    prove(grips, |precision| state(precision, &Control::Indentation));
    let load = [
        "0.296341357698877810555154994338",
        "-0.0286586201389137402805809379837",
        "-0.0259181393921157942173168079121",
    ];
    prove(load, |precision| state(precision, &Control::Force));
}

/// The sphere: −(3+k)/2·πwR under a dead load, −(1−k)(5+3k)/(2(3+k))·πwR at fixed grips.
#[test]
fn the_sphere_for_every_grading() {
    for k in [-0.9, -0.5, -0.1, 0.0, 0.2, 0.7, 0.99] {
        let sphere = GradedContact::new(2.0, 0.5, medium(k)).unwrap();
        let unit = std::f64::consts::PI * 0.01;
        let load = sphere.critical(&Control::Force).unwrap().force;
        assert_relative_eq!(load, -(3.0 + k) / 2.0 * unit, max_relative = 1e-13);
        let grips = sphere.critical(&Control::Indentation).unwrap().force;
        // 1 − k of a double close to 1 has lost digits of k, here two.
        let expected = -(1.0 - k) * (5.0 + 3.0 * k) / (2.0 * (3.0 + k)) * unit;
        assert_relative_eq!(grips, expected, max_relative = 1e-12);
    }
}

/// Each bit of each number at k = 0.
#[test]
fn without_grading_it_is_the_half_space() {
    for (n, c) in [(2.0, 0.5), (0.3, 1.7), (1.0, 0.2), (0.6, 2.4829), (0.5, 1.0)] {
        let graded = GradedContact::new(n, c, GradedHalfSpace::new(0.0, 3.1, 0.02).unwrap()).unwrap();
        let plain = PowerLawContact::new(PowerLaw::new(n, c).unwrap(), Material::new(3.1, 0.02).unwrap());
        assert_eq!(graded.profile(), plain.profile());
        for control in [Control::Indentation, Control::Force, Control::Machine { stiffness: 1.0 }] {
            assert_eq!(graded.critical(&control), plain.critical(&control));
        }
        assert_eq!(graded.machine_folds(&1.0), plain.machine_folds(&1.0));
        let a = 0.37;
        assert_eq!(graded.indentation(&a), plain.indentation(&a));
        assert_eq!(graded.force(&a), plain.force(&a));
        assert_eq!(graded.indentation_slope(&a), plain.indentation_slope(&a));
        assert_eq!(graded.force_slope(&a), plain.force_slope(&a));
        assert_eq!(graded.energy(&a, &0.1), plain.energy(&a, &0.1));
    }
}

/// The formulas of the graded half-space tend to those of the half-space for k → 0, to the first order in k.
#[test]
fn small_gradings_are_close_to_none() {
    for n in [0.2, 0.8, 2.0, 3.0] {
        for control in [Control::Indentation, Control::Force] {
            let [plain, graded] = [0.0, 1e-9].map(|k| contact(n, k).critical(&control).unwrap());
            // ∂ln a/∂k: at most 2 by λ, 3 by κ(n, k), and ln a by the exponent, all over 2n − 1.
            let bound = 1e-9 * (5.0 + plain.contact_radius.ln().abs()) / (2.0 * n - 1.0).abs();
            assert_relative_eq!(graded.contact_radius, plain.contact_radius, max_relative = bound);
            assert_relative_eq!(graded.force, plain.force, max_relative = 2.0 * bound + 1e-8);
        }
    }
}

/// d', F' and dΠ/dd are those of dual numbers, and Π is stationary on the equilibria.
#[test]
fn slopes_and_energy() -> Result<()> {
    for (n, k) in [(2.0, 0.3), (0.2, 0.3), (1.5, -0.6), (3.0, 1.0), (0.7, 0.9)] {
        let plain = contact(n, k);
        let constant = |x: f64| Dual::constant(x);
        let medium = match k {
            1.0 => GradedHalfSpace::winkler(constant(1.0 / std::f64::consts::PI), constant(0.01))?,
            _ => GradedHalfSpace::new(constant(k), constant(1.0), constant(0.01))?,
        };
        let kappa = constant(graded_kappa(&n, &k)?);
        let dual = GradedContact::with_kappa(constant(n), constant(1.0), kappa, medium)?;
        for a in [0.05, 0.4, 3.0] {
            let variable = Dual::variable(a);
            let scale = plain.profile().kappa() * a.powf(n) / a;
            let slope = plain.indentation_slope(&a)?;
            assert!((slope - dual.indentation(&variable)?.slope).abs() < 1e-14 * (scale + 1.0 / a));
            let force_slope = plain.force_slope(&a)?;
            let stiffness = plain.medium().punch_stiffness(&a)?;
            let found = dual.force(&variable)?.slope;
            assert!((force_slope - found).abs() < 1e-13 * stiffness * (scale + 1.0 / a), "{n} {k} {a}");
            let d = plain.indentation(&a)?;
            let by_radius = dual.energy(&variable, &constant(d))?.slope;
            assert!(by_radius.abs() < 1e-13 * stiffness * (scale * a + 1.0).powi(2) / a, "{by_radius}");
            let by_depth = dual.energy(&constant(a), &Dual::variable(d))?.slope;
            assert!((by_depth - plain.force(&a)?).abs() < 1e-13 * stiffness * (scale * a + 1.0));
        }
    }
    Ok(())
}

/// On a machine K d' + F' = 0 at every fold, and between folds D = d + F/K is monotone: a dense scan has as many turns.
#[test]
fn folds_on_a_machine_are_those_of_a_scan() -> Result<()> {
    let mut numbers = std::collections::BTreeSet::new();
    for k in [-0.7, -0.2, 0.3, 0.8, 1.0] {
        let bound = (5.0 - k) / 2.0 - f64::sqrt((1.0 - k) * (3.0 + k));
        let least = (1.0 - k) / 2.0;
        for n in [least + 0.03 * (bound - least), least + 0.4 * (bound - least), bound + 0.05, bound + 1.0] {
            for stiffness in [1e-4, 1e-2, 0.04, 0.1, 0.3, 1.0, 30.0] {
                for c in [0.1, 0.3, 1.0] {
                    let tip = GradedContact::new(n, c, medium(k))?;
                    let folds = match tip.machine_folds(&stiffness) {
                        // Near the threshold a fold may be out of the range of doubles.
                        Err(Error::OutOfRange { .. }) => continue,
                        folds => folds?,
                    };
                    numbers.insert(folds.len());
                    assert!(folds.len() < 2 || n < bound || k == 1.0, "n = {n}, k = {k}");
                    let slope = |a: f64| tip.indentation_slope(&a).unwrap() + tip.force_slope(&a).unwrap() / stiffness;
                    let (mut turns, mut last) = (Vec::new(), None);
                    for step in -6000..=6000 {
                        let a = 10.0_f64.powf(f64::from(step) / 200.0);
                        let rises = slope(a) > 0.0;
                        if last.is_some_and(|last| last != rises) {
                            turns.push((a, if rises { FoldKind::Minimum } else { FoldKind::Maximum }));
                        }
                        last = Some(rises);
                    }
                    let within = folds.iter().filter(|fold| (1e-30..1e30).contains(&fold.contact_radius));
                    let within: Vec<_> = within.map(|fold| (fold.contact_radius, fold.kind)).collect();
                    assert_eq!(within.len(), turns.len(), "n = {n}, k = {k}, K = {stiffness}, C = {c}: {folds:?}");
                    for ((found, kind), (turn, expected)) in within.iter().zip(&turns) {
                        assert_eq!(kind, expected);
                        assert!(*found <= *turn * 1.000_001 && *found >= *turn / 1.013, "{found} {turn}");
                    }
                    for fold in &folds {
                        let a = fold.contact_radius;
                        assert_relative_eq!(fold.indentation, tip.indentation(&a)?, max_relative = 1e-9);
                        assert_relative_eq!(fold.force, tip.force(&a)?, max_relative = 1e-9);
                    }
                }
            }
        }
    }
    assert_eq!(numbers.into_iter().collect::<Vec<_>>(), [0, 1, 2, 3]);
    Ok(())
}

/// At n = (1−k)/2 the equilibria of C at the threshold have d = 0 (or F = 0) at every radius.
#[test]
fn thresholds_of_the_coefficient() -> Result<()> {
    for k in [-0.5, 0.25, 0.5] {
        let n = (1.0 - k) / 2.0;
        for (control, held) in [(Control::Indentation, 0), (Control::Force, 1)] {
            let c = graded_threshold(&medium(k), &control)?;
            let tip = GradedContact::new(n, c, medium(k))?;
            assert_eq!(tip.regime()?, Regime::ScaleFree);
            assert!(matches!(tip.critical(&control), Err(Error::Domain { .. })));
            for a in [0.1, 1.0, 20.0] {
                let zero = [tip.indentation(&a)?, tip.force(&a)? / tip.medium().punch_stiffness(&a)?][held];
                assert!(zero.abs() < 1e-14 * tip.medium().detachment_elongation(&a)?, "{zero}");
            }
        }
    }
    assert!(matches!(graded_threshold(&medium(1.0), &Control::Force), Err(Error::Domain { .. })));
    Ok(())
}

#[test]
fn a_winkler_foundation_is_the_last_graded_half_space() -> Result<()> {
    // κ = 1, g = f; every power law breaks under a dead load, and shrinks to a point at fixed grips.
    assert_eq!(graded_kappa(&0.3, &1.0)?, 1.0);
    let tip = contact(0.1, 1.0);
    assert_eq!(tip.regime()?, Regime::PullOff);
    assert!(matches!(tip.critical(&Control::Indentation), Err(Error::Domain { .. })));
    // d = f(a) − √(2w/K_w), F = K_w π a²(nf/(n+2) − Δl), for C = 1 and K_w = 1/π.
    let (a, elongation) = (0.3_f64, (0.02 * std::f64::consts::PI).sqrt());
    assert_relative_eq!(tip.indentation(&a)?, a.powf(0.1) - elongation, max_relative = 1e-14);
    let expected = a * a * (0.1 * a.powf(0.1) / 2.1 - elongation);
    assert_relative_eq!(tip.force(&a)?, expected, max_relative = 1e-14);
    let load = tip.critical(&Control::Force)?;
    assert!(tip.force_slope(&load.contact_radius)?.abs() < 1e-13 * tip.medium().punch_stiffness(&load.contact_radius)?);
    Ok(())
}

#[test]
fn what_is_outside_of_the_domain_is_refused() {
    for k in [-1.0, 1.0, 2.0, f64::NAN] {
        assert!(matches!(GradedHalfSpace::new(k, 1.0, 1.0), Err(Error::Domain { .. })), "{k}");
    }
    assert!(GradedHalfSpace::new(0.5, 0.0, 1.0).is_err() && GradedHalfSpace::winkler(-1.0, 1.0).is_err());
    assert!(graded_kappa(&0.0, &0.5).is_err() && graded_kappa(&1.0, &-1.0).is_err());
    let tip = contact(2.0, 0.5);
    assert!(tip.indentation(&0.0).is_err() && tip.machine_folds(&0.0).is_err());
    // A radius of 10^−400: out of the range of doubles, with its logarithm.
    let tiny = GradedContact::new(0.36, 1e-4, medium(0.3)).unwrap();
    let big = tiny.critical(&Control::Force);
    assert!(matches!(big, Err(Error::OutOfRange { log10, .. }) if log10 > 300.0), "{big:?}");
    // κ for exponents whose Gamma functions are out of range: κ_n n^{-(1-k)/2} → Γ((1+k)/2) 2^{-(1-k)/2}.
    let kappa = graded_kappa(&1e6, &0.4).unwrap();
    let limit = statrs::function::gamma::gamma(0.7) * 5e5_f64.powf(0.3);
    assert_relative_eq!(kappa, limit, max_relative = 2e-6);
}
