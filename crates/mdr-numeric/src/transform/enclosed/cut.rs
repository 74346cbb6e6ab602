//! g, g' and g'' over intervals of radii, of a profile with a narrow dip, a needle or a pole far inside of them.
//!
//! Along rays r = x sinθ what is narrow moves with x, so that only intervals as narrow are enclosed well. So the profile is cut at a radius c below
//! the interval: with the parabola P(r) = α + βr² that touches it there, h = f − P and s = x² − r²,
//!
//! g = α + 2βx² − x ∫₀ᶜ h r s^(−3/2) dr + (g of h from c on), the mean of g likewise with 2βx²/3 and ∫₀ᶜ h r/(x√s) dr,
//!
//! x g' = 4βx² + x ∫₀ᶜ h r (2s + 3r²) s^(−5/2) dr + (x g' of h from c on),
//!
//! x²g'' = 4βx² − x³ ∫₀ᶜ h r (6s + 15r²) s^(−7/2) dr + (x²g'' of h from c on).
//!
//! The integrals up to c are (1.1) by parts, where nothing remains at c as h and h' are zero there. Their heights stay where they are, and are
//! [kept](super::store): only the kernel depends on x, and it is smooth. What is zero up to c and h from there on is a formula with a kink in f''.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use mdr_core::contact::{CutFormula, Result, Transform};
use mdr_core::number::{Interval, Real};
use rug::Float;

use super::ray::is_moderate;
use super::span::relative_width;
use super::store::{Below, Parabola, Store, widened};
use super::{Enclosed, KEPT, MOST, Order};
use crate::recent::Recent;

/// Over an interval of radii with fewer bits of one of the integrals than so many
const FEW: i64 = 2;
/// a cut is tried, and helps where one of the enclosures is narrower by so much.
const HELP: u32 = 4;
/// Where a cut has helped, intervals wider than this share of their radius are no longer integrated along rays: in doubles they have a width.
const NARROWEST: f64 = 1.0 / (1_u64 << 45) as f64;

/// After so many cuts that did not help they are no longer tried: waves that are everywhere are not better known from cuts.
const TRIALS: u32 = 64;

/// How many cuts have not helped, and whether one has.
#[derive(Debug, Default)]
pub(super) struct Cuts {
    failures: AtomicU32,
    come_first: AtomicBool,
}

impl Cuts {
    fn are_tried(&self) -> bool {
        self.failures.load(Ordering::Relaxed) < TRIALS
    }

    /// Whether a cut is tried before rays are.
    fn come_first(&self) -> bool {
        self.come_first.load(Ordering::Relaxed)
    }

    fn note(&self, has_helped: bool) {
        if has_helped {
            self.come_first.store(true, Ordering::Relaxed);
        } else {
            self.failures.fetch_add(1, Ordering::Relaxed);
        }
    }
}

/// What a cut says.
enum FromCut {
    /// The integrals.
    Values(Vec<Interval>),
    /// That something narrow is so close to the interval that its integrals are unknown, along rays, too.
    Unknown,
    /// Nothing: there is no cut.
    Nothing,
}

impl Enclosed {
    /// The integrals without powers that begin: along rays, or from a cut below x where rays say little.
    pub(super) fn by_cut_or_rays(&self, x: &Interval, order: Order) -> Result<Vec<Interval>> {
        let is_vague = |value: &Interval| value.accuracy_bits() < FEW;
        let come_first = self.cuts.come_first();
        let cut = if come_first { self.cut(x, order) } else { FromCut::Nothing };
        let has_width = relative_width(x) > NARROWEST;
        match cut {
            FromCut::Values(values) if has_width => return Ok(values),
            FromCut::Unknown if has_width => return Ok(vec![Interval::entire(x.ctx()); order.count()]),
            _ => (),
        }
        let mut values = self.between_breaks(x, order, self.formula.breaks())?;
        self.add_kinks(x, order, &mut values);
        let is_tried = !come_first && values.iter().any(is_vague) && self.cuts.are_tried();
        let FromCut::Values(cut) = (if is_tried { self.cut(x, order) } else { cut }) else { return Ok(values) };
        if is_tried {
            let helps = |(value, cut): (&Interval, &Interval)| is_vague(value) && cut.radius() < value.radius() / HELP;
            self.cuts.note(values.iter().zip(&cut).any(helps));
        }
        for (value, cut) in values.iter_mut().zip(cut) {
            *value = value.intersect(&cut).unwrap_or_else(|| Interval::entire(x.ctx()));
        }
        Ok(values)
    }

    /// The integrals over an interval of radii, from a cut below it.
    fn cut(&self, x: &Interval, order: Order) -> FromCut {
        let is_cut = is_moderate(x) && self.work() <= MOST;
        let has_break = || self.formula.breaks().iter().any(|b| b.lower() <= x.upper());
        match &self.store {
            Some(store) if is_cut && !has_break() => match store.below(x) {
                Below::Nothing => FromCut::Nothing,
                Below::Narrow => FromCut::Unknown,
                Below::Cut(c) => self.cut_at(store, c, x, order).map_or(FromCut::Nothing, FromCut::Values),
            },
            _ => FromCut::Nothing,
        }
    }

    /// From a cut at c; `None` where it takes too many cells.
    fn cut_at(&self, store: &Store, c: Float, x: &Interval, order: Order) -> Option<Vec<Interval>> {
        let CutFormula { height, bend, beyond } = self.formula.cut_at(&Interval::point(c.clone()))?;
        let within = store.integrals(x, order, &c, &Parabola { height, bend })?;
        let (formula, kept, onsets) = (Arc::new(beyond), Arc::new(Recent::up_to(KEPT)), Arc::default());
        let beyond = Enclosed { formula, kept, onsets, store: None, ..self.clone() };
        let beyond = beyond.integrals(x, order).ok()?;
        let sums: Vec<Interval> =
            within.iter().zip(beyond).map(|(within, beyond)| widened(within, x) + beyond).collect();
        sums.iter().all(Real::is_finite).then_some(sums)
    }
}
