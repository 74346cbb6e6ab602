//! Two works of adhesion: both legs together, one leg, records that stop early, pull-off from a pinned edge.
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

mod normal;
mod tips;

use mdr::prelude::*;
use mdr_fit::{Fit, FitStatus, Leg, Observation, Problem};
use std::f64::consts::PI;

use normal::Normal;
use tips::{CONTACT_POINT, E_STAR, Tip, estimate, tips};

/// A parabola, a cone and a hyperboloid.
fn few_tips() -> impl Iterator<Item = Tip> {
    let few =
        |tip: &Tip| matches!(tip.shape, Shape::Paraboloid { .. } | Shape::Cone { .. } | Shape::Hyperboloid { .. });
    tips().into_iter().filter(few)
}

const BASELINE: f64 = 3e-8;

/// How a curve with hysteresis is recorded.
#[derive(Clone, Copy, Debug)]
struct Record {
    works: [f64; 2],
    stiffness: Option<f64>,
    approach: bool,
    retract: bool,
    /// The radius where it turns, against the widest.
    turn: f64,
    /// Where the retraction ends: the share of the way from the turn to pull-off, with a tail beyond it above one.
    end: f64,
    rows: usize,
    /// σ_Y against the force of pull-off.
    noise: f64,
    /// Of the baseline, over the whole record, against the force of pull-off.
    drift: f64,
    seed: u64,
}

const USUAL: Record = Record {
    works: [0.01, 0.04],
    stiffness: None,
    approach: true,
    retract: true,
    turn: 1.0,
    end: 1.3,
    rows: 80,
    noise: 1e-2,
    drift: 0.0,
    seed: 1,
};

/// Rows with σ_Y, the sum of squares of their errors in units of it, and the place and the force of pull-off.
struct Curve {
    x: Vec<f64>,
    y: Vec<f64>,
    legs: Vec<Leg>,
    sigma: f64,
    chi2: f64,
    pull_off: [f64; 2],
}

impl Record {
    /// (X, F) of a radius and a depth.
    fn seen(&self, tip: &Tip, a: f64, d: f64) -> [f64; 2] {
        let force = 2.0 * E_STAR * (a * d - (tip.formula)(a)[1]);
        [d + self.stiffness.map_or(0.0, |stiffness| force / stiffness), force]
    }

    fn depth(&self, tip: &Tip, a: f64, work: f64) -> f64 {
        (tip.formula)(a)[0] - (2.0 * PI * a * work / E_STAR).sqrt()
    }

    fn state(&self, tip: &Tip, a: f64, work: f64) -> [f64; 2] {
        self.seen(tip, a, self.depth(tip, a, work))
    }

    /// From `from` inward as far as X falls.
    fn fold(&self, tip: &Tip, from: f64, work: f64) -> f64 {
        let mut fold = from;
        while fold > 1e-6 * from && self.state(tip, fold * 0.9995, work)[0] < self.state(tip, fold, work)[0] {
            fold *= 0.9995;
        }
        fold
    }

