//! The energies of a path over enclosures, from what is stored in its states.
//!
//! An event at a fixed value of the control loses the difference of Π − Fd, of Π, or of Π + F²/2k before and after it; the work of
//! the control is what is lost and what is stored.

use mdr_core::contact::{Control, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal};
use mdr_numeric::contact::Contact;
use mdr_numeric::path::{ContactState, Event, EventKind, Path};
use mdr_numeric::proof::{EnclosedEnergy, StoredEnergy};
use rug::Rational;

use super::{Balance, Dissipation, PathEvent, PathNumbers, changes};
use crate::answer::{Admission, Optional, Value};

/// The energy lost in each event, as records without other numbers, and the balance of a path along way points.
///
/// # Errors
/// Errors of the transform and of the integrals; see [`EnclosedEnergy::stored`].
pub(super) fn of_path(
    path: &Path<Interval>,
    way: &[Literal],
    contact: &Contact<Interval>,
    energy: &EnclosedEnergy<'_>,
) -> Result<PathNumbers<Enclosure>> {
    let jumps = path.events.iter().filter(|event| changes(event.kind));
    let (unbounded, finite): (Vec<_>, Vec<_>) = jumps.partition(|event| is_unbounded(event, contact));
    let lost_track = path.events.iter().any(|event| event.kind == EventKind::Undecided);
    let (has_balance, returns) = (unbounded.is_empty() && !lost_track, returns(path, way));
    // What is stored at the ends costs as much as at a jump.
    let ends = [path.events.first(), path.events.last()].into_iter().flatten().filter(|_| has_balance && !returns);
    let states: Vec<&ContactState<Interval>> =
        finite.iter().flat_map(|event| [&event.before, &event.after]).chain(ends.map(|event| &event.after)).collect();
    let mut stored = energy.stored(&states)?.into_iter();
    let mut next = || stored.next().flatten();
    let mut total = has_balance.then(StoredEnergy::default);
    let mut events = Vec::new();
    for event in &path.events {
        let dissipated = if !changes(event.kind) {
            None
        } else if is_unbounded(event, contact) {
            Some(Dissipation::Unbounded)
        } else {
            let [before, after] = [&event.before, &event.after].map(|state| match state {
                ContactState::Complete => next().or_else(|| energy.complete_contact(&event.value)),
                _ => next(),
            });
            let lost = before.zip(after).map(|(before, after)| before.minus(&after).plus(&work_in(event, contact)));
            total = total.zip(lost.clone()).map(|(total, lost)| total.plus(&lost));
            lost.map(|lost| Dissipation::Finite(value(lost)))
        };
        events.push(lost_in(event.kind, dissipated));
    }
    let stored = if returns {
        Some(StoredEnergy::default())
    } else {
        let [first, last] = [next(), next()];
        first.zip(last).map(|(first, last)| last.minus(&first))
    };
    let balance = total.zip(stored).map(|(dissipated, stored)| {
        let work = dissipated.clone().plus(&stored);
        let [work, dissipated, stored] = [work, dissipated, stored].map(value);
        Balance { work, dissipated, stored, jumps: Optional(None), hysteresis: Optional(None) }
    });
    Ok(PathNumbers { events, balance })
}

pub(super) fn value(sum: StoredEnergy) -> Value<Enclosure> {
    Value::Known(sum.energy().map_or_else(|| Rational::new().into(), |energy| energy.clone().into()))
}

/// The losses of a path whose jumps are all falls of a dead load, without bound; `None` if another is among them.
pub(super) fn of_falls(path: &Path<Interval>, control: &Control<Interval>) -> Option<PathNumbers<Enclosure>> {
    let mut jumps = path.events.iter().filter(|event| changes(event.kind)).peekable();
    jumps.peek()?;
    if !jumps.all(|event| falls(event, control)) {
        return None;
    }
    let lost = |event: &Event<Interval>| changes(event.kind).then_some(Dissipation::Unbounded);
    let events = path.events.iter().map(|event| lost_in(event.kind, lost(event))).collect();
    Some(PathNumbers { events, balance: None })
}

/// Whether a dead load falls without end.
fn falls(event: &Event<Interval>, control: &Control<Interval>) -> bool {
    event.kind == EventKind::Detached && event.fold.is_some() && *control == Control::Force
}

/// Whether a dead load falls without end, or an infinite surface comes into contact.
fn is_unbounded(event: &Event<Interval>, contact: &Contact<Interval>) -> bool {
    match event.kind {
        EventKind::CompleteContact => contact.transform().complete_contact().is_none(),
        _ => falls(event, contact.control()),
    }
}

/// F(d₂ − d₁) of a dead load between two contacts; where the surfaces are apart on one side it is 0.
pub(super) fn work_in(event: &Event<Interval>, contact: &Contact<Interval>) -> StoredEnergy {
    let depth = |state: &ContactState<Interval>| match state {
        ContactState::Complete => contact.transform().complete_contact().map(|[depth, _]| depth),
        _ => state.contact().map(|rest| rest.indentation.clone()),
    };
    match (contact.control(), depth(&event.before), depth(&event.after)) {
        (Control::Force, Some(before), Some(after)) => ((after - before) * &event.value).into(),
        _ => StoredEnergy::default(),
    }
}

/// Whether the path ends in the state in which it starts, at a way point with the same number: the enclosures of two equilibria at
/// one value are the same only if these are.
pub(super) fn returns(path: &Path<Interval>, way: &[Literal]) -> bool {
    let closed = way.first().zip(way.last()).is_some_and(|(first, last)| first.compare(last).is_eq());
    let [first, last] = [path.events.first(), path.events.last()].map(|event| event.map(|event| &event.after));
    let same = match (first, last) {
        (Some(ContactState::Contact(one)), Some(ContactState::Contact(other))) => {
            let [one, other] = [one, other].map(|rest| &rest.contact_radius);
            one.is_same(other)
        }
        (Some(ContactState::Detached), Some(ContactState::Detached)) => true,
        _ => false,
    };
    path.is_finished() && closed && same
}

/// An event with its energy alone.
pub(super) fn lost_in(kind: EventKind, dissipated: Option<Dissipation<Enclosure>>) -> PathEvent<Enclosure> {
    PathEvent {
        event: kind,
        position: Optional(None),
        indentation: None,
        force: None,
        contact_radius: None,
        to_contact_radius: None,
        to_indentation: None,
        to_force: None,
        admissible: Admission::Admissible,
        dissipated,
        hysteresis: Optional(None),
        edge: None,
    }
}
