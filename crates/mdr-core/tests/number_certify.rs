//! Certified decimals: correctly rounded, decided where they can be, and always ending where they cannot.

#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "helpers of tests may panic as tests do")]

use mdr_core::contact::{Error, Quantity};
use mdr_core::number::certify::{Decimal, Enclosure, certify};
use mdr_core::number::{Interval, Precision, Real};
use proptest::prelude::*;
use rug::ops::Pow;
use rug::{Float, Integer, Rational};

const KAPPA: [Quantity; 1] = [Quantity::Kappa];

fn exact(numerator: i64, denominator: i64, digits: u32) -> String {
    Enclosure::Exact((numerator, denominator).into()).round(digits).unwrap().to_string()
}

fn around(middle: &str, radius: f64, digits: u32) -> Option<String> {
    let middle = Interval::from_literal(Precision::new(400), &middle.parse().unwrap());
    let bound = Interval::from_f64(Precision::new(400), radius);
    Enclosure::from(middle.inflate(&bound)).round(digits).map(|decimal| decimal.to_string())
}

/// A correctly rounded decimal in the form of `Float::to_sign_string_exp_round`, with the point before the digits.
fn parts(decimal: &Decimal) -> (bool, String, Option<i32>) {
    let exponent = decimal.exponent().to_i32().map(|exponent| exponent + 1);
    (decimal.is_negative(), decimal.digits().to_owned(), exponent)
}

#[test]
fn ties_go_to_the_even_digit() {
    assert_eq!(exact(25, 10, 1), "2");
    assert_eq!(exact(35, 10, 1), "4");
    assert_eq!(exact(-25, 10, 1), "-2");
    assert_eq!(exact(1, 8, 2), "0.12");
    assert_eq!(exact(3, 8, 2), "0.38");
    assert_eq!(exact(99_995, 10_000, 4), "10.00");
    assert_eq!(exact(99_985, 10_000, 4), "9.998");
    assert_eq!(exact(99_994, 10_000, 4), "9.999");
    // An enclosure that is a point decides a tie too, once its precision represents the scaled number.
    for (value, digits, shown) in [(2.5, 1, "2"), (3.5, 1, "4"), (-0.375, 2, "-0.38"), (9.5, 1, "1e+1")] {
        let point = Interval::from_f64(Precision::new(64), value);
        assert_eq!(Enclosure::from(point).round(digits).unwrap().to_string(), shown);
    }
    assert_eq!(exact(2_500_000_000_000_001, 1_000_000_000_000_000, 1), "3");
}

#[test]
fn exact_zero() {
    let zero = Enclosure::Exact(Rational::new()).round(30).unwrap();
    assert!(zero.is_zero() && !zero.is_negative() && zero.digits().is_empty());
    assert_eq!((zero.to_string().as_str(), zero.to_f64(), zero.log10_f64()), ("0", 0.0, f64::NEG_INFINITY));
    assert_eq!(Enclosure::from(Interval::point(Float::new(53))).round(30), Some(zero));
}

/// Plain for decimal exponents from −6 to the number of digits minus one: no zero represents an unknown digit.
#[test]
fn display() {
    for (numerator, denominator, digits, shown) in [
        (1, 1, 1, "1"),
        (1, 1, 3, "1.00"),
        (1234, 1, 4, "1234"),
        (12_340, 1, 4, "1.234e+4"),
        (2698, 1, 3, "2.70e+3"),
        (123_400, 1, 4, "1.234e+5"),
        (-5, 1, 1, "-5"),
        (50, 1, 1, "5e+1"),
        (9996, 1, 3, "1.00e+4"),
        (9996, 1000, 3, "10.0"),
        (500, 1, 1, "5e+2"),
        (1, 1_000_000, 3, "0.00000100"),
        (-1, 10_000_000, 3, "-1.00e-7"),
        (2, 3, 5, "0.66667"),
        (200, 3, 5, "66.667"),
    ] {
        assert_eq!(exact(numerator, denominator, digits), shown);
    }
}

#[test]
fn near_a_power_of_ten() {
    assert_eq!(around("9.9996", 1e-5, 4).as_deref(), Some("10.00"));
    assert_eq!(around("9.9994", 1e-5, 4).as_deref(), Some("9.999"));
    assert_eq!(around("10", 1e-30, 4).as_deref(), Some("10.00"));
    assert_eq!(around("-0.001", 1e-30, 20).as_deref(), Some("-0.0010000000000000000000"));
    // 0.001 ± 10⁻³⁰: below the power of ten the last of 27 digits counts 10⁻³⁰, so half of them are 0.99…9.
    assert_eq!(around("0.001", 1e-30, 27), None);
    assert_eq!(around("9.99995", 1e-9, 5), None);
    assert_eq!(around("1", 0.5, 1), None);
    assert_eq!(around("1", 1.0, 1), None);
    assert_eq!(around("0", 1e-300, 1), None);
    assert_eq!(Enclosure::from(Interval::entire(Precision::new(64))).round(1), None);
}

