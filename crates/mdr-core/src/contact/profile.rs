//! The shape of the gap before deformation.

use crate::number::{Lift, Real};

/// An axisymmetric profile z = f(r), f(0) = 0, as one generic function.
///
/// Write the height once; derivatives come from evaluating it over [`Dual`](crate::number::Dual) numbers.
///
/// ```
/// use mdr_core::contact::Profile;
/// use mdr_core::number::{Dual, Lift, Real};
///
/// struct Paraboloid<R> { radius: R }
/// impl<R: Real> Profile<R> for Paraboloid<R> {
///     fn height<S: Lift<R>>(&self, r: &S) -> S {
///         r.square().over(2) / S::lift(&self.radius)
///     }
/// }
/// let ball = Paraboloid { radius: 2.0 };
/// let r = Dual::variable(1.0);
/// assert_eq!(ball.height(&r).slope, 0.5); // r/R
/// ```
pub trait Profile<R: Real>: Send + Sync {
    /// f(r) for r > 0, in m.
    fn height<S: Lift<R>>(&self, r: &S) -> S;

    /// Radii where f or a derivative of it jumps, ascending. Quadrature is split there.
    fn kinks(&self) -> Vec<R> {
        Vec::new()
    }

    /// The magnitude of the largest term that may cancel in the height at r; `None` if the formula has no cancellation.
    fn largest_term(&self, _r: &R) -> Option<R> {
        None
    }

    /// The radius up to which all kinks are known; `None` if that is everywhere.
    fn kinks_known_to(&self) -> Option<R> {
        None
    }

    /// The radius beyond which the profile is not defined (the equator of a sphere), if there is one.
    fn outer_radius(&self) -> Option<R> {
        None
    }

    /// Whether the profile has a vertical edge at its outer radius, where f is the limit from inside.
    fn vertical_edge(&self) -> bool {
        false
    }

    /// The exponent p of f(r) ≈ c rᵖ at the tip, if known. It selects the quadrature weight that is exact there.
    fn tip_exponent(&self) -> Option<R> {
        None
    }
}
