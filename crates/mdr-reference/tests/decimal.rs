//! Exact decimals: arithmetic, order, conversion from doubles and from hexadecimal, and rejected texts.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use mdr_reference::{Decimal, DecimalError};
use proptest::prelude::*;

fn decimal(text: &str) -> Decimal {
    text.parse().unwrap()
}

proptest! {
    /// Whole numbers of up to 38 digits, scaled.
    #[test]
    fn sums_and_order_are_those_of_integers(a in -(1_i128 << 100)..(1 << 100), b in -(1_i128 << 100)..(1 << 100), e in -400..400) {
        let [x, y] = [a, b].map(|value| decimal(&format!("{value}e{e}")));
        prop_assert_eq!(&x - &y, decimal(&format!("{}e{e}", a - b)));
        prop_assert_eq!(&x + &y, decimal(&format!("{}e{e}", a + b)));
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
    }

    #[test]
    fn doubles_come_back(bits in any::<u64>()) {
        let value = f64::from_bits(bits);
        prop_assume!(value.is_finite());
        let exact = Decimal::from_double(value).unwrap();
        prop_assert_eq!(exact.nearest(), value);
        prop_assert_eq!(decimal(&exact.to_string()), exact.clone());
        prop_assert!((exact.log10() - value.abs().log10()).abs() < 1e-12 || value.abs() < f64::MIN_POSITIVE);
    }
}

#[test]
fn refuses_what_is_no_number() {
    for text in ["", "-", ".", "1e", "1,5", "--1", "0x", "0xg", "1e+-3", "١"] {
        assert_eq!(text.parse::<Decimal>(), Err(DecimalError::NotANumber), "{text}");
    }
    assert_eq!("-Infinity".parse::<Decimal>(), Err(DecimalError::NotFinite));
    assert_eq!("1e100000000000000001".parse::<Decimal>(), Err(DecimalError::TooLarge));
}

#[test]
fn what_is_not_finite_is_no_decimal() {
    assert_eq!([f64::NAN, f64::INFINITY, -f64::INFINITY].map(Decimal::from_double), [None, None, None]);
}

#[test]
fn numbers_far_apart_cost_nothing() {
    let (large, small) = (decimal("1e900000000"), decimal("1e-900000000"));
    assert_eq!(&large - &small, large);
    assert_eq!(&small - &large, decimal("-1e900000000"));
}

proptest! {
    /// Twice 2ᵏm is 2ᵏ⁺¹m, far beyond the range of doubles, with the point at any position.
    #[test]
    fn doubling_adds_one_to_the_exponent(m in 1_u128.., k in -9_000_i64..9_000) {
        let once = decimal(&format!("0x{m:x}p{k}"));
        prop_assert_eq!(&once + &once, decimal(&format!("0x{m:x}p{:+}", k + 1)));
        let digits = format!("{m:x}");
        let (integer, fraction) = digits.split_at(digits.len() / 2);
        prop_assert_eq!(once, decimal(&format!("0X00{integer}.{fraction}000P{:+}", k + 4 * fraction.len() as i64)));
    }
}

#[test]
fn hexadecimal_ends_of_the_range() {
    assert_eq!(decimal("0x1.fffffffffffffp+1023").nearest(), f64::MAX);
    assert_eq!(decimal("0x1.2d97c7f3321d2000p+2"), decimal("0x1.2d97c7f3321d2p+2"));
}

/// −3π/2 as a long double of 64 bits.
#[test]
fn as_c_writes_long_doubles() {
    let (written, digits) = (decimal("-0x9.6cbe3f9990e91a8p-1"), decimal("-4.71238898038468985769"));
    assert!((&written - &digits).abs() < decimal("5e-19"), "{written}");
}

#[test]
fn the_exponent_has_a_bound_that_is_named() {
    for text in ["0x1p-17000", "-0x1p+16999", "0x0p+99999999", "0x0.0001p+17000", "0x0.0000000000001p-16442"] {
        assert!(text.parse::<Decimal>().is_ok(), "{text}");
    }
    for text in ["0x1p+17001", "0x1p-17001", "0x1p+99999999999999999999", "0x1.8p-17000"] {
        let error = text.parse::<Decimal>();
        assert_eq!(error, Err(DecimalError::BinaryTooLarge), "{text}");
    }
    assert!(DecimalError::BinaryTooLarge.to_string().contains("binary exponent beyond ±17000"));
}
