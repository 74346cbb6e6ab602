//! `--batch`: many questions, one a line, CSV or JSON lines.

use std::collections::BTreeMap;
use std::io::{self, BufRead, BufReader, BufWriter, ErrorKind, Read, Write};
use std::path::Path;

use mdr::critical::{CriticalAnswer, CriticalRow, PowerLaw};
use mdr::prelude::Arithmetic;
use mdr_core::text::excerpt;
use serde::Serialize;
use serde_json::value::RawValue;

use crate::error::{Failure, Result};
use crate::files;
use crate::output::Output;

/// Answers every line of the file in its format; whether all have an answer. A refused line says so in its place.
pub(super) fn answer(file: &Path, arithmetic: Arithmetic, out: &mut Output<impl Write>) -> Result<bool> {
    let mut input = files::open(file)?;
    let failed = |error: io::Error| files::of_flag("", file, error);
    let start = input.fill_buf().map_err(failed)?;
    // Some programs begin a file with a byte order mark.
    let mark = if start.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 };
    let is_json = start[mark..].iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'{');
    input.consume(mark);
    let input = Lines { from: input, length: 0 };
    match is_json {
        true => json_lines(BufReader::new(input), arithmetic, out, &failed),
        false => csv(input, arithmetic, out, &failed),
    }
}

/// The longest line of a batch: 1 MiB.
const LONGEST: usize = 1 << 20;

/// A reader that ends with an error at a line that is too long.
struct Lines<R> {
    from: R,
    /// The bytes of the line so far.
    length: usize,
}

impl<R: Read> Read for Lines<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let read = self.from.read(bytes)?;
        let mut parts = bytes[..read].split(|byte| *byte == b'\n').map(<[u8]>::len);
        let mut longest = self.length + parts.next().unwrap_or(0);
        self.length = longest;
        for part in parts {
            self.length = part;
            longest = longest.max(part);
        }
        match longest > LONGEST {
            true => Err(io::Error::new(
                ErrorKind::InvalidData,
                format!("a line is longer than {LONGEST} bytes: no question"),
            )),
            false => Ok(read),
        }
    }
}

/// An answer that cannot be written.
fn unwritten(error: impl Into<io::Error>) -> Failure {
    Failure::file("standard output", error)
}

fn json_lines(
    input: impl BufRead,
    arithmetic: Arithmetic,
    out: &mut Output<impl Write>,
    failed: &impl Fn(io::Error) -> Failure,
) -> Result<bool> {
    let mut out = BufWriter::new(out);
    let mut all = true;
    for line in input.lines() {
        let line = line.map_err(failed)?;
        if line.trim().is_empty() {
            continue;
        }
        let given: serde_json::Result<BTreeMap<String, Box<RawValue>>> = serde_json::from_str(&line);
        let given = given.map_err(|error| excerpt(&error.to_string()).to_string());
        // A number as it is written, a text without its quotation marks and escapes.
        let plain = |value: &RawValue| serde_json::from_str(value.get()).unwrap_or_else(|_| value.get().to_owned());
        let given = given.map(|given| {
            given.iter().map(|(key, value)| (key.clone(), plain(value))).collect::<BTreeMap<String, String>>()
        });
        let answer = given.and_then(|given| {
            let text = |key: &str| given.get(key).map(String::as_str);
            if let Some(unknown) = given.keys().find(|key| !PowerLaw::KEYS.contains(&key.as_str())) {
                let (unknown, known) = (excerpt(unknown), PowerLaw::KEYS.join("`, `"));
                return Err(format!("unknown key `{unknown}`; expected one of `{known}`"));
            }
            ask(text, arithmetic)
        });
        all &= answer.is_ok();
        let line = match &answer {
            Ok(answer) => serde_json::to_string(answer),
            Err(why) => serde_json::to_string(&Refused { schema: "mdr.critical/1", status: "domain-error", why }),
        };
        writeln!(out, "{}", mdr_provenance::json(&line.map_err(unwritten)?)).map_err(unwritten)?;
    }
    out.flush().map(|()| all).map_err(unwritten)
}

fn csv(
    input: impl Read,
    arithmetic: Arithmetic,
    out: &mut Output<impl Write>,
    failed: &impl Fn(io::Error) -> Failure,
) -> Result<bool> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(input);
    let unread = |error: csv::Error| failed(error.into());
    let header = reader.headers().map_err(unread)?.clone();
    if let Some(unknown) = header.iter().find(|key| !PowerLaw::KEYS.contains(key)) {
        let (unknown, known) = (excerpt(unknown), PowerLaw::KEYS.join("`, `"));
        let why = format!("unknown column `{unknown}`; expected some of `{known}`");
        return Err(failed(io::Error::new(ErrorKind::InvalidData, why)));
    }
    let mut writer = csv::Writer::from_writer(BufWriter::new(out));
    writer.write_record(CriticalRow::COLUMNS.into_iter().chain(["why"])).map_err(unwritten)?;
    let mut record = csv::StringRecord::new();
    let mut all = true;
    while reader.read_record(&mut record).map_err(unread)? {
        let text = |key: &str| {
            let column = header.iter().position(|name| name == key)?;
            record.get(column).filter(|text| !text.is_empty())
        };
        let answer = ask(text, arithmetic);
        all &= answer.is_ok();
        match answer {
            Ok(answer) => {
                for row in answer.rows() {
                    writer.write_record(row.0.iter().map(String::as_str).chain([""])).map_err(unwritten)?;
                }
            }
            Err(why) => {
                let cell = |title| match title {
                    "status" => "domain-error".to_owned(),
                    title => excerpt(text(title).unwrap_or_default()).to_string(),
                };
                writer.write_record(CriticalRow::COLUMNS.map(cell).into_iter().chain([why])).map_err(unwritten)?;
            }
        }
    }
    writer.flush().map(|()| all).map_err(unwritten)
}

/// The answer to the question of one line, or why it has none.
fn ask<'a>(
    text: impl Fn(&str) -> Option<&'a str>,
    arithmetic: Arithmetic,
) -> std::result::Result<CriticalAnswer, String> {
    let answer = PowerLaw::from_keys(text).and_then(|law| mdr::critical(&law, arithmetic));
    answer.map_err(|error| error.to_string())
}

/// A line that is no question.
#[derive(Serialize)]
struct Refused<'a> {
    schema: &'static str,
    status: &'static str,
    why: &'a str,
}
