//! g over complex sets of radii, from the formula of the profile: the proof that integrals over g converge as they are said to.
//!
//! Between two kinks g is an analytic function, which goes on beyond them. With D = r d/dr and part 0 of f before its first kink,
//!
//! G₀(x) = ∫₀^{π/2} sinθ (1 + D)f₀(x sinθ) dθ.
//!
//! Beyond a kink b, where part k of f follows part k − 1, and Δ is their difference, g has the further term
//!
//! x σ ∫₀^{π/2} sinφ r⁻² DΔ(r) dφ, σ = √(x² − b²), r² = b² + σ² sin²φ,
//!
//! which is (1.1) of Δ from b on. It is analytic in σ, so that g is, next to a kink, in σ instead of x. The weights sinθ dθ are
//! positive with the sum 1: over a convex set of values each mean lies in it, and some cells of angles give an enclosure. On springs whose stiffness
//! up to x is as x^q, on a graded half-space with q = 1 + k and on a Winkler foundation with q = 2, g is the mean of f + Df/q with the weights
//! q sinθ cos^(q − 1)θ dθ.
//!
//! Of a [power that begins](super::onsets) at b the term is another one.
//!
//! A profile with many kinks, as a table, has a term for the last few of them only. There f itself stands for Δ at the first of these, up to
//! which radii are [distant](super::distant).

use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::calculus::enclose::BOUND_BITS;
use mdr_core::contact::EnclosedFormula;
use mdr_core::number::{Analytic, Ends, Euler, Interval, Precision, Real, Rectangle};

use super::distant::Distant;
use super::onsets::Onsets;
use crate::medium::Medium;

/// Cells of angles, of equal weight.
const CELLS: i64 = 6;
/// From so many kinks on radii below the last few are distant,
const MANY: usize = 8;
/// and so many kinks before x are not.
const NEAR: usize = 4;

/// A profile f, as a sum of formulas, with its analytic continuation beyond kinks; from it g is bounded over complex sets of
/// radii, where its closed form or its integral is for numbers only.
///
/// ```
/// use mdr_core::contact::Expression;
/// use mdr_core::number::{Interval, Precision};
/// use mdr_numeric::proof::Continuation;
/// let (formula, none): (Expression, _) = ("r^2/2 - 0.1*max(0, r - 1)".parse()?, Default::default());
/// let precision = Precision::new(100);
/// let profile = Continuation::new(vec![formula.enclosed(&none, &formula.breaks(&none)?, precision)?]);
/// let profile = profile.expect("one kink");
/// // g = x² on [0.5, 0.6]
/// let number = |x: f64| Interval::point(rug::Float::with_val(100, x));
/// let x = number(0.5).hull(&number(0.6));
/// let g = profile.range(&x).expect("defined");
/// assert!(g.contains(number(0.25).lower()) && g.contains(number(0.36).upper()));
/// # Ok::<(), mdr_core::contact::ExpressionError>(())
/// ```
pub struct Continuation {
    terms: Vec<EnclosedFormula>,
    breaks: Vec<Interval>,
    /// sinθ over each cell, and sin²θ.
    cells: Vec<[Interval; 2]>,
    /// q, with a stiffness of the springs up to a as a^q: 1 on a half-space.
    order: Interval,
    /// k, if f is analytic at the axis as a function of r^(1/k) alone; else 1.
    root: u32,
    /// Of many kinks.
    distant: Option<Distant>,
    /// The powers that begin at kinks.
    onsets: Option<Box<Onsets>>,
    /// The heights that were evaluated, counted over intervals of doubles.
    heights: AtomicU64,
}

/// The largest k of r^(1/k).
const LARGEST_ROOT: u32 = 128;

