//! The contacts of the legs of a record over intervals: of an edge that advances, and of edges that are pinned before they recede.

use mdr_core::contact::{Edge, Result};
use mdr_core::number::{Dual, Interval, Precision, Real};

use super::super::contact::{Contact, Numbers, Tip};
use super::super::minimise::Minimum;
use super::super::objective::Objective;
use super::super::observation::Observation;
use super::super::problem::Kind;
use super::super::sheet::Sheet;
use super::rows::{Moving, point};
use super::{OUT_OF_RANGE, exact};

/// Where the edge of the contact is pinned.
pub(super) struct Pinned {
    /// A radius near it.
    near: f64,
    /// X and time where the record turns.
    turn: [Interval; 2],
}

/// The pins of the sheets of a minimum.
///
/// # Errors
/// A sentence that says why one has no proof.
pub(super) fn pins(
    objective: &Objective<'_>,
    minimum: &Minimum,
    precision: Precision,
) -> std::result::Result<Vec<Option<Pinned>>, String> {
    let evaluation = &minimum.evaluation;
    let pinned = |(index, sheet): (usize, &Sheet)| {
        let Some(pin) = sheet.pin else { return Ok(None) };
        if pin.is_at_end {
            return Err(
                "certified digits are not given where a record turns before its approach is in contact".to_owned()
            );
        }
        let first = objective.rows.iter().find(|row| evaluation.sheet_of(row) == index).ok_or(OUT_OF_RANGE)?;
        let of = |value: f64| exact(precision, value).ok_or(OUT_OF_RANGE);
        let [x, time] = objective.problem.turns[first.part as usize];
        Ok(Some(Pinned { near: pin.radius, turn: [of(x)?, of(time)?] }))
    };
    evaluation.sheets.iter().enumerate().map(pinned).collect()
}

/// The contacts of all sheets at these numbers.
///
/// # Errors
/// [`Error::Undecided`](mdr_core::contact::Error::Undecided) if the radius of a pinned edge is not enclosed well enough; errors of the transform.
pub(super) fn contacts<'t>(
    tip: &'t Tip<Moving>,
    numbers: &Numbers<Moving>,
    observation: Observation,
    pins: &[Option<Pinned>],
    kinds: &[Kind],
) -> Result<Vec<Contact<'t, Moving>>> {
    let of = |edge: Option<Edge>| {
        let mut numbers = numbers.clone();
        if let (Some(works), Some(edge)) = (&numbers.works, edge) {
            numbers.work = works[edge as usize].clone();
        }
        let mut contact = Contact::new(tip, numbers, observation);
        contact.direction = edge;
        contact
    };
    if numbers.works.is_none() {
        return Ok(vec![of(None)]);
    }
    let mut contacts = vec![of(Some(Edge::Advancing))];
    for pin in pins.iter().skip(1) {
        let mut contact = of(Some(Edge::Receding));
        if let Some(pin) = pin {
            let (radius, speeds) = pinned(&contacts[0], pin, kinds)?;
            (contact.edge, contact.pinned) = (Some(radius), Some(speeds));
        }
        contacts.push(contact);
    }
    Ok(contacts)
}

/// The radius at which an edge that advances is where the record turns, and how it moves with each number.
fn pinned(advancing: &Contact<'_, Moving>, pin: &Pinned, kinds: &[Kind]) -> Result<(Moving, Vec<(Kind, Moving)>)> {
    let [x, time] = pin.turn.each_ref().map(|number| Dual::constant(number.clone()));
    let [x, _] = advancing.numbers.without_trends([&x, &x, &time]);
    let turn = point(advancing, pin.near, |point| Ok((point.at[0].clone() - &x, point.tangent[0].clone())))?;
    let speed = |kind: &Kind| {
        let [own, _] = advancing.partial(*kind, &turn)?;
        let drift = if *kind == Kind::PositionDrift { time.clone() } else { x.lit(0) };
        Ok((*kind, -(own + drift) / &turn.tangent[0]))
    };
    let speeds = kinds.iter().map(speed).collect::<Result<_>>()?;
    Ok((turn.a, speeds))
}