    /// F at X on a stable arc, between two radii.
    fn force(&self, tip: &Tip, x: f64, [mut low, mut high]: [f64; 2], work: f64) -> f64 {
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *if self.state(tip, middle, work)[0] > x { &mut high } else { &mut low } = middle;
        }
        self.state(tip, 0.5 * (low + high), work)[1]
    }

    fn curve(&self, tip: &Tip) -> Curve {
        let [w1, w2] = self.works;
        let turn = self.turn * tip.widest;
        let [first, _] = self.state(tip, turn, w1);
        let fold1 = if w1 > 0.0 { self.fold(tip, turn, w1) } else { 0.0 };
        let fold2 = self.fold(tip, turn, w2);
        let depinned = self.state(tip, turn, w2);
        let pull_off = self.state(tip, fold2, w2);
        let retracted = |x: f64| -> Option<f64> {
            if x >= depinned[0] {
                // On the straight line between the two ends of the pinned segment.
                let top = self.state(tip, turn, w1);
                let share = if top[0] > depinned[0] { (x - depinned[0]) / (top[0] - depinned[0]) } else { 0.0 };
                return Some(depinned[1] + share * (top[1] - depinned[1]));
            }
            (x >= pull_off[0]).then(|| self.force(tip, x, [fold2, turn], w2))
        };
        let unit = 1.0 / self.stiffness.unwrap_or(1.0);
        let lowest = (0..400).map(|i| first + (pull_off[0] - first) * f64::from(i) / 400.0).filter_map(retracted);
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        let sigma = self.noise * lowest.abs() * unit;
        let mut normal = Normal(0x9e37_79b9_7f4a_7c15 ^ (self.seed * 7919));
        let (mut x, mut y, mut legs, mut chi2) = (Vec::new(), Vec::new(), Vec::new(), 0.0);
        let share = |index: usize| index as f64 / (self.rows - 1) as f64;
        let count = (usize::from(self.approach) + usize::from(self.retract)) * self.rows - 1;
        let mut add = |at: f64, force: f64, leg: Leg| {
            let error = normal.next();
            chi2 += error * error;
            let time = x.len() as f64 / count as f64;
            x.push(at + CONTACT_POINT);
            y.push((force + BASELINE + self.drift * lowest.abs() * time) * unit + sigma * error);
            legs.push(leg);
        };
        if self.approach {
            let far = -0.4 * first;
            for index in 0..self.rows {
                let at = far + (first - far) * share(index);
                add(at, if at >= 0.0 { self.force(tip, at, [fold1, turn], w1) } else { 0.0 }, Leg::Approach);
            }
        }
        if self.retract {
            let way = pull_off[0] - first;
            for index in 0..self.rows {
                let at = first + self.end * way * share(index);
                add(at, retracted(at).unwrap_or(0.0), Leg::Retract);
            }
        }
        Curve { x, y, legs, sigma, chi2, pull_off }
    }

    fn problem(&self, tip: &Tip, curve: &Curve, free: &[&str]) -> Problem {
        let observation =
            if self.stiffness.is_some() { Observation::DeflectionOfPosition } else { Observation::ForceOfIndentation };
        let problem = Problem::new(tip.shape.clone(), observation, &curve.x, &curve.y).unwrap();
        let mut problem = problem.legs(&curve.legs).unwrap().sigma_y(curve.sigma).unwrap();
        if let Some(stiffness) = self.stiffness {
            problem = problem.fixed("stiffness", stiffness).unwrap();
        }
        for (name, value) in [("contact_point", CONTACT_POINT), ("baseline", BASELINE / self.stiffness.unwrap_or(1.0))]
        {
            if !free.contains(&name) {
                problem = problem.fixed(name, value).unwrap();
            }
        }
        problem.free(free.iter().copied()).unwrap()
    }
}

const FIVE: [&str; 5] = ["e_star", "advancing", "receding", "contact_point", "baseline"];

/// What is wrong with a fit of a record, if something is.
fn fault(record: &Record, tip: &Tip, free: &[&str]) -> Option<String> {
    let curve = record.curve(tip);
    let what = format!("{} {record:?} {free:?}", tip.shape.name());
    let fit = match record.problem(tip, &curve, free).fit() {
        Ok(fit) => fit,
        Err(error) => return Some(format!("{what}: {error}")),
    };
    let chi2 = fit.chi2.unwrap();
    if fit.status != FitStatus::Fitted || chi2 > curve.chi2 * (1.0 + 1e-9) {
        return Some(format!(
            "{what}: {:?} {} χ² {chi2} for {}\n{:?}",
            fit.status, fit.reason, curve.chi2, fit.parameters
        ));
    }
    let truth = [("e_star", E_STAR), ("advancing", record.works[0]), ("receding", record.works[1])];
    truth.into_iter().filter(|(name, _)| free.contains(name)).find_map(|(name, made)| {
        let [value, stderr] = estimate(&fit, name);
        (!(((value - made) / stderr).abs() < 5.0))
            .then(|| format!("{what}: {name} = {value} ± {stderr} for {made}; {:?}", fit.warnings))
    })
}

#[test]
fn both_works_are_found_from_both_legs() {
    let mut faults = Vec::new();
    let mut count = 0;
    for tip in few_tips() {
        for stiffness in [None, Some(40.0)] {
            for (works, turn) in [([0.01, 0.04], 1.0), ([1e-3, 0.05], 0.7), ([0.03, 0.03], 0.7)] {
                let record = Record { works, stiffness, turn, seed: 7 + count, ..USUAL };
                count += 1;
                faults.extend(fault(&record, &tip, &FIVE));
            }
        }
    }
    assert!(faults.is_empty(), "{} of {count}:\n{}", faults.len(), faults.join("\n"));
}

