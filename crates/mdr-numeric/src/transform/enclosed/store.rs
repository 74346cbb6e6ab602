//! Heights of a formula on cells of radii, kept for integrals with many kernels.
//!
//! Cells are [k 2^e, (k + 1) 2^e]. Of each one the heights at the nodes of a rule are kept, and an enclosure of f on an ellipse around it:
//! integrals ∫ h(r) K(r, x) dr up to a radius c, with h = f − α − βr², then need only K anew for each x. Cells are halved until they are as
//! far from x as they are long, and until the remainder of their rule is small.

use std::collections::HashMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::calculus::panel::{LegendreNode, LegendrePanel};
use mdr_core::contact::FormulaPart;
use mdr_core::number::{Analytic, DoubleInterval, Interval, Precision, Real, Rectangle};
use rug::Float;
use rug::float::Round;

use super::Order;
use super::span::relative_width;

/// Cells that are kept, at most.
const KEPT: usize = 4096;
/// Cells that an integral may look at.
const MOST: usize = 600;
/// Octaves below the radius in which cells lie.
const DEEPEST: i32 = 62;
/// Where the remainder of the rule for f alone is at most so many times that of a half, 4 for a line and e^(2(L/s)²/3) times as much for a dip
/// of width s, nothing on a cell of length L is narrow.
const SMOOTH: f64 = 64.0;
/// The remainder of a cell is below this share of the relative width of x,
const BELOW_WIDTH: f64 = 1.0 / 64.0;
/// and need not be below this share of the sum.
const LEAST: f64 = 1e-15;

/// The cells of one formula, before its first break.
pub(super) struct Store {
    part: FormulaPart,
    heights: Arc<AtomicU64>,
    cells: Mutex<HashMap<Place, Arc<Cell>>>,
}

/// A place of cells.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Place {
    exponent: i32,
    index: u64,
}

struct Cell {
    panel: LegendrePanel,
    /// Each node with its height; an empty list where f is not known at all nodes.
    nodes: Vec<(LegendreNode, Interval)>,
    /// f on the ellipse, where it is shown to be analytic, and its heights are known.
    image: Option<Rectangle<DoubleInterval>>,
    /// Whether nothing on it is narrow.
    is_smooth: bool,
}

/// What is narrow below an interval of radii.
pub(super) enum Below {
    /// Nothing, from the axis on.
    Nothing,
    /// Nothing from this radius on.
    Cut(Float),
    /// Something that is closer to the interval than this is wide.
    Narrow,
}

/// The parabola α + βr² that is taken from f.
pub(super) struct Parabola {
    pub(super) height: Interval,
    pub(super) bend: Interval,
}

impl Place {
    /// The cell of this length around x.
    fn of(x: &Float, exponent: i32) -> Option<Self> {
        let index = Float::with_val(x.prec(), x >> exponent).to_integer_round(Round::Down)?.0.to_u64()?;
        Some(Place { exponent, index })
    }

    fn ends(self) -> [Float; 2] {
        [self.index, self.index + 1].map(|index| Float::with_val(BOUND_BITS, index) << self.exponent)
    }

    fn halves(self) -> [Place; 2] {
        let half = |index| Place { exponent: self.exponent - 1, index };
        [half(2 * self.index), half(2 * self.index + 1)]
    }
}

impl Store {
    pub(super) fn new(part: FormulaPart, heights: Arc<AtomicU64>) -> Self {
        Store { part, heights, cells: Mutex::default() }
    }

    fn cell(&self, place: Place) -> Option<Arc<Cell>> {
        let cells = || self.cells.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(cell) = cells().get(&place) {
            return Some(cell.clone());
        }
        let cell = Arc::new(self.new_cell(place)?);
        let mut cells = cells();
        if cells.len() == KEPT {
            cells.clear();
        }
        cells.insert(place, cell.clone());
        Some(cell)
    }

    fn new_cell(&self, place: Place) -> Option<Cell> {
        let [lower, upper] = place.ends();
        let panel = LegendrePanel::new(&lower, &upper)?;
        let with_height = |node: LegendreNode| {
            let height = self.height(&node.place)?;
            height.is_bounded().then_some((node, height))
        };
        let nodes: Vec<_> = panel.nodes().ok()?.into_iter().map(with_height).collect::<Option<_>>().unwrap_or_default();
        // Without heights an image is of no use.
        let image = self.height(&panel.ellipse()).filter(|image| !nodes.is_empty() && image.is_bounded());
        let is_smooth = image.as_ref().is_some_and(|image| self.is_as_smooth(place, panel.remainder(image)));
        Some(Cell { panel, nodes, image, is_smooth })
    }

