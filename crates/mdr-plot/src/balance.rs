//! The diagram {Δl, g − d} of equation (1.7), which scenes and figures have in common.

use std::borrow::Cow;

use mdr::diagram::{CurveSample, Diagram, Equilibrium};
use mdr::prelude::Stability;

use crate::chart::{Colour, Layer, Mark, Point, Stroke};

/// The colours of the two sides of the balance, and of jumps.
pub(crate) const ADHESION: Colour = Colour::Blue;
pub(crate) const ELASTICITY: Colour = Colour::Orange;
pub(crate) const LOSS: Colour = Colour::Purple;

/// A contact whose balance is drawn, with the units of radii and of lengths in m.
pub(crate) struct Balance<'a> {
    pub(crate) diagram: Cow<'a, Diagram>,
    pub(crate) units: [f64; 2],
}

impl Balance<'_> {
    /// (a, Δl(a)) in the units of the axes.
    pub(crate) fn on_elongation(&self, a: f64) -> Point {
        [a / self.units[0], self.diagram.elongation_at(a) / self.units[1]]
    }

    /// The curve Δl(a).
    pub(crate) fn elongation(&self) -> Layer {
        let [radius, length] = self.units;
        let point = |sample: &CurveSample| [sample.contact_radius / radius, sample.elongation / length];
        Layer::curve("Δ*l*(*a*)", self.diagram.samples().map(point).collect(), Stroke::Solid).coloured(ADHESION)
    }

    /// States on Δl(a), all of one stability.
    pub(crate) fn states<'s>(
        &self,
        name: impl Into<String>,
        states: impl IntoIterator<Item = &'s Equilibrium<f64>>,
        stability: Stability,
    ) -> Layer {
        let meaning = match stability {
            Stability::Stable => "stable",
            Stability::Unstable => "unstable",
            Stability::Neutral => "fold",
        };
        let points = states.into_iter().map(|state| self.on_elongation(state.contact_radius)).collect();
        Layer::marks(name, points, mark(stability)).meaning(meaning)
    }
}

/// The mark of a state.
pub(crate) fn mark(stability: Stability) -> Mark {
    match stability {
        Stability::Stable => Mark::Filled,
        Stability::Unstable => Mark::Open,
        Stability::Neutral => Mark::Diamond,
    }
}

/// A curve g(a) − d.
pub(crate) fn shifted(name: impl Into<String>, points: Vec<Point>, stroke: Stroke) -> Layer {
    Layer::curve(name, points, stroke).coloured(ELASTICITY)
}

/// An arrow along the axis of radii: where g − d is above Δl the contact shrinks, else it grows.
pub(crate) fn change(grows: bool, from: Point, to: Point) -> Layer {
    let [name, meaning] = if grows { ["grows (1.9)", "grows"] } else { ["shrinks (1.8)", "shrinks"] };
    Layer::arrow(name, [from, to]).meaning(meaning)
}
