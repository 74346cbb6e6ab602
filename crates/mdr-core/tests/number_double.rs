//! Intervals of doubles contain the truth, which enclosures of 300 bits hold; so do complex rectangles of them.

#![cfg(feature = "mp")]
#![allow(
    clippy::clone_on_copy,
    reason = "each function is written once for doubles and for enclosures, which are cloned"
)]

use mdr_core::number::{Analytic, DoubleInterval, Interval, Precision, Real, Rectangle, Special};
use proptest::prelude::*;
use rug::Float;

/// Bits of the truth.
fn truth() -> Precision {
    Precision::new(300)
}

/// A function over doubles, and over enclosures of many bits.
type Function = (&'static str, fn(&DoubleInterval) -> DoubleInterval, fn(&Interval) -> Interval);

macro_rules! functions {
    ($($name:literal: $function:expr;)*) => { [$(($name, $function, $function)),*] };
}

const ANYWHERE: [Function; 17] = functions! {
    "|x|": Real::abs; "x²": Real::square; "x³": |x| x.powi(3); "x⁴": |x| x.powi(4);
    "7x": |x| x.clone().times(7); "−7x": |x| x.clone().times(-7); "x/7": |x| x.clone().over(7); "−x/7": |x| x.clone().over(-7);
    "eˣ": Real::exp; "eˣ − 1": Real::exp_m1; "sin x": Special::sin; "cos x": Special::cos; "arctan x": Special::atan;
    "sinh x": Special::sinh; "cosh x": Special::cosh; "tanh x": Special::tanh; "x⁰": |x| x.powi(0);
};

const POSITIVE: [Function; 8] = functions! {
    "√x": Real::sqrt; "ln x": Real::ln; "ln(1 + x)": Real::ln_1p; "log₁₀ x": Special::log10;
    "1/x": |x| num_traits::Inv::inv(x.clone()); "x⁻²": |x| x.powi(-2); "x⁻³": |x| x.powi(-3); "π": Real::pi;
};

const WITHIN_ONE: [Function; 4] = functions! {
    "arcsin x": Special::asin; "arccos x": Special::acos; "artanh x": Special::atanh; "ln(1 + x)": Real::ln_1p;
};

/// A number that lies between the ends of an interval as k does between 0 and 1.
fn between(x: &DoubleInterval, k: f64) -> f64 {
    let (lo, hi) = (x.lower(), x.upper());
    (lo + (hi - lo) * k).clamp(lo, hi)
}

/// Both ends of an interval, its middle and the number after its lower end.
fn few_samples(x: &DoubleInterval) -> [f64; 4] {
    [x.lower(), x.upper(), between(x, 0.5), x.lower().next_up().min(x.upper())]
}

/// More numbers of an interval than [`few_samples`] has.
fn samples(x: &DoubleInterval) -> impl Iterator<Item = f64> {
    few_samples(x).into_iter().chain([0.25, 0.75].map(|k| between(x, k)))
}

/// An interval of doubles is refuted by a truth that is certainly outside of it.
fn holds(image: &DoubleInterval, truth: &Interval) -> bool {
    image.is_entire() || !Real::is_finite(truth) || *truth.upper() >= image.lower() && *truth.lower() <= image.upper()
}

fn contained(functions: &[Function], x: &DoubleInterval) -> Result<(), TestCaseError> {
    for (name, function, exact) in functions {
        let image = function(x);
        for at in samples(x) {
            let truth = exact(&Interval::from_f64(truth(), at));
            prop_assert!(holds(&image, &truth), "{name} of {x:?} is {image:?} without {truth}, at {at:e}");
        }
    }
    Ok(())
}

/// A number of either sign, with a binary exponent from a range.
fn number(exponents: std::ops::RangeInclusive<i32>) -> impl Strategy<Value = f64> + Clone {
    let mantissa = prop_oneof![4 => 1.0..2.0f64, 1 => Just(1.0), 1 => Just(2.0f64.next_down())];
    (mantissa, exponents, any::<bool>()).prop_map(|(x, exponent, negative)| {
        let half = exponent / 2;
        let size = x * 2f64.powi(half) * 2f64.powi(exponent - half);
        if negative { -size } else { size }
    })
}

fn interval<S: Strategy<Value = f64> + Clone + 'static>(numbers: S) -> impl Strategy<Value = DoubleInterval> {
    prop_oneof![
        numbers.clone().prop_map(DoubleInterval::point),
        numbers.clone().prop_map(|lo| DoubleInterval::new(lo, lo.next_up().next_up())),
        numbers.clone().prop_map(|end| DoubleInterval::new(end.min(0.0), end.max(0.0))),
        (numbers.clone(), numbers).prop_map(|(a, b)| DoubleInterval::new(a.min(b), a.max(b))),
    ]
}

