//! Fits of the published data sets, whose estimates are certified by another program in 60 digits.
#![cfg(feature = "fit")]
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use mdr::fit::{Fit, FitStatus, Loss, Observation, Problem};
use mdr::prelude::*;
use serde_json::Value as Json;
use std::f64::consts::PI;

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
/// Deflection on a cantilever tells neither the scale of forces nor that of lateral lengths. No force is told then, and steps of the
/// iteration that leave the range of numbers do not end it.
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

/// g and its integral, by hand.
type Formula = fn(f64) -> [f64; 2];

/// Five tips with lengths of their own, and the radii between which they are seen.
fn tips() -> Vec<(Shape<&'static str>, Formula, [f64; 2])> {
    vec![
        (Shape::Paraboloid { radius: "1e-5" }, |x| [x * x / 1e-5, x.powi(3) / 3e-5], [1e-6, 6e-6]),
        (Shape::Cone { flank: Flank::Slope("0.4") }, |x| [0.2 * PI * x, 0.1 * PI * x * x], [0.1e-6, 3e-6]),
        (
            Shape::Sphere { radius: "1e-5" },
            |x| [x * (x / 1e-5).atanh(), 0.5 * (x * x - 1e-10) * (x / 1e-5).atanh() + 0.5e-5 * x],
            [1e-6, 5e-6],
        ),
        (
            Shape::Hyperboloid { flank: Flank::Slope("0.36"), lateral: "1e-6" },
            |x| [0.36 * x * (x / 1e-6).atan(), 0.18 * ((x * x + 1e-12) * (x / 1e-6).atan() - 1e-6 * x)],
            [0.3e-6, 3e-6],
        ),
        (
            Shape::TruncatedParaboloid { radius: "1e-5", flat: "1e-6" },
            |x| [x / 1e-5 * (x * x - 1e-12).sqrt(), (x * x - 1e-12).powf(1.5) / 3e-5],
            [1.3e-6, 6e-6],
        ),
    ]
}

const E_STAR: f64 = 2e6;
const WORK: f64 = 0.05;

/// Normal numbers that are the same on every machine.
struct Normal(u64);

impl Normal {
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    fn next(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (2.0 * PI * self.uniform()).cos()
    }
}

/// A curve on retraction from states at given radii, all of them stable, with noise in F of this share of the largest force, an
/// offset of depth, and a detached tail.
fn curve(
    formula: Formula,
    [from, to]: [f64; 2],
    rows: usize,
    noise: f64,
    normal: &mut Normal,
) -> (Vec<f64>, Vec<f64>, f64) {
    let state = |index: usize| {
        let a = to + (from - to) * index as f64 / rows as f64;
        let elongation = (2.0 * PI * a * WORK / E_STAR).sqrt();
        let [g, integral] = formula(a);
        [g - elongation, 2.0 * E_STAR * (a * (g - elongation) - integral)]
    };
    let states: Vec<[f64; 2]> = (0..rows).map(state).collect();
    let stable = states.windows(2).position(|pair| pair[1][0] >= pair[0][0]).map_or(rows, |last| last + 1);
    let sigma = noise * states.iter().map(|state| state[1]).fold(f64::INFINITY, f64::min).abs();
    let last = states[stable - 1][0];
    let step = (states[0][0] - last) / rows as f64;
    let tail = (1..rows / 4).map(|index| [last - 3e-7 - step * index as f64, 0.0]);
    let all: Vec<[f64; 2]> = states[..stable].iter().copied().chain(tail).collect();
    let x = all.iter().map(|state| state[0] + 1e-7).collect();
    let y = all.iter().map(|state| state[1] + sigma * normal.next()).collect();
    (x, y, sigma)
}

/// Curves that were made by formulas of this file, without a start and from starts ten times off.
#[test]
fn tips_are_recovered_from_anywhere() {
    for (tip, formula, range) in tips() {
        let (x, y, sigma) = curve(formula, range, 150, 1e-2, &mut Normal(7));
        let problem = || {
            let problem = Problem::new(tip.clone(), Observation::ForceOfIndentation, &x, &y).unwrap();
            problem.free(["e_star", "work_of_adhesion", "contact_point"]).unwrap().sigma_y(sigma).unwrap()
        };
        let plain = problem().fit().unwrap();
        let values: Vec<f64> = plain.parameters.iter().map(|estimate| estimate.value.unwrap()).collect();
        for (estimate, made) in plain.parameters.iter().zip([E_STAR, WORK, 1e-7]) {
            let pull = (estimate.value.unwrap() - made) / estimate.stderr.unwrap();
            assert!(pull.abs() < 4.5, "{}: {estimate:?}", tip.name());
        }
        for [e_star, work] in [[10.0, 0.1], [0.1, 10.0], [10.0, 10.0]] {
            let started = problem()
                .start("e_star", e_star * E_STAR)
                .and_then(|problem| problem.start("work_of_adhesion", work * WORK));
            let fit = started.unwrap().fit().unwrap();
            for (estimate, value) in fit.parameters.iter().zip(&values) {
                assert!(digits(estimate.value.unwrap(), *value) > 8.0, "{}: {estimate:?}, {value:e}", tip.name());
            }
        }
    }
}

