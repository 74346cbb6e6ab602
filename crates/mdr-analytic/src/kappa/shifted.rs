//! κ_n for any n > 0: a shift to larger n, and Brouncker's continued fraction there.
//!
//! κ_n = κ_{n+2r} Π_{j<r} (n+2j+1)/(n+2j+2), and with s = 2n+1, σ = 2s, c_k = (2k+1)²
//!
//! 4κ_n²/π = s + 1/t_1,  t_k = σ + c_k/t_{k+1},  σ < t_k < σ + c_k/σ.
//!
//! Two steps in one, with w_k = σt_k + c_{k−1} and z = σ²:
//!
//! 4κ_n²/π = s (w_1+1)/(w_1−1),  w_k = z + c_{k−1} + c_k − c_k c_{k+1}/w_{k+2},  z + c_{k−1} < w_k < z + c_{k−1} + c_k.
//!
//! A relative error δ of w_{k+2} becomes at most θδ/(1−θ) in w_k, θ = c_k c_{k+1}/((z+c_{k+1})(z+c_{k−1}+c_k)) (1 +
//! |δ|), and one of w_1 less than 9δ/4w_1 in the result for w_1 ≥ 10. So later steps need fewer bits.

use mdr_core::number::{Precision, RoundingCount};
use rug::Float;

use super::rising::Rising;

/// n is shifted to this many times the precision in bits: shifting is cheaper than the fraction. The factor is
/// measured.
const SHIFT: f64 = 0.29;

/// The smallest shifted n, so that the bounds above hold.
const LEAST: f64 = 8.0;

/// The bounds on the steps decrease as n grows; larger n use those of this one, at the cost of a few bits and steps.
/// Below it z² < 10³⁰³ and θ > 10⁻³⁰³, so that no double overflows, underflows or is NaN.
const LARGEST: f64 = 1e75;

/// κ_n for n ≥ 0, computed with the given number of bits.
pub(super) fn kappa(n: &Float, bits: u32) -> RoundingCount {
    let approximate = n.to_f64();
    let shifts = (((SHIFT * f64::from(bits)).max(LEAST) - approximate) / 2.0).ceil().max(0.0) as u32;
    // s = 2(n+2r) + 1 with two roundings; ln κ² changes at most twice as much as ln s.
    let s = Float::with_val(bits, n * 2u32) + (4 * shifts + 1);
    let ratio = Fraction::new(approximate + 2.0 * f64::from(shifts), bits).ratio(&s, bits);
    let square = RoundingCount::new(s, 4).times(&ratio).times(&RoundingCount::pi(Precision::new(bits)));
    let mut result = square.sqrt();
    if let Some(rising) = Rising::new(n, shifts, bits) {
        result = result.times(&rising.product(1)).over(&rising.product(2));
    }
    // One more for the fixed point of n: d ln κ/dn < 1.
    RoundingCount::new(Float::with_val(bits, result.value() / 2u32), result.roundings() + 1)
}

/// The continued fraction, truncated for a given precision.
struct Fraction {
    /// For w_1, w_3, …: the bits by which a relative error is reduced in the result.
    gained: Vec<f64>,
    /// Whether θ ≤ 1/16 everywhere.
    proved: bool,
}

impl Fraction {
    fn new(n: f64, bits: u32) -> Self {
        let odd_square = |k: f64| (2.0 * k + 1.0) * (2.0 * k + 1.0);
        let z = (4.0 * n.min(LARGEST) + 2.0).powi(2);
        let mut fraction = Fraction { gained: Vec::with_capacity(32), proved: true };
        let mut total = z.log2() - 1.2;
        let mut k = 1.0;
        loop {
            fraction.gained.push(total);
            if total >= f64::from(bits) {
                return fraction;
            }
            let (last, next) = (z + odd_square(k - 1.0) + odd_square(k), odd_square(k + 1.0));
            let theta = odd_square(k) * next / ((z + next) * last);
            fraction.proved &= theta <= 1.0 / 16.0;
            // A tenth of a bit for 1 + |δ|.
            total -= (theta / (1.0 - theta)).log2() + 0.1;
            k += 2.0;
        }
    }

    /// (w_1 + 1)/(w_1 − 1).
    fn ratio(&self, s: &Float, bits: u32) -> RoundingCount {
        const MORE: u32 = 8;
        let last = self.gained.len() - 1;
        let precision = |step: usize| bits.saturating_sub(self.gained[step] as u32) + MORE;
        let middle = |k: u64| 8 * k * k + 2;
        let odd = |step: usize| 2 * step as u64 + 1;
        let z = Float::with_val(bits, s * 2u32).square();
        // w = x/y, at first its upper bound, with a relative error below one.
        let mut x = Float::with_val(precision(last), &z + middle(odd(last)));
        let mut y = Float::with_val(precision(last), 1);
        for step in (0..last).rev() {
            let (k, bits) = (odd(step), precision(step));
            let both = u128::from((2 * k + 1) * (2 * k + 3));
            let mut next = Float::with_val(bits, &z + middle(k)) * &x;
            next -= Float::with_val(bits, &y * (both * both));
            y = std::mem::replace(&mut x, next);
        }
        let ratio = Float::with_val(bits, &x + &y) / Float::with_val(bits, &x - &y);
        if !self.proved {
            return RoundingCount::unknown(Precision::new(bits));
        }
        // For θ ≤ 1/16 the five roundings of a step, including those of z and of the sum, contribute 5 units of its
        // precision. One unit for the end of the fraction, three for the last line, one for the quotient below.
        let steps = (5 * last as u64) >> MORE;
        RoundingCount::new(ratio, steps + 5)
    }
}
