//! The picture of a scene: the diagram {Δl, g − d}, and force against indentation and against contact radius.

mod loading;
#[cfg(test)]
mod tests;

use mdr_core::contact::Control;
use mdr_numeric::folds::Completeness;

use mdr::diagram::{DECADES, Diagram, HeldCurve, Spot, is_stable};

use super::axis::typographic;
use super::{Axis, Key, Layer, Mark, Panel, Picture, Stroke, Unit};

/// The picture of a scene.
pub(crate) fn picture(title: &str, data: &Diagram) -> Picture {
    Picture {
        title: title.to_owned(),
        description: description(data),
        panels: vec![
            balance(data),
            loading::panel(data, loading::Plane::Indentation),
            loading::panel(data, loading::Plane::Radius),
        ],
    }
}

/// The range of radii that is shown.
fn radii(data: &Diagram) -> (f64, f64) {
    let samples = || data.branches.iter().flat_map(|branch| &branch.samples).map(|sample| sample.contact_radius);
    (samples().fold(f64::INFINITY, f64::min), samples().fold(0.0, f64::max))
}

/// Whether the folds lie decades apart, so that radii need a logarithmic axis.
fn spans_decades(data: &Diagram) -> bool {
    data.folds.first().is_some_and(|fold| fold.contact_radius < radii(data).1 / DECADES)
}

fn radius_axis(data: &Diagram) -> Axis {
    const NAME: &str = "contact radius *a*";
    let (lower, upper) = radii(data);
    if spans_decades(data) {
        Axis::log(NAME, Unit::Si("m"), lower, upper)
    } else {
        // A wall is seen from outside, too.
        Axis::linear(NAME, Unit::Si("m"), 0.0, if data.wall.is_some() { 1.1 * upper } else { upper })
    }
}

/// The controlled quantity with its value, for a legend.
fn named(data: &Diagram, value: f64) -> String {
    let (name, unit) = match data.control {
        Control::Indentation => ("*d*", "m"),
        Control::Force => ("*F*", "N"),
        Control::Machine { .. } => ("*d* + *F*/*k*", "m"),
    };
    format!("{name} = {}", with_prefix(value, unit))
}

/// Four significant digits and an SI prefix.
fn with_prefix(value: f64, unit: &'static str) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let axis = Axis::linear("", Unit::Si(unit), 0.0, value.abs());
    let (power, unit) = axis.scaled_unit();
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
    let x = radius_axis(data);
    let y = balance_heights(data);
    let elongation: Vec<_> = data
        .branches
        .iter()
        .flat_map(|branch| &branch.samples)
        .map(|sample| [sample.contact_radius, sample.elongation])
        .collect();
    let mut layers = vec![Layer::Curve { name: "Δ*l*(*a*)".to_owned(), points: elongation, stroke: Stroke::Solid }];
    let mut legend = vec![(Key::Line(Stroke::Solid), "Δ*l*".to_owned())];
    let crowded = data.folds.len() > CROWD;
    let shown = if crowded { &data.held[..data.held.len().min(1)] } else { &data.held[..] };
    for (held, stroke) in shown.iter().zip(STROKES) {
        let stroke = if crowded { Stroke::Thin } else { stroke };
        let name = named(data, held.value);
        legend.push((Key::Line(stroke), format!("*g* − *d*, {name}")));
        layers.push(Layer::Curve { name: format!("*g* − *d*, {name}"), points: held.shifted.clone(), stroke });
    }
    let mut kinds = Vec::new();
    for held in shown.iter().filter(|held| held.equilibria.len() < CROWD) {
        for (stable, mark, name) in
            [(Some(true), Mark::Filled, "stable"), (Some(false), Mark::Open, "unstable"), (None, Mark::Diamond, "fold")]
        {
            let points = equilibria(data, held, stable);
            if points.is_empty() {
                continue;
            }
            layers.push(Layer::Marks { name: format!("{name}, {}", named(data, held.value)), points, mark });
            if !kinds.contains(&(Key::Mark(mark), name)) {
                kinds.push((Key::Mark(mark), name));
            }
        }
    }
    let arrows = data.held.first().map_or_else(Vec::new, |first| directions(data, first, &x, &y));
    if !arrows.is_empty() {
        kinds.push((Key::Arrow, "direction of change at the first value"));
    }
    layers.extend(arrows);
    legend.extend(kinds.into_iter().map(|(key, name)| (key, name.to_owned())));
    Panel { heading: "(a)  balance at the edge of the contact".to_owned(), x, y, layers, legend, aspect: 0.55 }
}

