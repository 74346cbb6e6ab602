//! Exact decimals of any length: parsed, subtracted, added, compared, and measured by their logarithm. Nothing is
//! rounded, so the judge is correct even where two numbers agree to fifty digits.

use std::cmp::Ordering;
use std::fmt;
use std::str::FromStr;

use crate::hexadecimal;
use crate::number::Number;

/// ± D · 10^exponent with an integer D of any length.
///
/// ```
/// use mdr_reference::Decimal;
/// let a: Decimal = "0.1".parse()?;
/// let b: Decimal = "0x1.999999999999ap-4".parse()?; // the double nearest to it, as C writes it with %a
/// assert_eq!((&b - &a).to_string(), "5.5511151231257827021181583404541015625e-18");
/// # Ok::<(), mdr_reference::DecimalError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Decimal {
    negative: bool,
    /// 0 to 9, the first and the last not 0; empty for zero.
    digits: Vec<u8>,
    exponent: i64,
}

/// Why a text is not a decimal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecimalError {
    /// Not of the form of a number: `0.25`, `-1e-9`, `0x1.8p-3`.
    NotANumber,
    /// An infinity or a NaN.
    NotFinite,
    /// A decimal exponent beyond ±10¹⁷.
    TooLarge,
    /// A hexadecimal number with a binary exponent beyond ±17 000.
    BinaryTooLarge,
}

impl fmt::Display for DecimalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            DecimalError::NotANumber => "not a number: expected a decimal such as 0.25 or 1e-9, or 0x1.8p-3",
            DecimalError::NotFinite => "not finite",
            DecimalError::TooLarge => "a decimal exponent beyond ±10^17",
            DecimalError::BinaryTooLarge => "a binary exponent beyond ±17000: write the number with decimal digits",
        })
    }
}

impl std::error::Error for DecimalError {}

/// The largest decimal exponent.
const LARGEST: i64 = 100_000_000_000_000_000;

/// If one number is this many decades below the other, their difference is taken to be the larger one.
const APART: i64 = 20_000;

impl FromStr for Decimal {
    type Err = DecimalError;

    fn from_str(text: &str) -> Result<Self, DecimalError> {
        let text = text.trim();
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let negative = text.starts_with('-');
        if Number::not_finite(text).is_some() {
            return Err(DecimalError::NotFinite);
        }
        if let Some(digits) = unsigned.strip_prefix("0x").or_else(|| unsigned.strip_prefix("0X")) {
            let (digits, exponent) = hexadecimal::read(digits)?;
            return Ok(Decimal::new(negative, digits, exponent));
        }
        let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, whole(exponent)?),
            None => (unsigned, 0),
        };
        let (integer, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: Vec<u8> = integer.bytes().chain(fraction.bytes()).map(|byte| byte.wrapping_sub(b'0')).collect();
        if digits.is_empty() || digits.iter().any(|digit| *digit > 9) {
            return Err(DecimalError::NotANumber);
        }
        let value = Decimal::new(negative, digits, exponent - fraction.len() as i64);
        let top = value.exponent + value.digits.len() as i64;
        if value.exponent.abs().max(top.abs()) > LARGEST { Err(DecimalError::TooLarge) } else { Ok(value) }
    }
}

/// An exponent.
pub(crate) fn whole(text: &str) -> Result<i64, DecimalError> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    if unsigned.is_empty() || !unsigned.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(DecimalError::NotANumber);
    }
    match text.parse::<i64>() {
        Ok(exponent) if exponent.abs() <= 2 * LARGEST => Ok(exponent),
        _ => Err(DecimalError::TooLarge),
    }
}

impl Decimal {
    fn new(negative: bool, mut digits: Vec<u8>, mut exponent: i64) -> Self {
        while digits.last() == Some(&0) {
            digits.pop();
            exponent += 1;
        }
        let leading = digits.iter().take_while(|digit| **digit == 0).count();
        digits.drain(..leading);
        if digits.is_empty() { Decimal::default() } else { Decimal { negative, digits, exponent } }
    }

    /// The exact value of a double; `None` if it is not finite.
    pub fn from_double(value: f64) -> Option<Self> {
        // A double has at most 767 digits.
        format!("{value:.800e}").parse().ok()
    }

    /// Whether this is zero.
    pub fn is_zero(&self) -> bool {
        self.digits.is_empty()
    }

    /// Whether this is an integer.
    pub fn is_whole(&self) -> bool {
        self.exponent >= 0
    }

    /// Whether this is below zero.
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// The magnitude.
    pub fn abs(&self) -> Self {
        Decimal { negative: false, ..self.clone() }
    }

    /// The nearest double, ties to even; ±∞ or ±0 beyond the range of `f64`.
    pub fn nearest(&self) -> f64 {
        self.to_string().parse().unwrap_or(f64::NAN)
    }

    /// log₁₀ of the magnitude, within the last digits of an `f64`; −∞ for zero.
    pub fn log10(&self) -> f64 {
        let leading = self.digits.iter().take(18).rev().fold(0.0, |sum, digit| (sum + f64::from(*digit)) / 10.0);
        leading.log10() + self.top() as f64
    }

