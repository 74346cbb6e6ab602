//! The energies of a path between two works of adhesion over enclosures.
//!
//! Π = U − w₁A is stored. A jump of the edge with the work of adhesion w loses the difference of U − wA before and after it, and
//! a receding edge w₂ − w₁ for each unit of area that it leaves; see [`EdgeEnergies`](mdr_numeric::path::EdgeEnergies).

use std::cmp::Ordering;

use mdr_core::contact::{Control, Edge, Error, Quantity, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Real};
use mdr_numeric::contact::Contact;
use mdr_numeric::path::{ContactState, Event, EventKind, Path};
use mdr_numeric::proof::{EnclosedEnergy, StoredEnergy};

use super::energies::{lost_in, returns, value, work_in};
use super::{Balance, Dissipation, PathEvent, PathNumbers, changes, written};
use crate::answer::Optional;

/// The energy lost in each event and by a receding edge, as records without other numbers, and the balance of a path along way points.
/// The contact is that of the advancing edge.
///
/// # Errors
/// Errors of the transform and of the integrals, see [`EnclosedEnergy::stored`]; [`Error::Undecided`] if it is not certain whether
/// the edge recedes.
pub(super) fn of_path(
    path: &Path<Interval>,
    way: &[Literal],
    contact: &Contact<Interval>,
    energy: &EnclosedEnergy<'_>,
) -> Result<PathNumbers<Enclosure>> {
    let stored = Stored::new(path, contact, energy)?;
    let (stays, written) = (path.stays(contact.vertical_edge().as_ref()), written(way, path));
    let (mut jumps, mut hysteresis) = (Some(StoredEnergy::default()), StoredEnergy::default());
    let mut events: Vec<PathEvent<Enclosure>> = Vec::new();
    for (index, event) in path.events.iter().enumerate() {
        let swept = match index.checked_sub(1) {
            Some(last) => {
                let at_one_value =
                    written[last].zip(written[index]).is_some_and(|(one, other)| one.compare(other).is_eq());
                on_the_way(&path.events[last], event, stays[index] || at_one_value)?
                    .plus(&receded(&event.before, &event.after)?)
            }
            None => StoredEnergy::default(),
        };
        let lost = swept.energy().map_or_else(StoredEnergy::default, |area| (stored.more.clone() * area).into());
        hysteresis = hysteresis.plus(&lost);
        let dissipated = if !changes(event.kind) {
            None
        } else if is_unbounded(event, contact) {
            jumps = None;
            Some(Dissipation::Unbounded)
        } else {
            let jump = stored.lost(index, event, contact)?;
            jumps = jumps.zip(jump.clone()).map(|(total, jump)| total.plus(&jump));
            jump.map(|jump| Dissipation::Finite(value(jump)))
        };
        events.push(PathEvent { hysteresis: Optional(Some(value(lost))), ..lost_in(event.kind, dissipated) });
    }
    let balance = jumps.zip(stored.ends()).map(|(jumps, (first, last))| {
        let stored = if returns(path, way) { StoredEnergy::default() } else { last.minus(&first) };
        let dissipated = jumps.clone().plus(&hysteresis);
        let work = dissipated.clone().plus(&stored);
        let [work, dissipated, stored, jumps, hysteresis] = [work, dissipated, stored, jumps, hysteresis].map(value);
        Balance { work, dissipated, stored, jumps: Optional(Some(jumps)), hysteresis: Optional(Some(hysteresis)) }
    });
    let lost_track = path.events.iter().any(|event| event.kind == EventKind::Undecided);
    Ok(PathNumbers { events, balance: balance.filter(|_| !lost_track) })
}

/// Π = U − w₁A of the states before and after each event.
struct Stored {
    pairs: Vec<[Option<StoredEnergy>; 2]>,
    /// w₂ − w₁.
    more: Interval,
}

