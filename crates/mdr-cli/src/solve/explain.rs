//! What each output cost.

use std::io::Write;
use std::time::Duration;

use mdr::Cost;

use crate::error::{Failure, Result};
use crate::table::{Tone, cell, render, table};

/// A table on standard error: one row for each output and arithmetic.
pub(crate) fn write(costs: &[(Cost, Duration)]) -> Result<()> {
    let mut table = table(&["output", "arithmetic", "g", "slope", "integral", "time"]);
    for (cost, time) in costs {
        let time = format!("{:.3} s", time.as_secs_f64());
        let mut rows: Vec<_> = cost.used().collect();
        if rows.is_empty() {
            rows.push(("none", Default::default()));
        }
        for (index, (arithmetic, evaluations)) in rows.into_iter().enumerate() {
            let first = index == 0;
            table.add_row([
                cell(if first { cost.output.name() } else { "" }, Tone::Strong),
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
