//! The transform of a formula as enclosures: proved values of g, g' and ∫g, also over intervals of radii.
//!
//! With M_k = ∫₀^{π/2} sinθ Dᵏf(x sinθ) dθ the mean of g is M₀, g = M₀ + M₁, x g' = M₁ + M₂ and x²g'' = M₃ − M₁, each one
//! [integral](mdr_core::calculus::enclose) over t = 2θ/π. At a kink b < x of the formula each branch is integrated to its own
//! side of an enclosure of arcsin(b/x), the hull of both over what remains; f' jumps there, and the end of the pieces moves
//! with x, so that x g' has the further term \[Df\] T with T = b²/(x√(x² − b²)), and x²g'' the terms \[D²f\] T + \[Df\] DT.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use mdr_core::calculus::enclose::{BOUND_BITS, Goal, Integrand, enclose};
use mdr_core::contact::{EnclosedFormula, Error, FormulaPart, Kink, Quantity, Result, Slopes, Transform};
use mdr_core::number::{Analytic, Dual, Euler, Interval, Precision, Real, Special};
use rug::Float;
use rug::float::Round;

/// The most pieces of an integral at one radius,
const PIECES: usize = 400;
/// and over an interval of radii, where too few only lead to narrower intervals.
const PIECES_OF_INTERVAL: usize = 60;
/// Intervals of radii that are wider than this ratio are not integrated: g' is bounded by ranges of (r f')'
const WIDEST: f64 = 1.03125;
/// on so many parts of the quarter circle.
const RANGES: i64 = 12;
/// Bits by which the aim of a rule is below the size of the integral,
const SPARE: i32 = 6;
/// and below the width of an enclosure over an interval of radii.
const BELOW_WIDTH: i32 = 9;
/// Recent integrals that are kept.
const KEPT: usize = 8;
/// Values of the integrand after which no further integral is begun: some seconds.
const MOST: u64 = 150_000;

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
    precision: Precision,
    kept: Arc<Mutex<Vec<Kept>>>,
    heights: Arc<AtomicU64>,
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
        Enclosed { formula: Arc::new(formula), precision, kept: Arc::default(), heights: Arc::default() }
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
        let known = |kept: &Vec<Kept>| kept.iter().find(|kept| same(kept)).map(|kept| kept.values.clone());
        if let Some(values) = known(&self.kept.lock().unwrap_or_else(PoisonError::into_inner)) {
            return Ok(values);
        }
        let mut values = self.between_breaks(x, order, self.formula.breaks())?;
        self.add_kinks(x, order, &mut values);
        if !Span::of(x).is_wide && !values.iter().all(Real::is_finite) {
            return Err(unproved(x, "a kink of the formula is not located"));
        }
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() == KEPT {
            kept.remove(0);
        }
        kept.push(Kept { x: x.clone(), order, values: values.clone() });
        Ok(values)
    }

    /// The integrals without the terms of kinks, cut at some breaks. Over an interval of radii that is too wide nothing is known.
    fn between_breaks(&self, x: &Interval, order: Order, breaks: &[Interval]) -> Result<Vec<Interval>> {
        let span = Span::of(x);
        let unknown = || vec![Interval::entire(x.ctx()); order.count()];
        if self.heights.load(Ordering::Relaxed) > MOST {
            return Err(unproved(x, "the integrals over the formula took too many values of it"));
        }
        if span.is_for_ranges() {
            return Ok(unknown());
        }
        match self.pieces(x, order, breaks, &span) {
            Some(values) => Ok(values.into_iter().map(|value| value.rounded(x.ctx())).collect()),
            None if span.is_wide => Ok(unknown()),
            None => Err(unproved(x, "an integral over the formula takes too many pieces there")),
        }
    }

    fn pieces(&self, x: &Interval, order: Order, breaks: &[Interval], span: &Span) -> Option<Vec<Interval>> {
        let precision = Precision::new(span.bits);
        let gaps = gaps(x, breaks, precision);
        let mut sums = vec![Interval::from_int(precision, 0); order.count()];
        let mut from = Float::new(span.bits);
        let one = Float::with_val(span.bits, 1);
        let goal = self.goal(x, order, &gaps, span)?;
        for (index, gap) in gaps.iter().enumerate() {
            let part = self.formula.part(if index == 0 { 0 } else { gaps[index - 1].last })?;
            let ray = Ray { part, x, order, heights: &self.heights };
            if from < gap.from {
                add(&mut sums, &enclose(&ray, [&from, &gap.from], &goal).ok()?);
            }
            add(&mut sums, &self.across(gap, x, order, precision)?);
            from = gap.to.clone();
        }
        let part = self.formula.part(gaps.last().map_or(0, |gap| gap.last))?;
        if from < one {
            let ray = Ray { part, x, order, heights: &self.heights };
            add(&mut sums, &enclose(&ray, [&from, &one], &goal).ok()?);
        }
        Some(sums)
    }

    /// The aim: relative to samples of the integrand.
    fn goal(&self, x: &Interval, order: Order, gaps: &[Gap], span: &Span) -> Option<Goal> {
        const SAMPLES: [f64; 5] = [0.97, 0.71, 0.43, 0.23, 0.11];
        let middle = x.midpoint();
        let mut sizes = vec![Float::new(BOUND_BITS); order.count()];
        for t in SAMPLES {
            let beyond = gaps.iter().rev().find(|gap| gap.to <= t);
            let part = self.formula.part(beyond.map_or(0, |gap| gap.last))?;
            let t = Interval::point(Float::with_val(BOUND_BITS, t));
            let ray = Ray { part, x: &middle, order, heights: &self.heights };
            for (size, value) in sizes.iter_mut().zip(ray.at(&t).into_iter().flatten()) {
                size.max_mut(value.abs().upper());
            }
        }
        // Where samples see nothing, some size: of a component beside it, or of the radius.
        let largest = sizes.iter().fold(Float::new(BOUND_BITS), |largest, size| largest.max(size));
        let least = if largest.is_zero() { Float::with_val(BOUND_BITS, x.upper()) } else { largest } >> 20u32;
        let tolerances = sizes.into_iter().map(|size| size.max(&least) * &span.aim).collect();
        let pieces = if span.is_wide { PIECES_OF_INTERVAL } else { PIECES };
        Some(Goal { bits: span.bits, tolerances, pieces })
    }

    /// The hull of all branches over a gap, times its length.
    fn across(&self, gap: &Gap, x: &Interval, order: Order, precision: Precision) -> Option<Vec<Interval>> {
        let t = Interval::new(gap.from.clone(), gap.to.clone()).rounded(precision);
        let length = Interval::point(gap.to.clone()) - Interval::point(gap.from.clone());
        let mut hull: Option<Vec<Interval>> = None;
        for index in gap.first..=gap.last {
            let part = self.formula.part(index)?;
            let values = Ray { part, x, order, heights: &self.heights }.at(&t)?;
            hull = Some(match hull {
                None => values,
                Some(hull) => hull.iter().zip(&values).map(|(one, other)| one.hull(other)).collect(),
            });
        }
        Some(hull?.into_iter().map(|value| value * &length).collect())
    }

    /// Adds the terms of the kinks inside x.
    fn add_kinks(&self, x: &Interval, order: Order, values: &mut [Interval]) {
        if order == Order::Value {
            return;
        }
        for (index, b) in self.formula.breaks().iter().enumerate() {
            if b.lower() >= x.upper() {
                break;
            }
            let unknown = || Interval::entire(x.ctx());
            let Some([_, first, second]) = self.formula.jump(index) else {
                values.iter_mut().for_each(|value| *value = unknown());
                return;
            };
            let zero = first.lit(0);
            let vanishes = [*first == zero, *first == zero && *second == zero];
            let b = b.rounded(x.ctx());
            let square = (x.clone() - &b) * (x.clone() + &b);
            // Unbounded, and so the entire line, unless x is certainly beyond b.
            let root = Real::sqrt(&square);
            let factor = b.square() / (x.clone() * &root);
            let terms = [factor.clone() * first, {
                let slope = -(x.square() / &square + x.lit(1)) * &factor;
                factor * second + slope * first
            }];
            for ((value, term), vanishes) in values.iter_mut().zip(terms).zip(vanishes) {
                if !vanishes {
                    *value += &term;
                }
            }
        }
    }

    /// Bounds of g' on an interval of radii that may be wide: with x cosθ = √(x² − b²) at a kink b, where r f' jumps,
    /// g' = ∫ (r f')' dθ + Σ \[r f'\]/√(x² − b²).
    fn slope_by_ranges(&self, x: &Interval) -> Option<Interval> {
        let x = x.rounded(Precision::new(BOUND_BITS));
        let quarter = x.pi().over(2);
        let mut sum = x.lit(0);
        let mut from = x.lit(0);
        for end in 1..=RANGES {
            let to = Special::sin(&quarter.clone().times(end).over(RANGES)).lesser(&x.lit(1));
            let radii = (from.clone() * &x).hull(&(to.clone() * &x));
            sum += &self.stretch(&radii)?;
            from = to;
        }
        let mut slope = sum * quarter.over(RANGES);
        for (index, b) in self.formula.breaks().iter().enumerate().filter(|(_, b)| b.lower() < x.upper()) {
            let jump = &self.formula.jump(index)?[1];
            if *jump != jump.lit(0) {
                let square = (x.clone() - b) * (x.clone() + b);
                slope += &(jump.clone() / &Real::sqrt(&square));
            }
        }
        slope.is_finite().then_some(slope)
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
    let [from, to] = [x.lower(), x.upper()].map(|end| end.to_string_radix(10, Some(17)));
    Error::Unproved { quantity: Quantity::TransformedProfile, from, to, remedy }
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

/// How precisely an interval of radii is integrated.
struct Span {
    is_wide: bool,
    ratio: Float,
    bits: u32,
    /// The aim relative to the size of the integrand.
    aim: Float,
}

impl Span {
    fn is_for_ranges(&self) -> bool {
        self.ratio > WIDEST
    }

    fn of(x: &Interval) -> Self {
        let bits = x.lower().prec();
        let ratio = Float::with_val_round(BOUND_BITS, x.upper() / x.lower(), Round::Up).0;
        let width = Float::with_val_round(BOUND_BITS, x.upper() - x.lower(), Round::Up).0 / x.lower();
        let finest = Float::with_val(BOUND_BITS, Float::i_exp(1, SPARE - bits as i32));
        let by_width = Float::with_val(BOUND_BITS, &width) >> BELOW_WIDTH;
        // Half of the bits say all about an interval of that width.
        let is_wide = width > Float::with_val(BOUND_BITS, Float::i_exp(1, -(bits as i32) / 2));
        let enough = width.get_exp().map_or(bits, |exponent| (2 * exponent.unsigned_abs() + 64).min(bits));
        Span { is_wide, ratio, bits: if is_wide { enough } else { bits }, aim: finest.max(&by_width) }
    }
}

/// An enclosure of angles, as a part of [0, 1], on which breaks lie, and the parts before and after them.
struct Gap {
    from: Float,
    to: Float,
    first: usize,
    last: usize,
}

/// The gaps around (2/π) arcsin(b/x), those that overlap in one.
fn gaps(x: &Interval, breaks: &[Interval], precision: Precision) -> Vec<Gap> {
    let x = x.rounded(precision);
    let one = x.lit(1);
    let mut gaps: Vec<Gap> = Vec::new();
    for (index, b) in breaks.iter().enumerate() {
        if b.lower() >= x.upper() {
            break;
        }
        let sine = (b.rounded(precision) / &x).lesser(&one);
        let t = Special::asin(&sine).times(2) / x.pi();
        let (from, to) = (t.lower().clone(), t.upper().clone().min(one.lower()));
        match gaps.last_mut() {
            Some(last) if last.to >= from => {
                last.to.max_mut(&to);
                last.last = index + 1;
            }
            _ => gaps.push(Gap { from, to, first: index, last: index + 1 }),
        }
    }
    gaps
}

fn add(sums: &mut [Interval], values: &[Interval]) {
    sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
}

/// The integrands (π/2) sinθ Dᵏf over t = 2θ/π.
struct Ray<'a> {
    part: &'a FormulaPart,
    x: &'a Interval,
    order: Order,
    heights: &'a AtomicU64,
}

