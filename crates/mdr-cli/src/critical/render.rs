//! The answer for a reader and for a spreadsheet.

use mdr::answer::NumberStyle;
use mdr::critical::{CriticalAnswer, overview, spreadsheet};
use mdr::prelude::Value;

use crate::error::Result;
use crate::output::{Format, Output};
use crate::table::{CellStyle, cell, render, table, text_table};
use crate::validity;

/// Writes answers in the `format` asked for; a single one for a reader with its sibling under the other control, and with the
/// control that was assumed where none is given.
pub(crate) fn write(
    answers: &[CriticalAnswer],
    sibling: Option<&CriticalAnswer>,
    assumed: bool,
    format: Format,
    style: &NumberStyle,
    out: &mut Output<impl std::io::Write>,
) -> Result<()> {
    match (format, answers) {
        (Format::Json, _) => answers.iter().try_for_each(|answer| out.json(answer)),
        (Format::Csv, _) => out.spreadsheet(&spreadsheet(answers)),
        (Format::Table, [one]) => {
            let mut text = for_reader(one, assumed, style);
            let sibling = sibling.and_then(|sibling| sibling.sentence(style)).map(|line| format!("\n{line}"));
            let validity = one.validity.as_ref().map(|validity| format!("\n\n{}", validity::text(validity, style)));
            text.extend(sibling.into_iter().chain(validity));
            out.text(text)
        }
        (Format::Table, _) => {
            let table = overview(answers, style);
            out.text(text_table(&table[0], table[1..].to_vec()))
        }
    }
}

fn for_reader(answer: &CriticalAnswer, assumed: bool, style: &NumberStyle) -> String {
    let mut table = table(&["quantity", "value", "unit"]);
    let kappa = style.number(&answer.kappa.to_string(), "");
    table.add_row([cell("kappa_n", CellStyle::Plain), cell(kappa, CellStyle::Good), cell("", CellStyle::Faint)]);
    for (name, value, unit) in answer.quantities() {
        let tone = match value {
            Some(Value::Unknown { .. }) => CellStyle::Bad,
            Some(_) => CellStyle::Good,
            None => CellStyle::Faint,
        };
        let text = value.map_or("none".to_owned(), |value| style.value(value, unit));
        table.add_row([cell(name, CellStyle::Plain), cell(text, tone), cell(style.unit(unit), CellStyle::Faint)]);
    }
    let note = if assumed { " (no --control is given)" } else { "" };
    let heading = answer.heading_with(note);
    format!("{heading}\n\n{}\n\n{}", render(&table), answer.explanation())
}
