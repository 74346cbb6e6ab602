//! The four operations, each with its error.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::Inv;

use super::{Wide, limbs};

/// The error of a product or quotient: the sum of both, one unit for terms of second order, two for truncation.
#[inline]
fn combined(a: u64, b: u64, inexact: bool) -> u64 {
    let sum = a.saturating_add(b);
    sum.saturating_add(u64::from(sum != 0) + 2 * u64::from(inexact))
}

/// error · 2^shift, rounded up.
#[inline]
pub(super) fn shifted(error: u64, shift: i64) -> u64 {
    match shift {
        _ if error == 0 => 0,
        ..=-64 => 1,
        -63..0 => (error >> -shift) + 1,
        _ if i64::from(error.leading_zeros()) > shift => error << shift,
        _ => u64::MAX,
    }
}

impl<const N: usize> Wide<N> {
    #[inline]
    pub(super) fn product(&self, other: &Self) -> Self {
        if self.is_hollow() || other.is_hollow() {
            return self.hollow_product(other);
        }
        let (mut high, mut low) = limbs::mul(&self.limbs, &other.limbs);
        let mut exponent = self.exponent + other.exponent;
        if high[N - 1] >> 63 == 0 {
            let carry = low[N - 1] >> 63;
            for i in (1..N).rev() {
                high[i] = high[i] << 1 | high[i - 1] >> 63;
            }
            high[0] = high[0] << 1 | carry;
            low[N - 1] <<= 1;
            exponent -= 1;
        }
        let error = combined(self.error, other.error, !limbs::is_zero(&low));
        Self::from_parts(self.negative != other.negative, high, exponent, error)
    }

    #[inline]
    pub(super) fn quotient(&self, other: &Self) -> Self {
        if other.is_hollow() {
            return Self::NOTHING;
        }
        if self.is_hollow() {
            // |y| ≥ 2^(e − 2), its error included.
            return self.scaled(2 - other.exponent);
        }
        let mut exponent = self.exponent - other.exponent;
        let (numerator, next) = if limbs::compare(&self.limbs, &other.limbs).is_lt() {
            (self.limbs, 0)
        } else {
            exponent += 1;
            let (halved, guard, _) = limbs::shift_down(&self.limbs, 1);
            (halved, guard)
        };
        let (quotient, inexact) = limbs::div(numerator, next, &other.limbs);
        Self::from_parts(
            self.negative != other.negative,
            quotient,
            exponent,
            combined(self.error, other.error, inexact),
        )
    }

    /// self ± other, the sign of `other` being given.
    #[inline]
    fn sum(&self, other: &Self, other_negative: bool) -> Self {
        if self.is_hollow() || other.is_hollow() {
            let other = Wide { negative: other_negative && !other.is_hollow(), ..*other };
            return match (self.is_zero(), other.is_zero(), other.is_around_zero()) {
                (true, ..) => other,
                (_, true, _) => *self,
                (_, _, true) => self.blurred(other.exponent),
                _ => other.blurred(self.exponent),
            };
        }
        let self_is_larger = self.exponent > other.exponent
            || (self.exponent == other.exponent && limbs::compare(&self.limbs, &other.limbs).is_ge());
        let (large, small, negative) =
            if self_is_larger { (self, other, self.negative) } else { (other, self, other_negative) };
        let distance = large.exponent.abs_diff(small.exponent);
        let (aligned, guard, lost) = limbs::shift_down(&small.limbs, distance);
        if self.negative == other_negative {
            Self::added(large, small, &aligned, guard != 0 || lost, negative)
        } else {
            Self::subtracted(large, small, &aligned, guard, lost, negative)
        }
    }

    #[inline]
    fn added(large: &Self, small: &Self, aligned: &[u64; N], mut inexact: bool, negative: bool) -> Self {
        let (mut sum, carry) = limbs::add(&large.limbs, aligned);
        let mut exponent = large.exponent;
        if carry {
            inexact |= sum[0] & 1 != 0;
            (sum, ..) = limbs::shift_down(&sum, 1);
            sum[N - 1] |= 1 << 63;
            exponent += 1;
        }
        // A weighted mean of both errors.
        let error = large.error.max(small.error);
        Self::from_parts(negative, sum, exponent, error + u64::from(error != 0) + 2 * u64::from(inexact))
    }

