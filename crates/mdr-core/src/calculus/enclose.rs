//! Enclosures of integrals of functions that are analytic piece by piece: Gauss–Legendre rules on pieces, each with a proved
//! bound of its remainder.
//!
//! # The bound
//! Let f be analytic inside the ellipse with the foci m ± h and the sum of half-axes ρh, and |f − c| ≤ M there for a real
//! constant c. The rule of N ≥ 2 nodes on m ± h is off by at most
//!
//! (64/15) M h / ((1 − ρ⁻²) ρ^(2N)).
//!
//! Proof. A constant is integrated exactly, so let c = 0, and h = 1. The Chebyshev coefficients of f obey |a_k| ≤ 2Mρ^−k.
//! The rule is exact up to the degree 2N − 1, and both the integral and the rule of an odd T_k vanish. For even k ≥ 2N ≥ 4
//! they differ by at most 2 + 2/(k² − 1) ≤ 32/15, since the weights are positive with the sum 2. The sum over even k ≥ 2N
//! of (32/15)·2Mρ^−k is the bound. The constant is that of P. Rabinowitz, Comm. ACM 12 (1969) 268; see L. N. Trefethen,
//! SIAM Rev. 50 (2008) 67, theorem 4.5.
//!
//! M is half the diagonal of an enclosure of the image of the ellipse, from [rectangles](crate::number::Rectangle). Where
//! the function is not shown to be analytic on any ellipse, the length times the range is an enclosure, too; a piece for
//! which neither is narrow enough is cut, in the manner of K. Petras, J. Comput. Appl. Math. 145 (2002) 345, and
//! F. Johansson, ICMS 2018, LNCS 10931, 255.

use rug::Float;
use rug::float::Round;

use super::legendre;
use crate::contact::{Error, Quantity, Result};
use crate::number::{Analytic, DoubleInterval, Ends, Interval, Precision, Real, Rectangle};

/// Bits of bounds: of M, of ranges and of remainders, whatever the precision of the nodes. What [is moderate](Integrand::is_moderate)
/// is bounded in doubles.
pub const BOUND_BITS: u32 = 64;

/// Bits of nodes, of values and of sums which are doubles.
pub const DOUBLE_BITS: u32 = f64::MANTISSA_DIGITS;

/// Sums of half-axes of ellipses, over half the distance of the foci; exact in doubles.
const ELLIPSES: [f64; 12] = [1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 32.0, 64.0];
/// The ellipse to begin with.
const FIRST: usize = 5;
/// Where nothing is analytic, the piece at the lower end is cut at this fraction: a singular end stays alone soon.
const AT_END: u32 = 8;

/// Several functions of one variable, real on the real axis, which are integrated together.
pub trait Integrand {
    /// The values at t, or enclosures over a set of t; `None` where one is not defined or not shown to be analytic.
    fn at<T: Analytic>(&self, t: &T) -> Option<Vec<T>>;

    /// Whether its numbers are far from the ends of the range of doubles, in which they may be bounded then.
    fn is_moderate(&self) -> bool {
        false
    }
}

/// Several functions that are integrated together, by what a rule needs of them: their values may come from another formula than
/// the proof that they are analytic. Each [`Integrand`] is one.
pub trait Sampled {
    /// Enclosures of the values at a real t; `None` where one is not defined.
    ///
    /// # Errors
    /// Errors of the computation of the values.
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>>;

    /// Enclosures over a complex set, on which all functions are shown to be analytic; `None` otherwise. In doubles of what
    /// [is moderate](Sampled::is_moderate) alone.
    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>>;

    /// Enclosures over a real interval; `None` where one is not defined.
    fn range(&self, t: &Interval) -> Option<Vec<Interval>>;

    /// The [range](Sampled::range) in doubles, of what [is moderate](Sampled::is_moderate).
    fn range_in_doubles(&self, _t: &DoubleInterval) -> Option<Vec<DoubleInterval>> {
        None
    }

    /// See [`Integrand::is_moderate`].
    fn is_moderate(&self) -> bool {
        false
    }

    /// Whether a value costs so much that a rule takes no more of them than it needs, as where it comes from another formula. Else their
    /// number comes in steps, so that few rules are made, and an integral is mostly better than it has to be, which searches repay.
    fn is_dear(&self) -> bool {
        true
    }
}

