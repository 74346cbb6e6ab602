//! Lines of answers: JSON, `id value`, and CSV.

use crate::judge::answer::Answer;
use crate::record::Status;
use crate::text::excerpt;

/// What a line should be.
pub(crate) const EXPECTED: &str =
    "a line is {\"id\": …, \"value\": …}, or an id and its value between blanks, tabs, commas or semicolons";

/// The fields of a line without braces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Field {
    Id,
    Value,
    Error,
    Status,
    /// A column that no answer has.
    Other,
}

/// The fields of a line where no header names them.
pub(crate) const PLAIN: [Field; 4] = [Field::Id, Field::Value, Field::Error, Field::Status];

/// A line that is not empty.
pub(crate) enum Line {
    /// The identifier of a question and the answer.
    Answer(String, Answer),
    /// The header of CSV.
    Header(Vec<Field>),
    /// A comment, which begins with #.
    Comment,
}

/// Reads a line: an object of JSON, or fields in the order of the header, which a first line may be.
///
/// # Errors
/// A message about the fault of the line, and what a line should be.
pub(crate) fn read(line: &str, fields: &[Field], may_be_header: bool) -> Result<Line, String> {
    let line = line.trim();
    let found = match line.chars().next() {
        Some('{' | '[') => Answer::from_json(line).map(|(id, answer)| Line::Answer(id, answer)),
        Some('#') => return Ok(Line::Comment),
        _ => {
            let cells = cells(line);
            match header(&cells).filter(|_| may_be_header) {
                Some(header) => return Ok(Line::Header(header)),
                None => plain(&cells, fields).map(|(id, answer)| Line::Answer(id, answer)),
            }
        }
    };
    found.map_err(|why| format!("{why}; {EXPECTED}"))
}

/// Between tabs, semicolons, commas or blanks, without quotation marks around them.
fn cells(line: &str) -> Vec<&str> {
    match ['\t', ';', ','].into_iter().find(|mark| line.contains(*mark)) {
        Some(mark) => line.split(mark).map(|cell| cell.trim().trim_matches('"').trim()).collect(),
        None => line.split_whitespace().map(|cell| cell.trim_matches('"')).collect(),
    }
}

/// The fields that a header names, if it has an id and a value or a status.
fn header(cells: &[&str]) -> Option<Vec<Field>> {
    let field = |cell: &&str| match cell.to_ascii_lowercase().as_str() {
        "id" => Field::Id,
        "value" => Field::Value,
        "error" => Field::Error,
        "status" => Field::Status,
        _ => Field::Other,
    };
    let fields: Vec<Field> = cells.iter().map(field).collect();
    let has = |field: Field| fields.iter().filter(|known| **known == field).count() == 1;
    (has(Field::Id) && (has(Field::Value) || has(Field::Status))).then_some(fields)
}

/// The answer of a line without braces. In the place of the value there may be a status.
fn plain(cells: &[&str], fields: &[Field]) -> Result<(String, Answer), String> {
    if cells.len() > fields.len() {
        let found = excerpt(&cells.join(" "));
        return Err(format!("{} fields where {} may be, {found}", cells.len(), fields.len()));
    }
    let cell = |field: Field| {
        let place = fields.iter().position(|known| *known == field)?;
        cells.get(place).copied().filter(|cell| !cell.is_empty())
    };
    let id = cell(Field::Id).ok_or("there is no id")?;
    let (mut value, mut status) = (cell(Field::Value), cell(Field::Status));
    if status.is_none() && value.is_some_and(|value| value.parse::<Status>().is_ok()) {
        (value, status) = (None, value);
    }
    if value.is_none() && status.is_none() {
        return Err(format!("there is neither a value nor a status beside {}", excerpt(id)));
    }
    Ok((id.to_owned(), Answer::of_texts(value, cell(Field::Error), status)?))
}
