//! The sheet: strokes, marks, arrows and text at places given in tenths of a point.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::geometry::{Rect, Spot};
use super::typeset::{self, FAMILY, POINTS};
use super::{Mark, Stroke};

/// Units of the sheet in a point. Coordinates are whole numbers of units: 720 to the inch.
pub(crate) const PER_POINT: f64 = 10.0;

/// Length and half width of an arrow head, radius of a mark.
const HEAD: (f64, f64) = (62.0, 22.0);
const MARK: f64 = 27.0;

/// Corners of a diamond, in radii of a mark.
const DIAMOND: [Spot; 4] = [[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]];

const GREY: RGBColor = RGBColor(0xD9, 0xD9, 0xD9);

/// What the backend may complain about.
pub(crate) type Failed = Box<dyn std::error::Error + Send + Sync>;

/// The result of drawing something.
pub(crate) type Drawn = Result<(), Failed>;

/// A white sheet.
pub(crate) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

/// Where a text stands relative to its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stand {
    Centred,
    /// Ends there.
    Before,
    /// Begins there.
    After,
    /// Centred and upright along the left side of a frame.
    Upwards,
}

impl<'a> Canvas<'a> {
    /// An empty sheet whose SVG is written to `text`.
    pub(crate) fn new(text: &'a mut String, width: f64, height: f64) -> Result<Self, Failed> {
        let area = SVGBackend::with_string(text, (width.ceil() as u32, height.ceil() as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        Ok(Canvas { area })
    }

    /// A polyline.
    pub(crate) fn line(&self, line: &[Spot], stroke: Stroke) -> Drawn {
        let spots: Vec<_> = line.iter().map(|spot| whole(*spot)).collect();
        let style = BLACK.stroke_width(width(stroke));
        match pattern(stroke) {
            [] => self.area.draw(&PathElement::new(spots, style))?,
            pattern => {
                for dash in dashes(line, pattern) {
                    let dash: Vec<_> = dash.into_iter().map(whole).collect();
                    self.area.draw(&PathElement::new(dash, style))?;
                }
            }
        }
        Ok(())
    }

    /// A shaded area without border.
    pub(crate) fn area(&self, outline: &[Spot]) -> Drawn {
        let outline: Vec<_> = outline.iter().map(|spot| whole(*spot)).collect();
        Ok(self.area.draw(&Polygon::new(outline, GREY.filled()))?)
    }

    /// The border of a rectangle.
    pub(crate) fn frame(&self, rect: &Rect) -> Drawn {
        let corners =
            [[rect.left, rect.top], [rect.right, rect.top], [rect.right, rect.bottom], [rect.left, rect.bottom]];
        let spots: Vec<_> = corners.iter().chain(&corners[..2]).map(|spot| whole(*spot)).collect();
        Ok(self.area.draw(&PathElement::new(spots, BLACK.stroke_width(width(Stroke::Thin))))?)
    }

    /// A mark.
    pub(crate) fn mark(&self, at: Spot, mark: Mark) -> Drawn {
        let radius = MARK as i32;
        match mark {
            Mark::Filled => self.area.draw(&Circle::new(whole(at), radius, BLACK.filled()))?,
            Mark::Open => {
                self.area.draw(&Circle::new(whole(at), radius, WHITE.filled()))?;
                self.area.draw(&Circle::new(whole(at), radius - 4, BLACK.stroke_width(9)))?;
            }
            Mark::Diamond => {
                let corners = DIAMOND.map(|[x, y]| whole([at[0] + MARK * x, at[1] + MARK * y]));
                self.area.draw(&Polygon::new(corners, BLACK.filled()))?;
            }
        }
        Ok(())
    }

    /// An arrow; its tip is at `to`.
    pub(crate) fn arrow(&self, from: Spot, to: Spot, stroke: Stroke) -> Drawn {
        let (length, half) = HEAD;
        let reach = (to[0] - from[0]).hypot(to[1] - from[1]);
        // Too short for a head.
        if reach <= length {
            return self.line(&[from, to], stroke);
        }
        let along = [(to[0] - from[0]) / reach, (to[1] - from[1]) / reach];
        let back =
            |by: f64, aside: f64| [to[0] - by * along[0] - aside * along[1], to[1] - by * along[1] + aside * along[0]];
        self.line(&[from, back(0.8 * length, 0.0)], stroke)?;
        let head: Vec<_> = [to, back(length, half), back(0.75 * length, 0.0), back(length, -half)].map(whole).to_vec();
        Ok(self.area.draw(&Polygon::new(head, BLACK.filled()))?)
    }

    /// A line of text.
    pub(crate) fn text(&self, text: &str, at: Spot, stand: Stand) -> Drawn {
        let anchor = match stand {
            Stand::Centred | Stand::Upwards => HPos::Center,
            Stand::Before => HPos::Right,
            Stand::After => HPos::Left,
        };
        // The backend divides the size by 1.24.
        let font = FontDesc::new(FontFamily::Name(FAMILY), POINTS * PER_POINT * 1.24, FontStyle::Normal);
        let font = if stand == Stand::Upwards { font.transform(FontTransform::Rotate270) } else { font };
        let style = TextStyle::from(font).color(&BLACK).pos(Pos::new(anchor, VPos::Center));
        Ok(self.area.draw(&Text::new(text, whole(at), style))?)
    }

    /// Ends the drawing.
    pub(crate) fn finish(self) -> Drawn {
        Ok(self.area.present()?)
    }
}

/// The SVG as the backend wrote it, with its size in points, a title, a description, and the markup of its texts
/// translated.
pub(crate) fn finished(svg: &str, title: &str, description: &str) -> String {
    let mut lines = svg.lines();
    let head = lines.next().unwrap_or_default();
    let mut finished = String::with_capacity(svg.len() + description.len() + 512);
    finished.push_str(&in_points(head));
    let [title, description] = [title, description].map(typeset::escaped);
    finished.push_str(&format!("\n<title>{title}</title>\n<desc>{description}</desc>\n"));
    for line in lines {
        match line.strip_prefix("<text ") {
            // Element and content are on one line so that no blank is added to the text.
            Some(rest) => finished.push_str(&format!("<text {rest}")),
            None if line.starts_with('<') => finished.push_str(&format!("{line}\n")),
            None => finished.push_str(&typeset::tspans(line)),
        }
    }
    finished
}

/// The size of the sheet in points; corners of lines are round, and blanks beside an index are kept.
fn in_points(head: &str) -> String {
    let attribute = |head: &str, name: &str| -> Option<(String, f64)> {
        let value = head.split(&format!("{name}=\"")).nth(1)?.split('"').next()?;
        Some((format!("{name}=\"{value}\""), value.parse().ok()?))
    };
    let mut head = head.to_owned();
    for name in [" width", " height"] {
        if let Some((old, units)) = attribute(&head, name) {
            head = head.replacen(&old, &format!("{name}=\"{}pt\"", units / PER_POINT), 1);
        }
    }
    head.replacen(" xmlns=", " stroke-linejoin=\"round\" xml:space=\"preserve\" xmlns=", 1)
}

fn whole([x, y]: Spot) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
}

fn width(stroke: Stroke) -> u32 {
    match stroke {
        Stroke::Solid | Stroke::Dashed | Stroke::Dotted | Stroke::DashDotted => 12,
        Stroke::Thin => 7,
        Stroke::Guide => 6,
    }
}

/// Lengths of strokes and gaps in turn; none for an unbroken line.
fn pattern(stroke: Stroke) -> &'static [f64] {
    match stroke {
        Stroke::Solid | Stroke::Thin => &[],
        Stroke::Dashed => &[60.0, 34.0],
        Stroke::Dotted => &[14.0, 26.0],
        Stroke::DashDotted => &[70.0, 26.0, 14.0, 26.0],
        Stroke::Guide => &[8.0, 22.0],
    }
}

