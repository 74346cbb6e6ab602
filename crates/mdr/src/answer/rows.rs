//! An output as a table: one flat row for each innermost record, with the cells of the records around it.

use std::borrow::Cow;
use std::fmt;

use mdr_core::contact::Status;

use super::{Answer, Balance, Cell, CurveSummary, Output, Row, Value};

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum FlatCell {
    /// A result.
    Number(String),
    /// An input, a word, or yes or no.
    Text(String),
    /// log₁₀ of a number that is out of range.
    Magnitude(f64),
    /// The status of the row.
    Status(Status),
    /// Nothing.
    Empty,
}

/// The cells of a row with their keys.
pub type FlatRow = Vec<(Cow<'static, str>, FlatCell)>;

impl fmt::Display for FlatCell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FlatCell::Number(text) | FlatCell::Text(text) => f.write_str(text),
            FlatCell::Magnitude(log10) => write!(f, "about 10^{log10:.6}"),
            FlatCell::Status(status) => status.fmt(f),
            FlatCell::Empty => Ok(()),
        }
    }
}

impl FlatCell {
    fn of(cell: &Cell<'_>) -> Self {
        match cell {
            Cell::Value(Value::Known(number)) => FlatCell::Number(number.to_string()),
            Cell::Value(Value::Given(literal)) => FlatCell::Text(literal.to_string()),
            Cell::Literal(literal) => FlatCell::Text(literal.to_string()),
            Cell::Value(_) | Cell::UnknownStability(_) => {
                cell.log10().filter(|log10| log10.is_finite()).map_or(FlatCell::Empty, FlatCell::Magnitude)
            }
            Cell::Flag(flag) => FlatCell::Text(if *flag { "yes" } else { "no" }.to_owned()),
            Cell::Count(count) => FlatCell::Text(count.to_string()),
            Cell::Word(word) => FlatCell::Text((*word).to_owned()),
            Cell::Absent | Cell::Rows(_) => FlatCell::Empty,
        }
    }
}

impl<N> Cell<'_, N> {
    /// log₁₀ of the magnitude of a number that is out of range.
    pub fn log10(&self) -> Option<f64> {
        match self {
            Cell::Value(value) => value.log10(),
            Cell::UnknownStability(value) => value.log10(),
            _ => None,
        }
    }
}

impl Output {
    /// Its flat rows; the last cell of each is its status.
    pub fn table(&self) -> Vec<FlatRow> {
        flat(&self.rows())
    }
}

impl crate::Validity {
    /// Its flat row; the last cell is its status.
    pub fn table(&self) -> FlatRow {
        flat(&[self.row()]).remove(0)
    }
}

fn flat(rows: &[Row<'_>]) -> Vec<FlatRow> {
    let mut table = Vec::new();
    for row in rows {
        let status = row.status();
        let mut own: FlatRow = Vec::new();
        let mut inner = Vec::new();
        for (key, cell) in &row.cells {
            match cell {
                Cell::Rows(rows) => inner.extend(flat(rows)),
                cell => own.push(((*key).into(), FlatCell::of(cell))),
            }
        }
        if inner.is_empty() {
            own.push(("status".into(), FlatCell::Status(status)));
            table.push(own);
            continue;
        }
        for below in inner {
            let mut whole: FlatRow = own.iter().cloned().chain(below).collect();
            // The status of a state counts where that of its point is ok.
            if let Some((_, FlatCell::Status(old @ Status::Ok))) = whole.iter_mut().find(|(key, _)| key == "status") {
                *old = status;
            }
            table.push(whole);
        }
    }
    table
}

/// The keys of all rows, in the order in which they first appear; the status last.
pub fn columns<'a>(rows: impl IntoIterator<Item = &'a FlatRow>) -> Vec<Cow<'static, str>> {
    let mut columns = Vec::new();
    for (key, _) in rows.into_iter().flatten() {
        if key != "status" && !columns.contains(key) {
            columns.push(key.clone());
        }
    }
    columns.push("status".into());
    columns
}

impl Output {
    /// Why numbers are not known, each reason once with its status; that of a value without equilibria stands in its row.
    pub fn reasons(&self) -> Vec<(Status, String)> {
        let mut reasons = Vec::new();
        collect_reasons(&self.rows(), &mut reasons);
        reasons
    }
}

