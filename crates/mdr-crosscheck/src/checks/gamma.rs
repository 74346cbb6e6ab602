//! Γ, on which κ_n rests in (1.12), from two independent libraries.

use mdr_core::contact::Result;
use mdr_core::number::{Gamma, Real};
use rug::Float;

use super::Check;
use crate::report::Unit;
use crate::trial::Trial;

/// The worst error of the Γ of statrs on (0.01, 50), in ulp, as published for its Lanczos sum.
const STATRS_ULP: f64 = 2708.0;

/// Γ(x) on the arguments of (1.12): MPFR against statrs at its own accuracy, and against pxfm at one ulp.
pub(super) const LIBRARIES: Check = Check {
    name: "gamma-libraries",
    claim: "Γ of MPFR against statrs (2708 ulp) and pxfm (1 ulp)",
    equations: &["1.12"],
    subjects: &[],
    unit: Unit::Ulp,
    cases: [400, 4000, 40_000],
    case,
};

fn case(trial: &mut Trial<'_>) -> Result<()> {
    let x = trial.uniform(0.01_f64.ln(), 50.0_f64.ln()).exp();
    trial.describe(format_args!("x = {x:e}"));
    let exact = Float::with_val(128, x).gamma();
    trial.enter("Γ (statrs)", ulps(statrs::function::gamma::gamma(x), &exact), STATRS_ULP);
    trial.enter("Γ (pxfm)", ulps(Gamma::gamma(&x), &exact), 1.0);
    Ok(())
}

/// The error of a double in units in the last place of the correctly rounded `exact`.
pub(crate) fn ulps(found: f64, exact: &Float) -> f64 {
    let nearest = exact.to_f64();
    let spacing = nearest.abs().next_up() - nearest.abs();
    (Float::with_val(exact.prec(), found) - exact).abs().approx() / spacing
}
