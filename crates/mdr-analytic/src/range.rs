//! Results that leave the range of their arithmetic become errors, never 0 or ∞; and intermediate results do not leave
//! it if the result does not.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

/// `value`, which is nonzero in exact arithmetic, unless it left the range; then an error with log10 of its magnitude,
/// from the natural logarithm, which is computed only in that case. An unbounded interval is undecided.
#[inline(always)]
pub(crate) fn representable<R: Real>(quantity: Quantity, value: R, ln_magnitude: impl FnOnce() -> R) -> Result<R> {
    if value.is_finite() && value != value.lit(0) { Ok(value) } else { Err(beyond(quantity, &ln_magnitude())) }
}

/// The error of a result with this logarithm of its magnitude.
#[cold]
fn beyond<R: Real>(quantity: Quantity, ln_magnitude: &R) -> Error {
    if ln_magnitude.is_finite() {
        return Error::OutOfRange { quantity, log10: ln_magnitude.approx() / std::f64::consts::LN_10 };
    }
    Error::undecided(quantity, ln_magnitude, "its magnitude")
}

/// `plus` − `minus`, both nonnegative; one that is 0 has underflowed and is negligible beside the other. Their
/// logarithms are needed if both are 0 or one is out of range.
#[inline(always)]
pub(crate) fn difference<R: Real>(quantity: Quantity, plus: R, minus: R, ln: impl FnOnce() -> [R; 2]) -> Result<R> {
    sum(quantity, plus, -minus, || {
        let [plus, minus] = ln();
        ln_difference(&plus, &minus)
    })
}

/// x + y of any signs; one that is 0 is exact or has underflowed and is negligible beside the other. The logarithm of
/// the magnitude of the sum is needed if both are 0 or one is out of range.
#[inline(always)]
pub(crate) fn sum<R: Real>(quantity: Quantity, x: R, y: R, ln_magnitude: impl FnOnce() -> R) -> Result<R> {
    let zero = x.lit(0);
    let flushed = x == zero && y == zero;
    let value = x + &y;
    if value.is_finite() && !flushed { Ok(value) } else { Err(beyond(quantity, &ln_magnitude())) }
}

/// ln(eᵖ + e^q).
pub(crate) fn ln_sum<R: Real>(p: &R, q: &R) -> R {
    let greater = p.greater(q);
    (p.lesser(q) - &greater).exp().ln_1p() + greater
}

/// ln|eᵖ − e^q|.
pub(crate) fn ln_difference<R: Real>(p: &R, q: &R) -> R {
    let gap = p.clone() - q;
    let gap = if gap > gap.lit(0) { -gap } else { gap };
    p.greater(q) + (-gap.exp_m1()).ln()
}

/// Whether rounding is relative to the magnitude of a number, which it is not for subnormal numbers.
#[inline(always)]
pub(crate) fn ordinary<R: Real>(x: &R) -> bool {
    x.approx().is_normal() || beyond_doubles(x)
}

#[cold]
fn beyond_doubles<R: Real>(x: &R) -> bool {
    x.is_finite() && x.abs() * x.unit_roundoff() > x.lit(0)
}

/// The product of some factors. Intermediate results stay in range if the product does.
#[inline(always)]
pub(crate) fn product<const N: usize, R: Real>(factors: [&R; N]) -> R {
    let mut plain = factors[0].clone();
    for factor in &factors[1..] {
        plain *= *factor;
        if !ordinary(&plain) {
            return balanced(factors.to_vec());
        }
    }
    plain
}

/// The product of some factors, where the next factor is always one that leads back towards one.
#[cold]
pub(crate) fn balanced<R: Real>(mut factors: Vec<&R>) -> R {
    factors.sort_by(|x, y| x.approx().abs().total_cmp(&y.approx().abs()));
    let one = factors[0].lit(1);
    let mut product = one.clone();
    while !factors.is_empty() {
        let next = if product.abs() > one { factors.remove(0) } else { factors.remove(factors.len() - 1) };
        product *= next;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_stay_in_range() {
        assert_eq!(product([&1e200, &1e200, &1e-200, &1e-200, &3.0]), 3.0);
        assert_eq!(product([&1e-200, &1e-200, &1e200, &1e200]), 1.0);
        assert_eq!(product([&1e-200, &1e-120, &1e200]), 1e-120);
        assert_eq!(product([&1e200, &1e200, &0.0]), 0.0);
        assert_eq!(product([&-1e200, &1e200]), f64::NEG_INFINITY);
    }

    #[test]
    fn differences_of_flushed_terms_are_out_of_range() {
        let ln = |log10: f64| log10 * std::f64::consts::LN_10;
        assert_eq!(difference(Quantity::Force, 2.0, 2.0, || unreachable!()), Ok(0.0));
        assert_eq!(difference(Quantity::Force, 0.0, 2.0, || unreachable!()), Ok(-2.0));
        for (plus, minus, expected) in [(-400.0, -410.0, -400.0), (-410.0, -400.0, -400.0)] {
            let Err(Error::OutOfRange { log10, .. }) = difference(Quantity::Force, 0.0, 0.0, || [ln(plus), ln(minus)])
            else {
                panic!("{plus}")
            };
            assert!((log10 - expected).abs() < 1e-9, "{log10}");
        }
    }
}
