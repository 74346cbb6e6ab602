//! The diagram {Δl(a), g(a) − d} of the paper, computed.

use mdr_core::contact::{Control, Equilibrium, Error, Instability, Material, Quantity, Result, Stability, Transform};
use mdr_numeric::branch::Branched;
use mdr_numeric::curve::Curve;
use mdr_numeric::equilibrium::Branches;

use crate::picture::{Axis, Key, Layer, Mark, Panel, Point, Side, Stroke, Unit};
use mdr::diagram::{Sample, samples};

/// Controlled indentation, the case of the paper.
const CONTROL: Control<f64> = Control::Indentation;

/// A contact whose diagrams are drawn, with the lengths that its axes are measured in.
pub(super) struct Study<'a> {
    branches: Branches<'a, f64>,
    /// The unit of radii, in m.
    radius: f64,
    /// The unit of lengths along the vertical axis, in m.
    length: f64,
    samples: Vec<Sample>,
}

impl<'a> Study<'a> {
    /// Folds and curve of a contact up to the radius `upper` (in units of `radius`).
    pub(super) fn new(
        transform: &'a dyn Transform<f64>,
        material: &'a Material<f64>,
        (radius, length): (f64, f64),
        upper: f64,
    ) -> Result<Self> {
        let branches = Branches::new(Curve::new(transform, material, &CONTROL))?;
        let nodes: Vec<_> = branches.folds().iter().map(|fold| fold.contact_radius).collect();
        // The curves begin in the origin; the first sample is nearer to it than anybody sees.
        let samples = samples(branches.curve(), 1e-6 * upper * radius, upper * radius, &nodes)?;
        Ok(Study { branches, radius, length, samples })
    }

    /// The folds by increasing radius.
    pub(super) fn folds(&self) -> &[Instability<f64>] {
        self.branches.folds()
    }

    /// The branches between the folds.
    pub(super) fn branches(&self) -> &Branches<'a, f64> {
        &self.branches
    }

    /// All equilibria at the indentation `d`, by increasing radius.
    pub(super) fn equilibria(&self, d: f64) -> Result<Vec<Equilibrium<f64>>> {
        self.branches.equilibria(&d)
    }

    /// The equilibria at the indentation `d` where their number is known.
    pub(super) fn some<const N: usize>(&self, d: f64) -> Result<[Equilibrium<f64>; N]> {
        let missing = |_| Error::NoEquilibrium { quantity: Quantity::Indentation, value: d.to_string() };
        self.equilibria(d)?.try_into().map_err(missing)
    }

    /// (a, Δl(a)) in the units of the axes.
    pub(super) fn on_elongation(&self, a: f64) -> Point {
        let elongation = (2.0 * std::f64::consts::PI * self.branches.curve().material_length() * a).sqrt();
        [a / self.radius, elongation / self.length]
    }

    /// The curve Δl(a).
    pub(super) fn elongation(&self) -> Layer {
        let at = |sample: &Sample| [sample.contact_radius / self.radius, sample.elongation / self.length];
        let points = [[0.0, 0.0]].into_iter().chain(self.samples.iter().map(at)).collect();
        Layer::Curve { name: "Δ*l*(*a*)".to_owned(), points, stroke: Stroke::Solid }
    }

    /// The points of g(a) − d.
    pub(super) fn shifted(&self, d: f64) -> Vec<Point> {
        let at = |sample: &Sample| [sample.contact_radius / self.radius, (sample.transformed - d) / self.length];
        [[0.0, -d / self.length]].into_iter().chain(self.samples.iter().map(at)).collect()
    }

    /// The curve g(a) − d.
    pub(super) fn transformed(&self, d: f64, name: &str, stroke: Stroke) -> Layer {
        Layer::Curve { name: name.to_owned(), points: self.shifted(d), stroke }
    }

    /// A mark and a label at an equilibrium.
    pub(super) fn state(&self, state: &Equilibrium<f64>, label: &str, side: Side) -> [Layer; 2] {
        let mark = match state.stability {
            Stability::Stable => Mark::Filled,
            Stability::Unstable => Mark::Open,
            Stability::Neutral => Mark::Diamond,
        };
        self.marked(state.contact_radius, label, mark, side)
    }

    /// A mark and a label on Δl at the radius a.
    pub(super) fn marked(&self, a: f64, label: &str, mark: Mark, side: Side) -> [Layer; 2] {
        let at = self.on_elongation(a);
        [
            Layer::Marks { name: label.to_owned(), points: vec![at], mark },
            Layer::Label { text: label.to_owned(), anchors: vec![at], side },
        ]
    }

    /// A guide from Δl down to the axis of radii, with a label at its foot.
    pub(super) fn dropped(&self, a: f64, label: &str, y: &Axis, side: Side) -> [Layer; 2] {
        let [x, top] = self.on_elongation(a);
        [
            Layer::Curve { name: label.to_owned(), points: vec![[x, y.range().0], [x, top]], stroke: Stroke::Guide },
            Layer::Label { text: label.to_owned(), anchors: foot(x, y), side },
        ]
    }

    /// An arrow along the axis of radii: which way a contact of radius `a` goes at the indentation d, by (1.8) and (1.9).
    pub(super) fn direction(&self, a: f64, d: f64, x: &Axis, y: &Axis) -> Result<Layer> {
        let change = self.branches.curve().direction(&a, &d)?;
        let reach = (x.at(0.075) - x.at(0.0)) * if change > 0.0 { -1.0 } else { 1.0 };
        let (from, height) = (a / self.radius, y.at(ARROW_HEIGHT));
        let name = if change > 0.0 { "shrinks (1.8)" } else { "grows (1.9)" };
        let [from, to] = [[from, height], [from + reach, height]];
        Ok(Layer::Arrow { name: name.to_owned(), from, to, stroke: Stroke::Thin })
    }
}