    /// One more than the decimal exponent of the first digit.
    fn top(&self) -> i64 {
        self.exponent + self.digits.len() as i64
    }

    /// The digits above 10^exponent, with zeros down to it.
    fn aligned(&self, exponent: i64) -> Vec<u8> {
        let zeros = usize::try_from(self.exponent - exponent).unwrap_or(0);
        let mut digits = self.digits.clone();
        digits.resize(digits.len() + zeros, 0);
        digits
    }

    fn compare_magnitude(&self, other: &Decimal) -> Ordering {
        match (self.is_zero(), other.is_zero()) {
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
            // The last digit is nonzero, so a longer number with the same beginning is larger.
            (false, false) => self.top().cmp(&other.top()).then_with(|| self.digits.cmp(&other.digits)),
        }
    }

    /// self + other, exactly unless they are more than 20 000 decades apart; then the larger one.
    fn sum(&self, other: &Decimal, other_negative: bool) -> Decimal {
        let order = self.compare_magnitude(other);
        let (large, small, negative) = match order {
            Ordering::Less => (other, self, other_negative),
            _ => (self, other, self.negative),
        };
        if small.is_zero() || large.top() - small.top() > APART {
            return Decimal { negative, ..large.clone() };
        }
        let exponent = large.exponent.min(small.exponent);
        let (mut digits, small) = (large.aligned(exponent), small.aligned(exponent));
        let subtract = self.negative != other_negative;
        if subtract && order.is_eq() {
            return Decimal::default();
        }
        let carried = combine(&mut digits, &small, if subtract { -1 } else { 1 });
        if carried {
            digits.insert(0, 1);
        }
        Decimal::new(negative, digits, exponent)
    }
}

/// Adds (`sign` 1) or subtracts (−1) a number that is not longer, in place; returns whether a one is carried out.
fn combine(digits: &mut [u8], other: &[u8], sign: i8) -> bool {
    let mut carry = 0;
    let padded = other.iter().rev().map(|digit| *digit as i8).chain(std::iter::repeat(0));
    for (digit, addend) in digits.iter_mut().rev().zip(padded) {
        let sum = *digit as i8 + sign * addend + carry;
        carry = sum.div_euclid(10);
        *digit = sum.rem_euclid(10) as u8;
    }
    carry > 0
}

impl std::ops::Sub for &Decimal {
    type Output = Decimal;
    fn sub(self, other: &Decimal) -> Decimal {
        self.sum(other, !other.negative)
    }
}

impl std::ops::Add for &Decimal {
    type Output = Decimal;
    fn add(self, other: &Decimal) -> Decimal {
        self.sum(other, other.negative)
    }
}

impl std::ops::Mul for &Decimal {
    type Output = Decimal;
    fn mul(self, other: &Decimal) -> Decimal {
        let mut sums = vec![0_u64; self.digits.len() + other.digits.len()];
        for (place, one) in self.digits.iter().enumerate() {
            for (at, digit) in other.digits.iter().enumerate() {
                sums[place + at + 1] += u64::from(*one) * u64::from(*digit);
            }
        }
        let mut carry = 0;
        let mut digits: Vec<u8> = sums
            .into_iter()
            .rev()
            .map(|sum| {
                let sum = sum + carry;
                carry = sum / 10;
                (sum % 10) as u8
            })
            .collect();
        digits.reverse();
        Decimal::new(self.negative != other.negative, digits, self.exponent + other.exponent)
    }
}

impl PartialOrd for Decimal {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Decimal {
    fn cmp(&self, other: &Self) -> Ordering {
        let sign = |value: &Decimal| if value.is_zero() { 0 } else { 1 - 2 * i8::from(value.negative) };
        sign(self).cmp(&sign(other)).then_with(|| {
            let order = self.compare_magnitude(other);
            if self.negative { order.reverse() } else { order }
        })
    }
}

/// All digits: `d.ddde±x` outside of 10⁻⁶ to 10²¹.
impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        let text: String = self.digits.iter().map(|digit| char::from(b'0' + digit)).collect();
        let sign = if self.negative { "-" } else { "" };
        let top = self.top();
        match usize::try_from(top.unsigned_abs()).unwrap_or(usize::MAX) {
            size if (1..=21).contains(&top) => match text.split_at_checked(size) {
                Some((integer, "")) => write!(f, "{sign}{integer}"),
                Some((integer, fraction)) => write!(f, "{sign}{integer}.{fraction}"),
                None => write!(f, "{sign}{text}{}", "0".repeat(size - text.len())),
            },
            size if (-5..=0).contains(&top) => write!(f, "{sign}0.{}{text}", "0".repeat(size)),
            _ => {
                let (first, rest) = text.split_at(1);
                let point = if rest.is_empty() { "" } else { "." };
                write!(f, "{sign}{first}{point}{rest}e{}", top - 1)
            }
        }
    }
}
