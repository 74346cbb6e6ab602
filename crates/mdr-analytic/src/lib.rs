//! Closed forms of the theory.

pub mod profiles;
