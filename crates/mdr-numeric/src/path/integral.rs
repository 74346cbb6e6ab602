//! Integrals over contact radii of functions that are smooth between folds and singular at kinks and at the tip.

use mdr_core::calculus::{
    Estimate, Tolerance, gauss_jacobi,
    quadrature::{pieces, tanh_sinh},
    roundoff_tolerance,
};
use mdr_core::contact::{Error, Result, Transform};
use mdr_core::number::{Real, order};

/// The most halvings of a piece that does not converge: oscillations without folds, thousands in one piece.
const HALVINGS: u32 = 12;

/// Folds per piece, two per wave: one rule of about a hundred nodes costs a tenth of as many small rules.
const FOLDS: usize = 16;
/// Nodes per piece for the magnitude of an integral.
const NODES: usize = 8;

/// The radii where an integrand is not smooth.
pub(super) struct Breaks<R> {
    /// Radii where g or a derivative of it jumps, ascending.
    kinks: Vec<R>,
    /// All radii where a piece should end, ascending.
    ends: Vec<R>,
    /// Where the profile ends, if it does: g may diverge there as a logarithm.
    outer: Option<R>,
}

impl<R: Real> Breaks<R> {
    /// Pieces end at the kinks, and in between at folds: at all if they are few, at some if many, to bound the waves
    /// per piece.
    pub(super) fn new(transform: &dyn Transform<R>, folds: impl ExactSizeIterator<Item = R>) -> Self {
        let kinks = transform.kinks();
        let stride = if folds.len() > 2 * FOLDS { FOLDS } else { 1 };
        let mut ends: Vec<R> = kinks.iter().cloned().chain(folds.step_by(stride)).collect();
        ends.sort_by(order);
        // A kink may be a fold.
        ends.dedup();
        Breaks { kinks, ends, outer: transform.outer_radius() }
    }

    /// The relative distance of a radius from the nearest kink, at most one.
    pub(super) fn clearance(&self, a: &R) -> R {
        let next = self.kinks.partition_point(|kink| kink <= a);
        let distance = |kink: &R| (a.clone() - kink).abs() / a;
        let nearest = self.kinks[next.saturating_sub(1)..].iter().take(2).map(distance);
        nearest.fold(a.lit(1), |least, distance| if distance < least { distance } else { least })
    }

