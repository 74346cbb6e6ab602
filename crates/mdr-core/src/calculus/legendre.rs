//! Gauss–Legendre rules whose nodes and weights are proved enclosures.

use std::sync::Arc;

use rug::Float;
use rug::float::Round;

use super::cache::{Key, RULES, Stored};
use crate::contact::{Error, Quantity, Result};
use crate::number::{Interval, Precision, Real};

/// Bits of bounds.
const LOW: u32 = 64;
/// Newton steps at few bits, before their number is doubled.
const EARLY: u32 = 4;

/// The rule of an even number of nodes on [−1, 1].
pub(super) struct Rule {
    /// The positive nodes, descending, with their weights; −x has the weight of x.
    pub(super) nodes: Vec<(Interval, Interval)>,
}

impl Stored for Rule {
    fn bits(&self) -> usize {
        self.nodes.iter().map(|(node, _)| 4 * node.lower().prec() as usize).sum()
    }
}

/// The rule with n nodes, n even, in so many bits: from the store of the process, or computed.
///
/// # Errors
/// [`Error::Undecided`] if a node cannot be isolated, which is not met.
pub(super) fn rule(n: usize, bits: u32) -> Result<Arc<Rule>> {
    RULES.rule(bits, Key::Legendre { n }, || build(n, bits))
}

/// (P_(n−1), P_n)(x) by the three-term recurrence, rounded to nearest at `bits` bits, |x| ≤ 1.
///
/// Both are off by at most 4(n+1)(n+2) 2^−bits. Proof: the errors obey (k+1)e_(k+1) = (2k+1)x e_k − k e_(k−1) + (k+1)δ_k
/// with |δ_k| ≤ 16·2^−bits, the rounding of one step. Their generating function is E = L ∫ D L with L = Σ P_k z^k, and
/// |P_k| ≤ 1 gives the majorant 8·2^−bits/(1−z)³ of E. Compare F. Johansson and M. Mezzarobba, SIAM J. Sci. Comput. 40
/// (2018) C726.
fn legendre(n: usize, x: &Float, bits: u32) -> (Float, Float) {
    let (mut before, mut last) = (Float::with_val(bits, 1), Float::with_val(bits, x));
    for k in 1..n as u32 {
        let mut next = Float::with_val(bits, x * &last);
        next *= 2 * k + 1;
        before *= k;
        next -= &before;
        next /= k + 1;
        before = std::mem::replace(&mut last, next);
    }
    (before, last)
}

/// Completeness: each interval holds a zero of P_n, the n/2 intervals are disjoint and positive, and P_n has n/2 positive
/// zeros.
fn build(n: usize, bits: u32) -> Result<Rule> {
    let precision = Precision::new(bits);
    let size = usize::BITS - n.leading_zeros();
    let working = bits + 4 * size + 24;
    let radius = Float::with_val(LOW, Float::i_exp(1, -((bits + 2 * size + 8) as i32)));
    let mut nodes: Vec<(Interval, Interval)> = Vec::with_capacity(n / 2);
    for index in 0..n / 2 {
        let found = isolated(&newton(n, index, working), n, &radius, working);
        let found = found.filter(|(node, _)| {
            let last = nodes.last().map_or_else(|| node.lit(1), |(last, _): &(Interval, Interval)| last.clone());
            *node.lower() > 0 && *node < last
        });
        let Some((node, weight)) = found else {
            return Err(Error::Undecided { quantity: Quantity::Integral, bits, what: "where the nodes of a rule lie" });
        };
        nodes.push((node, weight));
    }
    let nodes = nodes.into_iter().map(|(node, weight)| (node.rounded(precision), weight.rounded(precision))).collect();
    Ok(Rule { nodes })
}

/// A zero of P_n by Newton's method, counted from 1 downwards; nothing is proved of it.
fn newton(n: usize, index: usize, working: u32) -> Float {
    let size = usize::BITS - n.leading_zeros();
    let guess = (std::f64::consts::PI * (index as f64 + 0.75) / (n as f64 + 0.5)).cos();
    let mut x = Float::with_val(64, guess);
    let (mut bits, mut steps) = (64 + 2 * size, 0);
    while bits < working || steps <= EARLY {
        if steps >= EARLY {
            bits = (2 * bits - 4 * size - 8).min(working);
        }
        steps += 1;
        x.set_prec(bits);
        let (before, last) = legendre(n, &x, bits);
        let slope = (before - Float::with_val(64, &x * &last)) * n as u32;
        x -= last * (1 - Float::with_val(bits, x.square_ref())) / slope;
    }
    x
}

/// The zero of P_n within a radius ε of x, and its weight 2(1 − x²)/(n P_(n−1))²; `None` if it is not proved.
///
/// P_n' = n(P_(n−1) − xP_n)/(1 − x²) at x, and on x ± ε it moves by less than εn⁴/4 (Markov); a zero is there if |P_n| is
/// smaller than ε times the least slope. |P_(n−1)'| ≤ n² bounds the weight.
fn isolated(x: &Float, n: usize, radius: &Float, working: u32) -> Option<(Interval, Interval)> {
    let order = i32::try_from(n).ok()?;
    let rounding = Float::with_val(LOW, Float::i_exp(4 * (order + 1) * (order + 2), -(working as i32)));
    let up = |value: Float, by: &Float| Float::with_val_round(LOW, &value * by, Round::Up).0;
    let (before, last) = legendre(n, x, working);
    let exact = Interval::point(Float::with_val(working, x));
    let [one, radius] = [exact.lit(1), Interval::point(Float::with_val(working, radius))];
    let rounding = Interval::point(Float::with_val(working, &rounding));
    let [before, last] = [before, last].map(|value| Interval::point(value).inflate(&rounding));
    let count = exact.lit(i64::from(order));
    let slope = (before.clone() - exact.clone() * &last) * &count / (one.clone() - exact.square());
    let moved = up(Float::with_val(LOW, n).square().square(), radius.upper());
    let least = slope.abs() - Interval::point(Float::with_val(working, &moved));
    let node = exact.clone().inflate(&radius);
    if !(*least.lower() > 0 && last.abs() < least * &radius && *node.upper() < 1) {
        return None;
    }
    let before = before.inflate(&(radius * count.square())) * count;
    let weight = (one - node.square()).times(2) / before.square();
    weight.is_finite().then_some((node, weight))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The moments 2/(k+1) of even powers below the degree of exactness, and the sum of the weights.
    #[test]
    fn rules_are_exact_on_polynomials() {
        for (n, bits) in [(4, 24), (8, 64), (22, 64), (32, 115), (64, 214), (90, 712)] {
            let rule = rule(n, bits).unwrap();
            assert_eq!(rule.nodes.len(), n / 2);
            for power in [0, 2, n as i64, 2 * n as i64 - 2] {
                let terms = rule.nodes.iter().map(|(node, weight)| node.powi(power) * weight);
                let sum = terms.reduce(|sum, term| sum + term).unwrap().times(2);
                let moment = sum.lit(2).over(power + 1);
                assert!(
                    sum.overlaps(&moment) && sum.accuracy_bits() > i64::from(bits) - 14,
                    "{n} {bits} {power} {sum}"
                );
            }
        }
    }
}
