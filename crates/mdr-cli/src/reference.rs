//! `mdr reference`: the certified records.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use mdr_core::text::printable;
use mdr_reference::{Filter, Record, Table, TableFormat};

use crate::error::{Failure, Result, complain};
use crate::files;
use crate::output::{Format, Output};
use crate::table::{CellStyle, cell, render, render_whole, table, text_table};

/// List or export certified reference values, for the tests of other programs.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/reference.txt"))]
pub(crate) struct Reference {
    /// Only the records for which all these terms hold
    #[arg(long, value_name = "EXPR", default_value = "", hide_default_value = true)]
    filter: String,

    /// A small table to copy into a test; without a name, list the tables
    #[arg(long, value_name = "NAME", num_args = 0..=1, conflicts_with_all = ["filter", "generate"])]
    table: Option<Option<String>>,

    /// Write the table as a source file of this language
    #[arg(long, value_enum, requires = "table", conflicts_with_all = ["export", "format"])]
    language: Option<Language>,

    #[arg(long, value_name = "FILE", help = format!("Write the records to a file, as JSON lines (.jsonl) or as a table (.csv); with --table {}", extensions()))]
    export: Option<PathBuf>,

    /// Write the data sets of the certified fits into this folder: what is fitted (.toml) and the curve (.csv)
    #[arg(long, value_name = "DIR", conflicts_with_all = ["filter", "table", "export", "generate"])]
    data_sets: Option<PathBuf>,

    /// Compute all records anew and write the files of the release into this folder
    #[arg(long, value_name = "DIR", conflicts_with_all = ["filter", "export"])]
    generate: Option<PathBuf>,

    /// Write a certificate for each contact whose folds or equilibria are records (JSON lines)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["filter", "table", "export", "generate", "data_sets"])]
    certificates: Option<PathBuf>,

    /// Shape of the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// A language in which a table is written.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Language {
    /// A header of C and C++.
    C,
    /// A module of Fortran.
    Fortran,
    /// A module of Julia.
    Julia,
    /// A module of Python.
    Python,
}

impl Reference {
    /// Writes the records on `out` or into files; whether all could be certified.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        if let Some(folder) = &self.generate {
            return generate(folder, out);
        }
        if let Some(folder) = &self.data_sets {
            return data_sets(folder, out).map(|()| true);
        }
        if let Some(file) = &self.certificates {
            return certificates(file, out);
        }
        match &self.table {
            Some(Some(name)) => return self.table(name, out).map(|()| true),
            Some(None) => return out.text(tables()).map(|()| true),
            None => {}
        }
        let filter: Filter = self.filter.parse().map_err(|error| Failure::refused("--filter", error))?;
        let chosen: Vec<_> = filter.select().collect();
        match &self.export {
            Some(file) => export(file, &chosen, out)?,
            None => self.list(&chosen, out)?,
        }
        Ok(true)
    }

    /// Writes a table on `out` or into a file.
    fn table(&self, name: &str, out: &mut Output<impl std::io::Write>) -> Result<()> {
        let refuse = || Failure::flag("--table", format!("must be one of {}", Table::NAMES.join(", ")), name);
        let table = Table::named(name).ok_or_else(refuse)?;
        if let Some(file) = &self.export {
            return export_table(file, &table, out);
        }
        let format = match (self.language, self.format) {
            (Some(Language::C), _) => TableFormat::C,
            (Some(Language::Python), _) => TableFormat::Python,
            (Some(Language::Fortran), _) => TableFormat::Fortran,
            (Some(Language::Julia), _) => TableFormat::Julia,
            (None, Format::Json) => TableFormat::Json,
            (None, Format::Csv) => TableFormat::Csv,
            (None, Format::Table) => return out.text(table_for_reader(&table)),
        };
        out.text(table.write(format).trim_end())
    }

    fn list(&self, chosen: &[&Record], out: &mut Output<impl std::io::Write>) -> Result<()> {
        match self.format {
            Format::Json | Format::Csv => write(self.format, chosen, out),
            Format::Table if self.filter.trim().is_empty() => out.text(families(chosen)),
            Format::Table => out.text(for_reader(chosen)),
        }
    }
}

/// Writes the records into a folder; whether all could be certified.
fn generate(folder: &Path, out: &mut Output<impl std::io::Write>) -> Result<bool> {
    let records = match mdr_records::generate() {
        Ok(records) => records,
        Err(error) => {
            complain(Failure::refused("--generate", error));
            return Ok(false);
        }
    };
    files::make_folder("--generate", folder)?;
    for (file, content) in records {
        let path = folder.join(file);
        files::write("--generate", &path, &content)?;
        out.text(format_args!("{}: {} records", files::shown(&path), content.lines().count()))?;
    }
    Ok(true)
}

/// Writes the certificates of the records into a file; whether each contact has one.
fn certificates(file: &Path, out: &mut Output<impl std::io::Write>) -> Result<bool> {
    let (lines, without) = match mdr_records::certificates() {
        Ok(certificates) => certificates,
        Err(error) => {
            complain(Failure::refused("--certificates", error));
            return Ok(false);
        }
    };
    files::write("--certificates", file, &lines)?;
    out.text(format_args!("{}: {} certificates", files::shown(file), lines.lines().count()))?;
    without.iter().for_each(|why| complain(format_args!("without a certificate: {}", printable(why))));
    Ok(without.is_empty())
}

