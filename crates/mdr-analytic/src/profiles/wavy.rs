//! The paraboloid with concentric waves, whose contact jumps from crest to crest (figure 4 of the paper).

use mdr_core::contact::{Error, Quantity, Result};

use super::ranged::{Scale, length};
use super::{ClosedForm, Paraboloid, positive, shapes, transform};
use crate::range::representable;
use crate::struve::{Struve, small_h1};

transform!(Struve: WavyParaboloid);
shapes!(Struve {
    WavyParaboloid { radius, amplitude, wavelength } => WavyParaboloid::new(radius, amplitude, wavelength),
});

/// f = r²/2R + A(1 − cos kr), k = 2π/λ: g = x²/R + (π/2)Akx H₀(kx), with the Struve function H₀ (Guduru 2007).
///
/// With A > 0 the axis is on the crest of a wave, where contact begins; with A < 0 it is in a trough.
#[derive(Clone, Debug)]
pub struct WavyParaboloid<R> {
    paraboloid: Paraboloid<R>,
    amplitude: R,
    wavelength: R,
    /// k = 2π/λ.
    wavenumber: R,
}

impl<R: Struve> WavyParaboloid<R> {
    /// A paraboloid of curvature radius `radius` R with waves of the given `amplitude` A and `wavelength` λ.
    ///
    /// # Errors
    /// Unless R and λ are positive and finite and A is finite; [`Error::OutOfRange`] when 2π/λ is not a number.
    pub fn new(radius: R, amplitude: R, wavelength: R) -> Result<Self> {
        if !amplitude.is_finite() {
            return Err(Error::domain(Quantity::Parameter("amplitude"), &amplitude, "finite"));
        }
        let wavelength = positive("wavelength", wavelength)?;
        let two_pi = wavelength.pi().times(2);
        let wavenumber =
            representable(Quantity::Parameter("the wave number 2π/λ"), two_pi.clone() / &wavelength, || {
                two_pi.ln() - wavelength.ln()
            })?;
        Ok(WavyParaboloid { paraboloid: Paraboloid::new(radius)?, amplitude, wavelength, wavenumber })
    }

    /// (π/2)A.
    fn scale(&self) -> R {
        self.amplitude.pi().over(2) * &self.amplitude
    }
}

impl<R: Struve> ClosedForm<R> for WavyParaboloid<R> {
    fn rises(&self) -> bool {
        self.amplitude == self.amplitude.lit(0)
    }
    fn g_at(&self, x: &R) -> R {
        let z = self.wavenumber.clone() * x;
        self.paraboloid.g_at(x) + self.scale() * &z * z.struve_h0()
    }
    /// 2x/R + (π/2)Ak[H₀ + kx(2/π − H₁)].
    fn slope_at(&self, x: &R) -> R {
        let z = self.wavenumber.clone() * x;
        let [h0, h1] = z.struve();
        let wave = h0 + (z.lit(2) / z.pi() - h1) * &z;
        self.paraboloid.slope_at(x) + self.scale() * &self.wavenumber * wave
    }
    /// x²/3R + (π/2)A H₁(kx).
    fn mean_at(&self, x: &R) -> R {
        let z = self.wavenumber.clone() * x;
        let wave = match small_h1(&z) {
            // H₁ may underflow where A H₁ does not.
            Some(quotient) => self.scale() * &z * quotient,
            None => self.scale() * z.struve_h1(),
        };
        self.paraboloid.mean_at(x) + wave
    }
}

impl<R: Struve> Scale for WavyParaboloid<R> {
    fn scaled(&self, k: i64) -> Option<Self> {
        let wavelength = length(&self.wavelength, k)?;
        let flat = self.amplitude == self.amplitude.lit(0);
        Some(WavyParaboloid {
            paraboloid: self.paraboloid.scaled(k)?,
            amplitude: if flat { self.amplitude.clone() } else { length(&self.amplitude, k)? },
            wavenumber: wavelength.pi().times(2) / &wavelength,
            wavelength,
        })
    }
}
