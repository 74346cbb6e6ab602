//! Gauss–Jacobi rules: exactness, from one node to a thousand digits, and the number of nodes per digit.

use mdr_core::calculus::gauss_jacobi::{integrate, rule};
use mdr_core::calculus::roundoff_tolerance;
use mdr_core::contact::{Error, Quantity};
use mdr_core::number::{Dual, Real};

/// Exponents in use, and extreme ones: β = n/2 − 1 → −1 for the bluntest profiles, large for the steepest.
const EXPONENTS: [f64; 8] = [-1.0 + 1e-12, -0.999, -0.5, 0.0, 0.3, 1.0, 5.0, 60.0];

/// ∫ t^k t^β(1−t)^α dt / ∫ t^(k−1) t^β(1−t)^α dt.
fn moment_ratio<R: Real>(k: i64, alpha: &R, beta: &R) -> R {
    let (a, b) = (alpha.lit(1) + alpha, beta.lit(1) + beta);
    (alpha.lit(k - 1) + &b) / (alpha.lit(k - 1) + (a + b))
}

/// The moments of degree 0 … 2n−1 are accurate to `(k + n)·4` unit roundoffs: t^k magnifies the error of a node, a few
/// units, k-fold; n positive terms are summed; the reference is a product of k quotients.
fn assert_exact<R: Real>(n: usize, alpha: &R, beta: &R) {
    let rule = rule(n, alpha, beta).expect("a rule");
    assert_eq!(rule.nodes().len(), n);
    let moment = |k: i64| rule.integrate(|t| Ok(t.powi(k))).expect("a number");
    let mut truth = moment(0);
    for k in 1..2 * n as i64 {
        truth *= &moment_ratio(k, alpha, beta);
        let error = ((moment(k) - &truth) / &truth).abs();
        let bound = alpha.unit_roundoff().times(4 * (k + n as i64));
        assert!(error <= bound, "n = {n}, α = {alpha:?}, β = {beta:?}, k = {k}: {:e}", error.approx());
    }
}

#[test]
fn exact_to_degree_2n_minus_1() {
    for n in [1, 2, 3, 4, 7, 16, 45] {
        for alpha in EXPONENTS {
            for beta in EXPONENTS {
                assert_exact(n, &alpha, &beta);
            }
        }
    }
}

/// A Gauss rule has this error at degree 2n, in the monic norm; a rule of higher degree would pass the test above.
#[test]
fn not_exact_at_degree_2n() {
    for n in [1usize, 2, 5] {
        let rule = rule(n, &0.0, &0.0).unwrap();
        let value = rule.integrate(|t| Ok(t.powi(2 * n as i64))).unwrap();
        // ∫ P² of the monic shifted Legendre polynomial: n!⁴/((2n)!²(2n+1)).
        let factorial = |m: usize| (1..=m).map(|k| k as f64).product::<f64>();
        let norm = factorial(n).powi(4) / (factorial(2 * n).powi(2) * (2 * n + 1) as f64);
        let missing = 1.0 / (2 * n + 1) as f64 - value;
        assert!((missing / norm - 1.0).abs() < 1e-9, "n = {n}: {missing:e} against {norm:e}");
    }
}

/// B(α+1, β+1) against closed forms: α = 0, and π/sin πa for α + β = −1.
#[test]
fn total_weight() {
    for beta in EXPONENTS {
        let total = rule(3, &0.0, &beta).unwrap().integrate(|_| Ok(1.0)).unwrap();
        approx::assert_relative_eq!(total, 1.0 / (1.0 + beta), max_relative = 1e-14);
    }
    for a in [0.1, 0.25, 0.5, 0.7] {
        let total = rule(3, &(a - 1.0), &-a).unwrap().integrate(|_| Ok(1.0)).unwrap();
        let truth = std::f64::consts::PI / (std::f64::consts::PI * a).sin();
        approx::assert_relative_eq!(total, truth, max_relative = 1e-14);
    }
}

