//! The four operations with their error bounds.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::Inv;

use super::{Extended, limbs, power_of_two, truncation};

impl<const N: usize> Extended<N> {
    /// The error of a product or quotient: the sum of both, the truncation, and the terms of second order.
    #[inline]
    fn combined(a: f64, b: f64, inexact: bool) -> f64 {
        Self::second_order(a + b) + truncation(inexact)
    }

    #[inline]
    pub(super) fn product(&self, other: &Self) -> Self {
        if self.is_hollow() || other.is_hollow() {
            return self.hollow_product(other);
        }
        if N == 1 {
            // Without a branch on the leading bit, which is unpredictable.
            let product = u128::from(self.limbs[0]) * u128::from(other.limbs[0]);
            let zeros = product.leading_zeros();
            let normal = product << zeros;
            let error = Self::combined(self.error, other.error, normal as u64 != 0);
            let exponent = self.exponent + other.exponent - i64::from(zeros);
            let limbs = [(normal >> 64) as u64; N];
            return Self::from_parts(self.negative != other.negative, limbs, exponent, error);
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
        let error = Self::combined(self.error, other.error, !limbs::is_zero(&low));
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
        if N == 1 {
            let below = self.limbs[0] < other.limbs[0];
            let numerator = u128::from(self.limbs[0]) << (63 + u32::from(below));
            let (quotient, divisor) = ((numerator / u128::from(other.limbs[0])) as u64, other.limbs[0]);
            let inexact = quotient.wrapping_mul(divisor) != numerator as u64;
            let (limbs, exponent) = ([quotient; N], exponent + i64::from(!below));
            let error = Self::combined(self.error, other.error, inexact);
            return Self::from_parts(self.negative != other.negative, limbs, exponent, error);
        }
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
            Self::combined(self.error, other.error, inexact),
        )
    }

