//! `mdr judge`: the answers of another program against the certified records.

mod plot;

use std::fs::File;
use std::io::{self, BufReader};
use std::path::{Path, PathBuf};

use clap::Args;
use comfy_table::ColumnConstraint;
use mdr_reference::{Judge as Bench, Judged, Limits, Range, Refused, Report, Verdict, records};

use crate::error::{Failure, Result};
use crate::flags::Flag;
use crate::output::{Format, Output};
use crate::picture::file;
use crate::reference::size;
use crate::table::{Tone, cell, render, table};

const EXAMPLES: &str = "\
Examples:
  The questions, then the answers of a program of yours:
    mdr reference --export records.jsonl
    mdr judge answers.jsonl

  From a pipe, every answer with its judgement, for another program:
    ./my-solver records.jsonl | mdr judge - --format json

  Where they lose digits: near a fold, at the scale of SI units, or where the condition says so:
    mdr judge answers.jsonl --plot judged.svg

An answer is a line {\"id\": \"critical/jkr-unit/force/force\", \"value\": \"-4.712\", \"error\": \"0.001\"}: the value as a
number or a text, decimal or hexadecimal; the absolute error that it claims not to exceed, if it claims one; and where
there is no number, \"status\": no-equilibrium, overflow, underflow, domain-error or not-admissible.

right        within the claimed error; without a claim, as good as the question allows in double precision
inaccurate   without a claim, more digits lost than the question costs (see --excess); or an overstated claim
wrong        further off than it claims, no digit right, or not the kind of answer there is
digits       log relative error -log10(|value - certified|/|certified|), an interval
excess loss  log10(relative error/(u max(1, condition))), u = 2^-53: about 0 or below, the question is to blame for the
             error; far above 0, the algorithm
JSON: schema mdr.judge/1, one line an answer, worst first, then one for each refused line, then a summary.
Exit status: 0 no answer is wrong, 1 an answer is wrong, or none could be judged; 2 bad input.";

/// Mark the answers of another program: right digits, broken claims, and what is the algorithm's fault.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Judge {
    /// Answers, one JSON object a line; - for standard input
    #[arg(value_name = "ANSWERS.jsonl")]
    answers: PathBuf,

    /// Digits that an answer without a claimed error may lose beyond what the question costs [default: 3]
    #[arg(long, value_name = "DIGITS", allow_hyphen_values = true)]
    excess: Option<String>,

    /// Count inaccurate answers as wrong
    #[arg(long)]
    strict: bool,

    /// Draw right digits and excess loss to this SVG file, and their data to a CSV file beside it
    #[arg(long, value_name = "OUT.svg")]
    plot: Option<PathBuf>,

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
    /// Writes the judgement on `out`; whether no answer is wrong.
    pub(crate) fn run(&self, out: &mut Output<impl io::Write>) -> Result<bool> {
        self.plot.as_deref().map_or(Ok(()), file::check)?;
        let limits = self.limits()?;
        let mut bench = Bench::new(records(), limits);
        let name = self.answers.display().to_string();
        let read = if self.answers == Path::new("-") {
            bench.read(io::stdin().lock())
        } else {
            File::open(&self.answers).and_then(|file| bench.read(BufReader::new(file)))
        };
        read.map_err(|error| Failure::file(&name, error))?;
        let report = bench.report();
        if let Some(to) = &self.plot {
            if report.answered() == 0 {
                return Err(Failure::flag("--plot", "there is nothing to draw without an answer", &name));
            }
            file::write(&plot::picture(&report, &limits), to)?;
        }
        match self.format {
            Format::Json => out.text(report.to_json_lines())?,
            Format::Csv => out.csv(&CSV_HEADER, report.judged.iter().map(csv_row))?,
            Format::Table => out.text(self.for_reader(&report))?,
        }
        let strict = !self.strict || report.count(Verdict::Inaccurate) == 0;
        Ok(report.passed() && strict)
    }

    fn limits(&self) -> Result<Limits> {
        let Some(text) = &self.excess else { return Ok(Limits::default()) };
        let flag = Flag::new("--excess", text);
        let excess_loss = flag.number()?.nearest_f64();
        Ok(Limits { excess_loss, ..Limits::default() })
    }

    fn for_reader(&self, report: &Report<'_>) -> String {
        let shown = if self.all { report.answered() } else { SHOWN };
        let mut text = String::new();
        if report.answered() > 0 {
            let heading = if shown < report.answered() { "Worst answers:\n" } else { "" };
            text = format!("{heading}{}\n\n", answers(&report.judged[..shown.min(report.answered())]));
        }
        text.push_str(&classes(report));
        for (kind, refused) in report.refused() {
            text.push_str(&refusals(kind, refused));
        }
        let [right, inaccurate, wrong] =
            [Verdict::Right, Verdict::Inaccurate, Verdict::Wrong].map(|verdict| report.count(verdict));
        let (answered, questions) = (report.answered(), report.questions());
        format!(
            "{text}\n\n{answered} of {questions} questions answered: {right} right, {inaccurate} inaccurate, {wrong} wrong"
        )
    }
}

