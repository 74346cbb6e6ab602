//! Texts whose numbers a person would write: four digits, and a power of ten only where it saves zeros.

/// The text with every decimal rounded to four digits. Whole numbers, names, and numbers that no double holds stay.
pub(crate) fn numbers(text: &str) -> String {
    let mut short = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(|letter: char| letter.is_ascii_digit()) {
        let within_a_name = rest[..start].ends_with(|letter: char| letter.is_alphanumeric() || ".^_".contains(letter));
        let end = start + length(&rest[start..]);
        let number = &rest[start..end];
        short.push_str(&rest[..start]);
        match number.parse() {
            Ok(value) if !within_a_name && number.contains(['.', 'e']) && f64::is_normal(value) => {
                short.push_str(&rounded(value, 4));
            }
            _ => short.push_str(number),
        }
        rest = &rest[end..];
    }
    short + rest
}

/// The bytes of the number at the start of a text: digits, a point, digits, and an exponent where it has digits.
fn length(text: &str) -> usize {
    let digits = |from: usize| from + text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits(0);
    if text[end..].starts_with('.') {
        end = digits(end + 1);
    }
    if let Some(exponent) = text[end..].strip_prefix('e') {
        let from = end + 1 + usize::from(exponent.starts_with(['-', '+']));
        if digits(from) > from {
            end = digits(from);
        }
    }
    end
}

/// The number with so many significant digits.
pub(crate) fn rounded(value: f64, digits: usize) -> String {
    let scientific = format!("{value:.precision$e}", precision = digits - 1);
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    match exponent.parse::<i32>() {
        Ok(exponent @ -3..=4) => {
            let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
            trimmed(&format!("{value:.decimals$}"))
        }
        _ => format!("{}e{exponent}", trimmed(mantissa)),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn as_a_person_writes_them() {
        for (long, short) in [
            ("n = 1e-3, C = 88811524840735.547", "n = 0.001, C = 8.881e13"),
            ("E* = 1.3e6, w = 5e-2 (f64), k = 12", "E* = 1.3e6, w = 0.05 (f64), k = 12"),
            ("n = 1/2, 20 and 40 digits", "n = 1/2, 20 and 40 digits"),
            ("-0.6178954318318282)", "-0.6179)"),
            ("x2.5 = 6.5 of 1.15-printed", "x2.5 = 6.5 of 1.15-printed"),
            ("n ≈ 1.00000000000000e300, 3e400", "n ≈ 1e300, 3e400"),
            ("99999.6 and 9.9996, 12345.6", "1e5 and 10, 12346"),
            ("2e", "2e"),
        ] {
            assert_eq!(super::numbers(long), short);
        }
    }
}
