//! The profiles of the library by their shape and parameters: as closed forms, and as heights written from the geometry.
//!
//! Parameters are in the order of the records, those of a scene: lengths and slopes as the profile has them.

use mdr_analytic::profiles as closed;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::{Lift, Real};

/// A profile of the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "named after the type in mdr_analytic::profiles")]
pub enum Shape {
    Cone,
    Paraboloid,
    Sphere,
    Ellipsoid,
    Hyperboloid,
    TruncatedCone,
    TruncatedParaboloid,
    RoundedPunch,
    ParabolicCapCone,
    SphericalCapCone,
    DisplacedParaboloid,
    ParabolicDimple,
    EllipticalDimple,
    WavyParaboloid,
    Sum,
}

impl Shape {
    /// All of them.
    pub const ALL: [Shape; 15] = [
        Shape::Cone,
        Shape::Paraboloid,
        Shape::Sphere,
        Shape::Ellipsoid,
        Shape::Hyperboloid,
        Shape::TruncatedCone,
        Shape::TruncatedParaboloid,
        Shape::RoundedPunch,
        Shape::ParabolicCapCone,
        Shape::SphericalCapCone,
        Shape::DisplacedParaboloid,
        Shape::ParabolicDimple,
        Shape::EllipticalDimple,
        Shape::WavyParaboloid,
        Shape::Sum,
    ];

    /// As scenes and records name it.
    pub fn name(self) -> &'static str {
        match self {
            Shape::Cone => "cone",
            Shape::Paraboloid => "paraboloid",
            Shape::Sphere => "sphere",
            Shape::Ellipsoid => "ellipsoid",
            Shape::Hyperboloid => "hyperboloid",
            Shape::TruncatedCone => "truncated-cone",
            Shape::TruncatedParaboloid => "truncated-paraboloid",
            Shape::RoundedPunch => "rounded-punch",
            Shape::ParabolicCapCone => "cone-parabolic-cap",
            Shape::SphericalCapCone => "cone-spherical-cap",
            Shape::DisplacedParaboloid => "displaced-paraboloid",
            Shape::ParabolicDimple => "parabolic-dimple",
            Shape::EllipticalDimple => "elliptical-dimple",
            Shape::WavyParaboloid => "wavy-paraboloid",
            Shape::Sum => "sum",
        }
    }
}

/// A profile by its heights f(r), f(0) = 0.
#[derive(Clone, Debug)]
pub(crate) struct Height<R> {
    pub(crate) shape: Shape,
    pub(crate) parameters: Vec<R>,
}

/// The closed form of a profile.
///
/// # Errors
/// Parameters out of their domain, or not as many as the shape has.
pub(crate) fn closed_form<R: Struve + Lift<R>>(shape: Shape, parameters: &[R]) -> Result<Box<dyn Transform<R>>> {
    let unknown = || {
        let value = format!("{shape:?} {parameters:?}");
        Error::Domain { quantity: Quantity::Parameter("the profile"), value, requirement: "one of the library" }
    };
    let [first, rest @ ..] = parameters else { return Err(unknown()) };
    let first = first.clone();
    Ok(match (shape, rest) {
        (Shape::Cone, []) => Box::new(closed::Cone::new(first)?),
        (Shape::Paraboloid, []) => Box::new(closed::Paraboloid::new(first)?),
        (Shape::Sphere, []) => Box::new(closed::Sphere::new(first)?),
        (Shape::Ellipsoid, [height]) => Box::new(closed::Ellipsoid::new(first, height.clone())?),
        (Shape::Hyperboloid, [lateral]) => Box::new(closed::Hyperboloid::new(first, lateral.clone())?),
        (Shape::TruncatedCone, [flat]) => Box::new(closed::TruncatedCone::new(first, flat.clone())?),
        (Shape::TruncatedParaboloid, [flat]) => Box::new(closed::TruncatedParaboloid::new(first, flat.clone())?),
        (Shape::RoundedPunch, [flat]) => Box::new(closed::RoundedPunch::new(first, flat.clone())?),
        (Shape::ParabolicCapCone, [cap]) => Box::new(closed::ParabolicCapCone::new(first, cap.clone())?),
        (Shape::SphericalCapCone, [radius]) => Box::new(closed::SphericalCapCone::new(first, radius.clone())?),
        (Shape::DisplacedParaboloid, [offset]) => Box::new(closed::DisplacedParaboloid::new(first, offset.clone())?),
        (Shape::ParabolicDimple, [radius]) => Box::new(closed::ParabolicDimple::new(first, radius.clone())?),
        (Shape::EllipticalDimple, [radius]) => Box::new(closed::EllipticalDimple::new(first, radius.clone())?),
        (Shape::WavyParaboloid, [amplitude, wavelength]) => {
            Box::new(closed::WavyParaboloid::new(first, amplitude.clone(), wavelength.clone())?)
        }
        (Shape::Sum, [slope]) => {
            let paraboloid = Box::new(closed::Paraboloid::new(first)?);
            Box::new(closed::Sum::new(vec![paraboloid, Box::new(closed::Cone::new(slope.clone())?)]))
        }
        _ => return Err(unknown()),
    })
}

