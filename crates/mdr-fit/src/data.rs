//! Rows of a measured curve: columns by name, units, legs.

use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::{SiUnit, bare, scaled};

use super::observation::Leg;
use super::problem::{DataRow, OwnSigma};
use mdr::Result;
use mdr::reading::Location;

/// The most rows of a measured curve.
pub(super) const MOST_ROWS: usize = 1_000_000;

/// How to make a curve shorter.
pub(super) const FEWER_ROWS: &str = "average or leave out neighbouring rows";

/// Rows from slices, with their legs by the order of X where none are given.
pub(super) fn rows(x: &[f64], y: &[f64], legs: Option<&[Leg]>) -> Result<Vec<DataRow>> {
    if x.len() != y.len() {
        let why = format!("x and y must be of one length, got {} and {}", x.len(), y.len());
        return Err(Location::built("data").refuse(why));
    }
    let found = legs_by_order(x);
    let legs = legs.unwrap_or(&found);
    let row = |((x, y), leg): ((&f64, &f64), &Leg)| DataRow {
        x: *x,
        y: *y,
        time: 0.0,
        sigma: [OwnSigma::NONE; 2],
        part: 0,
        leg: *leg,
    };
    Ok(x.iter().zip(y).zip(legs).map(row).collect())
}

/// A record that turns more than once has cycles. Another turns where X has its extremum: it falls before and after a smallest X inside it, and rises before and falls after
/// a largest one.
pub(super) fn legs_by_order(x: &[f64]) -> Vec<Leg> {
    if let Some(legs) = super::select::cycles(x) {
        return legs;
    }
    let place = |better: fn(f64, f64) -> bool| {
        (0..x.len()).fold(0, |best: usize, index| if better(x[index], x[best]) { index } else { best })
    };
    let (highest, lowest, last) = (place(|x, best| x > best), place(|x, best| x < best), x.len().saturating_sub(1));
    let inside = |index: usize| index > 0 && index < last;
    let (turn, first) = match (inside(highest), inside(lowest)) {
        (true, _) => (highest, Leg::Approach),
        (_, true) => (lowest, Leg::Retract),
        _ if lowest == 0 && last > 0 => (last, Leg::Approach),
        _ => (last, Leg::Retract),
    };
    let second = if first == Leg::Approach { Leg::Retract } else { Leg::Approach };
    (0..x.len()).map(|index| if index <= turn { first } else { second }).collect()
}

/// Rejects rows with which a fit cannot begin.
pub(super) fn check(rows: &[DataRow]) -> std::result::Result<(), String> {
    if rows.len() < 3 {
        return Err(format!("a fit needs at least three rows, got {}", rows.len()));
    }
    for (index, row) in rows.iter().enumerate() {
        for (name, value) in [("x", row.x), ("y", row.y)] {
            if !value.is_finite() {
                return Err(format!("row {}: {name} must be a finite number, got {value}", index + 1));
            }
        }
    }
    for (name, values) in
        [("x", rows.iter().map(|row| row.x).collect::<Vec<_>>()), ("y", rows.iter().map(|row| row.y).collect())]
    {
        if values.iter().all(|value| *value == values[0]) {
            return Err(format!("{name} is {} in all {} rows: a constant tells nothing", values[0], rows.len()));
        }
    }
    Ok(())
}

/// The columns to read from a file: their names, or the first two.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    pub(super) x: Option<String>,
    pub(super) y: Option<String>,
    pub(super) leg: Option<String>,
    pub(super) sigma: [Option<String>; 2],
    /// In s.
    pub(super) time: Option<String>,
    /// Whether rows without a number are left out.
    pub(super) skips_missing: bool,
    /// Units that are stated beside the file.
    pub(super) units: Option<[String; 2]>,
}

/// Names of the legs in files of instruments.
const LEGS: [(Leg, &[&str]); 2] = [
    (
        Leg::Approach,
        &[
            "approach",
            "approaching",
            "extend",
            "extending",
            "extension",
            "trace",
            "advance",
            "load",
            "loading",
            "forward",
        ],
    ),
    (
        Leg::Retract,
        &[
            "retract",
            "retracting",
            "retraction",
            "withdraw",
            "withdrawal",
            "retrace",
            "unload",
            "unloading",
            "reverse",
            "backward",
        ],
    ),
];

