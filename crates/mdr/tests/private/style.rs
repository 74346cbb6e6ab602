//! Numbers for a reader: only the point moves, values stay, and units are shown.

use super::*;

fn written(text: &str, si: &str, units: &str, notation: Notation) -> String {
    let units = if units.is_empty() { Units::default() } else { units.parse().expect("units") };
    NumberStyle { notation, units }.number(text, si)
}

#[test]
fn only_the_point_moves() {
    use Notation::{Engineering, Plain, Scientific};
    for (text, si, units, notation, expected) in [
        ("-0.0000022614848269449457740", "m", "", Plain, "-0.0000022614848269449457740"),
        ("-0.0000022614848269449457740", "m", "", Engineering, "-2.26148 48269 44945 7740e-6"),
        ("-0.0000022614848269449457740", "m", "", Scientific, "-2.26148 48269 44945 7740e-6"),
        ("-0.0000022614848269449457740", "m", "nm", Plain, "-2261.4848269449457740"),
        ("-0.0000022614848269449457740", "m", "m", Engineering, "-2.26148 48269 44945 7740e-6"),
        ("0.2500", "N", "nm,nN", Plain, "2.500e8"),
        ("0.2500", "N", "nm,nN", Engineering, "250.0e6"),
        ("-0.00028492923374", "m", "mm", Engineering, "-0.28492 92337 4"),
        ("0.0189447", "m", "um", Engineering, "18944.7"),
        ("0.2500", "N", "kN", Plain, "0.0002500"),
        ("6.1810e+23", "N", "", Engineering, "618.10e21"),
        // One digit is no three.
        ("5e-7", "m", "", Engineering, "5e-7"),
        ("12", "", "nm", Engineering, "12"),
        ("0", "m", "nm", Engineering, "0"),
        ("-0.0", "m", "nm", Plain, "0"),
        ("1/3", "m", "nm", Engineering, "1/3"),
        ("undecided", "m", "nm", Engineering, "undecided"),
        ("2.5e-17", "m²", "nm", Plain, "25"),
        ("0.2", "N/m", "nN/nm", Plain, "0.2"),
        ("0.2", "N/m", "mN/m", Plain, "2e2"),
        ("1e99999999999999999999", "m", "nm", Plain, "1e99999999999999999999"),
    ] {
        assert_eq!(written(text, si, units, notation), expected, "{text} {si} {units} {notation:?}");
    }
}

/// Every number that a plain table shows is the same number in every other notation, in its unit.
#[test]
fn values_stay() {
    for text in ["0.00026046985393390224962", "-5.0000e-7", "123456.789", "1e-300", "-0.001"] {
        for notation in [Notation::Plain, Notation::Engineering, Notation::Scientific] {
            let value = |text: &str| text.replace(' ', "").parse::<f64>().expect("a number");
            let same = value(&written(text, "m", "", notation));
            assert_eq!(same, value(text), "{text} {notation:?}");
            let nanometres = value(&written(text, "m", "nm", notation)) / 1e9;
            // One rounding of each decimal, one of the quotient.
            assert!((nanometres / value(text) - 1.0).abs() <= 4.0 * f64::EPSILON, "{text} {notation:?}");
        }
    }
}

#[test]
fn magnitudes_are_in_the_unit_shown() {
    let style = NumberStyle { units: "nm".parse().expect("a unit"), ..NumberStyle::default() };
    let huge = Value::out_of_range(400.25);
    assert_eq!(style.value(&huge, "m"), "overflow: about 10^409.250000");
    assert_eq!(style.value(&huge, "N"), huge.to_string());
    assert_eq!(style.value(&Value::Given("0.5".parse().expect("a number")), "m"), "5e8");
}

#[test]
fn units_that_are_none() {
    for text in ["", "nm,", "parsec", "xm", "N/s", "kg", "mm/N"] {
        assert!(text.parse::<Units>().is_err(), "{text}");
    }
    assert!("furlong".parse::<Units>().unwrap_err().to_string().contains("`furlong` is no unit of m, N, Pa"));
}
