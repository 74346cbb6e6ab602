//! What enclosures prove of the shape of a formula, without an integral: whether its transform g falls nowhere, and where
//! f is lowest.
//!
//! With r = x sin θ the transform is g(x) = x ∫ f'(r) dθ over (0, π/2), and g'(x) = ∫ (r f')' dθ. So g falls nowhere where
//! r f' does not: f' + r f'' ≥ 0 on cells that cover all radii, and f' jumps upwards at every kink. Separated surfaces
//! first touch at min f, which is isolated by bisection with f, f' and f'' on each cell. Nothing is proved of a formula that
//! overflows the exponents of MPFR at some radius, such as cosh r.

use std::collections::BTreeMap;

use rug::Float;

use super::breaks::SEARCHED;
use super::{Breaks, Constant, Expression, ExpressionError, Function, Node, Operator};
use crate::number::{Dual, Interval, Lift, Literal, Precision, Real};

/// Bits of the enclosures.
const BITS: u32 = 192;
/// The most cells that are evaluated for each of the two proofs.
const BUDGET: usize = 12_000;
/// Cells are not halved below this many bits of their radius; closer to the outer radius none is looked at.
const FINEST: u32 = 120;

/// What is proved of the shape of a formula.
#[derive(Clone, Debug)]
pub struct FormulaShape {
    /// Whether g falls nowhere, so that every state of a contact is admissible. If not, it may fall or not.
    pub rises: bool,
    /// The lowest point of f.
    pub lowest: Lowest,
}

/// The lowest point of a profile with f(0) = 0.
#[derive(Clone, Debug)]
pub enum Lowest {
    /// f ≥ 0: the tip.
    Tip,
    /// One ring, where f < 0.
    Ring(LowestRing),
    /// It is not known where.
    Open {
        /// A bound: f is nowhere smaller; −∞ if there is none.
        at_least: f64,
    },
}

/// The ring on which a formula has its least value.
#[derive(Clone, Debug)]
pub struct LowestRing {
    root: Node<Constant>,
    /// The only minimum between these radii.
    within: (Float, Float),
}

impl Expression {
    /// The shape of the formula with these values of its parameters, of which the breaks are known: for radii from
    /// 10^−301 to 10^301, or to the outer radius.
    ///
    /// # Errors
    /// As [`Expression::bind`].
    pub fn shape(&self, values: &BTreeMap<String, Literal>, breaks: &Breaks) -> Result<FormulaShape, ExpressionError> {
        let root = self.with_values(values)?;
        let outer = breaks.outer_radius(BITS);
        let end = outer.clone().unwrap_or_else(|| Float::with_val(BITS, SEARCHED.1));
        let cells = Cells { root: root.bound(Precision::new(BITS)), end, bounded: outer.is_some() };
        let rises = cells.rise();
        // r f' does not fall and begins at zero, so f rises from the tip.
        let lowest = if rises { Lowest::Tip } else { cells.lowest(&root) };
        Ok(FormulaShape { rises, lowest })
    }
}

impl LowestRing {
    /// The radius and the height of the ring, rounded to the arithmetic.
    pub fn at<R: Real>(&self, ctx: R::Ctx) -> [R; 2] {
        let bits = R::from_int(ctx, 1).precision().saturating_add(64).max(BITS);
        let node: Node<Interval> = self.root.bound(Precision::new(bits));
        let within = [&self.within.0, &self.within.1].map(|end| Float::with_val(bits, end));
        let [lower, upper] = sharpened(&node, within, bits - 16);
        let radius = (lower + upper) / 2u32;
        let height: Node<Float> = self.root.bound(Precision::new(2 * bits));
        let height = height.value(&Float::with_val(2 * bits, &radius));
        [radius, height].map(|number| {
            let decimal = number.to_string_radix(10, Some(bits as usize / 3));
            decimal.parse().map_or_else(|_| R::from_f64(ctx, number.to_f64()), |literal| R::from_literal(ctx, &literal))
        })
    }
}

