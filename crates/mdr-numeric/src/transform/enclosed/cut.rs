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
//! The integrals up to c are the mean, g = (x times the mean)' and what follows from it for h up to c and 0 from there on. Their heights stay where
//! they are, and are [kept](super::store): only the kernel depends on x, and it is smooth. What is zero up to c and h from there on is a formula
//! with a kink in f''. As α and β are numbers, a step of h at c remains of their roundings; [its terms](of_step) are small, where roundings
//! of the parabola itself would be large beside a steep dip.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

use mdr_core::calculus::enclose::{BOUND_BITS, DOUBLE_BITS};
use mdr_core::contact::{CutFormula, Result, Transform};
use mdr_core::number::{Interval, Precision, Real};
use rug::Float;

use super::inside::{Parabola, integrals};
use super::ray::is_moderate;
use super::span::{Span, relative_width};
use super::store::{Below, Store};
use super::{Enclosed, KEPT, MOST, Order};
use crate::recent::Recent;

/// Over an interval of radii with fewer bits of one of the integrals than so many
const FEW: i64 = 2;
/// a cut is tried, and helps where one of the enclosures is narrower by so much.
const HELP: u32 = 4;
/// Where a cut has helped, intervals wider than this share of their radius are integrated in doubles.
const NARROWEST: f64 = 1.0 / (1_u64 << 45) as f64;

/// After so many cuts that did not help they are no longer tried: waves that are everywhere are not better known from cuts.
const TRIALS: u32 = 64;
/// At a radius a cut in many bits costs as much as rays, and much less once the heights are known: it is made where cells below the radius are
/// so many octaves shorter than it,
const DEEP: i32 = 12;
/// elsewhere after so many integrals along rays at one radius,
const SEVERAL: u32 = 4;
/// and no longer after so many have taken too many cells.
const FINE_TRIALS: u32 = 4;

/// How many cuts have not helped, and whether one has; how many integrals were taken at one radius, and how many cuts were not made there.
#[derive(Debug, Default)]
pub(super) struct Cuts {
    failures: AtomicU32,
    come_first: AtomicBool,
    fine: AtomicU32,
    fine_failures: AtomicU32,
}

impl Cuts {
    fn are_tried(&self) -> bool {
        self.failures.load(Ordering::Relaxed) < TRIALS
    }

    /// Whether a cut is tried before rays are: over an interval, once one has helped.
    fn come_first(&self, has_width: bool) -> bool {
        let are_fine = || !has_width && self.fine_failures.load(Ordering::Relaxed) < FINE_TRIALS;
        self.come_first.load(Ordering::Relaxed) || are_fine()
    }

    /// Whether a cut is made where cells are so many octaves shorter than the radius, or the interval; at one radius the question is counted.
    fn is_made(&self, depth: i32, has_width: bool) -> bool {
        let is_known = has_width || self.come_first.load(Ordering::Relaxed);
        is_known || self.fine.fetch_add(1, Ordering::Relaxed) >= SEVERAL || depth >= DEEP
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
    /// The integrals without powers that begin: along rays, or from a cut below x where rays say little, or cost more.
    pub(super) fn by_cut_or_rays(&self, x: &Interval, order: Order) -> Result<Vec<Interval>> {
        let is_vague = |value: &Interval| value.accuracy_bits() < FEW;
        let has_width = relative_width(x) > NARROWEST;
        let come_first = self.cuts.come_first(has_width);
        if come_first {
            match self.cut(x, order, has_width) {
                FromCut::Values(values) => return Ok(values),
                FromCut::Unknown if has_width => return Ok(vec![Interval::entire(x.ctx()); order.count()]),
                _ => (),
            }
        }
        let mut values = self.between_breaks(x, order, self.formula.breaks())?;
        self.add_kinks(x, order, &mut values);
        let is_tried = !come_first && values.iter().any(is_vague) && self.cuts.are_tried();
        let FromCut::Values(cut) = (if is_tried { self.cut(x, order, true) } else { FromCut::Nothing }) else {
            return Ok(values);
        };
        let helps = |(value, cut): (&Interval, &Interval)| is_vague(value) && cut.radius() < value.radius() / HELP;
        self.cuts.note(values.iter().zip(&cut).any(helps));
        for (value, cut) in values.iter_mut().zip(cut) {
            *value = value.intersect(&cut).unwrap_or_else(|| Interval::entire(x.ctx()));
        }
        Ok(values)
    }

    /// The integrals over an interval of radii, from a cut below it: in doubles, or in as many bits as a narrow one has.
    fn cut(&self, x: &Interval, order: Order, has_width: bool) -> FromCut {
        let is_cut = is_moderate(x) && self.work() <= MOST;
        let has_break = || self.formula.breaks().iter().any(|b| b.lower() <= x.upper());
        let Some(store) = self.store.as_ref().filter(|_| is_cut && !has_break()) else { return FromCut::Nothing };
        match store.below(x) {
            Below::Nothing => FromCut::Nothing,
            Below::Narrow => FromCut::Unknown,
            Below::Cut { depth, .. } if !self.cuts.is_made(depth, has_width) => FromCut::Nothing,
            Below::Cut { at, .. } => {
                let bits = if has_width { DOUBLE_BITS } else { Span::of(x).bits };
                let values = self.cut_at(store, &at, x, order, bits);
                if values.is_none() && !has_width {
                    self.cuts.fine_failures.fetch_add(1, Ordering::Relaxed);
                }
                values.map_or(FromCut::Nothing, FromCut::Values)
            }
        }
    }

    /// From a cut at c; `None` where it takes too many cells.
    fn cut_at(&self, store: &Store, c: &Float, x: &Interval, order: Order, bits: u32) -> Option<Vec<Interval>> {
        let c = Interval::point(c.clone()).rounded(Precision::new(bits.max(BOUND_BITS)));
        self.beside(store, &c, self.formula.cut_at(&c)?, x, order, bits)
    }

    /// From a formula that is cut at c, a number.
    fn beside(
        &self,
        store: &Store,
        c: &Interval,
        cut: CutFormula,
        x: &Interval,
        order: Order,
        bits: u32,
    ) -> Option<Vec<Interval>> {
        let CutFormula { height, bend, step, beyond } = cut;
        let within = integrals(store, x, order, c.lower(), &Parabola { height, bend }, bits)?;
        let (formula, kept, onsets) = (Arc::new(beyond), Arc::new(Recent::up_to(KEPT)), Arc::default());
        let beyond = Enclosed { formula, kept, onsets, store: None, ..self.clone() }.integrals(x, order).ok()?;
        let all = within.into_iter().zip(beyond).zip(of_step(x, c, &step, order));
        let sums: Vec<Interval> = all.map(|((within, beyond), step)| within + beyond + step).collect();
        sums.iter().all(Real::is_finite).then_some(sums)
    }
}

/// The terms of a step \[f\] at c, with T = c²/(x√s), s = x² − c² and q = x²/s: in g and in what it is above its mean \[f\] T, in x g' −\[f\] T q,
/// in x²g'' 3\[f\] T q².
fn of_step(x: &Interval, c: &Interval, step: &Interval, order: Order) -> Vec<Interval> {
    let s = (x.clone() - c) * (x.clone() + c);
    let share = step.clone() * c.square() / (x.clone() * Real::sqrt(&s));
    let q = x.square() / s;
    match order {
        Order::Value => vec![x.lit(0), share.clone(), share],
        Order::Slope => vec![-(share * q)],
        Order::Curvature => vec![-(share.clone() * &q), share * q.square().times(3)],
    }
}

#[cfg(test)]
#[path = "../../../tests/private/cut.rs"]
mod tests;