fn answers(judged: &[Judged<'_>]) -> String {
    let header = ["id", "line", "digits", "excess loss", "condition", "claim", "difficulty", "verdict"];
    let mut table = table(&header);
    for Judged { record, line, mark } in judged {
        let tone = match mark.verdict {
            Verdict::Right => Tone::Good,
            Verdict::Inaccurate => Tone::Strong,
            Verdict::Wrong => Tone::Bad,
        };
        let reason = if mark.reason.is_empty() { String::new() } else { format!(": {}", mark.reason) };
        table.add_row([
            cell(&record.id, Tone::Plain),
            cell(line, Tone::Faint),
            cell(mark.lre.map(shown).unwrap_or_default(), Tone::Plain),
            cell(mark.excess_loss.map(shown).unwrap_or_default(), Tone::Plain),
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
    let header =
        ["difficulty", "questions", "right", "inaccurate", "wrong", "least digits", "median", "median loss", "largest"];
    let mut table = table(&header);
    for class in report.classes() {
        let pair = |pair: Option<(f64, f64)>| pair.map_or(["".to_owned(), "".to_owned()], |(a, b)| [a, b].map(tenths));
        let ([least, digits], [loss, largest]) = (pair(class.digits), pair(class.excess_loss));
        let counts = class.verdicts.map(|count| count.to_string());
        let [right, inaccurate, wrong] = counts;
        let row = [class.difficulty.to_string(), class.questions.to_string(), right, inaccurate, wrong];
        let row = row.into_iter().chain([least, digits, loss, largest]);
        table.add_row(row.map(|text| cell(text, Tone::Plain)));
    }
    render(&table)
}

/// The refused lines of a kind, by number.
fn refusals(kind: &str, refused: &Refused) -> String {
    let lines: Vec<_> = refused.first.iter().map(|(line, why)| format!("\nline {line}: {kind}: {why}")).collect();
    let rest = refused.count - refused.first.len() as u64;
    let rest = if rest > 0 { format!("\n{rest} more lines {kind}") } else { String::new() };
    if refused.count > 0 { format!("\n{}{rest}", lines.concat()) } else { String::new() }
}

/// One number where both ends are the same to a tenth; `> x` where there is no upper end.
fn shown(range: Range) -> String {
    let (low, high) = (tenths(range.low), tenths(range.high));
    match (range.low.is_finite(), range.high.is_finite()) {
        (true, true) if low == high => low,
        (true, false) => format!("> {low}"),
        (false, true) => format!("< {high}"),
        (false, false) => "exact".to_owned(),
        _ => format!("{low} to {high}"),
    }
}

fn tenths(x: f64) -> String {
    if x.is_finite() { format!("{x:.1}") } else { "exact".to_owned() }
}

const CSV_HEADER: [&str; 12] = [
    "id",
    "line",
    "verdict",
    "reason",
    "status_matches",
    "lre_low",
    "lre_high",
    "excess_loss_low",
    "excess_loss_high",
    "claim",
    "condition",
    "difficulty",
];

fn csv_row(judged: &Judged<'_>) -> [String; 12] {
    let Judged { record, line, mark } = judged;
    let ends =
        |range: Option<Range>| range.map_or(["".to_owned(), "".to_owned()], |r| [r.low, r.high].map(|x| x.to_string()));
    let ([lre_low, lre_high], [loss_low, loss_high]) = (ends(mark.lre), ends(mark.excess_loss));
    [
        record.id.clone(),
        line.to_string(),
        mark.verdict.name().to_owned(),
        mark.reason.clone(),
        mark.status_matches.to_string(),
        lre_low,
        lre_high,
        loss_low,
        loss_high,
        mark.claim.name().to_owned(),
        record.total_condition().to_string(),
        record.difficulty.to_string(),
    ]
}
