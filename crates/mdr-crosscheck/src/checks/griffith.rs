//! Griffith's balance: the equilibria of (1.5), (1.6) are the stationary points of the potential energy.

use mdr_core::contact::{Control, Result};
use mdr_core::number::Dual;

use super::{Check, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::report::Unit;
use crate::theory::Form;
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// ∂Π/∂d = F (1.16) and ∂Π/∂a = 0 at d(a) (1.13), by dual numbers.
pub(super) const CLOSED: Check = Check {
    name: "energy-closed-form",
    claim: "∂Π/∂d = F (1.16) and ∂Π/∂a = 0 at d(a) (1.13)",
    equations: &["1.5", "1.6", "1.13", "1.16"],
    forms: &[Form::Energy, Form::Indentation, Form::Force],
    unit: Unit::Roundoffs,
    cases: [200, 2000, 20_000],
    case: |trial| by_turns!(trial, stationary),
};

fn stationary<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, ..Family::up_to(50) });
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let contact = scene.contact()?;
    // g and Δl within a factor of e² of where they balance at the fold.
    let stretch = R::from_f64(ctx, trial.uniform(-2.0, 2.0)) / (scene.n.clone() + scene.n.lit(1));
    let a = contact.critical(&Control::Indentation)?.contact_radius * stretch.exp();
    let d = trial.theory.indentation(&contact, &a)?;
    let dual = Scene {
        n: Dual::constant(scene.n.clone()),
        c: Dual::constant(scene.c.clone()),
        e_star: Dual::constant(scene.e_star.clone()),
        work: Dual::constant(scene.work.clone()),
    };
    let dual = dual.contact()?;

    let elongation = trial.theory.detachment_elongation(contact.material(), &a)?;
    let terms = trial.theory.g(contact.profile(), &a)? + &elongation;
    // d is rounded in g and in Δl; then means, squares and products, each derivative twice as many.
    let roundings = 2.0 * (TRANSFORM + ELONGATION + 14.0);
    let by_depth = trial.theory.energy(&dual, &Dual::constant(a.clone()), &Dual::variable(d.clone()))?.slope;
    let force = trial.theory.force(&contact, &a)?;
    let scale = terms.clone() * &a * scene.e_star.clone().times(2);
    trial.compare_on("∂Π/∂d", &by_depth, &force, &scale, roundings);

    // ∂Π/∂a = E*[(d−g)² − Δl²] is left of terms d², dg, g² and their sum with the slope of g: (n+1) of them.
    let by_radius = trial.theory.energy(&dual, &Dual::variable(a.clone()), &Dual::constant(d))?.slope;
    let scale = terms.square() * &scene.e_star;
    let exponent = a.ln().approx().abs();
    let allowed = 4.0 * (scene.n.approx() + 1.0) * (roundings + exponent);
    trial.compare_on("∂Π/∂a", &by_radius, &a.lit(0), &scale, allowed);
    Ok(())
}
