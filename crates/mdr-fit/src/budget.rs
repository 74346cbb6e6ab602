//! How the estimates follow the numbers that are given: ∂ln E*/∂ln k and the like.

use std::sync::Arc as Shared;

use nalgebra::{DMatrix, DVector};

use super::answer::BudgetEntry;
use super::errors::Errors;
use super::judge;
use super::minimise::Minimum;
use super::objective::Objective;
use super::problem::{Kind, Problem};

/// The derivatives of the estimates with respect to the logarithms of the given numbers: of the linearised model, θ follows φ by
/// ∂θ/∂φ = −(JᵀJ)⁻¹Jᵀ ∂r/∂φ. Numbers whose derivatives the profile does not have are left out.
pub(super) fn of(errors: &Errors<'_>, minimum: &Minimum) -> Vec<BudgetEntry> {
    let (objective, problem) = (errors.objective, errors.objective.problem);
    let counts = |kind: Kind| match kind {
        Kind::EffectiveModulus | Kind::Stiffness | Kind::Sensitivity | Kind::Profile(_) => true,
        Kind::WorkOfAdhesion => !problem.has_two_works(),
        Kind::Work(_) => problem.has_two_works(),
        _ => false,
    };
    let given: Vec<usize> = (0..problem.parameters.len())
        .filter(|index| {
            let parameter = &problem.parameters[*index];
            !parameter.free && counts(parameter.kind) && parameter.value.is_some_and(|value| value > 0.0)
        })
        .collect();
    if given.is_empty() || errors.kept.is_empty() {
        return Vec::new();
    }
    given.into_iter().filter_map(|index| along(objective, errors, minimum, index)).flatten().collect()
}

/// The derivatives of the residuals with respect to the fitted value of a given number.
pub(super) fn column(objective: &Objective<'_>, minimum: &Minimum, index: usize) -> Option<DVector<f64>> {
    let mut problem: Problem = objective.problem.clone();
    problem.parameters[index].free = true;
    problem.parameters[index].bounds = None;
    let mut freed = Objective::new(&problem, objective.x_scale, objective.noise).ok()?;
    freed.rows = Shared::clone(&objective.rows);
    freed.at_fold.clone_from(&objective.at_fold);
    let own = freed.free.iter().position(|free| *free == index)?;
    let mut fitted = minimum.fitted.clone();
    fitted.insert(own, freed.to_fitted(own, problem.parameters[index].value?));
    let kind = freed.kind(own);
    // Only a number of the profile needs a transform with its derivatives.
    let seeded = match kind {
        Kind::Profile(_) => Some(freed.evaluate(&fitted, Some(&minimum.evaluation.turns)).ok()?),
        _ => None,
    };
    let evaluation = seeded.as_ref().unwrap_or(&minimum.evaluation);
    let jacobian = freed.derivatives(&fitted, evaluation, &[(own, kind)]).ok()?;
    (jacobian.nrows() == minimum.jacobian.nrows()).then(|| jacobian.column(0).clone_owned())
}

/// The part of the residuals' derivatives with respect to a given number that the free numbers follow, in changes of these.
pub(super) fn followed(errors: &Errors<'_>, minimum: &Minimum, column: &DVector<f64>) -> Option<DVector<f64>> {
    let mut scaled: DMatrix<f64> = minimum.jacobian.select_columns(errors.kept);
    let lengths: Vec<f64> = scaled.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
    scaled.column_iter_mut().zip(&lengths).for_each(|(mut column, length)| column /= *length);
    let moved = judge::least_squares(scaled, column, 1e-11)?;
    Some(DVector::from_iterator(lengths.len(), moved.iter().zip(&lengths).map(|(moved, length)| moved / length)))
}

/// The derivatives with respect to one given number.
fn along(objective: &Objective<'_>, errors: &Errors<'_>, minimum: &Minimum, index: usize) -> Option<Vec<BudgetEntry>> {
    let moved = followed(errors, minimum, &column(objective, minimum, index)?)?;
    let of = objective.problem.parameters[index].name.clone();
    let entry = |(place, moved): (&usize, &f64)| {
        let parameter = objective.parameter(*place);
        let is_offset = parameter.kind.is_offset();
        let unit = if is_offset { parameter.unit_name() } else { "1" };
        BudgetEntry { name: parameter.name.clone(), of: of.clone(), slope: -moved, unit }
    };
    let found: Vec<BudgetEntry> = errors.kept.iter().zip(moved.iter()).map(entry).collect();
    found.iter().all(|entry| entry.slope.is_finite()).then_some(found)
}
