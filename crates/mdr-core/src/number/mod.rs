//! The arithmetics in which every formula runs, behind one trait.

mod dual;
mod float;
mod literal;
#[cfg(feature = "mp")]
mod mp;
mod real;

pub use dual::Dual;
pub use literal::{Literal, LiteralError};
#[cfg(feature = "mp")]
pub use mp::Precision;
pub use real::{Gamma, Lift, Real, Special};
