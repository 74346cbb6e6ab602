//! Standard output: its format, and a pipe that may close early.

use std::io::{self, ErrorKind, Write};

use clap::ValueEnum;
use serde::Serialize;

use crate::error::{Failure, Result};
use crate::table::terminal_width;

/// The shape of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For a reader: aligned, with units; in colour on a terminal unless NO_COLOR is set.
    Table,
    /// For a program: one JSON object a line, with a schema.
    Json,
    /// For a spreadsheet: a header and rows.
    Csv,
}

/// A writer that goes on when the reader has closed the pipe: the result of a command still decides its exit status.
pub(crate) struct Output<W> {
    to: W,
    /// The columns of the terminal, between which sentences are broken; none elsewhere.
    width: Option<usize>,
}

impl Output<io::StdoutLock<'static>> {
    pub(crate) fn stdout() -> Self {
        Output { to: io::stdout().lock(), width: terminal_width() }
    }
}

impl<W: Write> Output<W> {
    /// Any other writer.
    pub(crate) fn new(writer: W) -> Self {
        Output { to: writer, width: None }
    }

    /// One line of text, or several.
    pub(crate) fn text(&mut self, text: impl std::fmt::Display) -> Result<()> {
        match self.width {
            Some(width) => self.finish(|out| writeln!(out, "{}", wrapped(&text.to_string(), width))),
            None => self.finish(|out| writeln!(out, "{text}")),
        }
    }

    /// Bytes that need no formatting.
    pub(crate) fn bytes(&mut self, bytes: &[u8]) -> Result<()> {
        self.finish(|out| out.write_all(bytes))
    }

    /// The end of all that is written.
    pub(crate) fn close(&mut self) -> Result<()> {
        self.finish(|_| Ok(()))
    }

    /// One line of JSON, with the program in its head.
    pub(crate) fn json(&mut self, value: &impl Serialize) -> Result<()> {
        self.finish(|out| {
            let line = serde_json::to_string(value)?;
            writeln!(out, "{}", mdr_provenance::json(&line))
        })
    }

    /// Lines of JSON that are written already, with the program in the head of each.
    pub(crate) fn json_lines(&mut self, lines: &str) -> Result<()> {
        self.text(mdr_provenance::json(lines))
    }

    /// A header and rows, quoted where needed.
    pub(crate) fn csv<R: AsRef<[String]>>(
        &mut self,
        header: &[impl AsRef<[u8]>],
        rows: impl IntoIterator<Item = R>,
    ) -> Result<()> {
        self.finish(|out| {
            let mut csv = csv::Writer::from_writer(out);
            csv.write_record(header)?;
            for row in rows {
                csv.write_record(row.as_ref())?;
            }
            csv.flush()
        })
    }

    /// Records of a type, titled by its fields.
    pub(crate) fn records(&mut self, records: impl IntoIterator<Item: Serialize>) -> Result<()> {
        self.finish(|out| {
            let mut csv = csv::Writer::from_writer(out);
            records.into_iter().try_for_each(|record| csv.serialize(record))?;
            csv.flush()
        })
    }

    /// A table with its titles first.
    pub(crate) fn spreadsheet(&mut self, table: &[Vec<String>]) -> Result<()> {
        self.csv(&table[0], &table[1..])
    }

    fn finish(&mut self, write: impl FnOnce(&mut Self) -> io::Result<()>) -> Result<()> {
        write(self).and_then(|()| self.flush()).map_err(|error| Failure::file("standard output", error))
    }
}

impl<W: Write> Write for Output<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.to.write(bytes) {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(bytes.len()),
            result => result,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.to.flush() {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
            result => result,
        }
    }
}

/// The columns between which the texts of derivations are broken where they are written.
const WRITTEN: usize = 100;

/// Lines longer than `width` broken between words, the rest with the indentation of the line; lines of tables stay. What was broken
/// for a wider page flows on.
fn wrapped(text: &str, width: usize) -> String {
    let is_table = |line: &str| line.contains('\u{1b}') || line.starts_with(['│', '┌', '╞', '└', '╪', '├']);
    let mut wrapped = Vec::new();
    let mut lines = text.split('\n').peekable();
    while let Some(line) = lines.next() {
        if line.chars().count() <= width || is_table(line) {
            wrapped.push(line.to_owned());
            continue;
        }
        let mut words: Vec<&str> = line.split_whitespace().collect();
        let mut last = line;
        while let Some(next) = lines.next_if(|next| flows_on(last, next, width)) {
            words.extend(next.split_whitespace());
            last = next;
        }
        let indent = indentation(line).min(width / 2);
        let mut row = " ".repeat(indent);
        for word in words {
            let is_first = row.trim_start().is_empty();
            if !is_first && row.chars().count() + 1 + word.chars().count() > width {
                wrapped.push(std::mem::replace(&mut row, " ".repeat(indent)));
                row.push_str(word);
            } else {
                if !is_first {
                    row.push(' ');
                }
                row.push_str(word);
            }
        }
        wrapped.push(row);
    }
    wrapped.join("\n")
}

fn indentation(line: &str) -> usize {
    line.chars().take_while(|letter| *letter == ' ').count()
}

/// Whether a line was broken where its next word had no room any more, and goes on in the next line.
fn flows_on(line: &str, next: &str, width: usize) -> bool {
    let length = line.chars().count();
    let Some(word) = next.split_whitespace().next() else { return false };
    let full = (width + 1..=WRITTEN).contains(&length) && length + 1 + word.chars().count() > WRITTEN;
    full && indentation(line) == indentation(next)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_are_broken_between_words_and_tables_are_not() {
        assert_eq!(wrapped("  one two three", 10), "  one two\n  three");
        assert_eq!(wrapped("short\n\nlines", 10), "short\n\nlines");
        assert_eq!(wrapped("│ one two three │", 10), "│ one two three │");
        assert_eq!(wrapped("unbreakable-word then", 10), "unbreakable-word\nthen");
    }

    #[test]
    fn what_was_broken_for_a_wider_page_flows_on() {
        let text = format!("   {}longer\n   and on.\n   Another line.", "word ".repeat(18));
        let rows = wrapped(&text, 80);
        let lengths: Vec<usize> = rows.lines().map(|row| row.chars().count()).collect();
        assert!(lengths.len() == 3 && lengths[0] > 70 && lengths[1] > 20, "{rows}");
        assert!(rows.ends_with("longer and on.\n   Another line."), "{rows}");
    }
}
