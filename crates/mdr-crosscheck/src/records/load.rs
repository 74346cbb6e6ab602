//! What is held in a question about a profile of the library.

use mdr_core::contact::Control;
use mdr_core::number::{Dual, Real};

use super::condition::input;
use super::draft::literal;

/// Fixed grips, a dead load, or a machine of a stiffness in N/m.
#[derive(Clone, Copy, Debug)]
pub(super) enum Load {
    Indentation,
    Force,
    Machine(&'static str),
}

impl Load {
    pub(super) fn name(self) -> &'static str {
        match self {
            Load::Indentation => "indentation",
            Load::Force => "force",
            Load::Machine(_) => "machine",
        }
    }

    /// The symbol of the controlled quantity.
    pub(super) fn symbol(self) -> &'static str {
        match self {
            Load::Indentation => "d",
            Load::Force => "F",
            Load::Machine(_) => "D",
        }
    }

    /// The stiffness as an input, where there is one.
    pub(super) fn input(self) -> Option<(&'static str, &'static str)> {
        match self {
            Load::Machine(stiffness) => Some(("k", stiffness)),
            _ => None,
        }
    }

    pub(super) fn control<R: Real>(self, ctx: R::Ctx) -> Control<R> {
        match self {
            Load::Indentation => Control::Indentation,
            Load::Force => Control::Force,
            Load::Machine(stiffness) => Control::Machine { stiffness: R::from_literal(ctx, &literal(stiffness)) },
        }
    }

    /// The same; if the stiffness `moves`, with a derivative with respect to its logarithm.
    pub(super) fn moving<R: Real>(self, ctx: R::Ctx, moves: bool) -> Control<Dual<R>> {
        match self {
            Load::Indentation => Control::Indentation,
            Load::Force => Control::Force,
            Load::Machine(stiffness) => Control::Machine { stiffness: input(ctx, &literal(stiffness), moves) },
        }
    }
}
