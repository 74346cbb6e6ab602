//! Enclosures of a formula on a cell of radii, with its first and second derivative, across kinks as well.

use super::{Function, Node, Operator};
use crate::number::{Dual, Interval, Lift, Real};

/// The direction in which f' jumps at the kinks of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    Smooth,
    Upwards,
    Downwards,
    Either,
}

impl Bend {
    pub(super) fn is_upward(self) -> bool {
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
pub(super) struct Jet {
    pub(super) height: Interval,
    pub(super) slope: Interval,
    pub(super) curvature: Interval,
    pub(super) bend: Bend,
}

impl Jet {
    pub(super) fn at(node: &Node<Interval>, r: &Interval) -> Jet {
        let (twice, bend) = node.bent(&Dual::variable(Dual::variable(r.clone())));
        Jet { height: twice.value.value, slope: twice.value.slope, curvature: twice.slope.slope, bend }
    }

    /// f on the cell, by the mean value theorem where that is narrower.
    pub(super) fn mean_value(&self, node: &Node<Interval>, r: &Interval) -> Interval {
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
    pub(super) fn is_constant(&self) -> bool {
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
