//! How far an answer is from the exact result.

use mdr_core::number::certify::Decimal;
use mdr_core::number::{Interval, Real};
use rug::Float;
use serde::Serialize;

/// The accuracy that a method reached.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "outcome", content = "digits", rename_all = "kebab-case")]
pub enum Accuracy {
    /// −log₁₀ of the relative error; below zero where not even the order of magnitude is right.
    Digits(f64),
    /// At least so many digits are right: the error is below the roundoff of the answer or the width of the enclosure.
    AtLeast(f64),
    /// No answer, and why.
    #[serde(untagged)]
    Failed {
        /// The reason.
        failed: String,
    },
}

/// An error known to fewer digits than this is reported as a bound.
const RESOLUTION: f64 = 0.05;

impl Accuracy {
    /// The digits of `answer` that are right, where `truth` encloses the exact result and excludes zero.
    ///
    /// ```
    /// use mdr_core::number::{Interval, Precision, Real};
    /// use mdr_crosscheck::work_precision::Accuracy;
    /// use rug::Float;
    /// let third = Interval::from_int(Precision::new(200), 1).over(3);
    /// let of = |answer: f64| Accuracy::of(&Float::with_val(53, answer), &third);
    /// assert!(matches!(of(0.333), Accuracy::Digits(digits) if (digits - 3.0).abs() < 1e-9));
    /// assert!(matches!(of(1.0 / 3.0), Accuracy::AtLeast(digits) if digits > 15.9));
    /// assert!(of(f64::NAN).digits().is_none());
    /// ```
    pub fn of(answer: &Float, truth: &Interval) -> Accuracy {
        if !answer.is_finite() {
            return Accuracy::failed(&if answer.is_nan() { "not a number" } else { "overflow" });
        }
        if truth.contains_zero() || !truth.is_finite() {
            return Accuracy::failed(&"the exact result is not known");
        }
        let precision = answer.prec().max(truth.lower().prec());
        let off = |end: &Float| Float::with_val(precision, end - answer).abs();
        let [below, above] = [off(truth.lower()), off(truth.upper())];
        let least = if truth.contains(answer) { Float::new(precision) } else { below.clone().min(&above) };
        let size = truth.mid().abs();
        // In MPFR's range of exponents: an error of 10⁻⁵⁰⁰⁰ is no double.
        let digits = |error: Float| -(error / &size).log10().to_f64();
        let own = f64::from(answer.prec()) * std::f64::consts::LOG10_2;
        let (certain, hoped) = (digits(below.max(&above)), digits(least));
        if certain >= own {
            Accuracy::AtLeast(own)
        } else if hoped - certain > RESOLUTION {
            Accuracy::AtLeast(certain)
        } else {
            Accuracy::Digits(certain)
        }
    }

    pub(super) fn failed(reason: &impl ToString) -> Accuracy {
        Accuracy::Failed { failed: reason.to_string() }
    }

    /// The digits that are certainly right; `None` for a failure.
    pub fn digits(&self) -> Option<f64> {
        match self {
            Accuracy::Digits(digits) | Accuracy::AtLeast(digits) => Some(*digits),
            Accuracy::Failed { .. } => None,
        }
    }

    /// Digits that a question of this condition leaves in double precision: −log₁₀(u·max(1, condition)), u = 2⁻⁵³.
    pub(super) fn attainable(condition: f64) -> f64 {
        -(f64::EPSILON / 2.0 * condition.max(1.0)).log10()
    }

    /// The outcome with the fewest digits: what several numbers together are worth. A failure is worse than any.
    fn worst(outcomes: impl IntoIterator<Item = Accuracy>) -> Accuracy {
        let rank = |outcome: &Accuracy| outcome.digits().unwrap_or(f64::NEG_INFINITY);
        let least = outcomes.into_iter().min_by(|one, other| rank(one).total_cmp(&rank(other)));
        least.unwrap_or_else(|| Accuracy::failed(&"no answer"))
    }
}

/// The answer of a method.
pub(super) trait Answer {
    /// Compares it with enclosures of the exact results, one for each number.
    fn outcome(&self, truths: &[Interval]) -> Accuracy;

    /// Evaluations spent, where the method counts them.
    fn evaluations(&self) -> Option<u64> {
        None
    }
}

impl Answer for f64 {
    fn outcome(&self, truths: &[Interval]) -> Accuracy {
        Float::with_val(f64::MANTISSA_DIGITS, *self).outcome(truths)
    }
}

impl Answer for Float {
    fn outcome(&self, truths: &[Interval]) -> Accuracy {
        Accuracy::worst(truths.iter().map(|truth| Accuracy::of(self, truth)))
    }
}

/// An enclosure is worth what its worse end is.
impl Answer for Interval {
    fn outcome(&self, truths: &[Interval]) -> Accuracy {
        Accuracy::worst([self.lower(), self.upper()].map(|end| end.outcome(truths)))
    }
}

impl Answer for Decimal {
    fn outcome(&self, truths: &[Interval]) -> Accuracy {
        let precision = truths.iter().map(|truth| truth.lower().prec()).max().unwrap_or(f64::MANTISSA_DIGITS);
        match Float::parse(self.to_string()) {
            Ok(text) => Float::with_val(precision, text).outcome(truths),
            Err(error) => Accuracy::failed(&error),
        }
    }
}

/// Several numbers are worth what the worst is.
impl<T: Answer> Answer for Vec<T> {
    fn outcome(&self, truths: &[Interval]) -> Accuracy {
        Accuracy::worst(self.iter().zip(truths).map(|(number, truth)| number.outcome(std::slice::from_ref(truth))))
    }
}

/// An answer and the evaluations that it took.
impl<T: Answer> Answer for (T, u64) {
    fn outcome(&self, truths: &[Interval]) -> Accuracy {
        self.0.outcome(truths)
    }

    fn evaluations(&self) -> Option<u64> {
        Some(self.1)
    }
}
