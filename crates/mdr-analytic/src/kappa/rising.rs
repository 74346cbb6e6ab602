//! Products of many factors n + a, n + a + 2, …
//!
//! A run of d factors is a polynomial in n of degree d with integer coefficients. With precomputed powers of n it costs
//! d products with short numbers and one long product, instead of d long ones.

use mdr_core::number::RoundingCount;
use rug::{Assign, Float, Integer};

/// Π_{j<count} (n + first + 2j) for different `first`.
pub(super) struct Rising {
    /// Truncated powers of n with this number of binary places, from the first power on.
    powers: Vec<Integer>,
    places: u32,
    count: u32,
}

impl Rising {
    /// For n ≥ 0; `None` if there are no factors.
    pub(super) fn new(n: &Float, count: u32, places: u32) -> Option<Self> {
        if count == 0 {
            return None;
        }
        let largest = u32::BITS - (2 * count + 2).leading_zeros();
        // The number of short products that cost as much as a long one grows as the root of the length. Coefficients
        // stay below 2¹²⁷, being at most 2^d times the last.
        let degree = (places / 50).isqrt().max(4).min(126 / (largest + 1)).min(count);
        let shifted = Float::with_val(n.prec(), n << places);
        let (first, _) = shifted.to_integer_round(rug::float::Round::Down)?;
        let mut powers = Vec::with_capacity(degree as usize);
        powers.push(first);
        for i in 1..degree as usize {
            powers.push(Integer::from(&powers[i - 1] * &powers[0]) >> places);
        }
        Some(Rising { powers, places, count })
    }

    /// The product for the given first summand ≥ 1; summands are two apart.
    pub(super) fn product(&self, first: u32) -> RoundingCount {
        let degree = self.powers.len();
        let mut product = Float::with_val(self.places, 1);
        let mut roundings = 0;
        let (mut value, mut coefficient) = (Integer::new(), Integer::new());
        let mut coefficients = Vec::with_capacity(degree + 1);
        let mut j = 0;
        while j < self.count {
            let length = (self.count - j).min(degree as u32);
            let start = u64::from(first + 2 * j);
            expand(&mut coefficients, start, length);
            value.assign(coefficients[0]);
            value <<= self.places;
            for (c, power) in coefficients[1..].iter().zip(&self.powers) {
                coefficient.assign(*c);
                value += &coefficient * power;
            }
            product *= Float::with_val(self.places, &value) >> self.places;
            // A power nⁱ is too small by at most (i−1) max(1, n)^(i−2) units, so the polynomial q by at most q'(max(1,
            // n)). q'/q = Σ 1/(n+a) is below d/a, and q(1)/q(0) = Π (a+1)/a below 2d.
            roundings += 2 + (2 * u64::from(length).pow(2)).div_ceil(start);
            j += length;
        }
        RoundingCount::new(product, roundings)
    }
}

/// The coefficients of Π (n + start + 2j), j from 0 to length − 1, from the constant one on.
fn expand(coefficients: &mut Vec<u128>, start: u64, length: u32) {
    coefficients.clear();
    coefficients.push(1);
    for j in 0..u64::from(length) {
        let summand = u128::from(start + 2 * j);
        coefficients.push(1);
        for i in (1..coefficients.len() - 1).rev() {
            coefficients[i] = coefficients[i] * summand + coefficients[i - 1];
        }
        coefficients[0] *= summand;
    }
}
