//! Sizes of contacts, and functions of them.

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::{Real, Special};

use super::Medium;

impl<R: Special> Medium<R> {
    /// The contact radius or half-width of a contact of this size, in m.
    pub fn contact_radius(&self, size: &R) -> R {
        match self {
            Medium::Periodic { wavelength, .. } => phase(size, wavelength).atan() * wavelength / size.pi(),
            _ => size.clone(),
        }
    }

    /// A of a contact of this size.
    #[cfg(feature = "mp")]
    pub(crate) fn area(&self, size: &R) -> R {
        let [factor, one, other] = self.area_factors(size);
        one * &other * &factor
    }

    /// The size of a contact with this contact radius or half-width, in m, if there is one.
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// let waves = Medium::periodic(1e6, 1e-3)?;
    /// assert!(waves.size_within(&0.4e-3).is_ok() && waves.size_within(&0.5e-3).is_err());
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] for half of a period and more.
    pub fn size_within(&self, contact_radius: &R) -> Result<R> {
        match self {
            Medium::Periodic { wavelength, .. } if !(contact_radius.clone().times(2) < *wavelength) => {
                Err(Error::domain(Quantity::ContactRadius, contact_radius, "smaller than half of the wavelength"))
            }
            _ => Ok(self.size(contact_radius)),
        }
    }

    /// The factors whose product is the area A of a contact of this size: πa² of a disc, 2b per length of a strip, and 2a/λ per
    /// area of strips of the half-width a.
    pub(crate) fn area_factors(&self, size: &R) -> [R; 3] {
        match self {
            Medium::Plane { .. } => [size.lit(2), size.clone(), size.lit(1)],
            Medium::Periodic { wavelength, .. } => [size.lit(2), self.contact_radius(size), wavelength.clone().inv()],
            _ => self.disc_factors(size),
        }
    }

    /// The size of a contact with this contact radius or half-width, in m; below λ/2 on a periodic medium.
    pub fn size(&self, contact_radius: &R) -> R {
        match self {
            Medium::Periodic { wavelength, .. } => {
                let phase = phase(contact_radius, wavelength);
                phase.sin() / phase.cos() * wavelength / contact_radius.pi()
            }
            _ => contact_radius.clone(),
        }
    }
}

/// √(2πℓ/a), which stays in range if the product aℓ does not.
pub(super) fn root_of_length<R: Real>(length: R, a: &R) -> R {
    let square = (length.clone() / a * a.pi()).times(2);
    let normal = square.is_finite() && square.clone() * a.unit_roundoff() > a.lit(0);
    if normal { square.sqrt() } else { a.pi().times(2).sqrt() * length.sqrt() / a.sqrt() }
}

/// πx/λ.
pub(crate) fn phase<R: Real>(x: &R, wavelength: &R) -> R {
    x.pi() * x / wavelength
}

/// Λ = ln(1 + 1/t²) = −2 ln sin(πa/λ) at t = πb/λ, without cancellation: 0 at complete contact.
pub(crate) fn openness<R: Real>(size: &R, wavelength: &R) -> R {
    let t = phase(size, wavelength);
    if t.midpoint() < t.lit(1) { t.square().ln_1p() - t.ln().times(2) } else { t.square().inv().ln_1p() }
}

/// arcosh(L/b) for b < L, without cancellation.
pub(crate) fn arcosh_ratio<R: Real>(reference: &R, b: &R) -> R {
    let excess = (reference.clone() - b) / b;
    let square = excess.clone() * (excess.clone() + excess.lit(2));
    // Where the square is beyond the range of the numbers its root is hardly more than the excess, and less than one more.
    let root = if square.is_finite() { square.sqrt() } else { excess.clone().inflate(&excess.lit(1)) };
    (excess + root).ln_1p()
}