/// A minimum of a formula between two radii, the derivative negative at the lower one and positive at the upper one, to
/// so many bits.
fn sharpened(node: &Node<Interval>, [mut lower, mut upper]: [Float; 2], bits: u32) -> [Float; 2] {
    let fine = |lower: &Float, upper: &Float| Float::with_val(lower.prec(), upper - lower) <= upper.clone() >> bits;
    while !fine(&lower, &upper) {
        let middle = Float::with_val(lower.prec(), &lower + &upper) / 2u32;
        let slope = Jet::at(node, &Interval::point(middle.clone())).slope;
        if *slope.upper() < 0 {
            lower = middle;
        } else if *slope.lower() > 0 {
            upper = middle;
        } else {
            break;
        }
    }
    [lower, upper]
}

/// A formula on all radii.
struct Cells {
    root: Node<Interval>,
    end: Float,
    /// Whether the profile ends there.
    bounded: bool,
}

/// What is known of the least value on a cell.
enum Found {
    /// It is not less than at the tip, at a point that was evaluated, or on a neighbour.
    Nothing,
    /// A minimum inside, and the only one.
    Minimum,
    /// A smaller cell may tell.
    Halve,
    /// The profile falls to its end: no smaller cell tells.
    Open,
}

impl Cells {
    fn all(&self) -> Vec<(Float, Float)> {
        vec![(Float::with_val(BITS, SEARCHED.0), self.end.clone())]
    }

    /// Two halves of a cell; none of one that is as fine as cells become.
    fn halves(&self, (lower, upper): &(Float, Float)) -> Option<[(Float, Float); 2]> {
        let width = Float::with_val(BITS, upper - lower);
        if width <= upper.clone() >> FINEST {
            return None;
        }
        let middle = if *upper > lower.clone() * 4u32 {
            lower.clone().sqrt() * upper.clone().sqrt()
        } else {
            // Off the middle, so that an extremum at a round number is not at the end of a cell.
            lower.clone() + width * 0.492_613f64
        };
        Some([(middle.clone(), upper.clone()), (lower.clone(), middle)])
    }

    /// Whether r f' is proved not to fall.
    fn rise(&self) -> bool {
        let mut cells = self.all();
        for _ in 0..BUDGET {
            let Some(cell) = cells.pop() else { return true };
            let r = Interval::new(cell.0.clone(), cell.1.clone());
            // (r f')'; an operation outside of its domain leaves the entire line, whose lower end is −∞.
            let change_of = |jet: &Jet, r: &Interval| jet.slope.clone() + jet.curvature.clone() * r;
            let jet = Jet::at(&self.root, &r);
            let change = change_of(&jet, &r);
            if *change.lower() >= 0 && jet.bend.is_upward() {
                continue;
            }
            let middle = r.midpoint();
            let at_middle = Jet::at(&self.root, &middle);
            let change = change_of(&at_middle, &middle);
            if *change.upper() < 0 {
                return false;
            }
            match self.halves(&cell) {
                Some(halves) => cells.extend(halves),
                // Only the last piece before the outer radius is left out.
                None if self.bounded && cell.1 == self.end => {}
                None => return false,
            }
        }
        false
    }

    fn lowest(&self, root: &Node<Constant>) -> Lowest {
        let mut least = Float::new(BITS);
        let mut open: Vec<Float> = Vec::new();
        let mut minima: Vec<([Float; 2], Interval)> = Vec::new();
        let mut cells = self.all();
        let mut budget = BUDGET;
        while let Some(cell) = cells.pop() {
            if budget == 0 {
                return Lowest::Open { at_least: f64::NEG_INFINITY };
            }
            budget -= 1;
            let (found, height) = self.cell(&cell, &mut least);
            match found {
                Found::Nothing => {}
                Found::Open => open.push(height.lower().clone()),
                Found::Halve => match self.halves(&cell) {
                    Some(halves) => cells.extend(halves),
                    None => open.push(height.lower().clone()),
                },
                Found::Minimum => {
                    let [lower, upper] = sharpened(&self.root, [cell.0, cell.1], FINEST);
                    let r = Interval::new(lower.clone(), upper.clone());
                    let height = Jet::at(&self.root, &r).mean_value(&self.root, &r);
                    let at_middle = Jet::at(&self.root, &r.midpoint()).height;
                    least.min_mut(at_middle.upper());
                    minima.push(([lower, upper], height));
                }
            }
        }
        open.retain(|height| *height <= least);
        minima.retain(|(_, height)| *height.lower() <= least && *height.lower() < 0);
        match (open.as_slice(), minima.as_slice()) {
            ([], []) => Lowest::Tip,
            ([], [([lower, upper], _)]) if least < 0 => {
                Lowest::Ring(LowestRing { root: root.clone(), within: (lower.clone(), upper.clone()) })
            }
            _ => {
                let lower = minima.iter().map(|(_, height)| height.lower()).chain(&open);
                let at_least = lower.fold(f64::INFINITY, |least, height| least.min(height.to_f64()));
                // The next double below.
                Lowest::Open { at_least: if at_least.is_finite() { at_least.next_down() } else { f64::NEG_INFINITY } }
            }
        }
    }

