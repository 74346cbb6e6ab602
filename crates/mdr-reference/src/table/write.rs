//! A table as a file of another language.

use crate::catalogue::records;
use crate::json::quoted;
use crate::table::{Cell, Column, Table};

/// The shape of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableFormat {
    /// Comma-separated, with units in the header below a line of comment.
    Csv,
    /// One JSON object with the rows as objects, null where there is no number; schema `mdr.table/1`.
    Json,
    /// A header of C and C++ with a constant array of structures, NAN where there is no number.
    C,
    /// A module of Python with a list of dictionaries; a missing number is `None`.
    Python,
    /// A module of Fortran 2008 with a constant array for each column, NaN where there is no number.
    Fortran,
    /// A module of Julia with a vector of named tuples, NaN where there is no number.
    Julia,
}

impl TableFormat {
    /// All of them, with the extension of their files.
    pub const ALL: [(TableFormat, &'static str); 6] = [
        (TableFormat::Csv, "csv"),
        (TableFormat::Json, "json"),
        (TableFormat::C, "h"),
        (TableFormat::Python, "py"),
        (TableFormat::Fortran, "f90"),
        (TableFormat::Julia, "jl"),
    ];
}

/// The terms of use.
const LICENCE: &str = "CC0-1.0";

impl Table {
    /// The file of this format, with its last end of line.
    pub fn write(&self, format: TableFormat) -> String {
        match format {
            TableFormat::Csv => self.csv(),
            TableFormat::Json => self.json(),
            TableFormat::C => self.c(),
            TableFormat::Python => self.python(),
            TableFormat::Fortran => self.fortran(),
            TableFormat::Julia => self.julia(),
        }
    }

    /// How to cite the table, and its licence.
    fn citation(&self) -> String {
        let release = records().iter().map(|record| record.release).max().unwrap_or_default();
        format!(
            "{}. The mdr developers, mdr: certified reference values of adhesive contact mechanics, release {release}, \
             table {}. {LICENCE}: to be copied without conditions.",
            self.title, self.name
        )
    }

    fn csv(&self) -> String {
        let header = self.columns.iter().map(|Column { name, unit, .. }| match *unit {
            "" => (*name).to_owned(),
            unit => format!("{name} ({unit})"),
        });
        let line = |cells: Vec<String>| cells.iter().map(|text| csv_quoted(text)).collect::<Vec<_>>().join(",") + "\n";
        let rows = self.rows().map(line);
        format!("# {}\n{}{}", self.citation(), line(header.collect()), rows.collect::<String>())
    }

    fn json(&self) -> String {
        let units = self.columns.iter().filter(|column| !column.unit.is_empty());
        let units: Vec<_> = units.map(|column| format!("{}:{}", quoted(column.name), quoted(column.unit))).collect();
        format!(
            "{{\"schema\":\"mdr.table/1\",\"table\":\"{}\",\"licence\":\"{LICENCE}\",\"citation\":{},\"units\":{{{}}},\
             \"rows\":[\n{}\n]}}\n",
            self.name,
            quoted(&self.citation()),
            units.join(","),
            self.objects("null", ":").join(",\n")
        )
    }

    fn python(&self) -> String {
        let rows: Vec<_> = self.objects("None", ": ").iter().map(|row| format!("    {row},\n")).collect();
        format!("# {}\n{} = [\n{}]\n", self.citation(), self.constant(), rows.concat())
    }

    /// The rows as objects of JSON and Python.
    fn objects(&self, none: &str, colon: &str) -> Vec<String> {
        let field = |(column, cell): (&Column, &Cell)| format!("{}{colon}{}", quoted(column.name), cell.literal(none));
        let separator = if colon == ":" { "," } else { ", " };
        let row = |row: &Vec<Cell>| {
            let fields: Vec<_> = self.columns.iter().zip(row).map(field).collect();
            format!("{{{}}}", fields.join(separator))
        };
        self.rows.iter().map(row).collect()
    }

