//! The path of an edge with two works of adhesion: the sequence of events.

use std::cmp::Ordering;
use std::mem::take;

use mdr_core::contact::{Edge, Equilibrium, Error, Quantity, Result};
use mdr_core::number::Real;

use super::super::begin::begin;
use super::super::follow::{self, Follower, no_way};
use super::super::position::{Position, certain};
use super::super::{ContactState, Event, EventKind, Path, Start};
use super::{Edges, Held, Pin};
use crate::branch::{EquilibriumBranches, Towards, next_stable};

/// The position of the contact, apart from the value of the controlled quantity.
#[derive(Clone)]
enum Place<R> {
    Detached,
    /// In equilibrium at the work of adhesion of an edge.
    Moving(Edge, Position),
    Pinned(Pin<R>),
    Ended,
}

struct Walk<'e, 'a, R: Real, B> {
    edges: &'e Edges<'a, R, B>,
    place: Place<R>,
    value: Held<R>,
    events: Vec<Event<R>>,
}

/// As in [`Path::follow_edges`].
pub(in super::super) fn follow<R: Real, B: EquilibriumBranches<R>>(
    edges: &Edges<'_, R, B>,
    start: &Start<R>,
    way: &[R],
    ranks: Option<&[usize]>,
) -> Result<Path<R>> {
    if !edges.contact.adhesion().is_hysteretic() {
        let order = ranks.map(|ranks| ranks.windows(2).map(|pair| pair[1].cmp(&pair[0])).collect::<Vec<_>>());
        return follow::follow(edges.receding, start, way, order.as_deref()).map(Path::unpinned);
    }
    way.iter().try_for_each(|value| edges.contact.control().check_value(value))?;
    let held = |(index, number): (usize, &R)| Held {
        number: number.clone(),
        rank: ranks.and_then(|ranks| ranks.get(index).copied()),
    };
    let way: Vec<Held<R>> = way.iter().enumerate().map(held).collect();
    let Some((first, rest)) = way.split_first() else { return Err(no_way()) };
    let mut walk = Walk::new(edges, start, first)?;
    let begins_pinned = matches!(walk.place, Place::Pinned(_));
    for (index, target) in rest.iter().enumerate() {
        let order = target.compare(&way[index], edges.receding)?;
        walk.go(target, order, if index + 1 == rest.len() { EventKind::End } else { EventKind::WayPoint })?;
    }
    if rest.is_empty() {
        walk.go(first, Ordering::Equal, EventKind::End)?;
    }
    Ok(Path { events: walk.events, begins_pinned })
}

impl<'e, 'a, R: Real, B: EquilibriumBranches<R>> Walk<'e, 'a, R, B> {
    /// The path at its first way point.
    fn new(edges: &'e Edges<'a, R, B>, start: &Start<R>, first: &Held<R>) -> Result<Self> {
        let (place, state) = starting(edges, start, &first.number)?;
        let (edge, position) = match &place {
            Place::Moving(edge, position) => (*edge, *position),
            _ => (Edge::Advancing, Position::Detached),
        };
        let mut walk = Walk { edges, place, value: first.clone(), events: Vec::new() };
        let mut follower = walk.follower(edge, position);
        follower.stay(EventKind::Start, &first.number, state.clone());
        let admissible = follower.grow(&state)?;
        if state.contact().is_none() {
            follower.approach(&first.number)?;
        }
        match walk.place {
            // The edge stays where it is, but the path may have ended.
            Place::Pinned(_) if admissible => walk.events = follower.events,
            _ => walk.take_back(follower, edge),
        }
        Ok(walk)
    }

