//! Units of length, as powers of ten that are applied to decimals exactly.

use mdr_core::number::Literal;

/// A length with its unit, such as `2 nm`, in metres; `None` unless the text is a number followed by a unit of length.
pub fn length(text: &str) -> Option<Literal> {
    let digits = text.rfind(|c: char| c.is_ascii_digit() || c == '.')? + 1;
    let (number, unit) = text.split_at(digits);
    let number = number.trim();
    number.parse::<Literal>().ok()?;
    scaled(number, decimal_power(unit.trim())?).parse().ok()
}

/// The k of a unit of 10ᵏ m: the metre with an SI prefix, plain or in brackets. µ is accepted in both of its code
/// points, and as `u`.
pub(super) fn decimal_power(unit: &str) -> Option<i64> {
    let bare = unit.trim_matches(['[', ']', '(', ')', ' ']);
    Some(match bare {
        "km" => 3,
        "m" => 0,
        "dm" => -1,
        "cm" => -2,
        "mm" => -3,
        "um" | "\u{b5}m" | "\u{3bc}m" => -6,
        "nm" => -9,
        "\u{c5}" | "A\u{30a}" | "angstrom" => -10,
        "pm" => -12,
        "fm" => -15,
        _ => return None,
    })
}

/// The text of a literal times 10ᵏ, exactly: the exponent of a decimal is shifted, an integer of a fraction gets zeros.
pub(super) fn scaled(text: &str, power: i64) -> String {
    let zeros = |count: i64| "0".repeat(count.max(0) as usize);
    if power == 0 {
        text.to_owned()
    } else if let Some((numerator, denominator)) = text.split_once('/') {
        format!("{numerator}{}/{denominator}{}", zeros(power), zeros(-power))
    } else {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        // The exponent has been parsed as part of the literal, so it is an integer.
        let exponent: i64 = exponent.parse().unwrap_or(0);
        match exponent + power {
            0 => mantissa.to_owned(),
            exponent => format!("{mantissa}e{exponent}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_is_exact() {
        for (text, power, expected) in [
            ("20", -9, "20e-9"),
            ("-1.5e+3", -6, "-1.5e-3"),
            (".5E-2", 3, ".5e1"),
            ("1/3", -3, "1/3000"),
            ("1/3", 2, "100/3"),
            ("0.1", 0, "0.1"),
            ("20e-9", 9, "20"),
        ] {
            assert_eq!(scaled(text, power), expected);
            // The result is the correctly rounded product, not a product of rounded factors.
            let value = scaled(text, power).parse::<Literal>().unwrap().nearest_f64();
            assert_eq!(value, expected.parse::<Literal>().unwrap().nearest_f64());
        }
    }

    #[test]
    fn lengths_have_a_unit() {
        let metres = |text: &str| length(text).map(|literal| literal.to_string());
        assert_eq!(metres("2 nm").as_deref(), Some("2e-9"));
        assert_eq!(metres("1.5e-1um").as_deref(), Some("1.5e-7"));
        assert_eq!([metres("2e-9"), metres("nm"), metres("2 V"), metres("x nm")], [const { None }; 4]);
    }

    #[test]
    fn only_lengths_are_units() {
        assert_eq!(decimal_power("[nm]"), Some(-9));
        assert_eq!(decimal_power("(µm)"), Some(-6));
        assert_eq!((decimal_power("V"), decimal_power("r"), decimal_power("")), (None, None, None));
    }
}
