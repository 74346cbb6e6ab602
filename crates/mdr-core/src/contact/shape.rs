//! The profiles of the library by name, with parameters of any type.

use crate::number::Special;

/// A profile f(r) of the library with parameters of type `N`: [`Literal`](crate::number::Literal)s in a scene, numbers of an
/// arithmetic in a formula. Lengths are in metres.
///
/// The formulas of f are in the numeric crate, the transforms g in the analytic crate.
///
/// ```
/// use mdr_core::contact::Shape;
/// let tip = Shape::RoundedPunch { radius: 2.0, flat: 0.5 };
/// assert_eq!(tip.name(), "rounded-punch");
/// let millimetres = tip.map(|_, length| 1e3 * length);
/// assert_eq!(millimetres, Shape::RoundedPunch { radius: 2e3, flat: 0.5e3 });
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Shape<N> {
    /// f = C rⁿ, the family of the paper (1.11).
    Power {
        /// n.
        n: N,
        /// C, in m^(1−n).
        c: N,
    },
    /// f = r²/2R, the profile of the JKR theory.
    Paraboloid {
        /// R, the radius of curvature.
        radius: N,
    },
    /// f = r tan θ.
    Cone {
        /// The steepness.
        flank: Flank<N>,
    },
    /// f = R − √(R² − r²), up to the equator.
    Sphere {
        /// R.
        radius: N,
    },
    /// f = h (1 − √(1 − r²/b²)), up to the equator.
    Ellipsoid {
        /// The half axis b in the plane of contact.
        lateral: N,
        /// The half axis h across it.
        height: N,
    },
    /// A flat face with a vertical edge.
    FlatPunch {
        /// The radius of the face.
        radius: N,
    },
    /// A cone with a flat face instead of its tip.
    TruncatedCone {
        /// The steepness.
        flank: Flank<N>,
        /// The radius of the face.
        flat: N,
    },
    /// A paraboloid with a flat face instead of its tip.
    TruncatedParaboloid {
        /// The radius of curvature.
        radius: N,
        /// The radius of the face.
        flat: N,
    },
    /// A cone that begins as a paraboloid, with one slope where they meet.
    ConeParabolicCap {
        /// The steepness.
        flank: Flank<N>,
        /// The radius where they meet.
        cap: N,
    },
    /// A cone that begins as a sphere, with one slope where they meet.
    ConeSphericalCap {
        /// The steepness.
        flank: Flank<N>,
        /// The radius of the sphere.
        radius: N,
    },
    /// A hyperboloid of revolution.
    Hyperboloid {
        /// The steepness of the asymptote.
        flank: Flank<N>,
        /// The half axis in the plane of contact.
        lateral: N,
    },
    /// A flat face with a parabolic rounding around it.
    RoundedPunch {
        /// The radius of curvature of the rounding.
        radius: N,
        /// The radius of the face.
        flat: N,
    },
    /// A parabola with its vertex beside the axis: f = r²/2R − b r/R.
    DisplacedParaboloid {
        /// The radius of curvature R.
        radius: N,
        /// b, the distance of the vertex from the axis.
        offset: N,
    },
    /// A parabolic dimple in a flat face.
    ParabolicDimple {
        /// Its depth.
        depth: N,
        /// Its radius.
        radius: N,
    },
    /// An elliptical dimple in a flat face.
    EllipticalDimple {
        /// Its depth.
        depth: N,
        /// Its radius.
        radius: N,
    },
    /// f = r²/2R + A (1 − cos 2πr/λ), figure 4 of the paper.
    WavyParaboloid {
        /// R, the radius of curvature.
        radius: N,
        /// A, of either sign.
        amplitude: N,
        /// λ.
        wavelength: N,
    },
}

/// The slope of a cone, as the user gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum Flank<N> {
    /// tan θ, the slope against the plane of contact.
    Slope(N),
    /// Half the angle at the apex, in degrees: the slope is its cotangent.
    HalfAngleDegrees(N),
}

impl<N> Flank<N> {
    /// The key in a scene, and the number given for it.
    pub fn parameter(&self) -> (&'static str, &N) {
        match self {
            Flank::Slope(slope) => ("slope", slope),
            Flank::HalfAngleDegrees(angle) => ("half_angle_degrees", angle),
        }
    }

    /// tan θ: for half the angle α at the apex, cos α/sin α.
    pub fn slope(&self) -> N
    where
        N: Special,
    {
        match self {
            Flank::Slope(slope) => slope.clone(),
            Flank::HalfAngleDegrees(degrees) => {
                let radians = (degrees.pi() * degrees).over(180);
                radians.cos() / radians.sin()
            }
        }
    }

