//! The loss of admissibility over enclosures: the last admissible state on a stable branch, and the ring on which the surfaces touch.
//!
//! With c² = r² − a² and the [moments](super::fields) Jₖ = dᵏ/dcᵏ c ∫₀^{π/2} sinθ f(a sinθ)/(c² + a² cos²θ) dθ the gap and its slopes are
//!
//! h = f − d + (2/π) \[d arctan(a/c) − a J₀\], h' = f' − (2/π) \[d a/(rc) + a (r/c) J₁\],
//! h'' = f'' + (2/π) \[d a (1/(r²c) + 1/c³) + (a³/c³) J₁ − a (r²/c²) J₂\].
//!
//! On a stable branch h falls at every r as a grows ([why](crate::admissible)). So admissibility is lost between two radii a₁ < a₂ where
//!
//! * h(a₂, r) < 0 at one r;
//! * on a neighbourhood of that r, h'' > 0 and h − h'²/(2 min h'') > 0 at a₁, or the neighbourhood holds a kink at which h > 0, towards
//!   which h falls on both sides;
//! * elsewhere h(a₂, r) > 0 wherever g(r) < d. Where g ≥ d the gap is not negative unless it is so further inside.

use std::ops::RangeInclusive;

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::contact::{Equilibrium, Error, Quantity, Result, Stability};
use mdr_core::number::{Interval, Precision, Real, Special};

use super::continuation::Continuation;
use super::elsewhere::HEIGHTS;
use super::fields::moments;
use super::floor::Floor;
use super::stretch::leg;
use crate::admissible::Ring;
use crate::contact::Contact;

/// The most steps of Newton's iteration, each of which nearly doubles the digits of doubles.
const STEPS: usize = 24;
/// Neighbourhoods of the ring of the relative sizes 2^−k, the largest first.
const NEIGHBOURHOODS: [i32; 8] = [2, 3, 4, 6, 8, 10, 14, 18];
/// Bits of the precision by which two radii of contact are told apart, and how many more are tried.
const BRACKETS: [u32; 5] = [28, 40, 52, 64, 80];

/// A contact on a half-space, and what lies outside it.
pub(super) struct Outside<'a> {
    pub(super) contact: &'a Contact<Interval>,
    pub(super) profile: &'a Continuation,
    /// The most heights of f that are spent on one place.
    pub(super) heights: u64,
    /// A bound of g from below.
    pub(super) floor: Option<&'a Floor>,
}

/// A contact radius and the indentation.
#[derive(Clone)]
pub(super) struct Place {
    pub(super) a: Interval,
    pub(super) d: Interval,
}

impl Place {
    /// With the bits of bounds.
    pub(super) fn rough(&self) -> Place {
        let rough = |number: &Interval| number.rounded(Precision::new(BOUND_BITS));
        Place { a: rough(&self.a), d: rough(&self.d) }
    }

    /// Whether what is certain of another place is certain here.
    pub(super) fn is_within(&self, other: &Place) -> bool {
        other.a.encloses(&self.a) && other.d.encloses(&self.d)
    }

    pub(super) fn overlaps(&self, other: &Place) -> bool {
        self.a.overlaps(&other.a) && self.d.overlaps(&other.d)
    }

    fn hull(&self, other: &Place) -> Place {
        Place { a: self.a.hull(&other.a), d: self.d.hull(&other.d) }
    }
}

/// The ring, with radii around it on which the gap has no other minimum.
struct Valley {
    radius: Interval,
    around: Interval,
    /// A bound of h'' there; `None` if the ring is a kink.
    bend: Option<Interval>,
}

impl<'a> Outside<'a> {
    pub(super) fn new(contact: &'a Contact<Interval>, profile: &'a Continuation) -> Self {
        Outside { contact, profile, heights: HEIGHTS, floor: None }
    }
}