/// Records that end before pull-off, and of one leg.
#[test]
fn records_that_stop_early_tell_what_they_can() {
    let mut faults = Vec::new();
    for tip in few_tips() {
        for (end, retract, approach) in [(0.8, true, true), (0.95, true, true), (1.3, true, false)] {
            let record = Record { end, retract, approach, seed: 5, ..USUAL };
            faults.extend(fault(&record, &tip, &FIVE[..if approach { 5 } else { 4 }]));
        }
    }
    assert!(faults.is_empty(), "{}:\n{}", faults.len(), faults.join("\n"));
}

/// Certified digits that were asked for are there, or a warning says why not.
fn assert_answered(fit: &Fit) {
    let is_said = fit.warnings.iter().any(|warning| warning.contains("digits"));
    assert!(fit.certified.is_some() || is_said, "{:?}", fit.warnings);
}

/// Where the edge is pinned in all rows of the retraction there is a lower limit of w₂, and no value.
#[test]
fn a_pinned_edge_gives_a_lower_limit() {
    for tip in few_tips() {
        let record = Record { works: [0.005, 0.08], end: 0.2, turn: 0.5, ..USUAL };
        let curve = record.curve(&tip);
        let fit = record.problem(&tip, &curve, &FIVE).digits(8).fit().unwrap();
        assert_eq!(fit.status, FitStatus::Fitted, "{}", fit.reason);
        assert_answered(&fit);
        assert_eq!(fit.estimate("receding").unwrap().value, None);
        let limit = fit.limits.iter().find(|limit| limit.name == "work_of_adhesion.receding").unwrap();
        let lower = limit.lower.unwrap();
        assert!(lower > 0.005 && lower < 0.08 && limit.upper.is_none(), "{limit:?}");
        assert!(fit.warnings.iter().any(|warning| warning.contains("lower limit")), "{:?}", fit.warnings);
        let [e_star, stderr] = estimate(&fit, "e_star");
        assert!(((e_star - E_STAR) / stderr).abs() < 4.0, "{e_star} ± {stderr}");
        assert!(fit.rows.iter().filter(|row| row.leg == Leg::Retract).all(|row| row.pinned));
    }
}

/// A light preload: the contact breaks from where it is pinned, and w₂ lies between two rows.
#[test]
fn a_contact_may_break_where_it_is_pinned() {
    let tip = &tips()[0];
    // The fold of w₂ is at 1.16 µm under fixed grips, and the record turns at 1.08 µm.
    let record = Record { works: [0.002, 0.08], turn: 0.18, rows: 200, noise: 3e-3, ..USUAL };
    let curve = record.curve(tip);
    let fit = record.problem(tip, &curve, &FIVE).fit().unwrap();
    let limit = fit.limits.iter().find(|limit| limit.name == "work_of_adhesion.receding").unwrap();
    let [lower, upper] = [limit.lower.unwrap(), limit.upper.unwrap()];
    let [value, stderr] = estimate(&fit, "receding");
    assert!(lower < value && value < upper && stderr > 0.0, "{limit:?}");
    assert!((value / 0.08 - 1.0).abs() < 0.1, "{value} {limit:?} {:?}", fit.warnings);
}

/// One work of adhesion for a record with hysteresis: named, with both numbers; without hysteresis it is not named.
#[test]
fn hysteresis_is_named_where_one_work_does_not_serve() {
    let one = ["e_star", "work_of_adhesion", "contact_point", "baseline"];
    for tip in few_tips() {
        for (works, has_hysteresis) in [([0.01, 0.04], true), ([0.03, 0.03], false)] {
            for stated in [true, false] {
                let record = Record { works, ..USUAL };
                let curve = record.curve(&tip);
                let problem = record.problem(&tip, &curve, &one);
                let fit = if stated { problem } else { problem.sigma_y(0.0).unwrap() }.fit().unwrap();
                let is_named = fit.warnings.iter().any(|warning| warning.contains("hysteresis"));
                assert_eq!(is_named, has_hysteresis, "{} {works:?} {stated} {:?}", tip.shape.name(), fit.warnings);
                assert!(!stated || (fit.status == FitStatus::Fitted) != has_hysteresis, "{:?}", fit.status);
                assert_eq!(fit.legs.len(), 2);
            }
        }
    }
}

