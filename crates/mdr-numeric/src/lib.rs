//! The independent numerical route: nothing here knows a closed form of any transform.
//!
//! * [`profiles`]: heights f(r).
//! * [`transform`]: g, g' and ∫g by quadrature, for any profile.
//! * [`curve`]: the equilibria of (1.5) and (1.6) as a curve, and the direction of change off it.
//! * [`folds`]: the instabilities, by tangency (1.10), under every control.
//! * [`equilibrium`]: all equilibria at a given indentation, force or machine position, and what an instability leads to.
//! * [`branch`]: the curve cut at its folds, as a loading path needs it.
//! * [`path`]: what the contact does along a loading path.
//! * [`energy`]: the same equilibria from the potential energy (Griffith).
//! * [`springs`]: the elastic foundation of discrete springs, the paper's procedure taken literally.
//! * [`fields`]: pressure, displacement, gap.
//! * [`table`]: measured profiles from a CSV file, transformed exactly.
//! * [`proof`]: folds with a proof that none is missed.

#![forbid(unsafe_code)]

pub mod branch;
pub mod curve;
pub mod energy;
pub mod equilibrium;
pub mod fields;
pub mod folds;
pub mod path;
pub mod profiles;
#[cfg(feature = "mp")]
pub mod proof;
pub mod springs;
mod survey;
pub mod table;
pub mod transform;
