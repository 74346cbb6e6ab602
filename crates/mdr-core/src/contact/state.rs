//! States of the contact, the outcome of an instability, and the status of an answer.

use super::{Control, Error, Quantity, Result};
use crate::named;

named! {
    /// The kind of instability of a power-law profile f = C rⁿ.
    pub enum Regime {
        /// n > 1/2: under sufficient tension the contact breaks.
        PullOff = "pull-off",
        /// n = 1/2: the problem has no length scale; the ratio of C to a threshold decides.
        ScaleFree = "scale-free",
        /// n < 1/2: under sufficient compression the contact spreads over the whole surface.
        CompleteContact = "complete-contact",
    }
}

/// The response to a small change of the contact radius at a fixed value of the controlled quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stability {
    /// It returns to the equilibrium.
    Stable,
    /// It departs from the equilibrium.
    Unstable,
    /// Neutral equilibrium: the state is a fold.
    Neutral,
}

/// A state that satisfies (1.5) and (1.6).
#[derive(Clone, Debug, PartialEq)]
pub struct Equilibrium<R> {
    /// a, in m.
    pub contact_radius: R,
    /// d, in m; positive when pressed in.
    pub indentation: R,
    /// F, in N; positive when compressive.
    pub force: R,
    /// Stability under the control of the computation.
    pub stability: Stability,
}

impl<R> Equilibrium<R> {
    /// Converts the numbers of the state to another arithmetic.
    pub fn map<S>(&self, number: impl Fn(&R) -> S) -> Equilibrium<S> {
        Equilibrium {
            contact_radius: number(&self.contact_radius),
            indentation: number(&self.indentation),
            force: number(&self.force),
            stability: self.stability,
        }
    }

    /// Sets the controlled quantity of the state to the exact `value` at which the state was found.
    #[must_use]
    pub fn controlled<N>(self, control: &Control<N>, value: R) -> Self {
        match control {
            Control::Indentation => Equilibrium { indentation: value, ..self },
            Control::Force => Equilibrium { force: value, ..self },
            Control::Machine { .. } => self,
        }
    }
}

named! {
    /// The type of extremum that the controlled quantity, as a function of the contact radius along the equilibria, has at
    /// a fold.
    pub enum FoldKind {
        /// Below the fold there is no equilibrium nearby.
        Minimum = "minimum",
        /// Above the fold there is no equilibrium nearby.
        Maximum = "maximum",
    }
}

named! {
    /// The two ways in which the edge of a contact moves, each with a work of adhesion of its own.
    pub enum Edge {
        /// The contact grows.
        Advancing = "advancing",
        /// The contact shrinks.
        Receding = "receding",
    }
}

/// The state of the contact after an instability at a fold.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome<R> {
    /// A stable equilibrium at another finite radius.
    Jump {
        /// The radius of that equilibrium, in m.
        to: R,
    },
    /// The contact breaks.
    Detached,
    /// The surfaces come into contact everywhere.
    CompleteContact,
}

/// A fold of the controlled quantity along the curve of equilibria.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold<R> {
    /// a, in m.
    pub contact_radius: R,
    /// d, in m.
    pub indentation: R,
    /// F, in N.
    pub force: R,
    /// Whether the controlled quantity has a minimum or a maximum.
    pub kind: FoldKind,
}

impl<R> Fold<R> {
    /// Converts the numbers of the fold to another arithmetic.
    pub fn map<S>(&self, number: impl Fn(&R) -> S) -> Fold<S> {
        Fold {
            contact_radius: number(&self.contact_radius),
            indentation: number(&self.indentation),
            force: number(&self.force),
            kind: self.kind,
        }
    }
}

/// The state at the fold: a double root.
impl<R> From<Fold<R>> for Equilibrium<R> {
    fn from(fold: Fold<R>) -> Self {
        let Fold { contact_radius, indentation, force, .. } = fold;
        Equilibrium { contact_radius, indentation, force, stability: Stability::Neutral }
    }
}

named! {
    /// The status of an answer.
    #[non_exhaustive]
    pub enum Status {
        /// A number, as good as its promise.
        Ok = "ok",
        /// No state satisfies the equations.
        NoEquilibrium = "no-equilibrium",
        /// The state is the fold itself.
        Fold = "fold",
        /// Beyond the largest number of the arithmetic.
        Overflow = "overflow",
        /// Below the smallest positive number of the arithmetic.
        Underflow = "underflow",
        /// An input is outside its domain.
        DomainError = "domain-error",
        /// The surfaces would interpenetrate outside the assumed simply connected contact.
        NotAdmissible = "not-admissible",
        /// No permitted precision decides the required digits.
        Undecided = "undecided",
    }
}

/// A result that may be out of the range of its arithmetic. It is never replaced by 0 or ∞.
///
/// ```
/// use mdr_core::contact::{Quantity, Ranged, Status};
/// let tiny: Ranged<f64> = Ranged::Underflow { log10: -4766.0 };
/// assert_eq!(tiny.status(), Status::Underflow);
/// assert!(tiny.value(Quantity::ContactRadius).is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ranged<R> {
    /// In range.
    Value(R),
    /// Too large; log10 of its magnitude.
    Overflow {
        /// log10 of the magnitude.
        log10: f64,
    },
    /// Too small; log10 of its magnitude.
    Underflow {
        /// log10 of the magnitude.
        log10: f64,
    },
}

impl<R> Ranged<R> {
    /// `Ok`, `Overflow` or `Underflow`.
    pub fn status(&self) -> Status {
        match self {
            Ranged::Value(_) => Status::Ok,
            Ranged::Overflow { .. } => Status::Overflow,
            Ranged::Underflow { .. } => Status::Underflow,
        }
    }

    /// The value of the named `quantity`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] with log10 of the magnitude.
    pub fn value(self, quantity: Quantity) -> Result<R> {
        match self {
            Ranged::Value(value) => Ok(value),
            Ranged::Overflow { log10 } | Ranged::Underflow { log10 } => Err(Error::OutOfRange { quantity, log10 }),
        }
    }
}
