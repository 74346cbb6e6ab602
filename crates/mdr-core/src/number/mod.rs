//! The arithmetics in which every formula is evaluated, behind one trait.

/// The four operators of a type in the two forms that [`Real`] requires, from the assigning ones.
macro_rules! operators_from_assigning {
    ([$($generics:tt)*] $type:ty) => {
        operators_from_assigning! { [$($generics)*] $type: Add add add_assign }
        operators_from_assigning! { [$($generics)*] $type: Sub sub sub_assign }
        operators_from_assigning! { [$($generics)*] $type: Mul mul mul_assign }
        operators_from_assigning! { [$($generics)*] $type: Div div div_assign }
    };
    ([$($generics:tt)*] $type:ty: $operator:ident $method:ident $assign:ident) => {
        impl<$($generics)*> $operator<&Self> for $type {
            type Output = Self;
            #[inline]
            fn $method(mut self, other: &Self) -> Self {
                self.$assign(other);
                self
            }
        }
        impl<$($generics)*> $operator for $type {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$method(&other)
            }
        }
    };
}

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
pub use analytic::{Analytic, Ends, Euler, NearZero, Rectangle};
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
