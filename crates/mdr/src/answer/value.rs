//! A number of an answer, with its promise, or the reason why there is none.

use std::fmt;

use mdr_core::contact::{Error, Result, Status};
use mdr_core::named;
use mdr_core::number::{Decimal, Literal};

named! {
    /// How far a number can be trusted.
    pub enum Promise {
        /// Hardware arithmetic: accurate to some roundings times the condition of the question; nothing is proved.
        F64 = "f64",
        /// Every printed digit is proved, and the last is correctly rounded.
        Certified = "certified",
    }
}

/// A result in its arithmetic.
#[derive(Clone, Debug, PartialEq)]
pub enum Number {
    /// Correctly rounded; every digit is proved.
    Certified(Decimal),
    /// A double.
    F64(f64),
}

impl Number {
    /// How far the number can be trusted.
    pub fn promise(&self) -> Promise {
        match self {
            Number::Certified(_) => Promise::Certified,
            Number::F64(_) => Promise::F64,
        }
    }

    /// The nearest double; ±∞ and ±0 beyond the range of f64.
    pub fn to_f64(&self) -> f64 {
        match self {
            Number::Certified(decimal) => decimal.to_f64(),
            Number::F64(value) => *value,
        }
    }
}

/// Writes every proved digit; a double is written so that it reads back as itself.
impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Number::Certified(decimal) => decimal.fmt(f),
            // −0 is no other number than 0.
            Number::F64(0.0) => f.write_str("0"),
            Number::F64(value) if (1e-6..1e16).contains(&value.abs()) => write!(f, "{value}"),
            Number::F64(value) => write!(f, "{value:e}"),
        }
    }
}

/// A number, or the reason why there is none. It is never replaced by 0, NaN or infinity.
///
/// `N` is the type of its arithmetic: [`Number`] in an answer, an enclosure while its digits are being decided.
#[derive(Clone, Debug, PartialEq)]
pub enum Value<N = Number> {
    /// A result.
    Known(N),
    /// A number exactly as it was written, in the scene or as a short decimal chosen by the program.
    Given(Literal),
    /// No number.
    Unknown {
        /// The kind of failure.
        status: Status,
        /// log₁₀ of the magnitude of an overflow or underflow, if it is computed.
        log10: Option<f64>,
        /// The reason in words.
        why: Option<String>,
    },
}

impl<N> Value<N> {
    /// A result that may be out of range or out of its domain.
    ///
    /// # Errors
    /// Errors that concern the whole computation, not one value.
    pub(crate) fn from_result(result: Result<N>) -> Result<Self> {
        Ok(match result {
            Ok(value) => Value::Known(value),
            Err(Error::OutOfRange { log10, .. }) => Value::out_of_range(log10),
            Err(error @ Error::Domain { .. }) => Value::unknown(Status::DomainError, error.to_string()),
            Err(error @ (Error::NoConvergence { .. } | Error::BudgetSpent { .. })) => {
                Value::unknown(Status::Undecided, error.to_string())
            }
            Err(error) => return Err(error),
        })
    }

    /// A number that no double holds, by its logarithm.
    pub(crate) fn out_of_range(log10: f64) -> Self {
        let status = if log10 > 0.0 { Status::Overflow } else { Status::Underflow };
        Value::Unknown { status, log10: Some(log10), why: None }
    }

    /// No number, for a reason in words.
    pub(crate) fn unknown(status: Status, why: impl Into<String>) -> Self {
        Value::Unknown { status, log10: None, why: Some(why.into()) }
    }

    /// `ok` where there is a number.
    pub fn status(&self) -> Status {
        match self {
            Value::Unknown { status, .. } => *status,
            _ => Status::Ok,
        }
    }

    /// log₁₀ of the magnitude of a number that is out of range.
    pub fn log10(&self) -> Option<f64> {
        match self {
            Value::Unknown { log10, .. } => *log10,
            _ => None,
        }
    }

    /// The reason why there is no number.
    pub fn why(&self) -> Option<&str> {
        match self {
            Value::Unknown { why, .. } => why.as_deref(),
            _ => None,
        }
    }

    /// Converts the number to another arithmetic, where it may turn out to be unknown.
    pub(crate) fn and_then<M>(self, f: impl FnOnce(N) -> Value<M>) -> Value<M> {
        match self {
            Value::Known(number) => f(number),
            Value::Given(literal) => Value::Given(literal),
            Value::Unknown { status, log10, why } => Value::Unknown { status, log10, why },
        }
    }
}

impl Value {
    /// The result; `None` if it is unknown or was given.
    pub fn number(&self) -> Option<&Number> {
        match self {
            Value::Known(number) => Some(number),
            _ => None,
        }
    }

    /// The nearest double; `None` if there is no number, or no double within the range of f64.
    ///
    /// ```
    /// use mdr::answer::{Number, Value};
    /// assert_eq!(Value::Known(Number::F64(-0.25)).to_f64(), Some(-0.25));
    /// assert_eq!(Value::<Number>::Given("1/4".parse()?).to_f64(), Some(0.25));
    /// # Ok::<(), mdr_core::number::LiteralError>(())
    /// ```
    pub fn to_f64(&self) -> Option<f64> {
        let (nearest, is_zero) = match self {
            Value::Known(number @ Number::Certified(decimal)) => (number.to_f64(), decimal.is_zero()),
            Value::Known(Number::F64(value)) => (*value, true),
            Value::Given(literal) => (literal.nearest_f64(), literal.is_zero()),
            Value::Unknown { .. } => return None,
        };
        (nearest.is_finite() && (nearest != 0.0 || is_zero)).then_some(nearest)
    }

    /// How far the number can be trusted; `None` if there is no number, or it was given.
    pub fn promise(&self) -> Option<Promise> {
        self.number().map(Number::promise)
    }
}

/// Writes the number with all its digits; without a number its magnitude, `overflow: about 10^400.2`, or its status.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Known(number) => number.fmt(f),
            Value::Given(literal) => literal.fmt(f),
            Value::Unknown { status, log10: Some(log10), .. } if log10.is_finite() => {
                write!(f, "{status}: about 10^{log10:.6}")
            }
            Value::Unknown { status, .. } => status.fmt(f),
        }
    }
}
