//! The result of a run: one row a check, and every case that failed.

use std::fmt;

use mdr_core::named;
use serde::{Deserialize, Serialize};

use crate::options::{Level, Shard};
use crate::short;
use crate::trial::Trial;

named! {
    /// The unit of an error.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub enum ErrorUnit {
        /// Relative error over the unit roundoff 2^−p of the arithmetic of the case: f64 and arbitrary precision compare.
        Roundoffs = "u",
        /// Units in the last place of the correctly rounded result, binary or decimal.
        Ulp = "ulp",
        /// Relative error, where the comparison is limited by truncation and not by roundoff.
        Relative = "rel",
        /// Answers that must be equal: 0 or 1.
        Mismatch = "mismatch",
    }
}

impl ErrorUnit {
    /// The meaning of an error of 1, in a sentence.
    pub fn description(self) -> &'static str {
        match self {
            ErrorUnit::Roundoffs => "relative error 2^-p at p bits: 1.1e-16 in f64, where 9 u are an error of 1e-15",
            ErrorUnit::Ulp => "a unit in the last place of the correctly rounded result",
            ErrorUnit::Relative => "relative error 1, where truncation and not roundoff limits the comparison",
            ErrorUnit::Mismatch => "an answer that differs where two must be equal",
        }
    }
}

named! {
    /// Whether a check holds.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub enum CheckVerdict {
        /// No error exceeds its bound, and at least one case was compared.
        Pass = "pass",
        /// Some error exceeds its bound, or a route gave no answer where it must.
        Fail = "fail",
        /// No case was compared.
        Skipped = "skipped",
    }
}

/// One comparison worth telling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Finding {
    /// The index of the case: with the seed it gives the inputs again.
    pub index: usize,
    /// The quantity compared.
    pub quantity: String,
    /// The error found, in the unit of the row.
    pub error: f64,
    /// The error allowed for this case.
    pub allowed: f64,
    /// The inputs.
    pub inputs: String,
}

impl Finding {
    /// Error, allowed error, and quantity with inputs for a reader, with the numbers rounded.
    pub fn in_short(&self) -> [String; 3] {
        let case = format!("{}: {}", self.quantity, short::numbers(&self.inputs));
        [significant(self.error), significant(self.allowed), case]
    }

    /// error/allowed; an exact agreement is 0 also where nothing is allowed.
    pub fn share(&self) -> f64 {
        if self.error == 0.0 { 0.0 } else { self.error / self.allowed }
    }
}

/// Three digits are enough for an error.
fn significant(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        1e-2..1e4 => format!("{value:.3}"),
        _ => format!("{value:.2e}"),
    }
}

/// A case that failed, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// The check.
    pub check: String,
    /// The index of the case.
    pub index: usize,
    /// The inputs.
    pub inputs: String,
    /// The reason for the failure.
    pub reason: String,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Failure { check, index, inputs, reason } = self;
        write!(f, "{check} #{index}: {inputs}\n  {reason}")
    }
}

/// The result of one check.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct CheckRow {
    /// Stable name of the check.
    pub check: String,
    /// The comparison in words.
    pub claim: String,
    /// The equations of the paper it covers.
    pub equations: Vec<String>,
    /// The unit of the errors.
    pub unit: ErrorUnit,
    /// Cases that were compared.
    pub cases: usize,
    /// Cases that could not be asked (out of the range of f64, say).
    pub skipped: usize,
    /// Cases that failed.
    pub failed: usize,
    /// The largest error found.
    pub worst: Option<Finding>,
    /// The largest share of its allowed error that any comparison used.
    pub tightest: Option<Finding>,
    /// Pass, fail or skipped.
    pub verdict: CheckVerdict,
    /// All errors, ascending, from which the quantiles are taken, also after merging shards.
    pub errors: Vec<f64>,
}

impl CheckRow {
    /// The `tau`-quantile of the errors found; `None` without errors.
    pub fn quantile(&self, tau: f64) -> Option<f64> {
        use statrs::statistics::{Data, OrderStatistics};
        (!self.errors.is_empty()).then(|| Data::new(self.errors.clone()).quantile(tau))
    }

    /// The finding that decides the verdict: the largest share of an allowed error, or else the largest error.
    pub fn decisive(&self) -> Option<&Finding> {
        self.tightest.as_ref().or(self.worst.as_ref())
    }

    /// The median error.
    pub fn median(&self) -> Option<f64> {
        self.quantile(0.5)
    }
}

/// For a spreadsheet.
impl CheckRow {
    /// The titles of [`CheckRow::to_csv`].
    pub const CSV_HEADER: [&str; 12] = [
        "check",
        "claim",
        "equations",
        "cases",
        "skipped",
        "failed",
        "worst_error",
        "allowed_error",
        "unit",
        "quantity",
        "inputs",
        "verdict",
    ];

    /// The row as text, with its decisive finding.
    pub fn to_csv(&self) -> [String; 12] {
        let of = |field: fn(&Finding) -> String| self.decisive().map(field).unwrap_or_default();
        [
            self.check.clone(),
            self.claim.clone(),
            self.equations.join(" "),
            self.cases.to_string(),
            self.skipped.to_string(),
            self.failed.to_string(),
            of(|finding| finding.error.to_string()),
            of(|finding| finding.allowed.to_string()),
            self.unit.to_string(),
            of(|finding| finding.quantity.clone()),
            of(|finding| finding.inputs.clone()),
            self.verdict.to_string(),
        ]
    }
}

