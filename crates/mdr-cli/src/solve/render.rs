//! The answer for a reader and for a spreadsheet.

use std::path::Path;

use mdr::answer::{Balance, CurveSummary, FlatCell, FlatRow, Notation, Reader, columns, described, title};
use mdr::prelude::*;

use crate::error::{Failure, Result};
use crate::output::{Format, Output as Out};
use crate::table::{Tone, cell, render_whole, table};

/// Writes `answer` in the `format` asked for.
pub(crate) fn write(
    answer: &Answer,
    format: Format,
    reader: &Reader,
    out: &mut Out<impl std::io::Write>,
) -> Result<()> {
    match format {
        Format::Json => out.json(answer),
        Format::Csv => for_spreadsheet(answer, out),
        Format::Table => out.text(for_reader(answer, reader)),
    }
}

fn for_reader(answer: &Answer, reader: &Reader) -> String {
    let digits = match answer.arithmetic {
        Arithmetic::Certified { digits: 1 } => "1 digit".to_owned(),
        Arithmetic::Certified { digits } => format!("{digits} digits"),
        Arithmetic::Double => "f64".to_owned(),
    };
    let control = answer.control.map_or_else(String::new, |control| format!("; controlled: {}", control.name()));
    let heading = format!("Profile: {}{control}; {digits}", answer.profile);
    let parts = answer.outputs.iter().map(|part| output(part, answer.control, reader));
    let basis = answer.admissibility.map(|basis| format!("Admissible: {}.", described(basis)));
    let notes = answer.notes.iter().map(|note| format!("Note: {note}."));
    std::iter::once(heading).chain(notes).chain(parts).chain(basis).collect::<Vec<_>>().join("\n\n")
}

fn output(output: &Output, control: Option<ControlKind>, reader: &Reader) -> String {
    let rows = output.table();
    let mut text = format!("{} ({})\n\n", output.kind().name(), output.promise().name());
    if rows.is_empty() {
        text.push_str(" none\n");
    } else {
        text.push_str(&table_of(output, &rows, control, reader));
        text.push('\n');
    }
    let reasons = output.reasons();
    for (status, why) in reasons.iter().take(SHOWN) {
        text.push_str(&format!("\n{status}: {why}.\n"));
    }
    if reasons.len() > SHOWN {
        text.push_str(&format!("\nand {} more reasons.\n", reasons.len() - SHOWN));
    }
    if let Some(balance) = output.balance() {
        text.push_str(&format!("\n{}\n", energy(balance, reader)));
    }
    if let Output::ForceCurve(curve) = output {
        text.push_str(&format!("\n{}\n", summary(&curve.summary, reader)));
    }
    let exceptions = output.exceptions();
    if let Some((_, promise)) = exceptions.first() {
        let fields: Vec<&str> = exceptions.iter().map(|(field, _)| *field).collect();
        text.push_str(&format!("\nWith the promise {}: {}.\n", promise.name(), fields.join(", ")));
    }
    if let Some(complete) = output.complete() {
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

/// Reasons that are shown of one output.
const SHOWN: usize = 5;

/// log10 of what is out of range has a column of its own in a spreadsheet.
const LOG10: &str = "log10_";

/// The title of a column and its unit; values of the controlled quantity have that of the control.
fn titled(key: &str, control: Option<ControlKind>) -> (&str, &'static str) {
    match (key, control) {
        ("value", Some(ControlKind::Force)) => (key, "N"),
        ("value", Some(_)) => (key, "m"),
        _ => title(key),
    }
}

fn table_of(output: &Output, rows: &[FlatRow], control: Option<ControlKind>, reader: &Reader) -> String {
    let keys = columns(rows);
    let unit = |key| titled(key, control).1;
    let titles = keys.iter().map(|key| titled(key, control)).map(|(name, unit)| reader.titled(name, unit));
    let mut table = table(&titles.collect::<Vec<_>>());
    // Where the list is that of a range, its end is no end of the equilibria.
    let limited = output.rows().iter().any(|row| row.status() == Status::NoEquilibrium && row.why().is_some());
    let typed = Reader { notation: Notation::Plain, ..reader.clone() };
    for row in rows {
        table.add_row(keys.iter().map(|key| match value(row, key) {
            Some(FlatCell::Status(Status::NoEquilibrium)) if limited => {
                cell(format!("{} within the range", Status::NoEquilibrium), Tone::Bad)
            }
            Some(FlatCell::Magnitude(log10)) => {
                cell(format!("about 10^{:.6}", reader.magnitude(*log10, unit(key))), Tone::Bad)
            }
            Some(FlatCell::Number(text)) => cell(reader.number(text, unit(key)), Tone::Good),
            // What was typed keeps its notation.
            Some(FlatCell::Text(text)) => cell(typed.number(text, unit(key)), Tone::Plain),
            Some(found) => cell(text_of(found), tone(found)),
            None => cell("", Tone::Plain),
        }));
    }
    render_whole(&table)
}

fn value<'a>(row: &'a FlatRow, key: &str) -> Option<&'a FlatCell> {
    row.iter().find(|(name, _)| name == key).map(|(_, cell)| cell)
}

fn text_of(cell: &FlatCell) -> String {
    match cell {
        FlatCell::Number(text) | FlatCell::Text(text) => text.clone(),
        FlatCell::Magnitude(log10) => format!("about 10^{log10:.6}"),
        FlatCell::Status(status) => status.to_string(),
        FlatCell::Empty => String::new(),
    }
}

