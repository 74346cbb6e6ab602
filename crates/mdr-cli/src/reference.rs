//! `mdr reference`: the certified records.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use mdr_reference::{Filter, Record};

use crate::error::{Failure, Result};
use crate::output::{Format, Output};
use crate::table::{Tone, cell, render_whole, table};

const EXAMPLES: &str = "\
Examples:
  How many there are, by family:
    mdr reference

  A family:
    mdr reference --filter id~guduru

  The hard questions about power laws under a dead load:
    mdr reference --filter \"profile=power control=force difficulty=higher\"

  One of them, with all that is known about it:
    mdr reference --filter id=critical/jkr-unit/force/force --format json

  For a program in another language: one JSON object a line, or a spreadsheet:
    mdr reference --export records.jsonl
    mdr reference --filter status=ok --export records.csv

A filter has terms key=value, key!=value or key~part, separated by blanks or commas; all must
hold. Keys: id, profile, formula, quantity, unit, control (none where there is none), status,
difficulty (lower, average, higher), flag.
Every number is certified to 50 digits and confirmed by a second method; docs/reference/README.md
describes the fields.
Answers go to `mdr judge`.
Exit status: 0 listed, 1 with --generate, a digit was not certain; 2 bad input, or a filter that
chooses nothing.";

/// List or export certified reference values, for the tests of other programs.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Reference {
    /// Only the records for which all these terms hold
    #[arg(long, value_name = "EXPR", default_value = "", hide_default_value = true)]
    filter: String,

    /// Write the records to a file, as JSON lines (.jsonl) or as a table (.csv)
    #[arg(long, value_name = "FILE")]
    export: Option<PathBuf>,

    /// Compute all records anew and write the files of the release into this folder
    #[arg(long, value_name = "DIR", conflicts_with_all = ["filter", "export"])]
    generate: Option<PathBuf>,

    /// Shape of the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

impl Reference {
    /// Writes the records on `out` or into files; whether all could be certified.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        if let Some(folder) = &self.generate {
            return generate(folder, out);
        }
        let filter: Filter = self.filter.parse().map_err(|error| Failure::refused("--filter", error))?;
        let chosen: Vec<_> = filter.select().collect();
        match &self.export {
            Some(file) => export(file, &chosen, out)?,
            None => self.list(&chosen, out)?,
        }
        Ok(true)
    }

    fn list(&self, chosen: &[&Record], out: &mut Output<impl std::io::Write>) -> Result<()> {
        match self.format {
            Format::Json => out.text(chosen.iter().map(|record| record.to_json()).collect::<Vec<_>>().join("\n")),
            Format::Csv => out.csv(&Record::CSV_HEADER, chosen.iter().map(|record| record.to_csv())),
            Format::Table if self.filter.trim().is_empty() => out.text(families(chosen)),
            Format::Table => out.text(for_reader(chosen)),
        }
    }
}

fn generate(folder: &Path, out: &mut Output<impl std::io::Write>) -> Result<bool> {
    let files = match mdr_records::generate() {
        Ok(files) => files,
        Err(error) => {
            out.text(error)?;
            return Ok(false);
        }
    };
    let name = |path: &Path| format!("--generate {}", path.display());
    fs::create_dir_all(folder).map_err(|error| Failure::file(name(folder), error))?;
    for (file, content) in files {
        let path = folder.join(file);
        fs::write(&path, &content).map_err(|error| Failure::file(name(&path), error))?;
        out.text(format_args!("{}: {} records", path.display(), content.lines().count()))?;
    }
    Ok(true)
}

fn export(file: &Path, chosen: &[&Record], out: &mut Output<impl std::io::Write>) -> Result<()> {
    let name = file.display().to_string();
    let content = match file.extension().and_then(|extension| extension.to_str()) {
        Some("jsonl") => chosen.iter().map(|record| record.to_json() + "\n").collect::<String>().into_bytes(),
        Some("csv") => {
            let mut rows = Output::new(Vec::new());
            rows.csv(&Record::CSV_HEADER, chosen.iter().map(|record| record.to_csv()))?;
            rows.into_inner()
        }
        _ => return Err(Failure::flag("--export", "must end in .jsonl or .csv", &name)),
    };
    fs::write(file, content).map_err(|error| Failure::file(format!("--export {name}"), error))?;
    out.text(format_args!("{name}: {} records", chosen.len()))
}

/// A condition, of which the size matters.
pub(crate) fn size(condition: f64) -> String {
    if condition < 1e4 { format!("{condition:.2}") } else { format!("{condition:.1e}") }
}

/// How many records there are, by the first part of their ids.
fn families(all: &[&Record]) -> String {
    let mut counts: Vec<(&str, [usize; 4])> = Vec::new();
    for record in all {
        let family = record.id.split('/').next().unwrap_or_default();
        if counts.last().is_none_or(|(last, _)| *last != family) && !counts.iter().any(|(known, _)| *known == family) {
            counts.push((family, [0; 4]));
        }
        let Some((_, counts)) = counts.iter_mut().find(|(known, _)| *known == family) else { continue };
        counts[0] += 1;
        counts[1 + record.difficulty as usize] += 1;
    }
    let mut table = table(&["family", "records", "lower", "average", "higher", "for example"]);
    for (family, counts) in &counts {
        let example = all.iter().find(|record| record.id.starts_with(&format!("{family}/")));
        let numbers = counts.iter().map(|count| cell(count, Tone::Plain));
        let row = std::iter::once(cell(family, Tone::Strong)).chain(numbers);
        table.add_row(row.chain([cell(example.map_or("", |record| record.id.as_str()), Tone::Faint)]));
    }
    format!(
        "{}\n\n{} records of 50 certified digits, by difficulty. List some: mdr reference --filter \"id~jkr-unit\"",
        render_whole(&table),
        all.len()
    )
}

/// Digits of a value in the table.
const SHOWN: usize = 20;

fn for_reader(chosen: &[&Record]) -> String {
    let mut table = table(&["id", "value", "unit", "status", "condition", "difficulty"]);
    for record in chosen {
        let condition = if record.condition.is_empty() { String::new() } else { size(record.total_condition()) };
        table.add_row([
            cell(&record.id, Tone::Plain),
            cell(shortened(record), Tone::Strong),
            cell(&record.unit, Tone::Faint),
            cell(record.status, Tone::Plain),
            cell(condition, Tone::Faint),
            cell(record.difficulty, Tone::Plain),
        ]);
    }
    format!("{}\n\n{} of {} records", render_whole(&table), chosen.len(), mdr_reference::records().len())
}

/// The first digits, with an ellipsis where there are more.
fn shortened(record: &Record) -> String {
    let Some(value) = &record.value else { return String::new() };
    let (mantissa, exponent) = value.mid.split_at(value.mid.find('e').unwrap_or(value.mid.len()));
    match mantissa.char_indices().nth(SHOWN + 2) {
        Some((end, _)) => format!("{}…{exponent}", &mantissa[..end]),
        None => value.mid.clone(),
    }
}
