//! Curves as text, as instruments and spreadsheets write them. The reader is chosen by what is in the file, and never guesses a unit.

mod columns;
mod decode;
mod layout;

use std::borrow::Cow;

use mdr_core::text::excerpt;

use self::columns::Choice;
use self::layout::{Layout, Lines, Separator};
use crate::data::{self, Columns, MOST_ROWS};
use crate::observation::Leg;
use crate::problem::{DataRow, OwnSigma};

/// How the text of a curve was read.
///
/// ```
/// use mdr::no_files;
/// use mdr_fit::Problem;
/// let curve = "Tip 7\nz / µm; F (nN)\n2,0; 22186\n1,5; 13808\n1,0; 6718\n0,5; 1202\n0,0; -2094\n";
/// let fit = r#"
///     profile = { kind = "paraboloid", radius = "10 um" }
///     data = { observation = "F(d)", file = "curve.txt" }
///     fit = { free = ["e_star", "work_of_adhesion"] }
/// "#;
/// let files = |_: &str| Ok(curve.as_bytes().to_vec());
/// let read = Problem::from_toml(fit, "fit.toml", &files)?.read_from().cloned().expect("a file");
/// assert_eq!((read.separator, read.decimal_mark, read.first_line), ("semicolon", "comma", 3));
/// assert_eq!(read.x.unit.as_deref(), Some("µm"));
/// # Ok::<(), mdr::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct CurveText {
    /// `utf-8`, `utf-16le`, `utf-16be` or `latin-1`.
    pub encoding: &'static str,
    /// The mark between columns: `comma`, `semicolon`, `tab` or `blanks`.
    pub separator: &'static str,
    /// `point` or `comma`.
    pub decimal_mark: &'static str,
    /// The line of the header, if there is one.
    pub header_line: Option<usize>,
    /// The line of the first row.
    pub first_line: usize,
    /// The number of rows that were left out because x and y are both empty.
    pub empty_rows: usize,
    /// The column of X.
    pub x: CurveColumn,
    /// The column of Y.
    pub y: CurveColumn,
    /// The column of legs, if there is one.
    pub leg: Option<CurveColumn>,
    /// The origin of the legs: `column`, `segments` in comments, or `order` of X.
    pub legs: &'static str,
}

/// A column of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct CurveColumn {
    /// Its place, counted from 1.
    pub number: usize,
    /// Its name without the unit, if there is a header.
    pub name: Option<String>,
    /// The unit of its numbers.
    pub unit: Option<String>,
}

impl CurveText {
    /// The layout of the text in a sentence.
    pub fn sentence(&self) -> String {
        let column = |column: &CurveColumn| {
            let name = column.name.as_ref().map(|name| format!(" `{}`", excerpt(name))).unwrap_or_default();
            let unit = column.unit.as_ref().map(|unit| format!(" in {}", excerpt(unit))).unwrap_or_default();
            format!("column {}{name}{unit}", column.number)
        };
        let header = self.header_line.map_or("no header".to_owned(), |line| format!("header on line {line}"));
        let legs = match (&self.leg, self.legs) {
            (Some(leg), _) => format!("from {}", column(leg)),
            (None, "segments") => "from the segments named in comments".to_owned(),
            _ => "by the order of x".to_owned(),
        };
        let empty = match self.empty_rows {
            0 => String::new(),
            count => format!("; {count} empty rows left out"),
        };
        format!(
            "Read: {} text, {} between columns, decimal {}; {header}, rows from line {}; x from {}, y from {}, legs {legs}{empty}.",
            self.encoding,
            self.separator,
            self.decimal_mark,
            self.first_line,
            column(&self.x),
            column(&self.y)
        )
    }
}

/// The rows of a curve, and how its text was read where it was one.
#[derive(Debug)]
pub(super) struct Record {
    pub(super) rows: Vec<DataRow>,
    /// How its text was read, and a remark that belongs to the warnings.
    pub(super) text: Option<(CurveText, Option<String>)>,
    /// The rows that were left out since they have no number, by their place among all.
    pub(super) missing: Vec<usize>,
    /// Whether the rows have times.
    pub(super) has_times: bool,
}