    fn try_map<M, E>(&self, f: &mut impl FnMut(&'static str, &N) -> Result<M, E>) -> Result<Flank<M>, E> {
        let (key, number) = self.parameter();
        let number = f(key, number)?;
        Ok(match self {
            Flank::Slope(_) => Flank::Slope(number),
            Flank::HalfAngleDegrees(_) => Flank::HalfAngleDegrees(number),
        })
    }
}

/// Every name with a shape of that name.
const NAMES: [(&str, Shape<()>); 16] = [
    ("power", Shape::Power { n: (), c: () }),
    ("paraboloid", Shape::Paraboloid { radius: () }),
    ("cone", Shape::Cone { flank: Flank::Slope(()) }),
    ("sphere", Shape::Sphere { radius: () }),
    ("ellipsoid", Shape::Ellipsoid { lateral: (), height: () }),
    ("flat-punch", Shape::FlatPunch { radius: () }),
    ("truncated-cone", Shape::TruncatedCone { flank: Flank::Slope(()), flat: () }),
    ("truncated-paraboloid", Shape::TruncatedParaboloid { radius: (), flat: () }),
    ("cone-parabolic-cap", Shape::ConeParabolicCap { flank: Flank::Slope(()), cap: () }),
    ("cone-spherical-cap", Shape::ConeSphericalCap { flank: Flank::Slope(()), radius: () }),
    ("hyperboloid", Shape::Hyperboloid { flank: Flank::Slope(()), lateral: () }),
    ("rounded-punch", Shape::RoundedPunch { radius: (), flat: () }),
    ("displaced-paraboloid", Shape::DisplacedParaboloid { radius: (), offset: () }),
    ("parabolic-dimple", Shape::ParabolicDimple { depth: (), radius: () }),
    ("elliptical-dimple", Shape::EllipticalDimple { depth: (), radius: () }),
    ("wavy-paraboloid", Shape::WavyParaboloid { radius: (), amplitude: (), wavelength: () }),
];

impl Shape<()> {
    /// All names of shapes, as scenes and records use them.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.iter().map(|(name, _)| *name)
    }

    /// The shape with this name, without parameters; cones by their slope.
    pub fn by_name(name: &str) -> Option<&'static Shape<()>> {
        NAMES.iter().find(|(known, _)| *known == name).map(|(_, shape)| shape)
    }
}

impl<N> Shape<N> {
    /// The radius of curvature of its spherical or parabolic part, where it has one.
    pub fn curvature_radius(&self) -> Option<&N> {
        match self {
            Shape::Paraboloid { radius }
            | Shape::Sphere { radius }
            | Shape::TruncatedParaboloid { radius, .. }
            | Shape::ConeSphericalCap { radius, .. }
            | Shape::RoundedPunch { radius, .. }
            | Shape::DisplacedParaboloid { radius, .. }
            | Shape::WavyParaboloid { radius, .. } => Some(radius),
            _ => None,
        }
    }

