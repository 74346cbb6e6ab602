//! Polynomials of a piece of a tabulated branch.

use std::f64::consts::PI;

/// Coefficients of a polynomial, in powers of an argument between −1 and 1.
pub(super) const TERMS: usize = 10;
pub(super) type Coefficients = [f64; TERMS];
/// The coefficients by pairs, of an even and of an odd power: two polynomials in t² that are evaluated side by side.
pub(super) type Polynomial = [[f64; 2]; TERMS / 2];

/// A polynomial and its derivative.
#[inline]
pub(super) fn horner(coefficients: &Polynomial, t: f64) -> (f64, f64) {
    let squared = t * t;
    let ([mut even, mut odd], [mut even_slope, mut odd_slope]) = ([0.0; 2], [0.0; 2]);
    for [even_next, odd_next] in coefficients.iter().rev() {
        (even_slope, odd_slope) = (even_slope * squared + even, odd_slope * squared + odd);
        (even, odd) = (even * squared + even_next, odd * squared + odd_next);
    }
    (even + t * odd, odd + 2.0 * t * (even_slope + t * odd_slope))
}

/// The coefficients of even and of odd powers.
fn by_pairs(coefficients: &Coefficients) -> Polynomial {
    std::array::from_fn(|i| [coefficients[2 * i], coefficients[2 * i + 1]])
}

/// The polynomial through values at −cos(π(i + 1/2)/TERMS).
pub(super) fn fit(values: &Coefficients) -> Polynomial {
    // The roundings are those of differences.
    let base = values[TERMS / 2];
    let term = |k: usize| {
        let cosine = |i: usize| (PI * (k as f64) * (i as f64 + 0.5) / TERMS as f64).cos();
        let sum: f64 = (0..TERMS).map(|i| (values[TERMS - 1 - i] - base) * cosine(i)).sum();
        sum * if k == 0 { 1.0 } else { 2.0 } / TERMS as f64
    };
    let mut total = [0.0; TERMS];
    // The coefficients of Tₖ and of Tₖ₊₁.
    let (mut this, mut next) = ([0.0; TERMS], [0.0; TERMS]);
    (this[0], next[1]) = (1.0, 1.0);
    for k in 0..TERMS {
        let c = term(k);
        total.iter_mut().zip(&this).for_each(|(total, power)| *total += c * power);
        let mut after = this.map(|power| -power);
        after.iter_mut().skip(1).zip(&next).for_each(|(after, power)| *after += 2.0 * power);
        (this, next) = (next, after);
    }
    total[0] += base;
    by_pairs(&total)
}

/// The polynomial that has these values at these arguments.
pub(super) fn through(arguments: &Coefficients, values: &Coefficients) -> Polynomial {
    let mut quotients = *values;
    for order in 1..TERMS {
        for i in (order..TERMS).rev() {
            quotients[i] = (quotients[i] - quotients[i - 1]) / (arguments[i] - arguments[i - order]);
        }
    }
    let mut total = [0.0; TERMS];
    for (quotient, argument) in quotients.iter().zip(arguments).rev() {
        let shifted = total.map(|power| -argument * power);
        let mut raised = [0.0; TERMS];
        raised[1..].copy_from_slice(&total[..TERMS - 1]);
        total = std::array::from_fn(|i| raised[i] + shifted[i]);
        total[0] += quotient;
    }
    by_pairs(&total)
}