impl Integrand for Ray<'_> {
    fn at<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
        self.heights.fetch_add(1, Ordering::Relaxed);
        let half_pi = Interval::from_int(Precision::new(t.bits()), 1).pi().over(2);
        let sine = t.scaled(&half_pi).sin_cos().0;
        let r = Euler::variable(&sine.scaled(self.x), self.order.derivatives());
        let f = self.part.at(&r)?;
        let weight = sine.scaled(&half_pi);
        let values = match self.order {
            Order::Value => vec![f.value().clone(), f.value().plus(&f.derivative(1)), f.derivative(1)],
            Order::Slope => vec![f.derivative(1).plus(&f.derivative(2))],
            Order::Curvature => {
                let first = f.derivative(1);
                vec![first.plus(&f.derivative(2)), f.derivative(3).minus(&first)]
            }
        };
        Some(values.into_iter().map(|value| value.product(&weight)).collect())
    }
}

impl Transform<Interval> for Enclosed {
    fn g(&self, x: &Interval) -> Result<Interval> {
        Ok(self.integrals(x, Order::Value)?.swap_remove(1))
    }

    fn slope(&self, x: &Interval) -> Result<Interval> {
        self.check(x)?;
        let ranged = if Span::of(x).is_for_ranges() { self.slope_by_ranges(x) } else { None };
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
        self.formula.breaks().to_vec()
    }

