//! Reads exact rows from text.

use std::cmp::Ordering;
use std::io::Read;
use std::ops::Range;

use csv::{ReaderBuilder, StringRecord, Trim};
use mdr_core::number::{Literal, LiteralError, order};
use mdr_core::units::{SiUnit, bare, scaled};

use super::{MAXIMUM_ROWS, MINIMUM_ROWS, Table, TableColumn, TableError, TableRow};

/// A row of separated columns and the number of its line.
#[derive(Clone, Debug)]
pub struct Line {
    /// The line in the file, from 1; of a row with line breaks in quotation marks, the last.
    pub number: usize,
    /// Its columns, without blanks around them.
    pub fields: StringRecord,
}

impl Line {
    fn width(&self, expected: usize) -> Result<(), TableError> {
        let (line, found) = (self.number, self.fields.len());
        if found == expected { Ok(()) } else { Err(TableError::Width { line, found, expected }) }
    }

    /// Whether no field looks like a number: a header or a row of units.
    fn is_words(&self) -> bool {
        let word = |field: &str| {
            let number_like = field.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
            !number_like && field.parse::<Literal>() == Err(LiteralError::NotANumber)
        };
        self.fields.iter().all(word)
    }

    fn is_units(&self) -> bool {
        self.fields.iter().all(|field| metre_power(field).is_some())
    }
}

/// The k of a unit of 10ᵏ m, plain or in brackets.
pub(super) fn metre_power(unit: &str) -> Option<i64> {
    SiUnit::Metre.power_of(bare(unit))
}

/// The columns of r and f in a record, and their units.
struct Layout {
    width: usize,
    place: [usize; 2],
    power: [i64; 2],
    /// The units, unless both are metres.
    units: Option<[String; 2]>,
}

const COLUMNS: [TableColumn; 2] = [TableColumn::Radius, TableColumn::Height];

impl Layout {
    /// The two columns of a table without header.
    fn plain() -> Self {
        Layout { width: 2, place: [0, 1], power: [0, 0], units: None }
    }

    fn from_header(header: &Line) -> Result<Self, TableError> {
        let mut layout = Layout { width: header.fields.len(), ..Layout::plain() };
        for (place, column) in layout.place.iter_mut().zip(COLUMNS) {
            let named = |field: &str| field.eq_ignore_ascii_case(column.name());
            *place = header.fields.iter().position(named).ok_or_else(|| TableError::MissingColumn {
                line: header.number,
                column,
                found: header.fields.iter().collect::<Vec<_>>().join(", "),
            })?;
        }
        Ok(layout)
    }

    fn set_units(&mut self, units: &Line) -> Result<(), TableError> {
        units.width(self.width)?;
        for ((power, place), column) in self.power.iter_mut().zip(self.place).zip(COLUMNS) {
            let unit = &units.fields[place];
            *power = metre_power(unit).ok_or_else(|| TableError::UnknownUnit {
                line: units.number,
                column,
                unit: unit.to_owned(),
            })?;
        }
        if self.power != [0, 0] {
            self.units = Some(self.place.map(|place| units.fields[place].to_owned()));
        }
        Ok(())
    }

    /// The number in a column: as given, and in metres.
    fn number<'a>(&self, line: &'a Line, column: TableColumn) -> Result<(&'a str, Literal), TableError> {
        let (place, power) = (self.place[column as usize], self.power[column as usize]);
        let text = &line.fields[place];
        let metres = text.parse::<Literal>().and_then(|_| scaled(text, power).parse());
        let refused = |reason| TableError::NotANumber { line: line.number, column, text: text.to_owned(), reason };
        Ok((text, metres.map_err(refused)?))
    }

    /// A row, with its radius as given.
    fn row<'a>(&self, line: &'a Line) -> Result<(&'a str, TableRow), TableError> {
        line.width(self.width)?;
        let (given, radius) = self.number(line, TableColumn::Radius)?;
        let (_, height) = self.number(line, TableColumn::Height)?;
        if radius.is_negative() {
            return Err(TableError::NegativeRadius { line: line.number, radius: given.to_owned() });
        }
        Ok((given, TableRow { line: line.number, radius, height }))
    }
}

impl Table {
    /// Reads a table of two columns, `r` and `f`.
    ///
    /// Columns are separated by commas, semicolons or tabs (the first row decides); a header row names `r` and `f` (in
    /// any order, other columns are ignored) and may be left out when there are just these two; a row of units
    /// (`um,nm`; metres without it) may follow; comment lines start with `#`.
    ///
    /// # Errors
    /// [`TableError`], with the line, the column and the value.
    pub fn from_csv(source: impl Read) -> Result<Table, TableError> {
        let table = Table::from_csv_above_any_zero(source)?;
        if table.rows[0].radius.is_zero() { table.check_tip().map(|()| table) } else { Ok(table) }
    }

