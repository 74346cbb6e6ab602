//! A solver as somebody else might write it: the contact radius of an adhesive sphere after Johnson, Kendall & Roberts, in
//! double precision. What matters here is its test, `tests/oracle.rs`: the certified records of `mdr-reference` as oracle.

use std::f64::consts::PI;

/// The contact radius of a paraboloid f = C r² (1/C is twice the radius of a sphere) at the indentation depth d, on the
/// branch that is stable under fixed grips: the larger root of 2Ca² − √(2πaw/E*) = d. None beyond pull-off.
///
/// ```
/// // R = E* = w = 1, d = 0: a³ = 2π.
/// let a = jkr_example::contact_radius(0.5, 1.0, 1.0, 0.0).unwrap();
/// approx::assert_relative_eq!(a.powi(3), 2.0 * std::f64::consts::PI, max_relative = 1e-15);
/// ```
pub fn contact_radius(c: f64, e_star: f64, work: f64, d: f64) -> Option<f64> {
    let root = (2.0 * PI * work / e_star).sqrt();
    // With s = √a: 2Cs⁴ − root·s − d = 0, convex, a minimum at 8Cs³ = root.
    let lowest = (root / (8.0 * c)).cbrt();
    let excess = |s: f64| 2.0 * c * s.powi(4) - root * s - d;
    if excess(lowest) > 0.0 {
        return None;
    }
    // Newton's method from above: both roots are below this sum of scales.
    let mut s = (root / c).cbrt() + (d.abs() / c).sqrt().sqrt() + lowest;
    for _ in 0..100 {
        let next = s - excess(s) / (8.0 * c * s.powi(3) - root);
        if !(next < s) {
            break;
        }
        s = next;
    }
    Some(s * s)
}
