//! Formulas that are sums of powers of r, whose transforms are closed forms.

use std::collections::BTreeMap;

use rug::Rational;
use rug::ops::Pow;

use super::{Constant, Expression, Function, Node, Operator};
use crate::number::Literal;

/// The most terms of a sum that is multiplied out.
const TERMS: usize = 32;
/// The largest integer power that is multiplied out.
const POWER: i64 = 32;
/// The most bits of a coefficient or an exponent.
const BITS: u32 = 4096;

/// Coefficients by exponents: none is zero.
pub(super) type Sum = BTreeMap<Rational, Rational>;

impl Expression {
    /// The formula for r > 0 as a sum of powers Σ c rⁿ with rational constants: each n and c, by rising n. `None` if it is none, or
    /// one that is not seen to be, or a long one.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use mdr_core::number::Literal;
    /// let formula: Expression = "r^2/(2*R) + sqrt(r)*(r + 1/3)".parse()?;
    /// let values = [("R".to_owned(), Literal::from(2))].into();
    /// let literal = |text: &str| text.parse::<Literal>().expect("a number").to_rational();
    /// let powers = formula.powers(&values).expect("a sum of powers");
    /// let expected = [("1/2", "1/3"), ("3/2", "1"), ("2", "1/4")].map(|(n, c)| [literal(n), literal(c)]);
    /// assert_eq!(powers, expected);
    /// assert_eq!("1 - cos(r)".parse::<Expression>()?.powers(&values), None);
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn powers(&self, values: &BTreeMap<String, Literal>) -> Option<Vec<[Rational; 2]>> {
        let sum = self.with_values(values).ok()?.powers()?;
        Some(sum.into_iter().map(|(n, c)| [n, c]).collect())
    }
}

impl Node<Constant> {
    /// A formula with the same values at r > 0, in whose sums of powers nothing cancels at the axis or far out.
    pub(super) fn without_cancelled(&self) -> Node<Constant> {
        if let (Node::Operation(Operator::Add | Operator::Subtract, ..), Some(whole)) = (self, self.powers()) {
            let shorter = self.over_lowest_power(&whole).and_then(|sum| times_power(sum, whole.first_key_value()?.0));
            return shorter.unwrap_or_else(|| self.clone());
        }
        self.with_inner(Node::without_cancelled)
    }

    /// A sum of powers over its lowest one, with the same zeros at r > 0, if terms cancel in it at the axis or far out, where enclosures
    /// lose its sign; `None` where none does, or all do.
    pub(super) fn over_lowest_power(&self, whole: &Sum) -> Option<Node<Constant>> {
        let (least, most) = (whole.first_key_value()?.0, whole.last_key_value()?.0);
        let mut terms = Vec::new();
        self.terms(&mut terms);
        let is_beyond = |term: Sum| term.keys().any(|n| n < least || n > most);
        if !terms.iter().filter_map(|term| term.powers()).any(is_beyond) {
            return None;
        }
        over_power(whole, least)
    }

    /// The formula with quotients of sums of powers over the highest power of their divisors, as 1/(1/r² + 1) is r²/(1 + r²): there r does not
    /// grow in two places far out.
    pub(super) fn far_out(&self) -> Node<Constant> {
        let over_highest = |a: &Node<Constant>, b: &Node<Constant>| {
            let (a, b) = (a.powers()?, b.powers().filter(|b| b.len() > 1)?);
            let highest = b.last_key_value()?.0;
            Some(Node::Operation(
                Operator::Divide,
                Box::new(over_power(&a, highest)?),
                Box::new(over_power(&b, highest)?),
            ))
        };
        match self {
            Node::Operation(Operator::Divide, a, b) => over_highest(a, b),
            _ => None,
        }
        .unwrap_or_else(|| self.with_inner(Node::far_out))
    }

