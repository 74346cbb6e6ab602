//! From enclosures and from two precisions to decimals.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Quantity, Result, Status};
use mdr_core::number::certify::{Decimal, Enclosure, next_precision};
use mdr_core::number::{Interval, Precision, Real};
use rug::Float;

use super::record::{Field, Record, numbers, paired};
use crate::number::Number;

/// Bits beyond those of the digits asked for, to begin with.
pub(crate) const GUARD: u32 = 32;

/// The precision at which a proved number that may be zero, or a decision, is left undecided, over that to begin with. A number
/// that is not zero has its digits at any precision that is [needed](next_precision).
const MOST: u32 = 80;
/// The most bits for any number.
const LIMIT: u32 = 1 << 21;

/// The same for estimated numbers, whose quadratures grow much faster with the precision.
const ESTIMATES: u32 = 3;

/// The precision to begin with.
pub(crate) fn start(digits: u32) -> Precision {
    Precision::new(Precision::from_digits(digits).bits().saturating_add(GUARD).max(64))
}

/// The next precision.
pub(crate) fn raised(precision: Precision) -> Precision {
    Precision::new(precision.bits().saturating_add(precision.bits() / 2))
}

/// A precision from which a number is rounded to this one as if it were exact.
pub(crate) fn guarded(precision: Precision) -> Precision {
    Precision::new(precision.bits().saturating_add(GUARD))
}

/// Evaluates `f` at growing precision until the enclosures decide every number to `digits` significant digits, correctly
/// rounded. A number that stays open, as zero or a decimal tie does when its enclosure is not exact, is undecided.
///
/// # Errors
/// Those of `f`; [`Error::Undecided`] only when it is the last attempt that returns it.
pub(crate) fn proved(
    digits: u32,
    f: impl FnMut(Precision) -> Result<Vec<Record<Enclosure>>>,
) -> Result<Vec<Record<Number>>> {
    proved_from(start(digits), digits, f)
}

/// The same, beginning with a given precision.
///
/// # Errors
/// As [`proved`].
pub(crate) fn proved_from(
    mut precision: Precision,
    digits: u32,
    mut f: impl FnMut(Precision) -> Result<Vec<Record<Enclosure>>>,
) -> Result<Vec<Record<Number>>> {
    let begin = start(digits);
    let mut decided: Vec<Option<Decimal>> = Vec::new();
    loop {
        let last = precision.bits() >= MOST.saturating_mul(begin.bits());
        precision = match f(precision) {
            Err(Error::Undecided { .. }) if !last => next_precision(begin, precision, [None]),
            Err(error) => return Err(error),
            Ok(records) => {
                round(&records, digits, &mut decided);
                let open: Vec<&Enclosure> = still_open(&records, &decided).collect();
                let hopeless = last && !open.iter().all(|enclosure| enclosure.is_short_of(begin));
                if open.is_empty() || hopeless || precision.bits() >= LIMIT {
                    let bits = precision.bits();
                    let why =
                        format!("{bits} bits do not decide the digits: zero, or a decimal tie, as far as they tell");
                    return Ok(written(records, decided, &why));
                }
                next_precision(begin, precision, open.into_iter().map(Some))
            }
        };
    }
}

/// Those that are not decided yet.
fn still_open<'a>(
    records: &'a [Record<Enclosure>],
    decided: &'a [Option<Decimal>],
) -> impl Iterator<Item = &'a Enclosure> {
    numbers(records).into_iter().zip(decided).filter(|(_, decimal)| decimal.is_none()).map(|(enclosure, _)| enclosure)
}

/// Numbers of which no error but that of their rounding is known.
pub(crate) fn rounded<R: Real>(records: Vec<Record<R>>) -> Vec<Record<Estimate<R>>> {
    records.into_iter().map(|record| record.convert(exact)).collect()
}

/// A number without an error of its own.
pub(crate) fn exact<R: Real>(value: R) -> Estimate<R> {
    Estimate { error: value.lit(0), value, evaluations: 0 }
}

