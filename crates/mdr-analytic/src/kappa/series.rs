//! A hypergeometric series with three bits per term.
//!
//! By Gauss's second theorem κ_n = f(n, 1+n/2), where f(b, c) = ₂F₁(1, b; c; 1/2). The contiguous relations
//! f(b,c) = 1 + (b/2c) f(b+1,c+1) and f(b,c) = 2 − ((c−b)/c) f(b,c+1), taken in turn, give with x = n/2
//!
//! κ_n = Σ_m P_m (3x+1+3m)/(x+1+2m),  P_0 = 1,  P_{m+1} = −P_m (2x+m)(1−x+m) / (2(x+1+2m)(x+2+2m)).
//!
//! The remainder after M terms is exactly P_M f(2x+M, x+1+2M), and 0 < f ≤ 2 as soon as M ≥ x − 1: all terms of f are
//! then below those of Σ 2⁻ᵏ. The sum has no cancellation: P_m > 0 while m < x, and from there on it alternates with a
//! ratio below 1/8. For even n it terminates.

use mdr_core::number::Real;

/// Terms after which the remainder is below 2^−bits.
pub(super) fn terms(n: f64, bits: u32) -> u32 {
    let x = n / 2.0;
    let mut remaining = f64::from(bits) + 1.0;
    let mut product = 1.0;
    let mut m = 0;
    // One more than M ≥ x − 1 requires, because x is rounded.
    while remaining > 0.0 || f64::from(m) < x {
        let j = f64::from(m);
        // |1−x+m| may be arbitrarily small; the bound does not use that.
        let above = (2.0 * x + j) * (1.0 - x + j).abs().max(1.0);
        product *= above / (2.0 * (x + 1.0 + 2.0 * j) * (x + 2.0 + 2.0 * j));
        m += 1;
        // One logarithm for several terms.
        if m % 8 == 0 || remaining < 40.0 {
            remaining += product.log2();
            product = 1.0;
        }
    }
    m
}

/// The sum of the given number of terms, with its remainder.
pub(super) fn kappa<R: Real>(n: &R, terms: u32) -> R {
    let x = n.clone().over(2);
    let mut product = n.lit(1);
    let mut sum = n.lit(0);
    for m in (0..terms).map(i64::from) {
        product /= &(x.lit(2 * m + 1) + &x);
        sum += &((x.clone().times(3) + x.lit(3 * m + 1)) * &product);
        product *= &((n.lit(m) + n) * (x.clone() - x.lit(m + 1)));
        product /= &(x.lit(2 * m + 2) + &x).times(2);
    }
    sum.inflate(&product.times(2))
}
