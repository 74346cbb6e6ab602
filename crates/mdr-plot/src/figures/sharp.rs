//! Figure 3: a sharp tip, f ∝ r^{1/4}, whose contact is lost to complete contact.

use mdr::Result;
use mdr::prelude::{Elasticity, Scene, Shape};

use super::study::{Study, critical, critical_panel};
use crate::chart::{Picture, Side, Stroke};

/// An indentation with two equilibria that can be told apart, in units of d_c.
const PRESSED: f64 = 0.9;

/// Figure 3.
pub(super) fn figure_3() -> Result<Picture> {
    let scene = Scene::new(Shape::Power { n: "1/4", c: "1" }, Elasticity::effective("1")?, "1")?;
    let [kappa, a_c, d_c, force] = critical("1/4", "1")?;
    let study = |depths: &[f64], panel| Study::new(scene.clone(), [a_c, d_c], depths, panel);
    let heading = "(b)  *g*(*a*) − *d*, pressed in; arrows for *d* = 0.9 *d*_{c}";
    let mut wide = study(&[0.0, -0.5 * d_c], critical_panel("(a)  *g*(*a*) − *d*, not pressed in", 32.0, [0.0, 6.4]))?;
    let mut near = study(&[PRESSED * d_c], critical_panel(heading, 4.0, [-1.1, 2.1]))?;
    unpressed(&mut wide, d_c)?;
    pressed(&mut near, d_c)?;
    let share = |study: &Study, d, index| study.nth(d, index).map(|state| state.contact_radius / a_c);
    Ok(Picture {
        title: "Figure 3: a sharp tip that jumps to complete contact".to_owned(),
        description: format!(
            "The diagram {{Δl(a), g(a) − d}} of the profile f = C r^(1/4), for which g(x) = κ C x^(1/4) with κ = {kappa:.9}. \
             (a) At d = 0 the only equilibrium O, at a_O = {:.6} a_c (exactly 16 a_c), is unstable: a smaller contact \
             shrinks to nothing, a larger one grows without end. At d < 0 it is the same with a larger radius. (b) \
             Pressed in by 0 < d < d_c the contact has a stable equilibrium, at d = {PRESSED} d_c with a = {:.6} a_c, and \
             an unstable one with a = {:.6} a_c. Both meet in the critical state P (1.10), beyond which the contact \
             spreads over the whole surface. With C = 1 m^(3/4), E* = 1 Pa, w = 1 J/m²: a_c = {a_c:.9} m, d_c = {d_c:.9} m, \
             F_c = {force:.9} N.",
            share(&wide, 0.0, 0)?,
            share(&near, PRESSED * d_c, 0)?,
            share(&near, PRESSED * d_c, 1)?,
        ),
        panels: vec![wide.panel, near.panel],
    })
}

/// d ≤ 0: the unstable equilibrium.
fn unpressed(study: &mut Study, unit: f64) -> Result<()> {
    study.add([study.elongation(), study.ending(&study.elongation(), Side::Above)]);
    for (d, name, stroke) in [(0.0, "*d* = 0", Stroke::Dashed), (-0.5 * unit, "*d* < 0", Stroke::DashDotted)] {
        study.add([study.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke).meaning(name)]);
        study.add(study.state(study.nth(d, 0)?, if d == 0.0 { "*O*" } else { "" }, Side::Above));
    }
    let radius = study.nth(0.0, 0)?.contact_radius;
    study.add(study.dropped(radius, "*a*_{O}", Side::Right));
    study.add([0.5, 1.5].map(|share| study.direction(share * radius, 0.0)));
    Ok(())
}

/// d > 0: a stable equilibrium up to the critical state.
fn pressed(study: &mut Study, unit: f64) -> Result<()> {
    study.add([study.elongation(), study.ending(&study.elongation(), Side::Above)]);
    let d = PRESSED * unit;
    let name = format!("*d* = {PRESSED} *d*_{{c}}");
    let depths = [
        (d, name.as_str(), Stroke::Dashed),
        (unit, "*d* = *d*_{c}", Stroke::DashDotted),
        (1.3 * unit, "*d* > *d*_{c}", Stroke::Dotted),
    ];
    for (d, name, stroke) in depths {
        study.add([study.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke).meaning(name)]);
    }
    for index in 0..2 {
        study.add(study.state(study.nth(d, index)?, "", Side::Above));
    }
    study.add(study.critical());
    let outer = study.nth(d, 1)?.contact_radius;
    study.add([0.62, 1.2].map(|share| study.direction(share * outer, d)));
    Ok(())
}
