//! Force against indentation depth or against contact radius, with branches, folds and the events of a path.

use mdr_numeric::path::EventKind;

use super::radius_axis;
use mdr::diagram::{Branch, Diagram, Event, Sample, Spot};

use crate::picture::{Axis, Key, Layer, Mark, Panel, Point, Side, Stroke, Unit};

/// What the force is drawn against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Plane {
    Indentation,
    Radius,
}

/// Branches, marks, and numbered events that can be told apart.
const MOST_BRANCHES: usize = 60;
const MOST_MARKS: usize = 16;
const MOST_NUMBERS: usize = 14;

/// The panel of one plane.
pub(super) fn panel(data: &Diagram, plane: Plane) -> Panel {
    let states = states(data);
    let force = Axis::around("normal force *F*", Unit::Si("N"), states.iter().map(|spot| spot.force), true);
    let (heading, x) = match plane {
        Plane::Indentation => {
            let values = states.iter().map(|spot| spot.indentation);
            ("(b)  force and indentation depth", Axis::around("indentation depth *d*", Unit::Si("m"), values, true))
        }
        Plane::Radius => ("(c)  force and contact radius", radius_axis(data)),
    };
    let mut layers = Vec::new();
    let mut legend = Vec::new();
    loop_area(data, plane, &mut layers, &mut legend);
    branches(data, plane, &mut layers, &mut legend);
    if let Some(wall) = data.wall {
        let points = wall.map(|spot| plane.point(&spot)).to_vec();
        layers.push(Layer::Curve { name: "at the wall".to_owned(), points, stroke: Stroke::Solid });
        let entry = (Key::Line(Stroke::Solid), "stable".to_owned());
        if !legend.contains(&entry) {
            legend.insert(0, entry);
        }
    }
    if !data.folds.is_empty() && data.folds.len() <= MOST_MARKS {
        let points = data.folds.iter().map(|spot| plane.point(spot)).collect();
        layers.push(Layer::Marks { name: "folds".to_owned(), points, mark: Mark::Diamond });
        legend.push((Key::Mark(Mark::Diamond), "fold".to_owned()));
    }
    events(data, plane, &x, &mut layers, &mut legend);
    Panel { heading: heading.to_owned(), x, y: force, layers, legend, aspect: 0.55 }
}

impl Plane {
    fn point(self, spot: &Spot) -> Point {
        match self {
            Plane::Indentation => [spot.indentation, spot.force],
            Plane::Radius => [spot.contact_radius, spot.force],
        }
    }

    fn sample(self, sample: &Sample) -> Point {
        match self {
            Plane::Indentation => [sample.indentation, sample.force],
            Plane::Radius => [sample.contact_radius, sample.force],
        }
    }
}

/// The states that must be seen: in contact, with the curve between them.
fn states(data: &Diagram) -> Vec<Spot> {
    let reached = data.path.iter().flat_map(|event| [event.before, event.after]).flatten();
    let mut states: Vec<Spot> = reached.filter(|spot| spot.contact_radius > 0.0).collect();
    if states.is_empty() {
        states.extend(data.held.iter().flat_map(|held| &held.equilibria).map(|state| Spot {
            contact_radius: state.contact_radius,
            indentation: state.indentation,
            force: state.force,
        }));
    }
    states.extend(data.folds.iter().copied());
    let radii = || states.iter().map(|spot| spot.contact_radius).filter(|radius| *radius > 0.0);
    let (least, most) = (radii().fold(f64::INFINITY, f64::min), radii().fold(0.0, f64::max));
    let samples = || data.branches.iter().flat_map(|branch| &branch.samples);
    let between: Vec<Spot> = samples()
        .filter(|sample| states.is_empty() || (least..=most).contains(&sample.contact_radius))
        .map(spot)
        .collect();
    states.extend(between);
    states.extend(data.wall.iter().flatten());
    states.extend(near(data, &states));
    states
}

/// The states after the contact has come off, unless they are so far away that nothing else would be seen: a soft machine
/// draws the body back a long way.
fn near(data: &Diagram, states: &[Spot]) -> Vec<Spot> {
    let depths = || states.iter().map(|spot| spot.indentation);
    let (least, most) = (depths().fold(0.0, f64::min), depths().fold(0.0, f64::max));
    let apart = data.path.iter().filter(|event| event.kind == EventKind::Detached).filter_map(|event| event.after);
    apart.filter(|spot| (2.0 * least - most..=2.0 * most - least).contains(&spot.indentation)).collect()
}

fn spot(sample: &Sample) -> Spot {
    Spot { contact_radius: sample.contact_radius, indentation: sample.indentation, force: sample.force }
}

