//! `mdr report`: error against run time, and stability.

mod baseline;
mod diagram;
mod footer;
mod ladder_panels;
mod ladders;
mod page;
mod speed;
mod table;

use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use mdr_crosscheck::contest::speed::{Race, races};
use mdr_crosscheck::contest::{Clock, Diagram, Effort, Setup, Task, tasks};
use mdr_crosscheck::ladders::Ladder;
use serde::Serialize;

use self::footer::Machine;
use crate::error::{Failure, Result};
use crate::output::{Format, Output};
use crate::picture;
use crate::table::{Tone, cell};

const EXAMPLES: &str = "\
Examples:
  All tasks, into the directory report: ten minutes on two cores, and more where other projects take part:
    mdr report

  In less than a minute, into another directory, which is made when it is not there:
    mdr report --quick --out /tmp/report

  Two tasks alone:
    mdr report --only kappa,fold

  Whether digits or evaluations got worse since the last time; nothing is timed and nothing is written:
    mdr report --check docs/report/baseline.jsonl

  The baseline of that, anew, after a change that is meant:
    mdr report --renew docs/report/baseline.jsonl

Each diagram is an SVG file of black lines on white and a CSV file of its points; README.md shows them all, with a table of
the time to so many digits, what failed, and what was left out; report.json has all diagrams in one file. The stability
ladders, one SVG and one CSV file a family of directions and a table in README.md, tell how errors grow while questions become
hard; they are not timed and not in report.json. Errors are those of the answers against an enclosure of the truth in which no contestant had a part. Times are medians of repeated runs and
belong to the machine that the page names: compare them within one report.
JSON: schema mdr.report/1, one line a diagram.
Exit status: 0 all files are written and nothing got worse, 1 something got worse, 2 bad input or a file that cannot be written.";

/// Report error against run time: every method on the same questions, as diagrams, tables and data.
///
/// Several methods answer the same question with growing effort: closed forms, quadratures, searches, springs, in double,
/// arbitrary and certified precision.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Report {
    /// Directory of the files
    #[arg(long, value_name = "DIR", default_value = "report")]
    out: PathBuf,

    /// Less effort and fewer runs: less than a minute
    #[arg(long)]
    quick: bool,

    /// Only the tasks of these names, separated by commas; the races against other projects are the task speed, the stability
    /// ladders the task ladders
    #[arg(long, value_name = "TASK", value_delimiter = ',', allow_hyphen_values = true)]
    only: Vec<String>,

    /// Compare right digits and numbers of evaluations of the quick contest with those in this file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["out", "quick", "only", "format", "renew"])]
    check: Option<PathBuf>,

    /// Write right digits and numbers of evaluations of the quick contest into this file
    #[arg(long, value_name = "FILE", conflicts_with_all = ["out", "quick", "only", "format"])]
    renew: Option<PathBuf>,

    /// Shape of the result on standard output
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// What a report is about.
#[derive(Serialize)]
struct Findings {
    schema: &'static str,
    /// How it was asked for.
    command: String,
    machine: Machine,
    effort: Effort,
    /// Timed runs of every answer, where they are not too long.
    runs: usize,
    tasks: Vec<Section>,
    /// This workspace beside other projects.
    races: Vec<Race>,
    /// Who could not race, and why.
    absent: Vec<String>,
    /// How errors grow towards where functions are in danger: in files of their own.
    #[serde(skip)]
    ladders: Vec<Ladder>,
}

/// The diagrams of one task.
#[derive(Serialize)]
struct Section {
    name: &'static str,
    claim: &'static str,
    diagrams: Vec<Diagram>,
}

impl Findings {
    fn diagrams(&self) -> impl Iterator<Item = &Diagram> {
        self.tasks.iter().flat_map(|section| &section.diagrams)
    }
}