fn bits(words: [u64; 4], precision: u32) -> Float {
    Float::with_val(precision, Integer::from_digits(&words, rug::integer::Order::Lsf) | 1u32)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 500 / 256))]

    /// Against the conversion of MPFR, which also rounds correctly: a number and the same number as a rational.
    #[test]
    fn a_point_rounds_as_mpfr_does(
        words in any::<[u64; 4]>(),
        precision in 20_u32..300,
        exponent in -5000_i32..5000,
        digits in 2_u32..120,
        negative in any::<bool>(),
    ) {
        let x = bits(words, precision) << exponent;
        let x = if negative { -x } else { x };
        let expected = x.to_sign_string_exp(10, Some(digits as usize));
        let value = Interval::point(x.clone());
        prop_assert_eq!(Enclosure::from(value).round(digits).map(|d| parts(&d)), Some(expected.clone()));
        prop_assert_eq!(Enclosure::Exact(x.to_rational().unwrap()).round(digits).map(|d| parts(&d)), Some(expected));
    }

    /// An interval is decided exactly when its ends agree, and then to the decimal they agree on.
    #[test]
    fn an_interval_rounds_as_its_ends(
        words in any::<[u64; 4]>(),
        exponent in -900_i32..900,
        digits in 2_u32..60,
        width in 0_i32..250,
    ) {
        let lo = bits(words, 256) << exponent;
        let hi = Float::with_val(256, &lo + (lo.clone() >> width));
        let ends = [&lo, &hi].map(|end| end.to_sign_string_exp(10, Some(digits as usize)));
        let decided = Enclosure::from(Interval::new(lo, hi)).round(digits).map(|d| parts(&d));
        prop_assert_eq!(decided, (ends[0] == ends[1]).then(|| ends[0].clone()));
    }

    /// e^L by its logarithm and by its value.
    #[test]
    fn logarithmic_enclosures_agree_with_plain_ones(
        l in prop_oneof![-30.0..30.0, -1e6..1e6],
        digits in 1_u32..60,
        negative in any::<bool>(),
    ) {
        let of = |precision, log: bool| {
            let ln_magnitude = Interval::from_f64(precision, l);
            let magnitude = ln_magnitude.exp();
            if log { Enclosure::Log { negative, ln_magnitude } } else if negative { (-magnitude).into() } else { magnitude.into() }
        };
        let [a] = certify(KAPPA, digits, Precision::new(64), |precision| Ok([of(precision, true)])).unwrap();
        let [b] = certify(KAPPA, digits, Precision::new(64), |precision| Ok([of(precision, false)])).unwrap();
        prop_assert_eq!(a, b);
    }
}

/// e^L = 2.5 · 10^N for N = ±10^50 and ±10^300: the precision must rise to that of L's own integer part.
#[test]
fn logarithms_of_any_size() {
    for zeros in [3_u32, 50, 300] {
        for sign in [1, -1] {
            let decades = Integer::from(10).pow(zeros) * sign;
            let mut largest = 0;
            let [decimal] = certify(KAPPA, 12, Precision::new(64), |precision| {
                largest = precision.bits();
                let ten = Interval::from_int(precision, 10);
                let decades = Interval::from_rational(precision, &Rational::from(&decades));
                let ln_magnitude = ten.ln() * decades + ten.over(4).ln();
                Ok([Enclosure::Log { negative: true, ln_magnitude }])
            })
            .unwrap();
            assert!(decimal.is_negative());
            assert_eq!((decimal.digits(), decimal.exponent()), ("250000000000", decades));
            assert!(f64::from(largest) > f64::from(zeros) * 3.32 + 36.0, "{largest} bits cannot decide it");
        }
    }
}

/// An exact logarithm needs no more bits than it has, whatever its size and the digits asked for.
#[test]
fn exact_logarithm() {
    let log = |precision| {
        let ln_magnitude = Interval::from_int(Precision::new(precision), 10).powi(300);
        assert!(ln_magnitude.is_point());
        Enclosure::Log { negative: false, ln_magnitude }
    };
    let decimal = log(1000).round(400).unwrap();
    assert_eq!(Some(&decimal), log(4000).round(400).as_ref());
    // 10^300 / ln 10.
    assert!(decimal.exponent().to_string().starts_with("4342944819032518276511289189166050822943970058"));
}

