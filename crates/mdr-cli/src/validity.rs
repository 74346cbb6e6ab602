//! Whether the theory holds, for a reader.

use mdr::Validity;
use mdr::answer::{FlatCell, title};
use mdr::prelude::Status;

use crate::solve::render::{text_of, tone};
use crate::table::{Tone, cell, render, table};

/// A table of its numbers, and what they mean in a sentence.
pub(crate) fn text(validity: &Validity) -> String {
    let mut table = table(&["quantity", "value"]);
    for (key, value) in validity.table() {
        if value != FlatCell::Empty && value != FlatCell::Status(Status::Ok) {
            let name = if key == "slope" { "slope g'(a)" } else { title(&key) };
            table.add_row([cell(name, Tone::Plain), cell(text_of(&value), tone(&value))]);
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
