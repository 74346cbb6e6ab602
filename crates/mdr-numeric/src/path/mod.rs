//! Quasi-static loading paths: what the contact does while the controlled quantity is moved slowly along way points.
//!
//! On a stable branch nothing happens until the controlled quantity passes the value of a fold at one of its ends. The
//! contact then jumps to the next equilibrium in the direction of change, detaches, or covers the whole surface. The rest
//! is combinatorial, so a path asks for equilibria at way points and landings only, and over enclosures each of its
//! decisions is proved.

mod follow;
mod integral;
mod ledger;

use std::cmp::Ordering;

use mdr_core::contact::{Equilibrium, Result};
use mdr_core::number::Real;

use crate::admissible::Ring;
use crate::branch::Branched;

pub use ledger::{Balance, Entry, Ledger, Loss, stored};

/// Which of the equilibria at the first way point a path begins with.
#[derive(Clone, Debug, PartialEq)]
pub enum Start<R> {
    /// The stable one of the largest radius.
    Largest,
    /// The stable one of the smallest radius.
    Smallest,
    /// The stable one whose radius is nearest to this, in ratio.
    Nearest(R),
    /// None: the surfaces are apart.
    Detached,
}

/// What the two surfaces do.
#[derive(Clone, Debug, PartialEq)]
pub enum State<R> {
    /// They touch on a disc, in equilibrium; on a point with a = d = F = 0 where contact begins or ends smoothly.
    Contact(Equilibrium<R>),
    /// They do not touch; F = 0.
    Detached,
    /// They touch everywhere.
    Complete,
}

/// What happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EventKind {
    /// The path begins.
    Start,
    /// The surfaces come to touch at the tip, at the value 0 of every control, and the contact grows smoothly from there (n < 1/2).
    Touch,
    /// The surfaces come to touch, and the contact jumps to a finite radius.
    JumpIn,
    /// From a fold to another radius.
    Jump,
    /// The contact breaks at a fold; or it has shrunk smoothly to a point (n < 1/2).
    Detached,
    /// Past a fold there is no equilibrium up to the largest radius, of a profile without an outer one. The path ends: the
    /// theory knows nothing beyond.
    CompleteContact,
    /// The contact has come to the outer radius of the profile, and with it the path to its end. The states are those there;
    /// where it grows that far by itself, at the value of a fold or after a touch, those from which it does.
    EndOfProfile,
    /// Up to this value no equilibrium was found: it lies out of the range of the arithmetic, or the profile has an outer
    /// radius at which g is not known. The path ends; the states are the last that are known, at the value of the event before.
    Undecided,
    /// Outside of the contact the surfaces touch on a [ring](Event::ring), and would overlap from there on: on the way along a
    /// stable branch, in the state to which a jump leads, or apart, when they do not first touch at the tip. No theory of a
    /// simply connected contact goes further, and the path ends; the states are the last that are admissible.
    NotAdmissible,
    /// A way point is reached.
    WayPoint,
    /// The last way point is reached.
    End,
}

impl EventKind {
    /// The name in answers: `jump-in`.
    pub fn name(self) -> &'static str {
        match self {
            EventKind::Start => "start",
            EventKind::Touch => "touch",
            EventKind::JumpIn => "jump-in",
            EventKind::Jump => "jump",
            EventKind::Detached => "detached",
            EventKind::CompleteContact => "complete-contact",
            EventKind::EndOfProfile => "end-of-profile",
            EventKind::Undecided => "undecided",
            EventKind::NotAdmissible => "not-admissible",
            EventKind::WayPoint => "way-point",
            EventKind::End => "end",
        }
    }
}

/// One event of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Event<R> {
    /// What happens.
    pub kind: EventKind,
    /// The controlled quantity.
    pub value: R,
    /// Just before.
    pub before: State<R>,
    /// Just after; the same where nothing changes.
    pub after: State<R>,
    /// The fold that is left, by its index.
    pub fold: Option<usize>,
    /// Where the surfaces touch or would overlap, with [`EventKind::NotAdmissible`]; the gap is 0 where they touch, and
    /// negative where a state that is not admissible was jumped to or started from.
    pub ring: Option<Ring<R>>,
}

/// A loading path. Between two events the contact stays on one stable branch, or detached, and the controlled quantity is
/// monotone.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<R> {
    /// In their order.
    pub events: Vec<Event<R>>,
}

