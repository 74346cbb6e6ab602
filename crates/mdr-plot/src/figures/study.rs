//! The parts of the figures: curves, states, guides and arrows of a contact under controlled indentation.

use std::borrow::Cow;

use mdr::Result;
use mdr::critical::PowerLaw;
use mdr::diagram::{CurveSample, Equilibrium};
use mdr::prelude::*;

use crate::balance::{Balance, change, shifted};
use crate::chart::{Layer, Mark, Panel, Point, Side, Stroke};
use crate::{Axis, Unit};

/// A contact whose balance is drawn in a panel.
pub(super) struct Study {
    pub(super) sides: Balance<'static>,
    pub(super) panel: Panel,
}

/// The critical state of f = C rⁿ with E* = w = 1 under controlled indentation: κ, a_c, d_c and F_c.
pub(super) fn critical(n: &str, c: &str) -> Result<[f64; 4]> {
    let [n, c, work_of_adhesion] = [n.exact()?, c.exact()?, 1.exact()?];
    let elasticity = Elasticity::effective("1")?;
    let law = PowerLaw { n, c, elasticity, work_of_adhesion, control: Control::Indentation };
    let answer = mdr::critical(&law, Arithmetic::F64)?;
    let state = answer.state.ok_or_else(|| missing("folds", "there is no critical state".to_owned()))?;
    let [a, d, force] = state.values().map(|value| value.to_f64().unwrap_or(f64::NAN));
    Ok([answer.kappa.to_f64(), a, d, force])
}

fn missing(output: &str, why: String) -> Error {
    Error::Scene { place: None, key: format!("output.{output}"), why }
}

impl Study {
    /// The contact as far as the axis of radii reaches, measured in these units, with its equilibria at some indentations.
    pub(super) fn new(scene: Scene, units: [f64; 2], depths: &[f64], panel: Panel) -> Result<Self> {
        let at = depths.iter().map(|depth| depth.exact()).collect::<std::result::Result<_, _>>()?;
        let scene = scene.want(Want::Equilibria { at }).arithmetic(Arithmetic::F64);
        let diagram = scene.diagram_up_to(panel.x.range().1 * units[0])?;
        Ok(Study { sides: Balance { diagram: Cow::Owned(diagram), units }, panel })
    }

    /// Draws layers over those that are there.
    pub(super) fn add(&mut self, layers: impl IntoIterator<Item = Layer>) {
        self.panel.layers.extend(layers);
    }

    /// The radius of the first fold.
    pub(super) fn fold(&self) -> f64 {
        self.sides.diagram.folds.first().map_or(f64::NAN, |fold| fold.contact_radius)
    }

    /// All equilibria at one of the indentations, by increasing radius.
    pub(super) fn equilibria(&self, d: f64) -> &[Equilibrium<f64>] {
        self.sides.diagram.held.iter().find(|held| held.value == d).map_or(&[], |held| &held.equilibria)
    }

    /// One of them, from 0.
    pub(super) fn nth(&self, d: f64, index: usize) -> Result<&Equilibrium<f64>> {
        let why = || format!("there is no equilibrium number {} at d = {d}", index + 1);
        self.equilibria(d).get(index).ok_or_else(|| missing("equilibria", why()))
    }

    /// The curve Δl(a). Curves begin in the origin, nearer to it than the first sample.
    pub(super) fn elongation(&self) -> Layer {
        let mut curve = self.sides.elongation();
        curve.points.insert(0, [0.0, 0.0]);
        curve.points.dedup();
        curve
    }

    /// The curve g(a) − d.
    pub(super) fn transformed(&self, d: f64, name: &str, stroke: Stroke) -> Layer {
        let [radius, length] = self.sides.units;
        let at = |sample: &CurveSample| [sample.contact_radius / radius, (sample.transformed - d) / length];
        let mut points: Vec<_> = [[0.0, -d / length]].into_iter().chain(self.sides.diagram.samples().map(at)).collect();
        points.dedup();
        shifted(name, points, stroke)
    }

    /// The name of a curve at its right end, as far as it is seen.
    pub(super) fn ending(&self, curve: &Layer, side: Side) -> Layer {
        let Panel { x, y, .. } = &self.panel;
        let seen = |[a, b]: &&Point| (0.03..0.9).contains(&x.fraction(*a)) && (0.03..0.93).contains(&y.fraction(*b));
        let anchors = curve.points.iter().rev().filter(seen).copied().collect();
        Layer::label(curve.name.clone(), anchors, side).coloured(curve.colour)
    }

    /// A mark at an equilibrium, with a label unless its name is empty.
    pub(super) fn state(
        &self,
        state: &Equilibrium<f64>,
        name: &str,
        side: Side,
    ) -> impl Iterator<Item = Layer> + use<> {
        let marks = self.sides.states(name, [state], state.stability);
        let label = (!name.is_empty()).then(|| Layer::label(name, marks.points.clone(), side));
        [marks].into_iter().chain(label)
    }

    /// The critical state P, and its label.
    pub(super) fn critical(&self) -> [Layer; 2] {
        let at = vec![self.sides.on_elongation(self.fold())];
        [
            Layer::marks("*P*", at.clone(), Mark::Diamond).meaning("last equilibrium"),
            Layer::label("*P*", at, Side::Below),
        ]
    }

    /// A guide from Δl down to the axis of radii, with a label at its foot.
    pub(super) fn dropped(&self, a: f64, label: &str, side: Side) -> [Layer; 2] {
        let ([x, top], y) = (self.sides.on_elongation(a), &self.panel.y);
        let foot = [0.13, 0.19, 0.25].map(|height| [x, y.at(height)]).to_vec();
        [Layer::curve(label, vec![[x, y.range().0], [x, top]], Stroke::Guide), Layer::label(label, foot, side)]
    }

    /// An arrow along the axis of radii: which way a contact of radius `a` goes at the indentation d, by (1.8) and (1.9).
    pub(super) fn direction(&self, a: f64, d: f64) -> Layer {
        let (Panel { x, y, .. }, Balance { diagram, units }) = (&self.panel, &self.sides);
        let next = diagram.samples().find(|sample| sample.contact_radius >= a);
        let grows = next.is_some_and(|sample| sample.transformed - d < sample.elongation);
        let reach = (x.at(0.075) - x.at(0.0)) * if grows { 1.0 } else { -1.0 };
        let (from, height) = (a / units[0], y.at(ARROW_HEIGHT));
        change(grows, [from, height], [from + reach, height])
    }
}

/// How far above the axis of radii its arrows are, as a share of the vertical axis.
pub(super) const ARROW_HEIGHT: f64 = 0.055;

/// A panel with axes in units of the critical state of a power law.
pub(super) fn critical_panel(heading: &str, upper: f64, heights: [f64; 2]) -> Panel {
    let x = Axis::linear("contact radius *a* / *a*_{c}", Unit::One, 0.0, upper);
    Panel::new(heading, x, Axis::linear("length / |*d*_{c}|", Unit::One, heights[0], heights[1]))
}
