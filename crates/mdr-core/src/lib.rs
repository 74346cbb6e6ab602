//! Numbers, calculus and the field's vocabulary for adhesive contact mechanics. No physics is computed here.
//!
//! * [`number`]: the trait [`Real`](number::Real) in which every formula of the workspace is written once, and the
//!   arithmetics it runs in: `f64`, arbitrary precision (`rug::Float`), rigorous enclosures (`Interval`) and
//!   derivatives ([`Dual`](number::Dual)).
//! * [`calculus`]: quadrature and root finding over any `Real`, each with an error estimate and a count of evaluations.
//! * [`contact`]: material, profile, control, equilibrium, stability, instability, and the one error type.
//!
//! A formula is a generic function. It takes its constants from the values it is given, so it keeps their precision:
//!
//! ```
//! use mdr_core::number::Real;
//!
//! /// Δl(a) = √(2πaw/E*), the rule of Heß (1.4).
//! fn detachment_elongation<R: Real>(a: &R, w_over_e: &R) -> R {
//!     (a.pi() * a * w_over_e).times(2).sqrt()
//! }
//! let l = detachment_elongation(&1.0, &1e-4);
//! assert!((l - 0.025066282746310005).abs() < 1e-17);
//! ```
//!
//! # Features
//! `mp` (default): `rug::Float` and the interval arithmetic on it, which build GMP and MPFR. Without it the crate is
//! pure Rust and offers `f64` and its duals.

#![forbid(unsafe_code)]

pub mod calculus;
pub mod contact;
pub mod number;
