//! Hexadecimal numbers in the `%a` format of C: doubles are written in it, and numbers of any precision are read
//! exactly.

use crate::decimal::{DecimalError, whole};

/// The largest binary exponent, of the first bit and of the last: quadruple precision has up to 16494, and the cost of
/// all decimal digits grows as its square.
const LARGEST: i64 = 17_000;

/// ±0x1.hhhp±d without trailing zeros.
pub(crate) fn write(value: f64) -> String {
    let bits = value.to_bits();
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let (fraction, biased) = (bits & ((1 << 52) - 1), (bits >> 52) & 0x7ff);
    if value == 0.0 {
        return format!("{sign}0x0p+0");
    }
    let (first, exponent) = if biased == 0 { (0, -1022) } else { (1, biased as i64 - 1023) };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{first}{point}{digits}p{exponent:+}")
}

/// The number h.hhhp±d, without its sign and 0x: decimal digits, the first ones first, and the decimal exponent of the
/// last.
pub(crate) fn read(text: &str) -> Result<(Vec<u8>, i64), DecimalError> {
    let (mantissa, exponent) = text.split_once(['p', 'P']).unwrap_or((text, "0"));
    let (integer, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = integer.chars().chain(fraction.chars()).map(|letter| letter.to_digit(16)).collect::<Option<Vec<_>>>();
    let digits = digits.filter(|digits| !digits.is_empty()).ok_or(DecimalError::NotANumber)?;
    let exponent = whole(exponent).map_err(|error| match error {
        DecimalError::TooLarge => DecimalError::BinaryTooLarge,
        error => error,
    })?;
    let Some(first) = digits.iter().position(|digit| *digit != 0) else { return Ok((Vec::new(), 0)) };
    let last = digits.iter().rposition(|digit| *digit != 0).unwrap_or(first);
    let exponent = exponent + 4 * (integer.len() as i64 - 1 - last as i64);
    let top = exponent + 4 * (last - first) as i64 + i64::from(digits[first].ilog2());
    if exponent.abs().max(top.abs()) > LARGEST {
        return Err(DecimalError::BinaryTooLarge);
    }
    Ok(decimal_digits(&digits[first..=last], exponent))
}

/// h·2^exponent with the hexadecimal digits of h: 2⁻ᵏ is 5ᵏ·10⁻ᵏ.
fn decimal_digits(hexadecimal: &[u32], exponent: i64) -> (Vec<u8>, i64) {
    let mut limbs = vec![0];
    for digits in hexadecimal.chunks(7) {
        let chunk = digits.iter().fold(0, |sum, digit| 16 * sum + u64::from(*digit));
        multiply_add(&mut limbs, 1 << (4 * digits.len()), chunk);
    }
    let (base, at_once): (u64, u32) = if exponent < 0 { (5, 13) } else { (2, 30) };
    let mut left = exponent.unsigned_abs();
    while left > 0 {
        let now = left.min(u64::from(at_once));
        multiply_add(&mut limbs, base.pow(now as u32), 0);
        left -= now;
    }
    let text: String = limbs.iter().rev().map(|limb| format!("{limb:09}")).collect();
    (text.bytes().map(|byte| byte - b'0').collect(), exponent.min(0))
}

/// limbs·factor + addend, in place; limbs of nine decimal digits, the last ones first; factor up to 2³¹.
fn multiply_add(limbs: &mut Vec<u64>, factor: u64, addend: u64) {
    const BASE: u64 = 1_000_000_000;
    let mut carry = addend;
    for limb in limbs.iter_mut() {
        let value = *limb * factor + carry;
        *limb = value % BASE;
        carry = value / BASE;
    }
    while carry > 0 {
        limbs.push(carry % BASE);
        carry /= BASE;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::decimal::Decimal;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn doubles_come_back(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            prop_assert_eq!(write(value).parse().ok(), Decimal::from_double(value));
        }
    }

    #[test]
    fn as_c_writes_it() {
        for (value, text) in [(1.0, "0x1p+0"), (-0.1, "-0x1.999999999999ap-4"), (5e-324, "0x0.0000000000001p-1022")] {
            assert_eq!(write(value), text);
        }
    }
}
