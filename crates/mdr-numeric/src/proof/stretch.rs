//! Pieces of integrals between kinks.

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::number::{Analytic, Interval, Real};
use rug::Float;
use rug::float::Round;

use super::continuation::Continuation;
use crate::transform::is_moderate;

/// What the radii of a piece of an integral have in common: they lie beyond so many kinks, and are x = v or, beyond a kink b,
/// x² = b² + v², with v from one number to another as t goes from 0 to 1.
pub(super) struct Stretch<'a> {
    pub(super) profile: &'a Continuation,
    pub(super) beyond: usize,
    /// A number whose square is x² − v².
    pub(super) base: Option<Interval>,
    pub(super) from: Interval,
    pub(super) length: Interval,
}

impl Stretch<'_> {
    /// v and x.
    pub(super) fn at<T: Analytic>(&self, t: &T) -> Option<[T; 2]> {
        let v = t.scaled(&self.length).plus(&t.constant(&self.from));
        let x = match &self.base {
            None => v.clone(),
            Some(base) => v.squared().plus(&v.constant(base).squared()).sqrt()?,
        };
        Some([v, x])
    }

    /// Whether powers of all radii are in the range of doubles.
    pub(super) fn is_moderate(&self) -> bool {
        is_moderate(&self.length) && self.base.as_ref().is_none_or(is_moderate)
    }

    /// v and x over an interval of t, on which v does not fall below 0.
    pub(super) fn over(&self, t: &Interval) -> Option<[Interval; 2]> {
        let [v, x] = self.at(t)?;
        Some([v.nonnegative()?, x.nonnegative()?])
    }
}

/// √(x² − b²); 0 where both are the same enclosure of one number.
pub(super) fn leg(x: &Interval, b: &Interval) -> Interval {
    if x.is_same(b) {
        return x.lit(0);
    }
    let product = (x.clone() - b) * (x.clone() + b);
    Real::sqrt(&product.nonnegative().unwrap_or_else(|| x.lit(0)))
}

/// A number of bounds, rounded up.
pub(super) fn up(value: &Float) -> Float {
    Float::with_val_round(BOUND_BITS, value, Round::Up).0
}
