//! Gauss–Jacobi rules for I[φ] on the whole quarter circle.
//!
//! With s = sinθ, I[φ] = ∫₀¹ s^(p+1) (1−s)^(−1/2) · [s^(−p) (1+s)^(−1/2) φ(xs)] ds. Where φ ≈ c rᵖ at the tip and is otherwise
//! analytic, the bracket is analytic around [0, 1]; its nearest singularity is s = −1, and N nodes leave a relative error
//! of about (3+√8)^(−2N): 12 nodes for f64, 0.65 nodes a digit.

use std::sync::OnceLock;

use mdr_core::calculus::{Estimate, gauss_jacobi};
use mdr_core::contact::Result;
use mdr_core::number::Real;

/// A node s and the weight of φ(xs).
pub(super) struct Node<R> {
    s: R,
    weight: R,
}

/// The rule with `count` nodes for profiles of tip exponent `p`.
pub(super) fn nodes<R: Real>(p: &R, count: usize) -> Result<Vec<Node<R>>> {
    let rule = gauss_jacobi::rule(count, &p.ratio(-1, 2), &(p.lit(1) + p))?;
    let node = |node: &gauss_jacobi::Node<R>| {
        let s = node.t.clone();
        let smooth = (s.lit(1) + &s).sqrt() * s.pow(p);
        Node { weight: node.weight.clone() / smooth, s }
    };
    Ok(rule.nodes().iter().map(node).collect())
}

/// I[φ] and I[|φ|], `sample(s)` being φ(xs), and the number of nodes.
pub(super) fn sum<R: Real>(
    nodes: &[Node<R>],
    zero: R,
    mut sample: impl FnMut(&R) -> Result<R>,
) -> Result<(R, R, usize)> {
    let mut total = zero.clone();
    let mut magnitude = zero;
    for node in nodes {
        let term = sample(&node.s)? * &node.weight;
        magnitude += &term.abs();
        total += &term;
    }
    Ok((total, magnitude, nodes.len()))
}

/// The rungs in units of bits/14 nodes. Power profiles are settled by the third, fifty waves by the last.
const RUNGS: [usize; 8] = [1, 2, 3, 6, 12, 24, 48, 96];

/// Rules of growing size for one tip exponent, made when first needed.
pub(super) struct Ladder<R> {
    p: R,
    rungs: [OnceLock<Vec<Node<R>>>; RUNGS.len()],
}

impl<R: Real> Ladder<R> {
    pub(super) fn new(p: R) -> Self {
        Ladder { p, rungs: Default::default() }
    }

    fn rung(&self, index: usize) -> Result<&[Node<R>]> {
        if self.rungs[index].get().is_none() {
            let made = nodes(&self.p, RUNGS[index] * self.p.precision().div_ceil(14) as usize)?;
            // Another thread may have been faster; its rule is the same.
            let _ = self.rungs[index].set(made);
        }
        Ok(self.rungs[index].get().map_or(&[], Vec::as_slice))
    }

    /// Climbs until the estimated error is below `tolerance` relative to I[|φ|], the samples themselves being known to
    /// the relative `noise`. None when it gives up: then φ is not of the form this rule is made for.
    pub(super) fn integrate(
        &self,
        tolerance: &R,
        noise: &R,
        mut sample: impl FnMut(&R) -> Result<R>,
    ) -> Result<Option<Estimate<R>>> {
        let zero = self.p.lit(0);
        let (mut last, _, mut evaluations) = sum(self.rung(0)?, zero.clone(), &mut sample)?;
        let mut change: Option<R> = None;
        for index in 1..RUNGS.len() {
            let (value, magnitude, count) = sum(self.rung(index)?, zero.clone(), &mut sample)?;
            evaluations += count;
            let step = (value.clone() - &last).abs();
            let rounding = (magnitude.unit_roundoff() + noise).times(4) * &magnitude;
            let remainder = change.and_then(|before| remainder(&before, &step, &rounding));
            if let Some(remainder) = remainder.filter(|error| *error <= tolerance.clone() * &magnitude) {
                return Ok(Some(Estimate { value, error: remainder + rounding, evaluations }));
            }
            change = Some(step);
            last = value;
        }
        Ok(None)
    }
}

/// What is left after the last of two changes. Over equal steps a geometric convergence leaves step²/before; a longer last
/// step leaves less. Nothing is believed where the changes do not at least halve, unless they are rounding.
fn remainder<R: Real>(before: &R, step: &R, rounding: &R) -> Option<R> {
    if step <= rounding {
        Some(step.clone())
    } else if step.clone().times(2) <= *before {
        Some(step.clone() / before * step)
    } else {
        None
    }
}