    /// The name in scenes and records: `rounded-punch`.
    pub fn name(&self) -> &'static str {
        let blank = self.map(|_, _| ());
        let same = |(_, shape): &&(&str, Shape<()>)| std::mem::discriminant(shape) == std::mem::discriminant(&blank);
        NAMES.iter().find(same).map_or("", |(name, _)| name)
    }

    /// The parameters with their keys in a scene.
    pub fn parameters(&self) -> Vec<(&'static str, &N)> {
        match self {
            Shape::Power { n, c } => vec![("n", n), ("c", c)],
            Shape::Paraboloid { radius } | Shape::Sphere { radius } | Shape::FlatPunch { radius } => {
                vec![("radius", radius)]
            }
            Shape::Cone { flank } => vec![flank.parameter()],
            Shape::Ellipsoid { lateral, height } => vec![("lateral", lateral), ("height", height)],
            Shape::TruncatedCone { flank, flat } => vec![flank.parameter(), ("flat", flat)],
            Shape::TruncatedParaboloid { radius, flat } | Shape::RoundedPunch { radius, flat } => {
                vec![("radius", radius), ("flat", flat)]
            }
            Shape::ConeParabolicCap { flank, cap } => vec![flank.parameter(), ("cap", cap)],
            Shape::ConeSphericalCap { flank, radius } => vec![flank.parameter(), ("radius", radius)],
            Shape::Hyperboloid { flank, lateral } => vec![flank.parameter(), ("lateral", lateral)],
            Shape::DisplacedParaboloid { radius, offset } => vec![("radius", radius), ("offset", offset)],
            Shape::ParabolicDimple { depth, radius } | Shape::EllipticalDimple { depth, radius } => {
                vec![("depth", depth), ("radius", radius)]
            }
            Shape::WavyParaboloid { radius, amplitude, wavelength } => {
                vec![("radius", radius), ("amplitude", amplitude), ("wavelength", wavelength)]
            }
        }
    }

    /// The same shape with other parameters; `f` gets each with its key, in the order of [`Shape::parameters`].
    pub fn map<M>(&self, mut f: impl FnMut(&'static str, &N) -> M) -> Shape<M> {
        let Ok(shape) = self.try_map(|key, number| Ok::<M, std::convert::Infallible>(f(key, number)));
        shape
    }

    /// The steepness of a cone, for modification.
    pub fn flank_mut(&mut self) -> Option<&mut Flank<N>> {
        match self {
            Shape::Cone { flank }
            | Shape::TruncatedCone { flank, .. }
            | Shape::ConeParabolicCap { flank, .. }
            | Shape::ConeSphericalCap { flank, .. }
            | Shape::Hyperboloid { flank, .. } => Some(flank),
            _ => None,
        }
    }

    /// As [`Shape::map`], where `f` may fail.
    ///
    /// # Errors
    /// The first error of `f`.
    pub fn try_map<M, E>(&self, mut f: impl FnMut(&'static str, &N) -> Result<M, E>) -> Result<Shape<M>, E> {
        Ok(match self {
            Shape::Power { n, c } => Shape::Power { n: f("n", n)?, c: f("c", c)? },
            Shape::Paraboloid { radius } => Shape::Paraboloid { radius: f("radius", radius)? },
            Shape::Cone { flank } => Shape::Cone { flank: flank.try_map(&mut f)? },
            Shape::Sphere { radius } => Shape::Sphere { radius: f("radius", radius)? },
            Shape::Ellipsoid { lateral, height } => {
                Shape::Ellipsoid { lateral: f("lateral", lateral)?, height: f("height", height)? }
            }
            Shape::FlatPunch { radius } => Shape::FlatPunch { radius: f("radius", radius)? },
            Shape::TruncatedCone { flank, flat } => {
                Shape::TruncatedCone { flank: flank.try_map(&mut f)?, flat: f("flat", flat)? }
            }
            Shape::TruncatedParaboloid { radius, flat } => {
                Shape::TruncatedParaboloid { radius: f("radius", radius)?, flat: f("flat", flat)? }
            }
            Shape::ConeParabolicCap { flank, cap } => {
                Shape::ConeParabolicCap { flank: flank.try_map(&mut f)?, cap: f("cap", cap)? }
            }
            Shape::ConeSphericalCap { flank, radius } => {
                Shape::ConeSphericalCap { flank: flank.try_map(&mut f)?, radius: f("radius", radius)? }
            }
            Shape::Hyperboloid { flank, lateral } => {
                Shape::Hyperboloid { flank: flank.try_map(&mut f)?, lateral: f("lateral", lateral)? }
            }
            Shape::RoundedPunch { radius, flat } => {
                Shape::RoundedPunch { radius: f("radius", radius)?, flat: f("flat", flat)? }
            }
            Shape::DisplacedParaboloid { radius, offset } => {
                Shape::DisplacedParaboloid { radius: f("radius", radius)?, offset: f("offset", offset)? }
            }
            Shape::ParabolicDimple { depth, radius } => {
                Shape::ParabolicDimple { depth: f("depth", depth)?, radius: f("radius", radius)? }
            }
            Shape::EllipticalDimple { depth, radius } => {
                Shape::EllipticalDimple { depth: f("depth", depth)?, radius: f("radius", radius)? }
            }
            Shape::WavyParaboloid { radius, amplitude, wavelength } => Shape::WavyParaboloid {
                radius: f("radius", radius)?,
                amplitude: f("amplitude", amplitude)?,
                wavelength: f("wavelength", wavelength)?,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_that_of_its_shape_and_its_keys_are_mapped_in_their_order() {
        for name in Shape::names() {
            let shape = Shape::by_name(name).unwrap();
            assert_eq!(shape.name(), name);
            let mut keys = Vec::new();
            let mapped = shape.map(|key, ()| {
                keys.push(key);
                keys.len()
            });
            let parameters = mapped.parameters();
            assert_eq!(parameters.iter().map(|(key, _)| *key).collect::<Vec<_>>(), keys);
            assert!(parameters.iter().map(|(_, place)| **place).eq(1..=keys.len()), "{name}");
        }
    }
}
