//! Force against indentation depth, contact radius or position, with branches, folds and the events of a path.

use mdr::diagram::{Branch, CurveSample, Diagram, DiagramEvent, State};
use mdr::prelude::{Control, EventKind, Stability};

use crate::balance::{ADHESION, LOSS, mark};
use crate::chart::{Layer, Mark, Panel, Point, Side, Stroke};
use crate::scene::{radius_axis, with_prefix};
use crate::{Axis, Unit};

/// The abscissa of the force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Plane {
    Indentation,
    Radius,
    /// D = d + F/k, the position of a machine of this stiffness.
    Position {
        stiffness: f64,
    },
}

/// Branches, marks, and numbered events that can be told apart.
const MOST_BRANCHES: usize = 60;
const MOST_MARKS: usize = 16;
const MOST_NUMBERS: usize = 14;

/// The panel of one plane.
pub(crate) fn panel(data: &Diagram, plane: Plane) -> Panel {
    let states = states(data, plane);
    let force = Axis::around("normal force *F*", Unit::Si(data.force_unit), states.iter().map(|state| state.force));
    let values = with_room(data, plane, states.iter().map(|state| plane.point(state)[0]).collect());
    let (heading, x) = match plane {
        Plane::Indentation => {
            ("(b)  force and indentation depth", Axis::around("indentation depth *d*", Unit::Si("m"), values))
        }
        Plane::Radius => ("(c)  force and contact radius", radius_axis(data)),
        Plane::Position { .. } => {
            ("(d)  force and position", Axis::around("position *D* = *d* + *F*/*k*", Unit::Si("m"), values))
        }
    };
    let mut layers = Vec::new();
    layers.extend(loop_area(data, plane));
    layers.extend(branches(data, plane));
    layers.extend(travelled(data, plane));
    if let Some(edge) = data.vertical_edge {
        let points = edge.map(|state| plane.point(&state)).to_vec();
        layers.push(Layer::curve("at the wall", points, Stroke::Solid).meaning("stable"));
    }
    if !data.folds.is_empty() && data.folds.len() <= MOST_MARKS {
        let points = data.folds.iter().map(|state| plane.point(state)).collect();
        layers.push(Layer::marks("folds", points, Mark::Diamond).meaning("fold"));
    }
    layers.extend(events(data, plane, &x));
    Panel { layers, ..Panel::new(heading, x, force) }
}

/// Values with some room where a jump leads out of their range, for its arrow.
fn with_room(data: &Diagram, plane: Plane, mut values: Vec<f64>) -> Vec<f64> {
    const ROOM: f64 = 0.2;
    let least = values.iter().copied().fold(0.0, f64::min);
    let most = values.iter().copied().fold(0.0, f64::max);
    for event in data.path.iter().filter(|event| event.before != event.after) {
        let end = event.after.map_or(f64::NAN, |state| plane.point(&state)[0]);
        if end < least || (end.is_nan() && event.kind == EventKind::Detached) {
            values.push(least - ROOM * (most - least));
        } else if end > most {
            values.push(most + ROOM * (most - least));
        }
    }
    values
}

impl Plane {
    /// Those that tell something of a control, in the order of their letters.
    pub(crate) fn of(control: &Control<f64>) -> Vec<Self> {
        let position = match control {
            Control::Machine { stiffness } => Some(Plane::Position { stiffness: *stiffness }),
            _ => None,
        };
        [Plane::Indentation, Plane::Radius].into_iter().chain(position).collect()
    }

    fn point(self, state: &State) -> Point {
        let across = match self {
            Plane::Indentation => state.indentation,
            Plane::Radius => state.contact_radius,
            Plane::Position { stiffness } => state.indentation + state.force / stiffness,
        };
        [across, state.force]
    }
}

