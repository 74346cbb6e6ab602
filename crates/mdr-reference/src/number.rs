//! Numbers as other programs print them, finite or not.

use std::fmt;
use std::str::FromStr;

use crate::decimal::{Decimal, DecimalError};

/// A number as a program may print it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Number {
    Finite(Decimal),
    Infinite { negative: bool },
    Nan,
}

impl Number {
    /// A value that is not finite, in the spellings of C, C++, Fortran, Rust, Python, R, Java and of the former C
    /// library of Microsoft (`1.#INF`, `-1.#IND00`).
    pub(crate) fn not_finite(text: &str) -> Option<Self> {
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let word = unsigned.to_ascii_lowercase();
        // nan(ind), nan(0x8000000000000)
        let name = word.strip_suffix(')').and_then(|word| word.split_once('(')).map_or(word.as_str(), |(name, _)| name);
        match (word.strip_prefix("1.#").map(|kind| kind.trim_end_matches('0')), name) {
            (Some("inf"), _) => Some(Number::Infinite { negative: text.starts_with('-') }),
            (Some("qnan" | "snan" | "nan" | "ind"), _) | (None, "nan") => Some(Number::Nan),
            _ => ["inf", "infinity", "∞"]
                .contains(&word.as_str())
                .then(|| Number::Infinite { negative: text.starts_with('-') }),
        }
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        match Decimal::from_double(value) {
            Some(decimal) => Number::Finite(decimal),
            None if value.is_nan() => Number::Nan,
            None => Number::Infinite { negative: value < 0.0 },
        }
    }
}

impl FromStr for Number {
    type Err = DecimalError;

    fn from_str(text: &str) -> Result<Self, DecimalError> {
        let text = text.trim();
        Number::not_finite(text).map_or_else(|| text.parse().map(Number::Finite), Ok)
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Number::Finite(value) => value.fmt(f),
            Number::Infinite { negative: false } => f.write_str("inf"),
            Number::Infinite { negative: true } => f.write_str("-inf"),
            Number::Nan => f.write_str("nan"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_finite_as_others_print_it() {
        let read = |text: &str| text.parse::<Number>();
        for text in
            ["nan", "-nan", "NaN", "+NAN", "-nan(ind)", "nan(0x8000000000000)", "1.#QNAN", "-1.#IND00", "1.#SNAN"]
        {
            assert_eq!(read(text), Ok(Number::Nan), "{text}");
        }
        for text in ["inf", "+Inf", "INFINITY", "Infinity", "1.#INF", "1.#INF00", " inf ", "∞"] {
            assert_eq!(read(text), Ok(Number::Infinite { negative: false }), "{text}");
        }
        for text in ["-inf", "-Infinity", "-1.#INF0000"] {
            assert_eq!(read(text), Ok(Number::Infinite { negative: true }), "{text}");
        }
        for text in ["nano", "info", "1.#", "1.#JUNK", "nan(", "inf(1)", "--inf", "in f"] {
            assert_eq!(read(text), Err(DecimalError::NotANumber), "{text}");
        }
        assert_eq!("-1.#IND".parse::<Decimal>(), Err(DecimalError::NotFinite));
    }
}
