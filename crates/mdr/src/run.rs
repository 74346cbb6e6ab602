//! Control of a computation: progress for an observer, a stop, and the count of evaluations.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use mdr_core::contact::{self, Budget, EvaluationCounter, Evaluations};

use crate::answer::{Output, OutputKind};
use crate::scene::Want;

/// The arithmetics, as costs name them.
pub const ARITHMETICS: [&str; 3] = ["f64", "interval", "interval with slope"];

/// The cost of an output. Times are measured by the caller.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Cost {
    /// The kind of the output.
    pub output: OutputKind,
    /// Evaluations of g, its slope and its integral in each of the [`ARITHMETICS`].
    pub evaluations: [Evaluations; ARITHMETICS.len()],
}

impl Cost {
    /// The arithmetics that were used, by name.
    pub fn used(&self) -> impl Iterator<Item = (&'static str, Evaluations)> {
        let all = ARITHMETICS.into_iter().zip(self.evaluations);
        all.filter(|(_, evaluations)| *evaluations != Evaluations::default())
    }
}

/// Follows a run: a progress bar, a log, a page that shows each output as soon as it is there.
pub trait Observer {
    /// Called when an output begins.
    fn begin(&mut self, _: &Want) {}

    /// Called when an output is complete.
    fn output(&mut self, _: &Output, _: &Cost) {}
}

/// Observes nothing.
impl Observer for () {}

/// Stops a run, from any thread. The next evaluation of the profile ends it with [`Error::Stopped`](crate::Error::Stopped).
///
/// ```
/// use mdr::prelude::*;
/// let scene = Scene::new(Shape::Cone { flank: Flank::Slope("0.1") }, Elasticity::effective("1e6")?, "0.05")?
///     .want(Want::Curve { at: vec!["1e-3".parse().unwrap()] })
///     .arithmetic(Arithmetic::F64);
/// let stop = Stop::default();
/// stop.stop();
/// let stopped = scene.solve_with(&mut Run::new(&mut (), stop));
/// assert!(matches!(stopped, Err(Error::Stopped)));
/// # Ok::<(), mdr::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Asks the run to end.
    pub fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether it was asked to.
    pub fn is_stopped(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// A count of evaluations that ends with the run.
    pub(crate) fn tally(&self) -> Arc<EvaluationCounter> {
        Arc::new(EvaluationCounter::until(&self.0))
    }

    /// One for each arithmetic, with a budget that they share.
    pub(crate) fn counts(&self) -> Counts {
        let budget = Arc::new(Budget::default());
        std::array::from_fn(|arithmetic| {
            let counter = EvaluationCounter::until(&self.0).within(&budget);
            Arc::new(if arithmetic == 0 { counter } else { counter.leaving_reserve() })
        })
    }
}

/// Frees the constants that the arbitrary precision keeps for the calling thread: for threads that end.
pub fn free_thread_cache() {
    #[cfg(feature = "mp")]
    rug::float::free_cache(rug::float::FreeCache::Local);
}

/// How a scene is solved: its observer, its stop, and its budget of work; by default none, none, and [`BUDGET`].
#[derive(Default)]
pub struct Run<'a> {
    pub(crate) observer: Option<&'a mut dyn Observer>,
    pub(crate) stop: Stop,
    pub(crate) budget: Option<f64>,
}

/// The work for a scene, in seconds of a fast machine. It is counted and not timed, so that no answer depends on how busy the
/// machine is.
pub const BUDGET: f64 = 10.0;

/// The unit of work is a nanosecond of a machine of 2024: solve/weight.rs says what an evaluation costs.
const PER_SECOND: f64 = 1e9;
/// So many rows of a part have as much as the scene.
const ROWS: usize = 64;
/// The part of the budget, inverse, that is kept for later outputs: none is left without any.
const KEPT: u64 = 4;

impl<'a> Run<'a> {
    /// With an observer and a stop.
    pub fn new(observer: &'a mut dyn Observer, stop: Stop) -> Self {
        Run { observer: Some(observer), stop, budget: None }
    }

    /// The run with another [`BUDGET`] for the scene, all its outputs together, and so much more for each 64 rows of a long one. What is not
    /// found within it is `undecided`.
    #[must_use]
    pub fn within(self, seconds: f64) -> Self {
        Run { budget: Some(seconds), ..self }
    }

    /// The work for a scene with so many parts.
    pub(crate) fn allowance(&self, parts: usize) -> Allowance {
        let work = (PER_SECOND * self.budget.unwrap_or(BUDGET)) as u64;
        Allowance { work, left: work, parts: parts.max(1) as u64, later: parts as u64, before: 0, own: 0 }
    }
}

/// The work that the parts of a scene share.
pub(crate) struct Allowance {
    work: u64,
    /// What is left of it.
    left: u64,
    parts: u64,
    /// The parts to come.
    later: u64,
    /// What was spent before the last part.
    before: u64,
    /// What that part had for its rows, beside the work that is shared.
    own: u64,
}

impl Allowance {
    /// Allows the work for the next part, with so many rows: what is left, but for a share of each later one, and its own for its rows.
    pub(crate) fn next(&mut self, counts: &Counts, rows: usize) {
        let spent = counts[0].spent();
        self.left = self.left.saturating_sub((spent - self.before).saturating_sub(self.own));
        (self.before, self.own) = (spent, self.work.saturating_mul((rows / ROWS) as u64));
        self.later = self.later.saturating_sub(1);
        let share = self.work / (KEPT * self.parts);
        // All counts share it.
        counts[0].allow(self.left.saturating_sub(share * self.later).max(share).saturating_add(self.own));
    }
}

/// The evaluations so far, by arithmetic.
pub(crate) type Counts = [Arc<EvaluationCounter>; ARITHMETICS.len()];

/// A result that an answer can do without; a stop cannot be.
///
/// # Errors
/// [`Stopped`](contact::Error::Stopped).
pub(crate) fn lack<T>(result: contact::Result<T>) -> contact::Result<contact::Result<T>> {
    match result {
        Err(contact::Error::Stopped) => Err(contact::Error::Stopped),
        result => Ok(result),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What one part leaves the next one has, and what it does not, a share.
    #[test]
    fn the_parts_of_a_scene_share_one_budget() {
        let counts = Stop::default().counts();
        let mut allowance = Run::default().within(1.0).allowance(2);
        let budget = counts[0].budget();
        allowance.next(&counts, 0);
        budget.spend(874_999_999);
        assert!(!budget.is_spent());
        budget.spend(1);
        assert!(budget.is_spent());
        allowance.next(&counts, 0);
        budget.spend(124_999_999);
        assert!(!budget.is_spent());
        budget.spend(1);
        assert!(budget.is_spent());
    }

    /// Rows have work of their own, which no other part may spend.
    #[test]
    fn a_part_with_many_rows_has_more() {
        let counts = Stop::default().counts();
        let mut allowance = Run::default().within(1.0).allowance(2);
        let budget = counts[0].budget();
        allowance.next(&counts, 128);
        budget.spend(2_500_000_000);
        assert!(!budget.is_spent());
        allowance.next(&counts, 0);
        budget.spend(499_999_999);
        assert!(!budget.is_spent());
        budget.spend(1);
        assert!(budget.is_spent());
    }
}
