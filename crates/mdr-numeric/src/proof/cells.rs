//! The parts of a range on which a proof of all folds rests, in words that need no knowledge of the proof.

use std::cmp::Ordering;

use mdr_core::calculus::roots::Sample;
use mdr_core::named;
use mdr_core::number::{Interval, Real};
use rug::Float;

named! {
    /// How the controlled quantity of equilibria behaves while the contact radius grows through a part of a range.
    pub enum Trend {
        /// It rises: there is no fold, and equilibria are stable.
        Rises = "rises",
        /// It falls: there is no fold, and equilibria are unstable.
        Falls = "falls",
        /// It falls, then rises: one fold, a minimum.
        Minimum = "minimum",
        /// It rises, then falls: one fold, a maximum.
        Maximum = "maximum",
    }
}

/// A part of the range of a proof. The controlled quantity is continuous on it and has the trend; where it diverges, at a pole of
/// g, it has the trend on either side.
#[derive(Clone, Debug, PartialEq)]
pub struct ProvedCell {
    /// The smallest contact radius.
    pub from: Float,
    /// The largest contact radius.
    pub to: Float,
    /// How the controlled quantity behaves between them.
    pub trend: Trend,
}

impl ProvedCell {
    /// A cell of the isolation of zeros of the tangency condition, which has the sign of the derivative of the controlled quantity.
    pub(super) fn of([lower, upper]: &[Sample<Interval>; 2]) -> Self {
        let sign = |at: &Sample<Interval>| at.f.partial_cmp(&at.f.lit(0)).unwrap_or(Ordering::Equal);
        let trend = Trend::between(sign(lower), sign(upper));
        ProvedCell { from: lower.x.lower().clone(), to: upper.x.upper().clone(), trend }
    }
}

impl Trend {
    /// By the signs of the derivative at the two ends, between which it changes once at most.
    pub(super) fn between(lower: Ordering, upper: Ordering) -> Self {
        match (lower, upper) {
            (Ordering::Less, Ordering::Less | Ordering::Equal) => Trend::Falls,
            (Ordering::Less, Ordering::Greater) => Trend::Minimum,
            (Ordering::Greater, Ordering::Less) => Trend::Maximum,
            (Ordering::Equal, Ordering::Less) => Trend::Falls,
            _ => Trend::Rises,
        }
    }
}
