//! Results that leave the range of their arithmetic become errors, never 0 or ∞ in silence.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

/// `value`, which is not zero in exact arithmetic, unless it left the range; then an error with log10 of its magnitude,
/// from the natural logarithm computed only in that case. An interval that knows nothing is undecided.
#[inline(always)]
pub(crate) fn representable<R: Real>(quantity: Quantity, value: R, ln_magnitude: impl FnOnce() -> R) -> Result<R> {
    if value.is_finite() && value != value.lit(0) {
        Ok(value)
    } else {
        let ln_magnitude = ln_magnitude();
        if ln_magnitude.is_finite() {
            return Err(Error::OutOfRange { quantity, log10: ln_magnitude.approx() / std::f64::consts::LN_10 });
        }
        Err(Error::Undecided { quantity, bits: value.precision(), what: "its magnitude" })
    }
}