fn tone(cell: &FlatCell) -> Tone {
    match cell {
        FlatCell::Number(_) => Tone::Good,
        FlatCell::Text(_) => Tone::Plain,
        FlatCell::Status(Status::Ok) | FlatCell::Empty => Tone::Faint,
        FlatCell::Magnitude(_) | FlatCell::Status(_) => Tone::Bad,
    }
}

/// The energy of a path in a sentence.
fn energy(balance: &Balance, reader: &Reader) -> String {
    let part = |value: &Value| match value {
        Value::Unknown { log10: Some(log10), .. } => format!("about 10^{log10:.6} J"),
        Value::Unknown { status, why, .. } => {
            why.as_ref().map_or_else(|| status.to_string(), |why| format!("{status} ({why})"))
        }
        value => reader.quantity(&value.to_string(), "J"),
    };
    let [work, dissipated, stored] = [&balance.work, &balance.dissipated, &balance.stored].map(part);
    format!("Energy: work of the control {work}, dissipated {dissipated}, stored {stored} more than at the start.")
}

/// What is read off a force curve, in a sentence.
fn summary(summary: &CurveSummary, reader: &Reader) -> String {
    let part = |(name, value, unit): (&str, &Option<Value>, &str)| match value {
        Some(value) => format!("{name} {}", reader.quantity(&value.to_string(), unit)),
        None => format!("no {name}"),
    };
    let parts = [
        ("pull-off force", &summary.pull_off_force, "N"),
        ("force after jump-in", &summary.jump_in_force, "N"),
        ("minimum force", &summary.minimum_force, "N"),
        ("hysteresis", &summary.hysteresis, "J"),
    ];
    format!("Summary: {}.", parts.map(part).join(", "))
}

/// One table for all outputs: the first columns say which output, and its promise. A column of numbers has numbers only, and
/// log10 of what is out of range has a column of its own.
fn for_spreadsheet(answer: &Answer, out: &mut Out<impl std::io::Write>) -> Result<()> {
    let tables: Vec<(&Output, Vec<FlatRow>)> =
        answer.outputs.iter().map(|output| (output, separated(output, |log10, _| log10))).collect();
    let keys = columns(tables.iter().flat_map(|(_, rows)| rows));
    let header: Vec<&str> = ["output", "promise"].into_iter().chain(keys.iter().map(AsRef::as_ref)).collect();
    let rows = tables.iter().flat_map(|(output, rows)| {
        rows.iter().map(|row| {
            let first = [output.kind().name().to_owned(), output.promise().name().to_owned()];
            first
                .into_iter()
                .chain(keys.iter().map(|key| value(row, key).map(text_of).unwrap_or_default()))
                .collect::<Vec<_>>()
        })
    });
    out.csv(&header, rows)
}

/// The rows of an output with log10 of what is out of range in columns of its own.
fn separated(output: &Output, magnitude: impl Fn(f64, &str) -> f64) -> Vec<FlatRow> {
    let cells = |row: FlatRow| {
        row.into_iter().flat_map(|(key, cell)| match cell {
            FlatCell::Magnitude(log10) => {
                let log10 = magnitude(log10, &key).to_string();
                let magnitude = (format!("{LOG10}{key}").into(), FlatCell::Number(log10));
                vec![(key, FlatCell::Empty), magnitude]
            }
            cell => vec![(key, cell)],
        })
    };
    output.table().into_iter().map(|row| cells(row).collect()).collect()
}

/// One file an output in `folder`: the inputs of the scene, a column each, then its columns with their units. The files are
/// listed on `out`, with what is no row: the energy of a path, the summary of a force curve, the notes.
pub(crate) fn write_files(
    scene: &Scene,
    answer: &Answer,
    folder: &Path,
    reader: &Reader,
    out: &mut Out<impl std::io::Write>,
) -> Result<()> {
    let reader = &Reader { notation: Notation::Plain, ..reader.clone() };
    let failed = |error| Failure::file(format!("--out {}", folder.display()), error);
    std::fs::create_dir_all(folder).map_err(failed)?;
    let with_unit = |name: &str, unit: &str| match unit {
        "" => name.to_owned(),
        unit => format!("{name} ({})", reader.unit(unit)),
    };
    let inputs = scene.inputs();
    for output in &answer.outputs {
        let unit = |key: &str| titled(key.strip_prefix(LOG10).unwrap_or(key), answer.control).1;
        let rows = separated(output, |log10, key| reader.magnitude(log10, unit(key)));
        let keys = columns(&rows);
        let shown = |key: &str, cell: &FlatCell| match key.starts_with(LOG10) {
            true => text_of(cell),
            false => reader.number(&text_of(cell), unit(key)),
        };
        let name = format!("{}.csv", output.kind().name());
        let file = std::fs::File::create(folder.join(&name)).map_err(failed)?;
        let given = inputs.iter().map(|(name, unit, _)| with_unit(name, unit));
        let header: Vec<String> = given.chain(keys.iter().map(|key| with_unit(key, unit(key)))).collect();
        let rows = rows.iter().map(|row| {
            let given = inputs.iter().map(|(_, unit, value)| reader.number(value, unit));
            let found = keys.iter().map(|key| value(row, key).map_or_else(String::new, |cell| shown(key, cell)));
            given.chain(found).collect::<Vec<_>>()
        });
        Out::new(file).csv(&header.iter().map(String::as_str).collect::<Vec<_>>(), rows)?;
        out.text(folder.join(&name).display())?;
        output.balance().map_or(Ok(()), |balance| out.text(energy(balance, reader)))?;
        if let Output::ForceCurve(curve) = output {
            out.text(summary(&curve.summary, reader))?;
        }
    }
    answer.notes.iter().try_for_each(|note| out.text(format_args!("Note: {note}.")))
}