/// Evaluates `f` at two precisions and takes their difference, and what the finer one estimates, for the error; raises both
/// until all `digits` are certain by it. What is not then is not printed.
///
/// # Errors
/// Those of `f`.
pub(crate) fn estimated(
    digits: u32,
    mut f: impl FnMut(Precision) -> Result<Vec<Record<Estimate<Float>>>>,
) -> Result<Vec<Record<Number>>> {
    let mut precision = start(digits);
    let mut coarse = f(precision)?;
    let mut next = raised(precision);
    for attempt in 1.. {
        let tried = std::mem::replace(&mut precision, next);
        next = raised(precision);
        let fine = f(precision)?;
        let Some((records, agree)) = compared(&coarse, fine.clone()) else {
            if attempt == ESTIMATES {
                return Err(Error::Undecided {
                    quantity: Quantity::ContactRadius,
                    bits: precision.bits(),
                    what: "how many equilibria there are",
                });
            }
            coarse = fine;
            continue;
        };
        let mut decided = Vec::new();
        round(&records, digits, &mut decided);
        // What is marked as undecided may have a number in more bits.
        let open = decided.iter().any(Option::is_none) || !agree || records.iter().any(Record::is_open);
        if !open || attempt == ESTIMATES {
            for (decimal, enclosure) in decided.iter_mut().zip(numbers(&records)) {
                *decimal = decimal.take().or_else(|| (1..digits).rev().find_map(|fewer| enclosure.round(fewer)));
            }
            let why = format!("two precisions do not agree on a digit, the finer of {} bits", precision.bits());
            return Ok(written(records, decided, &why));
        }
        // The fine one may have all its digits already, but the coarse one did not.
        let lost = next_precision(start(digits), tried, still_open(&records, &decided).map(Some));
        next = Precision::new(lost.bits().clamp(next.bits(), MOST * start(digits).bits()));
        coarse = fine;
    }
    Ok(Vec::new())
}

/// The finer records, each number with the difference of the two and its own error on both sides, and whether both have them
/// all; one that either lacks is lacking, for its reason. None where they differ in their form.
fn compared(
    coarse: &[Record<Estimate<Float>>],
    fine: Vec<Record<Estimate<Float>>>,
) -> Option<(Vec<Record<Enclosure>>, bool)> {
    let mut agree = true;
    let records = paired(fine, coarse, &mut |fine, coarse| {
        agree &= matches!(fine, Field::Number(_)) == matches!(coarse, Field::Number(_));
        match (fine, coarse) {
            (Field::Number(fine), Field::Number(coarse)) => Some(Field::Number(around(fine, coarse))),
            (Field::Number(_), lacking @ Field::Marked { .. }) => Some(lacking.clone().without_number()),
            (Field::Number(_), _) | (Field::Absent | Field::Word(_) | Field::Flag(_), Field::Number(_)) => None,
            (fine, coarse) => (fine == *coarse || matches!(fine, Field::Marked { .. })).then(|| fine.without_number()),
        }
    })?;
    Some((records, agree))
}

/// A number, and how far another one is from it and its own error on both sides.
fn around(fine: Estimate<Float>, coarse: &Estimate<Float>) -> Enclosure {
    let change = Float::with_val(fine.value.prec(), &coarse.value - &fine.value);
    let error = Interval::point(change).abs() + Interval::point(fine.error);
    Enclosure::Value(Interval::point(fine.value).inflate(&error))
}

/// Rounds what is not decided yet.
fn round(records: &[Record<Enclosure>], digits: u32, decided: &mut Vec<Option<Decimal>>) {
    let enclosures = numbers(records);
    // The number of equilibria is no function of the precision; if it were, nothing before would count.
    if decided.len() != enclosures.len() {
        *decided = vec![None; enclosures.len()];
    }
    for (decimal, enclosure) in decided.iter_mut().zip(enclosures) {
        *decimal = decimal.take().or_else(|| enclosure.round(digits));
    }
}

