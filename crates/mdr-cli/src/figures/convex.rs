//! Figures 1 and 2: a convex profile, for which the paraboloid stands.

use mdr_analytic::{Contact, PowerLaw};
use mdr_core::contact::{Control, Material, Result, Stability};

use super::diagram::{CRITICAL, DIRECTION, STABLE, UNSTABLE};
use super::diagram::{Study, critical_units, ending, panel, with};
use crate::picture::{Axis, Key, Layer, Mark, Picture, Side, Stroke};

/// A paraboloid, R = 1, E* = w = 1. In units of its critical state the diagram is that of every paraboloid.
fn paraboloid() -> Result<Contact<f64>> {
    Ok(Contact::new(PowerLaw::paraboloid(1.0)?, Material::new(1.0, 1.0)?))
}

/// Runs `draw` on the study of the paraboloid with its critical indentation.
fn study<T>(upper: f64, draw: impl FnOnce(&Study<'_>, f64) -> Result<T>) -> Result<T> {
    let contact = paraboloid()?;
    let critical = contact.critical(&Control::Indentation)?;
    let units = (critical.contact_radius, critical.indentation.abs());
    draw(&Study::new(contact.profile(), contact.material(), units, upper)?, critical.indentation)
}

/// Figure 1: (a) without indentation; (b) at several indentations, and the last equilibrium.
pub(super) fn figure_1a() -> Result<Picture> {
    study(4.0, |study, critical| {
        let (x, y) = critical_units(4.0, (0.0, 4.4));
        let [rest] = &study.some(0.0)?;
        let radius = rest.contact_radius;
        let mut layers = vec![study.elongation(), study.transformed(0.0, "*g*(*a*)", Stroke::Dashed)];
        layers.extend(study.state(rest, "*O*", Side::Above));
        for (a, label, side) in [(0.5 * radius, "*a*_{1}", Side::Left), (1.3 * radius, "*a*_{2}", Side::Right)] {
            layers.extend(up_to_both(study, a, label, &y, side));
            layers.push(study.direction(a, 0.0, &x, &y)?);
        }
        layers.extend(study.dropped(radius, "*a*_{O}", &y, Side::Right));
        layers.extend(names(study, 0.0, "*g*(*a*)", &x, &y));
        let unit = study.folds()[0].contact_radius;
        Ok(Picture {
            title: "Figure 1a: equilibrium without indentation".to_owned(),
            description: format!(
                "The diagram {{Δl(a), g(a) − d}} of a paraboloid at d = 0. A contact of radius a_1, where Δl > g, grows \
                 (1.9); one of radius a_2, where Δl < g, shrinks (1.8); arrows show the computed direction of change. \
                 O is a stable equilibrium, at a_O/a_c = {:.6} (exactly 4^(2/3)). Lengths in units of the critical \
                 state a_c = {unit:.6}, |d_c| = {:.6} for R = 1, E* = w = 1.",
                radius / unit,
                critical.abs()
            ),
            panels: vec![with(panel("(a)  *d* = 0", x, y), layers, &[STABLE, DIRECTION])],
        })
    })
}

/// Figure 1b: indentation moves the curve of g; the last equilibrium P.
pub(super) fn figure_1b() -> Result<Picture> {
    study(4.0, |study, critical| {
        let (x, y) = critical_units(4.0, (-1.4, 4.4));
        let mut layers = vec![study.elongation()];
        let depths = [
            (-critical, "*d* > 0", Stroke::Dotted),
            (0.0, "*d* = 0", Stroke::Dashed),
            (0.6 * critical, "*d*_{c} < *d* < 0", Stroke::DashDotted),
            (critical, "*d* = *d*_{c}", Stroke::Thin),
        ];
        let mut radii = Vec::new();
        let mut legend = Vec::new();
        for (d, name, stroke) in depths {
            layers.push(study.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke));
            legend.push((Key::Line(stroke), name));
            for state in study.equilibria(d)?.iter().filter(|state| state.stability == Stability::Stable) {
                layers.extend(study.state(state, "", Side::Below).into_iter().take(1));
                radii.push(state.contact_radius);
            }
        }
        legend.extend([STABLE, CRITICAL]);
        let fold = &study.folds()[0];
        layers.extend(study.marked(fold.contact_radius, "*P*", Mark::Diamond, Side::Below));
        layers.push(elongation_name(study, &x, &y));
        let share = |radius: f64| radius / fold.contact_radius;
        Ok(Picture {
            title: "Figure 1b: equilibria at several indentations".to_owned(),
            description: format!(
                "The diagram {{Δl(a), g(a) − d}} of a paraboloid. Pressing (d > 0) moves the curve of g down and the \
                 stable equilibrium to a larger radius, pulling moves it up. The last equilibrium P, where the curves \
                 touch (1.10), is at a = a_c, d = d_c. Stable radii: {}.",
                radii.iter().map(|radius| format!("{:.5} a_c", share(*radius))).collect::<Vec<_>>().join(", "),
            ),
            panels: vec![with(panel("(b)  *g*(*a*) − *d*, pressed in and pulled out", x, y), layers, &legend)],
        })
    })
}

