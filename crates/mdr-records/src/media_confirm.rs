//! The second method for [media](crate::media): quadrature of the heights with the weight of the medium, and of the pressure with
//! its kernel. No closed form of a transform, of a fold or of a mean gap is used.

use mdr_core::calculus::quadrature::{tanh_sinh, tanh_sinh_near_ends};
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::Result;
use mdr_core::number::{Dual, Real, Special};
use rug::Float;

use crate::confirm::{agree, changes_sign};
use crate::media::{Held, Question};

/// The name of the method.
pub(crate) fn name(formula: &str) -> &'static str {
    match formula {
        "wave-fold" => "kernel-quadrature/mp",
        formula if formula.starts_with("wave-threshold") => "double-root/mp",
        _ => "quadrature-tangency/mp",
    }
}

/// Whether the second method has the same values.
pub(crate) fn agrees(question: &Question, x: &[Float], values: &[Float]) -> Result<bool> {
    let is_load = question.held() == Some(Held::Force);
    match question.formula() {
        "graded-critical" => graded(x, values, is_load),
        "graded-threshold" => graded_threshold(x, &values[0], is_load),
        "line-critical" => line(x, values),
        "line-threshold" => line_threshold(x, &values[0]),
        "wave-fold" => wave(question.held(), x, values),
        formula => threshold(formula, x, &values[0]),
    }
}

/// n∫₀^{π/2} sin^{n+shift}θ cosᵏθ dθ · C, with t = sin²θ: the transform of C rⁿ at 1 by its weight (shift −1), or N of line contact
/// (shift 0).
pub(crate) fn transform(n: &Float, c: &Float, weight: &Float, shift: i64) -> Result<Float> {
    let rise = (n.clone() + n.lit(shift - 1)).over(2);
    let fall = (weight.clone() - weight.lit(1)).over(2);
    let integral = tanh_sinh_near_ends(&n.lit(0), &n.lit(1), &roundoff_tolerance(n), |node| {
        Ok(node.from_lower.pow(&rise) * node.from_upper.pow(&fall))
    })?;
    Ok(integral.value * n / n.lit(2) * c)
}

/// The tangency g' = λ√B a^{−(1+k)/2} changes its sign at a; d and F are those of the springs, F by quadrature.
fn graded(x: &[Float], values: &[Float], is_load: bool) -> Result<bool> {
    let [n, c, k, coefficient, work] = [0, 1, 2, 3, 4].map(|place| x[place].clone());
    let unit = transform(&n, &c, &k, -1)?;
    let (one, whole) = (n.lit(1), k.clone() + n.lit(1));
    let elongation = |a: &Float| (n.pi() * &work * a.pow(&(one.clone() - &k)) / &coefficient).times(2).sqrt();
    // Δl' = (1−k)Δl/2a; under a load F' = S d' − S'Δl with S' = (1+k)S/a.
    let share = if is_load { whole.clone() + (one.clone() - &k).over(2) } else { (one.clone() - &k).over(2) };
    let tangent = |a: &Float| Ok(unit.clone() * &n * a.pow(&n) - elongation(a) * &share);
    let a = &values[0];
    if !changes_sign(a, tangent)? {
        return Ok(false);
    }
    let d = unit.clone() * a.pow(&n) - elongation(a);
    let integral = tanh_sinh(&n.lit(0), a, &roundoff_tolerance(&n), |x| Ok(x.pow(&k) * (unit.clone() * x.pow(&n))))?;
    let force = (d.clone() * a.pow(&whole) / &whole - integral.value) * &coefficient * n.lit(2);
    let size = elongation(a) + d.clone().abs();
    let load = size.clone() * a.pow(&whole) * &coefficient * n.lit(2) / &whole;
    Ok(agree(&d, &values[1], &size) && agree(&force, &values[2], &load))
}

/// With this C the tangency holds at n = (1−k)/2 for the radius 1.
fn graded_threshold(x: &[Float], value: &Float, is_load: bool) -> Result<bool> {
    let (k, one) = (&x[0], x[0].lit(1));
    let n = (one.clone() - k).over(2);
    let unit = transform(&n, &one, k, -1)?;
    let elongation = (n.pi() * &x[2] / &x[1]).times(2).sqrt();
    let share = if is_load { (k.clone() + &one) + &n } else { n.clone() };
    changes_sign(value, |c| Ok(unit.clone() * c * &n - elongation.clone() * &share))
}

/// N by quadrature: b N' − Δl/2 changes its sign at b, and the force is E*(N − Δl).
fn line(x: &[Float], values: &[Float]) -> Result<bool> {
    let [n, c, e, w] = [0, 1, 2, 3].map(|place| x[place].clone());
    let unit = transform(&n, &c, &n.lit(0), 0)?;
    let elongation = |b: &Float| (n.pi() * &w * b / &e).times(2).sqrt();
    let b = &values[0];
    let tangent = |b: &Float| Ok(unit.clone() * &n * b.pow(&n) - elongation(b).over(2));
    let force = (unit.clone() * b.pow(&n) - elongation(b)) * &e;
    let size = elongation(b) * &e;
    Ok(changes_sign(b, tangent)? && agree(&force, &values[1], &size))
}

