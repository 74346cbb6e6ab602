//! Results that were known before the theory: the modulus of two bodies (1.3), Johnson, Kendall and Roberts (1971), Kendall
//! (1971).

use mdr_core::contact::{Body, Control, Material, Result};
use mdr_core::number::Real;
use rug::{Float, Rational};

use super::common::rational;
use crate::arithmetic::Arithmetic;
use crate::grid::{Held, Scene};
use crate::trial::Trial;

const ROUNDINGS: f64 = 7.0;

/// 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂ in floating point against exact rational arithmetic.
///
/// Seven roundings a path at most: 1−ν, 1+ν, their product, the quotient, the sum of positive terms, the reciprocal.
pub(super) fn effective_modulus(trial: &mut Trial<'_>) -> Result<()> {
    let mut body = || (10_f64.powf(trial.uniform(-30.0, 30.0)), trial.uniform(-1.0, 0.5));
    let bodies = [body(), body()];
    trial.describe(format_args!("E, ν = {bodies:?}"));
    let [first, second] = bodies.map(|(e, nu)| {
        let (e, nu) = (rational(e), rational(nu));
        (1 - nu.square()) / e
    });
    let exact = Rational::from(&first + &second).recip();
    in_either_order::<f64>(trial, (), bodies, &exact.to_f64())?;
    let precision = trial.precision;
    in_either_order(trial, precision, bodies, &Float::with_val(precision.bits(), exact))
}

fn in_either_order<R: Real>(trial: &mut Trial<'_>, ctx: R::Ctx, bodies: [(f64, f64); 2], exact: &R) -> Result<()> {
    let body = |(e, nu)| Body::new(R::from_f64(ctx, e), R::from_f64(ctx, nu));
    let [first, second] = bodies.map(body);
    let (first, second) = (first?, second?);
    let e_star = |a, b| Material::from_bodies(a, b, R::from_int(ctx, 1)).map(|m| m.effective_modulus().clone());
    let found = e_star(&first, &second)?;
    trial.compare("E*", &found, exact, ROUNDINGS);
    trial.demand("E* does not depend on the order of the bodies", found == e_star(&second, &first)?);
    Ok(())
}

/// A flat cylinder of radius b: −√(2πwb/E*) and −√(8πE*wb³).
pub(super) fn punch<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let [radius, e_star, work] = decades::<R>(trial, ctx);
    let [r, e, w] = [&radius, &e_star, &work].map(R::approx);
    trial.describe(format_args!("b = {r:e}, E* = {e:e}, w = {w:e} ({})", R::NAME));
    let [d, f] = trial.closed.flat_punch_pull_off(&radius, &Material::new(e_star.clone(), work.clone())?)?;
    let depth = -(work.pi() * &work * &radius / &e_star).times(2).sqrt();
    let force = -(radius.powi(3) * work.pi() * &e_star * &work).times(8).sqrt();
    // Five roundings under each root, the root, and two factors.
    trial.compare("d", &d, &depth, 10.0);
    trial.compare("F", &f, &force, 14.0);
    Ok(())
}

/// Lengths and materials over many decades.
fn decades<R: Real>(trial: &mut Trial<'_>, ctx: R::Ctx) -> [R; 3] {
    [(); 3].map(|()| R::from_f64(ctx, 10_f64.powf(trial.uniform(-30.0, 30.0))))
}

/// The paraboloid r²/2R: F = −(5/6)πwR and a³ = πwR²/(8E*) under fixed grips, F = −(3/2)πwR and nine times that a³
/// under a dead load.
pub(super) fn jkr<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let held = Held::BOTH[round % 2];
    let [radius, e_star, work] = decades::<R>(trial, ctx);
    let [r, e, w] = [&radius, &e_star, &work].map(R::approx);
    trial.describe(format_args!("R = {r:e}, E* = {e:e}, w = {w:e} ({})", R::NAME));
    let scene = Scene { n: radius.lit(2), c: radius.clone().times(2).inv(), e_star, work };
    let state = trial.closed.critical(&scene.contact()?, &held.control())?;
    let tangent = scene.tangent(held.lambda(), &state.contact_radius);

    let pull = radius.pi() * &scene.work * &radius;
    let force = held.of([pull.clone().times(-5).over(6), pull.clone().times(-3).over(2)]);
    // C is rounded: once more in q, squared.
    let allowed = tangent.radius() + 2.0 / tangent.excess();
    trial.compare(format!("F ({held})"), &state.force, &force, 1.5 * allowed + 24.0);
    let cube = pull * &radius * &R::from_f64(ctx, held.lambda()).square() / scene.e_star.clone().times(8);
    trial.compare(format!("a³ ({held})"), &state.contact_radius.powi(3), &cube, 3.0 * allowed + 8.0);
    // d = a²/R − √(2πwa/E*) is −3a²/R at fixed grips and −a²/(3R) at a dead load: √(2πwa/E*) = 4a²/R, 4a²/3R.
    let square = state.contact_radius.square() / &radius;
    let depth = held.of([square.clone().times(-3), square.over(-3)]);
    trial.compare(format!("d ({held})"), &state.indentation, &depth, 1.5 * allowed + 24.0);
    Ok(())
}