    /// What is known of the least value on a cell, and an enclosure of f there; `least` is a value that f attains or
    /// exceeds somewhere.
    fn cell(&self, (lower, upper): &(Float, Float), least: &mut Float) -> (Found, Interval) {
        let r = Interval::new(lower.clone(), upper.clone());
        let jet = Jet::at(&self.root, &r);
        let at_middle = Jet::at(&self.root, &r.midpoint()).height;
        if at_middle.is_finite() {
            least.min_mut(at_middle.upper());
        }
        let height = jet.mean_value(&self.root, &r);
        // A value at the end of all radii has no neighbour.
        let last = *upper == self.end;
        let found = if *height.lower() >= 0 || *height.lower() > *least || *jet.slope.lower() > 0 {
            Found::Nothing
        } else if *jet.slope.upper() < 0 {
            if last { Found::Open } else { Found::Nothing }
        } else {
            let convex = jet.curvature.is_finite() && *jet.curvature.lower() > 0 && jet.bend.is_upward();
            let at_kink = jet.bend.is_upward() && self.halves(&(lower.clone(), upper.clone())).is_none();
            if convex || at_kink {
                let [first, end] = [lower, upper].map(|r| Jet::at(&self.root, &Interval::point(r.clone())).slope);
                let rises = *first.lower() > 0;
                match (*first.upper() < 0, *end.lower() > 0) {
                    (true, true) => Found::Minimum,
                    _ if rises || *end.upper() < 0 && !last => Found::Nothing,
                    _ => Found::Halve,
                }
            } else {
                Found::Halve
            }
        };
        (found, height)
    }
}

/// The direction in which f' jumps at the kinks of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Bend {
    Smooth,
    Upwards,
    Downwards,
    Either,
}

impl Bend {
    fn is_upward(self) -> bool {
        matches!(self, Bend::Smooth | Bend::Upwards)
    }

    /// That of a sum.
    fn with(self, other: Bend) -> Bend {
        match (self, other) {
            (Bend::Smooth, bend) | (bend, Bend::Smooth) => bend,
            (one, other) if one == other => one,
            _ => Bend::Either,
        }
    }

    /// That of a multiple by some number of an interval.
    fn times(self, factor: &Interval) -> Bend {
        match self {
            Bend::Smooth => Bend::Smooth,
            bend if *factor.lower() >= 0 => bend,
            Bend::Upwards if *factor.upper() <= 0 => Bend::Downwards,
            Bend::Downwards if *factor.upper() <= 0 => Bend::Upwards,
            _ => Bend::Either,
        }
    }

    fn reversed(self) -> Bend {
        match self {
            Bend::Upwards => Bend::Downwards,
            Bend::Downwards => Bend::Upwards,
            other => other,
        }
    }
}

/// A number with its first and second derivative.
type Twice = Dual<Dual<Interval>>;

/// Enclosures of f, f' and f'' on a cell, f'' without what a jump of f' adds.
struct Jet {
    height: Interval,
    slope: Interval,
    curvature: Interval,
    bend: Bend,
}

impl Jet {
    fn at(node: &Node<Interval>, r: &Interval) -> Jet {
        let (twice, bend) = node.bent(&Dual::variable(Dual::variable(r.clone())));
        Jet { height: twice.value.value, slope: twice.value.slope, curvature: twice.slope.slope, bend }
    }

    /// f on the cell, by the mean value theorem where that is narrower.
    fn mean_value(&self, node: &Node<Interval>, r: &Interval) -> Interval {
        if !self.slope.is_finite() {
            return self.height.clone();
        }
        let middle = r.midpoint();
        let by_slope = node.value(&middle) + self.slope.clone() * (r.clone() - &middle);
        self.height.intersect(&by_slope).unwrap_or_else(|| self.height.clone())
    }
}

