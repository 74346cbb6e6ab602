//! `mdr report`: error against run time, and stability, on one page.

mod footer;

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use mdr_crosscheck::findings::LadderRow;
use mdr_crosscheck::ladders::Ladder;
use mdr_crosscheck::work_precision::{Clock, Comparison, Point, Series};
use mdr_crosscheck::{Findings, Level};
use mdr_plot::{Method, Question};
use serde::Serialize;

use crate::error::{Failure, Result};
use crate::output::{Format, Output};
use crate::table::{Tone, cell};

const EXAMPLES: &str = "\
Examples:
  Everything, into the directory report: a few minutes:
    mdr report

  In less than a minute, into another directory, which is made when it is not there:
    mdr report --quick --out /tmp/report

Files: README.md shows both parts, kappa.svg, transform.svg, fold.svg and digits.svg draw error
against run time or time against digits, work-precision.csv has every answer, ladders.csv every
stability ladder. Errors are those of the answers against an enclosure of the exact result that
shares no code with any method; times are medians of repeated runs.
CSV: the rows of work-precision.csv. JSON: schema mdr.report/3, one line a question or a ladder.
Exit status: 0 all files are written, 2 bad input or a file that cannot be written.";

/// Report error against run time, and how errors grow while questions become hard: pictures, tables and data.
///
/// Methods of this workspace and of textbooks answer the same questions with growing effort: closed forms, quadratures,
/// searches, springs, in double, arbitrary and certified precision.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Report {
    /// Directory of the files
    #[arg(long, value_name = "DIR", default_value = "report")]
    out: PathBuf,

    /// Less effort and fewer runs: less than a minute
    #[arg(long)]
    quick: bool,

    /// Shape of the result on standard output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

impl Report {
    /// Writes the files, and what is in them on `out`.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        let directory = self.out.display();
        std::fs::create_dir_all(&self.out).map_err(|error| Failure::file(format!("--out {directory}"), error))?;
        let (level, runs) = if self.quick { (Level::Quick, 3) } else { (Level::Full, 9) };
        let findings = find(level, runs)?;
        for (task, comparisons) in &findings.tasks {
            let questions: Vec<_> = comparisons.iter().map(question).collect();
            self.write(&format!("{}.svg", task.name), &mdr_plot::comparison(task.title, &questions).svg())?;
        }
        self.write("work-precision.csv", &csv(findings.comparisons().flat_map(Comparison::rows))?)?;
        self.write("ladders.csv", &csv(findings.ladders.iter().map(Ladder::row))?)?;
        let command = if self.quick { "mdr report --quick" } else { "mdr report" };
        let origin =
            format!("    {command}\n\nMedians of {runs} runs, fewer where an answer takes long. {}", footer::machine());
        self.write("README.md", &findings.page(&origin))?;
        self.print(&findings, out)?;
        Ok(true)
    }

    /// Writes one file.
    fn write(&self, name: &str, text: &str) -> Result<()> {
        let path = self.out.join(name);
        std::fs::write(&path, text).map_err(|error| Failure::file(path.display().to_string(), error))
    }

    fn print(&self, findings: &Findings, out: &mut Output<impl std::io::Write>) -> Result<()> {
        match self.format {
            Format::Json => {
                let line = || Line { schema: "mdr.report/3", comparison: None, ladder: None };
                for comparison in findings.comparisons() {
                    out.json(&Line { comparison: Some(comparison), ..line() })?;
                }
                for ladder in &findings.ladders {
                    out.json(&Line { ladder: Some(ladder.row()), ..line() })?;
                }
                Ok(())
            }
            Format::Csv => out.text(csv(findings.comparisons().flat_map(Comparison::rows))?.trim_end()),
            Format::Table => {
                let mut table =
                    crate::table::table(&["question", "methods", "most digits", "no answer", "what is asked"]);
                for comparison in findings.comparisons() {
                    let points = || comparison.series.iter().flat_map(|series| &series.points);
                    let digits = points().filter_map(|point| point.outcome.digits()).fold(f64::NAN, f64::max);
                    let failed = points().filter(|point| point.outcome.digits().is_none()).count();
                    table.add_row([
                        cell(&comparison.id, Tone::Good),
                        cell(comparison.series.len(), Tone::Plain),
                        cell(format_args!("{digits:.1}"), Tone::Plain),
                        cell(failed, Tone::Plain),
                        cell(&comparison.title, Tone::Plain),
                    ]);
                }
                let open = findings.ladders.iter().filter(|ladder| !ladder.accepted()).count();
                let page = self.out.join("README.md");
                let (table, count) = (crate::table::render(&table), findings.ladders.len());
                out.text(format_args!(
                    "{table}\n\n{count} ladders, {open} not accepted\n\nThe page: {}",
                    page.display()
                ))
            }
        }
    }
}

/// A line of JSON: a question or a ladder.
#[derive(Serialize)]
struct Line<'a> {
    schema: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    comparison: Option<&'a Comparison>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ladder: Option<LadderRow<'a>>,
}

/// Asks everything, with a bar on standard error.
fn find(level: Level, runs: usize) -> Result<Findings> {
    let style = ProgressStyle::with_template("{bar:40.green} {pos} of {len}  {msg}  {elapsed}");
    let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(Findings::PARTS as u64).with_style(style);
    bar.enable_steady_tick(Duration::from_millis(500));
    let mut done = 0..;
    let findings = Findings::new(level, Clock::Runs(runs), |part| {
        bar.set_message(part);
        bar.set_position(done.next().unwrap_or_default());
    });
    bar.finish_and_clear();
    Ok(findings?)
}

/// What is drawn of a question: the answers with a time.
fn question(comparison: &Comparison) -> Question<'_> {
    let answer = |point: &Point| Some((point.seconds?, point.outcome.digits()));
    let method = |series: &Series| Method {
        name: series.method,
        textbook: !series.ours,
        answers: series.points.iter().filter_map(answer).collect(),
    };
    let (title, attainable) = (&comparison.title, comparison.attainable);
    Question { title, attainable, methods: comparison.series.iter().map(method).collect() }
}

/// A header and rows.
fn csv<T: Serialize>(rows: impl IntoIterator<Item = T>) -> Result<String> {
    let failed = |error: csv::Error| Failure::file("csv", std::io::Error::from(error));
    let mut csv = csv::Writer::from_writer(Vec::new());
    for row in rows {
        csv.serialize(row).map_err(failed)?;
    }
    let bytes = csv.into_inner().map_err(|error| Failure::file("csv", error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
