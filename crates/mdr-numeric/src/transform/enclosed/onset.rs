//! What powers that begin at a radius b add to the integrals: S = u^e s(u) beyond b, with u = r − b, and nothing before it.
//!
//! Their slopes or curvatures are infinite at b, and so are those of what is integrated along rays r = x sinθ. With y = x − b and u = yτ the
//! radii between b and x are 0 ≤ τ ≤ 1 whatever x is, so that y d/dx acts on S as u d/du, which leaves u^e as it is. By
//! x² − r² = y(1 − τ)(x + r), and with a = e + 1/2 and Y = y d/dy,
//!
//! I = ∫ r S/√(x² − r²) dr = yᵃ ∫₀¹ K τ^e dτ/√(1 − τ), K = r s/√(x + r),
//!
//! g = I' = y^(a−1) ∫ (Y + a)K …, g' = y^(a−2) ∫ (Y + a)(Y + a − 1)K …, and likewise g''; the mean of g is I/x.
//!
//! With k e whole, τ = vᵏ(2 − vᵏ) makes both ends analytic: 1 − τ = (1 − vᵏ)², so that τ^e dτ/√(1 − τ) = 2k v^(ke+k−1) (2 − vᵏ)^e dv.
//!
//! At y = 0 the integrals are numbers: g' begins as y^(e − 3/2).

use std::cmp::Ordering::{Greater, Less};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::calculus::enclose::{BOUND_BITS, Goal, Integrand, enclose};
use mdr_core::contact::{Kink, Onset, Result, Slopes};
use mdr_core::number::{Analytic, Euler, Interval, Precision, Real};
use rug::Float;

use super::ray::is_moderate;
use super::span::Span;
use super::{Enclosed, KEPT, Order, PIECES, PIECES_OF_INTERVAL, add, unproved};
use crate::recent::Recent;

/// Where the integrand is sampled for its size.
const SAMPLES: [f64; 4] = [0.97, 0.83, 0.61, 0.37];

/// What is integrated over v, but for the power of y.
struct Begun<'a> {
    onset: &'a Onset,
    y: &'a Interval,
    order: Order,
    heights: &'a AtomicU64,
}

/// K with derivatives by Y, at u = r − b over a set of y = x − b.
pub(crate) fn integrand<T: Analytic>(onset: &Onset, y: &T, u: &T, derivatives: usize) -> Option<Euler<T>> {
    let [y, u] = [y, u].map(|variable| Euler::variable(variable, derivatives));
    let begin = u.constant(onset.begin());
    let r = begin.plus(&u);
    onset.at(&u)?.product(&r).quotient(&r.plus(&begin).plus(&y).sqrt()?)
}

/// a = e + 1/2.
pub(crate) fn order(onset: &Onset, bits: u32) -> Interval {
    let bits = Precision::new(bits);
    onset.exponent().rounded(bits) + Interval::from_int(bits, 1).over(2)
}

impl Begun<'_> {
    /// K, (Y + a)K; or (Y + a)(Y + a − 1)K; or this and (Y + a − 2) of it.
    fn raised<T: Analytic>(&self, k: &Euler<T>) -> Vec<T> {
        let a = order(self.onset, k.bits());
        // (Y + p) of derivatives by Y.
        let next = |derivatives: &[T], less: i64| -> Vec<T> {
            let p = a.clone() - a.lit(less);
            derivatives.windows(2).map(|pair| pair[1].plus(&pair[0].scaled(&p))).collect()
        };
        let first = next(&k.derivatives(), 0);
        match self.order {
            Order::Value => vec![k.value().clone(), first[0].clone()],
            Order::Slope => next(&first, 1),
            Order::Curvature => {
                let second = next(&first, 1);
                let third = next(&second, 2).swap_remove(0);
                vec![second[0].clone(), third]
            }
        }
    }

    fn goal(&self, span: &Span) -> Option<Goal> {
        let middle = Begun { y: &self.y.midpoint(), ..*self };
        let mut sizes: Vec<Float> = Vec::new();
        for v in SAMPLES {
            let values = middle.at(&Interval::point(Float::with_val(BOUND_BITS, v)))?;
            sizes.resize(values.len(), Float::new(BOUND_BITS));
            for (size, value) in sizes.iter_mut().zip(values) {
                size.max_mut(value.abs().upper());
            }
        }
        let tolerances = sizes.into_iter().map(|size| size * &span.aim).collect();
        let pieces = if span.is_wide { PIECES_OF_INTERVAL } else { PIECES };
        Some(Goal { bits: span.bits, tolerances, pieces })
    }
}