impl<F: Integrand> Sampled for F {
    fn values(&self, t: &Interval) -> Result<Option<Vec<Interval>>> {
        Ok(self.at(t))
    }

    fn image<I: Ends>(&self, t: &Rectangle<I>) -> Option<Vec<Rectangle<I>>> {
        self.at(t)
    }

    fn range(&self, t: &Interval) -> Option<Vec<Interval>> {
        self.at(t)
    }

    fn range_in_doubles(&self, t: &DoubleInterval) -> Option<Vec<DoubleInterval>> {
        self.at(t)
    }

    fn is_moderate(&self) -> bool {
        Integrand::is_moderate(self)
    }

    fn is_dear(&self) -> bool {
        false
    }
}

/// What is asked of an integral.
#[derive(Clone, Debug)]
pub struct Goal {
    /// Bits of the nodes, of values and of sums; up to [`DOUBLE_BITS`] they are doubles where these reach.
    pub bits: u32,
    /// The error of the rules to aim at, for each of the functions. An enclosure holds whether or not it is met.
    pub tolerances: Vec<Float>,
    /// The most pieces.
    pub pieces: usize,
}

/// The fewest nodes of a rule.
const FEWEST: usize = 4;
/// Up to so many nodes a rule costs little beside [dear](Sampled::is_dear) values.
const FEW: usize = 64;

/// The logarithm of 10²⁴⁰ to the base 2: functions of such sizes are bounded in doubles.
const MODERATE: i32 = 800;

impl Goal {
    /// Whether all functions, whose sizes tolerances tell, are far from the ends of the range of doubles.
    fn is_moderate(&self) -> bool {
        let is_moderate = |exponent: i32| (exponent + self.bits as i32).abs() < MODERATE;
        self.tolerances.iter().all(|tolerance| tolerance.get_exp().is_some_and(is_moderate))
    }
}

/// The integrals of several functions from `lower` to `upper`. A singular end should be the lower one, at 0.
///
/// ```
/// use mdr_core::calculus::enclose::{Goal, Integrand, enclose};
/// use mdr_core::number::{Analytic, Interval, Precision, Real};
/// use rug::Float;
/// /// 4/(1 + t²), with the integral π over [0, 1].
/// struct Arc;
/// impl Integrand for Arc {
///     fn at<T: Analytic>(&self, t: &T) -> Option<Vec<T>> {
///         let one = t.integer(1);
///         Some(vec![t.integer(4).quotient(&one.plus(&t.squared()))?])
///     }
/// }
/// let goal = Goal { bits: 120, tolerances: vec![Float::with_val(64, 1e-30)], pieces: 100 };
/// let found = enclose(&Arc, [&Float::new(64), &Float::with_val(64, 1)], &goal)?;
/// let pi = Interval::from_int(Precision::new(120), 1).pi();
/// assert!(found[0].overlaps(&pi) && found[0].accuracy_bits() > 98);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Undecided`] when the pieces are spent, when an end of a piece is no longer exact, and where a function is not
/// defined at a node; errors of the values.
pub fn enclose(f: &impl Sampled, [lower, upper]: [&Float; 2], goal: &Goal) -> Result<Vec<Interval>> {
    pieces(f, [lower, upper], goal, |_, remainder| remainder)
}

