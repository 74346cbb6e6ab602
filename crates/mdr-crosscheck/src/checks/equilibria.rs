//! Equilibria and their stability on both sides of a fold.

use mdr_core::contact::{Outcome, Result, Stability};
use mdr_numeric::branch::Branched;
use mdr_numeric::curve::Curve;
use mdr_numeric::equilibrium::Branches;

use super::folds::{ClosedFold, Quadratures};
use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Held, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// At v = v_c(1 ∓ 2^−k) of the controlled quantity v: two equilibria before the closed-form critical value, the stable
/// one at the larger radius for n > 1/2 and at the smaller for n < 1/2, and none beyond it; what becomes of the contact
/// there; and each equilibrium put into the closed forms (1.13), (1.16).
///
/// k is as large as the errors of both routes in v_c allow. The residual is compared and not the radius: a − a_c grows as
/// the root of the distance, so half the digits of a radius are lost at the fold in any route.
pub(super) const BESIDE: Run = ("equilibria-beside-the-fold", |trial| by_turns!(every 5, trial, beside));

fn beside<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, most: 1e2, nearest: 20 });
    let held = trial.held();
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let (contact, material, control) = (scene.contact()?, scene.material()?, held.control());
    let fold = ClosedFold::of(trial, &scene, held)?;
    // Twice what counts as the fold itself.
    let bits = fold.bits(2.0);
    if bits < 1.0 {
        return Ok(());
    }
    let k = trial.uniform(1.0, bits + 1.0).floor() as i64;
    trial.describe_also(format_args!("{held}, k = {k}"));
    let distance = fold.value.lit(2).powi(-k);
    let branches = Branches::new(Curve::new(&fold.transform, &material, &control))?;

    let before = fold.value.clone() * &(distance.lit(1) - &distance);
    let equilibria = branches.equilibria(&before)?;
    let pull_off = scene.n > scene.n.ratio(1, 2);
    let stable: Vec<bool> = equilibria.iter().map(|state| state.stability == Stability::Stable).collect();
    trial.demand("two equilibria before the fold, and which is stable", stable == [!pull_off, pull_off]);
    for equilibrium in &equilibria {
        let a = &equilibrium.contact_radius;
        let at = Quadratures::at(&fold.transform, fold.tangent.n, a)?;
        let rounded_exponent = (fold.tangent.n + 1.0) * a.ln().approx().abs();
        let terms = trial.closed.g(contact.profile(), a)? + trial.closed.detachment_elongation(&material, a)?;
        let (found, scale) = match held {
            Held::Indentation => (trial.closed.indentation(&contact, a)?, terms),
            Held::Force => (trial.closed.force(&contact, a)?, terms * a * scene.e_star.clone().times(2)),
        };
        // The direction of change vanishes to the rounding of its terms; the last bracket moves g by n and Δl by ½.
        let allowed = at.g + at.mean + TRANSFORM + 2.0 * ELONGATION + 4.0 * fold.tangent.n + rounded_exponent + 16.0;
        trial.compare_on("v", &found, &before, &scale, allowed);
    }
    let beyond = fold.value.clone() * &(distance.lit(1) + &distance);
    trial.demand("no equilibrium beyond the fold", branches.equilibria(&beyond)?.is_empty());
    let outcome = if pull_off { Outcome::Detached } else { Outcome::CompleteContact };
    trial.demand("what becomes of the contact", branches.outcome(0)? == outcome);
    Ok(())
}
