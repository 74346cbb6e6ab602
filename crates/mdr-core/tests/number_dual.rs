//! Derivatives: of every function, in f64 and as enclosures, against difference quotients at four times the precision
//! and against closed forms.

#![cfg(feature = "mp")]

use mdr_core::number::{Dual, Interval, Precision, Real, Special};
use proptest::prelude::*;
use rug::Float;

/// A function with a name and the range of its arguments in these tests.
type Entry<R> = (&'static str, fn(&R) -> R, std::ops::Range<f64>);

/// Every function of one argument and some compositions, once for all arithmetics.
fn functions<R: Special>() -> Vec<Entry<R>> {
    vec![
        ("abs", R::abs, -4.0..-0.1),
        ("inv", |x| x.clone().inv(), 0.1..4.0),
        ("square", R::square, -4.0..4.0),
        ("sqrt", R::sqrt, 0.1..4.0),
        ("exp", R::exp, -4.0..4.0),
        ("exp_m1", R::exp_m1, -4.0..4.0),
        ("ln", R::ln, 0.1..4.0),
        ("ln_1p", R::ln_1p, -0.9..4.0),
        ("powi(7)", |x| x.powi(7), -2.0..2.0),
        ("powi(-3)", |x| x.powi(-3), 0.1..2.0),
        ("pow(x, 2/3)", |x| x.pow(&x.ratio(2, 3)), 0.1..4.0),
        ("pow(3, x)", |x| x.lit(3).pow(x), -2.0..2.0),
        ("pow(x, x)", |x| x.pow(x), 0.1..3.0),
        ("sin", R::sin, -8.0..8.0),
        ("cos", R::cos, -8.0..8.0),
        ("atan", R::atan, -4.0..4.0),
        ("asin", R::asin, -0.9..0.9),
        ("acos", R::acos, -0.9..0.9),
        ("atanh", R::atanh, -0.9..0.9),
        ("sinh", R::sinh, -4.0..4.0),
        ("cosh", R::cosh, -4.0..4.0),
        ("tanh", R::tanh, -4.0..4.0),
        ("log10", R::log10, 0.1..4.0),
        ("greater", |x| x.greater(&x.square()), 0.1..0.9),
        ("lesser", |x| x.lesser(&x.square()), 0.1..0.9),
        ("times, over", |x| x.clone().times(-5).over(3), -4.0..4.0),
        ("sum, difference", |x| x.exp() + x - x.sin(), -4.0..4.0),
        ("product", |x| x.exp() * x.sin(), -4.0..4.0),
        ("quotient", |x| x.sin() / x.exp(), -4.0..4.0),
        ("π x", |x| x.pi() * x, -4.0..4.0),
    ]
}

/// Bits of the difference quotients; the step is 2^−BITS/4.
const BITS: u32 = 800;

/// f'(x) and f''(x) from central differences with h = 2⁻²⁰⁰. Truncation is below f⁗ h², rounding below f 2⁻⁸⁰⁰/h²: on
/// these ranges, where f and its derivatives stay below 10⁹, both are below 2⁻³⁰⁰.
fn differences(function: fn(&Float) -> Float, x: f64) -> [Float; 2] {
    let x = Float::with_val(BITS, x);
    let h = Float::with_val(BITS, 1) >> (BITS / 4);
    let (below, at, above) = (function(&(x.clone() - &h)), function(&x), function(&(x + &h)));
    let first = (above.clone() - &below) >> 1 << (BITS / 4);
    let second = (above + below - at * 2) << (BITS / 2);
    [first, second]
}

/// At 100 bits the error of the differences, 2⁻³⁰⁰, is far below the last place.
fn close_to(enclosure: &Interval, value: &Float) -> bool {
    let slack = Interval::point(Float::with_val(100, 1) >> 300);
    enclosure.clone().inflate(&slack).contains(value)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 60 / 256))]

    /// First and second derivatives as enclosures: right, and of at least 80 of the 100 bits where they are not small.
    #[test]
    fn derivatives_are_enclosed(t in 0.0..1.0) {
        type Twice = Dual<Dual<Interval>>;
        for ((name, function, range), (_, plain, _)) in functions::<Twice>().into_iter().zip(functions::<Float>()) {
            let x = range.start + t * (range.end - range.start);
            let point = Interval::from_f64(Precision::new(100), x);
            let image = function(&Dual::variable(Dual::variable(point)));
            let [first, second] = differences(plain, x);
            for (enclosure, value) in [(&image.value.slope, &first), (&image.slope.value, &first), (&image.slope.slope, &second)] {
                prop_assert!(close_to(enclosure, value), "{name} at {x}: {enclosure:?} without {value}");
                // Conditioning: the terms of a derivative are below 2⁸ where it can be as small as 2⁻⁴, so that at most 12
                // bits are lost by cancellation; 8 more are left for the roundings.
                let sharp = enclosure.is_point() || enclosure.accuracy_bits() > 80 || value.clone().abs() < 0.0625;
                prop_assert!(sharp, "{name} at {x}: {enclosure:?} is not sharp");
            }
        }
    }

    /// Over a wide interval the derivative at every point inside is enclosed.
    #[test]
    fn derivatives_over_intervals(t in 0.0..0.8, width in 0.0..0.2, inside in 0.0..1.0) {
        for ((name, function, range), (_, plain, _)) in functions::<Dual<Interval>>().into_iter().zip(functions::<Float>()) {
            let at = |t: f64| range.start + t * (range.end - range.start);
            let [lo, hi] = [at(t), at(t + width)].map(|end| Float::with_val(100, end));
            let x = at(t + inside * width).clamp(at(t), at(t + width));
            let image = function(&Dual::variable(Interval::new(lo, hi)));
            let [first, _] = differences(plain, x);
            prop_assert!(close_to(&image.slope, &first), "{name} at {x}: {:?} without {first}", image.slope);
        }
    }

    /// In f64: a slope takes at most six roundings of an ulp each, and 1 − x² for |x| < 0.9 and the difference of two
    /// terms amplify them: at most 16 units in the last place of the largest term, which is at most 16 here where the
    /// slope is smaller.
    #[test]
    fn derivatives_in_f64(t in 0.0..1.0) {
        for ((name, function, range), (_, plain, _)) in functions::<Dual<f64>>().into_iter().zip(functions::<Float>()) {
            let x = range.start + t * (range.end - range.start);
            let slope = function(&Dual::variable(x)).slope;
            let [first, _] = differences(plain, x);
            let error = (Float::with_val(BITS, slope) - &first).abs().to_f64();
            let scale = first.to_f64().abs().max(16.0);
            prop_assert!(error <= 16.0 * f64::EPSILON * scale, "{name} at {x}: {slope} for {first}");
        }
    }
}

