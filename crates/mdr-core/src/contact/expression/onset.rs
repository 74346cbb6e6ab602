//! Powers that begin at a radius, as max(0, r − b)^1.5 does: C(r) B(r)^e beyond b, where B is zero, and nothing before it.
//!
//! With B = c(rⁿ − bⁿ) and r = b + u it is u^e C(b + u) h(u)^e, where h = B/u is a polynomial without zeros at u ≥ 0: but for the power of u it
//! is analytic at its onset. A formula that is a sum of such terms and of a rest is integrated term by term.

use rug::{Integer, Rational};

use super::breaks::{Breaks, is_zero};
use super::enclosed::EnclosedFormula;
use super::powers::{Sum, number};
use super::rooted::literal;
use super::{Constant, Expression, ExpressionError, Function, Node, Operator};
use crate::calculus::enclose::BOUND_BITS;
use crate::number::{Analytic, Interval, Precision, Real};

/// The largest n of rⁿ in B.
const DEGREE: i64 = 32;
/// The largest denominator of the exponent e.
const ORDER: u32 = 128;

/// A formula as a sum of powers that begin at radii, and the rest of it with its own breaks.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Split {
    rest: Node<Constant>,
    breaks: Breaks,
    terms: Vec<Term>,
}

/// C(r) max(0, B(r))^e.
#[derive(Clone, Debug, PartialEq)]
struct Term {
    factor: Node<Constant>,
    base: Base,
    exponent: Rational,
}

/// c(rⁿ − d), with c and d positive.
#[derive(Clone, Debug, PartialEq)]
struct Base {
    c: Rational,
    n: u32,
    d: Rational,
}

/// A formula without the powers that begin at a radius, and these.
#[derive(Clone, Debug)]
pub struct Onsets {
    /// What is left without them.
    pub rest: EnclosedFormula,
    /// The powers.
    pub powers: Vec<Onset>,
}

/// A power that begins at a radius b: u^e times a function of u = r − b that is analytic at u = 0, and nothing before b.
#[derive(Clone, Debug)]
pub struct Onset {
    /// n and d of bⁿ = d.
    place: (u32, Rational),
    begin: Interval,
    exponent: Interval,
    root: u32,
    /// C, and the coefficients of h: in the precision of bounds, and in that of values.
    factor: [Node<Interval>; 2],
    base: [Vec<Interval>; 2],
}

impl Node<Constant> {
    /// The formula as a sum of powers that begin at radii and of a rest; `None` without any, or if one of them stands elsewhere than in a
    /// sum.
    ///
    /// # Errors
    /// Errors of the breaks of the rest.
    pub(super) fn split(&self) -> Result<Option<Split>, ExpressionError> {
        let mut terms = Vec::new();
        let Some(rest) = self.rest(&Node::whole(1), &mut terms) else { return Ok(None) };
        if terms.is_empty() {
            return Ok(None);
        }
        let breaks = Expression { root: rest.clone() }.breaks(&Default::default())?;
        Ok(Some(Split { rest, breaks, terms }))
    }

    /// What is left without the powers, which are collected with what stands before them.
    fn rest(&self, factor: &Node<Constant>, terms: &mut Vec<Term>) -> Option<Node<Constant>> {
        let of = |operator, a: &Node<Constant>, b: &Node<Constant>| {
            Node::Operation(operator, Box::new(a.clone()), Box::new(b.clone()))
        };
        if let Some((base, exponent)) = self.power_of_switch()
            && !exponent.is_integer()
        {
            // From one half on g is continuous where it begins.
            if exponent <= Rational::from((1, 2)) || *exponent.denom() > ORDER {
                return None;
            }
            terms.push(Term { factor: factor.clone(), base, exponent });
            return Some(Node::whole(0));
        }
        Some(match self {
            Node::Negative(x) => Node::Negative(Box::new(x.rest(&Node::Negative(Box::new(factor.clone())), terms)?)),
            Node::Operation(operator @ (Operator::Add | Operator::Subtract), a, b) => {
                let a = a.rest(factor, terms)?;
                let sign =
                    if *operator == Operator::Add { factor.clone() } else { Node::Negative(Box::new(factor.clone())) };
                of(*operator, &a, &b.rest(&sign, terms)?)
            }
            Node::Operation(Operator::Multiply, a, b) if a.is_smooth() => {
                of(Operator::Multiply, a, &b.rest(&of(Operator::Multiply, factor, a), terms)?)
            }
            Node::Operation(operator @ (Operator::Multiply | Operator::Divide), a, b) if b.is_smooth() => {
                of(*operator, &a.rest(&of(*operator, factor, b), terms)?, b)
            }
            other => (!other.has_onset()).then(|| other.clone())?,
        })
    }

    /// Whether a power that begins at a radius stands in it.
    fn has_onset(&self) -> bool {
        let is_one = self.power_of_switch().is_some_and(|(_, exponent)| !exponent.is_integer());
        is_one
            || match self {
                Node::Variable | Node::Constant(_) => false,
                Node::Negative(x) | Node::Power(x, _) | Node::Function(_, x) => x.has_onset(),
                Node::Operation(_, a, b) => a.has_onset() || b.has_onset(),
            }
    }

