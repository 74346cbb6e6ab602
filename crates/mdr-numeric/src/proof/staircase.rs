//! The gap outside a contact from bounds of g on cells: a proof where f has so many pieces that integrals over f cost too much.
//!
//! The gap (2/π) ∫ₐʳ (g − d)/√(r² − x²) dx grows with g, so the least g on each cell gives a bound from below, and the greatest one
//! from above. The weight of a cell from x₁ to x₂ is
//!
//! ∫ dx/√(r² − x²) = 2 (x₂ − x₁)/\[(√(r − x₁) + √(r − x₂)) √(r + ξ)\], x₁ ≤ ξ ≤ x₂,
//!
//! and falls as r grows. Sums are done in doubles: of operations that round correctly, on differences of numbers that are exact, so
//! that a bound of their rounding error is known.

use std::sync::{Arc, OnceLock};

use mdr_core::contact::Transform;
use mdr_core::number::{DoubleInterval, Ends, Interval, Precision, Real};
use rug::float::Round;

use super::kinks::beside;
use super::overlap::Place;

/// Cells of each staircase, of which the finer ones are made when a state needs them.
const LEVELS: [usize; 3] = [1 << 9, 1 << 11, 1 << 13];
/// Octaves below the first kink that have cells,
const OCTAVES: i32 = 40;
/// and how many.
const PARTS_OF_OCTAVE: usize = 8;
/// Times that radii of one cell are halved.
const HALVINGS: u32 = 10;
/// The most terms of all sums for a state, by each staircase: about a fifth of a second.
const TERMS: u64 = 1 << 24;
/// Terms that cost as much as a height of a table.
pub(super) const TERMS_OF_HEIGHT: u64 = 1 << 14;
/// Roundings of one term, in units of 2⁻⁵².
const ROUNDINGS: f64 = 16.0;
/// Sums below this may have lost something to underflow.
const LEAST_SUM: f64 = 1e-280;
/// The precision in which g is bounded.
const BITS: u32 = 64;
/// What is known of g where nothing is.
const UNBOUNDED: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// g between two step functions.
pub(super) struct Staircases {
    transform: Bounded,
    /// Radii that hold the end of the profile, and bounds of g there.
    end: Option<[[f64; 2]; 2]>,
    levels: [OnceLock<Vec<Cell>>; LEVELS.len()],
}

/// A transform in an arithmetic that bounds g on cells.
pub(super) enum Bounded {
    InDoubles(Arc<dyn Transform<DoubleInterval>>),
    InBits(Arc<dyn Transform<Interval>>),
}

impl Bounded {
    fn g(&self, cell: &Cell) -> [f64; 2] {
        match self {
            Bounded::InDoubles(transform) => cell.bounded_by(&**transform, ()),
            Bounded::InBits(transform) => cell.bounded_by(&**transform, Precision::new(BITS)),
        }
    }

    fn kinks(&self) -> Vec<[f64; 2]> {
        match self {
            Bounded::InDoubles(transform) => transform.kinks().iter().map(ends_of).collect(),
            Bounded::InBits(transform) => transform.kinks().iter().map(ends_of).collect(),
        }
    }

    /// The last number that is certainly within the profile, and one that is not below its end.
    fn end(&self) -> Option<[f64; 2]> {
        let [least, most] = match self {
            Bounded::InDoubles(transform) => ends_of(&transform.outer_radius()?),
            Bounded::InBits(transform) => ends_of(&transform.outer_radius()?),
        };
        Some([least.next_down(), most])
    }
}

/// The ends of a set of numbers in doubles, rounded outward.
fn ends_of<I: Ends>(set: &I) -> [f64; 2] {
    [-(-set.clone()).most().to_f64_round(Round::Up), set.most().to_f64_round(Round::Up)]
}

/// Radii on which g is bounded.
struct Cell {
    from: f64,
    to: f64,
    /// The kink with this index is within, just above the lower end.
    kink: Option<(usize, [f64; 2])>,
    /// The least and the greatest g, once they are asked for.
    bounds: OnceLock<[f64; 2]>,
}

impl Cell {
    fn new([from, to]: [f64; 2], kink: Option<(usize, [f64; 2])>) -> Self {
        Cell { from, to, kink, bounds: OnceLock::new() }
    }

    /// Bounds of g.
    fn g(&self, transform: &Bounded) -> [f64; 2] {
        *self.bounds.get_or_init(|| transform.g(self))
    }

