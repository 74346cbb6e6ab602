//! The characteristic values of a force curve: pull-off force, jump-in, minimum force, hysteresis.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Error, FoldKind, Result, Status};
use mdr_numeric::contact::Contact;
use mdr_numeric::folds::{self, SearchQuality};
use mdr_numeric::path::{Dissipation, Event, EventKind, Path};

use super::samples::Course;
use super::{CurveSummary, ForceSample};
use crate::answer::{Number, Value};
use crate::outputs::path::{beyond_noise, changes};
use crate::solve::model::Model;

/// The summary of a path. The samples hold the force at both ends of every stretch between two events.
///
/// # Errors
/// Errors of [`folds::find_between`], except for numbers that are not decided.
pub(super) fn summary(
    course: Course<'_, '_>,
    model: &Model<f64>,
    path: &Path<f64>,
    samples: &[ForceSample],
) -> Result<CurveSummary> {
    Ok(CurveSummary {
        pull_off_force: pull_off(&path.events).map(known),
        jump_in_force: jump_in(&path.events).map(known),
        minimum_force: minimum(course, model, path, samples)?,
        hysteresis: hysteresis(course, path)?,
    })
}

fn known(value: f64) -> Value {
    Value::Known(Number::F64(value))
}

/// A number that was not found takes nothing else with it.
pub(super) fn unknown<N>(error: Error) -> Result<Value<N>> {
    match error {
        Error::Undecided { .. } => Ok(Value::unknown(Status::Undecided, error.to_string())),
        error => Value::from_result(Err(error)),
    }
}

/// The contact radii before and after an event, if both states are in contact.
fn radii(event: &Event<f64>) -> Option<[f64; 2]> {
    Some([event.before.contact()?.contact_radius, event.after.contact()?.contact_radius])
}

/// The force from which the contact breaks for the first time. Where it shrinks to a point from a smaller contact, to which it
/// has jumped before, that of the jump.
fn pull_off(events: &[Event<f64>]) -> Option<f64> {
    let breaks = events.iter().position(|event| event.kind == EventKind::Detached)?;
    let jumps = |event: &&Event<f64>| changes(event.kind) && radii(event).is_some();
    let at_a_point = events[breaks].before.contact().is_some_and(|state| state.contact_radius == 0.0);
    let last = events[..breaks].iter().rfind(jumps).filter(|_| at_a_point);
    let shrinks = |event: &&Event<f64>| radii(event).is_some_and(|[before, after]| after < before);
    let event = last.filter(shrinks).unwrap_or(&events[breaks]);
    event.before.contact().map(|state| state.force)
}

/// The force just after the surfaces have jumped into contact for the first time. Where contact begins continuously, after the
/// first jump to a larger radius of the contact that grows from there.
fn jump_in(events: &[Event<f64>]) -> Option<f64> {
    let mut grows_from_a_point = false;
    let event = events.iter().find(|event| {
        match event.kind {
            EventKind::Touch => grows_from_a_point = true,
            EventKind::Detached => grows_from_a_point = false,
            EventKind::JumpIn => return true,
            _ => {}
        }
        let grows = || radii(event).is_some_and(|[before, after]| after > before);
        grows_from_a_point && event.kind == EventKind::Jump && grows()
    })?;
    event.after.contact().map(|state| state.force)
}

