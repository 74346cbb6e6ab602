//! What jumps at a break of a formula, and whether several of its arguments change their signs at one radius.

use rug::Rational;
use rug::ops::Pow;

use super::enclosed::combined;
use super::{Constant, Function, Node, Operator};
use crate::number::{Analytic, Euler, Interval, Real};

/// Exact numbers of more bits are not computed,
const MOST_EXACT_BITS: u32 = 1 << 14;
/// and no higher powers.
const MOST_EXACT_POWER: i32 = 64;

/// The arguments of `abs`, `min` and `max` that change their signs at a break.
pub(super) struct Switch {
    arguments: Vec<Argument>,
}

/// The argument u of `abs(u)`, or the difference of those of `min` and `max`.
struct Argument {
    /// Over enclosures of its constants,
    node: Node<Interval>,
    /// and without the switches in it that have a sign at the break.
    settled: Node<Interval>,
    /// With its constants as they are written.
    exact: Node<Constant>,
    /// Its sign before the break.
    is_positive: bool,
}

impl Switch {
    /// At a cell with one break, from radii on both sides; `None` if a sign is not decided.
    pub(super) fn at(
        root: &Node<Constant>,
        tree: &Node<Interval>,
        cell: &Interval,
        beside: &[Option<Interval>],
    ) -> Option<Switch> {
        let [Some(before), Some(after)] = beside else { return None };
        let (mut nodes, mut exact) = (Vec::new(), Vec::new());
        tree.switches(&mut nodes);
        root.switches(&mut exact);
        let mut arguments: Vec<Argument> = Vec::new();
        for (node, exact) in nodes.into_iter().zip(exact) {
            let signs = [is_positive(&node, before)?, is_positive(&node, after)?];
            if signs[0] != signs[1] {
                if !arguments.iter().any(|known| known.node.is_same(&node)) {
                    arguments.push(Argument { settled: node.settled(cell), node, exact, is_positive: signs[0] });
                }
            } else if node.value(cell).contains_zero() {
                // It may touch zero.
                return None;
            }
        }
        Some(Switch { arguments })
    }

    /// Whether there is one argument, or all of them vanish at one rational radius in an interval that holds a zero of each.
    pub(super) fn is_at_one_radius(&self, tight: &Interval) -> bool {
        let [_, _, ..] = &self.arguments[..] else { return true };
        let Some(radius) = simplest(tight) else { return false };
        self.arguments.iter().all(|argument| argument.exact.rational(&radius).is_some_and(|value| value == 0))
    }

    /// Whether all arguments change their signs within a tight interval of a cell, and nowhere else in the cell.
    pub(super) fn is_only_within(&self, cell: &Interval, tight: &Interval) -> bool {
        self.arguments.iter().all(|Argument { settled: node, is_positive: before, .. }| {
            let Some(over) = node.analytic(&Euler::variable(cell, 1)) else { return false };
            let ends = [tight.lower(), tight.upper()].map(|end| is_positive(node, &Interval::point(end.clone())));
            !over.derivative(1).contains_zero() && ends == [Some(*before), Some(!*before)]
        })
    }
}

/// Derivatives on both sides of a break.
pub(super) struct Sides {
    before: Euler<Interval>,
    after: Euler<Interval>,
    /// Up to this order they are the same numbers.
    smooth: usize,
}

impl Sides {
    fn smooth(value: Euler<Interval>) -> Self {
        Sides { smooth: value.order(), before: value.clone(), after: value }
    }

    /// A function of one or two numbers with derivatives that are continuous up to an order.
    fn of(before: Euler<Interval>, after: Euler<Interval>, mut smooth: usize) -> Self {
        // Numbers that are exactly equal, such as zeros.
        while smooth < before.order() && before.derivative(smooth + 1) == after.derivative(smooth + 1) {
            smooth += 1;
        }
        Sides { before, after, smooth }
    }

