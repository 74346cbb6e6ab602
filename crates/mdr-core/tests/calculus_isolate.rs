//! All sign changes on a range: given zeros at any distance and scale, double zeros, an exhausted budget.

use mdr_core::calculus::isolate::{Behaviour, Isolation, isolate};
use mdr_core::calculus::roots::{bisect, bracket_geometric, refine};
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::{Error, Result};
use proptest::prelude::*;

/// Π (x − r)/(x + r): every factor has its exact sign.
fn product(roots: &[f64], x: f64) -> Result<f64> {
    Ok(roots.iter().map(|root| (x - root) / (x + root)).product())
}

/// Each root in its own bracket, in order.
fn assert_found(found: &Isolation<f64>, roots: &[f64]) {
    assert_eq!(found.brackets.len(), roots.len(), "{found:?}");
    for (bracket, root) in found.brackets.iter().zip(roots) {
        assert!(bracket.lower.x <= *root && *root <= bracket.upper.x, "{root} not in {bracket:?}");
    }
}

/// x² − 3x + 2 = (x−1)(x−2) is monotone on either side of 3/2.
fn parabola(lower: &f64, upper: &f64) -> Result<Behaviour> {
    Ok(if *upper < 1.5 || *lower > 1.5 { Behaviour::Monotone } else { Behaviour::Unknown })
}

#[test]
fn a_theorem_makes_it_complete() {
    let f = |x: &f64| Ok((x - 1.0) * (x - 2.0));
    let nonzero_at_the_vertex = |lower: &f64, upper: &f64| {
        let inside = *lower > 1.1 && *upper < 1.9;
        if inside { Ok(Behaviour::Nonzero) } else { parabola(lower, upper) }
    };
    let found = isolate(&1e-9, &1e9, 1000, f, nonzero_at_the_vertex).unwrap();
    assert_found(&found, &[1.0, 2.0]);
    assert!(found.undecided.is_empty());
    // Without the bound at the vertex one cell stays undecided, which the result reports.
    let open = isolate(&1e-9, &1e9, 1000, f, parabola).unwrap();
    assert_found(&open, &[1.0, 2.0]);
    assert!(open.undecided.len() == 1);
}

#[test]
fn impossible_ranges_are_refused() {
    for (lower, upper) in [(0.0, 1.0), (-1.0, 1.0), (2.0, 1.0), (1.0, f64::INFINITY), (f64::NAN, 1.0)] {
        assert!(isolate(&lower, &upper, 100, |&x| Ok(x), |_, _| Ok(Behaviour::Unknown)).is_err());
    }
}

/// A test from given roots: without a root a cell is free of zeros, with one in it the sign changes.
fn known(roots: &[f64]) -> impl Fn(&f64, &f64) -> Result<Behaviour> + '_ {
    |lower, upper| {
        Ok(match roots.iter().filter(|root| *lower <= **root && **root <= *upper).count() {
            0 => Behaviour::Nonzero,
            1 => Behaviour::Monotone,
            _ => Behaviour::Unknown,
        })
    }
}

#[test]
fn an_exhausted_budget_is_reported() {
    let roots: Vec<f64> = (1..=1000).map(|k| f64::from(k) / 100.0).collect();
    let found = isolate(&1e-3, &1e3, 100, |&x| product(&roots, x), known(&roots)).unwrap();
    assert!(!found.undecided.is_empty() && found.evaluations < 120);
}

/// Where counted work is spent, all zeros below are there, and what was not looked at is undecided.
#[test]
fn spent_work_leaves_what_was_found() {
    let roots: Vec<f64> = (1..=1000).map(|k| f64::from(k) / 100.0).collect();
    let mut left = 3000;
    let test = |lower: &f64, upper: &f64| {
        left -= 1;
        if left < 0 { Err(Error::BudgetSpent { evaluations: 3000 }) } else { known(&roots)(lower, upper) }
    };
    let found = isolate(&1e-3, &1e3, 100_000, |&x| product(&roots, x), test).unwrap();
    assert!(found.is_spent);
    let from = found.undecided[0].0;
    let below = roots.iter().filter(|root| **root < from).count();
    assert!(below > 100 && below < 1000, "{below}");
    assert_found(&Isolation { brackets: found.brackets[..below].to_vec(), ..found.clone() }, &roots[..below]);
    let is_known = |root: &f64| {
        found.brackets.iter().any(|bracket| bracket.lower.x <= *root && *root <= bracket.upper.x)
            || found.undecided.iter().any(|(lower, upper)| lower <= root && root <= upper)
    };
    assert!(roots.iter().all(is_known));
}