impl Stored {
    fn new(path: &Path<Interval>, contact: &Contact<Interval>, energy: &EnclosedEnergy<'_>) -> Result<Self> {
        let states: Vec<&ContactState<Interval>> =
            path.events.iter().flat_map(|event| [&event.before, &event.after]).collect();
        let mut all = energy.stored(&states)?.into_iter();
        let mut next = || all.next().flatten();
        let pairs = path.events.iter().map(|_| [next(), next()]).collect();
        let adhesion = contact.adhesion();
        Ok(Stored { pairs, more: adhesion.of(Edge::Receding).clone() - adhesion.of(Edge::Advancing) })
    }

    /// The difference of U − wA in a jump, w that of the edge that drives it.
    fn lost(&self, index: usize, event: &Event<Interval>, contact: &Contact<Interval>) -> Result<Option<StoredEnergy>> {
        let [before, after] = self.pairs[index].clone();
        let Some((before, after)) = before.zip(after) else { return Ok(None) };
        let lost = before.minus(&after).plus(&work_in(event, contact));
        if event.edge == Some(Edge::Advancing) {
            return Ok(Some(lost));
        }
        let [from, to] = [&event.before, &event.after].map(area);
        let (Some(from), Some(to)) = (from, to) else { return Ok(None) };
        let swept = from.minus(&to);
        Ok(Some(match swept.energy() {
            Some(area) => lost.minus(&(self.more.clone() * area).into()),
            None => lost,
        }))
    }

    /// In the first state and in the last one.
    fn ends(&self) -> Option<(StoredEnergy, StoredEnergy)> {
        self.pairs.first()?[1].clone().zip(self.pairs.last()?[1].clone())
    }
}

/// πa², exactly nothing where the surfaces are apart; `None` for complete contact.
fn area(state: &ContactState<Interval>) -> Option<StoredEnergy> {
    match state {
        ContactState::Contact(rest) if rest.contact_radius.upper().is_zero() => Some(StoredEnergy::default()),
        ContactState::Contact(rest) => {
            let a = &rest.contact_radius;
            Some((a.square() * a.pi()).into())
        }
        ContactState::Detached => Some(StoredEnergy::default()),
        ContactState::Complete => None,
    }
}

/// The area that the edge leaves between two events, on the way to the second of which it may stay where it is. One that moves may have moved
/// by less than these enclosures tell.
fn on_the_way(last: &Event<Interval>, event: &Event<Interval>, stays: bool) -> Result<StoredEnergy> {
    if let (Some(from), Some(to)) = (last.after.contact(), event.before.contact())
        && !stays
        && from.contact_radius.is_same(&to.contact_radius)
        && !from.contact_radius.upper().is_zero()
        && event.value.partial_cmp(&last.value) != Some(Ordering::Greater)
    {
        return Err(unseen(from.contact_radius.precision()));
    }
    receded(&last.after, &event.before)
}

fn unseen(bits: u32) -> Error {
    Error::Undecided { quantity: Quantity::ContactRadius, bits, what: "whether the edge recedes" }
}

/// The area that is left between two states; exactly nothing where the edge does not recede.
fn receded(from: &ContactState<Interval>, to: &ContactState<Interval>) -> Result<StoredEnergy> {
    let (Some(before), Some(after)) = (area(from), area(to)) else { return Ok(StoredEnergy::default()) };
    let order = match (before.energy(), after.energy()) {
        (None, _) => Some(Ordering::Less),
        (Some(_), None) => Some(Ordering::Greater),
        (Some(one), Some(other)) if one.is_same(other) => Some(Ordering::Equal),
        (Some(one), Some(other)) => one.partial_cmp(other),
    };
    match order {
        Some(Ordering::Greater) => Ok(before.minus(&after)),
        Some(_) => Ok(StoredEnergy::default()),
        None => Err(unseen(before.energy().map_or(0, Real::precision))),
    }
}

/// Whether a dead load falls without end, or an infinite surface comes into contact.
fn is_unbounded(event: &Event<Interval>, contact: &Contact<Interval>) -> bool {
    let in_contact = event.before.contact().is_some_and(|rest| !rest.contact_radius.upper().is_zero());
    let falls = event.kind == EventKind::Detached && *contact.control() == Control::Force && in_contact;
    event.kind == EventKind::CompleteContact || falls
}
