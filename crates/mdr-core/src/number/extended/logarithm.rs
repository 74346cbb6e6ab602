//! ln x, and powers.

use super::tables::{LN_2, LOG2_RECIPROCAL, LOG2_SERIES, RECIPROCAL};
use super::{Extended, limbs, power_of_two, truncation};

impl<const N: usize> Extended<N> {
    /// ln self; unknown unless self > 0.
    pub(super) fn logarithm(&self) -> Self {
        if self.is_hollow() || self.negative {
            return Self::NOTHING;
        }
        let less_one = *self - Self::from_double(1.0);
        if less_one.is_zero() || less_one.exponent < -7 {
            return less_one.logarithm_of_one_plus();
        }
        if N == 1 {
            let (fixed, error) = self.log2_fixed();
            return Self::from_fixed(fixed, error).product(&Self::constant(LN_2));
        }
        // self = m·2^k with m in [1/√2, √2) and y ≈ ln m a double: ln m = y + 2 artanh((m − e^y)/(m + e^y)).
        let mut k = self.exponent;
        let mut m = Extended { exponent: 0, error: 0.0, ..*self };
        if m.to_double() < std::f64::consts::FRAC_1_SQRT_2 {
            m.exponent = 1;
            k -= 1;
        }
        let y = Self::from_double(pxfm::f_log(m.to_double()));
        let power = y.exponential();
        let absolute = power.error + Self::second_order(self.error) + 16.0;
        let power = power.exactly();
        let z = (m - power).exactly().quotient(&(m + power).exactly()).exactly();
        let ln_m = y + z.artanh_series(3).scaled(1).exactly();
        (Self::constant(LN_2).times_int(k) + ln_m.exactly()).blurred(absolute.log2() as i64 + 1 - Self::BITS)
    }

    /// ln(1 + self) without cancellation.
    pub(super) fn logarithm_of_one_plus(&self) -> Self {
        let one = Self::from_double(1.0);
        if self.exponent > -7 && !self.is_zero() {
            return (one + self).logarithm();
        }
        if self.is_hollow() {
            // |ln(1 + x)| ≤ 2|x| for |x| ≤ 1/2.
            return self.scaled(1);
        }
        // |z| < 2^-8: each term gains 16 bits.
        let z = self.quotient(&(*self + one.scaled(1)));
        z.artanh_series(4 * N as i64 + 1).scaled(1)
    }

    /// Σ z^(2k+1)/(2k+1), k < terms.
    fn artanh_series(&self, terms: i64) -> Self {
        let square = self.product(self);
        let mut sum = Self::ZERO;
        for k in (0..terms).rev() {
            sum = sum.product(&square) + Self::from_double(1.0).over_int(2 * k + 1);
        }
        self.product(&sum).widened(1.0)
    }

    /// log₂ self in Q64 and a bound of its error in units of 2⁻⁶⁴, in one word.
    #[inline]
    fn log2_fixed(&self) -> (i128, f64) {
        let m = self.limbs[N - 1];
        // log₂(m(1 + δ)) changes by less than 1.443 δ.
        let error = 1.443 * Self::second_order(self.error);
        if m == 1 << 63 {
            return (i128::from(self.exponent - 1) << 64, error);
        }
        let i = (m >> 56) as usize & 127;
        // z = mc − 1 in Q70 from Q64 · Q10; |z| < 2^-7.
        let z = ((i128::from(m) * i128::from(RECIPROCAL[i]) - (1 << 74)) >> 4) as i64;
        let slope = LOG2_SERIES.iter().rev().fold(0, |sum, &c| c + ((i128::from(sum) * i128::from(z)) >> 64) as i64);
        let series = (i128::from(slope) * i128::from(z)) >> 68;
        ((i128::from(self.exponent) << 64) - i128::from(LOG2_RECIPROCAL[i]) + series, error + 2.0)
    }

