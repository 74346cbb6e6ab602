//! The independent numerical route.

#![forbid(unsafe_code)]

pub mod curve;
pub mod profiles;
pub mod transform;
