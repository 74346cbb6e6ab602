//! What a medium weighs the heights of a profile with in a transform.

use mdr_core::number::{Real, Special};

/// The medium of a transform.
#[derive(Clone, Debug)]
pub(crate) enum Weight<R> {
    /// A homogeneous half-space.
    #[cfg_attr(not(feature = "mp"), allow(dead_code, reason = "of enclosures only"))]
    HalfSpace,
    /// A half-space graded as zᵏ: k.
    Graded(R),
    /// A Winkler foundation.
    Winkler,
    /// A half-plane in line contact: the distance L of the reference of its depth, if it has one.
    Line(Option<R>),
}

impl<R: Real> Weight<R> {
    /// q = d ln S/d ln a where that is a constant: 1 + k, and 1 for a line contact, where it is not of use.
    pub(crate) fn order(&self, like: &R) -> R {
        match self {
            Weight::HalfSpace | Weight::Line(_) => like.lit(1),
            Weight::Graded(k) => like.lit(1) + k,
            Weight::Winkler => like.lit(2),
        }
    }
}

/// φ, what is weighed; D = r d/dr.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Density {
    /// f.
    Height,
    /// Df.
    Rise,
    /// (1 + k + D)f; Df in line contact.
    Transform,
    /// D of it.
    Slope,
}

/// The factor of the mean of a line contact of half-width b against a reference at L, (2/π)√(1 − (b/L)²).
pub(crate) fn factor_of_mean<R: Special>(b: &R, reference: &R) -> R {
    let share = b.clone() / reference;
    let room = (share.lit(1) - &share) * (share.lit(1) + &share);
    room.sqrt().times(2) / b.pi()
}
