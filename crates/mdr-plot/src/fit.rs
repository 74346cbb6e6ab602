//! The picture of a fit: data with their labels and the fitted arcs, residuals, contact radius.

use mdr_fit::{Fit, FittedRow, Leg, Observation};

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

/// A panel of the rows, one layer of marks for each label.
fn panel(fit: &Fit, heading: &str, y: Axis, height: impl Fn(&FittedRow) -> Option<f64>) -> Panel {
    let x = Axis::around(names(fit.observation)[0], Unit::Si(fit.units[0]), fit.rows.iter().map(|row| row.x));
    let mut panel = Panel::new(heading, x, y);
    let mut labels: Vec<i32> = fit.rows.iter().map(|row| row.label).collect();
    labels.sort_unstable();
    labels.dedup();
    let has_both = fit.legs.len() > 1;
    for label in labels {
        let (name, mark, colour) = match label {
            ..0 => ("detached".to_owned(), Mark::Cross, Colour::Grey),
            0 => ("in contact".to_owned(), Mark::Open, Colour::series(0)),
            arc => (format!("in contact, arc {arc}"), Mark::Open, Colour::series(arc as usize)),
        };
        let legs: &[Option<Leg>] =
            if has_both && label >= 0 { &[Some(Leg::Retract), Some(Leg::Approach)] } else { &[None] };
        for leg in legs {
            // The approach has colours of its own, after those of the arcs.
            let (name, colour) = match leg {
                Some(Leg::Approach) => (format!("{name}, approach"), Colour::series(APPROACH + label as usize)),
                _ => (name.clone(), colour),
            };
            let rows = fit.rows.iter().filter(|row| row.label == label && leg.is_none_or(|leg| row.leg == leg));
            let points: Vec<Point> = rows.filter_map(|row| Some([row.x, height(row)?])).collect();
            if !points.is_empty() {
                panel.layers.push(Layer::marks(name.clone(), points, mark).coloured(colour).meaning(name));
            }
        }
    }
    panel
}

/// The colour of the first arc of an approach.
const APPROACH: usize = 4;

fn curve(fit: &Fit) -> Panel {
    let [_, quantity] = names(fit.observation);
    let y = Axis::around(quantity, Unit::Si(fit.units[1]), fit.rows.iter().map(|row| row.y));
    let mut panel = panel(fit, "(a)  Data and fitted curve", y, |row| Some(row.y));
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
    let y = Axis::around("residual in units of σ", Unit::One, fit.rows.iter().map(|row| row.residual));
    let mut panel = panel(fit, "(b)  Residuals, curve minus datum", y, |row| Some(row.residual));
    let (first, last) = panel.x.range();
    panel.layers.push(Layer::curve("zero", vec![[first, 0.0], [last, 0.0]], Stroke::Thin));
    panel
}

fn radii(fit: &Fit) -> Panel {
    let of_rows = fit.rows.iter().filter_map(|row| row.contact_radius);
    let y = Axis::around("contact radius *a*", Unit::Si("m"), of_rows.chain([0.0]));
    panel(fit, "(c)  Contact radius", y, |row| row.contact_radius)
}
