//! The transform of any profile on other media than the half-space, by quadrature.
//!
//! With r = x sinθ and D = r d/dr, partial integration leaves no singularity at the tip (f(0) = 0). On a half-space graded as
//! zᵏ, with J[φ] = ∫₀^{π/2} sinθ cosᵏθ φ(x sinθ) dθ,
//!
//! * g(x) = J[(1 + k + D)f], x g'(x) = J[D(1 + k + D)f], and the mean of g weighted with S' is (1 + k)J[f];
//! * on a Winkler foundation, k = 1, g = f.
//!
//! In v = cos^(1+k)θ the weight is 1/(1 + k). In line contact N = ∫₀^{π/2} Df dθ and bN' = ∫₀^{π/2} D²f dθ, and against a reference
//! at the distance L the mean (2/π)∫₀ᵇ N(c)/(c√(1 − c²/L²)) dc is, with the order of the integrals changed,
//! (2/π)√(1 − b²/L²) ∫₀^{π/2} f/(1 − (b/L)² sin²θ) dθ.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use mdr_core::calculus::quadrature::{pieces, tanh_sinh_near_ends};
use mdr_core::calculus::{Estimate, Tolerance, roundoff_tolerance};
use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::{Dual, Special};

use super::integrand::{kink_jump, second_order};
use super::weight::{Density, Weight, factor_of_mean};

/// A profile given as a function, transformed for another medium.
///
/// ```
/// use mdr_core::contact::{Shape, Transform};
/// use mdr_numeric::{profiles::Heights, transform::Weighted};
/// let ball = || Heights::new([Shape::Paraboloid { radius: 1.0 }]);
/// let graded = Weighted::graded(ball()?, 0.3);
/// assert!((graded.g(&0.5)? / (0.25 / 1.3) - 1.0).abs() < 1e-13); // x²/(R(1 + k))
/// assert_eq!(Weighted::winkler(ball()?, 1.0).g(&0.5)?, 0.125);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Weighted<R, P> {
    profile: P,
    weight: Weight<R>,
    /// 1 + k; 1 for a line contact.
    order: R,
    kinks: Vec<R>,
    heights: Arc<AtomicU64>,
}

/// The least distance from a kink at which the profile is evaluated, in unit roundoffs: twice that to which the comparisons of a formula
/// such as max(r/R − 3/10, 0) tell on which side a radius is.
const BESIDE: i64 = 16;

/// Where a kink cuts a stretch.
#[derive(Clone)]
struct Cut<'k, R> {
    place: R,
    kink: &'k R,
}

/// Values of v from the edge of the contact, v = 0, or of 1 − v from its axis, up to an end.
struct Stretch<'k, R> {
    is_from_axis: bool,
    end: R,
    /// Those at the end included.
    cuts: Vec<Cut<'k, R>>,
}

impl<R: PartialEq> Stretch<'_, R> {
    fn kink_at(&self, place: &R) -> Option<&R> {
        self.cuts.iter().find(|cut| cut.place == *place).map(|cut| cut.kink)
    }
}

impl<R: Special, P: Profile<R>> Weighted<R, P> {
    fn new(profile: P, weight: Weight<R>, like: &R) -> Self {
        let (kinks, order) = (profile.kinks(), weight.order(like));
        Weighted { profile, weight, order, kinks, heights: Arc::default() }
    }

    /// On a half-space graded as zᵏ, with k within (−1, 1).
    pub fn graded(profile: P, k: R) -> Self {
        let like = k.clone();
        Self::new(profile, Weight::Graded(k), &like)
    }

    /// On a Winkler foundation; `like` has the arithmetic.
    pub fn winkler(profile: P, like: R) -> Self {
        Self::new(profile, Weight::Winkler, &like)
    }

    /// In line contact, as the N of a [`LineLoad`](super::LineLoad), with its mean against a reference at this distance; `like` has
    /// the arithmetic.
    pub fn line(profile: P, reference: Option<R>, like: R) -> Self {
        Self::new(profile, Weight::Line(reference), &like)
    }

