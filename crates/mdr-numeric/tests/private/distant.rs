//! Radii that are distant from x, against terms for every kink: two continuations of one function.

use mdr_core::contact::Transform;

use super::*;
use crate::table::Table;

/// A wavy paraboloid in twenty rows up to 1, of which some fall.
fn table(precision: Precision) -> crate::table::MeasuredProfile<Interval> {
    let row = |i: usize| {
        let r = 0.05 * i as f64;
        format!("{r:.2},{:.6}\n", r * r / 2.0 + 0.1 * (1.0 - (9.0 * r).cos()))
    };
    let csv: String = std::iter::once("r,f\n".to_owned()).chain((0..=20).map(row)).collect();
    let table = Table::from_csv(csv.as_bytes()).expect("a table");
    table.profile(precision).expect("rows of a profile")
}

fn both(precision: Precision) -> [Continuation; 2] {
    let profile = || Continuation::new(vec![table(precision).enclosed()]).expect("kinks apart");
    let mut whole = profile();
    whole.distant = None;
    [profile(), whole]
}

fn rectangle(re: [f64; 2], im: [f64; 2]) -> Rectangle {
    let side = |[from, to]: [f64; 2]| {
        let end = |x: f64| Interval::from_f64(Precision::new(BOUND_BITS), x);
        end(from).hull(&end(to))
    };
    Rectangle::new(side(re), side(im))
}

#[test]
fn distant_radii_and_terms_for_every_kink_are_one_function() {
    let ([profile, whole], mut compared) = (both(Precision::new(100)), 0);
    for (x, beyond) in [(0.4301, 8), (0.671, 13), (0.98, 19)] {
        for (height, size) in [(0.0, 1e-9), (0.003, 1e-9), (0.01, 1e-4), (0.02, 1e-3)] {
            let x = rectangle([x, x + size], [height, height + size]);
            let of = |profile: &Continuation| {
                let legs = profile.legs(&x, beyond, None)?;
                Some([profile.g(&x, &legs)?, profile.slope(&x, &legs, false)?])
            };
            let cut = of(&profile).expect("bounded");
            // Terms for every kink lose more bits.
            for (cut, all) in cut.iter().zip(of(&whole).iter().flatten()) {
                assert!(cut.re().overlaps(all.re()) && cut.im().overlaps(all.im()), "{beyond}, {height}, {size}");
                compared += 1;
            }
        }
    }
    assert!(compared >= 8, "{compared}");
}

/// x ∫ f'/√(x² − r²) dr up to a kink and its slope in x, at x + iy, by a midpoint rule.
fn by_midpoints(kink: usize, [x, y]: [f64; 2]) -> [[f64; 2]; 2] {
    const STEPS: usize = 4000;
    let (profile, precision) = (table(Precision::new(64)).enclosed(), Precision::new(64));
    let (mut g, mut slope) = ([0.0; 2], [0.0; 2]);
    let step = 0.05 * (kink + 1) as f64 / STEPS as f64;
    for i in 0..STEPS {
        let r = step * (i as f64 + 0.5);
        let part = profile.part((r / 0.05) as usize).expect("a cubic");
        let rise = part.slopes(&Interval::from_f64(precision, r)).expect("smooth")[1].approx() * step;
        // x² − r², and its square root.
        let (re, im) = (x * x - y * y - r * r, 2.0 * x * y);
        let root = (re.hypot(im).sqrt(), im.atan2(re) / 2.0);
        let (size, angle) = (x.hypot(y) / root.0, y.atan2(x) - root.1);
        let (sharp, turn) = (-r * r / root.0.powi(3), -3.0 * root.1);
        for (sum, size, angle) in [(&mut g, size, angle), (&mut slope, sharp, turn)] {
            sum[0] += rise * size * angle.cos();
            sum[1] += rise * size * angle.sin();
        }
    }
    [g, slope]
}

#[test]
fn distant_radii_have_the_share_that_they_have_by_quadrature() {
    let [profile, _] = both(Precision::new(100));
    let distant = profile.distant.as_ref().expect("many kinks");
    for (x, kink) in [(0.4301, 4), (0.671, 9), (0.93, 14), (0.98, 15)] {
        for y in [0.0, 0.01, 0.05] {
            let place = rectangle([x, x], [y, y]);
            let found = [distant.g(&place, kink), distant.slope(&place, kink)].map(|set| set.expect("bounded"));
            for (found, wanted) in found.iter().zip(by_midpoints(kink, [x, y])) {
                for (side, wanted) in [found.re(), found.im()].into_iter().zip(wanted) {
                    let near = Interval::from_f64(Precision::new(64), wanted);
                    let near = near.inflate(&Interval::from_f64(Precision::new(64), 1e-6));
                    assert!(side.overlaps(&near), "{kink}, {y}: {side} without {wanted}");
                }
            }
        }
    }
}

/// Seen from far away the share of f = r is the radius up to which it counts.
#[test]
fn all_radii_up_to_a_kink_count_once() {
    let breaks: Vec<Interval> = (1..=20).map(|k| Interval::from_int(Precision::new(64), k)).collect();
    let distant = Distant::new(&breaks, |radii, _| Some(radii.lit(1))).expect("many kinks");
    for kink in 0..20 {
        for x in [21.0, 1e6] {
            let g = distant.g(&rectangle([x, x], [0.0, 0.0]), kink).expect("bounded");
            let arc = x * ((kink + 1) as f64 / x).asin();
            assert!(g.re().overlaps(&Interval::from_f64(Precision::new(64), arc)), "{kink}, {x}: {}", g.re());
            assert!(x < 1e3 || g.re().accuracy_bits() > 30, "{kink}: {}", g.re());
        }
    }
}

#[test]
fn the_bounds_hold_g_at_real_radii() {
    let precision = Precision::new(100);
    let ([profile, _], transform) = (both(precision), table(precision));
    for beyond in 9..20 {
        let from = 0.05 * beyond as f64;
        for share in [0.1, 0.5, 0.9] {
            let x = from + 0.05 * share;
            let cell = rectangle([x, x + 0.002], [0.0, 0.0]);
            let legs = profile.legs(&cell, beyond, None).expect("beyond the kinks");
            let [g, slope] =
                [profile.g(&cell, &legs), profile.slope(&cell, &legs, false)].map(|set| set.expect("bounded"));
            for at in [x, x + 0.001, x + 0.002] {
                let at = Interval::from_f64(precision, at);
                assert!(g.re().overlaps(&transform.g(&at).expect("a number")), "{beyond}, {share}");
                assert!(slope.re().overlaps(&transform.slope(&at).expect("a number")), "{beyond}, {share}");
            }
        }
    }
}
