//! Tables for a reader.

use std::io::IsTerminal;

use comfy_table::presets::{NOTHING, UTF8_BORDERS_ONLY};
use comfy_table::{Attribute, Cell, Color, ContentArrangement, Row, Table};
use mdr::answer::FlatCell;
use mdr::prelude::Status;

/// How a cell is set off on a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CellStyle {
    Plain,
    Strong,
    Faint,
    Good,
    Bad,
}

/// The style of a cell of an answer.
pub(crate) fn tone(cell: &FlatCell) -> CellStyle {
    match cell {
        FlatCell::Number(_) => CellStyle::Good,
        FlatCell::Text(_) => CellStyle::Plain,
        FlatCell::Status(Status::Ok) | FlatCell::Empty => CellStyle::Faint,
        FlatCell::Magnitude(_) | FlatCell::Status(_) => CellStyle::Bad,
    }
}

/// A cell with a tone.
pub(crate) fn cell(content: impl ToString, tone: CellStyle) -> Cell {
    let cell = Cell::new(content);
    match tone {
        CellStyle::Plain => cell,
        CellStyle::Strong => cell.add_attribute(Attribute::Bold),
        CellStyle::Faint => cell.fg(Color::DarkGrey),
        CellStyle::Good => cell.fg(Color::Green),
        CellStyle::Bad => cell.fg(Color::Red).add_attribute(Attribute::Bold),
    }
}

/// The columns of the terminal that reads standard output; `None` for a file or a pipe.
pub(crate) fn terminal_width() -> Option<usize> {
    if !std::io::stdout().is_terminal() {
        return None;
    }
    // Terminals without a window have no width to tell; some say 0.
    Some(Table::new().width().filter(|width| *width > 0).map_or(120, usize::from))
}

/// Whether a terminal shows no colours: NO_COLOR is set (<https://no-color.org>), or it is one without.
fn is_without_colours() -> bool {
    std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty()) || is_dumb()
}

/// Whether the terminal says that it can only write lines.
pub(crate) fn is_dumb() -> bool {
    std::env::var_os("TERM").is_some_and(|value| value == "dumb")
}

/// An empty table: framed and fitted to a terminal, in colour unless it has none; bare columns of text elsewhere.
pub(crate) fn table(header: &[impl std::fmt::Display]) -> Table {
    let mut table = Table::new();
    table.set_header(header.iter().map(|title| cell(title, CellStyle::Strong)));
    let Some(width) = terminal_width() else {
        table.load_style(NOTHING).force_no_tty();
        return table;
    };
    table.load_style(UTF8_BORDERS_ONLY).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(u16::try_from(width).unwrap_or(u16::MAX));
    if is_without_colours() {
        table.force_no_tty();
    }
    table
}

/// The text of a table of texts, none of which is set off; each stays in one piece.
pub(crate) fn text_table(header: &[impl std::fmt::Display], rows: impl IntoIterator<Item: Into<Row>>) -> String {
    render_whole(table(header).add_rows(rows))
}

/// The text of a table whose cells stay in one piece: where it is wider than the terminal, one cell a line.
pub(crate) fn render_whole(table: &Table) -> String {
    if fits(table) { render(table) } else { vertical(table) }
}

/// Whether a terminal has room for a table whose cells stay in one piece.
pub(crate) fn fits(table: &Table) -> bool {
    let natural: usize = table.column_max_content_widths().iter().map(|width| usize::from(*width) + 3).sum();
    table.width().is_none_or(|width| natural < usize::from(width))
}

/// One cell a line with its title, a blank line between rows; empty cells are left out.
fn vertical(table: &Table) -> String {
    let titles: Vec<String> = table.header().into_iter().flat_map(|row| row.cell_iter().map(Cell::content)).collect();
    let longest = titles.iter().map(|title| title.chars().count()).max().unwrap_or(0);
    let row = |row: &Row| {
        let cells = titles.iter().zip(row.cell_iter().map(Cell::content)).filter(|(_, text)| !text.is_empty());
        cells.map(|(title, text)| format!(" {title:<longest$}  {text}")).collect::<Vec<_>>().join("\n")
    };
    table.row_iter().map(row).collect::<Vec<_>>().join("\n\n")
}

/// The text of a table without trailing blanks.
pub(crate) fn render(table: &Table) -> String {
    table.lines().map(|line| line.trim_end().to_owned()).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
#[path = "../tests/private/table.rs"]
mod tests;
