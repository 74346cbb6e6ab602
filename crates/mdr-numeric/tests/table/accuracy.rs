//! f64 against the same interpolant at 60 digits, and both against quadrature.

use mdr_core::contact::Transform;
use mdr_core::number::{Precision, Real};
use mdr_numeric::table::MeasuredProfile;
use rug::Float;

use super::sample::{Points, magnitude, radii, sampled, with_noise};

fn exact(points: &Points) -> MeasuredProfile<Float> {
    let precision = Precision::from_digits(60);
    let number = |value: f64| Float::with_val(precision.bits(), value);
    MeasuredProfile::new(points.iter().map(|&(r, f)| (number(r), number(f))).collect()).unwrap()
}

/// Critical radii: on a knot, just beside it, within the first piece, at the end.
fn probes(points: &Points) -> Vec<f64> {
    let rows = points.len();
    let knots = [1, 2, rows / 3, rows / 2 + 1, rows - 2, rows - 1].map(|i| points[i].0);
    let beside = knots.iter().flat_map(|&r| [r, r.next_down(), r * (1.0 - 1e-9), r * (1.0 - 1e-4)]);
    let above = knots.iter().flat_map(|&r| [r.next_up(), r * (1.0 + 1e-9), r * (1.0 + 1e-4)]);
    let tip = [1e-12, 0.3].map(|part| part * points[1].0);
    let end = points[rows - 1].0;
    beside.chain(above).chain(tip).filter(|&x| x <= end).collect()
}

/// The stated bound on the rounding error: 16 + 2 log₂ rows unit roundoffs of M(x) (for G of x M(x)), or four times as
/// many of its counterpart for g'.
fn assert_bound(points: &Points, probes: &[f64]) {
    let (fast, exact) = (MeasuredProfile::new(points.clone()).unwrap(), exact(points));
    let unit = 1f64.unit_roundoff() * (16.0 + 2.0 * (points.len() as f64).log2());
    for &x in probes {
        let wide = Float::with_val(exact.outer_radius().unwrap().prec(), x);
        let slopes = magnitude(points, x, |_| 1.0);
        let bends = magnitude(points, x, |aspect| 1.0 + aspect);
        let check = |what: &str, value: f64, expected: Float, magnitude: f64| {
            let error = (Float::with_val(wide.prec(), value) - expected).abs().to_f64();
            let rows = points.len();
            assert!(error <= unit * magnitude, "{what}({x}), {rows} rows: {error:e} against {:e}", unit * magnitude);
        };
        check("g", fast.g(&x).unwrap(), exact.g(&wide).unwrap(), x * slopes);
        check("g'", fast.slope(&x).unwrap(), exact.slope(&wide).unwrap(), 4.0 * bends);
        check("G", fast.integral(&x).unwrap(), exact.integral(&wide).unwrap(), x * x * slopes);
    }
}

fn wavy(r: f64) -> f64 {
    0.5 * r * r + 0.01 * (r * 9.0).sin().powi(2)
}

#[test]
fn doubles_are_within_their_bound() {
    for rows in [4, 10, 32, 33, 100, 1000] {
        for jitter in [0.0, 0.3] {
            let smooth = sampled(&radii(rows, 1.0, jitter), wavy);
            let rough = with_noise(smooth.clone(), 0.01);
            let step = sampled(&radii(rows, 1.0, jitter), |r| if r > 0.2 { 1.0 } else { 0.0 });
            for points in [smooth, rough, step] {
                assert_bound(&points, &probes(&points));
            }
        }
    }
}

#[test]
fn the_bound_holds_for_long_tables() {
    for (rows, probes) in [(10_000, 2), (100_000, 1)] {
        let points = with_noise(sampled(&radii(rows, 1.0, 0.3), wavy), 1e-3 / rows as f64);
        let knot = points[rows / 3].0;
        assert_bound(&points, &[knot.next_up(), 0.9173][..probes]);
    }
}

/// Rows at very different distances, between which the slopes of the cubic differ as much as they may.
#[test]
fn the_bound_holds_for_rows_that_crowd() {
    let points = vec![
        (0.0, 0.0),
        (9.51557348569304e-06, -0.1302223460012304),
        (0.09650174750018989, -0.22377537354346008),
        (0.09786535216557188, -0.4279626785019064),
        (0.09786887154736978, -0.7535035425651443),
        (0.10013538439859332, -0.6707126112851008),
    ];
    assert_bound(&points, &[0.0978688715473699]);
}
