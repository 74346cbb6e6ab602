//! Functions over sets around and beside 0, against their values at points.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use mdr_core::number::{Analytic, Euler, Interval, NearZero, Precision, Real, Rectangle};
use proptest::prelude::*;

fn number(value: f64) -> Interval {
    Interval::from_f64(Precision::new(64), value)
}

/// (1 − cos z)/z and (e^z − 1)/z − 1/2, which have no value where z may be 0.
fn quotients<T: Analytic>(z: &T) -> Option<Vec<T>> {
    let one = z.integer(1);
    let exponential = z.exp().minus(&one).quotient(z)?;
    Some(vec![one.minus(&z.sin_cos().1).quotient(z)?, exponential.minus(&one.divided(2))])
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// The values on the boundary bound those inside.
    #[test]
    fn the_boundary_bounds_the_inside(
        left in -2.0..-0.01, right in 0.01..2.0, high in 0.01..2.0, u in 0.0..1.0f64, v in -1.0..1.0,
    ) {
        let set = Rectangle::new(number(left).hull(&number(right)), number(0.0).hull(&number(high)));
        prop_assert!(quotients(&set).is_none());
        let bounds = set.by_boundary(|_| true, quotients).unwrap();
        let inside = Rectangle::new(number(left + (right - left) * u), number(high * v));
        prop_assert!(set.by_boundary(|_| false, quotients).is_none());
        if let Some(values) = quotients(&inside) {
            for (bound, value) in bounds.iter().zip(&values) {
                prop_assert!(bound.re().overlaps(value.re()) && bound.im().overlaps(value.im()));
            }
        }
        prop_assert!(bounds.iter().all(Rectangle::is_bounded));
        let radii = number(0.0).hull(&number(right));
        let bounds = radii.by_boundary(|_| true, quotients).unwrap();
        for (bound, value) in bounds.iter().zip(quotients(&number(right * u.max(1e-3))).unwrap()) {
            prop_assert!(bound.overlaps(&value) && Real::is_finite(bound));
        }
    }

    /// Powers and logarithms, with three Euler derivatives, at radii below the end.
    #[test]
    fn what_is_known_near_zero_holds_at_points(end in -30.0..-0.1, share in 0.0..40.0f64, n in 1..9, m in 1..4) {
        fn functions<T: Analytic>(r: &T, n: i64, m: i64) -> Option<Vec<T>> {
            let one = r.integer(1);
            let half = |k: i64| Real::over(number(1.0).lit(k), 2);
            let log = r.ln()?;
            let beyond = one.plus(&one.quotient(r)?).ln()?;
            Some(vec![
                r.power(&half(n))?.product(&log.raised(m)?),
                r.raised(n)?.product(&beyond).plus(&r.multiplied(3)),
                r.product(&log).exp().minus(&one),
                r.multiplied(2).sqrt()?.product(&log).sin_cos().0,
                log.multiplied(n).exp().product(&log.minus(&one)),
                r.power(&number(0.1).ratio(1, 3))?.product(&r.plus(&one).power(&half(m))?),
            ])
        }
        let (n, m) = (i64::from(n), i64::from(m));
        let end = number(f64::exp(end));
        let known = functions(&Euler::variable(&NearZero::up_to(&end.lit(1), &end).unwrap(), 3), n, m).unwrap();
        let r = end * number((-share).exp());
        let values = functions(&Euler::variable(&r, 3), n, m).unwrap();
        for (index, (known, value)) in known.iter().zip(&values).enumerate() {
            for k in 0..=3 {
                if let Some(range) = known.derivative(k).range() {
                    prop_assert!(range.overlaps(&value.derivative(k)), "{index}, {k}: {range} {}", value.derivative(k));
                } else {
                    prop_assert!(index == 4 || k > 0, "{index}, {k}");
                }
            }
        }
    }
}
