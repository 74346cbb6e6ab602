//! The answer for a reader and for a spreadsheet.

use std::borrow::Cow;

use mdr_core::contact::Status;

use super::answer::{Answer, Output as Solved, described};
use super::record::{Field, Record};
use crate::error::Result;
use crate::number::Number;
use crate::output::{Format, Output};
use crate::table::{Tone, cell, render, table};

/// Writes `answer` in the `format` asked for.
pub(crate) fn write(answer: &Answer, format: Format, out: &mut Output<impl std::io::Write>) -> Result<()> {
    match format {
        Format::Json => out.json(answer),
        Format::Csv => for_spreadsheet(answer, out),
        Format::Table => out.text(for_reader(answer)),
    }
}

/// A heading with its unit.
fn title(key: &str) -> &str {
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
        key => key,
    }
}

fn for_reader(answer: &Answer) -> String {
    let digits = match answer.digits {
        Some(1) => "1 digit".to_owned(),
        Some(digits) => format!("{digits} digits"),
        None => "f64".to_owned(),
    };
    let control = answer.control.map_or_else(String::new, |control| format!("; controlled: {control}"));
    let heading = format!("Profile: {}{control}; {digits}", answer.profile);
    let parts = answer.outputs.iter().map(output);
    let basis = answer.admissibility.map(|basis| format!("Admissible: {}.", described(basis)));
    let notes = answer.notes.iter().map(|note| format!("Note: {note}."));
    std::iter::once(heading).chain(notes).chain(parts).chain(basis).collect::<Vec<_>>().join("\n\n")
}

fn output(output: &Solved) -> String {
    let rows = flat(&output.records, |key, field| vec![(key.into(), text(field))]);
    let mut text = format!("{} ({})\n\n", output.want.name(), output.promise.name());
    let columns = columns(&rows);
    // Where the list is that of a range, its end is no end of the equilibria.
    let none = Status::NoEquilibrium.to_string();
    let limited =
        output.records.iter().any(|record| record.status() == Status::NoEquilibrium && record.why().is_some());
    if rows.is_empty() {
        text.push_str(" none\n");
    } else {
        let mut table = table(&columns.iter().map(|key| title(key)).collect::<Vec<_>>());
        for row in &rows {
            table.add_row(columns.iter().map(|key| match row.iter().find(|(name, _)| name == key) {
                Some((_, (text, tone))) if limited && *text == none => cell(format!("{text} within the range"), *tone),
                Some((_, (text, tone))) => cell(text, *tone),
                None => cell("", Tone::Plain),
            }));
        }
        text.push_str(&render(&table));
        text.push('\n');
    }
    let mut reasons = Vec::new();
    collect_reasons(&output.records, &mut reasons);
    for (status, why) in reasons.iter().take(SHOWN) {
        text.push_str(&format!("\n{status}: {why}.\n"));
    }
    if reasons.len() > SHOWN {
        text.push_str(&format!("\nand {} more reasons.\n", reasons.len() - SHOWN));
    }
    if let Some(balance) = &output.balance {
        text.push_str(&format!("\n{}\n", books(balance)));
    }
    if let Some((_, promise)) = output.exceptions.first() {
        let fields: Vec<&str> = output.exceptions.iter().map(|(field, _)| *field).collect();
        text.push_str(&format!("\nWith the promise {}: {}.\n", promise.name(), fields.join(", ")));
    }
    if let Some(complete) = &output.complete {
        let range = match (&complete.from, &complete.to) {
            (Some(from), Some(to)) => format!(" for contact radii from {from} to {to} m"),
            (Some(_), None) => " for all contact radii".to_owned(),
            _ => String::new(),
        };
        text.push('\n');
        let proved = if complete.proved { "Proved complete" } else { "Not proved complete" };
        text.push_str(&format!("{proved}{range}: {}.", complete.why));
    }
    text.trim_end().to_owned()
}

/// Reasons that are told of one output.
const SHOWN: usize = 5;

/// Why something is not ok, each reason once; that of a list without equilibria stands in its row.
fn collect_reasons(records: &[Record<Number>], reasons: &mut Vec<(Status, String)>) {
    for record in records {
        let status = record.status();
        if let Some(why) = record.why().filter(|_| status != Status::NoEquilibrium)
            && !reasons.contains(&(status, why.clone()))
        {
            reasons.push((status, why));
        }
        for (_, field) in record.fields() {
            if let Field::Records(records) = field {
                collect_reasons(records, reasons);
            }
        }
    }
}

