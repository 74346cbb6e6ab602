//! Counts of the evaluations of a transform: the cost of a method, independent of the machine it runs on.

use std::ops::Sub;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::{Error, Kink, Result, Transform};
use crate::number::Real;

/// Numbers of evaluations of a [`Transform`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Evaluations {
    /// Evaluations of g.
    pub g: u64,
    /// Evaluations of g'.
    pub slope: u64,
    /// Evaluations of the integral of g, of its mean, and of g minus its mean.
    pub integral: u64,
}

impl Evaluations {
    /// The sum of all three.
    pub fn total(self) -> u64 {
        self.g + self.slope + self.integral
    }
}

/// The evaluations since an earlier reading.
impl Sub for Evaluations {
    type Output = Self;

    fn sub(self, before: Self) -> Self {
        Evaluations {
            g: self.g - before.g,
            slope: self.slope - before.slope,
            integral: self.integral - before.integral,
        }
    }
}

/// A count of evaluations that several [`CountingTransform`]s and threads may share.
#[derive(Debug, Default)]
pub struct EvaluationCounter {
    counts: [AtomicU64; 3],
    budget: Arc<Budget>,
    leaves_reserve: bool,
    stop: Arc<AtomicBool>,
}

/// The work that may be spent, which several counts may share.
///
/// ```
/// use mdr_core::contact::Budget;
/// let budget = Budget::default();
/// assert!(!budget.is_spent()); // without a limit it never is
/// budget.allow(2);
/// budget.spend(2);
/// assert!(budget.is_spent());
/// budget.allow(1);
/// assert!(!budget.is_spent());
/// ```
#[derive(Debug, Default)]
pub struct Budget {
    spent: AtomicU64,
    /// The work up to which evaluations are allowed; 0 without a limit.
    limit: AtomicU64,
    /// What is kept of it for what begins last.
    reserve: AtomicU64,
}

/// The part of a budget, inverse, that is kept in reserve.
const RESERVE: u64 = 5;

impl Budget {
    /// Allows so much work from now on.
    pub fn allow(&self, work: u64) {
        self.limit.store(self.spent().saturating_add(work).max(1), Ordering::Relaxed);
        self.reserve.store(work / RESERVE, Ordering::Relaxed);
    }

    /// The work that was spent so far.
    pub fn spent(&self) -> u64 {
        self.spent.load(Ordering::Relaxed)
    }

    /// Does a part of the work with half as much again kept in reserve, so that something is left for what follows it.
    ///
    /// ```
    /// use mdr_core::contact::Budget;
    /// let budget = Budget::default();
    /// budget.allow(100);
    /// budget.spend(70);
    /// assert!(budget.holding_back(|| budget.is_spent_but_for_reserve()));
    /// assert!(!budget.is_spent_but_for_reserve());
    /// ```
    pub fn holding_back<T>(&self, part: impl FnOnce() -> T) -> T {
        let reserve = self.reserve.load(Ordering::Relaxed);
        self.reserve.store(reserve + reserve / 2, Ordering::Relaxed);
        let done = part();
        self.reserve.store(reserve, Ordering::Relaxed);
        done
    }

    /// Spends some.
    pub fn spend(&self, work: u64) {
        self.spent.fetch_add(work, Ordering::Relaxed);
    }

    /// Whether nothing is left.
    pub fn is_spent(&self) -> bool {
        self.left() == Some(0)
    }

    /// Whether no more is left than the fifth that is kept for what begins last.
    pub fn is_spent_but_for_reserve(&self) -> bool {
        self.left().is_some_and(|left| left <= self.reserve.load(Ordering::Relaxed))
    }

    /// The work that is left beside half of what is kept for what begins last, if there is a limit: for a proof that comes after all others,
    /// so that what begins last is not likely to be needed.
    ///
    /// ```
    /// use mdr_core::contact::Budget;
    /// let budget = Budget::default();
    /// assert_eq!(budget.left_for_last_proof(), None);
    /// budget.allow(100);
    /// budget.spend(30);
    /// assert_eq!(budget.left_for_last_proof(), Some(60));
    /// ```
    pub fn left_for_last_proof(&self) -> Option<u64> {
        self.left().map(|left| left.saturating_sub(self.reserve.load(Ordering::Relaxed) / 2))
    }

