//! Fits find the least sum of squares: of no curve are the estimates accepted at a minimum above that of the numbers it was made from.
#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

mod normal;
mod tips;

use mdr_fit::{FitStatus, Leg, Observation, Problem};
use std::f64::consts::PI;

use normal::Normal;
use tips::{CONTACT_POINT, E_STAR, Tip, estimate, tips};

/// How a curve is recorded.
#[derive(Clone, Copy, Debug)]
struct Record {
    work: f64,
    /// The cantilever, where there is one.
    stiffness: Option<f64>,
    approach: bool,
    retract: bool,
    /// Where it ends, against the place of pull-off, with a tail beyond it where that is more than one.
    end: f64,
    /// Rows of a leg.
    rows: usize,
    /// σ_Y against the force of pull-off.
    noise: f64,
    seed: u64,
}

const USUAL: Record =
    Record { work: 0.05, stiffness: None, approach: false, retract: true, end: 1.3, rows: 80, noise: 1e-2, seed: 1 };

/// Rows and σ_Y, with the sum of squares of their errors in units of it.
struct Curve {
    x: Vec<f64>,
    y: Vec<f64>,
    legs: Vec<Leg>,
    sigma: f64,
    chi2: f64,
}

impl Record {
    /// (X, F) of the contact radius.
    fn state(&self, tip: &Tip, a: f64) -> [f64; 2] {
        let [g, integral] = (tip.formula)(a);
        let d = g - (2.0 * PI * a * self.work / E_STAR).sqrt();
        let force = 2.0 * E_STAR * (a * d - integral);
        [d + self.stiffness.map_or(0.0, |stiffness| force / stiffness), force]
    }

    fn observation(&self) -> Observation {
        if self.stiffness.is_some() { Observation::DeflectionOfPosition } else { Observation::ForceOfIndentation }
    }

    fn curve(&self, tip: &Tip) -> Curve {
        let x_of = |a: f64| self.state(tip, a)[0];
        // From outside in as far as X falls.
        let mut fold = tip.widest;
        while x_of(fold * 0.9995) < x_of(fold) {
            fold *= 0.9995;
        }
        let [last, _] = self.state(tip, fold);
        let [first, _] = self.state(tip, tip.widest);
        let force = |x: f64| {
            let (mut low, mut high) = (fold, tip.widest);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                *if x_of(middle) > x { &mut high } else { &mut low } = middle;
            }
            self.state(tip, 0.5 * (low + high))[1]
        };
        let lowest = (0..400).map(|i| self.state(tip, fold + (tip.widest - fold) * f64::from(i) / 400.0)[1]);
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        let unit = 1.0 / self.stiffness.unwrap_or(1.0);
        let sigma = self.noise * lowest.abs() * unit;
        let mut normal = Normal(0x9e37_79b9_7f4a_7c15 ^ (self.seed * 7919));
        let (mut x, mut y, mut legs, mut chi2) = (Vec::new(), Vec::new(), Vec::new(), 0.0);
        let share = |index: usize| index as f64 / (self.rows - 1) as f64;
        let mut add = |at: f64, held: f64, leg: Leg| {
            let error = normal.next();
            chi2 += error * error;
            x.push(at + CONTACT_POINT);
            y.push(if at >= held { force(at) * unit } else { 0.0 } + sigma * error);
            legs.push(leg);
        };
        if self.approach {
            let far = -0.4 * first;
            (0..self.rows).for_each(|index| add(far + (first - far) * share(index), 0.0, Leg::Approach));
        }
        if self.retract {
            let end = if self.end <= 1.0 { self.end * last } else { self.end * last - 0.2 * first };
            (0..self.rows).for_each(|index| add(first + (end - first) * share(index), last, Leg::Retract));
        }
        Curve { x, y, legs, sigma, chi2 }
    }

    fn problem(&self, tip: &Tip, curve: &Curve, free: &[&str]) -> Problem {
        let problem = Problem::new(tip.shape.clone(), self.observation(), &curve.x, &curve.y).unwrap();
        let problem = problem.legs(&curve.legs).unwrap().sigma_y(curve.sigma).unwrap();
        let problem = match free.contains(&"contact_point") {
            true => problem,
            false => problem.fixed("contact_point", CONTACT_POINT).unwrap(),
        };
        let problem = match self.stiffness {
            Some(stiffness) => problem.fixed("stiffness", stiffness).unwrap(),
            None => problem,
        };
        problem.free(free.iter().copied()).unwrap()
    }
}

