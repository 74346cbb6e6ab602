//! Measured profiles on other media against the quadrature of any profile in more bits, and against the half-space.

use mdr_core::contact::{Result, Transform};
use mdr_core::number::{Precision, Real};
use mdr_numeric::table::MeasuredProfile;
use mdr_numeric::transform::Weighted;
use rug::Float;

use super::sample::{Points, magnitude, radii, sampled, with_noise};

fn number(value: f64) -> Float {
    Float::with_val(Precision::from_digits(25).bits(), value)
}

fn rows<R: mdr_core::number::Special>(points: &Points, number: impl Fn(f64) -> R) -> MeasuredProfile<R> {
    MeasuredProfile::new(points.iter().map(|&(r, f)| (number(r), number(f))).collect()).unwrap()
}

fn wavy(r: f64) -> f64 {
    0.5 * r * r + 0.01 * (r * 9.0).sin().powi(2)
}

/// Rows of a smooth profile, uneven, and even ones with noise.
fn tables(rows: usize) -> [Points; 2] {
    [sampled(&radii(rows, 1.0, 0.3), wavy), with_noise(sampled(&radii(rows, 1.0, 0.0), wavy), 0.01)]
}

/// Radii on a row, beside it on either side, within the first piece, and next to the end.
fn probes(points: &Points) -> Vec<f64> {
    let rows = points.len();
    let knots = [1, 2, rows / 2 + 1, rows - 1].map(|i| points[i].0);
    let beside = knots.iter().flat_map(|&r| [r, r.next_down(), r * (1.0 - 1e-9), r * (1.0 - 1e-3)]);
    let above = knots.iter().flat_map(|&r| [r.next_up(), r * (1.0 + 1e-9), r * (1.0 + 1e-2)]);
    let tip = [1e-12, 0.3].map(|part| part * points[1].0);
    let end = points[rows - 1].0;
    beside.chain(above).chain(tip).filter(|&x| x < end).collect()
}

/// Compares all values at the probes, with the bound of rounding errors on a half-space over the mean of the weight, 1 + k; where
/// the quadrature converges, which is all but one radius in fifty.
fn compare<R: Real>(
    points: &Points,
    order: f64,
    fast: &dyn Transform<f64>,
    slow: &dyn Transform<R>,
    number: impl Fn(f64) -> R,
) {
    let unit = 1f64.unit_roundoff() * (16.0 + 2.0 * (points.len() as f64).log2()) / order;
    let (mut open, probes) = (0, probes(points));
    for &x in &probes {
        let wide = number(x);
        let slopes = magnitude(points, x, |_| 1.0);
        let bends = magnitude(points, x, |aspect| 1.0 + aspect);
        let mut check = |what: &str, found: Result<f64>, expected: Result<R>, magnitude: f64| {
            let Ok(expected) = expected else { return open += 1 };
            let error = (expected.lit(0) + number(found.unwrap()) - expected).abs().approx();
            assert!(
                error <= unit * magnitude,
                "{what}({x}), {} rows: {error:e} against {:e}",
                points.len(),
                unit * magnitude
            );
        };
        check("g", fast.g(&x), slow.g(&wide), x * slopes);
        check("g'", fast.slope(&x), slow.slope(&wide), 4.0 * bends);
        check("the mean", fast.mean(&x), slow.mean(&wide), x * slopes);
        check("g over its mean", fast.above_mean(&x), slow.above_mean(&wide), x * slopes);
    }
    assert!(50 * open <= 4 * probes.len() as i32, "{open} open");
}

#[test]
fn graded_half_spaces_meet_the_quadrature_of_any_profile() {
    for points in [4, 10, 33].map(tables).as_flattened() {
        for k in [-0.7, 0.0, 0.5] {
            let fast = rows(points, |x| x).graded(k).unwrap();
            compare(points, 1.0 + k, &fast, &Weighted::graded(rows(points, number), number(k)), number);
        }
    }
}

#[test]
fn winkler_foundations_meet_the_quadrature_of_any_profile() {
    for points in [4, 10, 33].map(tables).as_flattened() {
        let fast = rows(points, |x| x).winkler().unwrap();
        compare(points, 1.0, &fast, &Weighted::winkler(rows(points, number), number(1.0)), number);
    }
}

/// Against a reference that is far, next to the rows, and among them, where its pole is near.
#[test]
fn line_contacts_meet_the_quadrature_of_any_profile() {
    for points in [4, 10, 33].map(tables).as_flattened() {
        for reference in [None, Some(30.0), Some(1.02)] {
            let fast = rows(points, |x| x).line(reference).unwrap();
            let slow = Weighted::line(rows(points, number), reference.map(number), number(1.0));
            compare(points, 1.0, &fast, &slow, number);
        }
    }
}

/// With clusters: k = 0 is the half-space, whose transform has closed moments.
#[test]
fn a_constant_modulus_is_the_half_space() {
    for points in [100, 1000].map(tables).as_flattened() {
        let half_space = rows(points, |x| x);
        compare(points, 0.5, &half_space.clone().graded(0.0).unwrap(), &half_space, |x| x);
    }
}

/// More bits take more nodes, and no clusters.
#[test]
fn more_bits_are_right() {
    let points = &tables(10)[0];
    let [few, many] = [25, 60].map(|digits| {
        let number = |value: f64| Float::with_val(Precision::from_digits(digits).bits(), value);
        rows(points, number).graded(number(0.3)).unwrap().g(&number(0.77)).unwrap()
    });
    let error = (many.clone() - few).abs() / many;
    assert!(error < 1e-23 && error > 0, "{error}");
}