    /// What jumps: exactly nothing where both sides are the same.
    pub(super) fn jump(&self) -> Option<Vec<Interval>> {
        let at = |k: usize| {
            let [before, after] = [&self.before, &self.after].map(|side| side.derivative(k));
            if k <= self.smooth { before.lit(0) } else { after - before }
        };
        let jumps: Vec<Interval> = (0..=self.before.order()).map(at).collect();
        jumps.iter().all(Real::is_finite).then_some(jumps)
    }
}

/// The sign of a part of a formula at a radius, if it is certain.
pub(super) fn is_positive(node: &Node<Interval>, radius: &Interval) -> Option<bool> {
    let value = node.value(radius);
    match (*value.lower() > 0, *value.upper() < 0) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    }
}

impl Node<Interval> {
    /// Whether both are written in the same way. (Enclosures that are no points are not equal, as numbers.)
    fn is_same(&self, other: &Node<Interval>) -> bool {
        match (self, other) {
            (Node::Variable, Node::Variable) => true,
            (Node::Constant(a), Node::Constant(b)) => a.is_same(b),
            (Node::Negative(x), Node::Negative(y)) => x.is_same(y),
            (Node::Power(x, n), Node::Power(y, k)) => n == k && x.is_same(y),
            (Node::Function(f, x), Node::Function(g, y)) => f == g && x.is_same(y),
            (Node::Operation(f, a, b), Node::Operation(g, c, d)) => f == g && a.is_same(c) && b.is_same(d),
            _ => false,
        }
    }

    /// Without the switches in it whose arguments have a certain sign over a cell of radii.
    fn settled(&self, cell: &Interval) -> Node<Interval> {
        if let Some(positive) = self.switch().and_then(|argument| is_positive(&argument, cell)) {
            return self.switched(positive).settled(cell);
        }
        self.with_inner(|x| x.settled(cell))
    }

    /// What a switch is where its argument has a sign.
    pub(super) fn switched(&self, positive: bool) -> Node<Interval> {
        let signed = |x: &Node<Interval>| if positive { x.clone() } else { Node::Negative(Box::new(x.clone())) };
        match self {
            Node::Function(_, x) => match &**x {
                Node::Power(base, 2) if matches!(self, Node::Function(Function::Sqrt, _)) => signed(base),
                x => signed(x),
            },
            Node::Operation(operator, a, b) => {
                let first = positive == (*operator == Operator::Maximum);
                if first { (**a).clone() } else { (**b).clone() }
            }
            other => other.clone(),
        }
    }

    /// The derivatives on both sides of a break.
    pub(super) fn sides(&self, r: &Euler<Interval>, switch: &Switch) -> Option<Sides> {
        if let Some(argument) = self.switch() {
            return self.switched_sides(&argument, r, switch);
        }
        Some(match self {
            Node::Variable => Sides::smooth(r.clone()),
            Node::Constant(constant) => Sides::smooth(r.constant(constant)),
            Node::Operation(Operator::Power, x, exponent) if exponent.is_constant() => {
                let x = x.sides(r, switch)?;
                Sides::of(self.unary(&x.before)?, self.unary(&x.after)?, x.smooth)
            }
            Node::Operation(operator, a, b) => {
                let (a, b) = (a.sides(r, switch)?, b.sides(r, switch)?);
                let side = |a: &Euler<Interval>, b: &Euler<Interval>| combined(*operator, a, b);
                Sides::of(side(&a.before, &b.before)?, side(&a.after, &b.after)?, a.smooth.min(b.smooth))
            }
            Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => {
                let x = x.sides(r, switch)?;
                Sides::of(self.unary(&x.before)?, self.unary(&x.after)?, x.smooth)
            }
        })
    }

    /// The derivatives on both sides of a break where a switch has an argument that may be zero there.
    fn switched_sides(&self, argument: &Node<Interval>, r: &Euler<Interval>, switch: &Switch) -> Option<Sides> {
        let Some(known) = switch.arguments.iter().find(|known| known.node.is_same(argument)) else {
            return self.switched(is_positive(argument, r.value())?).sides(r, switch);
        };
        let signs = [known.is_positive, !known.is_positive];
        let [before, after] = signs.map(|positive| self.switched(positive).sides(r, switch));
        let (before, after) = (before?.before, after?.after);
        let value = match self {
            Node::Function(..) => r.value().lit(0),
            _ => before.value().intersect(after.value())?,
        };
        Some(Sides::of(before.with_value(value.clone()), after.with_value(value), 0))
    }
}

