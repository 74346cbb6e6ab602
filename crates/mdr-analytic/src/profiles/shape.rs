//! The closed form of a shape by its name.

use mdr_core::contact::{Error, Quantity, Result, Shape, Transform};

use super::{capped, concave, punch, smooth, wavy};
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
