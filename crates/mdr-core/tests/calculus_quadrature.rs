//! Quadrature against closed forms.

use mdr_core::calculus::{Estimate, gauss_jacobi, quadrature, roundoff_tolerance};
use mdr_core::contact::Error;

fn check(name: &str, estimate: &Estimate<f64>, truth: f64) {
    let error = (estimate.value - truth).abs();
    assert!(error <= estimate.error, "{name}: {error:e} against the claimed {:e}", estimate.error);
}

#[test]
fn algebraic_and_logarithmic_ends() {
    let tolerance = roundoff_tolerance(&1.0);
    for power in [-0.95f64, -0.5, -0.25, 0.0, 0.1, 0.5, 1.0, 3.3, 20.0] {
        let estimate = quadrature::tanh_sinh(&0.0, &1.0, &tolerance, |x| Ok(x.powf(power))).unwrap();
        // The claim does not know what rounding x does inside f: |power| half-ulps, and one for powf.
        let inside = (power.abs() + 1.0) * f64::EPSILON * estimate.value;
        let estimate = Estimate { error: estimate.error + inside, ..estimate };
        check(&format!("x^{power}"), &estimate, 1.0 / (1.0 + power));
    }
}

#[test]
fn a_divergent_integral_does_not_converge() {
    let divergent = quadrature::tanh_sinh(&0.0, &1.0, &1e-3, |x| Ok(1.0 / x));
    assert!(matches!(divergent, Err(Error::NoConvergence { .. })), "{divergent:?}");
}

#[test]
fn gauss_rules_are_exact_to_degree_2n_minus_1() {
    // ∫ t^k dt = 1/(k+1). Rounding of n positive terms and of the weights: 2n unit roundoffs.
    for n in 1..40usize {
        let rule = gauss_jacobi::rule(n, &0.0, &0.0).unwrap();
        for k in 0..2 * n as i32 {
            let moment = rule.integrate(|t| Ok(t.powi(k))).unwrap();
            let error = (moment * f64::from(k + 1) - 1.0).abs();
            assert!(error <= 2.0 * (n as f64 + f64::from(k)) * f64::EPSILON, "n = {n}, k = {k}: {error:e}");
        }
    }
}