/// n → ∞ with C = R^{1−n}: Kendall's flat punch, F → −√(8πR³E*w).
///
/// From κ_nκ_{n+1} = π(n+1)/2 and κ growing: πn/2 < κ_n² < π(n+1)/2. Hence the logarithm of the ratio is
/// ln((2n−1)/(2n+2)) + 3/(4n−2)·ln(18B/(πRn²√(n(n+1)))) within ±3/(8n−4)·ln(1+1/n): the rate, and how far it is known.
pub(super) fn kendall<R: Arithmetic>(trial: &mut Trial<'_>, _round: usize, ctx: R::Ctx) -> Result<()> {
    let n = 10_f64.powf(trial.uniform(1.0, if R::NAME == "f64" { 2.0 } else { 6.0 }));
    let decades = if R::NAME == "f64" { 60.0 / n } else { 30.0 };
    let radius = R::from_f64(ctx, 10_f64.powf(trial.uniform(-decades, decades)));
    let (e_star, ratio) = (trial.uniform(-30.0, 30.0), trial.uniform(-6.0, 6.0));
    let e_star = R::from_f64(ctx, 10_f64.powf(e_star));
    let work = R::from_f64(ctx, 10_f64.powf(ratio)) * &e_star * &radius;
    let n = R::from_f64(ctx, n);
    let [p, r, e, w] = [&n, &radius, &e_star, &work].map(R::approx);
    trial.describe(format_args!("n = {p:e}, R = {r:e}, E* = {e:e}, w = {w:e} ({})", R::NAME));
    let one = n.lit(1);
    let scene = Scene { c: radius.pow(&(one.clone() - &n)), n, e_star, work };
    let n = &scene.n;
    let found = trial.closed.critical(&scene.contact()?, &Control::Force)?;
    let flat = -(radius.powi(3) * radius.pi() * &scene.e_star * &scene.work).times(8).sqrt();
    let limit = trial.closed.flat_punch_limit(&scene.contact()?)?;
    // C⁻^{1/n} = R^{1−1/n}; the power in C, its logarithm and the quotient are rounded.
    let limit_error = ((limit / &radius).ln() + radius.ln() / n).abs().approx();
    let ln_radius = radius.ln().approx().abs();
    trial.enter("ln b/R", limit_error, radius.unit_roundoff().approx() * (6.0 * ln_radius + 8.0));

    let excess = n.clone().times(2) - &one;
    let edge = radius.pi() * &scene.work / &scene.e_star / &radius;
    let next = one.clone() + n;
    let scale = edge.times(9) / (n.square() * (next.clone() * n).sqrt() * radius.pi());
    let predicted = (excess.clone() / next.times(2)).ln() + (scale.ln() / &excess).times(3).over(2);
    let error = ((found.force / flat).ln() - predicted).abs().approx();

    let (n, u) = (n.approx(), radius.unit_roundoff().approx());
    let rate = 0.75 / (2.0 * n - 1.0) * (1.0 / n).ln_1p();
    // The power in C has a rounded exponent and C enters squared.
    let power = 2.0 * n * radius.ln().approx().abs() / (2.0 * n - 1.0);
    let tangent = scene.tangent(3.0, &found.contact_radius);
    trial.enter("ln F_F/F_Kendall", error, rate + u * (1.5 * (tangent.radius() + power + 8.0) + 24.0));
    Ok(())
}
