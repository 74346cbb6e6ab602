//! Conversion of enclosures to decimals with every digit proved.

use rug::float::Round;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

pub use super::Decimal;
use super::{Interval, Precision, Real};
use crate::contact::{Error, Quantity, Result};

/// Returns `digits` if so many can be computed.
///
/// # Errors
/// [`Error::Domain`] unless 1 ≤ `digits` ≤ 1 000 000.
pub fn require_digits(digits: u32) -> Result<u32> {
    if (1..=1_000_000).contains(&digits) {
        return Ok(digits);
    }
    Err(Error::Domain { quantity: Quantity::Digits, value: digits.to_string(), requirement: "from 1 to 1000000" })
}

/// The proved information about a real number.
#[derive(Clone, Debug)]
pub enum Enclosure {
    /// The number lies in this interval.
    Value(Interval),
    /// The number is this rational. Zero and decimal ties need it: no interval of positive width decides them.
    Exact(Rational),
    /// The number is ±e^L with L in this interval: for magnitudes beyond the exponent range of MPFR, up to e^(10^300)
    /// and more.
    Log {
        /// Whether the number is below zero.
        negative: bool,
        /// L.
        ln_magnitude: Interval,
    },
}

impl From<Interval> for Enclosure {
    fn from(interval: Interval) -> Self {
        Enclosure::Value(interval)
    }
}

impl From<Rational> for Enclosure {
    fn from(value: Rational) -> Self {
        Enclosure::Exact(value)
    }
}

impl Enclosure {
    /// The number correctly rounded to `digits` ≥ 1 significant decimal digits, ties to the even digit; `None` while
    /// the enclosure admits more than one result.
    ///
    /// ```
    /// use mdr_core::number::certify::Enclosure;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let pi = |bits| Enclosure::from(Interval::from_int(Precision::new(bits), 0).pi());
    /// assert!(pi(16).round(8).is_none());
    /// assert_eq!(pi(40).round(8).map(|decimal| decimal.to_string()), Some("3.1415927".to_owned()));
    /// ```
    pub fn round(&self, digits: u32) -> Option<Decimal> {
        match self {
            Enclosure::Exact(value) => Some(round_rational(value, digits)),
            Enclosure::Value(value) => round_interval(value, digits),
            Enclosure::Log { negative, ln_magnitude } => round_exponential(*negative, ln_magnitude, digits),
        }
    }

    /// Bits of relative accuracy; `None` if the number may be zero, `i64::MAX` if it is exact.
    pub fn accuracy_bits(&self) -> Option<i64> {
        match self {
            Enclosure::Exact(_) => Some(i64::MAX),
            Enclosure::Value(value) if value.is_point() => Some(i64::MAX),
            Enclosure::Value(value) if value.contains_zero() || !value.is_finite() => None,
            Enclosure::Value(value) => Some(value.accuracy_bits()),
            Enclosure::Log { ln_magnitude, .. } => ln_magnitude.radius().get_exp().map(|bits| -i64::from(bits)),
        }
    }

    /// Whether the number is certainly nonzero and known to fewer bits than `asked`, so that more precision gains as
    /// many bits. A number known to enough bits that still has no digits is close to a tie.
    pub fn is_short_of(&self, asked: Precision) -> bool {
        self.accuracy_bits().is_some_and(|bits| bits < i64::from(asked.bits()))
    }
}

/// The precision to try after one that did not decide the digits. It adds the bits lost by the enclosures that are
/// still open; it doubles if a number may be zero or nothing is known.
pub fn next_precision<'a>(
    asked: Precision,
    tried: Precision,
    open: impl IntoIterator<Item = Option<&'a Enclosure>>,
) -> Precision {
    /// Added where the loss cannot be measured: at a tie, or for one more rounding.
    const MORE: u32 = 32;
    let needed = |enclosure: Option<&Enclosure>| match enclosure?.accuracy_bits()? {
        i64::MAX => None,
        bits => u32::try_from(i64::from(tried.bits()) - bits).ok().map(|lost| asked.bits().saturating_add(lost)),
    };
    let double = tried.bits().saturating_mul(2);
    let bits = open.into_iter().map(|enclosure| needed(enclosure).unwrap_or(double)).max().unwrap_or(double);
    Precision::new(bits.max(tried.bits() + tried.bits() / 4).saturating_add(MORE))
}

/// The most bits for numbers whose loss of precision is known.
const MOST_BITS: u32 = 1 << 21;

