//! The profiles of a scene as transforms, in any arithmetic.

use mdr_analytic::profiles::{
    Cone, DisplacedParaboloid, Ellipsoid, EllipticalDimple, FlatPunch, Hyperboloid, ParabolicCapCone, ParabolicDimple,
    Paraboloid, RoundedPunch, Sphere, SphericalCapCone, Sum, TruncatedCone, TruncatedParaboloid, WavyParaboloid,
};
use mdr_analytic::struve::Struve;
use mdr_analytic::{Kappa, PowerLaw};
use mdr_core::contact::{Error, Quantity, Result, Transform};
use mdr_core::number::{Literal, Special};
use mdr_numeric::transform::Quadrature;

use crate::scene::{Shape, Slope};

/// The transformed profile: a closed form where there is one, quadrature for a formula, exact pieces for a table.
///
/// Over intervals only a closed form and a table have a meaning. A quadrature takes a relative error that is `accepted` where
/// it cannot have the digits of the arithmetic.
///
/// # Errors
/// A parameter out of the domain of the profile.
pub(crate) fn transform<R: Struve + Kappa>(
    shape: &Shape,
    ctx: R::Ctx,
    accepted: Option<&R>,
) -> Result<Box<dyn Transform<R>>> {
    let n = |literal: &Literal| R::from_literal(ctx, literal);
    let t = |slope: &Slope| tangent::<R>(slope, ctx);
    Ok(match shape {
        Shape::Power { n: exponent, c } => Box::new(PowerLaw::new(n(exponent), n(c))?),
        Shape::Paraboloid { radius } => Box::new(Paraboloid::new(n(radius))?),
        Shape::Cone { slope } => Box::new(Cone::new(t(slope))?),
        Shape::Sphere { radius } => Box::new(Sphere::new(n(radius))?),
        Shape::Ellipsoid { lateral, height } => Box::new(Ellipsoid::new(n(lateral), n(height))?),
        Shape::FlatPunch { radius } => Box::new(FlatPunch::new(n(radius))?),
        Shape::TruncatedCone { slope, flat } => Box::new(TruncatedCone::new(t(slope), n(flat))?),
        Shape::TruncatedParaboloid { radius, flat } => Box::new(TruncatedParaboloid::new(n(radius), n(flat))?),
        Shape::ConeParabolicCap { slope, cap } => Box::new(ParabolicCapCone::new(t(slope), n(cap))?),
        Shape::ConeSphericalCap { slope, radius } => Box::new(SphericalCapCone::new(t(slope), n(radius))?),
        Shape::Hyperboloid { slope, lateral } => Box::new(Hyperboloid::new(t(slope), n(lateral))?),
        Shape::RoundedPunch { radius, flat } => Box::new(RoundedPunch::new(n(radius), n(flat))?),
        Shape::DisplacedParaboloid { radius, offset } => Box::new(DisplacedParaboloid::new(n(radius), n(offset))?),
        Shape::ParabolicDimple { depth, radius } => Box::new(ParabolicDimple::new(n(depth), n(radius))?),
        Shape::EllipticalDimple { depth, radius } => Box::new(EllipticalDimple::new(n(depth), n(radius))?),
        Shape::WavyParaboloid { radius, amplitude, wavelength } => {
            Box::new(WavyParaboloid::new(n(radius), n(amplitude), n(wavelength))?)
        }
        Shape::Sum(terms) => {
            let terms = terms.iter().map(|term| transform(term, ctx, accepted)).collect::<Result<_>>()?;
            Box::new(Sum::new(terms))
        }
        Shape::Expression { formula, values, breaks } => {
            let profile = formula.bind::<R>(ctx, values).map_err(|error| Error::Domain {
                quantity: Quantity::Parameter("the formula"),
                value: error.to_string(),
                requirement: "one whose names all have values",
            })?;
            let quadrature = Quadrature::new(profile.broken_at(ctx, breaks));
            match accepted {
                Some(error) => Box::new(quadrature.accepting(error.clone())?),
                None => Box::new(quadrature),
            }
        }
        Shape::Table(measured) => Box::new(measured.table().profile::<R>(ctx)?),
    })
}

/// tan θ of a flank, the cotangent of the half angle at its apex.
fn tangent<R: Special>(slope: &Slope, ctx: R::Ctx) -> R {
    match slope {
        Slope::Tangent(tangent) => R::from_literal(ctx, tangent),
        Slope::HalfAngleDegrees(degrees) => {
            let angle = R::from_literal(ctx, degrees);
            let radians = (angle.pi() * &angle).over(180);
            radians.cos() / radians.sin()
        }
    }
}