    fn c(&self) -> String {
        let (name, constant) = (format!("mdr_{}", self.name.replace('-', "_")), self.constant());
        let fields = self.columns.iter().map(|Column { name, unit, is_number }| {
            let kind = if *is_number { "double " } else { "const char *" };
            let comment = if unit.is_empty() { String::new() } else { format!(" /* {unit} */") };
            format!("    {kind}{name};{comment}\n")
        });
        let rows = self.rows.iter().map(|row| {
            let cells: Vec<_> = row.iter().map(|cell| cell.literal("NAN")).collect();
            format!("    {{{}}},\n", cells.join(", "))
        });
        format!(
            "/* {} */\n#ifndef MDR_{constant}_H\n#define MDR_{constant}_H\n\n#include <math.h>\n\nstruct {name} {{\n{}}};\n\n\
             static const struct {name} {name}_rows[] = {{\n{}}};\n\n#define MDR_{constant}_ROWS {}\n\n#endif\n",
            self.citation(),
            fields.collect::<String>(),
            rows.collect::<String>(),
            self.rows.len()
        )
    }

    fn fortran(&self) -> String {
        let (name, rows) = (self.name.replace('-', "_"), self.rows.len());
        let column = |(place, Column { name, unit, is_number }): (usize, &Column)| {
            let cells = self.rows.iter().map(|row| &row[place]);
            let texts = || cells.clone().map(Cell::text);
            let (kind, values): (String, Vec<String>) = if *is_number {
                let literal = |cell: &Cell| match cell {
                    Cell::Number(Some(_)) => real(&cell.text()),
                    _ => "nan".to_owned(),
                };
                ("real(real64)".to_owned(), cells.clone().map(literal).collect())
            } else {
                let width = texts().map(|text| text.len()).max().unwrap_or(0).max(1);
                let padded = |text: String| format!("'{:width$}'", text.replace('\'', "\'\'"));
                (format!("character(len={width})"), texts().map(padded).collect())
            };
            let comment = if unit.is_empty() { String::new() } else { format!(" ! {unit}") };
            format!("  {kind}, parameter, public :: {name}(rows) = [ &{comment}\n    {}]\n", values.join(", &\n    "))
        };
        format!(
            "{}module mdr_{name}\n  use, intrinsic :: iso_fortran_env, only: int64, real64\n  implicit none\n  private\n\n  integer, \
             parameter, public :: rows = {rows}\n  ! NaN, where there is no number: x /= x\n  real(real64), parameter :: nan = &\n    \
             transfer(9221120237041090560_int64, 1.0_real64)\n{}end module mdr_{name}\n",
            comments(&self.citation(), "!"),
            self.columns.iter().enumerate().map(column).collect::<String>()
        )
    }

    fn julia(&self) -> String {
        let field = |(column, cell): (&Column, &Cell)| format!("{} = {}", column.name, dollars(&cell.literal("NaN")));
        let row = |row: &Vec<Cell>| {
            let fields: Vec<_> = self.columns.iter().zip(row).map(field).collect();
            format!("    ({}),\n", fields.join(", "))
        };
        let rows: String = self.rows.iter().map(row).collect();
        format!("{}const {} = [\n{rows}]\n", comments(&self.citation(), "#"), self.constant())
    }

    /// The name in capitals, with underscores.
    fn constant(&self) -> String {
        self.name.replace('-', "_").to_uppercase()
    }
}

impl Cell {
    /// As C, JSON and Python write it.
    fn literal(&self, none: &str) -> String {
        match self {
            Cell::Text(text) => quoted(text),
            Cell::Number(None) => none.to_owned(),
            Cell::Number(Some(_)) => self.text(),
        }
    }
}

/// A number of double precision in Fortran.
fn real(text: &str) -> String {
    format!("{text}_real64")
}

/// A text of Julia, in which a dollar sign would begin a value.
fn dollars(text: &str) -> String {
    text.replace('$', "\\$")
}

/// A text as lines of comment of at most 120 characters.
fn comments(text: &str, mark: &str) -> String {
    let mut lines = vec![mark.to_owned()];
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + word.len() < 120 => line.extend([" ", word]),
            _ => lines.push(format!("{mark} {word}")),
        }
    }
    lines.join("\n") + "\n"
}

/// A cell of CSV, in quotation marks where it needs them.
fn csv_quoted(text: &str) -> String {
    if text.contains(['"', ',', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
