//! The certified records and the judge.

use mdr_reference::{Filter, FilterError, Judge, Limits, Range, Rules};
use pyo3::prelude::*;

use crate::errors::raise;
use crate::interrupt::detached;

/// Identifier, verdict, reason, right digits, excess loss, claim.
type Mark = (String, &'static str, String, Option<(f64, f64)>, Option<(f64, f64)>, &'static str);

/// Passed, failures, text, marks, number of questions.
type Judged = (bool, Vec<String>, String, Vec<Mark>, usize);

fn filter(text: &str) -> PyResult<Filter> {
    text.parse().map_err(|error: FilterError| raise("FilterError", (error.to_string(),)))
}

/// Identifiers of the records of a choice.
#[pyfunction]
pub(crate) fn select(choice: &str) -> PyResult<Vec<&'static str>> {
    Ok(filter(choice)?.select().map(|record| record.id.as_str()).collect())
}

/// All records as published, one JSON object a line.
#[pyfunction]
pub(crate) fn lines() -> Vec<&'static str> {
    mdr_reference::lines().collect()
}

/// Nearest double, high and low word, tolerance.
#[pyfunction]
pub(crate) fn numbers(id: &str) -> Option<(f64, (f64, f64), f64)> {
    mdr_reference::record(id).map(|record| (record.nearest(), record.pair(), record.tolerance()))
}

/// Judges answer lines: passed, failures, text, marks, number of questions. The rules are the excess loss and the overstatement
/// that pass, and whether inaccurate answers, odd lines, and missing answers do.
#[pyfunction]
pub(crate) fn judge_lines(
    py: Python<'_>,
    choice: &str,
    answers: Vec<String>,
    rules: (f64, f64, bool, bool, bool),
) -> PyResult<Judged> {
    let filter = filter(choice)?;
    let (excess_loss, overstatement, accept_inaccurate, lenient, complete) = rules;
    let limits = Limits { excess_loss, overstatement };
    detached(py, || {
        let mut judge = Judge::new(filter.select(), Rules { limits, accept_inaccurate, lenient, complete });
        answers.iter().for_each(|line| judge.line(line.as_bytes()));
        let report = judge.report();
        let range = |range: Option<Range>| range.map(|range| (range.low, range.high));
        let marks = report.judged.iter().map(|judged| {
            let mark = &judged.mark;
            let (digits, loss) = (range(mark.lre), range(mark.excess_loss));
            (judged.record.id.clone(), mark.verdict.name(), mark.reason.clone(), digits, loss, mark.claim.name())
        });
        (report.passed(), report.failures(), report.to_string(), marks.collect(), report.questions())
    })
}
