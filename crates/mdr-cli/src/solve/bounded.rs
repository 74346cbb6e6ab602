//! A formula that is a number up to some radius only, such as the height of a sphere.

use mdr_core::contact::{ExpressionProfile, Profile};
use mdr_core::number::{Lift, Real, Special};

/// The radii at which a formula is tried: 2^−1000 to 2^500 m, so that the square of none is out of range.
const TRIED: std::ops::RangeInclusive<i64> = -1000..=500;

/// A formula on the radii where it is a number.
pub(super) struct Bounded<R: Special> {
    profile: ExpressionProfile<R>,
    outer: Option<R>,
}

impl<R: Special> Bounded<R> {
    /// Finds the radius at which the formula ceases to be a number: between two powers of two, then by bisection. None where
    /// it is one at all powers of two that are tried, and where it is none at the first.
    pub(super) fn new(profile: ExpressionProfile<R>, ctx: R::Ctx) -> Self {
        let radius = |octave: i64| R::from_int(ctx, 2).powi(octave);
        let is_number = |r: &R| !is_nan(&profile.height(r));
        let outer = match TRIED.into_iter().position(|octave| !is_number(&radius(octave))) {
            None | Some(0) => None,
            Some(first) => {
                let octave = TRIED.start() + first as i64;
                Some(last_within(radius(octave - 1), radius(octave), is_number))
            }
        };
        Bounded { profile, outer }
    }
}

/// The largest radius, up to rounding, before which a condition holds that does at `inside` and not at `outside`.
fn last_within<R: Real>(mut inside: R, mut outside: R, holds: impl Fn(&R) -> bool) -> R {
    for _ in 0..=inside.precision() {
        let middle = (inside.clone() + &outside).over(2);
        if holds(&middle) { inside = middle } else { outside = middle }
    }
    inside
}

/// An infinite height is one: of a power out of range, or of a pole.
fn is_nan<R: Real>(x: &R) -> bool {
    x.partial_cmp(x).is_none()
}

impl<R: Special> Profile<R> for Bounded<R> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        self.profile.height(r)
    }

    fn outer_radius(&self) -> Option<R> {
        self.outer.clone()
    }
}
