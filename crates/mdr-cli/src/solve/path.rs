//! The output `path`: one record for each event.

use mdr_core::contact::{Control, Equilibrium, Error, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::branch::Branched;
use mdr_numeric::path::{Balance, Entry, Event, EventKind, Ledger, Loss, Path, Start as Begin, State};

use super::contact::{Arithmetic, Contact};
use super::record::{Field, Record};
use crate::scene::{Held, Start};

/// The path of a scene.
///
/// # Errors
/// As [`Path::follow`].
pub(crate) fn follow<R: Arithmetic>(contact: &Contact<R>, branches: &impl Branched<R>, held: &Held) -> Result<Path<R>> {
    let way: Vec<R> = held.path.iter().map(|point: &Literal| contact.number(point)).collect();
    Path::follow(branches, &start(contact, held), &way)
}

/// Where the path of a scene starts.
pub(crate) fn start<R: Arithmetic>(contact: &Contact<R>, held: &Held) -> Begin<R> {
    match &held.start {
        Start::Largest => Begin::Largest,
        Start::Smallest => Begin::Smallest,
        Start::Radius(radius) => Begin::Nearest(contact.number(radius)),
        Start::Detached => Begin::Detached,
    }
}

/// The records of events, with the energy that is lost in each.
pub(crate) fn records<R: Arithmetic>(control: &Control<R>, path: &Path<R>, lost: Vec<Field<R>>) -> Vec<Record<R>> {
    path.events.iter().zip(lost).map(|(event, lost)| record(control, event).with("dissipated", lost)).collect()
}

fn record<R: Arithmetic>(control: &Control<R>, event: &Event<R>) -> Record<R> {
    let [radius, indentation, force] = match event.kind {
        EventKind::Undecided => not_found(control, &event.value),
        _ => quantities(control, &event.before, &event.value),
    };
    let [to_radius, to_indentation, to_force] = if changes(event.kind) {
        quantities(control, &event.after, &event.value)
    } else {
        [Field::Absent, Field::Absent, Field::Absent]
    };
    let named = Record::new().with("event", Field::Word(name(event.kind)));
    let placed = match control {
        Control::Machine { .. } => named.with("position", Field::Number(event.value.clone())),
        _ => named,
    };
    placed
        .with("indentation", indentation)
        .with("force", force)
        .with("contact_radius", radius)
        .with("to_contact_radius", to_radius)
        .with("to_indentation", to_indentation)
        .with("to_force", to_force)
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

/// What is known of a state that was not found.
fn not_found<R: Arithmetic>(control: &Control<R>, value: &R) -> [Field<R>; 3] {
    let why = "no equilibrium was found up to here, and the profile does not end";
    let open = || Field::Marked { status: Status::Undecided, log10: None, why: Some(why.to_owned()) };
    let held = || Field::Number(value.clone());
    match control {
        Control::Indentation => [open(), held(), open()],
        Control::Force => [open(), open(), held()],
        Control::Machine { .. } => [open(), open(), open()],
    }
}

/// The energy lost in each event, as its ledger has it.
pub(crate) fn losses<R: Arithmetic>(path: &Path<R>, ledger: &Ledger<R>) -> Vec<Field<R>> {
    let of = |(event, entry): (&Event<R>, &Entry<R>)| match &entry.lost {
        _ if !changes(event.kind) => Field::Absent,
        Loss::Finite(lost) => Field::Number(lost.value.clone()),
        Loss::Unbounded => Field::Word("unbounded"),
    };
    path.events.iter().zip(&ledger.entries).map(of).collect()
}

/// The energy lost in each event, where its integral does not converge.
pub(crate) fn unknown_losses<R: Arithmetic>(path: &Path<R>, error: &Error) -> Vec<Field<R>> {
    let unknown = || Field::Marked { status: Status::Undecided, log10: None, why: Some(error.to_string()) };
    path.events.iter().map(|event| if changes(event.kind) { unknown() } else { Field::Absent }).collect()
}

/// The books of a path: the work of the control, the energy lost, and what is stored more than at the start.
///
/// The work is the sum of the other two, which have one sign or are of one size. Its own integral would cancel on a way to
/// and fro.
pub(crate) fn balance<R: Arithmetic>(balance: Balance<R>) -> Record<R> {
    let work = balance.stored.clone() + &balance.lost;
    let numbers = [("work", work), ("dissipated", balance.lost), ("stored", balance.stored)];
    numbers.into_iter().fold(Record::new(), |record, (key, value)| record.with(key, Field::Number(value)))
}

/// Whether the state is another one after the event.
fn changes(kind: EventKind) -> bool {
    use EventKind::{CompleteContact, Detached, Jump, JumpIn, Touch};
    matches!(kind, Touch | JumpIn | Jump | Detached | CompleteContact)
}

/// As an answer names it.
pub(crate) fn name(kind: EventKind) -> &'static str {
    match kind {
        EventKind::Start => "start",
        EventKind::Touch => "touch",
        EventKind::JumpIn => "jump-in",
        EventKind::Jump => "jump",
        EventKind::Detached => "detached",
        EventKind::CompleteContact => "complete-contact",
        EventKind::EndOfProfile => "end-of-profile",
        EventKind::Undecided => "undecided",
        EventKind::NotAdmissible => "not-admissible",
        EventKind::WayPoint => "way-point",
        EventKind::End => "end",
    }
}
