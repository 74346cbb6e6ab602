//! Certified answers.

use mdr_core::contact::{Fold, Regime};
use mdr_core::number::certify::Decimal;

use crate::state::State;

/// Correctly rounded answers to a [`Question`](super::Question).
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The regime of n: above, at or below 1/2.
    pub regime: Regime,
    /// κ_n.
    pub kappa: Decimal,
    /// The critical state; on a machine the first fold when leaving the stable branch. `None` at n = 1/2, except on a
    /// machine with 1 < ρ < 3.
    pub critical: Option<State<Decimal>>,
    /// On a machine all folds, by increasing radius; otherwise empty.
    pub folds: Vec<Fold<Decimal>>,
    /// At n = 1/2 the threshold of C under this control (1.19), see [`threshold`](crate::threshold()); otherwise
    /// `None`.
    pub threshold: Option<Decimal>,
    /// At n = 1/2 the ratio of C to the threshold.
    pub ratio: Option<Decimal>,
}
