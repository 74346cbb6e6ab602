//! Griffith's route: the potential energy by quadrature of quadratures, without the rule of Heß.

use mdr_core::contact::{Control, Equilibrium, Result, Transform};
use mdr_numeric::branch::Branched;
use mdr_numeric::curve::Curve;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::Branches;

use super::folds::transform;
use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Scene};
use crate::trial::Trial;

/// Π, the energy release rate and the work lost in jumps.
///
/// With V = (|d|+g)/Δl the integrands v² and v² + 2v x g'/Δl are below V²(1+2n), on the scale where πa²w is ½ and the
/// release rate of an equilibrium is 1. The rate is the derivative of the integral, not the integrand at its end, which
/// would be (1.5) once more.
pub(super) const POTENTIAL: Run = ("energy-quadrature", |trial| by_turns!(every 8, trial, potential));

/// Equilibria as stationary points of the energy against those by the rule of Heß.
///
/// From d_c/100, where for n < 1/2 the contact is nearly Hertzian, Δl a thousandth of d and less, and the energy a small
/// difference, to beside d_c. The first are known to the tolerance above over the derivative of the release rate, d ln/d ln a of ((g−d)/Δl)².
pub(super) const ROUTES: Run = ("energy-route-against-force-route", routes);

/// What the numerical energy meets, in u of its integrand: 128 is its goal. g and g' are known to 32, the square to twice
/// that, and where this noise ends the refinement, its last changes may be four times as large.
const ENERGY: f64 = 128.0 + 4.0 * 2.0 * 32.0;

fn potential<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 0.05, most: 1e3, nearest: 20 });
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let (contact, material) = (scene.contact()?, scene.material()?);
    let transform = transform(&scene)?;
    let energy = Energy::new(&transform, &material)?;
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

fn routes(trial: &mut Trial<'_>) -> Result<()> {
    let n = if trial.index.is_multiple_of(3) { trial.uniform(0.05, 0.42) } else { trial.uniform(0.6, 12.0) };
    let exponent = Exponent::Double(n);
    let scene: Scene<f64> = trial.scene(trial.index, exponent, 1.0, ());
    let (contact, material) = (scene.contact()?, scene.material()?);
    let share = trial.uniform(0.01_f64.ln(), 0.95_f64.ln()).exp();
    let value = contact.critical(&Control::Indentation)?.indentation * share;
    trial.describe_also(format_args!("d = {share:e} d_c"));
    let transform = transform(&scene)?;
    let by_force = Branches::new(Curve::new(&transform, &material, &Control::Indentation))?.equilibria(&value)?;
    let by_energy = Energy::new(&transform, &material)?.equilibria(&Control::Indentation, &value)?;
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
