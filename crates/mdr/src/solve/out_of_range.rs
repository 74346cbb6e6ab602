//! Results beyond the range of f64: computed in certified digits, rounded to the nearest double where there is one, and
//! marked with log10 where there is none.

use mdr_core::number::Decimal;

use crate::answer::{Number, Output, Promise, Value};

/// More than fix the nearest double.
pub(crate) const DIGITS: u32 = 25;

/// An output in decimals, rounded to doubles.
pub(super) fn in_doubles(output: Output) -> Output {
    output.resolve(Promise::F64, |number| match number {
        Number::Certified(decimal) => nearest(&decimal),
        double => Value::Known(double),
    })
}

/// The nearest double, or the status and log₁₀ of a number that has none.
fn nearest(decimal: &Decimal) -> Value {
    let nearest = decimal.to_f64();
    if decimal.is_zero() || nearest.abs() >= f64::MIN_POSITIVE && nearest.is_finite() {
        return Value::Known(Number::F64(nearest));
    }
    Value::out_of_range(decimal.log10_f64())
}

#[cfg(test)]
mod tests {
    use mdr_core::contact::Status;
    use mdr_core::number::certify::Enclosure;
    use rug::ops::Pow;

    use super::*;

    #[test]
    fn what_no_double_holds_has_a_logarithm() {
        let power = |exponent: i32| rug::Rational::from(10).pow(exponent);
        let of = |value: rug::Rational| nearest(&Enclosure::Exact(value).round(5).unwrap());
        assert_eq!(of(rug::Rational::new()), Value::Known(Number::F64(0.0)));
        assert_eq!(of(power(300) * rug::Rational::from((-3, 2))), Value::Known(Number::F64(-1.5e300)));
        let Value::Unknown { status: Status::Overflow, log10: Some(log10), .. } = of(-power(400)) else { panic!() };
        assert!((log10 - 400.0).abs() < 1e-12);
        assert_eq!(of(power(-320)).status(), Status::Underflow);
    }
}