impl Integrand for Begun<'_> {
    fn is_moderate(&self) -> bool {
        is_moderate(self.onset.begin())
    }

    fn at<T: Analytic>(&self, v: &T) -> Option<Vec<T>> {
        self.heights.fetch_add(T::WORK, Ordering::Relaxed);
        let k = i64::from(self.onset.root());
        let raised = v.raised(k)?;
        let left = v.integer(2).minus(&raised);
        let y = v.constant(self.y);
        let u = raised.product(&left).product(&y);
        let integrand = integrand(self.onset, &y, &u, self.order.derivatives())?;
        // k e is whole.
        let power = (self.onset.exponent().clone().times(k)).approx().round() as i64 + k - 1;
        let weight = v.raised(power)?.multiplied(2 * k).product(&left.power(self.onset.exponent())?);
        Some(self.raised(&integrand).into_iter().map(|value| value.product(&weight)).collect())
    }
}

impl Enclosed {
    /// Adds the terms of powers that begin at radii.
    pub(super) fn add_onsets(&self, x: &Interval, order: Order, values: &mut [Interval]) -> Result<()> {
        for onset in self.onsets.iter().filter(|onset| onset.begin().lower() < x.upper()) {
            add(values, &self.of_onset(onset, x, order)?);
        }
        Ok(())
    }

    /// The terms of one of them, which begins below x or in it.
    fn of_onset(&self, onset: &Onset, x: &Interval, order: Order) -> Result<Vec<Interval>> {
        let y = x.clone() - onset.begin();
        let begins = *y.lower() <= 0;
        let (y, span) = (y.positive_part(), Span::of(x));
        let Some(sums) = self.integrals_of_onset(onset, &y, order, &span) else {
            let unknown = vec![Interval::entire(x.ctx()); order.count()];
            return if span.is_wide {
                Ok(unknown)
            } else {
                Err(unproved(x, "a power of the formula begins too close to it"))
            };
        };
        let of = |index: usize, less: i64| {
            let value = sums[index].rounded(x.ctx()) * power(&y, onset, less);
            if begins { value.hull(&y.lit(0)) } else { value }
        };
        Ok(match order {
            Order::Value => {
                let (mean, g) = (of(0, 0) / x, of(1, 1));
                vec![mean.clone(), g.clone(), g - mean]
            }
            Order::Slope => vec![of(0, 2) * x],
            Order::Curvature => vec![of(0, 2) * x, of(1, 3) * x.square()],
        })
    }

    fn integrals_of_onset(&self, onset: &Onset, y: &Interval, order: Order, span: &Span) -> Option<Vec<Interval>> {
        let begun = Begun { onset, y, order, heights: &self.heights };
        let ends = [0, 1].map(|end| Float::with_val(BOUND_BITS, end));
        enclose(&begun, [&ends[0], &ends[1]], &begun.goal(span)?).ok()
    }

    /// The radii where a proof needs to know both sides: the breaks of the rest, and the onsets.
    pub(super) fn all_kinks(&self) -> Vec<Interval> {
        let mut all = self.formula.breaks().to_vec();
        if self.onsets.is_empty() {
            return all;
        }
        let mut known: Vec<&Onset> = Vec::new();
        for onset in self.onsets.iter() {
            if !known.iter().any(|other| onset.begins_with(other)) {
                known.push(onset);
                all.push(onset.begin().rounded(self.precision));
            }
        }
        all.sort_by(|one, other| one.lower().total_cmp(other.lower()));
        all
    }

