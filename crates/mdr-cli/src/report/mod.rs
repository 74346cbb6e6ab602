//! `mdr report`: error against run time, and stability, on one page.

mod footer;

use std::path::PathBuf;

use clap::Args;
use mdr_crosscheck::ladders::Ladder;
use mdr_crosscheck::work_precision::{Clock, Comparison, Measurement, Series};
use mdr_crosscheck::{Findings, Level};
use mdr_plot::{ComparedMethod, ComparedQuestion};

use crate::error::Result;
use crate::output::{Format, Output};
use crate::table::{CellStyle, cell, render, table};
use crate::{files, progress};

/// Report error against run time, and how errors grow while questions become hard: pictures, tables and data.
///
/// Methods of this workspace and of textbooks answer the same questions with growing effort: closed forms, quadratures,
/// searches, springs, in double, arbitrary and certified precision.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../../help/report.txt"))]
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
    /// Writes the files, and their contents on `out`.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        files::make_folder("--out", &self.out)?;
        let (level, runs) = if self.quick { (Level::Quick, 3) } else { (Level::Full, 9) };
        let findings = find(level, runs)?;
        let write = |name: &str, text: &str| files::write("", &self.out.join(name), text);
        for (task, comparisons) in &findings.tasks {
            let questions: Vec<_> = comparisons.iter().map(question).collect();
            write(
                &format!("{}.svg", task.name),
                &mdr_provenance::svg(&mdr_plot::comparison(task.title, &questions).svg()),
            )?;
        }
        files::create_csv("", &self.out.join("work-precision.csv"), |out| {
            out.records(findings.comparisons().flat_map(Comparison::rows))
        })?;
        files::create_csv("", &self.out.join("ladders.csv"), |out| {
            out.records(findings.ladders.iter().map(Ladder::row))
        })?;
        let command = if self.quick { "mdr report --quick" } else { "mdr report" };
        let origin =
            format!("    {command}\n\nMedians of {runs} runs, fewer where an answer takes long. {}", footer::machine());
        write("README.md", &findings.page(&origin))?;
        self.print(&findings, out)?;
        Ok(true)
    }

    fn print(&self, findings: &Findings, out: &mut Output<impl std::io::Write>) -> Result<()> {
        match self.format {
            Format::Json => findings.lines().try_for_each(|line| out.json(&line)),
            Format::Csv => out.records(findings.comparisons().flat_map(Comparison::rows)),
            Format::Table => {
                let mut table = table(&["question", "methods", "most digits", "no answer", "what is asked"]);
                for comparison in findings.comparisons() {
                    table.add_row([
                        cell(&comparison.id, CellStyle::Good),
                        cell(comparison.series.len(), CellStyle::Plain),
                        cell(format_args!("{:.1}", comparison.most_digits()), CellStyle::Plain),
                        cell(comparison.failures().count(), CellStyle::Plain),
                        cell(&comparison.title, CellStyle::Plain),
                    ]);
                }
                let open = findings.ladders.iter().filter(|ladder| !ladder.accepted()).count();
                let page = self.out.join("README.md");
                let (table, count) = (render(&table), findings.ladders.len());
                out.text(format_args!(
                    "{table}\n\n{count} ladders, {open} not accepted\n\nThe page: {}",
                    files::shown(&page)
                ))
            }
        }
    }
}

/// Asks everything, with a bar on standard error.
fn find(level: Level, runs: usize) -> Result<Findings> {
    let bar = progress::bar(Findings::PARTS);
    let mut done = 0..;
    let findings = Findings::new(level, Clock::Runs(runs), |part| {
        bar.set_message(part);
        bar.set_position(done.next().unwrap_or_default());
    });
    bar.finish_and_clear();
    Ok(findings?)
}

/// The part of a question that is drawn: the answers with a time.
fn question(comparison: &Comparison) -> ComparedQuestion<'_> {
    let answer = |point: &Measurement| Some((point.seconds?, point.outcome.digits()));
    let method = |series: &Series| ComparedMethod {
        name: series.method,
        textbook: !series.ours,
        answers: series.points.iter().filter_map(answer).collect(),
    };
    let (title, attainable) = (&comparison.title, comparison.attainable);
    ComparedQuestion { title, attainable, methods: comparison.series.iter().map(method).collect() }
}