/// One leg that is chosen from both is as good as a record of it alone.
#[test]
fn one_leg_may_be_chosen() {
    let tip = &tips()[0];
    let curve = USUAL.curve(tip);
    let one = ["e_star", "work_of_adhesion", "contact_point", "baseline"];
    let fit = USUAL.problem(tip, &curve, &one).only(Leg::Approach).fit().unwrap();
    let [work, stderr] = estimate(&fit, "work_of_adhesion");
    assert!(((work - 0.01) / stderr).abs() < 4.0 && fit.rows.len() == USUAL.rows, "{work} ± {stderr}");
    assert_eq!((fit.skipped[0].why, fit.skipped[0].rows), ("other leg", USUAL.rows));
    // The place where the record turns is known, also without its first rows.
    let masked = USUAL.problem(tip, &curve, &FIVE).only(Leg::Retract);
    let top = curve.x[USUAL.rows];
    let masked = masked.within(Some([-1e-5, top - 0.05 * (top - curve.pull_off[0])]), None).unwrap().fit().unwrap();
    let [work, stderr] = estimate(&masked, "receding");
    assert!(((work - 0.04) / stderr).abs() < 4.0, "{work} ± {stderr} {:?}", masked.warnings);
}

/// Hertz on the way in, given as zero or free.
#[test]
fn no_adhesion_on_the_way_in() {
    for tip in few_tips() {
        let record = Record { works: [0.0, 0.04], ..USUAL };
        let curve = record.curve(&tip);
        let given = record.problem(&tip, &curve, &["e_star", "receding", "contact_point", "baseline"]);
        let given = given.fixed("advancing", 0.0).unwrap().fit().unwrap();
        let [work, stderr] = estimate(&given, "receding");
        assert!(given.status == FitStatus::Fitted && ((work - 0.04) / stderr).abs() < 4.0, "{work} ± {stderr}");
        let free = record.problem(&tip, &curve, &FIVE).fit().unwrap();
        assert_eq!(free.status, FitStatus::Fitted, "{} {}", tip.shape.name(), free.reason);
        let limit = free.limits.iter().find(|limit| limit.name == "work_of_adhesion.advancing").unwrap();
        assert!(limit.upper.is_some_and(|upper| upper > 0.0 && upper < 5e-3), "{limit:?}");
    }
}

/// One work of adhesion that is zero: Hertz, with an upper limit, in one leg and in both.
#[test]
fn a_contact_without_adhesion_has_an_upper_limit() {
    let one = ["e_star", "work_of_adhesion", "contact_point", "baseline"];
    for (approach, retract) in [(true, false), (true, true)] {
        let tip = &tips()[0];
        let made = Record { works: [0.0, 1e-12], approach, retract, end: 1.3, noise: 1.0, ..USUAL };
        let mut curve = made.curve(tip);
        let sigma = 2e-7;
        let mut normal = Normal(99);
        curve.y.iter_mut().for_each(|y| *y += sigma * normal.next());
        curve.sigma = sigma;
        let fit = made.problem(tip, &curve, &one).digits(8).fit().unwrap();
        assert_eq!(fit.status, FitStatus::Fitted, "{} {}", fit.reason, approach);
        assert_answered(&fit);
        let limit = fit.limits.iter().find(|limit| limit.name == "work_of_adhesion").unwrap();
        assert!(limit.upper.is_some_and(|upper| upper > 1e-9 && upper < 0.05), "{limit:?}");
        let given = made.problem(tip, &curve, &["e_star", "contact_point", "baseline"]);
        let given = given.fixed("work_of_adhesion", 0.0).unwrap().fit().unwrap();
        let [e_star, stderr] = estimate(&given, "e_star");
        assert!(((e_star - E_STAR) / stderr).abs() < 4.0, "{e_star} ± {stderr}");
    }
}

