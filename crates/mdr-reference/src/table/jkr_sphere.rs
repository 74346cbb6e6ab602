//! The sphere of Johnson, Kendall and Roberts.

use crate::catalogue::records;
use crate::decimal::Decimal;
use crate::judge::maugis_unit;
use crate::record::{Record, Status};
use crate::table::{Cell, Column, Table};

/// The questions, by the part of an identifier before its quantity, each with a note on its purpose.
const CASES: &str = include_str!("../../data/jkr-sphere.tsv");

const fn text(name: &'static str) -> Column {
    Column { name, unit: "", is_number: false }
}

const fn number(name: &'static str, unit: &'static str) -> Column {
    Column { name, unit, is_number: true }
}

const COLUMNS: [Column; 16] = [
    text("id"),
    text("question"),
    text("control"),
    text("branch"),
    number("radius", "m"),
    number("e_star", "Pa"),
    number("work_of_adhesion", "J/m^2"),
    text("status"),
    number("contact_radius", "m"),
    number("indentation", "m"),
    number("force", "N"),
    number("tolerance", ""),
    number("maugis_contact_radius", ""),
    number("maugis_indentation", ""),
    number("maugis_force", ""),
    text("note"),
];

/// The rows, each from the records of one question.
pub(super) fn table() -> Table {
    Table {
        name: Table::NAMES[0],
        title: "JKR sphere f = r^2/(2R): folds and equilibria in SI units and in those of Maugis",
        columns: &COLUMNS,
        rows: CASES
            .lines()
            .skip(1)
            .filter_map(|line| line.split_once('\t').and_then(|(case, note)| row(case, note)))
            .collect(),
    }
}

/// The row of one question, from up to three records with the same inputs.
fn row(case: &str, note: &str) -> Option<Vec<Cell>> {
    let of_case = |record: &&Record| record.id.rsplit_once('/').is_some_and(|(id, _)| id == case);
    let given: Vec<&Record> = records().iter().filter(of_case).collect();
    let first = *given.first()?;
    let quantities = [("contact_radius", ""), ("indentation", "d"), ("force", "F")];
    // The value that is held is no record but an input.
    let value = |(quantity, input): (&str, &str)| match given.iter().find(|record| record.quantity == quantity) {
        Some(record) => Some(record.nearest()).filter(|value| value.is_finite()),
        None => first.input_f64(input),
    };
    let maugis = |asked: (&str, &str)| Some(twelve_digits(value(asked)? / maugis_unit(first, asked.0)?));
    let is_fold = first.formula == "critical";
    let flag = |name: &str| first.flags.iter().any(|flag| flag == name);
    let branch = match (is_fold || first.status == Status::NoEquilibrium, flag("outer")) {
        (true, _) => "",
        (false, true) => "stable",
        (false, false) => "unstable",
    };
    let tolerance = given.iter().filter(|record| record.value.is_some()).map(|record| record.tolerance());
    let own = |text: &str| Cell::Text(text.to_owned());
    Some(vec![
        own(case),
        own(if is_fold { "fold" } else { "equilibrium" }),
        own(first.control.as_deref()?),
        own(branch),
        Cell::Number(Some(radius(first)?)),
        Cell::Number(first.input_f64("E*")),
        Cell::Number(first.input_f64("w")),
        own(first.status.name()),
        Cell::Number(value(quantities[0])),
        Cell::Number(value(quantities[1])),
        Cell::Number(value(quantities[2])),
        Cell::Number(tolerance.reduce(f64::max).map(two_digits_up)),
        Cell::Number(maugis(quantities[0])),
        Cell::Number(maugis(quantities[1])),
        Cell::Number(maugis(quantities[2])),
        own(note),
    ])
}

/// R = 1/(2C), to 15 digits: those of the table are short decimals.
fn radius(record: &Record) -> Option<f64> {
    let c: Decimal = record.input("C")?.parse().ok()?;
    format!("{:.14e}", 0.5 / c.nearest()).parse().ok()
}

/// To twelve digits: the units of Maugis are computed in doubles.
fn twelve_digits(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// Rounded to two digits, away from zero.
fn two_digits_up(value: f64) -> f64 {
    let up = value * 1.05;
    format!("{up:.1e}").parse().unwrap_or(up)
}