/// Evaluates `f` at increasing precision until all its quantities are decided to `digits` significant digits, and
/// returns them correctly rounded.
///
/// The precision starts at `start` and grows by [the bits that were lost](next_precision). An [`Error::Undecided`] of
/// `f` counts as an attempt; any other error ends the search. A number that is a decimal tie or zero is decided only by
/// an exact enclosure.
///
/// # Errors
/// [`Error::Undecided`], with the quantity, beyond 64 · `start` + 20 000 bits, or 2²¹ where these are known to suffice;
/// [`Error::Domain`] for digits outside 1 to 10⁶; whatever `f` returns.
///
/// ```
/// use mdr_core::contact::Quantity;
/// use mdr_core::number::certify::certify;
/// use mdr_core::number::{Interval, Precision, Real};
/// // (10³⁰ + 1)^½ − 10¹⁵ loses a hundred bits; the digits are right all the same.
/// let [difference] = certify([Quantity::Indentation], 10, Precision::new(64), |precision| {
///     let large = Interval::from_int(precision, 10).powi(15);
///     Ok([((large.square() + large.lit(1)).sqrt() - large).into()])
/// })?;
/// assert_eq!(difference.to_string(), "5.000000000e-16");
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub fn certify<const K: usize>(
    quantities: [Quantity; K],
    digits: u32,
    start: Precision,
    mut f: impl FnMut(Precision) -> Result<[Enclosure; K]>,
) -> Result<[Decimal; K]> {
    require_digits(digits)?;
    let most = start.bits().saturating_mul(64).saturating_add(20_000);
    let mut bits = start.bits();
    let mut decided: [Option<Decimal>; K] = [const { None }; K];
    loop {
        let mut failure = None;
        let mut next = bits.saturating_mul(2).min(most);
        match f(Precision::new(bits)) {
            Ok(enclosures) => {
                for (decimal, enclosure) in decided.iter_mut().zip(&enclosures) {
                    *decimal = decimal.take().or_else(|| enclosure.round(digits));
                }
                let open = enclosures.iter().zip(&decided).filter(|(_, decimal)| decimal.is_none());
                let open: Vec<&Enclosure> = open.map(|(enclosure, _)| enclosure).collect();
                let is_measured = open.iter().all(|enclosure| enclosure.is_short_of(start));
                next = next_precision(start, Precision::new(bits), open.into_iter().map(Some)).bits();
                next = next.min(if is_measured { MOST_BITS } else { most });
            }
            Err(error @ Error::Undecided { .. }) => failure = Some(error),
            Err(error) => return Err(error),
        }
        let undecided = decided.iter().zip(quantities).find(|(decimal, _)| decimal.is_none());
        let Some((_, quantity)) = undecided else { break };
        if bits >= most.min(next) {
            return Err(failure.unwrap_or(Error::Undecided { quantity, bits, what: "the last digit asked for" }));
        }
        bits = next;
    }
    Ok(decided.map(Option::unwrap_or_default))
}

/// Guard bits of the conversion: its own error stays far below that of the enclosure.
const GUARD: u32 = 64;

/// Bits that represent `digits` decimal digits and the guard.
fn working_precision(value: &Interval, digits: u32) -> Precision {
    Precision::new(value.precision().max(Precision::from_digits(digits).bits()).saturating_add(GUARD))
}

/// The largest exponent for which a power of ten is computed exactly.
const LARGEST_POWER: f64 = 20_000.0;

fn round_interval(value: &Interval, digits: u32) -> Option<Decimal> {
    if value.contains_zero() || !value.is_finite() {
        return (value.is_point() && value.contains_zero()).then(Decimal::default);
    }
    let binary = value.lower().get_exp()?;
    if f64::from(binary).abs() * std::f64::consts::LOG10_2 > LARGEST_POWER {
        return round_far(value, digits);
    }
    let end = |end: &Float| Some(round_rational(&end.to_rational()?, digits));
    let rounded = end(value.lower())?;
    (value.is_point() || end(value.upper())? == rounded).then_some(rounded)
}

/// The nearest integer to a quotient of integers, ties to even.
fn round_quotient(numerator: Integer, denominator: Integer) -> Integer {
    let (mut quotient, remainder) = numerator.div_rem(denominator.clone());
    let half = (remainder * 2u32).cmp(&denominator);
    if half.is_gt() || (half.is_eq() && quotient.is_odd()) {
        quotient += 1;
    }
    quotient
}