/// Slope and drift of the baseline, drift of the position, and the sensitivity: made into the rows, and found again.
#[test]
fn trends_are_found_again() {
    let tip = &tips()[0];
    for stiffness in [None, Some(40.0)] {
        let record = Record { works: [0.03, 0.03], stiffness, ..USUAL };
        let unit = 1.0 / stiffness.unwrap_or(1.0);
        let curve = record.curve(tip);
        let span = curve.x[record.rows - 1] - curve.x[0];
        let count = curve.x.len() as f64 - 1.0;
        let cases: [(&str, f64); 3] =
            [("baseline_slope", 2e-6 / span * unit), ("baseline_drift", 5e-7 * unit), ("position_drift", 0.05 * span)];
        for (name, made) in cases {
            let mut moved = record.curve(tip);
            for index in 0..moved.x.len() {
                let time = index as f64 / count;
                match name {
                    "baseline_slope" => moved.y[index] += made * (moved.x[index] - CONTACT_POINT),
                    "baseline_drift" => moved.y[index] += made * time,
                    _ => moved.x[index] += made * time,
                }
            }
            let free = ["e_star", "work_of_adhesion", "contact_point", "baseline", name];
            let fit = record.problem(tip, &moved, &free).fit().unwrap();
            assert_eq!(fit.status, FitStatus::Fitted, "{name} {}", fit.reason);
            assert!(fit.chi2.unwrap() <= moved.chi2, "{name} {:?} {}", fit.chi2, moved.chi2);
            for (name, made) in [("e_star", E_STAR), ("work_of_adhesion", 0.03), (name, made)] {
                let [value, stderr] = estimate(&fit, name);
                assert!(((value - made) / stderr).abs() < 4.0, "{name} {value} ± {stderr} for {made}");
            }
            // Given, it leaves the other numbers as they were.
            let plain = record.problem(tip, &curve, &free[..4]).fit().unwrap();
            let given = record.problem(tip, &moved, &free[..4]).fixed(name, made).unwrap().fit().unwrap();
            let [one, other] = [&plain, &given].map(|fit| estimate(fit, "e_star"));
            assert!(((one[0] - other[0]) / one[1]).abs() < 1e-3, "{name} {one:?} {other:?}");
            let times: Vec<f64> = (0..moved.x.len()).map(|index| 10.0 * index as f64 / count).collect();
            let timed = record.problem(tip, &moved, &free).times(&times).unwrap().fit().unwrap();
            let ratio = if name == "baseline_slope" { 1.0 } else { 10.0 };
            let [one, other] = [&fit, &timed].map(|fit| estimate(fit, name));
            assert!((one[0] / other[0] / ratio - 1.0).abs() < 1e-4, "{name} {one:?} {other:?}");
        }
    }
}

/// The budget is what further fits find, and of the sensitivity and the stiffness what scaling says.
#[test]
fn the_budget_is_that_of_further_fits() {
    let tip = &tips()[0];
    let record = Record { works: [0.03, 0.03], stiffness: Some(40.0), ..USUAL };
    let curve = record.curve(tip);
    let free = ["e_star", "work_of_adhesion", "contact_point", "baseline"];
    let problem = || record.problem(tip, &curve, &free);
    let fit = problem().fit().unwrap();
    let slope =
        |name: &str, of: &str| fit.budget.iter().find(|entry| entry.name == name && entry.of == of).unwrap().slope;
    let step = 1e-3_f64;
    for (of, value) in [("stiffness", 40.0), ("sensitivity", 1.0)] {
        let moved = [step, -step].map(|step| problem().fixed(of, value * step.exp()).unwrap().fit().unwrap());
        for name in ["e_star", "work_of_adhesion"] {
            let [one, other] = [&moved[0], &moved[1]].map(|fit| estimate(fit, name)[0]);
            let difference = (one / other).ln() / (2.0 * step);
            // Residuals of one per cent keep the linearised model within some per cent of the full one.
            assert!((slope(name, of) / difference - 1.0).abs() < 0.05, "{name} {of}: {} {difference}", slope(name, of));
        }
    }
    assert!(slope("e_star", "stiffness") > 0.5 && slope("e_star", "radius") < -0.1);
}

