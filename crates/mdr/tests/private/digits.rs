//! Tests of the private items of `mdr::solve::digits`.

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

fn exact(value: Float) -> Value<Estimate<Float>> {
    Value::Known(Estimate { error: value.lit(0), value, evaluations: 0 })
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

/// A number that one precision lacks takes none of the others along, and is computed again.
#[test]
fn a_number_that_one_precision_lacks() {
    let third = |precision| Float::from_int(precision, 1).over(3);
    let mut calls = 0;
    let lacking = |from: usize| {
        move |precision| {
            calls += 1;
            let error = Error::NoConvergence { quantity: Quantity::Energy, evaluations: 9, error: 1e-9 };
            let second = if calls > from { Ok(third(precision)) } else { Err(error) };
            let second =
                Value::from_result(second.map(|value| Estimate { error: value.lit(0), value, evaluations: 0 }))?;
            Ok(record(exact(third(precision)), second))
        }
    };
    assert_eq!(status(&agree(5, lacking(1)).unwrap()), Status::Ok);
    let open = agree(5, lacking(3)).unwrap();
    assert!(status(&open) == Status::Undecided && open[0].dissipated.why().unwrap().contains("no convergence"));
    assert_eq!(text(&open), "0.33333");
}

#[test]
fn estimated_digits_are_those_on_which_two_precisions_agree() {
    // An error of 10⁻¹² at every precision, of alternating sign.
    let mut sign = 1;
    let noisy = |precision: Precision| {
        sign = -sign;
        let third = Float::from_int(precision, 1).over(3);
        Ok(only(exact(third + Float::from_int(precision, sign) * Float::from_int(precision, 10).powi(-12))))
    };
    let noisy = text(&agree(20, noisy).unwrap());
    assert!(noisy.starts_with("0.33333") && noisy.len() < 16, "{noisy}");
    let clean = |precision| Ok(only(exact(Float::from_int(precision, 1).over(3))));
    assert_eq!(text(&agree(20, clean).unwrap()), "0.33333333333333333333");
    // Noise around zero has no digits.
    let mut sign = 1;
    let noise = |precision: Precision| {
        sign = -sign;
        Ok(only(exact(Float::from_int(precision, sign) >> precision.bits())))
    };
    assert_eq!(status(&agree(20, noise).unwrap()), Status::Undecided);
}

#[test]
fn an_error_of_its_own_costs_a_number_its_digits_and_no_other_number() {
    // Both precisions agree on a third with an error of 10⁻⁹; beside it a number that the first does not have.
    let mut first = true;
    let records = |precision: Precision| {
        let third = Float::from_int(precision, 1).over(3);
        let known = exact(third.clone());
        let error = Float::from_int(precision, 10).powi(-9);
        let late = if std::mem::take(&mut first) {
            Value::Unknown { status: Status::Undecided, log10: None, why: None }
        } else {
            known.clone()
        };
        let rough = Value::Known(Estimate { value: third, error, evaluations: 0 });
        Ok(vec![Balance {
            work: late,
            dissipated: rough,
            stored: known,
            jumps: Optional(None),
            hysteresis: Optional(None),
        }])
    };
    let answer = agree(12, records).unwrap().remove(0);
    let [late, rough, known] = [&answer.work, &answer.dissipated, &answer.stored].map(Value::to_string);
    assert_eq!((rough, known.clone(), late), ("0.33333333".into(), "0.333333333333".into(), known));
}
