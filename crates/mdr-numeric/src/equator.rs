//! The equator of a profile: an outer radius where g diverges, as that of a sphere.
//!
//! Before it there is an equilibrium at every value at which the contact still grows, however close to the equator: at
//! 1 − a/R ≈ 2 exp(−2(1 + Δl/R)) on a sphere of radius R at d = R, where the arithmetic may have no number in between.

use mdr_core::contact::{Control, Result};
use mdr_core::number::Real;

use crate::contact::Contact;

/// The relative distance 2^−k from the equator at which the bounds of the profile are evaluated.
const MARGIN: i64 = 40;
/// The relative distance 2^−k from the equator within which a state is more accurate from the controlled value than
/// from its radius.
const NEAR: i64 = 8;

impl<R: Real> Contact<R> {
    /// The outer radius, if g is known to diverge there.
    ///
    /// # Errors
    /// Errors of the transform near its outer radius; see [`Transform::kink`](mdr_core::contact::Transform::kink).
    pub(crate) fn equator(&self) -> Result<Option<R>> {
        let transform = self.transform();
        let Some(outer) = transform.outer_radius().filter(|_| !transform.vertical_edge()) else { return Ok(None) };
        let end = transform.kink(transform.kinks().len(), &outer.lit(2).powi(-MARGIN))?;
        Ok(end.filter(|end| end.value.is_none() && end.inside.least.is_some()).map(|_| outer))
    }

    /// Indentation and force of the equilibrium between the last radius and the equator.
    ///
    /// The mean of g is that up to the last radius, since g is close to its mean over the remainder: it grows as the
    /// logarithm of the distance, or d would not be finite.
    pub(crate) fn state_before_equator(&self, last: &R, equator: &R, value: &R) -> Result<(R, R)> {
        let share = (equator.clone() - last) / equator;
        let mean = self.transform().mean(last)?;
        let mean = (self.transform().g(last)? - &mean) * share + mean;
        let d = self.held_against(equator, value, || Ok(mean.clone()))?;
        let force = match self.control() {
            Control::Force => value.clone(),
            _ => self.stiffness(equator) * (d.clone() - mean),
        };
        Ok((d, force))
    }
}

/// The relative distances 2^−k of a search towards an outer radius: 2⁻¹, 2⁻², 2⁻⁴, …, and the last one that the
/// arithmetic distinguishes from it with certainty.
pub(crate) fn approaches<R: Real>(outer: &R) -> impl Iterator<Item = R> {
    let last = i64::from(outer.precision()) - 1;
    let outer = outer.clone();
    let halvings = std::iter::successors(Some(1), |k| Some(2 * k)).take_while(move |k| *k < last);
    halvings.chain([last]).map(move |k| before(&outer, k))
}

/// The last radius before an outer one.
pub(crate) fn last_before<R: Real>(outer: &R) -> R {
    before(outer, i64::from(outer.precision()) - 1)
}

/// Whether a radius is so close to the equator that g is much more accurate than from the rounded radius.
pub(crate) fn is_near<R: Real>(a: &R, equator: &R) -> bool {
    *a > before(equator, NEAR)
}

/// outer·(1 − 2^−k).
fn before<R: Real>(outer: &R, k: i64) -> R {
    outer.clone() - outer.lit(2).powi(-k) * outer
}
