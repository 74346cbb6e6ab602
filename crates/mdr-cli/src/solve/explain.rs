//! The cost of each output.

use std::io::Write;
use std::time::Duration;

use mdr::Cost;

use crate::error::{Failure, Result};
use crate::table::{CellStyle, cell, render, table};

/// A table on standard error: one row for each output and arithmetic.
pub(crate) fn write(costs: &[(Cost, Duration)]) -> Result<()> {
    let mut table = table(&["output", "arithmetic", "g", "slope", "integral", "time"]);
    for (cost, time) in costs {
        let used: Vec<_> = cost.used().collect();
        let rows = if used.is_empty() { vec![("none", Default::default())] } else { used };
        // The first row has the output and its time.
        let mut ends = [cost.output.name().to_owned(), format!("{:.3} s", time.as_secs_f64())];
        for (arithmetic, evaluations) in rows {
            let [output, time] = std::mem::take(&mut ends);
            let counts = [evaluations.g, evaluations.slope, evaluations.integral];
            let names = [cell(output, CellStyle::Strong), cell(arithmetic, CellStyle::Plain)].into_iter();
            let counts = counts.map(|count| cell(count, CellStyle::Plain));
            table.add_row(names.chain(counts).chain([cell(time, CellStyle::Faint)]));
        }
    }
    writeln!(std::io::stderr(), "{}", render(&table)).map_err(|error| Failure::file("standard error", error))
}
