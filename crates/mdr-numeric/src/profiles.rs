//! Profiles as heights f(r), the input of the quadrature.
//!
//! Every height is written without cancellation near the tip and with ratios of lengths only, so that it is accurate at
//! any scale.

mod heights;

use mdr_core::contact::{Error, Profile, Quantity, Result};
use mdr_core::number::{Lift, Real};

pub use self::heights::Heights;

/// f = C rⁿ with n, C > 0: the family of the paper, (1.11).
///
/// ```
/// use mdr_core::contact::Profile;
/// let f = mdr_numeric::profiles::Power::new(3.0, 2.0)?;
/// assert_eq!(f.height(&2.0), 16.0);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Power<R> {
    exponent: R,
    coefficient: R,
}

impl<R: Real> Power<R> {
    /// From the exponent n and the coefficient C (m^(1−n)).
    ///
    /// # Errors
    /// [`Error::Domain`] unless both are positive and finite.
    pub fn new(exponent: R, coefficient: R) -> Result<Self> {
        Ok(Power {
            exponent: Error::require_positive(Quantity::Exponent, exponent)?,
            coefficient: Error::require_positive(Quantity::Coefficient, coefficient)?,
        })
    }
}

impl<R: Real> Profile<R> for Power<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        power(r, &self.exponent, &self.coefficient)
    }

    fn tip_exponent(&self) -> Option<R> {
        Some(self.exponent.clone())
    }
}

/// f = r tanθ: the cone.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone<R> {
    slope: R,
}

impl<R: Real> Cone<R> {
    /// From the slope tanθ of the generator against the plane.
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn new(slope: R) -> Result<Self> {
        Ok(Cone { slope: Error::require_positive(Quantity::Parameter("the slope of the cone"), slope)? })
    }
}

impl<R: Real> Profile<R> for Cone<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        S::lift(&self.slope) * r
    }

    fn tip_exponent(&self) -> Option<R> {
        Some(self.slope.lit(1))
    }
}

/// f = r²/2R: the paraboloid of the JKR theory.
#[derive(Clone, Debug, PartialEq)]
pub struct Paraboloid<R> {
    radius: R,
}

impl<R: Real> Paraboloid<R> {
    /// From the radius of curvature R (m).
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn new(radius: R) -> Result<Self> {
        Ok(Paraboloid { radius: radius_of_curvature(radius)? })
    }
}

impl<R: Real> Profile<R> for Paraboloid<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        parabola(r, &self.radius)
    }

    fn tip_exponent(&self) -> Option<R> {
        Some(self.radius.lit(2))
    }
}

/// f = R − √(R² − r²): the true sphere, up to its equator.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere<R> {
    radius: R,
}

impl<R: Real> Sphere<R> {
    /// From the radius R (m).
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn new(radius: R) -> Result<Self> {
        Ok(Sphere { radius: radius_of_curvature(radius)? })
    }
}

impl<R: Real> Profile<R> for Sphere<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        spherical(r, &self.radius, &self.radius)
    }

    fn outer_radius(&self) -> Option<R> {
        Some(self.radius.clone())
    }

    fn tip_exponent(&self) -> Option<R> {
        Some(self.radius.lit(2))
    }
}

/// f = 0 up to a vertical edge at r = b: the flat punch.
#[derive(Clone, Debug, PartialEq)]
pub struct FlatPunch<R> {
    radius: R,
}

impl<R: Real> FlatPunch<R> {
    /// From the radius b of the flat face (m).
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn new(radius: R) -> Result<Self> {
        Ok(FlatPunch { radius: Error::require_positive(Quantity::Parameter("the radius of the flat face"), radius)? })
    }
}

impl<R: Real> Profile<R> for FlatPunch<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        r.lit(0)
    }

    fn outer_radius(&self) -> Option<R> {
        Some(self.radius.clone())
    }

    fn wall(&self) -> bool {
        true
    }
}

/// f = (r−b)²/2R for r > b, else 0: the flat punch with a rounded edge.
#[derive(Clone, Debug, PartialEq)]
pub struct RoundedPunch<R> {
    radius: R,
    flat: R,
}

