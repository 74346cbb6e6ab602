//! Kinks and ends of formulas, against the known ones.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::collections::BTreeMap;

use mdr_core::contact::{Expression, ExpressionProfile, Profile};
use mdr_core::number::{Interval, Literal, Precision, Real};
use proptest::prelude::*;
use rug::Float;

fn values(given: &[(&str, &str)]) -> BTreeMap<String, Literal> {
    given.iter().map(|(name, value)| ((*name).to_owned(), value.parse().unwrap())).collect()
}

fn profile(formula: &str, given: &[(&str, &str)]) -> ExpressionProfile<f64> {
    let (formula, values) = (formula.parse::<Expression>().unwrap(), values(given));
    let breaks = formula.breaks(&values).unwrap_or_else(|error| panic!("{error}"));
    formula.bind((), &values).unwrap().broken_at((), &breaks)
}

#[test]
fn kinks_are_where_they_were_put() {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let cases: [(&str, &[f64]); 26] = [
        ("r^2", &[]),
        ("abs(1 - cosh(r) + r) + sqrt(cosh(r) - 1) + sqrt(sqrt(1 + r^2) - 1)", &[1.616137513774314]),
        ("abs(r - 1) - 1", &[1.0]),
        ("sqrt((r - 1)^2) + r - 1", &[1.0]),
        ("((r - 1)^2)^0.5 - 1", &[1.0]),
        ("sqrt(r^2 - 2*r + 1) - 1", &[1.0]),
        ("sqrt((r - 1)^2 + 1e-40) + r", &[]),
        ("sqrt((r^2 - r - 1)^4)", &[golden]),
        ("max(0, r - 3)", &[3.0]),
        ("min(r^2, 2*r, 1)", &[1.0, 2.0]),
        ("abs((r - 1)^2 - 1e-6)", &[0.999, 1.001]),
        ("abs(abs(r - 2) - 1) - 1", &[1.0, 2.0, 3.0]),
        ("acos(cos(min(r, 7)))", &[std::f64::consts::PI, 2.0 * std::f64::consts::PI, 7.0]),
        ("(r - 1)^2*atan(1/(r - 1))", &[1.0]),
        ("(abs(r - 1))^(1/2)", &[1.0]),
        ("abs(exp(r) - 2)", &[std::f64::consts::LN_2]),
        ("abs(log10(r + 1) - 1)", &[9.0]),
        ("abs(sinh(r) - 1) + abs(tanh(r) - 1/2)", &[0.5493061443340549, 0.881373587019543]),
        ("abs((r - 1)*(r - 2)*(r - 2.5))", &[1.0, 2.0, 2.5]),
        ("r*ln(1 + 1/r)", &[]),
        ("sqrt(r^2 + 1) - 1", &[]),
        ("r^1.5 + r^0.25", &[]),
        ("abs(r^4 - 5*r^2 + 4)", &[1.0, 2.0]),
        // What cancels far out and at the axis: 2r − 2, 3r² − 9 and 3r/4 − r².
        ("min(r^2, 1 + (r - 1)^2)", &[1.0]),
        ("max(0, (r + 1)^3 - 1 - 3*r - r^3 - 9)", &[3f64.sqrt()]),
        ("abs(r*(r - 1)^2 + r^2 - r^3 - r/4) + r", &[0.75]),
    ];
    for (formula, expected) in cases {
        let found = profile(formula, &[]);
        let kinks: Vec<f64> = Profile::<f64>::kinks(&found);
        let near = kinks.len() == expected.len()
            && kinks.iter().zip(expected).all(|(kink, expected)| (kink / expected - 1.0).abs() < 4.0 * f64::EPSILON);
        assert!(near, "{formula}: {kinks:?}, not {expected:?}");
        assert_eq!(found.outer_radius(), None, "{formula}");
        assert_eq!(found.kinks_known_to(), None, "{formula}");
    }
}

#[test]
fn they_have_no_scale() {
    for scale in ["1e-200", "3e-7", "1e200"] {
        let b: f64 = scale.parse().unwrap();
        let found = profile("b*(abs(r/b - 1) + max(r/b, 2) - 3 + sqrt(9 - (r/b)^2) - 3)", &[("b", scale)]);
        let kinks: Vec<f64> = Profile::<f64>::kinks(&found);
        assert!(kinks.len() == 2 && kinks[0] == b && (kinks[1] / b - 2.0).abs() < 1e-15, "{kinks:?}");
        assert!((found.outer_radius().unwrap() / b - 3.0).abs() < 1e-15);
    }
}

#[test]
fn a_profile_ends_where_its_formula_does() {
    for (formula, end) in [
        ("1 - sqrt(1 - r^2)", 1.0),
        ("asin(r/2)", 2.0),
        ("r - ln(3 - r)", 3.0),
        ("1/(1 - r) - 1", 1.0),
        ("r^2 + sqrt((r - 1)*(r - 1.5)) - sqrt(1.5)", 1.0),
        ("-ln(abs(1 - r))", 1.0),
        ("1 - sqrt(1 - sqrt(1 - sqrt(1 - r^2)))", 1.0),
        ("atanh(r/5)^2 + abs(r - 6) - 6", 5.0),
    ] {
        let found = profile(formula, &[]);
        assert!(found.outer_radius().is_some_and(|outer| (outer / end - 1.0).abs() < 1e-15), "{formula}: {found:?}");
        assert!(found.kinks().iter().all(|kink: &f64| *kink < end), "{formula}: {found:?}");
    }
}

