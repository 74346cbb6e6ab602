//! Pull-off and jump-in, as the fitted curve predicts them and as the record has them.

use nalgebra::DVector;

use super::answer::{Fit, FitEvent};
use super::arcs::end_speed;
use super::errors::Errors;
use super::minimise::Minimum;
use super::observation::{Leg, Observation};
use super::problem::Kind;
use mdr::Result;

/// Adds the events that the record can have.
pub(super) fn add(fit: &mut Fit, errors: &Errors<'_>, minimum: &Minimum) -> Result<()> {
    if errors.objective.problem.observation.sees_radius() {
        return Ok(());
    }
    fit.predicted_pull_off = pull_off(errors, minimum)?;
    let rows = &fit.rows;
    let data = &errors.objective.rows;
    let pair = |leg: Leg, index: usize| rows[index].leg == leg && data[index].part == data[index - 1].part;
    let breaks = (1..rows.len())
        .find(|index| pair(Leg::Retract, *index) && rows[*index].label < 0 && rows[*index - 1].label >= 0)
        .map(|index| index - 1);
    let touches = (1..rows.len())
        .find(|index| pair(Leg::Approach, *index) && rows[*index].label >= 0 && rows[*index - 1].label < 0);
    let [pull_off, jump_in] =
        [breaks, touches].map(|index| index.map(|index| measured(errors, minimum, [rows[index].x, rows[index].y])));
    let between = |first: Option<usize>| first.map(|index| [rows[index].x, rows[index + 1].x]);
    let (pull_off_between, jump_in_between) = (between(breaks), between(touches.map(|index| index - 1)));
    (fit.measured_pull_off, fit.measured_jump_in) = (pull_off, jump_in);
    (fit.pull_off_between, fit.jump_in_between) = (pull_off_between, jump_in_between);
    if touches.is_some() {
        fit.predicted_jump_in = Some(first_touch(errors, minimum));
    }
    Ok(())
}

/// The fold where the contact breaks, with standard errors: it moves along the curve, and with the curve.
fn pull_off(errors: &Errors<'_>, minimum: &Minimum) -> Result<Option<FitEvent>> {
    let evaluation = &minimum.evaluation;
    let sheet = evaluation.breaking();
    let Some(s) = evaluation.sheets[sheet].last_fold() else { return Ok(None) };
    let kinds = errors.kinds();
    let contact = &evaluation.contacts(errors.objective.problem.observation, &kinds)?[sheet];
    let point = contact.point(&s)?;
    let mut gradients = vec![DVector::zeros(kinds.len()); 5];
    for (index, kind) in kinds.iter().enumerate() {
        let speed = end_speed(contact, *kind, &point)?;
        let [x, y] = contact.partial(*kind, &point)?;
        let [d, f, a] = contact.state_partial(*kind, &point)?;
        let along = [point.tangent[0], point.tangent[1], point.slopes[1], point.slopes[0], point.slopes[2]];
        for ((gradient, fixed), along) in gradients.iter_mut().zip([x, y, f, d, a]).zip(along) {
            gradient[index] = fixed + along * speed;
        }
    }
    let values = [point.at[0], point.at[1], point.f, point.d, point.a];
    let known = |index: usize| errors.spectrum.determines(&gradients[index], values[index]).then_some(values[index]);
    // X and Y are seen.
    let state = [2, 3, 4].map(known);
    let stderr = [0, 1, 2, 3, 4].map(|index: usize| match index.checked_sub(2) {
        Some(of_state) if state[of_state].is_none() => f64::NAN,
        _ => errors.stderr(&gradients[index]),
    });
    let [force, indentation, contact_radius] = state;
    Ok(Some(FitEvent { x: values[0], y: values[1], force, indentation, contact_radius, stderr: Some(stderr) }))
}

/// The surfaces touch at d = 0 without force.
fn first_touch(errors: &Errors<'_>, minimum: &Minimum) -> FitEvent {
    let numbers = &minimum.evaluation.numbers;
    let kinds = errors.kinds();
    let of = |kind: Kind| {
        let gradient =
            DVector::from_iterator(kinds.len(), kinds.iter().map(|known| if *known == kind { 1.0 } else { 0.0 }));
        errors.stderr(&gradient)
    };
    let stderr = Some([of(Kind::ContactPoint), of(Kind::Baseline), 0.0, 0.0, 0.0]);
    let nothing = Some(0.0);
    let [x, y] = [numbers.contact_point, numbers.baseline];
    FitEvent { x, y, force: nothing, indentation: nothing, contact_radius: None, stderr }
}

/// A row as a state.
fn measured(errors: &Errors<'_>, minimum: &Minimum, [x, y]: [f64; 2]) -> FitEvent {
    let numbers = &minimum.evaluation.numbers;
    let observation = errors.objective.problem.observation;
    let [indentation, force] = numbers.state(observation, [x, y]);
    let undetermined = errors.spectrum.undetermined();
    let is_known = |kind: Kind| errors.kinds().iter().zip(&undetermined).all(|(known, lost)| *known != kind || !lost);
    let by_machine = is_known(Kind::Stiffness) || observation == Observation::ForceOfPosition;
    let force = Some(force).filter(|_| by_machine && is_known(Kind::Baseline));
    let by_force = is_known(Kind::Stiffness) || observation == Observation::DeflectionOfPosition;
    let indentation =
        Some(indentation).filter(|_| by_force && is_known(Kind::Baseline) && is_known(Kind::ContactPoint));
    FitEvent { x, y, force, indentation, contact_radius: None, stderr: None }
}
