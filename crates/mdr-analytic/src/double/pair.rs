//! Unevaluated sums of two doubles, with the operations that [`ready`](super::ready) needs.
//!
//! The error-free transformations are those of Knuth and of Dekker (Numer. Math. 18 (1971) 224); they hold while nothing
//! overflows and no product is subnormal. A sum or product of pairs is right to 2⁻¹⁰⁰ of its terms.

use mdr_core::number::Wide;

#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) high: f64,
    pub(super) low: f64,
}

impl Pair {
    /// a + b, exactly.
    #[inline(always)]
    pub(super) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Pair { high, low: (a - (high - part)) + (b - part) }
    }

    /// ab, exactly.
    #[inline(always)]
    pub(super) fn product(a: f64, b: f64) -> Self {
        let split = |x: f64| {
            let shifted = x * ((1_u64 << 27) + 1) as f64;
            let high = shifted - (shifted - x);
            (high, x - high)
        };
        let (high, (ah, al), (bh, bl)) = (a * b, split(a), split(b));
        Pair { high, low: ((ah * bh - high) + ah * bl + al * bh) + al * bl }
    }

    #[inline(always)]
    pub(super) fn times(self, other: Pair) -> Self {
        let Pair { high, low } = Self::product(self.high, other.high);
        Pair { high, low: low + (self.high * other.low + self.low * other.high) }
    }

    #[inline(always)]
    pub(super) fn plus(self, other: Pair) -> Self {
        let Pair { high, low } = Self::sum(self.high, other.high);
        Pair { high, low: low + (self.low + other.low) }
    }

    #[inline(always)]
    pub(super) fn minus(self, other: Pair) -> Self {
        self.plus(Pair { high: -other.high, low: -other.low })
    }

    #[inline(always)]
    pub(super) fn over(self, other: Pair) -> Self {
        let quotient = self.high / other.high;
        let rest = self.minus(Self::product(quotient, other.high));
        Pair { high: quotient, low: (rest.high + rest.low - quotient * other.low) / other.high }
    }

    /// self · (1 + small).
    #[inline(always)]
    pub(super) fn moved(self, small: f64) -> Self {
        Pair { high: self.high, low: self.low + self.high * small }
    }

    /// The nearest double, but for 2⁻⁵⁰ of an ulp.
    #[inline(always)]
    pub(super) fn rounded(self) -> f64 {
        self.high + self.low
    }
}

impl From<f64> for Pair {
    #[inline(always)]
    fn from(high: f64) -> Self {
        Pair { high, low: 0.0 }
    }
}

/// A positive word, exactly. Its exponent must be that of a normal double with 64 bits to spare.
impl From<&Wide<1>> for Pair {
    #[inline(always)]
    fn from(value: &Wide<1>) -> Self {
        let limb = value.limbs()[0];
        let unit = f64::from_bits(((value.exponent() + (1023 - 64)) as u64) << 52);
        Pair { high: (limb & !0x7ff) as f64 * unit, low: (limb & 0x7ff) as f64 * unit }
    }
}

/// Whether a word is a number within 2^±limit.
#[inline(always)]
pub(super) fn is_ordinary(value: &Wide<1>, limit: u64) -> bool {
    value.error() < 1e6 && value.exponent().unsigned_abs() < limit
}
