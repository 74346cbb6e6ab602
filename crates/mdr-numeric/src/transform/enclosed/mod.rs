//! The transform of a formula as enclosures: proved values of g, g' and ∫g, also over intervals of radii.
//!
//! With M_k = ∫₀^{π/2} sinθ Dᵏf(x sinθ) dθ the mean of g is M₀, g = M₀ + M₁, x g' = M₁ + M₂ and x²g'' = M₃ − M₁, each one
//! [integral](mdr_core::calculus::enclose) over t = 2θ/π. At a kink b < x of the formula each branch is integrated to its own
//! side of an enclosure of arcsin(b/x), the hull of both over what remains; f' jumps there, and the end of the pieces moves
//! with x, so that x g' has the further term \[Df\] T with T = b²/(x√(x² − b²)), and x²g'' the terms \[D²f\] T + \[Df\] DT.
//!
//! On other media the weights are others, in another variable t where that is better: see [`ray`]. On a half-space graded as zᵏ,
//! with the weight sinθ cosᵏθ in M_k, the mean is (1 + k)M₀, g = (1 + k)M₀ + M₁, x g' = (1 + k)M₁ + M₂ and
//! x²g'' = M₃ + kM₂ − (1 + k)M₁. On a Winkler foundation, k = 1, g = f. In line contact N = ∫Df dθ, bN' = ∫D²f dθ and
//! b²N'' = ∫(D³f − D²f) dθ, and the mean of N against a reference L is (2/π)√(1 − b²/L²) ∫ f/(1 − (b/L)² sin²θ) dθ.

mod cut;
mod inside;
mod kink;
pub(crate) mod onset;
mod ray;
mod slopes;
mod span;
mod store;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::calculus::enclose::{BOUND_BITS, Goal, Integrand, enclose};
use mdr_core::contact::{EnclosedFormula, Error, Kink, Onset, Onsets, Quantity, Result, Transform};
use mdr_core::number::{Analytic, Interval, Precision, Real, Special};
use rug::Float;

use super::weight::Weight;
use crate::recent::Recent;
use cut::Cuts;
use ray::Ray;
pub(crate) use ray::is_moderate;
pub use slopes::EnclosedWithSlopes;
use span::{Gap, Span, gaps};
use store::Store;

/// The most pieces of an integral at one radius,
const PIECES: usize = 400;
/// and over an interval of radii, where too few only lead to narrower intervals.
const PIECES_OF_INTERVAL: usize = 120;
/// The samples of an integrand see it if one of them is more than the radius times 2^−LEAST_SEEN.
const LEAST_SEEN: u32 = 40;
/// What is less than the radius times 2^−NOTHING is no measure of an integral.
const NOTHING: u32 = 180;
/// Over wide intervals of radii g' is bounded by ranges of (r f')' on so many parts of the quarter circle.
const RANGES: i64 = 12;
/// Recent integrals that are kept.
const KEPT: usize = 8;
/// Heights, counted over intervals, after which no further integral is begun: some seconds.
const MOST: u64 = 500_000;

/// The MDR-transformed profile of a formula over enclosures. Its values are proved; where an integral takes too many pieces it
/// is an [`Error::Unproved`] at a radius, and over an interval of radii the entire line. So is every integral after a great
/// many.
///
/// ```
/// use mdr_core::contact::{Expression, Transform};
/// use mdr_core::number::{Interval, Precision, Real};
/// use mdr_numeric::transform::Enclosed;
/// let (formula, none): (Expression, _) = ("r^2/2 - 0.1*max(0, r - 1)".parse()?, Default::default());
/// let precision = Precision::new(100);
/// let transform = Enclosed::new(formula.enclosed(&none, &formula.breaks(&none)?, precision)?, precision);
/// // g = x² − (x/10) arccos(1/x)
/// let g = transform.g(&Interval::from_int(precision, 2))?;
/// assert!((g.approx() - (4.0 - 0.2 * std::f64::consts::FRAC_PI_3)).abs() < 1e-15 && g.accuracy_bits() > 85);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Enclosed {
    formula: Arc<EnclosedFormula>,
    weight: Weight<Interval>,
    precision: Precision,
    kept: Arc<Recent<Kept>>,
    heights: Arc<AtomicU64>,
    cuts: Arc<Cuts>,
    /// Heights for cuts, on a half-space.
    store: Option<Arc<Store>>,
    /// Powers that begin at radii; the formula is the rest of it.
    onsets: Arc<[Onset]>,
}

