//! Griffith's balance: the equilibria of (1.5), (1.6) are the stationary points of the potential energy.

use mdr_core::contact::{Control, Result};
use mdr_core::number::Dual;

use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// ∂Π/∂d = F (1.16) and ∂Π/∂a = 0 at d(a) (1.13), by dual numbers.
pub(super) const CLOSED: Run = ("energy-closed-form", |trial| by_turns!(trial, stationary));

/// The work lost in jumps and the barrier before complete contact as differences of Π, and d(a₀) = 0.
pub(super) const JUMPS: Run = ("jump-work-closed-form", |trial| by_turns!(trial, jumps));

fn jumps<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, ..Family::up_to(50) });
    let scene: Scene<R> = trial.scene(round, exponent, 2.0 * exponent.value::<f64>(()), ctx);
    let contact = scene.contact()?;
    let a = trial.closed.radius_at_zero_indentation(&contact)?;
    let tangent = scene.tangent(2.0 * scene.n.approx(), &a);
    let elongation = trial.closed.detachment_elongation(contact.material(), &a)?;
    let d = trial.closed.indentation(&contact, &a)?;
    let allowed = 0.5 * tangent.excess() * tangent.radius() + TRANSFORM + ELONGATION + 4.0;
    trial.compare_on("d(a₀)", &d, &a.lit(0), &elongation, allowed);

    let unit = |scene: &Scene<R>, a: &R| a.pi() * a * a * &scene.work;
    let rest = trial.closed.energy(&contact, &a, &a.lit(0))?;
    if scene.n > scene.n.ratio(1, 2) {
        let lost = trial.closed.energy_lost_at_jump_in(&contact)?;
        trial.compare_on("jump-in", &lost, &-rest, &unit(&scene, &a), tangent.energy());
        // Towards n = 1/2 the pull-off is hundreds of decades from a₀.
        let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
        let contact = scene.contact()?;
        let state = contact.critical(&Control::Indentation)?;
        let a = &state.contact_radius;
        let lost = trial.closed.energy_lost_at_pull_off(&contact)?;
        let edge = trial.closed.energy(&contact, a, &state.indentation)?;
        trial.compare_on("pull-off", &lost, &edge, &unit(&scene, a), scene.tangent(1.0, a).energy());
    } else {
        let barrier = trial.closed.barrier_to_complete_contact(&contact)?;
        trial.compare_on("barrier", &barrier, &rest, &unit(&scene, &a), tangent.energy());
    }
    Ok(())
}

fn stationary<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, ..Family::up_to(50) });
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let contact = scene.contact()?;
    // g and Δl within a factor of e² of where they balance at the fold.
    let stretch = R::from_f64(ctx, trial.uniform(-2.0, 2.0)) / (scene.n.clone() + scene.n.lit(1));
    let a = contact.critical(&Control::Indentation)?.contact_radius * stretch.exp();
    let d = trial.closed.indentation(&contact, &a)?;
    let dual = scene.map(|x| Dual::constant(x.clone())).contact()?;

    let elongation = trial.closed.detachment_elongation(contact.material(), &a)?;
    let terms = trial.closed.g(contact.profile(), &a)? + &elongation;
    // d is rounded in g and in Δl; then means, squares and products, each derivative twice as many.
    let roundings = 2.0 * (TRANSFORM + ELONGATION + 14.0);
    let by_depth = trial.closed.energy(&dual, &Dual::constant(a.clone()), &Dual::variable(d.clone()))?.slope;
    let force = trial.closed.force(&contact, &a)?;
    let scale = terms.clone() * &a * scene.e_star.clone().times(2);
    trial.compare_on("∂Π/∂d", &by_depth, &force, &scale, roundings);

    // ∂Π/∂a = E*[(d−g)² − Δl²] is left of terms d², dg, g² and their sum with the slope of g: (n+1) of them.
    let by_radius = trial.closed.energy(&dual, &Dual::variable(a.clone()), &Dual::constant(d))?.slope;
    let scale = terms.square() * &scene.e_star;
    let exponent = a.ln().approx().abs();
    let allowed = 4.0 * (scene.n.approx() + 1.0) * (roundings + exponent);
    trial.compare_on("∂Π/∂a", &by_radius, &a.lit(0), &scale, allowed);
    Ok(())
}
