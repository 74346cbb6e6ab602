//! The independent numerical route: nothing here knows a closed form of any transform.
//!
//! * [`profiles`]: heights f(r).
//! * [`transform`]: g, g' and ∫g by quadrature, for any profile.
//! * [`curve`]: the equilibria of (1.5) and (1.6) as a curve, and the direction of change off it.
//! * [`fields`]: pressure, displacement, gap.
//! * [`table`]: measured profiles from a CSV file, transformed exactly.

#![forbid(unsafe_code)]

pub mod curve;
pub mod fields;
pub mod profiles;
pub mod table;
pub mod transform;
