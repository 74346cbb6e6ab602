//! The table in a text: its separator, its header, its units, and where its rows begin.

use std::borrow::Cow;

use csv::ReaderBuilder;
use mdr_core::text::excerpt;
use mdr_core::units::{SiUnit, bare};

use crate::data::{FEWER_ROWS, MOST_ROWS};
use crate::observation::Leg;

/// The most lines above the rows.
const MOST_ABOVE: usize = 10_000;

/// The longest line that is read.
const LONGEST_LINE: usize = 1 << 20;

/// What stands between two columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    Tab,
    Semicolon,
    Comma,
    Blanks,
}

impl Separator {
    /// In the order in which they are tried.
    const ALL: [Separator; 4] = [Separator::Tab, Separator::Semicolon, Separator::Comma, Separator::Blanks];

    /// As answers name it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Separator::Tab => "tab",
            Separator::Semicolon => "semicolon",
            Separator::Comma => "comma",
            Separator::Blanks => "blanks",
        }
    }

    /// The fields of a line, without blanks around them and without empty ones at its end.
    pub(super) fn fields(self, line: &str) -> Vec<Cow<'_, str>> {
        let mark = match self {
            Separator::Blanks => return line.split_whitespace().map(Cow::Borrowed).collect(),
            Separator::Tab => '\t',
            Separator::Semicolon => ';',
            Separator::Comma => ',',
        };
        let mut fields: Vec<Cow<'_, str>> = match line.contains('"') {
            false => line.split(mark).map(|field| Cow::Borrowed(field.trim())).collect(),
            true => quoted(line, mark),
        };
        let filled = fields.iter().rposition(|field| !field.is_empty()).map_or(0, |last| last + 1);
        fields.truncate(filled);
        fields
    }
}

/// The fields of a line with quotation marks.
fn quoted(line: &str, mark: char) -> Vec<Cow<'_, str>> {
    let mut reader = ReaderBuilder::new();
    let reader = reader.has_headers(false).delimiter(mark as u8).from_reader(line.as_bytes());
    let record = reader.into_records().next().and_then(Result::ok).unwrap_or_default();
    record.iter().map(|field| Cow::Owned(field.trim().to_owned())).collect()
}

/// A line of a text that is neither blank nor a comment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<'t> {
    /// Counted from 1.
    pub(super) number: usize,
    pub(super) text: &'t str,
    /// The leg of the segment in which it stands, if a comment above names one.
    pub(super) segment: Option<Leg>,
}

/// The lines of a text.
#[derive(Debug, Default)]
pub(super) struct Lines<'t> {
    pub(super) filled: Vec<Line<'t>>,
    /// Comments that may be a header: their places among the filled lines, their numbers, and their texts.
    comments: Vec<(usize, usize, &'t str)>,
}

/// How many lines end in a text: with a line feed, a carriage return, or both.
pub(super) fn breaks(text: &str) -> usize {
    text.matches('\n').count() + text.matches('\r').count() - text.matches("\r\n").count()
}

impl<'t> Lines<'t> {
    /// The lines of a text that are not blank. Comments begin with # or %; `# segment: extend` begins a leg.
    ///
    /// # Errors
    /// A line that is too long, a segment that is no leg, more lines than [`MOST_ROWS`] and what may stand above.
    pub(super) fn of(text: &'t str) -> Result<Self, String> {
        let (mut lines, mut segment, mut count) = (Lines::default(), None, 0_usize);
        let ends = |letter: char| matches!(letter, '\n' | '\r');
        let mut number = 0;
        let mut rest = Some(text);
        while let Some(from) = rest {
            number += 1;
            let (line, next) = match from.split_once(ends) {
                None => (from, None),
                Some((line, next)) if from[line.len()..].starts_with("\r\n") => (line, Some(&next[1..])),
                Some((line, next)) => (line, Some(next)),
            };
            rest = next;
            if line.len() > LONGEST_LINE {
                return Err(format!(
                    "line {number} is longer than {LONGEST_LINE} bytes: a row has its numbers on a line of its own"
                ));
            }
            if line.trim().is_empty() {
                continue;
            }
            if let Some(comment) = line.trim_start().strip_prefix(['#', '%']) {
                if let Some(name) = after(comment, "segment:") {
                    segment = Some((number, name));
                } else if lines.comments.len() < MOST_ABOVE {
                    lines.comments.push((lines.filled.len(), number, comment.trim_matches(' ')));
                }
                continue;
            }
            count += 1;
            if lines.filled.len() < MOST_ROWS + MOST_ABOVE {
                let leg = |(at, name): (usize, &str)| {
                    Leg::named(name).ok_or_else(|| {
                        let name = excerpt(name);
                        format!("line {at}: rows follow the segment `{name}`, which is neither approach nor retract: leave them out")
                    })
                };
                lines.filled.push(Line { number, text: line, segment: segment.map(leg).transpose()? });
            }
        }
        if count > lines.filled.len() {
            return Err(too_many(count));
        }
        Ok(lines)
    }
}

