//! Equilibria at a value against bisection of (1.13) and (1.16), implemented independently over MPFR with its own Γ;
//! against the closed forms of the family for m = 2; and against identities of physics.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]

mod bisection;
mod doubles;
mod family;
mod outcomes;
mod quadratic;
mod rows;
