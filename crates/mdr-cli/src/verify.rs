//! `mdr verify`: the closed forms against the independent numerical route.

use std::path::PathBuf;

use clap::Args;
use comfy_table::ColumnConstraint;
use mdr_crosscheck::{CheckRow, CheckVerdict, Finding, Level, Options, Shard, VerifyReport};

use crate::error::{Failure, Result};
use crate::flags::{Flag, nearest};
use crate::output::{Format, Output};
use crate::table::{CellStyle, cell, render, table};
use crate::{files, progress};

/// Verify the theory: closed forms against an independent numerical computation, over a grid of cases.
///
/// Each row is a check: how many cases were compared, the worst error found, the error allowed there, and the verdict.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/verify.txt"))]
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
            Format::Json => out.json_lines(report.to_json_lines().trim_end())?,
            Format::Csv => out.csv(&CheckRow::CSV_HEADER, report.rows.iter().map(CheckRow::to_csv))?,
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
        let names = mdr_crosscheck::check_names();
        let Some(name) = self.only.iter().find(|name| !names.contains(&name.as_str())) else {
            return Ok(self.only.clone());
        };
        let why = match nearest(name, names.iter().copied()) {
            Some((meant, true)) => format!("no such check; did you mean `{meant}`?"),
            _ => format!("must be one of {}", names.join(", ")),
        };
        Err(Failure::flag("--only", why, name))
    }

    fn merged(&self) -> Result<VerifyReport> {
        let mut lines = String::new();
        for path in &self.merge {
            let text = mdr::files::argument(path).and_then(mdr::files::text);
            let text = text.map_err(|error| files::of_flag("--merge", path, error))?;
            lines.push_str(&text);
            lines.push('\n');
        }
        VerifyReport::from_json_lines(&lines).map_err(|error| {
            let names: Vec<_> = self.merge.iter().map(|path| path.display().to_string()).collect();
            Failure::flag("--merge", error, &names.join(" "))
        })
    }
}

/// Runs with a progress bar on standard error when that is a terminal.
fn with_progress(options: &Options) -> VerifyReport {
    let bar = progress::bar(0);
    let report = mdr_crosscheck::run(options, &|progress| {
        bar.set_length(progress.total as u64);
        bar.set_position(progress.done as u64);
        bar.set_message(progress.check);
    });
    bar.finish_and_clear();
    report
}

fn for_reader(report: &VerifyReport) -> String {
    let mut table = table(&["check", "cases", "worst error", "allowed", "unit", "verdict", "worst case"]);
    for row in &report.rows {
        let [error, allowed, case] = row.decisive().map(Finding::in_short).unwrap_or_default();
        let tone = match row.verdict {
            CheckVerdict::Pass => CellStyle::Good,
            CheckVerdict::Fail => CellStyle::Bad,
            CheckVerdict::Skipped => CellStyle::Faint,
        };
        table.add_row([
            cell(&row.check, CellStyle::Plain),
            cell(row.cases, CellStyle::Plain),
            cell(error, CellStyle::Plain),
            cell(allowed, CellStyle::Plain),
            cell(row.unit, CellStyle::Faint),
            cell(row.verdict, tone),
            cell(case, CellStyle::Faint),
        ]);
    }
    // The name of a check stays in one piece, to be copied.
    table.set_constraints([ColumnConstraint::ContentWidth]);
    let failures: Vec<_> = report.failures.iter().map(ToString::to_string).collect();
    let mut parts = vec![render(&table), failures.join("\n"), report.units(), report.summary()];
    parts.retain(|part| !part.is_empty());
    parts.join("\n\n")
}
