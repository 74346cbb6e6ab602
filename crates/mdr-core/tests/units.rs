//! Numbers with units: exact, of the dimension of their key, or refused.

use mdr_core::contact::Shape;
use mdr_core::number::Literal;
use mdr_core::units::SiUnit;
use proptest::prelude::*;

const PREFIXES: [(&str, i32); 9] =
    [("f", -15), ("p", -12), ("n", -9), ("u", -6), ("µ", -6), ("μ", -6), ("m", -3), ("k", 3), ("G", 9)];

proptest! {
    #[test]
    fn a_prefix_shifts_the_decimal_point_and_no_digit(
        number in "[-+]?[0-9]{1,30}(\\.[0-9]{0,30})?(e[-+]?[0-9]{1,3})?",
        which in 0..PREFIXES.len(),
        gap in " ?",
    ) {
        let (prefix, power) = PREFIXES[which];
        let (mantissa, exponent) = number.split_once('e').unwrap_or((&number, "0"));
        let shifted = format!("{mantissa}e{}", exponent.parse::<i32>().unwrap() + power);
        let expected: Literal = shifted.parse().unwrap();
        for (unit, base) in [(SiUnit::Metre, "m"), (SiUnit::Newton, "N"), (SiUnit::Pascal, "Pa"), (SiUnit::NewtonPerMetre, "N/m")] {
            let read = unit.read(&format!("{number}{gap}{prefix}{base}")).unwrap();
            prop_assert!(read.compare(&expected).is_eq(), "{number}{prefix}{base}");
        }
    }

    #[test]
    fn a_prefix_of_a_fraction_is_exact(numerator in 0u32.., denominator in 1u32.., which in 0..PREFIXES.len()) {
        let (prefix, power) = PREFIXES[which];
        let zeros = |power: i32| "0".repeat(power.max(0) as usize);
        let expected: Literal = format!("{numerator}{}/{denominator}{}", zeros(power), zeros(-power)).parse().unwrap();
        let read = SiUnit::Metre.read(&format!("{numerator}/{denominator} {prefix}m")).unwrap();
        prop_assert!(read.compare(&expected).is_eq());
    }
}

#[test]
fn the_ways_to_write_a_unit() {
    for (unit, text, expected) in [
        (SiUnit::Metre, "5 um", "5e-6"),
        (SiUnit::Metre, "5µm", "5e-6"),
        (SiUnit::Metre, "5 \u{3bc}m", "5e-6"),
        (SiUnit::Metre, " -0.5nm ", "-0.5e-9"),
        (SiUnit::Metre, "3 Å", "3e-10"),
        (SiUnit::Metre, "2 m", "2"),
        (SiUnit::Metre, "1e-9m", "1e-9"),
        (SiUnit::Metre, "1/3um", "1/3000000"),
        (SiUnit::JoulePerSquareMetre, "50 mJ/m2", "50e-3"),
        (SiUnit::JoulePerSquareMetre, "50 mJ/m²", "50e-3"),
        (SiUnit::JoulePerSquareMetre, "50 mJ m^-2", "50e-3"),
        (SiUnit::JoulePerSquareMetre, "0.05 N/m", "0.05"),
        (SiUnit::JoulePerSquareMetre, "50mN/m", "50e-3"),
        (SiUnit::NewtonPerMetre, "0.3 nN/nm", "0.3"),
        (SiUnit::NewtonPerMetre, "4 pN/nm", "4e-3"),
        (SiUnit::Pascal, "1 GPa", "1e9"),
        (SiUnit::Pascal, "2.5 N/mm^2", "2.5e6"),
        (SiUnit::Degree, "20deg", "20"),
        (SiUnit::Degree, "20°", "20"),
        (SiUnit::Unstated, "7 kPa", "7e3"),
        (SiUnit::One, "1/2", "1/2"),
        (SiUnit::Coefficient, "1e-6", "1e-6"),
    ] {
        assert_eq!(unit.read(text).map(|number| number.to_string()).as_deref(), Ok(expected), "{text}");
    }
}

#[test]
fn what_is_no_number_in_the_unit_of_its_key() {
    for (unit, text, parts) in [
        (SiUnit::NewtonPerMetre, "0.3 nm", &["key is in N/m; got \"0.3 nm\"", "mN/m"][..]),
        (SiUnit::Metre, "5 nN", &["key is in m; got \"5 nN\"", "um"]),
        (SiUnit::Metre, "20 deg", &["key is in m"]),
        (SiUnit::One, "2 nm", &["key is a pure number"]),
        (SiUnit::Coefficient, "1 um", &["key is in m^(1-n)"]),
        (SiUnit::Unstated, "20 deg", &["radians"]),
        (SiUnit::Pascal, "1 Gpa", &["unknown unit `Gpa`", "did you mean `GPa`?"]),
        (SiUnit::Metre, "5 nn", &["unknown unit `nn`", "did you mean `nm`?"]),
        (SiUnit::Metre, "5 parsec", &["unknown unit `parsec`", "um, nm"]),
        (SiUnit::Metre, "5 m/", &["unknown unit `m/`"]),
        (SiUnit::Metre, "5 m^99999999999999999999", &["unknown unit"]),
        (SiUnit::Metre, "1e", &["not a number"]),
        (SiUnit::Metre, "nm", &["not a number"]),
        (SiUnit::Metre, "nan nm", &["not a number"]),
        (SiUnit::Metre, "1,5 nm", &["not a number"]),
        (SiUnit::Metre, "1/0 nm", &["division by zero"]),
        (SiUnit::Metre, "1e100001 km", &["too large"]),
        (SiUnit::Metre, "inf", &["not finite"]),
        (SiUnit::One, "1x", &["not a number"]),
    ] {
        let error = unit.read(text).expect_err(text).of("key");
        for part in parts {
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}

#[test]
fn a_key_has_one_unit_in_all_shapes() {
    for name in Shape::names() {
        let shape = Shape::by_name(name).unwrap();
        let keys: Vec<_> = shape.parameters().into_iter().map(|(key, ())| key).collect();
        assert_eq!(keys, shape.units().iter().map(|(key, _)| *key).collect::<Vec<_>>());
        for (key, unit) in shape.units() {
            assert_eq!(Shape::unit_of_key(key), Some(unit), "{name} {key}");
        }
    }
    assert_eq!(Shape::unit_of_key("half_angle_degrees"), Some(SiUnit::Degree));
}
