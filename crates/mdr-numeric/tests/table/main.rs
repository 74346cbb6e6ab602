//! Measured profiles: reading, shape, and the exactness of the transform.

#![allow(clippy::unwrap_used, reason = "a test that panics has failed")]

#[cfg(feature = "mp")]
mod accuracy;
mod convergence;
#[cfg(feature = "mp")]
mod enclosed;
#[cfg(feature = "mp")]
mod exactness;
mod noise;
#[cfg(feature = "mp")]
mod on_media;
mod read;
mod sample;
mod shape;