    /// Changes the controlled quantity to `target`, which has the given order relative to the previous way point, and
    /// records the events in between.
    fn go(&mut self, target: &Held<R>, order: Ordering, arrival: EventKind) -> Result<()> {
        let edge = if order == Ordering::Less { Edge::Receding } else { Edge::Advancing };
        if order != Ordering::Equal {
            self.turn(edge);
        }
        if let Place::Pinned(pin) = &self.place {
            let pin = pin.clone();
            let moves = || Ok(target.compare(&pin.limit(self.edges, edge)?, self.edges.branches(edge))? == order);
            if order == Ordering::Equal || !moves()? {
                return self.rest(&pin, target, order, arrival);
            }
            self.release(&pin, edge)?;
        }
        let (edge, position) = match &self.place {
            Place::Moving(edge, position) => (*edge, *position),
            Place::Detached => (edge, Position::Detached),
            Place::Pinned(_) | Place::Ended => return Ok(()),
        };
        let mut follower = self.follower(edge, position);
        follower.go(&target.number, order, arrival)?;
        self.take_back(follower, edge);
        self.value = target.clone();
        Ok(())
    }

    /// An edge that was moving the other way is pinned.
    fn turn(&mut self, edge: Edge) {
        let Place::Moving(moved, position) = self.place else { return };
        let Some(state) = self.events.last().map(|event| event.after.clone()).filter(|_| moved != edge) else { return };
        let Some(radius) = state.contact().map(|rest| rest.contact_radius.clone()) else { return };
        if !(radius > radius.lit(0)) {
            // A point.
            self.place = Place::Moving(edge, position);
            return;
        }
        let value = self.value.clone();
        self.record(EventKind::Pinned, moved, &value.number, state);
        self.place = Place::Pinned(Pin { radius, stopped: Some((moved, position, value)) });
    }

    /// The edge stays pinned up to `target`.
    fn rest(&mut self, pin: &Pin<R>, target: &Held<R>, order: Ordering, arrival: EventKind) -> Result<()> {
        let state = self.edges.pinned(&pin.radius, &target.number)?;
        if order == Ordering::Greater && self.overlaps(&state)? {
            return Ok(());
        }
        self.record(arrival, Edge::Receding, &target.number, ContactState::Contact(state));
        self.value = target.clone();
        Ok(())
    }

    /// A pinned edge begins to move; on an unstable branch it jumps.
    fn release(&mut self, pin: &Pin<R>, edge: Edge) -> Result<()> {
        let limit = pin.limit(self.edges, edge)?;
        let position = pin.position(self.edges, edge)?;
        let state = self.edges.state(edge, &pin.radius)?;
        let state = state.controlled(self.edges.contact.control(), limit.number.clone());
        if edge == Edge::Advancing && self.overlaps(&state)? {
            return Ok(());
        }
        self.record(EventKind::Depinned, edge, &limit.number, ContactState::Contact(state.clone()));
        self.value = limit.clone();
        self.place = Place::Moving(edge, position);
        match position {
            Position::Branch(branch) if !self.edges.is_stable(edge, branch)? => {
                self.jump(edge, branch, &limit.number, &state)
            }
            _ => Ok(()),
        }
    }

    /// An edge that is set free on an unstable branch runs to the next equilibrium, at a fixed `value`.
    fn jump(&mut self, edge: Edge, branch: usize, value: &R, from: &Equilibrium<R>) -> Result<()> {
        let branches = self.edges.branches(edge);
        let before = ContactState::Contact(from.clone());
        let mut follower = self.follower(edge, Position::Branch(branch));
        let next = match edge {
            Edge::Advancing => next_stable(branches, value, Some(branch + 1), Towards::Larger)?,
            Edge::Receding => next_stable(branches, value, branch.checked_sub(1), Towards::Smaller)?,
        };
        match (next, edge) {
            (Some((_, rest)), Edge::Advancing) if !follower.may_rest(value, &from.contact_radius, &rest)? => {}
            (Some((branch, rest)), _) => {
                follower.place = Position::Branch(branch);
                follower.enter(EventKind::Jump, value, before, ContactState::Contact(rest), None);
            }
            (None, Edge::Receding) => {
                follower.place = Position::Detached;
                follower.enter(EventKind::Detached, value, before, ContactState::Detached, None);
            }
            (None, Edge::Advancing) => follower.spread(value, before, None)?,
        }
        self.take_back(follower, edge);
        Ok(())
    }

