//! The path algorithm: the sequence of events.

use std::cmp::Ordering;

use mdr_core::contact::{Edge, Equilibrium, Error, FoldKind, Quantity, Result, Stability};
use mdr_core::number::Real;

use super::begin::{begin, still_apart};
use super::position::{Position, at_fold, certain, state};
use super::{ContactState, Event, EventKind, Start};
use crate::admissible::{GapVerdict, Ring};
use crate::branch::{End, EquilibriumBranches, FirstContact, Towards, next_stable};

pub(super) struct Follower<'a, R, B> {
    pub(super) branches: &'a B,
    pub(super) place: Position,
    pub(super) value: R,
    /// The edge of the branches, if there are two.
    pub(super) edge: Option<Edge>,
    pub(super) events: Vec<Event<R>>,
}

/// The events of [`Path::follow`](super::Path::follow). `order` gives the order of each way point relative to the
/// previous one if it is known; otherwise the numbers are compared.
pub(super) fn follow<R: Real, B: EquilibriumBranches<R>>(
    branches: &B,
    start: &Start<R>,
    way: &[R],
    order: Option<&[Ordering]>,
) -> Result<Vec<Event<R>>> {
    let Some((first, rest)) = way.split_first() else { return Err(no_way()) };
    way.iter().try_for_each(|value| branches.control().check_value(value))?;
    let (place, state) = begin(branches, start, first)?;
    let mut follower = Follower { branches, place, value: first.clone(), edge: None, events: Vec::new() };
    follower.stay(EventKind::Start, first, state.clone());
    follower.grow(&state)?;
    follower.approach(first)?;
    for (i, target) in rest.iter().enumerate() {
        let last = i + 1 == rest.len();
        let order = match order.and_then(|order| order.get(i)) {
            Some(order) => *order,
            None => certain(target, &way[i], branches)?,
        };
        follower.go(target, order, if last { EventKind::End } else { EventKind::WayPoint })?;
    }
    if rest.is_empty() {
        follower.go(first, Ordering::Equal, EventKind::End)?;
    }
    Ok(follower.events)
}

/// The error for a path without way points.
pub(super) fn no_way() -> Error {
    Error::Domain {
        quantity: Quantity::Parameter("the number of way points"),
        value: "0".to_owned(),
        requirement: "at least 1",
    }
}

