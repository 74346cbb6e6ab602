//! The picture of a scene: the diagram {Δl, g − d}, and force against indentation, contact radius and position.

use std::borrow::Cow;

use mdr::diagram::{CurveSample, DECADES, Diagram, HeldCurve, SearchQuality, State};
use mdr::prelude::{Control, Stability};

use crate::balance::{Balance, change, shifted};
use crate::chart::{Layer, Panel, Picture, Stroke};
use crate::loading::{self, Plane};
use crate::{Axis, Unit, typographic};

/// The picture of a scene: (a) the balance of Δl and g − d at the edge of the contact, with the equilibria at some values of the
/// controlled quantity; (b), (c) force against indentation depth and against contact radius, with the events of the path; (d) under
/// a machine, force against its position.
///
/// The caption has the state before and after each event. Lengths in metres, forces in newtons.
pub fn scene(title: &str, diagram: &Diagram) -> Picture {
    Picture {
        title: title.to_owned(),
        description: description(diagram),
        panels: [balance(diagram)]
            .into_iter()
            .chain(Plane::of(&diagram.control).into_iter().map(|plane| loading::panel(diagram, plane)))
            .collect(),
    }
}

/// Whether the folds lie decades apart, so that radii need a logarithmic axis.
fn spans_decades(data: &Diagram) -> bool {
    let upper = data.samples().map(|sample| sample.contact_radius).fold(0.0, f64::max);
    data.folds.first().is_some_and(|fold| fold.contact_radius < upper / DECADES)
}

pub(crate) fn radius_axis(data: &Diagram) -> Axis {
    const NAME: &str = "contact radius *a*";
    let radii = || data.samples().map(|sample| sample.contact_radius);
    let (lower, upper) = (radii().fold(f64::INFINITY, f64::min), radii().fold(0.0, f64::max));
    if spans_decades(data) {
        Axis::log(NAME, Unit::Si("m"), lower, upper)
    } else {
        // A vertical edge is also visible from outside, and an arrow to radius 0 has room.
        let upper = if data.vertical_edge.is_some() { 1.1 * upper } else { upper };
        Axis::linear(NAME, Unit::Si("m"), -0.04 * upper, upper)
    }
}

/// The controlled quantity with its value.
fn named(data: &Diagram, value: f64) -> String {
    let (name, unit) = match data.control {
        Control::Indentation => ("*d*", "m"),
        Control::Force => ("*F*", data.force_unit),
        Control::Machine { .. } => ("*d* + *F*/*k*", "m"),
    };
    format!("{name} = {}", with_prefix(value, unit))
}

/// Four significant digits and an SI prefix.
pub(crate) fn with_prefix(value: f64, unit: &'static str) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let (power, unit) = Axis::linear("", Unit::Si(unit), 0.0, value.abs()).scaled_unit();
    let scaled = value / 10f64.powi(power);
    let decimals = (3 - scaled.abs().log10().floor() as i32).clamp(0, 3) as usize;
    format!("{} {unit}", typographic(&format!("{scaled:.decimals$}")))
}

/// From how many folds on one curve of g − d is enough, and thin.
const CROWD: usize = 40;

/// Strokes of g − d at the values that are shown.
const STROKES: [Stroke; 3] = [Stroke::Dashed, Stroke::DashDotted, Stroke::Dotted];

/// The diagram {Δl, g − d}.
fn balance(data: &Diagram) -> Panel {
    let sides = Balance { diagram: Cow::Borrowed(data), units: [1.0; 2] };
    let mut panel = Panel::new("(a)  balance at the contact edge", radius_axis(data), balance_heights(data));
    panel.layers.push(sides.elongation().meaning("Δ*l*"));
    let crowded = data.folds.len() > CROWD;
    let shown = if crowded { &data.held[..data.held.len().min(1)] } else { &data.held[..] };
    for (held, stroke) in shown.iter().zip(STROKES) {
        let stroke = if crowded { Stroke::Thin } else { stroke };
        let name = format!("*g* − *d*, {}", named(data, held.value));
        panel.layers.push(shifted(name.clone(), held.shifted.clone(), stroke).meaning(name));
    }
    let largest = data.samples().next_back().map_or(0.0, |sample| sample.contact_radius);
    for held in shown.iter().filter(|held| held.equilibria.len() < CROWD) {
        for (stability, name) in
            [(Stability::Stable, "stable"), (Stability::Unstable, "unstable"), (Stability::Neutral, "fold")]
        {
            let seen = held.equilibria.iter().filter(|state| state.stability == stability);
            let seen = seen.filter(|state| (0.0..=largest).contains(&state.contact_radius));
            let marks = sides.states(format!("{name}, {}", named(data, held.value)), seen, stability);
            if !marks.points.is_empty() {
                panel.layers.push(marks);
            }
        }
    }
    if let Some(first) = data.held.first() {
        let arrows = directions(data, first, &panel);
        panel.layers.extend(arrows);
    }
    panel
}

