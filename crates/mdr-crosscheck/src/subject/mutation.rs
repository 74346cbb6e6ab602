//! Deliberate faults, as a mistake in a closed form would cause them.

use std::fmt;

use mdr_core::number::Real;

use super::{Subject, SubjectId, subjects};

/// One mistake in one closed form.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fault {
    /// Where.
    pub id: SubjectId,
    /// What.
    pub mutation: Mutation,
}

/// A kind of mistake.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Mutation {
    /// The opposite sign.
    Sign,
    /// A factor p/q too much.
    Factor(i64, i64),
    /// A factor 1 + 2⁻ᵏ too much, which is just visible in double precision.
    Slight(i64),
    /// The power of the named input is wrong by p/q.
    Exponent {
        /// Its place among the inputs of the subject.
        input: usize,
        /// Its name.
        name: &'static str,
        /// p.
        p: i64,
        /// q.
        q: i64,
    },
}

impl Mutation {
    /// The wrong value in the place of the right one.
    pub(super) fn apply<R: Real>(&self, value: R, inputs: &[&R]) -> R {
        match *self {
            Mutation::Sign => -value,
            Mutation::Factor(p, q) => value.times(p).over(q),
            Mutation::Slight(k) => value.lit(2).powi(-k) * &value + &value,
            Mutation::Exponent { input, p, q, .. } => value.clone() * inputs[input].pow(&value.ratio(p, q)),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: ", self.id)?;
        match self.mutation {
            Mutation::Sign => f.write_str("wrong sign"),
            Mutation::Factor(p, q) => write!(f, "factor {p}/{q}"),
            Mutation::Slight(k) => write!(f, "factor 1 + 2^-{k}"),
            Mutation::Exponent { name, p, q, .. } => write!(f, "power of {name} wrong by {p}/{q}"),
        }
    }
}

/// The mistakes that every subject must be caught with.
pub fn faults() -> impl Iterator<Item = Fault> {
    subjects().into_iter().flat_map(|Subject { id, inputs, .. }| {
        let general = [Mutation::Sign, Mutation::Factor(3, 2), Mutation::Factor(1, 2), Mutation::Slight(36)];
        let powers = inputs
            .iter()
            .enumerate()
            .flat_map(|(input, &name)| [(1, 2), (-1, 1)].map(|(p, q)| Mutation::Exponent { input, name, p, q }));
        general.into_iter().chain(powers).map(move |mutation| Fault { id, mutation })
    })
}