impl Continuation {
    /// The sum of formulas; `None` if two of their kinks are so close to each other that their order is not known.
    pub fn new(terms: Vec<EnclosedFormula>) -> Option<Self> {
        let mut breaks: Vec<Interval> = terms.iter().flat_map(EnclosedFormula::breaks).cloned().collect();
        breaks.sort_by(|one, other| one.lower().total_cmp(other.lower()));
        breaks.dedup_by(|one, other| one.is_same(other));
        if breaks.windows(2).any(|pair| pair[0].upper() >= pair[1].lower()) {
            return None;
        }
        let roots = terms.iter().filter_map(|term| term.part(0)?.root());
        let root = roots.fold(1, least_common_multiple);
        let root = if root > LARGEST_ROOT { 1 } else { root };
        let order = Interval::from_int(Precision::new(BOUND_BITS), 1);
        let (cells, heights) = (cells(|share| share.square()), AtomicU64::default());
        let onsets = Onsets::of(&terms, &breaks).map(Box::new);
        let mut all = Continuation { terms, breaks, cells, order, root, distant: None, onsets, heights };
        if all.breaks.len() >= MANY {
            all.distant = Distant::new(&all.breaks, |radii, beyond| all.slope_within(radii, beyond));
        }
        Some(all)
    }

    /// The profile on another medium; `None` in line contact, where g is not known on complex sets.
    pub fn on(mut self, medium: &Medium<Interval>) -> Option<Self> {
        let order = medium.order_of_discs()?.rounded(self.order.ctx());
        if !order.is_same(&self.order) {
            let share = order.lit(1) / &order;
            (self.cells, self.distant) = (cells(|cosine| cosine.pow(&share).square()), None);
            self.order = order;
        }
        Some(self)
    }

    /// Whether it is on a medium whose springs are spread like those of this one.
    pub(super) fn is_on(&self, medium: &Medium<Interval>) -> bool {
        medium.order_of_discs().is_some_and(|order| order.rounded(self.order.ctx()).is_same(&self.order))
    }

    fn is_on_half_space(&self) -> bool {
        self.order == self.order.lit(1)
    }

    /// What g is the mean of.
    fn weighted<T: Analytic>(&self, f: &Euler<T>) -> T {
        let rise = f.derivative(1);
        f.value().plus(&if self.is_on_half_space() { rise } else { rise.scaled(&(self.order.lit(1) / &self.order)) })
    }

    /// f' on radii beyond so many kinks.
    fn slope_within(&self, radii: &Interval, beyond: usize) -> Option<Interval> {
        let slopes = self.terms.iter().map(|term| {
            let [_, slope, _] = term.part(self.index(term, beyond))?.slopes(radii)?;
            Some(slope)
        });
        sum(slopes)
    }

    /// Enclosures of the radii where f is not smooth, ascending.
    pub fn breaks(&self) -> &[Interval] {
        &self.breaks
    }

    /// The heights that were evaluated so far, counted over intervals.
    pub(super) fn work(&self) -> u64 {
        let rest = self.onsets.as_ref().map_or(0, |onsets| onsets.work());
        self.heights.load(Ordering::Relaxed) / <Interval as Analytic>::WORK + rest
    }

    /// Counts a height over a set.
    fn count<T: Analytic>(&self) {
        self.heights.fetch_add(T::WORK, Ordering::Relaxed);
    }

    /// Whether f is known up to a radius.
    pub(super) fn reaches(&self, x: &Interval) -> bool {
        self.terms.iter().all(|term| {
            term.outer_radius().is_none_or(|outer| x.upper() < outer.lower())
                && term.known_to().is_none_or(|known_to| x.upper() <= known_to)
        })
    }

    /// The part of a term that follows so many kinks of the sum.
    fn index(&self, term: &EnclosedFormula, beyond: usize) -> usize {
        let Some(last) = beyond.checked_sub(1).and_then(|last| self.breaks.get(last)) else { return 0 };
        term.breaks().partition_point(|b| b.upper() <= last.upper())
    }

    /// f after so many kinks.
    pub(super) fn height<T: Analytic>(&self, r: &T, beyond: usize) -> Option<T> {
        if let Some(onsets) = &self.onsets {
            return onsets.height(r, beyond);
        }
        self.count::<T>();
        let values = self.terms.iter().map(|term| term.part(self.index(term, beyond))?.at(r));
        sum(values)
    }

