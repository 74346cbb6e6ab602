//! Newton's method in a bracket, and over neighbourhoods that contain their own image.

use std::cmp::Ordering;

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

/// Newton's method inside a shrinking bracket, for a function with its slope that is `rising` or falling at the root.
pub(crate) fn within<R: Real>(mut low: R, mut high: R, rising: bool, f: impl Fn(&R) -> (R, R)) -> R {
    let mut u = (low.clone() + &high).over(2).midpoint();
    let mut last_step = high.clone() - &low;
    for _ in 0..64 + 2 * u.precision() {
        let (value, slope) = f(&u);
        match value.partial_cmp(&u.lit(0)) {
            Some(Ordering::Greater) if rising => high = u.clone(),
            Some(Ordering::Less) if !rising => high = u.clone(),
            Some(Ordering::Greater | Ordering::Less) => low = u.clone(),
            // Only rounding is left.
            _ => break,
        }
        let newton = (u.clone() - value / slope).midpoint();
        let step = (newton.clone() - &u).abs();
        let brisk = step.clone().times(2) < last_step && newton >= low && newton <= high;
        let next = if brisk { newton } else { (low.clone() + &high).over(2).midpoint() };
        last_step = (next.clone() - &u).abs();
        u = next;
        // Newton's method doubles the digits: the next step would be below rounding.
        if last_step <= tolerance(&u) || (brisk && step.square() <= tolerance(&u)) {
            break;
        }
    }
    u
}

/// Two units in the last place of u, or of one.
pub(crate) fn tolerance<R: Real>(u: &R) -> R {
    (u.abs() + u.lit(1)) * u.unit_roundoff().times(2)
}

/// The root near `guess` of a function that is `rising` or falling there, by a Newton step over a neighbourhood, of this
/// radius at first, that contains its own image; `newton` returns the image of a number and the slope, over a
/// neighbourhood of it. For an interval type this proves existence and uniqueness. A second step carries the derivatives
/// of a dual number.
///
/// # Errors
/// [`Error::Undecided`] where no neighbourhood does; those of the second step.
pub(crate) fn enclosed<R: Real>(
    guess: &R,
    mut radius: R,
    rising: bool,
    what: &'static str,
    newton: impl Fn(&R, &R) -> Result<(R, R)>,
) -> Result<R> {
    // The uncertainty of terms that cancel at the guess does not show in the radius, so the neighbourhood grows as long
    // as it is known to a quarter of the digits.
    for _ in 0..guess.precision().div_ceil(4) {
        let neighbourhood = guess.clone().inflate_with_slope(&radius);
        let Ok((image, slope)) = newton(guess, &neighbourhood) else { break };
        if (image.clone() - guess).abs() <= radius {
            // If an enclosure proves a root, the slope proves that it is the one between two folds that is sought.
            let encloses = neighbourhood != *guess;
            if encloses && (slope > slope.lit(0)) != rising {
                break;
            }
            return Ok(newton(&image, &image)?.0);
        }
        radius = radius.times(8);
    }
    Err(undecided(guess, what))
}

/// The error for a radius that the arithmetic does not decide.
pub(crate) fn undecided<R: Real>(at: &R, what: &'static str) -> Error {
    Error::undecided(Quantity::ContactRadius, at, what)
}
