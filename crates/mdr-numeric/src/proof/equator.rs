//! Close to an equator, where g diverges: the proved sign of the condition up to it, and the equilibrium before it.

use std::cmp::Ordering;

use mdr_core::contact::{Equilibrium, Result, Stability};
use mdr_core::number::{Interval, Real};
use rug::Float;

use super::condition::sign;
use super::{EnclosedCurve, ProvedBranches, kinks};

/// The relative distance 2^−k from an equator within which folds are not searched.
const CLOSEST: u32 = 2560;

impl EnclosedCurve {
    /// The k for which a search for folds ends at a relative distance 2^−k before the outer radius: 40, or before an
    /// equator the first of 40, 80, 160, … for which there is certainly no fold closer to it.
    ///
    /// # Errors
    /// Errors of the transform near its outer radius; see [`Transform::kink`](mdr_core::contact::Transform::kink).
    pub fn octaves_to_equator(&self) -> Result<u32> {
        let Some(outer) = self.plain.equator()? else { return Ok(kinks::FINEST) };
        let mut octaves = kinks::FINEST;
        while octaves < CLOSEST && !self.is_stable_from(&outer.lit(2).powi(-i64::from(octaves)), &outer)? {
            octaves *= 2;
        }
        Ok(octaves)
    }

    /// The equator, if the condition is certainly positive from a radius up to it.
    pub(super) fn stable_equator(&self, from: &Float) -> Result<Option<Interval>> {
        let Some(outer) = self.plain.equator()? else { return Ok(None) };
        let margin = (outer.clone() - Interval::point(from.clone())) / &outer;
        let certain = margin > margin.lit(0) && margin < margin.ratio(1, 4) && self.is_stable_from(&margin, &outer)?;
        Ok(certain.then_some(outer))
    }

    /// Whether the condition is certainly positive from a relative distance up to the equator.
    fn is_stable_from(&self, margin: &Interval, equator: &Interval) -> Result<bool> {
        let transform = self.plain.transform();
        let around = equator.clone().inflate(&(margin.clone() * equator));
        let end = transform.kink(transform.kinks().len(), margin)?;
        Ok(end.is_some_and(|end| sign(&self.plain, &around, &end.inside) == Some(Ordering::Greater)))
    }
}

impl ProvedBranches {
    /// The equilibrium between a radius at which the contact grows and the equator; the two may be adjacent numbers of
    /// this precision.
    ///
    /// Up to the equilibrium g increases, to d + Δl. So its integral is that up to the last radius plus at most the
    /// distance times the larger of both heights. As d depends on the mean of g by a factor of at most one, a distance
    /// below half the radius makes d + Δl less than twice its value with the mean from the last radius alone.
    pub(super) fn before_equator(
        &self,
        last: &Interval,
        equator: &Interval,
        value: &Interval,
    ) -> Result<Equilibrium<Interval>> {
        let curve = &self.curve.plain;
        let radius = last.hull(equator);
        let distance = (equator.clone() - last) / &radius;
        if !(distance < distance.ratio(1, 2)) {
            return Err(self.curve.undecided("how far from the outer radius the equilibrium lies"));
        }
        let mean = curve.transform().mean(last)? * last / &radius;
        let below = curve.transform().g(last)?.abs();
        let at_state = (curve.held_against(&radius, value, || Ok(mean.clone()))? + curve.elongation(&radius)).abs();
        let highest = (below + at_state.times(2)) * distance.abs();
        let mean = mean.inflate(&highest);
        let d = curve.held_against(&radius, value, || Ok(mean.clone()))?;
        let force = curve.stiffness(&radius) * (d.clone() - &mean);
        Ok(self.equilibrium(radius, d, force, value, Stability::Stable))
    }
}