/// The strokes of a broken line.
fn dashes(line: &[Spot], pattern: &[f64]) -> Vec<Vec<Spot>> {
    let mut dashes = Vec::new();
    let mut current: Vec<Spot> = line.first().copied().into_iter().collect();
    let (mut index, mut rest) = (0, pattern.first().copied().unwrap_or(f64::INFINITY));
    for pair in line.windows(2) {
        let [mut from, to] = [pair[0], pair[1]];
        loop {
            let reach = (to[0] - from[0]).hypot(to[1] - from[1]);
            if reach <= rest {
                rest -= reach;
                current.push(to);
                break;
            }
            let share = rest / reach;
            from = [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
            current.push(from);
            if index % 2 == 0 {
                dashes.push(std::mem::take(&mut current));
            }
            current = vec![from];
            index = (index + 1) % pattern.len();
            rest = pattern[index];
        }
    }
    if index % 2 == 0 && current.len() > 1 {
        dashes.push(current);
    }
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_follow_the_line_around_its_corners() {
        let corner = [[0.0, 0.0], [5.0, 0.0], [5.0, 5.0]];
        assert_eq!(
            dashes(&corner, &[6.0, 2.0]),
            [vec![[0.0, 0.0], [5.0, 0.0], [5.0, 1.0]], vec![[5.0, 3.0], [5.0, 5.0]]]
        );
    }

    #[test]
    fn the_sheet_is_measured_in_points() {
        let svg = finished(
            "<svg width=\"3400\" height=\"2550\" viewBox=\"0 0 3400 2550\" xmlns=\"x\">\n<text x=\"1\">\n*a*\n</text>\n</svg>\n",
            "T & U",
            "E* < 1",
        );
        assert_eq!(
            svg,
            "<svg width=\"340pt\" height=\"255pt\" viewBox=\"0 0 3400 2550\" stroke-linejoin=\"round\" xml:space=\"preserve\" xmlns=\"x\">\n\
             <title>T &amp; U</title>\n<desc>E* &lt; 1</desc>\n\
             <text x=\"1\"><tspan font-style=\"italic\">a</tspan></text>\n</svg>\n"
        );
    }
}