impl<R: Real, B: EquilibriumBranches<R>> Follower<'_, R, B> {
    /// Changes the controlled quantity to `target`, which has the given order relative to the previous way point, and
    /// records the events in between.
    pub(super) fn go(&mut self, target: &R, order: Ordering, arrival: EventKind) -> Result<()> {
        match order {
            Ordering::Less => while self.pull(target)? {},
            Ordering::Greater => while self.press(target)? {},
            Ordering::Equal => {}
        }
        if self.place == Position::Ended {
            return Ok(());
        }
        match state(self.branches, self.place, target)? {
            Some(state) if order == Ordering::Greater && !self.grow(&state)? => {}
            Some(state) => self.stay(arrival, target, state),
            None => self.end_of_search(target)?,
        }
        Ok(())
    }

    /// No equilibrium was found on the last branch: the profile ends before `target`, or the reason is unknown.
    fn end_of_search(&mut self, target: &R) -> Result<()> {
        self.place = Position::Ended;
        if let End::Profile(end) = self.branches.end()? {
            let value = self.branches.control().controlled(&end.indentation, &end.force);
            if certain(target, &value, self.branches)? == Ordering::Greater {
                self.stay(EventKind::EndOfProfile, &value, ContactState::Contact(end));
                return Ok(());
            }
        }
        self.leave(EventKind::Undecided, target);
        Ok(())
    }

    /// Decreases the controlled quantity to the next event; returns whether there was one before `target`.
    fn pull(&mut self, target: &R) -> Result<bool> {
        let fold = match self.place {
            Position::Detached | Position::Ended => return Ok(false),
            Position::Branch(0) => {
                let tip = self.branches.tip_value(target);
                if certain(target, &tip, self.branches)? == Ordering::Greater {
                    return Ok(false);
                }
                self.vanish(&tip);
                return Ok(false);
            }
            Position::Branch(branch) => branch - 1,
            Position::Fold(fold) if self.is_maximum(fold) => {
                self.place = Position::Branch(fold);
                return Ok(true);
            }
            Position::Fold(fold) => fold,
        };
        self.past(fold, target, Ordering::Less)
    }

    /// Increases the controlled quantity to the next event; returns whether there was one before `target`.
    fn press(&mut self, target: &R) -> Result<bool> {
        let fold = match self.place {
            Position::Detached => return self.approach(target),
            Position::Ended => return Ok(false),
            Position::Branch(branch) => branch,
            Position::Fold(fold) if self.is_maximum(fold) => fold,
            // A flat has touched at this very value.
            Position::Fold(_) if *target == self.value => return Ok(false),
            Position::Fold(fold) => {
                self.place = Position::Branch(fold + 1);
                return Ok(true);
            }
        };
        self.past(fold, target, Ordering::Greater)
    }

    /// Passes a fold in the given direction, if `target` is beyond it.
    fn past(&mut self, fold: usize, target: &R, beyond: Ordering) -> Result<bool> {
        let Some(here) = self.branches.folds().get(fold) else { return Ok(false) };
        let side = self.branches.compare(target, here)?;
        if side == Ordering::Equal {
            self.place = Position::Fold(fold);
        }
        if side != beyond {
            return Ok(false);
        }
        let value = self.branches.control().controlled(&here.indentation, &here.force);
        if beyond == Ordering::Greater && !self.grow(&at_fold(here))? {
            return Ok(false);
        }
        match self.branches.after_jump(fold)? {
            Some((_, rest))
                if beyond == Ordering::Greater && !self.may_rest(&value, &here.contact_radius, &rest)? =>
            {
                return Ok(false);
            }
            Some((branch, rest)) => {
                self.place = Position::Branch(branch);
                self.enter(EventKind::Jump, &value, at_fold(here), ContactState::Contact(rest), Some(fold));
            }
            None if here.kind == FoldKind::Minimum => {
                self.place = Position::Detached;
                self.enter(EventKind::Detached, &value, at_fold(here), ContactState::Detached, Some(fold));
            }
            None => self.spread(&value, at_fold(here), Some(fold))?,
        }
        Ok(true)
    }

    /// The contact has grown along a stable branch to a state: returns whether that is admissible. If not, the path
    /// ends where admissibility was lost, after the last event or in that event itself.
    pub(super) fn grow(&mut self, state: &ContactState<R>) -> Result<bool> {
        let Some(rest) = state.contact().filter(|rest| rest.contact_radius > rest.contact_radius.lit(0)) else {
            return Ok(true);
        };
        let Some(overlap) = self.overlap(rest)? else { return Ok(true) };
        let last = self.events.last().and_then(|event| event.after.contact());
        let from = last.map_or(rest.contact_radius.lit(0), |last| last.contact_radius.clone());
        let last = if from < rest.contact_radius {
            self.branches.last_admissible([&from, &rest.contact_radius])
        } else {
            Ok(None)
        };
        match last {
            // Lost on the way, but the state is not known to the digits of this arithmetic.
            Err(Error::NoConvergence { .. }) => {
                let value = self.value.clone();
                self.leave(EventKind::Undecided, &value);
                self.touch_on(overlap);
            }
            Err(error) => return Err(error),
            Ok(Some((state, ring))) => {
                let value = self.branches.control().controlled(&state.indentation, &state.force);
                self.place = Position::Ended;
                self.stay(EventKind::NotAdmissible, &value, ContactState::Contact(state));
                self.touch_on(ring);
            }
            Ok(None) => {
                let value = self.value.clone();
                self.leave(EventKind::NotAdmissible, &value);
                self.touch_on(overlap);
            }
        }
        Ok(false)
    }

    /// Whether a contact that grows from one radius at a fixed controlled value can come to equilibrium in a state: the
    /// state must be admissible, and on the way the edge must nowhere be in compression, g − d < −Δl, where growth
    /// requires energy. Otherwise the path ends.
    pub(super) fn may_rest(&mut self, value: &R, from: &R, rest: &Equilibrium<R>) -> Result<bool> {
        let mut obstacle = self.overlap(rest)?;
        let indentation = rest.indentation.approx();
        for dip in self.branches.admissibility().dips(from.approx(), rest.contact_radius.approx(), indentation) {
            let radius = R::from_f64(value.ctx(), dip);
            let pushed_back = match self.branches.is_pushed_back(&radius, value) {
                // A minimum at which g is not a number is one where g tends to −∞.
                Err(Error::Domain { .. }) => true,
                pushed_back => pushed_back?,
            };
            if obstacle.is_none() && pushed_back {
                obstacle = Some(Ring { radius, gap: value.lit(0) });
            }
        }
        let Some(ring) = obstacle else { return Ok(true) };
        self.leave(EventKind::NotAdmissible, value);
        self.touch_on(ring);
        Ok(false)
    }

    /// The ring on which the surfaces would interpenetrate outside a contact.
    pub(super) fn overlap(&self, rest: &Equilibrium<R>) -> Result<Option<Ring<R>>> {
        let number = |x: f64| R::from_f64(rest.contact_radius.ctx(), x);
        Ok(match self.branches.verdict(rest)? {
            GapVerdict::Interpenetrating { radius, gap } => Some(Ring { radius: number(radius), gap: number(gap) }),
            GapVerdict::Admissible | GapVerdict::Undecided(_) => None,
        })
    }

    /// Records in the last event where the surfaces meet.
    pub(super) fn touch_on(&mut self, ring: Ring<R>) {
        if let Some(event) = self.events.last_mut() {
            event.ring = Some(ring);
        }
    }

    /// The contact grows from a state without reaching an equilibrium: it covers the whole surface, or reaches the end
    /// of the profile.
    pub(super) fn spread(&mut self, value: &R, before: ContactState<R>, fold: Option<usize>) -> Result<()> {
        self.place = Position::Ended;
        let kind = match self.branches.end()? {
            End::Open => {
                self.enter(EventKind::CompleteContact, value, before, ContactState::Complete, fold);
                return Ok(());
            }
            End::Profile(end) => {
                let at_end = self.branches.control().controlled(&end.indentation, &end.force);
                let grows = certain(value, &at_end, self.branches)? == Ordering::Greater;
                if grows { EventKind::EndOfProfile } else { EventKind::Undecided }
            }
            End::Unknown => EventKind::Undecided,
        };
        self.enter(kind, value, before.clone(), before, fold);
        Ok(())
    }

    /// The surfaces are separated, and the controlled quantity increases to `target`, or is there at the start: they
    /// touch at zero, or before on a ring, where the path ends. Returns whether they touch at the tip.
    ///
    /// # Errors
    /// [`Error::Unproved`] where a dimple at the tip touches before it, and it is not known at which depth.
    pub(super) fn approach(&mut self, target: &R) -> Result<bool> {
        if self.place != Position::Detached {
            return Ok(false);
        }
        if let Some(bound) = still_apart(self.branches, target) {
            let value = self.branches.control().controlled(&bound, &target.lit(0));
            if certain(target, &value, self.branches)? != Ordering::Less {
                self.leave(EventKind::Undecided, target);
            }
            return Ok(false);
        }
        if let Some(touch) = self.branches.first_touch()? {
            let zero = target.lit(0);
            let value = self.branches.control().controlled(&touch.indentation, &zero);
            if certain(target, &value, self.branches)? != Ordering::Less {
                self.leave(EventKind::NotAdmissible, &value);
                self.touch_on(Ring { radius: touch.radius, gap: zero });
            }
            return Ok(false);
        }
        let zero = target.lit(0);
        let side = certain(target, &zero, self.branches)?;
        match self.branches.onset()? {
            // The search for the first touch found none before the tip.
            FirstContact::Dimple => {
                let [from, to] = [&self.value, target].map(|value| value.approx().to_string());
                let remedy =
                    "a dimple at the tip is narrower than the search for the first touch resolves; begin in contact";
                Err(Error::Unproved { quantity: Quantity::Indentation, from, to, remedy })
            }
            // The springs reach further than the surfaces have to come.
            FirstContact::Smooth if self.branches.tip_value(&zero) < zero => {
                if side != Ordering::Less {
                    self.jump_in(&zero, 0)?;
                }
                Ok(side != Ordering::Less)
            }
            FirstContact::Smooth if side == Ordering::Greater => {
                self.place = Position::Branch(0);
                self.enter(EventKind::Touch, &zero, ContactState::Detached, ContactState::Contact(point(&zero)), None);
                Ok(true)
            }
            FirstContact::Abrupt if side != Ordering::Less => {
                self.jump_in(&zero, 1)?;
                Ok(true)
            }
            FirstContact::Smooth | FirstContact::Abrupt => Ok(false),
        }
    }

    /// From a point contact to the next equilibrium at zero, from a branch on.
    fn jump_in(&mut self, zero: &R, branch: usize) -> Result<()> {
        let flat = branch.checked_sub(1).and_then(|fold| Some((fold, self.branches.folds().get(fold)?)));
        if let Some((fold, end)) = flat
            && self.branches.compare(zero, end)? == Ordering::Equal
        {
            // Without adhesion the whole of a flat touches, and nothing is lost.
            self.place = Position::Fold(fold);
            self.enter(EventKind::Touch, zero, ContactState::Detached, at_fold(end), None);
            return Ok(());
        }
        match next_stable(self.branches, zero, Some(branch), Towards::Larger)? {
            Some((_, rest)) if !self.may_rest(zero, zero, &rest)? => {}
            Some((branch, rest)) => {
                self.place = Position::Branch(branch);
                self.enter(EventKind::JumpIn, zero, ContactState::Detached, ContactState::Contact(rest), None);
            }
            None => self.spread(zero, ContactState::Detached, None)?,
        }
        Ok(())
    }

    /// The contact has shrunk to a point, at the value at the tip, and the controlled quantity decreases.
    fn vanish(&mut self, tip: &R) {
        let zero = tip.lit(0);
        let indentation = if *tip < zero { tip.clone() } else { zero.clone() };
        let last = Equilibrium { indentation, ..point(&zero) };
        self.place = Position::Detached;
        self.enter(EventKind::Detached, tip, ContactState::Contact(last), ContactState::Detached, None);
    }

    fn is_maximum(&self, fold: usize) -> bool {
        self.branches.folds().get(fold).is_some_and(|fold| fold.kind == FoldKind::Maximum)
    }

    /// An event without a change of state.
    pub(super) fn stay(&mut self, kind: EventKind, value: &R, state: ContactState<R>) {
        self.enter(kind, value, state.clone(), state, None);
    }

    /// The path cannot be continued: it ends with the last known state.
    pub(super) fn leave(&mut self, kind: EventKind, value: &R) {
        self.place = Position::Ended;
        let last = self.events.last().map_or(ContactState::Detached, |event| event.after.clone());
        self.enter(kind, value, last.clone(), last, None);
    }

    pub(super) fn enter(
        &mut self,
        kind: EventKind,
        value: &R,
        before: ContactState<R>,
        after: ContactState<R>,
        fold: Option<usize>,
    ) {
        self.value = value.clone();
        let at_rest = matches!(kind, EventKind::Start | EventKind::WayPoint | EventKind::End);
        let edge = self.edge.filter(|_| !at_rest);
        self.events.push(Event { kind, value: value.clone(), before, after, fold, edge, ring: None });
    }
}

/// The point contact with which contact begins or ends continuously.
fn point<R: Real>(zero: &R) -> Equilibrium<R> {
    let [contact_radius, indentation, force] = [(); 3].map(|()| zero.clone());
    Equilibrium { contact_radius, indentation, force, stability: Stability::Stable }
}
