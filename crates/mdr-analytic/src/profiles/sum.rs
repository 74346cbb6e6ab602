//! Sums of profiles: g is linear in f.

use mdr_core::contact::{Result, Transform};
use mdr_core::number::Special;

/// The profile f₁ + f₂ + …, whose g, g' and G are the sums of theirs. It ends where its first term ends.
pub struct Sum<R> {
    terms: Vec<Box<dyn Transform<R>>>,
}

impl<R: Special> Sum<R> {
    /// The sum of `terms`; an empty sum is the flat half-space, g = 0.
    pub fn new(terms: Vec<Box<dyn Transform<R>>>) -> Self {
        Sum { terms }
    }

    fn total(&self, x: &R, part: impl Fn(&dyn Transform<R>) -> Result<R>) -> Result<R> {
        self.terms.iter().try_fold(x.lit(0), |sum, term| Ok(sum + part(term.as_ref())?))
    }
}

impl<R: Special> Transform<R> for Sum<R> {
    fn g(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.g(x))
    }
    fn slope(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.slope(x))
    }
    fn integral(&self, x: &R) -> Result<R> {
        self.total(x, |term| term.integral(x))
    }
    fn outer_radius(&self) -> Option<R> {
        let ends = self.terms.iter().filter_map(|term| term.outer_radius());
        ends.reduce(|a, b| if b < a { b } else { a })
    }
    fn wall(&self) -> bool {
        let Some(end) = self.outer_radius() else { return false };
        let mut last = self.terms.iter().filter(|term| term.outer_radius().is_some_and(|outer| !(outer > end)));
        last.all(|term| term.wall())
    }
    fn kinks(&self) -> Vec<R> {
        let mut kinks: Vec<R> = self.terms.iter().flat_map(|term| term.kinks()).collect();
        kinks.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
        kinks
    }
}