/// The integrals at a radius.
struct Kept {
    x: Interval,
    order: Order,
    values: Vec<Interval>,
}

/// What is integrated together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// M₀, M₀ + M₁ and M₁: the mean, g, and what it is above its mean.
    Value,
    /// M₁ + M₂ = x g'.
    Slope,
    /// M₁ + M₂ and M₃ − M₁ = x²g''.
    Curvature,
}

impl Enclosed {
    /// The transform of a formula that was bound in this precision.
    pub fn new(formula: EnclosedFormula, precision: Precision) -> Self {
        Self::weighing(formula, precision, Weight::HalfSpace)
    }

    /// On a half-space graded as zᵏ, with k within (−1, 1).
    ///
    /// ```
    /// use mdr_core::contact::{Expression, Transform};
    /// use mdr_core::number::{Interval, Precision, Real};
    /// use mdr_numeric::transform::Enclosed;
    /// let (formula, none): (Expression, _) = ("r^2/2".parse()?, Default::default());
    /// let precision = Precision::new(100);
    /// let [half, one] = [0.5, 1.0].map(|number| Interval::from_f64(precision, number));
    /// let formula = formula.enclosed(&none, &formula.breaks(&none)?, precision)?;
    /// // g = x²/(R(1 + k))
    /// let g = Enclosed::graded(formula, precision, half).g(&one)?;
    /// assert!(g.overlaps(&one.ratio(2, 3)) && g.accuracy_bits() > 85);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn graded(formula: EnclosedFormula, precision: Precision, k: Interval) -> Self {
        Self::weighing(formula, precision, Weight::Graded(k))
    }

    /// On a Winkler foundation, where g = f.
    pub fn winkler(formula: EnclosedFormula, precision: Precision) -> Self {
        Self::weighing(formula, precision, Weight::Winkler)
    }

    /// In line contact, as the N of a [`LineLoad`](super::LineLoad), with its mean against a reference at this distance.
    pub fn line(formula: EnclosedFormula, precision: Precision, reference: Option<Interval>) -> Self {
        Self::weighing(formula, precision, Weight::Line(reference))
    }

    fn weighing(formula: EnclosedFormula, precision: Precision, weight: Weight<Interval>) -> Self {
        let (kept, heights, cuts) = (Arc::new(Recent::up_to(KEPT)), Arc::<AtomicU64>::default(), Arc::default());
        let (formula, onsets) = match (formula.onsets(), &weight) {
            (Some(Onsets { rest, powers }), Weight::HalfSpace) => (rest.clone(), powers.clone().into()),
            _ => (formula, Arc::default()),
        };
        let part = formula.part(0).filter(|_| matches!(weight, Weight::HalfSpace));
        let store = part.map(|part| Arc::new(Store::new(part.clone(), heights.clone())));
        Enclosed { formula: Arc::new(formula), weight, precision, kept, heights, cuts, store, onsets }
    }

    /// Refuses radii that are not certainly within the formula.
    fn check(&self, x: &Interval) -> Result<()> {
        Error::require_positive(Quantity::Radius, x.clone())?;
        if self.formula.outer_radius().is_some_and(|outer| x.upper() >= outer.lower()) {
            return Err(Error::domain(Quantity::Radius, x, "below the outer radius of the profile"));
        }
        if self.formula.known_to().is_some_and(|known_to| x.upper() > known_to) {
            return Err(Error::domain(Quantity::Radius, x, "where the kinks of the formula are known"));
        }
        Ok(())
    }

    /// The integrals at x, with the terms of kinks.
    fn integrals(&self, x: &Interval, order: Order) -> Result<Vec<Interval>> {
        self.check(x)?;
        let same = |kept: &Kept| kept.order == order && kept.x.is_same(x) && kept.x.lower().prec() == x.lower().prec();
        if let Some(values) = self.kept.find(|kept| same(kept).then(|| kept.values.clone())) {
            return Ok(values);
        }
        let mut values = self.by_cut_or_rays(x, order)?;
        self.add_onsets(x, order, &mut values)?;
        if !Span::of(x).is_wide && !values.iter().all(Real::is_finite) {
            return Err(unproved(x, "a kink of the formula is not located"));
        }
        self.kept.keep(Kept { x: x.clone(), order, values: values.clone() });
        Ok(values)
    }

    /// The integrals without the terms of kinks, cut at some breaks. Over an interval of radii that is too wide nothing is known.
    fn between_breaks(&self, x: &Interval, order: Order, breaks: &[Interval]) -> Result<Vec<Interval>> {
        let span = Span::of(x);
        let unknown = || vec![Interval::entire(x.ctx()); order.count()];
        if self.work() > MOST {
            return Err(unproved(x, "the integrals over the formula took too many values of it"));
        }
        if let (Weight::Winkler, Order::Slope | Order::Curvature) = (&self.weight, order) {
            return Ok(self.direct(x, order, breaks).unwrap_or_else(unknown));
        }
        if span.is_for_ranges() {
            return Ok(unknown());
        }
        match self.pieces(x, order, breaks, &span) {
            Some(values) => {
                let mut values: Vec<_> = values.into_iter().map(|value| value.rounded(x.ctx())).collect();
                if let Weight::Winkler = self.weight {
                    let height =
                        self.direct(x, order, breaks).ok_or_else(|| unproved(x, "the formula is not defined"))?;
                    values.splice(1..2, height);
                }
                Ok(values)
            }
            None if span.is_wide => Ok(unknown()),
            None => Err(unproved(x, "an integral over the formula takes too many pieces there")),
        }
    }

    /// Without an integral, where g = f: f and its derivatives, of all parts of the formula that x meets.
    fn direct(&self, x: &Interval, order: Order, breaks: &[Interval]) -> Option<Vec<Interval>> {
        let first = breaks.partition_point(|b| b.upper() < x.lower());
        let last = breaks.partition_point(|b| b.lower() <= x.upper());
        let values = self.hull(first..=last, |index| {
            let [f, slope, bend] = self.formula.part(index)?.slopes(x)?;
            Some(match order {
                Order::Value => vec![f],
                Order::Slope => vec![slope * x],
                Order::Curvature => vec![slope * x, bend * x.square()],
            })
        })?;
        // Across a jump of f' there is no second derivative.
        let jumps = |index: usize| self.formula.jump(index).is_none_or(|jump| jump[1] != x.lit(0));
        let is_bent = order == Order::Curvature && (first..last).any(jumps);
        Some(if is_bent { vec![values[0].clone(), Interval::entire(x.ctx())] } else { values })
    }

    fn pieces(&self, x: &Interval, order: Order, breaks: &[Interval], span: &Span) -> Option<Vec<Interval>> {
        let precision = Precision::new(span.bits);
        let end = self.weight.end(span.bits);
        let gaps = gaps(x, breaks, &self.weight, &end);
        let mut sums = vec![Interval::from_int(precision, 0); order.count()];
        let mut from = Float::new(span.bits);
        let goal = self.goal(x, order, &gaps, span)?;
        for (index, gap) in gaps.iter().enumerate() {
            let ray = self.ray(if index == 0 { 0 } else { gaps[index - 1].last }, x, order)?;
            if from < gap.from {
                add(&mut sums, &enclose(&ray, [&from, &gap.from], &goal).ok()?);
            }
            add(&mut sums, &self.across(gap, x, order, precision)?);
            from = gap.to.clone();
        }
        let last = gaps.last().map_or(0, |gap| gap.last);
        if from < end {
            add(&mut sums, &enclose(&self.ray(last, x, order)?, [&from, &end], &goal).ok()?);
        }
        let reached = gaps.iter().find(|gap| gap.to >= end).map_or(last, |gap| gap.first);
        let beyond = self.hull(reached..=last, |index| self.ray(index, x, order)?.beyond(&end, precision))?;
        add(&mut sums, &beyond);
        Some(sums)
    }

    fn ray<'a>(&'a self, part: usize, x: &'a Interval, order: Order) -> Option<Ray<'a>> {
        Some(Ray { part: self.formula.part(part)?, x, order, weight: &self.weight, heights: &self.heights })
    }

    /// The hull of what some parts of the formula have.
    fn hull(
        &self,
        parts: std::ops::RangeInclusive<usize>,
        values: impl Fn(usize) -> Option<Vec<Interval>>,
    ) -> Option<Vec<Interval>> {
        let mut all = parts.map(values);
        let first = all.next()??;
        all.try_fold(first, |hull, other| Some(hull.iter().zip(&other?).map(|(one, other)| one.hull(other)).collect()))
    }

    /// The aim: relative to samples of the integrand, and to samples near the axis too where the first see hardly anything, as far
    /// outside of a bump.
    fn goal(&self, x: &Interval, order: Order, gaps: &[Gap], span: &Span) -> Option<Goal> {
        const SAMPLES: [f64; 5] = [0.97, 0.71, 0.43, 0.23, 0.11];
        const NEAR_AXIS: [f64; 3] = [0.11 / 64.0, 0.11 / 4096.0, 0.11 / 262_144.0];
        let middle = x.midpoint();
        let mut sizes = vec![Float::new(BOUND_BITS); order.count()];
        let mut see = |t: f64| {
            let t = self.weight.sample(&Interval::point(Float::with_val(BOUND_BITS, t)));
            let beyond = gaps.iter().rev().find(|gap| gap.to <= *t.lower());
            let ray = self.ray(beyond.map_or(0, |gap| gap.last), &middle, order)?;
            for (size, value) in sizes.iter_mut().zip(ray.at(&t).into_iter().flatten()) {
                size.max_mut(value.abs().upper());
            }
            Some(sizes.iter().fold(Float::new(BOUND_BITS), |largest, size| largest.max(size)))
        };
        let mut largest = Float::new(BOUND_BITS);
        for t in SAMPLES {
            largest = see(t)?;
        }
        let size = |bits: u32| Float::with_val(BOUND_BITS, x.upper()) >> bits;
        for t in NEAR_AXIS {
            if largest < size(LEAST_SEEN) {
                largest = see(t)?;
            }
        }
        // Where samples see nothing, some size: of a component beside it, or of the radius.
        let least = if largest.is_zero() { size(0) } else { largest.max(&size(NOTHING)) } >> 20u32;
        let tolerances = sizes.into_iter().map(|size| size.max(&least) * &span.aim).collect();
        let pieces = if span.is_wide { PIECES_OF_INTERVAL } else { PIECES };
        Some(Goal { bits: span.bits, tolerances, pieces })
    }

    /// The hull of all branches over a gap, times its length.
    fn across(&self, gap: &Gap, x: &Interval, order: Order, precision: Precision) -> Option<Vec<Interval>> {
        let t = Interval::new(gap.from.clone(), gap.to.clone()).rounded(precision);
        let length = Interval::point(gap.to.clone()) - Interval::point(gap.from.clone());
        let hull = self.hull(gap.first..=gap.last, |index| self.ray(index, x, order)?.at(&t))?;
        Some(hull.into_iter().map(|value| value * &length).collect())
    }

    /// Bounds of g' on an interval of radii that may be wide: with x cosθ = √(x² − b²) at a kink b, where r f' jumps,
    /// g' = ∫ (r f')' dθ + Σ \[r f'\]/√(x² − b²), and with the weights of the medium on others.
    fn slope_by_ranges(&self, x: &Interval) -> Option<Interval> {
        let x = x.rounded(Precision::new(BOUND_BITS));
        let quarter = x.pi().over(2);
        let mut slope = x.lit(0);
        let mut from = x.lit(0);
        for end in 1..=RANGES {
            let to = Special::sin(&quarter.clone().times(end).over(RANGES)).lesser(&x.lit(1));
            let radii = (from.clone() * &x).hull(&(to.clone() * &x));
            let share = match self.stretch(&radii) {
                Some(stretch) => stretch * self.weight.mass(end - 1, RANGES, &x),
                None if end == 1 => self.share_at_tip(&x, &to)?,
                None => return None,
            };
            slope += &share;
            from = to;
        }
        for (index, b) in self.formula.breaks().iter().enumerate().filter(|(_, b)| b.lower() < x.upper()) {
            let jump = &self.formula.jump(index)?[1];
            if *jump != jump.lit(0) {
                slope += &(jump.clone() * self.weight.share_of_step(&x, b));
            }
        }
        slope.is_finite().then_some(slope)
    }

    /// The part of g' of the radii up to x sinθ, without kinks there, by the range of what is integrated for x g': that is bounded at the
    /// tip of r^0.7, too, where (r f')' is not.
    fn share_at_tip(&self, x: &Interval, sine: &Interval) -> Option<Interval> {
        let first = self.formula.breaks().first();
        if first.is_some_and(|b| *b.lower() <= *(sine.clone() * x).upper()) {
            return None;
        }
        let ray = self.ray(0, x, Order::Slope)?;
        let to = ray.position(sine);
        let range = ray.at(&to.lit(0).hull(&to))?.swap_remove(0);
        Some(range * to / x)
    }

    /// (r f')' over a cell of radii, of all parts that it meets.
    fn stretch(&self, r: &Interval) -> Option<Interval> {
        let breaks = self.formula.breaks();
        let first = breaks.partition_point(|b| b.upper() < r.lower());
        let last = breaks.partition_point(|b| b.lower() <= r.upper());
        let mut parts = (first..=last).map(|index| self.formula.part(index)?.stretch(r));
        let one = parts.next()??;
        parts.try_fold(one, |hull, other| Some(hull.hull(&other?)))
    }
}

