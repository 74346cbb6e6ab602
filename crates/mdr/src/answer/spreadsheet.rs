//! Answers as tables of a spreadsheet: a column of numbers has numbers only.

use super::{Answer, FlatCell, FlatRow, Notation, Output, Reader, columns, title};
use crate::scene::Scene;

/// log₁₀ of what is out of range in a column of its own.
fn separated(row: FlatRow) -> FlatRow {
    row.into_iter()
        .flat_map(|(key, cell)| match cell {
            FlatCell::Magnitude(log10) => {
                let magnitude = (format!("log10_{key}").into(), FlatCell::Number(log10.to_string()));
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
            output.table().into_iter().map(move |row| (names, separated(row)))
        });
        let validity =
            self.validity.iter().map(|validity| (["validity", validity.promise().name()], separated(validity.table())));
        let rows: Vec<([&str; 2], FlatRow)> = rows.chain(validity).collect();
        let keys = columns(rows.iter().map(|(_, row)| row));
        let header = ["output", "promise"].into_iter().chain(keys.iter().map(AsRef::as_ref));
        let rows = rows.iter().map(|(names, row)| {
            names.iter().map(|name| (*name).to_owned()).chain(keys.iter().map(|key| text(row, key))).collect()
        });
        std::iter::once(header.map(str::to_owned).collect()).chain(rows).collect()
    }

    /// A table of one output, the titles first, with units in them: the inputs of its `scene`, a column each, then the columns of
    /// the output. Numbers are in the units of `reader`.
    pub fn spreadsheet_of(&self, output: &Output, scene: &Scene, reader: &Reader) -> Vec<Vec<String>> {
        let reader = &Reader { notation: Notation::Plain, ..reader.clone() };
        let with_unit = |name: &str, unit: &str| match unit {
            "" => name.to_owned(),
            unit => format!("{name} ({})", reader.unit(unit)),
        };
        let rows: Vec<FlatRow> = output.table().into_iter().map(separated).collect();
        let (inputs, keys) = (scene.inputs(), columns(&rows));
        let unit = |key| title(key, self.control).1;
        let header = inputs.iter().map(|(name, unit, _)| with_unit(name, unit));
        let header = header.chain(keys.iter().map(|key| with_unit(key, unit(key)))).collect();
        let rows = rows.iter().map(|row| {
            let given = inputs.iter().map(|(_, unit, value)| reader.number(value, unit));
            given.chain(keys.iter().map(|key| reader.number(&text(row, key), unit(key)))).collect()
        });
        std::iter::once(header).chain(rows).collect()
    }
}
