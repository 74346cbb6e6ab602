//! Fits of curves that are made here, by formulas of this file.
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

mod normal;

use mdr::prelude::*;
use mdr_fit::{Fit, FitStatus, Loss, Observation, Problem};
use std::f64::consts::PI;

use normal::Normal;

fn digits(value: f64, expected: f64) -> f64 {
    -((value - expected).abs() / expected.abs()).max(1e-17).log10()
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

/// A record that ends before pull-off, with the baseline free: that the last row is out of contact fits as well, for the baseline
/// takes it up, and it would tell w with an error a hundred times too small.
#[test]
fn a_last_row_that_the_baseline_takes_up_is_no_jump() {
    let (tip, formula, range) = tips().remove(0);
    for seed in 1..9 {
        let (x, y, sigma) = curve(formula, range, 150, 1e-2, &mut Normal(seed));
        let rows = 70;
        let problem = Problem::new(tip.clone(), Observation::ForceOfIndentation, &x[..rows], &y[..rows]).unwrap();
        let problem = problem.free(["e_star", "work_of_adhesion", "contact_point", "baseline"]).unwrap();
        let fit = problem.sigma_y(sigma).unwrap().fit().unwrap();
        assert!(fit.rows.iter().all(|row| row.label >= 0), "{seed}: {:?}", fit.warnings);
        for (estimate, made) in fit.parameters.iter().zip([E_STAR, WORK, 1e-7, 0.0]) {
            if let [Some(value), Some(stderr)] = [estimate.value, estimate.stderr] {
                // The valley of these minima bends, and errors are those of its tangent.
                assert!((value - made).abs() < 10.0 * stderr, "{seed}: {estimate:?}");
            }
        }
    }
}

/// Rows that lie close together at the fold, with noise in X and Y, a short tail, and nothing stated: no start, no σ.
#[test]
fn a_crowded_record_needs_no_start() {
    for (tip, formula, range) in tips() {
        let mut normal = Normal(11);
        let (mut x, y, _) = curve(formula, range, 100, 1e-2, &mut normal);
        let blur = 2e-3 * (x[0] - x[80]);
        x.iter_mut().for_each(|x| *x += blur * normal.next());
        let problem = Problem::new(tip.clone(), Observation::ForceOfIndentation, &x, &y).unwrap();
        let fit = problem.free(["e_star", "work_of_adhesion", "contact_point", "baseline"]).unwrap().fit().unwrap();
        assert_eq!(fit.status, FitStatus::Fitted, "{}: {}", tip.name(), fit.reason);
        for (estimate, made) in fit.parameters.iter().zip([E_STAR, WORK]) {
            assert!((estimate.value.unwrap() / made - 1.0).abs() < 0.1, "{}: {estimate:?}", tip.name());
        }
    }
}

/// A record that begins at its smallest force, where the two-point method has no second point.
#[test]
fn a_record_may_begin_in_tension() {
    for (tip, formula, range) in tips() {
        let (x, y, sigma) = curve(formula, range, 400, 1e-2, &mut Normal(13));
        let lowest = (0..y.len()).min_by(|one, other| y[*one].total_cmp(&y[*other])).unwrap();
        let problem = Problem::new(tip.clone(), Observation::ForceOfIndentation, &x[lowest..], &y[lowest..]).unwrap();
        let problem = problem.free(["e_star", "work_of_adhesion", "contact_point", "baseline"]).unwrap();
        let fit = problem.sigma_y(sigma).unwrap().fit().unwrap();
        for (estimate, made) in fit.parameters.iter().zip([E_STAR, WORK]) {
            let pull = (estimate.value.unwrap() - made) / estimate.stderr.unwrap();
            assert!(pull.abs() < 5.0, "{}: {estimate:?} {:?}", tip.name(), fit.reason);
        }
    }
}

/// How often the intervals of 68.3 and 95.4 % contain the numbers from which the curves were made.
fn coverage(curves: u64) -> [f64; 2] {
    let (mut inside, mut count) = ([0.0; 2], 0.0);
    for (tip, formula, range) in tips() {
        for seed in 1..=curves {
            let (x, y, sigma) = curve(formula, range, 80, 1e-2, &mut Normal(0x9e37_79b9_7f4a_7c15 ^ (seed * 7919)));
            let problem = Problem::new(tip.clone(), Observation::ForceOfIndentation, &x, &y).unwrap();
            let fit = problem.free(["e_star", "work_of_adhesion"]).unwrap().fixed("contact_point", 1e-7).unwrap();
            let fit = fit.sigma_y(sigma).unwrap().fit().unwrap();
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

/// A ball of 10 µm that was measured with heights wrong by a nanometre: smoothing removes that, and the fit shows its effect.
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
}
