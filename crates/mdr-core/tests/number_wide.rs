//! Containment and tightness against MPFR: the true value lies within the error bound, and the bound is small.

#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use mdr_core::number::{Extended, Literal, Real};
use quickcheck::{Arbitrary, Gen, quickcheck};
use rug::Float;
use rug::ops::Pow;

const BITS: u32 = 700;

/// The bounds are rounded doubles, as `nearest_f64` assumes.
const SLACK: f64 = 1.0 + 1024.0 * f64::EPSILON;

fn float(value: f64) -> Float {
    Float::with_val(BITS, value)
}

/// The largest error of a number with a significand, in units of 2^(−64N): an eighth of the number.
fn error_limit<const N: usize>() -> f64 {
    2f64.powi(64 * N as i32 - 3)
}

fn is_around_zero<const N: usize>(x: &Extended<N>) -> bool {
    x.error() == f64::INFINITY
}

/// The stored value.
fn stored<const N: usize>(x: &Extended<N>) -> Float {
    let mut value = float(0.0);
    for (i, &limb) in x.limbs().iter().enumerate() {
        value += Float::with_val(BITS, limb) << (64 * i as u32);
    }
    value >>= 64 * N as u32;
    value *= Float::with_val(BITS, 2).pow(x.exponent());
    if *x < Extended::from(0.0) { -value } else { value }
}

/// |true − stored| in units of 2^(−64N)|stored|.
fn units<const N: usize>(x: &Extended<N>, truth: &Float) -> f64 {
    let value = stored(x);
    if value == *truth {
        return 0.0;
    }
    ((Float::with_val(BITS, truth - &value) / value).abs() << (64 * N as u32)).to_f64()
}

/// The true value is contained, and the bound is at most `tight`.
#[track_caller]
fn check<const N: usize>(x: &Extended<N>, truth: &Float, tight: f64) {
    assert!(x.is_finite(), "nothing known instead of {truth}");
    if is_around_zero(x) {
        assert!(truth.clone().abs() <= Float::with_val(BITS, 2).pow(x.exponent()), "{truth} is not around zero");
        return;
    }
    assert!(
        units(x, truth) <= x.error() * SLACK,
        "N = {N}: {} units off, bound {}: {truth}",
        units(x, truth),
        x.error()
    );
    assert!(x.error() <= tight, "N = {N}: the bound {} exceeds {tight} for {truth}", x.error());
}

/// Doubles of the whole range of magnitudes, short and long, many near 1.
#[derive(Clone, Copy, Debug)]
struct Sample(f64);

impl Arbitrary for Sample {
    fn arbitrary(g: &mut Gen) -> Self {
        let significand = match u8::arbitrary(g) % 4 {
            0 => f64::from(u8::arbitrary(g)) + 1.0,
            1 => 1.0 + f64::EPSILON * f64::from(i16::arbitrary(g)),
            _ => f64::from_bits(u64::arbitrary(g) >> 12 | 1023 << 52),
        };
        let exponent = match u8::arbitrary(g) % 3 {
            0 => 0,
            1 => i32::from(i8::arbitrary(g) % 8),
            _ => i32::from(i16::arbitrary(g) % 1000),
        };
        Sample(significand * 2f64.powi(exponent))
    }
}

/// An inexact number and a true value at the limit of its error.
fn uncertain<const N: usize>(sample: Sample, error: u16) -> (Extended<N>, Float) {
    let x = Extended::<N>::from(sample.0).widened(f64::from(error));
    let shift = Float::with_val(BITS, error) >> (64 * N as u32);
    (x, float(sample.0) * (1 + shift))
}

