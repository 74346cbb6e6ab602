//! The integrands: a profile and its logarithmic derivatives.

use mdr_core::contact::Profile;
use mdr_core::number::{Dual, Special};

/// The function φ in I[φ] = ∫₀^{π/2} sinθ φ(x sinθ) dθ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Integrand {
    /// f, for the mean of g.
    Height,
    /// Df = r f', for g minus its mean.
    Rise,
    /// (1 + D)f = f + r f', for g.
    Transform,
    /// D(1 + D)f/x = s(2f' + r f''), s = r/x, for g'.
    Slope,
}

impl Integrand {
    /// In their order.
    #[cfg(feature = "mp")]
    pub(super) const ALL: [Integrand; 4] = [Integrand::Height, Integrand::Rise, Integrand::Transform, Integrand::Slope];

    /// φ at r = sx, with the derivatives from dual numbers; s is used for g' only. The variable has the slope r, not 1,
    /// so that the derivative is D and every term is a length of the magnitude of f. For g' the derivative is that in
    /// x, so that no height is divided by x: near the tip heights leave the range of the arithmetic where slopes do
    /// not.
    pub(super) fn at<R: Special>(self, profile: &impl Profile<R>, s: &R, r: &R) -> R {
        let r = logarithmic(r.clone());
        match self {
            Integrand::Height => profile.height(&r.value),
            Integrand::Rise => profile.height(&r).slope,
            Integrand::Transform => {
                let f = profile.height(&r);
                f.value + f.slope
            }
            Integrand::Slope => {
                let f = profile.height(&Dual { value: r, slope: Dual { value: s.clone(), slope: s.clone() } }).slope;
                f.value + f.slope
            }
        }
    }

    /// The relative effect of the rounding of r on the integrand: u |Dφ|/|φ|. The terms of φ are taken in magnitude, so
    /// that a zero of φ has no effect, and summed over the radii.
    pub(super) fn noise<R: Special>(self, profile: &impl Profile<R>, radii: &[R]) -> R {
        let zero = radii[0].lit(0);
        let total = |size: &dyn Fn(&R) -> R| radii.iter().fold(zero.clone(), |sum, r| sum + size(r).abs());
        let at = |integrand: Integrand, r: &R| integrand.at(profile, &r.lit(1), r);
        let height = total(&|r| at(Integrand::Height, r));
        // D(1 + D)f = r d/dr (1 + D)f.
        let bend = |r: &R| at(Integrand::Slope, r) * r;
        let condition = match self {
            Integrand::Height => {
                total(&|r| at(Integrand::Transform, r))
                    / (total(&|r| at(Integrand::Height, &r.clone().over(2))) + height)
            }
            Integrand::Rise | Integrand::Transform => total(&bend) / (total(&|r| at(Integrand::Transform, r)) + height),
            Integrand::Slope => {
                // D of it is not available: half of the digits of a backward difference are enough. Slopes only: if a
                // profile is steep they are in the range of the arithmetic, and lengths are not.
                let one = zero.lit(1);
                let h = zero.unit_roundoff().sqrt();
                let below = one.clone() - &h;
                let here = |r: &R| self.at(profile, &one, r);
                let change = |r: &R| here(r) - self.at(profile, &below, &(below.clone() * r));
                let slope = |r: &R| profile.height(&Dual { value: r.clone(), slope: one.clone() }).slope;
                let (bent, risen) = (total(&here), total(&slope));
                // At a singular end of the profile the difference is at most 1/h.
                (total(&change) / (bent.clone() + &risen) / h).greater(&(bent / risen))
            }
        };
        if condition.is_finite() { condition * zero.unit_roundoff() } else { zero }
    }
}

/// The dual number whose derivative part is r d/dr.
fn logarithmic<R: Special>(r: R) -> Dual<R> {
    Dual { value: r.clone(), slope: r }
}

/// f, Df and D²f at r: `value.value`, `slope.value`, `slope.slope`.
pub(super) fn second_order<R: Special>(profile: &impl Profile<R>, r: &R) -> Dual<Dual<R>> {
    let inner = logarithmic(r.clone());
    profile.height(&Dual { value: inner.clone(), slope: inner })
}

/// A jump with its absolute `error`.
pub(super) struct Jump<R> {
    pub(super) value: R,
    pub(super) error: R,
}

/// The jump of Df at a kink b: Df and D²f at b(1 ± h) on both sides, extrapolated to b. Zero if it is rounding only, as
/// at a kink of the second derivative.
pub(super) fn kink_jump<R: Special>(profile: &impl Profile<R>, kink: &R) -> Jump<R> {
    let h = kink.unit_roundoff().times(4);
    let side = |h: R| {
        let f = second_order(profile, &(kink.clone() * (h.lit(1) + &h))).slope;
        (f.value - f.slope.clone() * h, f.slope.abs())
    };
    let (outer, outer_bend) = side(h.clone());
    let (inner, inner_bend) = side(-h.clone());
    let error = (outer.abs() + inner.abs() + outer_bend + inner_bend) * h.times(4);
    let jump = outer - inner;
    let value = if jump.abs() > error { jump } else { jump.lit(0) };
    Jump { value, error }
}
