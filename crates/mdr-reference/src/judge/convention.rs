//! Conventions that programs mistake for the conventions of the records, and the answers that follow from each.
//!
//! A mistaken convention changes an input or the unit of an answer by a known factor, or answers a question next to the
//! one that was asked. Its effect on a certified value is exact: most values are monomials of their inputs, and the
//! others have a sibling among the records. No equation is solved here.

use std::f64::consts::PI;

use crate::catalogue::records;
use crate::record::{Record, Status};

/// A convention other than that of the records.
pub(crate) struct Convention {
    /// A stable name.
    pub(crate) name: String,
    /// The words after `if` in a sentence.
    pub(crate) statement: String,
    change: Change,
}

/// The effect of a convention on an answer.
#[derive(Clone, Copy)]
enum Change {
    /// An input, `w`, `E*` or `R`, is taken to be this many times as large.
    Input(&'static str, f64),
    /// Answers with this unit, to this power for areas, are this many times as large.
    Unit(&'static str, f64),
    /// Answers of this quantity have the other sign.
    Sign(&'static str),
    /// Answers are divided by the units of Maugis.
    MaugisUnits,
    /// Answers are those under this control.
    Control(&'static str),
    /// Answers belong to the other equilibrium of the two at the same value.
    OtherEquilibrium,
    /// π is this number. Of a paraboloid it stands beside w and nowhere else.
    Pi(f64),
}

/// Poisson's ratios that examples and tests are written with.
const POISSON: [&str; 10] = ["0.2", "0.25", "0.28", "0.3", "0.33", "0.35", "0.4", "0.45", "0.49", "0.5"];

impl Convention {
    /// All conventions of `data/conventions.tsv`, which are tested; those with a Poisson's ratio come last, once for each ratio.
    pub(crate) fn all() -> Vec<Convention> {
        let table = include_str!("../../data/conventions.tsv");
        let (of_poisson, plain): (Vec<_>, Vec<_>) =
            table.lines().filter(|line| !line.starts_with('#')).partition(|line| line.contains("{ν}"));
        let plain = plain.into_iter().map(|line| (line, "0"));
        let of_poisson = POISSON.into_iter().flat_map(|ratio| of_poisson.iter().map(move |&line| (line, ratio)));
        plain.chain(of_poisson).filter_map(|(line, ratio)| Convention::read(line, ratio)).collect()
    }

    /// The convention of a line of the table for a Poisson's ratio; `None` if the line cannot be read.
    fn read(line: &'static str, ratio: &str) -> Option<Convention> {
        let cells: [&str; 6] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        let [name, statement, change, of, factor, power] = cells;
        let (factor, nu): (f64, f64) = (factor.parse().ok()?, ratio.parse().ok()?);
        let flat = 1.0 - nu * nu;
        let factor = match power {
            "1" => factor * flat,
            "-1" => factor / flat,
            "1-ν" => factor * (1.0 - nu),
            _ => factor,
        };
        let change = match change {
            "input" => Change::Input(of, factor),
            "unit" => Change::Unit(of, factor),
            "sign" => Change::Sign(of),
            "maugis-units" => Change::MaugisUnits,
            "control" => Change::Control(of),
            "other-equilibrium" => Change::OtherEquilibrium,
            "pi" => Change::Pi(factor),
            _ => return None,
        };
        let [name, statement] = [name, statement].map(|text| text.replace("{ν}", ratio));
        Some(Convention { name, statement, change })
    }

    /// The answer of a program with this convention where the certified value is `value`; `None` if it does not follow from the
    /// record, or is no normal double.
    pub(crate) fn predict(&self, record: &Record, value: f64) -> Option<f64> {
        let scaled = |factor: f64| Some(value * factor);
        let predicted = match self.change {
            Change::Input(input, factor) => scaled(factor.powf(exponent(record, input)?)),
            Change::Unit(unit, factor) if record.unit == unit => scaled(factor),
            Change::Unit("m", factor) if record.unit == "m^2" => scaled(factor * factor),
            Change::Sign(quantity) if record.quantity == quantity => scaled(-1.0),
            Change::MaugisUnits => scaled(1.0 / maugis_unit(record, &record.quantity)?),
            Change::Control(control) => normal(under_control(record, control)?),
            Change::OtherEquilibrium => normal(other_equilibrium(record)?),
            Change::Pi(pi) if is_paraboloid(record) => scaled((pi / PI).powf(exponent(record, "w")?)),
            Change::Unit(..) | Change::Sign(_) | Change::Pi(_) => None,
        };
        predicted.filter(|value| value.is_normal())
    }

    /// Whether the answer of a program with this convention is the certified value, because it concerns other answers.
    pub(crate) fn leaves(&self, record: &Record) -> bool {
        match self.change {
            Change::Unit(unit, _) => record.unit != unit && (unit, record.unit.as_str()) != ("m", "m^2"),
            Change::Sign(quantity) => record.quantity != quantity,
            Change::Control(control) => record.control.as_deref() == Some(control),
            Change::Input(input, _) => exponent(record, input) == Some(0.0),
            Change::MaugisUnits | Change::OtherEquilibrium | Change::Pi(_) => false,
        }
    }

    /// Whether it is one of unit or sign: several of them may be mistaken together, each in its answers.
    pub(crate) fn is_of_notation(&self) -> bool {
        matches!(self.change, Change::Unit(..) | Change::Sign(_))
    }
}

/// The certified value, if it is a normal double.
pub(crate) fn normal(record: &Record) -> Option<f64> {
    let is_number = matches!(record.status, Status::Ok | Status::Fold);
    Some(record.nearest()).filter(|value| is_number && value.is_normal())
}

/// The power of an input to which the value is proportional; `None` if the value is no monomial.
///
/// At a given share of the critical state d ∝ √(wa/E*), F ∝ √(E*w) a^(3/2) and an energy ∝ wa² (1.16, 1.17). The contact radius
/// itself is that of a punch, or (1.15 with its exponent corrected) a ∝ (w/(E*C²))^p, p = 1/(2n − 1).
fn exponent(record: &Record, input: &str) -> Option<f64> {
    // The powers of a, E* and w in the value.
    let (radii, modulus, work) = match (record.formula.as_str(), record.quantity.as_str()) {
        ("threshold", "threshold_c") => (0.0, -0.5, 0.5),
        ("threshold", "ratio") => (0.0, 0.5, -0.5),
        ("transform", _) => (-1.0, 0.0, 0.0),
        (_, "contact_radius") => (1.0, 0.0, 0.0),
        (_, "indentation") => (0.5, -0.5, 0.5),
        (_, "force") => (1.5, 0.5, 0.5),
        (_, "energy") => (2.0, 0.0, 1.0),
        _ => return None,
    };
    // The power of R in a, where there is one, and that of w/E*.
    let (radius, share) = match (record.formula.as_str(), record.profile.as_str()) {
        (
            "critical"
            | "equilibrium-share"
            | "work-lost-at-pull-off"
            | "work-lost-at-jump-in"
            | "barrier-to-complete-contact",
            "power",
        ) => {
            let p = 1.0 / (2.0 * record.input_f64("n")? - 1.0);
            // Only a paraboloid has a radius, with C = 1/(2R).
            (is_paraboloid(record).then_some(2.0 * p), p)
        }
        ("threshold", _) => (None, 0.0),
        ("flat-punch-pull-off", _) | ("transform", "paraboloid") => (Some(1.0), 0.0),
        _ => return None,
    };
    match input {
        "R" => radius.map(|power| radii * power),
        "E*" => Some(modulus - radii * share),
        "w" => Some(work + radii * share),
        _ => None,
    }
}

/// Whether the contact is that of f = r²/(2R) on a half-space.
fn is_paraboloid(record: &Record) -> bool {
    record.profile == "power" && record.input("n") == Some("2") && record.formula != "line-critical"
}

/// The unit of Maugis for a quantity of a paraboloid: πwR for a force, (πwR²/K)^(1/3) for a contact radius and
/// (π²w²R/K²)^(1/3) for an indentation, with K = 4E*/3.
pub(crate) fn maugis_unit(record: &Record, quantity: &str) -> Option<f64> {
    let is_contact = is_paraboloid(record) && record.formula != "kappa";
    let input = |name: &str| record.input_f64(name).filter(|value| is_contact && *value > 0.0);
    let (radius, bulk, work) = (0.5 / input("C")?, 4.0 / 3.0 * input("E*")?, PI * input("w")?);
    match quantity {
        "force" => Some(work * radius),
        "contact_radius" => Some((work / bulk).cbrt() * radius.cbrt() * radius.cbrt()),
        "indentation" => Some((work / bulk).cbrt() * (work / bulk).cbrt() * radius.cbrt()),
        _ => None,
    }
}

/// The record of the same fold, or of the same share of it, under another control. A machine has a stiffness more.
fn under_control(record: &Record, control: &str) -> Option<&'static Record> {
    let given = record.control.as_deref().filter(|given| *given != control)?;
    let (formula, left_out): (&str, &[&str]) = match (record.formula.as_str(), given) {
        ("critical" | "equilibrium-share", _) => (&record.formula, &[]),
        ("folds", _) => ("folds", &["k"]),
        ("machine-folds", _) => ("critical", &["k", "fold"]),
        _ => return None,
    };
    let kept = || record.inputs.iter().filter(|(name, _)| !left_out.contains(&name.as_str()));
    records().iter().find(|other| {
        other.control.as_deref() == Some(control)
            && other.formula == formula
            && other.profile == record.profile
            && other.quantity == record.quantity
            && side(other) == side(record)
            && other.inputs.iter().eq(kept())
    })
}

/// The record of the other equilibrium of a power law at the same value.
fn other_equilibrium(record: &Record) -> Option<&'static Record> {
    let (formula, given) = (record.formula.as_str(), side(record)?);
    records().iter().find(|other| {
        other.formula == formula
            && other.control == record.control
            && other.quantity == record.quantity
            && side(other).is_some_and(|side| side != given)
            && other.inputs == record.inputs
    })
}

/// On which side of the fold an equilibrium of a power law stands.
fn side(record: &Record) -> Option<&'static str> {
    ["inner", "outer"].into_iter().find(|side| record.flags.iter().any(|flag| flag == side))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The records hold the magnitude of every exponent as a condition, computed by their generator.
    #[test]
    fn exponents_are_the_conditions_of_the_records() {
        let mut compared = 0;
        for record in records().iter().filter(|record| normal(record).is_some()) {
            let radius = if record.profile == "power" { "C" } else { "radius" };
            for (input, name) in [("w", "w"), ("E*", "E*"), ("R", radius)] {
                let known = record.condition.iter().find(|(known, _)| known == name);
                let (Some((_, condition)), Some(exponent)) = (known, exponent(record, input)) else { continue };
                let difference = (exponent.abs() - condition).abs();
                // R is proportional to 1/C; conditions have three digits.
                assert!(difference <= 6e-3 * condition.max(0.1), "{}: {name}: {exponent} and {condition}", record.id);
                compared += 1;
            }
        }
        assert!(compared > 1000, "{compared}");
    }

    #[test]
    fn every_line_of_the_table_is_a_convention() {
        let table = include_str!("../../data/conventions.tsv").lines().filter(|line| !line.starts_with('#'));
        assert!(table.clone().all(|line| Convention::read(line, "0.5").is_some()));
        assert_eq!((table.count(), Convention::all().len()), (38, 33 + 5 * POISSON.len()));
    }
}
