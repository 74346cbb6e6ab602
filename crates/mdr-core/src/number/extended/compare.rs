//! Order, where it is certain.

use std::cmp::Ordering;

use super::{Extended, limbs};

/// Overlapping numbers have no order, and only exact numbers are ever equal.
impl<const N: usize> PartialOrd for Extended<N> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        // The usual comparisons: against zero, and of exact numbers.
        if other.is_zero() && !self.is_hollow() {
            return Some(if self.negative { Ordering::Less } else { Ordering::Greater });
        }
        if self.is_exact() && other.is_exact() && !self.is_hollow() && self.negative == other.negative {
            let order = self.exponent.cmp(&other.exponent).then_with(|| limbs::compare(&self.limbs, &other.limbs));
            return Some(if self.negative { order.reverse() } else { order });
        }
        let difference = *self - other;
        match (difference.is_around_zero(), difference.is_zero(), difference.negative) {
            (true, ..) => None,
            (_, true, _) => Some(Ordering::Equal),
            (_, _, true) => Some(Ordering::Less),
            _ => Some(Ordering::Greater),
        }
    }
}

impl<const N: usize> PartialEq for Extended<N> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}
