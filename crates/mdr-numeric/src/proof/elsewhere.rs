//! Whether the gap is open on ranges of radii outside a contact, by cells.

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::contact::{Result, Transform};
use mdr_core::number::{Interval, Real};
use rug::Float;

use super::ends::{FAR, octave};
use super::kinks::beside;
use super::overlap::{Outside, Place};

/// The most cells outside a contact or a ring,
const CELLS: usize = 4000;
/// none of which is wider than this ratio when g is looked at,
const WIDEST: f64 = 1.03;
/// or narrower than this when nothing is decided.
const FINEST: f64 = 1.0 + 1e-9;
/// The share of the heights after which another way is tried to decide a gap: beside something narrow that is soon found,
const BEFORE_ANOTHER: u64 = 8;
/// by the minima of d, or by rings of 1 + 2^−k and of 2^k contact radii, k up to so many,
const RINGS: i64 = 30;
/// which may take this share.
const OF_RINGS: u64 = 2;
/// The octaves beyond a contact in which an overlap is looked for where the gap is not known to be open far away.
const NEAR: u32 = 4;
/// The most heights of f, counted over intervals, that one look at a contact may take, with those of g: about a second.
pub(super) const HEIGHTS: u64 = 200_000;
/// A look may take so many parts of what all may take: with a short look and the rings before it, they are 13/8 of one.
pub(super) const ONE_LOOK: [u64; 2] = [5, 8];

/// What is certain of the gap on some radii.
pub(super) enum Seen {
    /// It is nowhere negative.
    Open,
    /// It is negative at this radius.
    Closed { radius: f64, gap: f64 },
    /// Nothing is certain on this cell.
    Undecided(Interval),
}

