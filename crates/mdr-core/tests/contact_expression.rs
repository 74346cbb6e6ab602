//! The grammar of formulas: precedence, associativity and the column of an error.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use mdr_core::contact::{Expression, Profile};
use mdr_core::number::Dual;

fn at(formula: &str, r: f64) -> f64 {
    let values = BTreeMap::from([("R".to_owned(), "2".parse().unwrap())]);
    formula.parse::<Expression>().unwrap().bind((), &values).unwrap().height(&r)
}

#[test]
fn precedence_and_associativity() {
    assert_eq!(at("2 + 3*r^2", 2.0), 14.0);
    assert_eq!(at("-r^2", 3.0), -9.0);
    assert_eq!(at("2^3^2", 1.0), 512.0);
    assert_eq!(at("8/2/2", 1.0), 2.0);
    assert_eq!(at("1 - 2 - 3", 1.0), -4.0);
    assert_eq!(at("r^-2", 2.0), 0.25);
    assert_eq!(at("2e-1*r", 10.0), 2.0);
    assert_eq!(at("r^2/(2*R)", 2.0), 1.0);
    assert_eq!(at("sqrt(cos(0*pi))", 1.0), 1.0);
    assert_eq!(at("- -r", 1.0), 1.0);
    assert_eq!(at("abs(1 - r) + min(r, 2*r, 5) - max(1, r)", 3.0), 2.0);
    assert_eq!(at("log10(100*r)", 10.0), 3.0);
    assert_eq!(at("(0-2)^3", 1.0), -8.0, "an integer power has any base");
    assert_eq!(at("(0-2)^3.0e0", 1.0), -8.0);
}

#[test]
fn errors_point_at_the_column() {
    for (formula, column) in [
        ("", 1),
        ("r +", 4),
        ("r + * 2", 5),
        ("(r", 3),
        ("r)", 2),
        ("sec(r)", 1),
        ("log(r)", 1),
        ("min(r)", 6),
        ("max(r, 2", 9),
        ("min(r, )", 8),
        ("abs(r, 2)", 6),
        ("r, 2", 2),
        ("max", 4),
        ("sin r", 5),
        ("2 r", 3),
        ("r $ 2", 3),
        ("1.2.3*r", 1),
        ("r^", 3),
    ] {
        let error = formula.parse::<Expression>().unwrap_err();
        assert_eq!(error.column, column, "{formula:?}: {error}");
    }
    let missing = "r/Q".parse::<Expression>().unwrap().bind::<f64>((), &BTreeMap::new()).unwrap_err();
    assert_eq!(missing.to_string(), "column 3: unknown name `Q`; known here: r, pi");
    assert!("(".repeat(100_000).parse::<Expression>().is_err(), "deep nesting is an error, not a crash");
    assert!("r+".repeat(100_000).parse::<Expression>().is_err(), "so is a long chain");
}

/// Where max(0, x) is 0 its roots and powers are flat, with both derivatives.
#[test]
fn powers_of_a_flat_are_flat() {
    for text in ["max(0, r - 0.5)^1.5", "sqrt(max(0, r - 0.5))", "min(0, 0.5 - r)^2.5"] {
        let formula: Expression = text.parse().unwrap();
        let profile = formula.bind::<f64>((), &BTreeMap::new()).unwrap();
        let f = profile.height(&Dual::variable(Dual::variable(0.2)));
        assert_eq!([f.value.value, f.value.slope, f.slope.value, f.slope.slope], [0.0; 4], "{text}");
    }
}

/// Far from a step and from a peak doubles have derivatives, though e^u is beyond their range.
#[test]
fn steps_and_peaks_are_flat_far_away() {
    for text in
        ["tanh((r - 0.4)/1e-6)", "1/(1 + exp((0.4 - r)/1e-6))", "1/(1 + exp((r - 0.4)/1e-6))", "r/cosh((r - 0.4)/1e-6)"]
    {
        let formula: Expression = text.parse().unwrap();
        let profile = formula.bind::<f64>((), &BTreeMap::new()).unwrap();
        for r in [0.2, 0.6] {
            let f = profile.height(&Dual::variable(Dual::variable(r)));
            assert!(f.value.value.abs() <= 1.0, "{text} at {r}: {f:?}");
            assert_eq!([f.value.slope, f.slope.value, f.slope.slope], [0.0; 3], "{text} at {r}");
        }
    }
}

/// A peak keeps its value and its slope where the ways to compute them meet.
#[test]
fn a_peak_is_the_same_in_both_ways() {
    for u in [299.0_f64, 301.0, -299.0, -301.0] {
        let formula: Expression = "0.7/cosh(r)".parse().unwrap();
        let f = formula.bind::<f64>((), &BTreeMap::new()).unwrap().height(&Dual::variable(u));
        let value = 0.7 / u.cosh();
        assert!(
            (f.value / value - 1.0).abs() < 1e-13 && (f.slope / (-value * u.tanh()) - 1.0).abs() < 1e-13,
            "{u}: {f:?}"
        );
    }
}