/// Reads the rows of a text: lines of numbers between commas, semicolons, tabs or blanks, below what an instrument writes above them.
/// Lines that begin with # or % are comments.
pub(super) fn read(bytes: &[u8], columns: &Columns, bases: [&str; 2]) -> Result<Record, String> {
    let (text, encoding) = decode::decode(bytes)?;
    let lines = Lines::of(&text)?;
    let layout = Layout::find(&lines)?;
    let choice = Choice::new(&layout, columns, bases)?;
    let places = choice.pair(columns)?;
    let [x, y] = [choice.column(places[0], 0)?, choice.column(places[1], 1)?];
    let optional = |name: &Option<String>| name.as_ref().map(|name| choice.named(name)).transpose();
    let (leg, sigma) = (optional(&columns.leg)?, [optional(&columns.sigma[0])?, optional(&columns.sigma[1])?]);
    let named = [&x, &y].map(|column| column.unit.clone().unwrap_or_default());
    let of_sigma = [0, 1].map(|axis| {
        let own = sigma[axis].and_then(|place| choice.column(place, axis).ok()?.unit);
        own.unwrap_or_else(|| named[axis].clone())
    });
    let rows = &lines.filled[layout.first..];
    if rows.len() > MOST_ROWS {
        return Err(layout::too_many(rows.len()));
    }
    let mut cells = Cells { layout: &layout, bases, mark: None };
    let (mut read, mut legs, mut empty) = (Vec::with_capacity(rows.len()), Vec::new(), 0);
    let time = optional(&columns.time)?;
    let second = time.map(|place| data::second(choice.unit(place).unwrap_or(""))).transpose()?.unwrap_or(1.0);
    let mut missing = Vec::new();
    for line in rows {
        let row = Row { line: line.number, fields: layout.separator.fields(line.text) };
        cells.check(&row)?;
        if places.iter().all(|place| row.fields.get(*place).is_none_or(|field| field.is_empty())) {
            empty += 1;
            continue;
        }
        let is_missing = |place: &usize| row.fields.get(*place).is_none_or(|field| data::is_no_number(field));
        if columns.skips_missing && places.iter().any(is_missing) {
            missing.push(read.len() + missing.len());
            continue;
        }
        let own = match leg {
            Some(place) => Some(cells.leg(&row, place)?),
            None => line.segment,
        };
        legs.push(own);
        let mut of = |axis: usize| cells.number(&row, places[axis], &named[axis], axis);
        let (x, y) = (of(0)?, of(1)?);
        let mut deviation =
            |axis: usize| sigma[axis].map(|place| cells.number(&row, place, &of_sigma[axis], axis)).transpose();
        let sigma = [deviation(0)?, deviation(1)?];
        if let Some(sigma) = sigma.iter().flatten().find(|sigma| **sigma <= 0.0) {
            return Err(format!("line {}: a standard deviation must be positive, got {sigma}", line.number));
        }
        let time = time.map_or(Ok(0.0), |place| cells.time(&row, place))? * second;
        read.push(DataRow { x, y, time, sigma: sigma.map(OwnSigma::from), part: 0, leg: Leg::Retract });
    }
    let by_order = data::legs_by_order(&read.iter().map(|row: &DataRow| row.x).collect::<Vec<_>>());
    for ((row, given), found) in read.iter_mut().zip(&legs).zip(by_order) {
        row.leg = given.unwrap_or(found);
    }
    let text = CurveText {
        encoding,
        separator: layout.separator.name(),
        decimal_mark: if cells.mark == Some(',') { "comma" } else { "point" },
        header_line: layout.header_line,
        first_line: rows.first().map_or(0, |line| line.number),
        empty_rows: empty,
        x,
        y,
        leg: leg.map(|place| choice.bare(place)),
        legs: match leg {
            Some(_) => "column",
            None if legs.iter().any(Option::is_some) => "segments",
            None => "order",
        },
    };
    let has_times = time.is_some();
    Ok(Record { rows: read, text: Some((text, choice.others(columns, places))), missing, has_times })
}

