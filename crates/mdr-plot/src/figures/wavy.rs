//! Figure 4: a paraboloid with waves, whose contact jumps from crest to crest while it is pulled off.

use mdr::Result;
use mdr::diagram::State;
use mdr::prelude::{Elasticity, EventKind, Scene, Shape, Stability};

use super::study::{ARROW_HEIGHT, Study};
use crate::balance::LOSS;
use crate::chart::{Layer, Mark, Panel, Picture, Side, Stroke};
use crate::{Axis, Unit, typographic};

/// The largest radius shown, in m.
const UPPER: f64 = 0.12;

/// The largest length shown at d = 0, in m; pulling adds to it.
const UNPULLED: f64 = 0.0105;

/// Amplitude and wavelength of the waves, in m: one jump, and two.
const WAVES: [(f64, f64); 2] = [(5e-4, 0.1), (2e-4, 0.03)];

/// Figure 4.
pub(super) fn figure_4() -> Result<Picture> {
    let mut description = "The diagram {Δl(a), g(a) − d} of the profile r²/2R + A(1 − cos 2πr/λ), R = 1 m, w/E* = 0.0001 m; \
                           the contact is assumed to be simply connected. It rests with the radius a_0 at d = 0 and is pulled \
                           until the curves touch."
        .to_owned();
    let mut panels = Vec::new();
    for (letter, (amplitude, wavelength)) in ["a", "b"].into_iter().zip(WAVES) {
        let tip = Shape::WavyParaboloid { radius: 1.0, amplitude, wavelength };
        let scene = Scene::new(tip, Elasticity::effective("1")?, "1e-4")?.path(["0", "-1"])?;
        let waves = format!("*A* = {} mm, *λ* = {} mm", 1e3 * amplitude, 1e3 * wavelength);
        let axis = |quantity, upper| Axis::linear(quantity, Unit::Si("m"), 0.0, upper);
        let (x, y) = (axis("contact radius *a*", UPPER), axis("length", UNPULLED));
        let panel = Panel::new(format!("({letter})  *g*(*a*) − *d*, {waves}"), x, y);
        let history = History::of(&Study::new(scene.clone(), [1.0; 2], &[], panel.clone())?);
        let mut study = Study::new(scene, [1.0; 2], &history.depths(), panel)?;
        description.push_str(&format!(" ({letter}) A = {amplitude} m, λ = {wavelength} m: {}", history.description()));
        let deepest = history.jumps.iter().map(|jump| jump.d).fold(0.0, f64::min);
        study.panel.y = axis("length", UNPULLED - deepest);
        history.draw(&mut study);
        panels.push(study.panel);
    }
    Ok(Picture { title: "Figure 4: a wavy paraboloid jumps from crest to crest".to_owned(), description, panels })
}

/// The events on pulling from d = 0.
struct History {
    /// a_0.
    start: f64,
    jumps: Vec<Jump>,
}

/// The event where the curves touch.
struct Jump {
    /// The radius there, in m.
    from: f64,
    /// The indentation, in m.
    d: f64,
    /// The radius at which the contact comes to rest, in m; `None` if it breaks.
    to: Option<f64>,
}

impl History {
    fn of(study: &Study) -> Self {
        let radius = |state: Option<State>| state.map(|state| state.contact_radius).filter(|radius| *radius > 0.0);
        let path = &study.sides.diagram.path;
        let jumps = path.iter().filter(|event| matches!(event.kind, EventKind::Jump | EventKind::Detached));
        History {
            start: path.first().and_then(|event| radius(event.before)).unwrap_or_default(),
            jumps: jumps
                .filter_map(|event| Some(Jump { from: radius(event.before)?, d: event.value, to: radius(event.after) }))
                .collect(),
        }
    }

    /// The history in words and numbers.
    fn description(&self) -> String {
        let mut text = format!("a_0 = {:.7} m;", self.start);
        for Jump { from, d, to } in &self.jumps {
            let end = match to {
                Some(to) => format!(" jumps to {to:.7} m;"),
                None => " breaks.".to_owned(),
            };
            text.push_str(&format!(" at a = {from:.7} m, d = {d:.8} m the contact{end}"));
        }
        text
    }

    /// The indentations of the curves that are drawn, in m.
    fn depths(&self) -> Vec<f64> {
        [0.0].into_iter().chain(self.jumps.iter().map(|jump| jump.d)).collect()
    }

    fn draw(&self, study: &mut Study) {
        const STROKES: [Stroke; 4] = [Stroke::Dashed, Stroke::DashDotted, Stroke::Dotted, Stroke::Thin];
        study.add([study.elongation(), study.ending(&study.elongation(), Side::Below)]);
        let depths = self.jumps.iter().enumerate().map(|(index, jump)| (jump.d, format!("*d*_{{{}}}", index + 1)));
        for ((d, name), stroke) in [(0.0, "*d*".to_owned())].into_iter().chain(depths).zip(STROKES.into_iter().cycle())
        {
            let curve = study.transformed(d, &format!("*g*(*a*) − *d*, *d* = {d:.7} m"), stroke);
            study.add([curve.meaning(format!("{name} = {}", millimetres(d)))]);
        }
        self.mark(study);
        let height = study.panel.y.at(ARROW_HEIGHT);
        let arrow = |jump: &Jump| Layer::arrow("jump", [[jump.from, height], [jump.to.unwrap_or(0.0), height]]);
        study.add(self.jumps.iter().map(|jump| arrow(jump).coloured(LOSS).meaning("jump")));
    }

    /// Radii as the paper names them: a_0 at the start, then those where the curves touch, and a_2 where the first jump ends.
    fn mark(&self, study: &mut Study) {
        // A fold has two equilibria that rounding keeps apart.
        let is_fold = |a: f64| self.jumps.iter().any(|jump| (jump.from / a - 1.0).abs() < 1e-3);
        for d in self.depths() {
            let states = study.equilibria(d).iter();
            let states =
                states.filter(|state| state.stability == Stability::Unstable && !is_fold(state.contact_radius));
            let marks = study.sides.states("unstable", states, Stability::Unstable);
            study.add(Some(marks).filter(|marks| !marks.points.is_empty()));
        }
        let stable = |a: f64| (a, Mark::Filled, "stable");
        let mut states = vec![stable(self.start)];
        for Jump { from, to, .. } in &self.jumps {
            let meaning = if states.len() == 1 { "first point of instability" } else { "instability" };
            states.push((*from, Mark::Diamond, meaning));
            states.extend(to.map(stable));
        }
        let mut names = (0..).map(|number| format!("*a*_{{{number}}}")).peekable();
        for (index, (a, mark, meaning)) in states.into_iter().enumerate() {
            study.add([Layer::marks("", vec![study.sides.on_elongation(a)], mark).meaning(meaning)]);
            // The ends of later jumps have no name.
            let named = index < 3 || mark == Mark::Diamond;
            let name = if named { names.next() } else { names.peek().cloned() };
            let guide_and_label = study.dropped(a, &name.unwrap_or_default(), Side::Right);
            study.add(guide_and_label.into_iter().take(1 + usize::from(named)));
        }
    }
}

/// Three decimals, and none for zero.
fn millimetres(length: f64) -> String {
    if length == 0.0 { "0".to_owned() } else { typographic(&format!("{:.3} mm", 1e3 * length)) }
}