/// The nodes and weights of five-point Gauss–Legendre, Abramowitz & Stegun table 25.4.
#[test]
fn tabulated_legendre() {
    let rule = rule(5, &0.0, &0.0).unwrap();
    let table = [(0.906_179_845_938_664, 0.236_926_885_056_189), (0.538_469_310_105_683, 0.478_628_670_499_366)];
    for (node, (x, w)) in rule.nodes().iter().rev().zip(table) {
        // Fifteen printed decimals.
        assert!((2.0 * node.t - 1.0 - x).abs() < 1e-15 && (2.0 * node.weight - w).abs() < 1e-15, "{node:?}");
    }
    assert_eq!(rule.nodes()[2].t, 0.5);
}

#[test]
fn both_ends_to_relative_accuracy() {
    // Exchanging α and β mirrors the rule, small distances from the end included.
    let (one, other) = (rule(60, &-0.5, &0.25).unwrap(), rule(60, &0.25, &-0.5).unwrap());
    for (a, b) in one.nodes().iter().zip(other.nodes().iter().rev()) {
        approx::assert_relative_eq!(a.t, b.complement, max_relative = 4.0 * f64::EPSILON);
        approx::assert_relative_eq!(a.complement, b.t, max_relative = 4.0 * f64::EPSILON);
    }
}

/// Rules are exact at every β, so is their derivative: ∂/∂β ∫ t^(β+k) dt = −1/(β+k+1)².
#[test]
fn derivative_by_the_exponent() {
    let beta = Dual::variable(0.3);
    let rule = rule(4, &Dual::constant(0.0), &beta).unwrap();
    for k in 0..8 {
        let moment = rule.integrate(|t| Ok(t.powi(k))).unwrap();
        let exponent = 1.3 + k as f64;
        approx::assert_relative_eq!(moment.slope, -1.0 / (exponent * exponent), max_relative = 1e-13);
    }
}

#[test]
fn claims_hold() {
    // ∫ (1+t)^p dt, p from smooth to nearly singular at −1, and the oscillation of cos 40t.
    for p in [-3.5f64, -0.5, 0.3, 12.0] {
        let truth = ((p + 1.0) * 2f64.ln()).exp_m1() / (p + 1.0);
        let estimate = integrate(&0.0, &0.0, &roundoff_tolerance(&1.0), |t| Ok((1.0 + t).powf(p))).unwrap();
        let inside = (p.abs() + 2.0) * f64::EPSILON * truth;
        assert!((estimate.value - truth).abs() <= estimate.error + inside, "{p}: {estimate:?}");
        assert!(estimate.error <= 1e-14 * truth && estimate.evaluations <= 62);
        let fixed = rule(16, &0.0, &0.0).unwrap().integrate_with_estimate(|t| Ok((1.0 + t).powf(p))).unwrap();
        assert!((fixed.value - truth).abs() <= fixed.error + inside, "{p}: {fixed:?}");
    }
    let estimate = integrate(&0.0, &0.0, &1e-10, |t: &f64| Ok((40.0 * t).cos())).unwrap();
    assert!((estimate.value - 40f64.sin() / 40.0).abs() <= estimate.error);
}

#[test]
fn impossible_rules_are_refused() {
    assert!(matches!(rule(0, &0.0, &0.0), Err(Error::Domain { quantity: Quantity::Parameter("n"), .. })));
    for bad in [-1.0, -1.5, f64::NAN, f64::INFINITY] {
        assert!(matches!(rule(3, &bad, &0.0), Err(Error::Domain { quantity: Quantity::Parameter("alpha"), .. })));
        assert!(matches!(rule(3, &0.0, &bad), Err(Error::Domain { quantity: Quantity::Parameter("beta"), .. })));
    }
    let jump = integrate(&0.0, &0.0, &1e-12, |t| Ok(if *t < 0.3 { 0.0 } else { 1.0 }));
    assert!(matches!(jump, Err(Error::NoConvergence { .. })));
}