/// Two cycles in one file: four legs, with and without their names.
#[test]
fn two_cycles_are_recognised() {
    let tip = &tips()[0];
    let [one, two] = [3, 4].map(|seed| Record { seed, ..USUAL }.curve(tip));
    let x = [one.x, two.x].concat();
    let y = [one.y, two.y].concat();
    let legs = [one.legs, two.legs].concat();
    let curve = Curve { x, y, legs, sigma: one.sigma, chi2: one.chi2 + two.chi2, pull_off: one.pull_off };
    let named = USUAL.problem(tip, &curve, &FIVE).fit().unwrap();
    let problem = Problem::new(tip.shape.clone(), Observation::ForceOfIndentation, &curve.x, &curve.y).unwrap();
    let found = problem.sigma_y(curve.sigma).unwrap().free(FIVE).unwrap().fit().unwrap();
    for fit in [&named, &found] {
        assert_eq!(fit.legs.len(), 4, "{:?}", fit.legs);
        assert!(fit.warnings.iter().any(|warning| warning.contains("2 cycles")), "{:?}", fit.warnings);
        assert!(fit.status == FitStatus::Fitted && fit.chi2.unwrap() <= curve.chi2, "{:?} {}", fit.chi2, curve.chi2);
        for (name, made) in [("e_star", E_STAR), ("advancing", 0.01), ("receding", 0.04)] {
            let [value, stderr] = estimate(fit, name);
            assert!(((value - made) / stderr).abs() < 4.0, "{name} {value} ± {stderr}");
        }
    }
}

/// Adhesion force, force before the jump and work of separation against the curve that was made.
#[test]
fn quantities_are_those_of_the_curve() {
    let tip = &tips()[0];
    let record = Record { noise: 1e-4, rows: 400, ..USUAL };
    let curve = record.curve(tip);
    let fit = record.problem(tip, &curve, &FIVE).fit().unwrap();
    let value = |name: &str| fit.quantity(name).unwrap().value;
    // JKR: 3/2 πwR, at fixed grips 5/9 of it before the jump.
    let pull = 1.5 * PI * 0.04 * 1e-5;
    assert!((value("adhesion_force") / pull - 1.0).abs() < 1e-3, "{}", value("adhesion_force") / pull);
    assert!((value("pull_off_force") * 9.0 / 5.0 / pull - 1.0).abs() < 2e-2, "{}", value("pull_off_force") / pull);
    assert!((value("adhesion_force_measured") / pull - 1.0).abs() < 1e-2);
    // By the rows, up to the last interval.
    let ratio = value("separation_work_measured") / value("separation_work");
    assert!((ratio - 1.0).abs() < 2e-2, "{ratio}");
}

#[test]
fn what_makes_no_sense_is_refused_by_name() {
    let tip = &tips()[0];
    let curve = USUAL.curve(tip);
    let problem = || Problem::new(tip.shape.clone(), Observation::ForceOfIndentation, &curve.x, &curve.y).unwrap();
    let refused = |problem: mdr::Result<Problem>, word: &str| {
        let error = problem.and_then(|problem| problem.fit()).unwrap_err().to_string();
        assert!(error.contains(word), "{error}");
    };
    refused(problem().free(["e_star", "e_star"]), "named twice");
    refused(problem().free(["e_star", "work_of_adhesion"]).unwrap().start("radius", 1e-5), "`radius` is not free");
    refused(problem().free(["e_star", "work_of_adhesion", "advancing"]), "one number for both directions");
    refused(problem().free(["e_star", "advancing"]), "`work_of_adhesion.receding` is neither free nor given");
    refused(problem().free(["e_star", "work_of_adhesion"]).unwrap().within(Some([2.0, 1.0]), None), "must ascend");
    refused(problem().free(["e_star", "work_of_adhesion"]).unwrap().within(Some([1.0, 2.0]), None), "left out are");
    let mut order: Vec<usize> = (0..curve.x.len()).collect();
    let mut normal = Normal(31);
    order.sort_by_cached_key(|_| (normal.next() * 1e9) as i64);
    let [x, y] = [&curve.x, &curve.y].map(|values| order.iter().map(|index| values[*index]).collect::<Vec<_>>());
    let shuffled = Problem::new(tip.shape.clone(), Observation::ForceOfIndentation, &x, &y).unwrap();
    refused(shuffled.free(["e_star", "work_of_adhesion"]), "in the order in which they were recorded");
}

