//! Conventions that programs mistake for those of the records, and the answers that follow from each.
//!
//! A mistaken convention changes an input or the unit of an answer by a known factor, or answers a question next to the
//! one that was asked. What it makes of a certified value is exact: most values are monomials of their inputs, and the
//! others have a sibling among the records. No equation is solved here.

use std::f64::consts::PI;

use crate::catalogue::records;
use crate::record::{Record, Status};

/// A convention other than that of the records.
pub(crate) struct Convention {
    /// A stable name.
    pub(crate) name: String,
    /// What follows `if` in a sentence.
    pub(crate) statement: String,
    change: Change,
}

/// What a convention does to an answer.
#[derive(Clone, Copy)]
enum Change {
    /// An input is taken to be this many times as large.
    Input(Input, f64),
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
}

#[derive(Clone, Copy)]
enum Input {
    WorkOfAdhesion,
    Modulus,
    Radius,
}

/// Poisson's ratios that examples and tests are written with.
const POISSON: [&str; 10] = ["0.2", "0.25", "0.28", "0.3", "0.33", "0.35", "0.4", "0.45", "0.49", "0.5"];

/// Units of force, and of length, that programs print in place of N and m.
const UNITS: [(&str, &str, f64); 7] = [
    ("N", "mN", 1e3),
    ("N", "µN", 1e6),
    ("N", "nN", 1e9),
    ("N", "pN", 1e12),
    ("m", "mm", 1e3),
    ("m", "µm", 1e6),
    ("m", "nm", 1e9),
];

impl Convention {
    fn new(name: impl Into<String>, statement: impl Into<String>, change: Change) -> Self {
        Convention { name: name.into(), statement: statement.into(), change }
    }

    /// All that are tested.
    pub(crate) fn all() -> Vec<Convention> {
        use Change::{Control, Input as Scaled, MaugisUnits, OtherEquilibrium, Sign};
        use Input::{Modulus, Radius, WorkOfAdhesion};
        let mut all = vec![
            Convention::new("work-halved", "your work of adhesion is w/2 (γ taken for w)", Scaled(WorkOfAdhesion, 0.5)),
            Convention::new("work-doubled", "your work of adhesion is 2w (w taken for γ)", Scaled(WorkOfAdhesion, 2.0)),
            Convention::new("modulus-k", "your E* is 4E*/3 (K taken for E*)", Scaled(Modulus, 4.0 / 3.0)),
            Convention::new("modulus-from-k", "your E* is 3E*/4 (E* taken for K = 4E*/3)", Scaled(Modulus, 0.75)),
            Convention::new("radius-doubled", "your radius is 2R (a diameter taken for a radius)", Scaled(Radius, 2.0)),
            Convention::new(
                "radius-halved",
                "your radius is R/2 (R taken for the radius of two equal spheres, or for a diameter)",
                Scaled(Radius, 0.5),
            ),
            Convention::new("force-sign", "your force is positive in tension", Sign("force")),
            Convention::new("indentation-sign", "your indentation is positive when pulled out", Sign("indentation")),
            Convention::new(
                "maugis-units",
                "your answers are in the units of Maugis, πwR, (πwR²/K)^(1/3) and (π²w²R/K²)^(1/3)",
                MaugisUnits,
            ),
            Convention::new("control-force", "your folds are those under controlled force", Control("force")),
            Convention::new(
                "control-indentation",
                "your folds are those under controlled indentation",
                Control("indentation"),
            ),
            Convention::new("other-equilibrium", "your equilibria are the other ones of the two", OtherEquilibrium),
        ];
        all.extend(UNITS.into_iter().map(|(unit, printed, factor)| {
            let quantity = if unit == "N" { "forces" } else { "lengths" };
            Convention::new(printed, format!("your {quantity} are in {printed}"), Change::Unit(unit, factor))
        }));
        all.push(Convention::new(
            "modulus-two-bodies",
            "your modulus is E*/2 (E* taken for E of two equal bodies, ν = 0)",
            Scaled(Modulus, 0.5),
        ));
        all.push(Convention::new(
            "modulus-one-of-two",
            "your modulus is 2E* (E of one of two equal bodies taken for E*, ν = 0)",
            Scaled(Modulus, 2.0),
        ));
        all.extend(POISSON.into_iter().flat_map(Convention::of_poisson));
        all
    }