/// How far above the axis of radii its arrows are, as a share of the vertical axis.
pub(super) const ARROW_HEIGHT: f64 = 0.055;

/// Anchors beside the foot of a guide.
fn foot(x: f64, y: &Axis) -> Vec<Point> {
    [0.06, 0.09, 0.12, 0.15].map(|height| [x, y.at(height)]).to_vec()
}

/// Anchors along a curve as far as it is seen, from its right end on.
pub(super) fn ending(points: &[Point], x: &Axis, y: &Axis) -> Vec<Point> {
    let seen = |[a, b]: &Point| (0.03..0.98).contains(&x.fraction(*a)) && (0.03..0.97).contains(&y.fraction(*b));
    let mut anchors: Vec<Point> = Vec::new();
    for point in points.iter().rev().filter(|point| seen(point)) {
        let apart = |last: &Point| {
            (x.fraction(point[0]) - x.fraction(last[0])).hypot(y.fraction(point[1]) - y.fraction(last[1])) > 0.015
        };
        if anchors.last().is_none_or(apart) {
            anchors.push(*point);
        }
    }
    anchors
}

/// A panel with the usual axes, still empty.
pub(super) fn panel(heading: &str, x: Axis, y: Axis) -> Panel {
    Panel { heading: heading.to_owned(), x, y, layers: Vec::new(), legend: Vec::new(), aspect: 0.62 }
}

/// Axes in units of the critical state of a power law.
pub(super) fn critical_units(upper: f64, heights: (f64, f64)) -> (Axis, Axis) {
    (
        Axis::linear("contact radius *a* / *a*_{c}", Unit::One, 0.0, upper),
        Axis::linear("length / |*d*_{c}|", Unit::One, heights.0, heights.1),
    )
}

/// What marks and arrows mean.
pub(super) const STABLE: (Key, &str) = (Key::Mark(Mark::Filled), "stable");
pub(super) const UNSTABLE: (Key, &str) = (Key::Mark(Mark::Open), "unstable");
pub(super) const CRITICAL: (Key, &str) = (Key::Mark(Mark::Diamond), "critical");
pub(super) const DIRECTION: (Key, &str) = (Key::Arrow, "direction of change");

/// The panel with its contents.
pub(super) fn with(panel: Panel, layers: Vec<Layer>, legend: &[(Key, &str)]) -> Panel {
    let legend = legend.iter().map(|(key, text)| (*key, (*text).to_owned())).collect();
    Panel { layers, legend, ..panel }
}
