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
use mdr_core::contact::{Equilibrium, Error, Quantity, Result, Stability, Transform};
use mdr_core::number::{Euler, Interval, Precision, Real, Special};
use rug::Float;

use super::continuation::{Continuation, leg};
use super::ends::{FAR, octave};
use super::fields::moments;
use crate::admissible::Ring;
use crate::contact::Contact;

/// The most steps of Newton's iteration, each of which nearly doubles the digits of doubles.
const STEPS: usize = 24;
/// Neighbourhoods of the ring of the relative sizes 2^−k, the largest first.
const NEIGHBOURHOODS: [i32; 8] = [2, 3, 4, 6, 8, 10, 14, 18];
/// Bits of the precision by which two radii of contact are told apart, and how many more are tried.
const BRACKETS: [u32; 5] = [28, 40, 52, 64, 80];
/// The most cells outside the ring,
const CELLS: usize = 4000;
/// none of which is wider than this ratio when g is looked at,
const WIDEST: f64 = 1.03;
/// or narrower than this when nothing is decided.
const FINEST: f64 = 1.0 + 1e-9;

/// A contact on a half-space, and what lies outside it.
pub(super) struct Outside<'a> {
    pub(super) contact: &'a Contact<Interval>,
    pub(super) profile: &'a Continuation,
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

