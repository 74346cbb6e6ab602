//! Enclosures contain the exact values and hardly more: every operation at a random precision p against values computed
//! at 2p bits, over points, thin and wide intervals.

#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests do")]

use crate::number_support::{PRECISIONS, float, interval_of, right_and_sharp, samples, signed};
use mdr_core::number::{Gamma, Interval, Precision, Real, Special};
use proptest::prelude::*;
use rug::Float;
use rug::float::Constant;
use rug::ops::Pow;

/// Arguments of one kind at any precision.
fn arguments<S, T>(kind: fn(u32) -> S) -> impl Strategy<Value = (u32, T)>
where
    S: Strategy<Value = T> + 'static,
    T: std::fmt::Debug + 'static,
{
    PRECISIONS.prop_flat_map(move |bits| (Just(bits), kind(bits)))
}

/// One property a function of one argument: `name: operation, the same on a float, from which arguments, within how many
/// units in the last place, and with which further samples (interior extrema)`.
macro_rules! unary {
    ($($name:ident: $operation:expr, $reference:expr, $arguments:expr, $ulps:expr, $extrema:expr;)*) => {$(
        proptest! {
            #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 500 / 256))]
            #[test]
            fn $name((bits, x) in arguments($arguments)) {
                let operation: fn(&Interval) -> Interval = $operation;
                let reference: fn(Float) -> Float = $reference;
                let extrema: fn(&Interval) -> Vec<Float> = $extrema;
                let at = samples(&x, 2 * bits).into_iter().chain(extrema(&x));
                let values: Vec<Float> = at.map(|at| Float::with_val(2 * bits, reference(at))).collect();
                right_and_sharp(&operation(&x), &values, $ulps)?;
            }
        }
    )*};
}

fn none(_: &Interval) -> Vec<Float> {
    Vec::new()
}

/// Zero, where the interval contains it.
fn zero(x: &Interval) -> Vec<Float> {
    if x.contains_zero() { vec![Float::new(2 * x.precision())] } else { Vec::new() }
}

/// The first extrema of sin and cos in the interval: multiples of π/2, to far more bits than the argument has.
fn quarter_turns(x: &Interval) -> Vec<Float> {
    let bits = 2 * x.precision() + 500;
    let quarter = Float::with_val(bits, Constant::Pi) / 2u32;
    let first = Float::with_val(bits, x.lower() / &quarter).ceil();
    let turns = (0..5u32).map(|k| Float::with_val(bits, &first + k) * &quarter);
    turns.filter(|at| x.contains(at)).collect()
}

/// The minimum of Γ, as a root of ψ computed with mpmath (OEIS A030169).
fn minimum(bits: u32) -> Float {
    let digits = "1.46163214496836234126265954232572132846819620400644635129598840859878644035380181024307499273372559";
    Float::with_val(bits, Float::parse(digits).unwrap())
}

fn gamma_minimum(x: &Interval) -> Vec<Float> {
    let minimum = minimum(2 * x.precision());
    if x.contains(&minimum) { vec![minimum] } else { Vec::new() }
}

fn any_real(bits: u32) -> impl Strategy<Value = Interval> {
    interval_of(signed(bits, -1000..=1000).boxed())
}
fn ordinary(bits: u32) -> impl Strategy<Value = Interval> {
    interval_of(signed(bits, -80..=20).boxed())
}
fn positive(bits: u32) -> impl Strategy<Value = Interval> {
    interval_of(float(bits, -1000..=1000).boxed())
}
fn above_minus_one(bits: u32) -> impl Strategy<Value = Interval> {
    interval_of(prop_oneof![float(bits, -200..=200), float(bits, -200..=-1).prop_map(|x| -x)].boxed())
}
fn inside_unit(bits: u32) -> impl Strategy<Value = Interval> {
    interval_of(signed(bits, -100..=-1).boxed())
}
fn up_to_unit(bits: u32) -> impl Strategy<Value = Interval> {
    let ends = prop_oneof![9 => signed(bits, -100..=0), 1 => signed(bits, 1..=1)];
    let unit = Interval::new(Float::with_val(bits, -1), Float::with_val(bits, 1));
    interval_of(ends.boxed()).prop_filter_map("outside", move |x| x.intersect(&unit))
}
fn angles(bits: u32) -> impl Strategy<Value = Interval> {
    let wide = (signed(bits, -3..=10), 2.0..7.0).prop_map(|(lo, width)| Interval::new(lo.clone(), lo + width));
    prop_oneof![interval_of(signed(bits, -50..=3).boxed()), interval_of(signed(bits, 0..=300).boxed()), wide]
}
/// Thin and wide intervals on both sides of the minimum of Γ and across it, up to Γ(64).
fn gamma_arguments(bits: u32) -> impl Strategy<Value = Interval> {
    let close = signed(bits, -300..=-2).prop_map(move |x| x + minimum(bits));
    interval_of(prop_oneof![float(bits, -40..=6), float(bits, 1..=1), close].boxed())
}
fn digamma_arguments(bits: u32) -> impl Strategy<Value = Interval> {
    interval_of(prop_oneof![float(bits, -100..=10), float(bits, 1..=1)].boxed())
}