    /// self ± other, with the given sign of `other`.
    #[inline]
    fn sum(&self, other: &Self, other_negative: bool) -> Self {
        if self.is_hollow() || other.is_hollow() {
            let other = Extended { negative: other_negative && !other.is_hollow(), ..*other };
            return match (self.is_zero(), other.is_zero(), other.is_around_zero()) {
                (true, ..) => other,
                (_, true, _) => *self,
                (_, _, true) => self.blurred(other.exponent),
                _ => other.blurred(self.exponent),
            };
        }
        if N == 1 {
            return self.sum_of_words(other, other_negative);
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

    /// One word: the operand with the larger exponent in Q127, so that only a distance above 63 can lose a bit. Signs
    /// and order are unpredictable, hence selections instead of branches.
    #[inline]
    fn sum_of_words(&self, other: &Self, other_negative: bool) -> Self {
        let distance = self.exponent - other.exponent;
        let place = |limb: u64, below: i64| {
            let word = u128::from(limb) << 63;
            let shifted = word >> below.clamp(0, 127);
            (shifted as i128, shifted << below.clamp(0, 127) != word)
        };
        let (first, first_lost) = place(self.limbs[0], -distance);
        let (second, second_lost) = place(other.limbs[0], distance);
        let lost = first_lost | second_lost;
        let opposite = self.negative != other_negative;
        let sum = if opposite { first - second } else { first.wrapping_add(second) };
        if sum == 0 {
            let exact = self.is_exact() && other.is_exact();
            return if exact { Self::ZERO } else { Self::around_zero(Self::absolute_error(self, other)) };
        }
        let magnitude = if opposite { sum.unsigned_abs() } else { sum as u128 };
        let zeros = magnitude.leading_zeros();
        let normal = magnitude << zeros;
        let exponent = self.exponent.max(other.exponent) + 1 - i64::from(zeros);
        let limbs = [(normal >> 64) as u64; N];
        let rounding = truncation(normal as u64 != 0 || lost);
        if opposite {
            Self::difference(self, other, limbs, exponent, (sum < 0) != self.negative, rounding)
        } else {
            let error = Self::weighted_error(self, other) + rounding;
            Self::from_parts(self.negative, limbs, exponent, error)
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
        let error = Self::weighted_error(large, small) + truncation(inexact);
        Self::from_parts(negative, sum, exponent, error)
    }

    #[inline]
    fn subtracted(large: &Self, small: &Self, aligned: &[u64; N], guard: u64, lost: bool, negative: bool) -> Self {
        // The bits lost below the guard reduce the true difference by less than one unit of the guard.
        let (guard, borrow) = 0u64.overflowing_sub(guard);
        let (guard, borrow) = if lost { (guard.wrapping_sub(1), borrow || guard == 0) } else { (guard, borrow) };
        let difference = limbs::sub(&large.limbs, aligned, borrow);
        let exact_operands = large.is_exact() && small.is_exact();
        let Some((difference, rest, shift)) = limbs::normalise(difference, guard) else {
            return if exact_operands { Self::ZERO } else { Self::around_zero(Self::absolute_error(large, small)) };
        };
        let rounding = truncation(rest != 0 || lost);
        Self::difference(large, small, difference, large.exponent - shift, negative, rounding)
    }

    /// The error of a sum: the mean of both, weighted by the magnitudes, hence at most the larger one; the weight of a
    /// term with an exponent lower by d is less than 2^(1−d).
    #[inline]
    fn weighted_error(x: &Self, y: &Self) -> f64 {
        let larger = x.exponent.max(y.exponent);
        let part = |x: &Self| x.error * power_of_two((x.exponent - larger + 1).min(0));
        Self::second_order((part(x) + part(y)).min(x.error.max(y.error)))
    }

    /// A difference with the errors of both, magnified by cancellation.
    #[inline]
    fn difference(
        large: &Self,
        small: &Self,
        difference: [u64; N],
        exponent: i64,
        negative: bool,
        rounding: f64,
    ) -> Self {
        if large.is_exact() && small.is_exact() {
            return Self::from_parts(negative, difference, exponent, rounding);
        }
        // Times |x|/|x − y|, and the same for y.
        let inverse = 1.0 / difference[N - 1] as f64;
        let magnified = |x: &Self| x.error * (x.limbs[N - 1] as f64 * inverse) * power_of_two(x.exponent - exponent);
        let error = magnified(large) + magnified(small) + 1.0 + rounding;
        if error > Self::ERROR_LIMIT {
            return Self::around_zero(exponent.max(Self::absolute_error(large, small)) + 1);
        }
        Self::from_parts(negative, difference, exponent, error)
    }

    /// An exponent e such that the errors of both together are at most 2^e.
    fn absolute_error(large: &Self, small: &Self) -> i64 {
        let units = large.error + small.error + 2.0;
        large.exponent.max(small.exponent) - Self::BITS + units.log2() as i64 + 2
    }

    /// A product with a factor that is zero or around zero.
    #[cold]
    fn hollow_product(&self, other: &Self) -> Self {
        if self.is_nothing() || other.is_nothing() {
            Self::NOTHING
        } else if self.is_zero() || other.is_zero() {
            Self::ZERO
        } else {
            // One more bit for the error of the other factor.
            Self::around_zero(self.exponent + other.exponent + 1)
        }
    }

    /// −self if `flip`.
    #[inline]
    pub(super) fn flipped(self, flip: bool) -> Self {
        Extended { negative: self.negative != flip && !self.is_hollow(), ..self }
    }

    /// self · k.
    #[inline]
    pub(super) fn times_int(self, k: i64) -> Self {
        let magnitude = k.unsigned_abs();
        if magnitude.is_power_of_two() {
            return self.flipped(k < 0).scaled(i64::from(magnitude.trailing_zeros()));
        }
        if k == 0 || self.is_hollow() {
            return self.product(&Self::from_integer(k < 0, magnitude));
        }
        let (low, over) = limbs::mul_word(&self.limbs, magnitude);
        self.shortened(low, over, false, k < 0, 0)
    }

    /// self / k.
    #[inline]
    pub(super) fn over_int(self, k: i64) -> Self {
        let magnitude = k.unsigned_abs();
        if k == 0 {
            return Self::NOTHING;
        }
        if magnitude.is_power_of_two() || self.is_hollow() {
            return self.flipped(k < 0).scaled(-i64::from(magnitude.ilog2()));
        }
        // The quotient has N + 1 words from the top: its N lower words and the carry are those of a product with k.
        let (quotient, last, remainder) = limbs::div_word(&self.limbs, magnitude);
        let mut low = [0; N];
        low[1..].copy_from_slice(&quotient[..N - 1]);
        low[0] = last;
        self.shortened(low, quotient[N - 1], remainder, k < 0, -64)
    }

    /// (over, low)·2^scale as the significand, after an optional `remainder` was dropped.
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
        Self::from_parts(self.negative != flip, significand, exponent + scale, Self::combined(self.error, 0.0, inexact))
    }
}

impl<const N: usize> Neg for Extended<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.flipped(true)
    }
}

impl<const N: usize> Inv for Extended<N> {
    type Output = Self;
    #[inline]
    fn inv(self) -> Self {
        let mut one = Extended { negative: false, limbs: [0; N], exponent: 1, error: 0.0 };
        one.limbs[N - 1] = 1 << 63;
        one.quotient(&self)
    }
}

/// Each operator in the forms that `Real` requires, from one function.
macro_rules! operators {
    ($($operator:ident $method:ident $assigning:ident $assign:ident: |$a:ident, $b:ident| $value:expr;)*) => {$(
        impl<const N: usize> $operator<&Self> for Extended<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: &Self) -> Self {
                let ($a, $b) = (&self, other);
                $value
            }
        }
        impl<const N: usize> $operator for Extended<N> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                self.$method(&other)
            }
        }
        impl<const N: usize> $assigning<&Self> for Extended<N> {
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
