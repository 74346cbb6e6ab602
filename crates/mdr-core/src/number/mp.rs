//! `Real` for `rug::Float`; the significand carries the precision.

use rug::Float;
use rug::float::Constant;
use rug::ops::Pow;

use super::{Gamma, Literal, Real, Special};

/// Bits in the significand of an arbitrary-precision number or of the ends of an interval.
///
/// ```
/// use mdr_core::number::Precision;
/// assert_eq!(Precision::from_digits(50).bits(), 167);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Precision(u32);

impl Precision {
    /// A precision of `bits` bits, at least 2.
    pub fn new(bits: u32) -> Self {
        Precision(bits.max(2))
    }

    /// The bits that represent `digits` decimal digits: ⌈digits · log₂10⌉.
    pub fn from_digits(digits: u32) -> Self {
        // 3402/1024 exceeds log₂10 by 2·10⁻⁴, so the result is never too small.
        let bits = (u64::from(digits) * 3402).div_ceil(1024);
        Precision::new(u32::try_from(bits).unwrap_or(u32::MAX))
    }

    /// The number of bits.
    pub fn bits(self) -> u32 {
        self.0
    }
}

/// Functions of one number, each that of the same name in `rug`.
macro_rules! functions {
    ($($name:ident)*) => {$(
        fn $name(&self) -> Float {
            self.clone().$name()
        }
    )*};
}

impl Real for Float {
    type Ctx = Precision;

    fn ctx(&self) -> Precision {
        Precision(self.prec())
    }
    fn from_int(ctx: Precision, value: i64) -> Float {
        Float::with_val(ctx.0, value)
    }
    fn is_integer(&self, value: i64) -> bool {
        *self == value
    }
    fn from_f64(ctx: Precision, value: f64) -> Float {
        Float::with_val(ctx.0, value)
    }
    fn from_literal(ctx: Precision, literal: &Literal) -> Float {
        Float::with_val(ctx.0, literal.to_rational())
    }
    fn pi(&self) -> Float {
        Float::with_val(self.prec(), Constant::Pi)
    }
    fn times(self, k: i64) -> Float {
        self * k
    }
    fn over(self, k: i64) -> Float {
        self / k
    }
    functions!(abs square sqrt exp exp_m1 ln ln_1p);
    fn pow(&self, exponent: &Float) -> Float {
        Pow::pow(self.clone(), exponent)
    }
    fn powi(&self, exponent: i64) -> Float {
        Pow::pow(self.clone(), exponent)
    }
    fn precision(&self) -> u32 {
        self.prec()
    }
    fn unit_roundoff(&self) -> Float {
        Float::with_val(self.prec(), 1) >> self.prec()
    }
    fn approx(&self) -> f64 {
        self.to_f64()
    }
    fn is_finite(&self) -> bool {
        Float::is_finite(self)
    }
}

impl Special for Float {
    functions!(sin cos atan asin acos sinh cosh tanh log10 atanh);
}

impl Gamma for Float {
    functions!(gamma ln_gamma digamma);
}
