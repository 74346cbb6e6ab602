//! `mdr cite`: what to cite for an answer.

mod works;

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::{BufRead, Write};
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use mdr_reference::records;
use serde::Serialize;
use serde_json::Value;

use crate::error::{Failure, Result};
use crate::files;
use crate::output::Output;
use works::{POPOV, Work};

/// Print what to cite: the program with its version, the release of its records, the theory, and the sources of an answer.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/cite.txt"))]
pub(crate) struct Cite {
    /// An answer as JSON, or records; - for standard input
    #[arg(value_name = "ANSWER.json")]
    answer: Option<PathBuf>,

    /// Shape of the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

/// The shape of a citation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Sentences for a reader
    Text,
    /// Entries of a bibliography
    Bibtex,
    /// One object, mdr.cite/1
    Json,
}

/// The program; the repository's CITATION.cff has the same words.
#[derive(Debug, Serialize)]
struct Program {
    title: &'static str,
    version: &'static str,
    /// Where it is known; `+` stands for changes that are in no commit.
    #[serde(skip_serializing_if = "Option::is_none")]
    commit: Option<&'static str>,
    authors: [&'static str; 1],
    license: &'static str,
    /// Until one is assigned there is none.
    doi: Option<&'static str>,
}

const PROGRAM: Program = Program {
    title: "mdr: reference software for adhesion instabilities of axisymmetric contacts",
    version: env!("CARGO_PKG_VERSION"),
    commit: mdr_provenance::COMMIT,
    authors: ["the mdr developers"],
    license: env!("CARGO_PKG_LICENSE"),
    doi: None,
};

/// The certified records that this program carries.
#[derive(Debug, Serialize)]
struct Records {
    title: &'static str,
    release: u32,
    license: &'static str,
}

/// What an answer says of itself. Lines that say the same are one.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize)]
struct Answer {
    schema: String,
    /// Release and commit of the program that gave it.
    #[serde(skip_serializing_if = "Option::is_none")]
    program: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    arithmetic: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    digits: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    profile: Option<String>,
}

#[derive(Debug, Serialize)]
struct Citation {
    schema: &'static str,
    program: Program,
    records: Records,
    answers: Vec<Answer>,
    works: Vec<&'static Work>,
}

impl Cite {
    /// Writes the citation on `out`.
    pub(crate) fn run(&self, out: &mut Output<impl Write>) -> Result<()> {
        let (mut answers, mut works) = (BTreeSet::new(), vec![&POPOV]);
        if let Some(file) = &self.answer {
            let name = file.display().to_string();
            for (line, text) in (1..).zip(files::open(file)?.lines()) {
                let text = text.map_err(|error| Failure::file(&name, error))?;
                if text.trim().is_empty() {
                    continue;
                }
                let refuse = |why: &str| {
                    let why = format!("line {line} is no answer of mdr: {why}; answers are printed by --format json");
                    Failure::refused("ANSWER.json", format_args!("{name}: {why}"))
                };
                let value: Value = serde_json::from_str(&text).map_err(|error| refuse(&error.to_string()))?;
                answers.insert(answer(&value).ok_or_else(|| refuse("it has no schema"))?);
                for work in works::of(&value) {
                    if !works.contains(&work) {
                        works.push(work);
                    }
                }
            }
            if answers.is_empty() {
                return Err(Failure::refused("ANSWER.json", format_args!("{name}: there is no answer in it")));
            }
        }
        let release = records().iter().map(|record| record.release).max().unwrap_or_default();
        let records =
            Records { title: "Certified reference values of adhesive contact mechanics", release, license: "CC0-1.0" };
        let answers = answers.into_iter().collect();
        let citation = Citation { schema: "mdr.cite/1", program: PROGRAM, records, answers, works };
        match self.format {
            Format::Text => out.text(citation.text().trim_end()),
            Format::Bibtex => out.text(citation.bibtex().trim_end()),
            // The key `program` is the work to be cited here, with its commit.
            Format::Json => out.text(serde_json::to_string(&citation).unwrap_or_default()),
        }
    }
}

/// What a line says of itself: an answer by its schema, a record by its release.
fn answer(value: &Value) -> Option<Answer> {
    let text = |key: &str| value.get(key).and_then(Value::as_str).map(str::to_owned);
    let record = || value.get("id").and(value.get("release")).and_then(Value::as_u64);
    let schema = match text("schema") {
        Some(schema) => schema,
        None => format!("record of release {}", record()?),
    };
    let digits = value.get("digits").and_then(Value::as_u64);
    Some(Answer { schema, program: text("program"), arithmetic: text("arithmetic"), digits, profile: text("profile") })
}

impl Answer {
    fn text(&self) -> String {
        let digits = self.digits.map(|digits| format!("{digits} digits"));
        let profile = self.profile.as_ref().map(|profile| format!("profile {profile}"));
        let program = self.program.as_ref().map(|program| format!("by {program}"));
        let parts = [Some(self.schema.clone()), self.arithmetic.clone(), digits, profile, program];
        parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
    }
}

impl Citation {
    fn text(&self) -> String {
        let Citation { program, records, .. } = self;
        let mut text = format!("{}. {}, version {}.", program.authors.join(", "), program.title, program.version);
        text += &program.doi.map_or(" No DOI is assigned yet.".to_owned(), |doi| format!(" https://doi.org/{doi}"));
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "\n{}. {}, release {} ({}), in the same program.",
            program.authors.join(", "),
            records.title,
            records.release,
            records.license
        );
        for answer in &self.answers {
            let _ = writeln!(text, "Answer: {}.", answer.text());
        }
        for work in &self.works {
            let _ = writeln!(text, "{}: {}", work.why, work.text());
        }
        text
    }

    fn bibtex(&self) -> String {
        let Citation { program, records, .. } = self;
        let mut note = format!("certified reference values: release {}", records.release);
        for answer in &self.answers {
            let _ = write!(note, "; answer: {}", answer.text());
        }
        let doi =
            program.doi.map_or("  % doi: none is assigned yet\n".to_owned(), |doi| format!("  doi = {{{doi}}},\n"));
        let mut text = format!(
            "@software{{mdr,\n  author = {{{{{}}}}},\n  title = {{{{{}}}}},\n  version = {{{}}},\n{doi}  note = {{{note}}},\n}}\n",
            program.authors.join(" and "),
            program.title,
            program.version,
        );
        for work in &self.works {
            text.push('\n');
            text += &work.bibtex();
        }
        text
    }
}