#[test]
fn what_is_no_profile_is_refused() {
    for (formula, why) in [
        ("atan(1/(1 - r)) - atan(1)", "jumps at r = 1"),
        ("abs(r - 2)/(r - 2) + 1", "jumps at r = 2"),
        ("r^2*abs(sin(1/r))", "towards the axis"),
        ("r/Q", "unknown name `Q`"),
    ] {
        let error = formula.parse::<Expression>().unwrap().breaks(&BTreeMap::new()).unwrap_err().to_string();
        assert!(error.contains(why), "{formula}: {error}");
    }
}

/// Arguments that are written in different ways switch at one radius where that is a rational number.
#[test]
fn switches_at_one_radius() {
    let precision = Precision::new(100);
    let jump = |text: &str| {
        let (formula, none) = (text.parse::<Expression>().unwrap(), BTreeMap::new());
        let enclosed = formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
        assert_eq!(enclosed.breaks().len(), 1, "{text}");
        enclosed.jump(0).map(|jump| jump[1].clone())
    };
    // r times the jump of f'.
    for (text, expected) in [
        ("min(r^2, 0.04) + max(0, r - 0.2)", "0.12"),
        ("max(0, r - 1/3) + abs(1 - 3*r) + r", "7/3"),
        ("max(0, r - 0.1)*2 + max(r - 1/10, 0)", "0.3"),
        ("max(r^3, 0.008)*max(0, r^2/0.04 - 1) + min(0.2, r)", "-0.184"),
        ("abs(1/r - 3)", "6"),
    ] {
        let expected = Interval::from_literal(precision, &expected.parse().unwrap());
        let found = jump(text).unwrap_or_else(|| panic!("{text}"));
        assert!(found.overlaps(&expected) && found.accuracy_bits() > 85, "{text}: {found:?}");
    }
    for apart in ["max(0, r - 0.2) + max(0, r - 0.20000000000000000001)", "max(0, r - sqrt(2)) + max(0, r^2 - 2)"] {
        assert!(jump(apart).is_none(), "{apart}");
    }
}

/// A switch in the argument of another one has a sign at a kink of the outer one.
#[test]
fn switches_within_others() {
    let precision = Precision::new(100);
    let (formula, none): (Expression, _) = ("min(r^2/2, 0.05 + abs(r - 0.5))".parse().unwrap(), BTreeMap::new());
    let enclosed = formula.enclosed(&none, &formula.breaks(&none).unwrap(), precision).unwrap();
    // r²/2 = 0.55 − r, the corner of the cone, and r²/2 = r − 0.45 twice.
    let [first, second, third] = [2.1f64.sqrt() - 1.0, 1.0 - 0.1f64.sqrt(), 1.0 + 0.1f64.sqrt()];
    let expected = [
        (first, -first * (1.0 + first)),
        (0.5, 1.0),
        (second, second * (second - 1.0)),
        (third, third * (1.0 - third)),
    ];
    assert_eq!(enclosed.breaks().len(), expected.len());
    for (index, (radius, jump)) in expected.into_iter().enumerate() {
        let (found, slope) = (&enclosed.breaks()[index], &enclosed.jump(index).expect("known")[1]);
        assert!((found.approx() - radius).abs() < 1e-15 && found.accuracy_bits() > 90, "{index}: {found}");
        assert!((slope.approx() - jump).abs() < 1e-14 && slope.accuracy_bits() > 80, "{index}: {slope}");
    }
}

/// Of infinitely many kinks the first are found, with the radius up to which they are known.
#[test]
fn kinks_without_end() {
    let found = profile("abs(sin(pi*r)) + r^2", &[]);
    let (kinks, known): (Vec<f64>, f64) = (found.kinks(), found.kinks_known_to().unwrap());
    assert!(kinks.len() >= 200 && known > 200.0);
    for (i, kink) in kinks.iter().enumerate() {
        assert!((kink - (i + 1) as f64).abs() < 1e-12, "{i}: {kink}");
    }
}

#[test]
fn kinks_have_the_digits_of_the_arithmetic() {
    let formula: Expression = "abs(r^2 - 2)".parse().unwrap();
    let breaks = formula.breaks(&BTreeMap::new()).unwrap();
    for bits in [20, 53, 100, 1000] {
        let precision = Precision::new(bits);
        let profile = formula.bind::<Float>(precision, &BTreeMap::new()).unwrap().broken_at(precision, &breaks);
        assert_eq!(profile.kinks(), [Float::with_val(bits, 2).sqrt()]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(ProptestConfig::default().cases * 64 / 256))]

    /// Products of linear and quadratic factors with random roots, in every function that has kinks.
    #[test]
    fn random_products(roots in prop::collection::btree_set(1u32..2000, 1..6), double in 1u32..2000, shape in 0..4) {
        prop_assume!(!roots.contains(&double));
        let factor = |root: &u32| format!("(r - {root}/128)");
        let product = roots.iter().map(factor).collect::<Vec<_>>().join("*");
        let touching = format!("({}^2 + 1e-30)", factor(&double));
        let formula = match shape {
            0 => format!("abs({product}*{touching})"),
            1 => format!("max({product}, 0*r)"),
            2 => format!("sqrt(({product})^2)"),
            _ => format!("min({product}*r, r - r)*r"),
        };
        let kinks: Vec<f64> = profile(&formula, &[]).kinks();
        let expected: Vec<f64> = roots.iter().map(|root| f64::from(*root) / 128.0).collect();
        prop_assert_eq!(kinks, expected, "{}", formula);
    }
}
