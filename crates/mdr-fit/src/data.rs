//! Rows of a measured curve: columns by name, units, legs.

use csv::StringRecord;
use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::{SiUnit, bare, scaled};
use mdr_numeric::table::{self, Line};

use super::observation::Leg;
use super::problem::DataRow;
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
    let row = |((x, y), leg): ((&f64, &f64), &Leg)| DataRow { x: *x, y: *y, leg: *leg, sigma: [None; 2] };
    Ok(x.iter().zip(y).zip(legs).map(row).collect())
}

/// A record turns where X has its extremum: it falls before and after a smallest X inside it, and rises before and falls after
/// a largest one.
pub(super) fn legs_by_order(x: &[f64]) -> Vec<Leg> {
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
    /// Units that are stated beside the file.
    pub(super) units: Option<[String; 2]>,
}

/// Reads the rows of a CSV file: a header, a row of units, numbers. Lines that begin with # are comments; the separator is a
/// comma, a semicolon or a tab.
pub(super) fn read(text: &str, columns: &Columns, bases: [&str; 2]) -> std::result::Result<Vec<DataRow>, String> {
    let records = records(text)?;
    let mut lines = records.iter().peekable();
    let header = lines.next_if(|line| is_words(&line.fields) && !is_units(&line.fields)).map(|line| &line.fields);
    let units = lines.next_if(|line| is_words(&line.fields) && is_units(&line.fields)).map(|line| &line.fields);
    let place = |name: &Option<String>, otherwise: usize| match name {
        None => Ok(otherwise),
        Some(name) => column(header, name),
    };
    let places = [place(&columns.x, 0)?, place(&columns.y, 1)?];
    let optional = |name: &Option<String>| name.as_ref().map(|name| column(header, name)).transpose();
    let (leg, sigma) = (optional(&columns.leg)?, [optional(&columns.sigma[0])?, optional(&columns.sigma[1])?]);
    let unit = |axis: usize, place: usize| -> std::result::Result<String, String> {
        let stated = columns.units.as_ref().map(|units| units[axis].as_str());
        let unit = stated.or_else(|| units.and_then(|units| units.get(place)));
        let Some(unit) = unit.filter(|unit| !unit.is_empty()) else {
            return Err(format!(
                "no units: the row after the header must name them, such as `{}`, or `units` in [data]",
                bases.join(",")
            ));
        };
        match si("1", unit, bases[axis]) {
            Some(_) => Ok(unit.to_owned()),
            None => Err(format!(
                "`{}` is no unit of {}",
                excerpt(unit),
                if bases[axis] == "N" { "force" } else { "length" }
            )),
        }
    };
    let named = [unit(0, places[0])?, unit(1, places[1])?];
    let of_sigma =
        [0, 1].map(|axis| sigma[axis].and_then(|place| unit(axis, place).ok()).unwrap_or(named[axis].clone()));
    let mut rows = Vec::with_capacity(records.len());
    let mut legs = Vec::new();
    for Line { number: line, fields: record } in lines {
        let number = |place: usize, unit: &str, axis: usize| {
            let text = record.get(place).ok_or_else(|| format!("line {line}: there is no column {}", place + 1))?;
            si(text, unit, bases[axis]).filter(|value| value.is_finite()).ok_or_else(|| {
                let name = header.and_then(|header| header.get(place)).unwrap_or(["x", "y"][axis]);
                format!("line {line}: `{}` in the column `{}` is not a number", excerpt(text), excerpt(name))
            })
        };
        let own = |axis: usize| sigma[axis].map(|place| number(place, &of_sigma[axis], axis)).transpose();
        legs.push(
            leg.map(|place| {
                let name = record.get(place).unwrap_or("");
                leg_of(name)
                    .ok_or_else(|| format!("line {line}: a leg is `approach` or `retract`, got `{}`", excerpt(name)))
            })
            .transpose()?,
        );
        let (x, y) = (number(places[0], &named[0], 0)?, number(places[1], &named[1], 1)?);
        rows.push(DataRow { x, y, leg: Leg::Retract, sigma: [own(0)?, own(1)?] });
    }
    let by_order = legs_by_order(&rows.iter().map(|row| row.x).collect::<Vec<_>>());
    for ((row, given), found) in rows.iter_mut().zip(legs).zip(by_order) {
        row.leg = given.unwrap_or(found);
        if let Some(sigma) = row.sigma.iter().flatten().find(|sigma| **sigma <= 0.0) {
            return Err(format!("a standard deviation must be positive, got {sigma}"));
        }
    }
    Ok(rows)
}

/// A leg by its name.
pub(super) fn leg_of(name: &str) -> Option<Leg> {
    Leg::ALL.into_iter().find(|leg| leg.name() == name)
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
    number.parse::<Literal>().ok()?;
    scaled(number, power).parse().ok().map(|literal: Literal| literal.nearest_f64())
}

/// The rows of a file, with the numbers of their lines.
fn records(text: &str) -> std::result::Result<Vec<Line>, String> {
    let mut rows = table::separated(text.as_bytes()).map_err(|error| error.to_string())?;
    let mut records = Vec::new();
    while let Some(row) = rows.next() {
        // A header and units are no rows.
        let words = records.iter().take(2).take_while(|line: &&Line| is_words(&line.fields)).count();
        if records.len() - words == MOST_ROWS {
            let given = MOST_ROWS + 1 + rows.count();
            return Err(format!("{given} rows; at most {MOST_ROWS} are read: {FEWER_ROWS}"));
        }
        records.push(row.map_err(|error| error.to_string())?);
    }
    Ok(records)
}

/// Whether no field is a number, as in a header.
fn is_words(record: &StringRecord) -> bool {
    record.iter().all(|field| field.parse::<f64>().map_or(true, f64::is_nan) || field.is_empty())
}

/// Whether some field is a unit and no field is a longer word than a unit can be.
fn is_units(record: &StringRecord) -> bool {
    record.iter().any(|field| si("1", field, "m").or_else(|| si("1", field, "N")).is_some())
}

fn column(header: Option<&StringRecord>, name: &str) -> std::result::Result<usize, String> {
    let Some(header) = header else {
        return Err(format!("there is no header that names the column `{}`", excerpt(name)));
    };
    header.iter().position(|field| field == name).ok_or_else(|| {
        let known: Vec<&str> = header.iter().collect();
        mdr::reading::unknown_name_of_input("column", name, &known)
    })
}
