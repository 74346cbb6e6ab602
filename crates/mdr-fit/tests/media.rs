//! Fits on other media than the half-space, to curves of closed forms that are written out here.

use std::f64::consts::PI;

use mdr::prelude::*;
use mdr_fit::{Fit, Observation, Problem};

const BALL: Shape<&str> = Shape::Paraboloid { radius: "1" };
const WORK: f64 = 0.01;

/// (d, F) of a ball of radius 1 on a half-space graded with k and c = 2: g = a²/(1 + k).
fn graded(k: f64, a: f64) -> [f64; 2] {
    let c = 2.0;
    let d = a * a / (1.0 + k) - (2.0 * PI * WORK * a.powf(1.0 - k) / c).sqrt();
    [d, 2.0 * c / (1.0 + k) * (a.powf(1.0 + k) * d - a.powf(3.0 + k) / (3.0 + k))]
}

/// On springs of K_w = 5: g = f.
fn winkler(a: f64) -> [f64; 2] {
    let k = 5.0_f64;
    let d = a * a / 2.0 - (2.0 * WORK / k).sqrt();
    [d, PI * k * (a * a * d - a.powi(4) / 4.0)]
}

/// A cylinder on a half-plane of E* = 3, measured against the distance 10.
fn line(b: f64) -> [f64; 2] {
    let (e_star, l, arcosh) = (3.0, 10.0_f64, (10.0 / b).acosh());
    let far = l * l * (1.0 - (1.0 - (b / l).powi(2)).sqrt());
    let depth = 0.5 * (b * b * arcosh + far) - 2.0 / PI * arcosh * (2.0 * PI * WORK * b / e_star).sqrt();
    [depth, e_star * PI / 4.0 * b * b - (2.0 * PI * WORK * b * e_star).sqrt()]
}

/// A retraction from a = 0.9 to where F or d has its fold, and a tail without contact.
fn record(state: &dyn Fn(f64) -> [f64; 2], fold: f64, offset: f64) -> [Vec<f64>; 2] {
    let radii = (0..40).map(|step| 0.9 + (1.02 * fold - 0.9) * f64::from(step) / 39.0);
    let mut rows: Vec<[f64; 2]> = radii.map(state).collect();
    let last = rows[rows.len() - 1][0];
    rows.extend((1..12).map(|step| [last - 0.02 * f64::from(step) - 0.01, 0.0]));
    [rows.iter().map(|row| row[0] + offset).collect(), rows.iter().map(|row| row[1]).collect()]
}

fn near(fit: &Fit, name: &str, expected: f64) {
    let found = fit.estimate(name).and_then(|estimate| estimate.value).unwrap_or(f64::NAN);
    assert!((found / expected - 1.0).abs() < 1e-6, "{name} = {found}, expected {expected}; {}", fit.reason);
}

fn soil(k: &str) -> ExactMedium {
    ExactMedium::Graded { exponent: k.parse().expect("k"), stiffness: Grading::Coefficient("1".parse().expect("c")) }
}

fn springs() -> ExactMedium {
    ExactMedium::Winkler { modulus: "1".parse().expect("K") }
}

#[test]
fn the_modulus_of_the_medium_is_found() {
    let plane = ExactMedium::Plane { reference: Some("10".parse().expect("L")) };
    // Folds of d: a = [(1 − k)²B/N²]^(1/(3 + k)) with B = πw/2c and N = 1/(1 + k); none on a Winkler foundation.
    let fold = |k: f64| ((1.0 - k).powi(2) * PI * WORK / 4.0 * (1.0 + k).powi(2)).powf(1.0 / (3.0 + k));
    let cases: [(ExactMedium, &str, f64, [Vec<f64>; 2]); 4] = [
        (soil("0.3"), "coefficient", 2.0, record(&|a| graded(0.3, a), fold(0.3), 0.05)),
        (soil("-0.4"), "coefficient", 2.0, record(&|a| graded(-0.4, a), fold(-0.4), 0.05)),
        (springs(), "modulus", 5.0, record(&winkler, 0.02, 0.05)),
        (plane, "e_star", 3.0, record(&line, 0.13, 0.05)),
    ];
    for (medium, name, modulus, [x, y]) in cases {
        let problem = Problem::new(BALL, Observation::ForceOfIndentation, &x, &y).expect("a problem");
        let problem = problem.medium(medium).expect("a medium");
        let fit =
            problem.clone().free([name, "work_of_adhesion", "contact_point"]).expect("names").fit().expect("a fit");
        near(&fit, name, modulus);
        near(&fit, "work_of_adhesion", WORK);
        near(&fit, "contact_point", 0.05);
        assert!(fit.medium.is_some());
        // A number of the profile in place of the modulus, by the derivative of the transform on the medium.
        let fit = problem.free(["radius", "work_of_adhesion"]).and_then(|problem| problem.fixed(name, modulus));
        let fit = fit.and_then(|problem| problem.fixed("contact_point", 0.05)).expect("names");
        let fit = fit.start("radius", 1.3).expect("a start").fit().expect("a fit");
        near(&fit, "radius", 1.0);
        near(&fit, "work_of_adhesion", WORK);
    }
}