fn algebra<const N: usize>(a: Sample, b: Sample, errors: (u16, u16), negative: bool, k: i32) {
    let (x, s) = uncertain::<N>(a, errors.0);
    let (y, t) = uncertain::<N>(b, errors.1);
    let (y, t) = if negative { (-y, -t) } else { (y, t) };
    let sum = f64::from(errors.0) + f64::from(errors.1) + 3.0;
    check(&(x * y), &(s.clone() * &t), sum);
    check(&(x / y), &(s.clone() / &t), sum);
    check(&x.sqrt(), &s.clone().sqrt(), sum + 24.0);
    for (total, truth) in [(x + y, s.clone() + &t), (x - y, s.clone() - &t)] {
        // Magnified by cancellation, and by less than 4 beyond that.
        let larger = s.clone().abs().max(&t.clone().abs());
        let allowed = 4.0 * sum * (larger / truth.clone().abs()).to_f64().max(1.0);
        check(&total, &truth, if truth.is_zero() { 0.0 } else { allowed });
        let avoidable = errors == (0, 0) || allowed < error_limit::<N>();
        assert!(!is_around_zero(&total) || !avoidable, "an avoidable loss");
    }
    check(&x.times(i64::from(k)), &(s.clone() * k), sum);
    if k != 0 {
        check(&x.over(i64::from(k)), &(s / k), sum);
    }
}

quickcheck! {
    fn four_operations(a: Sample, b: Sample, errors: (u16, u16), exact: bool, negative: bool, k: i32) -> bool {
        let errors = if exact { (0, 0) } else { errors };
        algebra::<1>(a, b, errors, negative, k);
        algebra::<2>(a, b, errors, negative, k);
        algebra::<3>(a, b, errors, negative, k);
        algebra::<4>(a, b, errors, negative, k);
        true
    }

    fn elementary_functions(a: Sample, b: Sample) -> bool {
        elementary::<1>(a.0, b.0, 16.0);
        elementary::<2>(a.0, b.0, 65536.0);
        elementary::<4>(a.0, b.0, 262144.0);
        true
    }

    fn rounding_to_nearest(a: Sample, b: Sample, scale: i16) -> bool {
        // A quotient of doubles, scaled over and beyond the range of f64: MPFR rounds it the same way.
        let x = (Extended::<2>::from(a.0) / Extended::from(b.0)).scaled(i64::from(scale % 1200));
        let truth = Float::with_val(BITS, a.0) / b.0 * Float::with_val(BITS, 2).pow(scale % 1200);
        x.nearest_f64() == Some(truth.to_f64())
    }
}

fn elementary<const N: usize>(a: f64, b: f64, tight: f64) {
    let x = Extended::<N>::from(a);
    let truth = float(a);
    let ln = truth.clone().ln();
    // An absolute error of one unit is a relative one of 1/|ln x|, but near 1 the logarithm is relatively accurate.
    let absolute = if (a - 1.0).abs() < 0.003 { 1.0 } else { 1.0 / ln.to_f64().abs().min(1.0) };
    check(&x.ln(), &ln, 2.0 * tight + 4.0 * tight * absolute);
    let ln_1p = truth.clone().ln_1p();
    let absolute = if a < 0.003 { 1.0 } else { 1.0 / ln_1p.to_f64().min(1.0) };
    check(&x.ln_1p(), &ln_1p, 2.0 * tight + 4.0 * tight * absolute);
    let small = a.clamp(1e-200, 700.0);
    for argument in [small, -small] {
        let (x, truth) = (Extended::<N>::from(argument), float(argument));
        check(&x.exp(), &truth.clone().exp(), 8.0 * tight * small.max(1.0));
        // e^x − 1 loses at most four bits at |x| = 1/16.
        check(&x.exp_m1(), &truth.exp_m1(), 256.0 * tight * small.max(1.0));
    }
    let exponent = b.clamp(1e-3, 1e3) * if a.to_bits() & 1 == 0 { 1.0 } else { -1.0 };
    let power = x.pow(&Extended::from(exponent));
    let truth = truth.pow(float(exponent));
    let logarithm = (ln.to_f64() * exponent).abs();
    check(&power, &truth, (4.0 + logarithm + exponent.abs()) * 8.0 * tight);
}