    /// Whether f varies little more on the ellipse of a cell than on those of its halves, by the remainder of the rule for f alone.
    fn is_as_smooth(&self, place: Place, whole: Option<DoubleInterval>) -> bool {
        let of_half = |half: Place| {
            let [lower, upper] = half.ends();
            let panel = LegendrePanel::new(&lower, &upper)?;
            panel.remainder(&self.height(&panel.ellipse())?).map(|remainder| remainder.upper())
        };
        let halves = place.halves().map(of_half).into_iter().flatten().fold(0.0, f64::max);
        whole.is_some_and(|whole| whole.upper() <= SMOOTH * halves)
    }

    /// f over a set of radii.
    fn height<T: Analytic>(&self, r: &T) -> Option<T> {
        self.heights.fetch_add(T::WORK, Ordering::Relaxed);
        self.part.derivatives_at(r, 0).map(|f| f.value().clone())
    }

    fn is_smooth(&self, place: Place) -> bool {
        self.cell(place).is_some_and(|cell| cell.is_smooth)
    }

    /// Where x is cut.
    pub(super) fn below(&self, x: &Interval) -> Below {
        self.found_below(x).unwrap_or(Below::Narrow)
    }

    /// In cells of one length, from a quarter of x to its width: from the cell before that of its lower end on.
    fn found_below(&self, x: &Interval) -> Option<Below> {
        let width = Float::with_val(BOUND_BITS, x.upper() - x.lower());
        let exponent = x.lower().get_exp()?;
        for below in 2..DEEPEST {
            let exponent = exponent - below;
            if Float::with_val(BOUND_BITS, Float::i_exp(1, exponent)) < width {
                break;
            }
            let [first, last] = [x.lower(), x.upper()].map(|end| Place::of(end, exponent));
            let (first, last) = (first?.index - 1, last?.index);
            let is_smooth = |index| self.is_smooth(Place { exponent, index });
            if (first..=last).all(is_smooth) {
                let is_smooth_from_axis = below == 2 && (0..first).all(is_smooth);
                let [c, _] = Place { exponent, index: first }.ends();
                return Some(if is_smooth_from_axis { Below::Nothing } else { Below::Cut(c) });
            }
        }
        None
    }

    /// The integrals over the radii up to c of f − α − βr², and those of the parabola.
    pub(super) fn integrals(
        &self,
        x: &Interval,
        order: Order,
        c: &Float,
        parabola: &Parabola,
    ) -> Option<Vec<DoubleInterval>> {
        let all = Place { exponent: x.lower().get_exp()?, index: 0 };
        let in_doubles = DoubleInterval::around(x);
        let mut inside = Inside {
            store: self,
            nearest: x.lower(),
            c,
            deepest: all.exponent - DEEPEST,
            kernel: Kernel { x, order },
            parabola,
            in_doubles,
            aim: LEAST.max(BELOW_WIDTH * relative_width(x).to_f64()),
            sums: parabola.integrals(&in_doubles, order),
            looked_at: 0,
        };
        inside.add(all)?;
        Some(inside.sums)
    }
}

/// What is integrated beside h, with s = x² − r²: r/(x√s) in the mean of g, −x r s^(−3/2) in g, x r (2s + 3r²) s^(−5/2) in x g', and
/// −x³ r (6s + 15r²) s^(−7/2) in x²g''.
struct Kernel<'a> {
    x: &'a Interval,
    order: Order,
}

impl Kernel<'_> {
    fn times<T: Analytic>(&self, height: &T, r: &T) -> Option<Vec<T>> {
        self.at(height, r, &r.constant(self.x))
    }

    fn at<T: Analytic>(&self, height: &T, r: &T, x: &T) -> Option<Vec<T>> {
        let s = x.minus(r).product(&x.plus(r));
        let root = s.sqrt()?;
        if self.order == Order::Value {
            let mean = height.product(r).quotient(&x.product(&root))?;
            let g = mean.product(&x.squared()).quotient(&s)?.negated();
            let above = g.minus(&mean);
            return Some(vec![mean, g, above]);
        }
        let square = r.squared();
        let share = height.product(r).product(x).quotient(&s.squared().product(&root))?;
        let with = |of_s: i64, of_square: i64| s.multiplied(of_s).plus(&square.multiplied(of_square));
        let mut values = vec![share.product(&with(2, 3))];
        if self.order == Order::Curvature {
            values.push(share.product(&x.squared()).quotient(&s)?.product(&with(-6, -15)));
        }
        Some(values)
    }
}

