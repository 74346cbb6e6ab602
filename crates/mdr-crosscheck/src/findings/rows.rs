//! The two data files: a row for each answer, and a row for each ladder.

use serde::Serialize;

use super::Findings;
use crate::ladders::{Found, Ladder, Rung};
use crate::work_precision::{Accuracy, Comparison};

/// An answer of a method, for a table or CSV.
#[derive(Serialize)]
pub struct PointRow<'a> {
    comparison: &'a str,
    method: &'a str,
    by: &'static str,
    setting: &'a str,
    outcome: String,
    digits: Option<String>,
    evaluations: Option<u64>,
    seconds: Option<String>,
}

impl Comparison {
    /// A row for each answer.
    pub fn rows(&self) -> impl Iterator<Item = PointRow<'_>> {
        let all = self.series.iter().flat_map(|series| series.points.iter().map(move |point| (series, point)));
        all.map(|(series, point)| PointRow {
            comparison: &self.id,
            method: series.method,
            by: if series.ours { "mdr" } else { "textbook" },
            setting: &point.setting,
            outcome: match &point.outcome {
                Accuracy::Digits(_) => "digits".to_owned(),
                Accuracy::AtLeast(_) => "at-least".to_owned(),
                Accuracy::Failed { failed } => format!("failed: {failed}"),
            },
            digits: point.outcome.digits().map(|digits| format!("{digits:.2}")),
            evaluations: point.evaluations,
            seconds: point.seconds.map(|seconds| format!("{seconds:.3e}")),
        })
    }
}

/// A line of JSON, schema mdr.report/3: a question or a ladder.
#[derive(Serialize)]
pub struct FindingLine<'a> {
    schema: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    comparison: Option<&'a Comparison>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ladder: Option<LadderRow<'a>>,
}

impl Findings {
    /// A line for each question, then for each ladder.
    pub fn lines(&self) -> impl Iterator<Item = FindingLine<'_>> {
        let line = |comparison, ladder| FindingLine { schema: "mdr.report/3", comparison, ladder };
        let comparisons = self.comparisons().map(move |comparison| line(Some(comparison), None));
        comparisons.chain(self.ladders.iter().map(move |ladder| line(None, Some(ladder.row()))))
    }
}

/// A ladder by its worst rung, for a table or CSV.
#[derive(Serialize)]
pub struct LadderRow<'a> {
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

impl Ladder {
    /// The ladder by its worst rung.
    pub fn row(&self) -> LadderRow<'_> {
        let worst = self.worst();
        let short = |x: f64| if x.is_finite() { format!("{x:.2e}") } else { x.to_string() };
        let names = self.inputs.iter();
        let inputs = worst.map(|rung| names.zip(&rung.inputs).map(|(name, x)| format!("{name} = {x:e}")).collect());
        LadderRow {
            limit: self.family.name(),
            function: &self.function,
            direction: &self.toward,
            rungs: self.rungs.len(),
            accepted: self.accepted(),
            outcome: worst.map_or_else(String::new, |rung| outcome(&rung.found)),
            inputs: inputs.map_or_else(String::new, |inputs: Vec<_>| inputs.join("; ")),
            excess_loss: worst.and_then(Rung::excess).map(short),
            ulp: worst.and_then(Rung::ulp).map(short),
            condition: worst.and_then(|rung| rung.condition).map(short),
            textbook_formula: self.naive.as_deref(),
            textbook_ulp: self.worst_naive().map(short),
        }
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
