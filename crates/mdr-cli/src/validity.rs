//! Whether the theory holds, for a reader.

use mdr::Validity;
use mdr::answer::{FlatCell, NumberStyle};
use mdr::prelude::Status;

use crate::table::{CellStyle, cell, render, table, tone};

/// A table of its numbers, and their meaning in a sentence.
pub(crate) fn text(validity: &Validity, style: &NumberStyle) -> String {
    let mut table = table(&["quantity", "value"]);
    for (key, value) in &validity.table() {
        if *value != FlatCell::Empty && *value != FlatCell::Status(Status::Ok) {
            let (name, unit) = Validity::title(key);
            table.add_row([
                cell(style.titled(name, unit), CellStyle::Plain),
                cell(style.cell(value, unit), tone(value)),
            ]);
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

fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}
