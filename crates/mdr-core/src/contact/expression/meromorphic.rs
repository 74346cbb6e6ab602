//! Formulas such as (1 − cos r)/r, whose quotients by powers of r are analytic at the axis and are not seen to be.

use super::{Constant, Node, Operator};
use crate::number::Literal;

impl Node<Constant> {
    /// The formula without its divisions by powers of r; `None` if there are none.
    ///
    /// Only sums and products lead to them. Where this formula is analytic, the one with the divisions is too but for r = 0, where it has
    /// a pole, or none; it has none if it tends to 0 there, as every profile does.
    pub(super) fn cleared(&self) -> Option<Node<Constant>> {
        let both = |operator: Operator, a: &Node<Constant>, b: &Node<Constant>| {
            let cleared = [a.cleared(), b.cleared()];
            if cleared.iter().all(Option::is_none) {
                return None;
            }
            let [left, right] = cleared;
            let part = |cleared: Option<Node<Constant>>, plain: &Node<Constant>| {
                Box::new(cleared.unwrap_or_else(|| plain.clone()))
            };
            Some(Node::Operation(operator, part(left, a), part(right, b)))
        };
        match self {
            Node::Power(base, n) if *n < 0 && **base == Node::Variable => Some(one()),
            Node::Power(base, n) if *n > 0 => Some(Node::Power(Box::new(base.cleared()?), *n)),
            Node::Negative(inner) => Some(Node::Negative(Box::new(inner.cleared()?))),
            Node::Operation(Operator::Divide, a, b) if b.is_power_of_radius() => {
                Some(a.cleared().unwrap_or_else(|| (**a).clone()))
            }
            Node::Operation(Operator::Divide, a, b) => {
                Some(Node::Operation(Operator::Divide, Box::new(a.cleared()?), b.clone()))
            }
            Node::Operation(operator @ (Operator::Add | Operator::Subtract | Operator::Multiply), a, b) => {
                both(*operator, a, b)
            }
            _ => None,
        }
    }

    /// Whether it is a positive integer power of r, times a number.
    fn is_power_of_radius(&self) -> bool {
        let sum = self.powers().unwrap_or_default();
        sum.len() == 1 && sum.keys().all(|n| *n > 0 && n.is_integer())
    }
}

fn one() -> Node<Constant> {
    Node::Constant(Constant::Literal(Literal::from(1)))
}
