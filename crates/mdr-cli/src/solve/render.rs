//! The answer for a reader and for a spreadsheet.

use std::path::Path;

use mdr::answer::{FlatCell, FlatRow, NumberStyle, columns, described, title};
use mdr::prelude::*;

use crate::error::{Failure, Result};
use crate::output::{Format, Output as Out};
use crate::table::{Tone, cell, render_whole, table};
use crate::validity;

/// Writes `answer` in the `format` asked for.
pub(crate) fn write(
    answer: &Answer,
    format: Format,
    style: &NumberStyle,
    out: &mut Out<impl std::io::Write>,
) -> Result<()> {
    match format {
        Format::Json => out.json(answer),
        Format::Csv => out.spreadsheet(&answer.spreadsheet()),
        Format::Table => out.text(for_reader(answer, style)),
    }
}

fn for_reader(answer: &Answer, style: &NumberStyle) -> String {
    let digits = match answer.arithmetic {
        Arithmetic::Certified { digits: 1 } => "1 digit".to_owned(),
        Arithmetic::Certified { digits } => format!("{digits} digits"),
        Arithmetic::Double => "f64".to_owned(),
    };
    let control = answer.control.map_or_else(String::new, |control| format!("; controlled: {}", control.name()));
    let heading = format!("Profile: {}{control}; {digits}", answer.profile);
    let parts = answer.outputs.iter().map(|part| output(part, answer.control, style));
    let basis = answer.admissibility.map(|basis| format!("Admissible: {}.", described(basis)));
    let notes = answer.notes.iter().map(|note| format!("Note: {note}."));
    let validity = answer.validity.as_ref().map(|validity| validity::text(validity, style));
    std::iter::once(heading).chain(notes).chain(parts).chain(basis).chain(validity).collect::<Vec<_>>().join("\n\n")
}

fn output(output: &Output, control: Option<ControlKind>, style: &NumberStyle) -> String {
    let rows = output.table();
    let mut text = format!("{} ({})\n\n", output.kind().name(), output.promise().name());
    if rows.is_empty() {
        text.push_str(" none\n");
    } else {
        text.push_str(&table_of(output, &rows, control, style));
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
        text.push_str(&format!("\n{}\n", balance.sentence(style)));
    }
    if let Output::ForceCurve(curve) = output {
        text.push_str(&format!("\n{}\n", curve.summary.sentence(style)));
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

fn table_of(output: &Output, rows: &[FlatRow], control: Option<ControlKind>, style: &NumberStyle) -> String {
    let keys = columns(rows);
    let unit = |key| title(key, control).1;
    let titles = keys.iter().map(|key| title(key, control)).map(|(name, unit)| style.titled(name, unit));
    let mut table = table(&titles.collect::<Vec<_>>());
    // Where the list is that of a range, its end is no end of the equilibria.
    let limited = output.rows().iter().any(|row| row.status() == Status::NoEquilibrium && row.why().is_some());
    for row in rows {
        table.add_row(keys.iter().map(|key| match value(row, key) {
            Some(FlatCell::Status(Status::NoEquilibrium)) if limited => {
                cell(format!("{} within the range", Status::NoEquilibrium), Tone::Bad)
            }
            Some(found) => cell(style.cell(found, unit(key)), tone(found)),
            None => cell("", Tone::Plain),
        }));
    }
    render_whole(&table)
}

fn value<'a>(row: &'a FlatRow, key: &str) -> Option<&'a FlatCell> {
    row.iter().find(|(name, _)| name == key).map(|(_, cell)| cell)
}

pub(crate) fn tone(cell: &FlatCell) -> Tone {
    match cell {
        FlatCell::Number(_) => Tone::Good,
        FlatCell::Text(_) => Tone::Plain,
        FlatCell::Status(Status::Ok) | FlatCell::Empty => Tone::Faint,
        FlatCell::Magnitude(_) | FlatCell::Status(_) => Tone::Bad,
    }
}

/// One file an output in `folder`: the inputs of the scene, a column each, then its columns with their units. The files are
/// listed on `out`, with what is no row: the energy of a path, the summary of a force curve, the notes.
pub(crate) fn write_files(
    scene: &Scene,
    answer: &Answer,
    folder: &Path,
    style: &NumberStyle,
    out: &mut Out<impl std::io::Write>,
) -> Result<()> {
    let failed = |error| Failure::file(format!("--out {}", folder.display()), error);
    let plain = style.plain();
    std::fs::create_dir_all(folder).map_err(failed)?;
    for output in &answer.outputs {
        let file = folder.join(format!("{}.csv", output.kind().name()));
        let mut csv = Out::new(std::fs::File::create(&file).map_err(failed)?);
        csv.spreadsheet(&answer.spreadsheet_of(output, scene, style))?;
        out.text(file.display())?;
        output.balance().map_or(Ok(()), |balance| out.text(balance.sentence(&plain)))?;
        if let Output::ForceCurve(curve) = output {
            out.text(curve.summary.sentence(&plain))?;
        }
    }
    answer.notes.iter().try_for_each(|note| out.text(format_args!("Note: {note}.")))
}
