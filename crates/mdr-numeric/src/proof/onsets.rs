//! g over complex sets of radii beyond an onset b, where a power u^e of u = r − b begins.
//!
//! With y = x − b = σ²/(x + b), σ² = x² − b², the power has in g [the term](crate::transform::onset)
//!
//! y^(e − 1/2) ∫₀¹ (Y + a)K(yτ, y) τ^e dτ/√(1 − τ).
//!
//! The weights are positive with the sum B(e + 1, 1/2): the mean lies in each convex set of values.

use std::collections::BTreeMap;

use mdr_core::contact::{EnclosedFormula, Onset};
use mdr_core::number::{Analytic, Ends, Gamma, Interval, Real, Rectangle};

use super::continuation::Continuation;
use crate::transform::onset::{integrand, order, power};

/// The powers of a profile, and what is left without them.
pub(super) struct Onsets {
    rest: Continuation,
    /// By their kinks, at which nothing else changes.
    begun: BTreeMap<usize, Vec<Begun>>,
}

/// A power with the sum of its weights.
pub(super) struct Begun {
    onset: Onset,
    weight: Interval,
}

impl Onsets {
    /// The powers of a sum of formulas that has these kinks; `None` without any, or where one begins at a kink of another kind.
    pub(super) fn of(terms: &[EnclosedFormula], breaks: &[Interval]) -> Option<Self> {
        let mut begun = BTreeMap::<usize, Vec<Begun>>::new();
        for onset in terms.iter().filter_map(EnclosedFormula::onsets).flat_map(|onsets| &onsets.powers) {
            let mut at = breaks.iter().enumerate().filter(|(_, b)| b.overlaps(onset.begin()));
            let (Some((kink, _)), None) = (at.next(), at.next()) else { return None };
            let together = begun.entry(kink).or_default();
            if together.iter().any(|other| !other.onset.begins_with(onset)) {
                return None;
            }
            together.push(Begun::new(onset.clone()));
        }
        if begun.is_empty() {
            return None;
        }
        let rest = terms.iter().map(|term| term.onsets().map_or_else(|| term.clone(), |onsets| onsets.rest.clone()));
        let rest = Continuation::new(rest.collect())?;
        let is_apart = |kink: &usize| !rest.breaks().iter().any(|b| b.overlaps(&breaks[*kink]));
        (begun.keys().all(is_apart) && rest.breaks().len() + begun.len() == breaks.len())
            .then_some(Onsets { rest, begun })
    }

    /// The powers that begin at a kink.
    pub(super) fn at(&self, kink: usize) -> Option<&[Begun]> {
        self.begun.get(&kink).map(Vec::as_slice)
    }

    /// f after so many kinks of all: beyond an onset also over real sets that reach below it.
    pub(super) fn height<T: Analytic>(&self, r: &T, beyond: usize) -> Option<T> {
        let begun = self.begun.range(..beyond);
        let rest = self.rest.height(r, beyond - begun.clone().count())?;
        begun.flat_map(|(_, begun)| begun).try_fold(rest, |sum, begun| Some(sum.plus(&begun.height(r)?)))
    }

    /// The heights of the rest that were evaluated.
    pub(super) fn work(&self) -> u64 {
        self.rest.work()
    }

    /// Bounds of g over real radii on a half-space.
    pub(super) fn range(&self, x: &Interval) -> Option<Interval> {
        let mut g = self.rest.range(x)?;
        for begun in self.begun.values().flatten().filter(|begun| begun.onset.begin().lower() < x.upper()) {
            g += &begun.range(&x.rounded(g.ctx()))?;
        }
        Some(g)
    }
}

impl Begun {
    fn new(onset: Onset) -> Self {
        // B(e + 1, 1/2)
        let first = onset.exponent().clone() + onset.exponent().lit(1);
        let half = first.lit(1).over(2);
        let weight = Gamma::gamma(&first) * Real::sqrt(&first.pi()) / Gamma::gamma(&(first + half));
        Begun { onset, weight }
    }

    fn height<T: Analytic>(&self, r: &T) -> Option<T> {
        let u = r.minus(&r.constant(self.onset.begin())).positive_part();
        Some(self.onset.at(&u)?.product(&u.power(self.onset.exponent())?))
    }

    /// The integral, with its weights.
    fn mean<T: Analytic>(&self, y: &T) -> Option<T> {
        let all = Interval::from_int(self.weight.ctx(), 0).hull(&Interval::from_int(self.weight.ctx(), 1));
        let k = integrand(&self.onset, y, &y.scaled(&all), 1)?;
        let sum = k.derivative(1).plus(&k.value().scaled(&order(&self.onset, y.bits())));
        Some(sum.scaled(&self.weight)).filter(T::is_bounded)
    }

    /// The term of g at x with σ.
    pub(super) fn g<I: Ends>(&self, x: &Rectangle<I>, leg: &Rectangle<I>) -> Option<Rectangle<I>> {
        let sum = x.plus(&x.constant(self.onset.begin()));
        let y = leg.squared().quotient(&sum)?;
        let a = order(&self.onset, x.bits());
        let share = a.clone() - a.lit(1);
        // y^(e − 1/2)
        let twice = share.clone().times(2);
        let whole = twice.approx().round();
        let raised = if twice == Interval::from_f64(twice.ctx(), whole) {
            leg.raised(whole as i64)?
        } else {
            leg.power(&twice)?
        };
        self.mean(&y)?.product(&raised).quotient(&sum.power(&share)?)
    }

    /// Bounds of the term over real radii.
    fn range(&self, x: &Interval) -> Option<Interval> {
        let y = (x.clone() - self.onset.begin()).positive_part();
        Some(self.mean(&y)? * power(&y, &self.onset, 1))
    }
}
