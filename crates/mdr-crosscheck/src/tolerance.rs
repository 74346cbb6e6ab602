//! The allowed error of a case: derived from the two routes and the question, never from the results.
//!
//! **Unit.** All bounds here are in unit roundoffs u = 2^−p of the arithmetic of the case.
//!
//! **Model.** A route that does k roundings, each of relative size at most u, is exact for inputs changed by at most k·u
//! (to first order: k·u ≪ 1). Its result then errs by k·u times the condition of the result with respect to those
//! inputs. Two routes may differ by the sum of both bounds. The numbers of roundings below are counted in the formulas
//! and stated with them; the conditions are derivatives of the closed forms.
//!
//! **Conditions of a power-law contact.** A state where g' = λ√(B/a) (B = πw/(2E*); λ = 1 is the critical state under
//! fixed grips, 3 under a dead load) has a = q^{1/(2n−1)}, q = λ²B/N², N = nκ_nC. So
//!
//! * ∂ln a/∂ln q = 1/(2n−1): roundings in q, so in every input, are magnified without limit towards n = 1/2;
//! * the quotient ln q/(2n−1) is itself rounded, twice: 2u·|ln a|, which is what a power costs over many decades;
//! * g = λΔl/2n there, ∂d/∂ln a = ½(λ−1)Δl and ∂F/∂ln a = ½(λ−3)·2E*aΔl: a radius error does not reach the controlled
//!   quantity at its own fold;
//! * d = g − Δl and F = 2E*a(d − mean g) cancel. They are compared on the scale of their terms, Δl and 2E*aΔl, where
//!   they are as good as the terms; d_F = 0 at n = 3/2 needs no exception that way.

use mdr_core::calculus::Estimate;
use mdr_core::number::Real;

/// Roundings of κ_n: both arithmetics compute it with digits to spare and round once, f64 to 0.51 ulp.
pub(crate) const KAPPA: f64 = 1.1;

/// Roundings of a reference computed with guard digits and rounded once.
pub(crate) const ROUNDED: f64 = 1.0;

/// Roundings in ln q beside κ², which enters it twice: π, π·w, B, λ²B, nκ, nκC, its square (twice), q, ln q.
const QUOTIENT: f64 = 10.0 + 2.0 * KAPPA;

/// Roundings of g by closed form: κ, xⁿ, the two products, and the value of x.
pub(crate) const TRANSFORM: f64 = KAPPA + 4.0;

/// Roundings of Δl and of √(Ba) by closed form: B (three), the product, the root, the factor.
pub(crate) const ELONGATION: f64 = 6.0;

/// A state along the equilibria of a power law, with what its conditions depend on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tangent {
    /// n.
    pub(crate) n: f64,
    /// λ.
    pub(crate) lambda: f64,
    /// ln a, with a in m.
    pub(crate) ln_a: f64,
}

impl Tangent {
    /// |2n − 1|.
    pub(crate) fn excess(self) -> f64 {
        (2.0 * self.n - 1.0).abs()
    }

    /// Error of ln a, where a is a closed form.
    pub(crate) fn radius(self) -> f64 {
        QUOTIENT / self.excess() + 2.0 * self.ln_a.abs() + 2.0
    }

    /// g(a)/Δl(a) = λ/2n.
    pub(crate) fn transform(self) -> f64 {
        self.lambda / (2.0 * self.n)
    }

    /// mean of g over Δl(a) = λ/(2n(n+1)), and g − mean = λ/(2(n+1)) of Δl.
    pub(crate) fn pressed(self) -> f64 {
        self.lambda / (2.0 * (self.n + 1.0))
    }

    /// Errors of d as a tangent state against g − Δl at the same a, on the scale Δl, the tangency being exact.
    pub(crate) fn indentation_terms(self) -> f64 {
        let factors = 4.0;
        self.transform() * (TRANSFORM + 1.0) + (1.0 + self.transform()) * (factors + ELONGATION) + ELONGATION + 1.0
    }

    /// d of a critical state against (1.13) at the same closed-form a, on the scale Δl.
    ///
    /// With a off by δ they differ by [½(λ−1) − ½(λ/2n − 1)]δ = λ(2n−1)/4n·δ: what 1/(2n−1) magnified is taken back.
    pub(crate) fn indentation_at_radius(self) -> f64 {
        self.lambda * self.excess() / (4.0 * self.n) * self.radius() + self.indentation_terms()
    }

    /// Errors of F as a tangent state against (1.16) at the same a, on the scale 2E*aΔl, the tangency being exact.
    pub(crate) fn force_terms(self) -> f64 {
        let factors = 7.0;
        self.pressed() * (TRANSFORM + 4.0) + (1.0 + self.pressed()) * (factors + ELONGATION) + ELONGATION + 3.0
    }

