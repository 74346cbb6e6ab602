//! This workspace beside other projects: ratios of times that are taken in turns.
//!
//! In a [`Race`] both sides answer the same question; they take turns, so that a busy machine slows both, and both answers
//! are judged, since a fast wrong one does not count. Enclosures race enclosures.

use std::cell::RefCell;
use std::hint::black_box;

use mdr_analytic::double::Inverse;
use mdr_analytic::double::grid::{Materials, Points, States, critical_states};
use mdr_core::contact::{Control, Equilibrium, Error, Material, Ranged, Result, Status};
use mdr_core::number::{Interval, Precision, Real};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::outside::{self, Outsiders, Python, Reply, question};
use super::precision::{self, Entry, Found, Question, truth};
use super::{Arithmetic, Clock, Effort, Outcome, Time};

/// One side of a race.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Side {
    /// Who answers, with its version if it is another project.
    pub name: String,
    /// How right it is.
    pub outcome: Outcome,
    /// How long one answer takes.
    pub time: Time,
}

/// Two answers to one question, timed in turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Race {
    /// What is asked.
    pub question: String,
    /// This workspace.
    pub ours: Side,
    /// The fastest way that the other project has.
    pub theirs: Side,
    /// How many times faster this workspace is meant to be.
    pub aim: f64,
}

impl Race {
    /// How many times faster this workspace is.
    pub fn ratio(&self) -> f64 {
        self.theirs.time.median / self.ours.time.median
    }
}

/// All races that can be run, and a sentence for each that cannot. None without a clock.
pub fn races(effort: Effort, clock: &Clock) -> (Vec<Race>, Vec<String>) {
    let mut outsiders = Outsiders::new(clock);
    let python = match outsiders.python() {
        Ok(python) => python,
        Err(reason) => return (Vec::new(), reason.into_iter().collect()),
    };
    let mut hall = Hall { python, clock, races: Vec::new(), omissions: Vec::new() };
    let ladder: &[u32] = if effort == Effort::Full { &[50, 200, 1000, 10_000] } else { &[50, 200] };
    let most = ladder.last().copied().unwrap_or_default();
    for question in precision::questions(precision::enough(most)) {
        for &digits in ladder {
            hall.many_digits(&question, digits);
        }
    }
    hall.grid();
    hall.equilibria();
    (hall.races, hall.omissions)
}

/// Turns that each side takes.
const TURNS: usize = 3;

/// Where races are run.
struct Hall<'a> {
    python: &'a mut Python,
    clock: &'a Clock,
    races: Vec<Race>,
    omissions: Vec<String>,
}

/// How a race is run.
struct Lane<'a> {
    question: String,
    ours: &'static str,
    solver: &'a dyn Fn() -> Result<Vec<Found>>,
    /// The name, the package and the question of the other project.
    theirs: (&'a str, &'static str, Map<String, Value>),
    arithmetic: Arithmetic,
    truths: &'a [Interval],
    /// Answers of which one call consists.
    count: usize,
    aim: f64,
}

