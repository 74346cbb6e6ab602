//! κ_n of (1.12) by other roads: Γ, a positive series, the arithmetic-geometric mean, and a functional equation; and Γ, on
//! which it rests, from two independent libraries.

use mdr_core::contact::Result;
use mdr_core::number::{Gamma, Interval, Real};
use rug::Float;

use crate::arithmetic::Arithmetic;
use crate::derivations::hypergeometric;
use crate::grid::{Exponent, Family};
use crate::tolerance::{KAPPA, ROUNDED};
use crate::trial::{Trial, ulps};

/// The worst error of the Γ of statrs on (0.01, 50), in ulp, as published for its Lanczos sum.
const STATRS_ULP: f64 = 2708.0;

/// Γ(x) on the arguments of (1.12): MPFR against statrs at its own accuracy, and against pxfm at one ulp.
pub(super) fn libraries(trial: &mut Trial<'_>) -> Result<()> {
    let x = trial.uniform(0.01_f64.ln(), 50.0_f64.ln()).exp();
    trial.describe(format_args!("x = {x:e}"));
    let exact = Float::with_val(128, x).gamma();
    trial.enter("Γ (statrs)", ulps(statrs::function::gamma::gamma(x), &exact), STATRS_ULP);
    trial.enter("Γ (pxfm)", ulps(Gamma::gamma(&x), &exact), 1.0);
    Ok(())
}

/// All of the grid, up to 1/2 ± 2⁻⁵⁰.
const FAMILY: Family = Family::up_to(50);

/// κ_n against another road.
pub(super) fn against<R: Arithmetic>(
    trial: &mut Trial<'_>,
    round: usize,
    ctx: R::Ctx,
    reference: fn(&Float) -> Float,
) -> Result<()> {
    let exponent = trial.exponent(round, FAMILY);
    let n: R = exponent.value(ctx);
    trial.describe(format_args!("n = {exponent} ({})", R::NAME));
    let found = trial.closed.kappa(&n)?;
    let expected = R::round(ctx, &reference(&n.widen()));
    trial.compare("κ", &found, &expected, KAPPA + ROUNDED);
    Ok(())
}

/// κ_n = √π Γ(1+n/2)/Γ((n+1)/2), by the Γ of MPFR: with 64 guard bits and as many as the logarithms of Γ lose by their size (below n ln n < 2¹³).
pub(crate) fn by_gamma(n: &Float) -> Float {
    ln_kappa(&Float::with_val(n.prec() + 64 + 16, n)).exp()
}

/// ln κ_n = ln Γ(1+n/2) − ln Γ((n+1)/2) + ½ ln π, by the ln Γ of MPFR.
pub(crate) fn ln_kappa<R: Gamma>(n: &R) -> R {
    let half = n.clone().over(2);
    (half.clone() + n.lit(1)).ln_gamma() - (half + n.ratio(1, 2)).ln_gamma() + n.pi().ln().over(2)
}

/// κ_n = ₂F₁(1, n; 1+n/2; 1/2) = Σ_k Π_{j<k} (n+j)/(n+2+2j), Gauss's second theorem (DLMF 15.4.28), enclosed.
pub(crate) fn by_series(n: &Interval) -> Interval {
    hypergeometric(n, &(n.clone().over(2) + n.lit(1)))
}

/// 64 guard bits carry the sum.
pub(super) fn middle_of_series(n: &Float) -> Float {
    by_series(&Interval::point(Float::with_val(n.prec() + 64, n))).mid()
}

/// κ_{1/2} and κ_{1/3} by the arithmetic-geometric mean, carried up by κ_{n+2} = κ_n (n+2)/(n+1).
pub(super) fn agm<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let one = Float::with_val(R::from_int(ctx, 1).precision() + 64, 1);
    let (tip, climb) = ([(1, 2), (1, 3)][round % 2], (round / 2) as i64);
    let first = if tip == (1, 2) {
        one.pi().over(2) / one.clone().agm(&Real::sqrt(&one.lit(2)))
    } else {
        let modulus = ((one.lit(3).sqrt() + 2_u32) / 4_u32).sqrt();
        let scale = one.lit(3).pow(&one.ratio(3, 4)).over(3);
        scale * one.pi().over(2) / one.clone().agm(&modulus)
    };
    let (p, q) = tip;
    let step = |kappa: Float, j: i64| kappa.times(p + (2 * j + 2) * q).over(p + (2 * j + 1) * q);
    let expected = (0..climb).fold(first, step);
    let exponent = Exponent::Fraction(p + 2 * climb * q, q);
    trial.describe(format_args!("n = {exponent} ({})", R::NAME));
    let found = trial.closed.kappa(&exponent.value::<R>(ctx))?;
    // A third is rounded once, with condition at most 1/2.
    trial.compare("κ", &found, &R::round(ctx, &expected), KAPPA + ROUNDED + 0.5);
    Ok(())
}

/// κ_n κ_{n+1} = π(n+1)/2. The rounding of n + 1 counts half: ∂ln κ/∂ln n ≤ 1/2.
pub(super) fn product<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
    let exponent = trial.exponent(round, FAMILY);
    let n: R = exponent.value(ctx);
    trial.describe(format_args!("n = {exponent} ({})", R::NAME));
    let next = n.lit(1) + &n;
    let found = trial.closed.kappa(&n)? * trial.closed.kappa(&next)?;
    let expected = (next * n.pi()).over(2);
    // The roundings of n + 1 on both sides, of π, and of the three products.
    trial.compare("κκ", &found, &expected, 2.0 * KAPPA + 1.5 + 1.0 + 3.0);
    Ok(())
}
