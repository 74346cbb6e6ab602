//! Square roots: exact where the root is representable.

use super::{Extended, TWO_64, limbs};

impl<const N: usize> Extended<N> {
    /// √self; unknown for a negative number.
    #[inline]
    pub(super) fn root(&self) -> Self {
        if self.is_hollow() || self.negative {
            return if self.is_zero() { *self } else { Self::NOTHING };
        }
        let odd = self.exponent & 1;
        let (root, exact) = self.root_of_top(odd);
        let exponent = (self.exponent + odd) / 2;
        let error = Self::second_order(0.5 * self.error);
        let mut limbs = [0; N];
        limbs[N - 1] = root;
        if N == 1 {
            return Self::from_parts(false, limbs, exponent, error + if exact { 0.0 } else { 3.0 });
        }
        Self::from_parts(false, limbs, 0, 0.0).root_by_newton(&Extended { exponent: -odd, ..*self }).scaled(exponent)
    }

    /// The root of the upper word over 2^odd to a unit in the last place, and whether it is exact: from a double and
    /// one Newton step in integers.
    #[inline]
    fn root_of_top(&self, odd: i64) -> (u64, bool) {
        let top = self.limbs[N - 1];
        let square = (u128::from(top) << 64) >> odd;
        let scale = if odd == 0 { TWO_64 } else { TWO_64 / 2.0 };
        let mut root = (top as f64 * scale).sqrt().min(TWO_64_BELOW) as u64;
        // The residual is below 2^77 and the step below 2^12: the bits dropped by the shift change it by 2^-52.
        let residual = square.wrapping_sub(u128::from(root) * u128::from(root)) as i128;
        let step = (residual >> 14) as i64 as f64 * (1 << 13) as f64 / root as f64;
        root = root.saturating_add_signed(step as i64);
        (root, u128::from(root) * u128::from(root) == square)
    }

    /// From one word to N: each step s + (x − s²)/2s doubles the number of correct bits.
    fn root_by_newton(self, square: &Self) -> Self {
        let exact_square = square.exactly();
        let mut root = self;
        for _ in 0..N.next_power_of_two().ilog2() {
            let defect = (exact_square - root.product(&root).exactly()).exactly();
            root = (root + defect.quotient(&root).scaled(-1)).exactly();
        }
        // If the root has 32 trailing zero bits it may be exact.
        let short = root.rounded_to(Self::BITS - 32);
        if square.is_exact() && short.product(&short) == exact_square {
            return short;
        }
        // A relative error of 2^-63 is squared and halved in each step: 2^-127, 2^-255; then the roundings.
        root.widened(0.5 * square.error + 8.0)
    }

    /// The nearest exact number of `bits` bits.
    fn rounded_to(&self, bits: i64) -> Self {
        let (mut limbs, mut below) = (self.limbs, Self::BITS - bits - 1);
        let mut half = [0; N];
        half[(below / 64) as usize] = 1 << (below % 64);
        let (sum, carry) = limbs::add(&limbs, &half);
        if carry {
            return Extended { limbs: Self::from_double(1.0).limbs, exponent: self.exponent + 1, ..*self }.exactly();
        }
        limbs = sum;
        below += 1;
        for limb in &mut limbs {
            let cleared = below.clamp(0, 64) as u32;
            *limb = if cleared == 64 { 0 } else { *limb >> cleared << cleared };
            below -= 64;
        }
        Extended { limbs, ..*self }.exactly()
    }
}

/// The largest double below 2⁶⁴.
const TWO_64_BELOW: f64 = (u64::MAX - 0x7ff) as f64;
