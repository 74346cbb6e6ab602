//! Error against run time: several methods answer the same question with growing effort, and each answer is compared with
//! an enclosure of the exact result that shares no code with any of them.
//!
//! A [`Task`] has several questions; a [`Comparison`] is one question, a [`Series`] one method, a [`Measurement`] one setting
//! of its effort. Beside the methods of this workspace stand those that one would type from a textbook. Errors and numbers
//! of evaluations are a function of the source, up to the last bit of elementary functions of the system; a test compares
//! them with `docs/report/work-precision.csv`. Times are measured only when the [`Clock`] runs.
//!
//! ```
//! use mdr_crosscheck::Level;
//! use mdr_crosscheck::work_precision::{Clock, TASKS};
//! let comparisons = TASKS[0].comparisons(Level::Quick, Clock::Off)?;
//! let shipped = &comparisons[0].series[0];
//! assert!(shipped.ours && shipped.points[0].outcome.digits().is_some_and(|digits| digits > 15.6));
//! # Ok::<(), mdr_core::contact::Error>(())
//! ```

mod digits;
mod fold;
mod kappa;
mod outcome;
mod transform;

pub use outcome::Accuracy;

use std::hint::black_box;
use std::time::{Duration, Instant};

use mdr_core::contact::Result;
use mdr_core::number::Interval;
use serde::Serialize;

use self::outcome::Answer;
use crate::Level;

/// A family of questions.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub struct Task {
    /// Its name, with which the names of its comparisons begin.
    pub name: &'static str,
    /// The questions, in one line.
    pub title: &'static str,
    comparisons: fn(Level, Clock) -> Result<Vec<Comparison>>,
}

/// All tasks, in the order of the report.
pub const TASKS: [Task; 4] = [kappa::TASK, transform::TASK, fold::TASK, digits::TASK];

impl Task {
    /// Lets all methods answer the questions. The settings at [`Level::Quick`] are some of those at the other levels, which are
    /// alike.
    ///
    /// # Errors
    /// None that is known: every question has parameters in the domain of its functions.
    pub fn comparisons(&self, level: Level, clock: Clock) -> Result<Vec<Comparison>> {
        (self.comparisons)(level, clock)
    }
}

/// One question, and the answers of several methods.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Stable name: "transform-power-0.25".
    pub id: String,
    /// The question in words.
    pub title: String,
    /// Where the enclosure of the exact result comes from.
    pub truth: &'static str,
    /// Digits that the question leaves to any method in double precision: −log₁₀(u·max(1, condition)), u = 2⁻⁵³. `None` if
    /// more than double precision is wanted.
    pub attainable: Option<f64>,
    /// The methods; the first is the one that a user of this workspace gets.
    pub series: Vec<Series>,
}

/// One method on one question.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// Its name.
    pub method: &'static str,
    /// Whether it is a method of this workspace; else it is one of textbooks.
    pub ours: bool,
    /// By growing effort.
    pub points: Vec<Measurement>,
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measurement {
    /// The effort: "12 nodes", "50 digits", "4096 springs".
    pub setting: String,
    /// The accuracy reached.
    #[serde(flatten)]
    pub outcome: Accuracy,
    /// Evaluations of the integrand, function or spring that the method is made of, where they are counted.
    pub evaluations: Option<u64>,
    /// Seconds that one answer took; `None` if the clock is off.
    pub seconds: Option<f64>,
}

impl Comparison {
    /// The answers without a number, with their methods and why.
    pub fn failures(&self) -> impl Iterator<Item = (&Series, &Measurement, &str)> {
        let points = self.series.iter().flat_map(|series| series.points.iter().map(move |point| (series, point)));
        points.filter_map(|(series, point)| match &point.outcome {
            Accuracy::Failed { failed } => Some((series, point, failed.as_str())),
            _ => None,
        })
    }

    /// The most digits that any method reached; not a number where none has any.
    pub fn most_digits(&self) -> f64 {
        let points = self.series.iter().flat_map(|series| &series.points);
        points.filter_map(|point| point.outcome.digits()).fold(f64::NAN, f64::max)
    }
}

impl Series {
    /// A method of this workspace.
    fn ours(method: &'static str, points: Vec<Measurement>) -> Self {
        Series { method, ours: true, points }
    }

    /// A method of textbooks.
    fn textbook(method: &'static str, points: Vec<Measurement>) -> Self {
        Series { method, ours: false, points }
    }
}

impl Measurement {
    /// Answers once for the error, then as often as the clock needs for the time.
    fn measure<T: Answer>(
        setting: impl Into<String>,
        clock: Clock,
        truths: &[Interval],
        work: impl Fn() -> Result<T>,
    ) -> Self {
        Self::of(setting, work(), truths, clock.time(work))
    }

    /// An answer that took so long, or none.
    fn of<T: Answer>(setting: impl Into<String>, answer: Result<T>, truths: &[Interval], seconds: Option<f64>) -> Self {
        let (outcome, evaluations) = match answer {
            Ok(answer) => (answer.outcome(truths), answer.evaluations()),
            Err(error) => (Accuracy::failed(&error), None),
        };
        Measurement { setting: setting.into(), outcome, evaluations, seconds }
    }
}

/// Measures wall time, or leaves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Every answer is computed once and no time is taken.
    Off,
    /// The median of so many runs, at least one.
    Runs(usize),
}

/// A run shorter than this repeats the answer until it is not.
const SHORTEST: Duration = Duration::from_millis(2);

/// No run begins after so long a time: a slow answer is not timed as often as a fast one.
const LONGEST: Duration = Duration::from_secs(2);

impl Clock {
    /// The median of the seconds that one call of `work` takes; `None` if the clock is off.
    ///
    /// ```
    /// use mdr_crosscheck::work_precision::Clock;
    /// assert!(Clock::Off.time(|| 1).is_none());
    /// assert!(Clock::Runs(3).time(|| (0..1000).sum::<u32>()).is_some_and(|seconds| seconds > 0.0));
    /// ```
    pub fn time<T>(self, work: impl Fn() -> T) -> Option<f64> {
        let Clock::Runs(runs) = self else { return None };
        let begin = Instant::now();
        let mut repeats = 1;
        let mut first = run(repeats, &work);
        while first < SHORTEST {
            repeats *= 2;
            first = run(repeats, &work);
        }
        let mut durations = vec![first];
        while durations.len() < runs && begin.elapsed() < LONGEST {
            durations.push(run(repeats, &work));
        }
        durations.sort();
        Some(durations[durations.len() / 2].as_secs_f64() / f64::from(repeats))
    }
}

fn run<T>(repeats: u32, work: &impl Fn() -> T) -> Duration {
    let begin = Instant::now();
    for _ in 0..repeats {
        black_box(work());
    }
    begin.elapsed()
}
