//! Exponentials of pairs of doubles, without branches.
//!
//! x = k(ln 2)/64 + r, |r| ≤ (ln 2)/128, and eˣ = 2^(k/64)eʳ with a table of 2^(j/64) in pairs, k = 64e + j.
//!
//! **Error** of [`exponential`], relative. r: k·(ln 2)/64 is exact except for its second part, 2⁻⁴², and its roundings
//! for |k| < 2¹⁷: 2⁻⁷⁷. eʳ = 1 + r + r²/2 + r³Q(r): r and r² are pairs, r³Q < 2⁻²⁵·¹ is a double with 6 roundings,
//! 2⁻⁷⁵·⁵, and the first term that Q omits is r⁹/9! < 2⁻⁸⁵. The sum with r²/2, the product with the table and the sum
//! with that have an error below 2⁻⁷⁶. Together below 2⁻⁷⁴, [`ERROR`].

use super::pair::{Arithmetic, Pair};
use super::powers::{HIGH, LOW, STEP};

/// The bound of the relative error of an exponential.
pub(super) const ERROR: f64 = 1.0 / (1_u128 << 74) as f64;

/// 64/ln 2.
const STEPS: f64 = 64.0 * std::f64::consts::LOG2_E;

/// Adding it to an integer below 2⁵¹ shifts that into the last bits.
pub(super) const TO_INTEGER: f64 = 6_755_399_441_055_744.0; // 1.5·2⁵²

/// 2⁵²: or-ing its bits with a smaller integer gives a double.
pub(super) const FROM_INTEGER: f64 = 4_503_599_627_370_496.0;

/// Σ rʲ/(j + 3)!.
const CUBIC: [f64; 6] = [1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0, 1.0 / 40320.0];

/// k, from the bits of k + [`TO_INTEGER`], as an index into the table and a power of two.
#[inline(always)]
fn parts(shifted: f64) -> (usize, f64) {
    let bits = shifted.to_bits();
    ((bits % 64) as usize, f64::from_bits(((bits >> 6) + 1023) << 52))
}

/// e^x for |x| < 650, where the second part is also a normal number: within [`ERROR`].
#[inline(always)]
pub(super) fn exponential<A: Arithmetic>(arithmetic: A, x: Pair) -> Pair {
    let shifted = A::multiply_add(x.hi, STEPS, TO_INTEGER);
    let k = shifted - TO_INTEGER;
    let r = Pair::sum(A::multiply_add(-k, STEP.hi, x.hi), A::multiply_add(-k, STEP.lo, x.lo));
    let square = A::product(r.hi, r.hi);
    let sum = Pair::quick_sum(r.hi, 0.5 * square.hi);
    let rest = A::multiply_add(r.lo, r.hi, A::multiply_add(0.5, square.lo, cubic::<A>(r.hi, square.hi)));
    let less_one = Pair { hi: sum.hi, lo: sum.lo + (r.lo + rest) };
    let (index, scale) = parts(shifted);
    let power = Pair { hi: HIGH[index], lo: LOW[index] };
    let product = power.times(arithmetic, less_one);
    let all = Pair::quick_sum(power.hi, product.hi);
    let all = Pair::quick_sum(all.hi, all.lo + (product.lo + power.lo));
    Pair { hi: all.hi * scale, lo: all.lo * scale }
}

/// e^x for |x| < 650, within 2 roundings and one of x.
#[inline(always)]
pub(super) fn rough_exponential<A: Arithmetic>(x: f64) -> f64 {
    let shifted = A::multiply_add(x, STEPS, TO_INTEGER);
    let k = shifted - TO_INTEGER;
    let r = A::multiply_add(-k, STEP.lo, A::multiply_add(-k, STEP.hi, x));
    let square = r * r;
    let less_one = r + A::multiply_add(0.5, square, cubic::<A>(r, square));
    let (index, scale) = parts(shifted);
    A::multiply_add(HIGH[index], less_one, HIGH[index]) * scale
}

/// r³Q(r).
#[inline(always)]
fn cubic<A: Arithmetic>(r: f64, square: f64) -> f64 {
    let [c0, c1, c2, c3, c4, c5] = CUBIC;
    let odd = A::multiply_add(A::multiply_add(c5, square, c3), square, c1);
    let even = A::multiply_add(A::multiply_add(c4, square, c2), square, c0);
    square * r * A::multiply_add(odd, r, even)
}

/// ln x for normal x, to a relative 10⁻⁷: x = 2ᵉm, m between √½ and √2, and ln m = 2 artanh((m − 1)/(m + 1)).
#[inline(always)]
pub(super) fn rough_logarithm<A: Arithmetic>(x: f64) -> f64 {
    const BIAS: u64 = 1023 << 52;
    let biased = x.to_bits().wrapping_sub(std::f64::consts::FRAC_1_SQRT_2.to_bits()).wrapping_add(BIAS) >> 52;
    let e = f64::from_bits(biased | FROM_INTEGER.to_bits()) - (FROM_INTEGER + 1023.0);
    let m = f64::from_bits(x.to_bits().wrapping_sub(biased << 52).wrapping_add(BIAS));
    let s = (m - 1.0) / (m + 1.0);
    let square = s * s;
    let series = A::multiply_add(A::multiply_add(2.0 / 7.0, square, 0.4), square, 2.0 / 3.0);
    A::multiply_add(e, std::f64::consts::LN_2, s * A::multiply_add(series, square, 2.0))
}

#[cfg(test)]
#[path = "../../tests/private/exponential.rs"]
mod tests;
