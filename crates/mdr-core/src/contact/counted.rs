//! How often a transform is asked: what a method costs, whatever machine it runs on.

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
    /// Of the integral of g, of its mean, and of g less its mean.
    pub integral: u64,
}

impl Evaluations {
    /// All together.
    pub fn total(self) -> u64 {
        self.g + self.slope + self.integral
    }
}

/// What was spent since an earlier reading.
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

/// A count of evaluations that several [`CountedTransform`]s and threads may share.
#[derive(Debug, Default)]
pub struct Tally {
    counts: [AtomicU64; 3],
    stop: Arc<AtomicBool>,
}

impl Tally {
    /// A count of what may be stopped: once `stop` is true every evaluation is [`Error::Stopped`], which ends any loop.
    pub fn until(stop: &Arc<AtomicBool>) -> Self {
        Tally { counts: Default::default(), stop: Arc::clone(stop) }
    }

    /// The evaluations so far.
    pub fn read(&self) -> Evaluations {
        let [g, slope, integral] = self.counts.each_ref().map(|count| count.load(Ordering::Relaxed));
        Evaluations { g, slope, integral }
    }
}

/// A transform that counts how often it is asked; its answers are those of the transform inside.
///
/// ```
/// use mdr_core::contact::{CountedTransform, Evaluations, Result, Transform};
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
/// let counted = CountedTransform::new(Box::new(Paraboloid), &Default::default());
/// assert_eq!((counted.g(&2.0)?, counted.slope(&2.0)?, counted.slope(&3.0)?), (4.0, 4.0, 6.0));
/// assert_eq!(counted.evaluations(), Evaluations { g: 1, slope: 2, integral: 0 });
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct CountedTransform<R> {
    inner: Arc<dyn Transform<R>>,
    tally: Arc<Tally>,
}

impl<R: Real> CountedTransform<R> {
    /// Counts into `tally`.
    pub fn new(inner: Box<dyn Transform<R>>, tally: &Arc<Tally>) -> Self {
        Self::sharing(Arc::from(inner), tally)
    }

    /// The same of a transform that others use, too.
    pub fn sharing(inner: Arc<dyn Transform<R>>, tally: &Arc<Tally>) -> Self {
        CountedTransform { inner, tally: Arc::clone(tally) }
    }

    /// The evaluations so far, of all that share the count.
    pub fn evaluations(&self) -> Evaluations {
        self.tally.read()
    }

    fn count(&self, part: usize) -> Result<&dyn Transform<R>> {
        if self.tally.stop.load(Ordering::Relaxed) {
            return Err(Error::Stopped);
        }
        self.tally.counts[part].fetch_add(1, Ordering::Relaxed);
        Ok(&*self.inner)
    }
}

impl<R: Real> Transform<R> for CountedTransform<R> {
    fn g(&self, x: &R) -> Result<R> {
        self.count(0)?.g(x)
    }

    fn slope(&self, x: &R) -> Result<R> {
        self.count(1)?.slope(x)
    }

    fn integral(&self, x: &R) -> Result<R> {
        self.count(2)?.integral(x)
    }

    fn mean(&self, x: &R) -> Result<R> {
        self.count(2)?.mean(x)
    }

    fn g_within(&self, x: &R, needed: &R) -> Result<R> {
        self.count(0)?.g_within(x, needed)
    }

    fn mean_within(&self, x: &R, needed: &R) -> Result<R> {
        self.count(2)?.mean_within(x, needed)
    }

    fn above_mean(&self, x: &R) -> Result<R> {
        self.count(2)?.above_mean(x)
    }

    fn outer_radius(&self) -> Option<R> {
        self.inner.outer_radius()
    }

    fn wall(&self) -> bool {
        self.inner.wall()
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
}

#[cfg(test)]
mod tests {
    use super::super::{Error, Quantity};
    use super::*;

    /// Answers every question differently, and none as the trait does by itself.
    struct Peculiar;