/// The minimum of F along the path: at an end of a stretch between two events, or at a fold of F that lies on it. There
/// dF/da = 2E*a(g' − 3Δl') vanishes, g' = 3√(πw/(2E*a)).
///
/// `undecided` where the folds of F were not resolved.
///
/// Between two works of adhesion a stretch has the folds of the edge that moves; where it is pinned, F is linear.
fn minimum(
    course: Course<'_, '_>,
    model: &Model<f64>,
    path: &Path<f64>,
    samples: &[ForceSample],
) -> Result<Option<Value>> {
    // Forces in between are no less than at an end or a fold.
    let at_ends = samples.iter().filter_map(|sample| sample.force.to_f64()).reduce(f64::min);
    let stretches: Vec<[f64; 2]> = path
        .events
        .windows(2)
        .filter_map(|pair| Some([pair[0].after.contact()?.contact_radius, pair[1].before.contact()?.contact_radius]))
        .filter(|[from, to]| from != to)
        .collect();
    // A controlled force changes in one direction from event to event.
    if matches!(model.control(), Control::Force) || stretches.is_empty() {
        return Ok(at_ends.map(known));
    }
    let (growing, shrinking): (Vec<_>, Vec<_>) = match course {
        Course::One(_) => (Vec::new(), stretches),
        Course::Between(_) => stretches.into_iter().partition(|[from, to]| to > from),
    };
    let mut least = at_ends;
    for stretches in [growing, shrinking].into_iter().filter(|stretches| !stretches.is_empty()) {
        match at_folds(course.branches(stretches[0]).curve(), &stretches)? {
            Ok(found) => least = found.into_iter().chain(least).reduce(f64::min),
            Err(unknown) => return Ok(Some(unknown)),
        }
    }
    Ok(least.map(known))
}

/// The least force at a fold of F on stretches between two radii, or why it is not known.
fn at_folds(curve: &Contact<f64>, stretches: &[[f64; 2]]) -> Result<std::result::Result<Option<f64>, Value>> {
    let curve = curve.with_control(Control::Force);
    let [mut least, mut greatest] = [f64::INFINITY, 0.0_f64];
    for radius in stretches.as_flattened() {
        (least, greatest) = (least.min(*radius), greatest.max(*radius));
    }
    let found = match folds::find_between(&curve, &least, &greatest) {
        Err(error) => return unknown(error).map(Err),
        Ok(found) => found,
    };
    if found.completeness == SearchQuality::Doubtful {
        let why = "a minimum of the force between the ends of the path: its folds were not resolved everywhere";
        return Ok(Err(Value::unknown(Status::Undecided, why)));
    }
    let outer_edge = curve.vertical_edge();
    let passes = |radius: f64| {
        let reached = outer_edge == Some(radius);
        stretches
            .iter()
            .any(|[from, to]| from.min(*to) < radius && (radius < from.max(*to) || reached && radius == from.max(*to)))
    };
    for fold in found.out_of_range.iter().filter(|fold| fold.kind == FoldKind::Minimum) {
        if passes(fold.contact_radius) {
            return unknown(fold.error.clone()).map(Err);
        }
    }
    let met = found.folds.iter().filter(|fold| fold.kind == FoldKind::Minimum && passes(fold.contact_radius));
    Ok(Ok(met.map(|fold| fold.force).reduce(f64::min)))
}

/// The energy lost in all events, and by a receding edge; `None` if it has no bound.
fn hysteresis(course: Course<'_, '_>, path: &Path<f64>) -> Result<Option<Value>> {
    let mut lost = Estimate::exact(0.0);
    let mut out_of_range = None;
    for (event, loss) in path.events.iter().zip(course.losses(path)) {
        match loss {
            Ok((Dissipation::Unbounded, _)) if changes(event.kind) => return Ok(None),
            Ok((Dissipation::Finite(energy), by_edge)) if changes(event.kind) => {
                lost += &energy;
                lost += &Estimate::exact(by_edge);
            }
            Ok((_, by_edge)) => lost += &Estimate::exact(by_edge),
            Err(_) if !changes(event.kind) && matches!(course, Course::One(_)) => {}
            Err(Error::OutOfRange { log10, .. }) => out_of_range = Some(out_of_range.unwrap_or(log10).max(log10)),
            Err(error) => return unknown(error).map(Some),
        }
    }
    Ok(Some(match out_of_range {
        // What underflows is nothing beside what does not.
        Some(log10) if log10 > 0.0 || lost.value == 0.0 => Value::out_of_range(log10),
        _ => beyond_noise(&lost, &lost.error).and_then(|energy| known(energy.value)),
    }))
}
