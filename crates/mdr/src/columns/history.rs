//! The history of a contact while the controlled quantity moves slowly from value to value.

use mdr_core::contact::{self, Control, Edge, Error, Result, Status};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::path::{self, Dissipation, EventKind, Path, PathEnergy, Start};

use super::tables::Tables;
use super::{ContactColumns, States};
use crate::outputs::path::{changes, is_arrival};
use crate::run::lack;

/// How far two roundings of one contact radius may be apart, relative to it.
const ROUNDING: f64 = 1e-9;

/// A state of a history, in SI units. Surfaces that are apart have a = F = 0; surfaces that touch everywhere have no numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// a.
    pub contact_radius: f64,
    /// d; NaN where the surfaces are apart under a dead load.
    pub indentation: f64,
    /// F.
    pub force: f64,
}

/// Something that happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// The kind of event.
    pub kind: EventKind,
    /// The controlled quantity.
    pub value: f64,
    /// The state before it.
    pub before: State,
    /// The state after it; the same where nothing changes.
    pub after: State,
    /// The energy that is lost, in J: infinite where it has no bound, NaN where its integral does not converge.
    pub dissipated: f64,
    /// The part of it that a receding edge has lost since the event before, with two works of adhesion; NaN where that is less than
    /// doubles tell.
    pub hysteresis: f64,
    /// With two works of adhesion, the edge that jumps, stops, or begins to move.
    pub edge: Option<Edge>,
}

/// A state for each value.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    /// The states at the values, in their order. Behind the end of a path that cannot be continued there are none.
    pub states: States,
    /// The events between the values: every event but the arrival at a value.
    pub jumps: Vec<Event>,
}

/// Events, a curve to be drawn, and energy.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LoadingPath {
    /// The events, in their order.
    pub events: Vec<Event>,
    /// The states of the events, with a number of states between each two.
    pub curve: Vec<State>,
    /// Work of the control, energy lost, and increase of the stored energy from start to end, in J; `None` if one has no bound.
    pub balance: Option<[f64; 3]>,
}

impl ContactColumns {
    /// A state for each value, in their order.
    ///
    /// # Errors
    /// No value, or one that is not finite; no stable equilibrium at the first; a stiffness that is not positive; errors of the
    /// transform; [`Error::Stopped`].
    pub fn follow(&self, control: &Control<f64>, values: &[f64], start: &Start<f64>) -> Result<History> {
        let start = &self.start(start)?;
        self.branched(control, true, |branches| {
            let mut history = History { states: States::with_capacity(values.len()), jumps: Vec::new() };
            if let Some(tables) = Tables::new(branches, values)
                && self.follow_tabulated(branches, &tables, values, start, &mut history)?
            {
                return Ok(history);
            }
            history = History { states: States::with_capacity(values.len()), jumps: Vec::new() };
            let path = Path::follow(branches, start, values)?;
            self.append(&mut history, branches, &path, 0, values.len())?;
            Ok(history)
        })
    }

    /// A history by strides of growing length, each followed event by event. Between them the values lie within the tabulated branch
    /// on which the contact is, up to states that are known to be admissible, or below those at which separated surfaces touch: there
    /// nothing happens. False if a stride does not begin where the last one ended.
    fn follow_tabulated(
        &self,
        branches: &SearchedBranches<f64>,
        tables: &Tables<'_>,
        values: &[f64],
        start: &Start<f64>,
        history: &mut History,
    ) -> Result<bool> {
        let control = branches.control();
        values.iter().try_for_each(|value| control.check_value(value))?;
        // Where g may fall, surfaces may touch on a ring before they do at the tip.
        let touch = if branches.admissibility().holds_by_form() { 0.0 } else { f64::NEG_INFINITY };
        let (mut done, mut stride, mut last) = (0, 1, None);
        while done < values.len() {
            let before = done;
            match &mut last {
                Some(path::ContactState::Contact(rest)) => {
                    let branch = branches.folds().partition_point(|fold| fold.contact_radius < rest.contact_radius);
                    if let Some(known) = tables.branch(branch)? {
                        known.admissible(&values[done..], |value, state| {
                            history.states.push(self.numbers(&state, control, value), Status::Ok);
                            (*rest, done) = (state, done + 1);
                        });
                    }
                }
                Some(apart @ path::ContactState::Detached) => {
                    while let Some(value) = values.get(done).filter(|value| **value < touch) {
                        history.states.push(self.state_at(apart, control, *value).row(), Status::Ok);
                        done += 1;
                    }
                }
                Some(path::ContactState::Complete) | None => {}
            }
            if done == values.len() {
                break;
            }
            stride = if done > before { 1 } else { stride };
            let (from, to) = (done.saturating_sub(1), values.len().min(done + stride));
            let begin = match &last {
                Some(path::ContactState::Contact(rest)) => Start::Nearest(rest.contact_radius),
                Some(_) => Start::Detached,
                None => start.clone(),
            };
            let path = Path::follow(branches, &begin, &values[from..to])?;
            if let Some(last) = &last
                && !path.events.first().is_some_and(|event| is_one(last, &event.after))
            {
                return Ok(false);
            }
            self.append(history, branches, &path, done - from, to - done)?;
            if !path.is_finished() {
                (to..values.len()).for_each(|_| history.states.push([f64::NAN; 3], end_of(&path)));
                return Ok(true);
            }
            last = path.events.last().map(|event| event.after.clone());
            (done, stride) = (to, 2 * stride);
        }
        Ok(true)
    }