    /// fixed·2⁻⁶⁴ with `error` units of uncertainty, in one word.
    fn from_fixed(fixed: i128, error: f64) -> Self {
        let magnitude = fixed.unsigned_abs();
        if magnitude == 0 {
            return if error == 0.0 { Self::ZERO } else { Self::around_zero(error.log2() as i64 + 1 - 64) };
        }
        let zeros = magnitude.leading_zeros();
        let normal = magnitude << zeros;
        let mut limbs = [0; N];
        limbs[N - 1] = (normal >> 64) as u64;
        let exponent = 64 - i64::from(zeros);
        let truncated = truncation(normal as u64 != 0);
        Self::from_parts(fixed < 0, limbs, exponent, error * power_of_two(1 - exponent) + truncated)
    }

    /// self^exponent for self > 0; exact if base, exponent and result are exact.
    pub(super) fn power(&self, exponent: &Self) -> Self {
        let one = Self::from_double(1.0);
        if exponent.is_zero() || self.is_exact() && *self == one {
            return one;
        }
        if self.is_zero() && !exponent.is_around_zero() && !exponent.negative {
            return *self;
        }
        if let Some(power) = self.power_by_roots(exponent) {
            return power;
        }
        if self.is_hollow() || self.negative {
            return Self::NOTHING;
        }
        if exponent.is_hollow() {
            return self.logarithm().product(exponent).exponential();
        }
        if N == 1 { self.power_of_word(exponent) } else { self.logarithm().product(exponent).exponential() }
    }

    /// An integer exponent, or k/2^j with j ≤ 8 and an exact result.
    #[inline]
    fn power_by_roots(&self, exponent: &Self) -> Option<Self> {
        const SMALL: i64 = 6;
        let lowest_bit = exponent.exponent - Self::BITS + limbs::trailing_zeros(&exponent.limbs);
        if !exponent.is_exact() || exponent.exponent > SMALL || lowest_bit < -8 {
            return None;
        }
        let whole = (exponent.limbs[N - 1] >> (64 - (exponent.exponent - lowest_bit))) as i64;
        let whole = if exponent.negative { -whole } else { whole };
        if lowest_bit >= 0 {
            return Some(self.whole_power(whole << lowest_bit));
        }
        let mut root = *self;
        for _ in lowest_bit..0 {
            if !root.is_exact() {
                return None;
            }
            root = root.root();
        }
        let power = root.whole_power(whole);
        power.is_exact().then_some(power)
    }

    /// self^k by repeated squaring.
    pub(super) fn whole_power(&self, k: i64) -> Self {
        let mut power = Self::from_double(1.0);
        let mut square = *self;
        let mut bits = k.unsigned_abs();
        while bits != 0 {
            if bits & 1 == 1 {
                power = power.product(&square);
            }
            bits >>= 1;
            if bits != 0 {
                square = square.product(&square);
            }
        }
        if k < 0 { Self::from_double(1.0).quotient(&power) } else { power }
    }

    /// 2^(y log₂ self) in fixed point, so that a large logarithm loses no bits.
    #[inline]
    fn power_of_word(&self, y: &Self) -> Self {
        let (log2, uncertainty) = self.log2_fixed();
        let (magnitude, factor) = (log2.unsigned_abs(), y.limbs[N - 1]);
        // The product is below 2^(bits of log2 + y.exponent) in units of 2^-64; the exponent of the result must stay
        // far from the limit, and the scale of y within a word.
        if y.exponent.abs() > 60 || 128 - i64::from(magnitude.leading_zeros()) + y.exponent > 64 + 40 {
            return Self::NOTHING;
        }
        // magnitude·factor·2^(y.exponent − 64), in two halves.
        let high = (magnitude >> 64) * u128::from(factor);
        let low = (magnitude as u64 as u128) * u128::from(factor);
        let fixed = if y.exponent >= 0 {
            (high << y.exponent) + (low >> (64 - y.exponent))
        } else {
            (high + (low >> 64)) >> -y.exponent
        };
        let negative = (log2 < 0) != y.negative;
        let fixed = if negative { -(fixed as i128) } else { fixed as i128 };
        // |log₂ of the result| · error of y + |y| · error of log₂, and the truncation above.
        let from_y = y.error * ((fixed.unsigned_abs() >> 64) as u64 + 1) as f64;
        let error = from_y + uncertainty * (factor as f64 * power_of_two(-64)) * power_of_two(y.exponent) + 2.0;
        Self::power_of_two_fixed(fixed, error)
    }
}