impl<R: Real> RoundedPunch<R> {
    /// From the radius R of the rounding and the radius b of the flat face (m).
    ///
    /// # Errors
    /// [`Error::Domain`] unless both are positive and finite.
    pub fn new(radius: R, flat: R) -> Result<Self> {
        Ok(RoundedPunch {
            radius: radius_of_curvature(radius)?,
            flat: Error::require_positive(Quantity::Parameter("the radius of the flat face"), flat)?,
        })
    }
}

impl<R: Real> Profile<R> for RoundedPunch<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        let beyond = r.clone() - S::lift(&self.flat);
        if beyond > r.lit(0) { parabola(&beyond, &self.radius) } else { r.lit(0) }
    }

    fn kinks(&self) -> Vec<R> {
        vec![self.flat.clone()]
    }
}

/// f = r²/2R + A(1 − cos 2πr/λ): Guduru's wavy paraboloid (J. Mech. Phys. Solids 55 (2007) 445), figure 4 of the paper.
#[derive(Clone, Debug, PartialEq)]
pub struct WavyParaboloid<R> {
    radius: R,
    amplitude: R,
    wavelength: R,
}

impl<R: Real> WavyParaboloid<R> {
    /// From the radius R of the paraboloid, the amplitude A of the waves and their length λ (m).
    ///
    /// # Errors
    /// [`Error::Domain`] unless R and λ are positive and finite and A is finite. With A > 0 the body has the crest of a wave
    /// on its axis, with A < 0 a trough.
    pub fn new(radius: R, amplitude: R, wavelength: R) -> Result<Self> {
        if !amplitude.is_finite() {
            return Err(Error::domain(Quantity::Parameter("the amplitude of the waves"), &amplitude, "finite"));
        }
        Ok(WavyParaboloid {
            radius: radius_of_curvature(radius)?,
            amplitude,
            wavelength: Error::require_positive(Quantity::Parameter("the wavelength"), wavelength)?,
        })
    }
}

impl<R: Real> Profile<R> for WavyParaboloid<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        parabola(r, &self.radius) + waves(r, &self.amplitude, &self.wavelength)
    }

    fn tip_exponent(&self) -> Option<R> {
        Some(self.radius.lit(2))
    }
}

fn radius_of_curvature<R: Real>(radius: R) -> Result<R> {
    Error::require_positive(Quantity::Parameter("the radius of curvature"), radius)
}

/// r²/2R, by the ratio r/R.
fn parabola<R: Real, S: Lift<R>>(r: &S, radius: &R) -> S {
    (r.clone() / S::lift(radius) * r).over(2)
}

/// C rⁿ.
fn power<R: Real, S: Lift<R>>(r: &S, exponent: &R, coefficient: &R) -> S {
    let (n, c) = (S::lift(exponent), S::lift(coefficient));
    let power = r.pow(&n);
    let headroom = power.unit_roundoff().square();
    let normal = power.is_finite() && power.clone() * headroom > power.lit(0);
    if normal {
        return power * c;
    }
    // C rⁿ may be in range where rⁿ is not.
    let root = r.pow(&n.over(2));
    root.clone() * c * root
}

/// h(1 − √(1 − s²)) with s = r/b, as h s²/(1 + √((1−s)(1+s))).
fn spherical<R: Real, S: Lift<R>>(r: &S, lateral: &R, height: &R) -> S {
    let s = r.clone() / S::lift(lateral);
    let one = s.lit(1);
    let cosine = ((one.clone() - &s) * (one.clone() + &s)).sqrt();
    s.square() * S::lift(height) / (one + cosine)
}

/// A(1 − cos 2πr/λ) = 2A sin²(πr/λ), which keeps its digits near the tip.
fn waves<R: Real, S: Lift<R>>(r: &S, amplitude: &R, wavelength: &R) -> S {
    let half_phase = r.clone() / S::lift(wavelength) * r.pi();
    (half_phase.sin().square() * S::lift(amplitude)).times(2)
}
