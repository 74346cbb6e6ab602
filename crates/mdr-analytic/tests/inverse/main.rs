//! Equilibria at a value against bisection of (1.13) and (1.16), which are written down here a second time over MPFR with its
//! own Γ; against the closed forms that the family has for m = 2; and what physics demands.
#![cfg(feature = "mp")]
#![allow(clippy::unwrap_used, reason = "the helpers belong to the tests")]

#[path = "../common/mod.rs"]
mod common;

mod bisection;
mod doubles;
mod family;
mod outcomes;
mod rows;