/// The complaint about a curve of too many rows.
pub(super) fn too_many(rows: usize) -> String {
    format!("{rows} rows; at most {MOST_ROWS} are read: {FEWER_ROWS}")
}

/// What follows a key at the beginning of a comment, whatever its case.
fn after<'c>(comment: &'c str, key: &str) -> Option<&'c str> {
    let comment = comment.trim();
    let (start, rest) = comment.split_at_checked(key.len())?;
    start.eq_ignore_ascii_case(key).then(|| rest.trim())
}

/// The heading of a column: its name, and the unit that stands beside it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Heading {
    /// As it is written.
    pub(super) whole: String,
    pub(super) name: String,
    pub(super) unit: Option<String>,
}

impl Heading {
    /// `z [nm]`, `z (um)`, `z {um}`, `z / nm`, or `z, nm`. What is no unit is a part of the name: `Height (measured)`.
    pub(super) fn of(text: &str) -> Heading {
        let whole = text.trim().to_owned();
        let [open, close] = [["[", "(", "{"], ["]", ")", "}"]];
        let enclosed = open.iter().zip(close).find_map(|(open, close)| {
            let (name, unit) = whole.strip_suffix(close)?.rsplit_once(open)?;
            Some((name, unit))
        });
        let apart = || whole.split_once('/').or_else(|| whole.rsplit_once(','));
        // A name has a letter that a unit alone has not; [V] is a unit, too, of something else.
        let found = enclosed
            .filter(|(_, unit)| is_unit(unit) || whole.ends_with(']'))
            .or_else(|| apart().filter(|(_, unit)| is_unit(unit)));
        match found {
            Some((name, unit)) if !name.trim().is_empty() => {
                Heading { name: name.trim().to_owned(), unit: Some(unit.trim().to_owned()), whole }
            }
            _ => Heading { name: whole.clone(), unit: None, whole },
        }
    }
}

/// Whether a text is a unit of length or force, in brackets or without.
pub(super) fn is_unit(text: &str) -> bool {
    power(text, "m").or_else(|| power(text, "N")).is_some()
}

/// The power of ten of a unit over its base, `m` or `N`.
pub(super) fn power(unit: &str, base: &str) -> Option<i64> {
    let of = if base == "m" { SiUnit::Metre } else { SiUnit::Newton };
    of.power_of(bare(unit))
}

/// The header of a table that stands beside its rows.
#[derive(Debug)]
pub(super) struct Layout {
    pub(super) separator: Separator,
    /// Of each column, where there is a header.
    pub(super) headings: Option<Vec<Heading>>,
    /// The line of the header.
    pub(super) header_line: Option<usize>,
    /// The row of units, where there is one.
    pub(super) units: Option<Vec<String>>,
    /// The place of the first row among the filled lines.
    pub(super) first: usize,
    /// The number of columns of a row.
    pub(super) width: usize,
}

/// A line in fields: numbers, words, or both.
struct Split<'l> {
    fields: Vec<Cow<'l, str>>,
    numbers: usize,
}

impl Split<'_> {
    fn of(line: &str, separator: Separator) -> Split<'_> {
        let fields = separator.fields(line);
        let numbers = fields.iter().filter(|field| is_number(field, separator)).count();
        Split { fields, numbers }
    }

    /// At least two numbers, and no field of several: commas in `1,5 2,5` separate nothing.
    fn is_row(&self) -> bool {
        let is_several = |field: &Cow<'_, str>| {
            let mut parts = field.split_whitespace();
            parts.clone().count() > 1 && parts.all(|part| is_number(part, Separator::Blanks))
        };
        self.numbers >= 2 && !self.fields.iter().any(is_several)
    }

    fn is_words(&self) -> bool {
        self.numbers == 0 && !self.fields.is_empty()
    }

    fn is_all_numbers(&self) -> bool {
        self.numbers >= 2 && self.numbers == self.fields.iter().filter(|field| !field.is_empty()).count()
    }

    fn has_units(&self) -> bool {
        self.fields.iter().any(|field| is_unit(field))
    }
}