fn written(records: Vec<Record<Enclosure>>, decided: Vec<Option<Decimal>>, why: &str) -> Vec<Record<Number>> {
    let mut decided = decided.into_iter();
    let mut write = |_| match decided.next().flatten() {
        Some(decimal) => Field::Number(Number::Decimal(decimal.to_string())),
        None => Field::Marked { status: Status::Undecided, log10: None, why: Some(why.to_owned()) },
    };
    records.into_iter().map(|record| record.map(&mut write)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn only(records: Vec<Record<Number>>) -> String {
        match records[0].get("x") {
            Some(Field::Number(number)) => number.to_string(),
            field => format!("{field:?}"),
        }
    }

    fn record<N>(number: N) -> Vec<Record<N>> {
        vec![Record::new().with("x", Field::Number(number))]
    }

    #[test]
    fn proved_digits_are_those_of_the_enclosure() {
        // (10¹⁰ + 1)^½ − 10⁵ = 5·10⁻⁶ − 1.25·10⁻¹⁶ + … loses 34 bits: the precision rises until the digits are decided.
        let difference = |precision| {
            let large = Interval::from_int(precision, 10).powi(5);
            Ok(record(Enclosure::Value((large.square() + large.lit(1)).sqrt() - large)))
        };
        assert_eq!(only(proved(20, difference).unwrap()), "0.0000049999999998750000000");
        // A zero that is not exact is never decided, and is not printed as a zero.
        let zero = |precision| {
            let third = Interval::from_int(precision, 1).over(3);
            Ok(record(Enclosure::Value(third.clone() - &third)))
        };
        let open = proved(5, zero).unwrap();
        assert_eq!(open[0].status(), Status::Undecided);
    }

    /// A number that one precision lacks takes none of the others along, and is asked for again.
    #[test]
    fn a_number_that_one_precision_lacks() {
        let third = |precision| Float::from_int(precision, 1).over(3);
        let mut calls = 0;
        let lacking = |from: usize| {
            move |precision| {
                calls += 1;
                let error = Error::NoConvergence { quantity: Quantity::Energy, evaluations: 9, error: 1e-9 };
                let second = if calls > from { Ok(third(precision)) } else { Err(error) };
                Ok(rounded(vec![Record::new().with("x", Field::Number(third(precision))).number("y", second)?]))
            }
        };
        let found = estimated(5, lacking(1)).unwrap().remove(0);
        assert_eq!(found.status(), Status::Ok);
        let open = estimated(5, lacking(3)).unwrap();
        assert!(open[0].status() == Status::Undecided && open[0].why().unwrap().contains("no convergence"));
        assert_eq!(only(open), "0.33333");
    }

    #[test]
    fn estimated_digits_are_those_on_which_two_precisions_agree() {
        // An error of 10⁻¹² at every precision, of alternating sign.
        let mut sign = 1;
        let noisy = |precision: Precision| {
            sign = -sign;
            let third = Float::from_int(precision, 1).over(3);
            Ok(rounded(record(third + Float::from_int(precision, sign) * Float::from_int(precision, 10).powi(-12))))
        };
        let text = only(estimated(20, noisy).unwrap());
        assert!(text.starts_with("0.33333") && text.len() < 16, "{text}");
        let clean = |precision| Ok(rounded(record(Float::from_int(precision, 1).over(3))));
        assert_eq!(only(estimated(20, clean).unwrap()), "0.33333333333333333333");
        // Noise around zero has no digits.
        let mut sign = 1;
        let noise = |precision: Precision| {
            sign = -sign;
            Ok(rounded(record(Float::from_int(precision, sign) >> precision.bits())))
        };
        assert_eq!(estimated(20, noise).unwrap()[0].status(), Status::Undecided);
    }

    #[test]
    fn an_error_of_its_own_costs_a_number_its_digits_and_no_other_number() {
        // Both precisions agree on a third with an error of 10⁻⁹; beside it a number that the first does not have.
        let mut first = true;
        let records = |precision: Precision| {
            let third = Float::from_int(precision, 1).over(3);
            let known = Field::Number(exact(third.clone()));
            let error = Float::from_int(precision, 10).powi(-9);
            let late = if std::mem::take(&mut first) {
                Field::Marked { status: Status::Undecided, log10: None, why: None }
            } else {
                known.clone()
            };
            let rough = Field::Number(Estimate { value: third, error, evaluations: 0 });
            Ok(vec![Record::new().with("late", late).with("x", rough).with("y", known)])
        };
        let answer = estimated(12, records).unwrap();
        let text = |key| match answer[0].get(key) {
            Some(Field::Number(number)) => number.to_string(),
            field => format!("{field:?}"),
        };
        assert_eq!((text("x"), text("y"), text("late")), ("0.33333333".into(), "0.333333333333".into(), text("y")));
    }
}