    /// g beside the kink with this index among all; `Ok(None)` where it is not known.
    pub(super) fn kink_among_onsets(&self, index: usize, margin: &Interval) -> Result<Option<Kink<Interval>>> {
        let kinks = self.all_kinks();
        let Some(b) = kinks.get(index) else { return Ok(None) };
        let [inner, outer] = [b.lit(1) - margin, margin.clone() + b.lit(1)].map(|factor| factor * b);
        let is_near = |other: &Interval| other.upper() >= inner.lower() && other.lower() <= outer.upper();
        if kinks.iter().enumerate().any(|(other, kink)| other != index && is_near(kink)) {
            return Ok(None);
        }
        let (inside, outside) = (inner.hull(b), b.hull(&outer));
        let (kept, onsets) = (Arc::new(Recent::up_to(KEPT)), Arc::default());
        let rest = Enclosed { kept, onsets, ..self.clone() };
        let rest_kink = match rest.formula.breaks().iter().position(is_near) {
            Some(index) => rest.kink_of_breaks(index, margin)?,
            None => Some(smooth_kink([b, &inside, &outside], |x, order| rest.integrals(x, order))?),
        };
        let Some(mut kink) = rest_kink else { return Ok(None) };
        for onset in self.onsets.iter() {
            let begin = onset.begin();
            let own = match is_near(begin) {
                true => self.kink_of_onset(onset, &outside),
                false if begin.lower() > outer.upper() => continue,
                false => smooth_kink([b, &inside, &outside], |x, order| self.of_onset(onset, x, order))?,
            };
            kink = kink.plus(own);
        }
        Ok(Some(kink))
    }

    /// A power at its own onset, where it is zero, with bounds on radii beyond it.
    fn kink_of_onset(&self, onset: &Onset, outside: &Interval) -> Kink<Interval> {
        let zero = outside.lit(0);
        let y = zero.hull(&(outside.clone() - onset.begin()));
        let factor = self.integrals_of_onset(onset, &y, Order::Slope, &Span::of(outside));
        let slopes = factor.map_or_else(Slopes::unknown, |mut sums| {
            let factor = sums.swap_remove(0).rounded(outside.ctx());
            let exponent = onset.exponent().rounded(outside.ctx()) - outside.lit(3).over(2);
            let far = Interval::point(y.upper().clone()).rounded(outside.ctx());
            let at_end = factor.clone() * power(&far, onset, 2);
            // y^(e − 3/2) grows from 0, is 1, or falls from infinity.
            match factor.partial_cmp(&zero) {
                _ if exponent >= zero => Slopes::within(factor * power(&y, onset, 2)),
                Some(Greater) if exponent < zero => Slopes::at_least(at_end),
                Some(Less) if exponent < zero => Slopes::at_most(at_end),
                _ => Slopes::unknown(),
            }
        });
        Kink { value: Some((zero.clone(), zero.clone())), inside: Slopes::within(zero), outside: slopes }
    }
}

/// g beside a radius at which it is smooth, from integrals at b and over what is inside and outside of it.
fn smooth_kink(
    [b, inside, outside]: [&Interval; 3],
    integrals: impl Fn(&Interval, Order) -> Result<Vec<Interval>>,
) -> Result<Kink<Interval>> {
    let values = integrals(b, Order::Value)?;
    let slopes = |x: &Interval| -> Result<Slopes<Interval>> {
        let slope = integrals(x, Order::Slope)?.swap_remove(0) / x;
        Ok(if slope.is_finite() { Slopes::within(slope) } else { Slopes::unknown() })
    };
    let value = Some((values[1].clone(), values[0].clone()));
    Ok(Kink { value, inside: slopes(inside)?, outside: slopes(outside)? })
}

/// y^(a − j): of an interval that begins at 0, too, where it is the entire line below the power 0.
pub(crate) fn power(y: &Interval, onset: &Onset, less: i64) -> Interval {
    let exponent = order(onset, y.precision()) - y.lit(less);
    let zero = y.lit(0);
    if *y.lower() > 0 {
        return y.pow(&exponent);
    }
    if exponent == zero {
        return y.lit(1);
    }
    let end = Interval::point(y.upper().clone());
    if exponent > zero && *end.lower() > 0 { zero.hull(&end.pow(&exponent)) } else { Interval::entire(y.ctx()) }
}
