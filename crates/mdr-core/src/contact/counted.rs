//! Counts of the evaluations of a transform: the cost of a method, independent of the machine it runs on.

use std::ops::Sub;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use super::{Error, Kink, Result, Transform};
use crate::number::Real;

/// Numbers of evaluations of a [`Transform`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Evaluations {
    /// Of g.
    pub g: u64,
    /// Of g'.
    pub slope: u64,
    /// Of the integral of g, of its mean, and of g minus its mean.
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
    /// The work done within the transforms, as far as it is counted there.
    work: AtomicU64,
    /// The sum of counts and work up to which evaluations are allowed; 0 without a limit.
    limit: AtomicU64,
    stop: Arc<AtomicBool>,
}

impl EvaluationCounter {
    /// A count with a stop flag: once `stop` is true every evaluation returns [`Error::Stopped`], which ends any loop.
    pub fn until(stop: &Arc<AtomicBool>) -> Self {
        EvaluationCounter { stop: Arc::clone(stop), ..Self::default() }
    }

    /// Allows so much from now on: evaluations, and the [work](Transform::work) within them. Once it is spent every evaluation
    /// returns [`Error::BudgetSpent`].
    pub fn allow(&self, work: u64) {
        self.limit.store(self.spent().saturating_add(work).max(1), Ordering::Relaxed);
    }

    fn spent(&self) -> u64 {
        self.read().total().saturating_add(self.work.load(Ordering::Relaxed))
    }

    /// Counts the work of a transform during an evaluation.
    fn working<T>(&self, work: impl Fn() -> u64, evaluate: impl FnOnce() -> T) -> T {
        let before = work();
        let value = evaluate();
        self.work.fetch_add(work().saturating_sub(before), Ordering::Relaxed);
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
}

impl<R: Real> CountingTransform<R> {
    /// Counts the evaluations of `inner` into `tally`.
    pub fn new(inner: Box<dyn Transform<R>>, tally: &Arc<EvaluationCounter>) -> Self {
        Self::sharing(Arc::from(inner), tally)
    }

    /// Counts the evaluations through this wrapper into `tally`; `inner` may be shared.
    pub fn sharing(inner: Arc<dyn Transform<R>>, tally: &Arc<EvaluationCounter>) -> Self {
        CountingTransform { inner, tally: Arc::clone(tally) }
    }

    /// The evaluations so far, of all transforms that share the count.
    pub fn evaluations(&self) -> Evaluations {
        self.tally.read()
    }

    fn count<T>(&self, part: usize, evaluate: impl FnOnce(&dyn Transform<R>) -> Result<T>) -> Result<T> {
        let tally = &self.tally;
        if tally.stop.load(Ordering::Relaxed) {
            return Err(Error::Stopped);
        }
        let (limit, spent) = (tally.limit.load(Ordering::Relaxed), tally.spent());
        if limit > 0 && spent >= limit {
            return Err(Error::BudgetSpent { evaluations: spent });
        }
        tally.counts[part].fetch_add(1, Ordering::Relaxed);
        tally.working(|| self.inner.work(), || evaluate(&*self.inner))
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
        self.inner.kink(index, margin)
    }

    fn rises(&self) -> bool {
        self.inner.rises()
    }

    fn work(&self) -> u64 {
        self.inner.work()
    }
}
