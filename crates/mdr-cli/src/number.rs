//! Numbers of an answer.

use serde::Serialize;

/// A number in its arithmetic: the digits of a certified one as text, a hardware number as such.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum Number {
    /// Proved digits, or an input as it was written.
    Decimal(String),
    /// A double.
    Double(f64),
}

impl std::fmt::Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Number::Decimal(text) => f.write_str(text),
            // A double is written so that it reads back as itself.
            Number::Double(value) if *value == 0.0 || (1e-6..1e16).contains(&value.abs()) => write!(f, "{value}"),
            Number::Double(value) => write!(f, "{value:e}"),
        }
    }
}