/// A constant of a formula, in any of its forms.
pub(super) trait MaybeZero: Clone {
    /// Whether it is certainly zero.
    fn is_zero(&self) -> bool;
}

impl MaybeZero for Interval {
    fn is_zero(&self) -> bool {
        *self == self.lit(0)
    }
}

impl MaybeZero for Constant {
    fn is_zero(&self) -> bool {
        matches!(self, Constant::Literal(literal) if literal.is_zero())
    }
}

impl<C: MaybeZero> Node<C> {
    /// The arguments whose signs matter: of `abs`, of the root of a square, and the differences of those of `min` and `max`.
    fn switches(&self, found: &mut Vec<Node<C>>) {
        if let Some(argument) = self.switch() {
            found.push(argument);
        }
        match self {
            Node::Variable | Node::Constant(_) => {}
            Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => x.switches(found),
            Node::Operation(_, a, b) => {
                a.switches(found);
                b.switches(found);
            }
        }
    }

    pub(super) fn switch(&self) -> Option<Node<C>> {
        match self {
            Node::Function(Function::Abs, x) => Some((**x).clone()),
            Node::Function(Function::Sqrt, x) => match &**x {
                Node::Power(base, 2) => Some((**base).clone()),
                _ => None,
            },
            // max(u, 0) switches where u does, as another switch by u beside it.
            Node::Operation(Operator::Minimum | Operator::Maximum, a, b) => Some(match &**b {
                Node::Constant(zero) if zero.is_zero() => (**a).clone(),
                _ => Node::Operation(Operator::Subtract, a.clone(), b.clone()),
            }),
            _ => None,
        }
    }
}

impl Node<Constant> {
    /// The exact value at a rational radius; `None` of what is irrational, not defined, or large.
    fn rational(&self, r: &Rational) -> Option<Rational> {
        let value = match self {
            Node::Variable => r.clone(),
            Node::Constant(Constant::Literal(literal)) => literal.to_rational(),
            Node::Constant(_) => return None,
            Node::Negative(x) => -x.rational(r)?,
            Node::Power(x, n) => {
                let n = i32::try_from(*n).ok().filter(|n| n.abs() <= MOST_EXACT_POWER)?;
                let x = x.rational(r)?;
                if n < 0 && x == 0 {
                    return None;
                }
                x.pow(n)
            }
            Node::Function(Function::Abs, x) => x.rational(r)?.abs(),
            Node::Function(..) => return None,
            Node::Operation(operator, a, b) => {
                let (a, b) = (a.rational(r)?, b.rational(r)?);
                match operator {
                    Operator::Add => a + b,
                    Operator::Subtract => a - b,
                    Operator::Multiply => a * b,
                    Operator::Divide if b != 0 => a / b,
                    Operator::Minimum => a.min(b),
                    Operator::Maximum => a.max(b),
                    Operator::Divide | Operator::Power => return None,
                }
            }
        };
        (value.denom().significant_bits() <= MOST_EXACT_BITS && value.numer().significant_bits() <= MOST_EXACT_BITS)
            .then_some(value)
    }
}

/// The rational number with the least denominator in an interval of positive radii.
fn simplest(within: &Interval) -> Option<Rational> {
    let [mut low, mut high] = [within.lower().to_rational()?, within.upper().to_rational()?];
    let mut quotients = Vec::new();
    loop {
        let whole = low.clone().floor();
        // A whole number in it ends the fraction.
        if low == whole || Rational::from(&whole + 1u32) <= high {
            quotients.push(if low == whole { whole } else { whole + 1u32 });
            break;
        }
        [low, high] = [(high - &whole).recip(), (low - &whole).recip()];
        quotients.push(whole);
    }
    quotients.into_iter().rev().reduce(|tail, quotient| quotient + tail.recip())
}