    /// E and E* of one body on a rigid one, or of two equal bodies, in place of each other.
    fn of_poisson(ratio: &str) -> [Convention; 4] {
        let flat = ratio.parse().map_or(f64::NAN, |ratio: f64| 1.0 - ratio * ratio);
        let of = |name: &str, what: &str, factor: f64| {
            let change = Change::Input(Input::Modulus, factor);
            Convention::new(format!("{name}-{ratio}"), format!("your modulus is {what}, ν = {ratio})"), change)
        };
        [
            of("modulus-one-body", "E*/(1−ν²) (E* taken for E of one body", 1.0 / flat),
            of("modulus-two-bodies", "E*/(2(1−ν²)) (E* taken for E of two equal bodies", 0.5 / flat),
            of("modulus-of-one", "E = (1−ν²)E* (E of one body taken for E*", flat),
            of("modulus-one-of-two", "E = 2(1−ν²)E* (E of one of two equal bodies taken for E*", 2.0 * flat),
        ]
    }

    /// What a program with this convention answers where the certified value is `value`; none where this cannot be told
    /// from the record, or is no normal double.
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
            Change::Unit(..) | Change::Sign(_) => None,
        };
        predicted.filter(|value| value.is_normal())
    }
}

/// The certified value, if it is a normal double.
pub(crate) fn normal(record: &Record) -> Option<f64> {
    let is_number = matches!(record.status, Status::Ok | Status::Fold);
    Some(record.nearest()).filter(|value| is_number && value.is_normal())
}

/// The power of an input to which the value is proportional; none where it is no monomial.
///
/// With p = 1/(2n − 1), a state of a power law at a given share of the critical one has a ∝ (w/(E*C²))^p, d ∝ √(wa/E*),
/// F ∝ √(E*w) a^(3/2) and an energy ∝ wa² (1.15 to 1.17, exponent of (1.15) corrected).
fn exponent(record: &Record, input: Input) -> Option<f64> {
    let pick = |radius: Option<f64>, modulus: f64, work: f64| match input {
        Input::Radius => radius,
        Input::Modulus => Some(modulus),
        Input::WorkOfAdhesion => Some(work),
    };
    let quantity = record.quantity.as_str();
    match (record.formula.as_str(), record.profile.as_str()) {
        (
            "critical"
            | "equilibrium-share"
            | "work-lost-at-pull-off"
            | "work-lost-at-jump-in"
            | "barrier-to-complete-contact",
            "power",
        ) => {
            let n = record.input_f64("n")?;
            let p = 1.0 / (2.0 * n - 1.0);
            let (radii, modulus, work) = match quantity {
                "contact_radius" => (1.0, 0.0, 0.0),
                "indentation" => (0.5, -0.5, 0.5),
                "force" => (1.5, 0.5, 0.5),
                "energy" => (2.0, 0.0, 1.0),
                _ => return None,
            };
            // Only a paraboloid has a radius, with C = 1/(2R).
            let radius = is_paraboloid(record).then_some(radii * 2.0 * p);
            pick(radius, modulus - radii * p, work + radii * p)
        }
        ("threshold", _) => match quantity {
            "threshold_c" => pick(None, -0.5, 0.5),
            "ratio" => pick(None, 0.5, -0.5),
            _ => None,
        },
        ("flat-punch-pull-off", _) => match quantity {
            "indentation" => pick(Some(0.5), -0.5, 0.5),
            "force" => pick(Some(1.5), 0.5, 0.5),
            _ => None,
        },
        ("transform", "paraboloid") => pick(Some(-1.0), 0.0, 0.0),
        _ => None,
    }
}

/// Whether the contact is that of f = r²/(2R).
fn is_paraboloid(record: &Record) -> bool {
    record.profile == "power" && record.input("n") == Some("2")
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
            for (input, name) in [(Input::WorkOfAdhesion, "w"), (Input::Modulus, "E*"), (Input::Radius, radius)] {
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
}
