//! One panel being drawn.

use super::{LEFT, LINE, Legend, Name, Room, SAMPLE, class};
use crate::Axis;
use crate::chart::{Colour, Layer, Look, Mark, Panel, Point, Side, Stroke};
use crate::markup::{plain, tspans, width};

/// Radius of a mark, length and half width of an arrow head.
pub(super) const MARK: f64 = 3.2;
const HEAD: (f64, f64) = (8.0, 3.0);

/// Points of a curve nearer to the last one than this are left out.
const NEAR: f64 = 0.3;

/// A panel being drawn; places are in points from the upper left corner of its frame.
pub(super) struct Frame<'a> {
    pub(super) panel: &'a Panel,
    pub(super) size: [f64; 2],
    pub(super) svg: &'a mut String,
}

impl Frame<'_> {
    pub(super) fn draw(&mut self, named: Vec<Name<'_>>) {
        let [width, height] = self.size;
        self.axes();
        // An SVG inside cuts what leaves the frame.
        self.svg.push_str(&format!("<svg width=\"{width:.0}\" height=\"{height:.0}\">\n"));
        for layer in &self.panel.layers {
            if !matches!(layer.look, Look::Marks(_)) {
                self.layer(layer, &self.places(layer));
            }
        }
        self.svg.push_str("</svg>\n");
        let mut taken = Vec::new();
        for layer in &self.panel.layers {
            if let Look::Marks(_) = layer.look {
                let seen = self.seen(layer);
                self.layer(layer, &seen);
                taken.extend(seen.iter().map(|at| Room::around(*at, 2.0 * MARK, 2.0 * MARK)));
            }
        }
        for Name { text, colour, room } in named {
            self.name(text, colour, &room);
            taken.push(room);
        }
        for layer in &self.panel.layers {
            if let Look::Label(side) = layer.look {
                self.label(layer, side, &mut taken);
            }
        }
    }

    /// A layer with its points at these places; labels look for theirs when all else is drawn.
    fn layer(&mut self, layer: &Layer, places: &[Point]) {
        match layer.look {
            Look::Area => self.path("area", layer.colour, &outline(places)),
            Look::Curve(stroke) => self.line(stroke, layer.colour, places),
            Look::Arrow => self.arrow(layer.colour, places),
            Look::Marks(mark) => places.iter().for_each(|at| self.mark(mark, layer.colour, *at)),
            Look::Label(_) => {}
        }
    }

    /// The heading, and the legend below it.
    pub(super) fn head(&mut self, legend: &Legend<'_>, height: f64) {
        for (row, line) in legend.heading.iter().enumerate() {
            self.text([0.0, LINE * row as f64 + 12.0 - height], "heading", line);
        }
        for entry in &legend.entries {
            let y = LINE * ((legend.heading.len() + entry.row) as f64 + 0.5) - height;
            let ends = [[entry.left, y], [entry.left + SAMPLE - 6.0, y]];
            for layer in &entry.layers {
                match layer.look {
                    Look::Area => self.layer(layer, &corners(ends, 4.0)),
                    Look::Marks(_) => self.layer(layer, &[[f64::midpoint(ends[0][0], ends[1][0]), y]]),
                    _ => self.layer(layer, &ends),
                }
            }
            self.text([entry.left + entry.indent(), y + 4.0], "", entry.text);
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
            self.text([-6.0, at + 4.0], "note end", &tick.text);
        }
        let zero = height - y.fraction(0.0).clamp(0.0, 1.0) * height;
        if zero.is_finite() {
            self.svg.push_str(&format!("<path class=\"zero\" d=\"M0 {zero:.1}H{width:.0}\"/>\n"));
        }
        self.text([width, height + 30.0], "end", &x.title());
        self.text([-LEFT + 6.0, -8.0], "", &y.title());
    }

    /// Writes a text on the wanted side of the first of its places with room for it there, else on another side; without any
    /// room beside the first place.
    fn label(&mut self, layer: &Layer, side: Side, taken: &mut Vec<Room>) {
        let anchors = self.seen(layer);
        let size = (width(&layer.name), LINE - 2.0);
        let sides = [side, Side::Right, Side::Left, Side::Above, Side::Below];
        let rooms = || sides.into_iter().flat_map(|side| anchors.iter().map(move |at| Room::beside(*at, side, size)));
        let free = |room: &Room| self.holds(room) && !taken.iter().any(|other| room.overlaps(other));
        let Some(room) = rooms().find(free).or_else(|| rooms().next()) else { return };
        self.name(&layer.name, layer.colour, &room);
        taken.push(room);
    }

    /// A text in the middle of its room.
    fn name(&mut self, text: &str, colour: Colour, room: &Room) {
        self.text([room.centre[0], room.centre[1] + 4.0], &format!("label middle {}", class(colour)), text);
    }

    pub(super) fn holds(&self, room: &Room) -> bool {
        (0..2)
            .all(|axis| room.centre[axis] >= room.half[axis] && room.centre[axis] <= self.size[axis] - room.half[axis])
    }

    /// The points of a layer within the frame.
    pub(super) fn seen(&self, layer: &Layer) -> Vec<Point> {
        self.places(layer).into_iter().filter(|at| self.holds(&Room::around(*at, 0.0, 0.0))).collect()
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
        self.path("full", colour, &outline(&[*to, back(length, half), back(length, -half)]));
    }

    fn mark(&mut self, mark: Mark, colour: Colour, [x, y]: Point) {
        match mark {
            Mark::Filled | Mark::Open => {
                let kind = if mark == Mark::Filled { "full" } else { "open" };
                self.svg.push_str(&format!(
                    "<circle class=\"{kind} {}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{MARK}\"/>\n",
                    class(colour)
                ));
            }
            Mark::Diamond => {
                let reach = 1.4 * MARK;
                self.path("full", colour, &outline(&[[x, y - reach], [x + reach, y], [x, y + reach], [x - reach, y]]));
            }
            Mark::Cross => {
                for rise in [-MARK, MARK] {
                    self.line(Stroke::Solid, colour, &[[x - MARK, y - rise], [x + MARK, y + rise]]);
                }
            }
        }
    }
}

/// The rectangle around a horizontal line.
fn corners([[left, y], [right, _]]: [Point; 2], half: f64) -> [Point; 4] {
    [[left, y - half], [right, y - half], [right, y + half], [left, y + half]]
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