/// The integrals with the remainders of the rules, by the number of the piece, as `remainder` takes them.
fn pieces(
    f: &impl Sampled,
    [lower, upper]: [&Float; 2],
    goal: &Goal,
    mut remainder: impl FnMut(usize, Float) -> Float,
) -> Result<Vec<Interval>> {
    let open = |what| Error::Undecided { quantity: Quantity::Integral, bits: goal.bits, what };
    let exact = 2 * goal.bits + 64;
    let mut stack =
        vec![Piece { lower: Float::with_val(exact, lower), upper: Float::with_val(exact, upper), ellipse: FIRST }];
    let length = up(&(upper.clone() - lower));
    if length.is_zero() {
        return Ok(vec![Interval::from_int(Precision::new(goal.bits), 0); goal.tolerances.len()]);
    }
    let mut sums = vec![Interval::from_int(Precision::new(goal.bits), 0); goal.tolerances.len()];
    let (mut count, is_moderate) = (0, f.is_moderate() && goal.is_moderate());
    while let Some(piece) = stack.pop() {
        count += 1;
        if count > goal.pieces {
            return Err(open("an integral, in the number of pieces that it may take"));
        }
        let Some([half, middle]) = piece.part(2) else { return Err(open("an integral, near a singular end")) };
        let share: Vec<Float> =
            goal.tolerances.iter().map(|tolerance| Float::with_val(BOUND_BITS, tolerance * &half) / &length).collect();
        let at_end = piece.lower == *lower;
        let aim = Aim {
            tolerances: &share,
            most: goal.bits as usize / 2 + 8,
            exact_to: if f.is_dear() { FEW } else { FEWEST },
        };
        match best_rule(f, is_moderate, [&middle, &half], piece.ellipse, &aim) {
            Some(rule) if rule.nodes <= aim.most => {
                let ends = [&middle, &half];
                let is_rough = goal.bits <= DOUBLE_BITS && is_moderate;
                let in_doubles = if is_rough { rule.sum_in_doubles(f, ends)? } else { None };
                let precision = (Precision::new(goal.bits), goal.bits);
                let values =
                    if in_doubles.is_some() { in_doubles } else { rule.sum(ends, precision, |t| f.values(t))? };
                let values = values.ok_or_else(|| open("an integral, whose integrand is not defined at a node"))?;
                for ((sum, value), bound) in sums.iter_mut().zip(values).zip(&rule.bounds) {
                    let error = remainder(count, error_of_rule(bound, &half, rule.ellipse, rule.nodes));
                    let error = Interval::point(Float::with_val_round(goal.bits, &error, Round::Up).0);
                    *sum += &value.inflate(&error);
                }
            }
            found => {
                let tolerances: Vec<Float> = goal.tolerances.iter().map(|tolerance| tolerance.clone() / 8u32).collect();
                if found.is_none()
                    && let Some(values) = by_range(f, is_moderate, &piece, &tolerances)
                {
                    sums.iter_mut()
                        .zip(values)
                        .for_each(|(sum, value)| *sum += &value.rounded(Precision::new(goal.bits)));
                    continue;
                }
                let fraction = if found.is_none() && at_end { AT_END } else { 2 };
                let Some([_, cut]) = piece.part(fraction) else { return Err(open("an integral, near a singular end")) };
                let ellipse = found.map_or(piece.ellipse, |rule| rule.ellipse);
                stack.push(Piece { lower: cut.clone(), upper: piece.upper, ellipse });
                stack.push(Piece { lower: piece.lower, upper: cut, ellipse });
            }
        }
    }
    Ok(sums)
}

/// A part of the range, with exact ends, and the ellipse that was best for the part it was cut from.
struct Piece {
    lower: Float,
    upper: Float,
    ellipse: usize,
}

impl Piece {
    /// A fraction of the length, and the lower end plus it; `None` once they are no longer exact.
    fn part(&self, fraction: u32) -> Option<[Float; 2]> {
        let bits = self.lower.prec();
        let (length, exact) = Float::with_val_round(bits, &self.upper - &self.lower, Round::Nearest);
        let part = length / fraction;
        let (end, exact_too) = Float::with_val_round(bits, &self.lower + &part, Round::Nearest);
        (exact.is_eq() && exact_too.is_eq()).then_some([part, end])
    }
}

fn up(value: &Float) -> Float {
    Float::with_val_round(BOUND_BITS, value, Round::Up).0
}

/// x op y in the precision of bounds, rounded in one direction.
macro_rules! rounded {
    ($round:ident, $operation:expr) => {
        Float::with_val_round(BOUND_BITS, $operation, Round::$round).0
    };
}

/// A rule on an ellipse on which all functions are analytic.
struct Rule {
    nodes: usize,
    ellipse: usize,
    /// M of each function.
    bounds: Vec<Float>,
}

