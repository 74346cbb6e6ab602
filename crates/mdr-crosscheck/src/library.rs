//! The profiles of the library by their names and parameters: as closed forms, and as heights.
//!
//! Parameters are in the order of the records, those of a scene: lengths and slopes as the profile has them.

use mdr_analytic::Kappa;
use mdr_analytic::profiles::{self as closed, Sum};
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Flank, Result, Shape as Named, Transform};
use mdr_core::number::{Lift, Real, Special};
use mdr_numeric::profiles::Heights;

/// The shapes: the type of the closed form, and the name in scenes and records.
macro_rules! shapes {
    ($($shape:ident $name:literal,)*) => {
        /// A profile of the library that is no power law.
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
    };
}

shapes! {
    Cone "cone",
    Paraboloid "paraboloid",
    Sphere "sphere",
    Ellipsoid "ellipsoid",
    Hyperboloid "hyperboloid",
    TruncatedCone "truncated-cone",
    TruncatedParaboloid "truncated-paraboloid",
    RoundedPunch "rounded-punch",
    ParabolicCapCone "cone-parabolic-cap",
    SphericalCapCone "cone-spherical-cap",
    DisplacedParaboloid "displaced-paraboloid",
    ParabolicDimple "parabolic-dimple",
    EllipticalDimple "elliptical-dimple",
    WavyParaboloid "wavy-paraboloid",
    Sum "sum",
}

/// The shapes of which the profile is the sum: a paraboloid and a cone for [`Shape::Sum`], else itself. A parameter that is
/// not given is no number.
fn terms<R: Real>(shape: Shape, parameters: &[R]) -> Vec<Named<R>> {
    let number = |index: usize| parameters.get(index).cloned().unwrap_or_else(|| parameters[0].lit(0).over(0));
    if shape == Shape::Sum {
        return vec![Named::Paraboloid { radius: number(0) }, Named::Cone { flank: Flank::Slope(number(1)) }];
    }
    let mut indices = 0..;
    let blank = Named::by_name(shape.name()).into_iter();
    blank.map(|blank| blank.map(|_, ()| number(indices.next().unwrap_or(0)))).collect()
}

/// The closed form of a profile.
///
/// # Errors
/// Parameters out of their domain.
pub(crate) fn closed_form<R: Struve + Lift<R> + Kappa>(
    shape: Shape,
    parameters: &[R],
) -> Result<Box<dyn Transform<R>>> {
    let mut terms = terms(shape, parameters).into_iter().map(closed::closed_form).collect::<Result<Vec<_>>>()?;
    Ok(if terms.len() == 1 { terms.remove(0) } else { Box::new(Sum::new(terms)) })
}

/// The profile by its heights f(r), f(0) = 0.
pub(crate) fn heights<R: Special>(shape: Shape, parameters: &[R]) -> Heights<R> {
    Heights::new(terms(shape, parameters))
}
