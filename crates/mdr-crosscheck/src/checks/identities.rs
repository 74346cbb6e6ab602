//! The closed forms against each other: critical states put back into the equations they solve.

use mdr_core::contact::{Control, Result};
use mdr_core::number::Dual;

use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// (1.17) against (1.16) at a_c, d_c against (1.13), and the condition (1.10), (1.14) with its analogue for a dead load.
pub(super) const CRITICAL: Run = ("critical-state-in-its-equations", |trial| by_turns!(trial, critical));

/// The slopes along the equilibria against derivatives by dual numbers, and F' = 2E*(a d' − Δl).
pub(super) const SLOPES: Run = ("slopes-of-equilibria", |trial| by_turns!(trial, slopes));

/// Logarithms of a critical state against the state.
pub(super) const LOGARITHMS: Run = ("logarithms-of-critical-states", |trial| by_turns!(trial, logarithms));

fn critical<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (exponent, held) = (trial.exponent(round, Family::up_to(50)), trial.held());
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let contact = scene.contact()?;
    let state = trial.closed.critical(&contact, &held.control())?;
    let a = &state.contact_radius;
    let allowed = scene.tangent(held.lambda(), a);
    let elongation = trial.closed.detachment_elongation(contact.material(), a)?;
    let force_scale = elongation.clone() * a * contact.material().effective_modulus().clone().times(2);

    let d = trial.closed.indentation(&contact, a)?;
    trial.compare_on(format!("d ({held})"), &state.indentation, &d, &elongation, allowed.indentation_at_radius());
    let f = trial.closed.force(&contact, a)?;
    trial.compare_on(format!("F ({held})"), &state.force, &f, &force_scale, allowed.force_at_radius());
    let slope = trial.closed.slope(contact.profile(), a)?;
    let unit = (elongation / a).over(2);
    let tension = unit.clone() * R::from_f64(ctx, held.lambda());
    trial.compare_on(format!("g' ({held})"), &slope, &tension, &unit, allowed.slope_at_radius());
    Ok(())
}

fn slopes<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family::up_to(50));
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let contact = scene.contact()?;
    // Off the fold by up to a factor of two in the terms of d', so that nothing of it is small.
    let stretch = R::from_f64(ctx, trial.uniform(-1.0, 1.0)) / (scene.n.clone() + scene.n.lit(1));
    let a = contact.critical(&Control::Indentation)?.contact_radius * stretch.exp();
    let dual = scene.map(|x| Dual::constant(x.clone())).contact()?;
    let x = Dual::variable(a.clone());
    let n = scene.n.approx();
    let exponents = (n + 1.0) * (a.ln().approx().abs() + 1.0);

    let profile = contact.profile();
    let g = trial.closed.g(profile, &a)?;
    let slope = trial.closed.slope(profile, &a)?;
    let integral = trial.closed.integral(dual.profile(), &x)?;
    // n·g/x on one side; on the other a power with the rounded exponent n − 1.
    trial.compare("g", &integral.slope, &g, 2.0 * TRANSFORM + 6.0 + exponents);
    let tension = trial.closed.detachment_elongation(contact.material(), &a)? / a.clone().times(2);
    let terms = slope.clone() + &tension;
    let allowed = 2.0 * TRANSFORM + 2.0 * ELONGATION + 8.0 + exponents;
    let d = trial.closed.indentation(&dual, &x)?;
    trial.compare_on("d'", &trial.closed.indentation_slope(&contact, &a)?, &d.slope, &terms, allowed);
    let f = trial.closed.force(&dual, &x)?;
    let scale = terms * &a * scene.e_star.clone().times(2);
    trial.compare_on("F'", &trial.closed.force_slope(&contact, &a)?, &f.slope, &scale, 3.0 * allowed + 6.0);
    Ok(())
}

fn logarithms<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (exponent, held) = (trial.exponent(round, Family::up_to(40)), trial.held());
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let contact = scene.contact()?;
    // Each logarithm in ln q is rounded to its own size, and so are the sums: three roundings of their total.
    let terms = [&scene.e_star, &scene.work, &scene.c, &scene.c, &scene.n, &scene.n, &scene.n, &scene.n];
    let sizes: f64 = terms.iter().map(|x| x.ln().approx().abs() + 1.0).sum();
    let state = trial.closed.critical(&contact, &held.control())?;
    let ln = trial.closed.ln_critical(&contact, &held.control())?;
    let tangent = scene.tangent(held.lambda(), &state.contact_radius);
    let radius = tangent.radius() + 3.0 * sizes / tangent.excess();
    let mut compare = |name, value: &R, ln: &R, allowed: f64| {
        let error = (ln.clone() - value.abs().ln()) / value.unit_roundoff();
        trial.enter(format!("{name} ({held})"), error.abs().approx(), allowed);
    };
    compare("ln a", &state.contact_radius, &ln.contact_radius, radius);
    if state.indentation != state.indentation.lit(0) {
        compare("ln|d|", &state.indentation, &ln.indentation, 0.5 * radius + 3.0 * sizes + 20.0);
    }
    compare("ln|F|", &state.force, &ln.force, 1.5 * radius + 6.0 * sizes + 20.0);
    Ok(())
}
