//! Numbers for a reader: units with prefixes, engineering notation, digits in groups. Only the decimal point moves, so that a
//! certified digit stays certified.

use std::borrow::Cow;
use std::str::FromStr;

use mdr_core::units::SiUnit;

use super::{FlatCell, Value};

/// How the digits of a number are laid out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// As in JSON, to be copied.
    #[default]
    Plain,
    /// Powers of a thousand, and the decimals in groups of five: `260.46985 39339e-6`.
    Engineering,
    /// One digit before the point, and the decimals in groups of five: `2.60469 85393 39e-4`.
    Scientific,
}

/// Units that take the place of SI units, such as `nm,nN`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Units(Vec<Unit>);

/// A unit with its prefixes, and 10^power of it in one unit of the SI.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Unit {
    name: String,
    base: &'static str,
    power: i64,
}

/// A unit that nothing in an answer has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{}` is no unit of m, N, Pa, J or N/m with prefixes from q to Q, such as nm,nN,kPa,aJ,nN/nm", mdr_core::text::excerpt(.0))]
pub struct UnitError(String);

impl FromStr for Unit {
    type Err = UnitError;

    fn from_str(name: &str) -> Result<Self, UnitError> {
        const SHOWN: [SiUnit; 5] =
            [SiUnit::Metre, SiUnit::Newton, SiUnit::Pascal, SiUnit::Joule, SiUnit::NewtonPerMetre];
        // A power has no unit of its own here: areas follow lengths.
        let is_plain = name.chars().all(|letter| letter.is_alphabetic() || letter == '/');
        let found = SHOWN.iter().filter(|_| is_plain).find_map(|unit| Some((unit.symbol(), -unit.power_of(name)?)));
        let (base, power) = found.ok_or_else(|| UnitError(name.to_owned()))?;
        Ok(Unit { name: name.to_owned(), base, power })
    }
}

/// Separated by commas. Where a quantity has two units the last one counts.
impl FromStr for Units {
    type Err = UnitError;

    fn from_str(text: &str) -> Result<Self, UnitError> {
        text.split(',').map(|name| name.trim().parse()).collect::<Result<_, _>>().map(Units)
    }
}

impl Units {
    /// The unit shown for a unit of the SI, and the power of ten by which its numbers grow; areas follow lengths.
    fn shown<'a>(&'a self, si: &'a str) -> (Cow<'a, str>, i64) {
        let of = |base: &str| self.0.iter().rev().find(|unit| unit.base == base);
        match (of(si), si) {
            (Some(unit), _) => (Cow::Borrowed(unit.name.as_str()), unit.power),
            (None, "m²") => of("m").map_or((si.into(), 0), |unit| (format!("{}²", unit.name).into(), 2 * unit.power)),
            (None, _) => (si.into(), 0),
        }
    }
}

/// Writes the numbers of answers for a reader.
///
/// ```
/// use mdr::answer::{Notation, NumberStyle};
/// let style = NumberStyle { notation: Notation::Engineering, units: "um,mN".parse()? };
/// assert_eq!(style.quantity("0.00026046985393390224962", "m"), "260.46985 39339 02249 62 um");
/// assert_eq!(style.quantity("-0.0023561944901923449288", "N"), "-2.35619 44901 92344 9288 mN");
/// assert_eq!(style.number("3.9e-8", "J"), "39e-9");
/// assert_eq!(style.titled("integral", "m²"), "integral, um²");
/// # Ok::<(), mdr::answer::UnitError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NumberStyle {
    /// The layout of digits.
    pub notation: Notation,
    /// Units in place of those of the SI.
    pub units: Units,
}

impl NumberStyle {
    /// A number of an answer, given as text in the SI unit `si`. A text that is no decimal, such as `1/3`, stays as it is.
    pub fn number(&self, text: &str, si: &str) -> String {
        let (_, power) = self.units.shown(si);
        match Digits::of(text) {
            Some(digits) if power != 0 || self.notation != Notation::Plain => digits.write(power, self.notation),
            _ => text.to_owned(),
        }
    }

    /// A cell in the SI unit `si`; an input keeps its notation.
    pub fn cell(&self, cell: &FlatCell, si: &str) -> String {
        match cell {
            FlatCell::Number(text) => self.number(text, si),
            FlatCell::Text(text) => self.plain().number(text, si),
            FlatCell::Magnitude(log10) => FlatCell::Magnitude(self.magnitude(*log10, si)).to_string(),
            cell => cell.to_string(),
        }
    }

