//! Tanh-sinh (double exponential) quadrature. H. Takahasi, M. Mori, Publ. RIMS 9 (1974) 721.
//!
//! With x = a + (b−a)δ(t), δ = 1/(1 + e^(−π sinh t)), the integrand in t decays so fast that the trapezoidal rule
//! doubles its digits with each halving of the step, whatever algebraic or logarithmic singularity the ends have.

use std::sync::OnceLock;

use super::cache::{Cache, Key, RULES, Stored};
use super::estimate::{Estimate, Refinement, Tolerance, finite, rounding, sum};
use crate::contact::{Error, Quantity, Result};
use crate::number::{Real, order};

/// A point of the interval, with its distances from the ends, each to full relative accuracy.
#[derive(Clone, Debug)]
pub struct Node<R> {
    /// x.
    pub x: R,
    /// x − a, accurate also where x rounds to a.
    pub from_lower: R,
    /// b − x, accurate also where x rounds to b.
    pub from_upper: R,
}

/// ∫ₐᵇ f(x) dx with an error estimate.
///
/// `tolerance` is relative to ∫|f| ([`roundoff_tolerance`](super::roundoff_tolerance) is the tightest). A singularity
/// at an end x = 0 needs no care; elsewhere x cannot come closer to the end than one rounding, so use
/// [`tanh_sinh_near_ends`]. Split the interval at interior kinks. The error includes the rounding of the sum, not that
/// inside f; features of f between all nodes of the first four levels (55 in `f64`) are not detected.
///
/// ```
/// use mdr_core::calculus::{quadrature::tanh_sinh, roundoff_tolerance};
/// // ∫₀¹ ln x dx = −1
/// let integral = tanh_sinh(&0.0, &1.0, &roundoff_tolerance(&1.0), |x: &f64| Ok(x.ln()))?;
/// assert!((integral.value + 1.0).abs() <= integral.error && integral.error < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`NoConvergence`](crate::contact::Error::NoConvergence) with the error reached; a
/// [`Domain`](crate::contact::Error::Domain) error where f is not finite; whatever f returns.
pub fn tanh_sinh<R: Real>(
    lower: &R,
    upper: &R,
    tolerance: impl Into<Tolerance<R>>,
    mut f: impl FnMut(&R) -> Result<R>,
) -> Result<Estimate<R>> {
    integrate(lower, upper, tolerance.into(), &mut |node| {
        if node.is_interior(lower, upper) { f(&node.x).map(Some) } else { Ok(None) }
    })
}

/// ∫ₐᵇ f dx for an integrand written in the distances from the ends: ∫₀¹ dx/√(1−x) = ∫ `from_upper`^(−1/2). Otherwise it
/// is like [`tanh_sinh`].
///
/// # Errors
/// [`NoConvergence`](crate::contact::Error::NoConvergence) with the error reached; a
/// [`Domain`](crate::contact::Error::Domain) error where f is not finite; errors of f.
pub fn tanh_sinh_near_ends<R: Real>(
    lower: &R,
    upper: &R,
    tolerance: impl Into<Tolerance<R>>,
    mut f: impl FnMut(&Node<R>) -> Result<R>,
) -> Result<Estimate<R>> {
    let mut normal = |node: &Node<R>| if node.is_normal() { f(node).map(Some) } else { Ok(None) };
    integrate(lower, upper, tolerance.into(), &mut normal)
}

/// ∫ₐᵇ f(x) dx by [`tanh_sinh`] on each piece between the `breaks`, where f or a derivative of it jumps.
///
/// The tolerance is relative to ∫|f| of each piece; the errors are added. Breaks may come in any order, and those
/// outside (a, b) are ignored, so a list of all kinks can be passed. The end a may be larger than b.
///
/// ```
/// use mdr_core::calculus::{quadrature::tanh_sinh_pieces, roundoff_tolerance};
/// // ∫₀³ |(x−1)(x−2)| dx = 11/6
/// let bent = |x: &f64| Ok(((x - 1.0) * (x - 2.0)).abs());
/// let integral = tanh_sinh_pieces(&0.0, &3.0, &[2.0, 1.0, 7.0], &roundoff_tolerance(&1.0), bent)?;
/// assert!((integral.value - 11.0 / 6.0).abs() <= integral.error && integral.error < 1e-13);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`NoConvergence`](crate::contact::Error::NoConvergence) with the error reached; a
/// [`Domain`](crate::contact::Error::Domain) error where f is not finite; errors of f.
pub fn tanh_sinh_pieces<R: Real>(
    lower: &R,
    upper: &R,
    breaks: &[R],
    tolerance: impl Into<Tolerance<R>>,
    mut f: impl FnMut(&R) -> Result<R>,
) -> Result<Estimate<R>> {
    let tolerance = tolerance.into();
    pieces(lower, upper, breaks, |from, to| tanh_sinh(from, to, tolerance.clone(), &mut f))
}

