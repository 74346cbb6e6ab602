//! A correctly rounded decimal as text, independent of GMP.

use std::fmt;

#[cfg(feature = "mp")]
use rug::Integer;

/// ± d.ddd… · 10^exponent with a fixed number of significant digits, the first not zero; or exactly zero (the default).
/// The exponent has no limit.
///
/// Displays without an exponent where the decimal exponent lies between −6 and the number of digits less one, else as
/// `d.ddde±x`, so that every digit shown is one of them; zero as `0`.
///
/// ```
/// # #[cfg(feature = "mp")] {
/// use mdr_core::number::certify::Enclosure;
/// let show = |n: i64, d: i64| Enclosure::Exact((n, d).into()).round(3).map(|decimal| decimal.to_string());
/// assert_eq!(show(-2, 3).as_deref(), Some("-0.667"));
/// assert_eq!(show(1, 1_000_000_000).as_deref(), Some("1.00e-9"));
/// assert_eq!(show(2698, 1).as_deref(), Some("2.70e+3"));
/// assert_eq!(show(0, 1).as_deref(), Some("0"));
/// # }
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Decimal {
    negative: bool,
    digits: String,
    /// An integer as text; empty for zero.
    exponent: String,
}

impl Decimal {
    /// ± significand · 10^(exponent + 1 − digits), with a significand of exactly `digits` digits.
    #[cfg(feature = "mp")]
    pub(super) fn new(negative: bool, significand: Integer, exponent: Integer, digits: u32) -> Self {
        let text = significand.to_string();
        debug_assert_eq!(text.len(), digits as usize);
        Decimal { negative, digits: text, exponent: exponent.to_string() }
    }

    /// Whether the number is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// Whether the number is below zero.
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// The significant digits, the decimal point after the first; empty for zero.
    pub fn digits(&self) -> &str {
        &self.digits
    }

    /// The decimal exponent: the number lies between 10^exponent and 10^(exponent + 1) in magnitude. 0 for zero.
    #[cfg(feature = "mp")]
    pub fn exponent(&self) -> Integer {
        self.exponent.parse().unwrap_or_default()
    }

    /// log₁₀ of the magnitude to about 16 digits; −∞ for zero.
    pub fn log10_f64(&self) -> f64 {
        // Seventeen digits fix a double; an empty string is the zero.
        let leading = &self.digits[..self.digits.len().min(17)];
        let mantissa: f64 = format!("0{leading}e-{leading_zeros}", leading_zeros = leading.len().saturating_sub(1))
            .parse()
            .unwrap_or(f64::NAN);
        self.exponent.parse().unwrap_or(0.0) + mantissa.log10()
    }

    /// The nearest double; ±∞ and ±0 beyond the range of `f64`.
    pub fn to_f64(&self) -> f64 {
        self.to_string().parse().unwrap_or(f64::NAN)
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        if self.negative {
            f.write_str("-")?;
        }
        let digits = &self.digits;
        match self.exponent.parse::<i64>() {
            Ok(exponent @ -6..0) => {
                let zeros = exponent.unsigned_abs() as usize - 1;
                write!(f, "0.{}{digits}", "0".repeat(zeros))
            }
            Ok(exponent) if (0..digits.len() as i64).contains(&exponent) => {
                let (whole, fraction) = digits.split_at(exponent as usize + 1);
                let point = if fraction.is_empty() { "" } else { "." };
                write!(f, "{whole}{point}{fraction}")
            }
            _ => {
                let (first, rest) = digits.split_at(1);
                let point = if rest.is_empty() { "" } else { "." };
                let sign = if self.exponent.starts_with('-') { "" } else { "+" };
                write!(f, "{first}{point}{rest}e{sign}{}", self.exponent)
            }
        }
    }
}