unary! {
    negation: |x| -x.clone(), |x| -x, any_real, 0, none;
    absolute_value: Real::abs, Float::abs, any_real, 0, zero;
    square: Real::square, Float::square, any_real, 1, zero;
    reciprocal: |x| num_traits::Inv::inv(x.clone()), Float::recip, positive, 1, none;
    square_root: Real::sqrt, Float::sqrt, positive, 1, none;
    exponential: Real::exp, Float::exp, ordinary, 1, none;
    exponential_minus_one: Real::exp_m1, Float::exp_m1, ordinary, 1, none;
    logarithm: Real::ln, Float::ln, positive, 1, none;
    logarithm_of_one_plus: Real::ln_1p, Float::ln_1p, above_minus_one, 1, none;
    cube: |x| x.powi(3), |x| x.pow(3), any_real, 1, none;
    fourth_power: |x| x.powi(4), |x| x.pow(4), any_real, 1, zero;
    inverse_square: |x| x.powi(-2), |x| x.pow(-2), positive, 1, none;
    inverse_cube: |x| (-x.clone()).powi(-3), |x| (-x).pow(-3), positive, 1, none;
    sevenfold: |x| x.clone().times(-7), |x| x * -7, any_real, 1, none;
    seventh: |x| x.clone().over(-7), |x| x / -7, any_real, 1, none;
    sine: Special::sin, Float::sin, angles, 1, quarter_turns;
    cosine: Special::cos, Float::cos, angles, 1, quarter_turns;
    arctangent: Special::atan, Float::atan, any_real, 1, none;
    arcsine: Special::asin, Float::asin, up_to_unit, 1, none;
    arccosine: Special::acos, Float::acos, up_to_unit, 1, none;
    hyperbolic_sine: Special::sinh, Float::sinh, ordinary, 1, none;
    hyperbolic_cosine: Special::cosh, Float::cosh, ordinary, 1, zero;
    hyperbolic_tangent: Special::tanh, Float::tanh, any_real, 1, none;
    decimal_logarithm: Special::log10, Float::log10, positive, 1, none;
    area_hyperbolic_tangent: Special::atanh, Float::atanh, inside_unit, 1, none;
    // Two units where the minimum is inside: its lower bound is rounded twice.
    gamma: Gamma::gamma, Float::gamma, gamma_arguments, 2, gamma_minimum;
    log_gamma: Gamma::ln_gamma, Float::ln_gamma, gamma_arguments, 2, gamma_minimum;
    digamma: Gamma::digamma, Float::digamma, digamma_arguments, 1, none;
}

/// The values of an operation at all pairs of samples.
fn table(x: &Interval, y: &Interval, bits: u32, operation: fn(&Float, &Float, u32) -> Float) -> Vec<Float> {
    let ys = samples(y, bits);
    samples(x, bits).iter().flat_map(|x| ys.iter().map(|y| operation(x, y, bits)).collect::<Vec<_>>()).collect()
}

fn pairs(bits: u32) -> impl Strategy<Value = (Interval, Interval)> {
    let factor = || prop_oneof![any_real(bits), ordinary(bits), zero_ended(bits)];
    (factor(), factor())
}

