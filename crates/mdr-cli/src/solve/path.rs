//! The output `path`: one record for each event.

use mdr_core::contact::{Control, Equilibrium, Result};
use mdr_core::number::Literal;
use mdr_numeric::branch::Branched;
use mdr_numeric::energy::Energy;
use mdr_numeric::path::{Event, EventKind, Path, Start as Begin, State};

use super::contact::{Arithmetic, Contact};
use super::record::{Field, Record};
use crate::scene::{Held, Start};

/// The events of the path of a scene, without the energy that they dissipate.
///
/// # Errors
/// As [`Path::follow`].
pub(crate) fn follow<R: Arithmetic>(
    contact: &Contact<R>,
    branches: &impl Branched<R>,
    held: &Held,
) -> Result<Vec<Event<R>>> {
    let start = match &held.start {
        Start::Largest => Begin::Largest,
        Start::Smallest => Begin::Smallest,
        Start::Radius(radius) => Begin::Nearest(contact.number(radius)),
        Start::Detached => Begin::Detached,
    };
    let way: Vec<R> = held.path.iter().map(|point: &Literal| contact.number(point)).collect();
    Ok(Path::follow(branches, &start, &way)?.events)
}

/// The records of events; `dissipated` gives the energy lost in each.
///
/// # Errors
/// Those of `dissipated`.
pub(crate) fn records<R: Arithmetic>(
    control: &Control<R>,
    events: &[Event<R>],
    dissipated: impl Fn(&Event<R>) -> Result<Field<R>>,
) -> Result<Vec<Record<R>>> {
    let record = |event: &Event<R>| {
        let before = quantities(control, &event.before, &event.value);
        let after = if event.before == event.after {
            [Field::Absent, Field::Absent, Field::Absent]
        } else {
            quantities(control, &event.after, &event.value)
        };
        let [radius, indentation, force] = before;
        let [to_radius, to_indentation, to_force] = after;
        let event_name = Record::new().with("event", Field::Word(name(event.kind)));
        let placed = match control {
            Control::Machine { .. } => event_name.with("position", Field::Number(event.value.clone())),
            _ => event_name,
        };
        Ok(placed
            .with("indentation", indentation)
            .with("force", force)
            .with("contact_radius", radius)
            .with("to_contact_radius", to_radius)
            .with("to_indentation", to_indentation)
            .with("to_force", to_force)
            .with("dissipated", dissipated(event)?))
    };
    events.iter().map(record).collect()
}

/// Radius, indentation and force of a state; the controlled one is what it is held at.
fn quantities<R: Arithmetic>(control: &Control<R>, state: &State<R>, value: &R) -> [Field<R>; 3] {
    let held = || Field::Number(value.clone());
    match state {
        State::Contact(Equilibrium { contact_radius, indentation, force, .. }) => {
            let (d, f) = (Field::Number(indentation.clone()), Field::Number(force.clone()));
            let radius = Field::Number(contact_radius.clone());
            match control {
                Control::Indentation => [radius, held(), f],
                Control::Force => [radius, d, held()],
                Control::Machine { .. } => [radius, d, f],
            }
        }
        // Without a force the spring of a machine is slack; a dead load leaves the position open.
        State::Detached => match control {
            Control::Force => [Field::Absent, Field::Absent, Field::Number(value.lit(0))],
            _ => [Field::Absent, held(), Field::Number(value.lit(0))],
        },
        State::Complete => [Field::Absent, Field::Absent, Field::Absent],
    }
}

/// The energy lost in an event: that of the contact and of what holds it before, less that after, the controlled quantity
/// being the same. None where nothing jumps, and where the state after it has no energy: complete contact, and surfaces
/// that a dead load drives apart.
///
/// # Errors
/// As [`Energy::potential`].
pub(crate) fn dissipated<R: Arithmetic>(contact: &Contact<R>, event: &Event<R>) -> Result<Field<R>> {
    let energy = Energy::new(contact.transform(), contact.material())?;
    let zero = event.value.lit(0);
    let of = |state: &State<R>| match (state, contact.control()) {
        (State::Complete, _) | (State::Detached, Control::Force) => None,
        (State::Detached, _) => Some(Ok(zero.clone())),
        (State::Contact(rest), _) if rest.contact_radius == zero => Some(Ok(zero.clone())),
        (State::Contact(rest), control) => Some(stored(&energy, control, rest)),
    };
    let jumps = matches!(event.kind, EventKind::Jump | EventKind::JumpIn | EventKind::Touch | EventKind::Detached);
    // Contact begins at no load: nothing was stored.
    let before = if event.kind == EventKind::JumpIn { Some(Ok(zero.clone())) } else { of(&event.before) };
    match (before, of(&event.after)) {
        (Some(before), Some(after)) if jumps => Field::from_result(before.and_then(|before| Ok(before - after?))),
        _ => Ok(Field::Absent),
    }
}

/// Π, with the potential of a dead load or the energy in the spring of a machine.
fn stored<R: Arithmetic>(energy: &Energy<'_, R>, control: &Control<R>, rest: &Equilibrium<R>) -> Result<R> {
    let contact = energy.potential(&rest.contact_radius, &rest.indentation)?;
    Ok(match control {
        Control::Indentation => contact,
        Control::Force => contact - rest.force.clone() * &rest.indentation,
        Control::Machine { stiffness } => rest.force.square() / stiffness.clone().times(2) + &contact,
    })
}

/// As an answer names it.
fn name(kind: EventKind) -> &'static str {
    match kind {
        EventKind::Start => "start",
        EventKind::Touch => "touch",
        EventKind::JumpIn => "jump-in",
        EventKind::Jump => "jump",
        EventKind::Detached => "detached",
        EventKind::CompleteContact => "complete-contact",
        EventKind::EndOfProfile => "end-of-profile",
        EventKind::NotAdmissible => "not-admissible",
        EventKind::WayPoint => "way-point",
        EventKind::End => "end",
    }
}
