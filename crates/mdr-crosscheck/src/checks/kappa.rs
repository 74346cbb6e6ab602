//! κ_n of (1.12) by other roads: Γ, a positive series, the arithmetic-geometric mean, and a functional equation.

use mdr_core::contact::Result;
use mdr_core::number::{Interval, Real};
use rug::Float;

use super::{Run, by_turns};
use crate::arithmetic::Arithmetic;
use crate::derivations::hypergeometric;
use crate::grid::{Exponent, Family};
use crate::tolerance::{KAPPA, ROUNDED};
use crate::trial::Trial;

/// κ_n = √π Γ(1+n/2)/Γ((n+1)/2), by the Γ of MPFR.
pub(super) const GAMMA: Run = ("kappa-gamma", |trial| by_turns!(trial, against, by_gamma));

/// κ_n = ₂F₁(1, n; 1+n/2; 1/2) = Σ_k Π_{j<k} (n+j)/(n+2+2j), Gauss's second theorem.
pub(super) const SERIES: Run = ("kappa-series", |trial| by_turns!(trial, against, middle_of_series));

/// κ_{1/2} and κ_{1/3} by the arithmetic-geometric mean, carried up by κ_{n+2} = κ_n (n+2)/(n+1).
pub(super) const AGM: Run = ("kappa-agm", |trial| by_turns!(trial, agm));

/// κ_n κ_{n+1} = π(n+1)/2. The rounding of n + 1 counts half: ∂ln κ/∂ln n ≤ 1/2.
pub(super) const PRODUCT: Run = ("kappa-product", |trial| by_turns!(trial, product));

/// All of the grid, up to 1/2 ± 2⁻⁵⁰.
const FAMILY: Family = Family::up_to(50);

fn against<R: Arithmetic>(
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

/// With 64 guard bits and as many as the logarithms of Γ lose by their size (below n ln n < 2¹³).
pub(crate) fn by_gamma(n: &Float) -> Float {
    let n = Float::with_val(n.prec() + 64 + 16, n);
    let half = n.ratio(1, 2);
    let quotient = (half.clone() * &n + 1_u32).ln_gamma() - (half.clone() * &n + &half).ln_gamma();
    (quotient + n.pi().ln() * half).exp()
}

/// By Gauss's second theorem (DLMF 15.4.28), enclosed.
pub(crate) fn by_series(n: &Interval) -> Interval {
    hypergeometric(n, &(n.clone().over(2) + n.lit(1)))
}

/// 64 guard bits carry the sum.
fn middle_of_series(n: &Float) -> Float {
    by_series(&Interval::point(Float::with_val(n.prec() + 64, n))).mid()
}

fn agm<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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

fn product<R: Arithmetic>(trial: &mut Trial<'_>, round: usize, ctx: R::Ctx) -> Result<()> {
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
