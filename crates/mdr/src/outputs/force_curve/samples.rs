//! The samples of a force curve, with a break at every jump.

use mdr_core::contact::{Control, Error, Fold, FoldKind, Result};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{ContactState, Dissipation, EdgeEnergies, Edges, EventKind, Path};

use super::summary::{summary, unknown};
use super::{ForceCurve, ForceSample};
use crate::answer::{List, Number, Optional, Promise, Value};
use crate::outputs::path::{changes, edges, follow, quantities};
use crate::run::lack;
use crate::solve::states::States;

/// At least so many samples between two events.
const LEAST: usize = 2;

/// The branches on which the contact moves.
#[derive(Clone, Copy)]
pub(super) enum Course<'a, 'm> {
    One(&'a States<'m, f64>),
    /// With two works of adhesion: the branches of an advancing and of a receding edge.
    Between([&'a States<'m, f64>; 2]),
}

impl<'a, 'm> Course<'a, 'm> {
    /// The states at the work of adhesion of a receding edge.
    fn receding(self) -> &'a States<'m, f64> {
        match self {
            Course::One(states) | Course::Between([_, states]) => states,
        }
    }

    /// The path of the scene.
    fn follow(self) -> Result<Path<f64>> {
        match self {
            Course::One(states) => follow(states.model, &states.branches, states.scene),
            Course::Between([advancing, receding]) => {
                edges::follow(receding.model, [&advancing.branches, &receding.branches], receding.scene)
            }
        }
    }

    /// The branches on which the radius changes from one to another.
    pub(super) fn branches(self, [from, to]: [f64; 2]) -> &'a SearchedBranches<f64> {
        match self {
            Course::Between([advancing, _]) if to > from => &advancing.branches,
            _ => &self.receding().branches,
        }
    }

    /// The energy lost in each event, and on the way to it by a receding edge.
    pub(super) fn losses(self, path: &Path<f64>) -> Vec<Result<(Dissipation<f64>, f64)>> {
        match self {
            Course::One(states) => {
                Dissipation::of_each(path, &states.branches).into_iter().map(|loss| Ok((loss?, 0.0))).collect()
            }
            Course::Between([advancing, receding]) => {
                let losses = EdgeEnergies::new(&advancing.branches, &receding.branches).losses(path);
                losses.into_iter().map(|loss| loss.map(|loss| (loss.jump, loss.hysteresis))).collect()
            }
        }
    }

    /// The state at a value between those of two events, on the branch on which both are.
    fn between(self, from: &ContactState<f64>, to: &ContactState<f64>, value: f64) -> Result<ContactState<f64>> {
        let (Some(before), Some(after)) = (from.contact(), to.contact()) else { return Ok(ContactState::Detached) };
        let radii = [before.contact_radius, after.contact_radius];
        match self {
            Course::Between([advancing, receding]) if radii[0] == radii[1] => {
                let contact = receding.model.contact();
                let edges = Edges::new(&contact, &advancing.branches, &receding.branches);
                edges.pinned(&radii[0], &value).map(ContactState::Contact)
            }
            _ => between(self.branches(radii), radii, value),
        }
    }
}

/// The path as a measurement shows it: its samples, and what is read off a measured curve.
///
/// # Errors
/// A path that cannot start or be followed; errors of the transform.
pub(super) fn sampled(course: Course<'_, '_>, points: usize) -> Result<ForceCurve> {
    let model = course.receding().model;
    let path = course.follow()?;
    let travel: f64 = path.events.windows(2).map(|pair| (pair[1].value - pair[0].value).abs()).sum();
    let mut samples = Vec::new();
    let mut segment = 1;
    let mut last = 0.0;
    for pair in path.events.windows(2) {
        let [from, to] = [&pair[0], &pair[1]];
        let step = to.value - from.value;
        // An edge that stops or begins to move is no sample of its own.
        if step == 0.0 && (to.kind == EventKind::Pinned || from.kind == EventKind::Depinned) {
            continue;
        }
        // A jump breaks the curve, and so does a change of direction.
        if changes(from.kind) || step * last < 0.0 {
            segment += 1;
        }
        if step != 0.0 {
            last = step;
        }
        let share = if travel > 0.0 { step.abs() / travel } else { 0.0 };
        let count = LEAST.max((share * points as f64).round() as usize);
        for index in 0..=count {
            let value = if index == count { to.value } else { from.value + step * (index as f64 / count as f64) };
            let state = match index {
                0 => Ok(from.after.clone()),
                _ if index == count => Ok(to.before.clone()),
                _ => lack(course.between(&from.after, &to.before, value))?,
            };
            let seen = |state| match state {
                ContactState::Contact(state) => ContactState::Contact(model.shown(state)),
                state => state,
            };
            let sample = sample(model.control(), segment, step, value, state.map(seen))?;
            let has_depth = model.contact().medium().has_depth();
            samples.extend(
                sample.map(|sample| ForceSample { indentation: sample.indentation.filter(|_| has_depth), ..sample }),
            );
        }
    }
    let summary = summary(course, model, &path, &samples)?;
    Ok(ForceCurve { samples: List::new(Promise::F64, samples), summary })
}

/// The state at a value on the branch with two radii.
fn between(branches: &SearchedBranches<f64>, [from, to]: [f64; 2], value: f64) -> Result<ContactState<f64>> {
    let middle = f64::midpoint(from, to);
    // A branch that keeps its radius lies at a vertical edge, beyond the fold that is there.
    let below = |fold: &Fold<f64>| match fold.kind {
        FoldKind::Minimum => fold.contact_radius <= middle,
        FoldKind::Maximum => fold.contact_radius < middle,
    };
    let branch = branches.folds().partition_point(below);
    match branches.on_branch(branch, &value)? {
        Some(state) => Ok(ContactState::Contact(state)),
        // There is one, between those of the two events.
        None => {
            let what = "the equilibrium, of which f64 does not find the contact radius";
            Err(Error::undecided(branches.control().quantity(), &value, what))
        }
    }
}

/// `None` if the surfaces touch everywhere; without the numbers of a state that was not found.
fn sample(
    control: &Control<f64>,
    segment: usize,
    step: f64,
    value: f64,
    state: Result<ContactState<f64>>,
) -> Result<Option<ForceSample>> {
    let known = |value: Value<f64>| value.and_then(|value| Value::Known(Number::F64(value)));
    let numbers = match state {
        Ok(state) => quantities(control, &state, &value),
        Err(error) => {
            let open = Some(unknown(error)?);
            let held = Some(Value::Known(value));
            match control {
                Control::Indentation => [open.clone(), held, open],
                Control::Force => [open.clone(), open, held],
                Control::Machine { .. } => [open.clone(), open.clone(), open],
            }
        }
    };
    let [contact_radius, indentation, force] = numbers.map(|quantity| quantity.map(known));
    let Some(force) = force else { return Ok(None) };
    Ok(Some(ForceSample {
        segment,
        direction: if step < 0.0 { "retract" } else { "approach" },
        position: Optional(matches!(control, Control::Machine { .. }).then(|| known(Value::Known(value)))),
        indentation,
        force,
        contact_radius,
    }))
}
