//! The MDR transform (1.1) by quadrature of the profile alone, against its closed form (1.12), and the one-parameter family of
//! universal curves against states by such quadratures.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Result, Shape};
use mdr_numeric::contact::Contact;
use mdr_numeric::transform::Quadrature;

use super::common::transform;
use crate::arithmetic::Arithmetic;
use crate::grid::{Family, Scene};
use crate::tolerance::{ELONGATION, KAPPA, TRANSFORM, quadrature};
use crate::trial::Trial;

/// κ_n as the ratio of the quadrature to the profile.
pub(super) fn kappa<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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

/// g, g' and G = ∫₀ˣ g over many decades of x and C.
pub(super) fn power<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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

/// d/|d_c| and F/|F_c| at ã = a/a_c against the states (1.5), (1.6) by quadrature at a = ã a_c.
///
/// With a_c off by δ the term g is off by (n−½)δ of itself against the others: ½|2n−1|·δ, where δ is magnified by
/// 1/|2n−1|.
pub(super) fn curves<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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
    let curve = Contact::half_space(&transform, &material, &Control::Indentation);
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
