//! The edges of interval arithmetic: domains, infinities, huge arguments, and known pitfalls of rigorous code.

#![cfg(feature = "mp")]

use mdr_core::number::{Dual, Gamma, Interval, Lift, Precision, Real, Special};
use num_traits::Inv;
use rug::Float;
use rug::float::Round;

const BITS: u32 = 80;

fn interval(lo: f64, hi: f64) -> Interval {
    Interval::new(Float::with_val(BITS, lo), Float::with_val(BITS, hi))
}

fn int(value: i64) -> Interval {
    Interval::from_int(Precision::new(BITS), value)
}

fn entire() -> Interval {
    Interval::entire(Precision::new(BITS))
}

type Function = fn(&Interval) -> Interval;

/// Every function of one argument, with an interval that leaves its domain in part, if there is one.
fn functions() -> Vec<(&'static str, Function, Option<Interval>)> {
    vec![
        ("neg", |x| -x.clone(), None),
        ("inv", |x| x.clone().inv(), Some(interval(-1.0, 2.0))),
        ("abs", Real::abs, None),
        ("square", Real::square, None),
        ("sqrt", Real::sqrt, Some(interval(-1e-30, 4.0))),
        ("exp", Real::exp, None),
        ("exp_m1", Real::exp_m1, None),
        ("ln", Real::ln, Some(interval(0.0, 1.0))),
        ("ln_1p", Real::ln_1p, Some(interval(-1.0, 1.0))),
        ("pow", |x| x.pow(&int(2)), Some(interval(-1.0, 1.0))),
        ("powi", |x| x.powi(2), None),
        ("powi(-1)", |x| x.powi(-1), Some(interval(0.0, 1.0))),
        ("times", |x| x.clone().times(0), None),
        ("over", |x| x.clone().over(3), None),
        ("sin", Special::sin, None),
        ("cos", Special::cos, None),
        ("atan", Special::atan, None),
        ("asin", Special::asin, Some(interval(0.5, 1.0 + 1e-12))),
        ("acos", Special::acos, Some(interval(-1.0 - 1e-12, 0.0))),
        ("sinh", Special::sinh, None),
        ("cosh", Special::cosh, None),
        ("tanh", Special::tanh, None),
        ("log10", Special::log10, Some(interval(0.0, 1.0))),
        ("atanh", Special::atanh, Some(interval(0.0, 1.0))),
        ("gamma", Gamma::gamma, Some(interval(0.0, 1.0))),
        ("ln_gamma", Gamma::ln_gamma, Some(interval(-0.5, 3.0))),
        ("digamma", Gamma::digamma, Some(interval(0.0, 3.0))),
    ]
}

/// A finite enclosure proves that the argument lay in the domain.
#[test]
fn leaving_the_domain_leaves_nothing() {
    for (name, function, outside) in functions() {
        assert!(function(&entire()).is_entire(), "{name} of the entire line");
        if let Some(outside) = outside {
            assert!(function(&outside).is_entire(), "{name}({outside:?})");
        }
    }
    let operations: [fn(Interval, &Interval) -> Interval; 4] = [|x, y| x + y, |x, y| x - y, |x, y| x * y, |x, y| x / y];
    for operation in operations {
        for known in [int(0), int(3), interval(-1.0, 2.0)] {
            assert!(operation(known.clone(), &entire()).is_entire(), "{known:?} and the entire line");
            assert!(operation(entire(), &known).is_entire(), "the entire line and {known:?}");
        }
    }
    assert!(int(2).pow(&entire()).is_entire() && entire().pow(&int(2)).is_entire());
    assert!((int(1) / int(0)).is_entire() && int(1).over(0).is_entire() && (int(0) / int(0)).is_entire());
    assert!(int(0).pow(&int(0)).is_entire() && int(0).pow(&int(-1)).is_entire());
    assert!(int(0).powi(-3).is_entire());
}

/// Unbounded arguments give neither NaN nor reversed ends.
#[test]
fn ends_are_ordered_numbers_everywhere() {
    let ends = [f64::NEG_INFINITY, -1e300, -1.0, -0.0, 0.0, 1e-300, 1.0, 1.5, 1e300, f64::INFINITY];
    let mut intervals = vec![];
    for lo in ends {
        intervals.extend(ends.iter().map(|&hi| interval(lo, hi)));
    }
    let check = |result: Interval, what: &dyn Fn() -> String| {
        assert!(result.lower() <= result.upper(), "{}: {result:?}", what());
        assert!(*result.lower() < f64::INFINITY && *result.upper() > f64::NEG_INFINITY, "{}: {result:?}", what());
    };
    for x in &intervals {
        for (name, function, _) in functions() {
            check(function(x), &|| format!("{name}({x:?})"));
        }
        for y in &intervals {
            check(x.clone() + y, &|| format!("{x:?} + {y:?}"));
            check(x.clone() - y, &|| format!("{x:?} - {y:?}"));
            check(x.clone() * y, &|| format!("{x:?} * {y:?}"));
            check(x.clone() / y, &|| format!("{x:?} / {y:?}"));
            check(x.pow(y), &|| format!("{x:?} ^ {y:?}"));
            check(x.clone().inflate(y), &|| format!("{x:?} inflated by {y:?}"));
        }
    }
}

