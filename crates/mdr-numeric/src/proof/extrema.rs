//! The extrema of g: what decides whether a contact is admissible.

use mdr_core::calculus::isolate::{Behaviour, isolate};
use mdr_core::contact::{Error, Quantity, Result, Slopes, Transform};
use mdr_core::number::{Dual, Interval, Real};
use rug::Float;

use super::condition::behaviour;
use super::ends::FAR;
use super::{EnclosedCurve, kinks};

/// The most cells on which g' is shown to be of one sign out to the largest radii.
const CELLS: usize = 512;

/// Whether g' ≥ 0 from a radius out to 2^1048576 m, on cells in octaves that are halved until it is certain.
pub fn rises_from(transform: &dyn Transform<Interval>, from: &Float) -> bool {
    let bits = from.prec();
    let first = super::ends::octave(from);
    let end = |octave: f64| if octave > first { Float::with_val(bits, octave).exp2() } else { from.clone() };
    let mut open = vec![(first, FAR)];
    for _ in 0..CELLS {
        let Some((lower, upper)) = open.pop() else { return true };
        let slope = transform.slope(&Interval::new(end(lower), end(upper)));
        if slope.is_ok_and(|slope| *slope.lower() >= 0) {
            continue;
        }
        if upper - lower < 1e-2 {
            return false;
        }
        // The far radii are in cells that are wide, as they say most of the time that it rises.
        let step = (upper - lower).sqrt().min((upper - lower) / 2.0);
        let middle = if lower > 1.0 { (lower * upper).sqrt() } else { lower + step };
        open.extend([(middle, upper), (lower, middle)]);
    }
    false
}

impl EnclosedCurve {
    /// Enclosures of all radii in (lower, upper) off kinks at which g' changes its sign, with at most about `budget` evaluations
    /// between two kinks; `None` if some may be missing.
    ///
    /// # Errors
    /// Errors of the transform; [`Error::Unproved`] of a range that reaches beyond the profile.
    pub fn extrema(&self, lower: &Float, upper: &Float, budget: usize) -> Result<Option<Vec<Interval>>> {
        let transform = self.plain.transform();
        let mut extrema = Vec::new();
        let mut from = lower.clone();
        for (index, kink) in transform.kinks().iter().enumerate() {
            if kink.upper() <= lower || kink.lower() >= upper {
                continue;
            }
            let Some([before, after]) = self.one_sign_beside(index, kink)? else { return Ok(None) };
            if !self.turning_points(&from, &before, budget, &mut extrema)? {
                return Ok(None);
            }
            from = after;
        }
        let all = self.turning_points(&from, upper, budget, &mut extrema)?;
        Ok(all.then_some(extrema))
    }

    /// The ends of a neighbourhood of a kink on each side of which g' has one sign.
    fn one_sign_beside(&self, index: usize, kink: &Interval) -> Result<Option<[Float; 2]>> {
        let has_sign = |slopes: &Slopes<Interval>| {
            slopes.least.as_ref().is_some_and(|least| *least.lower() >= 0)
                || slopes.greatest.as_ref().is_some_and(|greatest| *greatest.upper() <= 0)
        };
        for margin in kinks::MARGINS {
            let width = kink.lit(2).powi(-i64::from(margin));
            let Some(known) = self.plain.transform().kink(index, &width)? else { continue };
            if has_sign(&known.inside) && has_sign(&known.outside) {
                return Ok(Some([
                    kinks::shifted(kink.lower(), -1, margin + 1),
                    kinks::shifted(kink.upper(), 1, margin + 1),
                ]));
            }
        }
        Ok(None)
    }

    /// Adds the zeros of g' between kinks; returns whether they are all.
    fn turning_points(&self, lower: &Float, upper: &Float, budget: usize, extrema: &mut Vec<Interval>) -> Result<bool> {
        if lower >= upper {
            return Ok(true);
        }
        let ends = [lower, upper].map(|end| Interval::point(end.clone()));
        let slope = |x: &Interval| self.slope_of_g(x);
        let isolation = isolate(&ends[0], &ends[1], budget, slope, |a, b| self.turn(&a.hull(b)))?;
        extrema.extend(isolation.brackets.iter().map(|bracket| bracket.lower.x.hull(&bracket.upper.x)));
        Ok(isolation.undecided.is_empty())
    }

    /// g', of which nothing is proved off the domain of the profile.
    fn slope_of_g(&self, x: &Interval) -> Result<Interval> {
        match self.plain.transform().slope(x) {
            Err(Error::Domain { .. }) => Err(Error::unproved(Quantity::Radius, x, "name radii within the profile")),
            slope => slope,
        }
    }

    /// The behaviour of g' on a cell.
    fn turn(&self, cell: &Interval) -> Result<Behaviour> {
        let over = match self.dual.transform().slope(&Dual::variable(cell.clone())) {
            Err(Error::Domain { .. }) => return Ok(Behaviour::Unknown),
            over => over?,
        };
        // On a flat g' is nothing everywhere.
        if over.value.vanishes() {
            return Ok(Behaviour::Nonzero);
        }
        behaviour(Some(over), cell, |centre| self.slope_of_g(centre).map(Some))
    }
}
