//! Decimals as text: the same number in another form, and rounded to fewer digits.

/// ± 0.d₁d₂… · 10^exponent without trailing zeros.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Decimal {
    negative: bool,
    digits: String,
    exponent: i64,
}

impl Decimal {
    /// Reads what `mdr` or mpmath print.
    pub(crate) fn new(text: &str) -> Self {
        let (negative, text) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
        let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let all = format!("{whole}{fraction}");
        assert!(!all.is_empty() && all.bytes().all(|b| b.is_ascii_digit()), "{text:?} is no decimal");
        let leading = all.len() - all.trim_start_matches('0').len();
        let exponent = power.parse::<i64>().unwrap() + whole.len() as i64 - leading as i64;
        let digits = all.trim_matches('0').to_owned();
        let exponent = if digits.is_empty() { 0 } else { exponent };
        Decimal { negative: negative && !digits.is_empty(), digits, exponent }
    }

    /// Rounded to `count` significant digits. A tie does not occur with irrational numbers.
    pub(crate) fn round(&self, count: usize) -> Self {
        let Some(next) = self.digits.as_bytes().get(count) else { return self.clone() };
        let mut digits = self.digits.as_bytes()[..count].to_vec();
        let mut exponent = self.exponent;
        if *next >= b'5' {
            match digits.iter().rposition(|digit| *digit != b'9') {
                Some(last) => {
                    digits.truncate(last + 1);
                    digits[last] += 1;
                }
                None => {
                    digits = vec![b'1'];
                    exponent += 1;
                }
            }
        }
        let digits = String::from_utf8(digits).unwrap().trim_end_matches('0').to_owned();
        Decimal { negative: self.negative, digits, exponent }
    }
}

/// The significant digits that a text of `mdr` shows.
pub(crate) fn significant_digits(text: &str) -> usize {
    let mantissa = text.trim_start_matches('-').split('e').next().unwrap_or_default();
    mantissa.chars().filter(char::is_ascii_digit).skip_while(|digit| *digit == '0').count()
}

#[test]
fn reads_and_rounds() {
    assert_eq!(Decimal::new("-0.00120"), Decimal::new("-1.2e-3"));
    assert_eq!(Decimal::new("1200"), Decimal::new("1.20e+3"));
    assert_eq!(Decimal::new("0"), Decimal::new("0.000"));
    assert_eq!(Decimal::new("99.96").round(3), Decimal::new("100"));
    assert_eq!(Decimal::new("1.2344").round(4), Decimal::new("1.234"));
    assert_ne!(Decimal::new("1.2e-3"), Decimal::new("1.2e-4"));
    assert_eq!(significant_digits("-0.00120e-7"), 3);
}