    /// F of a critical state against (1.16) at the same closed-form a, on the scale 2E*aΔl: λ(2n−1)/4(n+1)·δ.
    pub(crate) fn force_at_radius(self) -> f64 {
        self.lambda * self.excess() / (4.0 * (self.n + 1.0)) * self.radius() + self.force_terms()
    }

    /// Errors of g'(a) and λ√(B/a), on the scale √(B/a). The exponent n − 1 is rounded.
    pub(crate) fn slope_terms(self) -> f64 {
        let exponent = (self.n - 1.0).abs() * self.ln_a.abs();
        self.lambda * (TRANSFORM + 1.0 + exponent) + ELONGATION + 2.0
    }

    /// g' against λ√(B/a) at a closed-form critical a, on the scale √(B/a): λ(n−½)δ.
    pub(crate) fn slope_at_radius(self) -> f64 {
        self.lambda * self.excess() / 2.0 * self.radius() + self.slope_terms()
    }

    /// Π of a critical state by closed form, against another closed form of it, on the scale πa²w (E*aΔl² is twice that).
    ///
    /// Π/E*a = (d − mean)² + n²mean²/(2n+1) − …, mean = g/(n+1); an error of g, from κ or from the tangency λ at which
    /// the radius is not quite, enters both terms with twice their derivative.
    pub(crate) fn energy(self) -> f64 {
        let mean = self.transform() / (self.n + 1.0);
        let spread = (self.n * mean).powi(2) / (2.0 * self.n + 1.0);
        let by_transform = 4.0 * (self.pressed() - 1.0).abs() * self.transform() + 4.0 * spread;
        let tangency = 0.5 * self.excess() * self.radius();
        by_transform * (TRANSFORM + ELONGATION + 8.0 + tangency) + 30.0 * (1.0 + spread)
    }

    /// Error of ln a of a fold found by quadrature: the tangency ratio to `slope` and its other roundings, over its
    /// logarithmic derivative n − ½; and the last bracket.
    pub(crate) fn found_radius(self, slope: f64) -> f64 {
        2.0 * (slope + TANGENCY) / self.excess() + 4.0
    }

    /// d of a fold by closed form, with ln a off by `closed`, against quadrature (`g`) at its own fold, with ln a off by
    /// `found`; on the scale Δl. The first moves d at fixed tangency, ½d, the second along the equilibria, ½(λ−1)Δl.
    pub(crate) fn fold_indentation(self, closed: f64, found: f64, g: f64) -> f64 {
        0.5 * (self.transform() - 1.0).abs() * closed
            + 0.5 * (self.lambda - 1.0).abs() * found
            + self.transform() * g
            + self.indentation_terms()
            + ELONGATION
    }

    /// F likewise, on the scale 2E*aΔl.
    pub(crate) fn fold_force(self, closed: f64, found: f64, g: f64, mean: f64) -> f64 {
        1.5 * (self.pressed() - 1.0).abs() * closed
            + 0.5 * (self.lambda - 3.0).abs() * found
            + self.transform() * g
            + self.transform() / (self.n + 1.0) * mean
            + self.force_terms()
            + ELONGATION
            + 6.0
    }
}

/// Roundings of the tangency ratio g'/Δl' of the numerical route beside those of g': ℓ, its quotient by a, π, the root,
/// the quotient, the threshold.
const TANGENCY: f64 = 10.0;

/// The error of the balance φ(u) = μu + ln(N/√B) + μ ln(k/2E*) − ln λ(u) of a machine fold at u = ln(2E*a/k), at the
/// computed fold: each term to its own size, u itself to two of its roundings.
///
/// It is the relative error of g'/(λ√(B/a)) there, however flat φ is: the condition 1/φ' of u is not in it.
pub(crate) fn machine_balance(n: f64, u: f64, ln_stiffness_length: f64, ln_ratio: f64) -> f64 {
    let mu = (n - 0.5).abs();
    let terms = mu * u.abs() + mu * ln_stiffness_length.abs() + ln_ratio.abs() + 2.0;
    // |φ'| ≤ μ + 2 − √3.
    KAPPA + 10.0 + 4.0 * terms + (mu + 0.268) * (4.0 * u.abs() + 8.0)
}

/// Error of a quadrature of (1.1) for a profile of the order rⁿ, in u.
///
/// The error estimate of the rule itself, a rounding for every term of its sum, and twice the profile's condition n: a node
/// r = xs is rounded once for x·s and once in its own place, and rⁿ with its logarithmic derivatives repeats that.
pub(crate) fn quadrature<R: Real>(estimate: &Estimate<R>, n: f64) -> f64 {
    let left = (estimate.error.clone() / &estimate.value / estimate.value.unit_roundoff()).abs().approx();
    // Below a flat face the transform is zero exactly.
    let left = if estimate.value == estimate.value.lit(0) { 0.0 } else { left };
    left + estimate.evaluations as f64 + 4.0 * (n + 2.0)
}