#[test]
fn exact_results_are_exact() {
    fn exact<const N: usize>(x: Extended<N>, value: f64) {
        assert_eq!((x.error(), x.nearest_f64()), (0.0, Some(value)));
    }
    fn run<const N: usize>() {
        let w = |value: f64| Extended::<N>::from(value);
        exact(w(16.0).pow(&w(1.5)), 64.0);
        exact(w(16.0).pow(&w(-0.25)), 0.5);
        exact(w(81.0 * 2f64.powi(-8)).pow(&w(1.75)), 2187.0 * 2f64.powi(-14));
        exact(w(7.0).over(2) * w(2.0) - w(7.0), 0.0);
        exact(w(6.0) / w(3.0), 2.0);
        exact(w(2.25).sqrt(), 1.5);
        exact(w(0.0).sqrt(), 0.0);
        exact(w(0.5 + 2f64.powi(-50)).times(2) - w(1.0), 2f64.powi(-49));
        exact(w(3.0).pow(&w(0.0)), 1.0);
        exact(w(1.0).pow(&w(5.0)), 1.0);
        exact(w(0.0).exp(), 1.0);
        exact(w(1.0).ln(), 0.0);
        exact(w(1e300).scaled(1 << 20).scaled(-1 << 20), 1e300);
        exact((w(3e9) * w(7e8)).scaled(4000).scaled(-4000), 2.1e18);
        assert_eq!(w(2.0).partial_cmp(&w(3.0)), Some(std::cmp::Ordering::Less));
        assert_eq!(w(2.0), w(2.0));
        assert_ne!(w(2.0).sqrt().square(), w(2.0));
    }
    run::<1>();
    run::<2>();
    run::<3>();
    run::<4>();
}

#[test]
fn outside_the_domain_nothing_is_known() {
    let w = |value: f64| Extended::<1>::from(value);
    for x in
        [w(-1.0).sqrt(), w(-1.0).ln(), w(0.0).ln(), w(1.0) / w(0.0), w(-2.0).pow(&w(0.3)), w(f64::NAN), w(1e300).exp()]
    {
        assert!(!x.is_finite() && x.nearest_f64().is_none() && x.partial_cmp(&x).is_none());
        assert!(!(x * w(0.0)).is_finite() && !(x + w(1.0)).is_finite());
    }
}

#[test]
fn edges_of_the_range_of_f64() {
    let w = |value: f64| Extended::<2>::from(value);
    let least = f64::from_bits(1);
    assert_eq!(w(least).over(2).nearest_f64(), Some(0.0), "a tie goes to even");
    assert_eq!((w(least).times(3).over(4)).nearest_f64(), Some(least));
    assert_eq!(w(least).times(3).over(2).nearest_f64(), Some(2.0 * least));
    assert_eq!(w(f64::MAX).times(2).nearest_f64(), Some(f64::INFINITY));
    assert_eq!((w(f64::MAX) + w(f64::MAX).scaled(-53)).nearest_f64(), Some(f64::INFINITY));
    assert_eq!(w(f64::MIN_POSITIVE).nearest_f64(), Some(f64::MIN_POSITIVE));
    let beyond = w(10.0).powi(100_000);
    assert!((beyond.log10() - 1e5).abs() < 1e-9);
    // A bound wider than the guarantee gives no result.
    assert_eq!(Extended::<1>::from(1.5).widened(4096.0).nearest_f64(), None);
}

#[test]
fn literals_are_enclosed() {
    for text in ["0.3", "-2/7", "1.25e-40", "1e300", "5"] {
        let literal: Literal = text.parse().unwrap();
        let truth = Float::with_val(BITS, literal.to_rational());
        check(&Extended::<1>::from_literal((), &literal), &truth, 4096.0);
        check(&Extended::<4>::from_literal((), &literal), &truth, 4096.0);
    }
}
