//! Figure 4: a paraboloid with waves, whose contact jumps from crest to crest while it is pulled off.

use mdr_analytic::profiles::WavyParaboloid;
use mdr_core::contact::{Material, Result};
use mdr_numeric::path::{Event, EventKind, Path, Start, State};

use super::convex::elongation_name;
use super::diagram::{ARROW_HEIGHT, CRITICAL, STABLE, Study, panel};
use crate::picture::axis::typographic;
use crate::picture::{Axis, Key, Layer, Mark, Panel, Picture, Side, Stroke, Unit};

/// R, E* and w/E* of both panels.
const RADIUS: f64 = 1.0;
const LENGTH: f64 = 1e-4;

/// The largest radius shown, in m.
const UPPER: f64 = 0.12;

/// Amplitude and wavelength of the waves, in m: one jump, and two.
const WAVES: [(f64, f64); 2] = [(5e-4, 0.1), (2e-4, 0.03)];

/// Figure 4.
pub(super) fn figure_4() -> Result<Picture> {
    let mut description = format!(
        "The diagram {{Δl(a), g(a) − d}} of the profile r²/2R + A(1 − cos 2πr/λ), R = {RADIUS} m, w/E* = {LENGTH} m; the \
         contact is assumed to be simply connected. It rests with the radius a_0 at d = 0 and is pulled until the curves \
         touch."
    );
    let mut panels = Vec::new();
    for (letter, (amplitude, wavelength)) in ["a", "b"].into_iter().zip(WAVES) {
        let profile = WavyParaboloid::new(RADIUS, amplitude, wavelength)?;
        let material = Material::new(1.0, LENGTH)?;
        let study = Study::new(&profile, &material, (1.0, 1.0), UPPER)?;
        let history = history(&study)?;
        description.push_str(&told(letter, (amplitude, wavelength), &history));
        panels.push(drawn(letter, (amplitude, wavelength), &study, &history)?);
    }
    Ok(Picture { title: "Figure 4: a wavy paraboloid jumps from crest to crest".to_owned(), description, panels })
}

/// What happens on pulling from d = 0.
struct History {
    /// a_0.
    start: f64,
    jumps: Vec<Jump>,
}

/// What happens where the curves touch.
struct Jump {
    /// The radius there, in m.
    from: f64,
    /// The indentation, in m.
    d: f64,
    /// The radius at which the contact comes to rest, in m; none when it breaks.
    to: Option<f64>,
}

/// Pulls the contact from d = 0 until it breaks.
fn history(study: &Study<'_>) -> Result<History> {
    let path = Path::follow(study.branches(), &Start::Largest, &[0.0, -RADIUS])?;
    let radius = |state: &State<f64>| state.contact().map(|rest| rest.contact_radius);
    let start = path.events.first().and_then(|event| radius(&event.before)).unwrap_or_default();
    let jumps = path.events.iter().filter(|event| matches!(event.kind, EventKind::Jump | EventKind::Detached));
    let jump =
        |event: &Event<f64>| Some(Jump { from: radius(&event.before)?, d: event.value, to: radius(&event.after) });
    Ok(History { start, jumps: jumps.filter_map(jump).collect() })
}

/// The history in words and numbers.
fn told(letter: &str, (amplitude, wavelength): (f64, f64), history: &History) -> String {
    let mut text = format!(" ({letter}) A = {amplitude} m, λ = {wavelength} m: a_0 = {:.7} m;", history.start);
    for Jump { from, d, to } in &history.jumps {
        let end = match to {
            Some(to) => format!(" jumps to {to:.7} m;"),
            None => " breaks.".to_owned(),
        };
        text.push_str(&format!(" at a = {from:.7} m, d = {d:.8} m the contact{end}"));
    }
    text
}

fn drawn(letter: &str, (amplitude, wavelength): (f64, f64), study: &Study<'_>, history: &History) -> Result<Panel> {
    let deepest = history.jumps.iter().map(|jump| jump.d).fold(0.0, f64::min);
    let x = Axis::linear("contact radius *a*", Unit::Si("m"), 0.0, UPPER);
    let y = Axis::linear("length", Unit::Si("m"), 0.0, 0.0105 - deepest);
    let mut layers = vec![study.elongation(), elongation_name(study, &x, &y)];
    let depths = history.jumps.iter().enumerate().map(|(index, jump)| (jump.d, format!("*d*_{{{}}}", index + 1)));
    let mut legend: Vec<(Key, String)> = Vec::new();
    for ((d, name), stroke) in [(0.0, "*d*".to_owned())].into_iter().chain(depths).zip(STROKES.into_iter().cycle()) {
        layers.push(study.transformed(d, &format!("*g*(*a*) − *d*, *d* = {d:.7} m"), stroke));
        legend.push((Key::Line(stroke), format!("{name} = {}", millimetres(d))));
    }
    legend.extend([STABLE, CRITICAL, (Key::Arrow, "jump")].map(|(key, text)| (key, text.to_owned())));
    layers.extend(marked(study, history, &y));
    let heading = format!("({letter})  *g*(*a*) − *d*, *A* = {} mm, *λ* = {} mm", 1e3 * amplitude, 1e3 * wavelength);
    Ok(Panel { layers, legend, ..panel(&heading, x, y) })
}

/// Strokes of the curves g(a) − d.
const STROKES: [Stroke; 4] = [Stroke::Dashed, Stroke::DashDotted, Stroke::Dotted, Stroke::Thin];

/// Three decimals, and none for zero.
fn millimetres(length: f64) -> String {
    if length == 0.0 { "0".to_owned() } else { typographic(&format!("{:.3} mm", 1e3 * length)) }
}

/// Radii as the paper names them: a_0 at the start, then those where the curves touch, and a_2 where the first jump ends.
fn marked(study: &Study<'_>, history: &History, y: &Axis) -> Vec<Layer> {
    let height = y.at(ARROW_HEIGHT);
    let mut layers = Vec::new();
    let mut number = 0;
    let mut mark = |a: f64, mark: Mark, named: bool| {
        layers.extend(study.marked(a, "", mark, Side::Above).into_iter().take(1));
        let [guide, label] = study.dropped(a, &format!("*a*_{{{number}}}"), y, Side::Right);
        layers.push(guide);
        if named {
            layers.push(label);
            number += 1;
        }
    };
    mark(history.start, Mark::Filled, true);
    for (index, jump) in history.jumps.iter().enumerate() {
        mark(jump.from, Mark::Diamond, true);
        if let Some(to) = jump.to {
            mark(to, Mark::Filled, index == 0);
        }
    }
    for jump in &history.jumps {
        let (from, to) = ([jump.from, height], [jump.to.unwrap_or(0.0), height]);
        layers.push(Layer::Arrow { name: "jump".to_owned(), from, to, stroke: Stroke::Thin });
    }
    layers
}
