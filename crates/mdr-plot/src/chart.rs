//! Pictures as plain data in physical units: a picture has panels, a panel two axes and layers.

use crate::Axis;

/// A point of a chart, in the units of its two axes.
pub type Point = [f64; 2];

/// Panels side by side, three in a row, else two, with the caption of all.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The `<title>` of the SVG.
    pub title: String,
    /// The `<desc>` of the SVG: the caption, which describes the picture in words and numbers.
    pub description: String,
    /// In the order of reading.
    pub panels: Vec<Panel>,
}

/// The colours of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light or dark as the reader's system is, light in print.
    #[default]
    Auto,
    /// For a light page.
    Light,
    /// For a dark page.
    Dark,
    /// Black and grey on white.
    Paper,
}

/// One chart.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Above the frame, e.g. "(a)  *d* = 0"; with [markup](crate#markup).
    pub heading: String,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// In the order of drawing; marks lie over all lines, labels over all marks.
    pub layers: Vec<Layer>,
}

/// Something that is drawn in a panel.
#[derive(Clone, Debug)]
pub struct Layer {
    /// The series in the data; the text of a label. With [markup](crate#markup).
    pub name: String,
    /// Corners, points of a curve, marked points, tail and tip of an arrow, places of a label by preference.
    pub points: Vec<Point>,
    /// How the points are drawn.
    pub look: Look,
    /// The colour of lines, marks and labels.
    pub colour: Colour,
    /// What the layer shows, written once beside it, or beside one of the layers with the same text. With
    /// [markup](crate#markup).
    pub meaning: Option<String>,
    /// The size of marks: 1 for the usual one.
    pub scale: f64,
}

/// How the points of a layer are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// A shaded area.
    Area,
    /// A polyline, cut at the frame.
    Curve(Stroke),
    /// A mark at each point within the frame.
    Marks(Mark),
    /// A thin polyline with a tip at its last point.
    Arrow,
    /// The name beside the first point where it covers no mark and no other label.
    Label(Side),
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// Unbroken.
    Solid,
    /// Long dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// Dashes and dots in turn.
    DashDotted,
    /// Unbroken, thinner than data: a reference.
    Thin,
    /// Thin and dotted: drops a value to an axis. No data.
    Guide,
}

/// A mark at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A disc: a stable state.
    Filled,
    /// A ring: an unstable state.
    Open,
    /// A diamond: a critical state.
    Diamond,
    /// A cross, for failures.
    Cross,
}

/// Where a label stands, seen from its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Above it.
    Above,
    /// Below it.
    Below,
    /// To its left.
    Left,
    /// To its right.
    Right,
}

/// A colour of the palette, which readers with any colour vision can distinguish, on white and on black.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Nearly black; nearly white in the dark.
    Ink,
    /// Adhesion.
    Blue,
    /// Elasticity; failures.
    Orange,
    /// Jumps and the energy that they lose.
    Purple,
    /// Right answers.
    Green,
    /// Series for comparison.
    Grey,
    /// One more series.
    Sky,
    /// One more series.
    Amber,
}

impl Stroke {
    /// In the data, and without its hyphen in the style sheet.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Stroke::Solid => "solid",
            Stroke::Dashed => "dashed",
            Stroke::Dotted => "dotted",
            Stroke::DashDotted => "dash-dotted",
            Stroke::Thin => "thin",
            Stroke::Guide => "guide",
        }
    }
}

impl Mark {
    /// In the data.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Mark::Filled => "filled",
            Mark::Open => "open",
            Mark::Diamond => "diamond",
            Mark::Cross => "cross",
        }
    }
}

impl Colour {
    /// The colour of a series by its number, from 0; after eight they begin again.
    pub fn series(index: usize) -> Self {
        use Colour::{Amber, Blue, Green, Grey, Ink, Orange, Purple, Sky};
        [Blue, Orange, Green, Purple, Sky, Amber, Ink, Grey][index % 8]
    }
}

