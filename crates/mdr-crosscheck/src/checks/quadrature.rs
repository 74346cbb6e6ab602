//! The MDR transform (1.1) by quadrature of the profile alone, against its closed form (1.12).

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Result, Shape};
use mdr_numeric::transform::Quadrature;

use super::folds::transform;
use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::tolerance::{KAPPA, TRANSFORM, quadrature};
use crate::trial::Trial;

/// κ_n as the ratio of the quadrature to the profile.
pub(super) const KAPPA_RATIO: Run = ("kappa-quadrature", |trial| by_turns!(trial, kappa));

/// g, g' and G = ∫₀ˣ g over many decades of x and C.
pub(super) const POWER: Run = ("transform-quadrature", |trial| by_turns!(trial, power));

fn kappa<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family::up_to(50));
    let n: R = exponent.value(ctx);
    trial.describe(format_args!("n = {exponent} ({})", R::NAME));
    let one = n.lit(1);
    let transform = Quadrature::of([Shape::Power { n: n.clone(), c: one.clone() }])?.g_estimate(&one)?;
    let found = trial.closed.kappa(&n)?;
    let allowed = quadrature(&transform, n.approx()) + KAPPA;
    trial.compare("κ", &found, &transform.value, allowed);
    Ok(())
}

fn power<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family::up_to(50));
    let scales = trial.scales::<R>(round, exponent);
    let scene: Scene<R> = trial.planted(exponent, 1.0, scales, ctx);
    let x = R::from_f64(ctx, scales.radius);
    trial.describe_also(format_args!("x = {:e}", scales.radius));
    let contact = scene.contact()?;
    let transform = transform(&scene)?;
    let n = scene.n.approx();
    let rounded_exponent = (n + 1.0) * scales.radius.ln().abs();
    let forms = trial.closed;
    let mut compare = |name, closed: R, numeric: Estimate<R>, rounded: f64| {
        let allowed = quadrature(&numeric, n) + TRANSFORM + 2.0 + rounded;
        trial.compare(name, &closed, &numeric.value, allowed);
    };
    let mean = forms.integral(contact.profile(), &x)? / &x;
    compare("g", forms.g(contact.profile(), &x)?, transform.g_estimate(&x)?, 0.0);
    compare("g'", forms.slope(contact.profile(), &x)?, transform.slope_estimate(&x)?, rounded_exponent);
    compare("∫g/x", mean, transform.mean_estimate(&x)?, rounded_exponent);
    Ok(())
}
