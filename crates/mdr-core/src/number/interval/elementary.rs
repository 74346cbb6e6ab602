//! `Real` for intervals: powers, exponential and logarithm, monotone piece by monotone piece.

use std::cmp::Ordering;

use rug::Float;
use rug::float::{Constant, Round};
use rug::ops::{AddAssignRound, PowAssignRound, SubAssignRound};

use super::operators::{End, Side, extremes};
use super::{Interval, just_above};
use crate::number::{Literal, Precision, Real};

impl Interval {
    /// The image under an increasing function, correctly rounded at each end.
    pub(super) fn increasing(&self, function: impl Fn(&mut Float, Round) -> Ordering) -> Interval {
        monotone(&self.lo, &self.hi, function)
    }

    /// The image under a decreasing function.
    pub(super) fn decreasing(&self, function: impl Fn(&mut Float, Round) -> Ordering) -> Interval {
        monotone(&self.hi, &self.lo, function)
    }

    /// `image` if the whole interval is `inside` the domain, else (and for the entire line) the entire line.
    pub(super) fn within(&self, inside: bool, image: impl FnOnce(&Self) -> Interval) -> Interval {
        if inside && !self.is_entire() { image(self) } else { self.nothing_known() }
    }

    /// x^y for x > 0, or x ≥ 0 where y > 0. With x^y = e^(y ln x) the extreme corners are those of the product y · ln x.
    fn power(&self, exponent: &Interval) -> Interval {
        let function = |x: &mut Float, y: &Float, round| x.pow_assign_round(y, round);
        if exponent.is_point() {
            // Monotone in the base; a point base needs one evaluation.
            let raise = |x: &mut Float, round| function(x, &exponent.lo, round);
            return if exponent.lo >= 0 { self.increasing(raise) } else { self.decreasing(raise) };
        }
        let mut result = self.clone();
        let side_of_one = Side::from_ends(self.lo.partial_cmp(&1), self.hi.partial_cmp(&1));
        if let Some(corners) = extremes(side_of_one, exponent.sign()) {
            result.combine(exponent, corners, function);
            return result;
        }
        // Both ln x and y may be zero: x^y is least at (lo, hi) or (hi, lo) and greatest at (lo, lo) or (hi, hi).
        let mut other = self.clone();
        result.combine(exponent, [(End::Lower, End::Upper), (End::Upper, End::Upper)], function);
        other.combine(exponent, [(End::Upper, End::Lower), (End::Lower, End::Lower)], function);
        result.hull(&other)
    }
}

/// The interval from the arguments of the least and of the greatest value; a point needs one evaluation.
fn monotone(least: &Float, greatest: &Float, function: impl Fn(&mut Float, Round) -> Ordering) -> Interval {
    let mut lo = least.clone();
    let order = function(&mut lo, Round::Down);
    let hi = if least == greatest {
        just_above(&lo, order)
    } else {
        let mut hi = greatest.clone();
        function(&mut hi, Round::Up);
        hi
    };
    Interval { lo, hi }
}

/// Increasing functions by their names, those of `rug` that round, and their domains.
macro_rules! increasing {
    ($($name:ident: $function:ident, |$x:pat_param| $inside:expr;)*) => {$(
        fn $name(&self) -> Interval {
            let $x = self;
            self.within($inside, |x| x.increasing(Float::$function))
        }
    )*};
}
pub(super) use increasing;

impl Real for Interval {
    type Ctx = Precision;

    fn ctx(&self) -> Precision {
        Precision::new(self.lo.prec())
    }
    fn from_int(ctx: Precision, value: i64) -> Interval {
        Interval::outward(|round| Float::with_val_round(ctx.bits(), value, round))
    }
    fn is_integer(&self, value: i64) -> bool {
        self.lo == value && self.hi == value
    }
    /// The entire line when `value` is not finite.
    fn from_f64(ctx: Precision, value: f64) -> Interval {
        if value.is_finite() {
            Interval::outward(|round| Float::with_val_round(ctx.bits(), value, round))
        } else {
            Interval::entire(ctx)
        }
    }
    fn from_literal(ctx: Precision, literal: &Literal) -> Interval {
        Interval::from_rational(ctx, &literal.to_rational())
    }
    fn pi(&self) -> Interval {
        Interval::outward(|round| Float::with_val_round(self.lo.prec(), Constant::Pi, round))
    }
    fn times(mut self, k: i64) -> Interval {
        self.scale(k);
        self
    }
    fn over(mut self, k: i64) -> Interval {
        self.divide(k);
        self
    }
    fn abs(&self) -> Interval {
        if self.is_entire() {
            return self.clone();
        }
        match self.sign() {
            Side::Above => self.clone(),
            Side::Below => -self.clone(),
            Side::Across => Interval { lo: Float::new(self.lo.prec()), hi: (-self.lo.clone()).max(&self.hi) },
        }
    }
    fn square(&self) -> Interval {
        let mut square = self.abs();
        if !self.is_entire() {
            square.lo.square_round(Round::Down);
            square.hi.square_round(Round::Up);
        }
        square
    }
    increasing! {
        sqrt: sqrt_round, |x| x.lo >= 0;
        exp: exp_round, |_| true;
        exp_m1: exp_m1_round, |_| true;
        ln: ln_round, |x| x.lo > 0;
        ln_1p: ln_1p_round, |x| x.lo > -1;
    }
    fn pow(&self, exponent: &Interval) -> Interval {
        let inside = self.lo > 0 || (self.lo == 0 && exponent.lo > 0);
        self.within(inside && !exponent.is_entire(), |base| base.power(exponent))
    }
    fn powi(&self, exponent: i64) -> Interval {
        let function = |x: &mut Float, round| x.pow_assign_round(exponent, round);
        self.within(exponent >= 0 || !self.contains_zero(), |x| {
            let base = if exponent % 2 == 0 { x.abs() } else { x.clone() };
            if exponent >= 0 { base.increasing(function) } else { base.decreasing(function) }
        })
    }
    fn precision(&self) -> u32 {
        self.lo.prec()
    }
    fn unit_roundoff(&self) -> Interval {
        Interval::point(Float::with_val(self.lo.prec(), 1) >> self.lo.prec())
    }
    fn approx(&self) -> f64 {
        self.mid().to_f64()
    }
    fn is_finite(&self) -> bool {
        self.is_bounded()
    }
    fn inflate(mut self, bound: &Interval) -> Interval {
        let Interval { hi: bound, .. } = bound.abs();
        self.lo.sub_assign_round(&bound, Round::Down);
        self.hi.add_assign_round(&bound, Round::Up);
        self
    }
    fn greater(&self, other: &Interval) -> Interval {
        Interval::new(self.lo.clone().max(&other.lo), self.hi.clone().max(&other.hi))
    }
    fn either(&self, other: &Interval) -> Interval {
        self.hull(other)
    }
    fn midpoint(&self) -> Interval {
        Interval::point(self.mid())
    }
}
