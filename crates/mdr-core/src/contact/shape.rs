//! The profiles of the library by name, with parameters of any type.

use crate::number::{Real, Special};
use crate::units::SiUnit;

/// Declares the shapes: names, parameters in their order, each a number `N` with its unit or a [`Flank`] of one and with the symbol
/// that stands for it in the formula, and that formula, in which a flank is its slope.
macro_rules! shapes {
    (@flank N $field:ident) => {{
        let _ = $field;
        None
    }};
    (@flank Flank $field:ident) => { Some($field) };
    (@blank N) => { () };
    (@blank Flank) => { Flank::Slope(()) };
    (@parameter N $field:ident) => { (stringify!($field), $field) };
    (@parameter Flank $field:ident) => { $field.parameter() };
    (@unit N $field:ident $unit:ident) => {{
        let _ = $field;
        (stringify!($field), SiUnit::$unit)
    }};
    (@unit Flank $field:ident) => { ($field.parameter().0, $field.unit()) };
    (@map N $field:ident $f:ident) => { $f(stringify!($field), $field)? };
    (@map Flank $field:ident $f:ident) => { $field.try_map(&mut $f)? };
    ($(#[$meta:meta])* {$(
        $(#[$doc:meta])* $shape:ident = $name:literal {
            $($(#[$field_doc:meta])* $field:ident: $kind:ident $(<$of:ident>)? as $symbol:literal $(in $unit:ident)?,)*
        } is $formula:literal,
    )*}) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        pub enum Shape<N> {$(
            $(#[$doc])*
            #[doc = concat!("\n\nf = `", $formula, "`.")]
            $shape { $(#[doc = concat!($symbol, ": ")] $(#[$field_doc])* $field: $kind$(<$of>)?,)* },
        )*}

        /// Every shape without its parameters.
        const BLANK: &[Shape<()>] = &[$(Shape::$shape { $($field: shapes!(@blank $kind),)* },)*];

        impl<N> Shape<N> {
            /// The name in scenes and records: `rounded-punch`.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Shape::$shape { .. } => $name,)*
                }
            }

            /// The height f(r) as an [`Expression`](crate::contact::Expression) of the [symbols](Shape::symbols); t is the slope
            /// of a cone, whichever way its steepness is given.
            pub fn text(&self) -> &'static str {
                match self {
                    $(Shape::$shape { .. } => $formula,)*
                }
            }

            /// The symbols that stand for the parameters in [`Shape::text`], in the order of [`Shape::parameters`].
            pub fn symbols(&self) -> &'static [&'static str] {
                match self {
                    $(Shape::$shape { .. } => &[$($symbol),*],)*
                }
            }

            /// The steepness of a cone.
            pub fn flank(&self) -> Option<&Flank<N>> {
                match self {
                    $(Shape::$shape { $($field,)* } => [$(shapes!(@flank $kind $field),)*].into_iter().flatten().next(),)*
                }
            }

            /// The steepness of a cone, for modification.
            pub fn flank_mut(&mut self) -> Option<&mut Flank<N>> {
                match self {
                    $(Shape::$shape { $($field,)* } => [$(shapes!(@flank $kind $field),)*].into_iter().flatten().next(),)*
                }
            }

            /// The parameters with their keys in a scene.
            pub fn parameters(&self) -> Vec<(&'static str, &N)> {
                match self {
                    $(Shape::$shape { $($field,)* } => vec![$(shapes!(@parameter $kind $field),)*],)*
                }
            }

            /// The unit of each parameter with its key, in the order of [`Shape::parameters`].
            pub fn units(&self) -> Vec<(&'static str, SiUnit)> {
                match self {
                    $(Shape::$shape { $($field,)* } => vec![$(shapes!(@unit $kind $field $($unit)?),)*],)*
                }
            }

            /// The shape with other parameters, where `f`, which gets each with its key, may fail.
            ///
            /// # Errors
            /// The first error of `f`.
            pub fn try_map<M, E>(&self, mut f: impl FnMut(&'static str, &N) -> Result<M, E>) -> Result<Shape<M>, E> {
                Ok(match self {
                    $(Shape::$shape { $($field,)* } => Shape::$shape { $($field: shapes!(@map $kind $field f),)* },)*
                })
            }
        }
    };
}

