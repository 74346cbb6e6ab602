//! Answers that were given last, for questions that come again.

use std::sync::{Mutex, PoisonError};

/// The last answers, up to a number of them.
pub(crate) struct Recent<T> {
    most: usize,
    kept: Mutex<Vec<T>>,
}

impl<T> Recent<T> {
    pub(crate) fn up_to(most: usize) -> Self {
        Recent { most, kept: Mutex::default() }
    }

    /// What `of` makes of the last answer of which it makes something.
    pub(crate) fn find<U>(&self, of: impl Fn(&T) -> Option<U>) -> Option<U> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner).iter().rev().find_map(of)
    }

    /// Keeps an answer, in place of the oldest where there is no room.
    pub(crate) fn keep(&self, answer: T) {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() == self.most {
            kept.remove(0);
        }
        kept.push(answer);
    }
}