fn collect_reasons(rows: &[Row<'_>], reasons: &mut Vec<(Status, String)>) {
    for row in rows {
        let status = row.status();
        if let Some(why) = row.why().filter(|_| status != Status::NoEquilibrium)
            && !reasons.contains(&(status, why.clone()))
        {
            reasons.push((status, why));
        }
        for (_, cell) in &row.cells {
            if let Cell::Rows(rows) = cell {
                collect_reasons(rows, reasons);
            }
        }
    }
}

impl Answer {
    /// One table for all outputs, the titles first: the first two columns say which output, and its promise. A column of
    /// numbers has numbers only, and log₁₀ of what is out of range has a column of its own.
    pub fn spreadsheet(&self) -> Vec<Vec<String>> {
        let separated = |row: FlatRow| -> FlatRow {
            row.into_iter()
                .flat_map(|(key, cell)| match cell {
                    FlatCell::Magnitude(log10) => {
                        let magnitude = (format!("log10_{key}").into(), FlatCell::Number(log10.to_string()));
                        vec![(key, FlatCell::Empty), magnitude]
                    }
                    cell => vec![(key, cell)],
                })
                .collect()
        };
        let rows = self.outputs.iter().flat_map(|output| {
            let names = [output.kind().name(), output.promise().name()];
            output.table().into_iter().map(move |row| (names, separated(row)))
        });
        let validity = self
            .validity
            .iter()
            .map(|validity| (["validity", self.validity_promise().name()], separated(validity.table())));
        let rows: Vec<([&str; 2], FlatRow)> = rows.chain(validity).collect();
        let keys = columns(rows.iter().map(|(_, row)| row));
        let header = ["output", "promise"].into_iter().chain(keys.iter().map(AsRef::as_ref));
        let rows = rows.iter().map(|(names, row)| {
            let value =
                |key| row.iter().find(|(name, _)| name == key).map_or_else(String::new, |(_, cell)| cell.to_string());
            names.iter().map(|name| (*name).to_owned()).chain(keys.iter().map(value)).collect()
        });
        std::iter::once(header.map(str::to_owned).collect()).chain(rows).collect()
    }
}

/// The heading of a column, with its unit.
pub fn title(key: &str) -> &str {
    match key {
        "contact_radius" => "contact radius, m",
        "to_contact_radius" => "to radius, m",
        "indentation" => "indentation, m",
        "force" => "force, N",
        "to_indentation" => "to indentation, m",
        "position" => "position, m",
        "to_force" => "to force, N",
        "dissipated" => "dissipated, J",
        "energy" => "energy, J",
        "stiffness" => "stiffness, N/m",
        "pressure" => "pressure, Pa",
        "gap" => "gap, m",
        "displacement" => "displacement, m",
        "g" => "g, m",
        "integral" => "integral, m²",
        "x" => "x, m",
        "r" => "r, m",
        "range_of_adhesion" => "range of adhesion, m",
        "tabor" => "Tabor number",
        "jkr_pull_off" => "JKR pull-off force, N",
        "maugis_dugdale_pull_off" => "Maugis-Dugdale pull-off force, N",
        "correction" => "Maugis-Dugdale / JKR - 1",
        "maugis_dugdale_contact_radius" => "Maugis-Dugdale contact radius, m",
        "maugis_dugdale_outer_radius" => "radius of the attraction, m",
        "maugis_dugdale_indentation" => "Maugis-Dugdale indentation, m",
        "a_over_r" => "a/R",
        key => key,
    }
}

/// The energy of a path in a sentence.
impl fmt::Display for Balance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |value: &Value| match value {
            Value::Unknown { log10: Some(log10), .. } => format!("about 10^{log10:.6} J"),
            Value::Unknown { status, why: Some(why), .. } => format!("{status} ({why})"),
            Value::Unknown { status, .. } => status.to_string(),
            value => format!("{value} J"),
        };
        let [work, dissipated, stored] = [&self.work, &self.dissipated, &self.stored].map(part);
        write!(
            f,
            "Energy: work of the control {work}, dissipated {dissipated}, stored {stored} more than at the start."
        )
    }
}

/// What is read off a force curve, in a sentence.
impl fmt::Display for CurveSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = |(name, value, unit): (&str, &Option<Value>, &str)| match value {
            Some(value) => format!("{name} {value} {unit}"),
            None => format!("no {name}"),
        };
        let parts = [
            ("pull-off force", &self.pull_off_force, "N"),
            ("force after jump-in", &self.jump_in_force, "N"),
            ("minimum force", &self.minimum_force, "N"),
            ("hysteresis", &self.hysteresis, "J"),
        ];
        write!(f, "Summary: {}.", parts.map(part).join(", "))
    }
}
