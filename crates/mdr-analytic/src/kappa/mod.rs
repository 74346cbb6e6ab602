//! κ_n, the factor between a power law and its MDR transform (1.12), without the Gamma function.
//!
//! κ_n = √π Γ(1+n/2)/Γ((n+1)/2) grows from 1 at n → 0 as √(πn/2) for large n, and κ_n κ_{n+1} = π(n+1)/2. Two
//! expansions cover all n > 0, each with a proved remainder:
//!
//! * [`series`]: three bits per term, for n up to about a quarter of the precision in bits;
//! * [`brouncker`]: a continued fraction that improves as n grows.
//!
//! They are written for any arithmetic. Arbitrary precision and intervals have faster versions with counted roundings:
//! `horner` sums the series for rational n in exact `blocks` of terms, and `shifted` moves any n to where the continued
//! fraction is short, by the recurrence κ_n = κ_{n+2} (n+1)/(n+2) in runs of `rising` factors. For rational n with a
//! denominator up to 4 one arithmetic-geometric mean is enough (`elliptic`).
//!
//! Derivatives with respect to n come from an alternating series ([`alternating`]).

mod alternating;
#[cfg(feature = "mp")]
mod blocks;
mod brouncker;
#[cfg(feature = "mp")]
mod elliptic;
#[cfg(feature = "mp")]
mod horner;
#[cfg(feature = "mp")]
mod rational;
#[cfg(feature = "mp")]
mod rising;
mod series;
#[cfg(feature = "mp")]
mod shifted;

#[cfg(feature = "mp")]
pub use elliptic::free_cache;
#[cfg(feature = "mp")]
pub use rational::kappa_enclosure;
#[cfg(feature = "mp")]
pub(crate) use rational::rational_kappa;

use mdr_core::contact::{Error, Quantity, Result};
use mdr_core::number::{Dual, Real};

/// Numbers for which κ_n and its derivatives with respect to n can be computed.
///
/// The default methods, the generic expansions, serve any arithmetic.
pub trait Kappa: Real {
    /// κ_n for n ≥ 0 (κ_0 = 1), unchecked; [`kappa`] checks n.
    fn kappa(n: &Self) -> Self {
        expansion(n, 0.0)
    }

    /// dᵏ ln κ_n / dnᵏ for the order k ≥ 1, n ≥ 0.
    fn ln_kappa_derivative(n: &Self, order: u32) -> Self {
        alternating::ln_kappa_derivative(n, order)
    }
}

/// κ_n = √π Γ(1+n/2)/Γ((n+1)/2) (1.12), the factor in g(x) = κ_n C xⁿ, for every n > 0.
///
/// Within 0.51 ulp in `f64`, to the last bits in arbitrary precision, rigorous as an interval, with dκ/dn as a dual
/// number.
///
/// ```
/// use mdr_analytic::kappa;
/// assert!((kappa(&2.0)? - 2.0).abs() < 1e-15);
/// assert!((kappa(&0.5)? - 1.3110287771460599).abs() < 1e-15);
/// assert!(kappa(&-1.0).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless n is positive and finite.
pub fn kappa<R: Kappa>(n: &R) -> Result<R> {
    let n = Error::require_positive(Quantity::Exponent, n.clone())?;
    Ok(R::kappa(&n))
}

/// The expansion with fewer terms for this n at this precision, the continued fraction only where n is this many times
/// its depth: an arithmetic whose error bounds are powers of two needs partial numerators (2k+1)² well below s².
pub(crate) fn expansion<R: Real>(n: &R, depths: f64) -> R {
    let (size, bits) = (n.approx(), n.precision() + 2);
    match brouncker::depth(size, bits).filter(|depth| depths * f64::from(*depth) < size) {
        Some(depth) => brouncker::kappa(n, depth),
        None => series::kappa(n, series::terms(size, bits)),
    }
}

impl<R: Kappa> Kappa for Dual<R> {
    fn kappa(n: &Self) -> Self {
        let value = R::kappa(&n.value);
        let derivative = R::ln_kappa_derivative(&n.value, 1) * &value;
        n.chain(value, derivative)
    }

    fn ln_kappa_derivative(n: &Self, order: u32) -> Self {
        n.chain(R::ln_kappa_derivative(&n.value, order), R::ln_kappa_derivative(&n.value, order + 1))
    }
}

/// Thirty-two guard bits, so that the rounding errors of the expansion do not reach the result.
#[cfg(feature = "mp")]
impl Kappa for rug::Float {
    fn kappa(n: &Self) -> Self {
        const GUARD: u32 = 32;
        rug::Float::with_val(n.prec(), shifted::kappa(n, n.prec() + GUARD).value())
    }
}

#[cfg(feature = "mp")]
impl Kappa for mdr_core::number::Interval {
    fn kappa(n: &Self) -> Self {
        rational::interval_kappa(n)
    }
}

#[cfg(all(test, feature = "mp"))]
#[path = "../../tests/private/kappa.rs"]
mod tests;