/// The sum of the integrals over the pieces of (a, b) between the `breaks`, each by the rule `integral(from, to)`;
/// errors and evaluations are added. Breaks as for [`tanh_sinh_pieces`].
///
/// # Errors
/// Whatever `integral` returns.
pub fn pieces<R: Real>(
    lower: &R,
    upper: &R,
    breaks: &[R],
    mut integral: impl FnMut(&R, &R) -> Result<Estimate<R>>,
) -> Result<Estimate<R>> {
    let mut total = Estimate::exact(lower.lit(0));
    let mut from = lower;
    for to in ends_of_pieces(lower, upper, breaks) {
        total += &integral(from, to)?;
        from = to;
    }
    Ok(total)
}

/// Where the pieces end, in their order from `lower` on; apart from the integrals, of which there are hundreds of kinds.
fn ends_of_pieces<'e, R: Real>(lower: &R, upper: &'e R, breaks: &'e [R]) -> Vec<&'e R> {
    let (from, to) = (lower.midpoint(), upper.midpoint());
    let backwards = from > to;
    let (least, most) = if backwards { (to, from) } else { (from, to) };
    let mut ends: Vec<&R> = breaks.iter().filter(|end| least < end.midpoint() && end.midpoint() < most).collect();
    ends.sort_by(|one, other| order(*one, *other));
    if backwards {
        ends.reverse();
    }
    ends.push(upper);
    ends
}

impl<R: Real> Node<R> {
    fn new(lower: &R, upper: &R, near: R, far: R, side: Side) -> Self {
        match side {
            Side::Lower => Node { x: near.clone() + lower, from_lower: near, from_upper: far },
            Side::Upper => Node { x: upper.clone() - &near, from_lower: far, from_upper: near },
        }
    }

    /// Whether x is still distinct from the ends.
    fn is_interior(&self, lower: &R, upper: &R) -> bool {
        let x = self.x.midpoint();
        self.is_normal() && x != lower.midpoint() && x != upper.midpoint()
    }

    /// Whether the distances are still above underflow.
    fn is_normal(&self) -> bool {
        let normal = |distance: &R| distance.clone() * distance.unit_roundoff() != distance.lit(0);
        normal(&self.from_lower) && normal(&self.from_upper)
    }
}

const INTERVAL: Quantity = Quantity::Parameter("the interval of integration");

#[derive(Clone, Copy)]
enum Side {
    Lower,
    Upper,
}

/// δ in (0, 1/2) and dδ/dt at −t for one t > 0: δ is the distance from the nearer end of the unit interval.
struct Abscissa<R> {
    distance: R,
    weight: R,
}

/// The abscissae by level, outwards: t = 1, 2, 3, … at level 0, the odd multiples of 2^−level later.
struct Table<R> {
    levels: Vec<OnceLock<Vec<Abscissa<R>>>>,
    /// The cache that counts the levels as they are filled.
    cache: &'static Cache,
}

impl<R: Real> Stored for Table<R> {
    /// No level is filled yet.
    fn bits(&self) -> usize {
        0
    }
}

impl<R: Real> Table<R> {
    /// An empty table. Level ⌈log₂ bits⌉ suffices for entire integrands; the next two are for nearby singularities.
    fn new(like: &R, cache: &'static Cache) -> Self {
        let levels = u32::BITS - like.precision().leading_zeros() + 3;
        Table { levels: (0..levels).map(|_| OnceLock::new()).collect(), cache }
    }

    fn level(&self, like: &R, level: usize) -> &[Abscissa<R>] {
        self.levels[level].get_or_init(|| {
            let filled = abscissae(like, level as i64);
            self.cache.grown(filled.len() * 2 * like.precision() as usize);
            filled
        })
    }
}

/// The abscissae of one level, until δ ends the exponent range or falls below 2^(−64·bits).
fn abscissae<R: Real>(like: &R, level: i64) -> Vec<Abscissa<R>> {
    let step = like.lit(2).powi(-level);
    let stride = if level == 0 { 1 } else { 2 };
    let one = like.lit(1);
    let reach = like.lit(64 * i64::from(like.precision()));
    let mut found = Vec::new();
    for k in (1..).step_by(stride) {
        // sinh and cosh from e^t − 1, without cancellation at small t.
        let excess = step.clone().times(k).exp_m1();
        let shrunk = excess.clone() / (excess.clone() + &one);
        let sinh = (excess.clone() + &shrunk).over(2);
        let cosh = (excess * shrunk).over(2) + &one;
        let exponent = like.pi() * sinh;
        let decay = (-exponent.clone()).exp();
        let distance = decay.clone() / (decay.clone() + &one);
        if exponent.midpoint() > reach || distance.clone() * like.unit_roundoff() == like.lit(0) {
            break;
        }
        let weight = like.pi() * cosh * &distance / (decay + &one);
        found.push(Abscissa { distance, weight });
    }
    found
}