fn unproved(x: &Interval, remedy: &'static str) -> Error {
    Error::unproved(Quantity::TransformedProfile, x, remedy)
}

impl Order {
    fn count(self) -> usize {
        match self {
            Order::Value => 3,
            Order::Slope => 1,
            Order::Curvature => 2,
        }
    }

    fn derivatives(self) -> usize {
        match self {
            Order::Value => 1,
            Order::Slope => 2,
            Order::Curvature => 3,
        }
    }
}

fn add(sums: &mut [Interval], values: &[Interval]) {
    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
}

impl Transform<Interval> for Enclosed {
    fn g(&self, x: &Interval) -> Result<Interval> {
        Ok(self.integrals(x, Order::Value)?.swap_remove(1))
    }

    fn slope(&self, x: &Interval) -> Result<Interval> {
        self.check(x)?;
        if let Weight::Winkler = self.weight {
            return Ok(self.integrals(x, Order::Slope)?.swap_remove(0) / x);
        }
        let is_for_ranges = Span::of(x).is_for_ranges() && self.onsets.is_empty();
        let ranged = if is_for_ranges { self.slope_by_ranges(x) } else { None };
        ranged.map_or_else(|| Ok(self.integrals(x, Order::Slope)?.swap_remove(0) / x), Ok)
    }

    fn integral(&self, x: &Interval) -> Result<Interval> {
        Ok(self.mean(x)? * x)
    }

    fn mean(&self, x: &Interval) -> Result<Interval> {
        Ok(self.integrals(x, Order::Value)?.swap_remove(0))
    }

    fn above_mean(&self, x: &Interval) -> Result<Interval> {
        Ok(self.integrals(x, Order::Value)?.swap_remove(2))
    }

    fn outer_radius(&self) -> Option<Interval> {
        self.formula.outer_radius().map(|outer| outer.rounded(self.precision))
    }

    fn kinks(&self) -> Vec<Interval> {
        self.all_kinks()
    }

    fn work(&self) -> u64 {
        self.heights.load(Ordering::Relaxed) / <Interval as Analytic>::WORK
    }

    fn kink(&self, index: usize, margin: &Interval) -> Result<Option<Kink<Interval>>> {
        if self.onsets.is_empty() { self.kink_of_breaks(index, margin) } else { self.kink_among_onsets(index, margin) }
    }
}