const THREE: [&str; 3] = ["e_star", "work_of_adhesion", "contact_point"];
const FOUR: [&str; 4] = ["e_star", "work_of_adhesion", "contact_point", "baseline"];

/// The fault of a fit of a curve, if there is one.
fn fault(record: &Record, tip: &Tip, free: &[&str]) -> Option<String> {
    let curve = record.curve(tip);
    let what = format!("{} {record:?} {}", tip.shape.name(), free.len());
    let fit = match record.problem(tip, &curve, free).fit() {
        Ok(fit) => fit,
        Err(error) => return Some(format!("{what}: {error}")),
    };
    let chi2 = fit.chi2.unwrap();
    match fit.status {
        // The numbers that it was made from are among those that a fit chooses from.
        FitStatus::Fitted if chi2 > curve.chi2 * (1.0 + 1e-9) => {
            let [work, stderr] = estimate(&fit, "work_of_adhesion");
            Some(format!("{what}: χ² = {chi2}, that of the truth is {}; w = {work} ± {stderr}", curve.chi2))
        }
        FitStatus::Fitted => {
            let [work, stderr] = estimate(&fit, "work_of_adhesion");
            // What is far off is said.
            let is_said = !fit.warnings.is_empty() || ((work - record.work) / stderr).abs() < 5.0;
            (!is_said).then(|| format!("{what}: w = {work} ± {stderr} without a warning"))
        }
        // Adhesion that is not seen.
        FitStatus::NotConverged if fit.reason.contains("`work_of_adhesion` tends to zero") => None,
        status => Some(format!("{what}: {status:?}, {}", fit.reason)),
    }
}

fn check(records: impl Iterator<Item = Record>) {
    let mut faults = Vec::new();
    let mut count = 0;
    for record in records {
        for tip in tips() {
            for free in [&THREE[..], &FOUR] {
                count += 1;
                faults.extend(fault(&record, &tip, free));
            }
        }
    }
    assert!(faults.is_empty(), "{} of {count}:\n{}", faults.len(), faults.join("\n"));
}

/// Records that end before pull-off, or with a tail, of one leg or both, with and without a cantilever.
#[test]
fn no_record_is_fitted_above_the_truth() {
    let ends = [0.5, 0.7, 0.9, 0.99, 1.3];
    let records = ends.into_iter().flat_map(|end| {
        [false, true].into_iter().flat_map(move |approach| {
            [None, Some(40.0)].into_iter().map(move |stiffness| Record {
                end,
                approach,
                stiffness,
                seed: 3 + (100.0 * end) as u64,
                ..USUAL
            })
        })
    });
    check(records);
}

/// An error of x that is not stated shows in residuals that grow with the slope of the curve; exact x are not taken for it.
#[test]
fn an_error_of_x_that_is_not_stated_is_named() {
    let named = |record: &Record, error: f64| {
        let tip = &tips()[0];
        let mut curve = record.curve(tip);
        let mut normal = Normal(0x51_7cc1 + record.seed);
        let spacing = (curve.x[1] - curve.x[0]).abs();
        curve.x.iter_mut().for_each(|x| *x += error * spacing * normal.next());
        let fit = record.problem(tip, &curve, &FOUR).fit().unwrap();
        fit.warnings.iter().any(|warning| warning.contains("taken for exact"))
    };
    let records = |noise: f64| (0..10).map(move |seed| Record { noise, seed, rows: 150, ..USUAL });
    let missed = records(2e-2).filter(|record| !named(record, 0.5)).count();
    assert!(missed == 0, "{missed} of 10 are not named");
    let wrong = records(2e-2).chain(records(1e-1)).filter(|record| named(record, 0.0)).count();
    assert!(wrong == 0, "{wrong} of 20 exact records are named");
}

