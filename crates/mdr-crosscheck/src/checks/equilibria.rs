//! Equilibria and their stability on both sides of a fold, and at a given value of the controlled quantity.

use mdr_analytic::PowerLawContact;
use mdr_core::contact::{Control, Equilibrium, Outcome, Result, Stability, Transform};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;

use super::common::{ClosedFold, Quadratures, transform};
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Family, Held, Scene};
use crate::tolerance::{ELONGATION, TRANSFORM};
use crate::trial::Trial;

/// At v = v_c(1 ∓ 2^−k) of the controlled quantity v: two equilibria before the closed-form critical value, the stable
/// one at the larger radius for n > 1/2 and at the smaller for n < 1/2, and none beyond it; what becomes of the contact
/// there; and each equilibrium put into the closed forms (1.13), (1.16).
///
/// k is as large as the errors of both routes in v_c allow. The residual is compared and not the radius: a − a_c grows as
/// the root of the distance, so half the digits of a radius are lost at the fold in any route.
pub(super) fn beside<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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
    let branches = SearchedBranches::new(Contact::half_space(&fold.transform, &material, &control))?;

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

/// The inverse of (1.13) and (1.16) against the branches of the numerical route, which share no formula with it: their
/// number, their stability, a, d and F. Both at a value, and at its distance τ from the fold.
///
/// Half of the cases are at x_fold(1 − 2^−k), with k as large as the errors of both routes in x_fold allow; the others
/// beyond zero, or at n = 1/2.
pub(super) fn equilibria<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    if round % 7 == 6 { scale_free::<R>(trial, round, ctx) } else { folded::<R>(trial, round, ctx) }
}

/// n ≠ 1/2.
fn folded<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family { least: 1e-2, most: 1e2, nearest: 20 });
    let held = trial.held();
    let scene: Scene<R> = trial.scene(round, exponent, held.lambda(), ctx);
    let (contact, control) = (scene.contact()?, held.control());
    let fold = ClosedFold::of(trial, &scene, held)?;
    let bits = fold.bits(4.0);
    if bits < 1.0 {
        return Ok(());
    }
    let distance = if trial.uniform(0.0, 1.0) < 0.5 {
        let k = trial.uniform(1.0, bits + 1.0).floor() as i64;
        fold.value.lit(2).powi(-k)
    } else {
        fold.value.lit(1) + R::from_f64(ctx, 10_f64.powf(trial.uniform(-2.0, 2.0)))
    };
    trial.describe_also(format_args!("{held}, τ = {:e}", distance.approx()));
    let value = (distance.lit(1) - &distance) * &fold.value;
    let asked = Asked { scene: &scene, contact: &contact, held, value: &value };

    let numeric = asked.numeric(trial)?;
    let by_value = trial.closed.equilibria(&contact, &control, &value)?;
    asked.compare(trial, "at x", &by_value, &numeric, [0.0; 2])?;
    let by_distance = trial.closed.equilibria_at_distance(&contact, &control, &distance)?;
    let off = fold.value_error * (fold.value.abs().approx() / value.abs().approx() + 1.0);
    asked.compare(trial, "at τ", &by_distance, &numeric, [off, fold.radius_error])
}

/// n = 1/2: the value of a planted state, and its negative.
fn scale_free<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let half = Exponent::Fraction(1, 2);
    let held = trial.held();
    let scales = trial.scales::<R>(round, half);
    // ρ over its threshold, on either side.
    let off = 2_f64.powf(trial.uniform(0.25, 3.0));
    let rho = held.lambda() * if round.is_multiple_of(2) { off } else { 1.0 / off };
    let scene: Scene<R> = trial.planted(half, rho, scales, ctx);
    let contact = scene.contact()?;
    let state = contact.scale_free_state(&R::from_f64(ctx, scales.radius))?;
    let planted = held.of([state.indentation, state.force]);
    for value in [planted.clone(), -planted] {
        let asked = Asked { scene: &scene, contact: &contact, held, value: &value };
        let numeric = asked.numeric(trial)?;
        let found = trial.closed.equilibria(&contact, &held.control(), &value)?;
        asked.compare(trial, "at n = 1/2", &found, &numeric, [0.0; 2])?;
    }
    Ok(())
}

/// A question.
struct Asked<'a, R> {
    scene: &'a Scene<R>,
    contact: &'a PowerLawContact<R>,
    held: Held,
    value: &'a R,
}

impl<R: Arithmetic> Asked<'_, R> {
    /// The answer of the numerical route.
    fn numeric(&self, trial: &mut Trial<'_>) -> Result<Vec<Equilibrium<R>>> {
        let (transform, material) = (transform(self.scene)?, self.scene.material()?);
        let control: Control<R> = self.held.control();
        let found =
            SearchedBranches::new(Contact::half_space(&transform, &material, &control))?.equilibria(self.value)?;
        trial.demand("at most two equilibria", found.len() <= 2);
        Ok(found)
    }

    /// Both answers. `off` is what x is uncertain by, relative to itself, and ln a beside that.
    fn compare(
        &self,
        trial: &mut Trial<'_>,
        what: &str,
        closed: &[Equilibrium<R>],
        numeric: &[Equilibrium<R>],
        [off_value, off_radius]: [f64; 2],
    ) -> Result<()> {
        let stability = |states: &[Equilibrium<R>]| states.iter().map(|state| state.stability).collect::<Vec<_>>();
        trial.demand(format!("number and stability {what}"), stability(closed) == stability(numeric));
        let transform = transform(self.scene)?;
        let n = self.scene.n.approx();
        for (closed, numeric) in closed.iter().zip(numeric) {
            let a = &numeric.contact_radius;
            let at = Quadratures::at(&transform, n, a)?;
            // Everything on the scale g + Δl, which is 2E*a times larger for a force.
            let (g, elongation) = (self.contact.profile().g(a)?, self.contact.detachment_elongation(a)?);
            let terms = g.clone() + &elongation;
            let stiffness = a.clone() * self.scene.e_star.clone().times(2);
            // Close to the fold the slope is a small difference.
            let half = elongation.over(2);
            let pressed = g * &self.scene.n;
            let [fixed, dead] = [pressed.clone() - &half, pressed - half.times(3)];
            let (scale, slope) = self.held.of([(terms.clone(), fixed), (terms.clone() * &stiffness, dead)]);
            let slope = (slope / &terms).approx();
            // The residual of either route, and x itself.
            let rounded_exponent = (n + 1.0) * a.ln().approx().abs();
            let closed_terms = TRANSFORM + 2.0 * ELONGATION + rounded_exponent + 16.0;
            let numeric_terms = at.g + at.mean + 4.0 * n + rounded_exponent + 16.0;
            let of_value = (off_value + 1.0) * (self.value.clone() / &scale).abs().approx();
            // The fold is so far off that the curvature adds less than once more.
            let radius = 2.0 * (closed_terms + numeric_terms + of_value) / slope.abs() + off_radius + 4.0;
            trial.compare(format!("a {what}"), &closed.contact_radius, a, radius);
            // Moving along the equilibria d changes by ng − Δl/2 and F by 2E*a(ng − 3Δl/2), at fixed x by less.
            let moved = (n.max(1.5) + 3.0) * radius + closed_terms + numeric_terms + of_value;
            trial.compare_on(
                format!("d {what}"),
                &closed.indentation,
                &numeric.indentation,
                &terms,
                moved / n.min(1.0),
            );
            trial.compare_on(format!("F {what}"), &closed.force, &numeric.force, &(terms.clone() * stiffness), moved);
        }
        Ok(())
    }
}
