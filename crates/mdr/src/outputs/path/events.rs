//! One record for each event of a path, and the balance of its energy.

use std::cmp::Ordering;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{self, Control, Error, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::{Admissibility, GapVerdict, Ring};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::medium::Medium;
use mdr_numeric::path::{self, ContactState, Event, EventKind, Path, stored};

use super::{Balance, Dissipation, PathEvent, PathNumbers};
use crate::answer::record::Numbers;
use crate::answer::{Admission, Optional, Value};
use crate::scene::Scene;
use crate::solve::model::{Model, SceneReal};
use crate::solve::verdict;

/// The path of a scene.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform. See [`Path::follow`].
pub(crate) fn follow<R: SceneReal>(
    model: &Model<R>,
    branches: &impl EquilibriumBranches<R>,
    scene: &Scene,
) -> Result<Path<R>> {
    let way: Vec<R> = scene.path.iter().map(|point| model.number(point)).collect();
    let start = model.start(&scene.start)?;
    let order: Vec<Ordering> = scene.path.windows(2).map(|pair| pair[1].compare(&pair[0])).collect();
    Path::follow_ordered(branches, &start, &way, &order)
}

/// The events of a path, without the energy that is lost in each.
pub(crate) fn events<R: SceneReal>(
    control: &Control<R>,
    path: &Path<R>,
    admissibility: &Admissibility,
) -> Vec<PathEvent<R>> {
    path.events.iter().map(|event| of_event(control, event, admission(event, admissibility))).collect()
}

/// The events of a path of a contact, as [`events`], with contact radii for sizes and without depths that its medium does not have.
pub(crate) fn of_contact<R: SceneReal>(
    contact: &Contact<R>,
    path: &Path<R>,
    admissibility: &Admissibility,
) -> Vec<PathEvent<R>> {
    let medium = contact.medium();
    let mut events = events(contact.control(), &shown(path, medium), admissibility);
    if !medium.has_depth() {
        for event in &mut events {
            (event.indentation, event.to_indentation) = (None, None);
        }
    }
    events
}

/// A path with contact radii for the sizes of its contacts.
fn shown<R: SceneReal>(path: &Path<R>, medium: &Medium<R>) -> Path<R> {
    let mut path = path.clone();
    for event in &mut path.events {
        for state in [&mut event.before, &mut event.after] {
            if let ContactState::Contact(state) = state {
                state.contact_radius = medium.contact_radius(&state.contact_radius);
            }
        }
    }
    path
}

/// Whether the states of an event are admissible: all are up to the one that ends the path for that.
fn admission<R: SceneReal>(event: &Event<R>, admissibility: &Admissibility) -> Admission<R> {
    if event.kind == EventKind::Undecided {
        return Admission::Unknown { why: open_reason(event) };
    }
    if let Some(ring) = &event.ring {
        let verdict = GapVerdict::Interpenetrating { radius: ring.radius.approx(), gap: ring.gap.approx() };
        return match Admission::of(verdict) {
            Admission::Interpenetrating { at, .. } => {
                Admission::Interpenetrating { at, why: Some(remedy(event, ring)) }
            }
            other => other,
        };
    }
    let in_contact = |state: &&contact::Equilibrium<R>| state.contact_radius > state.contact_radius.lit(0);
    Admission::of(match event.after.contact().or(event.before.contact()).filter(in_contact) {
        Some(rest) => verdict(admissibility, &rest.contact_radius, &rest.indentation),
        None => GapVerdict::Admissible,
    })
}

/// The reason why a path ends, and a remedy.
fn remedy<R: SceneReal>(event: &Event<R>, ring: &Ring<R>) -> String {
    let radius = format!("{:.5e}", ring.radius.approx()).parse::<f64>().unwrap_or(f64::NAN);
    let remedy = "begin with a contact that reaches beyond it, start = \"largest\", or stay below this value";
    let happens = match event.after {
        _ if ring.gap < ring.gap.lit(0) => "in the state that comes next the surfaces would overlap",
        ContactState::Contact(_) => "outside of the contact the surfaces touch",
        _ => "coming closer the surfaces first touch not at the tip but",
    };
    format!(
        "{happens} on a ring of radius {radius:e} m, where the theory of one simply connected contact ends; {remedy}"
    )
}

fn of_event<R: SceneReal>(control: &Control<R>, event: &Event<R>, admissible: Admission<R>) -> PathEvent<R> {
    let [contact_radius, indentation, force] = match event.kind {
        EventKind::Undecided => not_found(control, &event.value, open_reason(event)),
        _ => quantities(control, &event.before, &event.value),
    };
    let [to_contact_radius, to_indentation, to_force] =
        if changes(event.kind) { quantities(control, &event.after, &event.value) } else { [None, None, None] };
    let is_machine = matches!(control, Control::Machine { .. });
    PathEvent {
        event: event.kind,
        position: Optional(is_machine.then(|| Value::Known(event.value.clone()))),
        indentation,
        force,
        contact_radius,
        to_contact_radius,
        to_indentation,
        to_force,
        admissible,
        dissipated: None,
        hysteresis: Optional(None),
        edge: event.edge,
    }
}

/// Radius, indentation and force of a state; the controlled one has the value of the control.
pub(crate) fn quantities<R: SceneReal>(
    control: &Control<R>,
    state: &ContactState<R>,
    value: &R,
) -> [Option<Value<R>>; 3] {
    let known = |number: &R| Some(Value::Known(number.clone()));
    match state {
        ContactState::Contact(rest) => {
            let rest = rest.clone().controlled(control, value.clone());
            [rest.contact_radius, rest.indentation, rest.force].map(|number| Some(Value::Known(number)))
        }
        // Without a force the spring of a machine is slack; a dead load leaves the position open.
        ContactState::Detached => match control {
            Control::Force => [None, None, known(&value.lit(0))],
            _ => [None, known(value), known(&value.lit(0))],
        },
        ContactState::Complete => [None, None, None],
    }
}

/// Why a path cannot be followed to the state of an event.
fn open_reason<R: SceneReal>(event: &Event<R>) -> &'static str {
    match event.before {
        _ if event.ring.is_some() => {
            "on the way on the surfaces come to touch outside of the contact; in which state is not decided"
        }
        ContactState::Detached => {
            "where the surfaces first touch is not decided: the profile may be lower elsewhere than at the tip; or the contact comes to rest \
             where g is not resolved"
        }
        _ => "no equilibrium was found up to here, and none is known at an end of the profile",
    }
}

