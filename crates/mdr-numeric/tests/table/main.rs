//! Measured profiles: reading, shape, and the exactness of the transform.

#![allow(clippy::unwrap_used, reason = "a test that panics has failed")]

#[cfg(feature = "mp")]
mod accuracy;
#[cfg(feature = "mp")]
mod sample;
