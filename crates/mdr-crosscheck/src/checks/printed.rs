//! (1.15) as it is printed, refuted. The printed form exists here and nowhere else.

use mdr_core::contact::{Control, Result};
use mdr_core::number::Real;

use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::trial::Trial;

/// The exponent of (1.15) must be 1/(2n−1); printed is 1/(1−2n).
///
/// Dimensions: in a unit of length s times smaller a radius is s times larger. The corrected form scales with s¹, the
/// printed one with s⁻¹, for every n.
pub(super) const DIMENSIONS: Run = ("printed-1.15-dimensions", |trial| by_turns!(trial, dimensions));

/// (πw/(2E*n²κ_n²C²))^{1/(1−2n)}: (1.15) as printed.
pub(super) fn printed_radius<R: Arithmetic>(scene: &Scene<R>) -> Result<R> {
    let kappa = mdr_analytic::kappa(&scene.n)?;
    let slope = kappa * &scene.n * &scene.c;
    let base = scene.work.pi() * &scene.work / &scene.e_star / slope.square().times(2);
    let one = scene.n.lit(1);
    Ok(base.pow(&(one.clone() - scene.n.clone().times(2)).inv()))
}

/// The contact in a unit of length s times smaller, the unit of force kept: C in m^(1−n), E* in N/m², w in N/m.
fn in_smaller_unit<R: Real>(scene: &Scene<R>, s: &R) -> Scene<R> {
    let one = s.lit(1);
    Scene {
        n: scene.n.clone(),
        c: s.pow(&(one - &scene.n)) * &scene.c,
        e_star: scene.e_star.clone() / s.square(),
        work: scene.work.clone() / s,
    }
}

fn dimensions<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, most: 20.0, nearest: 20 });
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let s = R::from_int(ctx, [1000, 2, 100, 10][round % 4]);
    let smaller = in_smaller_unit(&scene, &s);
    let radius = |trial: &Trial<'_>, scene: &Scene<R>| -> Result<R> {
        Ok(trial.closed.critical(&scene.contact()?, &Control::Indentation)?.contact_radius)
    };
    let (a, a_smaller) = (radius(trial, &scene)?, radius(trial, &smaller)?);
    let ln_s = s.ln();
    let exponent_of = |long: &R, short: &R| (short.ln() - long.ln()) / &ln_s;

    // Both radii, the rounding of the scaled inputs (C scales with a power), and two logarithms.
    let inputs = 8.0 + (1.0 - scene.n.approx()).abs() * ln_s.approx();
    let tangents = [scene.tangent(1.0, &a), smaller.tangent(1.0, &a_smaller)];
    let errors: f64 = tangents.iter().map(|t| t.radius() + t.ln_a.abs() + inputs / t.excess()).sum();
    let allowed = errors / ln_s.approx() + 4.0;
    trial.compare("dimension of a_c", &exponent_of(&a, &a_smaller), &s.lit(1), allowed);

    let printed = exponent_of(&printed_radius(&scene)?, &printed_radius(&smaller)?);
    let distance = ((printed - s.lit(1)).abs() / s.unit_roundoff()).approx();
    trial.demand("(1.15) as printed is no length", distance > allowed);
    Ok(())
}
