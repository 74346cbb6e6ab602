//! Closed forms in f64 at the ends of its range: a number where the result is one, else an error with its log10.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use mdr_analytic::{
    PowerLaw, PowerLawContact, ScaleFreeOutcome, detachment_elongation, double, threshold, universal_force,
    universal_indentation,
};
use mdr_core::contact::{Control, Equilibrium, Error, Material, Ranged, Result, Transform};

use crate::common::contact;

/// Against the double nearest to the true value, or its log10. A formula is a few dozen roundings; the exponent
/// 2/|2n−1| ≤ 5 of a length scale is rounded to half an ε of itself, which a magnitude of |ln x| ≤ 710 turns into 1775
/// ε, and a force or an energy squares that.
fn assert_same(what: &str, found: Result<f64>, expected: Ranged<f64>) {
    let (found, expected) = match (found, expected) {
        (Ok(found), Ranged::Value(expected)) => (found, expected),
        (
            Err(Error::OutOfRange { log10, .. }),
            Ranged::Overflow { log10: expected } | Ranged::Underflow { log10: expected },
        ) => (log10, expected),
        (found, expected) => panic!("{what}: {found:?}, expected {expected:?}"),
    };
    assert!(
        (found - expected).abs() <= 3650.0 * f64::EPSILON * expected.abs() + 1e-323,
        "{what}: {found}, expected {expected}"
    );
}

/// Powers of ten from one end of the range to the other.
const SCALES: [f64; 9] = [1e-305, 1e-200, 1e-150, 1e-60, 1.0, 1e60, 1e150, 1e200, 1e305];

#[test]
fn every_scale_is_a_number_or_said() {
    for e in SCALES {
        for w in SCALES {
            let material = Material::new(e, w).unwrap();
            for control in [Control::Indentation, Control::Force] {
                let expected = double::threshold(&material, &control).unwrap();
                assert_same(&format!("threshold {e:e} {w:e}"), threshold(&material, &control), expected);
            }
            for c in SCALES {
                let half = contact(0.5, c, e, w);
                let what = format!("E* = {e:e}, w = {w:e}, C = {c:e}");
                assert_same(&what, half.ratio(), double::ratio(c, &material).unwrap());
                let fate: ScaleFreeOutcome = half.fate(&Control::Indentation).unwrap();
                assert_eq!(fate, double::fate(c, &material, &Control::Indentation).unwrap(), "{what}");
                for n in [0.3, 2.0, 7.0] {
                    let any = contact(n, c, e, w);
                    let what = format!("n = {n}, {what}");
                    if n > 0.5 {
                        let lost = double::energy_lost_at_pull_off(n, c, &material).unwrap();
                        assert_same(&format!("energy lost, {what}"), any.energy_lost_at_pull_off(), lost);
                    }
                    for control in [Control::Indentation, Control::Force] {
                        let expected = double::critical(n, c, &material, &control).unwrap();
                        let expected = [expected.contact_radius, expected.indentation, expected.force];
                        match any.critical(&control) {
                            Ok(state) => {
                                let found = [state.contact_radius, state.indentation, state.force];
                                for (found, expected) in found.into_iter().zip(expected) {
                                    assert_same(&what, Ok(found), expected);
                                }
                            }
                            Err(error) => {
                                let first = expected.into_iter().find(|value| !matches!(value, Ranged::Value(_)));
                                assert_same(&what, Err(error), first.expect(&what));
                            }
                        }
                    }
                }
            }
            for a in SCALES {
                let what = format!("E* = {e:e}, w = {w:e}, a = {a:e}");
                let expected = double::detachment_elongation(&material, a).unwrap();
                assert_same(&what, detachment_elongation(&material, &a), expected);
            }
        }
    }
}

/// Away from zeros, where f64 and the double nearest to the truth differ by more than roundings.
#[test]
fn every_radius_is_a_number_or_said() {
    for (n, c, e, w) in
        [(2.0, 0.5, 1e300, 1e-20), (0.3, 1e-200, 1e-100, 1e200), (7.0, 1e305, 1e200, 1e-305), (1.0, 1.0, 1e200, 1e200)]
    {
        let (contact, material) = (contact(n, c, e, w), Material::new(e, w).unwrap());
        for a in SCALES {
            let what = |name: &str| format!("{name}: n = {n}, C = {c:e}, E* = {e:e}, w = {w:e}, a = {a:e}");
            assert_same(&what("g"), contact.profile().g(&a), double::g(n, c, a).unwrap());
            assert_same(&what("d"), contact.indentation(&a), double::indentation(n, c, &material, a).unwrap());
            assert_same(&what("F"), contact.force(&a), double::force(n, c, &material, a).unwrap());
            let slope = double::indentation_slope(n, c, &material, a).unwrap();
            assert_same(&what("d'"), contact.indentation_slope(&a), slope);
            assert_same(&what("F'"), contact.force_slope(&a), double::force_slope(n, c, &material, a).unwrap());
            for d in [-1e-170, 0.0, 1e-300, 3.0, 1e170] {
                let energy = double::energy(n, c, &material, a, d).unwrap();
                assert_same(&what(&format!("energy at {d:e}")), contact.energy(&a, &d), energy);
            }
        }
    }
    for n in [0.01, 0.4, 2.0, 100.0, 1e5] {
        for a in [1e-305, 1e-100, 0.3, 7.0, 1e100, 1e305] {
            let what = format!("n = {n}, a = {a:e} a_c");
            assert_same(&what, universal_indentation(&n, &a), double::universal_indentation(n, a).unwrap());
            assert_same(&what, universal_force(&n, &a), double::universal_force(n, a).unwrap());
        }
    }
}