    /// f beyond all kinks, over radii that may reach far out.
    pub(super) fn height_far_out(&self, r: &Interval) -> Option<Interval> {
        let beyond = self.breaks().len();
        if self.onsets.is_some() {
            return self.height(r, beyond);
        }
        self.count::<Interval>();
        sum(self.terms.iter().map(|term| term.part(self.index(term, beyond))?.far_out(r)))
    }

    /// f after so many kinks with its Euler derivatives, over a set of radii that may hold the axis.
    pub(super) fn heights<T: Analytic>(&self, r: &T, order: usize, beyond: usize) -> Option<Euler<T>> {
        if order == 0
            && beyond > 0
            && let Some(onsets) = &self.onsets
        {
            return Euler::from_derivatives(vec![onsets.height(r, beyond)?]);
        }
        self.count::<T>();
        let values = self.terms.iter().map(|term| term.part(self.index(term, beyond))?.derivatives_at(r, order));
        sum(values)
    }

    /// Likewise over x times sinθ of a cell, of which the first begins at the axis.
    fn heights_along<T: Analytic>(&self, x: &T, sine: &Interval, order: usize) -> Option<Euler<T>> {
        if *sine.lower() > 0 {
            return self.heights(&x.scaled(sine), order, 0);
        }
        self.count::<T>();
        let values = self.terms.iter().map(|term| term.part(0)?.derivatives_along(x, sine, order));
        sum(values)
    }

    /// Δ at a kink, of the terms that change there.
    fn change<T: Analytic>(&self, r: &T, kink: usize) -> Option<T> {
        self.count::<T>();
        let of = |term: &EnclosedFormula| {
            let [before, after] = [kink, kink + 1].map(|beyond| self.index(term, beyond));
            (before != after).then_some((before, after))
        };
        let changing = self.terms.iter().filter_map(|term| Some((term, of(term)?)));
        sum(changing.map(|(term, (before, after))| Some(term.part(after)?.at(r)?.minus(&term.part(before)?.at(r)?))))
    }

    /// Whether f' certainly jumps at a kink, at whose radius r is.
    pub(super) fn jumps(&self, kink: usize, r: &Interval) -> bool {
        let change = self.change(&Euler::variable(r, 1), kink);
        change.is_some_and(|change| !change.derivative(1).contains_zero())
    }

    /// Bounds of g over an interval of real radii that may begin at 0 and may hold kinks; `None` where f is not defined.
    pub fn range(&self, x: &Interval) -> Option<Interval> {
        if let Some(onsets) = self.onsets.as_ref().filter(|_| self.is_on_half_space()) {
            return onsets.range(x);
        }
        let x = x.rounded(Precision::new(BOUND_BITS));
        let mut means = Vec::new();
        for [sine, _] in &self.cells {
            let r = x.clone() * sine;
            let first = self.breaks.partition_point(|b| b.upper() < r.lower());
            let last = self.breaks.partition_point(|b| b.lower() <= r.upper());
            let mut parts = (first..=last).map(|beyond| {
                let f = self.heights(&r, 1, beyond)?;
                Some(self.weighted(&f))
            });
            let one = parts.next()??;
            means.push(parts.try_fold(one, |hull, other| Some(hull.hull(&other?)))?);
        }
        mean(means.into_iter().map(Some))
    }

    /// k, if f has fractional powers of r at the axis and is analytic there as a function of r^(1/k).
    pub(super) fn root(&self) -> Option<u32> {
        (self.root > 1).then_some(self.root)
    }

    /// g before the first kink, over a set of q = x^(1/k) that may hold the axis, with the [k](Self::root) of the profile.
    pub(super) fn g_at_root<T: Analytic>(&self, q: &T) -> Option<T> {
        mean(self.cells.iter().map(|[sine, _]| {
            self.count::<T>();
            let order = sine.lit(1).over(i64::from(self.root));
            let q = q.scaled(&sine.pow(&order));
            let of = |term: &EnclosedFormula| {
                let part = term.part(0)?;
                match part.root() {
                    Some(k) => part.derivatives_at_root(&q.raised(i64::from(self.root / k))?, 1),
                    None => part.derivatives_at(&q.raised(i64::from(self.root))?, 1),
                }
            };
            let f = sum(self.terms.iter().map(of))?;
            Some(self.weighted(&f))
        }))
    }

