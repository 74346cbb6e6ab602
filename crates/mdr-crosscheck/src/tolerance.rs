//! What a case is allowed to err: derived from the two routes and the question, never from what was found.
//!
//! **Unit.** All bounds here are in unit roundoffs u = 2^−p of the arithmetic of the case.
//!
//! **Model.** A route that does k roundings, each of relative size at most u, is exact for inputs changed by at most k·u
//! (to first order: k·u ≪ 1). Its result then errs by k·u times the condition of the result with respect to those
//! inputs. Two routes may differ by the sum of both bounds. The numbers of roundings below are counted in the formulas
//! and stated with them; the conditions are derivatives of the closed forms.
//!
//! **Conditions of a power-law contact.** With q = λ²B/N² (B = πw/(2E*), N = nκ_nC, λ = 1 for fixed grips, 3 for a dead
//! load) the critical radius is a = q^{1/(2n−1)}:
//!
//! * ∂ln a/∂ln q = 1/(2n−1): roundings in q, so in every input, are magnified without limit towards n = 1/2;
//! * the quotient ln q/(2n−1) is itself rounded, twice: 2u·|ln a|, which is what a power costs over many decades;
//! * d and F along the equilibria: ∂d/∂ln a = a d'(a) = ½Δl(λ−1) and ∂F/∂ln a = 2E*a·½Δl(λ−3) at the tangency λ, so a
//!   radius error does not reach the controlled quantity at its own fold;
//! * d = g − Δl and F = 2E*a(d − mean g) cancel: they err by k·u of the *terms*, and are compared on the scale of the
//!   terms, Δl and 2E*aΔl. d_F = 0 at n = 3/2 needs no exception that way.
//! * beside a fold, at relative distance ε of the controlled quantity, a − a_fold ~ √ε: an error δ of the controlled
//!   quantity moves a by δ/√ε, half of the digits are lost in the inverse problem.

/// Roundings of κ_n as f64: at most seven a term in a series whose mean index is below 3, then its sum; the continued
/// fraction for large n halves what its few steps bring in, by the square root.
pub(crate) const KAPPA: f64 = 32.0;

/// Roundings of a reference computed with guard digits and rounded once.
pub(crate) const ROUNDED: f64 = 1.0;

/// Roundings in q = λ²B/N² and its logarithm beside those of κ², which enter twice: π, π·w, 2E*, the quotient, λ²,
/// nκ, nκC, its square (twice), the quotient, the logarithm.
pub(crate) const QUOTIENT: f64 = 12.0 + 2.0 * KAPPA;

/// Error of ln a of a critical radius by closed form, in u.
pub(crate) fn critical_radius(n: f64, ln_a: f64) -> f64 {
    QUOTIENT / (2.0 * n - 1.0).abs() + 2.0 * ln_a.abs() + 2.0
}