/// The values of a state that was not found.
fn not_found<R: SceneReal>(control: &Control<R>, value: &R, why: &'static str) -> [Option<Value<R>>; 3] {
    let open = || Some(Value::unknown(Status::Undecided, why));
    let given = || Some(Value::Known(value.clone()));
    match control {
        Control::Indentation => [open(), given(), open()],
        Control::Force => [open(), open(), given()],
        Control::Machine { .. } => [open(), open(), open()],
    }
}

/// The events of a path with the energy lost in each, and the balance of its energy. `way` are its way points.
///
/// # Errors
/// Errors of the transform; [`Error::OutOfRange`] if an energy is not representable.
pub(crate) fn with_energy<R: SceneReal>(
    path: &Path<R>,
    way: &[Literal],
    branches: &SearchedBranches<R>,
) -> Result<PathNumbers<Estimate<R>>> {
    let losses = path.events.iter().zip(path::Dissipation::of_each(path, branches));
    let losses = losses.map(|(event, loss)| dissipated(event, loss)).collect::<Result<Vec<_>>>()?;
    let balance = balance(path, way, stored(path, branches), &losses)?;
    let events = alone(path, branches).into_iter().zip(losses);
    let events = events.map(|(event, dissipated)| PathEvent { dissipated, ..event }).collect();
    Ok(PathNumbers { events, balance })
}

/// The events of a path with contact radii, without energies.
pub(crate) fn alone<R: SceneReal>(path: &Path<R>, branches: &SearchedBranches<R>) -> Vec<PathEvent<Estimate<R>>> {
    of_contact(branches.curve(), path, branches.admissibility()).convert(Estimate::exact)
}

/// The energy lost in an event; unknown where its integral does not converge.
pub(super) fn dissipated<R: SceneReal>(
    event: &Event<R>,
    loss: Result<path::Dissipation<R>>,
) -> Result<Option<Dissipation<Estimate<R>>>> {
    Ok(match loss {
        _ if !changes(event.kind) => None,
        Ok(path::Dissipation::Unbounded) => Some(Dissipation::Unbounded),
        Ok(path::Dissipation::Finite(dissipated)) => {
            Some(Dissipation::Finite(beyond_noise(&dissipated, &dissipated.error)))
        }
        Err(error) => Some(Dissipation::Finite(unknown(error)?)),
    })
}