/// The identity of the grid of a run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Grid {
    /// How many cases.
    pub level: Level,
    /// Decimal digits of the arbitrary-precision cases.
    pub digits: u32,
    /// The seed.
    pub seed: u64,
    /// At most so many cases a check, if limited.
    pub limit: Option<usize>,
}

/// The result of a run or of several shards together.
#[derive(Clone, Debug, PartialEq)]
pub struct VerifyReport {
    /// The grid.
    pub grid: Grid,
    /// Which part of it.
    pub shard: Shard,
    /// One row a check, in the order of the registry.
    pub rows: Vec<CheckRow>,
    /// The cases that failed, in the order of checks and indices.
    pub failures: Vec<Failure>,
}

impl VerifyReport {
    /// Whether no check failed.
    pub fn passed(&self) -> bool {
        self.rows.iter().all(|row| row.verdict != CheckVerdict::Fail)
    }

    /// Cases compared in all rows.
    pub fn cases(&self) -> usize {
        self.rows.iter().map(|row| row.cases).sum()
    }

    /// How many checks hold, on which grid, as a sentence.
    pub fn summary(&self) -> String {
        let count = |verdict| self.rows.iter().filter(|row| row.verdict == verdict).count();
        let (passed, failed, skipped) =
            (count(CheckVerdict::Pass), count(CheckVerdict::Fail), count(CheckVerdict::Skipped));
        let skipped = if skipped == 0 { String::new() } else { format!(", {skipped} without a case") };
        let Grid { level, digits, seed, .. } = &self.grid;
        let (checks, cases, shard) = (self.rows.len(), self.cases(), self.shard);
        format!(
            "{checks} checks, {cases} cases: {passed} hold, {failed} failed{skipped}. Grid {level}, {digits} digits, seed \
             {seed}, shard {shard}."
        )
    }

    /// The meaning of the units of the rows, in lines.
    pub fn units(&self) -> String {
        let mut text =
            "Units of the errors; the numbers of a case are rounded here, and exact in JSON and CSV:".to_owned();
        for unit in ErrorUnit::ALL.into_iter().filter(|unit| self.rows.iter().any(|row| row.unit == *unit)) {
            text.push_str(&format!("\n  {:<8}  {}", unit.name(), unit.description()));
        }
        text
    }

    /// Enters the cases of one check, in the order of their indices.
    pub(crate) fn enter<'a>(&mut self, mut row: CheckRow, cases: impl Iterator<Item = Trial<'a>>) {
        for Trial { index, inputs, comparisons, broken, .. } in cases {
            if broken.is_none() && comparisons.is_empty() {
                row.skipped += 1;
                continue;
            }
            row.cases += 1;
            if let Some(reason) = broken.or_else(|| row.compare(comparisons)) {
                row.failed += 1;
                self.failures.push(Failure { check: row.check.clone(), index, inputs, reason });
            }
        }
        self.rows.push(row.judged());
    }
}

impl CheckRow {
    /// Takes in the findings of a case; why it failed, if it did.
    fn compare(&mut self, findings: Vec<Finding>) -> Option<String> {
        let mut reasons = Vec::new();
        for finding in findings {
            if finding.error > finding.allowed {
                let Finding { quantity, error, allowed, .. } = &finding;
                reasons.push(format!("{quantity}: error {error:.3e}, allowed {allowed:.3e}"));
            }
            self.errors.push(finding.error);
            keep_larger(&mut self.worst, finding.clone(), |finding| finding.error);
            keep_larger(&mut self.tightest, finding, Finding::share);
        }
        (!reasons.is_empty()).then(|| reasons.join("; "))
    }

    /// Sorts the errors and gives the verdict.
    pub(crate) fn judged(mut self) -> Self {
        self.errors.sort_by(f64::total_cmp);
        self.verdict = match (self.failed, self.cases) {
            (0, 0) => CheckVerdict::Skipped,
            (0, _) => CheckVerdict::Pass,
            _ => CheckVerdict::Fail,
        };
        self
    }

    /// Takes in the same row of another shard.
    pub(crate) fn absorb(&mut self, other: CheckRow) {
        self.cases += other.cases;
        self.skipped += other.skipped;
        self.failed += other.failed;
        self.errors.extend(other.errors);
        if let Some(finding) = other.worst {
            keep_larger(&mut self.worst, finding, |finding| finding.error);
        }
        if let Some(finding) = other.tightest {
            keep_larger(&mut self.tightest, finding, Finding::share);
        }
    }
}

/// Keeps the finding of the larger measure; of equal ones that of the smaller index, so that order does not matter.
fn keep_larger(kept: &mut Option<Finding>, finding: Finding, measure: impl Fn(&Finding) -> f64) {
    let replaces = kept.as_ref().is_none_or(|kept| {
        (measure(&finding), std::cmp::Reverse(finding.index)) > (measure(kept), std::cmp::Reverse(kept.index))
    });
    if replaces {
        *kept = Some(finding);
    }
}