/// The states that must be seen: in contact, with the curve between them.
fn states(data: &Diagram, plane: Plane) -> Vec<State> {
    let reached = data.path.iter().flat_map(|event| [event.before, event.after]).flatten();
    let mut states: Vec<State> = reached.filter(|state| state.contact_radius > 0.0).collect();
    if states.is_empty() {
        states.extend(data.held.iter().flat_map(|held| &held.equilibria).map(|state| State {
            contact_radius: state.contact_radius,
            indentation: state.indentation,
            force: state.force,
        }));
    }
    states.extend(data.folds.iter().copied());
    let radii = || states.iter().map(|state| state.contact_radius).filter(|radius| *radius > 0.0);
    let (least, most) = (radii().fold(f64::INFINITY, f64::min), radii().fold(0.0, f64::max));
    let seen = |sample: &&CurveSample| states.is_empty() || (least..=most).contains(&sample.contact_radius);
    let between: Vec<State> = data.samples().filter(seen).map(state).collect();
    states.extend(between);
    states.extend(data.vertical_edge.iter().flatten());
    states.extend(near(data, plane, &states));
    states
}

/// The states before there is a contact and after it has come off, unless they are so far away that nothing else would be seen: a
/// soft machine draws the body back a long way.
fn near(data: &Diagram, plane: Plane, states: &[State]) -> Vec<State> {
    let places = || states.iter().map(|state| plane.point(state)[0]);
    let (least, most) = (places().fold(0.0, f64::min), places().fold(0.0, f64::max));
    let apart = data.path.iter().filter(|event| matches!(event.kind, EventKind::Detached | EventKind::Start));
    let apart = apart.filter_map(|event| event.after);
    apart.filter(|state| (2.0 * least - most..=2.0 * most - least).contains(&plane.point(state)[0])).collect()
}

fn state(sample: &CurveSample) -> State {
    State { contact_radius: sample.contact_radius, indentation: sample.indentation, force: sample.force }
}

/// Stable branches solid, thin beside a path, unstable ones dashed; of very many, every so many.
fn branches(data: &Diagram, plane: Plane) -> Vec<Layer> {
    let crowd = data.branches.len().div_ceil(MOST_BRANCHES);
    // An odd step takes stable and unstable branches in turn.
    let step = crowd + 1 - crowd % 2;
    let every = if step == 1 { String::new() } else { format!(" (one of {step} branches shown)") };
    let mut layers = Vec::new();
    for (stable, name, strokes) in
        [(true, "stable", [Stroke::Solid, Stroke::Thin]), (false, "unstable", [Stroke::Dashed, Stroke::Guide])]
    {
        let stroke = strokes[usize::from(step > 1 || (stable && !data.path.is_empty()))];
        let shown = data.branches.iter().step_by(step).filter(|branch| branch.stable == stable);
        layers.extend(shown.map(|Branch { samples, .. }| {
            let points = samples.iter().map(|sample| plane.point(&state(sample))).collect();
            Layer::curve(name, points, stroke).meaning(format!("{name}{every}"))
        }));
    }
    for Branch { samples, .. } in data.advancing.iter().filter(|branch| branch.stable) {
        let points = samples.iter().map(|sample| plane.point(&state(sample))).collect();
        let layer = Layer::curve("advancing edge", points, Stroke::Thin).coloured(ADHESION);
        layers.push(layer.meaning("advancing edge"));
    }
    layers
}

/// The states that a path goes through, at rest all the way.
fn travelled(data: &Diagram, plane: Plane) -> Vec<Layer> {
    let legs = data.path.windows(2).filter_map(|pair| Some((pair[0].after?, pair[1].before?)));
    let legs = legs.filter(|(from, to)| from != to && from.contact_radius > 0.0 && to.contact_radius > 0.0);
    let points = |(from, to)| smooth(data, &from, &to).iter().map(|state| plane.point(state)).collect();
    legs.map(|leg| Layer::curve("path", points(leg), Stroke::Solid).meaning("path")).collect()
}

/// The area of a closed cycle, which is the work lost in it.
fn loop_area(data: &Diagram, plane: Plane) -> Option<Layer> {
    if plane == Plane::Radius || !is_cycle(&data.path) {
        return None;
    }
    let mut outline: Vec<Point> = Vec::new();
    for pair in data.path.windows(2) {
        if let (Some(from), Some(to)) = (pair[0].after, pair[1].before) {
            outline.extend(smooth(data, &from, &to).iter().map(|state| plane.point(state)));
        }
        outline.extend(pair[1].after.iter().map(|state| plane.point(state)));
    }
    let finite = outline.iter().flatten().all(|value| value.is_finite());
    finite.then(|| Layer::area("hysteresis", outline).coloured(LOSS).meaning("work lost in the cycle"))
}

