//! Where the words of a panel stand: letters and numbers at their points, and every meaning beside what it names.

use super::frame::{Frame, MARK};
use super::room::{Room, WAYS, encloses};
use super::{GAP, LINE};
use crate::chart::{Colour, Layer, Look, Point, Stroke};
use crate::markup::{lines, width};

/// A text that has found its place.
pub(super) struct Word {
    pub(super) lines: Vec<String>,
    pub(super) colour: Colour,
    pub(super) room: Room,
    /// A line to what it names, where there was no room beside it.
    pub(super) leader: Option<[Point; 2]>,
}

/// What is in the way of words.
#[derive(Default)]
struct Taken {
    /// Points of lines, each with the index of its layer.
    beads: Vec<(usize, Point)>,
    /// Marks, and words that stand.
    firm: Vec<Room>,
}

/// A text that looks for a place.
struct Wanted<'a> {
    text: &'a str,
    colour: Colour,
    /// The layers that it names.
    layers: Vec<usize>,
    /// What it may stand beside, the best first.
    anchors: Vec<Point>,
    /// How far from an anchor.
    gap: f64,
    ways: Vec<Point>,
    /// It stands in one of these outlines, not beside a point.
    outlines: Vec<Vec<Point>>,
}

/// Distance of the points of a line that are in the way, and half the size of what they block.
const STEP: f64 = 4.0;
const BEAD: f64 = 1.5;

/// Points of one meaning that are tried, and the room that a word keeps to the frame.
const MOST_ANCHORS: usize = 60;
const MARGIN: f64 = 2.0;

/// What a place costs: covering a mark or a word, a leader through one, each point of a line, moving into the frame, a leader.
const FIRM: f64 = 1000.0;
const STRUCK: f64 = 150.0;
const CROSSED: f64 = 3.0;
const MOVED: f64 = 0.4;
const LED: f64 = 12.0;

/// Places for all words of a panel.
pub(super) fn words(frame: &Frame<'_>) -> Vec<Word> {
    let layers = &frame.panel.layers;
    let mut taken = Taken::default();
    for (index, layer) in layers.iter().enumerate() {
        match layer.look {
            Look::Marks(_) => {
                let size = 2.0 * MARK * layer.scale;
                taken.firm.extend(frame.seen(layer).iter().map(|at| Room::around(*at, [size; 2])));
            }
            Look::Curve(_) | Look::Arrow => {
                taken.beads.extend(beads(frame, layer).into_iter().map(|at| (index, at)));
            }
            Look::Area | Look::Label(_) => {}
        }
    }
    let mut words = Vec::new();
    for wanted in labels(frame).into_iter().chain(meanings(frame)) {
        if let Some(word) = wanted.place(frame.size, &taken) {
            taken.firm.push(word.room);
            words.push(word);
        }
    }
    words
}

/// The visible points of a line.
fn beads(frame: &Frame<'_>, layer: &Layer) -> Vec<Point> {
    let places = frame.places(layer);
    match layer.look {
        Look::Arrow => frame.room(0.0).beads(&frame.arrow_line(&places), STEP),
        _ => frame.room(0.0).beads(&places, STEP),
    }
}

/// Letters and numbers, each on the wanted side of its first point that has room.
fn labels<'a>(frame: &Frame<'a>) -> Vec<Wanted<'a>> {
    let mut wanted = Vec::new();
    for layer in &frame.panel.layers {
        let Look::Label(side) = layer.look else { continue };
        let mut ways = vec![side.way()];
        ways.extend(WAYS.into_iter().filter(|way| *way != side.way()));
        wanted.push(Wanted {
            text: &layer.name,
            colour: layer.colour,
            layers: Vec::new(),
            anchors: frame.seen(layer),
            gap: MARK + GAP,
            ways,
            outlines: Vec::new(),
        });
    }
    wanted
}

