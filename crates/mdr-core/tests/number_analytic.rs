//! Functions over sets around and beside 0, against their values at points.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use mdr_core::number::{Analytic, DoubleInterval, Euler, Interval, NearZero, Precision, Real, Rectangle};
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

    /// tanh on rectangles and intervals contains its values at points, which are those of sinh/cosh, with two derivatives.
    #[test]
    fn hyperbolic_tangents_hold_at_points(
        left in -4.0..4.0f64, width in 0.0..1.0f64, low in -0.7..0.7f64, high in 0.0..0.7f64, u in 0.0..1.0f64, v in 0.0..1.0f64,
    ) {
        let set = Rectangle::new(number(left).hull(&number(left + width)), number(low).hull(&number(low + high)));
        let point = Rectangle::new(number(left + width * u), number(low + high * v));
        let (sinh, cosh) = point.sinh_cosh();
        let truth = sinh.quotient(&cosh).unwrap();
        if let Some(value) = set.tanh() {
            prop_assert!(value.re().overlaps(truth.re()) && value.im().overlaps(truth.im()));
        }
        let near = point.tanh().unwrap();
        prop_assert!(near.re().overlaps(truth.re()) && near.re().radius() < 1e-15, "{near:?} {truth:?}");
        let real = number(left + width * u);
        let [found, divided] = [
            Euler::variable(&real, 2).tanh().unwrap(),
            { let (sinh, cosh) = Euler::variable(&real, 2).sinh_cosh(); sinh.quotient(&cosh).unwrap() },
        ];
        for k in 0..=2 {
            prop_assert!(found.derivative(k).overlaps(&divided.derivative(k)));
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

/// Far from 0 cosh has no bound among doubles, and tanh and a logistic step are ±1 and 0 or 1.
#[test]
fn steps_are_known_far_away() {
    let far = |x: f64| DoubleInterval::point(x - 200.0).hull(&DoubleInterval::point(x + 200.0));
    let high = DoubleInterval::point(0.0).hull(&DoubleInterval::point(200.0));
    for sign in [-1.0, 1.0] {
        let tanh = Rectangle::new(far(1e5 * sign), high).tanh().unwrap();
        assert!(tanh.re().lower() <= sign && sign <= tanh.re().upper(), "{tanh:?}");
        let [width, height] = [tanh.re(), tanh.im()].map(|part| part.upper() - part.lower());
        // A dozen roundings, half of them on each side.
        assert!(width < 16.0 * f64::EPSILON && height < f64::MIN_POSITIVE, "{tanh:?}");
    }
    for (formula, truths) in [("1/(1 + exp((0.5 - r)/1e-5))", [0.0, 1.0]), ("1/cosh((r - 0.5)/1e-5)", [0.0, 0.0])] {
        let formula: mdr_core::contact::Expression = formula.parse().unwrap();
        let none = Default::default();
        let precision = Precision::new(64);
        let enclosed = formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
        let step = enclosed.part(0).unwrap();
        for (centre, truth) in [0.3, 0.7].into_iter().zip(truths) {
            let re = DoubleInterval::point(centre - 0.1).hull(&DoubleInterval::point(centre + 0.1));
            let value =
                step.at(&Rectangle::new(re, DoubleInterval::point(0.0).hull(&DoubleInterval::point(0.1)))).unwrap();
            let off = [value.re().lower() - truth, value.re().upper() - truth, value.im().lower(), value.im().upper()];
            assert!(off.iter().all(|off| off.abs() < 16.0 * f64::EPSILON), "{centre}: {value:?}");
        }
    }
}
