//! Closed forms of the theory.

#![forbid(unsafe_code)]

mod contact;
mod critical;
mod kappa;
mod machine;
mod power_law;
pub mod profiles;
mod range;
pub mod struve;

pub use contact::{Contact, detachment_elongation};
pub use critical::Critical;
pub use kappa::{Kappa, kappa};
pub use power_law::PowerLaw;
