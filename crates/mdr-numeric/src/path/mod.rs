//! Quasi-static loading paths: the states of the contact while the controlled quantity varies slowly along way points.
//!
//! On a stable branch the contact changes continuously until the controlled quantity passes the value of a fold at one
//! of its ends. The contact then jumps to the next equilibrium in the direction of change, detaches, or covers the
//! whole surface. The rest is combinatorial: equilibria are computed only at way points and after jumps, and over
//! enclosures each decision is proved.

mod begin;
mod complete;
mod energy;
mod follow;
mod integral;
mod pinned;
mod position;

use std::cmp::Ordering;

use mdr_core::contact::{Edge, Equilibrium, Result};
use mdr_core::named;
use mdr_core::number::{Literal, Real};

use crate::admissible::Ring;
use crate::branch::EquilibriumBranches;

pub use energy::{Balance, Dissipation, EventEnergy, PathEnergy, stored};
pub use pinned::{EdgeEnergies, EdgeLoss, Edges};

/// The equilibrium at the first way point with which a path begins; of a scene, with a radius as exact as it is written.
#[derive(Clone, Debug, PartialEq)]
pub enum Start<R = Literal> {
    /// The stable equilibrium with the largest radius.
    Largest,
    /// The stable equilibrium with the smallest radius.
    Smallest,
    /// The stable equilibrium whose radius is nearest to this, in ratio.
    Nearest(R),
    /// The surfaces are separated.
    Detached,
}

impl<R> Start<R> {
    /// Converts the radius to another arithmetic.
    pub fn map<S>(&self, number: impl FnOnce(&R) -> S) -> Start<S> {
        match self {
            Start::Largest => Start::Largest,
            Start::Smallest => Start::Smallest,
            Start::Nearest(radius) => Start::Nearest(number(radius)),
            Start::Detached => Start::Detached,
        }
    }
}

/// The state of the two surfaces.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactState<R> {
    /// Equilibrium with contact on a disc; a point with a = d = F = 0 if contact begins or ends continuously.
    Contact(Equilibrium<R>),
    /// No contact; F = 0.
    Detached,
    /// Contact everywhere.
    Complete,
}

named! {
    /// The kind of an event.
    pub enum EventKind {
        /// The path begins.
        Start = "start",
        /// The surfaces touch at the tip, at the value 0 of every control, and the contact grows continuously from there (n
        /// < 1/2).
        Touch = "touch",
        /// The surfaces touch, and the contact jumps to a finite radius.
        JumpIn = "jump-in",
        /// The contact jumps from a fold to another radius.
        Jump = "jump",
        /// The contact breaks at a fold; or it has shrunk continuously to a point (n < 1/2).
        Detached = "detached",
        /// After a fold there is no equilibrium up to the largest radius, of a profile without an outer one. The path ends,
        /// because the theory covers no further state.
        CompleteContact = "complete-contact",
        /// The contact edge reached the outer radius of the profile, so the path ends. Both states are the one at the outer
        /// radius; after a jump at a fold or after a touch, the one it jumped from.
        EndOfProfile = "end-of-profile",
        /// No equilibrium was found up to this value: it is out of the range of the arithmetic, or the profile has an outer
        /// radius at which g is not known. Or it is not known where the surfaces of a formula first touch, or in which state
        /// those outside the contact do, on a [ring](Event::ring). The path ends; the states are the last known one, at the
        /// value of the previous event.
        Undecided = "undecided",
        /// The surfaces touch on a [ring](Event::ring) outside the contact, and would interpenetrate beyond: along a stable
        /// branch, in the state to which a jump leads, or separated, if they do not first touch at the tip. The theory of a
        /// simply connected contact ends here, and so does the path; the states are the last admissible ones.
        NotAdmissible = "not-admissible",
        /// The controlled quantity turns, and the edge stays where it is until the work of adhesion of the other way is
        /// reached.
        Pinned = "pinned",
        /// A pinned edge begins to move.
        Depinned = "depinned",
        /// A way point is reached.
        WayPoint = "way-point",
        /// The last way point is reached.
        End = "end",
    }
}

/// One event of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Event<R> {
    /// The kind of the event.
    pub kind: EventKind,
    /// The controlled quantity.
    pub value: R,
    /// The state before.
    pub before: ContactState<R>,
    /// The state after; the same if nothing changes.
    pub after: ContactState<R>,
    /// The index of the fold that is passed.
    pub fold: Option<usize>,
    /// If there are two works of adhesion, the edge whose work of adhesion the event has: of a jump, that which drives it; of
    /// [`EventKind::Pinned`] the edge that stops, of [`EventKind::Depinned`] the one that begins to move. The fold is one of
    /// that edge.
    pub edge: Option<Edge>,
    /// The ring on which the surfaces touch or would interpenetrate, for [`EventKind::NotAdmissible`], and for
    /// [`EventKind::Undecided`] where that is why; the gap is 0
    /// where they touch, and negative if the path jumped to or started from a state that is not admissible.
    pub ring: Option<Ring<R>>,
}