    /// Bounds of g: from its value in the middle, or at the kink, and its slopes.
    fn bounded_by<I: Ends>(&self, transform: &dyn Transform<I>, ctx: I::Ctx) -> [f64; 2] {
        let hull = |[from, to]: [f64; 2]| I::from_f64(ctx, from).hull(&I::from_f64(ctx, to));
        let cell = hull([self.from, self.to]);
        let [least, most] = match self.kink {
            Some((index, kink)) => beside(transform, index, &hull(kink), &cell).unwrap_or_default(),
            None => {
                let middle = cell.midpoint();
                let slope = transform.slope(&cell);
                let bounds = transform.g(&middle).and_then(|g| Ok(g + slope? * (cell - middle))).ok();
                [bounds.clone(), bounds]
            }
        };
        let known = |bound: &I| bound.is_finite();
        let least = least.filter(known).map_or(f64::NEG_INFINITY, |g| ends_of(&g)[0]);
        [least, most.filter(known).map_or(f64::INFINITY, |g| ends_of(&g)[1])]
    }
}

/// A contact: bounds of its radius and its indentation.
#[derive(Clone, Copy)]
pub(super) struct State {
    a: [f64; 2],
    d: [f64; 2],
}

impl State {
    pub(super) fn of(place: &Place) -> Self {
        let [a, d] =
            [&place.a, &place.d].map(|x| [x.lower().to_f64_round(Round::Down), x.upper().to_f64_round(Round::Up)]);
        State { a, d }
    }
}

impl Staircases {
    /// Cells on which the transform bounds g. The radii next to the end of the profile are not all certainly within it, so that the
    /// transform is not asked there, but `range`.
    pub(super) fn new(transform: Bounded, range: impl Fn(&Interval) -> Option<Interval>) -> Self {
        let number = |x| Interval::from_f64(Precision::new(BITS), x);
        let bounds = |[from, to]: [f64; 2]| range(&number(from).hull(&number(to))).map_or(UNBOUNDED, |g| ends_of(&g));
        let end = transform.end().map(|radii| [radii, bounds(radii)]);
        Staircases { transform, end, levels: Default::default() }
    }

    /// Whether no gap outside a contact is negative, if that is certain; and the terms that were summed. Each staircase is asked for the
    /// radii that those before it leave open.
    pub(super) fn are_open(&self, state: State) -> (bool, u64) {
        let (mut left, mut terms) = (vec![[state.a[0], f64::INFINITY]], 0);
        for level in 0..LEVELS.len() {
            let mut stair = self.stair(level, state);
            left = stair.not_open(left);
            terms += stair.terms;
            if left.is_empty() {
                break;
            }
        }
        (left.is_empty(), terms)
    }

    /// The gap at a radius, from above, if it is certainly negative.
    pub(super) fn overlap(&self, state: State, r: f64) -> Option<f64> {
        let most = |level| self.stair(level, state).most(r);
        (0..LEVELS.len()).find_map(|level| most(level).filter(|gap| *gap < 0.0))
    }

    fn stair(&self, level: usize, state: State) -> Stair<'_> {
        let cells = self.levels[level].get_or_init(|| self.cells(LEVELS[level]));
        Stair { transform: &self.transform, cells, state, terms: 0 }
    }

    /// About so many cells between the first kink and the end of the profile, one that holds the end, and some below. None holds a kink
    /// but just above its lower end: there slopes are bounded by what is known of the kink.
    fn cells(&self, count: usize) -> Vec<Cell> {
        let kinks = self.transform.kinks();
        let (Some([first, _]), Some([[end, beyond], bounds])) = (kinks.first(), self.end) else { return Vec::new() };
        let parts = (count / kinks.len()).max(2);
        let mut cells = Vec::new();
        let mut from = first * 2f64.powi(-OCTAVES);
        for (index, kink) in kinks.iter().enumerate() {
            let before = kink[0].next_down();
            let next = kinks.get(index + 1).map_or(end, |[next, _]| *next);
            let after = before + ((next - before) / parts as f64).min(before / 8.0);
            if !(before > from && after > kink[1]) {
                return Vec::new();
            }
            divided([from, before], if index == 0 { PARTS_OF_OCTAVE } else { parts }, &mut cells);
            cells.push(Cell::new([before, after], Some((index, *kink))));
            from = after;
        }
        divided([from, end], parts, &mut cells);
        cells.push(Cell { bounds: bounds.into(), ..Cell::new([end, beyond], None) });
        cells
    }
}

/// A state among the cells.
struct Stair<'a> {
    transform: &'a Bounded,
    cells: &'a [Cell],
    state: State,
    terms: u64,
}

