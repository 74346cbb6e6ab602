//! Rigorous enclosures: intervals of `rug::Float` with outward rounding.

mod elementary;
mod gamma;
mod operators;
mod trigonometric;

use std::cmp::Ordering;
use std::fmt;

use rug::float::{Round, Special};
use rug::ops::NegAssign;
use rug::{Float, Rational};

use super::{Precision, Real};

/// A closed interval [lower, upper] that is proved to contain the exact result.
///
/// * **Containment**: an operation returns an interval that contains its result for every choice of numbers in the
///   operands; each end is rounded outward, for the elementary functions to the nearest representable number.
/// * **A finite enclosure is a proof that every step lay within its domain.** Where an argument leaves the domain, even
///   in part (√ of [−1, 4], division by an interval that contains 0), the result is the [entire](Self::entire) line, and
///   any operation on the entire line gives the entire line. No end is ever NaN, and lower ≤ upper.
/// * An operation that is exact on points stays a point: `2 · 3` is the degenerate interval [6, 6].
/// * **Comparison is certain or absent**: `<` holds when it holds for all pairs of numbers, `==` only between two equal
///   points. So `x == x` is false for an interval of positive width.
///
/// ```
/// use mdr_core::number::{Interval, Precision, Real};
/// let two = Interval::from_int(Precision::new(64), 2);
/// let root = two.sqrt();
/// assert!(root.square().contains(two.lower()) && root.accuracy_bits() >= 62);
/// assert!((root.clone() - &root).contains_zero());
/// assert!(!(two.clone() / (root.clone() - &root)).is_finite());
/// ```
#[derive(Clone)]
pub struct Interval {
    lo: Float,
    hi: Float,
}

impl Interval {
    /// [lo, hi], in the larger of the two precisions. The entire line when that is not a non-empty interval of real
    /// numbers: an end is NaN, the ends are in the wrong order, or both are the same infinity.
    pub fn new(mut lo: Float, mut hi: Float) -> Self {
        let precision = lo.prec().max(hi.prec());
        for end in [&mut lo, &mut hi] {
            if end.prec() != precision {
                end.set_prec(precision);
            }
        }
        let same_infinity = lo.is_infinite() && lo == hi;
        if lo <= hi && !same_infinity { Interval { lo, hi } } else { Self::entire(Precision::new(precision)) }
    }

    /// The degenerate interval [value, value]; the entire line when `value` is not finite.
    pub fn point(value: Float) -> Self {
        Interval::new(value.clone(), value)
    }

    /// The entire line [−∞, ∞]: nothing is known.
    pub fn entire(precision: Precision) -> Self {
        let end = |end: Special| Float::with_val(precision.bits(), end);
        Interval { lo: end(Special::NegInfinity), hi: end(Special::Infinity) }
    }

    /// The tightest enclosure of a rational; a point when the precision holds it.
    pub fn from_rational(precision: Precision, value: &Rational) -> Self {
        Self::outward(|round| Float::with_val_round(precision.bits(), value, round))
    }

    /// The interval between a quantity rounded down and, unless that was exact, the next number above.
    fn outward(rounded: impl FnOnce(Round) -> (Float, Ordering)) -> Self {
        let (lo, order) = rounded(Round::Down);
        let hi = just_above(&lo, order);
        Interval { lo, hi }
    }

    /// The tightest enclosure of the interval in another precision.
    #[must_use]
    pub fn rounded(&self, precision: Precision) -> Self {
        let end = |end: &Float, round| Float::with_val_round(precision.bits(), end, round).0;
        Interval::new(end(&self.lo, Round::Down), end(&self.hi, Round::Up))
    }

    /// The entire line in the precision of `self`.
    fn nothing_known(&self) -> Self {
        Self::entire(self.ctx())
    }

    /// The lower end.
    pub fn lower(&self) -> &Float {
        &self.lo
    }

    /// The upper end.
    pub fn upper(&self) -> &Float {
        &self.hi
    }

    /// A number near the middle, certainly inside the interval; NaN when the interval is unbounded.
    pub fn mid(&self) -> Float {
        if !self.is_bounded() {
            return Float::with_val(self.lo.prec(), Special::Nan);
        }
        let sum = Float::with_val(self.lo.prec(), &self.lo + &self.hi);
        if sum.is_finite() { sum / 2u32 } else { self.lo.clone() / 2u32 + self.hi.clone() / 2u32 }
    }

    /// A bound on the distance of the ends from [`mid`](Self::mid), rounded up; ∞ when the interval is unbounded.
    pub fn radius(&self) -> Float {
        let precision = self.lo.prec();
        if !self.is_bounded() {
            return Float::with_val(precision, Special::Infinity);
        }
        let mid = self.mid();
        let (above, _) = Float::with_val_round(precision, &self.hi - &mid, Round::Up);
        let (below, _) = Float::with_val_round(precision, &mid - &self.lo, Round::Up);
        above.max(&below)
    }

