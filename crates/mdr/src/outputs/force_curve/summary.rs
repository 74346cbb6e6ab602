//! The characteristic values of a force curve: pull-off force, jump-in, minimum force, hysteresis.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Error, Fold, FoldKind, Result, Status};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds::{self, SearchQuality};
use mdr_numeric::path::{Dissipation, EdgeEnergies, Event, EventKind, Path};

use super::ForceSample;
use super::samples::{Branches, Course};
use crate::answer::Value;
use crate::outputs::path::{beyond_noise, changes};
use crate::solve::model::SceneReal;

/// A number that was not found takes nothing else with it.
pub(super) fn unknown<N>(error: Error) -> Result<Value<N>> {
    match error {
        Error::Undecided { .. } => Ok(Value::unknown(Status::Undecided, error.to_string())),
        error => Value::from_result(Err(error)),
    }
}

/// The contact radii before and after an event, if both states are in contact.
fn radii<R: SceneReal>(event: &Event<R>) -> Option<[&R; 2]> {
    Some([&event.before.contact()?.contact_radius, &event.after.contact()?.contact_radius])
}

/// The force from which the contact breaks for the first time. Where it shrinks to a point from a smaller contact, to which it
/// has jumped before, that of the jump.
pub(super) fn pull_off<R: SceneReal>(events: &[Event<R>]) -> Option<R> {
    let breaks = events.iter().position(|event| event.kind == EventKind::Detached)?;
    let jumps = |event: &&Event<R>| changes(event.kind) && radii(event).is_some();
    let at_a_point =
        events[breaks].before.contact().is_some_and(|state| state.contact_radius <= state.contact_radius.lit(0));
    let last = events[..breaks].iter().rfind(jumps).filter(|_| at_a_point);
    let shrinks = |event: &&Event<R>| radii(event).is_some_and(|[before, after]| after < before);
    let event = last.filter(shrinks).unwrap_or(&events[breaks]);
    event.before.contact().map(|state| state.force.clone())
}

/// The force just after the surfaces have jumped into contact for the first time. Where contact begins continuously, after the
/// first jump to a larger radius of the contact that grows from there.
pub(super) fn jump_in<R: SceneReal>(events: &[Event<R>]) -> Option<R> {
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
    event.after.contact().map(|state| state.force.clone())
}

/// The contact radii at the ends of the stretches of a path between two events on which the edge moves: of an edge that advances, if that
/// has branches of its own, and of all others.
pub(super) fn stretches<R: SceneReal, B: EquilibriumBranches<R>>(
    course: &Course<'_, R, B>,
    path: &Path<R>,
) -> [Vec<[R; 2]>; 2] {
    let moves = |[from, to]: &[R; 2]| !course.branches.moving(to > from).is_same(from, to);
    let between = |pair: &[Event<R>]| {
        Some([pair[0].after.contact()?.contact_radius.clone(), pair[1].before.contact()?.contact_radius.clone()])
    };
    let stretches: Vec<[R; 2]> = path.events.windows(2).filter_map(between).filter(moves).collect();
    let grows = |[from, to]: &[R; 2]| matches!(course.branches, Branches::Between(_)) && to > from;
    let (growing, others) = stretches.into_iter().partition(grows);
    [growing, others]
}

/// Whether a radius is inside a stretch, or at its larger end where that is the vertical edge; `None` if that is not decided.
pub(super) fn passes<R: SceneReal>(
    radius: &R,
    stretches: &[[R; 2]],
    is_at_edge: bool,
    is_same: impl Fn(&R, &R) -> bool,
) -> Option<bool> {
    let mut passes = false;
    for [from, to] in stretches {
        let [low, high] = if from < to { [from, to] } else { [to, from] };
        let [above, below] = [low, high].map(|end| if is_same(radius, end) { Some(0) } else { order(radius, end) });
        let at_end = is_at_edge && below? == 0;
        passes |= above? > 0 && (below? < 0 || at_end);
    }
    Some(passes)
}

fn order<R: SceneReal>(one: &R, other: &R) -> Option<i8> {
    one.partial_cmp(other).map(|order| order as i8)
}