    fn work(&self) -> u64 {
        self.heights.load(Ordering::Relaxed)
    }

    fn kink(&self, index: usize, margin: &Interval) -> Result<Option<Kink<Interval>>> {
        let breaks = self.formula.breaks();
        let (Some(b), Some(jump)) = (breaks.get(index), self.formula.jump(index)) else { return Ok(None) };
        let before = |x: &Interval, order| self.between_breaks(x, order, &breaks[..index]);
        let Ok(value) = before(b, Order::Value) else { return Ok(None) };
        let [inner, outer] = [b.lit(1) - margin, margin.clone() + b.lit(1)].map(|factor| factor * b);
        if index > 0 && breaks[index - 1].upper() >= inner.lower()
            || breaks.get(index + 1).is_some_and(|next| next.lower() <= outer.upper())
        {
            return Ok(None);
        }
        let (inside, outside) = (inner.hull(b), b.hull(&outer));
        let mut below = before(&inside, Order::Slope)?;
        let mut above = self.between_breaks(&outside, Order::Slope, &breaks[..=index])?;
        for (x, values) in [(&inside, &mut below), (&outside, &mut above)] {
            let others = Enclosed { formula: Arc::new(self.formula.up_to(index)), ..self.clone() };
            others.add_kinks(x, Order::Slope, values);
        }
        let (below, above) = (below.swap_remove(0), above.swap_remove(0));
        // T falls to its value at the outer end.
        let least = b.square() / (outer.clone() * Real::sqrt(&((outer.clone() - b) * (outer + b))));
        let with_jump = (least * &jump[1] + &above) / &outside;
        let zero = b.lit(0);
        let outside = match &jump[1] {
            jump if *jump == zero => Slopes::within(above / &outside),
            jump if *jump > zero => Slopes::at_least(with_jump),
            jump if *jump < zero => Slopes::at_most(with_jump),
            _ => Slopes::unknown(),
        };
        let value = Some((value[1].clone(), value[0].clone()));
        Ok(Some(Kink { value, inside: Slopes::within(below / inside), outside }))
    }
}