/// Every meaning once: of marks first, since they have few places, then of arrows, lines and areas.
fn meanings<'a>(frame: &Frame<'a>) -> Vec<Wanted<'a>> {
    let order = |look: Look| match look {
        Look::Marks(_) => 0,
        Look::Arrow => 1,
        Look::Curve(_) => 2,
        Look::Area => 3,
        Look::Label(_) => 4,
    };
    let mut wanted: Vec<(i32, Wanted<'a>)> = Vec::new();
    for (index, layer) in frame.panel.layers.iter().enumerate() {
        let Some(text) = layer.meaning.as_deref().filter(|_| !layer.points.is_empty()) else { continue };
        let (_, entry) = match wanted.iter().position(|(_, known)| known.text == text) {
            Some(known) => &mut wanted[known],
            None => {
                let (colour, layers, gap) = (layer.colour, Vec::new(), MARK + GAP);
                let (anchors, outlines) = (Vec::new(), Vec::new());
                let entry = Wanted { text, colour, layers, anchors, gap, ways: WAYS.to_vec(), outlines };
                wanted.push((order(layer.look), entry));
                wanted.last_mut().expect("just pushed")
            }
        };
        entry.layers.push(index);
        match layer.look {
            Look::Marks(_) => entry.anchors.extend(frame.seen(layer)),
            Look::Arrow => {
                // From the middle outwards; at its ends an arrow meets states.
                let beads = beads(frame, layer);
                let middle = beads.len() / 2;
                let mut places: Vec<usize> = (beads.len() / 5..beads.len() - beads.len() / 5).collect();
                places.sort_by_key(|place| place.abs_diff(middle));
                entry.anchors.extend(places.into_iter().map(|place| beads[place]));
            }
            // From the outer end inwards, since there curves lie apart.
            Look::Curve(stroke) if stroke != Stroke::Guide => {
                let beads = beads(frame, layer);
                entry.anchors.extend(beads.into_iter().rev());
            }
            Look::Area => entry.outlines.push(frame.places(layer)),
            Look::Curve(_) | Look::Label(_) => {}
        }
    }
    wanted.sort_by_key(|(order, _)| *order);
    wanted.into_iter().map(|(_, wanted)| wanted).collect()
}