impl<R: Real> Path<R> {
    /// Follows the contact along the `way` points of the controlled quantity (d, F, or D = d + F/k).
    ///
    /// At a way point exactly at a fold the contact rests there. After detaching it touches again when the controlled
    /// quantity comes up to 0, or the lowest point of the profile to the surface. A path that cannot be continued ends with an
    /// event that says why; so does one that leaves the [admissible](crate::admissible) states, so that no event of it gains
    /// energy.
    ///
    /// The cost is that of one equilibrium per event, and of comparisons between folds: 10⁴ jumps are no trouble.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Material};
    /// use mdr_numeric::path::{EventKind, Path, Start};
    /// use mdr_numeric::{curve::Curve, equilibrium::Branches, profiles::WavyParaboloid, transform::Quadrature};
    /// // Figure 4 of the paper: pulled from d = 0, it jumps once and then breaks.
    /// let profile = Quadrature::new(WavyParaboloid::new(1.0, 5e-4, 0.1)?);
    /// let (material, control) = (Material::new(1.0, 1e-4)?, Control::Indentation);
    /// let branches = Branches::new(Curve::new(&profile, &material, &control))?;
    /// let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.01])?;
    /// let kinds: Vec<EventKind> = path.events.iter().map(|event| event.kind).collect();
    /// assert_eq!(kinds, [EventKind::Start, EventKind::Jump, EventKind::Detached, EventKind::End]);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`NoEquilibrium`](mdr_core::contact::Error::NoEquilibrium) when there is no stable equilibrium at the first way
    /// point, or for a detached start where the surfaces would overlap; [`Domain`](mdr_core::contact::Error::Domain)
    /// without way points, or unless they are finite; [`Undecided`](mdr_core::contact::Error::Undecided) over enclosures; those of the transform.
    pub fn follow(branches: &impl Branched<R>, start: &Start<R>, way: &[R]) -> Result<Self> {
        follow::follow(branches, start, way, None).map(|events| Path { events })
    }

    /// The same where the order of the way points is known: that of each against the one before it. Enclosures of two equal
    /// numbers do not tell that they are equal.
    ///
    /// # Errors
    /// As [`Path::follow`].
    pub fn follow_ordered(
        branches: &impl Branched<R>,
        start: &Start<R>,
        way: &[R],
        order: &[Ordering],
    ) -> Result<Self> {
        follow::follow(branches, start, way, Some(order)).map(|events| Path { events })
    }

    /// The state in which a path begins: what [`follow`](Path::follow) has in its first event.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Material, Stability};
    /// use mdr_numeric::path::{Path, Start};
    /// use mdr_numeric::{curve::Curve, equilibrium::Branches, profiles::Paraboloid, transform::Quadrature};
    /// let (ball, control) = (Quadrature::new(Paraboloid::new(1.0)?), Control::Indentation);
    /// let material = Material::new(1.0, 1e-3)?;
    /// let branches = Branches::new(Curve::new(&ball, &material, &control))?;
    /// let state = Path::first(&branches, &Start::Largest, &0.0)?;
    /// assert_eq!(state.contact().expect("in contact").stability, Stability::Stable);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Path::follow`].
    pub fn first(branches: &impl Branched<R>, start: &Start<R>, value: &R) -> Result<State<R>> {
        follow::begin(branches, start, value).map(|(_, state)| state)
    }

    /// The same path with its numbers in another arithmetic: states that were proved over enclosures, for the energies.
    pub fn map<S>(&self, number: impl Fn(&R) -> S) -> Path<S> {
        let event = |event: &Event<R>| Event {
            kind: event.kind,
            value: number(&event.value),
            before: event.before.map(&number),
            after: event.after.map(&number),
            fold: event.fold,
            ring: event.ring.as_ref().map(|ring| Ring { radius: number(&ring.radius), gap: number(&ring.gap) }),
        };
        Path { events: self.events.iter().map(event).collect() }
    }

    /// Whether the path came to its last way point.
    pub fn is_finished(&self) -> bool {
        self.events.last().is_some_and(|event| event.kind == EventKind::End)
    }
}

impl<R: Real> State<R> {
    /// The equilibrium, if the surfaces are in contact on a disc.
    pub fn contact(&self) -> Option<&Equilibrium<R>> {
        match self {
            State::Contact(equilibrium) => Some(equilibrium),
            State::Detached | State::Complete => None,
        }
    }

    fn map<S>(&self, number: impl Fn(&R) -> S) -> State<S> {
        match self {
            State::Contact(equilibrium) => State::Contact(equilibrium.map(number)),
            State::Detached => State::Detached,
            State::Complete => State::Complete,
        }
    }
}
