//! The energy of a contact by its loading without adhesion, for a medium whose springs are too soft at the tip for an integral
//! over them.
//!
//! Loaded without adhesion up to the size b, a contact stores U₀ = ∫₀ᵇ F₀ g' db, with F₀ = S (g − mean of g). From there at a
//! fixed size to the depth d it is a flat punch (K. L. Johnson, K. Kendall and A. D. Roberts, Proc. R. Soc. A 324 (1971) 301):
//! Π = U₀ + F₀(d − g) + ½S(d − g)² − wA.

use mdr_core::calculus::quadrature::tanh_sinh_near_ends;
use mdr_core::calculus::{Tolerance, roundoff_tolerance};
use mdr_core::contact::Result;
use mdr_core::number::Real;

use super::Energy;
use crate::contact::Contact;
use crate::medium::phase;

/// A contact along the whole surface of a periodic medium.
#[derive(Clone, Debug)]
pub(crate) struct Complete<R> {
    /// The approach at which it is complete, in m.
    pub(crate) indentation: R,
    /// Π, in J/m².
    pub(crate) potential: R,
}

impl<R: Real> Energy<R> {
    /// Π per area of a contact of one strip in each period.
    pub(super) fn by_loading(&self, wavelength: &R, b: &R, d: &R) -> Result<R> {
        let contact = &self.contact;
        let excess = d.clone() - contact.transform().g(b)?;
        let load = contact.stiffness(b) * contact.transform().above_mean(b)?;
        let punch = (contact.stiffness(b) * excess.square()).over(2);
        Ok(loaded(contact, wavelength, Some(b))? + load * &excess + punch)
    }
}

impl<R: Real> Complete<R> {
    /// The complete contact with one period; its approach is the limit of g, which g reaches as the fourth power of b.
    pub(crate) fn of(contact: &Contact<R>, wavelength: &R) -> Result<Self> {
        let bits = i64::from(wavelength.precision());
        let far = wavelength.lit(2).powi(bits / 4 + 8) * wavelength;
        let potential = loaded(contact, wavelength, None)?;
        Ok(Complete { indentation: contact.transform().g(&far)?, potential })
    }
}

/// U₀ − wA of a strip in each period, of the size b, in pieces between the kinks; of complete contact without a size.
fn loaded<R: Real>(contact: &Contact<R>, wavelength: &R, size: Option<&R>) -> Result<R> {
    let mut ends = contact.transform().kinks();
    ends.retain(|kink| size.is_none_or(|size| kink < size));
    let mut ends: Vec<Option<R>> = ends.into_iter().map(Some).collect();
    ends.push(size.cloned());
    let mut total = contact.modulus().lit(0);
    let mut start = total.clone();
    for end in ends {
        total += &piece(contact, wavelength, &start, end.as_ref())?;
        start = end.unwrap_or(start);
    }
    Ok(total)
}

/// The part of U₀ − wA between two sizes. With t = πb/λ = y/(1 − y) the range is finite.
fn piece<R: Real>(contact: &Contact<R>, wavelength: &R, from: &R, to: Option<&R>) -> Result<R> {
    let (zero, one) = (from.lit(0), from.lit(1));
    let tolerance = Tolerance::new(&roundoff_tolerance(&one).times(4)).or_noise_below(one.unit_roundoff().sqrt());
    let transform = contact.transform();
    let area = contact.adhesion().work().clone().times(2) / wavelength;
    let rest_of = |b: &R| (phase(b, wavelength) + &one).inv();
    let rest = to.map_or_else(|| zero.clone(), rest_of);
    let upper = to.map_or_else(|| one.clone(), |b| phase(b, wavelength) * &rest);
    let lower = phase(from, wavelength) * rest_of(from);
    let per_phase = wavelength.clone() / wavelength.pi();
    let integral = tanh_sinh_near_ends(&lower, &upper, tolerance, |node| {
        let left = rest.clone() + &node.from_upper;
        let t = (lower.clone() + &node.from_lower) / &left;
        if t < t.unit_roundoff().square() {
            return Ok(zero.clone());
        }
        let b = t.clone() * &per_phase;
        let power = contact.stiffness(&b) * transform.above_mean(&b)? * transform.slope(&b)?;
        Ok((power - area.clone() / (t.square() + &one)) / left.square())
    })?;
    Ok(integral.value * per_phase)
}
