//! The frame of a panel: from values to places on the sheet and back.

use super::geometry::{Rect, Spot};
use super::{Axis, Point};

/// A panel's axes laid over a rectangle of the sheet.
pub(crate) struct Frame<'a> {
    pub(crate) rect: Rect,
    pub(crate) x: &'a Axis,
    pub(crate) y: &'a Axis,
}

impl Frame<'_> {
    /// The place of a point; not finite where an axis has none.
    pub(crate) fn place(&self, [x, y]: Point) -> Spot {
        // Far outside is far enough: the drawing is cut at the frame.
        let within = |fraction: f64| if fraction.is_finite() { fraction.clamp(-1e6, 1e6) } else { fraction };
        [
            self.rect.left + within(self.x.fraction(x)) * self.rect.width(),
            self.rect.bottom - within(self.y.fraction(y)) * self.rect.height(),
        ]
    }

    pub(crate) fn places(&self, points: &[Point]) -> Vec<Spot> {
        points.iter().map(|point| self.place(*point)).collect()
    }
}
