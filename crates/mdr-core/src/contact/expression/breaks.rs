//! Where a formula is not smooth, and where it ends: searched by enclosures over all radii, so that none is missed.
//!
//! Every function of the grammar is smooth except where an argument passes a certain value: for `abs`, `sqrt`, a
//! logarithm, a denominator or a base this is 0, for `asin`, `acos`, `atanh` ±1, and for `min` and `max` equality of
//! two arguments. These radii are zeros of parts of the formula. A zero of a product is a zero of a factor, and that of
//! a power, a root or an absolute value is one of its base, so that (r − 1)² is searched by a zero with a sign change.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use rug::Float;

use super::onset::Split;
use super::switch::MaybeZero;
use super::{Constant, Expression, ExpressionError, ExpressionProfile, Function, Node, Operator};
use crate::calculus::roots::{self, Bracket};
use crate::number::{Dual, Interval, Literal, Precision, Real, Special};

/// The range of radii, 2^±1000 m. Its ends are no exact zeros of a plausible formula.
pub(super) const SEARCHED: (f64, f64) = (1.06e-301, 1.07e301);
/// Bits of the enclosures.
const BITS: u32 = 128;
/// Bits that resolve 1 − cos r and the like at the smallest radius.
const TIP_BITS: u32 = 8192;
/// Cells wider than this ratio are also evaluated with `TIP_BITS`: they may extend to the tip.
const WIDE: f64 = 256.0;
/// Cells are not halved below this relative width.
const FINEST: f64 = 1e-12;
/// The most cells that are evaluated,
const BUDGET: usize = 20_000;
/// and the most zeros, before the search stops at the radius it has reached.
const MOST: usize = 250;
/// f is compared on both sides of a break at the relative distances 2^−60 and 2^−240,
const CLOSE: [i64; 2] = [60, 240];
/// with so many bits.
const CLOSE_BITS: u32 = 512;

/// Where a formula is not smooth.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Breaks {
    /// By increasing radius, within the profile.
    kinks: Vec<Break>,
    /// The radius where the formula ceases to be a number, or has a pole.
    outer: Option<Break>,
    /// The radius up to which all of them are known; `None` if that is everywhere.
    known_to: Option<f64>,
    /// Powers that begin at radii, taken out of the formula.
    split: Option<Box<Split>>,
}

/// A zero of a part of a formula.
#[derive(Clone, Debug, PartialEq)]
struct Break {
    part: Node<Constant>,
    /// The only zero between these radii.
    within: (f64, f64),
    kind: Kind,
    /// Nearest to it.
    radius: f64,
}

/// The behaviour of a part at its zero.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// A sign change.
    Crossing,
    /// An extremum that is zero to the precision used.
    Touching,
    /// Either of these, or no zero.
    Open,
}

impl Expression {
    /// Where the formula is not smooth, and where it ends, with these values of its parameters.
    ///
    /// # Errors
    /// A parameter without a value, at its column; a formula that jumps; kinks that accumulate at the axis.
    pub fn breaks(&self, values: &BTreeMap<String, Literal>) -> Result<Breaks, ExpressionError> {
        let root = self.with_values(values)?;
        let mut parts = Vec::new();
        collect(&root, &mut parts);
        let mut breaks = Breaks::default();
        let mut end = SEARCHED.1;
        for (node, zeros_of) in parts {
            let (found, known_to) = zeros(&zeros_of, &breaks.kinks, end);
            breaks.kinks.extend(found);
            breaks.kinks.sort_by(|one, other| one.radius.total_cmp(&other.radius));
            breaks.kinks.dedup_by(|one, other| is_near(one.radius, other.radius));
            breaks.known_to = breaks.known_to.into_iter().chain(known_to).reduce(f64::min);
            if let Some(outer) = breaks.end_of(&node) {
                end = breaks.kinks[outer].within.0;
                breaks.outer = Some(breaks.kinks[outer].clone());
                breaks.kinks.truncate(outer);
            }
        }
        let refused = |reason: String| ExpressionError { column: 1, reason };
        if breaks.known_to.is_some_and(|radius| radius < 2.0 * SEARCHED.0) {
            return Err(refused("the formula has kinks without number towards the axis, r -> 0".to_owned()));
        }
        if breaks.known_to.is_some_and(|radius| radius >= end) {
            breaks.known_to = None;
        }
        breaks.cut_at_poles(&root).map_err(|radius| {
            refused(format!("the formula jumps at r = {radius}; the height of a profile is continuous"))
        })?;
        breaks.split = root.split()?.map(Box::new);
        Ok(breaks)
    }
}

