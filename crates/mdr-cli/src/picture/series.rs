//! The data of a picture as a table: what is drawn, in base units, before it is scaled, cut and thinned out.

use super::{Layer, Mark, Panel, Picture, Point, Stroke, typeset};
use crate::error::{Failure, Result};

pub(super) const HEADER: [&str; 9] =
    ["panel", "element", "series", "style", "x_quantity", "x", "y_quantity", "y", "units"];

/// The points of all curves, areas, marks and arrows, one a row.
///
/// # Errors
/// When `out` cannot be written.
pub(crate) fn write_csv(picture: &Picture, name: &str, out: impl std::io::Write) -> Result<()> {
    let mut csv = csv::Writer::from_writer(out);
    let failed = |error: csv::Error| Failure::file(name, std::io::Error::from(error));
    csv.write_record(HEADER).map_err(failed)?;
    for (index, panel) in picture.panels.iter().enumerate() {
        for row in rows(index + 1, panel) {
            csv.write_record(row).map_err(failed)?;
        }
    }
    csv.flush().map_err(|error| Failure::file(name, error))
}

fn rows(number: usize, panel: &Panel) -> impl Iterator<Item = [String; 9]> {
    let ((x_name, x_unit), (y_name, y_unit)) = (panel.x.column(), panel.y.column());
    let units = format!("{x_unit}; {y_unit}");
    panel.layers.iter().filter_map(data).flat_map(move |(element, series, style, points)| {
        let (x_name, y_name, units) = (x_name.clone(), y_name.clone(), units.clone());
        points.into_iter().map(move |[x, y]| {
            [
                number.to_string(),
                element.to_owned(),
                typeset::plain(series),
                style.to_owned(),
                x_name.clone(),
                number_text(x),
                y_name.clone(),
                number_text(y),
                units.clone(),
            ]
        })
    })
}

/// Element, series, style and points of a layer; labels are no data.
fn data(layer: &Layer) -> Option<(&'static str, &str, &'static str, Vec<Point>)> {
    Some(match layer {
        Layer::Curve { stroke: Stroke::Guide, .. } | Layer::Label { .. } => return None,
        Layer::Area { name, outline } => ("area", name, "shaded", outline.clone()),
        Layer::Curve { name, points, stroke } => ("curve", name, stroke_name(*stroke), points.clone()),
        Layer::Marks { name, points, mark } => ("mark", name, mark_name(*mark), points.clone()),
        Layer::Arrow { name, from, to, stroke } => ("arrow", name, stroke_name(*stroke), vec![*from, *to]),
    })
}

fn stroke_name(stroke: Stroke) -> &'static str {
    match stroke {
        Stroke::Solid => "solid",
        Stroke::Dashed => "dashed",
        Stroke::Dotted => "dotted",
        Stroke::DashDotted => "dash-dotted",
        Stroke::Thin => "thin",
        Stroke::Guide => "guide",
    }
}

fn mark_name(mark: Mark) -> &'static str {
    match mark {
        Mark::Filled => "filled",
        Mark::Open => "open",
        Mark::Diamond => "diamond",
    }
}

/// Ten significant digits: more than a drawing shows, fewer than could differ between two machines' elementary functions.
fn number_text(value: f64) -> String {
    format!("{value:.9e}")
}