#[test]
fn not_an_interval_is_the_entire_line() {
    assert!(interval(f64::NAN, 1.0).is_entire());
    assert!(interval(2.0, 1.0).is_entire());
    assert!(interval(f64::INFINITY, f64::INFINITY).is_entire());
    assert!(Interval::from_f64(Precision::new(BITS), f64::NAN).is_entire());
    assert!(Interval::from_f64(Precision::new(BITS), f64::INFINITY).is_entire());
    assert!(entire().mid().is_nan() && entire().midpoint().is_entire());
}

/// Overflow and underflow keep the bound on one side.
#[test]
fn beyond_the_range_of_exponents() {
    let huge = int(10).powi(400).exp();
    assert!(huge.lower().is_finite() && huge.upper().is_infinite());
    let tiny = (-int(10).powi(400)).exp();
    assert!(*tiny.lower() == 0 && *tiny.upper() > 0);
    assert!(!huge.is_finite() && (int(1) / &huge).is_finite());
    // Each number of an unbounded set times zero is zero; of the entire line nothing is known.
    for product in [int(0) * &huge, huge.clone() * int(0), int(0) * -huge] {
        assert!(product.is_point() && product.contains_zero());
    }
    assert!((int(0) * entire()).is_entire() && (entire() * int(0)).is_entire());
}

/// Exact results stay points.
#[test]
fn exact_results_are_points() {
    let exact = [
        int(7) + int(5),
        int(7) * int(-5),
        int(21) / int(7),
        int(2).powi(-3),
        int(9).sqrt(),
        int(9).pow(&int(1).over(2)),
        int(0).exp(),
        int(1).ln(),
        int(0).sin(),
        int(0).cos(),
        int(1).acos(),
        int(6).gamma(),
        int(2).ln_gamma(),
        int(3).times(i64::MIN),
        int(0).abs().square(),
    ];
    let values = [12.0, -35.0, 3.0, 0.125, 3.0, 3.0, 1.0, 0.0, 0.0, 1.0, 0.0, 120.0, 0.0, i64::MIN as f64 * 3.0, 0.0];
    for (enclosure, value) in exact.iter().zip(values) {
        assert!(enclosure.is_point() && enclosure.approx() == value, "{enclosure:?} is not {value}");
    }
    assert!(!int(2).sqrt().is_point() && !int(1).over(3).is_point());
}

/// An integer that does not fit is enclosed.
#[test]
fn ends_are_rounded_outward_from_the_start() {
    let coarse = Interval::from_int(Precision::new(8), 1001);
    assert!(*coarse.lower() < 1001 && 1001 < *coarse.upper());
    let third = Interval::from_literal(Precision::new(8), &"1/3".parse().unwrap());
    assert!(third.lower().clone() * 3 < 1 && Float::with_val(20, third.upper() * 3) > 1);
    // A constant of higher precision is not rounded to nearest.
    let mut sum = Interval::from_int(Precision::new(8), 1);
    sum += &Interval::point(Float::with_val(60, 1e-9));
    assert!(*sum.lower() == 1 && *sum.upper() > 1);
}

/// The corners of x^y where ln x and y change their signs.
#[test]
fn power_across_one_and_zero() {
    let image = interval(0.5, 2.0).pow(&interval(-1.0, 3.0));
    assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (0.125, 8.0));
    let image = interval(0.5, 2.0).pow(&interval(-3.0, 1.0));
    assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (0.125, 8.0));
    let image = interval(0.25, 0.5).pow(&interval(-1.0, 2.0));
    assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (0.0625, 4.0));
    let image = interval(0.0, 2.0).pow(&interval(0.5, 2.0));
    assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (0.0, 4.0));
}

#[test]
fn even_powers_across_zero() {
    for (exponent, greatest) in [(2, 9.0), (4, 81.0)] {
        let image = interval(-3.0, 2.0).powi(exponent);
        assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (0.0, greatest));
    }
    let image = interval(-3.0, 2.0).powi(3);
    assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (-27.0, 8.0));
}

