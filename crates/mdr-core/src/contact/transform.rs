//! The interface between closed forms and quadrature: the MDR-transformed profile.

use std::sync::Arc;

use super::{Kink, Result};
use crate::number::Real;

/// The MDR-transformed profile g of (1.1), with its slope and its integral.
///
/// Closed forms implement it in the analytic crate, quadrature in the numeric crate; equilibria, folds, paths, energy
/// and fields use this trait only. All lengths are in metres.
pub trait Transform<R: Real>: Send + Sync {
    /// g(x) for x > 0.
    ///
    /// # Errors
    /// Outside the radius range, or when a quadrature does not converge.
    fn g(&self, x: &R) -> Result<R>;

    /// g'(x).
    ///
    /// # Errors
    /// Where x is outside the radius range, or a quadrature does not converge, see [`Transform::g`].
    fn slope(&self, x: &R) -> Result<R>;

    /// G(x) = ∫₀ˣ g.
    ///
    /// # Errors
    /// Where x is outside the radius range, or a quadrature does not converge, see [`Transform::g`].
    fn integral(&self, x: &R) -> Result<R>;

    /// The mean (1/x) ∫₀ˣ g, in m; it is in range wherever g is. The force is 2E*a (d − mean).
    ///
    /// # Errors
    /// Where x is outside the radius range, or a quadrature does not converge, see [`Transform::g`].
    fn mean(&self, x: &R) -> Result<R> {
        Ok(self.integral(x)? / x)
    }

    /// g(x). Where full relative accuracy is not available, as near a tip whose heights cancel, the estimated absolute
    /// error is below `needed`.
    ///
    /// # Errors
    /// Where x is outside the radius range, or a quadrature does not converge, see [`Transform::g`].
    fn g_within(&self, x: &R, _needed: &R) -> Result<R> {
        self.g(x)
    }

    /// The mean (1/x) ∫₀ˣ g, see [`mean`](Transform::mean). Where full relative accuracy is not available, the estimated
    /// absolute error is below `needed`.
    ///
    /// # Errors
    /// Where x is outside the radius range, or a quadrature does not converge, see [`Transform::g`].
    fn mean_within(&self, x: &R, _needed: &R) -> Result<R> {
        self.mean(x)
    }

    /// g minus its mean, (1/x) ∫₀ˣ s g'(s) ds, in m: a state has F = 2E*a (g − mean − Δl). Override it where g and its
    /// mean nearly cancel, as for a power law with n → 0.
    ///
    /// # Errors
    /// Where x is outside the radius range, or a quadrature does not converge, see [`Transform::g`].
    fn above_mean(&self, x: &R) -> Result<R> {
        Ok(self.g(x)? - self.mean(x)?)
    }

    /// The mean of g² over the springs, (1/S)∫₀ˣ S'g² ds, in m²: a contact of depth d stores ½S(d² − 2d·mean + mean square). `None`
    /// without a closed form.
    ///
    /// # Errors
    /// Where x is outside the radius range, see [`Transform::g`].
    fn mean_square(&self, _x: &R) -> Option<Result<R>> {
        None
    }

    /// Of complete contact on a periodic medium: its depth, and what it stores per area over the modulus, both in m. `None` without closed
    /// forms, and elsewhere.
    fn complete_contact(&self) -> Option<[R; 2]> {
        None
    }

    /// The radius beyond which g is not defined, if there is one.
    fn outer_radius(&self) -> Option<R> {
        None
    }

    /// Whether the profile has a vertical edge at its outer radius, so that the contact edge can stay there at any
    /// larger indentation depth. If so, g, g' and ∫g are also defined at the outer radius, as limits from inside.
    fn vertical_edge(&self) -> bool {
        false
    }

    /// Radii where g or a derivative of it jumps, ascending.
    fn kinks(&self) -> Vec<R> {
        Vec::new()
    }

    /// Whether g is known to be nondecreasing: then the surfaces cannot interpenetrate outside the contact.
    fn rises(&self) -> bool {
        false
    }

    /// Whether g is known to be nondecreasing from a radius on, as beyond the edge of a dimple.
    fn rises_beyond(&self, _x: &R) -> bool {
        self.rises()
    }

    /// The cost of all evaluations so far beyond their number, in heights f(r), as it is counted in a budget. 0 where an
    /// evaluation is a closed form.
    fn work(&self) -> u64 {
        0
    }

    /// Bounds of g at the kink with this index and up to the relative distance `margin` < 1/4 on both sides of it;
    /// `None` if nothing is known. A [vertical edge](Transform::vertical_edge) has the index after the last kink, with nothing
    /// outside. So does an outer radius at which g diverges: it has no value there, and the lower bound of the slope
    /// inside holds from the margin on.
    ///
    /// Bounds are guaranteed for enclosures only.
    ///
    /// # Errors
    /// Errors of [`Transform::g`] near the kink.
    fn kink(&self, _index: usize, _margin: &R) -> Result<Option<Kink<R>>> {
        Ok(None)
    }
}

/// Forwards every method of [`Transform`] to the transform inside a smart pointer.
macro_rules! forward {
    ($($pointer:ident),*) => {$(
        impl<R: Real, T: Transform<R> + ?Sized> Transform<R> for $pointer<T> {
            fn g(&self, x: &R) -> Result<R> {
                (**self).g(x)
            }

            fn slope(&self, x: &R) -> Result<R> {
                (**self).slope(x)
            }

            fn integral(&self, x: &R) -> Result<R> {
                (**self).integral(x)
            }

            fn mean(&self, x: &R) -> Result<R> {
                (**self).mean(x)
            }

            fn g_within(&self, x: &R, needed: &R) -> Result<R> {
                (**self).g_within(x, needed)
            }

            fn mean_within(&self, x: &R, needed: &R) -> Result<R> {
                (**self).mean_within(x, needed)
            }

            fn above_mean(&self, x: &R) -> Result<R> {
                (**self).above_mean(x)
            }

            fn mean_square(&self, x: &R) -> Option<Result<R>> {
                (**self).mean_square(x)
            }

            fn complete_contact(&self) -> Option<[R; 2]> {
                (**self).complete_contact()
            }

            fn outer_radius(&self) -> Option<R> {
                (**self).outer_radius()
            }

            fn vertical_edge(&self) -> bool {
                (**self).vertical_edge()
            }

            fn kinks(&self) -> Vec<R> {
                (**self).kinks()
            }

            fn rises(&self) -> bool {
                (**self).rises()
            }

            fn rises_beyond(&self, x: &R) -> bool {
                (**self).rises_beyond(x)
            }

            fn work(&self) -> u64 {
                (**self).work()
            }

            fn kink(&self, index: usize, margin: &R) -> Result<Option<Kink<R>>> {
                (**self).kink(index, margin)
            }
        }
    )*};
}

forward!(Arc, Box);