impl Hall<'_> {
    fn many_digits(&mut self, question: &Question, digits: u32) {
        let Some(Entry { name, solver, .. }) = question.entries.first() else { return };
        let Ok(solver) = solver(digits) else { return };
        let aim = match (question.id, digits) {
            ("kappa-irrational", _) => 1.0,
            (_, 10_000) => 5.0,
            _ => 3.0,
        };
        let race = |hall: &mut Self, &(theirs, by): &precision::Other| {
            hall.race(&Lane {
                question: format!("{}, {digits} digits", question.title),
                ours: name,
                solver: &*solver,
                theirs: (theirs, "python-flint", question.asked(by, digits)),
                arithmetic: Arithmetic::Certified,
                truths: &question.truths,
                count: 1,
                aim,
            })
        };
        let found: Vec<_> = question.arb.iter().map(|other| race(self, other)).collect();
        self.keep(found);
    }

    /// The race against the faster of several.
    fn keep(&mut self, found: Vec<std::result::Result<Race, String>>) {
        let (races, reasons): (Vec<_>, Vec<_>) = found.into_iter().partition(std::result::Result::is_ok);
        let fastest = races.into_iter().flatten().min_by(|one, other| one.ratio().total_cmp(&other.ratio()));
        self.races.extend(fastest);
        self.omissions.extend(reasons.into_iter().filter_map(std::result::Result::err));
    }

    fn race(&mut self, lane: &Lane<'_>) -> std::result::Result<Race, String> {
        let (theirs, package, asked) = &lane.theirs;
        let turn = match self.clock {
            Clock::Off => Clock::Off,
            Clock::Runs(runs) => Clock::Runs(runs.div_ceil(TURNS)),
        };
        let (mut our_times, mut their_times, mut answer) = (Vec::new(), Vec::new(), None);
        for _ in 0..TURNS {
            our_times.extend(turn.time(lane.solver));
            match self.python.ask(asked.clone(), &turn) {
                Reply::Absent(package) => return Err(format!("{theirs}: the package {package} is not installed.")),
                Reply::Failed(reason) => return Err(format!("{}: {theirs} failed: {reason}.", lane.question)),
                Reply::Found { values, time, .. } => {
                    their_times.extend(time);
                    answer = Some(outside::judged(&values, lane.truths, lane.arithmetic));
                }
            }
        }
        let failed = |error: Error| Outcome::Failed(error.to_string());
        let side = |name: String, outcome: Outcome, times: &[Time]| {
            let time = together(times, lane.count).ok_or("no time was taken")?;
            Ok::<_, String>(Side { name, outcome, time })
        };
        let ours = (lane.solver)().map_or_else(failed, |found| precision::judged(&found, lane.truths));
        let their_outcome = answer.unwrap_or_else(|| Outcome::Failed("no answer".to_owned()));
        Ok(Race {
            question: lane.question.clone(),
            ours: side(lane.ours.to_owned(), ours, &our_times)?,
            theirs: side(format!("{theirs} ({})", self.python.package(package)), their_outcome, &their_times)?,
            aim: lane.aim,
        })
    }

    /// κ, a, d, F in f64 over the points n = 0.8 + 1.2 t, C = 1 + t.
    fn grid(&mut self) {
        const POINTS: usize = 100_000;
        const PICKED: [usize; 3] = [0, 33_333, 99_999];
        let (e, w) = (1e4, 0.05);
        let Ok(material) = Material::new(e, w) else { return };
        let at = |i: usize| {
            let t = i as f64 / POINTS as f64;
            (0.8 + 1.2 * t, 1.0 + t)
        };
        let (exponent, coefficient): (Vec<f64>, Vec<f64>) = (0..POINTS).map(at).unzip();
        let points = Points { exponent: &exponent, coefficient: &coefficient, material: Materials::One(&material) };
        let truths: Vec<[Interval; 4]> = PICKED.iter().filter_map(|&i| critical_truth(at(i), e, w)).collect();
        // As the other side returns them: all κ, then all a, …
        let truths: Vec<Interval> = (0..4).flat_map(|k| truths.iter().map(move |state| state[k].clone())).collect();
        let table = RefCell::new([(); 4].map(|()| vec![0.0; POINTS]));
        let statuses = RefCell::new(vec![Status::Ok; POINTS]);
        let solver = || {
            let mut columns = table.borrow_mut();
            let [kappa, contact_radius, indentation, force] = &mut *columns;
            let status = &mut statuses.borrow_mut();
            let mut states = States { kappa, contact_radius, indentation, force, status };
            critical_states(&points, &Control::Indentation, &mut states)?;
            Ok(columns.iter().flat_map(|column| PICKED.map(|i| Found::Double(column[i]))).collect())
        };
        let asked = question! {
            "ask": "grid", "by": "scipy", "count": POINTS, "e": e.to_string(), "w": w.to_string(), "picked": PICKED,
        };
        let race = self.race(&Lane {
            question: format!("κ, a, d and F in f64, a point of {POINTS}"),
            ours: "double::grid",
            solver: &solver,
            theirs: ("numpy arrays and Γ", "scipy", asked),
            arithmetic: Arithmetic::Double,
            truths: &truths,
            count: POINTS,
            aim: 4.0,
        });
        self.keep(vec![race]);
    }

    /// Both equilibria of a paraboloid under tension, the critical radius being known to both sides.
    fn equilibria(&mut self) {
        let truths = jkr_radii();
        let ball = Material::new(1.0, 1.0).and_then(|glue| Inverse::new(2.0, 0.5, &glue, &Control::Indentation));
        let Ok(ball) = ball else { return };
        let value = |x: &Ranged<f64>| match x {
            Ranged::Value(value) => *value,
            _ => f64::NAN,
        };
        let solver = || {
            let found = ball.equilibria(black_box(-0.5))?;
            let radius = |state: &Equilibrium<Ranged<f64>>| Found::Double(value(&state.contact_radius));
            Ok(found.as_slice().iter().map(radius).collect())
        };
        let asked = question! {
            "ask": "equilibria", "by": "brentq", "n": "2", "c": "1/2", "e": "1", "w": "1", "d": "-1/2",
        };
        let race = self.race(&Lane {
            question: "both equilibria at a given d in f64, n = 2".to_owned(),
            ours: "double::Inverse",
            solver: &solver,
            theirs: ("brentq", "scipy", asked),
            arithmetic: Arithmetic::Double,
            truths: &truths,
            count: 1,
            aim: 1.0,
        });
        self.keep(vec![race]);
    }
}

