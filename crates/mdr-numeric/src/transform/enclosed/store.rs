//! Heights of a formula on cells of radii, kept for integrals with many kernels.
//!
//! Cells are [k 2^e, (k + 1) 2^e]. Of each one the heights at the nodes of a rule are kept, for each number of bits, and an enclosure of f on an
//! ellipse around it: [integrals](super::inside) ∫ h(r) K(r, x) dr up to a radius c then need only K anew for each x.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::calculus::panel::{LegendreNode, LegendrePanel};
use mdr_core::contact::FormulaPart;
use mdr_core::number::{Analytic, DoubleInterval, Interval, Rectangle};
use rug::Float;
use rug::float::Round;

/// Cells that are kept, at most.
const KEPT: usize = 4096;
/// Octaves below the radius in which cells lie.
pub(super) const DEEPEST: i32 = 62;
/// Where the remainder of the rule for f alone is at most so many times that of a half, 4 for a line and e^(2(L/s)²/3) times as much for a dip
/// of width s, nothing on a cell of length L is narrow.
const SMOOTH: f64 = 64.0;

/// The cells of one formula, before its first break.
pub(super) struct Store {
    part: FormulaPart,
    heights: Arc<AtomicU64>,
    cells: Mutex<HashMap<Place, Arc<Cell>>>,
    /// The heights at the nodes of rules for so many bits.
    rules: Mutex<HashMap<(Place, u32), Arc<Rule>>>,
}

/// A place of cells.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Place {
    pub(super) exponent: i32,
    pub(super) index: u64,
}

pub(super) struct Cell {
    /// f on the ellipse, where it is shown to be analytic.
    pub(super) image: Option<Rectangle<DoubleInterval>>,
    /// Whether nothing on it is narrow.
    is_smooth: bool,
}

/// Each node of the rule of a cell with its height.
pub(super) type Rule = Vec<(LegendreNode, Interval)>;

/// What is narrow below an interval of radii.
pub(super) enum Below {
    /// Nothing, from the axis on.
    Nothing,
    /// Nothing from this radius on, `at` an end of cells that are so many octaves shorter than the interval is far from the axis.
    Cut { at: Float, depth: i32 },
    /// Something that is closer to the interval than this is wide.
    Narrow,
}

impl Place {
    /// The cell of this length around x.
    fn of(x: &Float, exponent: i32) -> Option<Self> {
        let index = Float::with_val(x.prec(), x >> exponent).to_integer_round(Round::Down)?.0.to_u64()?;
        Some(Place { exponent, index })
    }

    pub(super) fn ends(self) -> [Float; 2] {
        [self.index, self.index + 1].map(|index| Float::with_val(BOUND_BITS, index) << self.exponent)
    }

    pub(super) fn halves(self) -> [Place; 2] {
        let half = |index| Place { exponent: self.exponent - 1, index };
        [half(2 * self.index), half(2 * self.index + 1)]
    }
}

impl Store {
    pub(super) fn new(part: FormulaPart, heights: Arc<AtomicU64>) -> Self {
        Store { part, heights, cells: Mutex::default(), rules: Mutex::default() }
    }

    pub(super) fn cell(&self, place: Place) -> Option<Arc<Cell>> {
        kept(&self.cells, place, || {
            let panel = panel(place, BOUND_BITS)?;
            let image = self.height(&panel.ellipse()).filter(Analytic::is_bounded);
            let is_smooth = image.as_ref().is_some_and(|image| self.is_as_smooth(place, panel.remainder(image)));
            Some(Cell { image, is_smooth })
        })
    }

    /// `None` where f is not known at all nodes.
    pub(super) fn rule(&self, place: Place, panel: &LegendrePanel, bits: u32) -> Option<Arc<Rule>> {
        kept(&self.rules, (place, bits), || {
            let with_height = |node: LegendreNode| {
                let height = self.height(&node.place)?;
                height.is_bounded().then_some((node, height))
            };
            panel.nodes().ok()?.into_iter().map(with_height).collect()
        })
    }

    /// Whether f varies little more on the ellipse of a cell than on those of its halves, by the remainder of the rule for f alone.
    fn is_as_smooth(&self, place: Place, whole: Option<DoubleInterval>) -> bool {
        let of_half = |half: Place| {
            let panel = panel(half, BOUND_BITS)?;
            panel.remainder(&self.height(&panel.ellipse())?).map(|remainder| remainder.upper())
        };
        let halves = place.halves().map(of_half).into_iter().flatten().fold(0.0, f64::max);
        whole.is_some_and(|whole| whole.upper() <= SMOOTH * halves)
    }

    /// f over a set of radii.
    pub(super) fn height<T: Analytic>(&self, r: &T) -> Option<T> {
        self.count(T::WORK);
        self.part.derivatives_at(r, 0).map(|f| f.value().clone())
    }

    /// Counts as many evaluations in doubles as other work takes the time of.
    pub(super) fn count(&self, work: u64) {
        self.heights.fetch_add(work, Ordering::Relaxed);
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
        for depth in 2..DEEPEST {
            let exponent = exponent - depth;
            if Float::with_val(BOUND_BITS, Float::i_exp(1, exponent)) < width {
                break;
            }
            let [first, last] = [x.lower(), x.upper()].map(|end| Place::of(end, exponent));
            let (first, last) = (first?.index - 1, last?.index);
            let is_smooth = |index| self.is_smooth(Place { exponent, index });
            if (first..=last).all(is_smooth) {
                let is_smooth_from_axis = depth == 2 && (0..first).all(is_smooth);
                let [at, _] = Place { exponent, index: first }.ends();
                return Some(if is_smooth_from_axis { Below::Nothing } else { Below::Cut { at, depth } });
            }
        }
        None
    }
}

/// The piece of a place, with a rule for so many bits.
pub(super) fn panel(place: Place, bits: u32) -> Option<LegendrePanel> {
    let [lower, upper] = place.ends();
    LegendrePanel::new(&lower, &upper, bits)
}

/// What is kept under a key, or made and kept.
fn kept<K: Eq + Hash, V>(all: &Mutex<HashMap<K, Arc<V>>>, key: K, new: impl FnOnce() -> Option<V>) -> Option<Arc<V>> {
    let all = || all.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(value) = all().get(&key) {
        return Some(value.clone());
    }
    let value = Arc::new(new()?);
    let mut all = all();
    if all.len() >= KEPT {
        all.clear();
    }
    all.insert(key, value.clone());
    Some(value)
}

#[cfg(test)]
#[path = "../../../tests/private/store.rs"]
pub(super) mod tests;