/// The ends of a detector, and rows that are not numbers.
#[test]
fn rows_that_do_not_count_are_counted() {
    let text = "x,y\nnm,nN\n0,1\n10,nan\n20,3\n30,\n40,9\n50,9\n60,9\n70,9\n";
    let files = |_: &str| -> std::io::Result<Vec<u8>> { Ok(text.as_bytes().to_vec()) };
    let toml = |more: &str| {
        format!(
            "[profile]\nkind = \"paraboloid\"\nradius = \"1e-5\"\n[data]\nfile = \"a.csv\"\nobservation = \"F(d)\"\n{more}\n[fit]\nfree = [\"e_star\"]\n\
             [material]\nwork_of_adhesion = \"0\"\n"
        )
    };
    let error = Problem::from_toml(&toml(""), "a", &files).unwrap_err().to_string();
    assert!(error.contains("line 4") && error.contains("not a number"), "{error}");
    let fit = Problem::from_toml(&toml("missing = \"skip\"\nrows = { x = [\"0 nm\", \"65 nm\"] }"), "a", &files)
        .unwrap()
        .fit()
        .unwrap();
    let counts: Vec<_> = fit.skipped.iter().map(|skipped| (skipped.why, skipped.rows)).collect();
    assert_eq!(counts, [("not a number", 2), ("outside of x", 1)]);
    let saturated = "missing = \"skip\"\nsaturation = [\"-9 nN\", \"9 nN\"]";
    let error = Problem::from_toml(&toml(saturated), "a", &files).unwrap().fit().unwrap_err().to_string();
    assert!(error.contains("at least three rows") && error.contains("4 saturated"), "{error}");
}

/// Force by the formulas of this file: a paraboloid or another tip by its g and ∫g, pressed in by d.
#[cfg(feature = "mp")]
struct Own<'t> {
    tip: &'t Tip,
    e_star: f64,
}

#[cfg(feature = "mp")]
impl Own<'_> {
    fn depth(&self, a: f64, work: f64) -> f64 {
        (self.tip.formula)(a)[0] - (2.0 * PI * a * work / self.e_star).sqrt()
    }

    fn force(&self, a: f64, d: f64) -> f64 {
        2.0 * self.e_star * (a * d - (self.tip.formula)(a)[1])
    }

    /// The radius at a depth, near another.
    fn radius(&self, d: f64, work: f64, near: f64) -> f64 {
        let [mut low, mut high] = [0.97 * near, 1.03 * near];
        assert!(self.depth(low, work) < d && self.depth(high, work) > d);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            *if self.depth(middle, work) > d { &mut high } else { &mut low } = middle;
        }
        0.5 * (low + high)
    }
}

