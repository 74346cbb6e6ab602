//! One panel being drawn.

use super::LINE;
use super::layout::above;
use super::room::Room;
use super::style::class;
use super::words::{Word, words};
use crate::Axis;
use crate::chart::{Colour, Layer, Look, Mark, Panel, Point, Stroke};
use crate::markup::{plain, tspans};

/// Radius of a mark, length and half width of an arrow head.
pub(super) const MARK: f64 = 3.2;
const HEAD: (f64, f64) = (8.0, 3.0);

/// Between a frame and the numbers at its left.
pub(super) const NUMBERS: f64 = 6.0;

/// Points of a curve nearer to the last one than this are left out.
const NEAR: f64 = 0.3;

/// A panel being drawn; places are in points from the upper left corner of its frame.
pub(super) struct Frame<'a> {
    pub(super) panel: &'a Panel,
    pub(super) size: [f64; 2],
    /// What is to the left of the frame.
    pub(super) left: f64,
    pub(super) svg: &'a mut String,
}

impl<'a> Frame<'a> {
    pub(super) fn draw(&mut self) {
        let [width, height] = self.size;
        let panel: &'a Panel = self.panel;
        self.axes();
        // An SVG inside cuts what leaves the frame.
        self.svg.push_str(&format!("<svg class=\"frame\" width=\"{width:.0}\" height=\"{height:.0}\">\n"));
        for layer in panel.layers.iter().filter(|layer| matches!(layer.look, Look::Area | Look::Curve(_))) {
            self.layer(layer, &self.places(layer));
        }
        self.svg.push_str("</svg>\n");
        for layer in panel.layers.iter().filter(|layer| layer.look == Look::Arrow) {
            self.layer(layer, &self.places(layer));
        }
        for layer in panel.layers.iter().filter(|layer| matches!(layer.look, Look::Marks(_))) {
            self.layer(layer, &self.seen(layer));
        }
        for word in words(self) {
            self.word(&word);
        }
    }

    /// A layer with its points at these places; words look for theirs when all else is drawn.
    fn layer(&mut self, layer: &Layer, places: &[Point]) {
        match layer.look {
            Look::Area => self.path("area", layer.colour, &outline(places)),
            Look::Curve(stroke) => self.line(stroke, layer.colour, places),
            Look::Arrow => self.arrow(layer.colour, &self.arrow_line(places)),
            Look::Marks(mark) => places.iter().for_each(|at| self.mark(mark, layer.scale * MARK, layer.colour, *at)),
            Look::Label(_) => {}
        }
    }

    /// The heading, and the notes below it.
    pub(super) fn head(&mut self, height: f64) {
        let mut y = 12.0 - height;
        for (class, lines) in above(self.panel, self.size[0]) {
            for line in lines {
                self.text([0.0, y], class, &line);
                y += LINE;
            }
        }
    }

    /// A grid with numbers outside, a line at zero, and the names of both axes.
    fn axes(&mut self) {
        let (Panel { x, y, .. }, [width, height]) = (self.panel, self.size);
        for tick in x.ticks((width / 48.0) as usize) {
            let at = tick.fraction * width;
            self.svg.push_str(&format!("<path class=\"grid\" d=\"M{at:.1} 0V{height:.0}\"/>\n"));
            self.text([at, height + 14.0], "note middle", &tick.text);
        }
        for tick in y.ticks((height / 28.0) as usize) {
            let at = height - tick.fraction * height;
            self.svg.push_str(&format!("<path class=\"grid\" d=\"M0 {at:.1}H{width:.0}\"/>\n"));
            let class = if y.names().is_empty() { "note end" } else { "end" };
            self.text([-NUMBERS, at + 4.0], class, &tick.text);
        }
        let zero = height - y.fraction(0.0).clamp(0.0, 1.0) * height;
        if zero.is_finite() && y.names().is_empty() {
            self.svg.push_str(&format!("<path class=\"zero\" d=\"M0 {zero:.1}H{width:.0}\"/>\n"));
        }
        let zero = x.fraction(0.0);
        if (0.001..0.999).contains(&zero) {
            self.svg.push_str(&format!("<path class=\"zero\" d=\"M{:.1} 0V{height:.0}\"/>\n", zero * width));
        }
        self.text([width, height + 30.0], "end", &x.title());
        self.text([6.0 - self.left, -8.0], "", &y.title());
    }

    /// A word in the middle of its room, with the line to what it names.
    fn word(&mut self, word: &Word) {
        if let Some(ends) = word.leader {
            self.svg.push_str(&format!("<path class=\"leader\" d=\"{}\"/>\n", polyline(&ends)));
        }
        let [x, y] = word.room.centre;
        let top = y + 4.0 - 0.5 * LINE * (word.lines.len() as f64 - 1.0);
        for (row, line) in word.lines.iter().enumerate() {
            self.text([x, top + LINE * row as f64], &format!("label middle {}", class(word.colour)), line);
        }
    }

