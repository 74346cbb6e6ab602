//! The path of a power law, with energies that are sums over its states.

use std::cmp::Ordering;

use mdr_analytic::certified::{Curve, Point, Scaled};
use mdr_core::contact::{Control, ControlKind, Equilibrium, Error, Fold, FoldKind, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Real};
use mdr_numeric::admissible::{Admissibility, Ring, Touch};
use mdr_numeric::branch::{End, EquilibriumBranches, FirstContact, unordered};
use mdr_numeric::path::{ContactState, Event, EventKind, Path, Start};
use rug::Rational;

use super::{Balance, Dissipation, PathEvent, PathNumbers, changes, events as records, is_arrival};
use crate::answer::record::{Numbers, Part};
use crate::answer::{Optional, Value};
use crate::solve::power_law::PowerLaw;

/// The equilibrium in which a path starts; `None` if it cannot start, or if the surfaces are apart.
///
/// # Errors
/// A decision that the enclosures do not make; see [`Path::first`].
pub(crate) fn start(law: &PowerLaw<'_>, curve: &Curve, first: &Literal) -> Result<Option<Point>> {
    let value = law.number(first);
    let branches = Branches::new(law, curve, vec![value.clone()]);
    match Path::first(&branches, &branches.begin(), &branches.enclose(&value)) {
        Ok(ContactState::Contact(rest)) => Ok(Some(branches.at(&value, &rest)?.point)),
        Ok(_) | Err(Error::NoEquilibrium { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}

/// The events of the path of a scene and the balance of its energy.
///
/// # Errors
/// No stable equilibrium at the first way point; a decision that the enclosures do not make. See [`Path::follow`].
pub(super) fn events(law: &PowerLaw<'_>, curve: &Curve) -> Result<PathNumbers<Enclosure>> {
    let values: Vec<Rational> = law.scene.path.iter().map(|point| law.number(point)).collect();
    let branches = Branches::new(law, curve, values.clone());
    let way: Vec<Interval> = values.iter().map(|value| branches.enclose(value)).collect();
    let order: Vec<Ordering> = values.windows(2).map(|pair| pair[1].cmp(&pair[0])).collect();
    let path = Path::follow_ordered(&branches, &branches.begin(), &way, &order)?;
    let mut way_points = values.into_iter();
    let lines = path.events.iter().map(|event| branches.line(event, &mut way_points)).collect::<Result<Vec<_>>>()?;
    let mut events = records::events(curve.control(), &path, Admissibility::rising()).convert(Enclosure::from);
    events.iter_mut().zip(&lines).for_each(|(event, line)| branches.write(event, line));
    Ok(PathNumbers { events, balance: branches.balance(&lines) })
}

/// The identity of a state.
#[derive(Clone, PartialEq)]
enum Name {
    On {
        branch: usize,
        value: Rational,
    },
    Fold(usize),
    /// Where the contact comes to rest past a fold.
    Landing(usize),
}

/// A state of a contact with a radius.
#[derive(Clone)]
struct Known {
    name: Name,
    point: Point,
}

/// An event with its states as far as they have a radius, and the energy lost in it.
struct Line<'a> {
    event: &'a Event<Interval>,
    states: [Option<Known>; 2],
    /// The controlled quantity.
    value: Enclosure,
    dissipated: Option<Dissipation<Sum>>,
}

/// A sum of stored energies, each with its multiplicity, so that equal terms cancel exactly.
#[derive(Clone, Default)]
struct Sum(Vec<(Known, i64)>);

impl Sum {
    /// One stored energy less another; of no contact it is 0.
    fn between(plus: Option<&Known>, minus: Option<&Known>) -> Self {
        let mut sum = Sum::default();
        [(plus, 1), (minus, -1)].into_iter().for_each(|(known, times)| sum.add(known, times));
        sum
    }

    fn add(&mut self, known: Option<&Known>, times: i64) {
        let Some(known) = known else { return };
        match self.0.iter_mut().find(|(other, _)| other.name == known.name) {
            Some((_, count)) => *count += times,
            None => self.0.push((known.clone(), times)),
        }
    }

    fn plus(mut self, other: &Sum) -> Self {
        other.0.iter().for_each(|(known, times)| self.add(Some(known), *times));
        self
    }

    fn value(&self, curve: &Curve) -> Enclosure {
        let terms = self.0.iter().filter(|(_, times)| *times != 0);
        let terms = terms.map(|(known, times)| curve.stored(&known.point).multiple(*times));
        let sum = terms.reduce(|sum, term| sum.plus(&term));
        sum.map_or_else(|| Rational::new().into(), |sum| sum.enclosure())
    }
}

/// The branches of a power law for a path with some way points.
struct Branches<'a> {
    law: &'a PowerLaw<'a>,
    curve: &'a Curve,
    way: Vec<Rational>,
    folds: Vec<Fold<Interval>>,
}

impl<'a> Branches<'a> {
    fn new(law: &'a PowerLaw<'a>, curve: &'a Curve, way: Vec<Rational>) -> Self {
        let fold = |(point, kind): &(Point, FoldKind)| {
            let Equilibrium { contact_radius, indentation, force, .. } = state(curve, point);
            Fold { contact_radius, indentation, force, kind: *kind }
        };
        Branches { law, curve, way, folds: curve.folds().iter().map(fold).collect() }
    }

    fn enclose(&self, value: &Rational) -> Interval {
        Interval::from_rational(self.curve.precision(), value)
    }

    fn begin(&self) -> Start<Interval> {
        self.law.scene.start.map(|radius| self.enclose(&self.law.number(radius)))
    }

    fn fold(&self, fold: usize) -> Known {
        Known { name: Name::Fold(fold), point: self.curve.folds()[fold].0.clone() }
    }

    /// The state at a value that the path has found.
    fn at(&self, value: &Rational, rest: &Equilibrium<Interval>) -> Result<Known> {
        let count = self.folds.len();
        if let Some(fold) = (0..count).find(|fold| self.curve.exact_fold(*fold) == Some(value)) {
            return Ok(self.fold(fold));
        }
        let (scaled, ln_radius) = (Scaled::from(self.enclose(value)), rest.contact_radius.ln());
        let mut found = Vec::new();
        for branch in 0..=count {
            let point = self.curve.on_branch(branch, &scaled)?;
            let same = |point: &Point| point.stability == rest.stability && point.ln_radius().overlaps(&ln_radius);
            found.extend(point.filter(same).map(|point| (branch, point)));
        }
        match <[(usize, Point); 1]>::try_from(found) {
            Ok([(branch, point)]) => Ok(Known { name: Name::On { branch, value: value.clone() }, point }),
            Err(_) => Err(unordered(self.control(), &rest.contact_radius)),
        }
    }

    /// The stable state past a fold, as the trait defines it.
    fn resting(&self, fold: usize) -> Result<Option<(usize, Point)>> {
        let (point, kind) = &self.curve.folds()[fold];
        let value = self.curve.controlled(point);
        let branches: Vec<usize> = match kind {
            FoldKind::Minimum => (0..fold).rev().step_by(2).collect(),
            FoldKind::Maximum => (fold + 2..=self.folds.len()).step_by(2).collect(),
        };
        for branch in branches {
            if let Some(rest) = self.curve.on_branch(branch, &value)? {
                return Ok(Some((branch, rest)));
            }
        }
        Ok(None)
    }

    /// The line of an event; events at way points come in their order.
    fn line<'e>(&self, event: &'e Event<Interval>, way: &mut impl Iterator<Item = Rational>) -> Result<Line<'e>> {
        let held = match event.kind {
            kind if is_arrival(kind) => way.next(),
            // Surfaces meet and part at zero.
            kind if changes(kind) && event.fold.is_none() => Some(Rational::new()),
            _ => None,
        };
        let found = |state: &ContactState<Interval>| match (state, &held) {
            (ContactState::Contact(rest), Some(value)) if rest.contact_radius > rest.contact_radius.lit(0) => {
                self.at(value, rest).map(Some)
            }
            _ => Ok(None),
        };
        let states = match (event.kind, event.fold) {
            (EventKind::Jump, Some(fold)) => {
                let rest = self.resting(fold)?.map(|(_, point)| Known { name: Name::Landing(fold), point });
                [Some(self.fold(fold)), rest]
            }
            (_, Some(fold)) => [Some(self.fold(fold)), None],
            _ => [found(&event.before)?, found(&event.after)?],
        };
        let exact = held.or_else(|| self.curve.exact_fold(event.fold?).cloned());
        let value = match (exact, event.fold) {
            (Some(value), _) => value.into(),
            (None, Some(fold)) => self.curve.controlled(&self.curve.folds()[fold].0).enclosure(),
            (None, None) => event.value.clone().into(),
        };
        let falls = event.fold.is_some() && *self.control() == Control::Force;
        let dissipated = match event.kind {
            EventKind::CompleteContact => Some(Dissipation::Unbounded),
            EventKind::Detached if falls => Some(Dissipation::Unbounded),
            kind if changes(kind) => {
                Some(Dissipation::Finite(Value::Known(Sum::between(states[0].as_ref(), states[1].as_ref()))))
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
                let state = self.law.state(self.curve, &known.point, None);
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
        let sum = |sum: Sum| Value::Known(sum.value(self.curve));
        record.dissipated = line.dissipated.clone().map_part(&mut |value| value.and_then(sum));
    }

    /// The work of the control, the energy lost, and the increase of the stored energy. `None` if one of them has no bound.
    fn balance(&self, lines: &[Line<'_>]) -> Option<Balance<Enclosure>> {
        let dissipated = lines.iter().try_fold(Sum::default(), |sum, line| match &line.dissipated {
            None => Some(sum),
            Some(Dissipation::Finite(Value::Known(dissipated))) => Some(sum.plus(dissipated)),
            Some(_) => None,
        })?;
        let [first, last] = [lines.first()?, lines.last()?].map(|line| line.states[1].as_ref());
        let stored = Sum::between(last, first);
        let work = dissipated.clone().plus(&stored);
        let [work, dissipated, stored] = [work, dissipated, stored].map(Value::Known);
        let (jumps, hysteresis) = (Optional(None), Optional(None));
        Some(Balance { work, dissipated, stored, jumps, hysteresis }.convert(|sum| sum.value(self.curve)))
    }
}

/// A state over intervals, of which an end is 0 or ∞ where they cannot hold it.
fn state(curve: &Curve, point: &Point) -> Equilibrium<Interval> {
    Equilibrium {
        contact_radius: point.radius().interval(),
        indentation: point.indentation().interval(),
        force: curve.force(point).interval(),
        stability: point.stability,
    }
}

impl EquilibriumBranches<Interval> for Branches<'_> {
    fn control(&self) -> &Control<Interval> {
        self.curve.control()
    }

    fn folds(&self) -> &[Fold<Interval>] {
        &self.folds
    }

    fn on_branch(&self, branch: usize, value: &Interval) -> Result<Option<Equilibrium<Interval>>> {
        let point = self.curve.on_branch(branch, &value.clone().into())?;
        Ok(point.map(|point| state(self.curve, &point)))
    }

    fn compare(&self, value: &Interval, fold: &Fold<Interval>) -> Result<Ordering> {
        let unordered = || unordered(self.control(), value);
        let index = self.folds.iter().position(|other| std::ptr::eq(other, fold)).ok_or_else(unordered)?;
        let mut met = self.way.iter().filter(|point| value.lower() <= *point && value.upper() >= *point).peekable();
        if met.peek().is_some() && met.all(|point| Some(point) == self.curve.exact_fold(index)) {
            return Ok(Ordering::Equal);
        }
        self.curve.compare(&value.clone().into(), &self.curve.folds()[index].0)
    }

    fn onset(&self) -> Result<FirstContact> {
        Ok(if self.curve.begins_smoothly()? { FirstContact::Smooth } else { FirstContact::Abrupt })
    }

    fn end(&self) -> Result<End<Interval>> {
        Ok(End::Open)
    }

    fn admissibility(&self) -> &Admissibility {
        Admissibility::rising()
    }

    fn first_touch(&self) -> Result<Option<Touch<Interval>>> {
        Ok(None)
    }

    fn last_admissible(&self, _radii: [&Interval; 2]) -> Result<Option<(Equilibrium<Interval>, Ring<Interval>)>> {
        Ok(None)
    }

    fn is_pushed_back(&self, _radius: &Interval, _value: &Interval) -> Result<bool> {
        Ok(false)
    }

    fn after_jump(&self, fold: usize) -> Result<Option<(usize, Equilibrium<Interval>)>> {
        Ok(self.resting(fold)?.map(|(branch, point)| (branch, state(self.curve, &point))))
    }
}