/// Where a record ends at the fold, nothing bounds the place of the fold from beyond: a fold that is held there tells nothing of the errors,
/// and the warning says that the contact may break later.
#[test]
fn a_fold_held_at_the_end_of_a_record_is_no_datum() {
    let tip = &tips()[0];
    let mut held = 0;
    for seed in 0..12 {
        let record = Record { end: 1.0, rows: 150, noise: 0.1, seed, ..USUAL };
        let curve = record.curve(tip);
        let fit = record.problem(tip, &curve, &FOUR).fit().unwrap();
        if !fit.warnings.iter().any(|warning| warning.contains("no row lies beyond it")) {
            continue;
        }
        held += 1;
        let [work, stderr] = estimate(&fit, "work_of_adhesion");
        assert!(((work - record.work) / stderr).abs() < 4.0, "seed {seed}: w = {work} ± {stderr}");
        assert!(fit.tried[0].detached == 0, "seed {seed}: {:?}", fit.tried[0]);
    }
    assert!(held > 0, "no fold is held");
}

/// If the last row is nearer to the fold than the noise resolves, the sum of squares has a kink and several minima.
#[test]
fn the_last_row_may_be_at_the_fold() {
    let record =
        |seed: u64| Record { rows: 80 + 170 * (seed % 2) as usize, end: 1.2 + 0.007 * seed as f64, seed, ..USUAL };
    check((1..20).map(record).chain([
        Record { end: 1.434_086_938_692_628_3, seed: 81005, ..USUAL },
        Record { end: 1.432_044_982_930_840_4, seed: 81045, ..USUAL },
        Record { end: 1.340_006_256_561_929_3, seed: 81046, ..USUAL },
    ]));
}

/// An approach alone, with adhesion that is seen, hardly seen, and not.
#[test]
fn an_approach_alone_is_fitted_at_the_least() {
    let works = [0.05, 5e-3, 5e-4];
    check(works.into_iter().map(|work| Record {
        work,
        approach: true,
        retract: false,
        noise: 1e-2 * 0.05 / work,
        ..USUAL
    }));
}

/// All stated standard deviations times a factor: the estimates stay, errors follow, and the status follows from χ².
#[test]
fn a_common_factor_of_sigma_moves_no_estimate() {
    let tips = tips();
    for (tip, stiffness, x_share) in [(&tips[0], None, 0.0), (&tips[1], None, 2e-3), (&tips[3], Some(40.0), 2e-3)] {
        let record = Record { stiffness, noise: 2e-2, ..USUAL };
        let curve = record.curve(tip);
        let span = curve.x[0] - curve.x[curve.x.len() - 1];
        let fit = |factor: f64| {
            let problem = record.problem(tip, &curve, &FOUR).sigma_y(curve.sigma * factor).unwrap();
            let problem = problem.sigma_x(x_share * span * factor).unwrap();
            problem.profile_likelihood().fit().unwrap()
        };
        let plain = fit(1.0);
        assert_eq!(plain.status, FitStatus::Fitted, "{}", plain.reason);
        for factor in [1e-294, 1e-6, 0.03, 30.0, 1e290] {
            let other = fit(factor);
            let status = if factor < 0.1 { FitStatus::PoorFit } else { FitStatus::Fitted };
            assert_eq!(other.status, status, "{factor}: {}", other.reason);
            for (one, other) in plain.parameters.iter().zip(&other.parameters) {
                let [value, stderr] = [one.value.unwrap(), one.stderr.unwrap()];
                let moved = (other.value.unwrap() - value).abs() / stderr;
                assert!(moved < 1e-6, "{} {factor}: {one:?} {other:?}", tip.shape.name());
                if let Some(scaled) = other.stderr {
                    assert!((scaled / (stderr * factor) - 1.0).abs() < 1e-5, "{factor}: {one:?} {other:?}");
                }
            }
            assert!(factor > 0.1 || other.reason.contains("σ is too small"), "{}", other.reason);
            for (one, other) in plain.correlation.iter().flatten().zip(other.correlation.iter().flatten()) {
                assert!((one - other).abs() < 1e-6, "{factor}: {one} {other}");
            }
            assert!(other.rows.iter().all(|row| row.residual.is_finite()));
        }
    }
}

