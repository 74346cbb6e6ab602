//! Quadrature and root finding over any [`Real`](crate::number::Real).
//!
//! All tolerances are relative: scaling the argument or the function by a power of two changes no bit of the
//! significands.
//!
//! * [`quadrature`]: tanh-sinh, for integrands with any behaviour at the ends of the interval.
//! * [`gauss_jacobi`]: Gauss rules for the weight tᵝ(1−t)ᵅ, for integrands that are smooth once the weight is taken out.
//! * [`roots`]: brackets found by a search outwards through the exponent range, and their refinement.
//! * [`isolate`]: all sign changes on a range, with a proof of completeness where there is an enclosure test.
//! * `enclose` (feature `mp`): enclosures of integrals of functions that are analytic piece by piece.
//! * `panel` (feature `mp`): one such rule on a given piece, for integrands of which a part is known beforehand.
//! * `verify` (feature `mp`): existence and uniqueness of a zero by the interval Newton operator.

mod cache;
#[cfg(feature = "mp")]
pub mod enclose;
mod estimate;
pub mod gauss_jacobi;
pub mod isolate;
mod jacobi;
#[cfg(feature = "mp")]
mod legendre;
#[cfg(feature = "mp")]
pub mod panel;
pub mod quadrature;
pub mod roots;
#[cfg(feature = "mp")]
pub mod verify;

pub use estimate::{Estimate, Tolerance, roundoff_tolerance};
