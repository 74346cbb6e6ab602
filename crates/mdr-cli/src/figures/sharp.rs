//! Figure 3: a sharp tip, f ∝ r^{1/4}, whose contact is lost to complete contact.

use mdr_analytic::{Contact, PowerLaw};
use mdr_core::contact::{Control, Material, Result};

use super::convex::elongation_name;
use super::diagram::{CRITICAL, DIRECTION, STABLE, Study, UNSTABLE, critical_units, panel, with};
use crate::picture::{Key, Mark, Panel, Picture, Side, Stroke};

/// Figure 3.
pub(super) fn figure_3() -> Result<Picture> {
    let contact = Contact::new(PowerLaw::new(0.25, 1.0)?, Material::new(1.0, 1.0)?);
    let critical = contact.critical(&Control::Indentation)?;
    let units = (critical.contact_radius, critical.indentation);
    let study = |upper| Study::new(contact.profile(), contact.material(), units, upper);
    let (wide, near) = (study(32.0)?, study(4.0)?);
    let [rest] = wide.some(0.0)?;
    let [inner, outer] = near.some(PRESSED * critical.indentation)?;
    let share = |radius: f64| radius / critical.contact_radius;
    Ok(Picture {
        title: "Figure 3: a sharp tip that jumps to complete contact".to_owned(),
        description: format!(
            "The diagram {{Δl(a), g(a) − d}} of the profile f = C r^(1/4), for which g(x) = κ C x^(1/4) with κ = {:.9}. \
             (a) At d = 0 the only equilibrium O, at a_O = {:.6} a_c (exactly 16 a_c), is unstable: a smaller contact \
             shrinks to nothing, a larger one grows without end. At d < 0 it is the same with a larger radius. (b) \
             Pressed in by 0 < d < d_c the contact has a stable equilibrium, at d = {PRESSED} d_c with a = {:.6} a_c, and \
             an unstable one with a = {:.6} a_c. Both meet in the critical state P (1.10), beyond which the contact \
             spreads over the whole surface. With C = 1 m^(3/4), E* = 1 Pa, w = 1 J/m²: a_c = {:.9} m, d_c = {:.9} m, \
             F_c = {:.9} N.",
            contact.profile().kappa(),
            share(rest.contact_radius),
            share(inner.contact_radius),
            share(outer.contact_radius),
            critical.contact_radius,
            critical.indentation,
            critical.force,
        ),
        panels: vec![unpressed(&wide, critical.indentation)?, pressed(&near, critical.indentation)?],
    })
}

/// An indentation with two equilibria that can be told apart, in units of d_c.
const PRESSED: f64 = 0.9;

/// d ≤ 0: the unstable equilibrium.
fn unpressed(study: &Study<'_>, unit: f64) -> Result<Panel> {
    let (x, y) = critical_units(32.0, (0.0, 6.4));
    let mut layers = vec![study.elongation(), elongation_name(study, &x, &y)];
    let [rest] = study.some(0.0)?;
    let mut legend = Vec::new();
    for (d, name, stroke) in [(0.0, "*d* = 0", Stroke::Dashed), (-0.5 * unit, "*d* < 0", Stroke::DashDotted)] {
        layers.push(study.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke));
        legend.push((Key::Line(stroke), name));
        let [state] = study.some(d)?;
        layers.extend(study.state(&state, if d == 0.0 { "*O*" } else { "" }, Side::Above));
    }
    legend.extend([UNSTABLE, DIRECTION]);
    layers.extend(study.dropped(rest.contact_radius, "*a*_{O}", &y, Side::Right));
    for a in [0.5 * rest.contact_radius, 1.5 * rest.contact_radius] {
        layers.push(study.direction(a, 0.0, &x, &y)?);
    }
    Ok(with(panel("(a)  *g*(*a*) − *d*, not pressed in", x, y), layers, &legend))
}

/// d > 0: a stable equilibrium up to the critical state.
fn pressed(study: &Study<'_>, unit: f64) -> Result<Panel> {
    let (x, y) = critical_units(4.0, (-1.1, 2.1));
    let mut layers = vec![study.elongation(), elongation_name(study, &x, &y)];
    let d = PRESSED * unit;
    let name = format!("*d* = {PRESSED} *d*_{{c}}");
    let depths = [
        (d, name.as_str(), Stroke::Dashed),
        (unit, "*d* = *d*_{c}", Stroke::DashDotted),
        (1.3 * unit, "*d* > *d*_{c}", Stroke::Dotted),
    ];
    let mut legend = Vec::new();
    for (d, name, stroke) in depths {
        layers.push(study.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke));
        legend.push((Key::Line(stroke), name));
    }
    legend.extend([STABLE, UNSTABLE, CRITICAL, DIRECTION]);
    let [inner, outer] = study.some(d)?;
    for state in [&inner, &outer] {
        layers.extend(study.state(state, "", Side::Above).into_iter().take(1));
    }
    layers.extend(study.marked(study.folds()[0].contact_radius, "*P*", Mark::Diamond, Side::Below));
    for a in [0.62 * outer.contact_radius, 1.2 * outer.contact_radius] {
        layers.push(study.direction(a, d, &x, &y)?);
    }
    Ok(with(panel("(b)  *g*(*a*) − *d*, pressed in; arrows for *d* = 0.9 *d*_{c}", x, y), layers, &legend))
}