    /// g over a complex set of radii; beyond kinks on a half-space only.
    pub(super) fn g<I: Ends>(&self, x: &Rectangle<I>, legs: &Legs<I>) -> Option<Rectangle<I>> {
        if !legs.legs.is_empty() && !self.is_on_half_space() {
            return None;
        }
        let mut g = match (&self.distant, legs.base) {
            (Some(distant), Some(base)) => distant.g(x, base)?,
            _ => mean(self.cells.iter().map(|[sine, _]| {
                let f = self.heights_along(x, sine, 1)?;
                Some(self.weighted(&f))
            }))?,
        };
        for (kink, leg) in legs.all() {
            if let Some(begun) = self.onsets.as_ref().and_then(|onsets| onsets.at(kink)) {
                for power in begun {
                    g = g.plus(&power.g(x, leg)?);
                }
                continue;
            }
            let [i, _] = self.beyond(kink, leg, legs.base)?;
            g = g.plus(&x.product(leg).product(&i));
        }
        Some(g)
    }

    /// ∫ sinφ r⁻² DΔ dφ, and ∫ sin³φ r⁻⁴ (D² − 2D)Δ dφ, its derivative in x over x. At the base Δ is f.
    fn beyond<I: Ends>(&self, kink: usize, leg: &Rectangle<I>, base: Option<usize>) -> Option<[Rectangle<I>; 2]> {
        let square = leg.constant(&self.breaks[kink]).squared();
        let at = |[_, share]: &[Interval; 2]| {
            let r_squared = leg.squared().scaled(share).plus(&square);
            let r = Euler::variable(&r_squared.sqrt()?, 2);
            let change = if base == Some(kink) { self.height(&r, kink + 1)? } else { self.change(&r, kink)? };
            let (first, second) = (change.derivative(1), change.derivative(2));
            let rise = second.minus(&first.plus(&first));
            Some([first.quotient(&r_squared)?, rise.quotient(&r_squared.squared())?.scaled(share)])
        };
        let both: Vec<[Rectangle<I>; 2]> = self.cells.iter().map(at).collect::<Option<_>>()?;
        let of = |k: usize| mean(both.iter().map(|pair| Some(pair[k].clone())));
        Some([of(0)?, of(1)?])
    }

    /// x g' of part 0: ∫ sinθ (D + D²)f₀ dθ.
    pub(super) fn first_rise<I: Ends>(&self, x: &Rectangle<I>) -> Option<Rectangle<I>> {
        mean(self.cells.iter().map(|[sine, _]| {
            let f = self.heights_along(x, sine, 2)?;
            Some(f.derivative(1).plus(&f.derivative(2)))
        }))
    }

    /// dg/dx, or with `by_leg` dg/dσ of the last kink, which is bounded next to it.
    pub(super) fn slope<I: Ends>(&self, x: &Rectangle<I>, legs: &Legs<I>, by_leg: bool) -> Option<Rectangle<I>> {
        let mut slope = match (&self.distant, legs.base) {
            (Some(distant), Some(base)) => distant.slope(x, base)?,
            _ => self.first_rise(x)?.quotient(x)?,
        };
        let square = x.squared();
        let last = legs.all().last().filter(|_| by_leg);
        let others = legs.legs.len() - usize::from(last.is_some());
        for (kink, leg) in legs.all().take(others) {
            let [i, j] = self.beyond(kink, leg, legs.base)?;
            let factor = leg.plus(&square.quotient(leg)?);
            slope = slope.plus(&factor.product(&i)).plus(&square.product(leg).product(&j));
        }
        let Some((kink, leg)) = last else { return Some(slope) };
        let [i, j] = self.beyond(kink, leg, legs.base)?;
        let own = leg.squared().quotient(x)?.plus(x).product(&i).plus(&leg.squared().product(x).product(&j));
        Some(slope.product(leg).quotient(x)?.plus(&own))
    }