/// The minimum of F along the path in f64: at an end of a stretch between two events, or at a fold of F that lies on it. There
/// dF/da = 2E*a(g' − 3Δl') vanishes, g' = 3√(πw/(2E*a)).
///
/// `undecided` where the folds of F were not resolved.
///
/// Between two works of adhesion a stretch has the folds of the edge that moves; where it is pinned, F is linear.
///
/// # Errors
/// Errors of [`folds::find_between`], except for numbers that are not decided.
pub(super) fn minimum(
    course: &Course<'_, f64, SearchedBranches<f64>>,
    path: &Path<f64>,
    samples: &[ForceSample<f64>],
) -> Result<Option<Value<f64>>> {
    // Forces in between are no less than at an end or a fold.
    let forces = samples.iter().filter_map(|sample| match sample.force {
        Value::Known(force) => Some(force),
        _ => None,
    });
    let mut least = forces.reduce(f64::min);
    // A controlled force changes in one direction from event to event.
    if matches!(course.model.control(), Control::Force) {
        return Ok(least.map(Value::Known));
    }
    for (stretches, grows) in stretches(course, path).iter().zip([true, false]) {
        if stretches.is_empty() {
            continue;
        }
        match at_folds(course.branches.moving(grows).curve(), stretches)? {
            Ok(found) => least = found.into_iter().chain(least).reduce(f64::min),
            Err(unknown) => return Ok(Some(unknown)),
        }
    }
    Ok(least.map(Value::Known))
}

/// The least force at a fold of F on stretches between two radii, or why it is not known.
fn at_folds(curve: &Contact<f64>, stretches: &[[f64; 2]]) -> Result<std::result::Result<Option<f64>, Value<f64>>> {
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
        passes(&radius, stretches, outer_edge == Some(radius), |one, other| one == other).unwrap_or(false)
    };
    for fold in found.out_of_range.iter().filter(|fold| fold.kind == FoldKind::Minimum) {
        if passes(fold.contact_radius) {
            return unknown(fold.error.clone()).map(Err);
        }
    }
    let is_met = |fold: &&Fold<f64>| fold.kind == FoldKind::Minimum && passes(fold.contact_radius);
    Ok(Ok(found.folds.iter().filter(is_met).map(|fold| fold.force).reduce(f64::min)))
}

/// The energy lost in each event, and on the way to it by a receding edge.
fn losses(course: &Course<'_, f64, SearchedBranches<f64>>, path: &Path<f64>) -> Vec<Result<(Dissipation<f64>, f64)>> {
    match course.branches {
        Branches::One(branches) => {
            Dissipation::of_each(path, branches).into_iter().map(|loss| Ok((loss?, 0.0))).collect()
        }
        Branches::Between([advancing, receding]) => {
            let losses = EdgeEnergies::new(advancing, receding).losses(path);
            losses.into_iter().map(|loss| loss.map(|loss| (loss.jump, loss.hysteresis))).collect()
        }
    }
}

/// The energy lost in all events in f64, and by a receding edge; `None` if it has no bound.
///
/// # Errors
/// Errors of the energies, except for numbers that are not decided.
pub(super) fn hysteresis(
    course: &Course<'_, f64, SearchedBranches<f64>>,
    path: &Path<f64>,
) -> Result<Option<Value<f64>>> {
    let mut lost = Estimate::exact(0.0);
    let mut out_of_range = None;
    for (event, loss) in path.events.iter().zip(losses(course, path)) {
        match loss {
            Ok((Dissipation::Unbounded, _)) if changes(event.kind) => return Ok(None),
            Ok((Dissipation::Finite(energy), by_edge)) if changes(event.kind) => {
                lost += &energy;
                lost += &Estimate::exact(by_edge);
            }
            Ok((_, by_edge)) => lost += &Estimate::exact(by_edge),
            Err(_) if !changes(event.kind) && matches!(course.branches, Branches::One(_)) => {}
            Err(Error::OutOfRange { log10, .. }) => out_of_range = Some(out_of_range.unwrap_or(log10).max(log10)),
            Err(error) => return unknown(error).map(Some),
        }
    }
    Ok(Some(match out_of_range {
        // What underflows is nothing beside what does not.
        Some(log10) if log10 > 0.0 || lost.value == 0.0 => Value::out_of_range(log10),
        _ => beyond_noise(&lost, &lost.error).and_then(|energy| Value::Known(energy.value)),
    }))
}
