//! Paths between two works of adhesion: an edge that advances gains w₁, one that recedes needs w₂ ≥ w₁.
//!
//! With y = g(a) − d, the elongation of the springs at the edge, and Δlᵢ = √(2wᵢA'/S') of the [medium](crate::medium), the
//! edge advances where y < Δl₁, recedes where y > Δl₂, and is pinned in between: a stays, and dF = S(a) dd, or
//! dD = (1 + S/K) dd on a machine. The value of the controlled quantity at which y = Δlᵢ is that of the curve of equilibria
//! with the work of adhesion wᵢ, C₁(a) > C₂(a); so the edge is pinned while C₂(a) ≤ value ≤ C₁(a). Beyond C₁ it follows the
//! branches of w₁ and jumps at their folds, below C₂ those of w₂. A pinned edge at a radius on an unstable branch jumps as soon
//! as it is depinned: so a contact that was pressed too little breaks before the fold of w₂ is reached, and its pull-off force
//! depends on the preload.

mod energy;
mod follow;

use std::cmp::Ordering;

use mdr_core::contact::{Control, Edge, Equilibrium, Error, Fold, Result, Stability};
use mdr_core::number::Real;

use super::position::{Position, certain};
use super::{ContactState, Start};
use crate::branch::{EquilibriumBranches, FirstContact};
use crate::contact::Contact;

pub use energy::{EdgeEnergies, EdgeLoss};
pub(super) use follow::follow;

/// A contact with two works of adhesion: the branches of its equilibria at each.
///
/// See [`Path::follow_edges`](super::Path::follow_edges).
pub struct Edges<'a, R: Real, B> {
    contact: Contact<R>,
    advancing: &'a B,
    receding: &'a B,
}

impl<'a, R: Real, B: EquilibriumBranches<R>> Edges<'a, R, B> {
    /// The contact, with its branches at the work of adhesion of each edge, [`Contact::at`].
    pub fn new(contact: &Contact<R>, advancing: &'a B, receding: &'a B) -> Self {
        Edges { contact: contact.clone(), advancing, receding }
    }

    /// The state in which a path begins, as in [`Path::follow_edges`](super::Path::follow_edges), with the edge that is in
    /// equilibrium there: `None` if the edge is pinned between the two, or if the surfaces are apart.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Edge, Shape};
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::path::{Edges, Start};
    /// use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
    /// let adhesion = Adhesion::hysteretic(0.01, 0.04)?;
    /// let contact = Contact::new(ball, Medium::half_space(1.0)?, adhesion, Control::Indentation);
    /// let advancing = SearchedBranches::new(contact.at(Edge::Advancing))?;
    /// let receding = SearchedBranches::new(contact.at(Edge::Receding))?;
    /// let edges = Edges::new(&contact, &advancing, &receding);
    /// // The radius 0.2 is held from d = −0.184 to −0.072.
    /// let (edge, state) = edges.first(&Start::Nearest(0.2), &-0.1)?;
    /// assert!(edge.is_none() && state.contact().is_some_and(|state| state.contact_radius == 0.2));
    /// let (edge, state) = edges.first(&Start::Nearest(0.2), &0.0)?;
    /// assert!(edge == Some(Edge::Advancing) && state.contact().is_some_and(|state| state.contact_radius > 0.39));
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the transform; [`NoEquilibrium`](Error::NoEquilibrium), [`Domain`](Error::Domain) and
    /// [`Undecided`](Error::Undecided) under the conditions stated at [`Path::follow`](super::Path::follow).
    pub fn first(&self, start: &Start<R>, value: &R) -> Result<(Option<Edge>, ContactState<R>)> {
        follow::first(self, start, value)
    }

