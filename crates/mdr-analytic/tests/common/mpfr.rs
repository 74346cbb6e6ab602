//! κ_n and errors over MPFR, in the precision of the arguments.

use rug::Float;
use rug::float::Constant;

/// ln κ_n from two logarithms of Γ; for n = 10¹⁶ they cancel 60 bits.
pub(crate) fn ln_kappa(n: &Float) -> Float {
    let half = Float::with_val(n.prec(), n / 2u32);
    let ln_root_pi = Float::with_val(n.prec(), Constant::Pi).ln() / 2u32;
    ln_root_pi + (half.clone() + 1u32).ln_gamma() - (half + 0.5f64).ln_gamma()
}

/// The error in units in the last place of the truth.
pub(crate) fn ulps(found: f64, truth: &Float) -> f64 {
    let exponent = truth.get_exp().unwrap_or(-5000).max(-1021);
    let found = Float::with_val(truth.prec(), found);
    ((found - truth) / (Float::with_val(truth.prec(), 1) << (exponent - 53))).abs().to_f64()
}
