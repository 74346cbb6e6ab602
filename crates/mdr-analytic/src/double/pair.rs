//! Unevaluated sums of two doubles, in arithmetic with and without a fused multiply-add.
//!
//! The error-free transformations are those of Knuth, Dekker and Veltkamp (T. J. Dekker, Numer. Math. 18 (1971) 224);
//! they are valid while nothing overflows and no product is subnormal.

use mdr_core::number::Extended;

/// How products round. With FMA the error of a product is one instruction; without it, Dekker's splitting gives the
/// same exact value, since `f64::mul_add` would be a slow library call.
pub(super) trait Arithmetic: Copy {
    /// ab + c, rounded once or twice.
    fn multiply_add(a: f64, b: f64, c: f64) -> f64;

    /// ab exactly, unless it leaves the range.
    fn product(a: f64, b: f64) -> Pair;

    /// c − ab within one rounding of the result where c and ab nearly cancel.
    fn residual(c: f64, a: f64, b: f64) -> f64;
}

/// One rounding for ab + c.
#[derive(Clone, Copy)]
#[cfg_attr(target_arch = "wasm32", allow(dead_code, reason = "this target has no such instruction"))]
pub(super) struct Fused;

/// Two roundings for ab + c.
#[derive(Clone, Copy)]
pub(super) struct Separate;

/// The arithmetic of the baseline: fused where the target has it.
#[cfg(any(target_feature = "fma", target_arch = "aarch64"))]
pub(super) use self::Fused as Native;
#[cfg(not(any(target_feature = "fma", target_arch = "aarch64")))]
pub(super) use self::Separate as Native;

impl Arithmetic for Fused {
    #[inline(always)]
    fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }

    #[inline(always)]
    fn product(a: f64, b: f64) -> Pair {
        let hi = a * b;
        Pair { hi, lo: a.mul_add(b, -hi) }
    }

    #[inline(always)]
    fn residual(c: f64, a: f64, b: f64) -> f64 {
        (-a).mul_add(b, c)
    }
}

impl Arithmetic for Separate {
    #[inline(always)]
    fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }

    #[inline(always)]
    fn product(a: f64, b: f64) -> Pair {
        let hi = a * b;
        let ((a, a_rest), (b, b_rest)) = (halves(a), halves(b));
        Pair { hi, lo: a_rest * b_rest - (((hi - a * b) - a_rest * b) - a * b_rest) }
    }

    #[inline(always)]
    fn residual(c: f64, a: f64, b: f64) -> f64 {
        let product = Self::product(a, b);
        (c - product.hi) - product.lo
    }
}

/// Veltkamp's splitting into two parts of 26 bits.
#[inline(always)]
fn halves(a: f64) -> (f64, f64) {
    let shifted = 134_217_729.0 * a; // 2²⁷ + 1
    let high = shifted - (shifted - a);
    (high, a - high)
}

/// hi + lo with |lo| of the order of 2⁻⁵³|hi|. Products and quotients are accurate to a few units of 2⁻¹⁰⁵, sums to
/// that of their terms.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair {
    pub(super) hi: f64,
    pub(super) lo: f64,
}

impl Pair {
    /// The magnitude of a number within 2^±limit that is known to 2⁻⁴⁴, truncated at 2⁻¹⁰⁵.
    pub(super) fn of_magnitude<const N: usize>(value: &Extended<N>, limit: u64) -> Option<Pair> {
        let known = value.error() < 2f64.powi(64 * N as i32 - 44);
        if !known || value.is_zero() || value.exponent().unsigned_abs() >= limit {
            return None;
        }
        let limb = |i: usize| if i < N { u128::from(value.limbs()[N - 1 - i]) } else { 0 };
        let leading = limb(0) << 64 | limb(1);
        let unit = |exponent: i64| f64::from_bits(((value.exponent() + exponent + 1023) as u64) << 52);
        let part = |shift: u32| ((leading >> shift) as u64 & ((1 << 53) - 1)) as f64;
        Some(Pair { hi: part(75) * unit(-53), lo: part(22) * unit(-106) })
    }

    /// a + b, exactly.
    #[inline(always)]
    pub(super) fn sum(a: f64, b: f64) -> Pair {
        let hi = a + b;
        let part = hi - a;
        Pair { hi, lo: (a - (hi - part)) + (b - part) }
    }

    /// a + b exactly if |a| ≥ |b|, or if a is a multiple of the last place of b and of the sum.
    #[inline(always)]
    pub(super) fn quick_sum(a: f64, b: f64) -> Pair {
        let hi = a + b;
        Pair { hi, lo: b - (hi - a) }
    }

    #[inline(always)]
    pub(super) fn plus(self, other: Pair) -> Pair {
        let Pair { hi, lo } = Self::sum(self.hi, other.hi);
        Pair { hi, lo: lo + (self.lo + other.lo) }
    }

    #[inline(always)]
    pub(super) fn minus(self, other: Pair) -> Pair {
        self.plus(Pair { hi: -other.hi, lo: -other.lo })
    }

    #[inline(always)]
    pub(super) fn scaled<A: Arithmetic>(self, _: A, factor: f64) -> Pair {
        let product = A::product(self.hi, factor);
        Pair { hi: product.hi, lo: A::multiply_add(self.lo, factor, product.lo) }
    }

    #[inline(always)]
    pub(super) fn times<A: Arithmetic>(self, _: A, other: Pair) -> Pair {
        let Pair { hi, lo } = A::product(self.hi, other.hi);
        Pair { hi, lo: A::multiply_add(self.lo, other.hi, A::multiply_add(self.hi, other.lo, lo)) }
    }

    #[inline(always)]
    pub(super) fn square<A: Arithmetic>(self, _: A) -> Pair {
        let Pair { hi, lo } = A::product(self.hi, self.hi);
        Pair { hi, lo: A::multiply_add(self.hi + self.hi, self.lo, lo) }
    }

    /// The quotient by `divisor`, given its reciprocal to a few units in the last place.
    #[inline(always)]
    pub(super) fn over<A: Arithmetic>(self, _: A, divisor: Pair, reciprocal: f64) -> Pair {
        let hi = self.hi * reciprocal;
        let residual = A::residual(self.hi, hi, divisor.hi) + A::residual(self.lo, hi, divisor.lo);
        Pair { hi, lo: residual * reciprocal }
    }

    /// The nearest double, up to 2⁻⁵⁰ of an ulp.
    #[inline(always)]
    pub(super) fn rounded(self) -> f64 {
        self.hi + self.lo
    }
}

impl From<f64> for Pair {
    #[inline(always)]
    fn from(hi: f64) -> Self {
        Pair { hi, lo: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both are exact and agree to the last bit.
    #[test]
    fn the_splitting_gives_the_error_of_a_product() {
        let mut a = 1.0f64;
        for k in 0..2000 {
            a = (a * 1.618_033_988_749_895 + 0.1) % 3.0;
            let b = a.sqrt() * 2f64.powi(k % 400 - 200);
            let (fused, split) = (Fused::product(a, b), Separate::product(a, b));
            assert_eq!((fused.hi, fused.lo), (split.hi, split.lo), "{a:e} · {b:e}");
            assert_eq!(Fused::residual(fused.hi, a, b), Separate::residual(fused.hi, a, b));
        }
    }
}
