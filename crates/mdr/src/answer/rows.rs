//! An output as a table: one flat row for each innermost record, with the cells of the records around it.

use std::borrow::Cow;
use std::fmt;

use mdr_core::contact::Status;

use super::{Cell, Output, Row, Value};

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
    /// The flat rows of the output; the last cell of each row is its status.
    pub fn table(&self) -> Vec<FlatRow> {
        flat(&self.rows())
    }
}

impl crate::Validity {
    /// The flat row of the validity; its last cell is the status.
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
    /// The reasons why numbers are not decided, each once with its status; the reason of a value without equilibria stands in its
    /// row.
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

/// The cell below a key.
pub fn find<'r>(row: &'r FlatRow, key: &str) -> Option<&'r FlatCell> {
    row.iter().find(|(name, _)| name == key).map(|(_, cell)| cell)
}