    /// What the medium weighs with.
    pub(crate) fn weight(&self) -> &Weight<R> {
        &self.weight
    }

    /// 1 + k, 2 on a Winkler foundation, 1 in line contact.
    pub(crate) fn order(&self) -> &R {
        &self.order
    }

    /// Refuses radii at which there is no transform.
    ///
    /// # Errors
    /// [`Error::Domain`] there; [`Error::NoConvergence`] beyond the radii up to which kinks are known.
    pub(crate) fn check(&self, x: &R) -> Result<()> {
        if !(*x > x.lit(0) && x.is_finite()) {
            return Err(Error::domain(Quantity::Radius, x, "positive and finite"));
        }
        if self.profile.kinks_known_to().is_some_and(|known| *x > known) {
            let quantity = Quantity::TransformedProfile;
            return Err(Error::NoConvergence { quantity, evaluations: 0, error: 1.0 });
        }
        match self.profile.outer_radius() {
            Some(outer) if *x > outer || (*x == outer && !self.profile.vertical_edge()) => {
                Err(Error::domain(Quantity::Radius, x, "below the outer radius of the profile"))
            }
            _ => Ok(()),
        }
    }

    /// φ at r.
    fn at(&self, density: Density, r: &R) -> R {
        let logarithmic = || Dual { value: r.clone(), slope: r.clone() };
        match (density, &self.weight) {
            (Density::Height, _) => self.profile.height(r),
            (Density::Rise, _) | (Density::Transform, Weight::Line(_)) => self.profile.height(&logarithmic()).slope,
            (Density::Transform, _) => {
                let f = self.profile.height(&logarithmic());
                f.value * &self.order + f.slope
            }
            (Density::Slope, Weight::Line(_)) => second_order(&self.profile, r).slope.slope,
            (Density::Slope, _) => {
                let rise = second_order(&self.profile, r).slope;
                rise.value * &self.order + rise.slope
            }
        }
    }

    /// sinθ at v, from the distances of v from 0 and 1.
    fn sine(&self, from_lower: &R, from_upper: &R) -> R {
        let log = if from_lower.midpoint() < from_lower.ratio(1, 2) {
            from_lower.ln()
        } else {
            (-from_upper.clone()).ln_1p()
        };
        (-(log.times(2) / &self.order).exp_m1()).sqrt()
    }