#[cfg(feature = "mp")]
mod arbitrary_precision {
    use super::*;
    use mdr_core::calculus::quadrature::tanh_sinh_near_ends;
    use mdr_core::number::{Gamma, Precision};
    use rug::Float;

    fn one(digits: u32) -> Float {
        Float::with_val(Precision::from_digits(digits).bits(), 1)
    }

    #[test]
    fn exact_at_50_and_200_digits() {
        for (digits, n) in [(50, 33), (200, 60)] {
            let one = one(digits);
            for (alpha, beta) in [(one.ratio(-1, 2), one.ratio(3, 20)), (one.lit(0), one.ratio(-99, 100))] {
                assert_exact(n, &alpha, &beta);
            }
        }
    }

    /// κ_n = n∫₀¹ s^(n−1)/√(1−s²) ds: with the weight s^(n−1)(1−s)^(−1/2) the remaining factor is 1/√(1+s), whose
    /// nearest singularity s = −1 gives log₁₀(3+√8) = 0.766 digits for each of 2N degrees: 0.653 nodes per digit.
    fn kappa_over_n(n: &Float, nodes: usize) -> Float {
        let rule = rule(nodes, &n.ratio(-1, 2), &(n.clone() - 1u32)).expect("a rule");
        rule.integrate(|s| Ok((s.clone() + 1u32).sqrt().recip())).expect("a number")
    }

    /// √π Γ(1+n/2)/(nΓ((n+1)/2)), by MPFR's Γ.
    fn closed(n: &Float) -> Float {
        let (half, upper) = (n.clone() / 2u32, (n.clone() + 1u32) / 2u32);
        Gamma::gamma(&(half + 1u32)) * n.pi().sqrt() / Gamma::gamma(&upper) / n
    }

    #[test]
    fn price_of_a_digit() {
        let tolerance = |one: &Float| roundoff_tolerance(one);
        for digits in [50, 200] {
            let one = one(digits + 5);
            let n = one.ratio(1, 4);
            let truth = closed(&n);
            let error = |nodes| Float::with_val(53, (kappa_over_n(&n, nodes) - &truth) / &truth).abs();
            let digit = Float::with_val(53, 10).powi(-i64::from(digits));
            let needed = (digits as usize * 2 / 3..).find(|&nodes| error(nodes) < digit).unwrap();
            assert!((0.62..0.70).contains(&(needed as f64 / f64::from(digits))), "{digits} digits: {needed} nodes");

            let adaptive = integrate(&one.ratio(-1, 2), &(n.clone() - 1u32), &tolerance(&one), |s| {
                Ok((s.clone() + 1u32).sqrt().recip())
            });
            let adaptive = adaptive.unwrap();
            assert!((adaptive.value - &truth).abs() <= adaptive.error);
            assert!(adaptive.evaluations < 9 * digits as usize / 4, "{}", adaptive.evaluations);

            let integral = tanh_sinh_near_ends(&one.lit(0), &one, &tolerance(&one), |node| {
                let upper = (node.x.clone() + 1u32) * &node.from_upper;
                Ok(Real::pow(&node.x, &(n.clone() - 1u32)) / upper.sqrt())
            });
            let integral = integral.unwrap();
            assert!((integral.value - &truth).abs() <= integral.error * 2u32);
            assert!(integral.evaluations > 3 * digits as usize && integral.evaluations < 10 * digits as usize);
        }
    }

    #[test]
    fn a_thousand_digits() {
        let n = one(1005).ratio(1, 4);
        let truth = closed(&n);
        let error = Float::with_val(53, (kappa_over_n(&n, 657) - &truth) / &truth).abs();
        assert!(error < Float::with_val(53, 10).powi(-1000), "{error:e}");
    }
}
