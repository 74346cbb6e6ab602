//! One rule of Gauss and Legendre on a given piece, for integrands of which a part is known beforehand: what is kept of it at the nodes and
//! on an ellipse around the piece serves many integrals.

use rug::Float;
use rug::float::Round;

use super::enclose::{BOUND_BITS, ellipse, half_diagonal, in_doubles};
use super::legendre;
use crate::contact::Result;
use crate::number::{Analytic, DoubleInterval, Interval, Real, Rectangle};

/// The sum of the half-axes of the ellipse, over half the distance of its foci.
const RHO: f64 = 4.0;
/// Nodes of the rule.
const NODES: usize = 24;
/// The logarithm of ρ^(2N) to the base 2.
const DIGITS: i32 = 4 * NODES as i32;
/// (64/15)/(1 − ρ⁻²) = 1024/225, rounded up.
const FACTOR: f64 = 4.552;

/// A piece of the real line with one rule of 24 nodes.
///
/// ```
/// use mdr_core::calculus::panel::LegendrePanel;
/// use mdr_core::number::{Analytic, DoubleInterval, Real};
/// use rug::Float;
/// // ∫ eᵗ dt over [0, 1], with the bound of its remainder.
/// let panel = LegendrePanel::new(&Float::with_val(64, 0), &Float::with_val(64, 1)).expect("exact ends");
/// let sum = panel.nodes()?.iter().fold(DoubleInterval::point(0.0), |sum, node| sum + Real::exp(&node.t) * node.weight);
/// let remainder = panel.remainder(&Analytic::exp(&panel.ellipse())).expect("bounded");
/// let integral = sum.inflate(&remainder);
/// assert!(integral.lower() < 1_f64.exp() - 1.0 && integral.upper() > 1_f64.exp() - 1.0 && remainder.upper() < 1e-25);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LegendrePanel {
    middle: Float,
    half: Float,
}

/// A node of a rule on a piece.
#[derive(Clone, Debug)]
pub struct LegendreNode {
    /// Its place in the precision of bounds,
    pub place: Interval,
    /// and in doubles.
    pub t: DoubleInterval,
    /// Its weight, times half of the length.
    pub weight: DoubleInterval,
}

impl LegendrePanel {
    /// The piece between two ends; `None` where its middle is not a number in the precision of bounds.
    pub fn new(lower: &Float, upper: &Float) -> Option<Self> {
        let (length, exact) = Float::with_val_round(BOUND_BITS, upper - lower, Round::Nearest);
        let half = length / 2u32;
        let (middle, exact_too) = Float::with_val_round(BOUND_BITS, lower + &half, Round::Nearest);
        (exact.is_eq() && exact_too.is_eq()).then_some(LegendrePanel { middle, half })
    }

    /// The nodes, in pairs about the middle.
    ///
    /// # Errors
    /// Errors of the rule, which are not met.
    pub fn nodes(&self) -> Result<Vec<LegendreNode>> {
        let [middle, half] = [&self.middle, &self.half].map(|value| Interval::point(value.clone()));
        let rule = legendre::rule(NODES, BOUND_BITS)?;
        let pair = |(node, weight): &(Interval, Interval)| {
            let step = half.clone() * node;
            let weight = DoubleInterval::around(&(half.clone() * weight));
            [middle.clone() + &step, middle.clone() - &step].map(|place| {
                let t = DoubleInterval::around(&place);
                LegendreNode { place, t, weight }
            })
        };
        Ok(rule.nodes.iter().flat_map(pair).collect())
    }

    /// The upper half of a rectangle around the ellipse on which [the remainder](LegendrePanel::remainder) asks for the integrand.
    pub fn ellipse(&self) -> Rectangle<DoubleInterval> {
        in_doubles(&ellipse(&self.middle, &self.half, RHO))
    }

    /// The piece.
    pub fn range(&self) -> DoubleInterval {
        let point = |value: &Float| Interval::point(value.clone());
        let [middle, half] = [&self.middle, &self.half].map(point);
        DoubleInterval::around(&middle.inflate(&half))
    }

    /// [−R, R], where R bounds by how much the rule is off for an integrand that is analytic on the ellipse, with this image:
    /// (64/15) M h/((1 − ρ⁻²)ρ^(2N)), as for [`enclose`](super::enclose). `None` where the image is not bounded.
    pub fn remainder(&self, image: &Rectangle<DoubleInterval>) -> Option<DoubleInterval> {
        let half = DoubleInterval::around(&Interval::point(self.half.clone()));
        let bound = half_diagonal(image)? * half * DoubleInterval::point(FACTOR * 2_f64.powi(-DIGITS));
        bound.is_bounded().then(|| DoubleInterval::point(0.0).inflate(&bound))
    }
}

#[cfg(test)]
#[path = "../../tests/private/panel.rs"]
mod tests;
