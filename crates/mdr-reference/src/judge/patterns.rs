//! Three ways of losing digits that show in all answers together: single precision, clamped values, an absolute tolerance.

use std::collections::HashSet;

use crate::judge::convention::normal;
use crate::judge::explain::LEAST;
use crate::judge::{Explanation, Judged, Verdict};
use crate::record::{Record, UNIT_ROUNDOFF};

/// The relative distance to a number of single precision up to which an answer of nine digits may be one that was printed.
const PRINTED: f64 = 5e-9;

/// How many answers must be of single precision: a tenth of all numbers of nine digits are as close to one.
const LEAST_SINGLE: usize = 6;

/// The unit roundoff of single precision.
const SINGLE: f64 = 1.0 / 16_777_216.0;

/// The errors that a computation in single precision may have, over the condition and that roundoff.
const ROUNDINGS: f64 = 100.0;

/// Questions with a number beyond this many decades say nothing about single precision, whose range products of three leave.
const DECADES_OF_SINGLE: f64 = 12.0;

/// The factor between the sizes of answers that a tolerance spoils and of those that it leaves.
const SCALES: f64 = 1e3;

/// A finite answer and what it should be.
struct Pair<'a> {
    record: &'a Record,
    certified: f64,
    answer: f64,
    right: bool,
}

impl<'a> Pair<'a> {
    /// `None` unless both are normal doubles.
    fn of(judged: &Judged<'a>) -> Option<Self> {
        let (certified, answer) = (normal(judged.record)?, judged.value?);
        Some(Pair { record: judged.record, certified, answer, right: judged.mark.verdict == Verdict::Right })
    }

    fn error(&self) -> f64 {
        (self.answer - self.certified).abs()
    }

    /// The error that rounding in doubles may cause.
    fn rounding(&self) -> f64 {
        ROUNDINGS * UNIT_ROUNDOFF * self.record.total_condition().max(1.0) * self.certified.abs()
    }
}

