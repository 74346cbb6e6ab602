//! Bounds of g at a radius where one of its derivatives jumps, and close to it.

use crate::number::Real;

/// g at a kink, for proofs by enclosures: no enclosure of g' is valid on both sides of a kink.
#[derive(Clone, Debug)]
pub struct Kink<R> {
    /// g and its mean (1/x) ∫₀ˣ g at the kink; `None` where g is infinite.
    pub value: Option<(R, R)>,
    /// g' for smaller radii.
    pub inside: Slopes<R>,
    /// g' for larger radii.
    pub outside: Slopes<R>,
}

impl<R: Real> Kink<R> {
    /// The kink of the sum of two functions.
    pub fn plus(self, other: Self) -> Self {
        let value = match (self.value, other.value) {
            (Some((g, mean)), Some((other_g, other_mean))) => Some((g + other_g, mean + other_mean)),
            _ => None,
        };
        Kink { value, inside: self.inside.plus(other.inside), outside: self.outside.plus(other.outside) }
    }
}

/// Bounds of g' on an open interval that ends at a kink.
#[derive(Clone, Debug)]
pub struct Slopes<R> {
    /// A lower bound of g'; `None` if no bound exists or is known.
    pub least: Option<R>,
    /// An upper bound of g'; `None` if no bound exists or is known.
    pub greatest: Option<R>,
}

impl<R: Real> Slopes<R> {
    /// No bounds.
    pub fn unknown() -> Self {
        Slopes { least: None, greatest: None }
    }

    /// g' lies in an enclosure.
    pub fn within(enclosure: R) -> Self {
        Slopes { least: Some(enclosure.clone()), greatest: Some(enclosure) }
    }

    /// g' is at least `least`, and may be infinite.
    pub fn at_least(least: R) -> Self {
        Slopes { least: Some(least), greatest: None }
    }

    /// g' is at most `greatest`, and may be −∞.
    pub fn at_most(greatest: R) -> Self {
        Slopes { least: None, greatest: Some(greatest) }
    }

    /// The bounds of a sum of two functions.
    pub fn plus(self, other: Self) -> Self {
        let sum = |a: Option<R>, b: Option<R>| Some(a? + b?);
        Slopes { least: sum(self.least, other.least), greatest: sum(self.greatest, other.greatest) }
    }
}
