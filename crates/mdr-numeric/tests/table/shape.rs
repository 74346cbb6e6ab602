//! The interpolant preserves the shape of the data; the transform is independent of units; invalid profiles are
//! rejected.

use mdr_core::contact::{Error, Profile, Transform};
use mdr_core::number::{Dual, Real};
use mdr_numeric::table::MeasuredProfile;
use proptest::prelude::*;

use super::sample::Points;

/// Points from steps in r and f, the tip first when `tip`.
fn points(steps: &[(f64, f64)], tip: bool) -> Points {
    let mut last = (0.0, 0.0);
    let walk = steps.iter().map(|(dr, df)| {
        last = (last.0 + dr, last.1 + df);
        last
    });
    let tip = tip.then_some((0.0, 0.0));
    tip.into_iter().chain(walk).collect()
}

/// Steps of very different sizes, heights from `rise`.
fn steps(rise: std::ops::Range<f64>, rows: std::ops::Range<usize>) -> impl Strategy<Value = Vec<(f64, f64)>> {
    let width = (-6.0..1.0f64).prop_map(f64::exp);
    prop::collection::vec((width, rise), rows)
}

/// f and f' along the profile.
fn walk(profile: &MeasuredProfile<f64>) -> impl Iterator<Item = Dual<f64>> + '_ {
    let end = Profile::outer_radius(profile).unwrap();
    (0..=1000).map(move |i| profile.height(&Dual::variable((end * f64::from(i) / 1000.0).min(end))))
}

proptest! {
    #[test]
    fn passes_through_the_rows(steps in steps(-1.0..1.0, 4..60), tip: bool) {
        let points = points(&steps, tip);
        let profile = MeasuredProfile::new(points.clone()).unwrap();
        let highest = points.iter().fold(0f64, |highest, (_, f)| highest.max(f.abs()));
        for (r, f) in points {
            // At the upper end of a piece: Horner in s = 1, four terms of at most 9 |Δf| and |f|.
            prop_assert!((profile.height(&r) - f).abs() <= 64.0 * r.unit_roundoff() * highest);
        }
    }

    #[test]
    fn monotone_data_give_a_monotone_profile(steps in steps(0.0..1.0, 4..60), tip: bool) {
        let points = points(&steps, tip);
        let steepest = steps.iter().fold(0f64, |steepest, (dr, df)| steepest.max(df / dr));
        let profile = MeasuredProfile::new(points).unwrap();
        for f in walk(&profile) {
            // f' may touch zero; its coefficients are of the size of the steepest secant.
            prop_assert!(f.slope >= -64.0 * steepest.unit_roundoff() * steepest, "{f:?}");
        }
    }

    #[test]
    fn no_overshoot(steps in steps(-1.0..1.0, 4..60)) {
        let points = points(&steps, true);
        let profile = MeasuredProfile::new(points.clone()).unwrap();
        let heights = points.iter().map(|point| point.1);
        let (low, high) = (heights.clone().fold(0.0, f64::min), heights.fold(0.0, f64::max));
        let rounding = 64.0 * low.unit_roundoff() * (high - low);
        for f in walk(&profile) {
            prop_assert!(f.value >= low - rounding && f.value <= high + rounding, "{f:?} in {low}..{high}");
        }
    }

    #[test]
    fn powers_of_two_change_no_bit(steps in steps(-1.0..1.0, 4..120), tip: bool, at in 1e-3..1.0f64, a in -40..40i32, b in -40..40i32) {
        let points = points(&steps, tip);
        let (lateral, vertical) = (2f64.powi(a), 2f64.powi(b));
        let scaled = points.iter().map(|(r, f)| (r * lateral, f * vertical)).collect();
        let (profile, scaled) = (MeasuredProfile::new(points).unwrap(), MeasuredProfile::new(scaled).unwrap());
        let x = at * Transform::outer_radius(&profile).unwrap();
        let wide = x * lateral;
        prop_assert_eq!(scaled.g(&wide).unwrap(), profile.g(&x).unwrap() * vertical);
        prop_assert_eq!(scaled.slope(&wide).unwrap(), profile.slope(&x).unwrap() / lateral * vertical);
        prop_assert_eq!(scaled.integral(&wide).unwrap(), profile.integral(&x).unwrap() * lateral * vertical);
    }
}

fn refusal(points: &[(f64, f64)]) -> String {
    MeasuredProfile::new(points.to_vec()).unwrap_err().to_string()
}

#[test]
fn what_is_no_profile_is_refused() {
    let good = [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)];
    assert_eq!(refusal(&good[..3]), "rows of the table must be at least 4, got 3");
    let with = |i: usize, point: (f64, f64)| {
        let mut points = good;
        points[i] = point;
        refusal(&points)
    };
    assert_eq!(with(0, (0.0, 0.5)), "f(0) must be 0: heights are measured from the tip, got 0.5");
    for (i, bad, named) in [
        (0, (-1.0, 0.0), "got -1"),
        (2, (1.0, 2.0), "got 1"),
        (2, (0.5, 2.0), "got 0.5"),
        (2, (f64::NAN, 2.0), "got NaN"),
        (3, (f64::INFINITY, 2.0), "got inf"),
        (3, (3.0, f64::NAN), "got NaN"),
        (3, (3.0, f64::INFINITY), "got inf"),
        (2, (1.0 + f64::EPSILON, f64::MAX), "e308"),
    ] {
        let message = with(i, bad);
        assert!(message.contains("of the table must be finite") && message.ends_with(named), "{message}");
    }
}

#[test]
fn radii_outside_the_table_are_refused() {
    let profile = MeasuredProfile::new(vec![(0.5, 0.1), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]).unwrap();
    for x in [0.0, -1.0, f64::NAN, f64::INFINITY, 3.0f64.next_up()] {
        assert!(matches!(profile.g(&x), Err(Error::Domain { .. })), "{x}");
        assert!(profile.slope(&x).is_err() && profile.integral(&x).is_err());
    }
    assert!(profile.g(&3.0).is_ok() && profile.g(&1e-100).is_ok());
}

#[test]
fn extreme_scales_are_exact_or_refused() {
    // 2^±500 m: g is a number, G of the small one is not.
    let points = [(0.0, 0.0), (1.0, 1.0), (2.0, 3.0), (3.0, 4.0)];
    let scaled = |k: i32| points.map(|(r, f)| (r * 2f64.powi(k), f * 2f64.powi(k))).to_vec();
    let [small, plain, large] = [-600, 0, 500].map(|k| MeasuredProfile::new(scaled(k)).unwrap());
    let g = plain.g(&2.5).unwrap();
    assert_eq!(small.g(&(2.5 * 2f64.powi(-600))).unwrap(), g * 2f64.powi(-600));
    assert_eq!(large.g(&(2.5 * 2f64.powi(500))).unwrap(), g * 2f64.powi(500));
    let lost = small.integral(&(2.5 * 2f64.powi(-600))).unwrap_err();
    let log10 = plain.integral(&2.5).unwrap().log10() - 1200.0 * 2f64.log10();
    assert!(matches!(lost, Error::OutOfRange { log10: found, .. } if (found - log10).abs() < 1e-9), "{lost}");
}
