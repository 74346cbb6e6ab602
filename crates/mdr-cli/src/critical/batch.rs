//! `--batch`: many questions, one a line, CSV or JSON lines.

use std::collections::BTreeMap;
use std::io::{BufRead, BufWriter, Read, Write};
use std::path::Path;

use mdr::critical::{CriticalAnswer, CriticalRow, PowerLaw};
use mdr::prelude::Arithmetic;
use serde::Serialize;
use serde_json::value::RawValue;

use crate::error::Result;
use crate::files;
use crate::output::Output;

/// Answers every line of the file in its format; whether all have an answer. A refused line says so in its place.
pub(super) fn answer(file: &Path, arithmetic: Arithmetic, out: &mut Output<impl Write>) -> Result<bool> {
    let failed = |error| files::of_flag("", file, error);
    let mut input = files::open(file)?;
    let start = input.fill_buf().map_err(failed)?;
    let is_json = start.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'{');
    let all = if is_json { json_lines(input, arithmetic, out) } else { csv(input, arithmetic, out) };
    all.map_err(failed)
}

fn json_lines(input: impl BufRead, arithmetic: Arithmetic, out: &mut Output<impl Write>) -> std::io::Result<bool> {
    let mut out = BufWriter::new(out);
    let mut all = true;
    for line in input.lines() {
        let line = line?;
        if line.trim().is_empty() {
            continue;
        }
        let given: serde_json::Result<BTreeMap<String, Box<RawValue>>> = serde_json::from_str(&line);
        let answer = given.map_err(|error| error.to_string()).and_then(|given| {
            let text = |key: &str| given.get(key).map(|value| value.get().trim_matches('"'));
            if let Some(unknown) = given.keys().find(|key| !PowerLaw::KEYS.contains(&key.as_str())) {
                return Err(format!("unknown key `{unknown}`; expected one of `{}`", PowerLaw::KEYS.join("`, `")));
            }
            ask(text, arithmetic)
        });
        all &= answer.is_ok();
        match &answer {
            Ok(answer) => serde_json::to_writer(&mut out, answer)?,
            Err(why) => {
                serde_json::to_writer(&mut out, &Refused { schema: "mdr.critical/1", status: "domain-error", why })?
            }
        }
        out.write_all(b"\n")?;
    }
    out.flush().map(|()| all)
}

fn csv(input: impl Read, arithmetic: Arithmetic, out: &mut Output<impl Write>) -> std::io::Result<bool> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(input);
    let header = reader.headers()?.clone();
    if let Some(unknown) = header.iter().find(|key| !PowerLaw::KEYS.contains(key)) {
        let why = format!("unknown column `{unknown}`; expected some of `{}`", PowerLaw::KEYS.join("`, `"));
        return Err(std::io::Error::new(std::io::ErrorKind::InvalidData, why));
    }
    let mut writer = csv::Writer::from_writer(BufWriter::new(out));
    writer.write_record(CriticalRow::COLUMNS.into_iter().chain(["why"]))?;
    let mut record = csv::StringRecord::new();
    let mut all = true;
    while reader.read_record(&mut record)? {
        let text = |key: &str| {
            let column = header.iter().position(|name| name == key)?;
            record.get(column).filter(|text| !text.is_empty())
        };
        let answer = ask(text, arithmetic);
        all &= answer.is_ok();
        match answer {
            Ok(answer) => {
                for row in answer.rows() {
                    writer.write_record(row.0.iter().map(String::as_str).chain([""]))?;
                }
            }
            Err(why) => {
                let cell = |title| if title == "status" { "domain-error" } else { text(title).unwrap_or_default() };
                writer.write_record(CriticalRow::COLUMNS.map(cell).into_iter().chain([why.as_str()]))?;
            }
        }
    }
    writer.flush().map(|()| all)
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