impl Outside<'_> {
    fn equilibrium(&self, a: Interval) -> Result<Place> {
        Ok(Place { d: self.contact.indentation(&a)?, a })
    }

    /// The gap with two derivatives in r, over all parts of f that a set of radii meets.
    fn gap(&self, place: &Place, r: &Interval) -> Result<[Interval; 3]> {
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
            let f = self.profile.height(&Euler::variable(r, 2), beyond).ok_or_else(|| self.open(r))?;
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

    fn open(&self, r: &Interval) -> Error {
        let [from, to] = [r.lower(), r.upper()].map(|end| end.to_string_radix(10, Some(17)));
        Error::Unproved { quantity: Quantity::Radius, from, to, remedy: "the gap is not enclosed there" }
    }

    fn undecided(&self) -> Error {
        Error::undecided(Quantity::ContactRadius, self.contact.modulus(), "in which state admissibility is lost")
    }

    /// Whether the surfaces of an equilibrium certainly overlap at a radius.
    pub(super) fn overlaps(&self, a: &Interval, r: f64) -> Result<bool> {
        self.is_closed(&self.equilibrium(a.clone())?, r)
    }

    /// Whether the gap at a radius is certainly negative.
    pub(super) fn is_closed(&self, place: &Place, r: f64) -> Result<bool> {
        let [gap, ..] = self.gap(place, &Interval::from_f64(place.a.ctx(), r))?;
        Ok(*gap.upper() < 0)
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

    /// Checks that the gap is open outside the neighbourhood of the ring, wherever g is below the indentation.
    fn check_elsewhere(&self, place: &Place, around: &Interval) -> Result<()> {
        let far = self.far(place, around)?;
        let cells = vec![(around.upper().clone(), far), (place.a.upper().clone(), around.lower().clone())];
        self.check_cells(place, cells)
    }

    /// Checks that the gap is open everywhere outside the contact, up to the end of the profile, wherever g is below the indentation.
    pub(super) fn check_everywhere(&self, place: &Place) -> Result<()> {
        let far = match self.contact.transform().outer_radius() {
            Some(outer) => outer.rounded(place.a.ctx()).upper().clone(),
            None => self.far(place, &place.a)?,
        };
        self.check_cells(place, vec![(place.a.lower().clone(), far)])
    }

    fn check_cells(&self, place: &Place, mut cells: Vec<(Float, Float)>) -> Result<()> {
        for _ in 0..CELLS {
            let Some((from, to)) = cells.pop() else { return Ok(()) };
            let cell = Interval::new(from.clone(), to.clone());
            let ratio = Float::with_val(BOUND_BITS, &to / &from);
            if ratio <= WIDEST {
                if self.is_above(&cell, &place.d) || self.is_free(place, &cell) {
                    continue;
                }
                if ratio <= FINEST {
                    return Err(self.open(&cell));
                }
            }
            let middle = Float::with_val(BOUND_BITS, (from.clone() * &to).sqrt_ref());
            cells.extend([(middle.clone(), to), (from, middle)]);
        }
        Err(self.open(&place.a))
    }

    /// Whether g is certainly not below d on a cell.
    fn is_above(&self, cell: &Interval, d: &Interval) -> bool {
        let transform = self.contact.transform();
        if transform.g(cell).is_ok_and(|g| g.lower() >= d.upper()) {
            return true;
        }
        if least_before_end(transform, cell).is_some_and(|least| least.lower() >= d.upper()) {
            return true;
        }
        let kinks = transform.kinks();
        let mut within = kinks.iter().enumerate().filter(|(_, kink)| kink.overlaps(cell));
        let (Some((index, kink)), None) = (within.next(), within.next()) else { return false };
        least_beside(transform, index, kink, cell).is_some_and(|least| least.lower() >= d.upper())
    }

    /// Whether the gap is certainly open on a cell outside the contact.
    fn is_free(&self, place: &Place, cell: &Interval) -> bool {
        let Ok([over, slope, _]) = self.gap(place, cell) else { return false };
        if *over.lower() > 0 {
            return true;
        }
        let middle = cell.midpoint();
        let Ok([gap, ..]) = self.gap(place, &middle) else { return false };
        *(gap + slope * (cell.clone() - middle)).lower() > 0
    }

    /// A radius beyond which the gap is open: f is above the indentation by more than the surface may rise there,
    /// |u(r)| = (2/π) |∫₀ᵃ (d − g)/√(r² − x²) dx| ≤ (a/r) max |d − g|.
    fn far(&self, place: &Place, around: &Interval) -> Result<Float> {
        let Place { a, d } = place;
        let inside = self.profile.range(&a.lit(0).hull(a)).ok_or_else(|| self.open(a))?;
        let most = (d.clone() - inside).abs();
        let kinks = self.profile.breaks().last().map_or_else(|| around.upper(), Interval::upper);
        let mut from = Float::with_val(BOUND_BITS, around.upper().clone().max(kinks));
        for octaves in (0..6).map(|power| 1u32 << power) {
            from <<= octaves;
            if self.is_open_from(&from, &(most.clone() * a), d) {
                return Ok(from);
            }
        }
        Err(self.open(around))
    }

    /// Whether f − d is above `reach`/r from a radius beyond all kinks out to the largest radii.
    fn is_open_from(&self, from: &Float, reach: &Interval, d: &Interval) -> bool {
        let first = octave(from);
        let end = |octave: f64| if octave > first { Float::with_val(BOUND_BITS, octave).exp2() } else { from.clone() };
        let is_open = |lower: f64, upper: f64| {
            let r = Interval::new(end(lower), end(upper));
            let height = self.profile.height(&r, self.profile.breaks().len());
            let nearest = Interval::point(r.lower().clone());
            self.profile.reaches(&r) && height.is_some_and(|f| *(f - d - reach.clone() / nearest).lower() > 0)
        };
        let mut open = vec![(first, FAR)];
        for _ in 0..CELLS {
            let Some((lower, upper)) = open.pop() else { return true };
            if is_open(lower, upper) {
                continue;
            }
            if upper - lower < 1e-3 || !is_open(lower, lower) {
                return false;
            }
            let middle = if lower > 1.0 {
                (lower * upper).sqrt()
            } else {
                lower + (upper - lower).sqrt().min((upper - lower) / 2.0)
            };
            open.extend([(middle, upper), (lower, middle)]);
        }
        false
    }
}

/// A lower bound of g on a cell up to the end of the profile, or to where g diverges, on which it rises: g where the cell begins.
fn least_before_end(transform: &dyn Transform<Interval>, cell: &Interval) -> Option<Interval> {
    let outer = transform.outer_radius().filter(|outer| outer.overlaps(cell))?;
    let start = Interval::point(cell.lower().clone());
    let rises = transform.rises_beyond(&start) || {
        let margin = ((outer.clone() - &start) / &outer).upper().clone();
        let known = transform.kink(transform.kinks().len(), &Interval::point(margin)).ok()??;
        *known.inside.least?.lower() >= 0
    };
    rises.then(|| transform.g(&start).ok())?
}

/// A lower bound of g on a cell that holds one kink, from g there and the slopes on both sides.
fn least_beside(
    transform: &dyn Transform<Interval>,
    index: usize,
    kink: &Interval,
    cell: &Interval,
) -> Option<Interval> {
    let [before, after] = [cell.lower(), cell.upper()].map(|end| (Interval::point(end.clone()) - kink).abs());
    let margin = (before.greater(&after) / kink).upper().clone();
    let known = transform.kink(index, &Interval::point(margin)).ok()??;
    let (g, _) = known.value?;
    let zero = g.lit(0);
    let inside = g.clone() - known.inside.greatest?.greater(&zero) * before;
    let outside = g + known.outside.least?.lesser(&zero) * after;
    Some(inside.lesser(&outside))
}

#[cfg(test)]
#[path = "../../tests/private/overlap.rs"]
mod tests;
