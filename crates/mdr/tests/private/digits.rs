//! Tests of the private items of `mdr::solve::digits`.

use mdr_core::number::{Interval, Real};

use super::*;
use crate::answer::{Balance, Optional};

/// A record of three numbers of which these are the first and the second, and the third is given.
fn record<N>(work: Value<N>, dissipated: Value<N>) -> Vec<Balance<N>> {
    vec![Balance {
        work,
        dissipated,
        stored: Value::Given(0.into()),
        jumps: Optional(None),
        hysteresis: Optional(None),
    }]
}

fn only<N>(number: Value<N>) -> Vec<Balance<N>> {
    record(number, Value::Given(0.into()))
}

fn text(records: &[Balance]) -> String {
    records[0].work.to_string()
}

fn status(records: &[Balance]) -> Status {
    records.to_vec().rows()[0].status()
}

#[test]
fn proved_digits_are_those_of_the_enclosure() {
    // (10¹⁰ + 1)^½ − 10⁵ = 5·10⁻⁶ − 1.25·10⁻¹⁶ + … loses 34 bits: the precision rises until the digits are decided.
    let difference = |precision| {
        let large = Interval::from_int(precision, 10).powi(5);
        Ok(only(Value::Known(Enclosure::Value((large.square() + large.lit(1)).sqrt() - large))))
    };
    assert_eq!(text(&decide(20, difference).unwrap()), "0.0000049999999998750000000");
    // A zero that is not exact is never decided, and is not printed as a zero.
    let zero = |precision| {
        let third = Interval::from_int(precision, 1).over(3);
        Ok(only(Value::Known(Enclosure::Value(third.clone() - &third))))
    };
    assert_eq!(status(&decide(5, zero).unwrap()), Status::Undecided);
}