impl Outside<'_> {
    /// Checks that the gap is open outside the neighbourhood of the ring, wherever g is below the indentation.
    pub(super) fn check_elsewhere(&self, place: &Place, around: &Interval) -> Result<()> {
        let far = self.far(place, around)?;
        let cells = vec![(around.upper().clone(), far), (place.a.upper().clone(), around.lower().clone())];
        match self.look(place, cells, self.heights) {
            Seen::Open => Ok(()),
            Seen::Closed { radius, .. } => Err(self.open(&Interval::from_f64(place.a.ctx(), radius))),
            Seen::Undecided(cell) => Err(self.open(&cell)),
        }
    }

    /// What is certain of the gap everywhere outside the contact, up to the end of the profile.
    ///
    /// # Errors
    /// [`Error::Unproved`](mdr_core::contact::Error::Unproved) where nothing is known of a radius beyond which it is open.
    pub(super) fn look_everywhere(&self, place: &Place) -> Result<Seen> {
        let far = match self.contact.transform().outer_radius() {
            Some(outer) => Ok(outer.rounded(place.a.ctx()).upper().clone()),
            None => self.far(place, &place.a),
        };
        // Surfaces that are not known to be open far away may overlap near the contact.
        let near = || Float::with_val(BOUND_BITS, place.a.upper() << NEAR);
        let to = far.as_ref().map_or_else(|_| near(), Float::clone);
        let cells = vec![(place.a.lower().clone(), to)];
        let mut seen = self.look(place, cells.clone(), self.heights / BEFORE_ANOTHER);
        if let Seen::Undecided(_) = seen {
            let is_above = self.floor.is_some_and(|floor| far.as_ref().is_ok_and(|far| floor.is_above(place, far)));
            let another = if is_above { Some(Seen::Open) } else { self.closed_ring(place) };
            seen = another.unwrap_or_else(|| self.look(place, cells, self.heights));
        }
        if let Seen::Open = seen {
            // Near the contact only, where nothing is known of radii far away.
            return far.map(|_| seen).or_else(|error| self.closed_ring(place).ok_or(error));
        }
        Ok(seen)
    }

    /// What is certain of the gap on some cells, wherever g is below the indentation; the first that is not open ends it.
    fn look(&self, place: &Place, mut cells: Vec<(Float, Float)>, heights: u64) -> Seen {
        let work = || self.profile.work() + self.contact.transform().work();
        let last = work() + heights;
        for _ in 0..CELLS {
            let Some((from, to)) = cells.pop() else { return Seen::Open };
            if work() > last {
                break;
            }
            let cell = Interval::new(from.clone(), to.clone());
            let ratio = Float::with_val(BOUND_BITS, &to / &from);
            if ratio <= WIDEST {
                if self.is_above(&cell, &place.d) {
                    continue;
                }
                match self.seen(place, &cell) {
                    Seen::Open => continue,
                    Seen::Undecided(_) if ratio > FINEST => {}
                    other => return other,
                }
            }
            let middle = Float::with_val(BOUND_BITS, (from.clone() * &to).sqrt_ref());
            cells.extend([(middle.clone(), to), (from, middle)]);
        }
        Seen::Undecided(place.a.clone())
    }

    /// A ring on which the gap is closed, near the contact or far from it.
    fn closed_ring(&self, place: &Place) -> Option<Seen> {
        let octave = |k: i64| place.a.lit(2).powi(k) * &place.a;
        let near = (1..=RINGS).map(|k| octave(-k) + &place.a);
        let last = self.profile.work() + self.heights / OF_RINGS;
        let mut affordable = near.chain((1..=RINGS).map(octave)).take_while(|_| self.profile.work() <= last);
        affordable.find_map(|r| {
            let radius = r.midpoint();
            let [gap, ..] = self.gap(place, &radius).ok()?;
            (*gap.upper() < 0).then(|| Seen::Closed { radius: radius.approx(), gap: gap.approx() })
        })
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
        beside(transform, index, kink, cell)
            .is_some_and(|[least, _]| least.is_some_and(|least| least.lower() >= d.upper()))
    }

    /// What is certain of the gap on a cell outside the contact.
    fn seen(&self, place: &Place, cell: &Interval) -> Seen {
        let undecided = || Seen::Undecided(cell.clone());
        let Ok([over, slope, _]) = self.gap(place, cell) else { return undecided() };
        if *over.lower() > 0 {
            return Seen::Open;
        }
        let radius = cell.midpoint();
        let Ok([gap, ..]) = self.gap(place, &radius) else { return undecided() };
        if *gap.upper() < 0 {
            return Seen::Closed { radius: radius.approx(), gap: gap.approx() };
        }
        if *(gap + slope * (cell.clone() - radius)).lower() > 0 { Seen::Open } else { undecided() }
    }

    /// A radius beyond which the gap is open: f is above the indentation by more than the surface may rise there,
    /// |u(r)| = (2/π) |∫₀ᵃ (d − g)/√(r² − x²) dx| ≤ (a/r) max |d − g|. By parts with ∫₀ˣ g dx = x m, where m is an average of f, it is
    /// also |u(r)| ≤ (a/r) (|d| + (3/2) max |f|) from r = 2a on, as (2/π)(2a/√(r² − a²)) ≤ (3/2)(a/r) there.
    fn far(&self, place: &Place, around: &Interval) -> Result<Float> {
        let Place { a, d } = place;
        let by_transform = self.profile.range(&a.lit(0).hull(a)).map(|inside| (d.clone() - inside).abs());
        let by_heights = self.heights_within(a).map(|inside| inside.abs().times(3).over(2) + d.abs());
        let bounds = by_transform.into_iter().chain(by_heights).map(|bound| Interval::point(bound.upper().clone()));
        let most = bounds.reduce(|one, other| one.lesser(&other)).ok_or_else(|| self.open(a))?;
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

    /// f on all radii of the contact.
    fn heights_within(&self, a: &Interval) -> Option<Interval> {
        let last = self.profile.breaks().partition_point(|b| b.lower() <= a.upper());
        let mut parts = (0..=last).map(|beyond| self.profile.height(&a.lit(0).hull(a), beyond));
        let first = parts.next()??;
        parts.try_fold(first, |hull, part| Some(hull.hull(&part?))).filter(Real::is_finite)
    }

    /// Whether f − d is above `reach`/r from a radius beyond all kinks out to the largest radii.
    fn is_open_from(&self, from: &Float, reach: &Interval, d: &Interval) -> bool {
        let first = octave(from);
        let end = |octave: f64| if octave > first { Float::with_val(BOUND_BITS, octave).exp2() } else { from.clone() };
        let is_open = |lower: f64, upper: f64| {
            let r = Interval::new(end(lower), end(upper));
            let height = self.profile.height_far_out(&r);
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
