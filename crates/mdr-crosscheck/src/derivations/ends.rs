//! A formula in sinθ and cosθ beside an end of the quarter turn, where it may be infinite or vanish.
//!
//! With t the distance from the end, every part of the formula is t^p · c(t) on 0 < t ≤ ε, where p is an exact rational and an
//! interval contains c(t) for all of these t. There sin t = t · (sin t/t), and sin t/t and cos t fall from 1. Such products are
//! multiplied, divided and raised as they stand. Of a sum the least power is taken out, and t^q for what is left of the
//! others lies between 0 and ε^q.

use mdr_core::number::{Interval, Real, Special};
use mdr_symbolic::formula::{Evaluator, Function, evaluate};
use mdr_symbolic::{Domain, Formula, Symbol};
use rug::Rational;

use super::point::SamplePoint;

/// An end of the quarter turn.
#[derive(Clone, Copy, Debug)]
pub(super) enum End {
    /// θ = 0.
    Left,
    /// θ = π/2.
    Right,
}

/// ∫ of an integrand over 0 < t ≤ ε.
#[derive(Debug)]
pub(super) enum Tail {
    /// It lies in this interval.
    Enclosed(Interval),
    /// It is certainly infinite: |f| ≥ |c| t^p with p ≤ −1 and c of one sign.
    Divergent,
    /// Nothing is known.
    Unknown,
}

/// ∫ of the integrand from an end of the quarter turn to the distance `width` from it, which is below 1.
pub(super) fn tail(integrand: &Formula, point: &SamplePoint, end: End, width: &Interval) -> Tail {
    let beside = Beside { point, end, width };
    let Ok(Leading { power, factor, .. }) = evaluate(integrand, Domain::Positive, &beside) else {
        return Tail::Unknown;
    };
    let next = power + 1u32;
    if !factor.is_finite() || (next <= 0 && factor.contains_zero()) {
        Tail::Unknown
    } else if next <= 0 {
        Tail::Divergent
    } else {
        // The weight t^p is positive, so that the mean of c lies in its enclosure.
        let next = SamplePoint::interval(&next);
        Tail::Enclosed(factor * &width.pow(&next) / next)
    }
}

/// t^power · factor on 0 < t ≤ ε.
#[derive(Clone)]
struct Leading {
    power: Rational,
    /// Contains the other factor for all of these t.
    factor: Interval,
    /// The value, where it is a rational number known exactly: an exponent has to be.
    exact: Option<Rational>,
}

impl Leading {
    fn new(power: Rational, factor: Interval) -> Self {
        Leading { power, factor, exact: None }
    }

    /// Something without zero or pole at the end.
    fn regular(factor: Interval) -> Self {
        Self::new(Rational::new(), factor)
    }

    fn exact(value: Rational) -> Self {
        Leading { factor: SamplePoint::interval(&value), power: Rational::new(), exact: Some(value) }
    }

    /// Adds the exact value of an operation on two exact values.
    fn knowing(mut self, parts: [&Self; 2], join: impl FnOnce(&Rational, &Rational) -> Rational) -> Self {
        if let [Some(left), Some(right)] = parts.map(|part| part.exact.as_ref()) {
            self.exact = Some(join(left, right));
        }
        self
    }

    fn is_zero(&self) -> bool {
        self.factor.is_point() && self.factor.contains_zero()
    }
}

/// A point, and the distances t from an end up to a width.
struct Beside<'a> {
    point: &'a SamplePoint,
    end: End,
    width: &'a Interval,
}

