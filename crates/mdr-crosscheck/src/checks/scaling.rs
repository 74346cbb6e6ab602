//! The answers must not depend on the system of units.

use mdr_core::contact::Result;

use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Scene};
use crate::trial::Trial;

/// E* and w in a unit of force 4^m times smaller: B does not change, so that a and d are the same bits and F is
/// exactly 4^m times as large.
pub(super) const FORCE: Run = ("unit-of-force", |trial| by_turns!(trial, unit_of_force));

/// C, E* and w in a unit of length 2^m times smaller, for exponents where 2^{m(1−n)} is a power of two.
pub(super) const LENGTH: Run = ("unit-of-length", |trial| by_turns!(trial, unit_of_length));

fn unit_of_force<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let (exponent, held) = (trial.exponent(round, Family::up_to(50)), trial.held());
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let factor = R::from_int(ctx, 4).powi([7, -5, 20, -16, 1][round % 5]);
    let scaled = Scene { e_star: scene.e_star.clone() * &factor, work: scene.work.clone() * &factor, ..scene.clone() };
    let state = trial.closed.critical(&scene.contact()?, &held.control())?;
    let other = trial.closed.critical(&scaled.contact()?, &held.control())?;
    trial.demand(format!("a ({held})"), state.contact_radius == other.contact_radius);
    trial.demand(format!("d ({held})"), state.indentation == other.indentation);
    trial.demand(format!("F ({held})"), state.force * &factor == other.force);
    Ok(())
}

fn unit_of_length<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    // n = p/q and m a multiple of q.
    let (p, q) = [(2, 1), (1, 4), (1, 1), (3, 4), (3, 2), (5, 2), (5, 8), (3, 8), (3, 1), (7, 16)][round % 10];
    let held = trial.held();
    let scene: Scene<R> = trial.scene(round, Exponent::Fraction(p, q), held.lambda(), ctx);
    let m = q * [1, -2, 3][round % 3];
    let two = R::from_int(ctx, 2);
    let s = two.powi(m);
    let scaled = Scene {
        n: scene.n.clone(),
        c: scene.c.clone() * &two.powi(m / q * (q - p)),
        e_star: scene.e_star.clone() / s.square(),
        work: scene.work.clone() / &s,
    };
    let state = trial.closed.critical(&scene.contact()?, &held.control())?;
    let other = trial.closed.critical(&scaled.contact()?, &held.control())?;
    let [here, there] = [(&scene, &state), (&scaled, &other)]
        .map(|(scene, state)| scene.tangent(held.lambda(), &state.contact_radius).radius());
    let allowed = here + there;
    trial.compare(format!("a ({held})"), &other.contact_radius, &(state.contact_radius * &s), allowed);
    if state.indentation == s.lit(0) {
        trial.demand("d = 0", other.indentation == s.lit(0));
    } else {
        trial.compare(format!("d ({held})"), &other.indentation, &(state.indentation * &s), 0.5 * allowed + 24.0);
    }
    trial.compare(format!("F ({held})"), &other.force, &state.force, 1.5 * allowed + 24.0);
    Ok(())
}