impl Report {
    /// Writes the files, and what is in them on `out`; whether nothing got worse.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        match (&self.check, &self.renew) {
            (Some(path), _) => baseline::check(path, out),
            (None, Some(path)) => baseline::renew(path, out).map(|()| true),
            (None, None) => self.report(out).map(|()| true),
        }
    }

    fn report(&self, out: &mut Output<impl std::io::Write>) -> Result<()> {
        let tasks = self.tasks()?;
        let directory = || self.out.display().to_string();
        std::fs::create_dir_all(&self.out).map_err(|error| Failure::file(format!("--out {}", directory()), error))?;
        let findings = self.findings(&tasks);
        for diagram in findings.diagrams() {
            write(&self.out, &format!("{}.svg", diagram.id), picture::svg(&diagram::picture(diagram))?)?;
            write(&self.out, &format!("{}.csv", diagram.id), table::csv([diagram])?)?;
        }
        for (name, bytes) in ladders::files(&findings.ladders)? {
            write(&self.out, &name, bytes)?;
        }
        write(&self.out, "README.md", page::page(&findings))?;
        let json = serde_json::to_string(&findings)
            .map_err(|error| Failure::file("report.json", std::io::Error::other(error)))?;
        write(&self.out, "report.json", json + "\n")?;
        self.list(&findings, out)
    }

    /// The tasks that are asked for.
    fn tasks(&self) -> Result<Vec<&'static Task>> {
        let names: Vec<_> = tasks().iter().map(|task| task.name).chain([speed::NAME, ladders::NAME]).collect();
        if let Some(name) = self.only.iter().find(|name| !names.contains(&name.as_str())) {
            return Err(Failure::flag("--only", format_args!("must be one of {}", names.join(", ")), name));
        }
        Ok(tasks().iter().filter(|task| self.asks_for(task.name)).collect())
    }

    fn asks_for(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|asked| asked == name)
    }

    fn findings(&self, tasks: &[&'static Task]) -> Findings {
        let (effort, runs) = if self.quick { (Effort::Quick, 3) } else { (Effort::Full, 9) };
        let style = ProgressStyle::with_template("{bar:40.green} {pos} of {len}  {msg}  {elapsed}");
        let bar =
            ProgressBar::new(tasks.len() as u64 + 2).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.enable_steady_tick(Duration::from_millis(500));
        let mut setup = Setup::new(effort, Clock::Runs(runs));
        let mut sections = Vec::with_capacity(tasks.len());
        for task in tasks {
            bar.set_message(task.name);
            let diagrams = task.diagrams(&mut setup);
            sections.push(Section { name: task.name, claim: task.claim, diagrams });
            bar.inc(1);
        }
        let (races, absent) = if self.asks_for(speed::NAME) {
            bar.set_message(speed::NAME);
            races(&mut setup)
        } else {
            Default::default()
        };
        bar.inc(1);
        let ladders = if self.asks_for(ladders::NAME) {
            bar.set_message(ladders::NAME);
            mdr_crosscheck::ladders::ladders(effort)
        } else {
            Vec::new()
        };
        bar.finish_and_clear();
        let (schema, command, machine) = ("mdr.report/1", self.command(), Machine::here());
        Findings { schema, command, machine, effort, runs, tasks: sections, races, absent, ladders }
    }

    /// How this report is asked for, wherever its files go.
    fn command(&self) -> String {
        let quick = if self.quick { " --quick" } else { "" };
        let only = if self.only.is_empty() { String::new() } else { format!(" --only {}", self.only.join(",")) };
        format!("mdr report{quick}{only}")
    }

    fn list(&self, findings: &Findings, out: &mut Output<impl std::io::Write>) -> Result<()> {
        match self.format {
            Format::Json => findings.diagrams().try_for_each(|diagram| {
                #[derive(Serialize)]
                struct Line<'a> {
                    schema: &'static str,
                    diagram: &'a Diagram,
                }
                out.json(&Line { schema: findings.schema, diagram })
            }),
            Format::Csv => out.csv(&table::HEADER, findings.diagrams().flat_map(table::rows)),
            Format::Table => {
                let mut files =
                    crate::table::table(&["file", "contestants", "best digits", "failures", "what is asked"]);
                for diagram in findings.diagrams() {
                    let (digits, failures) = table::summary(diagram);
                    files.add_row([
                        cell(self.out.join(format!("{}.svg", diagram.id)).display(), Tone::Good),
                        cell(diagram.curves.len(), Tone::Plain),
                        cell(digits.map_or(String::new(), |digits| format!("{digits:.1}")), Tone::Plain),
                        cell(failures, Tone::Plain),
                        cell(&diagram.title, Tone::Plain),
                    ]);
                }
                for (family, of_family) in ladders::families(&findings.ladders) {
                    let open = of_family.iter().filter(|ladder| !ladder.accepted()).count();
                    files.add_row([
                        cell(self.out.join(format!("{}.svg", ladders::id(family))).display(), Tone::Good),
                        cell(of_family.len(), Tone::Plain),
                        cell("", Tone::Plain),
                        cell(open, Tone::Plain),
                        cell(format_args!("Errors as {}", family.title()), Tone::Plain),
                    ]);
                }
                let page = self.out.join("README.md");
                out.text(format_args!("{}\n\nThe page: {}", crate::table::render(&files), page.display()))
            }
        }
    }
}

/// Writes one file of a directory.
fn write(directory: &Path, name: &str, text: impl AsRef<[u8]>) -> Result<()> {
    let path = directory.join(name);
    std::fs::write(&path, text).map_err(|error| Failure::file(path.display().to_string(), error))
}
