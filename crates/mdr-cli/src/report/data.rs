//! The two data files: a row for each answer, and a row for each ladder.

use mdr_crosscheck::ladders::{Found, Ladder, Rung};
use mdr_crosscheck::work_precision::{Comparison, Outcome};
use serde::Serialize;

use crate::error::{Failure, Result};

/// An answer of a method.
#[derive(Serialize)]
pub(super) struct PointRow<'a> {
    comparison: &'a str,
    method: &'a str,
    by: &'static str,
    setting: &'a str,
    outcome: String,
    digits: Option<String>,
    evaluations: Option<u64>,
    seconds: Option<String>,
}

/// All answers to a question.
pub(super) fn points(comparison: &Comparison) -> impl Iterator<Item = PointRow<'_>> {
    let all = comparison.series.iter().flat_map(|series| series.points.iter().map(move |point| (series, point)));
    all.map(|(series, point)| PointRow {
        comparison: &comparison.id,
        method: series.method,
        by: if series.ours { "mdr" } else { "textbook" },
        setting: &point.setting,
        outcome: match &point.outcome {
            Outcome::Digits(_) => "digits".to_owned(),
            Outcome::AtLeast(_) => "at-least".to_owned(),
            Outcome::Failed { failed } => format!("failed: {failed}"),
        },
        digits: point.outcome.digits().map(|digits| format!("{digits:.2}")),
        evaluations: point.evaluations,
        seconds: point.seconds.map(|seconds| format!("{seconds:.3e}")),
    })
}

/// A ladder by its worst rung.
#[derive(Serialize)]
pub(super) struct LadderRow<'a> {
    limit: &'static str,
    function: &'a str,
    direction: &'a str,
    rungs: usize,
    accepted: bool,
    outcome: String,
    inputs: String,
    excess_loss: Option<String>,
    ulp: Option<String>,
    condition: Option<String>,
    textbook_formula: Option<&'a str>,
    textbook_ulp: Option<String>,
}

pub(super) fn ladder(ladder: &Ladder) -> LadderRow<'_> {
    let worst = ladder.worst();
    let short = |x: f64| if x.is_finite() { format!("{x:.2e}") } else { x.to_string() };
    let names = ladder.inputs.iter();
    let inputs = worst.map(|rung| names.zip(&rung.inputs).map(|(name, x)| format!("{name} = {x:e}")).collect());
    LadderRow {
        limit: ladder.family.name(),
        function: &ladder.function,
        direction: &ladder.toward,
        rungs: ladder.rungs.len(),
        accepted: ladder.accepted(),
        outcome: worst.map_or_else(String::new, |rung| outcome(&rung.found)),
        inputs: inputs.map_or_else(String::new, |inputs: Vec<_>| inputs.join("; ")),
        excess_loss: worst.and_then(Rung::excess).map(short),
        ulp: worst.and_then(ulp).map(short),
        condition: worst.and_then(|rung| rung.condition).map(short),
        textbook_formula: ladder.naive.as_deref(),
        textbook_ulp: ladder.worst_naive().map(short),
    }
}

fn outcome(found: &Found) -> String {
    match found {
        Found::Number { .. } => "number".to_owned(),
        Found::Beyond { .. } => "out of range".to_owned(),
        Found::Flushed => "rounded to 0".to_owned(),
        Found::Refused => "no such number".to_owned(),
        Found::Declined(what) => format!("declined: {what}"),
        Found::Wrong(what) => format!("wrong: {what}"),
    }
}

/// The error of an answer that is a number.
pub(super) fn ulp(rung: &Rung) -> Option<f64> {
    match rung.found {
        Found::Number { ulp, .. } => Some(ulp),
        _ => None,
    }
}

/// A header and rows.
pub(super) fn csv<T: Serialize>(rows: impl IntoIterator<Item = T>) -> Result<String> {
    let failed = |error: csv::Error| Failure::file("csv", std::io::Error::from(error));
    let mut csv = csv::Writer::from_writer(Vec::new());
    for row in rows {
        csv.serialize(row).map_err(failed)?;
    }
    let bytes = csv.into_inner().map_err(|error| Failure::file("csv", error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}
