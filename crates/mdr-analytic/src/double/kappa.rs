//! κ_n in extended precision and, rounded from there, in `f64`.

use mdr_core::number::{Extended, Real};

use super::kappa_table::{ASYMPTOTIC, CONSTANT, NEAR_HALF, SLOPES};
use crate::kappa::{Kappa, expansion};

/// The least n of the continued fraction, over its depth.
const DEPTHS: f64 = 6.0;

/// One word: a fit, to 6 units of 2⁻⁶⁴; two words near n = 1/2: a fit, to 8 units of 2⁻¹²⁸. Otherwise the generic
/// expansions, whose remainders are bounded.
impl<const N: usize> Kappa for Extended<N> {
    #[inline]
    fn kappa(n: &Self) -> Self {
        match N {
            1 => fitted(n).unwrap_or_else(|| asymptotic(n)),
            2 => fitted_near_half(n).unwrap_or_else(|| expansion(n, DEPTHS)),
            _ => expansion(n, DEPTHS),
        }
    }
}

/// Rounded from extended precision: within 0.51 ulp.
impl Kappa for f64 {
    fn kappa(n: &f64) -> f64 {
        Extended::<1>::kappa(&Extended::from(*n)).nearest_f64().unwrap_or(f64::NAN)
    }
}

/// The fit below n = 63, in one word.
#[inline]
fn fitted<const N: usize>(n: &Extended<N>) -> Option<Extended<N>> {
    let significand = u128::from(n.limbs()[N - 1]);
    let fraction = match n.exponent() {
        shift @ 0..=6 => significand << shift,
        shift @ -127..0 => significand >> -shift,
        shift if shift < 0 => 0,
        _ => return None,
    };
    // v = 1 + n in Q64, its binade and the sixteenth of the binade; the remainder is (u + 1)/2.
    let v = (1 << 64) + fraction;
    let zeros = v.leading_zeros();
    let binade = 63 - zeros as usize;
    if binade >= CONSTANT.len() / 16 {
        return None;
    }
    let normal = v << zeros;
    let interval = 16 * binade + (normal >> 123 & 15) as usize;
    let u = (((normal << 5) >> 64) as u64 ^ 1 << 63) as i64;
    let product = |a: i64| ((i128::from(a) * i128::from(u)) >> 64) as i64;
    let slope = SLOPES[interval].iter().rev().fold(0, |sum, &c| c + product(sum));
    let value = CONSTANT[interval].wrapping_add_signed((product(slope) + 4) >> 3);
    let shift = value.leading_zeros();
    let mut limbs = [0; N];
    limbs[N - 1] = value << shift;
    let exponent = 1 + binade.div_ceil(2) as i64 - i64::from(shift);
    // The fit, its rounding and that of v contribute 1.7 units of value ≥ 0.39; and 0 ≤ d ln κ/d ln n < 1/2.
    Some(Extended::from_parts(false, limbs, exponent, n.error() + 6.0))
}

/// κ_n = ½√(π(x + s(x)/x)), x = 2n + 1 ≥ 127, in one word. The second term is below 2⁻¹⁴ of the first, so a double
/// suffices.
fn asymptotic<const N: usize>(n: &Extended<N>) -> Extended<N> {
    /// The relative error of s(x)/x in units of 2⁻⁶⁴: 16 roundings of a double.
    const DOUBLE: f64 = 32768.0;
    let x = n.times(2) + n.lit(1);
    let inverse = x.approx().recip();
    let sum = ASYMPTOTIC.iter().rev().fold(0.0, |sum, &c| c + sum * inverse * inverse);
    let fraction = x + Extended::from(sum * inverse).widened(DOUBLE);
    (fraction * x.pi()).sqrt().over(2)
}

/// The fit for |n − 1/2| < 1/16, in two words.
fn fitted_near_half<const N: usize>(n: &Extended<N>) -> Option<Extended<N>> {
    let u = (*n - n.ratio(7, 16)).times(8);
    let words = |x: &Extended<N>| u128::from(x.limbs()[N - 1]) << 64 | u128::from(x.limbs()[N - 2]);
    let inside = u > u.lit(0) && u < u.lit(1);
    let shift = u32::try_from(-u.exponent()).ok().filter(|_| inside)?;
    let fixed = words(&u).checked_shr(shift).unwrap_or(0);
    let (first, rest) = NEAR_HALF.split_first()?;
    let value = first + high_product(rest.iter().rev().fold(0, |sum, c| c - high_product(sum, fixed)), fixed);
    let zeros = value.leading_zeros();
    let normal = value << zeros;
    let mut limbs = [0; N];
    (limbs[N - 1], limbs[N - 2]) = ((normal >> 64) as u64, normal as u64);
    // Roundings of the coefficients, of u, of each product and the fit contribute 4 units of a value above 0.6.
    Some(Extended::from_parts(false, limbs, 1 - i64::from(zeros), n.error() + 8.0))
}

/// ⌊ab/2¹²⁸⌋.
fn high_product(a: u128, b: u128) -> u128 {
    let low = |x: u128| u128::from(x as u64);
    let (middle, other) = ((a >> 64) * low(b), low(a) * (b >> 64));
    let carry = ((low(a) * low(b)) >> 64) + low(middle) + low(other);
    (a >> 64) * (b >> 64) + (middle >> 64) + (other >> 64) + (carry >> 64)
}