    #[inline]
    fn subtracted(large: &Self, small: &Self, aligned: &[u64; N], guard: u64, lost: bool, negative: bool) -> Self {
        // What was lost below the guard makes the true difference smaller by less than one unit of the guard.
        let (guard, borrow) = 0u64.overflowing_sub(guard);
        let (guard, borrow) = if lost { (guard.wrapping_sub(1), borrow || guard == 0) } else { (guard, borrow) };
        let difference = limbs::sub(&large.limbs, aligned, borrow);
        let exact_operands = large.is_exact() && small.is_exact();
        let Some((difference, rest, shift)) = limbs::normalise(difference, guard) else {
            return if exact_operands { Self::ZERO } else { Self::around_zero(Self::absolute_error(large, small)) };
        };
        let exponent = large.exponent - shift;
        let rounding = 2 * u64::from(rest != 0 || lost);
        if exact_operands {
            return Self::from_parts(negative, difference, exponent, rounding);
        }
        // |x|/|x − y| ≤ 2^(e_x − e + 1), and the same for y.
        let magnified = |x: &Self| shifted(x.error, x.exponent - exponent + 1);
        let error = magnified(large).saturating_add(magnified(small)).saturating_add(1 + rounding);
        if error > Self::ERROR_LIMIT {
            return Self::around_zero(exponent.max(Self::absolute_error(large, small)) + 1);
        }
        Self::from_parts(negative, difference, exponent, error)
    }

    /// The errors of both are together at most 2 to this power.
    fn absolute_error(large: &Self, small: &Self) -> i64 {
        let units = large.error + small.error + 2;
        large.exponent - Self::BITS + 64 - i64::from(units.leading_zeros())
    }

    /// A product with zero or with something around zero.
    #[cold]
    fn hollow_product(&self, other: &Self) -> Self {
        if self.is_nothing() || other.is_nothing() {
            Self::NOTHING
        } else if self.is_zero() || other.is_zero() {
            Self::ZERO
        } else {
            // One more bit for the error of a factor that is not around zero.
            Self::around_zero(self.exponent + other.exponent + 1)
        }
    }

    /// self · k.
    #[inline]
    pub(super) fn times_int(self, k: i64) -> Self {
        let magnitude = k.unsigned_abs();
        if k == 0 || self.is_hollow() {
            return self.product(&Self::from_integer(k < 0, magnitude));
        }
        let (low, over) = limbs::mul_word(&self.limbs, magnitude);
        self.shortened(low, over, false, k < 0, 0)
    }

    /// self / k.
    #[inline]
    pub(super) fn over_int(self, k: i64) -> Self {
        if k == 0 {
            return Self::NOTHING;
        }
        if self.is_hollow() {
            return self.scaled(i64::from(k.unsigned_abs().leading_zeros()) - 63);
        }
        // The quotient has N + 1 words counted from the top: its N lower ones and the carry are those of a product with k.
        let (quotient, last, remainder) = limbs::div_word(&self.limbs, k.unsigned_abs());
        let mut low = [0; N];
        low[1..].copy_from_slice(&quotient[..N - 1]);
        low[0] = last;
        self.shortened(low, quotient[N - 1], remainder, k < 0, -64)
    }

    /// (over, low)·2^scale in place of the significand, where a remainder may have been dropped.
    #[inline]
    fn shortened(&self, low: [u64; N], over: u64, remainder: bool, flip: bool, scale: i64) -> Self {
        let bits = u64::from(64 - over.leading_zeros());
        let (significand, inexact, exponent) = if over == 0 {
            match limbs::normalise(low, 0) {
                Some((significand, _, shift)) => (significand, remainder, self.exponent - shift),
                None => return Self::NOTHING,
            }
        } else {
            let (mut shifted, guard, lost) = limbs::shift_down(&low, bits);
            shifted[N - 1] |= over << (64 - bits);
            (shifted, remainder || guard != 0 || lost, self.exponent + bits as i64)
        };
        Self::from_parts(self.negative != flip, significand, exponent + scale, combined(self.error, 0, inexact))
    }
}

impl<const N: usize> Neg for Wide<N> {
    type Output = Self;
    #[inline]
    fn neg(mut self) -> Self {
        self.negative = !self.negative && !self.is_hollow();
        self
    }
}

impl<const N: usize> Inv for Wide<N> {
    type Output = Self;
    #[inline]
    fn inv(self) -> Self {
        let mut one = Wide { negative: false, limbs: [0; N], exponent: 1, error: 0 };
        one.limbs[N - 1] = 1 << 63;
        one.quotient(&self)
    }
}

/// Each operator in the forms that `Real` asks for, from one function.
macro_rules! operators {
    ($($operator:ident $method:ident $assigning:ident $assign:ident: |$a:ident, $b:ident| $value:expr;)*) => {$(
        impl<const N: usize> $operator<&Self> for Wide<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: &Self) -> Self {
                let ($a, $b) = (&self, other);
                $value
            }
        }
        impl<const N: usize> $operator for Wide<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$method(&other)
            }
        }
        impl<const N: usize> $assigning<&Self> for Wide<N> {
            #[inline]
            fn $assign(&mut self, other: &Self) {
                *self = self.$method(other);
            }
        }
    )*};
}
operators! {
    Add add AddAssign add_assign: |a, b| a.sum(b, b.negative);
    Sub sub SubAssign sub_assign: |a, b| a.sum(b, !b.negative);
    Mul mul MulAssign mul_assign: |a, b| a.product(b);
    Div div DivAssign div_assign: |a, b| a.quotient(b);
}