fn is_number(field: &str, separator: Separator) -> bool {
    let mut plain = Cow::Borrowed(field);
    if field.contains(['\u{2212}', ',']) {
        let decimal = if separator == Separator::Comma { "," } else { "." };
        plain = Cow::Owned(field.replace('\u{2212}', "-").replacen(',', decimal, 1));
    }
    plain.parse::<f64>().is_ok_and(|number| !number.is_nan())
}

impl Layout {
    /// Finds the table among the lines of a text.
    ///
    /// # Errors
    /// No row of numbers; a line before the first row that looks like a row; marks that are columns and decimals at once.
    pub(super) fn find(lines: &Lines<'_>) -> Result<Layout, String> {
        let filled = &lines.filled;
        let separator = separator(filled)?;
        let split = |place: usize| Split::of(filled[place].text, separator);
        let last = (0..filled.len()).rev().map(split).find(|line| line.is_row());
        let width = last.map_or(2, |line| line.fields.len());
        let is_row = |place: usize| {
            let line = split(place);
            line.is_row() && (separator != Separator::Blanks || line.fields.len() == width)
        };
        let is_numbers = |line: &&Line<'_>| Split::of(line.text, separator).is_all_numbers();
        let above = filled.iter().take(MOST_ABOVE).take_while(|line| !is_numbers(line)).count();
        let headers: Vec<Option<Vec<Heading>>> =
            filled[..above].iter().map(|line| headings(line.text, separator, width)).collect();
        let units = |place: usize| {
            let cells = units(filled[..above].get(place)?.text, separator)?;
            (separator != Separator::Blanks || cells.len() == width).then_some(cells)
        };
        // The place after a header that has units, or that a row of units follows.
        let after = |place: usize| {
            let header = headers[place].as_ref().filter(|_| units(place).is_none())?;
            let own = header.iter().filter(|heading| heading.unit.is_some()).count();
            match units(place + 1) {
                Some(_) => Some(place + 2),
                None => (own >= 2).then_some(place + 1),
            }
        };
        let candidates: Vec<(usize, usize)> = (0..above).filter_map(|place| Some((place, after(place)?))).collect();
        let above_row = candidates.iter().find(|(_, first)| *first < filled.len() && is_row(*first));
        let mut layout = Layout { separator, headings: None, header_line: None, units: None, first: 0, width };
        if let Some((place, first)) = above_row.or(candidates.first()) {
            if let Some(row) = (0..*place).find(|row| is_row(*row) && split(*row).fields.len() == width) {
                let [row, header] = [row, *place].map(|place| filled[place].number);
                return Err(format!(
                    "line {row} looks like a row above the header on line {header}: begin it with # where it is none"
                ));
            }
            layout.name(filled, *place, headers[*place].clone());
            layout.units = units(place + 1);
            layout.first = *first;
        } else {
            layout.first = (0..filled.len()).find(|place| is_row(*place)).unwrap_or(above);
            let mut top = layout.first;
            if let Some(found) = top.checked_sub(1).and_then(units) {
                (layout.units, top) = (Some(found), top - 1);
            }
            match top.checked_sub(1) {
                Some(place) if place < above && headers[place].is_some() => {
                    layout.name(filled, place, headers[place].clone());
                }
                // A row that is broken begins the rows, and is refused there.
                Some(place) if layout.units.is_none() => {
                    let line = split(place);
                    layout.first -= usize::from(line.numbers > 0 && line.fields.len() >= width);
                }
                _ => {}
            }
        }
        layout.comments(lines)?;
        Ok(layout)
    }

