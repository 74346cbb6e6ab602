//! Rows of values.

use mdr_analytic::double;
use mdr_analytic::double::grid::{BatchReport, InstructionSet};
use mdr_analytic::double::{BranchSlices, InverseBatch};
use mdr_core::contact::{Control, Error, Material, Quantity, Ranged, Stability, Status};
use rug::Float;

use super::bisection::{Scene, Truth};
use crate::common::mpfr::ulps;

/// The results of [`double::Inverse::branches`]: a and d or F of the smaller and of the larger equilibrium.
pub(crate) struct Many {
    sides: [[Vec<f64>; 2]; 2],
    status: Vec<Status>,
    tally: BatchReport,
}

impl Many {
    pub(crate) fn of(inverse: &double::Inverse, values: &[f64]) -> Self {
        let new = || vec![0.0; values.len()];
        let mut sides = [[new(), new()], [new(), new()]];
        let mut status = vec![Status::Undecided; values.len()];
        let [[a0, x0], [a1, x1]] = &mut sides;
        let mut found = InverseBatch {
            smaller: BranchSlices { contact_radius: a0, uncontrolled: x0 },
            larger: BranchSlices { contact_radius: a1, uncontrolled: x1 },
            status: &mut status,
        };
        let tally = inverse.branches(values, &mut found).unwrap();
        let many = Many { sides, status, tally };
        many.check_stable(inverse, values);
        many
    }

    /// [`double::Inverse::stable`] has the numbers of the stable branch; where a value was passed on because of the other branch,
    /// within an ulp.
    #[track_caller]
    fn check_stable(&self, inverse: &double::Inverse, values: &[f64]) {
        let [mut a, mut x] = [(); 2].map(|()| vec![0.0; values.len()]);
        let mut status = vec![Status::Undecided; values.len()];
        let mut found = BranchSlices { contact_radius: &mut a, uncontrolled: &mut x };
        let report = inverse.stable(values, &mut found, &mut status).unwrap();
        assert!(report.passed_on <= self.tally.passed_on);
        for (i, value) in values.iter().enumerate() {
            let Ok(states) = inverse.equilibria(*value) else {
                assert!(a[i].is_nan() && status[i] == self.status[i], "{:?} at {value:e}", status[i]);
                continue;
            };
            let states = states.as_slice();
            let stable = states.iter().position(|state| state.stability != Stability::Unstable);
            let Some(place) = stable else {
                assert!(a[i].is_nan() && x[i].is_nan() && status[i] == Status::NoEquilibrium, "at {value:e}");
                continue;
            };
            let side = &self.sides[if states.len() == 2 { place } else { 1 }];
            for (found, expected) in [(a[i], side[0][i]), (x[i], side[1][i])] {
                let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
                let close = (found - expected).abs() <= f64::EPSILON * expected.abs();
                assert!(same || (self.tally.passed_on > 0 && close), "{found:e} {expected:e} at {value:e}");
            }
            assert!(status[i] == self.status[i] || (states.len() == 2 && !a[i].is_nan() && !x[i].is_nan()));
        }
    }

    fn at(&self, i: usize) -> [f64; 4] {
        let [smaller, larger] = &self.sides;
        [smaller[0][i], smaller[1][i], larger[0][i], larger[1][i]]
    }
}

/// Result i of many against bisection: every value within an ulp, and the others NaN.
#[track_caller]
pub(crate) fn check_many(many: &Many, i: usize, truth: &Truth, value: f64, radii: &[Float]) {
    let by_force = truth.scene.by_force;
    let expected = |ln_a: &Float| [ln_a.clone().exp(), truth.state(ln_a)[usize::from(!by_force)].clone()];
    let (smaller, larger) = match radii {
        [] => (None, None),
        [only] => (None, Some(expected(only))),
        [smaller, larger] => (Some(expected(smaller)), Some(expected(larger))),
        _ => panic!("more than two"),
    };
    let mut status = if larger.is_some() { Status::Ok } else { Status::NoEquilibrium };
    let exact = [smaller, larger].map(|side| side.map_or([None, None], |side| side.map(Some)));
    for (found, exact) in many.at(i).into_iter().zip(exact.iter().flatten()) {
        match exact {
            Some(exact) if found.is_nan() => {
                let log10 = exact.clone().abs().log10().to_f64();
                assert!(log10.abs() > 307.0, "{log10}: {:?} at {value:e}", truth.scene);
                let beyond = if log10 > 0.0 { Status::Overflow } else { Status::Underflow };
                status = if status == Status::Ok { beyond } else { status };
            }
            Some(exact) => {
                let ulps = ulps(found, exact);
                assert!(
                    ulps <= 1.0 && (found != 0.0 || exact.is_zero()),
                    "{found:e} is {ulps} ulp off: {:?} at {value:e}",
                    truth.scene
                );
            }
            None => assert!(found.is_nan(), "{found:e}: {:?} at {value:e}", truth.scene),
        }
    }
    assert_eq!(many.status[i], status, "{:?} at {value:e}", truth.scene);
}

/// From close to the fold to far on both sides of zero, and where there is no equilibrium.
fn values(at_fold: f64, count: usize) -> Vec<f64> {
    let share = |i: usize| (i as f64 + 0.5) / count as f64;
    let near = (0..count).map(|i| 1.0 - 10f64.powf(-7.0 * share(i)));
    let towards_zero = (0..count).map(|i| 10f64.powf(-9.0 * share(i)));
    let far = (0..count).map(|i| -10f64.powf(18.0 * share(i) - 9.0));
    near.chain(towards_zero).chain(far).chain([0.0, 1.0 + 1e-7, 2.0, 1e6]).map(|z| at_fold * z).collect()
}

