//! This workspace beside other projects: ratios of times that are taken in turns.
//!
//! In a [`Race`] both sides answer the same question; they take turns, so that a busy machine slows both, and both answers
//! are judged, since a fast wrong one does not count. Enclosures race enclosures.

mod digits;
mod double;

use mdr_core::contact::{Error, Result};
use mdr_core::number::Interval;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::outside::{self, Outsiders, Reply};
use super::precision::{self, Found};
use super::{Arithmetic, Clock, Outcome, Setup, Time};

/// One side of a race.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Side {
    /// Who answers, with its version if it is another project.
    pub name: String,
    /// How right it is; [`Passed`](Outcome::Passed) for a part of an answer that is judged in another race.
    pub outcome: Outcome,
    /// How long one answer takes.
    pub time: Time,
}

/// Two answers to one question, timed in turns.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Race {
    /// What is asked: "κ_n for n = 3/10".
    pub question: String,
    /// How much of it: "50 digits", "100000 points in batches of 4096".
    pub setting: String,
    /// This workspace.
    pub ours: Side,
    /// The fastest way that the other project has.
    pub theirs: Side,
    /// How many times faster this workspace is meant to be, where that was laid down.
    pub aim: Option<f64>,
}

impl Race {
    /// How many times faster this workspace is.
    pub fn ratio(&self) -> f64 {
        self.theirs.time.median / self.ours.time.median
    }
}

/// All races that can be run, and a sentence for each that cannot. None without a clock.
pub fn races(setup: &mut Setup) -> (Vec<Race>, Vec<String>) {
    setup.outsiders.begin();
    if let Err(reason) = setup.outsiders.present() {
        return (Vec::new(), reason.into_iter().collect());
    }
    let questions = setup.questions();
    let Setup { effort, clock, ref mut outsiders, .. } = *setup;
    let mut hall = Hall { outsiders, clock, races: Vec::new(), omissions: Vec::new() };
    digits::races(&mut hall, effort, &questions);
    double::grids(&mut hall, effort);
    double::equilibria(&mut hall);
    (hall.races, hall.omissions)
}

/// Turns that each side takes.
const TURNS: usize = 3;

/// Where races are run.
struct Hall<'a> {
    outsiders: &'a mut Outsiders,
    clock: Clock,
    races: Vec<Race>,
    omissions: Vec<String>,
}

/// How a race is run.
struct Lane<'a> {
    question: &'a str,
    setting: &'a str,
    ours: &'a str,
    solver: &'a dyn Fn() -> Result<Vec<Found>>,
    /// The name, the package and the question of the other project.
    theirs: (&'a str, &'static str, Map<String, Value>),
    arithmetic: Arithmetic,
    truths: &'a [Interval],
    /// Whether the answer of the other side is all that is asked, or a part of it which is not judged.
    whole: bool,
    /// Whether both sides forget their constants, such as π, before every answer.
    fresh: bool,
    /// Answers of which one call consists.
    count: usize,
    aim: Option<f64>,
}

impl Hall<'_> {
    /// The race against the fastest of several.
    fn keep(&mut self, found: Vec<std::result::Result<Race, String>>) {
        let (races, reasons): (Vec<_>, Vec<_>) = found.into_iter().partition(std::result::Result::is_ok);
        let fastest = races.into_iter().flatten().min_by(|one, other| one.ratio().total_cmp(&other.ratio()));
        self.races.extend(fastest);
        self.omissions.extend(reasons.into_iter().filter_map(std::result::Result::err));
    }

    fn race(&mut self, lane: &Lane<'_>) -> std::result::Result<Race, String> {
        let (theirs, package, asked) = &lane.theirs;
        let lost = |how: &str| format!("{}, {}: {theirs} {how}.", lane.question, lane.setting);
        let turn = match self.clock {
            Clock::Off => Clock::Off,
            Clock::Runs(runs) => Clock::Runs(runs.div_ceil(TURNS)),
        };
        let (mut our_times, mut their_times, mut answer) = (Vec::new(), Vec::new(), None);
        for _ in 0..TURNS {
            our_times.extend(if lane.fresh { turn.time_after(forget, lane.solver) } else { turn.time(lane.solver) });
            match self.outsiders.ask(asked.clone(), &turn) {
                Reply::Absent(package) => return Err(format!("{theirs}: the package {package} is not installed.")),
                Reply::Failed(reason) => return Err(lost(&format!("failed: {reason}"))),
                Reply::Stopped(reason) => return Err(lost(&reason)),
                Reply::Found { values, time, .. } => {
                    their_times.extend(time);
                    let judged = || outside::judged(&values, lane.truths, lane.arithmetic);
                    answer = Some(if lane.whole { judged() } else { Outcome::Passed });
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
            question: lane.question.to_owned(),
            setting: lane.setting.to_owned(),
            ours: side(lane.ours.to_owned(), ours, &our_times)?,
            theirs: side(format!("{theirs} ({})", self.outsiders.package(package)), their_outcome, &their_times)?,
            aim: lane.aim,
        })
    }
}

/// The constants that κ_n and MPFR keep are computed anew when they are next wanted.
fn forget() {
    mdr_analytic::free_cache();
    rug::float::free_cache(rug::float::FreeCache::All);
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

#[cfg(test)]
mod tests {
    use super::super::Effort;
    use super::*;

    #[test]
    fn turns_are_put_together() {
        let time = |median: f64| Time { median, least: median / 2.0, most: median * 2.0, runs: 2 };
        let all = together(&[time(4.0), time(2.0), time(8.0)], 2).unwrap();
        assert_eq!(all, Time { median: 2.0, least: 0.5, most: 8.0, runs: 6 });
        assert_eq!(together(&[], 1), None);
    }

    #[test]
    fn nobody_races_without_a_clock() {
        assert_eq!(races(&mut Setup::new(Effort::Quick, Clock::Off)), (Vec::new(), Vec::new()));
    }
}