/// The patterns in the answers of a report, `not_right` of which are not right.
pub(super) fn found(judged: &[Judged<'_>], not_right: usize) -> Vec<Explanation> {
    let pairs: Vec<Pair<'_>> = judged.iter().filter_map(Pair::of).collect();
    let beyond = |record: &Record| record.decades() > DECADES_OF_SINGLE;
    let is_wrong = |judged: &&Judged<'_>| judged.mark.verdict != Verdict::Right;
    let out_of_range = judged.iter().filter(is_wrong).filter(|judged| beyond(judged.record)).count();
    let in_range: Vec<&Pair<'_>> = pairs.iter().filter(|pair| !beyond(pair.record)).collect();
    let single = single_precision(&in_range, not_right - out_of_range, not_right);
    let is_single = single.is_some();
    let mut units: Vec<&str> = pairs.iter().map(|pair| pair.record.unit.as_str()).collect();
    units.sort_unstable();
    units.dedup();
    let each = units.into_iter().flat_map(|unit| {
        let of_unit: Vec<&Pair<'_>> = pairs.iter().filter(|pair| pair.record.unit == unit).collect();
        let tolerance = absolute_tolerance(&of_unit, unit, not_right).filter(|_| !is_single);
        clamped(&of_unit, unit, not_right).into_iter().chain(tolerance)
    });
    single.into_iter().chain(each).collect()
}

fn explanation(
    name: &str,
    statement: String,
    explained: &[&Pair<'_>],
    not_right: usize,
    digits: u32,
) -> Option<Explanation> {
    let inputs: HashSet<_> = explained.iter().map(|pair| &pair.record.inputs).collect();
    let answers: HashSet<_> = explained.iter().map(|pair| pair.certified.to_bits()).collect();
    (inputs.len().min(answers.len()) >= LEAST).then(|| Explanation {
        names: vec![name.to_owned()],
        statements: vec![statement],
        explained: explained.len(),
        applicable: explained.len(),
        not_right,
        inputs: inputs.len(),
        digits,
    })
}

/// Every answer is a number of single precision, and the `wrong_here` that are not right are off by its rounding errors.
fn single_precision(pairs: &[&Pair<'_>], wrong_here: usize, not_right: usize) -> Option<Explanation> {
    let is_single = |value: f64| {
        let rounded = f64::from(value as f32);
        let has_nine_digits = || format!("{value:.8e}").parse() == Ok(value);
        rounded == value || has_nine_digits() && ((rounded - value) / value).abs() <= PRINTED
    };
    let wrong: Vec<&Pair<'_>> = pairs.iter().copied().filter(|pair| !pair.right).collect();
    let explained = |pair: &&Pair<'_>| {
        pair.error() <= ROUNDINGS * SINGLE * pair.record.total_condition().max(1.0) * pair.certified.abs()
    };
    if !pairs.iter().all(|pair| is_single(pair.answer)) || wrong.len() < wrong_here || !wrong.iter().all(explained) {
        return None;
    }
    // Whole numbers, and other short ones, are of single precision by themselves.
    let telling: Vec<&Pair<'_>> =
        wrong.into_iter().filter(|pair| pair.error() > PRINTED * pair.certified.abs()).collect();
    if telling.len() < LEAST_SINGLE {
        return None;
    }
    let worst = telling.iter().map(|pair| pair.error() / pair.certified.abs()).fold(0.0, f64::max);
    let digits = if worst < 1.0 { (-worst.log10()).floor() as u32 } else { 0 };
    explanation("float32", "your numbers are of single precision (float32)".to_owned(), &telling, not_right, digits)
}

/// Several wrong answers in one unit are one number, which no answer exceeds and which all certified values exceed; or the other way round.
fn clamped(pairs: &[&Pair<'_>], unit: &str, not_right: usize) -> Option<Explanation> {
    for (side, word) in [(1.0, "at most"), (-1.0, "at least")] {
        let most = pairs.iter().map(|pair| side * pair.answer).fold(f64::NEG_INFINITY, f64::max);
        let equal: Vec<&Pair<'_>> =
            pairs.iter().copied().filter(|pair| !pair.right && side * pair.answer == most).collect();
        // A program that always prints one number clamps nothing.
        let others: HashSet<_> =
            pairs.iter().filter(|pair| side * pair.answer != most).map(|pair| pair.answer.to_bits()).collect();
        let bound = side * most + 0.0;
        let unit = if unit == "1" { "" } else { unit };
        let statement = format!("your values are clamped to {word} {} {unit}", shortest(bound)).trim_end().to_owned();
        if others.len() >= LEAST
            && equal.iter().all(|pair| side * pair.certified > most)
            && let Some(found) = explanation("clamped", statement, &equal, not_right, 15)
        {
            return Some(found);
        }
    }
    None
}

/// Small values in one unit have lost digits and large ones have not, with absolute errors of all below one bound.
fn absolute_tolerance(pairs: &[&Pair<'_>], unit: &str, not_right: usize) -> Option<Explanation> {
    let spoiled: Vec<&Pair<'_>> = pairs.iter().copied().filter(|pair| !pair.right).collect();
    let bound = spoiled.iter().map(|pair| pair.error()).fold(0.0, f64::max);
    let largest = spoiled.iter().map(|pair| pair.certified.abs()).fold(0.0, f64::max);
    let left: Vec<&&Pair<'_>> = pairs.iter().filter(|pair| pair.right).collect();
    // Of these some digits are left.
    let rough = spoiled.iter().filter(|pair| pair.error() < 0.1 * pair.certified.abs()).count();
    let scales = left.iter().filter(|pair| pair.certified.abs() >= SCALES * largest).count();
    let contradicts = |pair: &&&Pair<'_>| pair.error() > bound.max(pair.rounding());
    // A loss that is a share of each value would be seen at the large ones.
    if bound == 0.0 || rough < LEAST || scales == 0 || left.iter().any(contradicts) {
        return None;
    }
    let statement = format!(
        "your iteration ends at an absolute tolerance of about {bound:.0e} {unit}, whatever the size of the value"
    );
    explanation("absolute-tolerance", statement, &spoiled, not_right, 0)
}

fn shortest(number: f64) -> String {
    if number == 0.0 || (1e-4..1e16).contains(&number.abs()) { format!("{number}") } else { format!("{number:e}") }
}
