//! From a picture to its SVG: one file for screens, light or dark, and for print.

mod frame;

use crate::chart::{Colour, Layer, Look, Panel, Picture, Point, Side, Stroke, Theme};
use crate::markup::{SIZE, escaped, lines, width};
use frame::{Frame, MARK};

/// Width and height of the frame of a panel in points: alone, one of two or more, one of three.
const ALONE: [f64; 2] = [420.0, 260.0];
const PAIRED: [f64; 2] = [320.0, 220.0];
const ONE_OF_THREE: [f64; 2] = [250.0, 210.0];

/// Room around a frame: for the numbers of the ticks, the next panel, the name of the horizontal axis.
const LEFT: f64 = 54.0;
const RIGHT: f64 = 24.0;
const BELOW: f64 = 46.0;
const MARGIN: f64 = 14.0;

/// Height of a line of text, and the width of a sample in a legend.
const LINE: f64 = 16.0;
const SAMPLE: f64 = 28.0;

/// Between a point's mark and its label.
const GAP: f64 = 4.0;

/// Curves of a panel that can be told by their names beside them; more have a legend.
const MOST_NAMED: usize = 4;

/// Class, colour on white, colour in the dark.
const PALETTE: [(Colour, &str, &str, &str); 8] = [
    (Colour::Ink, "ink", "#1c2127", "#e9ecef"),
    (Colour::Blue, "blue", "#0b62a8", "#62b5f5"),
    (Colour::Orange, "orange", "#b8480b", "#ff9d57"),
    (Colour::Purple, "purple", "#ca75ba", "#c77fc3"),
    (Colour::Green, "green", "#1f6b4a", "#6fd0a3"),
    (Colour::Grey, "grey", "#7f8a93", "#8a96a1"),
    (Colour::Sky, "sky", "#56b4e9", "#8fd0f5"),
    (Colour::Amber, "amber", "#c98b00", "#e6b84a"),
];

/// All that does not depend on light and dark, a rule a line. Halos keep labels legible on lines.
const STYLE: &str = include_str!("style.css");

/// The colours that depend on light and dark: name, light, dark.
const SHADES: [(&str, &str, &str); 5] = [
    ("var-page", "#ffffff", "#1a1e23"),
    ("var-text", "#1c2127", "#e9ecef"),
    ("var-muted", "#59636e", "#a0aab4"),
    ("var-grid", "#e8e6e0", "#2c343c"),
    ("var-zero", "#a8a69f", "#59636e"),
];

impl Picture {
    /// The SVG, well-formed XML whose sizes are in points, with the title and the description of the picture in it.
    ///
    /// It is a function of the picture alone: the same bytes on every run. It needs no font of its own.
    pub fn svg(&self) -> String {
        self.svg_in(Theme::Auto)
    }

    /// The SVG in fixed colours, for print, or for a page that is light or dark whatever the system of the reader is. See
    /// [`svg`](Picture::svg).
    pub fn svg_in(&self, theme: Theme) -> String {
        // Three panels fill a row; of other numbers two do.
        let columns = if self.panels.len() == 3 { 3 } else { self.panels.len().clamp(1, 2) };
        let frame = [ALONE, PAIRED, ONE_OF_THREE][columns - 1];
        let cell = LEFT + frame[0] + RIGHT;
        let (mut top, mut body) = (MARGIN, String::new());
        for row in self.panels.chunks(columns) {
            let named: Vec<_> = row.iter().map(|panel| named(panel, frame)).collect();
            let legends: Vec<_> =
                row.iter().zip(&named).map(|(panel, named)| Legend::new(panel, frame[0], named)).collect();
            let head = legends.iter().map(Legend::height).fold(0.0, f64::max);
            for (column, ((panel, legend), named)) in row.iter().zip(&legends).zip(named).enumerate() {
                let corner = [column as f64 * cell + LEFT, top + head];
                body.push_str(&format!("<g transform=\"translate({:.0} {:.0})\">\n", corner[0], corner[1]));
                let mut frame = Frame { panel, size: frame, svg: &mut body };
                frame.head(legend, head);
                frame.draw(named);
                body.push_str("</g>\n");
            }
            top += head + frame[1] + BELOW;
        }
        let [title, description] = [&self.title, &self.description].map(|text| escaped(text));
        let (width, height) = (columns as f64 * cell, top);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}pt\" height=\"{height:.0}pt\" viewBox=\"0 0 {width:.0} {height:.0}\" \
             role=\"img\" font-family=\"Inter, Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\" font-size=\"{SIZE}\" \
             xml:space=\"preserve\">\n<title>{title}</title>\n<desc>{description}</desc>\n<style>{}</style>\n\
             <rect class=\"page\" width=\"100%\" height=\"100%\"/>\n{body}</svg>\n",
            style(theme)
        )
    }
}

