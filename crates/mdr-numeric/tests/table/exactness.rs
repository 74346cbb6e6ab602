//! The closed moments against quadrature and against automatic differentiation, at 40 digits.

use mdr_core::contact::{Profile, Transform};
use mdr_core::number::{Dual, Precision, Real, Special};
use mdr_numeric::table::MeasuredProfile;
use mdr_numeric::transform::Quadrature;
use rug::Float;

use super::sample::{Points, magnitude, radii, sampled, with_noise};

const BITS: u32 = 136;

fn number(value: f64) -> Float {
    Real::from_f64(Precision::new(BITS), value)
}

/// A dozen rows that rise and fall, not equally spaced, without a row at the tip.
fn rough() -> Points {
    let points = sampled(&radii(13, 1.0, 0.4), |r| 0.5 * r * r + 0.05 * (20.0 * r).sin().powi(2));
    with_noise(points, 0.01).split_off(1)
}

fn profile<R: Special>(points: &Points, number: impl Fn(f64) -> R) -> MeasuredProfile<R> {
    MeasuredProfile::new(points.iter().map(|&(r, f)| (number(r), number(f))).collect()).unwrap()
}

/// Within the first piece, near a row, in the middle, on a row, at the end.
fn probes(points: &Points) -> Vec<f64> {
    vec![1e-7, 0.6 * points[0].0, points[4].0 + 1e-3, 0.73, points[7].0, 0.999]
}

#[test]
fn as_quadrature_of_the_interpolant() {
    let points = rough();
    let exact = profile(&points, number);
    let quadrature = Quadrature::new(exact.clone());
    let mut knots = Profile::kinks(&exact);
    knots.push(number(1.0));
    for x in probes(&points) {
        let wide = number(x);
        // The closed form is accurate to the stated bound; quadrature gives its own error, and its heights and their
        // derivatives have a few roundings of terms as large as the magnitude.
        let rounding = 256.0 * wide.unit_roundoff().approx();
        let check = |what: &str, value: Float, (expected, error): (Float, f64), magnitude: f64| {
            let difference = (value - &expected).abs().to_f64();
            let allowed = error + rounding * magnitude;
            assert!(difference <= allowed, "{what}({x}): {difference:e} against {allowed:e}");
        };
        let with_tip = [vec![(0.0, 0.0)], points.clone()].concat();
        let slopes = magnitude(&with_tip, x, |_| 1.0);
        let bends = magnitude(&with_tip, x, |aspect| 1.0 + aspect);
        let g = quadrature.g_estimate(&wide).unwrap();
        check("g", exact.g(&wide).unwrap(), (g.value, g.error.to_f64()), x * slopes);
        let slope = quadrature.slope_estimate(&wide).unwrap();
        check("g'", exact.slope(&wide).unwrap(), (slope.value, slope.error.to_f64()), bends);
        let integral = quadrature.integral(&wide).unwrap();
        check("G", exact.integral(&wide).unwrap(), (integral, 0.0), x * x * slopes);
    }
}

#[test]
fn slopes_are_derivatives() {
    let points = rough();
    let plain = profile(&points, number);
    let dual = profile(&points, |value| Dual::constant(number(value)));
    for x in probes(&points).into_iter().take(4) {
        let moving = Dual::variable(number(x));
        let close = |value: Float, expected: Float| {
            // g'' is as large as 1/√(x − r) beside a row, 10⁻³ away from it: a few bits of the 136.
            let error = (value - &expected).abs() / expected.abs();
            assert!(error < 2f64.powi(-115), "{x}: {error}");
        };
        close(dual.g(&moving).unwrap().slope, plain.slope(&number(x)).unwrap());
        close(dual.integral(&moving).unwrap().slope, plain.g(&number(x)).unwrap());
    }
}