impl Breaks {
    /// The radius where the profile ends, to so many bits.
    pub(super) fn outer_radius(&self, bits: u32) -> Option<Float> {
        self.outer.as_ref().map(|end| end.sharpened(bits))
    }

    /// The radii of the kinks to so many bits, each with the interval in which it is the only zero of its part.
    pub(super) fn places(&self, bits: u32) -> Vec<(Float, Interval)> {
        self.kinks.iter().map(|kink| (kink.sharpened(bits), enclosing(kink.within, BITS))).collect()
    }

    /// Powers that begin at radii, and the rest of the formula.
    pub(super) fn split(&self) -> Option<&Split> {
        self.split.as_deref()
    }

    /// The radius up to which all of them are known; `None` if that is everywhere.
    pub(super) fn known_to(&self) -> Option<Float> {
        self.known_to.map(|radius| Float::with_val(BITS, radius))
    }

    /// The break beyond which a part of the formula is not a number.
    fn end_of(&self, node: &Node<Constant>) -> Option<usize> {
        let precision = Precision::new(BITS);
        let node: Node<Float> = node.bound(precision);
        (0..self.kinks.len()).find(|&index| {
            let radius = self.kinks[index].radius;
            let next = self.kinks.get(index + 1).map_or(2.0 * radius, |next| next.radius);
            let beyond = Float::with_val(BITS, radius) + Float::with_val(BITS, next - radius) / 64u32;
            node.value(&beyond).is_nan()
        })
    }

    /// Ends the profile at its first pole.
    ///
    /// # Errors
    /// The first radius at which the formula jumps.
    fn cut_at_poles(&mut self, root: &Node<Constant>) -> Result<(), f64> {
        let precision = Precision::new(CLOSE_BITS);
        let root: Node<Float> = root.bound(precision);
        for (index, kink) in self.kinks.iter().enumerate() {
            let radius = kink.sharpened(CLOSE_BITS);
            let height = |side: i64, bits: i64| {
                let away = radius.lit(2).powi(-bits).times(side) * &radius;
                root.value(&(away + &radius))
            };
            let [far, near] = CLOSE.map(|bits| height(-1, bits));
            if !near.is_finite() || near.clone().abs() > far.abs().times(2) {
                self.outer = Some(kink.clone());
                self.kinks.truncate(index);
                return Ok(());
            }
            let size = near.clone().abs();
            let [far, near] = CLOSE.map(|bits| (height(1, bits) - height(-1, bits)).abs());
            let jumps = near.clone().times(2) > far && near > size >> 100u32;
            if jumps || !near.is_finite() {
                return Err(kink.radius);
            }
        }
        Ok(())
    }
}

impl Break {
    /// The zero in another arithmetic.
    fn in_arithmetic<R: Special>(&self, ctx: R::Ctx) -> R {
        let bits = R::from_int(ctx, 1).precision();
        let digits = bits as usize / 3 + 20;
        let decimal = self.sharpened(bits.saturating_add(64)).to_string_radix(10, Some(digits));
        decimal.parse().map_or_else(|_| R::from_f64(ctx, self.radius), |literal| R::from_literal(ctx, &literal))
    }

    /// The zero to so many bits.
    fn sharpened(&self, bits: u32) -> Float {
        sharpened(&self.part, self.within, self.kind, bits)
    }
}

impl<R: Special> ExpressionProfile<R> {
    /// Sets the kinks of the profile, and the radius where its formula ends.
    pub fn broken_at(self, ctx: R::Ctx, breaks: &Breaks) -> Self {
        let kinks = breaks.kinks.iter().map(|kink| kink.in_arithmetic(ctx)).collect();
        let outer = breaks.outer.as_ref().map(|end| end.in_arithmetic(ctx));
        let known_to = breaks.known_to.map(|radius| R::from_f64(ctx, radius));
        ExpressionProfile { kinks, outer, known_to, ..self }
    }
}