/// Heights that show all equilibria, and as much of the curves as comes with them.
fn balance_heights(data: &Diagram) -> Axis {
    const NAME: &str = "length";
    let Some(first) = data.samples().next() else { return Axis::linear(NAME, Unit::Si("m"), 0.0, 1.0) };
    // Towards complete contact Δl falls again.
    let top = data.samples().map(|sample| sample.elongation).fold(first.elongation, f64::max);
    if spans_decades(data) {
        return Axis::log(NAME, Unit::Si("m"), first.elongation, 3.0 * top);
    }
    let starts = || data.held.iter().filter_map(|held| held.shifted.first()).map(|point| point[1]);
    let lowest = starts().fold(0.0, f64::min).max(-top);
    let highest = starts().fold(top, f64::max).min(2.0 * top);
    // Zero is the end of the axis unless a curve begins well below.
    Axis::linear(NAME, Unit::Si("m"), if lowest < -0.05 * top { 1.2 * lowest } else { 0.0 }, 1.35 * highest)
}

/// Arrows between the equilibria at one value, as far as there is room.
fn directions(data: &Diagram, held: &HeldCurve, Panel { x, y, .. }: &Panel) -> Vec<Layer> {
    const REACH: f64 = 0.06;
    let states = held.equilibria.iter().map(|state| x.fraction(state.contact_radius));
    let ends: Vec<f64> = [x.fraction(0.0).max(0.0)].into_iter().chain(states).chain([1.0]).collect();
    let samples: Vec<&CurveSample> = data.samples().collect();
    let height = y.at(0.07);
    let mut layers = Vec::new();
    for pair in ends.windows(2).filter(|pair| pair[1] - pair[0] > 1.6 * REACH) {
        let middle = f64::midpoint(pair[0], pair[1]);
        let radius = x.at(middle);
        let next = samples.iter().find(|sample| sample.contact_radius >= radius);
        let shifted = held.shifted.iter().find(|point| point[0] >= radius);
        let (Some(sample), Some([_, shifted])) = (next, shifted) else { continue };
        let grows = *shifted < sample.elongation;
        let reach = if grows { REACH / 2.0 } else { -REACH / 2.0 };
        let [from, to] = [middle - reach, middle + reach].map(|at| [x.at(at), height]);
        layers.push(change(grows, from, to));
    }
    layers
}

/// Events in a caption.
const MOST_TOLD: usize = 40;

/// The caption.
fn description(data: &Diagram) -> String {
    let control = match &data.control {
        Control::Indentation => "controlled indentation".to_owned(),
        Control::Force => "controlled force".to_owned(),
        Control::Machine { stiffness } => {
            format!("a machine of stiffness {stiffness} {}", data.stiffness_unit)
        }
    };
    let mut text = format!(
        "Under {control}, computed in f64. (a) The diagram of Δl(a) and g(a) − d; equilibria are where the curves meet. \
         (b), (c) Force against indentation depth and against contact radius{}: stable equilibria solid, unstable ones \
         dashed, jumps as arrows, events numbered. The contact is assumed to be simply connected. {} folds in the range of radii shown, {}.",
        match data.control {
            Control::Machine { .. } => ", (d) against the position D = d + F/k",
            _ => "",
        },
        data.folds.len(),
        match data.completeness {
            SearchQuality::Resolved => "not proved to be all",
            SearchQuality::Doubtful => "and perhaps more that the search in f64 could not resolve",
        }
    );
    for (index, event) in data.path.iter().enumerate().take(MOST_TOLD) {
        text.push_str(&format!(" Event {}: {}", index + 1, event.kind.name()));
        for (word, state) in [("from", event.before), ("to", event.after.filter(|after| Some(*after) != event.before))]
        {
            if let Some(State { contact_radius, indentation, force }) = state {
                text.push_str(&format!(" {word} a = {contact_radius:.6e} m"));
                if indentation.is_finite() {
                    text.push_str(&format!(", d = {indentation:.6e} m, F = {force:.6e} {}", data.force_unit));
                }
            }
        }
        text.push('.');
    }
    if data.path.len() > MOST_TOLD {
        text.push_str(&format!(" {} more events.", data.path.len() - MOST_TOLD));
    }
    text
}