    /// ∫ f(a) da from one radius to another, using only breaks between them.
    pub(super) fn integrate(&self, from: &R, to: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<Estimate<R>> {
        let goal = roundoff_tolerance(from).times(4);
        let tolerance = Tolerance::new(&goal).or_noise_below(from.unit_roundoff().sqrt());
        match self.by_pieces(from, to, |lower, upper| self.piece([lower, upper], &tolerance, HALVINGS, &mut f)) {
            // Over a short piece the terms of f may cancel all but for rounding, which is nothing beside the whole.
            Err(error @ Error::NoConvergence { .. }) => {
                let whole = self.roughly(from, to, |a| Ok(f(a)?.abs())).map_err(|_| error)?.abs();
                let negligible = tolerance.clone().or_error_below(&(goal * whole));
                self.by_pieces(from, to, |lower, upper| self.piece([lower, upper], &negligible, HALVINGS, &mut f))
            }
            result => result,
        }
    }

    /// The magnitude of ∫ f(a) da of a positive f, by one small rule per piece.
    pub(super) fn roughly(&self, from: &R, to: &R, mut f: impl FnMut(&R) -> Result<R>) -> Result<R> {
        let zero = from.lit(0);
        let rule = gauss_jacobi::rule(NODES, &zero, &zero)?;
        let size = self.by_pieces(from, to, |lower, upper| {
            let width = upper.clone() - lower;
            let value = rule.integrate(|s| f(&off_tip(&(s.clone() * &width + lower), upper)))? * width;
            Ok(Estimate { value, error: zero.clone(), evaluations: NODES })
        })?;
        Ok(size.value)
    }

    /// The sum of integrals over the pieces between two radii.
    fn by_pieces(&self, from: &R, to: &R, integral: impl FnMut(&R, &R) -> Result<Estimate<R>>) -> Result<Estimate<R>> {
        let (lower, upper) = if from < to { (from, to) } else { (to, from) };
        let first = self.ends.partition_point(|end| end <= lower);
        let inside = &self.ends[first..self.ends.partition_point(|end| end < upper).max(first)];
        let mut total = pieces(lower, upper, inside, integral)?;
        if from > to {
            total.value = -total.value;
        }
        Ok(total)
    }

    /// One piece; if it does not converge, its two halves. Towards the end of the profile pieces become shorter with the
    /// distance from it.
    fn piece(
        &self,
        [lower, upper]: [&R; 2],
        tolerance: &Tolerance<R>,
        halvings: u32,
        f: &mut impl FnMut(&R) -> Result<R>,
    ) -> Result<Estimate<R>> {
        let middle =
            if wide(lower, upper) { (lower.ln() + upper.ln()).over(2).exp() } else { (lower.clone() + upper).over(2) };
        if let Some(middle) = self.towards_end(lower, upper) {
            return pieces(lower, upper, &[middle], |a, b| self.piece([a, b], tolerance, halvings, f));
        }
        match self.rule(lower, upper, tolerance, f) {
            Err(Error::NoConvergence { .. }) if halvings > 0 && middle > *lower && middle < *upper => {
                pieces(lower, upper, &[middle], |a, b| self.piece([a, b], tolerance, halvings - 1, f))
            }
            result => result,
        }
    }

    /// A radius within a piece that comes much closer to the end of the profile than it is long.
    fn towards_end(&self, lower: &R, upper: &R) -> Option<R> {
        let outer = self.outer.as_ref()?;
        let [far, near] = [lower, upper].map(|a| outer.clone() - a);
        let middle = outer.clone() - (far.clone() * &near).sqrt();
        (wide(&near, &far) && middle > *lower && middle < *upper).then_some(middle)
    }

    /// Gauss–Legendre; beside a kink b, where g' may have an inverse root, in s with a = b + s²(upper − b). At the tip,
    /// and if that does not converge beside a kink or over decades, tanh-sinh.
    fn rule(
        &self,
        lower: &R,
        upper: &R,
        tolerance: &Tolerance<R>,
        f: &mut impl FnMut(&R) -> Result<R>,
    ) -> Result<Estimate<R>> {
        let (zero, width) = (lower.lit(0), upper.clone() - lower);
        let tolerance = resolved(tolerance, upper, &width);
        let kink = self.kink_beside(lower, &width).filter(|kink| *kink <= lower);
        if *lower > zero {
            let result = match kink {
                Some(kink) => from_kink(kink, [lower, upper], &tolerance, f),
                None => gauss_jacobi::integrate(&zero, &zero, tolerance.clone(), |s| f(&(s.clone() * &width + lower)))
                    .map(|estimate| estimate.scaled(&width)),
            };
            let hard = || kink.is_some() || self.kink_beside(upper, &width).is_some() || wide(lower, upper);
            match result {
                Err(Error::NoConvergence { .. }) if hard() => {}
                result => return result,
            }
        }
        tanh_sinh(lower, upper, tolerance, |a| f(&off_tip(a, upper)))
    }

    /// The kink nearest to an end of a piece, if its distance does not exceed the length of the piece.
    fn kink_beside(&self, end: &R, width: &R) -> Option<&R> {
        let next = self.kinks.partition_point(|kink| kink <= end);
        let distance = |kink: &&R| ((*kink).clone() - end).abs();
        let near = self.kinks[next.saturating_sub(1)..].iter().take(2).filter(|kink| distance(kink) <= *width);
        near.min_by(|one, other| order(&distance(one), &distance(other)))
    }
}

/// The integral in s with a = b + s²(upper − b), from a kink b or slightly beyond it.
fn from_kink<R: Real>(
    kink: &R,
    [lower, upper]: [&R; 2],
    tolerance: &Tolerance<R>,
    f: &mut impl FnMut(&R) -> Result<R>,
) -> Result<Estimate<R>> {
    let zero = lower.lit(0);
    let reach = upper.clone() - kink;
    let first = ((lower.clone() - kink) / &reach).sqrt();
    let length = first.lit(1) - &first;
    let estimate = gauss_jacobi::integrate(&zero, &zero, tolerance.clone(), |t| {
        let a = (t.clone() * &length + &first).square() * &reach + kink;
        // s at the rounded radius, at which the root is evaluated.
        let s = ((a.clone() - kink) / &reach).sqrt();
        Ok(f(&a)? * s.times(2))
    })?;
    Ok(estimate.scaled(&(length * &reach)))
}

/// The tolerance for a piece that is short relative to its radii: the rounding of the radii, and with them of the
/// integrand, is a larger fraction of its length.
fn resolved<R: Real>(tolerance: &Tolerance<R>, upper: &R, width: &R) -> Tolerance<R> {
    /// The roundings of a radius that a rule may accumulate.
    const ROUNDINGS: i64 = 64;
    let noise = upper.unit_roundoff() * upper / width;
    let limit = noise.clone().times(ROUNDINGS);
    if limit > upper.unit_roundoff().sqrt() {
        tolerance.clone().with_noise(&noise).or_noise_below(limit)
    } else {
        tolerance.clone().with_noise(&noise)
    }
}

/// A radius bounded away from the tip by rounding: closer to it powers of a leave the range of the arithmetic.
fn off_tip<R: Real>(a: &R, upper: &R) -> R {
    let least = upper.unit_roundoff() * upper;
    if *a > least { a.clone() } else { least }
}

/// Whether a piece is so long that power laws are not smooth on it.
fn wide<R: Real>(lower: &R, upper: &R) -> bool {
    *lower > lower.lit(0) && *upper > lower.clone().times(8)
}