    /// The frame, or what it holds within a margin.
    pub(super) fn room(&self, margin: f64) -> Room {
        let [width, height] = self.size;
        Room::around([width / 2.0, height / 2.0], [width - 2.0 * margin, height - 2.0 * margin])
    }

    /// The line of an arrow as far as its head stays in the frame.
    pub(super) fn arrow_line(&self, places: &[Point]) -> Vec<Point> {
        self.room(HEAD.1 + 0.5).first_part(places)
    }

    /// The points of a layer within the frame.
    pub(super) fn seen(&self, layer: &Layer) -> Vec<Point> {
        self.places(layer).into_iter().filter(|at| self.room(0.0).holds(*at)).collect()
    }

    /// The points of a layer on the sheet; not finite where an axis has no place for one.
    pub(super) fn places(&self, layer: &Layer) -> Vec<Point> {
        // What is a thousand frames away is far enough.
        let within = |axis: &Axis, value: f64| {
            let fraction = axis.fraction(value);
            if fraction.is_finite() { fraction.clamp(-1e3, 1e3) } else { f64::NAN }
        };
        let Panel { x, y, .. } = self.panel;
        let place = |[a, b]: &Point| [within(x, *a) * self.size[0], (1.0 - within(y, *b)) * self.size[1]];
        layer.points.iter().map(place).collect()
    }

    fn text(&mut self, [x, y]: Point, class: &str, text: &str) {
        if !plain(text).is_empty() {
            self.svg.push_str(&format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>\n", tspans(text)));
        }
    }

    fn path(&mut self, kind: &str, colour: Colour, path: &str) {
        if !path.is_empty() {
            self.svg.push_str(&format!("<path class=\"{kind} {}\" d=\"{path}\"/>\n", class(colour)));
        }
    }

    fn line(&mut self, stroke: Stroke, colour: Colour, places: &[Point]) {
        let kind = if stroke == Stroke::Solid { "" } else { stroke.name() };
        self.path(format!("line {}", kind.replace('-', "")).trim_end(), colour, &polyline(places));
    }

    fn arrow(&mut self, colour: Colour, places: &[Point]) {
        let (length, half) = HEAD;
        let Some(to) = places.last() else { return };
        let reach = |from: &Point| (to[0] - from[0]).hypot(to[1] - from[1]);
        // Nearer to the tip than its own length, a direction is not seen.
        let Some(last) = places.iter().rposition(|place| reach(place) > length) else {
            return self.line(Stroke::Thin, colour, places);
        };
        let from = places[last];
        let along = [(to[0] - from[0]) / reach(&from), (to[1] - from[1]) / reach(&from)];
        let back =
            |by: f64, aside: f64| [to[0] - by * along[0] - aside * along[1], to[1] - by * along[1] + aside * along[0]];
        let mut line = places[..=last].to_vec();
        line.push(back(length, 0.0));
        self.line(Stroke::Thin, colour, &line);
        self.path("full tip", colour, &outline(&[*to, back(length, half), back(length, -half)]));
    }

    fn mark(&mut self, mark: Mark, radius: f64, colour: Colour, [x, y]: Point) {
        match mark {
            Mark::Filled | Mark::Open => {
                let kind = if mark == Mark::Filled { "full" } else { "open" };
                self.svg.push_str(&format!(
                    "<circle class=\"{kind} {}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius:.1}\"/>\n",
                    class(colour)
                ));
            }
            Mark::Diamond => {
                let reach = 1.4 * radius;
                self.path("full", colour, &outline(&[[x, y - reach], [x + reach, y], [x, y + reach], [x - reach, y]]));
            }
            Mark::Cross => {
                for rise in [-radius, radius] {
                    self.line(Stroke::Solid, colour, &[[x - radius, y - rise], [x + radius, y + rise]]);
                }
            }
        }
    }
}

/// The data of a path through the places, broken where one is not finite. Indistinguishable places are one.
fn polyline(places: &[Point]) -> String {
    let mut path = String::new();
    for part in places.split(|place| !place.iter().all(|x| x.is_finite())).filter(|part| part.len() > 1) {
        let mut last = [f64::NAN; 2];
        for (index, [x, y]) in part.iter().enumerate() {
            // The first place, which has none before it, is not near.
            let near = (x - last[0]).hypot(y - last[1]) < NEAR;
            if !near || index + 1 == part.len() {
                path.push_str(&format!("{}{x:.1} {y:.1}", if index == 0 { "M" } else { "L" }));
                last = [*x, *y];
            }
        }
    }
    path
}

/// The data of a closed path through the places.
fn outline(places: &[Point]) -> String {
    format!("{}Z", polyline(places))
}
