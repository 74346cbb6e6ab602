//! Enclosures in hardware: intervals of doubles with outward rounding, where an enclosure needs no more digits.

mod elementary;
mod operators;

use std::cmp::Ordering;

use rug::Float;
use rug::float::Round;

use super::interval::certain_order;
use super::{Interval, Precision};

/// A closed interval of doubles that is proved to contain the exact result, with the rules of an [`Interval`]: a finite enclosure is a
/// proof that every step lay within its domain, and comparison is certain or absent.
///
/// Each end of + − × ÷ and √ is the rounded one or the next double outward. Elementary functions are those of `pxfm`, whose worst error
/// is below one unit in the last place, widened by four of them.
///
/// ```
/// use mdr_core::number::{DoubleInterval, Interval, Precision, Real};
/// let third = DoubleInterval::from_int((), 1).over(3);
/// let exact = Interval::from_int(Precision::new(200), 1).over(3);
/// assert!(third.lower() < third.upper() && third.widened(Precision::new(200)).overlaps(&exact));
/// assert!((third.exp() - DoubleInterval::from_int((), 1)).lower() > 0.39);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DoubleInterval {
    lo: f64,
    hi: f64,
}

impl DoubleInterval {
    /// The entire line: nothing is known.
    pub const ENTIRE: DoubleInterval = DoubleInterval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// [lo, hi]; the entire line when that is not a non-empty interval of real numbers: an end is NaN, the ends are in the wrong order,
    /// or both are the same infinity.
    pub fn new(lo: f64, hi: f64) -> Self {
        let same_infinity = lo == hi && lo.is_infinite();
        if lo <= hi && !same_infinity { DoubleInterval { lo, hi } } else { Self::ENTIRE }
    }

    /// The degenerate interval [value, value]; the entire line when `value` is not finite.
    pub fn point(value: f64) -> Self {
        Self::new(value, value)
    }

    /// The tightest enclosure in doubles.
    ///
    /// ```
    /// use mdr_core::number::{DoubleInterval, Interval, Precision, Real};
    /// let third = Interval::from_int(Precision::new(100), 1).over(3);
    /// let doubles = DoubleInterval::around(&third);
    /// assert!(doubles.lower().next_up() == doubles.upper());
    /// ```
    pub fn around(interval: &Interval) -> Self {
        let end = |end: &Float, round| end.to_f64_round(round);
        Self::new(end(interval.lower(), Round::Down), end(interval.upper(), Round::Up))
    }

    /// The interval in a precision of 53 bits or more, in which it is exact.
    pub fn widened(&self, precision: Precision) -> Interval {
        let end = |end: f64, round| Float::with_val_round(precision.bits(), end, round).0;
        Interval::new(end(self.lo, Round::Down), end(self.hi, Round::Up))
    }

    /// The lower end.
    pub fn lower(&self) -> f64 {
        self.lo
    }

    /// The upper end.
    pub fn upper(&self) -> f64 {
        self.hi
    }

    /// Whether the interval is the entire line.
    pub fn is_entire(&self) -> bool {
        self.lo == f64::NEG_INFINITY && self.hi == f64::INFINITY
    }

    /// The smallest interval that contains both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        DoubleInterval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    fn is_point(&self) -> bool {
        self.lo == self.hi
    }

    fn contains_zero(&self) -> bool {
        self.lo <= 0.0 && self.hi >= 0.0
    }
}

impl PartialEq for DoubleInterval {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for DoubleInterval {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        certain_order([&self.lo, &self.hi], [&other.lo, &other.hi])
    }
}
