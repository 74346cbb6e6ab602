//! The samples of a force curve, with a break at every jump.

use std::cmp::Ordering;

use mdr_core::contact::{Control, Error, Fold, FoldKind, Quantity, Result};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::path::{ContactState, Edges, EventKind, Path};

use super::ForceSample;
use super::summary::unknown;
use crate::answer::{Optional, Value};
use crate::outputs::path::{changes, edges, follow, quantities};
use crate::run::lack;
use crate::scene::Scene;
use crate::solve::model::{Model, SceneReal};

/// At least so many samples between two events.
const LEAST: usize = 2;

/// A contact with the branches on which it moves.
pub(super) struct Course<'a, R: SceneReal, B> {
    pub(super) scene: &'a Scene,
    /// The contact; with two works of adhesion, that of a receding edge.
    pub(super) model: &'a Model<R>,
    pub(super) branches: Branches<'a, B>,
}

pub(super) enum Branches<'a, B> {
    One(&'a B),
    /// With two works of adhesion: the branches of an advancing and of a receding edge.
    Between([&'a B; 2]),
}

impl<'a, B> Branches<'a, B> {
    /// The branches at the work of adhesion of a receding edge.
    fn receding(&self) -> &'a B {
        match self {
            Branches::One(branches) | Branches::Between([_, branches]) => branches,
        }
    }

    /// The branches of a contact that grows, or shrinks.
    pub(super) fn moving(&self, grows: bool) -> &'a B {
        match self {
            Branches::Between([advancing, _]) if grows => advancing,
            _ => self.receding(),
        }
    }
}

/// Where the samples between two events are, and what is kept of where each is from.
pub(super) trait Places<R> {
    type Origin;

    /// The value of the controlled quantity at a share of the way between two others: so many steps of so many.
    fn between(&self, ends: [&R; 2], share: [usize; 2]) -> Result<(R, Self::Origin)>;

    /// The origin of a sample that is the state after an event, or before it, by its number.
    fn of_event(&self, number: usize, is_before: bool) -> Self::Origin;
}

impl<'a, R: SceneReal, B: EquilibriumBranches<R>> Course<'a, R, B> {
    /// The path of the scene.
    ///
    /// # Errors
    /// A path that cannot start or be followed; errors of the transform.
    pub(super) fn follow(&self) -> Result<Path<R>> {
        match self.branches {
            Branches::One(branches) => follow(self.model, branches, self.scene),
            Branches::Between(branches) => edges::follow(self.model, branches, self.scene),
        }
    }

    /// The samples of a path, about so many, each with its origin.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Undecided`] if enclosures do not decide the order of two values or radii.
    pub(super) fn sampled<P: Places<R>>(
        &self,
        path: &Path<R>,
        points: usize,
        places: &P,
    ) -> Result<Vec<(ForceSample<R>, P::Origin)>> {
        let control = self.model.control();
        let has_depth = self.model.contact().medium().has_depth();
        let ways = path.events.windows(2).map(|pair| (pair[1].value.clone() - &pair[0].value).abs());
        let travel = ways.reduce(|sum, way| sum + way);
        let mut samples = Vec::new();
        let (mut segment, mut last) = (1, Ordering::Equal);
        for (number, pair) in path.events.windows(2).enumerate() {
            let [from, to] = [&pair[0], &pair[1]];
            let direction = self.order(&to.value, &from.value)?;
            // An edge that stops or begins to move is no sample of its own.
            if direction.is_eq() && (to.kind == EventKind::Pinned || from.kind == EventKind::Depinned) {
                continue;
            }
            // A jump breaks the curve, and so does a change of direction.
            if changes(from.kind) || direction.is_ne() && direction == last.reverse() {
                segment += 1;
            }
            if direction.is_ne() {
                last = direction;
            }
            let way = (to.value.clone() - &from.value).abs();
            let share = travel.as_ref().filter(|_| direction.is_ne()).map_or(0.0, |travel| (way / travel).approx());
            let count = LEAST.max((share * points as f64).round() as usize);
            // The sizes of the last contacts, from which the next is guessed.
            let mut sizes: Vec<R> = Vec::new();
            for index in 0..=count {
                let (value, origin, state) = match index {
                    0 => (from.value.clone(), places.of_event(number, false), Ok(from.after.clone())),
                    _ if index == count => (to.value.clone(), places.of_event(number + 1, true), Ok(to.before.clone())),
                    _ => {
                        let (value, origin) = places.between([&from.value, &to.value], [index, count])?;
                        let state = lack(self.between([&from.after, &to.before], &value, &sizes))?;
                        (value, origin, state)
                    }
                };
                if let Some(state) = state.as_ref().ok().and_then(ContactState::contact) {
                    sizes.push(state.contact_radius.clone());
                }
                let seen = |state| match state {
                    ContactState::Contact(state) => ContactState::Contact(self.model.shown(state)),
                    state => state,
                };
                let sample = sample(control, segment, direction, &value, state.map(seen))?;
                samples.extend(sample.map(|sample| {
                    let indentation = sample.indentation.filter(|_| has_depth);
                    (ForceSample { indentation, ..sample }, origin)
                }));
            }
        }
        Ok(samples)
    }

