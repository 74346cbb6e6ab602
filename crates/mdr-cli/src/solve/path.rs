//! The output `path`: one record for each event.

use std::cmp::Ordering;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Equilibrium, Error, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::{Admissibility, Ring, Verdict};
use mdr_numeric::branch::Branched;
use mdr_numeric::equilibrium::Branches;
use mdr_numeric::path::{Event, EventKind, Loss, Path, Start as Begin, State, stored};
use rug::Rational;

use super::contact::{Arithmetic, Contact};
use super::digits::{exact, rounded};
use super::record::{Field, Record, point};
use crate::scene::{Held, Start};

/// The path of a scene.
///
/// # Errors
/// As [`Path::follow`].
pub(crate) fn follow<R: Arithmetic>(contact: &Contact<R>, branches: &impl Branched<R>, held: &Held) -> Result<Path<R>> {
    let way: Vec<R> = held.path.iter().map(|point: &Literal| contact.number(point)).collect();
    let exact: Vec<Rational> = held.path.iter().map(Literal::to_rational).collect();
    let order: Vec<Ordering> = exact.windows(2).map(|pair| pair[1].cmp(&pair[0])).collect();
    Path::follow_ordered(branches, &start(contact, held), &way, &order)
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

/// The records of events, without the energy that is lost in each.
pub(crate) fn records<R: Arithmetic>(
    control: &Control<R>,
    path: &Path<R>,
    admissibility: &Admissibility<'_>,
) -> Vec<Record<R>> {
    path.events.iter().map(|event| judged(record(control, event), event, admissibility)).collect()
}

/// An event with whether the states in it are admissible: all are up to the one that ends the path for that.
fn judged<R: Arithmetic>(record: Record<R>, event: &Event<R>, admissibility: &Admissibility<'_>) -> Record<R> {
    if let Some(ring) = &event.ring {
        return record.overlapping(point(ring.radius.approx(), ring.gap.approx())).because(remedy(event, ring));
    }
    let in_contact = |state: &&Equilibrium<R>| state.contact_radius > state.contact_radius.lit(0);
    match event.after.contact().or(event.before.contact()).filter(in_contact) {
        _ if event.kind == EventKind::Undecided => record.judged(Verdict::Undecided("the state was not found")),
        Some(rest) => record.judged(admissibility.of(rest.contact_radius.approx(), rest.indentation.approx())),
        None => record.judged(Verdict::Admissible),
    }
}

/// Why a path ends, and what may be done.
fn remedy<R: Arithmetic>(event: &Event<R>, ring: &Ring<R>) -> String {
    let radius = format!("{:.5e}", ring.radius.approx()).parse::<f64>().unwrap_or(f64::NAN);
    let remedy = "begin with a contact that reaches beyond it, start = \"largest\", or stay below this value";
    let happens = match event.after {
        _ if ring.gap < ring.gap.lit(0) => "in the state that comes next the surfaces would overlap",
        State::Contact(_) => "outside of the contact the surfaces touch",
        _ => "coming closer the surfaces first touch not at the tip but",
    };
    format!(
        "{happens} on a ring of radius {radius:e} m, where the theory of one simply connected contact ends; {remedy}"
    )
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
    let why = "no equilibrium was found up to here, and none is known at an end of the profile";
    let open = || Field::Marked { status: Status::Undecided, log10: None, why: Some(why.to_owned()) };
    let held = || Field::Number(value.clone());
    match control {
        Control::Indentation => [open(), held(), open()],
        Control::Force => [open(), open(), held()],
        Control::Machine { .. } => [open(), open(), open()],
    }
}

/// One record with the `events` of a path, the energy lost in each, and the `balance` of its energy.
///
/// # Errors
/// Those of the transform; [`Error::OutOfRange`].
pub(crate) fn with_energy<R: Arithmetic>(
    path: &Path<R>,
    held: &Held,
    branches: &Branches<'_, R>,
) -> Result<Vec<Record<Estimate<R>>>> {
    let losses = path.events.iter().zip(Loss::of_each(path, branches));
    let losses = losses.map(|(event, loss)| lost(event, loss)).collect::<Result<Vec<_>>>()?;
    let balance = balance(path, held, branches, &losses)?.into_iter().collect();
    let events = rounded(records(branches.control(), path, branches.admissibility())).into_iter().zip(losses);
    let events = events.map(|(event, lost)| event.with("dissipated", lost)).collect();
    Ok(vec![Record::new().with("events", Field::Records(events)).with("balance", Field::Records(balance))])
}

/// The energy lost in an event. Where its integral does not converge the field says so.
fn lost<R: Arithmetic>(event: &Event<R>, loss: Result<Loss<R>>) -> Result<Field<Estimate<R>>> {
    match loss {
        _ if !changes(event.kind) => Ok(Field::Absent),
        Ok(Loss::Unbounded) => Ok(Field::Word("unbounded")),
        Ok(Loss::Finite(lost)) => {
            let noise = lost.error.clone();
            Ok(beyond_noise(lost, &noise))
        }
        Err(error) => unknown(error),
    }
}

/// An energy that cannot be had.
fn unknown<R>(error: Error) -> Result<Field<R>> {
    match error {
        Error::OutOfRange { .. } => Err(error),
        error => Field::from_result(Err(error)),
    }
}

/// The books of a path: the work of the control, the energy lost, and what is stored more than at the start. None where one of
/// them has no bound, or the path is lost.
///
/// The work is the sum of the other two, which have one sign or are of one size. Its own integral would cancel on a way to
/// and fro.
///
/// # Errors
/// As [`with_energy`].
fn balance<R: Arithmetic>(
    path: &Path<R>,
    held: &Held,
    branches: &Branches<'_, R>,
    losses: &[Field<Estimate<R>>],
) -> Result<Option<Record<Estimate<R>>>> {
    let lost_track = path.events.iter().any(|event| event.kind == EventKind::Undecided);
    let unbounded = losses.iter().any(|lost| matches!(lost, Field::Word(_)));
    let Some(first) = path.events.first().filter(|_| !lost_track && !unbounded) else { return Ok(None) };
    let stored = match stored(path, branches) {
        Ok(Some(stored)) if returns(path, held) => Field::Number(exact(stored.value.lit(0))),
        Ok(Some(stored)) => {
            let noise = stored.error.clone();
            beyond_noise(stored, &noise)
        }
        Ok(None) => return Ok(None),
        Err(error) => unknown(error)?,
    };
    let lost = losses.iter().fold(Field::Number(exact(first.value.lit(0))), |sum, lost| plus(&sum, lost));
    let work = work(&lost, &stored);
    Ok(Some(Record::new().with("work", work).with("dissipated", lost).with("stored", stored)))
}

/// The sum of two energies, of which one may be absent or unknown.
fn plus<R: Arithmetic>(one: &Field<Estimate<R>>, other: &Field<Estimate<R>>) -> Field<Estimate<R>> {
    match (one, other) {
        (Field::Number(one), Field::Number(other)) => Field::Number(Estimate {
            value: one.value.clone() + &other.value,
            error: one.error.clone() + &other.error,
            evaluations: one.evaluations + other.evaluations,
        }),
        (Field::Number(_), Field::Marked { .. }) => other.clone(),
        _ => one.clone(),
    }
}

/// Whether the path ends in the state in which it starts, at a way point with the same number.
fn returns<R: Arithmetic>(path: &Path<R>, held: &Held) -> bool {
    let ends = [held.path.first(), held.path.last()].map(|point| point.map(Literal::to_rational));
    let [first, last] = [path.events.first(), path.events.last()].map(|event| event.map(|event| &event.after));
    path.is_finished() && ends[0] == ends[1] && first == last
}

/// The work of the control, unless it is nothing but the rounding of what it is the sum of.
fn work<R: Arithmetic>(lost: &Field<Estimate<R>>, stored: &Field<Estimate<R>>) -> Field<Estimate<R>> {
    /// Unit roundoffs of an energy.
    const ROUNDINGS: i64 = 1024;
    let work = plus(lost, stored);
    let (Field::Number(sum), Field::Number(lost), Field::Number(stored)) = (&work, lost, stored) else { return work };
    let noise = (lost.value.abs() + stored.value.abs()) * sum.value.unit_roundoff().times(ROUNDINGS);
    beyond_noise(sum.clone(), &noise)
}

/// An energy, unless it is nothing but its error: a zero that is not exact is none, however many precisions agree on it.
fn beyond_noise<R: Arithmetic>(energy: Estimate<R>, noise: &R) -> Field<Estimate<R>> {
    if energy.value.abs() > *noise || *noise == noise.lit(0) {
        return Field::Number(energy);
    }
    let why = "zero up to the rounding of the energies that it is made of";
    Field::Marked { status: Status::Undecided, log10: None, why: Some(why.to_owned()) }
}

/// Whether the state is another one after the event.
pub(crate) fn changes(kind: EventKind) -> bool {
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