/// A loading path. Between two events the contact stays on one stable branch, or detached, and the controlled quantity is
/// monotone.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<R> {
    /// The events in order.
    pub events: Vec<Event<R>>,
    /// Whether the edge is pinned between two works of adhesion where the path begins, as it may be from [`Start::Nearest`].
    pub begins_pinned: bool,
}

impl<R: Real> Path<R> {
    /// A path whose edge moves from where it begins.
    fn unpinned(events: Vec<Event<R>>) -> Self {
        Path { events, begins_pinned: false }
    }

    /// Follows the contact along the `way` points of the controlled quantity (d, F, or D = d + F/k).
    ///
    /// At a way point exactly at a fold the contact stays there. After detachment it touches again when the controlled
    /// quantity increases to 0, or when the lowest point of the profile reaches the surface. A path that cannot be
    /// continued ends with an event that states the reason; so does one that leaves the [admissible](crate::admissible)
    /// states, so no event of it gains energy.
    ///
    /// The cost is one equilibrium per event and comparisons between folds, also for 10⁴ jumps.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use mdr_core::contact::{Control, Material, Shape};
    /// use mdr_numeric::path::{EventKind, Path, Start};
    /// use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
    /// // Figure 4 of the paper: pulled from d = 0, it jumps once and then breaks.
    /// let profile = Arc::new(Quadrature::of([Shape::WavyParaboloid { radius: 1.0, amplitude: 5e-4, wavelength: 0.1 }])?);
    /// let (material, control) = (Material::new(1.0, 1e-4)?, Control::Indentation);
    /// let branches = SearchedBranches::new(Contact::half_space(&profile, &material, &control))?;
    /// let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.01])?;
    /// let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
    /// assert_eq!(kinds, [EventKind::Start, EventKind::Jump, EventKind::Detached, EventKind::End]);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`NoEquilibrium`](mdr_core::contact::Error::NoEquilibrium) if there is no stable equilibrium at the first way
    /// point, or for a detached start where the surfaces would interpenetrate;
    /// [`Domain`](mdr_core::contact::Error::Domain) without way points, or unless they are finite;
    /// [`Undecided`](mdr_core::contact::Error::Undecided) over enclosures;
    /// [`Unproved`](mdr_core::contact::Error::Unproved) where surfaces that are apart come to touch beside a tip on a ring that the search
    /// for it does not resolve; errors of the transform.
    pub fn follow(branches: &impl EquilibriumBranches<R>, start: &Start<R>, way: &[R]) -> Result<Self> {
        follow::follow(branches, start, way, None).map(Path::unpinned)
    }

    /// Follows the contact like [`Path::follow`], with a given order of each way point relative to the previous one. Enclosures
    /// of two equal numbers do not show that they are equal.
    ///
    /// # Errors
    /// Errors of the transform; [`NoEquilibrium`](mdr_core::contact::Error::NoEquilibrium),
    /// [`Domain`](mdr_core::contact::Error::Domain) and [`Undecided`](mdr_core::contact::Error::Undecided) under the conditions
    /// stated at [`Path::follow`].
    pub fn follow_ordered(
        branches: &impl EquilibriumBranches<R>,
        start: &Start<R>,
        way: &[R],
        order: &[Ordering],
    ) -> Result<Self> {
        follow::follow(branches, start, way, Some(order)).map(Path::unpinned)
    }

    /// Follows the contact between its two [edges](Edges), which have different works of adhesion, along the `way` points of the
    /// controlled quantity.
    ///
    /// An edge advances to the first radius a' ≥ a at which g(a') − d is at least Δl₁, and recedes to the first a' ≤ a at which
    /// it is at most Δl₂; in between it is pinned. `ranks` are the places of the way points in their order, equal for equal
    /// numbers, where these do not show it: enclosures of two equal numbers do not.
    ///
    /// The path starts on the receding edge for [`Start::Largest`], on the advancing one for [`Start::Smallest`]. A contact of the
    /// radius of [`Start::Nearest`] is pinned if it can be, and else the nearest state of either edge.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Edge, Shape};
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::path::{Edges, EventKind, Path, Start};
    /// use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
    /// let adhesion = Adhesion::hysteretic(0.01, 0.04)?;
    /// let contact = Contact::new(ball, Medium::half_space(1.0)?, adhesion, Control::Indentation);
    /// let [advancing, receding] =
    ///     [Edge::Advancing, Edge::Receding].map(|edge| SearchedBranches::new(contact.at(edge)));
    /// let (advancing, receding) = (advancing?, receding?);
    /// let edges = Edges::new(&contact, &advancing, &receding);
    /// let path = Path::follow_edges(&edges, &Start::Detached, &[-0.2, 0.03, -0.2], None)?;
    /// let kinds: Vec<&str> = path.events.iter().map(|event| event.kind.name()).collect();
    /// assert_eq!(kinds, ["start", "jump-in", "way-point", "pinned", "depinned", "detached", "end"]);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the transform; [`NoEquilibrium`](mdr_core::contact::Error::NoEquilibrium),
    /// [`Domain`](mdr_core::contact::Error::Domain) and [`Undecided`](mdr_core::contact::Error::Undecided) under the conditions
    /// stated at [`Path::follow`].
    pub fn follow_edges<B: EquilibriumBranches<R>>(
        edges: &Edges<'_, R, B>,
        start: &Start<R>,
        way: &[R],
        ranks: Option<&[usize]>,
    ) -> Result<Self> {
        pinned::follow(edges, start, way, ranks)
    }