    fn name(&mut self, filled: &[Line<'_>], place: usize, headings: Option<Vec<Heading>>) {
        (self.headings, self.header_line) = (headings, Some(filled[place].number));
    }

    /// Headers in comments: `# columns: z F` and `# units: m N` above the rows, or the last comment with a name for each column.
    fn comments(&mut self, lines: &Lines<'_>) -> Result<(), String> {
        let width = self.width;
        let mut columns: Option<(usize, Vec<Heading>)> = None;
        for (place, number, comment) in &lines.comments {
            let listed = |key: &str| after(comment, key).and_then(|list| headings(list, self.separator, width));
            if let Some(found) = listed("columns:") {
                match &columns {
                    Some((first, known)) if *known != found => {
                        return Err(format!(
                            "line {number}: other columns than on line {first}: keep one order of columns"
                        ));
                    }
                    _ => columns = Some((*number, found)),
                }
            } else if let Some(found) = listed("units:")
                && *place <= self.first
                && self.units.is_none()
            {
                self.units = Some(found.into_iter().map(|heading| heading.whole).collect());
            }
        }
        if self.headings.is_some() {
            return Ok(());
        }
        let last = lines.comments.iter().rev().find(|(place, ..)| *place == self.first);
        let last = || {
            let (_, number, text) = last?;
            let found = headings(text, self.separator, width).filter(|found| found.len() == width)?;
            Some((*number, found))
        };
        if let Some((number, found)) = columns.or_else(last) {
            (self.headings, self.header_line) = (Some(found), Some(number));
        }
        Ok(())
    }
}

/// The separator of the last line that is a row.
fn separator(lines: &[Line<'_>]) -> Result<Separator, String> {
    for line in lines.iter().rev() {
        let fits = |separator: &Separator| Split::of(line.text, *separator).is_row();
        if let Some(separator) = Separator::ALL.into_iter().find(fits) {
            return match separator {
                Separator::Comma if is_undecided(line.text) => Err(format!(
                    "line {}: commas in `{}` may be decimal marks or separators: separate columns by semicolons, tabs or blanks",
                    line.number,
                    excerpt(line.text.trim())
                )),
                separator => Ok(separator),
            };
        }
    }
    let first = lines.first().map_or(1, |line| line.number);
    Err(format!(
        "line {first} and all below: no row of at least two numbers, between commas, semicolons, tabs or blanks"
    ))
}

/// Whether commas stand between digits with a blank after some of them and without after others, as in `0,5, 1,2`.
fn is_undecided(line: &str) -> bool {
    let digit = |letter: Option<char>| letter.is_some_and(|letter| letter.is_ascii_digit());
    let parts: Vec<&str> = line.split(',').collect();
    let pairs = || parts.windows(2).filter(|pair| digit(pair[0].chars().next_back()));
    let close = pairs().any(|pair| digit(pair[1].chars().next()));
    let wide = pairs().any(|pair| pair[1].starts_with(' ') && digit(pair[1].trim_start().chars().next()));
    close && wide && !line.contains('.')
}

/// The headings of a line of words, one for each column where columns are separated by blanks.
fn headings(line: &str, separator: Separator, width: usize) -> Option<Vec<Heading>> {
    let is_header = |fields: &[Cow<'_, str>], exactly: bool| {
        let words = fields.iter().all(|field| !is_number(field, separator));
        words && if exactly { fields.len() == width } else { fields.len() >= 2.min(width) }
    };
    let own = separator.fields(line);
    if separator != Separator::Blanks && own.len() > 1 {
        return is_header(&own, false).then(|| own.iter().map(|field| Heading::of(field)).collect());
    }
    let tabs = Separator::Tab.fields(line);
    if is_header(&tabs, true) {
        return Some(tabs.iter().map(|field| Heading::of(field)).collect());
    }
    let blanks: Vec<Cow<'_, str>> = words(line).into_iter().map(Cow::Owned).collect();
    is_header(&blanks, true).then(|| blanks.iter().map(|field| Heading::of(field)).collect())
}

/// Names between blanks, each with the unit behind it, `z [nm]` or `z / nm`; a name may stand in quotation marks.
fn words(line: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut rest = line.trim();
    while !rest.is_empty() {
        let quoted = rest.strip_prefix('"').and_then(|open| open.split_once('"'));
        let (word, next) = quoted.unwrap_or_else(|| rest.split_once(char::is_whitespace).unwrap_or((rest, "")));
        rest = next.trim_start();
        let bracketed = word.starts_with(['[', '(', '{']) && word.ends_with([']', ')', '}']);
        match words.last_mut() {
            Some(name) if quoted.is_none() && (bracketed || word == "/" || name.ends_with(" /")) => {
                name.push(' ');
                name.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    words
}

/// The fields of a row of units: words of which one is a unit.
fn units(line: &str, separator: Separator) -> Option<Vec<String>> {
    let split = Split::of(line, separator);
    (split.is_words() && split.has_units()).then(|| split.fields.iter().map(|field| bare(field).to_owned()).collect())
}
