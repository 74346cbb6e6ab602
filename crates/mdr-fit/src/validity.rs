//! Whether the theory holds for the fitted contact.

use mdr_core::contact::{Edge, Elasticity};
use mdr_core::number::{Exact, Literal};

use super::answer::{Fit, FitStatus};
use super::contact::Numbers;
use super::problem::Problem;
use mdr::Result;
use mdr::scene::{Arithmetic, Scene};

/// Adds whether the theory holds for the contact with these numbers, by the range of adhesion, and a warning if it does not;
/// nothing without a range, or if the data do not determine the contact.
pub(super) fn add(fit: &mut Fit, problem: &Problem, numbers: &Numbers<f64>) -> Result<()> {
    let Some(range) = problem.range_of_adhesion.filter(|_| fit.status == FitStatus::Fitted) else { return Ok(()) };
    let fitted: Vec<Literal> =
        numbers.profile.iter().map(|number| number.exact()).collect::<std::result::Result<_, _>>()?;
    let profile = problem.profile.with_numbers(&mut fitted.into_iter());
    let own = numbers.of_edge(Some(Edge::Receding));
    let scene = Scene::new(profile, Elasticity::effective(numbers.e_star)?, own.work)?;
    let validity = scene.range_of_adhesion(range)?.arithmetic(Arithmetic::F64).validity()?;
    if validity.regime != mdr::validity::AdhesionRegime::Jkr {
        fit.warnings.push(validity.advice());
    }
    fit.validity = Some(Box::new(validity));
    Ok(())
}