/// Heights that show all equilibria, and as much of the curves as comes with them.
fn balance_heights(data: &Diagram) -> Axis {
    const NAME: &str = "length";
    let samples = || data.branches.iter().flat_map(|branch| &branch.samples);
    let (Some(first), Some(last)) = (samples().next(), samples().last()) else {
        return Axis::linear(NAME, Unit::Si("m"), 0.0, 1.0);
    };
    if spans_decades(data) {
        return Axis::log(NAME, Unit::Si("m"), first.elongation, 3.0 * last.elongation);
    }
    let top = last.elongation;
    let starts = || data.held.iter().filter_map(|held| held.shifted.first()).map(|point| point[1]);
    let lowest = starts().fold(0.0, f64::min).max(-top);
    let highest = starts().fold(top, f64::max).min(2.0 * top);
    // Zero is the end of the axis unless a curve begins well below.
    Axis::linear(NAME, Unit::Si("m"), if lowest < -0.05 * top { 1.2 * lowest } else { 0.0 }, 1.35 * highest)
}

/// The equilibria of one kind, on Δl.
fn equilibria(data: &Diagram, held: &HeldCurve, stable: Option<bool>) -> Vec<[f64; 2]> {
    let samples = || data.branches.iter().flat_map(|branch| &branch.samples);
    // Δl grows as √a, which is exact from any sample.
    let Some(sample) = samples().last() else { return Vec::new() };
    let elongation = |a: f64| sample.elongation * (a / sample.contact_radius).sqrt();
    let shown = 0.0..=sample.contact_radius;
    let states =
        held.equilibria.iter().filter(|state| is_stable(state) == stable && shown.contains(&state.contact_radius));
    states.map(|state| [state.contact_radius, elongation(state.contact_radius)]).collect()
}

/// Arrows between the equilibria at one value, as far as there is room: where g − d is above Δl the contact shrinks.
fn directions(data: &Diagram, held: &HeldCurve, x: &Axis, y: &Axis) -> Vec<Layer> {
    const REACH: f64 = 0.06;
    let states = held.equilibria.iter().map(|state| x.fraction(state.contact_radius));
    let ends: Vec<f64> = [0.0].into_iter().chain(states).chain([1.0]).collect();
    let samples: Vec<_> = data.branches.iter().flat_map(|branch| &branch.samples).collect();
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
        layers.push(Layer::Arrow {
            name: if grows { "grows (1.9)" } else { "shrinks (1.8)" }.to_owned(),
            from: [x.at(middle - reach), height],
            to: [x.at(middle + reach), height],
            stroke: Stroke::Thin,
        });
    }
    layers
}

/// The caption.
fn description(data: &Diagram) -> String {
    let control = match &data.control {
        Control::Indentation => "controlled indentation".to_owned(),
        Control::Force => "controlled force".to_owned(),
        Control::Machine { stiffness } => format!("a machine of stiffness {stiffness} N/m"),
    };
    let mut text = format!(
        "Under {control}, computed in f64. (a) The diagram of Δl(a) and g(a) − d; equilibria are where the curves meet. \
         (b), (c) Force against indentation depth and against contact radius: stable equilibria solid, unstable ones \
         dashed, jumps as arrows. The contact is assumed to be simply connected. {} folds in the range of radii shown, {}.",
        data.folds.len(),
        match data.completeness {
            Completeness::Resolved => "not proved to be all",
            Completeness::Doubtful => "and perhaps more that the search in f64 could not resolve",
        }
    );
    for (index, event) in data.path.iter().enumerate().take(MOST_TOLD) {
        text.push_str(&format!(" Event {}: {}", index + 1, event.kind.name()));
        for (word, spot) in [("from", event.before), ("to", event.after.filter(|after| Some(*after) != event.before))] {
            if let Some(Spot { contact_radius, indentation, force }) = spot {
                text.push_str(&format!(" {word} a = {contact_radius:.6e} m"));
                if indentation.is_finite() {
                    text.push_str(&format!(", d = {indentation:.6e} m, F = {force:.6e} N"));
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

/// Events in a caption.
const MOST_TOLD: usize = 40;
