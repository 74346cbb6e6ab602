//! Ziv's strategy: the same formula with more words until its result can be rounded.

use mdr_core::contact::{Error, Fold, Quantity, Ranged, Result};
use mdr_core::number::Extended;

use crate::state::State;
use crate::threshold::ScaleFreeOutcome;

/// A result in extended precision that can be rounded to `f64` if its error bound is small enough.
pub(super) trait Round {
    type Rounded;

    /// The result in `f64`; `None` if the error bound is too wide.
    fn round(&self) -> Option<Self::Rounded>;
}

impl<const N: usize> Round for Extended<N> {
    type Rounded = Ranged<f64>;

    #[inline(always)]
    fn round(&self) -> Option<Ranged<f64>> {
        let value = self.nearest_f64()?;
        Some(if value.is_infinite() {
            Ranged::Overflow { log10: self.log10() }
        } else if value == 0.0 && !self.is_zero() {
            Ranged::Underflow { log10: self.log10() }
        } else {
            Ranged::Value(value)
        })
    }
}

impl<const N: usize> Round for State<Extended<N>> {
    type Rounded = State<Ranged<f64>>;

    #[inline(always)]
    fn round(&self) -> Option<Self::Rounded> {
        Some(State {
            contact_radius: self.contact_radius.round()?,
            indentation: self.indentation.round()?,
            force: self.force.round()?,
        })
    }
}

impl<const N: usize> Round for Fold<Extended<N>> {
    type Rounded = Fold<Ranged<f64>>;

    fn round(&self) -> Option<Self::Rounded> {
        Some(Fold {
            contact_radius: self.contact_radius.round()?,
            indentation: self.indentation.round()?,
            force: self.force.round()?,
            kind: self.kind,
        })
    }
}

impl Round for ScaleFreeOutcome {
    type Rounded = ScaleFreeOutcome;

    fn round(&self) -> Option<ScaleFreeOutcome> {
        Some(*self)
    }
}

impl<T: Round> Round for Vec<T> {
    type Rounded = Vec<T::Rounded>;

    fn round(&self) -> Option<Self::Rounded> {
        self.iter().map(T::round).collect()
    }
}

/// A decided result, a certain error, or `None` if more words are needed.
#[inline(always)]
pub(super) fn settle<T: Round>(formula: impl FnOnce() -> Result<T>) -> Option<Result<T::Rounded>> {
    match formula() {
        Ok(answer) => answer.round().map(Ok),
        // With few words an unknown result is reported as out of range.
        Err(Error::OutOfRange { .. } | Error::Undecided { .. } | Error::NoConvergence { .. }) => None,
        Err(certain) => Some(Err(certain)),
    }
}

#[cold]
pub(super) fn undecided(quantity: Quantity) -> Error {
    Error::Undecided { quantity, bits: 256, what: "which double is nearest" }
}

/// Evaluates a formula, generic in the arithmetic `$wide`, with 64, 128 and 256 bits until its result can be rounded.
macro_rules! decide {
    ($quantity:expr, $wide:ident => $formula:expr) => {{
        let one = {
            type $wide = Extended<1>;
            || settle(|| $formula)
        };
        let two = {
            type $wide = Extended<2>;
            || settle(|| $formula)
        };
        let four = {
            type $wide = Extended<4>;
            || settle(|| $formula)
        };
        one().or_else(two).or_else(four).unwrap_or_else(|| Err(undecided($quantity)))
    }};
}
pub(super) use decide;
