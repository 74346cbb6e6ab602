//! Enclosures from a count of roundings: they contain the result of MPFR at higher precision, and are tight.

#![cfg(feature = "mp")]

use mdr_core::number::{Precision, RoundingCount};
use rug::float::exp_min;
use rug::ops::Pow;
use rug::{Float, Rational};

#[test]
fn powers_and_roots_are_enclosed_and_tight() {
    for bits in [2, 10, 53, 54, 100, 121, 192, 700, 4000] {
        for x in [(1, 3), (2, 1), (123_456_789, 1), (1, 1_000_000_007)].map(Rational::from) {
            for (p, q) in [
                (1, 3),
                (-1, 3),
                (2, 5),
                (-5, 7),
                (5, 2),
                (3, 4),
                (-7, 1),
                (100, 87),
                (11, 499),
                (-499, 500),
                (-997, 3),
                (1000, 999),
                (0, 3),
            ] {
                let power = |bits| RoundingCount::new(Float::with_val(bits, &x), 1).power(p, q);
                let found = power(bits + 24).enclosure(Precision::new(bits));
                // MPFR's power at more than twice the precision.
                let wide = Float::with_val(2 * bits + 100, &x);
                let exact = wide.clone().pow(Float::with_val(wide.prec(), Rational::from((p, q))));
                assert!(found.contains(&exact), "{x}^({p}/{q}), {bits} bits: {found} {exact}");
                assert!(found.accuracy_bits() >= i64::from(bits) - 2, "{x}^({p}/{q}), {bits} bits: {found}");
            }
        }
    }
}

#[test]
fn means_are_enclosed_and_tight() {
    for bits in (2..300).step_by(7).chain([700, 4000]) {
        for (x, y) in [(1, 2), (1, 1), (3, 1), (1_000_000_007, 1_000_000_009), (1, i64::MAX), (355, 113)] {
            for shift in [0, 7, -100_000_000] {
                let number = |value, bits| Float::with_val(bits, value);
                let [a, b] = [x, y].map(|value| RoundingCount::new(number(value, bits + 24), 1));
                let b = RoundingCount::new(b.value().clone() << shift, 1);
                let found = a.agm(&b).enclosure(Precision::new(bits));
                // MPFR's mean at more than twice the precision.
                let exact = number(x, 2 * bits + 100).agm(&(number(y, 2 * bits + 100) << shift));
                assert!(found.contains(&exact), "agm({x}, {y}·2^{shift}), {bits} bits: {found} {exact}");
                assert!(found.accuracy_bits() >= i64::from(bits) - 2, "agm({x}, {y}·2^{shift}): {found}");
            }
        }
    }
}

#[test]
fn the_count_is_in_the_enclosure() {
    let precision = Precision::new(100);
    let number = |roundings| RoundingCount::new(Float::with_val(100, 3), roundings);
    let width = |roundings| number(roundings).enclosure(precision).radius() >> 1_u32;
    // (1+u)^1000 − 1 is more than 999 u.
    assert!(width(1000) * 2u32 > Float::with_val(100, 3 * 999) >> 100);
    assert!(number(u64::MAX).enclosure(precision).is_entire());
    assert!(!number(1 << 61).enclosure(Precision::new(10)).is_entire());
    assert!(RoundingCount::new(Float::with_val(20, 3), 1 << 20).enclosure(precision).is_entire());
    assert!(number(1).times(&number(2)).over(&number(3)).roundings() == 8);
}

#[test]
fn beyond_the_exponents_nothing_is_known() {
    let huge = RoundingCount::new(Float::with_val(60, 1) << (i32::MAX / 2), 0);
    let tiny = RoundingCount::new(Float::with_val(60, 1) >> (i32::MAX / 2), 0);
    assert!(tiny.clone().plus(&tiny).agm(&tiny).enclosure(Precision::new(50)).is_entire());
    assert!(huge.clone().agm(&RoundingCount::new(Float::with_val(60, 0), 0)).enclosure(Precision::new(50)).is_entire());
    assert!(huge.clone().power(100, 1).enclosure(Precision::new(50)).is_entire());
    assert!(huge.power(-100, 3).enclosure(Precision::new(50)).is_entire());
    let one = || RoundingCount::new(Float::with_val(60, 1), 1);
    for (p, q) in [(1, u32::MAX), (i32::MIN, 3), (-1, 1001), (1001, 3)] {
        assert!(one().power(p, q).enclosure(Precision::new(50)).is_entire());
    }
}

/// In any combination: roots halve a count, a factor adds one to it, and a product brings a value back into range.
#[test]
fn what_is_unknown_stays_unknown() {
    let precision = Precision::new(100);
    let number = |value: Float, roundings| RoundingCount::new(value, roundings);
    let three = || Float::with_val(100, 3);
    let least = Float::with_val(100, 1) << exp_min();
    let unknown = [
        number(three(), 1).power(1001, 3),
        number(three(), u64::MAX).times(&number(three(), 1)),
        number(three(), u64::MAX).power(2, 1),
        // 0.7 times the least number is rounded to it.
        number(least.clone(), 0).scaled(&(7, 10).into()),
        number(least, 0).over(&number(Float::with_val(100, 1.4), 0)),
    ];
    for (case, unknown) in unknown.into_iter().enumerate() {
        let root = unknown.clone().sqrt().sqrt().sqrt().sqrt();
        let raised = unknown.clone().times(&number(Float::with_val(100, 1) << 1000, 0));
        let scaled = unknown.clone().scaled(&(3, 7).into()).power(1, 3);
        let beside = number(three(), 1).plus(&unknown).agm(&number(three(), 1)).power(-2, 1);
        for after in [unknown, root, raised, scaled, beside] {
            assert!(after.enclosure(precision).is_entire(), "case {case}: {after:?}");
        }
    }
}