/// Γ(1.46163…) = 0.88560319441088870027881590058…: contained where the interval spans the minimum, and tight there.
#[test]
fn gamma_across_its_minimum() {
    let least = Float::with_val(200, Float::parse("0.88560319441088870027881590058").unwrap());
    for x in [interval(1.0, 2.0), interval(1.4616, 1.4617), interval(1.461632144968362, 1.4616321449683625)] {
        let image = x.gamma();
        assert!(*image.lower() <= least && *image.lower() > least.clone() - 1e-22, "{image:?}");
    }
    assert_eq!(interval(1.0, 2.0).gamma().upper().to_f64(), 1.0);
    assert!(interval(1.0, 2.0).ln_gamma().contains(&least.ln()));
}

/// sin 10²² = −0.8522008497671888017727… (a classic test of argument reduction).
#[test]
fn huge_and_wide_angles() {
    let known = Float::with_val(70, Float::parse("-0.8522008497671888017727").unwrap());
    let sine = int(10).powi(22).sin();
    assert!((sine.mid() - known).abs() < 1e-21 && sine.accuracy_bits() > 70);
    assert!(int(2).powi(100_000).cos().accuracy_bits() > 70);
    let beyond = int(2).powi(1 << 20).sin();
    assert_eq!((beyond.lower().to_f64(), beyond.upper().to_f64()), (-1.0, 1.0));
    // Nearly a whole turn, and far out, where neighbouring numbers are further apart than the period.
    let most = interval(0.0, 6.0).sin();
    assert_eq!((most.lower().to_f64(), most.upper().to_f64()), (-1.0, 1.0));
    // From cos 0 = 1 on either side of 0, over less and more than half a turn.
    for (lo, hi, least) in
        [(0.0, 3.0, -0.9899924966004454), (0.0, 4.0, -1.0), (-3.0, 0.0, -0.9899924966004454), (-4.0, 0.0, -1.0)]
    {
        let image = interval(lo, hi).cos();
        assert_eq!((image.lower().to_f64(), image.upper().to_f64()), (least, 1.0), "cos [{lo}, {hi}]");
    }
    let (low, high) = (2_f64.powi(90), 2_f64.powi(90) * (1.0 + f64::EPSILON));
    assert!(interval(low, high).cos().contains(&Float::with_val(BITS, -1)));
    let coarse = Interval::new(Float::with_val(4, 40), Float::with_val(4, 44));
    assert!(coarse.sin().contains(&Float::with_val(60, 42).sin()));
}

/// Comparison is certain or absent.
#[test]
fn comparison() {
    assert!(interval(1.0, 2.0) < interval(2.5, 3.0) && interval(2.5, 3.0) > interval(1.0, 2.0));
    assert!(interval(1.0, 2.0).partial_cmp(&interval(2.0, 3.0)).is_none());
    assert!(int(2) == int(2) && int(2) >= int(2) && interval(1.0, 2.0) != interval(1.0, 2.0));
    assert_eq!(interval(1.0, 2.0).accuracy_bits(), 0);
    assert_eq!(int(2).accuracy_bits(), i64::MAX);
    assert_eq!(interval(-1.0, 1.0).accuracy_bits(), i64::MIN);
}

#[test]
fn sets() {
    let (a, b) = (interval(0.0, 2.0), interval(1.0, 3.0));
    assert_eq!(a.hull(&b).to_string(), interval(0.0, 3.0).to_string());
    assert_eq!(a.intersect(&b).unwrap().to_string(), interval(1.0, 2.0).to_string());
    assert!(a.overlaps(&b) && a.intersect(&interval(2.5, 3.0)).is_none() && !a.overlaps(&interval(2.5, 3.0)));
    assert_eq!(a.inflate(&interval(-0.5, 0.25)).to_string(), interval(-0.5, 2.5).to_string());
}

/// Printing rounds outward, unlike a conversion to f64.
#[test]
fn printing_is_outward() {
    let third = int(1).over(3);
    assert_eq!(format!("{third:.3}"), "[3.33e-1, 3.34e-1]");
    let (down, up) = (third.lower().to_f64_round(Round::Down), third.upper().to_f64_round(Round::Up));
    assert!(down < up);
}

