//! The effective modulus of two bodies (1.3).

use mdr_core::contact::{Body, Material, Result};
use mdr_core::number::Real;
use rug::{Float, Rational};

use super::Run;
use super::certified::rational;
use crate::trial::Trial;

/// 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂ in floating point against exact rational arithmetic.
///
/// Seven roundings a path at most: 1−ν, 1+ν, their product, the quotient, the sum of positive terms, the reciprocal.
pub(super) const BODIES: Run = ("effective-modulus", case);

const ROUNDINGS: f64 = 7.0;

fn case(trial: &mut Trial<'_>) -> Result<()> {
    let mut body = || (10_f64.powf(trial.uniform(-30.0, 30.0)), trial.uniform(-1.0, 0.5));
    let bodies = [body(), body()];
    trial.describe(format_args!("E, ν = {bodies:?}"));
    let [first, second] = bodies.map(|(e, nu)| {
        let (e, nu) = (rational(e), rational(nu));
        (1 - nu.square()) / e
    });
    let exact = Rational::from(&first + &second).recip();
    compare::<f64>(trial, (), bodies, &exact.to_f64())?;
    let precision = trial.precision;
    compare(trial, precision, bodies, &Float::with_val(precision.bits(), exact))
}

fn compare<R: Real>(trial: &mut Trial<'_>, ctx: R::Ctx, bodies: [(f64, f64); 2], exact: &R) -> Result<()> {
    let body = |(e, nu)| Body::new(R::from_f64(ctx, e), R::from_f64(ctx, nu));
    let [first, second] = bodies.map(body);
    let (first, second) = (first?, second?);
    let e_star = |a, b| Material::from_bodies(a, b, R::from_int(ctx, 1)).map(|m| m.effective_modulus().clone());
    let found = e_star(&first, &second)?;
    trial.compare("E*", &found, exact, ROUNDINGS);
    trial.demand("E* does not depend on the order of the bodies", found == e_star(&second, &first)?);
    Ok(())
}