/// The value of an integrand at a node; `None` where it cannot be evaluated any closer to an end. There are hundreds of integrands, and
/// the rule is compiled once.
type Integrand<'f, R> = &'f mut dyn FnMut(&Node<R>) -> Result<Option<R>>;

/// The integral.
fn integrate<R: Real>(lower: &R, upper: &R, tolerance: Tolerance<R>, f: Integrand<'_, R>) -> Result<Estimate<R>> {
    let width = upper.clone() - lower;
    let zero = width.lit(0);
    if width.midpoint() < zero {
        let mirrored = integrate(upper, lower, tolerance, f)?;
        return Ok(Estimate { value: -mirrored.value, ..mirrored });
    }
    if width.midpoint() == zero {
        return Ok(Estimate::exact(zero));
    }
    let panel = Panel { lower, upper, width };
    let table = RULES.rule(panel.width.precision(), Key::TanhSinh, || Ok(Table::new(&panel.width, &RULES)))?;
    let mut refinement = Refinement::new(tolerance);
    let mut total = panel.centre(f)?;
    let (mut magnitude, mut evaluations) = (total.abs(), 1);
    let mut level = 0;
    loop {
        let mut cut_off = zero.clone();
        for side in [Side::Lower, Side::Upper] {
            let walk = panel.walk(table.level(&panel.width, level), side, f)?;
            total += &sum(&walk.terms, &zero);
            magnitude += &walk.magnitude;
            cut_off += &walk.cut_off;
            evaluations += walk.terms.len();
        }
        let step = panel.width.clone() * zero.lit(2).powi(-(level as i64));
        let scaled = |x: &R| x.clone() * &step;
        let whole = scaled(&magnitude);
        let known = scaled(&cut_off.times(2)) + rounding(&whole, 4);
        let (estimate, converged) = refinement.push(scaled(&total), &whole, &known, evaluations);
        level += 1;
        if converged {
            return Ok(estimate);
        } else if level == table.levels.len() {
            return refinement.exhausted(estimate, &whole);
        }
    }
}

/// The interval of integration.
struct Panel<'a, R> {
    lower: &'a R,
    upper: &'a R,
    width: R,
}

/// The terms of one level on one side, Σ|terms|, and an estimate of the terms cut off at the end of the exponent range.
struct Walk<R> {
    terms: Vec<R>,
    magnitude: R,
    cut_off: R,
}

impl<R: Real> Panel<'_, R> {
    /// The term of the middle.
    fn centre(&self, f: Integrand<'_, R>) -> Result<R> {
        let half = self.width.clone().over(2);
        let value = f(&Node::new(self.lower, self.upper, half.clone(), half, Side::Lower))?;
        let value = value.ok_or_else(|| Error::domain(INTERVAL, &self.width, "wider than a rounding"))?;
        Ok(finite(value)? * self.width.pi().over(4))
    }

    /// Outwards from the middle until both weight and term are below rounding: a small term alone may be a zero of f.
    fn walk(&self, abscissae: &[Abscissa<R>], side: Side, f: Integrand<'_, R>) -> Result<Walk<R>> {
        let Panel { lower, upper, width } = self;
        let roundoff = width.unit_roundoff();
        let mut terms: Vec<R> = Vec::with_capacity(abscissae.len());
        let mut magnitude = width.lit(0);
        for Abscissa { distance, weight } in abscissae {
            let near = width.clone() * distance;
            let far = width.clone() - &near;
            let Some(value) = f(&Node::new(lower, upper, near, far, side))? else { break };
            let term = finite(value)? * weight;
            let size = term.abs();
            magnitude += &size;
            terms.push(term);
            if weight.midpoint() <= roundoff && size.midpoint() <= (magnitude.clone() * &roundoff).midpoint() {
                return Ok(Walk { terms, magnitude, cut_off: width.lit(0) });
            }
        }
        let cut_off = tail(&terms).unwrap_or_else(|| magnitude.clone());
        Ok(Walk { terms, magnitude, cut_off })
    }
}

/// The geometric bound on the terms beyond the last; `None` when they do not decay.
fn tail<R: Real>(terms: &[R]) -> Option<R> {
    let [.., before, last] = terms else { return None };
    let (before, last) = (before.abs().midpoint(), last.abs().midpoint());
    if last == last.lit(0) {
        return Some(last);
    }
    let ratio = last.clone() / before;
    let room = ratio.lit(1) - &ratio;
    if room > room.lit(0) { Some(last * ratio / room) } else { None }
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use super::*;

    /// A level is counted once, when it is filled.
    #[test]
    fn levels_are_counted_when_they_are_filled() {
        static CACHE: LazyLock<Cache> = LazyLock::new(Cache::default);
        let table = Table::new(&1.0, &CACHE);
        assert_eq!(CACHE.bits(), 0);
        let [coarse, finer] = [0, 1].map(|level| table.level(&1.0, level).len());
        assert!(coarse > 0 && finer > 0);
        table.level(&1.0, 0);
        assert_eq!(CACHE.bits(), 2 * 53 * (coarse + finer));
    }
}
