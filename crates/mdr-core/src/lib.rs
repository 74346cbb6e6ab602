//! Numbers, calculus and the vocabulary of adhesive contact mechanics: the base of all other crates of the workspace.
//! No formula of the theory is here. The trait [`Real`](number::Real) is what makes one formula serve every arithmetic:
//! a generic function takes its constants from its arguments and so keeps their precision.
//!
//! ```
//! use mdr_core::number::{Dual, Real};
//!
//! /// Δl(a) = √(2πaw/E*), the rule of Heß (1.4).
//! fn detachment_elongation<R: Real>(a: &R, w_over_e: &R) -> R {
//!     (a.pi() * a * w_over_e).times(2).sqrt()
//! }
//! let elongation = detachment_elongation(&1.0, &1e-4);
//! assert!((elongation - 0.025066282746310005).abs() < 1e-17);
//! // The same function with derivatives: dΔl/da = Δl/2a.
//! let dual = detachment_elongation(&Dual::variable(1.0), &Dual::constant(1e-4));
//! assert!((dual.slope - elongation / 2.0).abs() < 1e-17);
//! ```
//!
//! | task | module |
//! |---|---|
//! | compute in `f64`, arbitrary precision, enclosures, derivatives | [`number`]: [`Real`](number::Real), [`Dual`](number::Dual), [`Extended`](number::Extended), `Interval` |
//! | read exact decimals and fractions | [`number`]: [`Literal`](number::Literal), [`Exact`](number::Exact) |
//! | read numbers with their units | [`units`]: [`SiUnit`](units::SiUnit) |
//! | prove decimal digits | `number::certify` |
//! | integrate | [`calculus::quadrature`], [`calculus::gauss_jacobi`] |
//! | find zeros: one, all on a range, with proof | [`calculus::roots`], [`calculus::isolate`], `calculus::verify` |
//! | name materials, profiles, controls, states | [`contact`]: [`Material`](contact::Material), [`Shape`](contact::Shape), [`Control`](contact::Control), [`Equilibrium`](contact::Equilibrium) |
//! | define a profile by a formula | [`contact::Expression`] |
//! | repeat the text of others in a message | [`text`]: [`excerpt`](text::excerpt) |
//! | provide a transform g(x) | [`contact::Transform`] |
//!
//! # Features
//! `mp` (default): `rug::Float`, `Interval`, `certify` and `verify`, which build GMP and MPFR. Without it the crate is
//! pure Rust and offers `f64`, [`Extended`](number::Extended) and their duals.
//!
//! # Accuracy and errors
//! Elementary functions of `f64` are within 1 ulp, of `rug::Float` correctly rounded; an `Interval` contains the exact
//! result. Quadrature and root finding return an error estimate and the number of evaluations. Arithmetic is total, as
//! in IEEE 754; functions that check their input return [`contact::Error`] with the quantity, its value and the
//! requirement.

#![forbid(unsafe_code)]

pub mod calculus;
pub mod contact;
mod named;
pub mod number;
pub mod text;
pub mod units;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