    /// Whether the surfaces would overlap outside a contact whose edge is pinned; the path then ends in the last state.
    fn overlaps(&mut self, state: &Equilibrium<R>) -> Result<bool> {
        let mut follower = self.follower(Edge::Advancing, Position::Detached);
        let ring = follower.overlap(state)?;
        if let Some(ring) = &ring {
            let value = self.value.number.clone();
            follower.leave(EventKind::NotAdmissible, &value);
            follower.touch_on(ring.clone());
            self.place = Place::Ended;
        }
        self.events = follower.events;
        Ok(ring.is_some())
    }

    /// An event without a change of state.
    fn record(&mut self, kind: EventKind, edge: Edge, value: &R, state: ContactState<R>) {
        let mut follower = self.follower(edge, Position::Detached);
        follower.stay(kind, value, state);
        self.events = follower.events;
    }

    /// The path of one edge, from here on.
    fn follower(&mut self, edge: Edge, place: Position) -> Follower<'a, R, B> {
        let (branches, value) = (self.edges.branches(edge), self.value.number.clone());
        Follower { branches, place, value, edge: Some(edge), events: take(&mut self.events) }
    }

    fn take_back(&mut self, follower: Follower<'a, R, B>, edge: Edge) {
        self.place = match follower.place {
            Position::Detached => Place::Detached,
            Position::Ended => Place::Ended,
            position => Place::Moving(edge, position),
        };
        self.events = follower.events;
    }
}

/// The state in which a path begins, with the edge that could move.
pub(super) fn first<R: Real, B: EquilibriumBranches<R>>(
    edges: &Edges<'_, R, B>,
    start: &Start<R>,
    value: &R,
) -> Result<(Option<Edge>, ContactState<R>)> {
    let (place, state) = starting(edges, start, value)?;
    let edge = if let Place::Moving(edge, _) = place { Some(edge) } else { None };
    Ok((edge, state))
}

/// The position and the state in which a path begins at its first way point.
fn starting<R: Real, B: EquilibriumBranches<R>>(
    edges: &Edges<'_, R, B>,
    start: &Start<R>,
    value: &R,
) -> Result<(Place<R>, ContactState<R>)> {
    let of = |edge: Edge| -> Result<(Place<R>, ContactState<R>)> {
        let (position, state) = begin(edges.branches(edge), start, value)?;
        Ok((if position == Position::Detached { Place::Detached } else { Place::Moving(edge, position) }, state))
    };
    match start {
        Start::Largest => of(Edge::Receding),
        Start::Smallest | Start::Detached => of(Edge::Advancing),
        Start::Nearest(radius) => {
            let radius = Error::require_positive(Quantity::ContactRadius, radius.clone())?;
            let limits = [edges.limit(Edge::Receding, &radius)?, edges.limit(Edge::Advancing, &radius)?];
            let above = certain(value, &limits[0], edges.receding)? != Ordering::Less;
            if above && certain(value, &limits[1], edges.receding)? != Ordering::Greater {
                let state = ContactState::Contact(edges.pinned(&radius, value)?);
                return Ok((Place::Pinned(Pin { radius, stopped: None }), state));
            }
            nearest(of(Edge::Receding), of(Edge::Advancing), &radius, edges.receding)
        }
    }
}

/// Of two states that may not exist, the one whose radius is nearer, in ratio.
fn nearest<R: Real, T>(
    one: Result<(T, ContactState<R>)>,
    other: Result<(T, ContactState<R>)>,
    radius: &R,
    branches: &impl EquilibriumBranches<R>,
) -> Result<(T, ContactState<R>)> {
    let (one, other) = match (one, other) {
        (Err(Error::NoEquilibrium { .. }), other) => return other,
        (one, Err(Error::NoEquilibrium { .. })) => return one,
        (one, other) => (one?, other?),
    };
    let distance = |state: &ContactState<R>| {
        state.contact().map_or(radius.lit(0), |rest| (rest.contact_radius.ln() - radius.ln()).abs())
    };
    let nearer = certain(&distance(&one.1), &distance(&other.1), branches)? == Ordering::Less;
    Ok(if nearer { one } else { other })
}
