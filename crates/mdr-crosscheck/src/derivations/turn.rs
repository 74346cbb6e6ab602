//! ∫₀^{π/2} of a formula in sinθ and cosθ, enclosed.
//!
//! The midpoint rule on a panel of width h errs by h³/24 times a value of the second derivative on the panel, which dual
//! numbers over dual numbers over intervals enclose. At either end a power of the sine or the cosine may have no second
//! derivative, or be infinite: panels shrink geometrically towards both, and what is left beside an end is the integral of
//! the power with which the integrand goes there ([`tail`]). An integral that diverges there, or an integrand without a real
//! value, makes the formula one without meaning.

use mdr_core::number::{Dual, Interval, Real, Special};
use mdr_symbolic::formula::{Arithmetic, Function, evaluate};
use mdr_symbolic::{Domain, Formula, Symbol};
use rug::Rational;

use super::ends::{End, Tail, tail};
use super::point::Point;

/// Halvings from the middle, θ = π/4, towards an end.
const OCTAVES: i64 = 11;
/// Panels in each.
const PANELS: i64 = 24;

/// The integral of `integrand` over θ from 0 to π/2, at a point; the entire line when that cannot be enclosed. Where it
/// certainly has no value, the point takes note of that.
pub(super) fn quarter_turn(integrand: &Formula, point: &Point) -> Interval {
    let width = point.pi().over(4 << OCTAVES);
    enclosed(integrand, point, &width).unwrap_or_else(|| Interval::entire(width.ctx()))
}

fn enclosed(integrand: &Formula, point: &Point, width: &Interval) -> Option<Interval> {
    // Both ends come first: either may say that there is no value.
    let tails = [End::Left, End::Right].map(|end| tail(integrand, point, end, width));
    point.note(tails.iter().any(|tail| matches!(tail, Tail::Divergent)));
    match tails {
        [Tail::Enclosed(left), Tail::Enclosed(right)] if !point.is_undefined() => {
            let left = half(integrand, point, End::Left, width, left)?;
            Some(left + half(integrand, point, End::Right, width, right)?)
        }
        _ => None,
    }
}

/// The integral between an end and the middle, from that up to a first `distance` from the end.
fn half(integrand: &Formula, point: &Point, end: End, distance: &Interval, tail: Interval) -> Option<Interval> {
    let (mut sum, mut left) = (tail, distance.clone());
    for _ in 0..OCTAVES {
        let width = left.clone().over(PANELS);
        for panel in 0..PANELS {
            sum += &midpoint(integrand, point, end, &(left.clone() + width.clone().times(panel)), &width)?;
        }
        if !sum.is_finite() {
            return None;
        }
        left = left.times(2);
    }
    Some(sum)
}

/// The midpoint rule between the distances left and left + width from an end, with its error.
fn midpoint(integrand: &Formula, point: &Point, end: End, left: &Interval, width: &Interval) -> Option<Interval> {
    let middle = left.clone() + width.clone().over(2);
    let panel = left.hull(&(left.clone() + width));
    let curvature = at(integrand, point, end, Dual::variable(Dual::variable(panel)))?.slope.slope;
    let error = curvature * &width.powi(2).over(24);
    Some((at(integrand, point, end, middle)? + error) * width)
}

/// The integrand at a distance from an end.
fn at<R: FromInterval>(integrand: &Formula, point: &Point, end: End, distance: R) -> Option<R> {
    let (sine, cosine) = (distance.sin(), distance.cos());
    let arithmetic = match end {
        End::Left => AtAngle { point, sine, cosine, angle: distance },
        End::Right => AtAngle { point, sine: cosine, cosine: sine, angle: distance.pi().over(2) - &distance },
    };
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