/// The parts of a formula that are not smooth everywhere, each with the subexpression whose zeros matter; inner parts
/// first.
fn collect(node: &Node<Constant>, found: &mut Vec<(Node<Constant>, Node<Constant>)>) {
    let of = |part: &Node<Constant>, found: &mut Vec<_>| {
        let mut parts = Vec::new();
        factors(part, &mut parts);
        found.extend(parts.into_iter().map(|part| (node.clone(), part)));
    };
    match node {
        Node::Variable | Node::Constant(_) => {}
        Node::Negative(x) => collect(x, found),
        Node::Power(x, n) => {
            collect(x, found);
            if *n < 0 {
                of(x, found);
            }
        }
        Node::Operation(operator, a, b) => {
            collect(a, found);
            collect(b, found);
            match operator {
                Operator::Divide => of(b, found),
                Operator::Power => of(a, found),
                Operator::Minimum | Operator::Maximum => {
                    of(&Node::Operation(Operator::Subtract, a.clone(), b.clone()), found);
                }
                Operator::Add | Operator::Subtract | Operator::Multiply => {}
            }
        }
        Node::Function(function, x) => {
            collect(x, found);
            let one = || Box::new(Node::whole(1));
            match function {
                Function::Sqrt | Function::Ln | Function::Log10 | Function::Abs => of(x, found),
                Function::Asin | Function::Acos | Function::Atanh => {
                    of(&Node::Operation(Operator::Subtract, one(), x.clone()), found);
                    of(&Node::Operation(Operator::Add, one(), x.clone()), found);
                }
                Function::Exp | Function::Sin | Function::Cos | Function::Atan => {}
                Function::Sinh | Function::Cosh | Function::Tanh => {}
            }
        }
    }
}

/// Factors that vanish where the whole does, without those that certainly have no zero at r > 0.
fn factors(node: &Node<Constant>, found: &mut Vec<Node<Constant>>) {
    match node {
        Node::Variable | Node::Constant(_) | Node::Power(_, 0) => {}
        Node::Negative(x) | Node::Power(x, _) => factors(x, found),
        Node::Function(Function::Sqrt | Function::Abs | Function::Sinh | Function::Tanh | Function::Atan, x) => {
            factors(x, found);
        }
        Node::Operation(Operator::Power, x, _) => factors(x, found),
        // Where it is nothing all along it is smooth, and where that ends the other one vanishes.
        Node::Operation(Operator::Minimum | Operator::Maximum, a, b) if is_zero(a) => factors(b, found),
        Node::Operation(Operator::Minimum | Operator::Maximum, a, b) if is_zero(b) => factors(a, found),
        Node::Operation(Operator::Multiply | Operator::Divide, a, b) => {
            factors(a, found);
            factors(b, found);
        }
        Node::Operation(Operator::Add | Operator::Subtract, ..) => {
            let shorter = node.powers().and_then(|whole| node.over_lowest_power(&whole));
            found.push(shorter.unwrap_or_else(|| node.clone()));
        }
        other => found.push(other.clone()),
    }
}

pub(super) fn is_zero(node: &Node<Constant>) -> bool {
    matches!(node, Node::Constant(constant) if constant.is_zero())
}

/// Whether two radii are equal to about the precision of doubles.
fn is_near(one: f64, other: f64) -> bool {
    (one - other).abs() <= 4.0 * f64::EPSILON * one.max(other)
}

/// The zeros of a part up to `end`, ascending, and the radius where the search gave up, if it did.
fn zeros(part: &Node<Constant>, known: &[Break], end: f64) -> (Vec<Break>, Option<f64>) {
    let search = Search { part, node: part.bound(Precision::new(BITS)), known };
    let mut found: Vec<Break> = Vec::new();
    let mut cells = vec![(SEARCHED.0, end)];
    let mut budget = BUDGET;
    while let Some(cell) = cells.pop() {
        if budget == 0 || found.len() == MOST {
            return (found, Some(cell.0));
        }
        budget -= 1;
        match search.cell(cell) {
            Some(zeros) => found.extend(zeros),
            None => {
                let middle =
                    if cell.1 > 4.0 * cell.0 { cell.0.sqrt() * cell.1.sqrt() } else { 0.5 * cell.0 + 0.5 * cell.1 };
                cells.extend([(middle, cell.1), (cell.0, middle)]);
            }
        }
    }
    (found, None)
}

struct Search<'a> {
    part: &'a Node<Constant>,
    node: Node<Interval>,
    /// Radii at which parts of this part may not be smooth.
    known: &'a [Break],
}