impl<R: Real> Height<R> {
    fn parameter(&self, index: usize) -> &R {
        &self.parameters[index.min(self.parameters.len() - 1)]
    }

    /// Where the cap of a cone ends: Rt/√(1 + t²), where the sphere has the slope t.
    fn cap(&self) -> R {
        let (slope, radius) = (self.parameter(0), self.parameter(1));
        (slope.square() + slope.lit(1)).sqrt().inv() * slope * radius
    }
}

/// h(1 − √(1 − (r/l)²)) without cancellation.
fn spherical<S: Real>(r: &S, l: &S, h: &S) -> S {
    let s = r.clone() / l;
    let cosine = ((s.lit(1) - &s) * (s.lit(1) + &s)).sqrt();
    s.square() * h / (s.lit(1) + cosine)
}

impl<R: Real> Profile<R> for Height<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        let [p, q] = [0, 1].map(|index| S::lift(self.parameter(index)));
        let beyond = r.clone() - &q;
        let outside = beyond > r.lit(0);
        match self.shape {
            Shape::Cone => p * r,
            Shape::Paraboloid => r.square() / p.times(2),
            Shape::Sphere => spherical(r, &p, &p),
            Shape::Ellipsoid => spherical(r, &p, &q),
            Shape::Hyperboloid => p * r.square() / ((r.square() + q.square()).sqrt() + &q),
            Shape::TruncatedCone if outside => p * beyond,
            Shape::TruncatedParaboloid if outside => beyond * (r.clone() + &q) / p.times(2),
            Shape::RoundedPunch if outside => beyond.square() / p.times(2),
            Shape::ParabolicCapCone if outside => p * (r.clone() - q.over(2)),
            Shape::ParabolicCapCone => p * r.square() / q.times(2),
            Shape::SphericalCapCone => {
                let edge = S::lift(&self.cap());
                if *r > edge { spherical(&edge, &q, &q) + p * (r.clone() - &edge) } else { spherical(r, &q, &q) }
            }
            Shape::DisplacedParaboloid => (r.clone() - q.times(2)) * r / p.times(2),
            Shape::ParabolicDimple if outside => -p,
            Shape::ParabolicDimple => -(r.square() / q.square() * p),
            Shape::EllipticalDimple => -spherical(r, &q, &p),
            Shape::WavyParaboloid => {
                let phase = r.pi() * r / S::lift(self.parameter(2));
                r.square() / p.times(2) + (phase.sin().square() * q).times(2)
            }
            Shape::Sum => r.square() / p.times(2) + q * r,
            Shape::TruncatedCone | Shape::TruncatedParaboloid | Shape::RoundedPunch => r.lit(0),
        }
    }

    fn kinks(&self) -> Vec<R> {
        match self.shape {
            Shape::TruncatedCone
            | Shape::TruncatedParaboloid
            | Shape::RoundedPunch
            | Shape::ParabolicCapCone
            | Shape::ParabolicDimple => {
                vec![self.parameter(1).clone()]
            }
            Shape::SphericalCapCone => vec![self.cap()],
            _ => Vec::new(),
        }
    }

    fn outer_radius(&self) -> Option<R> {
        match self.shape {
            Shape::Sphere | Shape::Ellipsoid => Some(self.parameter(0).clone()),
            Shape::EllipticalDimple => Some(self.parameter(1).clone()),
            _ => None,
        }
    }

    fn tip_exponent(&self) -> Option<R> {
        let exponent = match self.shape {
            Shape::Cone | Shape::DisplacedParaboloid | Shape::Sum => 1,
            Shape::TruncatedCone | Shape::TruncatedParaboloid | Shape::RoundedPunch => return None,
            _ => 2,
        };
        Some(self.parameter(0).lit(exponent))
    }
}
