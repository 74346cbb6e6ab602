//! Figure 5: Johnson's wave, whose surfaces jump into complete contact under a load, and not under a held approach.

use std::f64::consts::PI;

use mdr::Result;
use mdr::diagram::{Equilibrium, State};
use mdr::prelude::{Control, Elasticity, Exact, ExactMedium, Literal, Profile, Scene};

use super::study::{ARROW_HEIGHT, Study};
use crate::balance::{LOSS, shifted};
use crate::chart::{Layer, Mark, Panel, Picture, Side, Stroke};
use crate::{Axis, Unit};

/// α = √(2λw/(π²h₀²E*)).
const ALPHA: f64 = 0.3;
/// The largest half-width shown, over λ: at 1/2 the contact is complete.
const UPPER: f64 = 0.499;

/// A wave with λ = h₀ = E* = 1.
fn wave(control: Control<Literal>) -> Result<Scene> {
    let work = (PI * ALPHA).powi(2) / 2.0;
    let medium = ExactMedium::Periodic { wavelength: 1.exact()?, flaw: None };
    Ok(Scene::new(Profile::Wave(1.exact()?), Elasticity::effective("1")?, work)?.medium(medium)?.control(control))
}

/// The contact with its folds, and the curves that touch there.
struct Touching {
    study: Study,
    folds: Vec<State>,
}

impl Touching {
    fn new(scene: &Scene, heading: &str, heights: [f64; 2], held: impl Fn(&State) -> f64) -> Result<Self> {
        let panel = || {
            let x = Axis::linear("half-width *a* / *λ*", Unit::One, 0.0, UPPER);
            Panel::new(heading, x, Axis::linear("length / *h*_{0}", Unit::One, heights[0], heights[1]))
        };
        let folds = Study::new(scene.clone(), [1.0; 2], &[], panel())?.sides.diagram.folds.clone();
        let values: Vec<f64> = folds.iter().map(held).collect();
        Ok(Touching { study: Study::new(scene.clone(), [1.0; 2], &values, panel())?, folds })
    }

    /// The curves, where they touch, and the jumps from there: to radii in units of λ.
    fn draw(mut self, names: &[(&str, &str, Side, f64)]) -> Panel {
        let study = &mut self.study;
        study.add([study.elongation(), study.ending(&study.elongation(), Side::Above)]);
        let strokes = [Stroke::Dashed, Stroke::DashDotted];
        for (((value, label, side, rest), fold), stroke) in names.iter().zip(&self.folds).zip(strokes) {
            let near = |held: &&mdr::diagram::HeldCurve| {
                held.equilibria
                    .iter()
                    .any(|one: &Equilibrium<f64>| (one.contact_radius - fold.contact_radius).abs() < 1e-6)
            };
            let points = study.sides.diagram.held.iter().find(near).map(|held| held.shifted.clone());
            let curve = shifted(format!("*g*(*a*) − *d*, {value}"), points.unwrap_or_default(), stroke);
            study.add([curve.meaning(*value)]);
            let at = vec![study.sides.on_elongation(fold.contact_radius)];
            study.add([
                Layer::marks(*label, at.clone(), Mark::Diamond).meaning("critical"),
                Layer::label(*label, at, *side),
            ]);
            let height = study.panel.y.at(ARROW_HEIGHT);
            let arrow = Layer::arrow("jump", [[fold.contact_radius, height], [*rest, height]]);
            study.add([arrow.coloured(LOSS).meaning("jump")]);
        }
        self.study.panel
    }
}

/// Figure 5: (a) the approach of the mean planes is held; (b) the mean pressure is.
pub(super) fn figure_5() -> Result<Picture> {
    let approach = Touching::new(
        &wave(Control::Indentation)?,
        "(a)  *g*(*a*) − *d* at a held approach *d*",
        [0.0, 1.5],
        |fold| fold.indentation,
    )?;
    let load =
        Touching::new(&wave(Control::Force)?, "(b)  *g*(*a*) − *d* under a held pressure", [-0.75, 0.85], |fold| {
            fold.force
        })?;
    let described = |folds: &[State]| -> Vec<String> {
        let one = |fold: &State| {
            let pressure = fold.force / PI;
            format!("a = {:.7} λ, d = {:.7} h₀, p = {pressure:.7} p*", fold.contact_radius, fold.indentation)
        };
        folds.iter().map(one).collect()
    };
    let description = format!(
        "The diagram {{Δl(a), g(a) − d}} of a half-plane on a wave h₀(1 − cos 2πx/λ) (Johnson 1995), α = {ALPHA}, with \
         g = h₀s(1 − ln s), s = sin²(πa/λ), and Δl = h₀α|ln s|√tan(πa/λ); p* = πE*h₀/λ. (a) Where the approach of the mean planes is \
         held the curves touch once, at P: {}. There the contact is pulled off; it never jumps into complete contact. (b) Under a mean \
         pressure, with the d that the pressure holds at each a, they touch twice: the contact breaks at P_1, {}, and jumps into \
         complete contact, a = λ/2, at P_2, {}.",
        described(&approach.folds).join("; "),
        described(&load.folds[..1.min(load.folds.len())]).join(""),
        described(load.folds.get(1..).unwrap_or_default()).join("; "),
    );
    let panels = vec![
        approach.draw(&[("*d* = *d*_{c}", "*P*", Side::Above, 0.0)]),
        load.draw(&[("pull-off", "*P*_{1}", Side::Above, 0.0), ("pull-in", "*P*_{2}", Side::Below, UPPER)]),
    ];
    Ok(Picture { title: "Figure 5: a wave that jumps into complete contact".to_owned(), description, panels })
}
