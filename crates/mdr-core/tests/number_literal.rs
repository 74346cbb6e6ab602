//! Exact decimal inputs: parsing, rejection, order and rounding.

use std::cmp::Ordering;

use mdr_core::number::{Literal, LiteralError};

#[test]
fn decimals_are_exact() {
    for (text, value) in [("0.3", 0.3), ("-1.5e-12", -1.5e-12), (".5", 0.5), ("5.", 5.0), ("0e5", 0.0), ("1E+3", 1e3)] {
        assert_eq!(text.parse::<Literal>().unwrap().nearest_f64(), value, "{text}");
    }
}

#[test]
fn integers_are_as_if_written() {
    for value in [0, 1, -1, 10, -1200, i64::MAX, i64::MIN] {
        assert_eq!(Literal::from(value), value.to_string().parse().unwrap());
    }
}

#[test]
fn refuses_what_is_not_a_finite_number() {
    use LiteralError::*;
    for (text, why) in [
        ("", NotANumber),
        ("-", NotANumber),
        (".", NotANumber),
        ("1e", NotANumber),
        ("0x10", NotANumber),
        ("1,5", NotANumber),
        ("--1", NotANumber),
        ("1/2/3", NotANumber),
        ("1.5/2", NotANumber),
        ("NaN", NotFinite),
        ("-inf", NotFinite),
        ("1e999999999", TooLarge),
        ("1e99999999999999999999", TooLarge),
        ("1/0", ZeroDenominator),
    ] {
        assert_eq!(text.parse::<Literal>(), Err(why), "{text:?}");
    }
}

#[test]
fn fractions() {
    let value = |text: &str| text.parse::<Literal>().unwrap().nearest_f64();
    let close = |x: f64, y: f64| (x - y).abs() <= 2.0 * f64::EPSILON * y.abs();
    let zeros = "0".repeat(400);
    assert!(close(value("1/3"), 1.0 / 3.0) && close(value("-22/7"), -22.0 / 7.0));
    assert!(close(value(&format!("1{zeros}/1{zeros}")), 1.0), "neither part is a double");
    assert!(close(value(&format!("3{zeros}/2{}", "0".repeat(100))), 1.5e300));
    assert_eq!((value("0/7"), value(&format!("1{zeros}/7")), value(&format!("7/1{zeros}"))), (0.0, f64::INFINITY, 0.0));
}

/// The order of the texts is that of the rationals, also where doubles do not distinguish them.
#[test]
fn order() {
    let sorted = [
        "-1e400",
        "-3",
        "-1/3",
        "-0.3333333333333333333333",
        "0",
        "1/1000000000000000000001",
        "1e-21",
        "0.3333333333333333333333",
        "1/3",
        "0.5",
        "999999999999999999/1000000000",
        "1000000000",
        "1e400",
    ];
    let literals: Vec<Literal> = sorted.iter().map(|text| text.parse().unwrap()).collect();
    for (i, one) in literals.iter().enumerate() {
        for (j, other) in literals.iter().enumerate() {
            assert_eq!(one.compare(other), i.cmp(&j), "{one} and {other}");
            #[cfg(feature = "mp")]
            assert_eq!(one.compare(other), one.to_rational().cmp(&other.to_rational()), "{one} and {other}");
        }
    }
    let equal =
        |one: &str, other: &str| one.parse::<Literal>().unwrap().compare(&other.parse().unwrap()) == Ordering::Equal;
    assert!(equal("2/6", "1/3") && equal("-0", "0/5") && equal("1.50", "3/2") && equal("100", "1e2"));
}

#[test]
fn small_integers() {
    let integer = |text: &str| text.parse::<Literal>().unwrap().small_integer();
    assert_eq!(
        [integer("2"), integer("-2.0"), integer("12e3"), integer("0")],
        [Some(2), Some(-2), Some(12_000), Some(0)]
    );
    for text in ["2.5", "2.00000000000000000000001", "4/2", "1e7", "1e-1"] {
        assert_eq!(integer(text), None, "{text}");
    }
}

#[cfg(feature = "mp")]
#[test]
fn rational_value() {
    let rational = |text: &str| text.parse::<Literal>().unwrap().to_rational();
    assert_eq!(rational("0.3"), rug::Rational::from((3, 10)));
    assert_eq!(rational("-2/6"), rug::Rational::from((-1, 3)));
    assert_eq!(rational("1.20e2"), rug::Rational::from(120));
    let tiny = "4.9406564584124654e-324".parse::<Literal>().unwrap();
    assert_eq!(tiny.nearest_f64(), f64::from_bits(1));
}