    /// The state in which a path begins: that of the first event of [`follow`](Path::follow).
    ///
    /// ```
    /// use std::sync::Arc;
    /// use mdr_core::contact::{Control, Material, Shape, Stability};
    /// use mdr_numeric::path::{Path, Start};
    /// use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
    /// let (ball, control) = (Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?), Control::Indentation);
    /// let material = Material::new(1.0, 1e-3)?;
    /// let branches = SearchedBranches::new(Contact::half_space(&ball, &material, &control))?;
    /// let state = Path::first(&branches, &Start::Largest, &0.0)?;
    /// assert_eq!(state.contact().expect("in contact").stability, Stability::Stable);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the transform; [`NoEquilibrium`](mdr_core::contact::Error::NoEquilibrium),
    /// [`Domain`](mdr_core::contact::Error::Domain) and [`Undecided`](mdr_core::contact::Error::Undecided) under the conditions
    /// stated at [`Path::follow`].
    pub fn first(branches: &impl EquilibriumBranches<R>, start: &Start<R>, value: &R) -> Result<ContactState<R>> {
        begin::begin(branches, start, value).map(|(_, state)| state)
    }

    /// Converts the numbers of the path to another arithmetic, such as states proved over enclosures for the energies.
    pub fn map<S>(&self, number: impl Fn(&R) -> S) -> Path<S> {
        let event = |event: &Event<R>| Event {
            kind: event.kind,
            value: number(&event.value),
            before: event.before.map(&number),
            after: event.after.map(&number),
            fold: event.fold,
            edge: event.edge,
            ring: event.ring.as_ref().map(|ring| Ring { radius: number(&ring.radius), gap: number(&ring.gap) }),
        };
        Path { events: self.events.iter().map(event).collect(), begins_pinned: self.begins_pinned }
    }

    /// Whether the edge stays where it is on the way to each event of a path between two works of adhesion, so that its radius is the same in
    /// every digit: at the [vertical edge](crate::contact::Contact::vertical_edge) of a body, if it has one, and where it is pinned, from the
    /// event [`EventKind::Pinned`] to [`EventKind::Depinned`] and from the start of a path that [begins so](Path::begins_pinned).
    pub fn stays(&self, vertical_edge: Option<&R>) -> Vec<bool> {
        let is_at = |state: &ContactState<R>, radius: &R| {
            let order = state.contact().map(|rest| rest.contact_radius.partial_cmp(radius));
            matches!(order, Some(None | Some(Ordering::Equal)))
        };
        let mut pinned = self.begins_pinned;
        let on_the_way = |event: &Event<R>| {
            let is_at_end = vertical_edge.is_some_and(|end| is_at(&event.before, end));
            let before = pinned || is_at_end || event.kind == EventKind::Depinned;
            pinned = match event.kind {
                EventKind::Pinned => true,
                EventKind::Start | EventKind::WayPoint | EventKind::End => pinned,
                _ => false,
            };
            before
        };
        self.events.iter().map(on_the_way).collect()
    }

    /// Whether the path reached its last way point.
    pub fn is_finished(&self) -> bool {
        self.events.last().is_some_and(|event| event.kind == EventKind::End)
    }
}

impl<R: Real> ContactState<R> {
    /// The equilibrium, if the surfaces are in contact on a disc.
    pub fn contact(&self) -> Option<&Equilibrium<R>> {
        match self {
            ContactState::Contact(equilibrium) => Some(equilibrium),
            ContactState::Detached | ContactState::Complete => None,
        }
    }

    fn map<S>(&self, number: impl Fn(&R) -> S) -> ContactState<S> {
        match self {
            ContactState::Contact(equilibrium) => ContactState::Contact(equilibrium.map(number)),
            ContactState::Detached => ContactState::Detached,
            ContactState::Complete => ContactState::Complete,
        }
    }
}