    /// hi − lo rounded up.
    fn width(&self) -> Float {
        Float::with_val_round(self.lo.prec(), &self.hi - &self.lo, Round::Up).0
    }

    /// Bits of relative accuracy: −log₂(radius/|mid|) rounded down. `i64::MAX` for a point, `i64::MIN` for an interval
    /// whose middle is 0 or that is unbounded.
    pub fn accuracy_bits(&self) -> i64 {
        if self.is_point() {
            return i64::MAX;
        }
        match (self.mid().get_exp(), self.radius().get_exp()) {
            (Some(mid), Some(radius)) => i64::from(mid) - 1 - i64::from(radius),
            _ => i64::MIN,
        }
    }

    /// Whether `value` lies in the interval.
    pub fn contains(&self, value: &Float) -> bool {
        self.lo <= *value && *value <= self.hi
    }

    /// Whether 0 lies in the interval.
    pub fn contains_zero(&self) -> bool {
        self.lo.cmp0() != Some(Ordering::Greater) && self.hi.cmp0() != Some(Ordering::Less)
    }

    /// Whether both are the same set of numbers; [`PartialEq`] is equality of the numbers that they enclose.
    pub fn is_same(&self, other: &Interval) -> bool {
        self.lo == other.lo && self.hi == other.hi
    }

    /// Its part without numbers below 0; `None` if it has none.
    pub fn nonnegative(&self) -> Option<Interval> {
        let zero = Float::new(self.lo.prec());
        let lo = if self.lo.is_sign_negative() { zero } else { self.lo.clone() };
        (lo <= self.hi).then(|| Interval::new(lo, self.hi.clone()))
    }

    /// Whether every number of the other lies in the interval.
    pub fn encloses(&self, other: &Interval) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// Whether the two intervals have a number in common.
    pub fn overlaps(&self, other: &Interval) -> bool {
        self.lo <= other.hi && other.lo <= self.hi
    }

    /// The smallest interval that contains both.
    pub fn hull(&self, other: &Interval) -> Interval {
        let lo = if self.lo <= other.lo { &self.lo } else { &other.lo };
        let hi = if self.hi >= other.hi { &self.hi } else { &other.hi };
        Interval::new(lo.clone(), hi.clone())
    }

    /// The intersection: two enclosures of one number refine each other. `None` when they are disjoint.
    pub fn intersect(&self, other: &Interval) -> Option<Interval> {
        let lo = if self.lo >= other.lo { &self.lo } else { &other.lo };
        let hi = if self.hi <= other.hi { &self.hi } else { &other.hi };
        (lo <= hi).then(|| Interval::new(lo.clone(), hi.clone()))
    }

    /// Whether the interval is a single number.
    pub fn is_point(&self) -> bool {
        self.lo == self.hi
    }

    /// Whether the interval is the entire line.
    pub fn is_entire(&self) -> bool {
        self.lo.is_infinite() && self.hi.is_infinite()
    }

    fn is_bounded(&self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Reflection at 0, in place.
    fn negate(&mut self) {
        std::mem::swap(&mut self.lo, &mut self.hi);
        self.lo.neg_assign();
        self.hi.neg_assign();
    }
}

/// The upper end that belongs to a lower end which was rounded down with the given ternary result.
fn just_above(lo: &Float, order: Ordering) -> Float {
    let mut hi = lo.clone();
    if order != Ordering::Equal {
        hi.next_up();
    }
    hi
}

/// The order of two closed intervals by their ends, where it holds for all pairs of their numbers.
pub(super) fn certain_order<E: PartialOrd>([lo, hi]: [&E; 2], [other_lo, other_hi]: [&E; 2]) -> Option<Ordering> {
    if hi < other_lo {
        Some(Ordering::Less)
    } else if lo > other_hi {
        Some(Ordering::Greater)
    } else if lo == hi && other_lo == other_hi {
        Some(Ordering::Equal)
    } else {
        None
    }
}

impl PartialEq for Interval {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Interval {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        certain_order([&self.lo, &self.hi], [&other.lo, &other.hi])
    }
}

/// `[lower, upper]` in decimals rounded outward; the format's precision sets the number of digits (default 20).
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = Some(f.precision().unwrap_or(20));
        let lower = self.lo.to_string_radix_round(10, digits, Round::Down);
        let upper = self.hi.to_string_radix_round(10, digits, Round::Up);
        write!(f, "[{lower}, {upper}]")
    }
}

impl fmt::Debug for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