    impl Transform<f64> for Peculiar {
        fn g(&self, x: &f64) -> Result<f64> {
            Ok(x + 1.0)
        }

        fn slope(&self, x: &f64) -> Result<f64> {
            Ok(x + 2.0)
        }

        fn integral(&self, x: &f64) -> Result<f64> {
            Ok(x + 3.0)
        }

        fn mean(&self, x: &f64) -> Result<f64> {
            Ok(x + 4.0)
        }

        fn above_mean(&self, x: &f64) -> Result<f64> {
            Ok(x + 5.0)
        }

        fn g_within(&self, x: &f64, needed: &f64) -> Result<f64> {
            Ok(x + needed)
        }

        fn mean_within(&self, x: &f64, needed: &f64) -> Result<f64> {
            Ok(x - needed)
        }

        fn outer_radius(&self) -> Option<f64> {
            Some(6.0)
        }

        fn wall(&self) -> bool {
            true
        }

        fn kinks(&self) -> Vec<f64> {
            vec![7.0]
        }

        fn kink(&self, index: usize, margin: &f64) -> Result<Option<Kink<f64>>> {
            Err(Error::domain(Quantity::ContactRadius, &(index as f64 + margin), "peculiar"))
        }

        fn rises(&self) -> bool {
            true
        }
    }

    #[test]
    fn every_question_is_passed_on_and_counted_once() {
        let tally = Arc::new(Tally::default());
        let counted = CountedTransform::new(Box::new(Peculiar), &tally);
        let spent = |work: &dyn Fn() -> Result<f64>| {
            let before = counted.evaluations();
            (work().unwrap(), counted.evaluations() - before)
        };
        let none = Evaluations::default();
        let [g, slope] = [Evaluations { g: 1, ..none }, Evaluations { slope: 1, ..none }];
        let integral = Evaluations { integral: 1, ..none };
        assert_eq!(spent(&|| counted.g(&10.0)), (11.0, g));
        assert_eq!(spent(&|| counted.slope(&10.0)), (12.0, slope));
        assert_eq!(spent(&|| counted.integral(&10.0)), (13.0, integral));
        assert_eq!(spent(&|| counted.mean(&10.0)), (14.0, integral));
        assert_eq!(spent(&|| counted.above_mean(&10.0)), (15.0, integral));
        assert_eq!(spent(&|| counted.g_within(&10.0, &0.5)), (10.5, g));
        assert_eq!(spent(&|| counted.mean_within(&10.0, &0.5)), (9.5, integral));
        assert_eq!((counted.outer_radius(), counted.wall(), counted.kinks()), (Some(6.0), true, vec![7.0]));
        assert!(counted.rises());
        let expected = Peculiar.kink(2, &0.5).unwrap_err().to_string();
        assert_eq!(counted.kink(2, &0.5).unwrap_err().to_string(), expected);
        assert_eq!(tally.read(), Evaluations { g: 2, slope: 1, integral: 4 });
        assert_eq!(tally.read().total(), 7);
    }

    #[test]
    fn a_stop_ends_every_evaluation() {
        let stop = Arc::new(AtomicBool::new(false));
        let counted = CountedTransform::new(Box::new(Peculiar), &Arc::new(Tally::until(&stop)));
        assert!(counted.g(&1.0).is_ok());
        stop.store(true, Ordering::Relaxed);
        assert_eq!((counted.g(&1.0), counted.mean(&1.0)), (Err(Error::Stopped), Err(Error::Stopped)));
        assert_eq!(counted.evaluations().total(), 1);
    }

    #[test]
    fn a_count_can_be_shared() {
        let tally = Arc::new(Tally::default());
        let [one, other] = [(); 2].map(|()| CountedTransform::new(Box::new(Peculiar), &tally));
        assert!(one.g(&1.0).is_ok() && other.g(&1.0).is_ok());
        assert_eq!((one.evaluations().g, other.evaluations().g), (2, 2));
    }
}