impl Search<'_> {
    /// The zeros between two radii; `None` if they cannot be determined.
    fn cell(&self, cell: (f64, f64)) -> Option<Vec<Break>> {
        if self.sign_over(cell, cell.1 / cell.0 > WIDE).is_some() {
            return Some(Vec::new());
        }
        let curved = |x: Interval| self.node.value(&Dual::variable(Dual::variable(x))).slope;
        let over = curved(enclosing(cell, BITS));
        let ends = [cell.0, cell.1];
        let signs = ends.map(|radius| self.sign_over((radius, radius), true));
        let monotone = |within: (f64, f64), signs: [Option<Ordering>; 2]| match signs {
            [Some(one), Some(other)] if one == other => Some(Vec::new()),
            [Some(_), Some(_)] => Some(vec![self.zero(within, Kind::Crossing)]),
            _ => None,
        };
        if sign(&over.value).is_some()
            && let Some(zeros) = monotone(cell, signs)
        {
            return Some(zeros);
        }
        if sign(&over.slope).is_some()
            && let [Some(before), Some(after)] =
                ends.map(|radius| sign(&curved(enclosing((radius, radius), BITS)).value))
        {
            return match signs {
                _ if before == after => monotone(cell, signs),
                [Some(first), Some(last)] => self.around_extremum(cell, [first, last]),
                _ => None,
            };
        }
        if cell.1 - cell.0 > FINEST * cell.1 {
            return None;
        }
        if let [Some(first), Some(last)] = signs
            && first != last
        {
            return Some(vec![self.zero(cell, Kind::Crossing)]);
        }
        let is_known =
            self.known.iter().any(|kink| kink.radius / cell.0 - 1.0 < 1e-9 && 1.0 - kink.radius / cell.1 < 1e-9);
        Some(if is_known { Vec::new() } else { vec![self.zero(cell, Kind::Open)] })
    }

    /// The sign of the part between two radii, with more bits where it `matters`.
    fn sign_over(&self, cell: (f64, f64), matters: bool) -> Option<Ordering> {
        let in_more_bits = || {
            let node: Node<Interval> = self.part.bound(Precision::new(TIP_BITS));
            sign(&node.value(&enclosing(cell, TIP_BITS)))
        };
        sign(&self.node.value(&enclosing(cell, BITS))).or_else(|| if matters { in_more_bits() } else { None })
    }

    /// The zeros around the only extremum of the part, which is compared with zero in many bits.
    fn around_extremum(&self, cell: (f64, f64), [first, last]: [Ordering; 2]) -> Option<Vec<Break>> {
        let extremum = sharpened(self.part, cell, Kind::Touching, CLOSE_BITS);
        let width = Float::with_val(CLOSE_BITS, &extremum >> (CLOSE_BITS - 16));
        let near = Interval::point(extremum.clone()).inflate(&Interval::point(width));
        let node: Node<Interval> = self.part.bound(Precision::new(CLOSE_BITS));
        let middle = extremum.to_f64();
        match sign(&node.value(&near)) {
            None => Some(vec![self.zero(cell, Kind::Touching)]),
            Some(sign) if sign == first && sign == last => Some(Vec::new()),
            Some(_) if middle > cell.0 && middle < cell.1 => {
                let crossings = [(cell.0, middle, first), (middle, cell.1, last)];
                let at_middle = self.sign_over((middle, middle), true)?;
                let crossed = crossings.into_iter().filter(|(_, _, end)| *end != at_middle);
                Some(crossed.map(|(lower, upper, _)| self.zero((lower, upper), Kind::Crossing)).collect())
            }
            Some(_) => None,
        }
    }

    fn zero(&self, within: (f64, f64), kind: Kind) -> Break {
        let radius = sharpened(self.part, within, kind, BITS).to_f64();
        Break { part: self.part.clone(), within, kind, radius }
    }
}

/// The interval of all radii between two.
fn enclosing((lower, upper): (f64, f64), bits: u32) -> Interval {
    Interval::new(Float::with_val(bits, lower), Float::with_val(bits, upper))
}

/// The sign of a value that is certainly nonzero.
fn sign(value: &Interval) -> Option<Ordering> {
    value.partial_cmp(&value.lit(0)).filter(|order| *order != Ordering::Equal)
}

/// The zero of a part between two radii, or of its slope where it only touches zero.
fn sharpened(part: &Node<Constant>, (lower, upper): (f64, f64), kind: Kind, bits: u32) -> Float {
    let working = bits.saturating_add(64);
    let node: Node<Float> = part.bound(Precision::new(working));
    let [lower, upper] = [lower, upper].map(|radius| Float::with_val(working, radius));
    let tolerance = Float::with_val(working, 1) >> (bits + 16);
    let root = |f: &dyn Fn(&Float) -> Float| {
        let f = |x: &Float| Ok(f(x));
        let bracket = Bracket::new(&lower, &upper, f).ok().flatten()?;
        roots::refine(bracket, &tolerance, f).ok().map(|root| root.value)
    };
    let found = match kind {
        Kind::Crossing => root(&|x| node.value(x)),
        Kind::Touching => root(&|x| node.value(&Dual::variable(x.clone())).slope),
        Kind::Open => None,
    };
    let middle = || (lower.clone() + &upper) / 2u32;
    Float::with_val(bits, &found.unwrap_or_else(middle))
}
