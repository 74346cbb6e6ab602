//! An attempt at a question: its answer beside the enclosure of the truth, and its time.

use std::fmt::Display;

use mdr_core::number::{Interval, Real};
use rug::Float;

use super::{Clock, Outcome, Point};

/// What a contestant returns.
pub trait Answer {
    /// The number, exactly.
    fn value(&self) -> Float;

    /// Evaluations spent, where the contestant counts them.
    fn evaluations(&self) -> Option<u64> {
        None
    }
}

impl Answer for f64 {
    fn value(&self) -> Float {
        Float::with_val(f64::MANTISSA_DIGITS, *self)
    }
}

impl Answer for Float {
    fn value(&self) -> Float {
        self.clone()
    }
}

/// The middle of an enclosure.
impl Answer for Interval {
    fn value(&self) -> Float {
        self.mid()
    }
}

/// A number and the evaluations it took.
impl<T: Answer> Answer for (T, u64) {
    fn value(&self) -> Float {
        self.0.value()
    }

    fn evaluations(&self) -> Option<u64> {
        Some(self.1)
    }
}

impl Outcome {
    /// The digits of `answer` that are right, where `truth` encloses the exact value and excludes zero.
    ///
    /// An error below the unit roundoff of the answer's own precision, or one that the width of the enclosure cannot tell
    /// from zero, is [`AtLeast`](Outcome::AtLeast). What is no number has [failed](Outcome::Failed).
    ///
    /// ```
    /// use mdr_core::number::{Interval, Precision, Real};
    /// use mdr_crosscheck::contest::Outcome;
    /// let third = Interval::from_int(Precision::new(200), 1).over(3);
    /// assert!(matches!(Outcome::of(&0.333, &third), Outcome::Digits(digits) if (digits - 3.0).abs() < 1e-9));
    /// assert!(matches!(Outcome::of(&(1.0 / 3.0), &third), Outcome::AtLeast(digits) if digits > 15.9));
    /// assert!(matches!(Outcome::of(&f64::NAN, &third), Outcome::Failed(_)));
    /// ```
    pub fn of(answer: &impl Answer, truth: &Interval) -> Outcome {
        let answer = answer.value();
        if answer.is_nan() {
            return Outcome::Failed("not a number".to_owned());
        }
        if answer.is_infinite() {
            return Outcome::Failed("overflow".to_owned());
        }
        if truth.contains_zero() || !truth.is_finite() {
            return Outcome::Failed("no truth to compare with".to_owned());
        }
        let precision = answer.prec().max(truth.lower().prec());
        let off = |end: &Float| Float::with_val(precision, end - &answer).abs();
        let [below, above] = [off(truth.lower()), off(truth.upper())];
        let least = if truth.contains(&answer) { Float::new(precision) } else { below.clone().min(&above) };
        let most = below.max(&above);
        let size = truth.mid().abs();
        let digits = |error: Float| -(error / &size).log10().to_f64();
        let own = f64::from(answer.prec()) * std::f64::consts::LOG10_2;
        let (certain, hoped) = (digits(most), digits(least));
        if certain >= own {
            Outcome::AtLeast(own)
        } else if hoped - certain > RESOLUTION {
            Outcome::AtLeast(certain)
        } else {
            Outcome::Digits(certain)
        }
    }

    /// The outcome with the fewest digits: what several numbers together are worth. A failure is worse than any.
    pub(crate) fn worst(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
        let rank = |outcome: &Outcome| outcome.digits().unwrap_or(f64::NEG_INFINITY);
        let least = outcomes.into_iter().min_by(|one, other| rank(one).total_cmp(&rank(other)));
        least.unwrap_or_else(|| Outcome::Failed("no answer".to_owned()))
    }

    /// The digits that are certainly right; none for a failure.
    pub fn digits(&self) -> Option<f64> {
        match self {
            Outcome::Digits(digits) | Outcome::AtLeast(digits) => Some(*digits),
            Outcome::Failed(_) | Outcome::Stopped(_) | Outcome::Passed => None,
        }
    }
}

/// Digits of an error that are known to less than this are drawn as a bound.
const RESOLUTION: f64 = 0.05;

impl Point {
    /// Answers once for the error and the count, then as often as the clock asks for the time: failing takes time, too.
    pub fn measure<T: Answer, E: Display>(
        setting: impl Into<String>,
        clock: &Clock,
        truth: &Interval,
        mut work: impl FnMut() -> Result<T, E>,
    ) -> Point {
        let (outcome, evaluations) = match work() {
            Ok(answer) => (Outcome::of(&answer, truth), answer.evaluations()),
            Err(error) => (Outcome::Failed(error.to_string()), None),
        };
        Point { setting: setting.into(), outcome, evaluations, time: clock.time(work) }
    }
}

/// Digits that a question of this condition leaves in double precision: −log₁₀(u·max(1, condition)).
///
/// ```
/// assert!((mdr_crosscheck::contest::ceiling(0.5) - 15.95).abs() < 0.01);
/// assert!((mdr_crosscheck::contest::ceiling(1e3) - 12.95).abs() < 0.01);
/// ```
pub fn ceiling(condition: f64) -> f64 {
    -(f64::EPSILON / 2.0 * condition.max(1.0)).log10()
}