    /// J[φ], or the integral over θ of a line contact.
    fn integral(&self, density: Density, x: &R, needed: &R) -> Result<Estimate<R>> {
        self.check(x)?;
        let (zero, one) = (x.lit(0), x.lit(1));
        let goal = roundoff_tolerance(x).times(4);
        let tolerance = Tolerance::new(&goal).or_noise_below(x.unit_roundoff().sqrt()).or_error_below(needed);
        let inner: Vec<&R> = self.kinks.iter().filter(|kink| *kink < x).collect();
        let mut count = 0;
        let mut over = |stretch: &Stretch<'_, R>| {
            let places: Vec<R> = stretch.cuts.iter().map(|cut| cut.place.clone()).collect();
            pieces(&zero, &stretch.end, &places, |from, to| {
                let [least, most] = self.sides(stretch, x, [from, to]);
                tanh_sinh_near_ends(from, to, tolerance.clone(), |node| {
                    count += 1;
                    let near = if *from == zero { node.from_lower.clone() } else { node.x.clone() };
                    let far = if *to == one { node.from_upper.clone() } else { one.clone() - &node.x };
                    let sine = if stretch.is_from_axis { self.sine(&far, &near) } else { self.sine(&near, &far) };
                    // Closer to the tip powers of r leave the range, and contribute nothing.
                    if !(sine.clone() > sine.unit_roundoff().square()) {
                        return Ok(zero.clone());
                    }
                    let radius = match (&least, &most) {
                        (Some(least), _) if sine.clone() * x < *least => least.clone(),
                        (_, Some(most)) if sine.clone() * x > *most => most.clone(),
                        _ => sine.clone() * x,
                    };
                    let height = self.at(density, &radius);
                    Ok(match &self.weight {
                        Weight::Line(Some(reference)) if density == Density::Height => {
                            let share = sine.clone() * x / reference;
                            height / sine / (one.clone() - share.square())
                        }
                        Weight::Line(_) => height / sine,
                        _ => height,
                    })
                })
            })
        };
        let estimate = self.stretches(&inner, x).iter().try_fold(Estimate::exact(zero.clone()), |mut sum, stretch| {
            sum += &over(stretch)?;
            Ok(sum)
        });
        self.heights.fetch_add(count, Ordering::Relaxed);
        let mut estimate = estimate.map_err(|error| match error {
            Error::NoConvergence { .. } if self.overflows(x) => {
                Error::OutOfRange { quantity: Quantity::TransformedProfile, log10: f64::INFINITY }
            }
            Error::NoConvergence { evaluations, error, .. } => {
                Error::NoConvergence { quantity: Quantity::TransformedProfile, evaluations, error }
            }
            error => error,
        })?;
        if !self.is_of_line() {
            estimate = estimate.scaled(&self.order.clone().inv());
        }
        if density == Density::Slope {
            for kink in inner {
                let jump = kink_jump(&self.profile, kink);
                let factor = self.share_of_jump(kink, x);
                estimate.value += &(factor.clone() * jump.value);
                estimate.error += &(factor * jump.error);
            }
        }
        if !estimate.value.is_finite() {
            let log10 = estimate.value.approx().abs().log10();
            return Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 });
        }
        Ok(estimate)
    }

    /// The domain of v cut at kinks below x: of those next to the axis the places in 1 − v, which keep their digits there.
    fn stretches<'k>(&self, inner: &[&'k R], x: &R) -> Vec<Stretch<'k, R>> {
        let (one, half) = (x.lit(1), x.ratio(1, 2));
        let cut = |kink: &&'k R| Cut { place: self.position(kink, x), kink: *kink };
        let (edge, rest): (Vec<_>, Vec<_>) = inner.iter().map(cut).partition(|cut| cut.place < half);
        if rest.is_empty() {
            return vec![Stretch { is_from_axis: false, end: one, cuts: edge }];
        }
        let from_axis = |cut: Cut<'k, R>| Cut { place: self.position_from_axis(cut.kink, x), ..cut };
        let mut axis: Vec<_> = rest.into_iter().map(from_axis).collect();
        // The kink farthest from the edge, of those that are counted from there.
        let border = edge.iter().reduce(|one, other| if other.place > one.place { other } else { one });
        let Some(border) = border.cloned() else {
            return vec![Stretch { is_from_axis: true, end: one, cuts: axis }];
        };
        let ends = [border.place.clone(), one - &border.place];
        axis.push(Cut { place: ends[1].clone(), ..border });
        let [to_border, to_axis] = ends;
        vec![
            Stretch { is_from_axis: false, end: to_border, cuts: edge },
            Stretch { is_from_axis: true, end: to_axis, cuts: axis },
        ]
    }

    /// The least and the greatest radius at which the profile is evaluated on a piece that a kink ends: a few numbers beside it, where the
    /// formula of that side holds, though it was rounded too. Below a kink that is not told apart from x all radii are on one side.
    fn sides(&self, stretch: &Stretch<'_, R>, x: &R, piece: [&R; 2]) -> [Option<R>; 2] {
        let [inner, outer] = if stretch.is_from_axis { piece } else { [piece[1], piece[0]] };
        let beside = |kink: &R, side: i64| x.unit_roundoff().times(side * BESIDE) * kink + kink;
        let least = stretch.kink_at(inner).map(|kink| {
            let least = beside(kink, 1);
            let exists = self.profile.outer_radius().is_none_or(|outer| least < outer);
            if exists { least } else { least.lesser(x) }
        });
        let is_edge = if stretch.is_from_axis { *outer == x.lit(1) } else { *outer == x.lit(0) };
        let most = match stretch.kink_at(outer) {
            Some(kink) => Some(beside(kink, -1)),
            None if is_edge => {
                let mut beyond = self.kinks.iter().filter(|kink| *kink >= x).map(|kink| beside(kink, -1));
                beyond.find(|most| most < x)
            }
            None => None,
        };
        [least, most]
    }

    /// Whether f at x is so large that sums over it leave the range of the arithmetic.
    fn overflows(&self, x: &R) -> bool {
        let size = self.at(Density::Height, x).abs();
        size > x.lit(0) && !size.times(1 << 24).is_finite()
    }

    fn is_of_line(&self) -> bool {
        matches!(self.weight, Weight::Line(_))
    }

    /// v at a kink.
    fn position(&self, kink: &R, x: &R) -> R {
        cosine(kink, x).pow(&self.order)
    }

    /// 1 − v at a kink.
    fn position_from_axis(&self, kink: &R, x: &R) -> R {
        let share = kink.clone() / x;
        -((-share.square()).ln_1p() * &self.order).over(2).exp_m1()
    }

    /// The part of a jump of Df at a kink in x g': sin²θ cos^(k−1)θ, and tanθ in line contact.
    fn share_of_jump(&self, kink: &R, x: &R) -> R {
        let (sine, cosine) = (kink.clone() / x, cosine(kink, x));
        match self.weight {
            Weight::Line(_) => sine / cosine,
            _ => sine.square() * cosine.pow(&(self.order.clone() - cosine.lit(2))),
        }
    }

    fn value(&self, density: Density, x: &R) -> Result<R> {
        Ok(self.integral(density, x, &x.lit(0))?.value)
    }
}

