//! The closed forms of power laws: published numbers, one function in several arithmetics, and properties.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

#[cfg(feature = "mp")]
mod arithmetics;
mod properties;
mod published;