/// Closed forms at arguments where they are exact or famous.
#[test]
fn known_derivatives() {
    let at = |x: i64, over: i64| Dual::variable(Interval::from_int(Precision::new(100), x).over(over));
    let rational = |n: i64, d: i64| Interval::from_int(Precision::new(100), n).over(d);
    let root_three = rational(3, 1).sqrt();
    for (slope, known) in [
        (at(2, 1).powi(10).slope, rational(5120, 1)),
        (at(4, 1).sqrt().slope, rational(1, 4)),
        (at(0, 1).exp().slope, rational(1, 1)),
        (at(5, 1).ln().slope, rational(1, 5)),
        (at(1, 1).atan().slope, rational(1, 2)),
        (at(1, 2).asin().slope, rational(2, 1) / &root_three),
        (at(1, 2).acos().slope, rational(-2, 1) / &root_three),
        (at(1, 2).atanh().slope, rational(4, 3)),
        (at(0, 1).sin().slope, rational(1, 1)),
        (at(0, 1).cos().slope, rational(0, 1)),
        // d(x^x) = x^x (ln x + 1).
        (at(2, 1).pow(&at(2, 1)).slope, (rational(2, 1).ln() + rational(1, 1)).times(4)),
    ] {
        assert!(slope.overlaps(&known) && slope.radius() < 1e-26, "{slope:?} is not {known:?}");
    }
}

/// A branch never depends on the derivative.
#[test]
fn comparisons_look_at_values() {
    let (a, b) = (Dual { value: 1.0, slope: 5.0 }, Dual { value: 1.0, slope: -5.0 });
    assert!(a == b && a <= b && a < Dual { value: 2.0, slope: f64::NEG_INFINITY });
}

/// x^y at x = 0 keeps its domain while y is constant: (x^{3/2})' = 0 there.
#[test]
fn powers_at_zero() {
    let zero = Dual::variable(0.0);
    assert_eq!(zero.pow(&zero.ratio(3, 2)).slope, 0.0);
    let zero = Dual::variable(Interval::from_int(Precision::new(64), 0));
    let power = zero.pow(&zero.ratio(3, 2));
    assert!(power.value == Interval::from_int(Precision::new(64), 0) && power.slope == power.value);
}
