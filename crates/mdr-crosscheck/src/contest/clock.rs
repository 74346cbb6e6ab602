//! Wall time of one answer: the median of repeated runs, with its spread.

use std::hint::black_box;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

/// Seconds that one answer took.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Time {
    /// The median.
    pub median: f64,
    /// The least.
    pub least: f64,
    /// The most.
    pub most: f64,
    /// Runs that were timed; fast answers are repeated within a run.
    pub runs: usize,
}

/// Measures times, or leaves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Every answer is computed once and no time is taken: what a test does.
    Off,
    /// So many runs of every answer.
    Runs(usize),
}

/// A run shorter than this is repeated until it is not.
const SHORTEST: Duration = Duration::from_millis(2);

/// Runs beyond this total end early: a slow answer is not timed as often as a fast one.
const LONGEST: Duration = Duration::from_secs(2);

impl Clock {
    /// The time of one call of `work`; none when the clock is off.
    ///
    /// ```
    /// use mdr_crosscheck::contest::Clock;
    /// assert!(Clock::Off.time(|| 1).is_none());
    /// let time = Clock::Runs(3).time(|| (0..1000).sum::<u32>()).expect("the clock runs");
    /// assert!(time.least <= time.median && time.median <= time.most && time.runs == 3);
    /// ```
    pub fn time<T>(&self, mut work: impl FnMut() -> T) -> Option<Time> {
        let Clock::Runs(runs) = *self else { return None };
        let begin = Instant::now();
        let mut repeats = 1;
        let mut first = run(repeats, &mut work);
        while first < SHORTEST {
            repeats *= 2;
            first = run(repeats, &mut work);
        }
        let mut seconds = vec![first.as_secs_f64() / f64::from(repeats)];
        while seconds.len() < runs && begin.elapsed() < LONGEST {
            seconds.push(run(repeats, &mut work).as_secs_f64() / f64::from(repeats));
        }
        Time::of(seconds)
    }

    /// The time of one call of `work`, each after `before`, which is not in it.
    pub(super) fn time_after<T>(&self, before: impl Fn(), mut work: impl FnMut() -> T) -> Option<Time> {
        let Clock::Runs(runs) = *self else { return None };
        let begin = Instant::now();
        let mut seconds = Vec::with_capacity(runs);
        while seconds.len() < runs && (seconds.is_empty() || begin.elapsed() < LONGEST) {
            before();
            seconds.push(run(1, &mut work).as_secs_f64());
        }
        Time::of(seconds)
    }
}

impl Time {
    /// Of several runs; none of none.
    fn of(mut seconds: Vec<f64>) -> Option<Time> {
        seconds.sort_by(f64::total_cmp);
        let [least, median, most] = [0, seconds.len() / 2, seconds.len().wrapping_sub(1)].map(|i| seconds.get(i));
        Some(Time { median: *median?, least: *least?, most: *most?, runs: seconds.len() })
    }
}

fn run<T>(repeats: u32, work: &mut impl FnMut() -> T) -> Duration {
    let begin = Instant::now();
    for _ in 0..repeats {
        black_box(work());
    }
    begin.elapsed()
}