    /// σ of the kinks before x that have a term, the last of them given.
    pub(super) fn legs<I: Ends>(
        &self,
        x: &Rectangle<I>,
        beyond: usize,
        last: Option<&Rectangle<I>>,
    ) -> Option<Legs<I>> {
        let base = beyond.checked_sub(NEAR).filter(|_| self.distant.is_some());
        let first = base.unwrap_or(0);
        let square = x.squared();
        let leg = |(kink, b): (usize, &Interval)| match last {
            Some(last) if kink + 1 == beyond => Some(last.clone()),
            _ => square.minus(&square.constant(b).squared()).sqrt(),
        };
        let legs = self.breaks.iter().enumerate().take(beyond).skip(first).map(leg).collect::<Option<_>>()?;
        Some(Legs { base, first, legs })
    }

    /// Whether f'(0) = 0 exactly, where f is smooth at the tip.
    pub(super) fn is_flat_at_tip(&self, precision: Precision) -> bool {
        let zero = Interval::from_int(precision, 0);
        self.terms.iter().all(|term| {
            let slope = term.part(0).and_then(|part| part.stretch(&zero));
            slope.is_some_and(|slope| slope.lower().is_zero() && slope.upper().is_zero())
        })
    }

    /// Bounds of g' on [0, x], without kinks there, over π/2.
    pub(super) fn stretch_from_tip(&self, x: &Interval) -> Option<Interval> {
        let first = self.breaks.first();
        if first.is_some_and(|b| b.lower() <= x.upper()) {
            return None;
        }
        let radii = x.lit(0).hull(x);
        sum(self.terms.iter().map(|term| term.part(0)?.stretch(&radii)))
    }
}

/// Of a number that is not too large already.
fn least_common_multiple(one: u32, other: u32) -> u32 {
    if one > LARGEST_ROOT {
        return one;
    }
    let (mut divisor, mut rest) = (one, other);
    while rest != 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    one / divisor * other
}

/// The sum of what is defined.
fn sum<T: Analytic>(mut values: impl Iterator<Item = Option<T>>) -> Option<T> {
    let first = values.next()??;
    values.try_fold(first, |sum, value| Some(sum.plus(&value?)))
}

/// σ = √(x² − b²) of kinks b before x.
pub(super) struct Legs<I = Interval> {
    /// The kink up to which radii are distant.
    base: Option<usize>,
    /// The first kink with a leg.
    first: usize,
    legs: Vec<Rectangle<I>>,
}

impl<I> Legs<I> {
    /// The kinks, with their legs.
    fn all(&self) -> impl Iterator<Item = (usize, &Rectangle<I>)> {
        (self.first..).zip(&self.legs)
    }
}

/// The mean over the cells.
fn mean<T: Analytic>(values: impl Iterator<Item = Option<T>>) -> Option<T> {
    let mut count = 0;
    let total = sum(values.inspect(|_| count += 1))?;
    let bits = Precision::new(total.bits());
    Some(total.scaled(&Real::over(Interval::from_int(bits, 1), count))).filter(T::is_bounded)
}

/// sinθ and sin²θ on cells of equal weight, from cos²θ where so much of the weight is left.
fn cells(square: impl Fn(Interval) -> Interval) -> Vec<[Interval; 2]> {
    let precision = Precision::new(BOUND_BITS);
    let ends: Vec<Interval> = (0..=CELLS)
        .map(|j| {
            let share = Interval::from_int(precision, CELLS - j).over(CELLS);
            share.lit(1) - square(share)
        })
        .collect();
    let cell = |pair: &[Interval]| [Real::sqrt(&pair[0]).hull(&Real::sqrt(&pair[1])), pair[0].hull(&pair[1])];
    ends.windows(2).map(cell).collect()
}

#[cfg(test)]
#[path = "../../tests/private/distant.rs"]
mod tests;
