//! Random numbers and intervals at random precision, and the criteria for a correct and sharp enclosure.

#![cfg(feature = "mp")]

use std::ops::RangeInclusive;

use mdr_core::number::Interval;
use proptest::prelude::*;
use rug::float::Round;
use rug::{Float, Integer};

/// Precisions of the tests, in bits.
pub(crate) const PRECISIONS: RangeInclusive<u32> = 24..=400;

/// A float of `bits` bits with a binary exponent in the range: random, sparse (powers of two and near them) or dense.
pub(crate) fn float(bits: u32, exponents: RangeInclusive<i32>) -> impl Strategy<Value = Float> {
    let words = prop_oneof![
        4 => any::<[u64; 7]>(),
        1 => any::<u64>().prop_map(|low| [low & 3, 0, 0, 0, 0, 0, 1 << 63]),
        1 => Just([u64::MAX; 7]),
    ];
    (words, exponents).prop_map(move |(words, exponent)| {
        let mantissa = Integer::from_digits(&words, rug::integer::Order::Lsf) | (Integer::from(1) << 447);
        let (mantissa, _) = Float::with_val_round(bits, mantissa, Round::Zero);
        (mantissa >> 448) << exponent
    })
}

/// A float of either sign.
pub(crate) fn signed(bits: u32, exponents: RangeInclusive<i32>) -> impl Strategy<Value = Float> {
    (float(bits, exponents), any::<bool>()).prop_map(|(x, negative)| if negative { -x } else { x })
}

/// Intervals from numbers: points, a few units in the last place wide, and between two random numbers.
pub(crate) fn interval_of<S: Strategy<Value = Float> + Clone + 'static>(numbers: S) -> impl Strategy<Value = Interval> {
    prop_oneof![
        numbers.clone().prop_map(Interval::point),
        (numbers.clone(), 1..5).prop_map(|(lo, steps)| {
            let hi = step(&lo, steps);
            Interval::new(lo, hi)
        }),
        (numbers.clone(), numbers).prop_map(|(a, b)| if a <= b { Interval::new(a, b) } else { Interval::new(b, a) }),
    ]
}

/// `x` shifted by this many units in the last place.
pub(crate) fn step(x: &Float, steps: i32) -> Float {
    let mut x = x.clone();
    for _ in 0..steps.abs() {
        if steps > 0 { x.next_up() } else { x.next_down() }
    }
    x
}

/// Both ends and three numbers between them, at `bits` bits.
pub(crate) fn samples(interval: &Interval, bits: u32) -> Vec<Float> {
    let (lo, hi) = (Float::with_val(bits, interval.lower()), Float::with_val(bits, interval.upper()));
    let between = |k: u32| {
        let point = Float::with_val(bits, &hi - &lo) * k / 4u32 + &lo;
        point.max(&lo).min(&hi)
    };
    (0..=4).map(between).chain([hi.clone()]).collect()
}

/// An enclosure is right when it contains the value at every sample, and sharp when each of its ends is within `ulps`
/// units in the last place of the extreme value among them.
///
/// The values are rounded to nearest at a higher precision. That is a monotone map that leaves the ends of the
/// enclosure unchanged, so both criteria need no tolerance for that rounding.
pub(crate) fn right_and_sharp(enclosure: &Interval, values: &[Float], ulps: i32) -> Result<(), TestCaseError> {
    for value in values {
        prop_assert!(enclosure.contains(value), "{enclosure:?} does not contain {value}");
    }
    let least = values.iter().min_by(|a, b| a.total_cmp(b)).ok_or(TestCaseError::fail("no value"))?;
    let greatest = values.iter().max_by(|a, b| a.total_cmp(b)).ok_or(TestCaseError::fail("no value"))?;
    prop_assert!(step(enclosure.lower(), ulps) >= *least, "{enclosure:?} begins far below {least}");
    prop_assert!(step(enclosure.upper(), -ulps) <= *greatest, "{enclosure:?} ends far above {greatest}");
    Ok(())
}
