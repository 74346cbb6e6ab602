//! ∫₀^{π/2} of a formula in sinθ and cosθ, enclosed.
//!
//! The midpoint rule on a panel of width h errs by h³/24 times a value of the second derivative on the panel, which dual
//! numbers over dual numbers over intervals enclose. Panels shrink geometrically towards θ = 0, where a power of the sine
//! may have no second derivative; the last panel is the range of the integrand times its width.

use mdr_core::number::{Dual, Interval, Real, Special};
use mdr_symbolic::formula::{Arithmetic, Function, evaluate};
use mdr_symbolic::{Domain, Formula, Symbol};
use rug::Rational;

use super::point::Point;

/// Halvings towards θ = 0.
const OCTAVES: i64 = 12;
/// Panels in each.
const PANELS: i64 = 24;

/// The integral of `integrand` over θ from 0 to π/2, at a point; the entire line when that cannot be enclosed.
pub(super) fn quarter_turn(integrand: &Formula, point: &Point) -> Interval {
    let right = point.pi().over(2);
    enclosed(integrand, point, &right).unwrap_or_else(|| Interval::entire(right.ctx()))
}

fn enclosed(integrand: &Formula, point: &Point, right: &Interval) -> Option<Interval> {
    let mut upper = right.clone().over(1 << OCTAVES);
    let mut sum = at(integrand, point, right.lit(0).hull(&upper))? * &upper;
    for _ in 0..OCTAVES {
        if !sum.is_finite() {
            return None;
        }
        let width = upper.clone().over(PANELS);
        for panel in 0..PANELS {
            sum += &midpoint(integrand, point, &(upper.clone() + width.clone().times(panel)), &width)?;
        }
        upper = upper.times(2);
    }
    Some(sum)
}

/// The midpoint rule on [left, left + width], with its error.
fn midpoint(integrand: &Formula, point: &Point, left: &Interval, width: &Interval) -> Option<Interval> {
    let middle = left.clone() + width.clone().over(2);
    let panel = left.hull(&(left.clone() + width));
    let curvature = at(integrand, point, Dual::variable(Dual::variable(panel)))?.slope.slope;
    let error = curvature * &width.powi(2).over(24);
    Some((at(integrand, point, middle)? + error) * width)
}

/// The integrand at an angle.
fn at<R: FromInterval>(integrand: &Formula, point: &Point, angle: R) -> Option<R> {
    let arithmetic = AtAngle { point, sine: angle.sin(), cosine: angle.cos(), angle };
    evaluate(integrand, Domain::Positive, &arithmetic).ok()
}

/// Numbers that can hold an interval as a constant.
trait FromInterval: Special {
    fn from_interval(value: Interval) -> Self;
}

impl FromInterval for Interval {
    fn from_interval(value: Interval) -> Self {
        value
    }
}

impl<R: FromInterval> FromInterval for Dual<R> {
    fn from_interval(value: Interval) -> Self {
        Dual::constant(R::from_interval(value))
    }
}

/// A point and an angle.
struct AtAngle<'a, R> {
    point: &'a Point,
    angle: R,
    sine: R,
    cosine: R,
}

impl<R: FromInterval> Arithmetic for AtAngle<'_, R> {
    type Value = R;

    fn rational(&self, value: &Rational) -> R {
        R::from_interval(self.point.rational(value))
    }
    fn pi(&self) -> R {
        R::from_interval(self.point.pi())
    }
    fn n(&self) -> R {
        R::from_interval(self.point.n())
    }
    fn symbol(&self, symbol: Symbol) -> R {
        match symbol.name() {
            "θ" => self.angle.clone(),
            "sinθ" => self.sine.clone(),
            "cosθ" => self.cosine.clone(),
            _ => R::from_interval(self.point.symbol(symbol)),
        }
    }
    fn add(&self, left: &R, right: &R) -> R {
        left.clone() + right
    }
    fn multiply(&self, left: &R, right: &R) -> R {
        left.clone() * right
    }
    fn divide(&self, left: &R, right: &R) -> R {
        left.clone() / right
    }
    fn integer_power(&self, base: &R, exponent: i32) -> R {
        base.powi(i64::from(exponent))
    }
    fn power(&self, base: &R, exponent: &R) -> R {
        self.point.note(*base < base.lit(0));
        base.pow(exponent)
    }
    /// Of the functions only the sine occurs under an integral.
    fn function(&self, function: Function, arguments: &[R]) -> R {
        match (function, arguments) {
            (Function::Sine, [z]) => z.sin(),
            _ => R::from_interval(Interval::entire(self.point.pi().ctx())),
        }
    }
    fn quarter_turn(&self, _: &Formula) -> R {
        R::from_interval(Interval::entire(self.point.pi().ctx()))
    }
}
