//! Exact decimals and fractions, as the user writes them.

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// The largest decimal exponent of a literal, and the largest number of its digits.
const LIMIT: i64 = 100_000;

/// An exact rational number as a user writes it: `0.3`, `-1.5e-12`, or a fraction of two integers `1/3`.
///
/// Its value is the same in every arithmetic: exactly this rational where the arithmetic can represent it, else the
/// nearest number or the tightest enclosure. Text that is not a finite number is rejected with the reason.
///
/// ```
/// use mdr_core::number::Literal;
/// let third: Literal = "1/3".parse()?;
/// assert_eq!(third.nearest_f64(), 1.0 / 3.0);
/// assert_eq!(third.to_string(), "1/3");
/// assert!("nan".parse::<Literal>().is_err());
/// # Ok::<(), mdr_core::number::LiteralError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Literal {
    text: String,
    pub(super) negative: bool,
    /// Significant digits of the numerator, without leading zeros; empty for zero.
    pub(super) digits: String,
    /// The value is ± digits · 10^exponent / denominator.
    pub(super) exponent: i64,
    /// Digits of the denominator; "1" for a decimal.
    pub(super) denominator: String,
}

/// Why a text is not a literal.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum LiteralError {
    /// Not of the form of a number.
    #[error("not a number: expected a decimal such as 0.25 or 1e-9, or a fraction of integers such as 1/3")]
    NotANumber,
    /// An infinity or a NaN was written.
    #[error("not finite: expected a decimal such as 0.25 or 1e-9")]
    NotFinite,
    /// More digits or a larger exponent than the limit.
    #[error("too large to be meant: at most {LIMIT} digits and a decimal exponent within ±{LIMIT}")]
    TooLarge,
    /// A fraction over zero.
    #[error("division by zero")]
    ZeroDenominator,
}

impl FromStr for Literal {
    type Err = LiteralError;

    fn from_str(text: &str) -> Result<Self, LiteralError> {
        let text = text.trim();
        let (negative, unsigned) = match text.as_bytes().first() {
            Some(b'-') => (true, &text[1..]),
            Some(b'+') => (false, &text[1..]),
            _ => (false, text),
        };
        if ["nan", "inf", "infinity"].iter().any(|word| unsigned.eq_ignore_ascii_case(word)) {
            return Err(LiteralError::NotFinite);
        }
        let (digits, exponent, denominator) = match unsigned.split_once('/') {
            Some((numerator, denominator)) => (integer(numerator)?, 0, integer(denominator)?),
            None => {
                let (digits, exponent) = decimal(unsigned)?;
                (digits, exponent, "1".to_owned())
            }
        };
        if denominator.is_empty() {
            return Err(LiteralError::ZeroDenominator);
        }
        Ok(Literal { text: text.to_owned(), negative, digits, exponent, denominator })
    }
}

/// The digits of an unsigned integer without leading zeros.
fn integer(text: &str) -> Result<String, LiteralError> {
    if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
        return Err(LiteralError::NotANumber);
    }
    if text.len() as i64 > LIMIT {
        return Err(LiteralError::TooLarge);
    }
    Ok(text.trim_start_matches('0').to_owned())
}

/// Digits and exponent of an unsigned decimal.
fn decimal(text: &str) -> Result<(String, i64), LiteralError> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        None => (text, 0),
        Some((mantissa, exponent)) => (mantissa, signed_exponent(exponent)?),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let mut digits = integer(&format!("{whole}{fraction}"))?;
    let mut exponent = exponent - fraction.len() as i64;
    let significant = digits.trim_end_matches('0').len();
    exponent += (digits.len() - significant) as i64;
    digits.truncate(significant);
    if digits.is_empty() {
        exponent = 0;
    }
    if exponent.abs() > LIMIT {
        return Err(LiteralError::TooLarge);
    }
    Ok((digits, exponent))
}

fn signed_exponent(text: &str) -> Result<i64, LiteralError> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    if unsigned.is_empty() || !unsigned.bytes().all(|b| b.is_ascii_digit()) {
        return Err(LiteralError::NotANumber);
    }
    text.parse()
        .map_err(|_| LiteralError::TooLarge)
        .and_then(|exponent: i64| if exponent.abs() > 2 * LIMIT { Err(LiteralError::TooLarge) } else { Ok(exponent) })
}

impl Literal {
    /// Whether the literal is zero.
    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// Whether the literal is below zero.
    pub fn is_negative(&self) -> bool {
        self.negative && !self.is_zero()
    }

    /// The value of a decimal that is exactly an integer of at most six digits.
    pub fn small_integer(&self) -> Option<i64> {
        let places = usize::try_from(self.exponent).ok()?;
        if self.denominator != "1" || self.digits.len() + places > 6 {
            return None;
        }
        let magnitude: i64 = format!("0{}{}", self.digits, "0".repeat(places)).parse().ok()?;
        Some(if self.negative { -magnitude } else { magnitude })
    }

