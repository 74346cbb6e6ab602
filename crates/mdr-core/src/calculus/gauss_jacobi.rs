//! Gauss–Jacobi quadrature on [0, 1] with the weight tᵝ(1−t)ᵅ.

use std::sync::{Arc, OnceLock};

use super::cache::{Key, RULES, Stored};
use super::estimate::{Estimate, Refinement, Tolerance, finite, rounding, sum};
use super::jacobi::Jacobi;
use crate::contact::{Error, Quantity, Result};
use crate::number::Real;

/// One node t of a Gauss rule.
#[derive(Clone, Debug)]
pub struct GaussNode<R> {
    /// t in (0, 1).
    pub t: R,
    /// 1 − t, accurate also where t rounds to 1.
    pub complement: R,
    /// The weight, positive.
    pub weight: R,
}

/// A Gauss rule: Σ wᵢ f(tᵢ) = ∫₀¹ tᵝ(1−t)ᵅ f(t) dt up to rounding for polynomials f of degree 2N−1.
#[derive(Clone, Debug)]
pub struct GaussRule<R> {
    alpha: R,
    beta: R,
    nodes: Vec<GaussNode<R>>,
}

/// The relative error of a sum over a rule, in unit roundoffs. From 53 to 900 bits at most 9 was measured, typically 2.
const ROUNDINGS: i64 = 12;

/// The rule with `n` nodes for α > −1 and β > −1, computed in their precision once per process and stored.
///
/// Nodes are accurate to a few roundings *relative* to their distance from the nearer end. The total weight B(α+1, β+1)
/// is summed from a series of positive terms, without Γ. Intended for floating types and their duals: interval
/// enclosures widen with n.
///
/// ```
/// use mdr_core::calculus::gauss_jacobi::rule;
/// // ∫₀¹ t³/√(1−t) dt = 32/35 with two nodes
/// let value = rule(2, &-0.5_f64, &0.0)?.integrate(|t| Ok(t.powi(3)))?;
/// assert!((value - 32.0 / 35.0).abs() < 4e-16);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Domain`](Error::Domain) unless n ≥ 1, α > −1 and β > −1 with finite, normal α+1 and β+1;
/// [`NoConvergence`](Error::NoConvergence) when the zeros cannot be separated.
pub fn rule<R: Real>(n: usize, alpha: &R, beta: &R) -> Result<Arc<GaussRule<R>>> {
    let key = Key::GaussJacobi { n, alpha: format!("{alpha:?}"), beta: format!("{beta:?}") };
    let kept = RULES.rule(alpha.precision(), key, || GaussRule::new(n, alpha, beta))?;
    // The text of an exponent may be shorter than its precision, so neighbouring exponents can share a key.
    let same = kept.alpha == *alpha && kept.beta == *beta;
    if same { Ok(kept) } else { GaussRule::new(n, alpha, beta).map(Arc::new) }
}

/// ∫₀¹ tᵝ(1−t)ᵅ f(t) dt to a `tolerance` relative to ∫ tᵝ(1−t)ᵅ|f|, by doubling the number of nodes.
///
/// For an f analytic around [0, 1]. The first rule has about bits/25 nodes; for a power profile the fourth rule
/// suffices. Split the interval where f or a derivative of it jumps; otherwise the error may be underestimated.
///
/// ```
/// use mdr_core::calculus::{gauss_jacobi, roundoff_tolerance};
/// // ∫₀¹ e^t/√t dt = 2.925303491814363…
/// let integral = gauss_jacobi::integrate(&0.0, &-0.5, &roundoff_tolerance(&1.0), |t: &f64| Ok(t.exp()))?;
/// assert!((integral.value - 2.925303491814363).abs() < 2e-15 && integral.evaluations == 30);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// Errors of [`rule`] and of f; [`Domain`](Error::Domain) where f is not finite; [`NoConvergence`](Error::NoConvergence)
/// when 16 times the nodes that a power profile needs are not enough.
pub fn integrate<R: Real>(
    alpha: &R,
    beta: &R,
    tolerance: impl Into<Tolerance<R>>,
    f: impl FnMut(&R) -> Result<R>,
) -> Result<Estimate<R>> {
    GaussLadder::new(alpha, beta).integrate(tolerance, f)
}

