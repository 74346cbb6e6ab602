//! A critical state.

use mdr_core::contact::{Equilibrium, Stability};

/// A critical state, with quantities of any type: numbers, certified decimals, logarithms.
#[derive(Clone, Debug, PartialEq)]
pub struct State<T> {
    /// a, in m.
    pub contact_radius: T,
    /// d, in m; positive when pressed in.
    pub indentation: T,
    /// F, in N; positive when compressive.
    pub force: T,
}

impl<R> State<R> {
    /// The equilibrium at the fold: a double root.
    pub(crate) fn at_rest(self) -> Equilibrium<R> {
        let State { contact_radius, indentation, force } = self;
        Equilibrium { contact_radius, indentation, force, stability: Stability::Neutral }
    }
}
