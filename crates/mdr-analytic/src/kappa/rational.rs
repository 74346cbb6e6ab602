//! Enclosures of κ_n for a rational n and for an interval: the choice of the expansion.

use mdr_core::number::{Interval, Precision, Real, RoundingCount};
use rug::float::Round;
use rug::{Float, Rational};

use super::blocks::Series;
use super::{elliptic, horner, shifted};

/// An enclosure of κ_n for a rational n > 0, a few units in the last place wide at the given precision.
///
/// Uses an arithmetic-geometric mean for denominators up to 4, cached per thread for later calls; binary splitting if n
/// has few digits, so that ten thousand digits of κ_{3/10} take milliseconds; the expansions for a general n otherwise.
///
/// ```
/// use mdr_analytic::kappa_enclosure;
/// use mdr_core::number::Precision;
/// let kappa = kappa_enclosure(Precision::new(120), &(1, 2).into());
/// assert!(kappa.accuracy_bits() > 110);
/// assert!((kappa.mid().to_f64() - 1.3110287771460599).abs() < 1e-15);
/// ```
pub fn kappa_enclosure(precision: Precision, n: &Rational) -> Interval {
    rational_kappa(Precision::new(precision.bits() + guard(precision.bits())), n).enclosure(precision)
}

/// Bits for the roundings of [`rational_kappa`] and [`interval_kappa`].
fn guard(bits: u32) -> u32 {
    6 + (u32::BITS - bits.leading_zeros())
}

/// Above this number of bits the runs of terms are long integers.
const LONG: u32 = 6000;

/// κ_n for a rational n > 0, computed with the given number of bits.
pub(crate) fn rational_kappa(precision: Precision, n: &Rational) -> RoundingCount {
    let bits = precision.bits();
    elliptic::kappa(n, bits).unwrap_or_else(|| expansion(n, bits))
}

/// κ_n for a rational n > 0 with any denominator, computed with the given number of bits.
pub(super) fn expansion(n: &Rational, bits: u32) -> RoundingCount {
    let series = if n.to_f64() < f64::from(bits) / 16.0 { Series::new(n, bits) } else { None };
    match series {
        Some(series) if bits <= LONG => horner::sum(&series, bits, |from, to| series.double_word(from, to)),
        Some(series) => {
            let run = series.terms_in((bits / 16).max(1024));
            horner::sum(&series, bits, |from, to| series.long(from, to.min(from + run)))
        }
        None => shifted::kappa(&Float::with_val(bits, n), bits),
    }
}

/// κ_n for an interval n ≥ 0. κ increases with n, so a wide interval is evaluated at its ends.
pub(super) fn interval_kappa(n: &Interval) -> Interval {
    const SLACK: i64 = 16;
    let precision = n.ctx();
    let bits = precision.bits() + guard(precision.bits());
    if n.is_point() {
        return shifted::kappa(n.lower(), bits).enclosure(precision);
    }
    if n.accuracy_bits() < i64::from(precision.bits()) - SLACK {
        let end = |end: &Float| shifted::kappa(end, bits).enclosure(precision);
        return Interval::new(end(n.lower()).lower().clone(), end(n.upper()).upper().clone());
    }
    let middle = shifted::kappa(&n.mid(), bits).enclosure(precision);
    // n dκ/dn < κ
    let (radius, _) = Float::with_val_round(53, n.radius() / n.lower(), Round::Up);
    let spread = Interval::point(Float::with_val(precision.bits(), radius)) * &middle;
    middle.inflate(&spread)
}