/// Whether a field says that nothing was measured.
pub(super) fn is_no_number(field: &str) -> bool {
    let field = field.trim().trim_start_matches(['+', '-']).to_ascii_lowercase();
    ["", "nan", "na", "n/a", "null", "none", "inf", "infinity"].contains(&field.as_str())
}

/// A unit of time in s.
pub(super) fn second(unit: &str) -> std::result::Result<f64, String> {
    let units =
        [("", 1.0), ("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("µs", 1e-6), ("μs", 1e-6), ("ns", 1e-9), ("min", 60.0)];
    let found = units.iter().find(|(name, _)| *name == unit.trim());
    found
        .map(|(_, second)| *second)
        .ok_or_else(|| format!("`{}` is no unit of time: s, ms, us, ns or min", excerpt(unit)))
}

impl Leg {
    /// The leg that instruments call by this name, in capitals or not: `approach`, `extend`, `trace` and the like, or `retract`, `withdraw`,
    /// `retrace`.
    ///
    /// ```
    /// use mdr_fit::Leg;
    /// assert_eq!(Leg::named("Extend"), Some(Leg::Approach));
    /// assert_eq!(Leg::named("pause"), None);
    /// ```
    pub fn named(name: &str) -> Option<Leg> {
        let is_name = |known: &&str| known.eq_ignore_ascii_case(name.trim());
        LEGS.into_iter().find(|(_, names)| names.iter().any(is_name)).map(|(leg, _)| leg)
    }
}

/// The unit of a column, by its name.
pub(super) fn si_unit(base: &str) -> SiUnit {
    match base {
        "m" => SiUnit::Metre,
        "N" => SiUnit::Newton,
        _ => SiUnit::NewtonPerMetre,
    }
}

/// A number with its unit in SI; the unit is a base, `m` or `N`, with a prefix. `None` for another unit or no number.
pub(super) fn si(number: &str, unit: &str, base: &str) -> Option<f64> {
    let power = si_unit(base).power_of(bare(unit))?;
    let number = number.trim();
    by_doubles(number, power).or_else(|| {
        number.parse::<Literal>().ok()?;
        scaled(number, power).parse().ok().map(|literal: Literal| literal.nearest_f64())
    })
}

/// The double nearest to a decimal number times a power of ten, of which records have millions. `None` for a fraction, for a number
/// that is no normal double, and for no number.
fn by_doubles(number: &str, power: i64) -> Option<f64> {
    let of_decimals = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'e' | b'E' | b'+' | b'-');
    if !number.bytes().all(of_decimals) {
        return None;
    }
    let value: f64 = if power == 0 { number.parse() } else { scaled(number, power).parse() }.ok()?;
    value.is_normal().then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What doubles read is the double nearest to the literal, and what is no literal is nothing to them either.
    #[test]
    fn decimals_by_doubles_are_those_of_literals() {
        let (mut read, mut left) = (0, 0);
        let signs = ["", "-", "+", "--"];
        let mantissas = "0|1|1.|.5|.||0.1|123456789012345678901|9.999999999999999999|1.2.3|1-2|00012.50".split('|');
        let ends = "|e5|E-7|e+300|e-309|e-330|e400|e|e1.5|e-|e3e3|e99999999999999999999|/3".split('|');
        for number in signs.iter().flat_map(|sign| mantissas.clone().map(move |mantissa| format!("{sign}{mantissa}"))) {
            for (end, power) in ends.clone().flat_map(|end| [0, -9, 3].map(|power| (end, power))) {
                let number = format!("{number}{end}");
                let literal =
                    number.parse::<Literal>().ok().and_then(|_| scaled(&number, power).parse::<Literal>().ok());
                match by_doubles(&number, power) {
                    Some(value) => {
                        assert_eq!(literal.map(|literal| literal.nearest_f64()), Some(value), "{number} {power}");
                        read += 1;
                    }
                    None => left += 1,
                }
            }
        }
        assert!(read > 200 && left > 1000, "{read} {left}");
    }
}
