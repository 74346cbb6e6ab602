//! The data of a picture as a table, in base units, before they are scaled, cut and thinned out for drawing.

use std::io::Read;

use crate::chart::{Layer, Look, Panel, Picture, Stroke};
use crate::markup::plain;

/// The first line of the data of every picture.
pub const CSV_HEADER: &str = "panel,element,series,style,x_quantity,x,y_quantity,y,units";

/// The bytes from a file that tell whether it is the data of a picture.
const LONGEST_START: u64 = 1024;

/// Whether a file begins like the data of a picture. Lines of comments, which begin with `#`, may stand above.
pub fn is_data(from: impl Read) -> bool {
    let mut start = Vec::new();
    let read = from.take(LONGEST_START).read_to_end(&mut start);
    let mut lines = start.split(|byte| *byte == b'\n').skip_while(|line| line.starts_with(b"#"));
    read.is_ok() && lines.next().is_some_and(|line| line == CSV_HEADER.as_bytes())
}

impl Picture {
    /// The points of all areas, curves, marks and arrows as CSV, one a row, with the header [`CSV_HEADER`].
    ///
    /// Numbers are in base units with ten significant digits: more than a drawing shows, fewer than could differ between the
    /// elementary functions of two machines.
    pub fn csv(&self) -> String {
        let mut csv = format!("{CSV_HEADER}\n");
        for (index, panel) in self.panels.iter().enumerate() {
            for layer in &panel.layers {
                rows(index + 1, panel, layer, &mut csv);
            }
        }
        csv
    }
}

/// Adds the points of a layer; labels and guides are no data.
fn rows(number: usize, panel: &Panel, layer: &Layer, csv: &mut String) {
    let (element, style) = match layer.look {
        Look::Curve(Stroke::Guide) | Look::Label(_) => return,
        Look::Area => ("area", "shaded"),
        Look::Curve(stroke) => ("curve", stroke.name()),
        Look::Marks(mark) => ("mark", mark.name()),
        Look::Arrow => ("arrow", Stroke::Thin.name()),
    };
    let series = quoted(&plain(&layer.name));
    let [(x_name, x_unit), (y_name, y_unit)] =
        [&panel.x, &panel.y].map(|axis| (quoted(&plain(&axis.quantity)), axis.unit.base()));
    for [x, y] in &layer.points {
        csv.push_str(&format!(
            "{number},{element},{series},{style},{x_name},{x:.9e},{y_name},{y:.9e},{x_unit}; {y_unit}\n"
        ));
    }
}

/// A field as RFC 4180 has it.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