/// The energy of a path in a sentence.
fn books(balance: &Record<Number>) -> String {
    let part = |(key, field): &(&'static str, Field<Number>)| {
        let energy = match field {
            Field::Marked { log10: None, status, why } => {
                why.as_ref().map_or_else(|| status.to_string(), |why| format!("{status} ({why})"))
            }
            field => format!("{} J", text(field).0),
        };
        match *key {
            "work" => format!("work of the control {energy}"),
            "dissipated" => format!("dissipated {energy}"),
            key => format!("{key} {energy} more than at the start"),
        }
    };
    format!("Energy: {}.", balance.fields().iter().map(part).collect::<Vec<_>>().join(", "))
}

/// A row: its columns with their texts.
type Row = Vec<(Cow<'static, str>, (String, Tone))>;

/// One row for each innermost record, with the fields of the records around it.
fn flat(records: &[Record<Number>], write: fn(&'static str, &Field<Number>) -> Row) -> Vec<Row> {
    let mut rows = Vec::new();
    for record in records {
        let mut own: Row = Vec::new();
        let mut inner = Vec::new();
        let mut nested = false;
        for (key, field) in record.fields() {
            match field {
                Field::Records(records) => {
                    nested = true;
                    inner.extend(flat(records, write));
                }
                field => own.extend(write(key, field)),
            }
        }
        let status = record.status();
        let tone = if status == Status::Ok { Tone::Faint } else { Tone::Bad };
        if inner.is_empty() {
            own.push(("status".into(), (status.to_string(), tone)));
            rows.push(own);
            continue;
        }
        for row in inner {
            let mut row: Row = own.iter().cloned().chain(row).collect();
            // The status of a state counts where that of its point is ok.
            if nested
                && status != Status::Ok
                && let Some((_, (text, old))) = row.iter_mut().find(|(key, _)| *key == "status")
                && text == "ok"
            {
                (*text, *old) = (status.to_string(), tone);
            }
            rows.push(row);
        }
    }
    rows
}

fn text(field: &Field<Number>) -> (String, Tone) {
    match field {
        Field::Number(number) => (number.to_string(), Tone::Good),
        Field::Given(literal) => (literal.to_string(), Tone::Plain),
        Field::Marked { log10: Some(log10), .. } if log10.is_finite() => (format!("about 10^{log10:.6}"), Tone::Bad),
        Field::Marked { .. } | Field::Absent | Field::Records(_) => (String::new(), Tone::Faint),
        Field::Word(word) => ((*word).to_owned(), Tone::Plain),
        Field::Flag(true) => ("yes".to_owned(), Tone::Plain),
        Field::Flag(false) => ("no".to_owned(), Tone::Plain),
    }
}

/// A field in a spreadsheet: a column of numbers has numbers only, and log10 of what is none has a column of its own.
fn columns_of(key: &'static str, field: &Field<Number>) -> Row {
    match field {
        Field::Marked { log10: Some(log10), .. } if log10.is_finite() => vec![
            (key.into(), (String::new(), Tone::Bad)),
            (format!("log10_{key}").into(), (log10.to_string(), Tone::Bad)),
        ],
        field => vec![(key.into(), text(field))],
    }
}

/// The keys of all rows, in the order in which they first appear; the status last.
fn columns(rows: &[Row]) -> Vec<Cow<'static, str>> {
    let mut columns = Vec::new();
    for (key, _) in rows.iter().flatten() {
        if *key != "status" && !columns.contains(key) {
            columns.push(key.clone());
        }
    }
    columns.push("status".into());
    columns
}

/// One table for all outputs: the first columns say which output, and its promise.
fn for_spreadsheet(answer: &Answer, out: &mut Output<impl std::io::Write>) -> Result<()> {
    let tables: Vec<_> = answer.outputs.iter().map(|output| (output, flat(&output.records, columns_of))).collect();
    let all: Vec<Row> = tables.iter().flat_map(|(_, rows)| rows.iter().cloned()).collect();
    let keys = columns(&all);
    let header: Vec<&str> = ["output", "promise"].into_iter().chain(keys.iter().map(AsRef::as_ref)).collect();
    let rows = tables.iter().flat_map(|(output, rows)| {
        rows.iter().map(|row| {
            let value = |key: &Cow<'static, str>| {
                row.iter().find(|(name, _)| name == key).map(|(_, (text, _))| text.clone()).unwrap_or_default()
            };
            let first = [output.want.name().to_owned(), output.promise.name().to_owned()];
            first.into_iter().chain(keys.iter().map(value)).collect::<Vec<_>>()
        })
    });
    out.csv(&header, rows)
}