/// The transform of a formula over enclosures with derivatives in the radius.
#[derive(Clone)]
pub struct EnclosedWithSlopes(Enclosed);

impl EnclosedWithSlopes {
    /// From the transform over enclosures.
    pub fn new(transform: Enclosed) -> Self {
        EnclosedWithSlopes(transform)
    }
}

impl Transform<Dual<Interval>> for EnclosedWithSlopes {
    fn g(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        Ok(x.chain(self.0.g(&x.value)?, self.0.slope(&x.value)?))
    }

    fn slope(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        let mut values = self.0.integrals(&x.value, Order::Curvature)?;
        let curvature = values.swap_remove(1) / x.value.square();
        let slope = values.swap_remove(0) / &x.value;
        let slope = if slope.is_finite() { slope } else { self.0.slope_by_ranges(&x.value).unwrap_or(slope) };
        Ok(x.chain(slope, curvature))
    }

    fn integral(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        Ok(x.chain(self.0.integral(&x.value)?, self.0.g(&x.value)?))
    }

    fn mean(&self, x: &Dual<Interval>) -> Result<Dual<Interval>> {
        Ok(x.chain(self.0.mean(&x.value)?, self.0.above_mean(&x.value)? / &x.value))
    }

    fn outer_radius(&self) -> Option<Dual<Interval>> {
        Transform::outer_radius(&self.0).map(Dual::constant)
    }

    fn kinks(&self) -> Vec<Dual<Interval>> {
        Transform::kinks(&self.0).into_iter().map(Dual::constant).collect()
    }

    fn work(&self) -> u64 {
        self.0.work()
    }
}
