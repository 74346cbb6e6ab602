//! `mdr judge`: the answers of another program against the certified records.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use comfy_table::ColumnConstraint;
use mdr_reference::{Class, Filter, Judge as Bench, Judged, Limits, Range, Report, Rules, Verdict};

use crate::error::{Failure, Result};
use crate::files;
use crate::flags::Flag;
use crate::output::{Format, Output};
use crate::plot::PictureFlags;
use crate::reference::size;
use crate::table::{CellStyle, cell, render, table, text_table};

/// The help of `--plot`.
const PICTURE: &str = "Draw right digits and excess loss to this file, SVG, PNG or PDF by its name, and their data to a CSV file beside it";

/// Mark the answers of another program: right digits, broken claims, and the losses due to its algorithm.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/judge.txt"), mut_arg("plot", |flag| flag.help(PICTURE)))]
pub(crate) struct Judge {
    /// Answers, one a line, as JSON, `id value` or CSV; - for standard input
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

    #[command(flatten)]
    picture: PictureFlags,

    /// Show all answers in the table, not only the worst
    #[arg(long)]
    all: bool,

    /// Shape of the result
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// Answers shown in the table.
const SHOWN: usize = 20;

impl Judge {
    /// Writes the judgement on `out`; whether the answers pass.
    pub(crate) fn run(&self, out: &mut Output<impl io::Write>) -> Result<bool> {
        let drawn = self.picture.wanted()?;
        let rules = self.rules()?;
        let filter: Filter = self.filter.parse().map_err(|error| Failure::refused("--filter", error))?;
        let mut bench = Bench::new(filter.select(), rules);
        let read = bench.read(files::open(&self.answers)?);
        read.map_err(|error| files::of_flag("", &self.answers, error))?;
        let report = bench.report();
        match self.format {
            Format::Json => out.json_lines(&report.to_json_lines())?,
            Format::Csv => out.spreadsheet(&report.to_rows())?,
            Format::Table => out.text(self.for_reader(&report))?,
        }
        if drawn && report.answered() == 0 {
            // A closed standard error changes nothing.
            drop(writeln!(io::stderr(), "note: --plot: no picture, since there is no answer to draw"));
        } else {
            self.picture.draw(|| Ok(mdr_plot::judged(&report, &rules.limits)))?;
        }
        Ok(report.passed())
    }

    fn rules(&self) -> Result<Rules> {
        let mut limits = Limits::default();
        if let Some(text) = &self.excess {
            let flag = Flag::new("--excess", text);
            limits.excess_loss = flag.number(mdr_core::units::SiUnit::One)?.nearest_f64();
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
        let classes = text_table(&Class::HEADER, report.classes().iter().map(Class::cells));
        format!("{text}{classes}\n\n{}", report.summary())
    }
}

fn answers(judged: &[Judged<'_>]) -> String {
    let mut table = table(&["id", "line", "digits", "excess loss", "condition", "claim", "difficulty", "verdict"]);
    let range = |range: Option<Range>| range.map_or_else(String::new, |range| range.to_string());
    for Judged { record, line, mark, .. } in judged {
        let tone = match mark.verdict {
            Verdict::Right => CellStyle::Good,
            Verdict::Inaccurate => CellStyle::Strong,
            Verdict::Wrong => CellStyle::Bad,
        };
        let reason = if mark.reason.is_empty() { String::new() } else { format!(": {}", mark.reason) };
        table.add_row([
            cell(&record.id, CellStyle::Plain),
            cell(line, CellStyle::Faint),
            cell(range(mark.lre), CellStyle::Plain),
            cell(range(mark.excess_loss), CellStyle::Plain),
            cell(size(record.total_condition()), CellStyle::Faint),
            cell(mark.claim.name(), CellStyle::Plain),
            cell(record.difficulty, CellStyle::Faint),
            cell(format!("{}{reason}", mark.verdict.name()), tone),
        ]);
    }
    // An identifier stays in one piece, to be copied.
    table.set_constraints([ColumnConstraint::ContentWidth]);
    render(&table)
}
