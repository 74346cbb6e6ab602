//! Existence and uniqueness of a zero, proved by the interval Newton operator.

use rug::Float;

use crate::contact::Result;
use crate::number::{Interval, Real};

/// An interval around `candidate` that contains exactly one zero of f, as narrow as the precision of the candidate
/// allows; `None` when that cannot be proved (a double zero, a slope of uncertain sign, a candidate too far away).
///
/// `f` and `slope` are enclosures of a function and of its derivative. With N(X) = m − f(m)/f'(X), N(X) ⊂ X proves
/// existence and uniqueness (R. E. Moore, Interval Analysis, 1966); five radii of X are tried, from twice the Newton
/// step upwards.
///
/// ```
/// use mdr_core::calculus::verify::verify;
/// use mdr_core::number::{Interval, Precision, Real};
/// use rug::Float;
/// let candidate = Float::with_val(100, 1.41421356);
/// let root = verify(&candidate, |x| Ok(x.square() - &x.lit(2)), |x| Ok(x.clone().times(2)))?.expect("a proof");
/// assert!(root.contains(&Float::with_val(100, 2).sqrt()) && root.accuracy_bits() > 95);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// Whatever f and its slope return.
pub fn verify(
    candidate: &Float,
    f: impl FnMut(&Interval) -> Result<Interval>,
    mut slope: impl FnMut(&Interval) -> Result<Interval>,
) -> Result<Option<Interval>> {
    let at_candidate = slope(&Interval::point(candidate.clone()))?;
    verify_with(candidate, &at_candidate, f, slope)
}

/// [`verify`] with a slope of f near the candidate, of which nothing needs to be certain: only the radii that are tried depend on it.
///
/// # Errors
/// Whatever f and its slope return.
pub fn verify_with(
    candidate: &Float,
    slope_near: &Interval,
    mut f: impl FnMut(&Interval) -> Result<Interval>,
    mut slope: impl FnMut(&Interval) -> Result<Interval>,
) -> Result<Option<Interval>> {
    let point = Interval::point(candidate.clone());
    let value = f(&point)?;
    let step = value.clone() / slope_near;
    let rounding = point.unit_roundoff().times(4) * point.abs();
    let radius = (Interval::abs(&step) + rounding).times(2);
    for growth in [1, 2, 4, 16, 256] {
        let bound = radius.clone().times(growth);
        let around = point.clone().inflate(&bound);
        let over_cell = slope(&around)?;
        // The image is no narrower than the enclosure of f makes it.
        let narrowest = value.radius() / Real::abs(&over_cell).upper().clone();
        let image = point.clone() - value.clone() / over_cell;
        if around.lower() < image.lower() && image.upper() < around.upper() {
            if image.radius() <= narrowest * 2u32 {
                return Ok(Some(image));
            }
            let newton = |x: &Interval| -> Result<Interval> {
                let middle = x.midpoint();
                Ok(middle.clone() - f(&middle)? / slope(x)?)
            };
            return tighten(image, newton).map(Some);
        }
    }
    Ok(None)
}

/// Applies the operator while it more than halves the interval.
fn tighten(mut root: Interval, mut newton: impl FnMut(&Interval) -> Result<Interval>) -> Result<Interval> {
    loop {
        let Some(narrower) = newton(&root)?.intersect(&root) else { return Ok(root) };
        if narrower.radius() * 2u32 >= root.radius() {
            return Ok(narrower);
        }
        root = narrower;
    }
}