/// Figure 2: two equilibria, and the direction of change everywhere else.
pub(super) fn figure_2() -> Result<Picture> {
    study(2.6, |study, critical| {
        let d = 0.8 * critical;
        let (x, y) = critical_units(2.6, (0.0, 3.0));
        let [lower, upper] = &study.some(d)?;
        let (first, second) = (lower.contact_radius, upper.contact_radius);
        let mut layers = vec![study.elongation(), study.transformed(d, "*g*(*a*) − *d*", Stroke::Dashed)];
        layers.extend(study.state(lower, "*P*_{1}", Side::Above));
        layers.extend(study.state(upper, "*P*_{2}", Side::Below));
        layers.extend(study.dropped(first, "*a*_{eq,1}", &y, Side::Right));
        layers.extend(study.dropped(second, "*a*_{eq,2}", &y, Side::Right));
        for a in [0.85 * first, 0.62 * second, 1.36 * second] {
            layers.push(study.direction(a, d, &x, &y)?);
        }
        layers.extend(names(study, d, "*g*(*a*) − *d*", &x, &y));
        let unit = study.folds()[0].contact_radius;
        Ok(Picture {
            title: "Figure 2: a stable and an unstable equilibrium".to_owned(),
            description: format!(
                "The diagram {{Δl(a), g(a) − d}} of a paraboloid at d = 0.8 d_c. P_1, at a_eq,1 = {:.6} a_c, is \
                 unstable, P_2, at a_eq,2 = {:.6} a_c, is stable: arrows show the computed direction of change, shrinking \
                 outside (1.8) and growing between (1.9).",
                first / unit,
                second / unit
            ),
            panels: vec![with(panel("*d* = 0.8 *d*_{c}", x, y), layers, &[STABLE, UNSTABLE, DIRECTION])],
        })
    })
}

/// A guide from the axis of radii to the upper of the two curves, with a label at its foot.
fn up_to_both(study: &Study<'_>, a: f64, label: &str, y: &Axis, side: Side) -> [Layer; 2] {
    let [mut guide, text] = study.dropped(a, label, y, side);
    if let Layer::Curve { points, .. } = &mut guide {
        let [x, _] = points[1];
        let on_g = study.shifted(0.0).into_iter().find(|point| point[0] >= x).map_or(0.0, |point| point[1]);
        points[1][1] = points[1][1].max(on_g);
    }
    [guide, text]
}

/// The names of the two curves.
fn names(study: &Study<'_>, d: f64, name: &str, x: &Axis, y: &Axis) -> [Layer; 2] {
    let anchors = ending(&study.shifted(d), x, y);
    [Layer::Label { text: name.to_owned(), anchors, side: Side::Left }, elongation_name(study, x, y)]
}

/// The name of Δl at its end.
pub(super) fn elongation_name(study: &Study<'_>, x: &Axis, y: &Axis) -> Layer {
    let Layer::Curve { name, points, .. } = study.elongation() else { return study.elongation() };
    Layer::Label { text: name, anchors: ending(&points, x, y), side: Side::Below }
}
