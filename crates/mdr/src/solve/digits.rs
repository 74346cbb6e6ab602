//! From enclosures to decimals.

use mdr_core::contact::{Error, Result, Status};
use mdr_core::number::Precision;
use mdr_core::number::certify::{Decimal, Enclosure, next_precision};

use crate::answer::record::{Cell, Numbers, Row, cells};
use crate::answer::{Number, Value};

/// Bits beyond those of the requested digits, to begin with.
const GUARD: u32 = 32;

/// The precision at which a proved number that may be zero, or a decision, is left undecided, over that to begin with. A number
/// that is not zero has its digits at any precision that is [needed](next_precision).
pub(crate) const MOST: u32 = 80;
/// The most for integrals, whose cost grows much faster with the precision.
pub(crate) const MOST_OF_INTEGRALS: u32 = 6;
/// The most for decisions, such as those of a path, where g is an integral.
pub(crate) const MOST_OF_DECISIONS: u32 = 16;
/// The most bits for any number.
const LIMIT: u32 = 1 << 21;

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
/// Errors of `f`; [`Error::Undecided`] only when it is the last attempt that returns it.
pub(crate) fn decide<T: Numbers<Enclosure>>(
    digits: u32,
    f: impl FnMut(Precision) -> Result<T>,
) -> Result<T::With<Number>> {
    decide_from(start(digits), digits, f)
}

/// Evaluates `f` at growing precision like [`decide`], beginning with a given precision.
///
/// # Errors
/// Errors of `f`; [`Error::Undecided`] only when it is the last attempt that returns it.
pub(crate) fn decide_from<T: Numbers<Enclosure>>(
    precision: Precision,
    digits: u32,
    f: impl FnMut(Precision) -> Result<T>,
) -> Result<T::With<Number>> {
    decide_within(MOST, precision, digits, f)
}

/// Evaluates `f` at growing precision like [`decide_from`], up to `most` times the precision to begin with for all that may be
/// left undecided: 80 for closed forms, fewer for integrals.
///
/// # Errors
/// Errors of `f`; [`Error::Undecided`] only when it is the last attempt that returns it.
pub(crate) fn decide_within<T: Numbers<Enclosure>>(
    most: u32,
    mut precision: Precision,
    digits: u32,
    mut f: impl FnMut(Precision) -> Result<T>,
) -> Result<T::With<Number>> {
    let begin = start(digits);
    let mut decided: Vec<Option<Decimal>> = Vec::new();
    loop {
        let last = precision.bits() >= most.saturating_mul(begin.bits());
        precision = match f(precision) {
            Err(Error::Undecided { .. }) if !last => next_precision(begin, precision, [None]),
            Err(error) => return Err(error),
            Ok(records) => {
                let rows = records.rows();
                let enclosures = known(&rows);
                round(&enclosures, digits, &mut decided);
                let open: Vec<&Enclosure> = still_open(&enclosures, &decided).collect();
                let hopeless = last && !open.iter().all(|enclosure| enclosure.is_short_of(begin));
                if open.is_empty() || hopeless || precision.bits() >= LIMIT {
                    let bits = precision.bits();
                    let why =
                        format!("{bits} bits do not decide the digits: zero, or a decimal tie, as far as they tell");
                    return Ok(written(records, decided, Number::Certified, &why));
                }
                next_precision(begin, precision, open.into_iter().map(Some))
            }
        };
    }
}

/// By how many digits fewer all numbers of a record may be decided, where one of them is near a decimal tie.
const FEWER: u32 = 3;

/// The digits of enclosures on which no more work is spent: so many, or somewhat fewer if those are decided in all of them.
pub(crate) fn as_far_as_known<T: Numbers<Enclosure>>(digits: u32, records: T) -> T::With<Number> {
    let at = |digits: u32| {
        let mut decided = Vec::new();
        round(&known(&records.rows()), digits, &mut decided);
        decided
    };
    let least = digits.saturating_sub(FEWER).max(1);
    let all = (least..=digits).rev().map(at).find(|decided| decided.iter().all(Option::is_some));
    let decided = all.unwrap_or_else(|| at(digits));
    written(
        records,
        decided,
        Number::Certified,
        "the precision that was reached before the work ended does not decide its digits",
    )
}

/// The numbers of rows, in their order.
fn known<'a, N>(rows: &[Row<'a, N>]) -> Vec<&'a N> {
    let number = |(_, cell): (_, &Cell<'a, N>)| match *cell {
        Cell::Value(Value::Known(number)) => Some(number),
        _ => None,
    };
    cells(rows).into_iter().filter_map(number).collect()
}

/// Those that are not decided yet.
fn still_open<'a>(enclosures: &[&'a Enclosure], decided: &[Option<Decimal>]) -> impl Iterator<Item = &'a Enclosure> {
    enclosures.iter().zip(decided).filter(|(_, decimal)| decimal.is_none()).map(|(enclosure, _)| *enclosure)
}

/// Rounds the enclosures that are not decided yet.
fn round(enclosures: &[&Enclosure], digits: u32, decided: &mut Vec<Option<Decimal>>) {
    // The number of equilibria is no function of the precision; if it were, nothing before would count.
    if decided.len() != enclosures.len() {
        *decided = vec![None; enclosures.len()];
    }
    for (decimal, enclosure) in decided.iter_mut().zip(enclosures) {
        *decimal = decimal.take().or_else(|| enclosure.round(digits));
    }
}

fn written<T: Numbers<Enclosure>>(
    records: T,
    decided: Vec<Option<Decimal>>,
    promise: fn(Decimal) -> Number,
    why: &str,
) -> T::With<Number> {
    let mut decided = decided.into_iter();
    records.resolve(|_| match decided.next().flatten() {
        Some(decimal) => Value::Known(promise(decimal)),
        None => Value::unknown(Status::Undecided, why),
    })
}

#[cfg(test)]
#[path = "../../tests/private/digits.rs"]
mod tests;
