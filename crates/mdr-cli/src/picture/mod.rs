//! Diagrams for print: what is to be seen as plain data in physical units, and its drawing as SVG by `plotters`.
//!
//! A [`Picture`] is a column of [`Panel`]s, a panel two [`Axis`] and [`Layer`]s. Everything is told apart by dashes, marks
//! and labels, never by colour. Labels look for a place where they cover nothing. The drawing is a pure function of the
//! data: the same bytes on every run.

pub(crate) mod axis;
mod canvas;
pub(crate) mod file;
mod frame;
mod geometry;
mod legend;
mod placement;
mod render;
pub(crate) mod scene;
mod series;
mod typeset;

pub(crate) use axis::{Axis, Unit};
#[cfg(test)]
pub(crate) use render::crowded;
pub(crate) use render::svg;
pub(crate) use series::write_csv;

/// A point of a diagram, in the units of its two axes.
pub(crate) type Point = [f64; 2];

/// A drawing, one panel below the other.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    /// Its `<title>`.
    pub(crate) title: String,
    /// Its `<desc>`: the caption, with what is seen in words and numbers.
    pub(crate) description: String,
    /// From top to bottom.
    pub(crate) panels: Vec<Panel>,
}

/// One diagram.
#[derive(Clone, Debug)]
pub(crate) struct Panel {
    /// Above the frame, e.g. "(a) d = 0".
    pub(crate) heading: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    /// In the order of drawing.
    pub(crate) layers: Vec<Layer>,
    /// What the strokes and marks mean, where no label on the curve tells.
    pub(crate) legend: Vec<(Key, String)>,
    /// Height of the frame over its width.
    pub(crate) aspect: f64,
}

/// Something to be seen in a diagram. Texts may hold the markup of [`typeset`].
#[derive(Clone, Debug)]
pub(crate) enum Layer {
    /// A shaded area.
    Area { name: String, outline: Vec<Point> },
    /// A curve; it is cut where it leaves the axes.
    Curve { name: String, points: Vec<Point>, stroke: Stroke },
    /// States set off on a curve.
    Marks { name: String, points: Vec<Point>, mark: Mark },
    /// An arrow.
    Arrow { name: String, from: Point, to: Point, stroke: Stroke },
    /// A text beside the first of its anchors where it covers nothing; a long way off all of them it is drawn beside the
    /// best.
    Label { text: String, anchors: Vec<Point>, side: Side },
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stroke {
    Solid,
    Dashed,
    Dotted,
    DashDotted,
    /// Thinner than data: an arrow, a reference.
    Thin,
    /// Thin and dotted: drops a value to an axis.
    Guide,
}

/// How a state is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// Stable.
    Filled,
    /// Unstable.
    Open,
    /// Neither: the critical state itself.
    Diamond,
}

/// Where a label would like to be, seen from its anchor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Above,
    Below,
    Left,
    Right,
}

/// The sample of a legend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Key {
    Line(Stroke),
    Mark(Mark),
    Arrow,
    Area,
    /// No sample.
    Text,
}
