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

impl Exact for Literal {
    fn exact(self) -> Result<Literal, LiteralError> {
        Ok(self)
    }
}

impl Exact for &Literal {
    fn exact(self) -> Result<Literal, LiteralError> {
        Ok(self.clone())
    }
}

impl Exact for &str {
    fn exact(self) -> Result<Literal, LiteralError> {
        self.parse()
    }
}

impl Exact for String {
    fn exact(self) -> Result<Literal, LiteralError> {
        self.parse()
    }
}

impl Exact for i64 {
    fn exact(self) -> Result<Literal, LiteralError> {
        Ok(self.into())
    }
}

impl Exact for i32 {
    fn exact(self) -> Result<Literal, LiteralError> {
        Ok(i64::from(self).into())
    }
}

impl Exact for f64 {
    fn exact(self) -> Result<Literal, LiteralError> {
        self.try_into()
    }
}
