//! One rule of Gauss and Legendre on a given piece, for integrands of which a part is known beforehand: what is kept of it at the nodes and
//! on an ellipse around the piece serves many integrals.

use rug::Float;
use rug::float::Round;

use super::enclose::{BOUND_BITS, ellipse, half_diagonal, in_doubles};
use super::legendre;
use crate::contact::Result;
use crate::number::{Analytic, DoubleInterval, Interval, Precision, Real, Rectangle};

/// The sum of the half-axes of the ellipse, over half the distance of its foci.
const RHO: f64 = 4.0;
/// The logarithm of ρ² to the base 2: bits that each node gains.
const GAIN: u32 = 4;
/// Bits that a rule gains beyond those that it is made for.
const SPARE: u32 = 32;
/// The most bits of a rule, whose gain is a normal double.
const MOST: u32 = 900;
/// (64/15)/(1 − ρ⁻²) = 1024/225, rounded up.
const FACTOR: f64 = 4.552;

/// A piece of the real line with one rule, of 24 nodes for 64 bits.
///
/// ```
/// use mdr_core::calculus::panel::LegendrePanel;
/// use mdr_core::number::{Analytic, DoubleInterval, Interval, Precision, Real};
/// use rug::Float;
/// // ∫ eᵗ dt over [0, 1], with the bound of its remainder.
/// let panel = LegendrePanel::new(&Float::with_val(64, 0), &Float::with_val(64, 1), 100).expect("exact ends");
/// let sum = panel.nodes()?.iter().fold(Interval::from_int(Precision::new(100), 0), |sum, node| {
///     sum + Real::exp(&node.place) * &node.weight
/// });
/// let remainder = panel.remainder(&Analytic::exp(&panel.ellipse())).expect("bounded");
/// let integral = sum.inflate(&remainder.widened(Precision::new(100)));
/// let truth = Real::exp(&integral.lit(1)) - integral.lit(1);
/// assert!(integral.overlaps(&truth) && integral.accuracy_bits() > 90);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct LegendrePanel {
    middle: Float,
    half: Float,
    bits: u32,
}

/// A node of a rule on a piece.
#[derive(Clone, Debug)]
pub struct LegendreNode {
    /// Its place,
    pub place: Interval,
    /// and its weight, times half of the length.
    pub weight: Interval,
}

impl LegendrePanel {
    /// The piece between two ends, with a rule for so many bits or those of bounds; `None` where its middle is not a number in the
    /// precision of bounds, and where the bits are more than 900.
    pub fn new(lower: &Float, upper: &Float, bits: u32) -> Option<Self> {
        let bits = bits.max(BOUND_BITS);
        let (length, exact) = Float::with_val_round(BOUND_BITS, upper - lower, Round::Nearest);
        let half = length / 2u32;
        let (middle, exact_too) = Float::with_val_round(BOUND_BITS, lower + &half, Round::Nearest);
        (exact.is_eq() && exact_too.is_eq() && bits <= MOST).then_some(LegendrePanel { middle, half, bits })
    }

    /// How many nodes there are.
    fn count(&self) -> u32 {
        (self.bits + SPARE).div_ceil(2 * GAIN) * 2
    }

    /// The nodes, in pairs about the middle.
    ///
    /// # Errors
    /// Errors of the rule, which are not met.
    pub fn nodes(&self) -> Result<Vec<LegendreNode>> {
        let precision = Precision::new(self.bits);
        let [middle, half] = [&self.middle, &self.half].map(|value| Interval::point(value.clone()).rounded(precision));
        let rule = legendre::rule(self.count() as usize, self.bits)?;
        let pair = |(node, weight): &(Interval, Interval)| {
            let (step, weight) = (half.clone() * node, half.clone() * weight);
            [middle.clone() + &step, middle.clone() - &step].map(|place| LegendreNode { place, weight: weight.clone() })
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
        let gained = 2_f64.powi(-((GAIN * self.count()) as i32));
        let bound = half_diagonal(image)? * half * DoubleInterval::point(FACTOR * gained);
        bound.is_bounded().then(|| DoubleInterval::point(0.0).inflate(&bound))
    }
}

#[cfg(test)]
#[path = "../../tests/private/panel.rs"]
mod tests;
