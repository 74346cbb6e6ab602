//! Griffith's balance: the equilibria of (1.5), (1.6) are the stationary points of the potential energy, by its closed form
//! and, without the rule of Heß, by quadrature of quadratures.

use mdr_core::contact::{Control, Equilibrium, Result, Transform};
use mdr_core::number::Dual;
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::SearchedBranches;

use super::common::transform;
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// The work lost in jumps and the barrier before complete contact as differences of Π, and d(a₀) = 0.
pub(super) fn jumps<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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

/// ∂Π/∂d = F (1.16) and ∂Π/∂a = 0 at d(a) (1.13), by dual numbers.
pub(super) fn stationary<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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

/// The error of the numerical energy, in u of its integrand: 128 is its goal. g and g' are known to 32, the square to twice
/// that, and where this noise ends the refinement, its last changes may be four times as large.
const ENERGY: f64 = 128.0 + 4.0 * 2.0 * 32.0;

/// Π, the energy release rate and the work lost in jumps.
///
/// With V = (|d|+g)/Δl the integrands v² and v² + 2v x g'/Δl are below V²(1+2n), on the scale where πa²w is ½ and the
/// release rate of an equilibrium is 1. The rate is the derivative of the integral, not the integrand at its end, which
/// would be (1.5) once more.
pub(super) fn potential<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 0.05, most: 1e3, nearest: 20 });
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let (contact, material) = (scene.contact()?, scene.material()?);
    let transform = transform(&scene)?;
    let energy = Energy::new(Contact::half_space(&transform, &material, &Control::Indentation))?;
    let critical = trial.closed.critical(&contact, &Control::Indentation)?;
    let n = scene.n.approx();
    let stretch = R::from_f64(ctx, trial.uniform(-1.0, 1.0)) / (scene.n.clone() + scene.n.lit(1));
    let a = critical.contact_radius.clone() * stretch.exp();
    let d = trial.closed.indentation(&contact, &a)?;
    let size = |a: &R, d: &R| -> Result<f64> {
        let elongation = contact.detachment_elongation(a)?;
        let terms = (d.abs() + contact.indentation(a)?.abs() + &elongation) / elongation;
        Ok(terms.approx().powi(2) * (1.0 + 2.0 * n))
    };
    let unit = |a: &R| a.pi() * a * a * &scene.work;

    let allowed = ENERGY * size(&a, &d)?;
    let closed = trial.closed.energy(&contact, &a, &d)?;
    trial.compare_on("Π", &closed, &energy.potential(&a, &d)?, &unit(&a), 2.0 * allowed);
    trial.compare("release rate", &energy.release_by_variation(&a, &d)?, &a.lit(1), 2.0 * allowed);

    let excess = (2.0 * n - 1.0).abs();
    let tangent = scene.tangent(1.0, &critical.contact_radius);
    if n > 0.5 {
        let (a, d) = (&critical.contact_radius, &critical.indentation);
        let lost = trial.closed.energy_lost_at_pull_off(&contact)?;
        // a_c is off by the closed form's error, which moves the lost work by twice that, times its own small factor.
        let allowed = 2.0 * ENERGY * size(a, d)? + 2.0 * excess * tangent.radius();
        trial.compare_on("pull-off", &lost, &energy.potential(a, d)?, &unit(a), allowed);
    }
    Ok(())
}

/// Equilibria as stationary points of the energy against those by the rule of Heß.
///
/// From d_c/100, where for n < 1/2 the contact is nearly Hertzian, Δl a thousandth of d and less, and the energy a small
/// difference, to beside d_c. The first are known to the tolerance above over the derivative of the release rate, d ln/d ln a of ((g−d)/Δl)².
pub(super) fn routes(trial: &mut Trial<'_>) -> Result<()> {
    let n = if trial.index.is_multiple_of(3) { trial.uniform(0.05, 0.42) } else { trial.uniform(0.6, 12.0) };
    let exponent = Exponent::Double(n);
    let scene: Scene<f64> = trial.scene(trial.index, exponent, 1.0, ());
    let (contact, material) = (scene.contact()?, scene.material()?);
    let share = trial.uniform(0.01_f64.ln(), 0.95_f64.ln()).exp();
    let value = contact.critical(&Control::Indentation)?.indentation * share;
    trial.describe_also(format_args!("d = {share:e} d_c"));
    let transform = transform(&scene)?;
    let by_force =
        SearchedBranches::new(Contact::half_space(&transform, &material, &Control::Indentation))?.equilibria(&value)?;
    let by_energy = Energy::new(Contact::half_space(&transform, &material, &Control::Indentation))?
        .equilibria(&Control::Indentation, &value)?;
    let stabilities = |states: &[Equilibrium<f64>]| -> Vec<_> { states.iter().map(|state| state.stability).collect() };
    trial.demand("number and stability", stabilities(&by_force) == stabilities(&by_energy));
    for (force, energy) in by_force.iter().zip(&by_energy) {
        let a = force.contact_radius;
        let elongation = contact.detachment_elongation(&a)?;
        let terms = (value.abs() + contact.profile().g(&a)? + elongation) / elongation;
        let rate = 2.0 * (contact.indentation_slope(&a)? * a / elongation).abs();
        let allowed = 2.0 * ENERGY * terms.powi(2) * (1.0 + 2.0 * n) / rate;
        trial.compare("a", &energy.contact_radius, &a, allowed);
    }
    Ok(())
}
