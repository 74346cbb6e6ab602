//! The Struve functions H₀ and H₁, which the MDR transform of a cosine contains.
//!
//! * Small z: H₀ = (2/π) Σ (−1)ᵏ z^{2k+1}/((2k+1)!!)² and H₁ = (2/π) Σ (−1)ᵏ z^{2k+2}/((2k+1)!!² (2k+3)) (DLMF 11.2.1);
//!   from k with 2k + 1 ≥ z on the terms decrease and alternate, so the remainder is below the first omitted term.
//! * Large z: H_ν − Y_ν is the divergent series of DLMF 11.6.1, whose remainder is below the first omitted term.
//!
//! Accuracy: `f64` a few units of 10⁻¹⁶ absolute (both functions are of order one, and H₀ has zeros); `rug::Float` to
//! working precision in the same sense; an `Interval` is rigorous for every argument z ≥ 0.

#[cfg(feature = "mp")]
mod enclosure;
#[path = "../../data/struve.rs"]
mod table;

#[cfg(feature = "small")]
use libm::{y0, y1};
use mdr_core::number::{Dual, Real, Special};
#[cfg(not(feature = "small"))]
use pxfm::{f_y0 as y0, f_y1 as y1};

/// The Struve functions of order 0 and 1, for z ≥ 0.
///
/// ```
/// use mdr_analytic::struve::Struve;
/// // Abramowitz & Stegun, table 12.1
/// assert!((1.0.struve_h0() - 0.5686566).abs() < 1e-7);
/// assert!((1.0.struve_h1() - 0.1984573).abs() < 1e-7);
/// ```
pub trait Struve: Special {
    /// H₀(self). H₀' = 2/π − H₁.
    fn struve_h0(&self) -> Self;
    /// H₁(self). H₁' = H₀ − H₁/z.
    fn struve_h1(&self) -> Self;
    /// Both, at little more than the cost of one if they come from one series.
    fn struve(&self) -> [Self; 2] {
        [self.struve_h0(), self.struve_h1()]
    }
}

/// The power series with the given first term, times π/2 that of H₀ (`order` 0) or H₁ (`order` 1), or that over z; summed
/// until its terms are negligible. The first term omitted, which bounds the remainder, comes with the sum.
///
/// The terms are as large as e^z/z: the caller provides the bits that cancel.
fn power_series<R: Real>(z: &R, first: R, order: i64) -> (R, R) {
    let square = -z.square();
    let mut term = first;
    let mut sum = term.clone();
    let mut k = 0;
    loop {
        k += 1;
        term *= &square;
        term = term.over((2 * k + 1) * (2 * k + 1 + 2 * order));
        // Once the terms decrease they keep decreasing.
        let falling = !(z.midpoint() > z.lit(2 * k + 1));
        if falling && !(term.abs().midpoint() > sum.abs().midpoint() * z.unit_roundoff()) {
            return (sum, term);
        }
        sum += &term;
    }
}

/// H₁(z)/z = (2/π) Σ (−1)ᵏ z^{2k+1}/((2k+1)!!² (2k+3)) for z < 2⁻²⁰, in range where H₁ may underflow; `None` for other
/// z. The first omitted term also bounds the derivatives of the remainder.
pub(crate) fn small_h1<R: Real>(z: &R) -> Option<R> {
    if !(*z < z.lit(2).powi(-20)) {
        return None;
    }
    let (sum, omitted) = power_series(z, z.clone().over(3), 1);
    Some(sum.inflate_with_slope(&omitted).times(2) / z.pi())
}

/// The argument from which on the tables apply.
const FAR: f64 = 3.0;

impl Struve for f64 {
    fn struve_h0(&self) -> f64 {
        if *self < FAR {
            return power_series(self, *self, 0).0 * std::f64::consts::FRAC_2_PI;
        }
        std::f64::consts::FRAC_2_PI * chebyshev(&table::K0, FAR / self) / self + y0(*self)
    }

    fn struve_h1(&self) -> f64 {
        if *self < FAR {
            return power_series(self, self * self / 3.0, 1).0 * std::f64::consts::FRAC_2_PI;
        }
        let decaying = chebyshev(&table::K1, FAR / self) / (self * self);
        std::f64::consts::FRAC_2_PI * (1.0 + decaying) + y1(*self)
    }
}

/// Σ c_k T_k(2v − 1) by Clenshaw's recurrence.
fn chebyshev(coefficients: &[f64], v: f64) -> f64 {
    let t = 2.0 * v - 1.0;
    let (mut b1, mut b2) = (0.0, 0.0);
    for c in coefficients[1..].iter().rev() {
        (b1, b2) = (2.0 * t * b1 - b2 + c, b1);
    }
    t * b1 - b2 + coefficients[0]
}

impl<R: Struve> Struve for Dual<R> {
    fn struve_h0(&self) -> Self {
        let [h0, _] = self.struve();
        h0
    }

    fn struve_h1(&self) -> Self {
        let [_, h1] = self.struve();
        h1
    }

    fn struve(&self) -> [Self; 2] {
        let z = &self.value;
        let [h0, h1] = z.struve();
        // H₁/z → 0 as z → 0.
        let quotient = if *z == z.lit(0) { h1.clone() } else { h1.clone() / z };
        let [slope0, slope1] = [z.lit(2) / z.pi() - &h1, h0.clone() - quotient];
        [self.chain(h0, slope0), self.chain(h1, slope1)]
    }
}