/// With radii no depth is needed.
#[test]
fn radii_on_a_half_plane() {
    let radii: Vec<f64> = (1..30).map(|step| 0.03 * f64::from(step)).collect();
    let forces: Vec<f64> = radii.iter().map(|a| line(*a)[1]).collect();
    let problem = Problem::new(BALL, Observation::ForceOfRadius, &radii, &forces).expect("a problem");
    let problem = problem.medium(ExactMedium::Plane { reference: None }).expect("a medium");
    let fit = problem.free(["e_star", "work_of_adhesion"]).expect("names").fit().expect("a fit");
    near(&fit, "e_star", 3.0);
    near(&fit, "work_of_adhesion", WORK);
    assert_eq!(fit.units, ["m", "N/m"]);
}

/// k = 0 is the half-space: the same estimates, in every bit.
#[test]
fn no_grading_is_the_half_space() {
    let [x, y] = record(&|a| graded(0.0, a), 0.16, 0.05);
    let problem = Problem::new(BALL, Observation::ForceOfIndentation, &x, &y).expect("a problem");
    let ends = [(ExactMedium::HalfSpace, "e_star"), (soil("0"), "coefficient")].map(|(medium, name)| {
        let free = [name, "work_of_adhesion", "contact_point"];
        let fit = problem.clone().medium(medium).and_then(|problem| problem.free(free)).expect("names").fit();
        let bits = |fit: &Fit| fit.parameters.iter().map(|each| each.value.map(f64::to_bits)).collect::<Vec<_>>();
        bits(&fit.expect("a fit"))
    });
    assert_eq!(ends[0], ends[1]);
}

#[test]
fn what_a_medium_lacks_is_said() {
    let [x, y] = record(&winkler, 0.02, 0.0);
    let problem = Problem::new(BALL, Observation::ForceOfIndentation, &x, &y).expect("a problem");
    let why = |medium| problem.clone().medium(medium).expect_err("refused").to_string();
    let wave = ExactMedium::Periodic { wavelength: "1".parse().expect("a length"), flaw: None };
    assert!(why(wave).contains("periodic"));
    assert!(why(ExactMedium::Plane { reference: None }).contains("reference"));
    assert!(why(soil("1.5")).contains("within (-1, 1)"));
    let on = problem.clone().medium(springs()).expect("a medium");
    let why = on.clone().free(["e_star"]).expect_err("no E*").to_string();
    assert!(why.contains("modulus"), "{why}");
    let ranged = on.clone().free(["modulus", "work_of_adhesion"]).and_then(|problem| problem.range_of_adhesion(1e-3));
    let why = ranged.expect("names").fit().expect_err("no range").to_string();
    assert!(why.contains("range of adhesion"), "{why}");
    let fit = on.free(["modulus", "work_of_adhesion"]).expect("names").digits(10).fit().expect("a fit");
    assert!(fit.certified.is_none() && fit.warnings.iter().any(|warning| warning.contains("another medium")));
}

#[cfg(feature = "toml")]
#[test]
fn a_fit_on_a_medium_is_read() {
    let rows: Vec<String> =
        (0..20).map(|step| line(0.9 - 0.03 * f64::from(step))).map(|[d, f]| format!("[{d}, {:e}]", 1e3 * f)).collect();
    let text = |medium: &str| {
        format!(
            "[profile]\nkind = \"paraboloid\"\nradius = 1\n[medium]\n{medium}\n[data]\nobservation = \"F(d)\"\n\
             units = [\"m\", \"mN/m\"]\nrows = [{}]\n[fit]\nfree = [\"e_star\", \"work_of_adhesion\"]\n",
            rows.join(", ")
        )
    };
    let read = |medium: &str| Problem::from_toml(&text(medium), "fit.toml", &mdr::no_files);
    let fit = read("kind = \"plane\"\nreference = \"10 m\"").and_then(|problem| problem.fit()).expect("a fit");
    near(&fit, "e_star", 3.0);
    let why = read("kind = \"periodic\"\nwavelength = 1").expect_err("refused").to_string();
    assert!(why.starts_with("fit.toml:") && why.contains("periodic"), "{why}");
}
