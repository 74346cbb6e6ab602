//! Order, where it is certain.

use std::cmp::Ordering;

use super::Wide;

/// Certain only: overlapping numbers have no order, and only exact numbers are ever equal.
impl<const N: usize> PartialOrd for Wide<N> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let difference = *self - other;
        match (difference.is_around_zero(), difference.is_zero(), difference.negative) {
            (true, ..) => None,
            (_, true, _) => Some(Ordering::Equal),
            (_, _, true) => Some(Ordering::Less),
            _ => Some(Ordering::Greater),
        }
    }
}

impl<const N: usize> PartialEq for Wide<N> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}