impl Rule {
    /// h Σ w f over intervals of a context, of which the nodes have so many bits; `None` where a function is not defined.
    fn sum<I: Ends>(
        &self,
        [middle, half]: [&Float; 2],
        (ctx, bits): (I::Ctx, u32),
        values: impl Fn(&I) -> Result<Option<Vec<I>>>,
    ) -> Result<Option<Vec<I>>> {
        let point = |value: &Float| I::around(ctx, &Interval::point(value.clone()));
        let (middle, half) = (point(middle), point(half));
        let mut sums: Option<Vec<I>> = None;
        for (node, weight) in &legendre::rule(self.nodes, bits)?.nodes {
            let (step, weight) = (half.clone() * I::around(ctx, node), I::around(ctx, weight));
            for t in [middle.clone() + &step, middle.clone() - &step] {
                let Some(values) = values(&t)? else { return Ok(None) };
                let terms = values.into_iter().map(|value| value * &weight);
                sums = Some(match sums {
                    None => terms.collect(),
                    Some(sums) => sums.into_iter().zip(terms).map(|(sum, term)| sum + term).collect(),
                });
            }
        }
        Ok(sums.map(|sums| sums.into_iter().map(|sum| sum * &half).collect()))
    }

    /// The sums in doubles; `None` where they do not reach.
    fn sum_in_doubles(&self, f: &impl Sampled, ends: [&Float; 2]) -> Result<Option<Vec<Interval>>> {
        let sums = self.sum(ends, ((), DOUBLE_BITS), |t: &DoubleInterval| Ok(f.range_in_doubles(t)))?;
        let sums = sums.filter(|sums| sums.iter().all(Real::is_finite));
        Ok(sums.map(|sums| widened(&sums, DOUBLE_BITS)))
    }
}

/// Intervals of doubles in so many bits.
fn widened(sums: &[DoubleInterval], bits: u32) -> Vec<Interval> {
    sums.iter().map(|sum| sum.widened(Precision::new(bits))).collect()
}

/// The rule with the fewest nodes: from one ellipse to larger ones while that helps, else to smaller ones; where more than the most
/// are too many, also while it does no harm. No ellipse is larger than one on which a function is not analytic.
fn best_rule(
    f: &impl Sampled,
    is_moderate: bool,
    [middle, half]: [&Float; 2],
    from: usize,
    aim: &Aim<'_>,
) -> Option<Rule> {
    let mut best: Option<Rule> = None;
    let mut consider = |ellipse: usize| {
        let bounds = bounds(f, is_moderate, [middle, half], ELLIPSES[ellipse])?;
        let nodes = aim.nodes(&bounds, half, ELLIPSES[ellipse]);
        // Rules come in steps: a larger ellipse may need as many nodes, and the next one fewer.
        let better = best.as_ref().is_none_or(|best| nodes < best.nodes || nodes == best.nodes && nodes > aim.most);
        if better {
            best = Some(Rule { nodes, ellipse, bounds });
        }
        Some(better)
    };
    let first = consider(from);
    let mut larger = from + 1;
    while first.is_some() && larger < ELLIPSES.len() && consider(larger) == Some(true) {
        larger += 1;
    }
    if first.is_none() || larger == from + 1 {
        for ellipse in (0..from).rev() {
            if consider(ellipse) == Some(false) {
                break;
            }
        }
    }
    best
}

/// M of each function on an ellipse; `None` if one is not shown to be analytic. The upper half of the rectangle around it
/// is enough, as f takes conjugate values at conjugate points.
fn bounds(f: &impl Sampled, is_moderate: bool, [middle, half]: [&Float; 2], rho: f64) -> Option<Vec<Float>> {
    fn diagonals<I: Ends>(images: &[Rectangle<I>]) -> Option<Vec<Float>> {
        images.iter().map(|image| Some(half_diagonal(image)?.most())).collect()
    }
    let ellipse = ellipse(middle, half, rho);
    if is_moderate { diagonals(&f.image(&in_doubles(&ellipse))?) } else { diagonals(&f.image(&ellipse)?) }
}

/// The upper half of a rectangle around an ellipse.
pub(super) fn ellipse(middle: &Float, half: &Float, rho: f64) -> Rectangle {
    // Half-axes rounded up by more than their roundings.
    let axis = |sign: f64| rounded!(Up, half * ((rho + sign / rho) / 2.0 * (1.0 + 1e-7)));
    let [long, short] = [axis(1.0), axis(-1.0)];
    let re = Interval::new(rounded!(Down, middle - &long), rounded!(Up, middle + &long));
    Rectangle::new(re, Interval::new(Float::new(BOUND_BITS), short))
}

