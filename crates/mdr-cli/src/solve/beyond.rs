//! Results beyond the range of f64: computed in certified digits, rounded to the nearest double where there is one, and
//! marked with log10 where there is none.

use std::sync::Arc;

use mdr_core::contact::{Result, Status};
use mdr_core::number::Literal;

use super::answer::{Output, Promise};
use super::certified::Certified;
use super::contact::Tally;
use super::record::{Field, Record, numbers};
use crate::number::Number;
use crate::scene::{Scene, Want};

/// More than fix the nearest double.
pub(super) const DIGITS: u32 = 25;

/// Whether an output in f64 has lost numbers to the ends of the range: zeros beside numbers that are none, and what is below
/// the smallest normal double. A record of zeros is a flat face.
pub(super) fn lost_numbers(output: &Output) -> bool {
    let lost = |record: &Record<Number>| {
        let small = |number: &&&Number| matches!(number, Number::Double(x) if x.abs() < f64::MIN_POSITIVE);
        let all = numbers(std::slice::from_ref(record));
        let small = all.iter().filter(small).count();
        small > 0 && small < all.len()
            || record
                .fields()
                .iter()
                .any(|(_, field)| matches!(field, Field::Marked { log10: Some(x), .. } if !x.is_finite()))
    };
    output.want == Want::Transform && output.records.iter().any(lost)
}

/// The output in doubles, with the status and log10 of each number that is none.
///
/// # Errors
/// As [`Certified::output`].
pub(super) fn output(scene: &Scene, want: Want, tally: &Arc<Tally>) -> Result<Output> {
    Ok(in_doubles(Certified::new(scene, DIGITS, tally).output(want)?))
}

/// An output in decimals, rounded to doubles.
pub(super) fn in_doubles(output: Output) -> Output {
    let rounded = |record: Record<Number>| record.map(&mut nearest);
    let Output { want, complete, records, balance, .. } = output;
    let records = records.into_iter().map(rounded).collect();
    Output { complete, balance: balance.map(rounded), ..Output::new(want, Promise::Double, records) }
}

/// The nearest double, or what is known of a number that has none.
fn nearest(number: Number) -> Field<Number> {
    let Number::Decimal(text) = &number else { return Field::Number(number) };
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let log10 = match (mantissa.parse::<f64>(), exponent.parse::<f64>()) {
        (Ok(mantissa), Ok(exponent)) => mantissa.abs().log10() + exponent,
        _ => f64::NAN,
    };
    let nearest = match text.parse::<Literal>() {
        Ok(literal) => literal.nearest_f64(),
        Err(_) if log10 > 0.0 => f64::INFINITY,
        Err(_) => 0.0,
    };
    let normal = nearest.abs() >= f64::MIN_POSITIVE && nearest.is_finite();
    if normal || log10 == f64::NEG_INFINITY {
        return Field::Number(Number::Double(nearest));
    }
    let status = if log10 > 0.0 { Status::Overflow } else { Status::Underflow };
    Field::Marked { status, log10: Some(log10), why: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_no_double_holds_has_a_logarithm() {
        let of = |text: &str| nearest(Number::Decimal(text.to_owned()));
        assert_eq!(of("0"), Field::Number(Number::Double(0.0)));
        assert_eq!(of("-1.5000e+300"), Field::Number(Number::Double(-1.5e300)));
        let Field::Marked { status: Status::Overflow, log10: Some(log10), .. } = of("-1.00e+400") else { panic!() };
        assert!((log10 - 400.0).abs() < 1e-12);
        let Field::Marked { status: Status::Underflow, .. } = of("1.00e-320") else { panic!() };
    }
}
