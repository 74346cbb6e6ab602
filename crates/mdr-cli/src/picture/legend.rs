//! The legend: rows of samples with their meaning, above the frame, where no data are.

use super::canvas::{Canvas, Drawn, PER_POINT, Stand};
use super::geometry::Spot;
use super::{Key, Stroke, typeset};

/// The room between a sample and its meaning, and between two entries.
const GAP: f64 = 50.0;
const COLUMN_GAP: f64 = 150.0;

/// The width of a sample.
fn sample(key: Key) -> f64 {
    match key {
        Key::Mark(_) => 60.0,
        Key::Line(_) | Key::Arrow => 280.0,
        Key::Area => 200.0,
        Key::Text => 0.0,
    }
}

/// An entry and its place.
pub(crate) struct Entry<'a> {
    key: Key,
    text: &'a str,
    left: f64,
    row: usize,
}

/// Entries one after the other, in a new row where the width is used up; and the number of rows.
pub(crate) fn arranged(legend: &[(Key, String)], width: f64) -> (Vec<Entry<'_>>, usize) {
    let (mut left, mut row) = (0.0, 0);
    let mut entries = Vec::with_capacity(legend.len());
    for (key, text) in legend {
        let need = sample(*key) + GAP + PER_POINT * typeset::width(text);
        if left > 0.0 && left + need > width {
            (left, row) = (0.0, row + 1);
        }
        entries.push(Entry { key: *key, text, left, row });
        left += need + COLUMN_GAP;
    }
    let rows = if legend.is_empty() { 0 } else { row + 1 };
    (entries, rows)
}

impl Entry<'_> {
    /// Draws the entry of a legend whose first row has its middle at `origin`.
    pub(crate) fn draw(&self, canvas: &Canvas<'_>, origin: Spot) -> Drawn {
        let y = origin[1] + self.row as f64 * row_height();
        let left = origin[0] + self.left;
        let width = sample(self.key);
        let ends = [[left, y], [left + width, y]];
        match self.key {
            Key::Line(stroke) => canvas.line(&ends, stroke)?,
            Key::Mark(mark) => canvas.mark([left + width / 2.0, y], mark)?,
            Key::Arrow => canvas.arrow(ends[0], ends[1], Stroke::Thin)?,
            Key::Text => {}
            Key::Area => {
                let half = 40.0;
                let [[left, _], [right, _]] = ends;
                canvas.area(&[[left, y - half], [right, y - half], [right, y + half], [left, y + half]])?;
            }
        }
        canvas.text(self.text, [left + width + GAP, y], Stand::After)
    }
}

/// Height of a row.
pub(crate) fn row_height() -> f64 {
    PER_POINT * typeset::height() * 1.1
}
