//! Gauss–Jacobi rules for I[φ] on the whole quarter circle.
//!
//! With s = sinθ, I[φ] = ∫₀¹ s^(p+1) (1−s)^(−1/2) · [s^(−p) (1+s)^(−1/2) φ(xs)] ds. If φ ≈ c rᵖ at the tip and is
//! otherwise analytic, the bracket is analytic around [0, 1]; its nearest singularity is s = −1, and N nodes leave a
//! relative error of about (3+√8)^(−2N): 12 nodes for f64, 0.65 nodes per digit.

use std::sync::OnceLock;

use mdr_core::calculus::{Estimate, gauss_jacobi};
use mdr_core::contact::Result;
use mdr_core::number::Real;

/// A node s and the weight of φ(xs).
#[derive(Clone)]
pub(super) struct Node<R> {
    s: R,
    weight: R,
}

/// The rule with `count` nodes for profiles of tip exponent `p`.
pub(super) fn nodes<R: Real>(p: &R, count: usize) -> Result<Vec<Node<R>>> {
    let rule = gauss_jacobi::rule(count, &p.ratio(-1, 2), &(p.lit(1) + p))?;
    let node = |node: &gauss_jacobi::GaussNode<R>| {
        let s = node.t.clone();
        let smooth = (s.lit(1) + &s).sqrt() * s.pow(p);
        Node { weight: node.weight.clone() / smooth, s }
    };
    Ok(rule.nodes().iter().map(node).collect())
}

/// I[φ] and I[|φ|], with φ(xs) = `sample(s)`.
pub(super) fn sum<R: Real>(nodes: &[Node<R>], zero: R, mut sample: impl FnMut(&R) -> R) -> (R, R) {
    let mut total = zero.clone();
    let mut magnitude = zero;
    for node in nodes {
        let term = sample(&node.s) * &node.weight;
        magnitude += &term.abs();
        total += &term;
    }
    (total, magnitude)
}

/// The rule sizes in units of bits/14 nodes. Power profiles converge at the third, fifty waves at the last.
const RUNGS: [usize; 8] = [1, 2, 3, 6, 12, 24, 48, 96];

/// Rules of increasing size for one tip exponent, computed when first needed.
#[derive(Clone)]
pub(super) struct Ladder<R> {
    p: R,
    /// `None` inside if the rule could not be computed, as for a hundred nodes crowded by p = 1000.
    rungs: [OnceLock<Option<Vec<Node<R>>>>; RUNGS.len()],
}

impl<R: Real> Ladder<R> {
    pub(super) fn new(p: R) -> Self {
        Ladder { p, rungs: Default::default() }
    }

    fn rung(&self, index: usize) -> Option<&[Node<R>]> {
        let unit = self.p.precision().div_ceil(14) as usize;
        self.rungs[index].get_or_init(|| nodes(&self.p, RUNGS[index] * unit).ok()).as_deref()
    }

    /// Increases the rule size until the estimated error is below `tolerance` relative to I[|φ|], or below the absolute
    /// error `needed`, or until it stops decreasing below `attainable`, where `noise` is the relative error of the
    /// samples. `None` if it does not converge: φ is then not of the form this rule is made for. A value at the ends of
    /// the range of the arithmetic is returned with an error as large as itself.
    pub(super) fn integrate(
        &self,
        tolerance: &R,
        attainable: &R,
        needed: &R,
        noise: &R,
        mut sample: impl FnMut(&R) -> R,
    ) -> Option<Estimate<R>> {
        let zero = self.p.lit(0);
        let (mut last, _) = sum(self.rung(0)?, zero.clone(), &mut sample);
        let mut change: Option<R> = None;
        for index in 1..RUNGS.len() {
            let (value, magnitude) = sum(self.rung(index)?, zero.clone(), &mut sample);
            let step = (value.clone() - &last).abs();
            let rounding = (magnitude.unit_roundoff() + noise).times(4) * &magnitude;
            if !value.is_finite() || underflows(&magnitude) {
                return Some(Estimate { error: magnitude, ..Estimate::exact(value) });
            }
            if let Some(before) = change {
                let settled = step.clone().times(4) >= before;
                let goal = if settled { attainable } else { tolerance };
                let remainder = remainder(&before, &step, &magnitude, &rounding);
                // Steps of noise, each negligible.
                let negligible = || Some(before.greater(&step).times(OSCILLATION)).filter(|error| error <= needed);
                let good = |error: &R| *error <= (goal.clone() * &magnitude).greater(needed);
                if let Some(remainder) = remainder.filter(good).or_else(negligible) {
                    return Some(Estimate { error: remainder + rounding, ..Estimate::exact(value) });
                }
            }
            change = Some(step);
            last = value;
        }
        None
    }
}

/// Whether a magnitude is so small, but nonzero, that its terms may have lost digits: below about 10⁻³⁰⁶ in `f64`.
pub(super) fn underflows<R: Real>(magnitude: &R) -> bool {
    let zero = magnitude.lit(0);
    *magnitude != zero && (magnitude.unit_roundoff() * magnitude).over(64) == zero
}

/// Singularities in conjugate pairs make the changes oscillate, and a small one may be chance: errors of twenty times
/// the geometric estimate were observed (a hyperboloid, x ≈ its lateral length, 50 digits).
const OSCILLATION: i64 = 64;

/// The error after the last of two changes. Over equal steps a geometric convergence leaves step²/before; a longer last
/// step leaves less. A step may be small by chance while few nodes sample little of a wave, so its convergence is not
/// taken to be faster than one that began at the magnitude and reached the previous change. `None` if the changes do
/// not at least halve, unless they are rounding.
fn remainder<R: Real>(before: &R, step: &R, magnitude: &R, rounding: &R) -> Option<R> {
    if step <= rounding {
        Some(step.clone())
    } else if step.clone().times(2) <= *before {
        let rate = (step.clone() / before).greater(&(before.clone() / magnitude));
        Some((rate * step).times(OSCILLATION))
    } else {
        None
    }
}
