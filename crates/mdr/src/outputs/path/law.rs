//! The path of a power law, with energies that are sums over its states.

use std::cmp::Ordering;

use mdr_analytic::certified::{Curve, EnergySum, PathPoint};
use mdr_core::contact::{Control, ControlKind, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Real};
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::path::{ContactState, Event, EventKind, Path};
use rug::Rational;

use super::{Balance, Dissipation, PathEvent, PathNumbers, changes, events as records, is_arrival};
use crate::answer::record::{Numbers, Part};
use crate::answer::{Optional, Value};
use crate::solve::law_branches::LawBranches;
use crate::solve::power_law::PowerLaw;

/// The events of the path of a scene and the balance of its energy.
///
/// # Errors
/// No stable equilibrium at the first way point; a decision that the enclosures do not make. See [`Path::follow`].
pub(super) fn events(law: &PowerLaw<'_>, curve: &Curve) -> Result<PathNumbers<Enclosure>> {
    let values: Vec<Rational> = law.scene.path.iter().map(|point| law.number(point)).collect();
    let branches = LawBranches::new(curve, values.clone());
    let way: Vec<Interval> = values.iter().map(|value| branches.enclose(value)).collect();
    let order: Vec<Ordering> = values.windows(2).map(|pair| pair[1].cmp(&pair[0])).collect();
    let path = Path::follow_ordered(&branches, &law.begin(&branches), &way, &order)?;
    let traced = Traced { law, branches };
    let mut way_points = values.into_iter();
    let lines = path.events.iter().map(|event| traced.line(event, &mut way_points)).collect::<Result<Vec<_>>>()?;
    let mut events = records::events(curve.control(), &path, Admissibility::rising()).convert(Enclosure::from);
    events.iter_mut().zip(&lines).for_each(|(event, line)| traced.write(event, line));
    Ok(PathNumbers { events, balance: traced.balance(&lines) })
}

/// An event with its states as far as they have a radius, and the energy lost in it.
struct Line<'a> {
    event: &'a Event<Interval>,
    states: [Option<PathPoint>; 2],
    /// The controlled quantity.
    value: Enclosure,
    dissipated: Option<Dissipation<EnergySum>>,
}

/// The branches of a power law, with its scene.
struct Traced<'a> {
    law: &'a PowerLaw<'a>,
    branches: LawBranches<'a>,
}

impl Traced<'_> {
    /// The line of an event; events at way points come in their order.
    fn line<'e>(&self, event: &'e Event<Interval>, way: &mut impl Iterator<Item = Rational>) -> Result<Line<'e>> {
        let curve = self.branches.curve;
        let held = match event.kind {
            kind if is_arrival(kind) => way.next(),
            // Surfaces meet and part at zero.
            kind if changes(kind) && event.fold.is_none() => Some(Rational::new()),
            _ => None,
        };
        let found = |state: &ContactState<Interval>| match (state, &held) {
            (ContactState::Contact(rest), Some(value)) if rest.contact_radius > rest.contact_radius.lit(0) => {
                self.branches.at(value, rest).map(Some)
            }
            _ => Ok(None),
        };
        let states = match (event.kind, event.fold) {
            (EventKind::Jump, Some(fold)) => [curve.at_fold(fold), curve.past_fold(fold)?.map(|(_, rest)| rest)],
            (_, Some(fold)) => [curve.at_fold(fold), None],
            _ => [found(&event.before)?, found(&event.after)?],
        };
        let exact = held.or_else(|| curve.exact_fold(event.fold?).cloned());
        let value = match (exact, event.fold) {
            (Some(value), _) => value.into(),
            (None, Some(fold)) => curve.controlled(&curve.folds()[fold].0).enclosure(),
            (None, None) => event.value.clone().into(),
        };
        let falls = event.fold.is_some() && *curve.control() == Control::Force;
        let dissipated = match event.kind {
            EventKind::CompleteContact => Some(Dissipation::Unbounded),
            EventKind::Detached if falls => Some(Dissipation::Unbounded),
            kind if changes(kind) => {
                Some(Dissipation::Finite(Value::Known(EnergySum::difference(states[0].as_ref(), states[1].as_ref()))))
            }
            _ => None,
        };
        Ok(Line { event, states, value, dissipated })
    }

    /// Gives an event its numbers at any scale, exact where they are.
    fn write(&self, record: &mut PathEvent<Enclosure>, line: &Line<'_>) {
        let put = |slot: &mut Option<Value<Enclosure>>, number: &Enclosure| {
            if let Some(Value::Known(known)) = slot {
                *known = number.clone();
            }
        };
        put(&mut record.position.0, &line.value);
        let control = self.law.scene.control.kind();
        let before = [&mut record.contact_radius, &mut record.indentation, &mut record.force];
        let after = [&mut record.to_contact_radius, &mut record.to_indentation, &mut record.to_force];
        let states = [&line.event.before, &line.event.after].into_iter().zip(&line.states);
        for ([radius, indentation, force], (state, known)) in [before, after].into_iter().zip(states) {
            if let Some(known) = known {
                let state = self.law.state(self.branches.curve, known.point(), None);
                put(radius, &state.contact_radius);
                put(indentation, &state.indentation);
                put(force, &state.force);
            }
            match (control, state) {
                (ControlKind::Indentation, _) | (ControlKind::Machine, ContactState::Detached) => {
                    put(indentation, &line.value)
                }
                (ControlKind::Force, ContactState::Contact(_)) => put(force, &line.value),
                _ => {}
            }
        }
        let sum = |sum: EnergySum| Value::Known(sum.value(self.branches.curve));
        record.dissipated = line.dissipated.clone().map_part(&mut |value| value.and_then(sum));
    }

    /// The work of the control, the energy lost, and the increase of the stored energy. `None` if one of them has no bound.
    fn balance(&self, lines: &[Line<'_>]) -> Option<Balance<Enclosure>> {
        let dissipated = lines.iter().try_fold(EnergySum::default(), |sum, line| match &line.dissipated {
            None => Some(sum),
            Some(Dissipation::Finite(Value::Known(dissipated))) => Some(sum.plus(dissipated)),
            Some(_) => None,
        })?;
        let [first, last] = [lines.first()?, lines.last()?].map(|line| line.states[1].as_ref());
        let stored = EnergySum::difference(last, first);
        let work = dissipated.clone().plus(&stored);
        let [work, dissipated, stored] = [work, dissipated, stored].map(Value::Known);
        let (jumps, hysteresis) = (Optional(None), Optional(None));
        Some(Balance { work, dissipated, stored, jumps, hysteresis }.convert(|sum| sum.value(self.branches.curve)))
    }
}
