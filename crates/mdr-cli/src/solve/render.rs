//! The answer for a reader and for a spreadsheet.

use std::path::Path;

use comfy_table::{Cell, Table};
use mdr::answer::{FlatCell, FlatRow, Notation, NumberStyle, Units, columns, described, find};
use mdr::prelude::*;

use crate::columns::shortened;
use crate::error::Result;
use crate::output::{Format, Output as Out};
use crate::table::{CellStyle, cell, fits, render_whole, table, tone};
use crate::{files, validity};

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
        Arithmetic::F64 => "f64".to_owned(),
    };
    let control = answer.control.map_or_else(String::new, |control| format!("; controlled: {}", control.name()));
    let medium = answer.medium.map_or_else(String::new, |medium| format!("; medium: {medium}"));
    let heading = format!("Profile: {}{medium}{control}; {digits}", answer.profile);
    let parts = answer.outputs.iter().map(|part| output(answer, part, style));
    let basis = answer.admissibility.map(|basis| format!("Admissible: {}.", described(basis)));
    let notes = answer.notes.iter().map(|note| format!("Note: {note}."));
    let validity = answer.validity.as_ref().map(|validity| validity::text(validity, style));
    std::iter::once(heading).chain(notes).chain(parts).chain(basis).chain(validity).collect::<Vec<_>>().join("\n\n")
}

fn output(answer: &Answer, output: &Output, style: &NumberStyle) -> String {
    let rows = output.table();
    let undecided = output.complete().is_some_and(|complete| complete.undecided);
    let table = match rows.is_empty() {
        true if undecided => " none found".to_owned(),
        true => " none".to_owned(),
        false => table_of(answer, output, &rows, style),
    };
    let heading = format!("{} ({})", output.kind().name(), output.standing());
    [heading, table].into_iter().chain(answer.remarks(output, style)).collect::<Vec<_>>().join("\n\n")
}

fn table_of(answer: &Answer, output: &Output, rows: &[FlatRow], style: &NumberStyle) -> String {
    let keys = columns(rows);
    let unit = |key| answer.title(output, key).1;
    let titles = keys.iter().map(|key| answer.title(output, key)).map(|(name, unit)| style.titled(name, unit));
    let mut table = table(&titles.collect::<Vec<_>>());
    // Where the list is that of a range, its end is no end of the equilibria.
    let limited = output.rows().iter().any(|row| row.status() == Status::NoEquilibrium && row.why().is_some());
    for row in rows {
        table.add_row(keys.iter().map(|key| match find(row, key) {
            Some(FlatCell::Status(Status::NoEquilibrium)) if limited => {
                cell(format!("{} within the range", Status::NoEquilibrium), CellStyle::Bad)
            }
            Some(found) => cell(style.cell(found, unit(key)), tone(found)),
            None => cell("", CellStyle::Plain),
        }));
    }
    if fits(&table) {
        return render_whole(&table);
    }
    let short = short_table(answer, output, rows, style).filter(fits);
    short.map_or_else(|| render_whole(&table), |short| format!("{}\n\n{SHORTENED}", render_whole(&short)))
}

const SHORTENED: &str =
    "Six digits, to fit the terminal, and no column of statuses that are all ok; --format csv has all.";

/// The table with six digits of each number, and one notation in each column; for the layout of digits that a terminal has unless
/// another is asked for.
fn short_table(answer: &Answer, output: &Output, rows: &[FlatRow], style: &NumberStyle) -> Option<Table> {
    let is_default = style.notation == Notation::Engineering && style.units == Units::default();
    let mut titles = Vec::new();
    let mut cells: Vec<Vec<Cell>> = vec![Vec::new(); rows.len()];
    for key in columns(rows).into_iter().filter(|_| is_default) {
        let (name, unit) = answer.title(output, &key);
        let found: Vec<Option<&FlatCell>> = rows.iter().map(|row| find(row, &key)).collect();
        if found.iter().all(|found| matches!(found, Some(FlatCell::Status(Status::Ok)))) {
            continue;
        }
        let number = |found: &Option<&'_ FlatCell>| match found {
            Some(FlatCell::Number(text) | FlatCell::Text(text)) => {
                text.parse::<f64>().is_ok().then(|| text.to_string())
            }
            _ => None,
        };
        let numbers: Vec<String> = found.iter().filter_map(number).collect();
        let numbers: Vec<&str> = numbers.iter().map(String::as_str).collect();
        let (short, unit) = shortened(&numbers, unit)?;
        let mut short = short.into_iter();
        // Names are longer than numbers of six digits: each word has its line.
        titles.push(style.titled(name, &unit).replace(' ', "\n"));
        for (row, found) in cells.iter_mut().zip(&found) {
            row.push(match (number(found), found) {
                (Some(_), Some(of)) => cell(short.next().unwrap_or_default(), tone(of)),
                (None, Some(of)) => cell(style.cell(of, &unit), tone(of)),
                (_, None) => cell("", CellStyle::Plain),
            });
        }
    }
    let mut table = table(&titles);
    table.add_rows(cells);
    is_default.then_some(table)
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
    files::make_folder("--out", folder)?;
    let plain = style.plain();
    for output in &answer.outputs {
        let file = folder.join(format!("{}.csv", output.kind().name()));
        files::create_csv("--out", &file, |out| out.spreadsheet(&answer.spreadsheet_of(output, scene, style)))?;
        out.text(files::shown(&file))?;
        output.sentences(&plain).iter().try_for_each(|sentence| out.text(sentence))?;
    }
    answer.notes.iter().try_for_each(|note| out.text(format_args!("Note: {note}.")))
}