/// How often the intervals of 68.3 and 95.4 % contain what the curves were made from.
fn coverage(curves: u64) -> [f64; 2] {
    let (mut inside, mut count) = ([0.0; 2], 0.0);
    for (tip, formula, range) in tips() {
        for seed in 1..=curves {
            let (x, y, sigma) = curve(formula, range, 80, 1e-2, &mut Normal(0x9e37_79b9_7f4a_7c15 ^ (seed * 7919)));
            let problem = Problem::new(tip.clone(), Observation::ForceOfIndentation, &x, &y).unwrap();
            let fit = problem.free(["e_star", "work_of_adhesion"]).unwrap().fixed("contact_point", 1e-7).unwrap();
            let fit = fit.sigma_y(sigma).unwrap().sigma_x(0.0).unwrap().fit().unwrap();
            for (estimate, made) in fit.parameters.iter().zip([E_STAR, WORK]) {
                let pull = ((estimate.value.unwrap() - made) / estimate.stderr.unwrap()).abs();
                inside[0] += f64::from(u8::from(pull < 1.0));
                inside[1] += f64::from(u8::from(pull < 2.0));
                count += 1.0;
            }
        }
    }
    inside.map(|inside| inside / count)
}

#[test]
fn intervals_cover_as_often_as_they_say() {
    let [one, two] = coverage(20);
    // Of 200 numbers: three standard deviations of a binomial share.
    assert!((one - 0.683).abs() < 0.1 && (two - 0.954).abs() < 0.045, "{one} {two}");
}

#[test]
#[ignore = "a minute in a release build"]
fn intervals_of_a_thousand_curves_cover_as_often_as_they_say() {
    let [one, two] = coverage(1000);
    assert!((one - 0.683).abs() < 0.015 && (two - 0.954).abs() < 0.007, "{one} {two}");
}

/// A few wild rows: least squares follow them, Huber's loss does not; priors and bounds are kept.
#[test]
fn wild_rows_priors_and_bounds() {
    let (tip, formula, range) = tips().remove(0);
    let (x, mut y, sigma) = curve(formula, range, 150, 1e-2, &mut Normal(11));
    for index in [10, 40, 70] {
        y[index] += 200.0 * sigma;
    }
    let problem = || {
        let problem =
            Problem::new(tip.clone(), Observation::ForceOfIndentation, &x, &y).unwrap().sigma_y(sigma).unwrap();
        problem.fixed("contact_point", 1e-7).unwrap().free(["e_star", "work_of_adhesion"]).unwrap()
    };
    let error = |fit: &Fit| (fit.estimate("e_star").unwrap().value.unwrap() / E_STAR - 1.0).abs();
    let [squares, huber] = [Loss::LeastSquares, Loss::Huber].map(|loss| error(&problem().loss(loss).fit().unwrap()));
    assert!(huber < 0.2 * squares, "{huber} {squares}");
    let bounded = problem().bounds("e_star", [3e6, 4e6]).unwrap().fit().unwrap();
    assert_eq!((bounded.parameters[0].value, bounded.parameters[0].stderr), (Some(3e6), None));
    let prior = problem().prior("e_star", 1.9e6, 1.0).unwrap().fit().unwrap();
    assert!((prior.parameters[0].value.unwrap() - 1.9e6).abs() < 10.0);
}

/// A ball of 10 µm that was measured with heights wrong by a nanometre: smoothing takes that away, and the fit shows what it does.
#[test]
fn noise_of_a_measured_tip_moves_the_estimates() {
    let mut noise = Normal(5);
    let heights = (0..60).map(|row| {
        let r = 5e-8 * f64::from(row);
        format!("{r:e},{:e}\n", r * r / 2e-5 + if row == 0 { 0.0 } else { 1e-9 * noise.next() })
    });
    let tip = format!("r,f\nm,m\n{}", heights.collect::<String>());
    let rows = (0..60).map(|row| {
        let a = 1.2e-6 + 2e-8 * f64::from(row);
        let elongation = (2.0 * PI * a * WORK / E_STAR).sqrt();
        let d = a * a / 1e-5 - elongation;
        format!("[{d:e}, {:e}]", 2.0 * E_STAR * (a * d - a.powi(3) / 3e-5))
    });
    let text = format!(
        "[profile]\nkind = \"table\"\nfile = \"tip.csv\"\nsmooth = \"400 nm\"\n[data]\nobservation = \"F(d)\"\n\
         sigma = {{ x = \"0\" }}\nrows = [{}]\n[fit]\nfree = [\"e_star\", \"work_of_adhesion\"]\n",
        rows.collect::<Vec<_>>().join(", ")
    );
    let files = |_: &str| Ok(tip.as_bytes().to_vec());
    let stated = Problem::from_toml(&text, "fit.toml", &files).unwrap().fit().unwrap();
    assert_eq!(stated.status, FitStatus::Fitted, "{}", stated.reason);
    let lengths: Vec<Option<f64>> = stated.smoothing.iter().map(|other| other.length).collect();
    assert_eq!(lengths, [None, Some(2e-7), Some(8e-7)]);
    // The rows as they are fit worse than the smooth tip, by far.
    assert!(stated.smoothing[0].rss > 4.0 * stated.rss, "{:e} {:e}", stated.smoothing[0].rss, stated.rss);
    assert!((stated.estimate("e_star").unwrap().value.unwrap() / E_STAR - 1.0).abs() < 0.05);
    assert!(problem(&set("Sphere1")).fit().unwrap().smoothing.is_empty());
}
