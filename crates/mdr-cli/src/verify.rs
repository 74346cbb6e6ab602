//! `mdr verify`: the closed forms against the independent numerical route.

use std::path::PathBuf;

use clap::Args;
use comfy_table::ColumnConstraint;
use indicatif::{ProgressBar, ProgressStyle};
use mdr_crosscheck::{Level, Options, Report, Row, Shard, Unit, Verdict};

use crate::error::{Failure, Result};
use crate::flags::{Flag, likely};
use crate::output::{Format, Output};
use crate::short;
use crate::table::{Tone, cell, render, table};

const EXAMPLES: &str = "\
Examples:
  The whole grid, with a table of the results:
    mdr verify

  In under a minute, or in half an hour with many more cases:
    mdr verify --quick
    mdr verify --full

  Two checks alone, by the names in the table:
    mdr verify --only kappa-gamma,jkr

  At 200 digits, with another seed for the random part of the grid:
    mdr verify --digits 200 --seed 7

  Over four processes or machines, then the verdict on the whole:
    mdr verify --full --shard 1/4 --format json > 1.jsonl
    mdr verify --full --shard 2/4 --format json > 2.jsonl    # and so on
    mdr verify --merge 1.jsonl 2.jsonl 3.jsonl 4.jsonl

A run is a pure function of level, digits, seed and shard. The allowed errors are derived from
error bounds and condition numbers, never from what was found.
JSON: schema mdr.verify/1, one line a check and one a failing case; the lines of shards
concatenate.
Exit status: 0 all checks hold, 1 a check failed, 2 bad input.";

/// Verify the theory: closed forms against an independent numerical computation, over a grid of cases.
///
/// Each row is a check: how many cases were compared, the worst error found, the error allowed there, and the verdict.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Verify {
    /// Fewer cases: under a minute
    #[arg(long, conflicts_with = "full")]
    quick: bool,

    /// More cases: half an hour
    #[arg(long)]
    full: bool,

    /// Decimal digits of the arbitrary-precision cases [default: 50]
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    digits: Option<String>,

    /// Part I of N parts of the grid, from 1/N to N/N
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    shard: Option<String>,

    /// Seed of the random part of the grid [default: 0]
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    seed: Option<String>,

    /// Only the checks of these names, separated by commas
    #[arg(long, value_name = "CHECK", value_delimiter = ',', allow_hyphen_values = true)]
    only: Vec<String>,

    /// Judge the JSON lines of all shards of a run instead of running
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["quick", "full", "digits", "shard", "seed", "only"])]
    merge: Vec<PathBuf>,

    /// Shape of the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// The digits beyond which a run would take days.
const MAX_DIGITS: u32 = 2_000;