    /// The units of this style in plain notation, for copying.
    pub fn plain(&self) -> Self {
        NumberStyle { notation: Notation::Plain, units: self.units.clone() }
    }

    /// A number with its unit.
    pub fn quantity(&self, text: &str, si: &str) -> String {
        format!("{} {}", self.number(text, si), self.unit(si))
    }

    /// A number of an answer in the SI unit `si`; without a number its status, and its magnitude if that is computed.
    pub fn value(&self, value: &Value, si: &str) -> String {
        match (value.status(), value.log10()) {
            (status, Some(log10)) if log10.is_finite() => {
                format!("{status}: about 10^{:.6}", self.magnitude(log10, si))
            }
            _ => self.number(&value.to_string(), si),
        }
    }

    /// log₁₀ of a number that is out of range, given in the SI unit `si`.
    pub fn magnitude(&self, log10: f64, si: &str) -> f64 {
        log10 + self.units.shown(si).1 as f64
    }

    /// The displayed unit for a unit of the SI.
    pub fn unit<'a>(&'a self, si: &'a str) -> Cow<'a, str> {
        self.units.shown(si).0
    }

    /// `name, unit`; the name alone for a number without unit.
    pub fn titled(&self, name: &str, si: &str) -> String {
        if si.is_empty() { name.to_owned() } else { format!("{name}, {}", self.unit(si)) }
    }
}

/// ± d.ddd… · 10^exponent, as the digits that were written.
struct Digits<'a> {
    sign: &'a str,
    digits: String,
    exponent: i64,
}

impl<'a> Digits<'a> {
    /// `None` if the text is no decimal, or its exponent is beyond 64 bits.
    fn of(text: &'a str) -> Option<Self> {
        let (sign, rest) = text.strip_prefix('-').map_or(("", text), |rest| ("-", rest));
        let (mantissa, exponent) = rest.split_once('e').unwrap_or((rest, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let all = format!("{whole}{fraction}");
        if all.is_empty() || !all.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        let leading = all.bytes().take_while(|digit| *digit == b'0').count();
        let exponent = exponent.parse::<i64>().ok()?.checked_add(whole.len() as i64 - 1 - leading as i64)?;
        Some(Digits { sign, digits: all[leading..].to_owned(), exponent })
    }

    fn write(&self, power: i64, notation: Notation) -> String {
        /// Longer runs of zeros are a power of ten.
        const ZEROS: i64 = 6;
        let Some(exponent) = self.exponent.checked_add(power).filter(|_| !self.digits.is_empty()) else {
            return "0".to_owned();
        };
        let count = self.digits.len() as i64;
        // A zero that is no digit of the number is never put before its point.
        let before = match notation {
            Notation::Plain if (0..count).contains(&exponent) => exponent,
            Notation::Plain if (-ZEROS..0).contains(&exponent) => exponent,
            // A unit that was chosen is meant to need no power of ten.
            Notation::Engineering if power != 0 && (-3..count.min(6)).contains(&exponent) => exponent,
            Notation::Engineering if exponent.rem_euclid(3) < count => exponent.rem_euclid(3),
            _ => 0,
        };
        let (whole, fraction) = match usize::try_from(before) {
            Ok(before) => (self.digits[..=before].to_owned(), self.digits[before + 1..].to_owned()),
            Err(_) => ("0".to_owned(), format!("{}{}", "0".repeat((-before - 1) as usize), self.digits)),
        };
        let fraction = if notation == Notation::Plain { fraction } else { grouped(&fraction) };
        let point = if fraction.is_empty() { "" } else { "." };
        let times = if exponent == before { String::new() } else { format!("e{}", exponent - before) };
        format!("{}{whole}{point}{fraction}{times}", self.sign)
    }
}

/// Groups of five digits.
fn grouped(digits: &str) -> String {
    let groups: Vec<&str> = (0..digits.len()).step_by(5).map(|at| &digits[at..digits.len().min(at + 5)]).collect();
    groups.join(" ")
}

#[cfg(test)]
#[path = "../../tests/private/style.rs"]
mod tests;
