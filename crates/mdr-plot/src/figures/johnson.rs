//! Johnson's wave: the diagram {Δl, g − d} of a half-plane on a slightly wavy surface.

use std::borrow::Cow;

use mdr::Result;
use mdr::diagram::State;
use mdr::prelude::*;

use super::study::Study;
use crate::balance::{Balance, shifted};
use crate::chart::{Layer, Mark, Panel, Picture, Side, Stroke};
use crate::{Axis, Unit};

/// w of the wave with h₀ = λ = E* = 1 at α = √(2λw/(π²h₀²E*)) = 0.3.
const WORK: &str = "0.44413219804902113784755209499";

/// The largest half-width that is shown, in periods.
const WIDEST: f64 = 0.495;

/// The wave under a control, with the equilibria at some values, as far as it is not in complete contact.
fn wave(control: Control<Literal>, values: &[f64], heading: &str, heights: [f64; 2]) -> Result<Study> {
    let at = values.iter().map(|value| value.exact()).collect::<std::result::Result<_, _>>()?;
    let scene = Scene::new(Profile::Wave("1".exact()?), Elasticity::effective("1")?, WORK)?
        .medium(Medium::Periodic { wavelength: "1".exact()?, flaw: None })?
        .control(control)
        .want(Want::Equilibria { at })
        .arithmetic(Arithmetic::Double);
    let diagram = scene.diagram_up_to(WIDEST)?;
    let x = Axis::linear("half-width of the contact *a* / λ", Unit::One, 0.0, 0.5);
    let panel = Panel::new(heading, x, Axis::linear("length / *h*_{0}", Unit::One, heights[0], heights[1]));
    Ok(Study { sides: Balance { diagram: Cow::Owned(diagram), units: [1.0; 2] }, panel })
}

/// A touching point of the two curves, with its label.
fn touching(study: &mut Study, fold: &State, label: &str, side: Side) {
    let at = vec![study.sides.on_elongation(fold.contact_radius)];
    study.add([
        Layer::marks(label, at.clone(), Mark::Diamond).meaning("the curves touch"),
        Layer::label(label, at, side),
    ]);
}

/// The figure.
pub(super) fn figure() -> Result<Picture> {
    // The folds first, at which the curves are then drawn.
    let folds = |control| Ok::<_, Error>(wave(control, &[], "", [0.0, 1.0])?.sides.diagram.folds.clone());
    let (grips, load) = (folds(Control::Indentation)?, folds(Control::Force)?);
    let ([pull_off], [off, into]) = (&grips[..], &load[..]) else {
        let why = "the wave has other folds than one by its approach and two under a load".to_owned();
        return Err(Error::Scene { place: None, key: "output.folds".to_owned(), why });
    };
    let d = pull_off.indentation;
    let mut approach =
        wave(Control::Indentation, &[0.0, d], "(a)  the approach *d* of the mean planes is held", [0.0, 1.5])?;
    approach.add([approach.elongation()]);
    let depths = [(0.0, "*d* = 0", Stroke::Dashed), (d, "*d* = *d*_{c}", Stroke::DashDotted)];
    for (d, name, stroke) in depths {
        approach.add([approach.transformed(d, &format!("*g*(*a*) − *d*, {name}"), stroke).meaning(name)]);
    }
    for state in approach.equilibria(0.0).to_vec() {
        approach.add(approach.state(&state, "", Side::Above));
    }
    touching(&mut approach, pull_off, "*P*", Side::Below);
    let forces = [(off.force, "*p* = *p*_{off}", Stroke::DashDotted), (into.force, "*p* = *p*_{in}", Stroke::Dotted)];
    let heading = "(b)  the mean pressure *p* is held";
    let mut dead = wave(Control::Force, &forces.map(|(force, ..)| force), heading, [-0.2, 0.7])?;
    dead.add([dead.elongation()]);
    let held = dead.sides.diagram.held.clone();
    for (held, (_, name, stroke)) in held.iter().zip(forces) {
        dead.add([shifted(format!("*g*(*a*) − *d*, {name}"), held.shifted.clone(), stroke).meaning(name)]);
    }
    touching(&mut dead, off, "*P*_{off}", Side::Below);
    touching(&mut dead, into, "*P*_{in}", Side::Below);
    Ok(Picture {
        title: "Johnson's wave: pull-off, and the jump into complete contact".to_owned(),
        description: format!(
            "The diagram {{Δl(a), g(a) − d}} of an elastic half-plane on a wave of the amplitude h_0 and the wavelength λ (K. L. \
             Johnson, Int. J. Solids Struct. 32 (1995) 423), for α = 0.3: g = h_0 s(1 − ln s) and Δl = −h_0 α √t ln s, where s is \
             the square of the sine of πa/λ, and t its tangent. (a) With the mean planes held the curves touch once, at the pull-off \
             P: a = {:.6} λ, d = {:.6} h_0. No approach makes the contact complete. (b) Under a mean pressure p they touch twice: \
             at the pull-off, a = {:.6} λ, p = {:.6} p*, and at a = {:.6} λ, p = {:.6} p*, beyond which the contact jumps to \
             complete contact; p* = πE*h_0/λ would close the wave without adhesion.",
            pull_off.contact_radius,
            pull_off.indentation,
            off.contact_radius,
            off.force / std::f64::consts::PI,
            into.contact_radius,
            into.force / std::f64::consts::PI,
        ),
        panels: vec![approach.panel, dead.panel],
    })
}
