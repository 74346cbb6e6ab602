//! The arithmetics in which every formula is evaluated, behind one trait.

#[cfg(feature = "mp")]
pub mod certify;
#[cfg(feature = "mp")]
mod counted;
mod decimal;
mod dual;
mod exact;
mod float;
#[cfg(feature = "mp")]
mod interval;
mod literal;
#[cfg(feature = "mp")]
mod mp;
mod real;
mod wide;

#[cfg(feature = "mp")]
pub use counted::Counted;
pub use decimal::Decimal;
pub use dual::Dual;
pub use exact::Exact;
#[cfg(feature = "mp")]
pub use interval::Interval;
pub use literal::{Literal, LiteralError};
#[cfg(feature = "mp")]
pub use mp::Precision;
pub use real::{Gamma, Lift, Real, Special, order};
pub use wide::Wide;
