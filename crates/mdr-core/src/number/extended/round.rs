//! Conversion from and to doubles.

use super::{Extended, power_of_two};

impl<const N: usize> Extended<N> {
    /// The exact value of a finite double; unknown for NaN and ∞.
    #[inline]
    pub(super) fn from_double(value: f64) -> Self {
        let bits = value.to_bits();
        let (biased, fraction) = ((bits >> 52 & 0x7ff) as i64, bits & ((1 << 52) - 1));
        if biased == 0x7ff {
            return Self::NOTHING;
        }
        let (significand, exponent) = if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
        Self::from_integer(value.is_sign_negative(), significand).scaled(exponent)
    }

    /// ± an integer.
    #[inline]
    pub(super) fn from_integer(negative: bool, magnitude: u64) -> Self {
        if magnitude == 0 {
            return Self::ZERO;
        }
        let zeros = magnitude.leading_zeros();
        let mut limbs = [0; N];
        limbs[N - 1] = magnitude << zeros;
        Extended { negative, limbs, exponent: 64 - i64::from(zeros), error: 0.0 }
    }

    /// The double nearest to the true value or next to the nearest one: within one unit in the last place, half of it
    /// from this rounding, gradual underflow included. `None` when the error bound does not guarantee that.
    ///
    /// ±∞ stands for a magnitude beyond the largest double, and ±0 for one at or below half the smallest;
    /// [`log10`](Extended::log10) gives its order of magnitude. An exact zero is 0.
    #[inline]
    pub fn nearest_f64(&self) -> Option<f64> {
        if self.is_around_zero() {
            return None;
        }
        let kept = (self.exponent + 1074).clamp(0, 53);
        // error · 2^(e − 64N) ≤ ulp/2 = 2^(e − kept − 1); the bound itself has been rounded some hundred times.
        let slack = 1.0 + f64::EPSILON * 1024.0;
        (self.error * slack <= power_of_two(Self::BITS - kept - 1)).then(|| self.to_double())
    }

    /// The stored value rounded to the nearest double.
    #[inline]
    pub(super) fn to_double(self) -> f64 {
        if N == 1 && (-958..=1024).contains(&self.exponent) {
            // The conversion of the word rounds to nearest even; the scaling is exact.
            let scale = f64::from_bits(((self.exponent + (1023 - 64)) as u64) << 52);
            let magnitude = self.limbs[0] as f64 * scale;
            return if self.negative { -magnitude } else { magnitude };
        }
        if self.is_nothing() {
            return f64::NAN;
        }
        let kept = (self.exponent + 1074).min(53);
        if kept < 0 || self.is_hollow() {
            return if self.negative { -0.0 } else { 0.0 };
        }
        let top = u128::from(self.limbs[N - 1]);
        let below = 64 - kept;
        let (mut rounded, rest, half) = ((top >> below) as u64, top & ((1 << below) - 1), 1 << (below - 1));
        let sticky = self.limbs[..N - 1].iter().any(|&word| word != 0);
        if rest > half || rest == half && (sticky || rounded & 1 == 1) {
            rounded += 1;
        }
        let magnitude = if self.exponent > 1024 {
            f64::INFINITY
        } else if self.exponent >= -1021 {
            // The carry of a rounded significand increments the exponent, up to ∞.
            f64::from_bits((((self.exponent + 1022) as u64) << 52) + rounded - (1 << 52))
        } else {
            f64::from_bits(rounded)
        };
        if self.negative { -magnitude } else { magnitude }
    }

    /// log₁₀ of the magnitude of the stored value, rounded once; within an ulp where log₁₀ is above 1.
    #[cold]
    pub fn log10(&self) -> f64 {
        let magnitude = Extended { negative: false, ..*self };
        magnitude.logarithm().quotient(&Self::from_double(10.0).logarithm()).to_double()
    }
}
