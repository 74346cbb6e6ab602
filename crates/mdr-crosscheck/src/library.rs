//! The profiles of the library by their shape and parameters: as closed forms, and as heights written from the geometry.
//!
//! Parameters are in the order of the records, those of a scene: lengths and slopes as the profile has them.

use mdr_analytic::profiles as closed;
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::{Lift, Real};

/// The shapes: variant, name in scenes and records, and how its parameters make a closed form.
macro_rules! shapes {
    ($($shape:ident $name:literal ($($parameter:ident),+) => $new:expr;)*) => {
        /// A profile of the library.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[expect(missing_docs, reason = "named after the type in mdr_analytic::profiles")]
        pub enum Shape {
            $($shape,)*
        }

        impl Shape {
            /// All of them.
            pub const ALL: [Shape; { [$($name),*].len() }] = [$(Shape::$shape),*];

            /// As scenes and records name it.
            pub fn name(self) -> &'static str {
                match self {
                    $(Shape::$shape => $name,)*
                }
            }

            /// The public constructor of its closed form.
            pub(crate) fn constructor(self) -> &'static str {
                match self {
                    $(Shape::$shape => concat!(stringify!($shape), "::new"),)*
                }
            }
        }

        /// The closed form of a profile.
        ///
        /// # Errors
        /// Parameters out of their domain, or not as many as the shape has.
        pub(crate) fn closed_form<R: Struve + Lift<R>>(shape: Shape, parameters: &[R]) -> Result<Box<dyn Transform<R>>> {
            match (shape, parameters) {
                $((Shape::$shape, [$($parameter),+]) => {
                    $(let $parameter = $parameter.clone();)+
                    Ok(Box::new($new?))
                })*
                (shape, parameters) => {
                    let value = format!("{shape:?} {parameters:?}");
                    let quantity = Quantity::Parameter("the profile");
                    Err(Error::Domain { quantity, value, requirement: "one of the library" })
                }
            }
        }
    };
}

shapes! {
    Cone "cone" (slope) => closed::Cone::new(slope);
    Paraboloid "paraboloid" (radius) => closed::Paraboloid::new(radius);
    Sphere "sphere" (radius) => closed::Sphere::new(radius);
    Ellipsoid "ellipsoid" (lateral, height) => closed::Ellipsoid::new(lateral, height);
    Hyperboloid "hyperboloid" (slope, lateral) => closed::Hyperboloid::new(slope, lateral);
    TruncatedCone "truncated-cone" (slope, flat) => closed::TruncatedCone::new(slope, flat);
    TruncatedParaboloid "truncated-paraboloid" (radius, flat) => closed::TruncatedParaboloid::new(radius, flat);
    RoundedPunch "rounded-punch" (radius, flat) => closed::RoundedPunch::new(radius, flat);
    ParabolicCapCone "cone-parabolic-cap" (slope, cap) => closed::ParabolicCapCone::new(slope, cap);
    SphericalCapCone "cone-spherical-cap" (slope, radius) => closed::SphericalCapCone::new(slope, radius);
    DisplacedParaboloid "displaced-paraboloid" (radius, offset) => closed::DisplacedParaboloid::new(radius, offset);
    ParabolicDimple "parabolic-dimple" (depth, radius) => closed::ParabolicDimple::new(depth, radius);
    EllipticalDimple "elliptical-dimple" (depth, radius) => closed::EllipticalDimple::new(depth, radius);
    WavyParaboloid "wavy-paraboloid" (radius, amplitude, wavelength) =>
        closed::WavyParaboloid::new(radius, amplitude, wavelength);
    Sum "sum" (radius, slope) => sum(radius, slope);
}

/// A paraboloid and a cone.
fn sum<R: Struve + Lift<R>>(radius: R, slope: R) -> Result<closed::Sum<R>> {
    let paraboloid: Box<dyn Transform<R>> = Box::new(closed::Paraboloid::new(radius)?);
    Ok(closed::Sum::new(vec![paraboloid, Box::new(closed::Cone::new(slope)?)]))
}

/// A profile by its heights f(r), f(0) = 0.
#[derive(Clone, Debug)]
pub(crate) struct Height<R> {
    pub(crate) shape: Shape,
    pub(crate) parameters: Vec<R>,
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