/// An integral up to c that is being added up.
struct Inside<'a> {
    store: &'a Store,
    nearest: &'a Float,
    c: &'a Float,
    deepest: i32,
    kernel: Kernel<'a>,
    parabola: &'a Parabola,
    /// x in doubles.
    in_doubles: DoubleInterval,
    /// The remainder that a cell may have, as a share of the sum.
    aim: f64,
    sums: Vec<DoubleInterval>,
    looked_at: usize,
}

impl Inside<'_> {
    /// Adds the cell at a place, or what of it lies below c.
    fn add(&mut self, place: Place) -> Option<()> {
        let [lower, upper] = place.ends();
        if lower >= *self.c {
            return Some(());
        }
        self.looked_at += 1;
        if self.looked_at > MOST || place.exponent < self.deepest {
            return None;
        }
        let apart = Float::with_val(BOUND_BITS, self.nearest - &upper);
        if upper <= *self.c && apart >= Float::with_val(BOUND_BITS, &upper - &lower) {
            let cell = self.store.cell(place)?;
            if let Some(shares) = self.by_rule(&cell).or_else(|| self.by_range(&cell)) {
                self.sums.iter_mut().zip(shares).for_each(|(sum, share)| *sum += &share);
                return Some(());
            }
        }
        // What is largest comes first.
        place.halves().into_iter().rev().try_for_each(|half| self.add(half))
    }

    /// By the rule of the cell, where its remainder is small.
    fn by_rule(&self, cell: &Cell) -> Option<Vec<DoubleInterval>> {
        let image = cell.image.as_ref()?;
        self.store.heights.fetch_add(cell.nodes.len() as u64, Ordering::Relaxed);
        let mut shares = vec![DoubleInterval::point(0.0); self.sums.len()];
        for (node, height) in &cell.nodes {
            let above = height.minus(&self.parabola.at(&node.place));
            let values = self.kernel.at(&DoubleInterval::around(&above), &node.t, &self.in_doubles)?;
            shares.iter_mut().zip(values).for_each(|(share, value)| *share += &(value * node.weight));
        }
        let r = cell.panel.ellipse();
        let images = self.kernel.times(&image.minus(&self.parabola.at(&r)), &r)?;
        let with_remainder = |((share, image), sum): ((DoubleInterval, Rectangle<DoubleInterval>), &DoubleInterval)| {
            let remainder = cell.panel.remainder(&image)?;
            let is_small = remainder.upper() <= self.allowed(sum).max(self.allowed(&share)).max(radius(&share));
            is_small.then(|| share.inflate(&remainder))
        };
        shares.into_iter().zip(images).zip(&self.sums).map(with_remainder).collect()
    }

    /// By ranges on all of a cell on which f is not shown to be analytic, where that is enough.
    fn by_range(&self, cell: &Cell) -> Option<Vec<DoubleInterval>> {
        if cell.image.is_some() {
            return None;
        }
        let r = cell.panel.range();
        let length = DoubleInterval::point(r.upper()) - DoubleInterval::point(r.lower());
        let height = self.store.height(&r)?.minus(&self.parabola.at(&r));
        let ranges = self.kernel.at(&height, &r, &self.in_doubles)?;
        let narrow = |(range, sum): (DoubleInterval, &DoubleInterval)| {
            let area = range * length;
            (radius(&area) <= self.allowed(sum)).then_some(area)
        };
        ranges.into_iter().zip(&self.sums).map(narrow).collect()
    }

    fn allowed(&self, sum: &DoubleInterval) -> f64 {
        (self.aim * sum.abs().upper()).max(radius(sum) / MOST as f64)
    }
}

impl Parabola {
    /// α + 2βx²/3, α + 2βx² and their difference; or 4βx² once or twice.
    fn integrals(&self, x: &DoubleInterval, order: Order) -> Vec<DoubleInterval> {
        let [height, bend] = [&self.height, &self.bend].map(DoubleInterval::around);
        let square = bend * x.square();
        match order {
            Order::Value => vec![height + square.times(2).over(3), height + square.times(2), square.times(4).over(3)],
            order => vec![square.times(4); order.count()],
        }
    }

    fn at<T: Analytic>(&self, r: &T) -> T {
        r.squared().scaled(&self.bend).plus(&r.constant(&self.height))
    }
}

/// Half of the length, or the infinity.
fn radius(interval: &DoubleInterval) -> f64 {
    (interval.upper() - interval.lower()) / 2.0
}

/// A sum of doubles in the context of x.
pub(super) fn widened(sum: &DoubleInterval, x: &Interval) -> Interval {
    sum.widened(Precision::new(BOUND_BITS)).rounded(x.ctx())
}

#[cfg(test)]
#[path = "../../../tests/private/store.rs"]
mod tests;
