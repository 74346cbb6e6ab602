//! Whether the theory holds, for a reader.

use mdr::Validity;
use mdr::answer::{FlatCell, FlatRow, Notation, Reader, title};
use mdr::prelude::Status;

use crate::solve::render::tone;
use crate::table::{Tone, cell, render, table};

/// A table of its numbers, and what they mean in a sentence.
pub(crate) fn text(validity: &Validity, reader: &Reader) -> String {
    let mut table = table(&["quantity", "value"]);
    let row = validity.table();
    for (key, value) in &row {
        if *value != FlatCell::Empty && *value != FlatCell::Status(Status::Ok) {
            let (name, unit) = title(key, None);
            table.add_row([cell(reader.titled(name, unit), Tone::Plain), cell(number(&row, key, reader), tone(value))]);
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

/// What stands below a key, in the units of `reader`.
pub(crate) fn number(row: &FlatRow, key: &str, reader: &Reader) -> String {
    match row.iter().find(|(name, _)| name == key) {
        Some((_, FlatCell::Number(text))) => reader.number(text, title(key, None).1),
        // What was typed keeps its notation.
        Some((_, FlatCell::Text(text))) => {
            Reader { notation: Notation::Plain, ..reader.clone() }.number(text, title(key, None).1)
        }
        Some((_, other)) => other.to_string(),
        None => String::new(),
    }
}

fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}