/// With this C the force vanishes at the half-width 1.
fn line_threshold(x: &[Float], value: &Float) -> Result<bool> {
    let half = x[0].ratio(1, 2);
    let unit = transform(&half, &half.lit(1), &half.lit(0), 0)?;
    let elongation = (half.pi() * &x[1] / &x[0]).times(2).sqrt();
    changes_sign(value, |c| Ok(unit.clone() * c - &elongation))
}

/// P and H at ψ: P from the stress intensity at the edge, and H from the displacement by the kernel, 1 − H = u(0) in the middle of the
/// contact, u = −(2/π)∫q ln|2 sin S| dS, where √s sin θ = sin S and q dS = (P + s cos 2θ) dθ.
fn state<R: Special>(alpha: &R, angle: &R) -> Result<(R, R)> {
    let (sine, cosine) = angle.sin_and_cos();
    let share = sine.square();
    let pressure = share.clone() - alpha.clone() * (sine.clone() / cosine).sqrt();
    let zero = angle.lit(0);
    let displacement = tanh_sinh(&zero, &angle.pi().over(2), &roundoff_tolerance(angle), |theta| {
        let stress = pressure.clone() + share.clone() * theta.times_two().cos();
        Ok(-(sine.clone() * theta.sin()).times(2).ln() * stress)
    })?;
    let lifted = displacement.value.times(4) / angle.pi();
    Ok((pressure, angle.lit(1) - lifted))
}

/// Twice a number that is borrowed.
trait Twice {
    fn times_two(&self) -> Self;
}

impl<R: Real> Twice for R {
    fn times_two(&self) -> R {
        self.clone().times(2)
    }
}

/// The controlled quantity is stationary at ψ: its slope by dual numbers changes its sign.
fn wave(held: Option<Held>, x: &[Float], values: &[Float]) -> Result<bool> {
    let (h, l, e, w) = (&x[0], &x[1], &x[2], &x[3]);
    let alpha = (w.clone() * l / e).times(2).sqrt() / h / h.pi();
    let unit = h.pi() * e * h / l;
    let compliance = x.get(4).map(|k| unit.clone() / k / h);
    let slope = |a: &Float| {
        let angle = Dual::variable(a.pi() * a / l);
        let (pressure, gap) = state(&Dual::constant(alpha.clone()), &angle)?;
        Ok(match (held, &compliance) {
            (Some(Held::Force), _) => pressure.slope,
            (_, Some(compliance)) => pressure.slope * compliance - gap.slope,
            (_, None) => -gap.slope,
        })
    };
    let (pressure, gap) = state(&alpha, &(l.pi() * &values[0] / l))?;
    let approach = (gap.lit(1) - gap.clone()) * h;
    let (length, load) = (h.clone() * (gap.clone().abs() + gap.lit(1)), unit.clone());
    Ok(changes_sign(&values[0], slope)?
        && agree(&approach, &values[1], &length)
        && agree(&(pressure * unit), &values[2], &load))
}

/// From what each threshold means: P has a double turning point, P touches zero, complete contact has no energy, M touches zero.
fn threshold(formula: &str, x: &[Float], value: &Float) -> Result<bool> {
    let one = x[0].lit(1);
    let alpha = |w: &Float| (w.clone() * &x[1] / &x[2]).times(2).sqrt() / &x[0] / one.pi();
    match formula {
        // The slope of P where its curvature vanishes, sin²ψ = 3/8, and P where its slope does, sin²ψ = 3/4.
        "wave-threshold-load" => changes_sign(value, |w| {
            let angle = one.ratio(3, 5).sqrt().atan();
            let (sine, cosine) = (angle.clone().sin(), angle.cos());
            let root = (sine.clone() / &cosine).sqrt();
            Ok((sine.clone() * &cosine).times(2) - alpha(w) / (root * cosine.square()).times(2))
        }),
        "wave-threshold-touch" => changes_sign(value, |w| Ok(one.ratio(3, 4) - alpha(w) * one.lit(3).sqrt().sqrt())),
        "wave-threshold-energy" => changes_sign(value, |w| Ok(one.ratio(1, 4) - alpha(w).square() * one.pi().over(2))),
        // ln s + 4(1 − s) at its maximum, s = 1/4; the logarithm by quadrature.
        _ => {
            let logarithm = tanh_sinh(&one.ratio(1, 4), &one, &roundoff_tolerance(&one), |t| Ok(t.clone().recip()))?;
            changes_sign(value, |k| Ok(one.pi() * &x[1] / k / &x[0] - (one.lit(3) - &logarithm.value)))
        }
    }
}