/// Writes the data sets into a folder.
fn data_sets(folder: &Path, out: &mut Output<impl std::io::Write>) -> Result<()> {
    const FLAG: &str = "--data-sets";
    files::make_folder(FLAG, folder)?;
    for set in mdr_reference::data_sets() {
        let [fit, curve] = ["toml", "csv"].map(|extension| folder.join(set.name).with_extension(extension));
        files::write(FLAG, &fit, set.fit)?;
        files::write(FLAG, &curve, set.curve)?;
        out.text(format_args!("{}: {} rows, {}", files::shown(&fit), set.rows(), set.level))?;
    }
    Ok(())
}

/// Writes records in the format that the extension of the file names.
fn export(file: &Path, chosen: &[&Record], out: &mut Output<impl std::io::Write>) -> Result<()> {
    let name = file.display().to_string();
    let format = match file.extension().and_then(|extension| extension.to_str()) {
        Some("jsonl") => Format::Json,
        Some("csv") => Format::Csv,
        _ => return Err(Failure::flag("--export", "must end in .jsonl or .csv", &name)),
    };
    files::create("--export", file, |out| write(format, chosen, out))?;
    out.text(format_args!("{}: {} records", files::shown(file), chosen.len()))
}

/// Writes records for a program or a spreadsheet.
fn write(format: Format, chosen: &[&Record], out: &mut Output<impl std::io::Write>) -> Result<()> {
    match format {
        Format::Csv => {
            // Each input has a column of its own behind those of all records.
            let names: BTreeSet<&str> =
                chosen.iter().flat_map(|record| record.inputs.iter().map(|(name, _)| name.as_str())).collect();
            let header = Record::CSV_HEADER.into_iter().map(str::to_owned);
            let header: Vec<String> = header.chain(names.iter().map(|name| format!("input_{name}"))).collect();
            let header: Vec<&str> = header.iter().map(String::as_str).collect();
            let inputs = |record: &Record| {
                let cells = names.iter().map(|name| record.input(name).unwrap_or_default().to_owned());
                cells.collect::<Vec<String>>()
            };
            out.csv(
                &header,
                chosen.iter().map(|record| record.to_csv().into_iter().chain(inputs(record)).collect::<Vec<_>>()),
            )
        }
        _ => out.text(chosen.iter().map(|record| record.to_json()).collect::<Vec<_>>().join("\n")),
    }
}

/// Writes a table in the format that the extension of the file names.
fn export_table(file: &Path, table: &Table, out: &mut Output<impl std::io::Write>) -> Result<()> {
    let name = file.display().to_string();
    let extension = file.extension().and_then(|extension| extension.to_str());
    let format = TableFormat::ALL.into_iter().find(|(_, known)| Some(*known) == extension);
    let (format, _) =
        format.ok_or_else(|| Failure::flag("--export", format_args!("must end in {}", extensions()), &name))?;
    files::write("--export", file, table.write(format))?;
    out.text(format_args!("{}: {} rows", files::shown(file), table.rows().count()))
}

/// The extensions of the files of a table: `.csv, .json … or .jl`.
fn extensions() -> String {
    let all = TableFormat::ALL.map(|(_, extension)| format!(".{extension}"));
    let [others @ .., last] = &all;
    format!("{} or {last}", others.join(", "))
}

/// The list of tables, each with its content.
fn tables() -> String {
    let mut list = table(&["table", "rows", "what it holds"]);
    for known in Table::NAMES.into_iter().filter_map(Table::named) {
        let rows = cell(known.rows().count(), CellStyle::Plain);
        list.add_row([cell(known.name, CellStyle::Strong), rows, cell(known.title, CellStyle::Faint)]);
    }
    format!("{}\n\nTo copy one: mdr reference --table jkr-sphere --export jkr_sphere.h", render(&list))
}

/// The columns of a table with the questions and the right answers.
fn table_for_reader(wanted: &Table) -> String {
    const SHOWN: [&str; 6] = ["id", "status", "contact_radius", "indentation", "force", "tolerance"];
    let header = wanted.header();
    let places: Vec<_> = SHOWN.iter().filter_map(|name| header.iter().position(|known| known == name)).collect();
    let rows = wanted.rows().map(|row| places.iter().map(|&place| row[place].clone()).collect::<Vec<_>>());
    format!("{}\n\n{}. All columns: --format csv", text_table(&SHOWN, rows), wanted.title)
}

/// A condition, of which the size matters.
pub(crate) fn size(condition: f64) -> String {
    if condition < 1e4 { format!("{condition:.2}") } else { format!("{condition:.1e}") }
}

/// How many records there are, by the first part of their ids.
fn families(all: &[&Record]) -> String {
    let mut families: Vec<(&str, &Record, [usize; 4])> = Vec::new();
    for record in all {
        let family = record.id.split('/').next().unwrap_or_default();
        let known = families.iter().position(|(known, ..)| *known == family);
        let place = known.unwrap_or_else(|| {
            families.push((family, record, [0; 4]));
            families.len() - 1
        });
        let counts = &mut families[place].2;
        counts[0] += 1;
        counts[1 + record.difficulty as usize] += 1;
    }
    let mut table = table(&["family", "records", "lower", "average", "higher", "for example"]);
    for (family, example, counts) in &families {
        let numbers = counts.iter().map(|count| cell(count, CellStyle::Plain));
        let row = std::iter::once(cell(family, CellStyle::Strong)).chain(numbers);
        table.add_row(row.chain([cell(&example.id, CellStyle::Faint)]));
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
            cell(&record.id, CellStyle::Plain),
            cell(shortened(record), CellStyle::Strong),
            cell(&record.unit, CellStyle::Faint),
            cell(record.status, CellStyle::Plain),
            cell(condition, CellStyle::Faint),
            cell(record.difficulty, CellStyle::Plain),
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