impl Verify {
    /// Writes the result on `out`; whether every check holds.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        let report = if self.merge.is_empty() { with_progress(&self.options()?) } else { self.merged()? };
        match self.format {
            Format::Json => out.text(report.to_json_lines().trim_end())?,
            Format::Csv => out.csv(&Row::CSV_HEADER, report.rows.iter().map(Row::to_csv))?,
            Format::Table => out.text(for_reader(&report))?,
        }
        Ok(report.passed())
    }

    fn options(&self) -> Result<Options> {
        let level = match (self.quick, self.full) {
            (true, _) => Level::Quick,
            (_, true) => Level::Full,
            _ => Level::Default,
        };
        let mut options = Options::at(level);
        if let Some(text) = &self.digits {
            options.digits = Flag::new("--digits", text).whole(1, MAX_DIGITS)?;
        }
        if let Some(text) = &self.seed {
            options.seed = Flag::new("--seed", text).seed()?;
        }
        if let Some(text) = &self.shard {
            let flag = Flag::new("--shard", text);
            options.shard = text.parse::<Shard>().map_err(|_| flag.refuse("must be I/N with 1 <= I <= N"))?;
        }
        options.only = self.only()?;
        Ok(options)
    }

    fn only(&self) -> Result<Vec<String>> {
        if self.only.is_empty() {
            return Ok(Vec::new());
        }
        // A run without cases tells the names of the checks.
        let nothing = mdr_crosscheck::run(&Options { limit: Some(0), ..Options::default() }, &|_| ());
        let names: Vec<_> = nothing.rows.iter().map(|row| row.check.as_str()).collect();
        match self.only.iter().find(|name| !names.contains(&name.as_str())) {
            Some(name) => Err(match likely(name, names.iter().copied()) {
                Some(meant) => Failure::flag("--only", format_args!("no such check; did you mean `{meant}`?"), name),
                None => Failure::flag("--only", format_args!("must be one of {}", names.join(", ")), name),
            }),
            None => Ok(self.only.clone()),
        }
    }

    fn merged(&self) -> Result<Report> {
        let mut lines = String::new();
        for path in &self.merge {
            let name = path.display().to_string();
            let text =
                std::fs::read_to_string(path).map_err(|error| Failure::file(format!("--merge {name}"), error))?;
            lines.push_str(&text);
            lines.push('\n');
        }
        Report::from_json_lines(&lines).map_err(|error| {
            let names: Vec<_> = self.merge.iter().map(|path| path.display().to_string()).collect();
            Failure::flag("--merge", error, &names.join(" "))
        })
    }
}

/// Runs with a progress bar on standard error when that is a terminal.
fn with_progress(options: &Options) -> Report {
    let style = ProgressStyle::with_template("{bar:40.green} {percent:>3} %  {elapsed} / {duration}  {msg}");
    let bar = ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let report = mdr_crosscheck::run(options, &|progress| {
        bar.set_length(progress.total as u64);
        bar.set_position(progress.done as u64);
        bar.set_message(progress.check);
    });
    bar.finish_and_clear();
    report
}

fn for_reader(report: &Report) -> String {
    let mut table = table(&["check", "cases", "worst error", "allowed", "unit", "verdict", "worst case"]);
    for row in &report.rows {
        let worst = row.decisive();
        let tone = match row.verdict {
            Verdict::Pass => Tone::Good,
            Verdict::Fail => Tone::Bad,
            Verdict::Skipped => Tone::Faint,
        };
        table.add_row([
            cell(&row.check, Tone::Plain),
            cell(row.cases, Tone::Plain),
            cell(worst.map(|finding| significant(finding.error)).unwrap_or_default(), Tone::Plain),
            cell(worst.map(|finding| significant(finding.allowed)).unwrap_or_default(), Tone::Plain),
            cell(row.unit, Tone::Faint),
            cell(row.verdict, tone),
            cell(
                worst
                    .map(|finding| format!("{}: {}", finding.quantity, short::numbers(&finding.inputs)))
                    .unwrap_or_default(),
                Tone::Faint,
            ),
        ]);
    }
    // The name of a check stays in one piece, to be copied.
    table.set_constraints([ColumnConstraint::ContentWidth]);
    let failures: Vec<_> = report
        .failures
        .iter()
        .map(|failure| format!("\n{} #{}: {}\n  {}", failure.check, failure.index, failure.inputs, failure.reason))
        .collect();
    let parts = [&render(&table), &failures.concat(), &units(report), &report.summary()];
    parts
        .map(|part| part.trim_matches('\n'))
        .into_iter()
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join("\n\n")
}

/// Three digits are enough for an error.
fn significant(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        1e-2..1e4 => format!("{value:.3}"),
        _ => format!("{value:.2e}"),
    }
}

/// What the units of the table mean.
fn units(report: &Report) -> String {
    let is_used = |unit: &Unit| report.rows.iter().any(|row| row.unit == *unit);
    let lines =
        Unit::ALL.into_iter().filter(is_used).map(|unit| format!("  {:<8}  {}", unit.to_string(), unit.description()));
    format!(
        "Units of the errors; the numbers of a case are rounded here, and exact in JSON and CSV:\n{}",
        lines.collect::<Vec<_>>().join("\n")
    )
}