fn positive(x: DoubleInterval) -> DoubleInterval {
    let size = Real::abs(&x);
    DoubleInterval::new(size.lower().max(f64::MIN_POSITIVE), size.upper().max(f64::MIN_POSITIVE))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn functions_of_any_number(x in interval(number(-30..=12))) {
        contained(&ANYWHERE, &x)?;
    }

    #[test]
    fn functions_near_the_ends_of_the_range(x in interval(number(-1074..=1023))) {
        contained(&ANYWHERE, &x)?;
        contained(&POSITIVE, &positive(x))?;
    }

    #[test]
    fn functions_of_positive_numbers(x in interval(number(-30..=30))) {
        contained(&POSITIVE, &positive(x))?;
    }

    #[test]
    fn functions_within_one(x in interval(number(-40..=-1))) {
        contained(&WITHIN_ONE, &x)?;
    }

    #[test]
    fn operations(x in interval(number(-1074..=1023)), y in interval(number(-1074..=1023))) {
        let [sum, difference, product, quotient] = [x + y, x - y, x * y, x / y];
        for left in samples(&x) {
            for right in samples(&y) {
                let [a, b] = [left, right].map(|end| Interval::from_f64(Precision::new(2300), end));
                let truths = [a.clone() + &b, a.clone() - &b, a.clone() * &b, a.clone() / &b];
                for (image, truth) in [sum, difference, product, quotient].iter().zip(truths) {
                    prop_assert!(holds(image, &truth), "{left:e}, {right:e}: {image:?} without {truth}");
                }
            }
        }
    }

    #[test]
    fn powers(x in interval(number(-8..=8)).prop_map(positive), y in interval(number(-6..=3))) {
        let power = x.pow(&y);
        for base in samples(&x) {
            for exponent in samples(&y) {
                let truth = Interval::from_f64(truth(), base).pow(&Interval::from_f64(truth(), exponent));
                prop_assert!(holds(&power, &truth), "{base}^{exponent}: {power:?}");
            }
        }
    }

    #[test]
    fn rectangles(re in interval(number(-6..=3)), im in interval(number(-6..=2))) {
        let in_doubles = image(&Rectangle::new(re, im));
        for x in few_samples(&re) {
            for y in few_samples(&im) {
                let point = [x, y].map(|end| Interval::from_f64(truth(), end));
                let [x, y] = point;
                for ((name, found), (_, truth)) in in_doubles.iter().zip(image(&Rectangle::new(x.clone(), y.clone()))) {
                    let (Some(found), Some(truth)) = (found, truth) else { continue };
                    let is_inside = holds(found.re(), truth.re()) && holds(found.im(), truth.im());
                    prop_assert!(is_inside, "{name} at {x} + {y}i: {found:?} without {truth:?}");
                }
            }
        }
    }
}

/// Every function over a rectangle.
fn image<I: mdr_core::number::Ends>(z: &Rectangle<I>) -> Vec<(&'static str, Option<Rectangle<I>>)> {
    let third = Interval::from_int(truth(), 1).over(3);
    let (sin, cos) = z.sin_cos();
    let (sinh, cosh) = z.sinh_cosh();
    vec![
        ("z²", Some(z.squared())),
        ("z³", z.raised(3)),
        ("1/z", z.integer(1).quotient(z)),
        ("z^(1/3)", z.power(&third)),
        ("√z", z.sqrt()),
        ("eᶻ", Some(z.exp())),
        ("ln z", z.ln()),
        ("sin z", Some(sin)),
        ("cos z", Some(cos)),
        ("sinh z", Some(sinh)),
        ("cosh z", Some(cosh)),
        ("arctan z", z.atan()),
        ("arcsin z", z.asin()),
        ("artanh z", z.atanh()),
        ("z/3", Some(z.scaled(&third))),
    ]
}

#[test]
fn outside_of_a_domain_nothing_is_known() {
    let across = DoubleInterval::new(-1.0, 4.0);
    for unknown in [
        Real::sqrt(&across),
        Real::ln(&across),
        DoubleInterval::point(1.0) / across,
        Special::asin(&across),
        Special::atanh(&across),
        Real::exp(&DoubleInterval::ENTIRE),
        Real::pow(&across, &across),
        across * DoubleInterval::ENTIRE,
        Real::powi(&across, -1),
        DoubleInterval::new(f64::NAN, 1.0),
    ] {
        assert!(unknown.is_entire(), "{unknown:?}");
    }
}

#[test]
fn an_overflow_keeps_its_lower_end() {
    let huge = Real::exp(&DoubleInterval::point(1e4));
    assert!(huge.lower() > 1e300 && huge.upper() == f64::INFINITY);
    assert_eq!((huge * DoubleInterval::point(0.0)).upper(), 0.0);
    assert!(Real::exp(&DoubleInterval::point(-1e4)).lower() == 0.0);
}

/// What is exactly zero stays so: the image of a flat face has no width.
#[test]
fn zero_stays_exact() {
    let zero = DoubleInterval::point(0.0);
    let wide = DoubleInterval::new(-3.0, 5.0);
    let all = [zero + zero, zero * wide, zero / DoubleInterval::new(1.0, 2.0), Real::square(&zero), Real::sqrt(&zero)];
    assert!(all.iter().all(|image| image.lower() == 0.0 && image.upper() == 0.0), "{all:?}");
    assert!(mdr_core::number::Ends::hypot(&zero, &zero).upper() == 0.0);
}

#[test]
fn an_interval_is_the_tightest_around_another() {
    let third = Interval::from_int(Precision::new(200), 1).over(3);
    let found = DoubleInterval::around(&third);
    assert!(
        found.lower().next_up() == found.upper()
            && found.widened(truth()).contains(&Float::with_val(200, third.lower()))
    );
    assert!(DoubleInterval::around(&Interval::entire(truth())).is_entire());
}
