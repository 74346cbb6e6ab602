//! From a picture to its SVG.

use super::canvas::{self, Canvas, Drawn, Failed, PER_POINT, Stand};
use super::frame::Frame;
use super::geometry::{Rect, Spot, simplified};
use super::placement::{Obstacles, leader};
use super::{Axis, Layer, Panel, Picture, Point, Side, Stroke, legend, typeset};
use crate::error::{Failure, Result};

/// Room around the frames, in units of the sheet.
const LEFT: f64 = 590.0;
const RIGHT: f64 = 160.0;
const BELOW: f64 = 480.0;
const MARGIN: f64 = 110.0;
const FRAME_WIDTH: f64 = 3900.0;

/// Between a frame and the numbers of its ticks.
const AT_TICK: f64 = 50.0;

/// Length of a tick.
const TICK: f64 = 40.0;

/// Points nearer to the line than this are not drawn.
const TOLERANCE: f64 = 0.5;

/// A panel with its place on the sheet.
struct Placed<'a> {
    panel: &'a Panel,
    frame: Frame<'a>,
    top: f64,
}

/// The SVG of a picture.
///
/// # Errors
/// None that is known: the drawing is made in memory.
pub(crate) fn svg(picture: &Picture) -> Result<String> {
    drawn(picture)
        .map(|(svg, _)| svg)
        .map_err(|error| Failure::file(picture.title.clone(), std::io::Error::other(error)))
}

/// The labels for which no free place was found.
#[cfg(test)]
pub(crate) fn crowded(picture: &Picture) -> Vec<String> {
    drawn(picture).unwrap().1
}

/// The SVG, and the labels that cover something or are left out.
fn drawn(picture: &Picture) -> std::result::Result<(String, Vec<String>), Failed> {
    let (placed, height) = arranged(&picture.panels);
    let mut svg = String::new();
    let mut crowded = Vec::new();
    let canvas = Canvas::new(&mut svg, LEFT + FRAME_WIDTH + RIGHT, height)?;
    for panel in &placed {
        panel.draw(&canvas, &mut crowded)?;
    }
    canvas.finish()?;
    Ok((canvas::finished(&svg, &picture.title, &picture.description), crowded))
}

/// The panels from top to bottom, and the height of the sheet.
fn arranged(panels: &[Panel]) -> (Vec<Placed<'_>>, f64) {
    let mut y = 0.0;
    let mut placed = Vec::with_capacity(panels.len());
    for panel in panels {
        let top = y + MARGIN;
        let (_, rows) = legend::arranged(&panel.legend, FRAME_WIDTH);
        let lines = rows + usize::from(!panel.heading.is_empty());
        let frame_top = top + lines as f64 * legend::row_height();
        let bottom = frame_top + panel.aspect * FRAME_WIDTH;
        let rect = Rect { left: LEFT, top: frame_top, right: LEFT + FRAME_WIDTH, bottom };
        placed.push(Placed { panel, frame: Frame { rect, x: &panel.x, y: &panel.y }, top });
        y = bottom + BELOW;
    }
    (placed, y)
}

