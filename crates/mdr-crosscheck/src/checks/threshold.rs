//! n = 1/2, where no length is singled out: (1.18), (1.19).

use std::sync::Arc;

use mdr_core::contact::{Control, Material, Result, Shape};
use mdr_core::number::Real;
use mdr_numeric::contact::Contact;
use mdr_numeric::transform::Quadrature;

use super::common::transform;
use crate::arithmetic::Arithmetic;
use crate::grid::{Exponent, Held, Scales, Scene};
use crate::tolerance::{ELONGATION, KAPPA, TRANSFORM, quadrature};
use crate::trial::Trial;

const HALF: Exponent = Exponent::Fraction(1, 2);

/// Whether a contact of radius `a` shrinks at d = 0 or F = 0.
fn shrinks<R: Arithmetic>(c: &R, material: &Material<R>, control: &Control<R>, a: &R) -> Result<bool> {
    let transform = Arc::new(Quadrature::of([Shape::Power { n: c.ratio(1, 2), c: c.clone() }])?);
    Ok(Contact::half_space(&transform, material, control).direction(a, &a.lit(0))? > a.lit(0))
}

/// The C at which the fate of a contact at d = 0 (or F = 0) changes, by bisection on the direction of change (1.8), (1.9)
/// over quadratures, against 2/ϖ·√(2πw/E*) with ϖ = π/agm(1, √2).
pub(super) fn bisection<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let held = Held::BOTH[round % 2];
    let scales = trial.scales::<R>(round, HALF);
    let scene: Scene<R> = trial.planted(HALF, 1.0, scales, ctx);
    trial.describe_also(format_args!("a = {:e}, {held}", scales.radius));
    let (material, control, a) = (scene.material()?, held.control(), R::from_f64(ctx, scales.radius));
    // The planted C is the threshold under fixed grips: it stands between a sixteenth and sixteen times of it.
    let (mut low, mut high) = (scene.c.clone().over(16), scene.c.clone().times(16));
    for _ in 0..scene.c.precision() + 4 {
        let middle = (low.clone() + &high).over(2);
        if shrinks(&middle, &material, &control, &a)? {
            high = middle;
        } else {
            low = middle;
        }
    }
    let found = (low + high).over(2);
    let threshold = trial.closed.threshold(&material, &control)?;
    let transform = Quadrature::of([Shape::Power { n: found.ratio(1, 2), c: found.clone() }])?;
    // g against Δl, or (force) g − Δl against the mean of g, which at the threshold is two thirds of g.
    let (g, mean) = (transform.g_estimate(&a)?, transform.mean_estimate(&a)?);
    let [of_g, of_mean] = [quadrature(&g, 0.5), quadrature(&mean, 0.5)];
    let numeric = held.of([of_g, 3.0 * of_g + 2.0 * of_mean + ELONGATION]);
    trial.compare("C", &found, &threshold, numeric + ELONGATION + 16.0 + agm(&found));
    Ok(())
}

/// Roundings of ϖ: each step of the mean two, which a mean of means does not magnify.
fn agm<R: Real>(like: &R) -> f64 {
    2.0 * f64::from(like.precision()).log2() + 6.0
}

/// States, ratio and fate at n = 1/2, and ϖ = Γ(1/4)²/√(8π).
pub(super) fn states<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let scales = trial.scales::<R>(round, HALF);
    // ρ between 1/4 and 8, both thresholds within.
    let rho = 2_f64.powf(trial.uniform(-2.0, 3.0));
    let scene: Scene<R> = trial.planted(HALF, rho, scales, ctx);
    let Scales { radius, .. } = scales;
    trial.describe_also(format_args!("a = {radius:e}"));
    let (contact, a) = (scene.contact()?, R::from_f64(ctx, radius));

    let guarded = rug::Float::with_val(scene.c.precision() + 32, 0.25).gamma();
    let lemniscate = guarded.clone().square() / (guarded.pi() * 8_u32).sqrt();
    let expected = R::round(ctx, &lemniscate);
    trial.compare("ϖ", &trial.closed.lemniscate_constant(&scene.c)?, &expected, agm(&scene.c) + 1.0);

    let transform = transform(&scene)?;
    let material = scene.material()?;
    let curve = Contact::half_space(&transform, &material, &Control::Indentation);
    let (g, mean) = (transform.g_estimate(&a)?, transform.mean_estimate(&a)?);
    let elongation = curve.detachment_elongation(&a)?;
    let numeric = quadrature(&g, 0.5);
    let ratio = trial.closed.ratio(&contact)?;
    trial.compare("ρ", &ratio, &(g.value.clone() / &elongation), numeric + TRANSFORM + 2.0 * ELONGATION + 2.0);

    let [d, f] = trial.closed.scale_free_state(&contact, &a)?;
    let scale = elongation + &g.value;
    let allowed = numeric + TRANSFORM + 2.0 * ELONGATION + 12.0;
    trial.compare_on("d", &d, &curve.indentation(&a)?, &scale, allowed);
    let scale = scale * &a * scene.e_star.clone().times(2);
    let allowed = allowed + quadrature(&mean, 0.5) + KAPPA;
    trial.compare_on("F", &f, &curve.force(&a)?, &scale, allowed);

    for held in Held::BOTH {
        let control = held.control();
        let fate = trial.closed.fate(&contact, &control)?;
        let expected = if shrinks(&scene.c, &material, &control, &a)? { 1 } else { -1 };
        trial.demand(format!("fate ({held})"), fate == fate.lit(expected));
    }
    Ok(())
}
