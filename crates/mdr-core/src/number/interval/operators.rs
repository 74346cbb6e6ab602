//! + − × ÷ with each end rounded outward, in place.

use std::cmp::Ordering;
use std::mem::swap;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::Inv;
use rug::float::Round;
use rug::ops::{AddAssignRound, DivAssignRound, MulAssignRound, SubAssignRound};
use rug::{Assign, Float};

use super::Interval;

/// The position of an interval relative to a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Above,
    Below,
    Across,
}

impl Side {
    /// From the comparisons of the two ends with the number; an end equal to it counts as lying on one side.
    pub(super) fn from_ends(lower: Option<Ordering>, upper: Option<Ordering>) -> Self {
        if lower != Some(Ordering::Less) {
            Side::Above
        } else if upper != Some(Ordering::Greater) {
            Side::Below
        } else {
            Side::Across
        }
    }
}

/// One end of an interval.
#[derive(Clone, Copy)]
pub(super) enum End {
    Lower,
    Upper,
}

impl End {
    fn opposite(self) -> End {
        match self {
            End::Lower => End::Upper,
            End::Upper => End::Lower,
        }
    }
}

/// The ends (of the left and of the right factor) whose product is the least, then those whose product is the greatest.
/// `None` when both factors contain zero in their interior, where two products compete for each end.
pub(super) fn extremes(left: Side, right: Side) -> Option<[(End, End); 2]> {
    use End::{Lower, Upper};
    use Side::{Above, Across, Below};
    Some(match (left, right) {
        (Above, Above) => [(Lower, Lower), (Upper, Upper)],
        (Above, Across) => [(Upper, Lower), (Upper, Upper)],
        (Above, Below) => [(Upper, Lower), (Lower, Upper)],
        (Across, Above) => [(Lower, Upper), (Upper, Upper)],
        (Across, Below) => [(Upper, Lower), (Lower, Lower)],
        (Below, Above) => [(Lower, Upper), (Upper, Lower)],
        (Below, Across) => [(Lower, Upper), (Lower, Lower)],
        (Below, Below) => [(Upper, Upper), (Lower, Lower)],
        (Across, Across) => return None,
    })
}

impl Interval {
    /// The position of the interval relative to zero.
    pub(super) fn sign(&self) -> Side {
        Side::from_ends(self.lo.cmp0(), self.hi.cmp0())
    }

    pub(super) fn end(&self, end: End) -> &Float {
        match end {
            End::Lower => &self.lo,
            End::Upper => &self.hi,
        }
    }

    /// Replaces the ends by an operation on the given corners, rounded outward.
    pub(super) fn combine(
        &mut self,
        other: &Interval,
        [(least, by_least), (greatest, by_greatest)]: [(End, End); 2],
        operation: impl Fn(&mut Float, &Float, Round) -> Ordering,
    ) {
        match (least, greatest) {
            (End::Lower, End::Upper) => {}
            (End::Upper, End::Lower) => swap(&mut self.lo, &mut self.hi),
            (End::Lower, End::Lower) => self.hi.assign(&self.lo),
            (End::Upper, End::Upper) => self.lo.assign(&self.hi),
        }
        operation(&mut self.lo, other.end(by_least), Round::Down);
        operation(&mut self.hi, other.end(by_greatest), Round::Up);
        self.settle();
    }

    /// Whether it is exactly zero beside a factor that has one infinite end, such as an overflow: each of its numbers times zero is
    /// zero. The entire line has none that are known.
    fn annuls(&self, other: &Interval) -> bool {
        self.lo.is_zero() && self.hi.is_zero() && other.lo.is_infinite() != other.hi.is_infinite()
    }

    /// Replaces a NaN end: 0 · ∞ occurs only where nothing is known of one operand.
    fn settle(&mut self) {
        if self.lo.is_nan() || self.hi.is_nan() {
            *self = self.nothing_known();
        }
    }

    /// Both factors contain zero in their interior.
    fn multiply_across(&mut self, other: &Interval) {
        let precision = self.lo.prec();
        let product = |a: &Float, b: &Float, round| Float::with_val_round(precision, a * b, round).0;
        let lo = product(&self.lo, &other.hi, Round::Down).min(&product(&self.hi, &other.lo, Round::Down));
        let hi = product(&self.lo, &other.lo, Round::Up).max(&product(&self.hi, &other.hi, Round::Up));
        *self = Interval { lo, hi };
    }

    /// self · k.
    pub(super) fn scale(&mut self, k: i64) {
        if k < 0 {
            swap(&mut self.lo, &mut self.hi);
        }
        self.lo.mul_assign_round(k, Round::Down);
        self.hi.mul_assign_round(k, Round::Up);
        self.settle();
    }

    /// self / k; the entire line for k = 0.
    pub(super) fn divide(&mut self, k: i64) {
        if k == 0 {
            *self = self.nothing_known();
            return;
        }
        if k < 0 {
            swap(&mut self.lo, &mut self.hi);
        }
        self.lo.div_assign_round(k, Round::Down);
        self.hi.div_assign_round(k, Round::Up);
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.negate();
        self
    }
}

impl Inv for Interval {
    type Output = Self;
    fn inv(mut self) -> Self {
        if self.contains_zero() {
            return self.nothing_known();
        }
        swap(&mut self.lo, &mut self.hi);
        self.lo.recip_round(Round::Down);
        self.hi.recip_round(Round::Up);
        self
    }
}

impl AddAssign<&Self> for Interval {
    fn add_assign(&mut self, other: &Self) {
        self.lo.add_assign_round(&other.lo, Round::Down);
        self.hi.add_assign_round(&other.hi, Round::Up);
    }
}

impl SubAssign<&Self> for Interval {
    fn sub_assign(&mut self, other: &Self) {
        self.lo.sub_assign_round(&other.hi, Round::Down);
        self.hi.sub_assign_round(&other.lo, Round::Up);
    }
}

impl MulAssign<&Self> for Interval {
    fn mul_assign(&mut self, other: &Self) {
        if self.annuls(other) {
            return;
        }
        if other.annuls(self) {
            self.lo.assign(0);
            self.hi.assign(0);
            return;
        }
        match extremes(self.sign(), other.sign()) {
            Some(corners) => self.combine(other, corners, |x, y, round| x.mul_assign_round(y, round)),
            None => self.multiply_across(other),
        }
    }
}

impl DivAssign<&Self> for Interval {
    fn div_assign(&mut self, other: &Self) {
        // The reciprocal of a divisor on one side of zero lies on that side, its ends exchanged.
        let flip = |(left, right): (End, End)| (left, right.opposite());
        match extremes(self.sign(), other.sign()) {
            Some(corners) if !other.contains_zero() => {
                self.combine(other, corners.map(flip), |x, y, round| x.div_assign_round(y, round))
            }
            _ => *self = self.nothing_known(),
        }
    }
}

operators_from_assigning! { [] Interval }