impl Beside<'_> {
    /// An interval that contains t^q for all t, q ≥ 0; the entire line for q < 0.
    fn range(&self, q: &Rational) -> Interval {
        match q.cmp0() {
            std::cmp::Ordering::Less => self.unknown().factor,
            std::cmp::Ordering::Equal => self.width.lit(1),
            std::cmp::Ordering::Greater => self.width.lit(0).hull(&self.width.pow(&SamplePoint::interval(q))),
        }
    }

    /// An interval that contains the value for all t.
    fn values(&self, of: &Leading) -> Interval {
        of.factor.clone() * self.range(&of.power)
    }

    fn unknown(&self) -> Leading {
        Leading::regular(Interval::entire(self.width.ctx()))
    }

    /// sin t.
    fn vanishing(&self) -> Leading {
        Leading::new(Rational::from(1), (self.width.sin() / self.width).hull(&self.width.lit(1)))
    }

    /// cos t.
    fn remaining(&self) -> Leading {
        Leading::regular(self.width.cos().hull(&self.width.lit(1)))
    }

    fn angle(&self) -> Leading {
        let right = self.width.pi().over(2);
        match self.end {
            End::Left => Leading::new(Rational::from(1), self.width.lit(1)),
            End::Right => Leading::regular((right.clone() - self.width).hull(&right)),
        }
    }
}

impl Evaluator for Beside<'_> {
    type Value = Leading;

    fn rational(&self, value: &Rational) -> Leading {
        Leading::exact(value.clone())
    }
    fn pi(&self) -> Leading {
        Leading::regular(self.point.pi())
    }
    fn n(&self) -> Leading {
        Leading::exact(self.point.exponent().clone())
    }
    fn symbol(&self, symbol: Symbol) -> Leading {
        match (symbol.name(), self.end) {
            ("θ", _) => self.angle(),
            ("sinθ", End::Left) | ("cosθ", End::Right) => self.vanishing(),
            ("cosθ", End::Left) | ("sinθ", End::Right) => self.remaining(),
            _ => Leading::regular(self.point.symbol(symbol)),
        }
    }
    fn add(&self, left: &Leading, right: &Leading) -> Leading {
        let sum = match (left.is_zero(), right.is_zero()) {
            (true, _) => Leading { exact: None, ..right.clone() },
            (_, true) => Leading { exact: None, ..left.clone() },
            _ => {
                let least = left.power.clone().min(right.power.clone());
                let rest = |of: &Leading| of.factor.clone() * self.range(&Rational::from(&of.power - &least));
                let factor = rest(left) + rest(right);
                Leading::new(least, factor)
            }
        };
        sum.knowing([left, right], |left, right| Rational::from(left + right))
    }
    fn multiply(&self, left: &Leading, right: &Leading) -> Leading {
        let power = Rational::from(&left.power + &right.power);
        let product = Leading::new(power, left.factor.clone() * &right.factor);
        product.knowing([left, right], |left, right| Rational::from(left * right))
    }
    fn divide(&self, left: &Leading, right: &Leading) -> Leading {
        if right.is_zero() {
            return self.unknown();
        }
        let power = Rational::from(&left.power - &right.power);
        let quotient = Leading::new(power, left.factor.clone() / &right.factor);
        quotient.knowing([left, right], |left, right| Rational::from(left / right))
    }
    fn integer_power(&self, base: &Leading, exponent: i32) -> Leading {
        let power = Rational::from(&base.power * exponent);
        Leading::new(power, base.factor.powi(i64::from(exponent)))
    }
    /// A negative base is one at all of these t: the integrand has no value there.
    fn power(&self, base: &Leading, exponent: &Leading) -> Leading {
        self.point.note(base.factor < base.factor.lit(0));
        match &exponent.exact {
            Some(exact) => Leading::new(Rational::from(&base.power * exact), base.factor.pow(&exponent.factor)),
            None => Leading::regular(self.values(base).pow(&self.values(exponent))),
        }
    }
    /// Of the functions only the sine occurs under an integral.
    fn function(&self, function: Function, arguments: &[Leading]) -> Leading {
        match (function, arguments) {
            (Function::Sine, [z]) => Leading::regular(self.values(z).sin()),
            _ => self.unknown(),
        }
    }
    fn quarter_turn(&self, _: &Formula) -> Leading {
        self.unknown()
    }
}

#[cfg(test)]
#[path = "../../tests/private/ends.rs"]
mod tests;
