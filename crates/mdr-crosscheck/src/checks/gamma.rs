//! Γ, on which κ_n rests in (1.12), from two independent libraries.

use mdr_core::contact::Result;
use mdr_core::number::Gamma;
use rug::Float;

use super::Run;
use crate::trial::{Trial, ulps};

/// The worst error of the Γ of statrs on (0.01, 50), in ulp, as published for its Lanczos sum.
const STATRS_ULP: f64 = 2708.0;

/// Γ(x) on the arguments of (1.12): MPFR against statrs at its own accuracy, and against pxfm at one ulp.
pub(super) const LIBRARIES: Run = ("gamma-libraries", case);

fn case(trial: &mut Trial<'_>) -> Result<()> {
    let x = trial.uniform(0.01_f64.ln(), 50.0_f64.ln()).exp();
    trial.describe(format_args!("x = {x:e}"));
    let exact = Float::with_val(128, x).gamma();
    trial.enter("Γ (statrs)", ulps(statrs::function::gamma::gamma(x), &exact), STATRS_ULP);
    trial.enter("Γ (pxfm)", ulps(Gamma::gamma(&x), &exact), 1.0);
    Ok(())
}