    /// Reads a table like [`Table::from_csv`], with heights measured from any zero.
    ///
    /// # Errors
    /// [`TableError`], with the line, the column and the value. f(0) is not checked.
    pub fn from_csv_above_any_zero(mut source: impl Read) -> Result<Table, TableError> {
        let mut bytes = Vec::new();
        source.read_to_end(&mut bytes)?;
        let mut lines = separated(&bytes)?.peekable();
        let mut words = || lines.next_if(|line| line.as_ref().is_ok_and(Line::is_words)).transpose();

        let mut layout = Layout::plain();
        let mut units = words()?;
        if let Some(header) = units.take_if(|line| !line.is_units()) {
            layout = Layout::from_header(&header)?;
            units = words()?;
        }
        if let Some(units) = units {
            layout.set_units(&units)?;
        }
        // Rows read so far, and the last radius as given.
        let (mut rows, mut previous) = (Vec::<TableRow>::new(), String::new());
        while let Some(line) = lines.next() {
            let line = line?;
            let (given, row) = layout.row(&line)?;
            if let Some(last) = rows.last() {
                let (line, radius, previous_line) = (row.line, given.to_owned(), last.line);
                match order(&row.radius.nearest_f64(), &last.radius.nearest_f64()) {
                    Ordering::Less => return Err(TableError::Unsorted { line, radius, previous, previous_line }),
                    Ordering::Equal => return Err(TableError::Repeated { line, radius, previous_line }),
                    Ordering::Greater => {}
                }
            }
            if rows.len() == MAXIMUM_ROWS {
                let given = rows.len() + lines.count() + 1;
                let what = format!("{given} rows; at most {MAXIMUM_ROWS} are read");
                return Err(TableError::TooLarge { what, remedy: "keep every tenth row, or the rows near the tip" });
            }
            given.clone_into(&mut previous);
            rows.push(row);
        }
        if rows.len() < MINIMUM_ROWS {
            return Err(TableError::TooFewRows { rows: rows.len() });
        }
        Ok(Table { rows, units: layout.units })
    }
}

/// The longest line that is read.
const LONGEST_LINE: usize = 1 << 20;

/// The rows of a text without its byte order mark, comments and blank lines. Columns are separated by commas, semicolons or
/// tabs: the first row decides. Lines end with a line feed, a carriage return, or both.
///
/// # Errors
/// [`TableError::TooLarge`] for a line of more than 1 MiB; of each row [`TableError::Malformed`] where it is not UTF-8.
pub fn separated(text: &[u8]) -> Result<impl Iterator<Item = Result<Line, TableError>> + '_, TableError> {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let longest = text.split(|byte| *byte == b'\n').position(|line| line.len() > LONGEST_LINE);
    match longest {
        None => Ok(records(text)),
        Some(line) => {
            let what = format!("line {} is longer than {LONGEST_LINE} bytes", line + 1);
            Err(TableError::TooLarge { what, remedy: "a row has its numbers on a line of its own" })
        }
    }
}

fn records(text: &[u8]) -> impl Iterator<Item = Result<Line, TableError>> + '_ {
    let mut reader = ReaderBuilder::new()
        .has_headers(false)
        .comment(Some(b'#'))
        .flexible(true)
        .trim(Trim::All)
        .delimiter(separator(text))
        .from_reader(text);
    let mut lines = LineCounter { text, seen: 0, line: 1 };
    std::iter::from_fn(move || {
        loop {
            let mut fields = StringRecord::new();
            let outcome = reader.read_record(&mut fields);
            // The reader reports the position before preceding comments; its position after the record is exact.
            let number = lines.of_record_before(reader.position().byte() as usize);
            match outcome {
                Ok(false) => return None,
                Ok(true) if fields.get(0).is_some_and(|first| first.starts_with('#')) => {}
                Ok(true) => return Some(Ok(Line { number, fields })),
                Err(error) => return Some(Err(TableError::Malformed { line: number, reason: error.to_string() })),
            }
        }
    })
}

/// The separator of the first line that is neither blank nor a comment.
fn separator(text: &[u8]) -> u8 {
    let first =
        text.split(|&b| b == b'\n' || b == b'\r').map(<[u8]>::trim_ascii).find(|line| !matches!(line, [] | [b'#', ..]));
    let first = first.unwrap_or_default();
    [b'\t', b';'].into_iter().find(|separator| first.contains(separator)).unwrap_or(b',')
}

/// Counts lines as the reader proceeds.
struct LineCounter<'a> {
    text: &'a [u8],
    seen: usize,
    line: usize,
}

impl LineCounter<'_> {
    /// Whether a line ends with this byte: a line feed, or a carriage return without one after it.
    fn ends_line(&self, place: usize) -> bool {
        match self.text[place] {
            b'\n' => true,
            b'\r' => self.text.get(place + 1) != Some(&b'\n'),
            _ => false,
        }
    }

    /// The line of the record that ends, including its line break, before byte `end`.
    fn of_record_before(&mut self, end: usize) -> usize {
        let fresh: Range<usize> = self.seen..end.saturating_sub(1).max(self.seen);
        self.seen = fresh.end;
        self.line += fresh.filter(|&place| self.ends_line(place)).count();
        self.line
    }
}