/// A rectangle in doubles.
pub(super) fn in_doubles(rectangle: &Rectangle) -> Rectangle<DoubleInterval> {
    Rectangle::new(DoubleInterval::around(rectangle.re()), DoubleInterval::around(rectangle.im()))
}

/// Half the diagonal of a rectangle and its conjugate, as an upper end; `None` if it is not finite.
pub(super) fn half_diagonal<I: Ends>(value: &Rectangle<I>) -> Option<I> {
    let ([left, right], [_, far]) = (value.re().ends(), value.im().abs().ends());
    let bound = (right - left).over(2).hypot(&far);
    bound.is_finite().then_some(bound)
}

/// What is asked of a rule.
struct Aim<'a> {
    /// For each function.
    tolerances: &'a [Float],
    /// The most nodes.
    most: usize,
    /// Up to how many nodes a rule has no more than it needs.
    exact_to: usize,
}

impl Aim<'_> {
    /// Nodes for which the remainders are within tolerances, beyond some in steps of about √2.
    fn nodes(&self, bounds: &[Float], half: &Float, rho: f64) -> usize {
        let bits = bounds.iter().zip(self.tolerances).map(|(bound, tolerance)| {
            let ratio = Float::with_val(BOUND_BITS, bound * half) / tolerance;
            // log₂ 64/15 < 2.1
            let (mantissa, exponent) = ratio.to_f64_exp();
            let beyond = 2.1 - (1.0 - rho.powi(-2)).log2();
            if ratio.is_zero() { 0.0 } else { mantissa.log2() + f64::from(exponent) + beyond }
        });
        let least = (bits.fold(0.0, f64::max) / (2.0 * rho.log2())).ceil().clamp(FEWEST as f64, 1e9);
        let even = |nodes: f64| nodes as usize & !1;
        if least <= self.exact_to as f64 {
            return even(least + 1.0);
        }
        let mut nodes = self.exact_to as f64;
        while (even(nodes) as f64) < least {
            nodes *= std::f64::consts::SQRT_2 * 1.0001;
        }
        even(nodes)
    }
}

/// (64/15) M h/((1 − ρ⁻²)ρ^(2N)), rounded up.
fn error_of_rule(bound: &Float, half: &Float, ellipse: usize, nodes: usize) -> Float {
    let square = Float::with_val(BOUND_BITS, ELLIPSES[ellipse]).square();
    let less = rounded!(Down, &square - 1u32) * 15u32;
    let mut power = Float::with_val(BOUND_BITS, 1);
    for _ in 1..nodes {
        power = rounded!(Down, &power * &square);
    }
    let below = rounded!(Down, &less * &power);
    let above = rounded!(Up, &rounded!(Up, bound * half) * 64u32);
    rounded!(Up, &above / &below)
}

/// Length times range, where that is narrow enough for all functions.
fn by_range(f: &impl Sampled, is_moderate: bool, piece: &Piece, tolerances: &[Float]) -> Option<Vec<Interval>> {
    let over = Interval::new(rounded!(Down, &piece.lower), rounded!(Up, &piece.upper));
    let length = rounded!(Down, &piece.upper - &piece.lower);
    let length = Interval::new(length, rounded!(Up, &piece.upper - &piece.lower));
    let areas = |ranges: Vec<Interval>| {
        let areas = ranges.into_iter().zip(tolerances).map(|(range, tolerance)| {
            let area = range * &length;
            let narrow = area.is_finite() && rounded!(Up, area.upper() - area.lower()) <= *tolerance;
            narrow.then_some(area)
        });
        areas.collect::<Option<Vec<_>>>()
    };
    let in_doubles = if is_moderate { f.range_in_doubles(&DoubleInterval::around(&over)) } else { None };
    in_doubles.and_then(|ranges| areas(widened(&ranges, BOUND_BITS))).or_else(|| areas(f.range(&over)?))
}

#[cfg(test)]
#[path = "../../tests/private/enclose.rs"]
mod tests;
