//! + − × ÷ of intervals of doubles, with each end rounded outward.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::Inv;

use super::DoubleInterval;

/// x + y and its rounding error, which is exact unless the sum overflows (D. E. Knuth, The Art of Computer Programming 2, 4.2.2).
fn two_sum(x: f64, y: f64) -> (f64, f64) {
    let sum = x + y;
    let part = sum - x;
    (sum, (x - (sum - part)) + (y - part))
}

/// x + y rounded down; exact sums stay as they are.
fn sum_down(x: f64, y: f64) -> f64 {
    let (sum, error) = two_sum(x, y);
    // NaN where the sum is infinite: then the next double is finite or the sum stays what it is.
    if error >= 0.0 { sum } else { sum.next_down() }
}

impl DoubleInterval {
    /// The image under a product or a quotient, whose extremes are at corners; each true corner lies within a rounding of the computed
    /// one. A corner of 0 may be one of either sign that has underflowed, where the factors have such signs.
    fn by_corners(&self, other: &Self, corner: impl Fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self, other);
        let corners = [corner(a.lo, b.lo), corner(a.lo, b.hi), corner(a.hi, b.lo), corner(a.hi, b.hi)];
        if corners.iter().any(|corner| corner.is_nan()) {
            return Self::ENTIRE;
        }
        let least = corners.into_iter().fold(f64::INFINITY, f64::min);
        let greatest = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let is_negative = a.lo < 0.0 && b.hi > 0.0 || a.hi > 0.0 && b.lo < 0.0;
        let is_positive = a.lo < 0.0 && b.lo < 0.0 || a.hi > 0.0 && b.hi > 0.0;
        let lo = if least == 0.0 && !is_negative { 0.0 } else { least.next_down() };
        let hi = if greatest == 0.0 && !is_positive { 0.0 } else { greatest.next_up() };
        Self::new(lo, hi)
    }
}

impl Neg for DoubleInterval {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleInterval { lo: -self.hi, hi: -self.lo }
    }
}

impl Inv for DoubleInterval {
    type Output = Self;
    fn inv(self) -> Self {
        DoubleInterval { lo: 1.0, hi: 1.0 } / self
    }
}

impl AddAssign<&Self> for DoubleInterval {
    fn add_assign(&mut self, other: &Self) {
        if self.is_entire() || other.is_entire() {
            *self = Self::ENTIRE;
        } else {
            *self = Self::new(sum_down(self.lo, other.lo), -sum_down(-self.hi, -other.hi));
        }
    }
}

impl SubAssign<&Self> for DoubleInterval {
    fn sub_assign(&mut self, other: &Self) {
        *self += &-*other;
    }
}

impl MulAssign<&Self> for DoubleInterval {
    fn mul_assign(&mut self, other: &Self) {
        if self.is_entire() || other.is_entire() {
            *self = Self::ENTIRE;
            return;
        }
        if self.lo > 0.0 && other.lo > 0.0 {
            *self = Self::new((self.lo * other.lo).next_down().max(0.0), (self.hi * other.hi).next_up());
            return;
        }
        // An end may be infinite, of an overflow: each number of the interval times zero is zero.
        let product = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
        *self = self.by_corners(other, product);
    }
}

impl DivAssign<&Self> for DoubleInterval {
    fn div_assign(&mut self, other: &Self) {
        if self.is_entire() || other.contains_zero() {
            *self = Self::ENTIRE;
            return;
        }
        if self.lo > 0.0 && other.lo > 0.0 {
            *self = Self::new((self.lo / other.hi).next_down().max(0.0), (self.hi / other.lo).next_up());
            return;
        }
        *self = self.by_corners(other, |x, y| x / y);
    }
}

operators_from_assigning! { [] DoubleInterval }
