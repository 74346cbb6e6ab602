//! The expansions one by one: against each other at higher precision, and cut short.

use mdr_core::number::{Interval, Precision, Real};
use rug::Float;

use super::*;

fn assert_encloses(kappa: &Interval, exact: &Interval, bits: u32, what: &dyn std::fmt::Display) {
    let inside = kappa.lower() <= exact.lower() && exact.upper() <= kappa.upper();
    assert!(inside, "{what}, {bits} bits: {kappa} does not contain {exact}");
    assert!(kappa.accuracy_bits() >= i64::from(bits) - 2, "{what}, {bits} bits: {kappa}");
}

/// Beyond what Γ of MPFR can do in a test: runs of long integers against the continued fraction at twice the precision.
#[test]
fn many_digits_of_two_expansions_agree() {
    for n in [(1, 3), (7, 5), (4, 1), (41, 2)].map(rug::Rational::from) {
        for bits in [3000, 5990, 6010, 13_000] {
            let sharp = by_continued_fraction(&n, bits);
            assert_encloses(&kappa_enclosure(Precision::new(bits), &n), &sharp, bits, &n);
            let series = rational::expansion(&n, bits + 20).enclosure(Precision::new(bits));
            assert_encloses(&series, &sharp, bits, &n);
        }
    }
}

/// Twice the precision.
fn by_continued_fraction(n: &rug::Rational, bits: u32) -> Interval {
    shifted::kappa(&Float::with_val(2 * bits, n), 2 * bits).enclosure(Precision::new(2 * bits))
}

/// Every residue and parity of every denominator, up to the largest n that a mean serves and beyond.
#[test]
fn means_agree_with_the_continued_fraction() {
    for bits in [8, 53, 64, 200, 1000, 1100, 3400] {
        for q in 1..=5 {
            let largest = bits * q;
            for p in (1..=2 * q + 2).chain([7 * q + 1, largest - 1, largest, largest + 1]) {
                let n = rug::Rational::from((p, q));
                let reached = *n.denom() < 5 && n <= bits;
                let found = elliptic::kappa(&n, bits);
                assert_eq!(found.is_some(), reached, "n = {n}, {bits} bits");
                let Some(found) = found else { continue };
                assert!(found.roundings() < 8, "n = {n}, {bits} bits: {found:?}");
                let found = found.enclosure(Precision::new(bits - 4));
                assert_encloses(&found, &by_continued_fraction(&n, bits), bits - 4, &n);
            }
        }
    }
}

/// The result is independent of the numbers cached by earlier calls at any precision.
#[test]
fn a_mean_that_was_kept_is_that_of_a_first_call() {
    for n in [(1, 2), (3, 2), (1, 3), (2, 3), (7, 4), (13, 3)].map(rug::Rational::from) {
        for bits in [2000, 2056, 2072, 53, 1000, 1999, 3000, 2000] {
            let kappa = || elliptic::kappa(&n, bits).map(|kappa| kappa.value().clone());
            let first = std::thread::scope(|scope| scope.spawn(kappa).join().unwrap());
            assert_eq!(kappa(), first, "n = {n}, {bits} bits");
        }
    }
}

/// A truncated expansion is enclosed by its remainder, which is not much larger than the error.
#[test]
fn remainders_are_bounds_and_not_generous() {
    for (numerator, denominator) in [(1, 3), (1, 2), (3, 2), (7, 1), (41, 4)] {
        let n = rug::Rational::from((numerator, denominator));
        let point = Interval::from_rational(Precision::new(400), &n);
        let sharp = Float::kappa(&Float::with_val(500, &n));
        let slope = Float::ln_kappa_derivative(&Float::with_val(500, &n), 1);
        for terms in [6, 9, 14] {
            let check = |enclosure: Interval, value: &Float| {
                assert!(enclosure.contains(value), "n = {n}, {terms} terms: {enclosure} {value}");
                let error: Float = enclosure.mid() - value;
                assert!(enclosure.radius() < error.abs() * 40u32, "n = {n}, {terms} terms: {enclosure}");
            };
            check(series::kappa(&point, terms), &sharp);
            check(brouncker::kappa(&point, terms), &sharp);
            let sequence = |j: i64| point.lit(1) / (point.lit(j + 1) + &point);
            let sum = alternating::alternating_sum(&point, i64::from(terms), sequence);
            // 2a₀/T_N(3) relative, and up to two bits of the measure itself.
            assert!(sum.contains(&slope) && sum.accuracy_bits() > i64::from(terms) * 5 / 2 - 5);
        }
    }
}

/// Without guard bits the count alone says how far a value may be off: a series that ends a term too early shows.
#[test]
fn counts_of_few_bits_bound_the_error() {
    for bits in 8..=48 {
        let check = |what: &str, n: &rug::Rational, found: mdr_core::number::RoundingCount| {
            let truth = Float::kappa(&Float::with_val(500, n));
            let enclosure = found.enclosure(Precision::new(400));
            assert!(enclosure.contains(&truth), "{what}, n = {n}, {bits} bits: {found:?} is not {truth}");
        };
        for (p, q) in [(1, 7), (3, 10), (2, 5), (1, 100), (4, 9), (6, 5), (7, 5), (11, 6), (12, 5)] {
            let n = rug::Rational::from((p, q));
            check("series", &n, rational::expansion(&n, bits));
        }
        for (p, q) in [(1, 2), (3, 4), (1, 3), (5, 3), (7, 2), (6, 1), (8, 1)] {
            let n = rug::Rational::from((p, q));
            if let Some(mean) = elliptic::kappa(&n, bits) {
                check("mean", &n, mean);
            }
        }
        // Numbers of five bits, which are exact.
        for (p, q) in [(1, 16), (5, 8), (13, 8), (21, 4), (19, 1), (31, 1), (480, 1)] {
            let n = rug::Rational::from((p, q));
            check("fraction", &n, shifted::kappa(&Float::with_val(bits, &n), bits));
        }
    }
}

/// The number of terms leaves what it says: twice the first term that is left out, which is the width of the enclosure.
#[test]
fn as_many_terms_as_the_bits_need() {
    for bits in (8..=200).step_by(8) {
        for n in [0.01, 0.3, 1.7, 5.1, 12.3, 40.7] {
            let point = Interval::point(Float::with_val(600, n));
            let found = series::kappa(&point, series::terms(n, bits));
            assert!(found.radius() <= Float::with_val(600, 2) >> bits, "n = {n}, {bits} bits: {found:?}");
        }
    }
}