    /// B and e, if it is max(0, B)^e in any of its forms.
    fn power_of_switch(&self) -> Option<(Base, Rational)> {
        match self {
            Node::Operation(Operator::Maximum, a, b) if is_zero(a) => Some((Base::of(&b.powers()?)?, 1.into())),
            Node::Operation(Operator::Maximum, a, b) if is_zero(b) => Some((Base::of(&a.powers()?)?, 1.into())),
            Node::Power(x, n) if *n > 0 => x.power_of_switch().map(|(base, e)| (base, e * *n)),
            Node::Function(Function::Sqrt, x) => x.power_of_switch().map(|(base, e)| (base, e / 2)),
            Node::Operation(Operator::Power, x, exponent) => {
                let (base, e) = x.power_of_switch()?;
                let exponent = number(&exponent.powers()?)?;
                (exponent > 0).then(|| (base, e * exponent))
            }
            _ => None,
        }
    }
}

impl Base {
    /// Of a sum of two powers that is negative up to its only zero.
    fn of(sum: &Sum) -> Option<Base> {
        let (first, last) = (sum.first_key_value()?, sum.last_key_value()?);
        let n = last.0.is_integer().then(|| last.0.numer().to_i64()).flatten().filter(|n| (1..=DEGREE).contains(n))?;
        let is_one = sum.len() == 2 && *first.0 == 0 && *first.1 < 0 && *last.1 > 0;
        let (c, constant) = (last.1.clone(), first.1.clone());
        is_one.then(|| Base { d: -constant / &c, c, n: n as u32 })
    }

    /// b.
    fn zero(&self, precision: Precision) -> Option<Interval> {
        let d = enclosed(&self.d, precision)?;
        Some(if self.n == 1 { d } else { d.pow(&d.lit(1).over(i64::from(self.n))) })
    }

    /// The coefficients of h(u) = c((b + u)ⁿ − bⁿ)/u.
    fn coefficients(&self, precision: Precision) -> Option<Vec<Interval>> {
        let (b, c) = (self.zero(precision)?, enclosed(&self.c, precision)?);
        let coefficient = |j: u32| {
            let ways = Integer::from(self.n).binomial(j).to_i64()?;
            Some(b.powi(i64::from(self.n - j)) * c.clone().times(ways))
        };
        (1..=self.n).map(coefficient).collect()
    }
}

fn enclosed(value: &Rational, precision: Precision) -> Option<Interval> {
    Some(Interval::from_literal(precision, &literal(value)?))
}

impl Split {
    /// With enclosures in a precision, of a formula that is known as far as `whole`.
    pub(super) fn enclosed(&self, whole: &EnclosedFormula, precision: Precision) -> Option<Onsets> {
        let mut rest = EnclosedFormula::new(&self.rest, &self.breaks, precision);
        rest.outer.clone_from(&whole.outer);
        rest.known_to.clone_from(&whole.known_to);
        let mut powers: Vec<Onset> = self.terms.iter().map(|term| term.enclosed(precision)).collect::<Option<_>>()?;
        powers.sort_by(|one, other| one.begin.lower().total_cmp(other.begin.lower()));
        Some(Onsets { rest, powers })
    }
}

impl Term {
    fn enclosed(&self, precision: Precision) -> Option<Onset> {
        let both = [Precision::new(BOUND_BITS), precision];
        let [low, high] = both.map(|precision| self.base.coefficients(precision));
        Some(Onset {
            place: (self.base.n, self.base.d.clone()),
            begin: self.base.zero(precision)?,
            exponent: enclosed(&self.exponent, precision)?,
            root: self.exponent.denom().to_u32()?,
            factor: both.map(|precision| self.factor.bound::<Interval>(precision).folded()),
            base: [low?, high?],
        })
    }
}

impl Onset {
    /// The radius b where it begins.
    pub fn begin(&self) -> &Interval {
        &self.begin
    }

    /// Whether it begins at the same radius as another one, exactly.
    pub fn begins_with(&self, other: &Onset) -> bool {
        self.place == other.place
    }

    /// The exponent e.
    pub fn exponent(&self) -> &Interval {
        &self.exponent
    }

    /// The least k for which k e is whole: in the root of u of this order it is analytic.
    pub fn root(&self) -> u32 {
        self.root
    }

    /// The term over u^e at r = b + u.
    ///
    /// ```
    /// use mdr_core::contact::Expression;
    /// use mdr_core::number::{Interval, Precision, Real};
    /// let formula: Expression = "r^2/2 - max(0, r^2 - 1)^1.5".parse()?;
    /// let none = Default::default();
    /// let precision = Precision::new(100);
    /// let enclosed = formula.enclosed(&none, &formula.breaks(&none)?, precision)?;
    /// let onset = &enclosed.onsets().expect("one power").powers[0];
    /// // −(2u + u²)^1.5/u^1.5 at u = 2.
    /// let value = onset.at(&Interval::from_int(precision, 2)).expect("analytic");
    /// assert!(value.contains(Interval::from_int(precision, -8).lower()) && onset.root() == 2);
    /// # Ok::<(), mdr_core::contact::ExpressionError>(())
    /// ```
    pub fn at<T: Analytic>(&self, u: &T) -> Option<T> {
        let index = usize::from(u.bits() > BOUND_BITS);
        let mut coefficients = self.base[index].iter().rev();
        let highest = u.constant(coefficients.next()?);
        let base = coefficients.fold(highest, |sum, next| sum.product(u).plus(&u.constant(next)));
        let factor = self.factor[index].analytic(&u.constant(&self.begin).plus(u))?;
        Some(factor.product(&base.power(&self.exponent)?))
    }
}
