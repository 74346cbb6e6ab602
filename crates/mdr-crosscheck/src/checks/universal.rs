//! The one-parameter family of universal curves.

use mdr_core::contact::{Control, Result};
use mdr_numeric::curve::Curve;

use super::folds::transform;
use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::tolerance::{ELONGATION, quadrature};
use crate::trial::Trial;

/// d/|d_c| and F/|F_c| at ã = a/a_c against the states (1.5), (1.6) by quadrature at a = ã a_c.
///
/// With a_c off by δ the term g is off by (n−½)δ of itself against the others: ½|2n−1|·δ, where δ is magnified by
/// 1/|2n−1|.
pub(super) const CURVES: Run = ("universal-curves", |trial| by_turns!(trial, curves));

fn curves<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, Family::up_to(50));
    let scene: Scene<R> = trial.scene(round, exponent, 1.0, ctx);
    let contact = scene.contact()?;
    let stretch = trial.uniform(-1.0, 1.0);
    trial.describe_also(format_args!("a/a_c = exp({stretch:e}/(n+1))"));
    let scaled = (R::from_f64(ctx, stretch) / (scene.n.clone() + scene.n.lit(1))).exp();
    let critical = trial.closed.critical(&contact, &Control::Indentation)?;
    let a = scaled.clone() * &critical.contact_radius;

    let transform = transform(&scene)?;
    let material = scene.material()?;
    let curve = Curve::new(&transform, &material, &Control::Indentation);
    let (g, mean) = (transform.g_estimate(&a)?, transform.mean_estimate(&a)?);
    let elongation = curve.detachment_elongation(&a)?;
    let tangent = scene.tangent(1.0, &critical.contact_radius);
    let shifted = 0.5 * tangent.excess() * tangent.radius();

    let d = trial.closed.universal_indentation(&scene.n, &scaled)? * critical.indentation.abs();
    let allowed = shifted + quadrature(&g, tangent.n) + 3.0 * ELONGATION + 16.0;
    trial.compare_on("d", &d, &curve.indentation(&a)?, &(elongation.clone() + &g.value), allowed);
    let f = trial.closed.universal_force(&scene.n, &scaled)? * critical.force.abs();
    let scale = (elongation + &g.value) * &a * scene.e_star.clone().times(2);
    let allowed = allowed + shifted + quadrature(&mean, tangent.n) + 16.0;
    trial.compare_on("F", &f, &curve.force(&a)?, &scale, allowed);
    Ok(())
}
