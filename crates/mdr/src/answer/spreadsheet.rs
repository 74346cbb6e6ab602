//! Answers as tables of a spreadsheet: a column of numbers has numbers only.

use super::{Answer, FlatCell, FlatRow, NumberStyle, Output, columns};
use crate::scene::Scene;

/// log₁₀ of a number out of range has a column of its own.
const LOG10: &str = "log10_";
/// The promise of an output, or of a row of it that has its own.
const PROMISE: &str = "promise";

/// Moves log₁₀ of numbers out of range to columns of their own; `magnitude` takes log₁₀ in the SI unit and the key of the number.
fn separated(row: FlatRow, magnitude: impl Fn(f64, &str) -> f64) -> FlatRow {
    row.into_iter()
        .flat_map(|(key, cell)| match cell {
            FlatCell::Magnitude(log10) => {
                let log10 = magnitude(log10, &key).to_string();
                let magnitude = (format!("{LOG10}{key}").into(), FlatCell::Number(log10));
                vec![(key, FlatCell::Empty), magnitude]
            }
            cell => vec![(key, cell)],
        })
        .collect()
}

fn text(row: &FlatRow, key: &str) -> String {
    row.iter().find(|(name, _)| name == key).map_or_else(String::new, |(_, cell)| cell.to_string())
}

impl Answer {
    /// One table for all outputs, the titles first: the first two columns say which output, and its promise.
    pub fn spreadsheet(&self) -> Vec<Vec<String>> {
        let rows = self.outputs.iter().flat_map(|output| {
            let names = [output.kind().name(), output.promise().name()];
            output.table().into_iter().map(move |row| {
                let own = row.iter().find(|(key, _)| key == PROMISE).map(|(_, cell)| cell.to_string());
                let row = row.into_iter().filter(|(key, _)| key != PROMISE).collect();
                ([names[0].to_owned(), own.unwrap_or_else(|| names[1].to_owned())], separated(row, |log10, _| log10))
            })
        });
        let validity = self.validity.iter().map(|validity| {
            let names = ["validity", validity.promise().name()].map(str::to_owned);
            (names, separated(validity.table(), |log10, _| log10))
        });
        let rows: Vec<([String; 2], FlatRow)> = rows.chain(validity).collect();
        let keys = columns(rows.iter().map(|(_, row)| row));
        let header = ["output", PROMISE].into_iter().chain(keys.iter().map(AsRef::as_ref));
        let rows = rows
            .iter()
            .map(|(names, row)| names.iter().cloned().chain(keys.iter().map(|key| text(row, key))).collect());
        std::iter::once(header.map(str::to_owned).collect()).chain(rows).collect()
    }

    /// A table of one output, the titles first, with units in them: the inputs of its `scene`, a column each, then the columns of
    /// the output. Numbers are in the units of `style`.
    pub fn spreadsheet_of(&self, output: &Output, scene: &Scene, style: &NumberStyle) -> Vec<Vec<String>> {
        let style = &style.plain();
        let with_unit = |name: &str, unit: &str| match unit {
            "" => name.to_owned(),
            unit => format!("{name} ({})", style.unit(unit)),
        };
        let unit = |key: &str| self.title(output, key.strip_prefix(LOG10).unwrap_or(key)).1;
        let in_units = |row| separated(row, |log10, key| style.magnitude(log10, unit(key)));
        let rows: Vec<FlatRow> = output.table().into_iter().map(in_units).collect();
        let (inputs, keys) = (scene.inputs(), columns(&rows));
        let header = inputs.iter().map(|(name, unit, _)| with_unit(name, unit));
        let header = header.chain(keys.iter().map(|key| with_unit(key, unit(key)))).collect();
        let rows = rows.iter().map(|row| {
            let given = inputs.iter().map(|(_, unit, value)| style.number(value, unit));
            let found = keys.iter().map(|key| match key.starts_with(LOG10) {
                true => text(row, key),
                false => style.number(&text(row, key), unit(key)),
            });
            given.chain(found).collect()
        });
        std::iter::once(header).chain(rows).collect()
    }
}