/// Numbers that are typed far off, starting values and given values: half of them for each tip.
#[test]
fn absurd_numbers_are_answered_or_refused() {
    for (index, tip) in tips().into_iter().enumerate() {
        let curve = USUAL.curve(&tip);
        let problem = || USUAL.problem(&tip, &curve, &THREE);
        for (name, value) in ["e_star", "work_of_adhesion"]
            .into_iter()
            .flat_map(|name| [1e-300, 1e-30, 1e-9, 1e30, 1e300].map(|value| (name, value)))
            .skip(index % 2)
            .step_by(2)
        {
            let fit = problem().start(name, value).unwrap().fit().unwrap();
            let chi2 = fit.chi2.unwrap();
            assert!(
                fit.status == FitStatus::Fitted && chi2 <= curve.chi2,
                "{} {name} {value}: {chi2}",
                tip.shape.name()
            );
            // Given instead of free it is no fit, or no answer, but never a good one.
            let free: Vec<&str> = THREE.into_iter().filter(|free| *free != name).collect();
            match USUAL.problem(&tip, &curve, &free).fixed(name, value).unwrap().fit() {
                Ok(fit) => assert!(fit.status != FitStatus::Fitted, "{} {name} = {value}: {fit:?}", tip.shape.name()),
                Err(error) => assert!(error.to_string().len() > 40, "{error}"),
            }
        }
    }
}

/// A contact without adhesion, w given as next to nothing: Hertz.
#[test]
fn adhesion_that_is_given_as_nothing() {
    for tip in tips().iter().take(4) {
        let record = Record { work: 1e-12, end: 1.0, noise: 1.0, ..USUAL };
        let mut curve = record.curve(tip);
        curve.x.iter().zip(&mut curve.y).for_each(|(x, y)| {
            if *x < CONTACT_POINT {
                *y = 0.0
            }
        });
        for work in [1e-12, 1e-30, 1e-100] {
            let problem =
                record.problem(tip, &curve, &["e_star", "contact_point"]).fixed("work_of_adhesion", work).unwrap();
            let fit = problem.sigma_y(0.0).unwrap().fit().unwrap();
            let [e_star, _] = estimate(&fit, "e_star");
            assert!(
                (e_star / E_STAR - 1.0).abs() < 1e-3,
                "{} {work}: {e_star:e} {:?} {}",
                tip.shape.name(),
                fit.status,
                fit.reason
            );
        }
    }
}

/// x is exact unless its σ is given; the place of the jump is a bracket.
#[test]
fn x_is_exact_unless_its_sigma_is_given() {
    let tip = &tips()[0];
    let curve = USUAL.curve(tip);
    let fit = |sigma: Option<f64>| {
        let problem = USUAL.problem(tip, &curve, &FOUR);
        sigma.map_or(Ok(problem.clone()), |sigma| problem.sigma_x(sigma)).unwrap().fit().unwrap()
    };
    let plain = fit(None);
    assert_eq!((plain.distance, plain.sigma[0]), ("vertical", 0.0));
    assert_eq!(plain, fit(Some(0.0)));
    assert_eq!(fit(Some(1e-9)).distance, "orthogonal");
    let [last, first] = plain.pull_off_between.unwrap();
    assert!(last > first && curve.x.windows(2).any(|pair| pair == [last, first]));
    let fold = plain.predicted_pull_off.unwrap();
    assert!(fold.x <= last, "the fold is at or beyond the last row in contact");
    assert!(plain.tried.len() > 1 && plain.tried.windows(2).all(|pair| pair[0].rss <= pair[1].rss));
}

