//! Which curves are named beside them, and the room that texts and marks take.

use super::LINE;
use super::frame::{Frame, MARK};
use crate::chart::{Colour, Layer, Look, Panel, Point, Side, Stroke};
use crate::markup::width;

/// Between a point's mark and its label.
const GAP: f64 = 4.0;

/// Curves of a panel that can be told by their names beside them; more have a legend.
const MOST_NAMED: usize = 4;

/// The name of a curve beside it.
pub(super) struct Name<'a> {
    pub(super) text: &'a str,
    pub(super) colour: Colour,
    pub(super) room: Room,
}

/// The curves that can be named beside them: those that alone have their entry of the legend, where there is room that no
/// line crosses.
pub(super) fn named(panel: &Panel, size: [f64; 2]) -> Vec<Name<'_>> {
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
pub(super) struct Room {
    pub(super) centre: Point,
    pub(super) half: Point,
}

impl Room {
    pub(super) fn around(centre: Point, width: f64, height: f64) -> Self {
        Room { centre, half: [width / 2.0, height / 2.0] }
    }

    /// On one side of a marked point.
    pub(super) fn beside([x, y]: Point, side: Side, (width, height): (f64, f64)) -> Self {
        let (aside, up) = (width / 2.0 + MARK + GAP, height / 2.0 + MARK + GAP);
        let centre = match side {
            Side::Above => [x, y - up],
            Side::Below => [x, y + up],
            Side::Left => [x - aside, y],
            Side::Right => [x + aside, y],
        };
        Self::around(centre, width, height)
    }

    /// What lies between a place and the middle of a room beside it.
    fn between([x, y]: Point, room: &Room) -> Self {
        let [u, v] = room.centre;
        let reach = |from: f64, to: f64, half: f64| ((to - from).abs() - half).max(1.0);
        let (wide, high) = (reach(x, u, room.half[0]), reach(y, v, room.half[1]));
        Self::around([x + (u - x).signum() * wide / 2.0, y + (v - y).signum() * high / 2.0], wide, high)
    }

    pub(super) fn overlaps(&self, other: &Room) -> bool {
        (0..2).all(|axis| (self.centre[axis] - other.centre[axis]).abs() < self.half[axis] + other.half[axis])
    }
}
