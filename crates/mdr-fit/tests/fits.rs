//! Fits of the published data sets, whose estimates are certified by another program in 60 digits.
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr::prelude::*;
use mdr_fit::{Fit, FitStatus, Observation, Problem};
use serde_json::Value as Json;

/// A data set by its name.
fn set(id: &str) -> Json {
    let sets: Json = serde_json::from_str(include_str!("fits/public.json")).unwrap();
    sets["sets"].as_array().unwrap().iter().find(|set| set["id"] == id).unwrap().clone()
}

fn number(value: &Json) -> f64 {
    value.as_str().unwrap().parse().unwrap()
}

fn numbers(values: &Json) -> Vec<f64> {
    values.as_array().unwrap().iter().map(number).collect()
}

/// The problem of a data set, without start.
fn problem(set: &Json) -> Problem {
    let given = set["generated_with"].as_object().unwrap();
    let shape = Shape::by_name(set["profile"].as_str().unwrap()).unwrap();
    let shape = shape.map(|key, ()| given[key].as_str().unwrap());
    let (_, observation) = Observation::NAMES.into_iter().find(|(name, _)| set["observation"] == *name).unwrap();
    let units = set["units"].as_array().unwrap();
    let column = |key: &str, axis: usize| -> Vec<f64> {
        // Scaling the decimal text is exact.
        let nano = units[axis] == "nm";
        let values = set[key].as_array().unwrap().iter();
        values
            .map(|text| format!("{}{}", text.as_str().unwrap(), if nano { "e-9" } else { "" }).parse().unwrap())
            .collect()
    };
    let mut problem = Problem::new(shape, observation, &column("x", 0), &column("y", 1)).unwrap();
    let free: Vec<&str> = set["free"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    for name in ["stiffness", "contact_point", "baseline"] {
        if let Some(value) = given.get(name).filter(|_| !free.contains(&name)) {
            problem = problem.fixed(name, number(value)).unwrap();
        }
    }
    problem.free(free).unwrap().sigma_x(number(&set["sigma_x"])).unwrap().sigma_y(number(&set["sigma_y"])).unwrap()
}

fn started(set: &Json, start: usize) -> Problem {
    let start = set["starts"][start].as_object().unwrap();
    start.iter().fold(problem(set), |problem, (name, value)| problem.start(name, number(value)).unwrap())
}

fn digits(value: f64, expected: f64) -> f64 {
    -((value - expected).abs() / expected.abs()).max(1e-17).log10()
}

/// Digits of estimates and of standard errors.
fn agreement(set: &Json, fit: &Fit) -> [f64; 2] {
    let certified = &set["certified"];
    let least = |values: Vec<f64>, key: &str| {
        values
            .iter()
            .zip(numbers(&certified[key]))
            .map(|(value, expected)| digits(*value, expected))
            .fold(17.0, f64::min)
    };
    [
        least(fit.parameters.iter().map(|estimate| estimate.value.unwrap()).collect(), "estimate"),
        least(fit.parameters.iter().map(|estimate| estimate.scaled_stderr.unwrap()).collect(), "sd_scaled"),
    ]
}

fn check(id: &str, expected: [f64; 2]) {
    let set = set(id);
    let generated: Vec<i64> = set["labels"].as_array().unwrap().iter().map(|label| label.as_i64().unwrap()).collect();
    for start in 0..2 {
        let fit = started(&set, start).fit().unwrap();
        assert_eq!(fit.status, FitStatus::Fitted, "{id}: {}", fit.reason);
        let found = agreement(&set, &fit);
        assert!(found[0] >= expected[0] && found[1] >= expected[1], "{id} from start {start}: {found:?} digits");
        let labels: Vec<i64> = fit.rows.iter().map(|row| i64::from(row.label)).collect();
        assert_eq!(labels, generated, "{id} from start {start}");
        check_sums(&set, &fit);
    }
}

/// Sums of squares, correlations and the pull-off, beside the certified ones.
fn check_sums(set: &Json, fit: &Fit) {
    let certified = &set["certified"];
    assert_eq!(fit.dof as u64, certified["dof"].as_u64().unwrap());
    // The residuals of noise-free data are rounding.
    let exact = set["id"] == "Rounded1";
    let least = if exact { 2.5 } else { 9.0 };
    assert!(digits(fit.rss, number(&certified["rss"])) > least, "{}: rss {:e}", set["id"], fit.rss);
    for (row, expected) in fit.correlation.iter().zip(certified["correlation"].as_array().unwrap()) {
        for (value, expected) in row.iter().zip(numbers(expected)) {
            assert!((value - expected).abs() < 1e-8, "{}: correlation {value}, {expected}", set["id"]);
        }
    }
    let (Some(pull_off), Some(fold)) = (&fit.predicted_pull_off, certified.get("fold")) else { return };
    let scale = fit.parameters[0].scaled_stderr.unwrap() / fit.parameters[0].stderr.unwrap();
    let stderr = pull_off.stderr.unwrap();
    let found = [pull_off.contact_radius.unwrap(), pull_off.x, pull_off.y];
    for ((value, stderr), key) in
        found.iter().zip([stderr[4], stderr[0], stderr[1]]).zip(["fold_radius", "fold_given", "fold_measured"])
    {
        let expected = numbers(&fold[key]);
        assert!(digits(*value, expected[0]) > 9.0, "{}: {key} {value:e}", set["id"]);
        assert!(
            digits(stderr * scale, expected[1]) > least.min(7.0),
            "{}: error of {key} {:e}",
            set["id"],
            stderr * scale
        );
    }
}

#[test]
fn sphere() {
    check("Sphere1", [10.0, 8.0]);
}

/// A tip of the library has no noise to smooth.
#[test]
fn a_tip_of_the_library_is_not_smoothed() {
    assert!(problem(&set("Sphere1")).fit().unwrap().smoothing.is_empty());
}

#[test]
fn cone_on_a_cantilever() {
    check("Cone1", [10.0, 8.0]);
}

#[test]
fn hyperboloid_with_both_legs() {
    check("Hyper1", [10.0, 8.0]);
}

#[test]
fn wavy_with_two_branches() {
    check("Wavy1", [10.0, 8.0]);
}

#[test]
fn rounded_punch_without_noise() {
    check("Rounded1", [10.0, 3.0]);
}

#[test]
fn sphere_under_a_microscope() {
    check("JKRtest1", [10.0, 8.0]);
}

#[test]
fn beyond_the_fold() {
    check("Beyond1", [6.0, 5.0]);
}

#[test]
fn degenerate_is_refused_with_what_the_data_fix() {
    let set = set("Degenerate1");
    for start in 0..2 {
        let fit = started(&set, start).fit().unwrap();
        assert_eq!(fit.status, FitStatus::Unidentifiable);
        let expected = set["certified"]["invariants"].as_object().unwrap();
        assert_eq!(fit.invariants.len(), expected.len());
        for invariant in &fit.invariants {
            let known = &expected[&invariant.name];
            assert!(digits(invariant.value, number(&known["value"])) > 10.0);
            assert!(digits(invariant.scaled_stderr, number(&known["stderr"])) > 8.0);
        }
        assert!(fit.parameters.iter().all(|estimate| estimate.value.is_none() && estimate.stderr.is_none()));
    }
}

/// Digits of another program, proved here: estimates, standard errors and sums of squares.
/// Deflection on a cantilever determines neither the scale of forces nor that of lateral lengths. No force is reported then, and
/// steps of the iteration that leave the range of numbers do not end it.
#[test]
fn two_scales_that_a_cantilever_does_not_tell() {
    let mut set = set("Hyper1");
    let scales = ["e_star", "work_of_adhesion", "stiffness", "slope", "lateral"];
    for offsets in [&[][..], &["contact_point", "baseline"]] {
        set["free"] = [&scales[..], offsets].concat().into();
        let fit = problem(&set).fixed("stiffness", 0.4).unwrap().fit().unwrap();
        assert_eq!(fit.status, FitStatus::Unidentifiable, "{offsets:?}: {}", fit.reason);
        let (predicted, measured) = (fit.predicted_pull_off.unwrap(), fit.measured_pull_off.unwrap());
        assert_eq!([predicted.force, measured.force, predicted.contact_radius], [None; 3], "{offsets:?}");
        if offsets.is_empty() {
            let names: Vec<&str> = fit.invariants.iter().map(|invariant| invariant.name.as_str()).collect();
            let lengths = "work_of_adhesion * stiffness^(-1) * lateral^2";
            assert_eq!(names, ["e_star * stiffness^(-1) * lateral", lengths, "slope * lateral"]);
        }
    }
}

#[test]
#[cfg(feature = "mp")]
fn certified_digits_are_those_of_another_program() {
    for (id, digits) in [("Sphere1", 17), ("Rounded1", 17), ("JKRtest1", 17), ("Cone1", 15), ("Beyond1", 17)] {
        let set = set(id);
        let fit = problem(&set).digits(digits).fit().unwrap();
        let certified = fit.certified.unwrap_or_else(|| panic!("{id}: {:?}", fit.warnings));
        let pairs = |key: &str, found: Vec<f64>| {
            for (found, expected) in found.iter().zip(numbers(&set["certified"][key])) {
                assert!(self::digits(*found, expected) > 14.5, "{id} {key}: {found:e}, {expected:e}");
            }
        };
        pairs("estimate", certified.parameters.iter().map(|estimate| estimate.value.to_f64()).collect());
        pairs("sd_scaled", certified.parameters.iter().map(|estimate| estimate.scaled_stderr.to_f64()).collect());
        assert!(certified.local_minimum, "{id}");
        assert!(self::digits(certified.rss.to_f64(), number(&set["certified"]["rss"])) > 14.5, "{id}");
    }
}

/// An end of an interval is where the sum of squares, fitted anew with the number given, has risen by the quantile of χ².
#[test]
fn intervals_end_where_the_sum_of_squares_has_risen() {
    for id in ["JKRtest1", "Cone1"] {
        let set = set(id);
        let fit = problem(&set).profile_likelihood().fit().unwrap();
        assert_eq!(fit.intervals.len(), 2 * fit.parameters.len(), "{id}: {:?}", fit.warnings);
        for interval in &fit.intervals {
            let quantile = if interval.level == 0.68 { 0.994_457_883_209_753_1 } else { 1.959_963_984_540_054 };
            let mut others = set.clone();
            others["free"].as_array_mut().unwrap().retain(|name| *name != interval.name);
            let estimate = fit.estimate(&interval.name).unwrap();
            for end in [interval.lower, interval.upper].map(Option::unwrap) {
                let given = problem(&others).fixed(&interval.name, end).unwrap().fit().unwrap();
                let risen = given.chi2.unwrap() - fit.chi2.unwrap();
                assert!((risen / (quantile * quantile) - 1.0).abs() < 1e-4, "{id} {interval:?}: χ² rises by {risen}");
                // The models are nearly linear within these errors.
                let length = (end - estimate.value.unwrap()).abs() / (quantile * estimate.stderr.unwrap());
                assert!((length - 1.0).abs() < 0.1, "{id} {interval:?}: {length} standard errors");
            }
        }
    }
}