/// Estimates in proved digits, of two works of adhesion and with slope and drift of the baseline, are where the sum of squares of this file's
/// own formulas has the certified value and its minimum.
#[cfg(feature = "mp")]
#[test]
fn proved_digits_are_at_the_minimum_of_other_formulas() {
    for (tip, seed) in few_tips().zip(1..) {
        let record = Record { rows: 24, seed, ..USUAL };
        let curve = record.curve(&tip);
        let free = ["e_star", "advancing", "receding", "contact_point", "baseline", "baseline_slope", "baseline_drift"];
        let fit = record.problem(&tip, &curve, &free).digits(12).fit().unwrap();
        let certified = fit.certified.as_ref().unwrap_or_else(|| panic!("{}: {:?}", tip.shape.name(), fit.warnings));
        assert!(certified.local_minimum);
        let found: Vec<f64> = certified.parameters.iter().map(|estimate| estimate.value.to_f64()).collect();
        for (estimate, found) in fit.parameters.iter().zip(&found) {
            let difference = (estimate.value.unwrap() - found).abs() / estimate.stderr.unwrap();
            assert!(difference < 1e-6, "{}: {difference:e}", estimate.name);
        }
        let sum = |numbers: &[f64]| -> f64 {
            let [e_star, w1, w2, contact_point, baseline, slope, drift] = *numbers else { panic!("seven numbers") };
            let own = Own { tip: &tip, e_star };
            let turn = curve.x[record.rows] - contact_point;
            let pinned = own.radius(turn, w1, tip.widest);
            let square = |(index, row): (usize, &mdr_fit::FittedRow)| {
                let d = row.x - contact_point;
                let force = match row.contact_radius {
                    None => 0.0,
                    Some(_) if row.pinned => own.force(pinned, d),
                    Some(near) => own.force(own.radius(d, if row.leg == Leg::Approach { w1 } else { w2 }, near), d),
                };
                let time = index as f64 / (curve.x.len() - 1) as f64;
                ((force + baseline + slope * d + drift * time - row.y) / curve.sigma).powi(2)
            };
            fit.rows.iter().enumerate().map(square).sum()
        };
        let least = sum(&found);
        let stated = certified.rss.to_f64() / curve.sigma.powi(2);
        assert!((least / stated - 1.0).abs() < 1e-9, "{}: {least} and {stated}", tip.shape.name());
        for (place, estimate) in certified.parameters.iter().enumerate() {
            let [below, above] = [-1e-2, 1e-2].map(|step| {
                let mut moved = found.clone();
                moved[place] += step * fit.parameters[place].stderr.unwrap();
                sum(&moved)
            });
            // The slope against the curvature, of which 1e-4 is left to terms of third order.
            let (slope, bend) = (above - below, above + below - 2.0 * least);
            assert!(bend > 0.0 && slope.abs() < 2e-2 * bend, "{}: {slope:e}, {bend:e}", estimate.name);
        }
    }
}

/// A slope of the baseline or a sign that is reversed, of which the problem knows nothing, is named.
#[test]
fn what_a_record_has_beside_the_problem_is_named() {
    let tip = few_tips().next().unwrap();
    let curve = USUAL.curve(&tip);
    let warned = |y: &[f64]| {
        let other = Curve { x: curve.x.clone(), y: y.to_vec(), legs: curve.legs.clone(), ..curve };
        USUAL.problem(&tip, &other, &FIVE).fit().unwrap().warnings
    };
    let has = |warnings: &[String], what: &str| warnings.iter().any(|warning| warning.contains(what));
    let all = ["looks like", "reversed", "not random", "rough"];
    let none = warned(&curve.y);
    assert!(!all.iter().any(|what| has(&none, what)), "{none:?}");
    let span = curve.x[USUAL.rows] - curve.x[0];
    let sloped: Vec<f64> =
        curve.x.iter().zip(&curve.y).map(|(x, y)| y + 40.0 * curve.sigma * (x - curve.x[0]) / span).collect();
    let warnings = warned(&sloped);
    assert!(has(&warnings, "with `baseline_slope` free"), "{warnings:?}");
    let reversed: Vec<f64> = curve.y.iter().map(|y| -y).collect();
    let warnings = warned(&reversed);
    assert!(has(&warnings, "with the sign of y reversed"), "{warnings:?}");
}

/// Two works of adhesion of a contact without any are both zero or hardly told from it; upper limits are beyond their scatter.
#[test]
fn two_works_may_both_be_zero() {
    let tip = few_tips().next().unwrap();
    for seed in 1..=2 {
        let record = Record { works: [0.0, 1e-9], seed, noise: 1.0, ..USUAL };
        let adhesive = USUAL.curve(&tip);
        let mut curve = record.curve(&tip);
        // Noise as beside adhesion.
        let mut normal = Normal(77 * seed);
        curve.sigma = adhesive.sigma;
        curve.y.iter_mut().for_each(|y| *y += adhesive.sigma * normal.next());
        let fit = record.problem(&tip, &curve, &FIVE).fit().unwrap();
        assert_eq!(fit.status, FitStatus::Fitted, "{}", fit.reason);
        for name in ["work_of_adhesion.advancing", "work_of_adhesion.receding"] {
            let estimate = fit.estimate(name).unwrap();
            let (value, stderr) = (estimate.value.unwrap(), estimate.stderr.unwrap_or(0.0));
            assert!(value < 1e-3, "{estimate:?}");
            if let Some(limit) = fit.limits.iter().find(|limit| limit.name == name) {
                assert!(limit.upper.unwrap() > value + stderr && limit.upper.unwrap() < 2e-3, "{limit:?}");
            }
        }
    }
}