    /// The order of two values of the controlled quantity; copies of one enclosure are equal.
    fn order(&self, one: &R, other: &R) -> Result<Ordering> {
        if self.branches.receding().is_same(one, other) {
            return Ok(Ordering::Equal);
        }
        let quantity = self.model.control().quantity();
        one.partial_cmp(other).ok_or_else(|| Error::undecided(quantity, one, "the order of two events of the path"))
    }

    /// The state at a value between those of two events, on the branch on which both are.
    fn between(&self, [from, to]: [&ContactState<R>; 2], value: &R, sizes: &[R]) -> Result<ContactState<R>> {
        let (Some(before), Some(after)) = (from.contact(), to.contact()) else { return Ok(ContactState::Detached) };
        let radii = [&before.contact_radius, &after.contact_radius];
        match &self.branches {
            Branches::Between([advancing, receding]) if receding.is_same(radii[0], radii[1]) => {
                let contact = self.model.contact();
                Edges::new(&contact, *advancing, *receding).pinned(radii[0], value).map(ContactState::Contact)
            }
            branches => between(branches.moving(radii[1] > radii[0]), radii, value, sizes),
        }
    }
}

/// The state at a value on the branch with two radii.
fn between<R: SceneReal, B: EquilibriumBranches<R>>(
    branches: &B,
    radii: [&R; 2],
    value: &R,
    sizes: &[R],
) -> Result<ContactState<R>> {
    let mut branch = 0;
    for fold in branches.folds() {
        if !is_below(branches, fold, radii)? {
            break;
        }
        branch += 1;
    }
    let found = match sizes {
        // Not from the fold itself, from which the size grows as a root.
        [_, .., one, last] => {
            let step = last.clone() - one;
            branches.on_branch_near(branch, value, [&(last.clone() + &step), &(last.clone() + step.over(2))])
        }
        _ => branches.on_branch(branch, value),
    };
    match found? {
        Some(state) => Ok(ContactState::Contact(state)),
        // There is one, between those of the two events.
        None => {
            let what = "the equilibrium, of which the contact radius is not found";
            Err(Error::undecided(branches.control().quantity(), value, what))
        }
    }
}

/// Whether a fold is below the branch with two radii. A branch that keeps its radius lies at a vertical edge, beyond the fold that is
/// there.
fn is_below<R: SceneReal, B: EquilibriumBranches<R>>(
    branches: &B,
    fold: &Fold<R>,
    [from, to]: [&R; 2],
) -> Result<bool> {
    let is_kept = branches.is_same(from, to);
    let order = if is_kept && branches.is_same(&fold.contact_radius, from) {
        Some(Ordering::Equal)
    } else {
        let middle = if is_kept { from.clone() } else { (from.clone() + to).over(2) };
        fold.contact_radius.partial_cmp(&middle)
    };
    let what = "on which branch a state is";
    let order = order.ok_or_else(|| Error::undecided(Quantity::ContactRadius, &fold.contact_radius, what))?;
    Ok(match fold.kind {
        FoldKind::Minimum => order.is_le(),
        FoldKind::Maximum => order.is_lt(),
    })
}

/// `None` if the surfaces touch everywhere; without the numbers of a state that was not found.
fn sample<R: SceneReal>(
    control: &Control<R>,
    segment: usize,
    direction: Ordering,
    value: &R,
    state: Result<ContactState<R>>,
) -> Result<Option<ForceSample<R>>> {
    let [contact_radius, indentation, force] = match state {
        Ok(state) => quantities(control, &state, value),
        Err(error) => {
            let open = Some(unknown(error)?);
            let held = Some(Value::Known(value.clone()));
            match control {
                Control::Indentation => [open.clone(), held, open],
                Control::Force => [open.clone(), open, held],
                Control::Machine { .. } => [open.clone(), open.clone(), open],
            }
        }
    };
    let Some(force) = force else { return Ok(None) };
    Ok(Some(ForceSample {
        segment,
        direction: if direction.is_lt() { "retract" } else { "approach" },
        position: Optional(matches!(control, Control::Machine { .. }).then(|| Value::Known(value.clone()))),
        indentation,
        force,
        contact_radius,
    }))
}