#[test]
fn what_is_no_number_is_refused() {
    let contact = contact(2.0, 0.5, 1.0, 1.0);
    assert!(matches!(contact.energy(&1.0, &f64::NAN), Err(Error::Domain { .. })));
    for a in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        assert!(contact.energy(&a, &1.0).is_err() && contact.indentation_slope(&a).is_err(), "{a}");
    }
    assert!(matches!(PowerLaw::paraboloid(1e-310), Err(Error::OutOfRange { log10, .. }) if log10 > 308.0));
    // d = 0 of a scale-free state at its threshold, F = 0 at three times that, are results.
    assert_eq!(contact.critical(&Control::Force).unwrap().force.signum(), -1.0);
}

/// The equilibria at half of the controlled value of the fold, at 10^-60 of it, and at the same on the other side of
/// zero.
#[test]
fn every_equilibrium_is_a_number_or_said() {
    for e in SCALES {
        for w in SCALES {
            let material = Material::new(e, w).unwrap();
            for (n, c) in [0.3, 0.5, 1.0, 2.0, 7.0].into_iter().flat_map(|n| SCALES.map(|c| (n, c))) {
                for control in [Control::Indentation, Control::Force] {
                    let values = held_values(n, c, &material, &control);
                    values.into_iter().for_each(|value| check_equilibria(&contact(n, c, e, w), &control, value));
                }
            }
        }
    }
}

/// Normal numbers. If d(a) and F(a) underflow in f64 they do not determine the radius.
fn held_values(n: f64, c: f64, material: &Material<f64>, control: &Control<f64>) -> Vec<f64> {
    if n == 0.5 {
        return SCALES.into_iter().flat_map(|x| [x, -x]).collect();
    }
    let fold = double::critical(n, c, material, control).unwrap();
    let at_fold = if matches!(control, Control::Force) { fold.force } else { fold.indentation };
    match at_fold {
        Ranged::Value(at_fold) if at_fold.is_normal() => {
            let shares = [0.5, 0.0, -1.0, 1e-60, -1e-60, -1e60];
            shares.into_iter().map(|share| share * at_fold).filter(|x| x.is_normal() || *x == 0.0).collect()
        }
        _ => vec![],
    }
}

fn check_equilibria(contact: &PowerLawContact<f64>, control: &Control<f64>, value: f64) {
    let (profile, material) = (contact.profile(), contact.material());
    let what = format!("{contact:?}, {control:?} of {value:e}");
    let expected = double::equilibria(*profile.exponent(), *profile.coefficient(), material, control, value).unwrap();
    let numbers = |state: &Equilibrium<Ranged<f64>>| [state.contact_radius, state.indentation, state.force];
    match contact.equilibria(control, &value) {
        Ok(found) => {
            assert_eq!(found.as_slice().len(), expected.as_slice().len(), "{what}");
            for (found, expected) in found.as_slice().iter().zip(expected.as_slice()) {
                assert_eq!(found.stability, expected.stability, "{what}");
                // Results from a subnormal radius have no more digits than the radius.
                let known = if found.contact_radius.is_normal() { 3 } else { 1 };
                let found = [found.contact_radius, found.indentation, found.force];
                for (found, expected) in found.into_iter().zip(numbers(expected)).take(known) {
                    assert_same(&what, Ok(found), expected);
                }
            }
        }
        // The step of Newton's method needs d'(a) or F'(a), and at F = 0 the terms of F.
        Err(Error::OutOfRange { log10, .. }) => {
            let beyond = |a: &f64| {
                let elongation = contact.detachment_elongation(a).unwrap_or(0.0);
                let terms = match control {
                    Control::Force => {
                        [material.effective_modulus() * a * elongation, contact.force_slope(a).unwrap_or(0.0)]
                    }
                    _ => [elongation, contact.indentation_slope(a).unwrap_or(0.0)],
                };
                !terms.into_iter().all(f64::is_normal)
            };
            let excused = expected.as_slice().iter().any(|state| match numbers(state) {
                [Ranged::Value(a), Ranged::Value(_), Ranged::Value(_)] => beyond(&a),
                _ => true,
            });
            assert!(excused && log10.abs() > 307.0, "{what}: 10^{log10}, expected {expected:?}");
        }
        Err(error) => panic!("{what}: {error}, expected {expected:?}"),
    }
}