/// A row in its fields.
struct Row<'l> {
    line: usize,
    fields: Vec<Cow<'l, str>>,
}

/// The reader of cells, with the decimal mark of the file once a number has shown it.
struct Cells<'l> {
    layout: &'l Layout,
    bases: [&'l str; 2],
    mark: Option<char>,
}

impl Cells<'_> {
    /// Refuses a row with other columns than those of the header.
    fn check(&self, row: &Row<'_>) -> Result<(), String> {
        let [width, fields, line] = [self.layout.width, row.fields.len(), row.line];
        match (self.layout.separator, &self.layout.headings) {
            (Separator::Blanks, _) if fields != width => {
                Err(format!("line {line}: {fields} columns between blanks, and the last row has {width}"))
            }
            (Separator::Comma, Some(headings)) if fields > headings.len() => Err(format!(
                "line {line}: {fields} columns, and the header has {}: with decimal commas, columns are separated by semicolons, tabs or \
                 blanks",
                headings.len()
            )),
            _ => Ok(()),
        }
    }

    fn field<'r>(&self, row: &'r Row<'_>, place: usize) -> Result<&'r str, String> {
        let missing = || format!("line {}: there is no column {}", row.line, place + 1);
        row.fields.get(place).map(|field| &**field).ok_or_else(missing)
    }

    fn leg(&self, row: &Row<'_>, place: usize) -> Result<Leg, String> {
        let name = self.field(row, place)?;
        let refuse = || {
            format!(
                "line {}: a leg is `approach` or `retract`, or a usual name of one, such as `extend` or `withdraw`; got `{}`",
                row.line,
                excerpt(name)
            )
        };
        Leg::named(name).ok_or_else(refuse)
    }

    /// A time, in the unit of its column.
    fn time(&self, row: &Row<'_>, place: usize) -> Result<f64, String> {
        let text = self.field(row, place)?;
        let time = text.trim().replacen(',', ".", 1).parse::<f64>().ok().filter(|time| time.is_finite());
        time.ok_or_else(|| format!("line {}: `{}` in the column of times is not a number", row.line, excerpt(text)))
    }

    /// A number in SI.
    fn number(&mut self, row: &Row<'_>, place: usize, unit: &str, axis: usize) -> Result<f64, String> {
        let text = self.field(row, place)?;
        let refuse = |why: &str| {
            let headings = self.layout.headings.as_ref();
            let name =
                headings.and_then(|headings| headings.get(place)).map_or(["x", "y"][axis], |heading| &heading.name);
            Err(format!("line {}: `{}` in the column `{}` {why}", row.line, excerpt(text), excerpt(name)))
        };
        if let Some(mark) = text.chars().find(|letter| matches!(letter, '.' | ',')) {
            if self.mark.is_some_and(|known| known != mark) {
                return refuse("is not a number with the decimal mark of the lines before");
            }
            self.mark = Some(mark);
        }
        let plain: Cow<'_, str> = match text.contains([',', '\u{2212}']) {
            true => Cow::Owned(text.replace('\u{2212}', "-").replacen(',', ".", 1)),
            false => Cow::Borrowed(text),
        };
        match data::si(&plain, unit, self.bases[axis]).filter(|value| value.is_finite()) {
            Some(value) => Ok(value),
            None if data::is_no_number(text) => refuse("is not a number; `missing = \"skip\"` leaves such rows out"),
            None if has_thousands(text) => refuse("is not a number; write it without marks between the thousands"),
            None => refuse("is not a number"),
        }
    }
}

/// Whether a number has marks between its thousands: two kinds of marks, or one more than once.
fn has_thousands(text: &str) -> bool {
    let marks = text.chars().filter(|letter| ",.'\u{2019}_\u{a0}\u{202f}".contains(*letter)).count();
    marks > 1 && text.chars().filter(char::is_ascii_digit).count() > 3
}