/// The style sheet. Colours are written out, since some programs that print SVG do not support variables.
fn style(theme: Theme) -> String {
    let shaded = |dark: bool| {
        let colours = PALETTE
            .iter()
            .map(|(_, class, light, night)| format!(".{class}{{color:{}}}", if dark { night } else { light }));
        let rules = SHADES.iter().fold(STYLE.replace('\n', ""), |rules, (name, light, night)| {
            rules.replace(name, if dark { night } else { light })
        });
        colours.collect::<String>() + &rules
    };
    match theme {
        Theme::Auto => format!("{}@media screen and (prefers-color-scheme:dark){{{}}}", shaded(false), shaded(true)),
        Theme::Light => shaded(false),
        Theme::Dark => shaded(true),
        Theme::Paper => PALETTE.iter().fold(shaded(false), |style, (_, class, light, _)| {
            // Lines of a black and white print differ by their strokes.
            let black = if matches!(*class, "purple" | "grey" | "sky" | "amber") { "#6a6a6a" } else { "#000000" };
            style.replace(&format!(".{class}{{color:{light}}}"), &format!(".{class}{{color:{black}}}"))
        }),
    }
}

fn class(colour: Colour) -> &'static str {
    PALETTE.iter().find(|(other, ..)| *other == colour).map_or("ink", |(_, class, ..)| class)
}

/// The heading of a panel in lines, and below it what its lines and marks mean in rows, above the frame.
struct Legend<'a> {
    heading: Vec<String>,
    entries: Vec<Entry<'a>>,
    rows: usize,
}

/// A text with the layers that share it, and its place.
struct Entry<'a> {
    text: &'a str,
    layers: Vec<&'a Layer>,
    left: f64,
    row: usize,
}

impl Entry<'_> {
    /// The room of the sample; a note has none.
    fn indent(&self) -> f64 {
        if self.layers.iter().all(|layer| matches!(layer.look, Look::Label(_))) { 0.0 } else { SAMPLE }
    }
}

impl<'a> Legend<'a> {
    /// Entries one after the other, in a new row where `room` is used up. Curves that are named beside them need none.
    fn new(panel: &'a Panel, room: f64, named: &[Name<'_>]) -> Self {
        let mut entries: Vec<Entry<'a>> = Vec::new();
        for layer in &panel.layers {
            let Some(text) = layer.legend.as_deref() else { continue };
            if named.iter().any(|name| name.text == text) {
                continue;
            }
            match entries.iter_mut().find(|known| known.text == text) {
                Some(Entry { layers, .. }) if layers.iter().any(|known| known.look == layer.look) => {}
                Some(Entry { layers, .. }) => layers.push(layer),
                None => entries.push(Entry { text, layers: vec![layer], left: 0.0, row: 0 }),
            }
        }
        // Lines, then marks, then the rest, as they come.
        entries.sort_by_key(|entry| match entry.layers[0].look {
            Look::Curve(_) => 0,
            Look::Marks(_) => 1,
            Look::Area | Look::Arrow => 2,
            Look::Label(_) => 3,
        });
        let (mut left, mut row) = (0.0, 0);
        for entry in &mut entries {
            let need = entry.indent() + width(entry.text);
            if left > 0.0 && left + need > room {
                (left, row) = (0.0, row + 1);
            }
            (entry.left, entry.row) = (left, row);
            left += need + MARGIN;
        }
        let rows = if entries.is_empty() { 0 } else { row + 1 };
        Legend { heading: lines(&panel.heading, room), entries, rows }
    }

    /// With the name of the vertical axis below.
    fn height(&self) -> f64 {
        LINE * ((self.heading.len() + self.rows) as f64 + 1.0) + 4.0
    }
}

/// The name of a curve beside it.
struct Name<'a> {
    text: &'a str,
    colour: Colour,
    room: Room,
}

