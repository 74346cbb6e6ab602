//! The picture of a fit: data with their labels and the fitted arcs, residuals, contact radius.

use mdr::fit::{Fit, FittedRow, Observation};

use crate::chart::{Colour, Layer, Mark, Panel, Picture, Point, Stroke};
use crate::{Axis, Unit, typographic};

/// The picture of a fit: (a) data and the fitted curve, (b) residuals in units of σ, (c) contact radius of the rows in contact.
///
/// Rows in contact are rings in the colour of their arc, detached rows are grey crosses.
pub fn fit(title: &str, fit: &Fit) -> Picture {
    Picture { title: title.to_owned(), description: caption(fit), panels: vec![curve(fit), residuals(fit), radii(fit)] }
}

fn caption(fit: &Fit) -> String {
    let estimates = fit.parameters.iter().map(|estimate| match (estimate.value, estimate.stderr) {
        (Some(value), Some(stderr)) => format!("{} = {value:.4e} ± {stderr:.1e} {}", estimate.name, estimate.unit),
        (Some(value), None) => format!("{} = {value:.4e} {} at its bound", estimate.name, estimate.unit),
        _ => format!("{} is not determined", estimate.name),
    });
    typographic(&format!(
        "{} rows, {}: {}.",
        fit.rows.len(),
        fit.status.name(),
        estimates.collect::<Vec<_>>().join(", ")
    ))
}

fn names(observation: Observation) -> [&'static str; 2] {
    match observation {
        Observation::ForceOfIndentation => ["indentation depth *d*", "force *F*"],
        Observation::ForceOfPosition => ["position *D*", "force *F*"],
        Observation::DeflectionOfPosition => ["position *D*", "deflection *F*/*k*"],
        Observation::IndentationOfForce => ["force *F*", "indentation depth *d*"],
        Observation::ForceOfRadius => ["contact radius *a*", "force *F*"],
        Observation::RadiusOfForce => ["force *F*", "contact radius *a*"],
    }
}

fn axis(fit: &Fit, index: usize, values: impl Iterator<Item = f64>) -> Axis {
    Axis::around(names(fit.observation)[index], Unit::Si(fit.observation.units()[index]), values)
}

/// Rows by their label, one layer of marks for each.
fn marks(fit: &Fit, point: impl Fn(&FittedRow) -> Option<Point>) -> Vec<Layer> {
    let mut labels: Vec<i32> = fit.rows.iter().map(|row| row.label).collect();
    labels.sort_unstable();
    labels.dedup();
    let layer = |label: i32| {
        let points = fit.rows.iter().filter(|row| row.label == label).filter_map(&point).collect();
        if label < 0 {
            return Layer::marks("detached", points, Mark::Cross).coloured(Colour::Grey).meaning("detached");
        }
        let name = if label == 0 { "in contact".to_owned() } else { format!("in contact, arc {label}") };
        let colour = Colour::series(label as usize);
        Layer::marks(name.clone(), points, Mark::Open).coloured(colour).meaning(name)
    };
    labels.into_iter().map(layer).filter(|layer| !layer.points.is_empty()).collect()
}

fn curve(fit: &Fit) -> Panel {
    let x = axis(fit, 0, fit.rows.iter().map(|row| row.x));
    let y = axis(fit, 1, fit.rows.iter().map(|row| row.y));
    let mut panel = Panel::new("(a)  Data and fitted curve", x, y);
    panel.layers = marks(fit, |row| Some([row.x, row.y]));
    for arc in &fit.arcs {
        let points = arc.iter().map(|[x, y, _]| [*x, *y]).collect();
        panel.layers.push(Layer::curve("fit", points, Stroke::Solid).meaning("fit"));
    }
    if let Some(pull_off) = &fit.predicted_pull_off {
        let mark = Layer::marks("predicted pull-off", vec![[pull_off.x, pull_off.y]], Mark::Diamond);
        panel.layers.push(mark.coloured(Colour::Purple).meaning("predicted pull-off"));
    }
    panel
}

fn residuals(fit: &Fit) -> Panel {
    let x = axis(fit, 0, fit.rows.iter().map(|row| row.x));
    let y = Axis::around("residual in units of σ", Unit::One, fit.rows.iter().map(|row| row.residual));
    let (first, last) = x.range();
    let mut panel = Panel::new("(b)  Residuals, curve minus datum", x, y);
    panel.layers = marks(fit, |row| Some([row.x, row.residual]));
    panel.layers.push(Layer::curve("zero", vec![[first, 0.0], [last, 0.0]], Stroke::Thin));
    panel
}

fn radii(fit: &Fit) -> Panel {
    let x = axis(fit, 0, fit.rows.iter().map(|row| row.x));
    let of_rows = fit.rows.iter().filter_map(|row| row.contact_radius);
    let y = Axis::around("contact radius *a*", Unit::Si("m"), of_rows.chain([0.0]));
    let mut panel = Panel::new("(c)  Contact radius", x, y);
    panel.layers = marks(fit, |row| Some([row.x, row.contact_radius?]));
    panel
}