/// One time from those of several turns, for one of so many answers.
fn together(times: &[Time], count: usize) -> Option<Time> {
    let mut medians: Vec<f64> = times.iter().map(|time| time.median).collect();
    medians.sort_by(f64::total_cmp);
    let share = |seconds: f64| seconds / count as f64;
    Some(Time {
        median: share(*medians.get(medians.len() / 2)?),
        least: share(times.iter().map(|time| time.least).fold(f64::INFINITY, f64::min)),
        most: share(times.iter().map(|time| time.most).fold(0.0, f64::max)),
        runs: times.iter().map(|time| time.runs).sum(),
    })
}

/// The critical state under fixed grips for doubles.
fn critical_truth((n, c): (f64, f64), e: f64, w: f64) -> Option<[Interval; 4]> {
    let [n, c, e, w] = [n, c, e, w].map(|value| Interval::from_f64(Precision::new(256), value));
    truth::critical(&n, truth::kappa_of(&n), [c, e, w]).try_into().ok()
}

/// Both roots of a² − √(2πa) = −1/2, by bisection over intervals.
fn jkr_radii() -> Vec<Interval> {
    let fraction = |p: i64, q: i64| Interval::from_int(Precision::new(256), p).over(q);
    let above = |a: &Interval| a.square() + a.ratio(1, 2) > (a.pi() * a).times(2).sqrt();
    let root = |mut one: Interval, mut other: Interval| {
        let side = above(&one);
        for _ in 0..200 {
            let middle = (one.clone() + &other).over(2);
            if above(&middle) == side { one = middle } else { other = middle }
        }
        one.hull(&other)
    };
    vec![root(fraction(1, 1000), fraction(1, 2)), root(fraction(1, 1), fraction(2, 1))]
}

#[cfg(test)]
mod tests {
    use rug::Float;

    use super::*;

    #[test]
    fn the_radii_are_enclosed() {
        let radii = jkr_radii();
        for a in &radii {
            let residual = a.square() - (a.pi() * a).times(2).sqrt() + a.ratio(1, 2);
            assert!(residual.contains_zero() && a.accuracy_bits() > 180);
        }
        assert!(radii[0] < radii[1]);
    }

    #[test]
    fn the_grid_is_judged_by_the_equations_of_equilibrium() {
        let truth = critical_truth((2.0, 0.5), 1.0, 1.0).unwrap();
        // a³ = πwR²/(8E*), F = −(5/6)πwR.
        let (pi, a) = (truth[0].pi(), truth[1].clone());
        assert!(a.powi(3).overlaps(&pi.clone().over(8)) && truth[0].contains(&Float::with_val(53, 2)));
        assert!(truth[3].overlaps(&pi.times(-5).over(6)) && truth[3].accuracy_bits() > 200);
    }

    #[test]
    fn turns_are_put_together() {
        let time = |median: f64| Time { median, least: median / 2.0, most: median * 2.0, runs: 2 };
        let all = together(&[time(4.0), time(2.0), time(8.0)], 2).unwrap();
        assert_eq!(all, Time { median: 2.0, least: 0.5, most: 8.0, runs: 6 });
        assert_eq!(together(&[], 1), None);
    }

    #[test]
    fn nobody_races_without_a_clock() {
        assert_eq!(races(Effort::Quick, &Clock::Off), (Vec::new(), Vec::new()));
    }
}