impl Placed<'_> {
    fn draw(&self, canvas: &Canvas<'_>, crowded: &mut Vec<String>) -> Drawn {
        let mut obstacles = Obstacles::default();
        self.areas(canvas)?;
        self.axes(canvas)?;
        self.head(canvas)?;
        for layer in &self.panel.layers {
            self.lines(canvas, layer, &mut obstacles)?;
        }
        // Marks lie over lines.
        for layer in &self.panel.layers {
            self.marks(canvas, layer, &mut obstacles)?;
        }
        for layer in &self.panel.layers {
            let Layer::Label { text, anchors, side } = layer else { continue };
            if !self.label(canvas, (text, anchors, *side), &mut obstacles)? {
                crowded.push(text.clone());
            }
        }
        Ok(())
    }

    fn head(&self, canvas: &Canvas<'_>) -> Drawn {
        let left = self.frame.rect.left;
        let mut y = self.top + legend::row_height() / 2.0;
        if !self.panel.heading.is_empty() {
            canvas.text(&self.panel.heading, [left, y], Stand::After)?;
            y += legend::row_height();
        }
        for entry in legend::arranged(&self.panel.legend, FRAME_WIDTH).0 {
            entry.draw(canvas, [left, y - 0.15 * legend::row_height()])?;
        }
        Ok(())
    }

    fn axes(&self, canvas: &Canvas<'_>) -> Drawn {
        let Frame { rect, x, y } = &self.frame;
        canvas.frame(rect)?;
        let most = |length: f64, apart: f64| (length / apart) as usize;
        for tick in x.ticks(most(rect.width(), 480.0)) {
            let at = rect.left + tick.fraction * rect.width();
            canvas.line(&[[at, rect.bottom], [at, rect.bottom - TICK]], Stroke::Thin)?;
            canvas.line(&[[at, rect.top], [at, rect.top + TICK]], Stroke::Thin)?;
            canvas.text(&tick.text, [at, rect.bottom + 100.0], Stand::Centred)?;
        }
        for tick in y.ticks(most(rect.height(), 300.0)) {
            let at = rect.bottom - tick.fraction * rect.height();
            canvas.line(&[[rect.left, at], [rect.left + TICK, at]], Stroke::Thin)?;
            canvas.line(&[[rect.right, at], [rect.right - TICK, at]], Stroke::Thin)?;
            canvas.text(&tick.text, [rect.left - AT_TICK, at], Stand::Before)?;
        }
        canvas.text(&x.title(), [(rect.left + rect.right) / 2.0, rect.bottom + 280.0], Stand::Centred)?;
        canvas.text(&y.title(), [130.0, (rect.top + rect.bottom) / 2.0], Stand::Upwards)?;
        self.zero(canvas, y)
    }

    /// A reference line where the vertical axis passes zero within its range.
    fn zero(&self, canvas: &Canvas<'_>, y: &Axis) -> Drawn {
        let Rect { left, right, top, bottom } = self.frame.rect;
        let at = bottom - y.fraction(0.0) * (bottom - top);
        if at > top && at < bottom { canvas.line(&[[left, at], [right, at]], Stroke::Guide) } else { Ok(()) }
    }

    fn areas(&self, canvas: &Canvas<'_>) -> Drawn {
        for layer in &self.panel.layers {
            if let Layer::Area { outline, .. } = layer {
                let rect = &self.frame.rect;
                let inside = |[x, y]: Spot| [x.clamp(rect.left, rect.right), y.clamp(rect.top, rect.bottom)];
                let outline: Vec<_> = self.frame.places(outline).into_iter().map(inside).collect();
                canvas.area(&simplified(&outline, TOLERANCE))?;
            }
        }
        Ok(())
    }

    fn lines(&self, canvas: &Canvas<'_>, layer: &Layer, obstacles: &mut Obstacles) -> Drawn {
        match layer {
            Layer::Curve { points, stroke, .. } => {
                for part in self.frame.rect.clip_line(&self.frame.places(points)) {
                    let part = simplified(&part, TOLERANCE);
                    canvas.line(&part, *stroke)?;
                    obstacles.line(&part);
                }
            }
            Layer::Arrow { from, to, stroke, .. } => {
                let [from, to] = [*from, *to].map(|point| self.frame.place(point));
                debug_assert!(from.iter().chain(&to).all(|x| x.is_finite()));
                if let Some((from, to)) = self.frame.rect.clip(from, to) {
                    canvas.arrow(from, to, *stroke)?;
                    obstacles.line(&[from, to]);
                    obstacles.block(Rect::around(to, 60.0, 60.0));
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn marks(&self, canvas: &Canvas<'_>, layer: &Layer, obstacles: &mut Obstacles) -> Drawn {
        let Layer::Marks { points, mark, .. } = layer else { return Ok(()) };
        for spot in self.frame.places(points) {
            let rect = Rect::around(spot, 50.0, 50.0);
            if self.frame.rect.overlaps(&rect) {
                canvas.mark(spot, *mark)?;
                obstacles.block(rect);
            }
        }
        Ok(())
    }

    /// Whether the label has a place of its own.
    fn label(
        &self,
        canvas: &Canvas<'_>,
        (text, anchors, side): (&str, &[Point], Side),
        obstacles: &mut Obstacles,
    ) -> std::result::Result<bool, Failed> {
        let size = (PER_POINT * typeset::width(text), PER_POINT * typeset::height());
        // Not over the ticks.
        let room = self.frame.rect.shrunk(1.3 * TICK);
        let inside = |spot: &Spot| self.frame.rect.contains(&Rect::around(*spot, 0.0, 0.0));
        let anchors: Vec<_> = self.frame.places(anchors).into_iter().filter(inside).collect();
        let Some((rect, covered)) = obstacles.place(&room, &anchors, size, side) else { return Ok(false) };
        if let Some((from, to)) = leader(&rect, &anchors) {
            canvas.line(&[from, to], Stroke::Guide)?;
        }
        canvas.text(text, [(rect.left + rect.right) / 2.0, (rect.top + rect.bottom) / 2.0], Stand::Centred)?;
        obstacles.block(rect);
        Ok(covered == 0.0)
    }
}