/// Stable branches solid, unstable ones dashed; of very many, every so many.
fn branches(data: &Diagram, plane: Plane, layers: &mut Vec<Layer>, legend: &mut Vec<(Key, String)>) {
    let crowd = data.branches.len().div_ceil(MOST_BRANCHES);
    // An odd step takes stable and unstable branches in turn.
    let step = crowd + 1 - crowd % 2;
    for (stable, name, strokes) in
        [(true, "stable", (Stroke::Solid, Stroke::Thin)), (false, "unstable", (Stroke::Dashed, Stroke::Guide))]
    {
        let shown: Vec<&Branch> = data.branches.iter().step_by(step).filter(|branch| branch.stable == stable).collect();
        let stroke = if step == 1 { strokes.0 } else { strokes.1 };
        for branch in &shown {
            let points = branch.samples.iter().map(|sample| plane.sample(sample)).collect();
            layers.push(Layer::Curve { name: name.to_owned(), points, stroke });
        }
        if !shown.is_empty() {
            let every = if step == 1 { String::new() } else { format!(" (one of {step} branches shown)") };
            legend.push((Key::Line(stroke), format!("{name}{every}")));
        }
    }
}

/// The area of a closed cycle, which is the work lost in it.
fn loop_area(data: &Diagram, plane: Plane, layers: &mut Vec<Layer>, legend: &mut Vec<(Key, String)>) {
    if plane != Plane::Indentation || !is_cycle(&data.path) {
        return;
    }
    let mut outline: Vec<Point> = Vec::new();
    for pair in data.path.windows(2) {
        if let (Some(from), Some(to)) = (pair[0].after, pair[1].before) {
            outline.extend(smooth(data, &from, &to).iter().map(|spot| plane.point(spot)));
        }
        outline.extend(pair[1].after.iter().map(|spot| plane.point(spot)));
    }
    if outline.iter().flatten().all(|value| value.is_finite()) {
        layers.push(Layer::Area { name: "hysteresis".to_owned(), outline });
        legend.push((Key::Area, "work lost in the cycle".to_owned()));
    }
}

/// Whether a path comes back to its first state by another way.
fn is_cycle(path: &[Event]) -> bool {
    let jumps = path.iter().any(|event| event.before != event.after);
    match (path.first().and_then(|event| event.after), path.last().and_then(|event| event.before)) {
        (Some(first), Some(last)) => {
            // The same branch at the same value: the rest is rounding.
            let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (a.abs() + b.abs());
            jumps && close(first.contact_radius, last.contact_radius) && close(first.indentation, last.indentation)
        }
        _ => false,
    }
}

/// The states on a branch from one to another; in a straight line where they are apart or at a wall.
fn smooth(data: &Diagram, from: &Spot, to: &Spot) -> Vec<Spot> {
    let between = |a: f64| {
        (a > from.contact_radius && a < to.contact_radius) || (a < from.contact_radius && a > to.contact_radius)
    };
    let apart = from.contact_radius == 0.0 || to.contact_radius == 0.0;
    let samples = data.branches.iter().flat_map(|branch| &branch.samples);
    let mut spots: Vec<Spot> = samples.filter(|sample| !apart && between(sample.contact_radius)).map(spot).collect();
    if from.contact_radius > to.contact_radius {
        spots.reverse();
    }
    spots.insert(0, *from);
    spots.push(*to);
    spots
}

/// Jumps as arrows; events numbered as in the caption.
fn events(data: &Diagram, plane: Plane, x: &Axis, layers: &mut Vec<Layer>, legend: &mut Vec<(Key, String)>) {
    let mut jumps = false;
    for (index, event) in data.path.iter().enumerate() {
        let Some(from) = event.before else { continue };
        let to = event.after.unwrap_or(from);
        let [mut start, mut end] = [from, to].map(|spot| plane.point(&spot));
        // Where a body that has come off goes to under its load, and how far a contact spreads, is not in the diagram.
        match (event.kind, plane) {
            (EventKind::Detached, _) if end[0].is_nan() => end = [x.range().0, start[1]],
            (EventKind::CompleteContact, Plane::Radius) => end = [x.range().1, start[1]],
            // A logarithmic axis has no zero.
            (_, Plane::Radius) => [start, end] = [start, end].map(|[a, force]| [a.max(x.range().0), force]),
            _ => {}
        }
        if start != end && start.iter().chain(&end).all(|value| value.is_finite()) {
            jumps = true;
            layers.push(Layer::Arrow {
                name: event.kind.name().to_owned(),
                from: start,
                to: end,
                stroke: Stroke::Thin,
            });
        }
        if let Some(spot) = event.in_contact().filter(|_| data.path.len() <= MOST_NUMBERS) {
            let (anchors, side) = (vec![plane.point(&spot)], Side::Left);
            layers.push(Layer::Label { text: (index + 1).to_string(), anchors, side });
        }
    }
    if jumps {
        legend.push((Key::Arrow, "jump".to_owned()));
    }
    if !data.path.is_empty() && data.path.len() <= MOST_NUMBERS {
        legend.push((Key::Text, "1, 2, …  events in their order".to_owned()));
    }
}
