//! Columns of numbers for a terminal that is narrower than their digits: each in one notation, with six significant digits.

/// Significant digits of the largest number of a column.
const DIGITS: i32 = 6;

/// Numbers that differ more have a power of ten each.
const SPAN: f64 = 1e4;

/// The numbers of a column, shortened, and the unit that they have then. `None` where one is no decimal.
pub(crate) fn shortened(numbers: &[&str], unit: &str) -> Option<(Vec<String>, String)> {
    let values: Vec<f64> = numbers.iter().map(|text| text.parse().ok()).collect::<Option<_>>()?;
    if !values.iter().all(|value| value.is_finite()) {
        return None;
    }
    let sizes = || values.iter().map(|value| value.abs()).filter(|size| *size > 0.0);
    let (least, most) = (sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
    let is_short = |text: &&str| text.len() <= DIGITS as usize && !text.contains('e');
    if most == 0.0 || numbers.iter().all(is_short) {
        return Some((numbers.iter().map(|text| (*text).to_owned()).collect(), unit.to_owned()));
    }
    if most / least > SPAN {
        let digits = (DIGITS - 1) as usize;
        let text = |value: &f64| if *value == 0.0 { "0".to_owned() } else { format!("{value:.digits$e}") };
        return Some((values.iter().map(text).collect(), unit.to_owned()));
    }
    let exponent = most.log10().floor() as i32;
    let power = 3 * exponent.div_euclid(3);
    let (power, unit) = match with_prefix(power, unit) {
        Some(unit) => (power, unit),
        // What has no prefix keeps its numbers where they are legible.
        None if (-3..DIGITS).contains(&exponent) => (0, unit.to_owned()),
        None => (power, format!("1e{power} {unit}").trim_end().to_owned()),
    };
    let decimals = (DIGITS - 1 - (exponent - power)).max(0) as usize;
    // A power of ten to be divided by is exact longer than one to be multiplied with.
    let scaled = |value: &f64| if power < 0 { value * 10_f64.powi(-power) } else { value / 10_f64.powi(power) };
    let text = |value: &f64| if *value == 0.0 { "0".to_owned() } else { format!("{:.decimals$}", scaled(value)) };
    Some((values.iter().map(text).collect(), unit))
}

/// A unit with the prefix of a power of ten.
fn with_prefix(power: i32, unit: &str) -> Option<String> {
    const PREFIXES: [&str; 13] = ["a", "f", "p", "n", "µ", "m", "", "k", "M", "G", "T", "P", "E"];
    // A power of a unit takes that of its prefix, too.
    let is_plain = !unit.is_empty() && unit.chars().all(|letter| letter.is_ascii_alphabetic() || letter == '/');
    let prefix = PREFIXES.get(usize::try_from(power / 3 + 6).ok()?)?;
    is_plain.then(|| format!("{prefix}{unit}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(numbers: &[&str], unit: &str) -> (String, String) {
        let (numbers, unit) = shortened(numbers, unit).unwrap_or_default();
        (numbers.join(" "), unit)
    }

    #[test]
    fn a_column_has_one_notation() {
        let of = |numbers: &str, unit: &str| (numbers.to_owned(), unit.to_owned());
        assert_eq!(column(&["-2e-8", "-1.882352941176470e-8", "0"], "m"), of("-20.0000 -18.8235 0", "nm"));
        assert_eq!(column(&["1", "2"], ""), of("1 2", ""), "what is short stays");
        assert_eq!(column(&["1e-3", "123456.7"], "N"), of("1.00000e-3 1.23457e5", "N"), "decades apart");
        assert_eq!(column(&["0.0123456789", "0.5"], ""), of("0.012346 0.500000", ""));
        assert_eq!(column(&["1.23456789e-9"], "m²"), of("1.23457", "1e-9 m²"));
        assert_eq!(shortened(&["1/3"], "m"), None);
        assert_eq!(shortened(&["1e400"], "m"), None, "beyond a double");
    }
}