impl Node<Interval> {
    /// The value with two derivatives, one-sided ones of both sides at a kink, and how the first jumps there.
    fn bent(&self, r: &Twice) -> (Twice, Bend) {
        match self {
            Node::Variable => (r.clone(), Bend::Smooth),
            Node::Constant(constant) => (Twice::lift(constant), Bend::Smooth),
            Node::Negative(x) => negative(x.bent(r)),
            Node::Power(x, n) => through(x.bent(r), |x| x.powi(*n), |x| x.powi(*n).slope),
            Node::Function(Function::Abs, x) => magnitude(x.bent(r)),
            Node::Function(Function::Sqrt, x) if matches!(&**x, Node::Power(_, 2)) => match &**x {
                Node::Power(base, _) => magnitude(base.bent(r)),
                _ => through(x.bent(r), |x| x.sqrt(), |x| x.sqrt().slope),
            },
            Node::Function(function, x) => through(x.bent(r), |x| function.apply(x), |x| function.apply(x).slope),
            Node::Operation(Operator::Power, base, n) if matches!(&**base, Node::Variable) && n.is_constant() => {
                (power(r, &n.value(&r.value.value)), Bend::Smooth)
            }
            Node::Operation(operator, a, b) => operation(*operator, a.bent(r), b.bent(r)),
        }
    }
}

impl<C> Node<C> {
    fn is_constant(&self) -> bool {
        match self {
            Node::Variable => false,
            Node::Constant(_) => true,
            Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => x.is_constant(),
            Node::Operation(_, a, b) => a.is_constant() && b.is_constant(),
        }
    }
}

/// rⁿ, its derivatives as powers of r: narrower than by the chain rule.
fn power(r: &Twice, n: &Interval) -> Twice {
    let r = &r.value.value;
    let less = |k: i64| r.pow(&(n.clone() - n.lit(k)));
    let slope = less(1) * n;
    let curvature = less(2) * n * (n.clone() - n.lit(1));
    Dual { value: Dual { value: r.pow(n), slope: slope.clone() }, slope: Dual { value: slope, slope: curvature } }
}

fn negative((x, bend): (Twice, Bend)) -> (Twice, Bend) {
    (-x, bend.reversed())
}

fn magnitude(x: (Twice, Bend)) -> (Twice, Bend) {
    let other = negative(x.clone());
    greater(x, other)
}

/// A smooth function, with its derivative.
fn through(
    (x, bend): (Twice, Bend),
    function: impl Fn(&Twice) -> Twice,
    derivative: impl Fn(&Dual<Interval>) -> Interval,
) -> (Twice, Bend) {
    let bend =
        if bend == Bend::Smooth { bend } else { bend.times(&derivative(&Dual::variable(x.value.value.clone()))) };
    (function(&x), bend)
}

/// The greater of two; where either may be, an enclosure of both, and the slope jumps upwards.
fn greater((x, bend): (Twice, Bend), (y, other): (Twice, Bend)) -> (Twice, Bend) {
    let (left, right) = (&x.value.value, &y.value.value);
    if left < right {
        (y, other)
    } else if left > right {
        (x, bend)
    } else {
        let bend = if bend.is_upward() && other.is_upward() { Bend::Upwards } else { Bend::Either };
        let mut both = x.either(&y);
        both.value.value = left.greater(right);
        (both, bend)
    }
}

fn operation(operator: Operator, (x, bend): (Twice, Bend), (y, other): (Twice, Bend)) -> (Twice, Bend) {
    let (left, right) = (x.value.value.clone(), y.value.value.clone());
    match operator {
        Operator::Add => (x + y, bend.with(other)),
        Operator::Subtract => (x - y, bend.with(other.reversed())),
        Operator::Multiply => (x * y, bend.times(&right).with(other.times(&left))),
        Operator::Divide => {
            let turned = if other == Bend::Smooth { Bend::Smooth } else { Bend::Either };
            (x / y, bend.times(&right).with(turned))
        }
        Operator::Power => {
            let bend = if bend.with(other) == Bend::Smooth { Bend::Smooth } else { Bend::Either };
            (x.pow(&y), bend)
        }
        Operator::Maximum => greater((x, bend), (y, other)),
        Operator::Minimum => negative(greater(negative((x, bend)), negative((y, other)))),
    }
}