shapes! {
    /// A profile f(r) of the library with parameters of type `N`: [`Literal`](crate::number::Literal)s in a scene, numbers of an
    /// arithmetic in a formula. Lengths are in metres, and heights count from the tip, outward: f(0) = 0.
    ///
    /// Formulas are written as an [`Expression`](crate::contact::Expression). The heights f without cancellation are in the numeric
    /// crate, the transforms g in the analytic crate.
    ///
    /// ```
    /// use mdr_core::contact::Shape;
    /// let tip = Shape::RoundedPunch { radius: 2.0, flat: 0.5 };
    /// assert_eq!(tip.name(), "rounded-punch");
    /// let millimetres = tip.map(|_, length| 1e3 * length);
    /// assert_eq!(millimetres, Shape::RoundedPunch { radius: 2e3, flat: 0.5e3 });
    /// ```
    {
        /// The family of the paper (1.11).
        Power = "power" {
            /// the exponent.
            n: N as "n" in One,
            /// the coefficient, in m^(1−n).
            c: N as "C" in Coefficient,
        } is "C*r^n",
        /// The profile of the JKR theory.
        Paraboloid = "paraboloid" {
            /// the radius of curvature.
            radius: N as "R" in Metre,
        } is "r^2/(2*R)",
        /// A cone.
        Cone = "cone" {
            /// the slope tan θ.
            flank: Flank<N> as "t",
        } is "t*r",
        /// A sphere, up to the equator.
        Sphere = "sphere" {
            /// the radius.
            radius: N as "R" in Metre,
        } is "R - sqrt(R^2 - r^2)",
        /// An ellipsoid of revolution, up to the equator.
        Ellipsoid = "ellipsoid" {
            /// the half axis in the plane of contact.
            lateral: N as "b" in Metre,
            /// the half axis across it.
            height: N as "h" in Metre,
        } is "h*(1 - sqrt(1 - r^2/b^2))",
        /// A flat face with a vertical edge at b.
        FlatPunch = "flat-punch" {
            /// the radius of the face.
            radius: N as "b" in Metre,
        } is "0",
        /// A cone with a flat face instead of its tip.
        TruncatedCone = "truncated-cone" {
            /// the slope tan θ.
            flank: Flank<N> as "t",
            /// the radius of the face.
            flat: N as "b" in Metre,
        } is "t*max(r - b, 0)",
        /// A paraboloid with a flat face instead of its tip.
        TruncatedParaboloid = "truncated-paraboloid" {
            /// the radius of curvature.
            radius: N as "R" in Metre,
            /// the radius of the face.
            flat: N as "b" in Metre,
        } is "max(r^2 - b^2, 0)/(2*R)",
        /// A cone that begins as a paraboloid, with one slope where they meet.
        ConeParabolicCap = "cone-parabolic-cap" {
            /// the slope tan θ.
            flank: Flank<N> as "t",
            /// the radius where they meet.
            cap: N as "b" in Metre,
        } is "t*min(r, b)^2/(2*b) + t*max(r - b, 0)",
        /// A cone that begins as a sphere, with one slope where they meet.
        ConeSphericalCap = "cone-spherical-cap" {
            /// the slope tan θ.
            flank: Flank<N> as "t",
            /// the radius of the sphere.
            radius: N as "R" in Metre,
        } is "R - sqrt(R^2 - min(r, R*t/sqrt(1 + t^2))^2) + t*max(r - R*t/sqrt(1 + t^2), 0)",
        /// A hyperboloid of revolution.
        Hyperboloid = "hyperboloid" {
            /// the slope tan θ of the asymptote.
            flank: Flank<N> as "t",
            /// the half axis in the plane of contact.
            lateral: N as "b" in Metre,
        } is "t*(sqrt(r^2 + b^2) - b)",
        /// A flat face with a parabolic rounding around it.
        RoundedPunch = "rounded-punch" {
            /// the radius of curvature of the rounding.
            radius: N as "R" in Metre,
            /// the radius of the face.
            flat: N as "b" in Metre,
        } is "max(r - b, 0)^2/(2*R)",
        /// A parabola with its vertex beside the axis. The vertex is a ridge, b²/2R below the tip.
        DisplacedParaboloid = "displaced-paraboloid" {
            /// the radius of curvature.
            radius: N as "R" in Metre,
            /// the distance of the vertex from the axis.
            offset: N as "b" in Metre,
        } is "(r^2 - 2*b*r)/(2*R)",
        /// A parabolic dimple in a flat face, which is h below the tip.
        ParabolicDimple = "parabolic-dimple" {
            /// its depth.
            depth: N as "h" in Metre,
            /// its radius.
            radius: N as "b" in Metre,
        } is "-h*min(r, b)^2/b^2",
        /// An elliptical dimple in a flat face, which is h below the tip. Heights are known up to b, where g is −∞.
        EllipticalDimple = "elliptical-dimple" {
            /// its depth.
            depth: N as "h" in Metre,
            /// its radius.
            radius: N as "b" in Metre,
        } is "h*(sqrt(1 - min(r, b)^2/b^2) - 1)",
        /// A paraboloid with a wave, figure 4 of the paper.
        WavyParaboloid = "wavy-paraboloid" {
            /// the radius of curvature.
            radius: N as "R" in Metre,
            /// the amplitude, of either sign.
            amplitude: N as "A" in Metre,
            /// the wavelength λ.
            wavelength: N as "L" in Metre,
        } is "r^2/(2*R) + A*(1 - cos(2*pi*r/L))",
    }
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

    /// That of its number.
    pub fn unit(&self) -> SiUnit {
        match self {
            Flank::Slope(_) => SiUnit::One,
            Flank::HalfAngleDegrees(_) => SiUnit::Degree,
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

impl Shape<()> {
    /// All names of shapes, as scenes and records use them.
    pub fn names() -> impl Iterator<Item = &'static str> {
        BLANK.iter().map(Shape::name)
    }

    /// The unit of the parameter that has this key in some shape: a key has one unit in all of them.
    pub fn unit_of_key(key: &str) -> Option<SiUnit> {
        let angle = Flank::HalfAngleDegrees(());
        let mut all = BLANK.iter().flat_map(Shape::units).chain([(angle.parameter().0, angle.unit())]);
        all.find(|(known, _)| *known == key).map(|(_, unit)| unit)
    }

    /// The shape with this name, without parameters; cones by their slope.
    pub fn by_name(name: &str) -> Option<&'static Shape<()>> {
        BLANK.iter().find(|shape| shape.name() == name)
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

    /// The radius of the ring on which f is lowest and f there, below the tip: the ridge of a displaced paraboloid, and the rim of a dimple.
    /// `None` for other shapes, which are lowest at the tip unless they have waves.
    ///
    /// ```
    /// use mdr_core::contact::Shape;
    /// assert_eq!(Shape::DisplacedParaboloid { radius: 2.0, offset: 1.0 }.lowest_ring(), Some([1.0, -0.25]));
    /// assert_eq!(Shape::ParabolicDimple { depth: 0.1, radius: 3.0 }.lowest_ring(), Some([3.0, -0.1]));
    /// assert_eq!(Shape::Paraboloid { radius: 2.0 }.lowest_ring(), None);
    /// ```
    pub fn lowest_ring(&self) -> Option<[N; 2]>
    where
        N: Real,
    {
        match self {
            Shape::DisplacedParaboloid { radius, offset } => {
                Some([offset.clone(), -(offset.square() / radius.clone().times(2))])
            }
            Shape::ParabolicDimple { depth, radius } | Shape::EllipticalDimple { depth, radius } => {
                Some([radius.clone(), -depth.clone()])
            }
            _ => None,
        }
    }

    /// The text of its formula up to where g diverges, the edge of an elliptical dimple: there that of all of it has two kinks at one radius.
    pub(crate) fn text_to_pole(&self) -> &'static str {
        if let Shape::EllipticalDimple { .. } = self { "h*(sqrt(1 - r^2/b^2) - 1)" } else { self.text() }
    }

    /// Whether it is a flat face, f = 0 up to its edge: then g = 0 on every medium.
    pub fn is_flat(&self) -> bool {
        matches!(self, Shape::FlatPunch { .. })
    }

    /// Whether its formula is that of all of it: the formula of a flat punch or of an elliptical dimple goes on beyond their edges.
    pub fn is_all_of_its_formula(&self) -> bool {
        !matches!(self, Shape::FlatPunch { .. } | Shape::EllipticalDimple { .. })
    }

    /// Whether f' is continuous where its formula has a kink: a cone has one slope where its cap ends.
    pub fn is_capped(&self) -> bool {
        matches!(self, Shape::ConeParabolicCap { .. } | Shape::ConeSphericalCap { .. })
    }

    /// The exponent of the power law that a shape follows near its tip only, and the radius up to which it does: 2 and the radius of the
    /// cap for a cone with a parabolic cap. `None` for other shapes; [`Shape::powers`] has those that are powers everywhere.
    ///
    /// ```
    /// use mdr_core::contact::{Flank, Shape};
    /// let capped = Shape::ConeParabolicCap { flank: Flank::Slope(0.3), cap: 1e-6 };
    /// assert_eq!(capped.law_at_tip(), Some((2, &1e-6)));
    /// ```
    pub fn law_at_tip(&self) -> Option<(u32, &N)> {
        if let Shape::ConeParabolicCap { cap, .. } = self { Some((2, cap)) } else { None }
    }

    /// The exponents n and coefficients C of f = Σ C rⁿ, where the shape is such a sum.
    ///
    /// ```
    /// use mdr_core::contact::Shape;
    /// assert_eq!(Shape::Paraboloid { radius: 2.0 }.powers(), Some(vec![[2.0, 0.25]]));
    /// assert_eq!(Shape::Sphere { radius: 2.0 }.powers(), None);
    /// ```
    pub fn powers(&self) -> Option<Vec<[N; 2]>>
    where
        N: Special,
    {
        let curved = |radius: &N| [radius.lit(2), radius.clone().times(2).inv()];
        Some(match self {
            Shape::Power { n, c } => vec![[n.clone(), c.clone()]],
            Shape::Paraboloid { radius } => vec![curved(radius)],
            Shape::Cone { flank } => vec![[flank.parameter().1.lit(1), flank.slope()]],
            Shape::DisplacedParaboloid { radius, offset } => {
                vec![curved(radius), [radius.lit(1), -(offset.clone() / radius)]]
            }
            _ => return None,
        })
    }

    /// The shape with other parameters; `f` gets each with its key, in the order of [`Shape::parameters`].
    pub fn map<M>(&self, mut f: impl FnMut(&'static str, &N) -> M) -> Shape<M> {
        let Ok(shape) = self.try_map(|key, number| Ok::<M, std::convert::Infallible>(f(key, number)));
        shape
    }

    /// The unit of the parameter with this key.
    pub fn unit_of(&self, key: &str) -> SiUnit {
        self.units().into_iter().find(|(known, _)| *known == key).map_or(SiUnit::One, |(_, unit)| unit)
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