impl Outside<'_> {
    fn equilibrium(&self, a: Interval) -> Result<Place> {
        Ok(Place { d: self.contact.indentation(&a)?, a })
    }

    /// The gap with two derivatives in r, over all parts of f that a set of radii meets.
    pub(super) fn gap(&self, place: &Place, r: &Interval) -> Result<[Interval; 3]> {
        let breaks = self.profile.breaks();
        let first = breaks.partition_point(|b| b.upper() < r.lower());
        let last = breaks.partition_point(|b| b.lower() <= r.upper());
        self.gap_over(place, r, first..=last)
    }

    /// The gap with two derivatives in r, over some parts of f, which go on beyond kinks.
    fn gap_over(&self, place: &Place, r: &Interval, parts: RangeInclusive<usize>) -> Result<[Interval; 3]> {
        let Place { a, d } = place;
        if !(r > a && self.profile.reaches(r)) {
            return Err(self.open(r));
        }
        let c = leg(r, a);
        let j = moments(self.profile, a, r, 2)?;
        let ratio = r.clone() / &c;
        let cube = c.square() * &c;
        let share = d.clone() * a;
        let u = d.clone() * Special::atan(&(a.clone() / &c)) - a.clone() * &j[0];
        let slope = -(share.clone() / (r.clone() * &c)) - a.clone() * &ratio * &j[1];
        let bend = share / (r.square() * &c) + d.clone() * a / &cube;
        let bend = bend + a.square() * a / &cube * &j[1] - ratio.square() * a * &j[2];
        let mut heights: Option<[Interval; 3]> = None;
        for beyond in parts {
            let f = self.profile.heights(r, 2, beyond).ok_or_else(|| self.open(r))?;
            let (rise, second) = (f.derivative(1), f.derivative(2));
            let of = [f.value().clone(), rise.clone() / r, (second - rise) / r.square()];
            heights = Some(match heights {
                None => of,
                Some(hull) => std::array::from_fn(|k| hull[k].hull(&of[k])),
            });
        }
        let Some([f, f1, f2]) = heights else { return Err(self.open(r)) };
        let share = |value: Interval| value.times(2) / a.pi();
        Ok([f - d + share(u), f1 + share(slope), f2 + share(bend)])
    }

    pub(super) fn open(&self, r: &Interval) -> Error {
        Error::unproved(Quantity::Radius, r, "the gap is not enclosed there")
    }

    fn undecided(&self) -> Error {
        Error::undecided(Quantity::ContactRadius, self.contact.modulus(), "in which state admissibility is lost")
    }

    /// Whether the surfaces of an equilibrium certainly overlap at a radius.
    pub(super) fn overlaps(&self, a: &Interval, r: f64) -> Result<bool> {
        Ok(self.overlap(&self.equilibrium(a.clone())?, r)?.is_some())
    }

    /// The gap at a radius, if it is certainly negative.
    pub(super) fn overlap(&self, place: &Place, r: f64) -> Result<Option<f64>> {
        let [gap, ..] = self.gap(place, &Interval::from_f64(place.a.ctx(), r))?;
        Ok((*gap.upper() < 0).then(|| gap.approx()))
    }

    /// The last admissible state of a stable branch and the ring, from approximations of both.
    ///
    /// # Errors
    /// [`Error::Unproved`] and [`Error::Undecided`] where it is not proved; errors of the transform.
    pub(super) fn last_admissible(&self, rough: [f64; 2]) -> Result<(Equilibrium<Interval>, Ring<Interval>)> {
        let [a, r] = rough.map(|x| Interval::from_f64(self.contact.modulus().ctx(), x));
        let kink = self.profile.breaks().iter().find(|b| (b.approx() / r.approx() - 1.0).abs() < 1e-6);
        let kink = kink.map(|kink| kink.rounded(a.ctx()));
        let (a, r) = self.settled(a, kink.clone().unwrap_or(r), kink.is_some())?;
        let bits = a.precision();
        for spare in BRACKETS.iter().filter(|spare| **spare < bits) {
            let step = a.lit(2).powi(i64::from(*spare) - i64::from(bits)) * &a;
            let [before, after] = [a.clone() - &step, a.clone() + &step].map(|a| a.midpoint());
            let [before, after] = [self.equilibrium(before)?, self.equilibrium(after)?];
            let [gap, ..] = self.gap(&after, &r)?;
            if *gap.upper() >= 0 {
                continue;
            }
            let both = before.hull(&after).rough();
            let valley = match &kink {
                Some(kink) => self.valley_at_kink(&both, kink),
                None => self.valley(&both, &r),
            };
            let Some(valley) = valley else { return Err(self.undecided()) };
            if !self.is_open(&before, &valley)? {
                continue;
            }
            self.check_elsewhere(&after.rough(), &valley.around)?;
            let hull = before.a.hull(&after.a);
            let radius = self.ring(&before.hull(&after), valley)?;
            let (indentation, force) = self.contact.state(&hull)?;
            let gap = hull.lit(0);
            let state = Equilibrium { contact_radius: hull, indentation, force, stability: Stability::Stable };
            return Ok((state, Ring { radius, gap }));
        }
        Err(self.undecided())
    }

    /// The contact radius and the ring to the digits of this arithmetic, which nothing rests on: Newton's iteration for h = h' = 0.
    fn settled(&self, mut a: Interval, mut r: Interval, at_kink: bool) -> Result<(Interval, Interval)> {
        let enough = a.unit_roundoff().approx() * 64.0;
        for _ in 0..STEPS {
            let place = self.equilibrium(a.clone())?;
            let [mut gap, slope, bend] = self.gap(&place, &r)?;
            if !at_kink {
                let step = (slope / &bend).midpoint();
                gap -= &(step.square() * bend).over(2);
                r = (r - &step).midpoint();
            }
            let held = self.contact.elongation(&a);
            let deeper = self.contact.transform().slope(&a)? - self.contact.elongation_slope(&a);
            let c = leg(&r, &a);
            let fall = (held / &c + deeper * Special::atan(&(c / &a))).times(2) / a.pi();
            let step = (gap / fall).midpoint();
            let is_last = (step.approx() / a.approx()).abs() <= enough;
            a = (a + step).midpoint();
            if !Real::is_finite(&a) || !Real::is_finite(&r) {
                return Err(self.undecided());
            }
            if is_last {
                return Ok((a, r));
            }
        }
        Err(self.undecided())
    }

    /// Radii around the ring on which the gap is convex for all places.
    fn valley(&self, places: &Place, r: &Interval) -> Option<Valley> {
        let r = r.rounded(Precision::new(BOUND_BITS));
        NEIGHBOURHOODS.iter().find_map(|size| {
            let around = self.beside(places, &r, *size)?;
            if self.profile.breaks().iter().any(|b| b.overlaps(&around)) {
                return None;
            }
            let [_, _, bend] = self.gap(places, &around).ok()?;
            (*bend.lower() > 0).then(|| Valley { radius: r.clone(), around, bend: Some(bend) })
        })
    }

    /// Radii around a kink towards which the gap falls on both sides.
    fn valley_at_kink(&self, places: &Place, kink: &Interval) -> Option<Valley> {
        let rough = kink.rounded(Precision::new(BOUND_BITS));
        NEIGHBOURHOODS.iter().find_map(|size| {
            let around = self.beside(places, &rough, *size)?;
            let breaks = self.profile.breaks();
            if breaks.iter().filter(|b| b.overlaps(&around)).count() != 1 {
                return None;
            }
            let index = breaks.iter().position(|b| b.overlaps(&around))?;
            // Each side holds the enclosure of the kink.
            let sides = [[around.lower(), rough.upper()], [rough.lower(), around.upper()]];
            let [before, after] = sides.map(|[from, to]| Interval::new(from.clone(), to.clone()));
            let [_, before, _] = self.gap_over(places, &before, index..=index).ok()?;
            let [_, after, _] = self.gap_over(places, &after, index + 1..=index + 1).ok()?;
            let falls = *before.upper() < 0 && *after.lower() > 0;
            falls.then(|| Valley { radius: kink.clone(), around, bend: None })
        })
    }

    /// r (1 ± 2^−size), outside the contact.
    fn beside(&self, places: &Place, r: &Interval, size: i32) -> Option<Interval> {
        let width = r.lit(2).powi(-i64::from(size)) * r;
        let around = r.clone().inflate(&width);
        (around > places.a && self.profile.reaches(&around)).then_some(around)
    }

    /// Whether no gap in the valley is closed.
    fn is_open(&self, place: &Place, valley: &Valley) -> Result<bool> {
        let r =
            if valley.bend.is_some() { valley.radius.midpoint().rounded(place.a.ctx()) } else { valley.radius.clone() };
        let [gap, slope, _] = self.gap(place, &r)?;
        let least = match &valley.bend {
            Some(bend) => gap - slope.square() / bend.clone().times(2),
            None => gap,
        };
        Ok(*least.lower() > 0)
    }

    /// The radius at which h' = 0.
    fn ring(&self, places: &Place, valley: Valley) -> Result<Interval> {
        let Some(bend) = valley.bend else { return Ok(valley.radius) };
        let r = valley.radius.midpoint().rounded(places.a.ctx());
        let [_, slope, _] = self.gap(places, &r)?;
        (r - slope / bend).intersect(&valley.around).ok_or_else(|| self.undecided())
    }
}

#[cfg(test)]
#[path = "../../tests/private/overlap.rs"]
mod tests;