    /// Appends the states at so many values of a path, of which the first `known` ones are known already, and its events.
    fn append(
        &self,
        history: &mut History,
        branches: &SearchedBranches<f64>,
        path: &Path<f64>,
        known: usize,
        count: usize,
    ) -> Result<()> {
        let control = branches.control();
        self.arrivals(&mut history.states, path, control, [known, count]);
        if path.events.iter().any(|event| !is_arrival(event.kind)) {
            let losses = Dissipation::of_each(path, branches);
            let jumps = self.events(path, &losses, control)?.into_iter();
            history.jumps.extend(jumps.filter(|event| !is_arrival(event.kind)));
        }
        Ok(())
    }

    /// Appends the states at `count` values of a path, after the first `known` ones.
    pub(super) fn arrivals(
        &self,
        states: &mut States,
        path: &Path<f64>,
        control: &Control<f64>,
        [known, count]: [usize; 2],
    ) {
        let len = states.status.len() + count;
        for event in path.events.iter().filter(|event| is_arrival(event.kind)).skip(known).take(count) {
            let state = self.state_at(&event.after, control, event.value);
            let known = !state.contact_radius.is_nan();
            states.push(state.row(), if known { Status::Ok } else { Status::NoEquilibrium });
        }
        for _ in states.status.len()..len {
            states.push([f64::NAN; 3], end_of(path));
        }
    }

    /// The events along way points, with the energy of each event, and `between` states between each two.
    ///
    /// # Errors
    /// No way point, or one that is not finite; no stable equilibrium at the first; a stiffness that is not positive; errors of
    /// the transform; [`Error::Stopped`].
    pub fn path(&self, control: &Control<f64>, way: &[f64], start: &Start<f64>, between: usize) -> Result<LoadingPath> {
        let start = &self.start(start)?;
        self.branched(control, true, |branches| {
            let path = Path::follow(branches, start, way)?;
            let losses = Dissipation::of_each(&path, branches);
            let balance =
                lack(PathEnergy::new(&path, branches).and_then(|energies| energies.balance(&path, branches)))?;
            let balance = balance.map_or(Some([f64::NAN; 3]), |balance| {
                balance.map(|balance| [balance.work, balance.dissipated, balance.stored])
            });
            let events = self.events(&path, &losses, control)?;
            let curve = self.curve_between(|_| branches.curve(), &events, between)?;
            Ok(LoadingPath { events, curve, balance })
        })
    }

    /// The state from which the contact comes off, drawn back from zero indentation, force or position. On the way there may
    /// have been a stronger pull.
    ///
    /// # Errors
    /// [`Error::NoEquilibrium`] if there is no contact to begin with, or if it does not come off; a stiffness that is not
    /// positive; errors of the transform; [`Error::Stopped`].
    pub fn pull_off(&self, control: &Control<f64>) -> Result<State> {
        self.branched(control, true, |branches| {
            let value = |fold: &contact::Fold<f64>| control.controlled(&fold.indentation, &fold.force);
            let lowest = branches.folds().iter().map(value).filter(|value| value.is_finite()).fold(-1e-150, f64::min);
            let path = Path::follow(branches, &Start::Largest, &[0.0, 2.0 * lowest])?;
            let off = path.events.iter().rev().find(|event| event.kind == EventKind::Detached);
            let off = off.ok_or_else(|| Error::no_equilibrium(control.quantity(), &0.0))?;
            Ok(self.state_at(&off.before, control, off.value))
        })
    }

