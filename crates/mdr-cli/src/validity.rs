//! Whether the theory holds, for a reader.

use mdr::Validity;
use mdr::answer::{FlatCell, FlatRow, NumberStyle, title};
use mdr::prelude::Status;

use crate::solve::render::tone;
use crate::table::{Tone, cell, render, table};

/// A table of its numbers, and what they mean in a sentence.
pub(crate) fn text(validity: &Validity, style: &NumberStyle) -> String {
    let mut table = table(&["quantity", "value"]);
    let row = validity.table();
    for (key, value) in &row {
        if *value != FlatCell::Empty && *value != FlatCell::Status(Status::Ok) {
            let (name, unit) = title(key, None);
            table.add_row([cell(style.titled(name, unit), Tone::Plain), cell(number(&row, key, style), tone(value))]);
        }
    }
    let why = validity.row().why().map_or_else(String::new, |why| format!("\n\nNot known: {why}."));
    format!(
        "validity ({})\n\n{}{why}\n\nDoes the theory hold? {}.",
        validity.promise().name(),
        render(&table),
        capital(&validity.advice())
    )
}

/// What stands below a key, in the units of `style`.
pub(crate) fn number(row: &FlatRow, key: &str, style: &NumberStyle) -> String {
    let found = row.iter().find(|(name, _)| name == key);
    found.map_or_else(String::new, |(_, cell)| style.cell(cell, title(key, None).1))
}

fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}