/// cosθ at sinθ = b/x.
fn cosine<R: Special>(kink: &R, x: &R) -> R {
    ((x.clone() - kink) / x * ((x.clone() + kink) / x)).sqrt()
}

impl<R: Special, P: Profile<R>> Transform<R> for Weighted<R, P> {
    fn g(&self, x: &R) -> Result<R> {
        self.g_within(x, &x.lit(0))
    }

    fn slope(&self, x: &R) -> Result<R> {
        if let Weight::Winkler = self.weight {
            self.check(x)?;
            return Ok(self.profile.height(&Dual::variable(x.clone())).slope);
        }
        Ok(self.value(Density::Slope, x)? / x)
    }

    /// x times the mean.
    fn integral(&self, x: &R) -> Result<R> {
        Ok(self.mean(x)? * x)
    }

    fn mean(&self, x: &R) -> Result<R> {
        self.mean_within(x, &x.lit(0))
    }

    fn g_within(&self, x: &R, needed: &R) -> Result<R> {
        if let Weight::Winkler = self.weight {
            self.check(x)?;
            return Ok(self.profile.height(x));
        }
        Ok(self.integral(Density::Transform, x, needed)?.value)
    }

    fn mean_within(&self, x: &R, needed: &R) -> Result<R> {
        match &self.weight {
            Weight::Line(None) => Ok(x.lit(0)),
            Weight::Line(Some(reference)) => {
                let factor = factor_of_mean(x, reference);
                // What the mean needs, its integral needs over the factor.
                Ok(self.integral(Density::Height, x, &(needed.clone() / &factor))?.value * factor)
            }
            _ => Ok(self.integral(Density::Height, x, needed)?.value * &self.order),
        }
    }

    fn above_mean(&self, x: &R) -> Result<R> {
        self.value(Density::Rise, x)
    }

    fn outer_radius(&self) -> Option<R> {
        self.profile.outer_radius()
    }

    fn vertical_edge(&self) -> bool {
        self.profile.vertical_edge()
    }

    fn kinks(&self) -> Vec<R> {
        self.kinks.clone()
    }

    fn work(&self) -> u64 {
        self.heights.load(Ordering::Relaxed)
    }
}
