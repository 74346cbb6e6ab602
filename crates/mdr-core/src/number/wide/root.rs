//! Square roots: exact where the root is representable.

use super::{Wide, limbs};

impl<const N: usize> Wide<N> {
    /// √self; nothing is known for a negative number.
    #[inline]
    pub(super) fn root(&self) -> Self {
        if self.is_hollow() || self.negative {
            return if self.is_zero() { *self } else { Self::NOTHING };
        }
        if N == 1 { self.root_of_word() } else { self.root_by_newton() }
    }

    /// One word: a double, one Newton step in integers, and the floor is exact.
    #[inline]
    fn root_of_word(&self) -> Self {
        let odd = self.exponent & 1;
        let square = (u128::from(self.limbs[N - 1]) << 64) >> odd;
        let mut root = (square as f64).sqrt().min(TWO_64_BELOW) as u64;
        let residual = square.wrapping_sub(u128::from(root) * u128::from(root)) as i128;
        root = root.saturating_add_signed((residual as f64 / (2.0 * root as f64)) as i64);
        let mut rest = square.wrapping_sub(u128::from(root) * u128::from(root)) as i128;
        while rest < 0 {
            root -= 1;
            rest += 2 * i128::from(root) + 1;
        }
        while rest > 2 * i128::from(root) {
            rest -= 2 * i128::from(root) + 1;
            root += 1;
        }
        let mut limbs = [0; N];
        limbs[N - 1] = root;
        let error = self.error.div_ceil(2) + u64::from(self.error != 0) + 2 * u64::from(rest != 0);
        Self::from_parts(false, limbs, (self.exponent + odd) / 2, error)
    }

    /// More words: Newton's iteration for 1/√x from a double, and a last step for √x itself.
    fn root_by_newton(&self) -> Self {
        let odd = self.exponent & 1;
        let square = Wide { exponent: -odd, error: 0, ..*self };
        let mut reciprocal = Self::from_double(1.0 / square.to_double().sqrt());
        for _ in 0..N.ilog2() + 1 {
            let defect = Self::from_double(1.0) - square.product(&reciprocal).product(&reciprocal).exactly();
            reciprocal = (reciprocal + reciprocal.product(&defect.exactly()).scaled(-1)).exactly();
        }
        let root = square.product(&reciprocal).exactly();
        let defect = (square - root.product(&root).exactly()).exactly();
        let root = (root + defect.product(&reciprocal).scaled(-1)).exactly();
        let exponent = (self.exponent + odd) / 2;
        // A root that ends 32 bits early may be the exact one.
        let short = root.rounded_to(Self::BITS - 32);
        if self.is_exact() && short.product(&short) == square {
            return short.scaled(exponent);
        }
        // The iteration has converged when the square of the root is the number, but for rounding.
        let residual = square - root.product(&root).exactly();
        if !residual.is_hollow() && residual.exponent > 4 - Self::BITS {
            return Self::NOTHING;
        }
        root.widened(self.error.div_ceil(2) + 24).scaled(exponent)
    }

    /// The nearest exact number of `bits` bits.
    fn rounded_to(&self, bits: i64) -> Self {
        let (mut limbs, mut below) = (self.limbs, Self::BITS - bits - 1);
        let mut half = [0; N];
        half[(below / 64) as usize] = 1 << (below % 64);
        let (sum, carry) = limbs::add(&limbs, &half);
        if carry {
            return Wide { limbs: Self::from_double(1.0).limbs, exponent: self.exponent + 1, ..*self }.exactly();
        }
        limbs = sum;
        below += 1;
        for limb in &mut limbs {
            let cleared = below.clamp(0, 64) as u32;
            *limb = if cleared == 64 { 0 } else { *limb >> cleared << cleared };
            below -= 64;
        }
        Wide { limbs, ..*self }.exactly()
    }
}

/// The largest double below 2⁶⁴.
const TWO_64_BELOW: f64 = (u64::MAX - 0x7ff) as f64;