    /// The nearest double; ±∞ or ±0 beyond the range of `f64`. Without the feature `mp` a fraction of integers above
    /// 2⁵³ may be two ulp off.
    pub fn nearest_f64(&self) -> f64 {
        #[cfg(feature = "mp")]
        if self.denominator != "1" {
            return nearest_f64(&self.to_rational());
        }
        let part = |digits: &str, exponent: i64| -> f64 {
            // `digits` is empty for zero, hence the leading 0; the grammar was checked by the parser.
            format!("0{digits}e{exponent}").parse().unwrap_or(f64::NAN)
        };
        let magnitude = if self.digits.len().max(self.denominator.len()) <= 300 {
            part(&self.digits, self.exponent) / part(&self.denominator, 0)
        } else if self.denominator == "1" {
            part(&self.digits, self.exponent)
        } else {
            // As 0.digits, which cannot leave the range; the decimal point is shifted last.
            let quotient = part(&format!(".{}", self.digits), 0) / part(&format!(".{}", self.denominator), 0);
            let shift = self.digits.len() as i64 - self.denominator.len() as i64;
            if shift == 0 { quotient } else { format!("{quotient:?}e{shift}").parse().unwrap_or(f64::NAN) }
        };
        if self.negative { -magnitude } else { magnitude }
    }

    /// The exact order of the two values, independent of their notation; no rounding, no GMP.
    ///
    /// ```
    /// use std::cmp::Ordering;
    /// use mdr_core::number::Literal;
    /// let [third, decimal]: [Literal; 2] = ["1/3".parse()?, "0.3333333333333333333".parse()?];
    /// assert_eq!(third.compare(&decimal), Ordering::Greater);
    /// assert_eq!(Literal::from(2).compare(&"20e-1".parse()?), Ordering::Equal);
    /// # Ok::<(), mdr_core::number::LiteralError>(())
    /// ```
    pub fn compare(&self, other: &Self) -> Ordering {
        let sign = |literal: &Self| i8::from(!literal.is_zero()) - 2 * i8::from(literal.is_negative());
        sign(self).cmp(&sign(other)).then_with(|| {
            if self.is_negative() { other.compare_magnitude(self) } else { self.compare_magnitude(other) }
        })
    }

    /// |self| against |other|, both nonzero or both zero, as fractions over a common denominator.
    fn compare_magnitude(&self, other: &Self) -> Ordering {
        let [one, two] = [(self, other), (other, self)].map(|(this, that)| {
            let digits = product(&this.digits, &that.denominator);
            let magnitude = this.exponent + digits.len() as i64;
            (magnitude, digits.trim_end_matches('0').to_owned())
        });
        one.0.cmp(&two.0).then_with(|| one.1.cmp(&two.1))
    }

    /// The exact value.
    #[cfg(feature = "mp")]
    pub fn to_rational(&self) -> rug::Rational {
        use rug::ops::Pow;
        use rug::{Integer, Rational};
        let parse = |digits: &str| digits.parse::<Integer>().unwrap_or_default();
        let scale = Integer::from(10).pow(self.exponent.unsigned_abs() as u32);
        let mut numerator = parse(&self.digits);
        let mut denominator = parse(&self.denominator);
        if self.exponent < 0 {
            denominator *= scale;
        } else {
            numerator *= scale;
        }
        let value = Rational::from((numerator, denominator));
        if self.negative { -value } else { value }
    }
}

/// The product of two positive integers in decimal digits without leading zeros.
fn product(one: &str, other: &str) -> String {
    const WIDTH: usize = 9;
    const BASE: u64 = 1_000_000_000;
    if other == "1" {
        return one.to_owned();
    }
    let limbs = |text: &str| -> Vec<u64> {
        let chunk = |chunk: &[u8]| chunk.iter().fold(0, |limb, digit| 10 * limb + u64::from(digit - b'0'));
        text.as_bytes().rchunks(WIDTH).map(chunk).collect()
    };
    let (one, other) = (limbs(one), limbs(other));
    let mut sum = vec![0u64; one.len() + other.len()];
    for (i, x) in one.iter().enumerate() {
        let mut carry = 0;
        for (j, y) in other.iter().enumerate() {
            let total = sum[i + j] + x * y + carry;
            sum[i + j] = total % BASE;
            carry = total / BASE;
        }
        sum[i + other.len()] += carry;
    }
    let text: String = sum.iter().rev().map(|limb| format!("{limb:0WIDTH$}")).collect();
    text.trim_start_matches('0').to_owned()
}

/// The nearest double.
#[cfg(feature = "mp")]
fn nearest_f64(value: &rug::Rational) -> f64 {
    // Rounding to 53 bits is correct unless the double is subnormal; there the sticky bits of a longer float decide.
    let direct = rug::Float::with_val(f64::MANTISSA_DIGITS, value).to_f64();
    if direct.is_normal() { direct } else { rug::Float::with_val(4096, value).to_f64() }
}

/// In its original notation.
impl fmt::Display for Literal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl From<i64> for Literal {
    fn from(value: i64) -> Self {
        let all = value.unsigned_abs().to_string();
        let digits = all.trim_end_matches('0').to_owned();
        let exponent = if digits.is_empty() { 0 } else { (all.len() - digits.len()) as i64 };
        Literal { text: value.to_string(), negative: value < 0, digits, exponent, denominator: "1".to_owned() }
    }
}

/// The shortest decimal that reads back as a finite double: 0.1 becomes 1/10, not the double nearest to it.
impl TryFrom<f64> for Literal {
    type Error = LiteralError;

    fn try_from(value: f64) -> Result<Self, LiteralError> {
        format!("{value:e}").parse()
    }
}