/// Rows of values against bisection, most of them without extended precision: all of them far from n = 1/2.
#[test]
fn many_values_of_one_contact() {
    let ordinary = [0.1, 0.25, 0.3, 0.45, 0.75, 1.0, 1.7, 2.0, 4.0].map(|n| (n, 0));
    for (n, passed_on) in ordinary.into_iter().chain([(30.0, 6), (0.49, 3), (0.51, 3), (0.52, 2)]) {
        for by_force in [false, true] {
            let scene = Scene::with_fold(n, 1e-6, 1e6, 0.05, by_force);
            let truth = scene.truth();
            let values = values(truth.at_fold(), 12);
            let radii: Vec<_> = values.iter().map(|&value| truth.equilibria(value)).collect();
            for path in InstructionSet::available() {
                let many = Many::of(&scene.inverse().with_instructions(path), &values);
                for (i, radii) in radii.iter().enumerate() {
                    check_many(&many, i, &truth, values[i], radii);
                }
                assert_eq!(many.tally.without_value, 3);
                assert!(many.tally.passed_on <= passed_on, "{:?}: {scene:?} by {path}", many.tally);
            }
        }
    }
}

/// The result at a value is independent of its position and of the vector width.
#[test]
fn place_and_width_do_not_matter() {
    for (n, by_force) in [(0.3, false), (1.05, true), (2.0, false)] {
        let scene = Scene::with_fold(n, 1e-6, 1e6, 0.05, by_force);
        let values = values(scene.truth().at_fold(), 60);
        let bits = |many: &Many, i: usize| many.at(i).map(f64::to_bits);
        for path in InstructionSet::available() {
            let inverse = scene.inverse().with_instructions(path);
            let whole = Many::of(&inverse, &values);
            for start in [1, 37, 64] {
                let part = Many::of(&inverse, &values[start..]);
                assert!((start..values.len()).all(|i| bits(&part, i - start) == bits(&whole, i)), "{start} by {path}");
            }
            // One by one, with the same constants, which have been computed by now.
            for (i, &value) in values.iter().enumerate() {
                let found = inverse.equilibria(value).unwrap();
                for (state, side) in found.as_slice().iter().rev().zip(whole.sides.iter().rev()) {
                    assert_eq!(state.contact_radius, Ranged::Value(side[0][i]));
                    assert_eq!(if by_force { state.indentation } else { state.force }, Ranged::Value(side[1][i]));
                }
            }
        }
        if let (Some(four), Some(eight)) = (InstructionSet::avx2(), InstructionSet::avx512()) {
            let [four, eight] = [four, eight].map(|path| Many::of(&scene.inverse().with_instructions(path), &values));
            assert!((0..values.len()).all(|i| bits(&four, i) == bits(&eight, i)));
        }
    }
}

#[test]
fn what_many_values_may_be() {
    // A cone with w = E* = C = 1 has d_c = −1 exactly, and the double root there is a_c = 2/π.
    let unit = Material::new(1.0, 1.0).unwrap();
    let cone = double::Inverse::new(1.0, 1.0, &unit, &Control::Indentation).unwrap();
    let many = Many::of(&cone, &[-1.0, f64::NAN, f64::NEG_INFINITY, -1.5, 1e308, -1e-200]);
    let expected = [
        Status::Fold,
        Status::DomainError,
        Status::DomainError,
        Status::NoEquilibrium,
        Status::Overflow,
        Status::Underflow,
    ];
    assert_eq!(many.status, expected);
    assert_eq!([many.at(0)[0], many.at(0)[2]], [std::f64::consts::FRAC_2_PI; 2]);
    assert_eq!(many.at(0)[1], many.at(0)[3]);
    assert!((1..4).all(|i| many.at(i).iter().all(|x| x.is_nan())));
    // F is out of range and a is not; for the smaller state a underflows, for the larger one both are values.
    assert!(many.at(4)[2] > 1e307 && many.at(4)[3].is_nan());
    assert!(many.at(5)[0].is_nan() && many.at(5)[2] > 0.1 && many.at(5)[3] < 0.0);
    assert_eq!(many.tally, BatchReport { passed_on: 5, without_value: 5 });
    // n = 1/2 has at most one equilibrium, which counts as the larger.
    let threshold = mdr_analytic::threshold(&unit, &Control::Indentation).unwrap();
    let above = double::Inverse::new(0.5, 2.0 * threshold, &unit, &Control::Indentation).unwrap();
    let many = Many::of(&above, &[-1.0, 1.0]);
    assert_eq!(many.status, [Status::NoEquilibrium, Status::Ok]);
    assert!(many.at(1)[0].is_nan() && many.at(1)[2] > 0.0);
}

#[test]
fn slices_of_different_lengths_are_refused() {
    let unit = Material::new(1.0, 1.0).unwrap();
    let ball = double::Inverse::new(2.0, 0.5, &unit, &Control::Force).unwrap();
    let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::ContactRadius, Quantity::Indentation];
    for (wrong, quantity) in quantities.into_iter().chain([Quantity::Parameter("the status")]).enumerate() {
        let len = |i: usize| if i == wrong { 8 } else { 9 };
        let ([mut a0, mut x0, mut a1, mut x1], mut status) = ([[0.0; 9]; 4], [Status::Ok; 9]);
        let mut found = InverseBatch {
            smaller: BranchSlices { contact_radius: &mut a0[..len(0)], uncontrolled: &mut x0[..len(1)] },
            larger: BranchSlices { contact_radius: &mut a1[..len(2)], uncontrolled: &mut x1[..len(3)] },
            status: &mut status[..len(4)],
        };
        assert_eq!(ball.branches(&[0.0; 9], &mut found), Err(Error::Length { quantity, len: 8, expected: 9 }));
    }
}