/// 1000 digits of π end in …2164201989 (the next are 38…); 10 000 digits agree with MPFR's own conversion.
#[test]
fn many_digits() {
    let pi = |digits| {
        let [pi] = certify(KAPPA, digits, Precision::from_digits(digits), |precision| {
            Ok([Interval::from_int(precision, 1).pi().into()])
        })
        .unwrap();
        pi
    };
    assert_eq!(pi(1).to_string(), "3");
    assert_eq!(pi(50).to_string(), "3.1415926535897932384626433832795028841971693993751");
    assert!(pi(1001).to_string().ends_with("2164201989"));
    let long = Float::with_val(40_000, rug::float::Constant::Pi);
    assert_eq!(parts(&pi(10_000)), long.to_sign_string_exp(10, Some(10_000)));
}

/// The precision increases until a cancellation of 10³ bits is covered; quantities decided early keep their value.
#[test]
fn precision_rises() {
    let mut attempts = 0;
    let quantities = [Quantity::ContactRadius, Quantity::Indentation, Quantity::Force];
    let [radius, indentation, force] = certify(quantities, 30, Precision::new(64), |precision| {
        attempts += 1;
        let one = Interval::from_int(precision, 1);
        let tiny = Interval::from_int(precision, 2).powi(-1000);
        Ok([one.clone().over(3).into(), ((one.clone() + tiny) - one).into(), Enclosure::Exact((-3, 2).into())])
    })
    .unwrap();
    assert_eq!(radius.to_string(), "0.333333333333333333333333333333");
    assert_eq!(indentation.to_string(), "9.33263618503218878990089544724e-302");
    assert_eq!(force.to_string(), "-1.50000000000000000000000000000");
    assert!((3..10).contains(&attempts));
}

/// 5/2 as (√2)²·5/4 is a tie that no enclosure of it decides; nor is an unbounded enclosure ever decided.
#[test]
fn gives_up_at_a_cap() {
    let mut last = 0;
    let tie = certify(KAPPA, 1, Precision::new(64), |precision| {
        last = precision.bits();
        let two = Interval::from_int(precision, 2);
        Ok([two.sqrt().square().times(5).over(4).into()])
    });
    assert_eq!(
        tie,
        Err(Error::Undecided { quantity: Quantity::Kappa, bits: 24_096, what: "the last digit asked for" })
    );
    assert_eq!(last, 24_096);
    let quantities = [Quantity::Kappa, Quantity::Force];
    let unbounded = certify(quantities, 1, Precision::new(64), |precision| {
        Ok([Enclosure::Exact(1.into()), Interval::entire(precision).into()])
    });
    assert!(matches!(unbounded, Err(Error::Undecided { quantity: Quantity::Force, .. })));
}

/// An undecided comparison within `f` leads to more bits; a wrong input does not.
#[test]
fn errors_of_the_computation() {
    let mut attempts = 0;
    let result = certify(KAPPA, 5, Precision::new(64), |precision| {
        attempts += 1;
        if precision.bits() < 200 {
            return Err(Error::Undecided { quantity: Quantity::Radius, bits: precision.bits(), what: "a sign" });
        }
        Ok([Enclosure::Exact(2.into())])
    });
    assert_eq!((result.unwrap()[0].to_string().as_str(), attempts), ("2.0000", 3));

    let mut attempts = 0;
    let domain = Error::domain(Quantity::Exponent, &-1.0, "positive");
    let result = certify(KAPPA, 5, Precision::new(64), |_| {
        attempts += 1;
        Err(domain.clone())
    });
    assert_eq!((result, attempts), (Err(domain), 1));

    let always = |precision: Precision| {
        Err(Error::Undecided { quantity: Quantity::Radius, bits: precision.bits(), what: "a sign" })
    };
    let result = certify(KAPPA, 5, Precision::new(64), always);
    assert_eq!(result, Err(Error::Undecided { quantity: Quantity::Radius, bits: 24_096, what: "a sign" }));
}

#[test]
fn absurd_digits_are_refused() {
    for digits in [0, 1_000_001, u32::MAX] {
        let refused = certify(KAPPA, digits, Precision::new(64), |_| Ok([Enclosure::Exact(1.into())]));
        assert!(matches!(refused, Err(Error::Domain { quantity: Quantity::Digits, .. })), "{digits}");
    }
}

#[test]
fn decimals_as_doubles() {
    let value = |text: &str| {
        let literal: mdr_core::number::Literal = text.parse().unwrap();
        Enclosure::Exact(literal.to_rational()).round(25).unwrap()
    };
    assert_eq!(value("-0.1").to_f64(), -0.1);
    assert_eq!(value("1e400").to_f64(), f64::INFINITY);
    assert_eq!(value("1e400").log10_f64(), 400.0);
    assert_eq!(value("2e-4766").log10_f64(), -4766.0 + 2_f64.log10());
}
