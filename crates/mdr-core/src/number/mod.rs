//! The arithmetics in which every formula is evaluated, behind one trait.

#[cfg(feature = "mp")]
mod analytic;
#[cfg(feature = "mp")]
pub mod certify;
#[cfg(feature = "mp")]
mod counted;
mod decimal;
#[cfg(feature = "mp")]
mod double;
mod dual;
mod exact;
mod extended;
mod float;
#[cfg(feature = "mp")]
mod interval;
mod literal;
#[cfg(feature = "mp")]
mod mp;
mod real;

#[cfg(feature = "mp")]
pub use analytic::{Analytic, Ends, Euler, Rectangle};
#[cfg(feature = "mp")]
pub use counted::RoundingCount;
pub use decimal::Decimal;
#[cfg(feature = "mp")]
pub use double::DoubleInterval;
pub use dual::Dual;
pub use exact::Exact;
pub use extended::Extended;
#[cfg(feature = "mp")]
pub use interval::Interval;
pub use literal::{Literal, LiteralError};
#[cfg(feature = "mp")]
pub use mp::Precision;
pub use real::{Gamma, Lift, Real, Special, order};
