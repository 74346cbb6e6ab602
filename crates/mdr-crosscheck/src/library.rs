//! The profiles of the library by their names in scenes and records, as closed forms and as shapes.

use mdr_analytic::Kappa;
use mdr_analytic::profiles::{self as closed, Sum};
use mdr_analytic::struve::Struve;
use mdr_core::contact::{Result, Shape, Transform};
use mdr_core::number::{Lift, Real};

/// A paraboloid and a cone together.
const SUM: &str = "sum";

/// Every profile with a closed form that is no power law, in the order of the trials.
pub(crate) const NAMES: [&str; 15] = [
    "cone",
    "paraboloid",
    "sphere",
    "ellipsoid",
    "hyperboloid",
    "truncated-cone",
    "truncated-paraboloid",
    "rounded-punch",
    "cone-parabolic-cap",
    "cone-spherical-cap",
    "displaced-paraboloid",
    "parabolic-dimple",
    "elliptical-dimple",
    "wavy-paraboloid",
    SUM,
];

/// The shapes of which the profile with this name is the sum; `parameter` gets the key of each parameter.
pub(crate) fn terms<R>(name: &str, mut parameter: impl FnMut(&'static str) -> R) -> Vec<Shape<R>> {
    let names = if name == SUM { vec!["paraboloid", "cone"] } else { vec![name] };
    names.into_iter().filter_map(Shape::by_name).map(|blank| blank.map(|key, ()| parameter(key))).collect()
}

/// The same with the parameters in the order of [`Shape::parameters`]. One that is not given is no number.
pub(crate) fn ordered<R: Real>(name: &str, parameters: &[R]) -> Vec<Shape<R>> {
    let mut given = parameters.iter().cloned();
    terms(name, |_| given.next().unwrap_or_else(|| parameters[0].lit(0).over(0)))
}

/// The closed form of a sum of shapes.
///
/// # Errors
/// Parameters out of their domain.
pub(crate) fn closed_form<R: Struve + Lift<R> + Kappa>(terms: Vec<Shape<R>>) -> Result<Box<dyn Transform<R>>> {
    let mut terms = terms.into_iter().map(closed::closed_form).collect::<Result<Vec<_>>>()?;
    Ok(if terms.len() == 1 { terms.remove(0) } else { Box::new(Sum::new(terms)) })
}