    /// Leaves to what begins last its reserve, once, however much of it a single evaluation before has taken.
    ///
    /// ```
    /// use mdr_core::contact::Budget;
    /// let budget = Budget::default();
    /// budget.allow(100);
    /// budget.spend(130);
    /// budget.open_reserve();
    /// assert_eq!(budget.left(), Some(20));
    /// budget.spend(20);
    /// budget.open_reserve();
    /// assert!(budget.is_spent());
    /// ```
    pub fn open_reserve(&self) {
        let reserve = self.reserve.swap(0, Ordering::Relaxed);
        if self.left().is_some_and(|left| left < reserve) {
            self.limit.store(self.spent().saturating_add(reserve), Ordering::Relaxed);
        }
    }

    /// The work that is left, if there is a limit.
    pub fn left(&self) -> Option<u64> {
        let limit = self.limit.load(Ordering::Relaxed);
        (limit > 0).then(|| limit.saturating_sub(self.spent()))
    }
}

impl EvaluationCounter {
    /// A count with a stop flag: once `stop` is true every evaluation returns [`Error::Stopped`], which ends any loop.
    pub fn until(stop: &Arc<AtomicBool>) -> Self {
        EvaluationCounter { stop: Arc::clone(stop), ..Self::default() }
    }

    /// A count with a budget that others share. Once it is spent every evaluation returns [`Error::BudgetSpent`].
    #[must_use]
    pub fn within(self, budget: &Arc<Budget>) -> Self {
        EvaluationCounter { budget: Arc::clone(budget), ..self }
    }

    /// The count, ended where no more than the reserve of its budget is left: for proofs, after which hardware arithmetic has its turn.
    #[must_use]
    pub fn leaving_reserve(self) -> Self {
        EvaluationCounter { leaves_reserve: true, ..self }
    }

    fn is_spent(&self) -> bool {
        if self.leaves_reserve { self.budget.is_spent_but_for_reserve() } else { self.budget.is_spent() }
    }

    /// Allows so much work from now on: a [weight](CountingTransform::weighing) for each evaluation, and for each height within
    /// it. Once it is spent every evaluation returns [`Error::BudgetSpent`].
    pub fn allow(&self, work: u64) {
        self.budget.allow(work);
    }

    /// The work that was spent so far, of all that share the budget.
    pub fn spent(&self) -> u64 {
        self.budget.spent()
    }

    /// The budget from which the evaluations are paid, for work that is no evaluation.
    pub fn budget(&self) -> &Arc<Budget> {
        &self.budget
    }

    /// Counts what a transform does during an evaluation.
    fn working<T>(&self, weight: u64, heights: impl Fn() -> u64, evaluate: impl FnOnce() -> T) -> T {
        let before = heights();
        let value = evaluate();
        let heights = heights().saturating_sub(before);
        self.budget.spend(weight.saturating_mul(heights.max(1)));
        value
    }

    /// The evaluations so far.
    pub fn read(&self) -> Evaluations {
        let [g, slope, integral] = self.counts.each_ref().map(|count| count.load(Ordering::Relaxed));
        Evaluations { g, slope, integral }
    }
}

/// A transform that counts its evaluations and otherwise forwards every call to the transform inside.
///
/// ```
/// use mdr_core::contact::{CountingTransform, Evaluations, Result, Transform};
///
/// struct Paraboloid;
/// impl Transform<f64> for Paraboloid {
///     fn g(&self, x: &f64) -> Result<f64> {
///         Ok(x * x)
///     }
///     fn slope(&self, x: &f64) -> Result<f64> {
///         Ok(2.0 * x)
///     }
///     fn integral(&self, x: &f64) -> Result<f64> {
///         Ok(x.powi(3) / 3.0)
///     }
/// }
/// let counted = CountingTransform::new(Box::new(Paraboloid), &Default::default());
/// assert_eq!((counted.g(&2.0)?, counted.slope(&2.0)?, counted.slope(&3.0)?), (4.0, 4.0, 6.0));
/// assert_eq!(counted.evaluations(), Evaluations { g: 1, slope: 2, integral: 0 });
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct CountingTransform<R> {
    inner: Arc<dyn Transform<R>>,
    tally: Arc<EvaluationCounter>,
    weight: u64,
}

