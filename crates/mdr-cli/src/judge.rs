//! `mdr judge`: the answers of another program against the certified records.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use comfy_table::ColumnConstraint;
use mdr_reference::{Class, Filter, Judge as Bench, Judged, Limits, Report, Rules, Verdict};

use crate::error::{Failure, Result};
use crate::flags::Flag;
use crate::output::{Format, Output};
use crate::plot;
use crate::reference::size;
use crate::table::{Tone, cell, render, table};

const EXAMPLES: &str = "\
Examples:
  The questions, then the answers of a program of yours:
    mdr reference --export records.jsonl
    mdr judge answers.jsonl

  From a pipe, every answer with its judgement, for another program:
    ./my-solver records.jsonl | mdr judge - --format json

  All questions about spheres, and none without an answer:
    mdr judge answers.jsonl --filter profile=sphere --complete

  Where they lose digits: near a fold, at the scale of SI units, or where the condition says so:
    mdr judge answers.jsonl --plot judged.svg

An answer is a line {\"id\": \"critical/jkr-unit/force/force\", \"value\": \"-4.712\", \"error\": \"0.001\"}:
the value as a number or a text, decimal or hexadecimal; the absolute error that it claims not to
exceed, if it claims one; and where there is no number, \"status\": no-equilibrium, overflow,
underflow, domain-error or not-admissible. NaN and infinities are read as C and others print them.
A line that is no answer, an unknown id, and a second answer to a question are not judged.

right        within the claimed error; without a claim, as good as the question allows in double
             precision; or the status
inaccurate   without a claim, more digits lost than the question costs (see --excess); an
             overstated claim; or the status fold without its number
wrong        further off than it claims, no digit right, NaN, or not the kind of answer there is
digits       log relative error -log10(|value - certified|/|certified|), an interval
excess loss  log10(relative error/(u max(1, condition))), u = 2^-53: about 0 or below, the
             question is to blame for the error; far above 0, the algorithm
JSON: schema mdr.judge/1, one line an answer, worst first, then one for each refused line, then
a summary.
Exit status: 0 passed; 1 an answer is wrong, or inaccurate (but for --accept-inaccurate), a line
was not judged (but for --lenient), a question has no answer (with --complete), or there is no
answer at all; 2 bad input.";

/// Mark the answers of another program: right digits, broken claims, and what is the algorithm's fault.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Judge {
    /// Answers, one JSON object a line; - for standard input
    #[arg(value_name = "ANSWERS.jsonl")]
    answers: PathBuf,

    /// Judge answers to these records only, and set others aside; terms as in mdr reference --filter
    #[arg(long, value_name = "EXPR", default_value = "", hide_default_value = true)]
    filter: String,

    /// Fail when a question has no answer
    #[arg(long)]
    complete: bool,

    /// Pass in spite of lines that are no answers, unknown ids, and second answers
    #[arg(long)]
    lenient: bool,

    /// Pass in spite of inaccurate answers
    #[arg(long)]
    accept_inaccurate: bool,

    /// Digits that an answer without a claimed error may lose beyond what the question costs, from 0 to 16 [default: 3]
    #[arg(long, value_name = "DIGITS", allow_hyphen_values = true)]
    excess: Option<String>,

    /// Draw right digits and excess loss to this SVG file, and their data to a CSV file beside it
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,

    /// Colours of the picture
    #[arg(long, value_enum, default_value_t)]
    theme: plot::Colours,

    /// Show all answers in the table, not only the worst
    #[arg(long)]
    all: bool,

    /// Shape of the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// In place of a picture.
const NOTHING_TO_DRAW: &str = "no picture, since there is no answer to draw";

/// Answers shown in the table.
const SHOWN: usize = 20;

impl Judge {
    /// Writes the judgement on `out`; whether the answers pass.
    pub(crate) fn run(&self, out: &mut Output<impl io::Write>) -> Result<bool> {
        self.plot.as_deref().map_or(Ok(()), plot::check)?;
        let rules = self.rules()?;
        let filter: Filter = self.filter.parse().map_err(|error| Failure::refused("--filter", error))?;
        let mut bench = Bench::new(filter.select(), rules);
        let name = self.answers.display().to_string();
        let read = if self.answers == Path::new("-") {
            bench.read(io::stdin().lock())
        } else {
            File::open(&self.answers).and_then(|file| bench.read(BufReader::new(file)))
        };
        read.map_err(|error| Failure::file(&name, error))?;
        let report = bench.report();
        match self.format {
            Format::Json => out.text(report.to_json_lines())?,
            Format::Csv => {
                let rows = report.to_rows();
                let header: Vec<&str> = rows[0].iter().map(String::as_str).collect();
                out.csv(&header, &rows[1..])?;
            }
            Format::Table => out.text(self.for_reader(&report))?,
        }
        match &self.plot {
            // A closed standard error changes nothing.
            Some(_) if report.answered() == 0 => drop(writeln!(io::stderr(), "note: --plot: {NOTHING_TO_DRAW}")),
            Some(to) => plot::write(&mdr_plot::judged(&report, &rules.limits), self.theme, to, "--plot ")?,
            None => {}
        }
        Ok(report.passed())
    }

    fn rules(&self) -> Result<Rules> {
        let mut limits = Limits::default();
        if let Some(text) = &self.excess {
            let flag = Flag::new("--excess", text);
            limits.excess_loss = flag.number()?.nearest_f64();
            if !(0.0..=16.0).contains(&limits.excess_loss) {
                return Err(flag.refuse("must be from 0 to 16, the digits of a double"));
            }
        }
        let Judge { accept_inaccurate, lenient, complete, .. } = *self;
        Ok(Rules { limits, accept_inaccurate, lenient, complete })
    }

    fn for_reader(&self, report: &Report<'_>) -> String {
        let shown = if self.all { report.answered() } else { SHOWN };
        let mut text = String::new();
        if report.answered() > 0 {
            let heading = if shown < report.answered() { "Worst answers:\n" } else { "" };
            text = format!("{heading}{}\n\n", answers(&report.judged[..shown.min(report.answered())]));
        }
        format!("{text}{}\n\n{}", classes(report), report.summary())
    }
}

fn answers(judged: &[Judged<'_>]) -> String {
    let header = ["id", "line", "digits", "excess loss", "condition", "claim", "difficulty", "verdict"];
    let mut table = table(&header);
    for Judged { record, line, mark, .. } in judged {
        let tone = match mark.verdict {
            Verdict::Right => Tone::Good,
            Verdict::Inaccurate => Tone::Strong,
            Verdict::Wrong => Tone::Bad,
        };
        let reason = if mark.reason.is_empty() { String::new() } else { format!(": {}", mark.reason) };
        table.add_row([
            cell(&record.id, Tone::Plain),
            cell(line, Tone::Faint),
            cell(mark.lre.map(|range| range.to_string()).unwrap_or_default(), Tone::Plain),
            cell(mark.excess_loss.map(|range| range.to_string()).unwrap_or_default(), Tone::Plain),
            cell(size(record.total_condition()), Tone::Faint),
            cell(mark.claim.name(), Tone::Plain),
            cell(record.difficulty, Tone::Faint),
            cell(format!("{}{reason}", mark.verdict.name()), tone),
        ]);
    }
    // An identifier stays in one piece, to be copied.
    table.set_constraints([ColumnConstraint::ContentWidth]);
    render(&table)
}

fn classes(report: &Report<'_>) -> String {
    let mut table = table(&Class::HEADER);
    for class in report.classes() {
        table.add_row(class.cells().map(|text| cell(text, Tone::Plain)));
    }
    render(&table)
}
