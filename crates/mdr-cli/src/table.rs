//! Tables for a reader.

use std::io::IsTerminal;

use comfy_table::presets::{NOTHING, UTF8_BORDERS_ONLY};
use comfy_table::{Attribute, Cell, Color, ContentArrangement, Table};

/// How a cell is set off on a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tone {
    Plain,
    Strong,
    Faint,
    Good,
    Bad,
}

/// A cell with a tone.
pub(crate) fn cell(content: impl ToString, tone: Tone) -> Cell {
    let cell = Cell::new(content);
    match tone {
        Tone::Plain => cell,
        Tone::Strong => cell.add_attribute(Attribute::Bold),
        Tone::Faint => cell.fg(Color::DarkGrey),
        Tone::Good => cell.fg(Color::Green),
        Tone::Bad => cell.fg(Color::Red).add_attribute(Attribute::Bold),
    }
}

/// An empty table: framed and fitted to a terminal, in colour unless NO_COLOR is set (<https://no-color.org>); bare
/// columns of text elsewhere.
pub(crate) fn table(header: &[&str]) -> Table {
    let mut table = Table::new();
    table.set_header(header.iter().map(|title| cell(title, Tone::Strong)));
    if !std::io::stdout().is_terminal() {
        table.load_style(NOTHING).force_no_tty();
        return table;
    }
    table.load_style(UTF8_BORDERS_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    // Terminals without a window have no width to tell; some say 0.
    let width = table.width().filter(|width| *width > 0).unwrap_or(120);
    table.set_width(width);
    if std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty()) {
        table.force_no_tty();
    }
    table
}

/// The text of a table without trailing blanks.
pub(crate) fn render(table: &Table) -> String {
    table.lines().map(|line| line.trim_end().to_owned()).collect::<Vec<_>>().join("\n")
}
