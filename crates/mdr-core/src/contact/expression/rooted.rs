//! Formulas in a root q = r^(1/k) of the radius, in which fractional powers of r are analytic at the axis.

use rug::Rational;

use super::powers::{Sum, number};
use super::{Constant, Function, Node, Operator};
use crate::number::Literal;

/// The largest order of a root.
const ORDER: u32 = 128;

impl Node<Constant> {
    /// The formula in q = r^(1/k), with the least k > 1 for which no fractional power of r is left; `None` if there is no such
    /// power, or none of a small order.
    pub(super) fn in_root(&self) -> Option<(u32, Node<Constant>)> {
        let mut order = 1;
        self.collect_orders(&mut order)?;
        if order == 1 { None } else { Some((order, self.rooted(order)?)) }
    }

    /// Multiplies `order` until it is a multiple of the denominators of all powers of r; `None` beyond the largest.
    fn collect_orders(&self, order: &mut u32) -> Option<()> {
        let mut include = |n: &Rational| {
            let all = rug::Integer::from(n.denom().lcm_u_ref(*order)).to_u32().filter(|all| *all <= ORDER)?;
            *order = all;
            Some(())
        };
        if let Some((base, exponent)) = self.fractional() {
            let (lowest, _) = base.first_key_value()?;
            include(&(lowest.clone() * &exponent))?;
            return base.keys().try_for_each(|n| include(&(n.clone() - lowest)));
        }
        match self {
            Node::Variable | Node::Constant(_) => Some(()),
            Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => x.collect_orders(order),
            Node::Operation(_, a, b) => {
                a.collect_orders(order)?;
                b.collect_orders(order)
            }
        }
    }

    /// A sum of powers of r, and the exponent of a fractional power of it.
    fn fractional(&self) -> Option<(Sum, Rational)> {
        let (base, exponent) = match self {
            Node::Function(Function::Sqrt, base) => (base, Rational::from((1, 2))),
            Node::Operation(Operator::Power, base, exponent) => (base, number(&exponent.powers()?)?),
            _ => return None,
        };
        let base = base.powers().filter(|base| base.keys().any(|n| *n != 0))?;
        (!exponent.is_integer()).then_some((base, exponent))
    }

    fn rooted(&self, k: u32) -> Option<Node<Constant>> {
        if let Some((base, exponent)) = self.fractional() {
            // (Σ c rⁿ)^e = q^(k m e) (Σ c q^(k(n − m)))^e, where m is the least n.
            let lowest = base.first_key_value()?.0.clone();
            let rest = base.into_iter().map(|(n, c)| (n - &lowest, c)).collect();
            let factor = power(&(lowest * &exponent), k)?;
            let exponent = Box::new(constant(&exponent)?);
            let rest = Node::Operation(Operator::Power, Box::new(polynomial(rest, k)?), exponent);
            return Some(Node::Operation(Operator::Multiply, Box::new(factor), Box::new(rest)));
        }
        let inner = |x: &Node<Constant>| x.rooted(k).map(Box::new);
        Some(match self {
            Node::Variable => Node::Power(Box::new(Node::Variable), i64::from(k)),
            Node::Constant(value) => Node::Constant(value.clone()),
            Node::Negative(x) => Node::Negative(inner(x)?),
            Node::Power(x, n) if matches!(**x, Node::Variable) => power(&Rational::from(*n), k)?,
            Node::Power(x, n) => Node::Power(inner(x)?, *n),
            Node::Function(function, x) => Node::Function(*function, inner(x)?),
            Node::Operation(operator, a, b) => Node::Operation(*operator, inner(a)?, inner(b)?),
        })
    }
}

pub(super) fn literal(value: &Rational) -> Option<Literal> {
    value.to_string().parse().ok()
}

fn constant(value: &Rational) -> Option<Node<Constant>> {
    literal(value).map(|literal| Node::Constant(Constant::Literal(literal)))
}

/// q^(kn).
fn power(n: &Rational, k: u32) -> Option<Node<Constant>> {
    let exponent = Rational::from(n * k);
    let exponent = exponent.is_integer().then(|| exponent.numer().to_i64()).flatten()?;
    Some(Node::Power(Box::new(Node::Variable), exponent))
}

/// Σ c q^(kn).
fn polynomial(sum: Sum, k: u32) -> Option<Node<Constant>> {
    let mut terms = sum.iter().map(|(n, c)| {
        let factor = constant(c)?;
        if *n == 0 {
            return Some(factor);
        }
        Some(Node::Operation(Operator::Multiply, Box::new(factor), Box::new(power(n, k)?)))
    });
    let first = terms.next().unwrap_or_else(|| constant(&Rational::new()))?;
    terms.try_fold(first, |sum, term| Some(Node::Operation(Operator::Add, Box::new(sum), Box::new(term?))))
}