impl Stair<'_> {
    /// The first cell that reaches beyond the smallest contact radius.
    fn first(&self) -> Option<usize> {
        let first = self.cells.partition_point(|cell| cell.to <= self.state.a[0]);
        self.cells.get(first).is_some_and(|cell| cell.from <= self.state.a[0]).then_some(first)
    }

    /// The radii, of those that are asked for, at which it is not certain that the gap is open.
    fn not_open(&mut self, radii: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let Some(first) = self.first() else { return radii };
        let mut left: Vec<[f64; 2]> = Vec::new();
        for [from, to] in radii {
            let start = self.cells.partition_point(|cell| cell.to <= from);
            let end = self.cells.partition_point(|cell| cell.from < to);
            for last in start..end {
                let cell = &self.cells[last];
                let [least, _] = cell.g(self.transform);
                let radii = [cell.from.max(from), cell.to.min(to)];
                if !(least >= self.state.d[1] || self.is_open_within(radii, [first, last], HALVINGS)) {
                    left.push(radii);
                }
            }
        }
        left
    }

    /// Whether no gap at these radii, which are in the last of some cells, is negative.
    fn is_open_within(&mut self, radii: [f64; 2], cells: [usize; 2], halvings: u32) -> bool {
        self.terms += (cells[1] - cells[0]) as u64 + 1;
        let d = self.state.d[1];
        if self.least(radii, cells, |[least, _]| least - d) >= 0.0 {
            return true;
        }
        let middle = radii[0] + (radii[1] - radii[0]) / 2.0;
        halvings > 0
            && self.terms < TERMS
            && middle > radii[0]
            && middle < radii[1]
            && self.is_open_within([radii[0], middle], cells, halvings - 1)
            && self.is_open_within([middle, radii[1]], cells, halvings - 1)
    }

    /// The gap at a radius from above.
    fn most(&self, r: f64) -> Option<f64> {
        let first = self.first()?;
        let last = self.cells.partition_point(|cell| cell.to < r);
        if last < first || last >= self.cells.len() {
            return None;
        }
        let d = self.state.d[0];
        let below = self.least([r, r], [first, last], |[_, most]| d - most);
        below.is_finite().then_some(-below)
    }

    /// (2/π) ∫ t dx/√(r² − x²) from a to r, from below, for all r from `near` to `far` in the last of some cells. Its lower bound t on a
    /// cell is found from the bounds of g; the factor 2/π is not, so that the sign is certain and the last digit is not.
    fn least(&self, [near, far]: [f64; 2], [first, last]: [usize; 2], t: impl Fn([f64; 2]) -> f64) -> f64 {
        let [inner, outer] = self.state.a;
        let (mut sum, mut size) = (0.0, 0.0);
        for (index, cell) in (first..).zip(&self.cells[first..=last]) {
            let t = t(cell.g(self.transform));
            let from = cell.from.max(if t > 0.0 { outer } else { inner });
            // Before the last cell the weight is least for the farthest r; in the last cell, which ends at r, for the nearest.
            let weight = match (t > 0.0, index < last) {
                (true, true) if from < cell.to => weight([from, cell.to], far, far + cell.to),
                (true, false) if from < near => weight([from, near], near, near + near),
                (true, _) => continue,
                (false, true) => weight([from, cell.to], near, near + from),
                (false, false) => 2.0 * (far - from).sqrt() / (near + from).sqrt(),
            };
            sum += t * weight;
            size += (t * weight).abs();
        }
        let slack = (ROUNDINGS + (last - first) as f64) * f64::EPSILON * size;
        if size < LEAST_SUM && size > 0.0 { f64::NEG_INFINITY } else { (sum - slack) * std::f64::consts::FRAC_2_PI }
    }
}

/// The weight of a cell for one r, with r + ξ.
fn weight([from, to]: [f64; 2], r: f64, across: f64) -> f64 {
    2.0 * (to - from) / (((r - from).sqrt() + (r - to).sqrt()) * across.sqrt())
}

/// Adds cells between two radii without a kink: so many in each octave.
fn divided([from, to]: [f64; 2], parts: usize, cells: &mut Vec<Cell>) {
    let mut lower = from;
    while lower < to {
        let octave = if 2.0 * lower >= to { to } else { 2.0 * lower };
        let step = (octave - lower) / parts as f64;
        for part in 1..=parts {
            let end = if part == parts { octave } else { (lower + step).min(octave) };
            if end > lower {
                cells.push(Cell::new([lower, end], None));
            }
            lower = end;
        }
    }
}

#[cfg(test)]
#[path = "../../tests/private/staircase.rs"]
pub(super) mod tests;
