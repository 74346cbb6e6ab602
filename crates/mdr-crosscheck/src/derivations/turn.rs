//! ∫₀^{π/2} of a formula in sinθ and cosθ, enclosed.
//!
//! The midpoint rule on a panel of width h errs by h³/24 times a value of the second derivative on the panel, which dual
//! numbers over dual numbers over intervals enclose. At either end a power of the sine or the cosine may have no second
//! derivative, or be infinite: panels shrink geometrically towards both, and what is left beside an end is the integral of
//! the power with which the integrand goes there ([`tail`]). An integral that diverges there, or an integrand without a real
//! value, makes the formula one without meaning.

use mdr_core::number::{Dual, Interval, Real};
use mdr_symbolic::formula::{Evaluator, evaluate};
use mdr_symbolic::{Domain, Formula};

use super::direct::{Direct, Level};
use super::ends::{End, Tail, tail};
use super::point::SamplePoint;

/// Halvings from the middle, θ = π/4, towards an end.
const OCTAVES: i64 = 11;
/// Panels in each.
const PANELS: i64 = 24;

/// The integral of `integrand` over θ from 0 to π/2, at a point; the entire line when that cannot be enclosed. Where it
/// certainly has no value, the point takes note of that.
pub(super) fn quarter_turn(integrand: &Formula, point: &SamplePoint) -> Interval {
    let width = point.pi().over(4 << OCTAVES);
    enclosed(integrand, point, &width).unwrap_or_else(|| Interval::entire(width.ctx()))
}

fn enclosed(integrand: &Formula, point: &SamplePoint, width: &Interval) -> Option<Interval> {
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
fn half(integrand: &Formula, point: &SamplePoint, end: End, distance: &Interval, tail: Interval) -> Option<Interval> {
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
fn midpoint(integrand: &Formula, point: &SamplePoint, end: End, left: &Interval, width: &Interval) -> Option<Interval> {
    let middle = left.clone() + width.clone().over(2);
    let panel = left.hull(&(left.clone() + width));
    let curvature = at(integrand, point, end, Dual::variable(Dual::variable(panel)))?.slope.slope;
    let error = curvature * &width.powi(2).over(24);
    Some((at(integrand, point, end, middle)? + error) * width)
}

/// The integrand at a distance from an end.
fn at<R: Level>(integrand: &Formula, point: &SamplePoint, end: End, distance: R) -> Option<R> {
    let (sine, cosine) = distance.sin_and_cos();
    let values = match end {
        End::Left => [("sinθ", sine), ("cosθ", cosine), ("θ", distance)],
        End::Right => [("sinθ", cosine), ("cosθ", sine), ("θ", distance.pi().over(2) - &distance)],
    };
    evaluate(integrand, Domain::Positive, &Direct::new(point, values)).ok()
}