    /// What is added and subtracted.
    fn terms<'a>(&'a self, found: &mut Vec<&'a Node<Constant>>) {
        match self {
            Node::Negative(x) => x.terms(found),
            Node::Operation(Operator::Add | Operator::Subtract, a, b) => {
                [a, b].into_iter().for_each(|x| x.terms(found))
            }
            term => found.push(term),
        }
    }

    /// The formula as a sum of powers of r, if it is one.
    pub(super) fn powers(&self) -> Option<Sum> {
        let sum = match self {
            Node::Variable => Sum::from([(1.into(), 1.into())]),
            Node::Constant(Constant::Literal(literal)) => constant(literal.to_rational()),
            Node::Constant(_) => return None,
            Node::Negative(x) => scaled(x.powers()?, &Rational::from(-1)),
            Node::Power(x, n) => raised(&x.powers()?, &Rational::from(*n))?,
            Node::Function(Function::Sqrt, x) => raised(&x.powers()?, &Rational::from((1, 2)))?,
            Node::Function(..) => return None,
            Node::Operation(operator, a, b) => {
                let (a, b) = (a.powers()?, b.powers()?);
                match operator {
                    Operator::Add => added(a, b),
                    Operator::Subtract => added(a, scaled(b, &Rational::from(-1))),
                    Operator::Multiply => product(&a, &b),
                    Operator::Divide => product(&a, &raised(&b, &Rational::from(-1))?),
                    Operator::Power => raised(&a, &number(&b)?)?,
                    Operator::Minimum | Operator::Maximum => return None,
                }
            }
        };
        let is_short =
            |number: &Rational| number.numer().significant_bits() + number.denom().significant_bits() <= BITS;
        (sum.len() <= TERMS && sum.iter().all(|(n, c)| is_short(n) && is_short(c))).then_some(sum)
    }
}

/// A sum of powers over a power of r.
fn over_power(sum: &Sum, exponent: &Rational) -> Option<Node<Constant>> {
    let mut terms = sum.iter().map(|(n, c)| times_power(fraction(c)?, &Rational::from(n - exponent)));
    let first = terms.next()??;
    terms.try_fold(first, |sum, term| Some(Node::Operation(Operator::Add, Box::new(sum), Box::new(term?))))
}

/// A factor times rⁿ.
fn times_power(factor: Node<Constant>, n: &Rational) -> Option<Node<Constant>> {
    let variable = Box::new(Node::Variable);
    let power = match n.is_integer().then(|| n.numer().to_i64()) {
        Some(Some(0)) => return Some(factor),
        Some(n) => Node::Power(variable, n?),
        None => Node::Operation(Operator::Power, variable, Box::new(fraction(n)?)),
    };
    Some(Node::Operation(Operator::Multiply, Box::new(factor), Box::new(power)))
}

/// A rational number as a quotient of two whole ones.
fn fraction(value: &Rational) -> Option<Node<Constant>> {
    let whole =
        |number: &rug::Integer| Some(Box::new(Node::Constant(Constant::Literal(number.to_string().parse().ok()?))));
    Some(Node::Operation(Operator::Divide, whole(value.numer())?, whole(value.denom())?))
}

fn constant(value: Rational) -> Sum {
    if value == 0 { Sum::new() } else { Sum::from([(Rational::new(), value)]) }
}

/// The value of a sum that is a number.
pub(super) fn number(sum: &Sum) -> Option<Rational> {
    match sum.iter().next() {
        None => Some(Rational::new()),
        Some((n, c)) => (*n == 0 && sum.len() == 1).then(|| c.clone()),
    }
}

fn scaled(mut sum: Sum, factor: &Rational) -> Sum {
    sum.values_mut().for_each(|c| *c *= factor);
    sum
}

fn added(mut a: Sum, b: Sum) -> Sum {
    for (n, c) in b {
        let sum = a.remove(&n).unwrap_or_default() + c;
        if sum != 0 {
            a.insert(n, sum);
        }
    }
    a
}

fn product(a: &Sum, b: &Sum) -> Sum {
    let shifted = |(n, c): (&Rational, &Rational)| {
        a.iter().map(|(m, d)| (Rational::from(m + n), Rational::from(d * c))).collect()
    };
    b.iter().map(shifted).fold(Sum::new(), added)
}

/// A sum of powers to a power: of one term, or to a small positive integer.
fn raised(base: &Sum, exponent: &Rational) -> Option<Sum> {
    let integer = exponent.is_integer().then(|| exponent.numer().to_i64()).flatten();
    if let (1, Some((n, c))) = (base.len(), base.first_key_value()) {
        let c = match integer {
            _ if *c == 1 => Rational::from(1),
            Some(power) if power.abs() <= POWER => Rational::from(c.pow(i32::try_from(power).ok()?)),
            _ => return None,
        };
        return Some(Sum::from([(Rational::from(n * exponent), c)]));
    }
    let power = integer.filter(|power| (1..=POWER).contains(power))?;
    let mut all = base.clone();
    for _ in 1..power {
        all = product(&all, base);
        if all.len() > TERMS {
            return None;
        }
    }
    Some(all)
}
