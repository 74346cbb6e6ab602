//! `mdr report`: error against run time, and stability.

mod baseline;
mod diagram;
mod footer;
mod ladder_panels;
mod ladders;
mod overview;
mod page;
mod speed;
mod store;
mod summary;
mod table;

use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use mdr_crosscheck::contest::speed::races;
use mdr_crosscheck::contest::{Clock, Diagram, Effort, Setup, tasks};
use serde::Serialize;

use self::footer::Machine;
use self::store::{Findings, Made, Section};
use crate::error::{Failure, Result};
use crate::output::{Format, Output};
use crate::picture;
use crate::table::{Tone, cell};

const EXAMPLES: &str = "\
Examples:
  All tasks, into the directory report: five minutes on two cores, other projects included:
    mdr report

  In less than a minute, into another directory, which is made when it is not there:
    mdr report --quick --out /tmp/report

  Two tasks alone:
    mdr report --only kappa,fold

  Whether digits or evaluations got worse since the last time; nothing is timed or written:
    mdr report --check docs/report/baseline.jsonl

  The baseline of that, anew, after a change that is meant:
    mdr report --renew docs/report/baseline.jsonl

README.md shows every task with a picture and the time to so many digits; each task has a page of
its own with all diagrams, tables, failures and what was left out. A diagram is an SVG file of
black lines on white and a CSV file of its points; report.json has all of them, but for the
stability ladders, which have CSV files. Files are written task by task: a report that is
interrupted leaves what is done and says so, and --only leaves other tasks as they are. Other
projects' methods are stopped where one answer takes longer than 4 s, or all answers of a task
30 s. Errors are those of the answers against an enclosure of the truth in which no contestant had
a part. Times are medians of repeated runs and belong to the machine that the page names.
JSON: schema mdr.report/2, one line a diagram.
Exit status: 0 all files are written and nothing got worse, 1 something got worse, 2 bad input or
a file that cannot be written.";

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
        let names = self.tasks()?;
        let directory = || self.out.display().to_string();
        std::fs::create_dir_all(&self.out).map_err(|error| Failure::file(format!("--out {}", directory()), error))?;
        let mut findings = Findings::load(&self.out)?;
        findings.unfinished = names.iter().map(|name| (*name).to_owned()).collect();
        self.save(&findings)?;
        let style = ProgressStyle::with_template("{bar:40.green} {pos} of {len}  {msg}  {elapsed}");
        let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::new(names.len() as u64).with_style(style);
        bar.enable_steady_tick(Duration::from_millis(500));
        let (effort, runs) = self.effort();
        let mut setup = Setup::new(effort, Clock::Runs(runs));
        for name in &names {
            bar.set_message(*name);
            findings.put(self.section(name, &mut setup)?, &all());
            self.save(&findings)?;
            bar.inc(1);
        }
        bar.finish_and_clear();
        findings.tasks.retain(|section| names.contains(&&*section.name));
        self.list(&findings, out)
    }

    /// The overview, and everything in one file.
    fn save(&self, findings: &Findings) -> Result<()> {
        write(&self.out, "README.md", overview::page(findings, &all()))?;
        findings.save(&self.out)
    }

    /// The tasks that are asked for.
    fn tasks(&self) -> Result<Vec<&'static str>> {
        let mut names = all();
        if let Some(name) = self.only.iter().find(|name| !names.contains(&name.as_str())) {
            return Err(Failure::flag("--only", format_args!("must be one of {}", names.join(", ")), name));
        }
        names.retain(|name| self.only.is_empty() || self.only.iter().any(|asked| asked == name));
        Ok(names)
    }

    /// How far a task goes, and how often it is timed.
    fn effort(&self) -> (Effort, usize) {
        if self.quick { (Effort::Quick, 3) } else { (Effort::Full, 9) }
    }

    /// Does one task and writes its page and the files that are shown there.
    fn section(&self, name: &str, setup: &mut Setup) -> Result<Section> {
        let (effort, runs) = self.effort();
        let made = Made { command: self.command(), effort, runs, machine: Machine::here() };
        let mut section = Section::new(name, made);
        if name == ladders::NAME {
            let found = mdr_crosscheck::ladders::ladders(effort);
            section.ladders = Some(ladders::Summary::of(&found));
            for (name, bytes) in ladders::files(&found)? {
                write(&self.out, &name, bytes)?;
            }
            self.draw(&summary::id(&section), &summary::of_ladders(&found))?;
            write(&self.out, "ladders.md", ladders::page(&section, &found, effort))?;
            return Ok(section);
        }
        match tasks().iter().find(|task| task.name == name) {
            Some(task) => section.diagrams = task.diagrams(setup),
            None => (section.races, section.absent) = races(setup),
        }
        for diagram in &section.diagrams {
            self.draw(&diagram.id, &diagram::picture(diagram))?;
            write(&self.out, &format!("{}.csv", diagram.id), table::csv([diagram])?)?;
        }
        if let Some(picture) = summary::picture(&section) {
            self.draw(&summary::id(&section), &picture)?;
        }
        write(&self.out, &format!("{name}.md"), page::page(&section))?;
        Ok(section)
    }

    fn draw(&self, name: &str, picture: &picture::Picture) -> Result<()> {
        write(&self.out, &format!("{name}.svg"), picture::svg(picture)?)
    }

    /// How this report is asked for, wherever its files go.
    fn command(&self) -> String {
        let quick = if self.quick { " --quick" } else { "" };
        let only = if self.only.is_empty() { String::new() } else { format!(" --only {}", self.only.join(",")) };
        format!("mdr report{quick}{only}")
    }

    fn list(&self, findings: &Findings, out: &mut Output<impl std::io::Write>) -> Result<()> {
        let mut diagrams = findings.tasks.iter().flat_map(|section| &section.diagrams);
        match self.format {
            Format::Json => diagrams.try_for_each(|diagram| {
                #[derive(Serialize)]
                struct Line<'a> {
                    schema: &'static str,
                    diagram: &'a Diagram,
                }
                out.json(&Line { schema: store::SCHEMA, diagram })
            }),
            Format::Csv => out.csv(&table::HEADER, diagrams.flat_map(table::rows)),
            Format::Table => {
                let mut files =
                    crate::table::table(&["file", "contestants", "best digits", "failures", "what is asked"]);
                for diagram in diagrams {
                    let (digits, failures) = table::summary(diagram);
                    files.add_row([
                        cell(self.out.join(format!("{}.svg", diagram.id)).display(), Tone::Good),
                        cell(diagram.curves.len(), Tone::Plain),
                        cell(digits.map_or(String::new(), |digits| format!("{digits:.1}")), Tone::Plain),
                        cell(failures, Tone::Plain),
                        cell(&diagram.title, Tone::Plain),
                    ]);
                }
                for section in &findings.tasks {
                    let page = cell(self.out.join(format!("{}.md", section.name)).display(), Tone::Good);
                    let claim = page::capitalised(&section.claim);
                    files.add_row([
                        page,
                        cell("", Tone::Plain),
                        cell("", Tone::Plain),
                        cell("", Tone::Plain),
                        cell(claim, Tone::Plain),
                    ]);
                }
                let page = self.out.join("README.md");
                out.text(format_args!("{}\n\nThe page: {}", crate::table::render(&files), page.display()))
            }
        }
    }
}

/// The names of all tasks, in the order of the page.
fn all() -> Vec<&'static str> {
    tasks().iter().map(|task| task.name).chain([speed::NAME, ladders::NAME]).collect()
}

/// Writes one file of a directory.
fn write(directory: &Path, name: &str, text: impl AsRef<[u8]>) -> Result<()> {
    let path = directory.join(name);
    std::fs::write(&path, text).map_err(|error| Failure::file(path.display().to_string(), error))
}
