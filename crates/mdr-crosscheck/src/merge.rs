//! Reports as lines of JSON: shards concatenate, and the lines of all shards merge into the report of the whole.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use mdr_core::text::excerpt;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::checks::registry;
use crate::options::Shard;
use crate::report::{CheckRow, Failure, Grid, VerifyReport};

/// The schema that every line names.
const SCHEMA: &str = "mdr.verify/1";

/// One line: a row or a failing case, with the identity of the run.
#[derive(Serialize, Deserialize)]
struct Line {
    schema: String,
    #[serde(flatten)]
    grid: Grid,
    shard: Shard,
    #[serde(flatten)]
    content: Content,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Content {
    Row(CheckRow),
    Failure(Failure),
}

/// Why lines do not make a report.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MergeError {
    /// A line is not one of ours.
    #[error("line {line} is no line of a verification: {}", excerpt(&source.to_string()))]
    Line {
        /// Counted from 1.
        line: usize,
        /// The error of the parser.
        source: serde_json::Error,
    },
    /// Lines of different grids, or of different partitions.
    #[error("line {line} belongs to another run: its {what} differs")]
    Mixed {
        /// Counted from 1.
        line: usize,
        /// The property that differs.
        what: &'static str,
    },
    /// Not every part is there exactly once.
    #[error("check {}: incomplete: {got} of {count} shards present", excerpt(check))]
    Incomplete {
        /// The check.
        check: String,
        /// Different shards found.
        got: usize,
        /// Shards there should be.
        count: u32,
    },
    /// One part of a check occurs twice.
    #[error("line {line}: shard {shard} of check {} is repeated", excerpt(check))]
    Repeated {
        /// Counted from 1.
        line: usize,
        /// The shard.
        shard: Shard,
        /// The check.
        check: String,
    },
    /// Nothing at all.
    #[error("no lines to merge")]
    Empty,
}

impl VerifyReport {
    /// One line of JSON a row, then one for each failing case.
    pub fn to_json_lines(&self) -> String {
        let mut lines = String::new();
        let mut push = |content| {
            let line = Line { schema: SCHEMA.to_owned(), grid: self.grid.clone(), shard: self.shard, content };
            // Strings, integers and finite numbers only: this cannot fail.
            let _ = writeln!(lines, "{}", serde_json::to_string(&line).unwrap_or_default());
        };
        self.rows.iter().cloned().for_each(|row| push(Content::Row(row)));
        self.failures.iter().cloned().for_each(|failure| push(Content::Failure(failure)));
        lines
    }

    /// The report of the whole from the lines of all its shards, in any order. It equals the report of one run over the
    /// whole, bit for bit.
    ///
    /// # Errors
    /// [`MergeError`] when a line is foreign, when the lines are of different runs, or when a shard is missing or twice.
    pub fn from_json_lines(text: &str) -> Result<VerifyReport, MergeError> {
        let mut report: Option<VerifyReport> = None;
        let mut count = 0;
        let mut seen: Vec<BTreeSet<Shard>> = Vec::new();
        for (number, text) in text.lines().enumerate().filter(|(_, text)| !text.trim().is_empty()) {
            let line = number + 1;
            let Line { schema, grid, shard, content } =
                serde_json::from_str(text).map_err(|source| MergeError::Line { line, source })?;
            let report = report.get_or_insert_with(|| {
                count = shard.count();
                VerifyReport { grid: grid.clone(), shard: Shard::WHOLE, rows: Vec::new(), failures: Vec::new() }
            });
            let foreign = [
                (schema != SCHEMA, "schema"),
                (grid != report.grid, "grid"),
                (shard.count() != count, "number of shards"),
            ];
            if let Some((_, what)) = foreign.into_iter().find(|(differs, _)| *differs) {
                return Err(MergeError::Mixed { line, what });
            }
            match content {
                Content::Failure(failure) => report.failures.push(failure),
                Content::Row(row) => match report.rows.iter().position(|known| known.check == row.check) {
                    None => {
                        seen.push(BTreeSet::from([shard]));
                        report.rows.push(row);
                    }
                    Some(position) if seen[position].insert(shard) => report.rows[position].absorb(row),
                    Some(_) => return Err(MergeError::Repeated { line, shard, check: row.check }),
                },
            }
        }
        let mut report = report.ok_or(MergeError::Empty)?;
        if let Some((row, shards)) = report.rows.iter().zip(&seen).find(|(_, shards)| shards.len() != count as usize) {
            return Err(MergeError::Incomplete { check: row.check.clone(), got: shards.len(), count });
        }
        report.rows = report.rows.into_iter().map(CheckRow::judged).collect();
        let rank = |name: &str| registry().iter().position(|check| check.row.check == name);
        report.rows.sort_by_key(|row| rank(&row.check));
        report.failures.sort_by_key(|failure| (rank(&failure.check), failure.index));
        Ok(report)
    }
}