/// An energy that could not be computed.
pub(super) fn unknown<N>(error: Error) -> Result<Value<N>> {
    match error {
        Error::OutOfRange { .. } => Err(error),
        Error::Undecided { .. } => Ok(Value::unknown(Status::Undecided, error.to_string())),
        error => Value::from_result(Err(error)),
    }
}

/// Energy balance of a path: work, dissipation, increase of stored energy. `None` if a term is unbounded or the path could not be
/// followed.
///
/// The work is the sum of the other two, which have one sign or are of one size. Its own integral would cancel on a way to
/// and fro.
///
/// # Errors
/// Errors of the transform; [`Error::OutOfRange`] if an energy is not representable.
pub(super) fn balance<R: SceneReal>(
    path: &Path<R>,
    way: &[Literal],
    stored: Result<Option<Estimate<R>>>,
    losses: &[Option<Dissipation<Estimate<R>>>],
) -> Result<Option<Balance<Estimate<R>>>> {
    let lost_track = path.events.iter().any(|event| event.kind == EventKind::Undecided);
    let Some(first) = path.events.first().filter(|_| !lost_track) else { return Ok(None) };
    let mut dissipated = Value::Known(Estimate::exact(first.value.lit(0)));
    for loss in losses.iter().flatten() {
        match loss {
            Dissipation::Unbounded => return Ok(None),
            Dissipation::Finite(loss) => dissipated = plus(&dissipated, loss),
        }
    }
    let stored = match stored {
        Ok(Some(stored)) if returns(path, way) => Value::Known(Estimate::exact(stored.value.lit(0))),
        Ok(Some(stored)) => beyond_noise(&stored, &stored.error),
        Ok(None) => return Ok(None),
        Err(error) => unknown(error)?,
    };
    let work = work(&dissipated, &stored);
    Ok(Some(Balance { work, dissipated, stored, jumps: Optional(None), hysteresis: Optional(None) }))
}

/// The sum of two energies, of which one may be unknown.
pub(super) fn plus<R: SceneReal>(one: &Value<Estimate<R>>, other: &Value<Estimate<R>>) -> Value<Estimate<R>> {
    match (one, other) {
        (Value::Known(one), Value::Known(other)) => {
            let mut sum = one.clone();
            sum += other;
            Value::Known(sum)
        }
        (Value::Known(_), unknown) => unknown.clone(),
        (unknown, _) => unknown.clone(),
    }
}

/// Whether the path ends in the state in which it starts, at a way point with the same number.
fn returns<R: SceneReal>(path: &Path<R>, way: &[Literal]) -> bool {
    let closed = way.first().zip(way.last()).is_some_and(|(first, last)| first.compare(last).is_eq());
    let [first, last] = [path.events.first(), path.events.last()].map(|event| event.map(|event| &event.after));
    path.is_finished() && closed && first == last
}

/// The work of the control, unless it is nothing but the rounding of the terms of its sum.
pub(super) fn work<R: SceneReal>(dissipated: &Value<Estimate<R>>, stored: &Value<Estimate<R>>) -> Value<Estimate<R>> {
    /// Unit roundoffs of an energy.
    const ROUNDINGS: i64 = 1024;
    let work = plus(dissipated, stored);
    let (Value::Known(sum), Value::Known(dissipated), Value::Known(stored)) = (&work, dissipated, stored) else {
        return work;
    };
    let noise = (dissipated.value.abs() + stored.value.abs()) * sum.value.unit_roundoff().times(ROUNDINGS);
    beyond_noise(sum, &noise)
}

/// An energy, unless it is nothing but its error: a zero that is not exact is none.
pub(crate) fn beyond_noise<R: SceneReal>(energy: &Estimate<R>, noise: &R) -> Value<Estimate<R>> {
    if energy.value.abs() > *noise || *noise == noise.lit(0) {
        return Value::Known(energy.clone());
    }
    Value::unknown(Status::Undecided, "zero up to the rounding of the energies that it is made of")
}

/// Whether the state is another one after the event.
pub(crate) fn changes(kind: EventKind) -> bool {
    use EventKind::{CompleteContact, Detached, Jump, JumpIn, Touch};
    matches!(kind, Touch | JumpIn | Jump | Detached | CompleteContact)
}

/// Whether the event is the arrival at a way point.
pub(crate) fn is_arrival(kind: EventKind) -> bool {
    matches!(kind, EventKind::Start | EventKind::WayPoint | EventKind::End)
}