proptest! {
    #[test]
    fn planted_roots_are_found(logs in prop::collection::btree_set(-200_000..200_000i32, 1..8)) {
        // Distinct roots e^(k/1000): never closer than one part in 10³.
        let roots: Vec<f64> = logs.iter().map(|&k| (f64::from(k) / 1000.0).exp()).collect();
        let found = isolate(&1e-100, &1e100, 100_000, |&x| product(&roots, x), known(&roots)).unwrap();
        assert_found(&found, &roots);
    }

    #[test]
    fn powers_of_two_change_no_bit(k in -400..400i32, target in 1.0..2.0f64) {
        let scale = 2f64.powi(k);
        let f = move |scale: f64| move |x: &f64| { let y = x / scale; Ok(y * y.sqrt() - target * y.ln_1p() - 0.1) };
        let bracket = |scale: f64| bracket_geometric(&(3.0 * scale), f(scale)).unwrap().unwrap();
        let (a, b) = (bracket(1.0), bracket(scale));
        prop_assert_eq!((a.lower.x * scale, a.upper.x * scale), (b.lower.x, b.upper.x));
        let tolerance = roundoff_tolerance(&1.0);
        let roots = (refine(a.clone(), &tolerance, f(1.0)).unwrap(), refine(b.clone(), &tolerance, f(scale)).unwrap());
        prop_assert_eq!((roots.0.value * scale, roots.0.evaluations), (roots.1.value, roots.1.evaluations));
        let roots = (bisect(a, &0.0, f(1.0)).unwrap(), bisect(b, &0.0, f(scale)).unwrap());
        prop_assert_eq!(roots.0.value * scale, roots.1.value);
    }
}

/// With one generic function, intervals are the test.
#[cfg(feature = "mp")]
mod proved_by_intervals {
    use super::*;
    use mdr_core::number::{Dual, Interval, Precision, Real};
    use rug::Float;

    /// (1 − 10⁻⁹/x)(x − 1)(x − 1001/1000), times a second (x − 1) for a double zero.
    fn triple<R: Real>(x: &R, double: bool) -> R {
        let one = x.lit(1);
        let near = x.clone() - &one;
        let value = (one - x.ratio(1, 1_000_000_000) / x) * &near * (x.clone() - x.ratio(1001, 1000));
        if double { value * near } else { value }
    }

    fn behaviour(lower: &Float, upper: &Float, double: bool) -> Behaviour {
        let x = Dual::variable(Interval::new(lower.clone(), upper.clone()));
        let Dual { value, slope } = triple(&x, double);
        match (value.contains_zero(), slope.contains_zero()) {
            (false, _) => Behaviour::Nonzero,
            (_, false) => Behaviour::Monotone,
            _ => Behaviour::Unknown,
        }
    }

    fn found(double: bool) -> Isolation<Float> {
        let [lower, upper] = [-40, 10].map(|k| Float::with_val(Precision::new(80).bits(), 2).powi(k));
        isolate(&lower, &upper, 20_000, |x| Ok(triple(x, double)), |a, b| Ok(behaviour(a, b, double)))
            .expect("a finite function")
    }

    #[test]
    fn all_simple_zeros() {
        let isolation = found(false);
        assert!(isolation.undecided.is_empty() && isolation.brackets.len() == 3, "{isolation:?}");
        for (bracket, root) in isolation.brackets.iter().zip([1e-9, 1.0, 1.001]) {
            assert!(bracket.lower.x < root * 1.000_000_1 && bracket.upper.x > root * 0.999_999_9);
        }
    }

    #[test]
    fn a_double_zero_is_no_proof() {
        let isolation = found(true);
        assert!(!isolation.undecided.is_empty() && isolation.brackets.len() == 2, "{isolation:?}");
        assert!(isolation.undecided.iter().any(|(lower, upper)| *lower <= 1 && *upper >= 1));
    }
}

/// Where a function is not known, cells are left undecided, and those beside them are not.
#[test]
fn what_is_not_proved_is_left_and_the_rest_is_found() {
    let hole = 1.2..1.3;
    let roots = [0.5, 1.0, 2.0, 7.0];
    let f = |x: &f64| {
        let unproved = || Error::Unproved {
            quantity: mdr_core::contact::Quantity::Integrand,
            from: x.to_string(),
            to: x.to_string(),
            remedy: "nothing is known of a hole",
        };
        if hole.contains(x) { Err(unproved()) } else { product(&roots, *x) }
    };
    let outside = known(&roots);
    let test = |lower: &f64, upper: &f64| {
        let meets = *lower < hole.end && *upper > hole.start;
        if meets { Ok(Behaviour::Unknown) } else { outside(lower, upper) }
    };
    let found = isolate(&0.1, &10.0, 1000, f, test).unwrap();
    assert_found(&found, &roots);
    let [(from, to)] = found.undecided[..] else { panic!("{found:?}") };
    assert!(from <= hole.start && from > 1.1 && to >= hole.end && to < 1.4, "{from} to {to}");
}