impl<R: Real> CountingTransform<R> {
    /// Counts the evaluations of `inner` into `tally`.
    pub fn new(inner: Box<dyn Transform<R>>, tally: &Arc<EvaluationCounter>) -> Self {
        Self::sharing(Arc::from(inner), tally)
    }

    /// Counts the evaluations through this wrapper into `tally`; `inner` may be shared.
    pub fn sharing(inner: Arc<dyn Transform<R>>, tally: &Arc<EvaluationCounter>) -> Self {
        CountingTransform { inner, tally: Arc::clone(tally), weight: 1 }
    }

    /// Counts with a weight: an evaluation of a closed form, or a height of a quadrature, costs so much of the budget; 1 by default.
    #[must_use]
    pub fn weighing(self, weight: u64) -> Self {
        CountingTransform { weight: weight.max(1), ..self }
    }

    /// The evaluations so far, of all transforms that share the count.
    pub fn evaluations(&self) -> Evaluations {
        self.tally.read()
    }

    fn count<T>(&self, part: usize, evaluate: impl FnOnce(&dyn Transform<R>) -> Result<T>) -> Result<T> {
        self.paid(|inner| {
            self.tally.counts[part].fetch_add(1, Ordering::Relaxed);
            evaluate(inner)
        })
    }

    /// Pays for an evaluation from what is left of the budget.
    fn paid<T>(&self, evaluate: impl FnOnce(&dyn Transform<R>) -> Result<T>) -> Result<T> {
        let tally = &self.tally;
        if tally.stop.load(Ordering::Relaxed) {
            return Err(Error::Stopped);
        }
        if tally.is_spent() {
            return Err(Error::BudgetSpent { evaluations: tally.read().total() });
        }
        tally.working(self.weight, || self.inner.work(), || evaluate(&*self.inner))
    }
}

impl<R: Real> Transform<R> for CountingTransform<R> {
    fn g(&self, x: &R) -> Result<R> {
        self.count(0, |inner| inner.g(x))
    }

    fn slope(&self, x: &R) -> Result<R> {
        self.count(1, |inner| inner.slope(x))
    }

    fn integral(&self, x: &R) -> Result<R> {
        self.count(2, |inner| inner.integral(x))
    }

    fn mean(&self, x: &R) -> Result<R> {
        self.count(2, |inner| inner.mean(x))
    }

    fn g_within(&self, x: &R, needed: &R) -> Result<R> {
        self.count(0, |inner| inner.g_within(x, needed))
    }

    fn mean_within(&self, x: &R, needed: &R) -> Result<R> {
        self.count(2, |inner| inner.mean_within(x, needed))
    }

    fn above_mean(&self, x: &R) -> Result<R> {
        self.count(2, |inner| inner.above_mean(x))
    }

    fn mean_square(&self, x: &R) -> Option<Result<R>> {
        self.count(2, |inner| inner.mean_square(x).transpose()).transpose()
    }

    fn complete_contact(&self) -> Option<[R; 2]> {
        self.inner.complete_contact()
    }

    fn outer_radius(&self) -> Option<R> {
        self.inner.outer_radius()
    }

    fn vertical_edge(&self) -> bool {
        self.inner.vertical_edge()
    }

    fn kinks(&self) -> Vec<R> {
        self.inner.kinks()
    }

    fn kink(&self, index: usize, margin: &R) -> Result<Option<Kink<R>>> {
        self.paid(|inner| inner.kink(index, margin))
    }

    fn rises(&self) -> bool {
        self.inner.rises()
    }

    fn rises_beyond(&self, x: &R) -> bool {
        self.inner.rises_beyond(x)
    }

    fn work(&self) -> u64 {
        self.inner.work()
    }
}