/// Whether a path comes back to its first state by another way.
fn is_cycle(path: &[DiagramEvent]) -> bool {
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

/// The states on a branch from one to another; in a straight line where they are apart or at a vertical edge.
fn smooth(data: &Diagram, from: &State, to: &State) -> Vec<State> {
    let [start, end] = [from.contact_radius, to.contact_radius];
    // Apart there is no branch.
    let apart = start == 0.0 || end == 0.0;
    let inner = data.samples_between(start, end).filter(|_| !apart);
    let mut states: Vec<State> = inner.map(state).collect();
    if from.contact_radius > to.contact_radius {
        states.reverse();
    }
    states.insert(0, *from);
    states.push(*to);
    states
}

/// Jumps as arrows, resting states as discs; events numbered as in the caption.
fn events(data: &Diagram, plane: Plane, x: &Axis) -> Vec<Layer> {
    let mut layers: Vec<Layer> = data.path.iter().filter_map(|event| jump(data, event, plane, x)).collect();
    if data.path.len() > MOST_NUMBERS {
        return layers;
    }
    let is_fold = |state: &State| data.folds.iter().any(|fold| fold.contact_radius == state.contact_radius);
    let resting = data.path.iter().filter_map(|event| event.after);
    // Out of contact the radius tells nothing.
    let is_told = |state: &State| state.contact_radius > 0.0 || plane != Plane::Radius;
    let resting = resting.filter(|state| is_told(state) && !is_fold(state));
    let points: Vec<Point> = resting.map(|state| plane.point(&state)).collect();
    if !points.is_empty() {
        layers.push(Layer::marks("events", points, mark(Stability::Stable)));
    }
    for (index, event) in data.path.iter().enumerate().filter(|(_, event)| event.before.is_some()) {
        let apart = event.after.filter(|_| plane != Plane::Radius);
        if let Some(state) = event.in_contact().or(apart) {
            layers.push(Layer::label((index + 1).to_string(), vec![plane.point(&state)], Side::Left));
        }
    }
    layers
}

/// The way of an event that changes the state.
fn jump(data: &Diagram, event: &DiagramEvent, plane: Plane, x: &Axis) -> Option<Layer> {
    let from = event.before?;
    let to = event.after.unwrap_or(from);
    let mut points: Vec<Point> = match plane {
        // The line of the control.
        Plane::Indentation | Plane::Position { .. } => vec![plane.point(&from), plane.point(&to)],
        Plane::Radius => {
            data.jump(event).unwrap_or_else(|| vec![from, to]).iter().map(|state| plane.point(state)).collect()
        }
    };
    // Where a body that has come off goes to under its load, and how far a contact spreads, is not in the diagram.
    let [start, end] = [points[0], points[points.len() - 1]];
    match (event.kind, plane) {
        (EventKind::Detached, _) if end[0].is_nan() => points = vec![start, [x.range().0, start[1]]],
        (EventKind::CompleteContact, Plane::Radius) => points = vec![start, [x.range().1, start[1]]],
        // A logarithmic axis has no zero.
        (_, Plane::Radius) => points.iter_mut().for_each(|point| point[0] = point[0].max(x.range().0)),
        _ => {}
    }
    let moves = points.iter().any(|point| *point != points[0]);
    if !moves || !points.iter().flatten().all(|value| value.is_finite()) {
        return None;
    }
    let kind = match event.kind {
        EventKind::Detached => "pull-off",
        kind => kind.name(),
    };
    // The arrow ends at the frame where the body goes farther.
    let is_seen = (0.0..=1.0).contains(&x.fraction(points[points.len() - 1][0]));
    let meaning = match plane {
        Plane::Indentation if !is_seen => format!("{kind}, to *d* = {}", with_prefix(to.indentation, "m")),
        _ => kind.to_owned(),
    };
    Some(Layer::arrow(event.kind.name(), points).coloured(LOSS).meaning(meaning))
}
