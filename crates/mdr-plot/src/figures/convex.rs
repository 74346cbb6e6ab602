//! Figures 1 and 2: a convex profile, for which the paraboloid stands.

use mdr::Result;
use mdr::prelude::{Elasticity, Scene, Shape, Stability};

use super::study::{Study, critical, critical_panel};
use crate::chart::{Panel, Picture, Side, Stroke};

/// A paraboloid, R = 1, E* = w = 1, with its equilibria at indentations in units of |d_c|; and |d_c|. In units of its critical
/// state the diagram is that of every paraboloid.
fn paraboloid(panel: Panel, depths: &[f64]) -> Result<(Study, f64)> {
    let scene = Scene::new(Shape::Paraboloid { radius: "1" }, Elasticity::effective("1")?, "1")?;
    let [_, radius, depth, _] = critical("2", "1/2")?;
    let unit = depth.abs();
    let depths: Vec<f64> = depths.iter().map(|share| share * unit).collect();
    Ok((Study::new(scene, [radius, unit], &depths, panel)?, unit))
}

/// Figure 1: (a) without indentation; (b) at several indentations, and the last equilibrium.
pub(super) fn figure_1a() -> Result<Picture> {
    let (mut study, unit) = paraboloid(critical_panel("(a)  *d* = 0", 4.0, [0.0, 4.4]), &[0.0])?;
    let transformed = study.transformed(0.0, "*g*(*a*)", Stroke::Dashed);
    study.add([study.elongation(), transformed.clone()]);
    let rest = study.nth(0.0, 0)?;
    let radius = rest.contact_radius;
    study.add(study.state(rest, "*O*", Side::Above));
    for (a, label, side) in [(0.5 * radius, "*a*_{1}", Side::Left), (1.3 * radius, "*a*_{2}", Side::Right)] {
        let [mut guide, text] = study.dropped(a, label, side);
        // Up to the upper of the two curves.
        let [from, to] = [guide.points[0], guide.points[1]];
        let on_g = transformed.points.iter().find(|point| point[0] >= from[0]).map_or(0.0, |point| point[1]);
        guide.points[1][1] = to[1].max(on_g);
        study.add([guide, text, study.direction(a, 0.0)]);
    }
    study.add(study.dropped(radius, "*a*_{O}", Side::Right));
    study.add([study.ending(&transformed, Side::Left), study.ending(&study.elongation(), Side::Below)]);
    let a_c = study.fold();
    Ok(Picture {
        title: "Figure 1a: equilibrium without indentation".to_owned(),
        description: format!(
            "The diagram {{Δl(a), g(a) − d}} of a paraboloid at d = 0. A contact of radius a_1, where Δl > g, grows (1.9); \
             one of radius a_2, where Δl < g, shrinks (1.8); arrows show the computed direction of change. O is a stable \
             equilibrium, at a_O/a_c = {:.6} (exactly 4^(2/3)). Lengths in units of the critical state a_c = {a_c:.6}, \
             |d_c| = {unit:.6} for R = 1, E* = w = 1.",
            radius / a_c,
        ),
        panels: vec![study.panel],
    })
}

/// Figure 1b: indentation moves the curve of g; the last equilibrium P.
pub(super) fn figure_1b() -> Result<Picture> {
    let depths = [
        (1.0, "*d* > 0", Stroke::Dotted),
        (0.0, "*d* = 0", Stroke::Dashed),
        (-0.6, "*d*_{c} < *d* < 0", Stroke::DashDotted),
        (-1.0, "*d* = *d*_{c}", Stroke::Thin),
    ];
    let panel = critical_panel("(b)  *g*(*a*) − *d*, pressed in and pulled out", 4.0, [-1.4, 4.4]);
    let (mut study, unit) = paraboloid(panel, &depths.map(|(share, ..)| share))?;
    study.add([study.elongation()]);
    let (mut radii, mut unstable) = (Vec::new(), Vec::new());
    for (share, name, stroke) in depths {
        let d = share * unit;
        study.add([study.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke).meaning(name)]);
        for state in study.equilibria(d).to_vec().iter().filter(|state| state.stability != Stability::Neutral) {
            study.add(study.state(state, "", Side::Below));
            let list = if state.stability == Stability::Stable { &mut radii } else { &mut unstable };
            list.push(format!("{:.5} a_c", state.contact_radius / study.fold()));
        }
    }
    study.add(study.critical());
    study.add([study.ending(&study.elongation(), Side::Below)]);
    Ok(Picture {
        title: "Figure 1b: equilibria at several indentations".to_owned(),
        description: format!(
            "The diagram {{Δl(a), g(a) − d}} of a paraboloid. Pressing (d > 0) moves the curve of g down and the \
             stable equilibrium to a larger radius, pulling moves it up. The last equilibrium P, where the curves \
             touch (1.10), is at a = a_c, d = d_c. Stable radii: {}; unstable, at d_c < d < 0: {}.",
            radii.join(", "),
            unstable.join(", "),
        ),
        panels: vec![study.panel],
    })
}

/// Figure 2: two equilibria, and the direction of change everywhere else.
pub(super) fn figure_2() -> Result<Picture> {
    let (mut study, unit) = paraboloid(critical_panel("*d* = 0.8 *d*_{c}", 2.6, [0.0, 3.0]), &[-0.8])?;
    let d = -0.8 * unit;
    let transformed = study.transformed(d, "*g*(*a*) − *d*", Stroke::Dashed);
    study.add([study.elongation(), transformed.clone()]);
    let (lower, upper) = (study.nth(d, 0)?, study.nth(d, 1)?);
    let (first, second) = (lower.contact_radius, upper.contact_radius);
    let unstable = study.state(lower, "*P*_{1}", Side::Above);
    study.add(unstable.chain(study.state(upper, "*P*_{2}", Side::Below)));
    study.add(study.dropped(first, "*a*_{eq,1}", Side::Right));
    study.add(study.dropped(second, "*a*_{eq,2}", Side::Right));
    study.add([0.85 * first, 0.62 * second, 1.36 * second].map(|a| study.direction(a, d)));
    study.add([study.ending(&transformed, Side::Left), study.ending(&study.elongation(), Side::Below)]);
    Ok(Picture {
        title: "Figure 2: a stable and an unstable equilibrium".to_owned(),
        description: format!(
            "The diagram {{Δl(a), g(a) − d}} of a paraboloid at d = 0.8 d_c. P_1, at a_eq,1 = {:.6} a_c, is \
             unstable, P_2, at a_eq,2 = {:.6} a_c, is stable: arrows show the computed direction of change, shrinking \
             outside (1.8) and growing between (1.9).",
            first / study.fold(),
            second / study.fold(),
        ),
        panels: vec![study.panel],
    })
}
