//! From enclosures and from two precisions to decimals.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Quantity, Result, Status};
use mdr_core::number::certify::{Decimal, Enclosure, next_precision};
use mdr_core::number::{Interval, Precision, Real};
use rug::Float;

use crate::answer::record::{Cell, Numbers, Row, cells};
use crate::answer::{Number, Value};

/// Bits beyond those of the requested digits, to begin with.
const GUARD: u32 = 32;

/// The precision at which a proved number that may be zero, or a decision, is left undecided, over that to begin with. A number
/// that is not zero has its digits at any precision that is [needed](next_precision).
pub(crate) const MOST: u32 = 80;
/// The most for integrals, whose cost grows much faster with the precision.
pub(crate) const MOST_OF_INTEGRALS: u32 = 6;
/// The most bits for any number.
const LIMIT: u32 = 1 << 21;

/// The most attempts for estimated numbers, whose quadratures grow much faster with the precision.
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

/// Bits to which a quadrature is exact that is accepted in a certified answer.
pub(crate) fn bits_of_quadratures(digits: u32) -> i64 {
    i64::from(start(digits).bits() - GUARD / 2)
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

/// Evaluates `f` at two precisions and takes their difference and the error estimate of the finer one for the error; raises both
/// until all `digits` are certain by it. Digits that are not certain then are not printed.
///
/// # Errors
/// Errors of `f`.
pub(crate) fn agree<T: Numbers<Estimate<Float>> + Clone>(
    digits: u32,
    mut f: impl FnMut(Precision) -> Result<T>,
) -> Result<<T::With<Enclosure> as Numbers<Enclosure>>::With<Number>> {
    let mut precision = start(digits);
    let mut coarse = f(precision)?;
    let mut next = raised(precision);
    let mut attempt = 1;
    loop {
        let tried = std::mem::replace(&mut precision, next);
        next = raised(precision);
        let fine = f(precision)?;
        let Some((records, both)) = compared(&coarse, fine.clone()) else {
            if attempt == ESTIMATES {
                return Err(Error::Undecided {
                    quantity: Quantity::ContactRadius,
                    bits: precision.bits(),
                    what: "how many equilibria there are",
                });
            }
            coarse = fine;
            attempt += 1;
            continue;
        };
        let mut decided = Vec::new();
        let rows = records.rows();
        let enclosures = known(&rows);
        round(&enclosures, digits, &mut decided);
        // What is marked as undecided may have a number in more bits.
        let open = decided.iter().any(Option::is_none) || !both || rows.iter().any(Row::is_open);
        if !open || attempt == ESTIMATES {
            for (decimal, enclosure) in decided.iter_mut().zip(&enclosures) {
                *decimal = decimal.take().or_else(|| (1..digits).rev().find_map(|fewer| enclosure.round(fewer)));
            }
            let why = format!("two precisions do not agree on a digit, the finer of {} bits", precision.bits());
            return Ok(written(records, decided, Number::Estimated, &why));
        }
        // The fine one may have all its digits already, but the coarse one did not.
        let needed = next_precision(start(digits), tried, still_open(&enclosures, &decided).map(Some));
        next = Precision::new(needed.bits().clamp(next.bits(), MOST * start(digits).bits()));
        coarse = fine;
        attempt += 1;
    }
}

/// The finer records, each number with the difference of the two and its own error on both sides, and whether both have them all;
/// one that either lacks is lacking, for its reason. `None` if they differ in their form.
fn compared<T: Numbers<Estimate<Float>>>(coarse: &T, fine: T) -> Option<(T::With<Enclosure>, bool)> {
    let (rows, others) = (fine.rows(), coarse.rows());
    let (ones, others) = (cells(&rows), cells(&others));
    let mut pairs = ones.iter().zip(&others);
    let is_alike = pairs.all(|((key, cell), (other_key, other))| key == other_key && have_one_form(cell, other));
    if ones.len() != others.len() || !is_alike {
        return None;
    }
    let differ = || Value::unknown(Status::Undecided, "two precisions differ in their form");
    let mut both = true;
    let mut merged = Vec::new();
    for ((_, fine), (_, coarse)) in ones.into_iter().zip(others) {
        let (Cell::Value(fine), Cell::Value(coarse)) = (fine, coarse) else { continue };
        both &= matches!(fine, Value::Known(_)) == matches!(coarse, Value::Known(_));
        merged.push(match (fine, coarse) {
            (Value::Known(fine), Value::Known(coarse)) => Value::Known(around(fine, coarse)),
            (Value::Known(_), Value::Unknown { status, log10, why }) | (Value::Unknown { status, log10, why }, _) => {
                Value::Unknown { status: *status, log10: *log10, why: why.clone() }
            }
            (Value::Known(_), Value::Given(_)) => differ(),
            (Value::Given(literal), _) => Value::Given(literal.clone()),
        });
    }
    let mut merged = merged.into_iter();
    Some((fine.map_values(&mut |_| merged.next().unwrap_or_else(differ)), both))
}

/// Whether cells of two records of one form can stand under one key; numbers may differ.
fn have_one_form<N>(one: &Cell<'_, N>, other: &Cell<'_, N>) -> bool {
    match (one, other) {
        (Cell::Value(_), Cell::Value(_)) | (Cell::Absent, Cell::Absent) => true,
        (Cell::UnknownStability(_), Cell::UnknownStability(_) | Cell::Flag(_)) => true,
        (Cell::Rows(ones), Cell::Rows(others)) => ones.len() == others.len(),
        (Cell::Literal(one), Cell::Literal(other)) => one == other,
        (Cell::Word(one), Cell::Word(other)) => one == other,
        (Cell::Flag(one), Cell::Flag(other)) => one == other,
        _ => false,
    }
}

/// A number, and how far another one is from it and its own error on both sides.
fn around(fine: &Estimate<Float>, coarse: &Estimate<Float>) -> Enclosure {
    let change = Float::with_val(fine.value.prec(), &coarse.value - &fine.value);
    let error = Interval::point(change).abs() + Interval::point(fine.error.clone());
    Enclosure::Value(Interval::point(fine.value.clone()).inflate(&error))
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
