//! Conversion of exact inputs of any type to literals.

use super::{Literal, LiteralError};

/// A type with an exact decimal or fractional value: a text such as `"1/3"` or `"2e-9"`, an integer, or a double, which
/// stands for the shortest decimal that reads back as itself.
///
/// ```
/// use mdr_core::number::Exact;
/// assert!(0.1.exact()?.compare(&"1/10".exact()?).is_eq());
/// assert!(f64::NAN.exact().is_err());
/// # Ok::<(), mdr_core::number::LiteralError>(())
/// ```
pub trait Exact {
    /// The exact value.
    ///
    /// # Errors
    /// [`LiteralError`] unless it is a finite number.
    fn exact(self) -> Result<Literal, LiteralError>;
}

macro_rules! exact {
    ($($type:ty: |$value:ident| $literal:expr;)*) => {$(
        impl Exact for $type {
            fn exact(self) -> Result<Literal, LiteralError> {
                let $value = self;
                $literal
            }
        }
    )*};
}

exact! {
    Literal: |literal| Ok(literal);
    &Literal: |literal| Ok(literal.clone());
    &str: |text| text.parse();
    String: |text| text.parse();
    i64: |integer| Ok(integer.into());
    i32: |integer| Ok(i64::from(integer).into());
    f64: |double| double.try_into();
}