/// The curves that can be named beside them: those that alone have their entry of the legend, where there is room that no
/// line crosses.
fn named(panel: &Panel, size: [f64; 2]) -> Vec<Name<'_>> {
    let mut svg = String::new();
    let frame = Frame { panel, size, svg: &mut svg };
    let alone = |layer: &Layer| panel.layers.iter().filter(|other| other.legend == layer.legend).count() == 1;
    let is_curve =
        |layer: &Layer| layer.legend.is_some() && matches!(layer.look, Look::Curve(stroke) if stroke != Stroke::Guide);
    if panel.layers.iter().filter(|layer| is_curve(layer)).count() > MOST_NAMED {
        return Vec::new();
    }
    // Marks, labels at their first place, and lines as rows of small rooms, are in the way; each with its layer.
    let mut taken = Vec::new();
    for (index, layer) in panel.layers.iter().enumerate() {
        let places = frame.places(layer);
        let rooms: Vec<Room> = match layer.look {
            Look::Marks(_) => places.iter().map(|at| Room::around(*at, 4.0 * MARK, 4.0 * MARK)).collect(),
            Look::Label(side) => {
                let size = (width(&layer.name), LINE);
                places.first().map(|at| Room::beside(*at, side, size)).into_iter().collect()
            }
            Look::Curve(_) | Look::Arrow => places.windows(2).flat_map(|ends| along(ends[0], ends[1])).collect(),
            Look::Area => Vec::new(),
        };
        taken.extend(rooms.into_iter().map(|room| (index, room)));
    }
    let mut names: Vec<Name<'_>> = Vec::new();
    for (index, layer) in panel.layers.iter().enumerate().filter(|(_, layer)| is_curve(layer) && alone(layer)) {
        let Some(text) = layer.legend.as_deref() else { continue };
        let size = (width(text), LINE - 3.0);
        let seen = frame.seen(layer);
        // From the outer end inwards, since there curves lie apart.
        let anchors = (1..40).rev().filter_map(|part| seen.get(part * seen.len() / 40));
        // Nothing is under the name, and no other line between it and its curve.
        let free = |(at, room): &(Point, Room)| {
            let bridge = Room::between(*at, room);
            frame.holds(room)
                && !taken.iter().any(|(_, other)| room.overlaps(other))
                && !taken.iter().any(|(of, other)| *of != index && bridge.overlaps(other))
                && !names.iter().any(|name| room.overlaps(&name.room))
        };
        let sides = [Side::Right, Side::Left, Side::Above, Side::Below];
        let mut rooms = anchors.flat_map(|at| sides.map(|side| (*at, Room::beside(*at, side, size))));
        if let Some((_, room)) = rooms.find(free) {
            names.push(Name { text, colour: layer.colour, room });
        }
    }
    names
}

/// Small rooms along a line, near enough to each other that no text slips between them.
fn along(from: Point, to: Point) -> Vec<Room> {
    const STEP: f64 = 4.0;
    let reach = (to[0] - from[0]).hypot(to[1] - from[1]);
    if !reach.is_finite() {
        return Vec::new();
    }
    let steps = (reach / STEP).ceil().clamp(1.0, 400.0) as usize;
    let at = |step: usize| step as f64 / steps as f64;
    let point = |step| [from[0] + at(step) * (to[0] - from[0]), from[1] + at(step) * (to[1] - from[1])];
    (0..=steps).map(|step| Room::around(point(step), 2.0, 2.0)).collect()
}

/// A rectangle that a text or a mark takes.
struct Room {
    centre: Point,
    half: Point,
}

impl Room {
    fn around(centre: Point, width: f64, height: f64) -> Self {
        Room { centre, half: [width / 2.0, height / 2.0] }
    }

    /// On one side of a marked point.
    fn beside([x, y]: Point, side: Side, (width, height): (f64, f64)) -> Self {
        let (aside, up) = (width / 2.0 + MARK + GAP, height / 2.0 + MARK + GAP);
        let centre = match side {
            Side::Above => [x, y - up],
            Side::Below => [x, y + up],
            Side::Left => [x - aside, y],
            Side::Right => [x + aside, y],
        };
        Self::around(centre, width, height)
    }

    /// The gap between a place and the middle of a room beside it.
    fn between([x, y]: Point, room: &Room) -> Self {
        let [u, v] = room.centre;
        let reach = |from: f64, to: f64, half: f64| ((to - from).abs() - half).max(1.0);
        let (wide, high) = (reach(x, u, room.half[0]), reach(y, v, room.half[1]));
        Self::around([x + (u - x).signum() * wide / 2.0, y + (v - y).signum() * high / 2.0], wide, high)
    }

    fn overlaps(&self, other: &Room) -> bool {
        (0..2).all(|axis| (self.centre[axis] - other.centre[axis]).abs() < self.half[axis] + other.half[axis])
    }
}