impl Picture {
    /// The letters of the panels, a, b, …: of a heading that begins with one in parentheses, else by the order.
    fn letters(&self) -> impl Iterator<Item = (char, &Panel)> {
        self.panels.iter().zip('a'..).map(|(panel, by_order)| {
            let mut heading = panel.heading.chars();
            let letter = match (heading.next(), heading.next(), heading.next()) {
                (Some('('), Some(letter), Some(')')) => letter,
                _ => by_order,
            };
            (letter, panel)
        })
    }

    /// The picture with some of its panels, named by their letters, in this order.
    ///
    /// # Errors
    /// The letters of all panels, where one of `letters` is not among them, or there is none.
    ///
    /// ```
    /// use mdr_plot::{Axis, Panel, Picture, Unit};
    /// let panel = |heading: &str| Panel::new(heading, Axis::linear("x", Unit::One, 0.0, 1.0), Axis::linear("y", Unit::One, 0.0, 1.0));
    /// let picture = Picture { title: "two".into(), description: String::new(), panels: vec![panel("(a)  one"), panel("(b)  two")] };
    /// assert_eq!(picture.only(['b']).unwrap().panels[0].heading, "(b)  two");
    /// assert_eq!(picture.only(['z']).unwrap_err(), ['a', 'b']);
    /// ```
    pub fn only(&self, letters: impl IntoIterator<Item = char>) -> Result<Picture, Vec<char>> {
        let panel = |wanted: char| self.letters().find(|(letter, _)| *letter == wanted).map(|(_, panel)| panel.clone());
        match letters.into_iter().map(panel).collect::<Option<Vec<Panel>>>() {
            Some(panels) if !panels.is_empty() => Ok(Picture { panels, ..self.clone() }),
            _ => Err(self.letters().map(|(letter, _)| letter).collect()),
        }
    }
}

impl Panel {
    /// A panel without layers.
    pub fn new(heading: impl Into<String>, x: Axis, y: Axis) -> Self {
        Panel { heading: heading.into(), x, y, layers: Vec::new() }
    }

    /// Adds a series: a line with a mark at each point, and its name beside it.
    pub fn series(&mut self, name: &str, points: Vec<Point>, mark: Mark, colour: Colour) {
        self.layers.push(Layer::curve(name, points.clone(), Stroke::Solid).coloured(colour).meaning(name));
        self.layers.push(Layer::marks(name, points, mark).coloured(colour).meaning(name));
    }

    /// Adds a text below the heading.
    pub fn note(&mut self, text: impl Into<String>) {
        self.layers.push(Layer::label("", Vec::new(), Side::Right).meaning(text));
    }
}

impl Layer {
    fn new(name: impl Into<String>, points: Vec<Point>, look: Look) -> Self {
        Layer { name: name.into(), points, look, colour: Colour::Ink, meaning: None, scale: 1.0 }
    }

    /// A shaded area.
    pub fn area(name: impl Into<String>, outline: Vec<Point>) -> Self {
        Self::new(name, outline, Look::Area)
    }

    /// A curve.
    pub fn curve(name: impl Into<String>, points: Vec<Point>, stroke: Stroke) -> Self {
        Self::new(name, points, Look::Curve(stroke))
    }

    /// Marked points.
    pub fn marks(name: impl Into<String>, points: Vec<Point>, mark: Mark) -> Self {
        Self::new(name, points, Look::Marks(mark))
    }

    /// An arrow through some points, with its tip at the last.
    pub fn arrow(name: impl Into<String>, points: impl Into<Vec<Point>>) -> Self {
        Self::new(name, points.into(), Look::Arrow)
    }

    /// A text beside one of its anchors, the first if there is room.
    pub fn label(text: impl Into<String>, anchors: Vec<Point>, side: Side) -> Self {
        Self::new(text, anchors, Look::Label(side))
    }

    /// Sets the size of marks, in that of usual ones.
    #[must_use]
    pub fn sized(self, scale: f64) -> Self {
        Layer { scale, ..self }
    }

    /// Sets the colour; the default is black.
    #[must_use]
    pub fn coloured(self, colour: Colour) -> Self {
        Layer { colour, ..self }
    }

    /// Says beside the layer what it shows.
    #[must_use]
    pub fn meaning(self, text: impl Into<String>) -> Self {
        Layer { meaning: Some(text.into()), ..self }
    }
}