/// How often the intervals of one and of two standard errors hold E* and w, of four free numbers with a tail and x exact.
#[test]
#[ignore = "some minutes in a debug build"]
fn intervals_of_four_numbers_cover_as_often_as_they_say() {
    let tips = tips();
    let numbers = [("e_star", E_STAR), ("work_of_adhesion", USUAL.work)];
    for rows in [80, 250] {
        let (mut inside, mut count) = ([[0.0_f64; 2]; 2], 0.0);
        for (which, tip) in [0, 1, 3].map(|which| (which, &tips[which as usize])) {
            for seed in 1..=50 {
                let mut place = Normal(seed * 104_729 + 17 + 1_000_003 * which);
                place.next();
                let end = 1.2 + 0.3 * place.uniform();
                let record = Record { seed: seed + 1000 * rows as u64 + 500 * which, rows, end, ..USUAL };
                let curve = record.curve(tip);
                let fit = record.problem(tip, &curve, &FOUR).fit().unwrap();
                assert_eq!(fit.status, FitStatus::Fitted, "{}", fit.reason);
                count += 1.0;
                for ((name, made), inside) in numbers.into_iter().zip(&mut inside) {
                    let [value, stderr] = estimate(&fit, name);
                    let pull = ((value - made) / stderr).abs();
                    for (share, limit) in inside.iter_mut().zip([1.0, 2.0]) {
                        *share += f64::from(u8::from(pull < limit));
                    }
                }
            }
        }
        for [one, two] in inside.map(|inside| inside.map(|inside| inside / count)) {
            // Of 150 numbers: three standard deviations of a binomial share.
            assert!((one - 0.683).abs() < 0.114 && (two - 0.954).abs() < 0.052, "{rows} rows: {one} {two}");
        }
    }
}

/// The coverage of docs/fit.md: five tips, x exact or with an error, σ stated or not; `MDR_COVERAGE` curves of each tip, 200 by default.
#[test]
#[ignore = "minutes; prints the table of docs/fit.md"]
#[allow(clippy::print_stdout, reason = "the table")]
fn coverage_of_five_tips() {
    let each: u64 = std::env::var("MDR_COVERAGE").ok().and_then(|count| count.parse().ok()).unwrap_or(200);
    let numbers = [("e_star", E_STAR), ("work_of_adhesion", USUAL.work)];
    for (has_error, is_stated) in [(false, true), (false, false), (true, true), (true, false)] {
        let (mut inside, mut count, mut others) = ([[0.0_f64; 2]; 2], 0.0, 0);
        for (which, tip) in tips().iter().enumerate() {
            for seed in 1..=each {
                let mut normal = Normal(seed * 104_729 + 17 + 1_000_003 * which as u64);
                normal.next();
                let end = 1.2 + 0.3 * normal.uniform();
                let record = Record { seed: seed + 100_000 * (1 + which as u64), rows: 200, end, ..USUAL };
                let mut curve = record.curve(tip);
                // Of the depth of the last row, 1 %.
                let sigma = 1e-2 * (curve.x[curve.x.len() - 1] - CONTACT_POINT).abs();
                if has_error {
                    curve.x.iter_mut().for_each(|x| *x += sigma * normal.next());
                }
                let mut problem = record.problem(tip, &curve, &FOUR);
                if has_error {
                    problem = problem.sigma_x(sigma).unwrap();
                }
                if !is_stated && !has_error {
                    problem = problem.sigma_y(0.0).unwrap();
                }
                let fit = problem.fit().unwrap();
                if fit.status != FitStatus::Fitted {
                    others += 1;
                    continue;
                }
                count += 1.0;
                for ((name, made), inside) in numbers.into_iter().zip(&mut inside) {
                    let estimate = fit.estimate(name).unwrap();
                    // Scaled by the residuals where σ is to be taken as known up to a factor.
                    let stderr = if is_stated { estimate.stderr } else { estimate.scaled_stderr }.unwrap();
                    let pull = ((estimate.value.unwrap() - made) / stderr).abs();
                    for (share, limit) in inside.iter_mut().zip([1.0, 2.0]) {
                        *share += f64::from(u8::from(pull < limit));
                    }
                }
            }
        }
        let shares = inside.map(|inside| inside.map(|inside| 100.0 * inside / count));
        println!(
            "x with an error: {has_error}, σ stated: {is_stated}, {count} curves, {others} not fitted: {shares:.1?}"
        );
        for [one, two] in shares {
            let deviations = |share: f64, right: f64| (share - right).abs() / (right * (100.0 - right) / count).sqrt();
            assert!(deviations(one, 68.27) < 4.0 && deviations(two, 95.45) < 5.0, "{one} {two}");
        }
    }
}