/// The rules for one weight that [`integrate`] uses in turn. Keep one to integrate many functions with the same weight:
/// in `f64` looking up the rules costs more than the integral.
#[derive(Clone, Debug)]
pub struct GaussLadder<R> {
    alpha: R,
    beta: R,
    rules: [OnceLock<Arc<GaussRule<R>>>; RUNGS],
}

/// From about bits/25 nodes to 128 times as many.
const RUNGS: usize = 8;

impl<R: Real> GaussLadder<R> {
    /// An empty ladder; unsuitable exponents are rejected at the first integral.
    pub fn new(alpha: &R, beta: &R) -> Self {
        GaussLadder { alpha: alpha.clone(), beta: beta.clone(), rules: Default::default() }
    }

    fn rule(&self, rung: usize) -> Result<&GaussRule<R>> {
        if let Some(rule) = self.rules[rung].get() {
            return Ok(rule);
        }
        let smallest = (self.alpha.precision() as usize + 12) / 25;
        let rule = rule(smallest << rung, &self.alpha, &self.beta)?;
        Ok(self.rules[rung].get_or_init(|| rule))
    }

    /// ∫₀¹ tᵝ(1−t)ᵅ f(t) dt to a `tolerance` relative to ∫ tᵝ(1−t)ᵅ|f|, by doubling the number of nodes; see the function
    /// [`integrate`].
    ///
    /// # Errors
    /// Errors of [`rule`] and of f; [`Domain`](Error::Domain) where f is not finite; [`NoConvergence`](Error::NoConvergence)
    /// when 16 times the nodes that a power profile needs are not enough.
    pub fn integrate(
        &self,
        tolerance: impl Into<Tolerance<R>>,
        mut f: impl FnMut(&R) -> Result<R>,
    ) -> Result<Estimate<R>> {
        let mut refinement = Refinement::new(tolerance.into());
        let mut evaluations = 0;
        let mut rung = 0;
        loop {
            let rule = self.rule(rung)?;
            let (value, magnitude) = rule.sums(&mut f)?;
            evaluations += rule.nodes.len();
            let known = rounding(&magnitude, ROUNDINGS);
            let (estimate, converged) = refinement.push(value, &magnitude, &known, evaluations);
            rung += 1;
            if converged {
                return Ok(estimate);
            } else if rung == RUNGS {
                return refinement.exhausted(estimate, &magnitude);
            }
        }
    }
}

impl<R: Real> GaussRule<R> {
    fn new(n: usize, alpha: &R, beta: &R) -> Result<Self> {
        let degree = i64::try_from(n).unwrap_or(i64::MAX);
        if n == 0 {
            let requirement = "a positive number of nodes";
            return Err(Error::Domain { quantity: Quantity::Parameter("n"), value: n.to_string(), requirement });
        }
        let exponent = |name, value: &R| {
            let raised = value.lit(1) + value;
            let valid = raised.approx().is_normal() && raised > raised.lit(0);
            if valid { Ok(raised) } else { Err(Error::domain(Quantity::Parameter(name), value, "above -1 and finite")) }
        };
        let (a, b) = (exponent("alpha", alpha)?, exponent("beta", beta)?);
        let (low, high) =
            (Jacobi::new(degree, &a.approx(), &b.approx()), Jacobi::new(degree, &b.approx(), &a.approx()));
        let below = low.zeros_below(0.5);
        let mut nodes = half(degree, &a, &b, &low.smallest_zeros(below));
        let above = half(degree, &b, &a, &high.smallest_zeros(n - below));
        nodes.extend(above.into_iter().rev().map(|node| GaussNode { t: node.complement, complement: node.t, ..node }));

        let total = beta_function(&a, &b);
        let weights: Vec<R> = nodes.iter().map(|node| node.weight.clone()).collect();
        let scale = total.clone() / sum(&weights, &total);
        nodes.iter_mut().for_each(|node| node.weight *= &scale);

        let ascending = nodes.windows(2).all(|pair| pair[0].t < pair[1].t);
        let weighted = nodes.iter().all(|node| node.weight >= total.lit(0) && node.weight.is_finite());
        if ascending && weighted {
            Ok(GaussRule { alpha: alpha.clone(), beta: beta.clone(), nodes })
        } else {
            Err(Error::NoConvergence { quantity: Quantity::Integral, evaluations: 0, error: f64::NAN })
        }
    }

    /// α.
    pub fn alpha(&self) -> &R {
        &self.alpha
    }

    /// β.
    pub fn beta(&self) -> &R {
        &self.beta
    }