/// The greater and the lesser of two: certain where the order is, an enclosure of both where it is not.
#[test]
fn the_greater_of_two() {
    let (low, wide, high) = (interval(-1.0, 0.0), interval(-0.5, 3.0), interval(1.0, 2.0));
    assert_eq!(low.greater(&high).to_string(), high.to_string());
    assert_eq!(low.lesser(&high).to_string(), low.to_string());
    assert_eq!(wide.greater(&high).to_string(), interval(1.0, 3.0).to_string());
    assert_eq!(wide.lesser(&high).to_string(), interval(-0.5, 2.0).to_string());
    assert_eq!((1.0.greater(&2.0), 1.0.lesser(&2.0), 2.0.lesser(&2.0)), (2.0, 1.0, 2.0));
    assert!(f64::NAN.greater(&1.0).is_nan() && 1.0.lesser(&f64::NAN).is_nan());
    let dual = |value: &Interval, slope| Dual { value: value.clone(), slope: int(slope) };
    assert_eq!(dual(&low, 3).greater(&dual(&high, 5)).slope.to_string(), int(5).to_string());
    // max(x, y) has the slope of either where the two may be equal.
    for other in [&wide, &high] {
        let either = dual(&high, 3).greater(&dual(other, 5)).slope;
        assert!(either.contains(int(3).lower()) && either.contains(int(5).lower()), "{either}");
    }
    let equal = Dual { value: int(1), slope: int(3) }.lesser(&Dual { value: int(1), slope: int(5) });
    assert!(equal.slope.contains(int(3).lower()) && equal.slope.contains(int(5).lower()));
}

/// Across a kink of |x| a derivative is not finite; a truncation bound does not bound the derivative either.
#[test]
fn duals_over_intervals_claim_nothing_unproved() {
    let kink = Dual::variable(interval(-1.0, 2.0)).abs();
    assert_eq!(kink.value.to_string(), interval(0.0, 2.0).to_string());
    assert!(!kink.slope.is_finite());
    assert!(Dual::variable(interval(-2.0, -1.0)).abs().slope == int(-1));
    let x = Dual::variable(int(1));
    let truncated = x.clone().inflate(&Dual::lift(&int(1).over(8)));
    assert_eq!(truncated.value.to_string(), interval(0.875, 1.125).to_string());
    assert!(!truncated.slope.is_finite());
    let bound = Dual { value: int(1).over(8), slope: int(-1).over(4) };
    let truncated = x.inflate_with_slope(&bound);
    assert_eq!(truncated.value.to_string(), interval(0.875, 1.125).to_string());
    assert_eq!(truncated.slope.to_string(), interval(0.75, 1.25).to_string());
    let twice = Dual::variable(Dual::variable(int(1))).inflate_with_slope(&Dual::constant(bound));
    assert!(twice.value.slope.is_finite() && twice.slope.value.is_finite() && !twice.slope.slope.is_finite());
    assert_eq!(Dual::variable(3.0).inflate(&Dual::constant(1.0)).slope, 1.0);
}

/// (r²)ᵏ at the axis, where r² and its slope are zero and its curvature is not: it is no constant, whose power has no slope.
#[test]
fn a_power_of_a_square_has_its_own_curvature_at_the_axis() {
    let square = Dual::variable(Dual::variable(int(0))).square();
    let power = |numerator, denominator| square.pow(&square.ratio(numerator, denominator)).slope.slope;
    assert_eq!([power(2, 1), power(5, 2), power(3, 1)].map(|curvature| curvature.approx()), [0.0; 3]);
    // |r| and |r|^(3/2) have none.
    assert!([power(1, 2), power(3, 4)].iter().all(|curvature| !curvature.is_finite()));
    // 2^y, where the exponent y is zero with its slope and curves by 2: the curvature is 2 ln 2.
    let exponential = square.lit(2).pow(&square).slope.slope;
    assert!((exponential.approx() - 2.0 * 2f64.ln()).abs() < 1e-15, "{exponential}");
}

/// Beside a maximum or minimum of sin and cos the sign of the derivative is known however near the interval comes, and however far out it is.
#[test]
fn an_extremum_is_seen_however_narrow_the_interval() {
    let ctx = Precision::new(320);
    for turns in [0_i64, 1, -2, 3, 1001, -333_334, 700_001, 9_000_002, 1 << 40] {
        let extremum = Interval::from_int(ctx, turns).pi() * &Interval::from_int(ctx, turns).over(2);
        for bits in [-8, -29, -30, -31, -33, -34, -60, -200] {
            let width = Interval::from_int(ctx, 2).powi(bits);
            let [below, above] = [extremum.clone() - &width, extremum.clone() + &width];
            let image = |x: &Interval| if turns % 2 == 0 { x.cos() } else { x.sin() };
            let across = image(&below.hull(&above));
            let size = |x: &Interval| x.lower().clone().abs().max(&x.upper().clone().abs());
            assert_eq!(size(&across), 1, "{turns} quarter turns, 2^{bits}");
            // From one width beside the extremum to two; nearer than 2^-160 the value rounds to 1.
            let beside = image(&above.hull(&(above.clone() + &width)));
            assert!(size(&beside) < 1 || bits < -160, "{turns} quarter turns, 2^{bits}");
        }
    }
}