/// Rounds an interval of extreme magnitude, for which a power of ten is not computed exactly.
fn round_far(value: &Interval, digits: u32) -> Option<Decimal> {
    let magnitude = value.abs().rounded(working_precision(value, digits));
    // |value| < 2^e, so the decimal exponent is at most ⌊e · log₁₀2⌋, and at least one less: 2^(e−1) ≤ upper end.
    let binary = magnitude.upper().get_exp()?;
    let mut exponent = (f64::from(binary) * std::f64::consts::LOG10_2 + 1e-6).floor() as i64;
    let ten = magnitude.lit(10);
    // If this is certain, the scaled number needs no division, which could destroy a tie.
    if magnitude < ten.powi(exponent) {
        exponent -= 1;
    }
    let scale = i64::from(digits) - 1 - exponent;
    let power = ten.powi(scale.abs());
    let scaled = if scale < 0 { magnitude / power } else { magnitude * power };
    decide(value.upper().is_sign_negative(), &scaled, exponent.into(), digits)
}

fn round_exponential(negative: bool, ln_magnitude: &Interval, digits: u32) -> Option<Decimal> {
    let largest = ln_magnitude.lower().get_exp().max(ln_magnitude.upper().get_exp()).unwrap_or(0);
    let integer_bits = u32::try_from(largest).unwrap_or(0);
    if !ln_magnitude.is_finite() || integer_bits > ln_magnitude.precision() {
        return None;
    }
    let bits = working_precision(ln_magnitude, digits).bits().saturating_add(integer_bits);
    let ln_magnitude = ln_magnitude.rounded(Precision::new(bits));
    let ln_10 = ln_magnitude.lit(10).ln();
    let (exponent, _) = (ln_magnitude.clone() / &ln_10).upper().to_integer_round(Round::Down)?;
    let whole = Interval::point(Float::with_val(bits, &exponent));
    let scaled =
        (ln_magnitude - whole * ln_10).exp() * Interval::from_int(Precision::new(bits), 10).powi(digits.into());
    decide(negative, &scaled.over(10), exponent, digits)
}

/// The decimal of ±scaled · 10^(exponent + 1 − digits), where `exponent` is the decimal exponent of the upper end or one
/// more.
fn decide(negative: bool, scaled: &Interval, exponent: Integer, digits: u32) -> Option<Decimal> {
    let lower = nearest(scaled.lower(), exponent.clone(), digits)?;
    let upper = nearest(scaled.upper(), exponent, digits)?;
    (lower == upper).then(|| Decimal::new(negative, lower.0, lower.1, digits))
}

/// `scaled` · 10^(exponent + 1 − digits) rounded to a significand of `digits` digits and its decimal exponent. `None`
/// where the value is more than a decade below 10^exponent.
fn nearest(scaled: &Float, exponent: Integer, digits: u32) -> Option<(Integer, Integer)> {
    let unit = Integer::from(10).pow(digits - 1);
    let (scaled, exponent) = if *scaled >= unit {
        (scaled.clone(), exponent)
    } else {
        // Four more bits hold the tenfold exactly.
        (Float::with_val(scaled.prec() + 4, scaled * 10u32), exponent - 1u32)
    };
    if scaled < unit {
        return None;
    }
    let (significand, _) = scaled.to_integer_round(Round::Nearest)?;
    Some(carry(significand, exponent, unit))
}

/// 10^digits, reached by rounding up, is 10^(digits − 1) with the next exponent.
fn carry(significand: Integer, exponent: Integer, unit: Integer) -> (Integer, Integer) {
    if significand >= Integer::from(&unit * 10u32) { (unit, exponent + 1u32) } else { (significand, exponent) }
}

fn round_rational(value: &Rational, digits: u32) -> Decimal {
    if value.is_zero() {
        return Decimal::default();
    }
    let (numerator, denominator) = (value.numer().clone().abs(), value.denom());
    let unit = Integer::from(10).pow(digits - 1);
    // log₂ of the value lies between this and two less, so the exponent is right or one too high.
    let binary = i64::from(numerator.significant_bits()) - i64::from(denominator.significant_bits()) + 1;
    let mut exponent = (binary as f64 * std::f64::consts::LOG10_2 + 1e-6).floor() as i64;
    loop {
        let scale = i64::from(digits) - 1 - exponent;
        let power = Integer::from(10).pow(scale.unsigned_abs() as u32);
        let (dividend, divisor) = if scale < 0 {
            (numerator.clone(), Integer::from(denominator * &power))
        } else {
            (Integer::from(&numerator * &power), denominator.clone())
        };
        if dividend < Integer::from(&divisor * &unit) {
            exponent -= 1;
            continue;
        }
        let significand = round_quotient(dividend, divisor);
        let (significand, exponent) = carry(significand, exponent.into(), unit);
        return Decimal::new(*value < 0, significand, exponent, digits);
    }
}

#[cfg(test)]
#[path = "../../../tests/private/certify.rs"]
mod tests;
