//! The closed form of a shape by its name.

use mdr_core::contact::{Result, Shape, Transform};

use super::{
    Cone, DisplacedParaboloid, Ellipsoid, EllipticalDimple, FlatPunch, Hyperboloid, ParabolicCapCone, ParabolicDimple,
    Paraboloid, RoundedPunch, Sphere, SphericalCapCone, TruncatedCone, TruncatedParaboloid, WavyParaboloid,
};
use crate::struve::Struve;
use crate::{Kappa, PowerLaw};

/// The transformed profile g of a shape of the library, in any arithmetic.
///
/// ```
/// use mdr_analytic::profiles::closed_form;
/// use mdr_core::contact::{Flank, Shape};
/// let cone = closed_form(Shape::Cone { flank: Flank::HalfAngleDegrees(45.0) })?;
/// assert!((cone.g(&2.0)? - std::f64::consts::PI).abs() < 1e-15, "g = π/2 · a tan θ");
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`](mdr_core::contact::Error::Domain) for a parameter outside its domain.
pub fn closed_form<R: Struve + Kappa>(shape: Shape<R>) -> Result<Box<dyn Transform<R>>> {
    Ok(match shape {
        Shape::Power { n, c } => Box::new(PowerLaw::new(n, c)?),
        Shape::Paraboloid { radius } => Box::new(Paraboloid::new(radius)?),
        Shape::Cone { flank } => Box::new(Cone::new(flank.slope())?),
        Shape::Sphere { radius } => Box::new(Sphere::new(radius)?),
        Shape::Ellipsoid { lateral, height } => Box::new(Ellipsoid::new(lateral, height)?),
        Shape::FlatPunch { radius } => Box::new(FlatPunch::new(radius)?),
        Shape::TruncatedCone { flank, flat } => Box::new(TruncatedCone::new(flank.slope(), flat)?),
        Shape::TruncatedParaboloid { radius, flat } => Box::new(TruncatedParaboloid::new(radius, flat)?),
        Shape::ConeParabolicCap { flank, cap } => Box::new(ParabolicCapCone::new(flank.slope(), cap)?),
        Shape::ConeSphericalCap { flank, radius } => Box::new(SphericalCapCone::new(flank.slope(), radius)?),
        Shape::Hyperboloid { flank, lateral } => Box::new(Hyperboloid::new(flank.slope(), lateral)?),
        Shape::RoundedPunch { radius, flat } => Box::new(RoundedPunch::new(radius, flat)?),
        Shape::DisplacedParaboloid { radius, offset } => Box::new(DisplacedParaboloid::new(radius, offset)?),
        Shape::ParabolicDimple { depth, radius } => Box::new(ParabolicDimple::new(depth, radius)?),
        Shape::EllipticalDimple { depth, radius } => Box::new(EllipticalDimple::new(depth, radius)?),
        Shape::WavyParaboloid { radius, amplitude, wavelength } => {
            Box::new(WavyParaboloid::new(radius, amplitude, wavelength)?)
        }
    })
}
