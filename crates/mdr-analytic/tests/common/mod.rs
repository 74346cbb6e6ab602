//! Helpers of several tests.
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]

#[cfg(feature = "mp")]
pub(crate) mod mpfr;

use mdr_analytic::{PowerLaw, PowerLawContact, double};
use mdr_core::contact::Material;

pub(crate) fn contact(n: f64, c: f64, e_star: f64, work: f64) -> PowerLawContact<f64> {
    PowerLawContact::new(PowerLaw::new(n, c).unwrap(), Material::new(e_star, work).unwrap())
}

/// C for which the radius of the fold is about `a`: `tension` is 1 under fixed grips and 3 under a dead load.
pub(crate) fn coefficient_for(a: f64, n: f64, e: f64, w: f64, critical_ratio: f64) -> f64 {
    let ln_edge = (std::f64::consts::PI * w / (2.0 * e)).ln() / 2.0;
    (ln_edge + (0.5 - n) * a.ln() + (critical_ratio / (n * double::kappa(n).unwrap())).ln()).exp()
}