    /// The start of a path, by its size.
    pub(super) fn start(&self, start: &Start<f64>) -> Result<Start<f64>> {
        Ok(match start {
            Start::Nearest(radius) => Start::Nearest(self.size(*radius)?),
            start => start.clone(),
        })
    }

    /// A state of a path at a value, in numbers.
    fn state_at(&self, state: &path::ContactState<f64>, control: &Control<f64>, value: f64) -> State {
        let [contact_radius, indentation, force] = match state {
            path::ContactState::Contact(rest) => self.numbers(rest, control, value),
            path::ContactState::Detached if *control == Control::Force => [0.0, f64::NAN, 0.0],
            path::ContactState::Detached => [0.0, value, 0.0],
            path::ContactState::Complete => [f64::NAN; 3],
        };
        State { contact_radius, indentation, force }
    }

    /// The events with the energy lost in each.
    pub(super) fn events(
        &self,
        path: &Path<f64>,
        losses: &[Result<Dissipation<f64>>],
        control: &Control<f64>,
    ) -> Result<Vec<Event>> {
        let described = |(event, loss): (&path::Event<f64>, &Result<Dissipation<f64>>)| {
            let dissipated = match loss {
                _ if !changes(event.kind) => 0.0,
                Ok(Dissipation::Finite(dissipated)) => dissipated.value,
                Ok(Dissipation::Unbounded) => f64::INFINITY,
                Err(Error::Stopped) => return Err(Error::Stopped),
                Err(_) => f64::NAN,
            };
            let [before, after] = [&event.before, &event.after].map(|state| self.state_at(state, control, event.value));
            let edge = event.edge;
            Ok(Event { kind: event.kind, value: event.value, before, after, dissipated, hysteresis: 0.0, edge })
        };
        path.events.iter().zip(losses).map(described).collect()
    }

    /// The states of the events, and between two of them states at equal steps of the radius on the curve of a contact that grows, or
    /// does not.
    pub(super) fn curve_between<'c>(
        &self,
        curve: impl Fn(bool) -> &'c Contact<f64>,
        events: &[Event],
        between: usize,
    ) -> Result<Vec<State>> {
        let mut states: Vec<State> = Vec::new();
        let mut last: Option<State> = None;
        for event in events {
            let ends = last.map(|last| [last.contact_radius, event.before.contact_radius]);
            if let Some([from, to]) = ends.filter(|[from, to]| *from > 0.0 && *to > 0.0 && from != to) {
                for step in 1..=between {
                    let radius = from + (to - from) * (step as f64 / (between + 1) as f64);
                    // A radius at which g has no number, such as an edge, is passed by.
                    let found = self.size(radius).and_then(|size| curve(to > from).state(&size));
                    if let Ok((indentation, force)) = lack(found)? {
                        states.push(State { contact_radius: radius, indentation: self.depth(indentation), force });
                    }
                }
            }
            states.push(event.before);
            if changes(event.kind) {
                states.push(event.after);
            }
            last = Some(event.after);
        }
        Ok(states)
    }
}

/// The status of the values behind the end of a path that cannot be continued.
fn end_of(path: &Path<f64>) -> Status {
    path.events.last().map_or(Status::NoEquilibrium, |event| match event.kind {
        EventKind::NotAdmissible => Status::NotAdmissible,
        EventKind::Undecided => Status::Undecided,
        _ => Status::NoEquilibrium,
    })
}

/// Whether two states are one, up to rounding.
fn is_one(one: &path::ContactState<f64>, other: &path::ContactState<f64>) -> bool {
    match (one.contact(), other.contact()) {
        (Some(one), Some(other)) => {
            (one.contact_radius - other.contact_radius).abs() <= ROUNDING * one.contact_radius.abs()
        }
        (None, None) => one == other,
        _ => false,
    }
}

impl State {
    fn row(self) -> [f64; 3] {
        [self.contact_radius, self.indentation, self.force]
    }
}