    /// The nodes, ascending.
    pub fn nodes(&self) -> &[GaussNode<R>] {
        &self.nodes
    }

    /// Σ wᵢ f(tᵢ).
    ///
    /// # Errors
    /// Whatever f returns, or a [`Domain`](Error::Domain) error where f is not finite.
    pub fn integrate(&self, mut f: impl FnMut(&R) -> Result<R>) -> Result<R> {
        let mut total = self.alpha.lit(0);
        for node in &self.nodes {
            total += &(finite(f(&node.t)?)? * &node.weight);
        }
        Ok(total)
    }

    /// Σ wᵢ f(tᵢ) with an error estimate: the difference from the rule with half as many nodes. That is the error of the
    /// smaller rule, far too large for a smooth f; [`integrate`] compares more rules and is sharper.
    ///
    /// # Errors
    /// Errors of f; [`Domain`](Error::Domain) where f is not finite; errors of [`rule`] for the smaller rule.
    pub fn integrate_with_estimate(&self, mut f: impl FnMut(&R) -> Result<R>) -> Result<Estimate<R>> {
        let smaller = rule(self.nodes.len().div_ceil(2), &self.alpha, &self.beta)?;
        let (value, magnitude) = self.sums(&mut f)?;
        let distance =
            if self.nodes.len() == 1 { magnitude.clone() } else { (smaller.integrate(&mut f)? - &value).abs() };
        let error = (distance + rounding(&magnitude, ROUNDINGS)).midpoint();
        Ok(Estimate { value, error, evaluations: self.nodes.len() + smaller.nodes.len() })
    }

    /// Σ wᵢ f(tᵢ) and Σ wᵢ |f(tᵢ)|.
    fn sums(&self, f: &mut impl FnMut(&R) -> Result<R>) -> Result<(R, R)> {
        let mut magnitude = self.alpha.lit(0);
        let mut terms = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let term = finite(f(&node.t)?)? * &node.weight;
            magnitude += &term.abs();
            terms.push(term);
        }
        Ok((sum(&terms, &magnitude), magnitude))
    }
}

impl<R: Real> Stored for GaussRule<R> {
    fn bits(&self) -> usize {
        self.nodes.len() * 3 * self.alpha.precision() as usize
    }
}

/// The nodes near `guesses`, with weights up to a factor common to all nodes of the rule.
///
/// wᵢ = m/(t(1−t)q_n'²), m = B(a,b)·(a/b)·Π_{k=2}^n k(k+a−1)/((k+a+b−2)(k+b−1)) for q_n(0) = 1.
fn half<R: Real>(n: i64, a: &R, b: &R, guesses: &[f64]) -> Vec<GaussNode<R>> {
    let polynomial = Jacobi::new(n, a, b);
    let plus = |x: &R, k: i64| x.lit(k) + x;
    let factor =
        (2..=n).fold(a.clone() / b, |m, k| m * plus(a, k - 1).times(k) / ((plus(a, k - 2) + b) * plus(b, k - 1)));
    let node = |&guess: &f64| {
        let (t, slope) = polynomial.zero_near(&R::from_f64(a.ctx(), guess));
        let weight = factor.clone() / (polynomial.span(&t) * slope.square());
        GaussNode { complement: t.lit(1) - &t, weight, t }
    };
    guesses.iter().map(node).collect()
}

/// B(a, b) = 2^−(a+b)·[S(a) + S(b)], S(p) = Σ_k Π_{j<k} (a+b+j)/(2(p+1+j))/p: the integral split at 1/2. All terms are
/// positive, and from k ≈ max(a, b) on each is about half the one before.
fn beta_function<R: Real>(a: &R, b: &R) -> R {
    let plus = |x: &R, k: i64| x.lit(k) + x;
    let series = |p: &R| {
        let mut term = p.clone().inv();
        let mut terms = vec![term.clone()];
        let mut total = term.clone();
        for k in 0.. {
            // The rounding of a+b differs from term to term, and so does not add up.
            term *= &(plus(a, k) + b);
            term /= &plus(p, k + 1).times(2);
            total += &term;
            terms.push(term.clone());
            if term.clone().times(64).midpoint() <= (total.clone() * total.unit_roundoff()).midpoint() {
                break;
            }
        }
        sum(&terms, &term)
    };
    let half = a.ratio(1, 2);
    (series(a) + series(b)) * half.pow(a) * half.pow(b)
}
