//! Near n = 1/2, and at the limits of the kernel.

use mdr_analytic::double::grid::InstructionSet;

use super::answers::{answers, worst};
use super::points::{CONTROLS, Point, loaded, representable};

#[test]
fn ladder_towards_one_half() {
    let mut points = Vec::new();
    for k in 2..=50 {
        for n in [0.5 + 2f64.powi(-k), 0.5 - 2f64.powi(-k)] {
            for (e, w, a) in [(1e6, 0.05, 1e-3), (1e20, 1e-20, 1e-40), (1.0, 1.0, 1.0), (1e200, 1e-100, 1e-40)] {
                points.push(Point::with_radius(n, e, w, a));
            }
        }
    }
    for path in InstructionSet::available() {
        for control in &CONTROLS {
            // The rounding of C changes a, for the largest k out of range.
            let points = representable(loaded(&points, control), control);
            assert!(points.len() > 250, "{}", points.len());
            let (_, tally) = worst(&points, path, control);
            assert!(tally.passed_on < points.len() / 2, "{} of {}", tally.passed_on, points.len());
        }
    }
}

fn two(k: i32) -> f64 {
    2f64.powi(k)
}

/// Both sides of every limit of the kernel.
fn edges() -> Vec<Point> {
    let about = |x: f64| [x.next_down(), x, x.next_up()];
    let mut points = Vec::new();
    for n in about(two(-30)).into_iter().chain(about(512.0)).chain(about(0.5 + two(-37))).chain(about(0.5 - two(-37))) {
        for a in [1e-80, 1.0, 1e80] {
            points.push(Point::with_radius(n, 1.0, 1.0, a));
        }
    }
    for (c, n) in [(two(-390), 2.0), (two(390), 2.0), (two(-390), 3e-9), (two(390), 300.0)] {
        points.extend(about(c).map(|c| Point { n, c, e: 1.0, w: 1.0 }));
    }
    for x in [two(-80), two(80)] {
        for y in [two(-80), 1.0, two(80)] {
            points.extend(about(x).map(|e| Point { n: 2.0, c: 1.0, e, w: y }));
            points.extend(about(x).map(|w| Point { n: 0.3, c: 1.0, e: y, w }));
        }
    }
    for a in [-200.0, 200.0] {
        points.extend([a - 1e-9, a + 1e-9].map(|a: f64| Point::with_radius(1.3, 1.0, 1.0, a.exp())));
    }
    points
}

/// Whether the kernel computes a point of this radius itself.
fn ordinary(p: &Point, radius: f64) -> bool {
    (two(-30)..=512.0).contains(&p.n)
        && (2.0 * p.n - 1.0).abs() >= two(-36)
        && (two(-390)..=two(390)).contains(&p.c)
        && [p.e, p.w].iter().all(|x| (two(-80)..=two(80)).contains(x))
        && radius.ln().abs() <= 200.0
}

#[test]
fn the_limits_of_the_kernel() {
    for path in InstructionSet::available() {
        for control in &CONTROLS {
            let points = representable(edges(), control);
            worst(&points, path, control);
            let mut passed_on = 0;
            for p in points {
                let answers = answers(&[p], path, control);
                let expected = usize::from(!ordinary(&p, answers.at(0)[1]));
                assert_eq!(answers.tally.passed_on, expected, "{p:?} under {control:?} by {path}");
                passed_on += expected;
            }
            assert!((20..70).contains(&passed_on), "{passed_on}");
        }
    }
}
