//! The formulas as textbooks write them, in doubles, as a reader would type them. They are not part of the shipped library.

use std::f64::consts::PI;

use mdr_core::number::Gamma;

/// κ_n = √π Γ(1+n/2)/Γ((n+1)/2), with a Γ right to one ulp.
pub(crate) fn kappa(n: f64) -> f64 {
    PI.sqrt() * Gamma::gamma(&(1.0 + n / 2.0)) / Gamma::gamma(&((n + 1.0) / 2.0))
}

/// κ_n as √π e to the difference of two log-gammas, which does not overflow.
pub(crate) fn kappa_by_logarithms(n: f64) -> f64 {
    PI.sqrt() * (Gamma::ln_gamma(&(1.0 + n / 2.0)) - Gamma::ln_gamma(&((n + 1.0) / 2.0))).exp()
}

/// κ_n C xⁿ.
pub(crate) fn g(n: f64, c: f64, x: f64) -> f64 {
    kappa_by_logarithms(n) * c * x.powf(n)
}

/// √(2πaw/E*).
pub(crate) fn elongation(e: f64, w: f64, a: f64) -> f64 {
    (2.0 * PI * a * w / e).sqrt()
}

/// (1.13).
pub(crate) fn indentation([n, c, e, w]: [f64; 4], a: f64) -> f64 {
    g(n, c, a) - elongation(e, w, a)
}

/// (1.16).
pub(crate) fn force([n, c, e, w]: [f64; 4], a: f64) -> f64 {
    2.0 * e * (n / (n + 1.0) * kappa_by_logarithms(n) * c * a.powf(n + 1.0) - (2.0 * PI * w / e).sqrt() * a.powf(1.5))
}

/// g' − √(πw/(2E*a)).
pub(crate) fn indentation_slope([n, c, e, w]: [f64; 4], a: f64) -> f64 {
    n * g(n, c, a) / a - (PI * w / (2.0 * e * a)).sqrt()
}

/// 2E*(a d' − Δl).
pub(crate) fn force_slope([n, c, e, w]: [f64; 4], a: f64) -> f64 {
    2.0 * e * (n * g(n, c, a) - (PI * w * a / (2.0 * e)).sqrt() - elongation(e, w, a))
}

/// (1.15) with its exponent corrected, for g' = λΔl'.
pub(crate) fn critical_radius([n, c, e, w]: [f64; 4], tension: f64) -> f64 {
    let slope = n * kappa_by_logarithms(n) * c;
    (tension * tension * PI * w / (2.0 * e * slope * slope)).powf(1.0 / (2.0 * n - 1.0))
}

/// (1.13) at that radius.
pub(crate) fn critical_indentation(law: [f64; 4], tension: f64) -> f64 {
    indentation(law, critical_radius(law, tension))
}

/// (1.16) at that radius.
pub(crate) fn critical_force(law: [f64; 4], tension: f64) -> f64 {
    force(law, critical_radius(law, tension))
}

/// (ãⁿ − 2nã^{1/2})/|1−2n|.
pub(crate) fn universal_indentation(n: f64, a: f64) -> f64 {
    (a.powf(n) - 2.0 * n * a.sqrt()) / (1.0 - 2.0 * n).abs()
}

/// (ãⁿ⁺¹ − 2(n+1)ã^{3/2})/(2n+1).
pub(crate) fn universal_force(n: f64, a: f64) -> f64 {
    (a.powf(n + 1.0) - 2.0 * (n + 1.0) * a.powf(1.5)) / (2.0 * n + 1.0)
}

/// Π = E*∫(d−g)² − πa²w, term by term.
pub(crate) fn energy([n, c, e, w]: [f64; 4], a: f64, d: f64) -> f64 {
    let g = g(n, c, a);
    e * a * (d * d - 2.0 * d * g / (n + 1.0) + g * g / (2.0 * n + 1.0)) - PI * a * a * w
}

/// artanh t as half a logarithm.
pub(crate) fn artanh(t: f64) -> f64 {
    0.5 * ((1.0 + t) / (1.0 - t)).ln()
}

/// √(x² − b²) through the squares.
pub(crate) fn leg(x: f64, b: f64) -> f64 {
    (x * x - b * b).sqrt()
}

/// The larger equilibrium radius of a sphere at a given d: (a²/R − d)² = 2πwa/E* as a quartic, by Ferrari's solution as
/// discrete element codes use it (Parteli et al., Sci. Rep. 4 (2014) 6227).
pub(crate) fn ferrari(radius: f64, e: f64, w: f64, d: f64) -> f64 {
    let c0 = (radius * d).powi(2);
    let c1 = -2.0 * PI * w * radius * radius / e;
    let c2 = -2.0 * d * radius;
    let p = -c2 * c2 / 12.0 - c0;
    let q = -c2.powi(3) / 108.0 + c0 * c2 / 3.0 - c1 * c1 / 8.0;
    let u = (-q / 2.0 + (q * q / 4.0 + p.powi(3) / 27.0).sqrt()).cbrt();
    let s = if p == 0.0 { -5.0 * c2 / 6.0 - q.cbrt() } else { -5.0 * c2 / 6.0 + u - p / (3.0 * u) };
    let root = (c2 + 2.0 * s).sqrt();
    let rest = root * root - 4.0 * (c2 + s + c1 / (2.0 * root));
    0.5 * (root + rest.sqrt())
}

/// The power series of H₀ in doubles, whose terms grow to e^z before they fall.
pub(crate) fn struve_h0(z: f64) -> f64 {
    let (mut term, mut sum) = (z, z);
    for k in 1..2000 {
        let odd = f64::from(2 * k + 1);
        term *= -z * z / (odd * odd);
        sum += term;
    }
    2.0 / PI * sum
}
