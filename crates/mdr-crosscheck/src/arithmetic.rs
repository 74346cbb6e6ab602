//! The two arithmetics of the cases: f64 and rug floats.

use mdr_analytic::profiles::ClosedReal;
use mdr_core::number::{Gamma, Lift, Precision};
use rug::Float;

/// An arithmetic in which closed forms and the numerical route both run.
pub(crate) trait Arithmetic: ClosedReal + Gamma + Lift<Self> {
    /// As the reports call it.
    const NAME: &'static str;

    /// This value, exactly, as a float of at least its precision.
    fn widen(&self) -> Float;

    /// The nearest number of this arithmetic.
    fn round(ctx: Self::Ctx, value: &Float) -> Self;
}

impl Arithmetic for f64 {
    const NAME: &'static str = "f64";

    fn widen(&self) -> Float {
        Float::with_val(f64::MANTISSA_DIGITS, *self)
    }
    fn round((): (), value: &Float) -> f64 {
        value.to_f64()
    }
}

impl Arithmetic for Float {
    const NAME: &'static str = "mp";

    fn widen(&self) -> Float {
        self.clone()
    }
    fn round(ctx: Precision, value: &Float) -> Float {
        Float::with_val(ctx.bits(), value)
    }
}
