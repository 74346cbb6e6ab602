//! Fits of the published data sets, whose estimates are certified by another program in 60 digits.
#![cfg(feature = "fit")]

use mdr::fit::{Fit, FitStatus, Leg, Observation, Problem};
use mdr::prelude::*;
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
        values.map(|text| format!("{}{}", text.as_str().unwrap(), if nano { "e-9" } else { "" }).parse().unwrap()).collect()
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
        values.iter().zip(numbers(&certified[key])).map(|(value, expected)| digits(*value, expected)).fold(17.0, f64::min)
    };
    [
        least(fit.parameters.iter().map(|estimate| estimate.value.unwrap()).collect(), "estimate"),
        least(fit.parameters.iter().map(|estimate| estimate.scaled_stderr.unwrap()).collect(), "sd_scaled"),
    ]
}

fn check(id: &str, expected: [f64; 2]) {
    let set = set(id);
    for start in 0..2 {
        let fit = started(&set, start).fit().unwrap();
        let found = agreement(&set, &fit);
        println!("{id} start {start}: {found:.1?} digits, {} evaluations, {:?}, {:?}", fit.evaluations, fit.status, fit.warnings);
        println!("   {:?} rss {:e}", fit.parameters.iter().map(|e| (e.value.unwrap_or(0.0), e.scaled_stderr.unwrap_or(0.0))).collect::<Vec<_>>(), fit.rss);
        assert_eq!(fit.status, FitStatus::Fitted, "{id}: {}", fit.reason);
        assert!(found[0] >= expected[0] && found[1] >= expected[1], "{id} from start {start}: {found:?} digits");
        let labels: Vec<i64> = fit.rows.iter().map(|row| i64::from(row.label)).collect();
        let generated: Vec<i64> = set["labels"].as_array().unwrap().iter().map(|label| label.as_i64().unwrap()).collect();
        let others = labels.iter().zip(&generated).filter(|(one, other)| one != other).count();
        println!("   {others} labels differ");
    }
}

#[test]
fn sphere() {
    check("Sphere1", [10.0, 8.0]);
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
        println!("{:?} {} {:?} {:?}", fit.status, fit.reason, fit.invariants, fit.singular_values);
        assert_eq!(fit.status, FitStatus::Unidentifiable);
        let expected = set["certified"]["invariants"].as_object().unwrap();
        assert_eq!(fit.invariants.len(), expected.len());
        for invariant in &fit.invariants {
            let known = &expected[&invariant.name];
            assert!(digits(invariant.value, number(&known["value"])) > 10.0);
            assert!(digits(invariant.scaled_stderr, number(&known["stderr"])) > 8.0);
        }
        assert!(fit.parameters.iter().all(|estimate| estimate.value.is_none() && estimate.stderr.is_none()));
        let _ = Leg::Retract;
    }
}