/// Intervals that touch zero, and zero itself.
fn zero_ended(bits: u32) -> impl Strategy<Value = Interval> {
    signed(bits, -100..=100).prop_flat_map(move |end| {
        let zero = Float::new(bits);
        let touching = if end > 0 { Interval::new(zero.clone(), end) } else { Interval::new(end, zero.clone()) };
        prop_oneof![Just(touching), Just(Interval::point(zero))]
    })
}

/// Bases on both sides of one and exponents on both sides of zero.
fn powers(bits: u32) -> impl Strategy<Value = (Interval, Interval)> {
    let base = interval_of(prop_oneof![float(bits, 0..=1), float(bits, -100..=100)].boxed());
    let exponent =
        interval_of(prop_oneof![signed(bits, -100..=4), signed(bits, 1..=3).prop_map(|x| x.round())].boxed());
    (base, exponent)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 1000 / 256))]

    #[test]
    fn sum((bits, (x, y)) in arguments(pairs)) {
        let values = table(&x, &y, 2 * bits, |x, y, bits| Float::with_val(bits, x + y));
        right_and_sharp(&(x + y), &values, 1)?;
    }

    #[test]
    fn difference((bits, (x, y)) in arguments(pairs)) {
        let values = table(&x, &y, 2 * bits, |x, y, bits| Float::with_val(bits, x - y));
        right_and_sharp(&(x - y), &values, 1)?;
    }

    #[test]
    fn product((bits, (x, y)) in arguments(pairs)) {
        let values = table(&x, &y, 2 * bits, |x, y, bits| Float::with_val(bits, x * y));
        right_and_sharp(&(x * y), &values, 1)?;
    }

    #[test]
    fn quotient((bits, (x, y)) in arguments(pairs)) {
        if y.contains_zero() {
            prop_assert!((x / y).is_entire());
        } else {
            let values = table(&x, &y, 2 * bits, |x, y, bits| Float::with_val(bits, x / y));
            right_and_sharp(&(x / y), &values, 1)?;
        }
    }

    #[test]
    fn power((bits, (x, y)) in arguments(powers)) {
        let values = table(&x, &y, 2 * bits, |x, y, bits| Float::with_val(bits, Pow::pow(x, y)));
        right_and_sharp(&x.pow(&y), &values, 1)?;
    }

    /// A decimal, which is not a binary fraction, between two neighbouring numbers.
    #[test]
    fn literal(bits in PRECISIONS, numerator in any::<i64>(), denominator in 1_i64..) {
        let rational = rug::Rational::from((numerator, denominator));
        let enclosure = Interval::from_rational(Precision::new(bits), &rational);
        let literal = format!("{numerator}/{denominator}").parse().unwrap();
        prop_assert_eq!(enclosure.to_string(), Interval::from_literal(Precision::new(bits), &literal).to_string());
        prop_assert!(*enclosure.lower() <= rational && rational <= *enclosure.upper());
        right_and_sharp(&enclosure, &[Float::with_val(2 * bits, &rational)], 1)?;
    }

    /// Middle, radius and accuracy describe the interval.
    #[test]
    fn middle_and_radius((bits, x) in arguments(any_real)) {
        let (mid, radius) = (x.mid(), x.radius());
        prop_assert!(x.contains(&mid));
        let reach = |sign: i32| Float::with_val(3000, &mid + Float::with_val(bits, &radius * sign));
        prop_assert!(reach(-1) <= *x.lower() && *x.upper() <= reach(1));
        if !x.is_point() && mid != 0 {
            let relative = Float::with_val(bits, &radius / mid.abs());
            // Exponents bound the quotient within a factor of four.
            let exact = -relative.log2().to_f64();
            let claimed = x.accuracy_bits() as f64;
            prop_assert!(claimed <= exact && exact <= claimed + 3.0, "{claimed} of {exact}");
        }
        let midpoint = x.midpoint();
        prop_assert!(midpoint.is_point() && x.contains(midpoint.lower()));
    }

    /// The entire line contains every value but is never tight, so the tests above can fail.
    #[test]
    fn entire_line_is_not_sharp(bits in PRECISIONS, value in -1e9..1e9) {
        let entire = Interval::entire(Precision::new(bits));
        prop_assert!(right_and_sharp(&entire, &[Float::with_val(2 * bits, value)], 1000).is_err());
    }
}
