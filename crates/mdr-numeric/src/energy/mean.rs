//! Means over the contact, to rounding or coarsely.

use mdr_core::calculus::{
    Estimate, Tolerance, gauss_jacobi,
    quadrature::{tanh_sinh_near_ends, tanh_sinh_pieces},
    roundoff_tolerance,
};
use mdr_core::contact::{Error, Result};
use mdr_core::number::Real;

use super::Energy;

/// The required accuracy of an integral.
pub(super) enum Grade<R> {
    /// To a sixteenth of itself or of this scale, for locating the crossings.
    Coarse(R),
    /// To rounding.
    Full,
}

/// Nodes of a coarse integral, and of the one it is compared with.
const COARSE: [usize; 2] = [12, 8];

impl<R: Real> Energy<R> {
    /// (1/a) ∫₀ᵃ h(x) dx.
    pub(super) fn mean(&self, a: &R, grade: &Grade<R>, mut h: impl FnMut(&R) -> Result<R>) -> Result<R> {
        if let Grade::Coarse(scale) = grade
            && let Some(value) = self.coarse(a, scale, &mut h)?
        {
            return Ok(value);
        }
        Ok(self.full(a, full_tolerance(a), &mut h)?.value)
    }

    /// The mean over the radii from the last kink b before a to a, if there is one; h may have a root or a logarithm at b.
    pub(super) fn mean_beyond(
        &self,
        edge: Option<&R>,
        a: &R,
        grade: &Grade<R>,
        mut h: impl FnMut(&R) -> Result<R>,
    ) -> Result<R> {
        let Some(edge) = edge else { return self.mean(a, grade, h) };
        // A radius that rounds to the edge represents those beside it.
        let beside = edge.unit_roundoff().times(2) * edge + edge;
        let mut to = |tolerance| {
            let integral = tanh_sinh_near_ends(edge, a, tolerance, |node| h(&node.x.greater(&beside)))?;
            Ok(integral.scaled(&(a.clone() - edge).inv()))
        };
        if let Grade::Coarse(scale) = grade
            && let Some(value) = certain_enough(to(Tolerance::new(&a.ratio(1, 10_000)))?, scale)
        {
            return Ok(value);
        }
        Ok(to(full_tolerance(a))?.value)
    }

    /// `None` if the terms of the integral cancel so far that its error might matter.
    fn coarse(&self, a: &R, scale: &R, h: &mut impl FnMut(&R) -> Result<R>) -> Result<Option<R>> {
        let estimate = match &self.tip {
            Some(p) => {
                let inverse = p.clone().inv();
                let beta = inverse.clone() - a.lit(1);
                let mut by = |nodes| -> Result<R> {
                    let rule = gauss_jacobi::rule(nodes, &a.lit(0), &beta)?;
                    Ok(rule.integrate(|tau| h(&(tau.pow(&inverse) * a)))? * &inverse)
                };
                let (fine, rough) = (by(COARSE[0])?, by(COARSE[1])?);
                Estimate { value: fine.clone(), error: (fine - rough).abs(), evaluations: COARSE[0] + COARSE[1] }
            }
            None => self.double_exponential(a, &a.ratio(1, 10_000), h)?,
        };
        Ok(certain_enough(estimate, scale))
    }

    /// In τ = tᵖ, t = x/a, integer powers of g are analytic: Gauss–Jacobi with the weight τ^(1/p−1). If that does not
    /// converge, and beside kinks, tanh-sinh.
    fn full(&self, a: &R, tolerance: Tolerance<R>, h: &mut impl FnMut(&R) -> Result<R>) -> Result<Estimate<R>> {
        let Some(p) = &self.tip else { return self.double_exponential(a, tolerance, h) };
        let inverse = p.clone().inv();
        let beta = inverse.clone() - a.lit(1);
        match gauss_jacobi::integrate(&a.lit(0), &beta, tolerance.clone(), |tau| h(&(tau.pow(&inverse) * a))) {
            Ok(estimate) => Ok(estimate.scaled(&inverse)),
            Err(Error::NoConvergence { .. }) => self.double_exponential(a, tolerance, h),
            Err(error) => Err(error),
        }
    }

    fn double_exponential(
        &self,
        a: &R,
        tolerance: impl Into<Tolerance<R>>,
        h: &mut impl FnMut(&R) -> Result<R>,
    ) -> Result<Estimate<R>> {
        let integral = tanh_sinh_pieces(&a.lit(0), a, &self.contact.transform().kinks(), tolerance, h)?;
        Ok(integral.scaled(&a.clone().inv()))
    }
}

/// g may itself have noise, up to √u.
fn full_tolerance<R: Real>(like: &R) -> Tolerance<R> {
    Tolerance::new(&roundoff_tolerance(like).times(4)).or_noise_below(like.unit_roundoff().sqrt())
}

/// The value, if it is accurate to a sixteenth of itself or of the scale.
fn certain_enough<R: Real>(estimate: Estimate<R>, scale: &R) -> Option<R> {
    let Estimate { value, error, .. } = estimate;
    // Infinite terms are large enough, although their error is NaN.
    let uncertain = error.times(16) > value.abs() + scale;
    (!uncertain).then_some(value)
}
