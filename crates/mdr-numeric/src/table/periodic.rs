//! Rows of a periodic profile: one crest at r = 0, and a trough at half of the wavelength.
//!
//! The rows up to the trough are the profile, mirrored there and repeated. Rows beyond are not averaged with them, but have to
//! agree: between rows an even profile that rises from crest to trough lies between its neighbours, and so has the mirror image of
//! each row beyond. Rows of which one does not are of another wavelength, or not even.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::Real;

/// Points of two periods, from points that begin at a crest.
///
/// ```
/// use mdr_numeric::table::periodic::mirrored;
/// let half = [0.0, 0.125, 0.25, 0.375, 0.5].map(|r: f64| (r, 1.0 - (2.0 * std::f64::consts::PI * r).cos()));
/// assert_eq!(mirrored(half.to_vec(), &1.0)?.len(), 17);
/// assert!(mirrored(half.to_vec(), &1.2).is_err()); // the rows end before the trough
/// assert!(mirrored(half.to_vec(), &0.7).is_err()); // beyond 0.35 the heights ought to fall
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] if the rows end before the trough, or if one beyond contradicts the wavelength.
pub fn mirrored<R: Real>(points: Vec<(R, R)>, wavelength: &R) -> Result<Vec<(R, R)>> {
    let half = wavelength.clone().over(2);
    // A decimal in a table is not exactly half of another.
    let slack = half.unit_roundoff().times(16) * &half;
    let (mut kept, beyond): (Vec<_>, Vec<_>) = points.into_iter().partition(|(r, _)| *r <= half.clone() + &slack);
    let ends_at_trough = kept.last().is_some_and(|(r, _)| (half.clone() - r).abs() <= slack);
    let Some((last, top)) = kept.last().cloned() else { return Ok(kept) };
    if !ends_at_trough && beyond.is_empty() {
        let requirement = "at least half of the wavelength: the rows reach from a crest at r = 0 to the trough; measure as far as \
                           there, or give the wavelength of the rows";
        return Err(Error::domain(Quantity::Parameter("the last radius of the table"), &last, requirement));
    }
    for (r, height) in &beyond {
        require_image(&kept, wavelength, r, height)?;
    }
    if ends_at_trough && let Some(trough) = kept.last_mut() {
        trough.0 = half;
    }
    let mut fall: Vec<(R, R)> = kept.iter().rev().map(|(r, f)| (wavelength.clone() - r, f.clone())).collect();
    if ends_at_trough {
        fall.remove(0);
    }
    if kept.first().is_none_or(|(r, _)| *r != r.lit(0)) {
        fall.push((wavelength.clone(), top.lit(0)));
    }
    let rise: Vec<(R, R)> =
        kept.iter().filter(|(r, _)| *r != r.lit(0)).map(|(r, f)| (wavelength.clone() + r, f.clone())).collect();
    // A second trough with its slope, so that a whole period follows the first crest.
    let again: Vec<(R, R)> = fall.iter().map(|(r, f)| (wavelength.clone() + r, f.clone())).collect();
    Ok(kept.into_iter().chain(fall).chain(rise).chain(again).collect())
}

/// Requires a row beyond the trough to lie between the heights of the rows around its image before it.
fn require_image<R: Real>(kept: &[(R, R)], wavelength: &R, r: &R, height: &R) -> Result<()> {
    let mut image = r.clone();
    while image > *wavelength {
        image -= wavelength;
    }
    if image.clone().times(2) > *wavelength {
        image = wavelength.clone() - &image;
    }
    let zero = r.lit(0);
    let top = kept.iter().fold(zero.clone(), |top, (_, f)| top.greater(&f.abs()));
    let slack = top.unit_roundoff().times(1 << 12) * top;
    let shift = wavelength.unit_roundoff().times(64) * r;
    let below = kept.iter().rev().find(|(at, _)| *at <= image.clone() + &shift).map_or(&zero, |(_, f)| f);
    let above = kept.iter().find(|(at, _)| at.clone() + &shift >= image).map_or(height, |(_, f)| f);
    // A row that is its own image has both at once.
    let [lower, upper] = [below.lesser(above), below.greater(above)];
    if *height >= lower - &slack && *height <= upper + &slack {
        return Ok(());
    }
    let requirement = "one at which the height is between those of the rows around its image, f(λ − r) = f(λ + r) = f(r): the rows are \
                       not periodic with this wavelength; give their own, or only those from a crest to the trough beside it";
    Err(Error::domain(Quantity::Parameter("a radius of the table"), r, requirement))
}
