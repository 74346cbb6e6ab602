//! The seam between closed forms and quadrature: the MDR-transformed profile.

use super::{Kink, Result};
use crate::number::Real;

/// The MDR-transformed profile g of (1.1), with its slope and its integral.
///
/// Closed forms implement it in one crate, quadrature in another; equilibria, folds, paths, energy and fields are written
/// once against it. All lengths in metres.
pub trait Transform<R: Real>: Send + Sync {
    /// g(x) for x > 0.
    ///
    /// # Errors
    /// Outside the radius range, or when a quadrature does not converge.
    fn g(&self, x: &R) -> Result<R>;

    /// g'(x).
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn slope(&self, x: &R) -> Result<R>;

    /// G(x) = ∫₀ˣ g.
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn integral(&self, x: &R) -> Result<R>;

    /// The mean (1/x) ∫₀ˣ g, a length like g itself: in range wherever g is. The force is 2E*a (d − mean).
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn mean(&self, x: &R) -> Result<R> {
        Ok(self.integral(x)? / x)
    }

    /// g(x), or where it cannot be had to its own accuracy, as near a tip whose heights cancel, to an absolute error that is
    /// estimated to be below what is `needed` of it.
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn g_within(&self, x: &R, _needed: &R) -> Result<R> {
        self.g(x)
    }

    /// The same of the [mean](Transform::mean).
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn mean_within(&self, x: &R, _needed: &R) -> Result<R> {
        self.mean(x)
    }

    /// g less its mean, (1/x) ∫₀ˣ s g'(s) ds, in m: a state has F = 2E*a (this − Δl). Override it where g and its mean nearly
    /// cancel, as for a power law with n → 0.
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn above_mean(&self, x: &R) -> Result<R> {
        Ok(self.g(x)? - self.mean(x)?)
    }

    /// The radius beyond which g is not defined, if there is one.
    fn outer_radius(&self) -> Option<R> {
        None
    }

    /// Whether the profile rises vertically at its outer radius, so that the edge of the contact can rest there at any
    /// larger indentation. If so, g, g' and ∫g are defined at the outer radius too, as limits from inside.
    fn wall(&self) -> bool {
        false
    }

    /// Radii where g or a derivative of it jumps, ascending.
    fn kinks(&self) -> Vec<R> {
        Vec::new()
    }

    /// Whether g is known by its form to fall nowhere: then no contact overlaps outside of its edge.
    fn rises(&self) -> bool {
        false
    }

    /// What is known of g at the kink of this index and up to the relative distance `margin` < 1/4 on both sides of it; the
    /// [wall](Transform::wall) comes after the last kink, with nothing outside. So does an outer radius towards which g grows
    /// without bound: there it has no value, and the least slope inside holds from the margin on. None where nothing is known.
    ///
    /// Bounds hold over enclosures; other arithmetics promise nothing about them.
    ///
    /// # Errors
    /// As [`Transform::g`].
    fn kink(&self, _index: usize, _margin: &R) -> Result<Option<Kink<R>>> {
        Ok(None)
    }
}
