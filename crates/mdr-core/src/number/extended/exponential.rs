//! e^x and 2^x.

use super::tables::{EXP2, EXP2_TAYLOR, INVERSE_FACTORIAL, LN_2};
use super::{EXPONENT_LIMIT, Extended, limbs, power_of_two};

impl<const N: usize> Extended<N> {
    /// e^self.
    pub(super) fn exponential(&self) -> Self {
        if self.exponent > 62 || self.is_around_zero() && self.exponent > -2 {
            return Self::NOTHING;
        }
        if self.is_hollow() {
            return Self::from_double(1.0) + self.exponential_minus_one();
        }
        if N == 1 {
            return self.quotient(&Self::constant(LN_2)).power_of_two();
        }
        // self = k ln2 + r with 0 ≤ r < 1; all errors together are an absolute error of |self|·(error + 6) units.
        let ln_2 = Self::constant(LN_2).exactly();
        let mut k = self.quotient(&ln_2).whole() - i64::from(self.negative);
        let mut r = (self.exactly() - ln_2.times_int(k).exactly()).exactly();
        if r.negative {
            k -= 1;
            r = (r + ln_2).exactly();
        }
        let argument = (self.error + 6.0) * power_of_two(self.exponent);
        r.exponential_of_fraction().widened(argument).scaled(k)
    }

    /// e^self for 0 ≤ self < 1: Taylor's series of self/2^s in fixed point, and s squarings.
    fn exponential_of_fraction(&self) -> Self {
        let squarings = if N == 2 { 6 } else { 8 };
        let Ok(shift) = u64::try_from(squarings - self.exponent) else { return Self::NOTHING };
        let (x, ..) = limbs::shift_down(&self.limbs, shift);
        // x ≤ 2^-s. The first omitted term, x^16/16! < 2^-140 or x^25/25! < 2^-283, is less than a unit; each product
        // is truncated by less than one unit, and all but the last are multiplied by x.
        let terms = if N == 2 { 14 } else { 23 };
        let mut sum = [0; N];
        for factorial in INVERSE_FACTORIAL[..terms].iter().rev() {
            let mut term = [0; N];
            term.copy_from_slice(&factorial[4 - N..]);
            (sum, _) = limbs::add(&limbs::mul(&sum, &x).0, &term);
        }
        // x + x²/2! + … = x + x·(x·sum).
        let (sum, _) = limbs::add(&x, &limbs::mul(&limbs::mul(&sum, &x).0, &x).0);
        let one = Self::from_double(1.0);
        let mut power = match limbs::normalise(sum, 0) {
            Some((limbs, _, shift)) => one + Self::from_parts(false, limbs, -shift, 0.0),
            None => one,
        };
        power = power.widened(4.0);
        for _ in 0..squarings {
            power = power.product(&power);
        }
        power
    }

    /// e^self − 1 without cancellation.
    pub(super) fn exponential_minus_one(&self) -> Self {
        let one = Self::from_double(1.0);
        if self.is_hollow() && self.exponent <= 0 {
            // |e^x − 1| ≤ 2|x| for |x| ≤ 1.
            return self.scaled(1);
        }
        if self.exponent > -4 {
            return self.exponential() - one;
        }
        // |self| < 1/16: each term gains at least 4 bits, so 64N/4 terms are enough.
        let mut sum = one;
        for k in (2..=16 * N as i64).rev() {
            sum = one + sum.product(self).over_int(k);
        }
        self.product(&sum).widened(1.0)
    }

    /// The integer part of a number below 2⁶², towards zero.
    fn whole(&self) -> i64 {
        if self.exponent <= 0 || self.is_hollow() {
            return 0;
        }
        let magnitude = (self.limbs[N - 1] >> (64 - self.exponent.min(63))) as i64;
        if self.negative { -magnitude } else { magnitude }
    }

    /// 2^self in one word.
    #[inline]
    fn power_of_two(&self) -> Self {
        if self.is_hollow() || self.exponent > 40 {
            return Self::NOTHING;
        }
        let magnitude = u128::from(self.limbs[N - 1]);
        let (fixed, dropped) = match self.exponent {
            0.. => (magnitude << self.exponent, false),
            -63..0 => (magnitude >> -self.exponent, (magnitude << (64 + self.exponent)) as u64 != 0),
            _ => (0, self.limbs[N - 1] != 0),
        };
        let fixed = if self.negative { -(fixed as i128) } else { fixed as i128 };
        Self::power_of_two_fixed(fixed, self.error * power_of_two(self.exponent) + if dropped { 1.0 } else { 0.0 })
    }

    /// 2^(fixed·2⁻⁶⁴), with `error` units of uncertainty in `fixed`, in one word.
    #[inline]
    pub(super) fn power_of_two_fixed(fixed: i128, error: f64) -> Self {
        let high = |a: u64, b: u64| ((u128::from(a) * u128::from(b)) >> 64) as u64;
        let (whole, fraction) = ((fixed >> 64) as i64, fixed as u64);
        if error > Self::ERROR_LIMIT || whole.unsigned_abs() >= EXPONENT_LIMIT as u64 {
            return Self::NOTHING;
        }
        let rest = fraction << 8;
        let slope = EXP2_TAYLOR.iter().rev().fold(0, |sum, &c| c + high(sum, rest));
        let power = EXP2[(fraction >> 56) as usize];
        let mut limbs = [0; N];
        limbs[N - 1] = power + (high(power, high(slope, rest)) >> 8);
        // The table is accurate to half a unit in the last place and the correction is truncated twice: 4 units. An
        // error δ of the argument is one of ln2·δ < 3δ/4 of the result.
        let inexact = if fraction == 0 && error == 0.0 { 0.0 } else { 0.75 * error + 5.0 };
        Self::from_parts(false, limbs, whole + 1, inexact)
    }
}
