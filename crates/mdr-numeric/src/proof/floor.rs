//! A bound of g from below by the folds of d, for contacts beside something narrow, where enclosures of the gap are wide.
//!
//! Beyond a radius a, d = g − Δl is least at a, at a minimum or where it ends, and Δl is not below Δl(a). So g is not below the indentation of
//! a state at a where no minimum of d beyond a is below it by more than Δl(a); and where g ≥ d from a up to r, the gap at r is not negative.

use std::sync::OnceLock;

use mdr_core::contact::FoldKind;
use mdr_core::number::Interval;
use rug::Float;

use super::EnclosedCurve;
use super::overlap::Place;

/// The octaves beyond the range of the folds up to which g is bounded, too: as far as a gap may have to be looked at.
const BEYOND: u32 = 3;

/// The minima of d on a range of radii, found when they are asked for.
pub(super) struct Floor {
    curve: EnclosedCurve,
    range: (Float, Float),
    /// Evaluations between two kinks.
    most: usize,
    minima: OnceLock<Option<Minima>>,
}

struct Minima {
    /// Radius and d of each one.
    places: Vec<Place>,
    /// The radii between which these are all.
    from: Float,
    to: Float,
    /// d at the end of the range.
    last: Interval,
}

impl Floor {
    /// Of a contact at fixed grips.
    pub(super) fn new(curve: EnclosedCurve, (lower, upper): (Float, Float), most: usize) -> Self {
        Floor { curve, range: (lower, upper << BEYOND), most, minima: OnceLock::new() }
    }

    /// Whether g is certainly not below d from a on up to a radius.
    pub(super) fn is_above(&self, place: &Place, to: &Float) -> bool {
        let minima = self.minima.get_or_init(|| self.find());
        minima.as_ref().is_some_and(|minima| minima.is_above(place, to, &self.curve))
    }

    fn find(&self) -> Option<Minima> {
        let found = self.curve.folds(&self.range.0, &self.range.1, self.most).ok()?;
        if !found.poles.is_empty() {
            return None;
        }
        let (from, to) = found.range;
        let from = found.undecided.into_iter().map(|(_, end)| end).fold(from, |from, end| from.max(&end));
        let last = self.curve.plain().indentation(&Interval::point(to.clone())).ok()?;
        let minima = found.folds.into_iter().filter(|fold| fold.kind == FoldKind::Minimum);
        let places = minima.map(|fold| Place { a: fold.contact_radius, d: fold.indentation }).collect();
        Some(Minima { places, from, to, last })
    }
}

impl Minima {
    fn is_above(&self, Place { a, d }: &Place, to: &Float, curve: &EnclosedCurve) -> bool {
        let held = curve.plain().elongation(a);
        let is_above = |least: &Interval| *(least.clone() + &held - d).lower() >= 0;
        let mut beyond = self.places.iter().filter(|place| place.a.upper() >= a.lower());
        *a.lower() >= self.from && *to <= self.to && is_above(&self.last) && beyond.all(|place| is_above(&place.d))
    }
}

#[cfg(test)]
#[path = "../../tests/private/floor.rs"]
mod tests;
