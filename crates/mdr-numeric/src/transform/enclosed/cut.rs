//! g' and g'' over intervals of radii, of a profile with a narrow dip, a needle or a pole far inside of them.
//!
//! Along rays r = x sinθ what is narrow moves with x, so that only intervals as narrow are enclosed well. So the profile is cut at a radius c below
//! the interval: with the parabola P(r) = α + βr² that touches it there, h = f − P and s = x² − r²,
//!
//! x g' = 4βx² + x ∫₀ᶜ h r (2s + 3r²) s^(−5/2) dr + (x g' of h from c on),
//!
//! x²g'' = 4βx² − x³ ∫₀ᶜ h r (6s + 15r²) s^(−7/2) dr + (x²g'' of h from c on).
//!
//! The integrals up to c are (1.1) by parts, where nothing remains at c as h and h' are zero there. Their heights stay where they are: only the
//! kernel depends on x, and it is smooth. What is zero up to c and h from there on is a formula with a kink in f''.

use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use mdr_core::calculus::enclose::{BOUND_BITS, Goal, Integrand, enclose};
use mdr_core::contact::{CutFormula, FormulaPart};
use mdr_core::number::{Analytic, Interval, Real};
use rug::Float;

use super::super::weight::Weight;
use super::ray::is_moderate;
use super::span::Span;
use super::{Enclosed, KEPT, Order, PIECES_OF_INTERVAL};
use crate::recent::Recent;

/// The cut is this many widths of the interval below it: there the kernel is known to a third of itself.
const WIDTHS: u32 = 8;
/// Only intervals narrower than this share of their radius are cut.
const NARROW: f64 = 1.0 / 32.0;
/// Where the kernel is sampled for its size, as shares of c.
const SAMPLES: [f64; 4] = [0.93, 0.71, 0.43, 0.17];

/// After so many cuts that did not help they are no longer tried: waves that are everywhere are not better known from cuts.
const TRIALS: u32 = 64;

/// How many cuts in a row have not helped.
#[derive(Debug, Default)]
pub(super) struct Cuts {
    failures: AtomicU32,
}

impl Cuts {
    pub(super) fn are_tried(&self) -> bool {
        self.failures.load(Ordering::Relaxed) < TRIALS
    }

    pub(super) fn note(&self, has_helped: bool) {
        let failures = if has_helped { 0 } else { self.failures.load(Ordering::Relaxed) + 1 };
        self.failures.store(failures, Ordering::Relaxed);
    }
}

impl Enclosed {
    /// The integrals for slopes over an interval of radii, from a cut below it; `None` where there is none, or one takes too many pieces.
    pub(super) fn cut(&self, x: &Interval, order: Order) -> Option<Vec<Interval>> {
        let span = &Span::of(x);
        if order == Order::Value || !span.is_wide || !matches!(self.weight, Weight::HalfSpace) {
            return None;
        }
        let width = Float::with_val(BOUND_BITS, x.upper() - x.lower());
        if width > Float::with_val(BOUND_BITS, x.lower() * NARROW)
            || self.formula.breaks().iter().any(|b| b.lower() <= x.upper())
        {
            return None;
        }
        let c = Float::with_val(BOUND_BITS, x.lower() - width * WIDTHS);
        let CutFormula { inside, outside, bend } = self.formula.cut_at(&Interval::point(c.clone()))?;
        let kernel = Kernel { part: &inside, x, order, heights: &self.heights };
        let parabola = (bend.rounded(x.ctx()) * x.square()).times(4);
        let within = enclose(&kernel, [&Float::new(BOUND_BITS), &c], &kernel.goal(&c, &parabola, span)?).ok()?;
        let (formula, kept, onsets) = (Arc::new(outside), Arc::new(Recent::up_to(KEPT)), Arc::default());
        let beyond = Enclosed { formula, kept, onsets, ..self.clone() };
        let beyond = beyond.integrals(x, order).ok()?;
        let sum = |(within, beyond): (Interval, Interval)| within.rounded(x.ctx()) + beyond + &parabola;
        let sums: Vec<Interval> = within.into_iter().zip(beyond).map(sum).collect();
        sums.iter().all(Real::is_finite).then_some(sums)
    }
}

/// What is integrated up to c.
struct Kernel<'a> {
    part: &'a FormulaPart,
    x: &'a Interval,
    order: Order,
    heights: &'a AtomicU64,
}

impl Kernel<'_> {
    /// The aim: relative to samples, or to the parabola.
    fn goal(&self, c: &Float, parabola: &Interval, span: &Span) -> Option<Goal> {
        let middle = Kernel { x: &self.x.midpoint(), ..*self };
        let mut sizes = vec![Float::with_val(BOUND_BITS, parabola.abs().upper()); self.order.count()];
        for share in SAMPLES {
            let values = middle.at(&Interval::point(Float::with_val(BOUND_BITS, c * share)))?;
            for (size, value) in sizes.iter_mut().zip(values) {
                size.max_mut(&Float::with_val(BOUND_BITS, value.abs().upper() * c));
            }
        }
        let tolerances = sizes.into_iter().map(|size| size * &span.aim).collect();
        Some(Goal { bits: span.bits, tolerances, pieces: PIECES_OF_INTERVAL })
    }
}

impl Integrand for Kernel<'_> {
    fn is_moderate(&self) -> bool {
        is_moderate(self.x)
    }

    fn at<T: Analytic>(&self, r: &T) -> Option<Vec<T>> {
        self.heights.fetch_add(T::WORK, Ordering::Relaxed);
        let height = self.part.derivatives_at(r, 0)?;
        let square = r.squared();
        let s = r.constant(&self.x.square()).minus(&square);
        let share = height.value().product(r).quotient(&s.squared().product(&s.sqrt()?))?;
        let with = |of_s: i64, of_square: i64| s.multiplied(of_s).plus(&square.multiplied(of_square));
        let mut values = vec![share.product(&with(2, 3)).scaled(self.x)];
        if self.order == Order::Curvature {
            let cube = self.x.square() * self.x;
            values.push(share.quotient(&s)?.product(&with(-6, -15)).scaled(&cube));
        }
        Some(values)
    }
}
