//! Brouncker's continued fraction, for large n.
//!
//! With s = 2n+1 (Brouncker 1656; Perron, *Die Lehre von den Kettenbrüchen*):
//!
//! 4κ_n²/π = s + 1²/(2s + 3²/(2s + 5²/(2s + …))).
//!
//! All its elements are positive, so a tail t = 2s + (2k+1)²/(2s + …) lies between 2s and 2s + (2k+1)²/2s, and
//! evaluation backwards from there encloses the value. Each step reduces a relative error by exp(−2 arsinh(s/2k)): if s
//! is of the order of the precision in bits, a small fraction of that number of steps is enough, and one step for n =
//! 10³⁰⁰.

use mdr_core::number::Real;

/// The depth at which the tail is negligible at the given precision; `None` if it exceeds a third of the bits, where
/// the series is faster.
pub(super) fn depth(n: f64, bits: u32) -> Option<u32> {
    let s = 2.0 * n + 1.0;
    let mut remaining = f64::from(bits) * std::f64::consts::LN_2;
    for k in 1..=bits / 3 {
        remaining -= 2.0 * (s / (2.0 * f64::from(k))).asinh();
        if remaining <= 0.0 {
            return Some(k);
        }
    }
    None
}

/// κ_n = ½√(π b), where b is the continued fraction cut at the given depth.
pub(super) fn kappa<R: Real>(n: &R, depth: u32) -> R {
    let s = n.clone().times(2) + n.lit(1);
    let twice = s.clone().times(2);
    let odd_square = |k: i64| n.lit((2 * k + 1) * (2 * k + 1));
    let slack = odd_square(i64::from(depth)) / &twice.clone().times(2);
    let mut tail = (twice.clone() + &slack).inflate(&slack);
    for k in (1..i64::from(depth)).rev() {
        tail = odd_square(k) / &tail + &twice;
    }
    let fraction = tail.inv() + &s;
    (fraction * s.pi()).sqrt().over(2)
}
