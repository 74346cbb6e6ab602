//! What an output cost.

use std::io::Write;
use std::time::Duration;

use mdr_core::contact::Evaluations;

use super::contact::NAMES;
use crate::error::{Failure, Result};
use crate::scene::Want;
use crate::table::{Tone, cell, render, table};

/// Evaluations by arithmetic, and the time.
pub(crate) struct Cost {
    want: Want,
    evaluations: [Evaluations; NAMES.len()],
    time: Duration,
}

impl Cost {
    /// From the tallies before and after.
    pub(crate) fn new(
        want: Want,
        before: [Evaluations; NAMES.len()],
        after: [Evaluations; NAMES.len()],
        time: Duration,
    ) -> Self {
        Cost { want, evaluations: std::array::from_fn(|i| after[i] - before[i]), time }
    }

    /// The arithmetics that were used, by name.
    fn used(&self) -> impl Iterator<Item = (&'static str, Evaluations)> {
        NAMES.into_iter().zip(self.evaluations).filter(|(_, evaluations)| *evaluations != Evaluations::default())
    }
}

/// A table on standard error: one row for each output and arithmetic.
pub(crate) fn write(costs: &[Cost]) -> Result<()> {
    let mut table = table(&["output", "arithmetic", "g", "slope", "integral", "time"]);
    for cost in costs {
        let time = format!("{:.3} s", cost.time.as_secs_f64());
        let mut rows: Vec<_> = cost.used().collect();
        if rows.is_empty() {
            rows.push(("none", Evaluations::default()));
        }
        for (index, (arithmetic, evaluations)) in rows.into_iter().enumerate() {
            let first = index == 0;
            table.add_row([
                cell(if first { cost.want.name() } else { "" }, Tone::Strong),
                cell(arithmetic, Tone::Plain),
                cell(evaluations.g, Tone::Plain),
                cell(evaluations.slope, Tone::Plain),
                cell(evaluations.integral, Tone::Plain),
                cell(if first { time.as_str() } else { "" }, Tone::Faint),
            ]);
        }
    }
    writeln!(std::io::stderr(), "{}", render(&table)).map_err(|error| Failure::file("standard error", error))
}
