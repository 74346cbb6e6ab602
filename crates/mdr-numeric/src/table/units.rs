//! Units of length, as powers of ten that are applied to decimals exactly.

/// The k of a unit of 10ᵏ m: the metre with an SI prefix, plain or in brackets. µ is taken in both of its code points,
/// and as `u`.
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

/// The text of a literal times 10ᵏ, exactly: the exponent of a decimal moves, an integer of a fraction gets zeros.
pub(super) fn scaled(text: &str, power: i64) -> String {
    let zeros = |count: i64| "0".repeat(count.max(0) as usize);
    if power == 0 {
        text.to_owned()
    } else if let Some((numerator, denominator)) = text.split_once('/') {
        format!("{numerator}{}/{denominator}{}", zeros(power), zeros(-power))
    } else {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        // The exponent was read before as part of the literal; it is an integer.
        let exponent: i64 = exponent.parse().unwrap_or(0);
        format!("{mantissa}e{}", exponent + power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdr_core::number::Literal;

    #[test]
    fn scaling_is_exact() {
        for (text, power, expected) in [
            ("20", -9, "20e-9"),
            ("-1.5e+3", -6, "-1.5e-3"),
            (".5E-2", 3, ".5e1"),
            ("1/3", -3, "1/3000"),
            ("1/3", 2, "100/3"),
            ("0.1", 0, "0.1"),
        ] {
            assert_eq!(scaled(text, power), expected);
            // What is read back is the correctly rounded product, not a product of rounded factors.
            let value = scaled(text, power).parse::<Literal>().unwrap().nearest_f64();
            assert_eq!(value, expected.parse::<Literal>().unwrap().nearest_f64());
        }
    }

    #[test]
    fn only_lengths_are_units() {
        assert_eq!(decimal_power("[nm]"), Some(-9));
        assert_eq!(decimal_power("(µm)"), Some(-6));
        assert_eq!((decimal_power("V"), decimal_power("r"), decimal_power("")), (None, None, None));
    }
}
