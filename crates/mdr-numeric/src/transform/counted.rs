//! A profile with a counter of its heights.

use std::sync::atomic::{AtomicUsize, Ordering};

use mdr_core::contact::Profile;
use mdr_core::number::{Lift, Real};

/// The heights of a profile, and the number that were evaluated. It counts for one thread.
pub(super) struct CountingProfile<'a, P> {
    profile: &'a P,
    heights: AtomicUsize,
}

impl<'a, P> CountingProfile<'a, P> {
    pub(super) fn new(profile: &'a P) -> Self {
        CountingProfile { profile, heights: AtomicUsize::new(0) }
    }

    pub(super) fn heights(&self) -> usize {
        self.heights.load(Ordering::Relaxed)
    }
}

impl<R: Real, P: Profile<R>> Profile<R> for CountingProfile<'_, P> {
    fn height<S: Lift<R>>(&self, r: &S) -> S {
        // Only one thread counts, so no lock is needed.
        self.heights.store(self.heights() + 1, Ordering::Relaxed);
        self.profile.height(r)
    }
}