impl Wanted<'_> {
    /// The cheapest place; none for a meaning of which nothing is seen.
    fn place(&self, frame: Point, taken: &Taken) -> Option<Word> {
        let lines = lines(self.text, 0.75 * frame[0]);
        let longest = lines.iter().map(|line| width(line)).fold(0.0, f64::max);
        let size = [longest, LINE * lines.len() as f64 - 3.0];
        let best = self.beside(frame, size, taken).into_iter().chain(self.inside(frame, size, taken));
        let mut best = best.min_by(|a, b| a.0.total_cmp(&b.0));
        if best.as_ref().is_none_or(|(cost, ..)| *cost > LED) {
            let led = self.led(frame, size, taken);
            best = best.into_iter().chain(led).min_by(|a, b| a.0.total_cmp(&b.0));
        }
        let (_, room, leader) = best?;
        Some(Word { lines, colour: self.colour, room, leader })
    }

    /// The cheapest room beside an anchor.
    fn beside(&self, frame: Point, size: Point, taken: &Taken) -> Option<Place> {
        let step = self.anchors.len().div_ceil(MOST_ANCHORS).max(1);
        let mut best: Option<Place> = None;
        for (order, at) in self.anchors.iter().step_by(step).enumerate() {
            for (turn, way) in self.ways.iter().enumerate() {
                let (room, moved) = Room::beside(*at, *way, size, self.gap).within(frame, MARGIN);
                let dear = 0.02 * (8 * order + turn) as f64 + MOVED * moved;
                let most = best.as_ref().map_or(f64::INFINITY, |(cost, ..)| *cost);
                if dear < most {
                    let cost = dear + taken.cost(&room, &self.layers, most - dear) + self.bridged(*at, &room, taken);
                    if cost < most {
                        best = Some((cost, room, None));
                    }
                }
            }
        }
        best
    }

    /// What lies between an anchor and its room.
    fn bridged(&self, at: Point, room: &Room, taken: &Taken) -> f64 {
        let to = room.nearest(at);
        let middle = [0, 1].map(|axis| f64::midpoint(at[axis], to[axis]));
        let bridge = Room::around(middle, [0, 1].map(|axis| (to[axis] - at[axis]).abs().max(2.0)));
        let others = taken.beads.iter().filter(|(of, bead)| {
            !self.layers.contains(of) && (bead[0] - at[0]).hypot(bead[1] - at[1]) > MARK && bridge.holds(*bead)
        });
        CROSSED * others.count() as f64
    }

    /// The cheapest room in an outline.
    fn inside(&self, frame: Point, size: Point, taken: &Taken) -> Option<Place> {
        let mut best: Option<Place> = None;
        for at in grid(frame) {
            let room = Room::around(at, size);
            let is_inside = |outline: &Vec<Point>| room.corners().iter().all(|corner| encloses(outline, *corner));
            if self.outlines.iter().any(is_inside) && room.within(frame, MARGIN).1 == 0.0 {
                let most = best.as_ref().map_or(f64::INFINITY, |(cost, ..)| *cost);
                let cost = taken.cost(&room, &self.layers, most);
                if cost < most {
                    best = Some((cost, room, None));
                }
            }
        }
        best
    }

    /// The cheapest room anywhere, with a line to the nearest anchor.
    fn led(&self, frame: Point, size: Point, taken: &Taken) -> Option<Place> {
        let step = self.anchors.len().div_ceil(MOST_ANCHORS).max(1);
        let mut anchors: Vec<Point> = self.anchors.iter().step_by(step).copied().collect();
        if anchors.is_empty() {
            let is_inside = |at: &Point| self.outlines.iter().any(|outline| encloses(outline, *at));
            anchors = grid(frame).filter(is_inside).collect();
        }
        let mut best: Option<Place> = None;
        for at in grid(frame) {
            let (room, moved) = Room::around(at, size).within(frame, MARGIN);
            let near = anchors.iter().map(|anchor| (room.nearest(*anchor), *anchor));
            let far = |(to, anchor): &(Point, Point)| (to[0] - anchor[0]).hypot(to[1] - anchor[1]);
            let (to, anchor) = near.min_by(|a, b| far(a).total_cmp(&far(b)))?;
            let reach = far(&(to, anchor));
            let dear = LED + 0.1 * reach + MOVED * moved;
            let most = best.as_ref().map_or(f64::INFINITY, |(cost, ..)| *cost);
            // Nearer than this the line would not be seen.
            if dear >= most || reach < 2.0 * MARK {
                continue;
            }
            let whole = Room::around([frame[0] / 2.0, frame[1] / 2.0], frame);
            let crossed = whole.beads(&[anchor, to], STEP);
            let over = |bead: &Point| {
                let here = Room::around(*bead, [3.0; 2]);
                let far = (bead[0] - anchor[0]).hypot(bead[1] - anchor[1]) > 2.0 * MARK;
                let firm = taken.firm.iter().any(|room| far && room.overlaps(&here));
                let line = taken.beads.iter().any(|(_, other)| far && here.holds(*other));
                f64::from(u8::from(firm)) * STRUCK + f64::from(u8::from(line)) * CROSSED
            };
            let cost = dear + taken.cost(&room, &self.layers, most - dear) + crossed.iter().map(over).sum::<f64>();
            if cost < most {
                // The line ends before the mark.
                let short = |from: Point, to: Point, by: f64| {
                    let share = by / reach;
                    [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
                };
                best = Some((cost, room, Some([short(to, anchor, 1.0), short(anchor, to, MARK + 1.0)])));
            }
        }
        best
    }
}

/// What a place costs, its room, its leader.
type Place = (f64, Room, Option<[Point; 2]>);

impl Taken {
    /// What a room costs that covers something; more than `most` is not counted out.
    fn cost(&self, room: &Room, own: &[usize], most: f64) -> f64 {
        let firm = self.firm.iter().filter(|other| room.overlaps(other)).count();
        let mut cost = FIRM * firm as f64;
        let wide = Room { half: room.half.map(|half| half + BEAD), ..*room };
        for (of, bead) in &self.beads {
            if cost >= most {
                break;
            }
            if wide.holds(*bead) {
                // A word on its own line is bad, on another it misleads.
                cost += if own.contains(of) { CROSSED } else { 1.5 * CROSSED };
            }
        }
        cost
    }
}

/// Places over the whole frame, the outer ones last.
fn grid([width, height]: Point) -> impl Iterator<Item = Point> {
    let (columns, rows) = ((width / 9.0) as usize, (height / 8.0) as usize);
    (1..rows).flat_map(move |row| {
        (1..columns).map(move |column| [width * column as f64 / columns as f64, height * row as f64 / rows as f64])
    })
}
