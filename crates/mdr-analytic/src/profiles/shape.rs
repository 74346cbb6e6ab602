//! The closed form of a shape by its name.

use mdr_core::contact::{Error, Quantity, Result, Shape, Transform};
use mdr_core::number::Dual;
#[cfg(feature = "mp")]
use mdr_core::number::Interval;

use super::{Sum, capped, concave, punch, smooth, wavy};
use crate::struve::Struve;
use crate::{Kappa, PowerLaw};

/// The transformed profile g of a shape of the library, in any arithmetic that has it.
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
pub fn closed_form<R: ClosedReal>(shape: Shape<R>) -> Result<Box<dyn Transform<R>>> {
    R::closed_form(shape)
}

/// An arithmetic that has the closed forms of the library: `f64`, numbers of any precision, enclosures, and dual numbers over
/// them.
///
/// The closed forms are generic. A release compiles them in this crate for each of these arithmetics: what calls them through
/// this trait does not compile them again. Another arithmetic has them with an `impl` without functions.
///
/// ```
/// use mdr_analytic::profiles::{ClosedReal, closed_form};
/// use mdr_core::contact::{Shape, Transform};
/// use mdr_core::number::Dual;
/// // The curvature of g = x²/R is 2/R.
/// fn curvature<R: ClosedReal>(radius: R, at: R) -> mdr_core::contact::Result<R>
/// where
///     Dual<R>: ClosedReal,
/// {
///     let ball = closed_form(Shape::Paraboloid { radius: Dual::constant(radius) })?;
///     Ok(ball.slope(&Dual::variable(at))?.slope)
/// }
/// assert_eq!(curvature(4.0, 0.3)?, 0.5);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub trait ClosedReal: Struve + Kappa {
    /// The transformed profile g of a shape of the library.
    ///
    /// # Errors
    /// [`Error::Domain`](mdr_core::contact::Error::Domain) for a parameter outside its domain.
    fn closed_form(shape: Shape<Self>) -> Result<Box<dyn Transform<Self>>> {
        by_module(shape)
    }

    /// The [`Sum`] of transforms.
    fn sum(terms: Vec<Box<dyn Transform<Self>>>) -> Box<dyn Transform<Self>> {
        Box::new(Sum::new(terms))
    }
}

/// `ClosedReal`, with functions that are not generic in builds of this configuration: only this crate compiles those.
macro_rules! closed_forms {
    (compiled if $configuration:meta: $($arithmetic:ty),*) => {$(
        impl ClosedReal for $arithmetic {
            #[cfg($configuration)]
            fn closed_form(shape: Shape<Self>) -> Result<Box<dyn Transform<Self>>> {
                by_module(shape)
            }

            #[cfg($configuration)]
            fn sum(terms: Vec<Box<dyn Transform<Self>>>) -> Box<dyn Transform<Self>> {
                Box::new(Sum::new(terms))
            }
        }
    )*};
}

closed_forms!(compiled if all(): f64, Dual<f64>);
// Development builds share what is generic, and the crates above compile these faster, as they do without optimisation.
#[cfg(feature = "mp")]
closed_forms!(
    compiled if not(debug_assertions): rug::Float, Dual<rug::Float>, Interval, Dual<Interval>, Dual<Dual<Interval>>
);

fn by_module<R: Struve + Kappa>(shape: Shape<R>) -> Result<Box<dyn Transform<R>>> {
    if let Shape::Power { n, c } = shape {
        return Ok(Box::new(PowerLaw::new(n, c)?));
    }
    let modules =
        [smooth::closed_form, punch::closed_form, capped::closed_form, concave::closed_form, wavy::closed_form];
    modules.into_iter().find_map(|closed_form| closed_form(&shape)).unwrap_or_else(|| {
        let (quantity, value) = (Quantity::Parameter("the shape"), shape.name().to_owned());
        Err(Error::Domain { quantity, value, requirement: "one whose transform is a closed form" })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shape_has_a_closed_form() {
        for name in Shape::names() {
            let shape = Shape::by_name(name).unwrap().map(|_, ()| 0.5);
            assert!(closed_form(shape).is_ok_and(|profile| profile.g(&0.25).is_ok_and(f64::is_finite)), "{name}");
        }
    }
}
