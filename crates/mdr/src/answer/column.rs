//! Columns of a table: the key of a cell with its heading and unit.

use mdr_core::contact::ControlKind;

use super::{Answer, Output};
use crate::Validity;

/// A column of a table: the key of its cells, its heading for a reader and its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    key: &'static str,
    title: &'static str,
    unit: Unit,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    /// By its symbol, empty for a pure number or a word.
    Symbol(&'static str),
    /// The unit of the controlled quantity.
    Controlled,
}

impl Column {
    /// A column without a unit, with its key as its heading.
    pub(crate) fn new(key: &'static str) -> Self {
        Column { key, title: key, unit: Unit::Symbol("") }
    }

    pub(crate) fn titled(self, title: &'static str, unit: &'static str) -> Self {
        Column { title, unit: Unit::Symbol(unit), ..self }
    }

    /// The column with the values of the controlled quantity.
    pub(crate) fn controlled(key: &'static str) -> Self {
        Column { key, title: key, unit: Unit::Controlled }
    }

    /// The heading and the unit under `control`; the unit is empty for a pure number or a word.
    fn heading(self, control: Option<ControlKind>) -> (&'static str, &'static str) {
        let unit = match (self.unit, control) {
            (Unit::Symbol(unit), _) => unit,
            (Unit::Controlled, Some(ControlKind::Force)) => "N",
            (Unit::Controlled, Some(_)) => "m",
            (Unit::Controlled, None) => "",
        };
        (self.title, unit)
    }
}

/// The heading and the unit of the column below a key; the key itself, without a unit, for other columns.
fn heading<'k>(columns: &[Column], key: &'k str, control: Option<ControlKind>) -> (&'k str, &'static str) {
    columns.iter().find(|column| column.key == key).map_or((key, ""), |column| column.heading(control))
}

impl Output {
    /// The heading of a column of its [table](Output::table) and its unit in an answer under `control`; the unit is empty for a
    /// pure number or a word.
    ///
    /// ```
    /// use mdr::prelude::*;
    /// let tip = Shape::Paraboloid { radius: "0.01" };
    /// let scene = Scene::new(tip, Elasticity::effective("1e6")?, "0.05")?
    ///     .control(Control::Force)
    ///     .want(Want::Equilibria { at: vec!["-1e-3".parse().unwrap()] })
    ///     .arithmetic(Arithmetic::F64);
    /// let answer = scene.solve()?;
    /// assert_eq!(answer.outputs[0].title("contact_radius", answer.control), ("contact radius", "m"));
    /// assert_eq!(answer.outputs[0].title("value", answer.control), ("value", "N"));
    /// # Ok::<(), mdr::Error>(())
    /// ```
    pub fn title<'k>(&self, key: &'k str, control: Option<ControlKind>) -> (&'k str, &'static str) {
        heading(&self.columns(), key, control)
    }
}

impl Answer {
    /// The heading of a column of one of its outputs and its unit, with forces in the unit of the answer: in line contact
    /// they are per length and on a periodic medium per area, and so are energies and stiffnesses.
    pub fn title<'k>(&self, output: &Output, key: &'k str) -> (&'k str, &'static str) {
        let (title, unit) = output.title(key, self.control);
        (title, self.unit(unit))
    }

    /// The unit of a column in this answer.
    fn unit(&self, unit: &'static str) -> &'static str {
        match (self.force_unit, unit) {
            ("N", unit) => unit,
            (force, "N") => force,
            ("N/m", "J") => "J/m",
            ("N/m", "N/m") => "Pa",
            ("Pa", "J") => "J/m²",
            ("Pa", "N/m") => "Pa/m",
            (_, unit) => unit,
        }
    }

    /// What belongs below the table of one of its outputs, a paragraph each; see [`Output::remarks`]. Sums of energies, which are
    /// said there in joules, are left out where they are per length or per area.
    pub fn remarks(&self, output: &Output, style: &super::NumberStyle) -> Vec<String> {
        let mut remarks = output.remarks(style);
        if self.force_unit != "N" {
            let sentences = output.sentences(style);
            remarks.retain(|remark| !sentences.contains(remark));
        }
        remarks
    }
}

impl Validity {
    /// The heading of a column of its [table](Validity::table) and its unit; the unit is empty for a pure number or a word.
    pub fn title(key: &str) -> (&str, &'static str) {
        heading(&<Validity as super::record::Numbers<super::Number>>::columns(), key, None)
    }
}
