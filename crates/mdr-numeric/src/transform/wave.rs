//! Johnson's wave on a half-plane.

use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::Real;

use crate::medium::{WAVELENGTH, openness, phase};

/// The undeformed gap h₀(1 − cos 2πx/λ) on a [periodic](crate::medium::Medium::Periodic) medium, of h₀ from the mean to a crest (K.
/// L. Johnson, Int. J. Solids Struct. 32 (1995) 423): in the size b = (λ/π) tan(πa/λ), with t = πb/λ, s = t²/(1 + t²) and
/// Λ = −ln s, it is g = h₀s(1 + Λ), its mean h₀s.
///
/// ```
/// use mdr_core::contact::Control;
/// use mdr_numeric::{contact::Contact, folds, medium::{Adhesion, Medium}, transform::Wave};
/// // α = √(2λw/(π²h₀²E*)) = 1: the jump to complete contact is at s = 1/2, under p̄ = −p*/2 with p* = πE*h₀/λ.
/// let (waves, height) = (Medium::periodic(1.0, 1.0)?, 1e-2);
/// let work = std::f64::consts::PI.powi(2) * 1e-4 / 2.0;
/// let contact = Contact::new(Wave::new(height, 1.0)?, waves, Adhesion::new(work)?, Control::Force);
/// let pull_in = &folds::find(&contact)?[1];
/// assert!((pull_in.force / (std::f64::consts::PI * height) + 0.5).abs() < 1e-12);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Wave<R> {
    amplitude: R,
    wavelength: R,
}

impl<R: Real> Wave<R> {
    /// From h₀, half of the height from a trough to a crest, and the period λ, both in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless both are positive and finite.
    pub fn new(amplitude: R, wavelength: R) -> Result<Self> {
        let amplitude = Error::require_positive(Quantity::Parameter("the amplitude"), amplitude)?;
        Ok(Wave { amplitude, wavelength: Error::require_positive(WAVELENGTH, wavelength)? })
    }

    fn phase(&self, b: &R) -> Result<R> {
        Ok(phase(&Error::require_positive(Quantity::ContactRadius, b.clone())?, &self.wavelength))
    }

    /// s.
    fn closed(&self, b: &R) -> Result<R> {
        Ok((self.phase(b)?.square().inv() + b.lit(1)).inv())
    }

    fn representable(&self, b: &R, value: R) -> Result<R> {
        if value.is_finite() && value != value.lit(0) {
            return Ok(value);
        }
        let log10 = (phase(b, &self.wavelength).ln().times(2) + self.amplitude.ln()).approx() / std::f64::consts::LN_10;
        Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 })
    }
}

impl<R: Real> Transform<R> for Wave<R> {
    fn g(&self, b: &R) -> Result<R> {
        let above = openness(b, &self.wavelength) + b.lit(1);
        self.representable(b, self.closed(b)? * above * &self.amplitude)
    }

    /// h₀Λ ds/db = h₀Λ · 2t/(1 + t²)² · π/λ.
    fn slope(&self, b: &R) -> Result<R> {
        let t = self.phase(b)?;
        let growth = (t.square() + t.lit(1)).square().inv() * &t;
        let slope = (growth * b.pi() / &self.wavelength).times(2) * openness(b, &self.wavelength) * &self.amplitude;
        self.representable(b, slope)
    }

    /// x times the mean.
    fn integral(&self, b: &R) -> Result<R> {
        Ok(self.mean(b)? * b)
    }

    fn mean(&self, b: &R) -> Result<R> {
        self.representable(b, self.closed(b)? * &self.amplitude)
    }

    fn above_mean(&self, b: &R) -> Result<R> {
        self.representable(b, self.closed(b)? * openness(b, &self.wavelength) * &self.amplitude)
    }

    /// (h₀s)²(1 + Λ/2): without adhesion the energy per area is p*h₀s²/4, and p* = h₀ΛS.
    fn mean_square(&self, b: &R) -> Option<Result<R>> {
        let above = openness(b, &self.wavelength).over(2) + b.lit(1);
        Some(self.closed(b).and_then(|closed| self.representable(b, (closed * &self.amplitude).square() * above)))
    }

    /// h₀, and p*h₀/4 = πE*h₀²/4λ over E*.
    fn complete_contact(&self) -> Option<[R; 2]> {
        let stored = self.amplitude.square() * self.amplitude.pi() / &self.wavelength;
        Some([self.amplitude.clone(), stored.over(4)])
    }

    fn rises(&self) -> bool {
        true
    }
}