    /// The branches of an edge.
    fn branches(&self, edge: Edge) -> &'a B {
        match edge {
            Edge::Advancing => self.advancing,
            Edge::Receding => self.receding,
        }
    }

    /// The value of the controlled quantity at which an edge with this radius begins to move, C₁(a) or C₂(a).
    fn limit(&self, edge: Edge, radius: &R) -> Result<R> {
        if let Some(fold) = self.fold_at(edge, radius) {
            return Ok(self.contact.control().controlled(&fold.indentation, &fold.force));
        }
        self.known(self.contact.at(edge).controlled(radius))
    }

    /// The fold of an edge at exactly this radius, as at a kink, whose enclosure may reach over it.
    fn fold_at(&self, edge: Edge, radius: &R) -> Option<&'a Fold<R>> {
        self.branches(edge).folds().iter().find(|fold| self.receding.is_same(&fold.contact_radius, radius))
    }

    /// The state in which an edge with this radius begins to move.
    fn state(&self, edge: Edge, radius: &R) -> Result<Equilibrium<R>> {
        let (indentation, force) = match self.fold_at(edge, radius) {
            Some(fold) => (fold.indentation.clone(), fold.force.clone()),
            None => self.known(self.contact.at(edge).state(radius))?,
        };
        Ok(Equilibrium { contact_radius: radius.clone(), indentation, force, stability: Stability::Stable })
    }

    /// The state of an edge that is pinned at a radius, at a value of the controlled quantity.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::OutOfRange`] if the force is not representable in this arithmetic;
    /// [`Error::Undecided`] if the enclosure of the radius reaches over a kink.
    pub fn pinned(&self, radius: &R, value: &R) -> Result<Equilibrium<R>> {
        let fold = self.fold_at(Edge::Receding, radius).or_else(|| self.fold_at(Edge::Advancing, radius));
        let (indentation, force) = match self.contact.equilibrium_at(radius, value) {
            Err(Error::Domain { .. }) if let Some(fold) = fold => self.beside_fold(fold, value),
            state => self.known(state)?,
        };
        let state = Equilibrium { contact_radius: radius.clone(), indentation, force, stability: Stability::Stable };
        Ok(state.controlled(self.contact.control(), value.clone()))
    }

    /// The state at the radius of a fold and a value of the controlled quantity: the contact is a spring of the stiffness S(a).
    fn beside_fold(&self, fold: &Fold<R>, value: &R) -> (R, R) {
        let stiffness = self.contact.stiffness(&fold.contact_radius);
        let control = self.contact.control();
        let more = value.clone() - control.controlled(&fold.indentation, &fold.force);
        let deeper = match control {
            Control::Indentation => more,
            Control::Force => more / &stiffness,
            Control::Machine { stiffness: spring } => more / (stiffness.clone() / spring + stiffness.lit(1)),
        };
        (deeper.clone() + &fold.indentation, deeper * stiffness + &fold.force)
    }

    /// The enclosure of a radius may reach over a kink, where it is of no use.
    fn known<T>(&self, result: Result<T>) -> Result<T> {
        result.map_err(|error| match error {
            Error::Domain { .. } => self.undecided("on which side of a kink the radius of a pinned edge lies"),
            error => error,
        })
    }

    fn undecided(&self, what: &'static str) -> Error {
        Error::undecided(mdr_core::contact::Quantity::ContactRadius, self.contact.modulus(), what)
    }

    /// The branch of an edge, or its fold, with this radius.
    fn locate(&self, edge: Edge, radius: &R) -> Result<Position> {
        let folds = self.branches(edge).folds();
        if self.contact.vertical_edge().is_some_and(|outer_edge| self.receding.is_same(&outer_edge, radius)) {
            return Ok(Position::Branch(folds.len()));
        }
        if let Some(index) = folds.iter().position(|fold| self.receding.is_same(&fold.contact_radius, radius)) {
            return Ok(Position::Fold(index));
        }
        for (index, fold) in folds.iter().enumerate() {
            match radius.partial_cmp(&fold.contact_radius) {
                Some(Ordering::Less) => return Ok(Position::Branch(index)),
                Some(Ordering::Equal) => return Ok(Position::Fold(index)),
                Some(Ordering::Greater) => {}
                None => return Err(self.undecided("on which side of a fold a pinned edge begins to move")),
            }
        }
        Ok(Position::Branch(folds.len()))
    }

    /// Whether equilibria of an edge on a branch are stable.
    fn is_stable(&self, edge: Edge, branch: usize) -> Result<bool> {
        let branches = self.branches(edge);
        match branches.is_stable(branch) {
            Some(stable) => Ok(stable),
            None => Ok(branches.onset()? == FirstContact::Smooth),
        }
    }
}

/// A value of the controlled quantity, with its place among the way points if it is one and the places are given.
#[derive(Clone)]
struct Held<R> {
    number: R,
    rank: Option<usize>,
}

impl<R: Real> Held<R> {
    fn compare(&self, other: &Self, branches: &impl EquilibriumBranches<R>) -> Result<Ordering> {
        match (self.rank, other.rank) {
            (Some(one), Some(other)) => Ok(one.cmp(&other)),
            _ => certain(&self.number, &other.number, branches),
        }
    }
}

/// A pinned edge.
#[derive(Clone)]
struct Pin<R> {
    radius: R,
    /// The edge that stopped, its position and the value at which it did: it moves on from there.
    stopped: Option<(Edge, Position, Held<R>)>,
}

impl<R: Real> Pin<R> {
    /// The value at which an edge begins to move.
    fn limit<B: EquilibriumBranches<R>>(&self, edges: &Edges<'_, R, B>, edge: Edge) -> Result<Held<R>> {
        match &self.stopped {
            Some((stopped, _, value)) if *stopped == edge => Ok(value.clone()),
            _ => Ok(Held { number: edges.limit(edge, &self.radius)?, rank: None }),
        }
    }

    /// The position from which an edge begins to move.
    fn position<B: EquilibriumBranches<R>>(&self, edges: &Edges<'_, R, B>, edge: Edge) -> Result<Position> {
        match &self.stopped {
            Some((stopped, position, _)) if *stopped == edge => Ok(*position),
            _ => edges.locate(edge, &self.radius),
        }
    }
}
