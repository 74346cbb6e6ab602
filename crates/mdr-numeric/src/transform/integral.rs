//! One integral I[φ]: choice of the rule, pieces between kinks, errors, and the number of heights evaluated.

use mdr_core::calculus::{Estimate, Tolerance, gauss_jacobi, quadrature::tanh_sinh};
use mdr_core::contact::{Error, Profile, Quantity, Result};
use mdr_core::number::Special;

use super::angles::{Angles, sine_and_cosine};
use super::counted::CountingProfile;
use super::gauss;
use super::integrand::{Integrand, kink_jump};
use super::quadrature::{Quadrature, Rule};
use super::strides::strides;

/// I[φ] at x.
pub(super) struct Integral<'a, R, P> {
    quadrature: &'a Quadrature<R, P>,
    profile: CountingProfile<'a, P>,
    x: &'a R,
    integrand: Integrand,
    /// An absolute error that is small enough; 0 if the tolerance decides.
    needed: R,
}

impl<'a, R: Special, P: Profile<R>> Integral<'a, R, P> {
    pub(super) fn new(quadrature: &'a Quadrature<R, P>, x: &'a R, integrand: Integrand, needed: R) -> Self {
        Integral { quadrature, profile: CountingProfile::new(&quadrature.profile), x, integrand, needed }
    }

    /// I[φ], for g' with the contributions of the kinks. All heights are counted, including those of rules that failed.
    pub(super) fn estimate(&self) -> Result<Estimate<R>> {
        let estimate = self.smooth().map(|estimate| match self.integrand {
            Integrand::Slope => self.with_kinks(estimate),
            _ => estimate,
        });
        let evaluations = self.profile.heights();
        match estimate {
            Ok(estimate) => finite(Estimate { evaluations, ..estimate }),
            Err(error) => Err(in_our_terms(error, evaluations)),
        }
    }

    /// I[φ] between the kinks.
    fn smooth(&self) -> Result<Estimate<R>> {
        if self.quadrature.kinks.iter().all(|kink| kink >= self.x) {
            return self.whole();
        }
        let mut total = Estimate::exact(self.x.lit(0));
        for angles in Angles::between(&self.quadrature.kinks, self.x) {
            total += &self.piece(&angles)?;
        }
        Ok(total)
    }

    /// g' with its terms from kinks b. The end of a piece moves with x: sin²θ_b \[Df\]/(x cosθ_b) at sinθ_b = b/x.
    ///
    /// x and b are taken to be exact, so that the factor of the jump has at most twelve roundings, and the angle of the
    /// kink is accurate to one rounding.
    fn with_kinks(&self, smooth: Estimate<R>) -> Estimate<R> {
        let mut total = smooth;
        for kink in self.quadrature.kinks.iter().filter(|kink| *kink < self.x) {
            let jump = kink_jump(&self.profile, kink);
            let [sine, cosine] = sine_and_cosine(kink, self.x);
            let factor = sine.square() / cosine / self.x;
            let rounding = jump.value.abs() * jump.value.unit_roundoff().times(12);
            total.value += &(factor.clone() * jump.value);
            total.error += &(factor * (jump.error + rounding));
        }
        total
    }

    /// φ(x sinθ).
    fn at(&self, sine: &R) -> R {
        self.integrand.at(&self.profile, sine, &(sine.clone() * self.x))
    }

    /// sinθ φ(x sinθ) at one of the angles; 0 below sinθ = u, which contributes at most u² of the integral and where
    /// powers of r might leave the range.
    fn sample(&self, angles: &Angles<R>, angle: &R) -> R {
        let sine = angles.sine(angle);
        if sine < sine.unit_roundoff() {
            return sine.lit(0);
        }
        self.integrand.at(&self.profile, &sine, &angles.radius(&sine, self.x)) * sine
    }

    fn tolerance(&self) -> R {
        self.quadrature.tolerance(self.x)
    }

    /// The tolerance, or the accuracy attainable with the rounding of r, which limits steep profiles.
    fn attainable(&self, noise: &R) -> R {
        self.tolerance().greater(&noise.clone().times(16))
    }

    /// This goal, or an error that is small enough.
    fn to(&self, goal: &R) -> Tolerance<R> {
        Tolerance::new(goal).or_error_below(&self.needed)
    }

    /// The relative effect of the rounding of r = x sinθ on the integrand at the larger end, where it is largest.
    fn noise(&self, angles: &Angles<R>) -> R {
        self.integrand.noise(&self.profile, &[angles.largest_radius(self.x)])
    }

    /// I[φ] over the quarter circle in one piece.
    fn whole(&self) -> Result<Estimate<R>> {
        let quarter = Angles::quarter(self.x);
        match (self.quadrature.rule, &self.quadrature.ladder) {
            (Rule::Gauss { nodes }, _) => self.fixed(nodes),
            (Rule::Automatic, Some(ladder)) => {
                let noise = self.noise(&quarter);
                // If more than half of the digits are noise, slow convergence could be mistaken for noise.
                let attainable = self.attainable(&noise).lesser(&self.x.unit_roundoff().sqrt());
                ladder
                    .integrate(&self.tolerance(), &attainable, &self.needed, &noise, |s| self.at(s))
                    .map_or_else(|| self.patient(&quarter), Ok)
            }
            _ => self.patient(&quarter),
        }
    }

    /// The rule with the number of nodes set by the caller; its error estimate is the difference from the rule of half
    /// that size, hence far too large. One node has no smaller rule, and an error as large as the integral.
    fn fixed(&self, count: usize) -> Result<Estimate<R>> {
        let [fine, coarse] = self.quadrature.fixed_rules(self.x, count)?;
        let sum = |nodes| gauss::sum(nodes, self.x.lit(0), |s| self.at(s));
        let ((value, magnitude), (coarse, _)) = (sum(fine), sum(coarse));
        let distance = if count == 1 { magnitude.clone() } else { (value.clone() - coarse).abs() };
        let error = distance + magnitude.unit_roundoff().times(4) * &magnitude;
        Ok(Estimate { error, ..Estimate::exact(value) })
    }

    /// I[φ] between two kinks.
    fn piece(&self, angles: &Angles<R>) -> Result<Estimate<R>> {
        match (self.quadrature.rule, self.weight(angles)) {
            (Rule::TanhSinh, _) | (Rule::Automatic, None) => self.patient(angles),
            (Rule::Automatic, Some(beta)) => match self.gauss(angles, &beta, self.to(&self.tolerance())) {
                Ok(estimate) => Ok(with_noise(estimate, &self.noise(angles))),
                Err(_) => self.patient(angles),
            },
            (Rule::Gauss { nodes }, beta) => {
                let zero = self.x.lit(0);
                let rule = gauss_jacobi::rule(nodes, &zero, &beta.unwrap_or_else(|| zero.clone()))?;
                rule.integrate_with_estimate(|t| Ok(self.weighted(angles, t, rule.beta())))
            }
        }
    }

    /// β of the Gauss–Jacobi rule for a piece; `None` at a tip of unknown shape.
    fn weight(&self, angles: &Angles<R>) -> Option<R> {
        if angles.touch_tip() {
            self.quadrature.profile.tip_exponent().map(|p: R| p.lit(1) + p)
        } else {
            Some(self.x.lit(0))
        }
    }

    /// Gauss–Jacobi in t from 0 to 1, with the weight tᵝ.
    fn gauss(&self, angles: &Angles<R>, beta: &R, tolerance: Tolerance<R>) -> Result<Estimate<R>> {
        gauss_jacobi::integrate(&self.x.lit(0), beta, tolerance, |t| Ok(self.weighted(angles, t, beta)))
    }

    /// The integrand in t divided by tᵝ.
    fn weighted(&self, angles: &Angles<R>, t: &R, beta: &R) -> R {
        let width = angles.upper.clone() - &angles.lower;
        let value = self.sample(angles, &(width.clone() * t + &angles.lower)) * width;
        if *beta == beta.lit(0) { value } else { value / t.pow(beta) }
    }

    /// The integrand between two angles if it consists of the rounding of terms that cancel only, as of abs(r - 1) +
    /// r - 1 before 1: the error is all of it. Two precisions do not agree on it; in doubles, which searches for folds
    /// use, it is 0, since noise over a small radius would look like a slope.
    fn rounding(&self, angles: &Angles<R>) -> Option<Estimate<R>> {
        /// Roundings of the largest term, including those of its derivatives.
        const ROUNDINGS: i64 = 256;
        const SAMPLES: i64 = 8;
        let width = angles.upper.clone() - &angles.lower;
        let mut total = Estimate::exact(self.x.lit(0));
        for i in 0..SAMPLES {
            let angle = width.clone().times(2 * i + 1).over(2 * SAMPLES) + &angles.lower;
            let radius = angles.radius(&angles.sine(&angle), self.x);
            let term = self.quadrature.profile.largest_term(&radius)?;
            let noise = term.unit_roundoff().times(ROUNDINGS) * term;
            // For g', noise in the slopes of f.
            let noise = if self.integrand == Integrand::Slope { noise / &radius } else { noise };
            let value = self.sample(angles, &angle);
            // Terms that overflow say nothing of rounding.
            if value.abs() > noise || !value.is_finite() || !noise.is_finite() {
                return None;
            }
            total.value += &value;
            total.error += &noise;
        }
        let mean = |sum: R| (sum * &width).over(SAMPLES);
        let is_double = self.x.precision() <= f64::MANTISSA_DIGITS;
        let value = if is_double { self.x.lit(0) } else { mean(total.value) };
        Some(Estimate { error: mean(total.error), ..Estimate::exact(value) })
    }

    /// Tanh-sinh, and if that does not converge [strides](super::strides): a hundred waves are too many for one rule.
    fn patient(&self, angles: &Angles<R>) -> Result<Estimate<R>> {
        match self.double_exponential(angles) {
            Err(Error::NoConvergence { .. }) if self.quadrature.rule == Rule::Automatic => {
                self.rounding(angles).map_or_else(|| self.many(angles), Ok)
            }
            result => result,
        }
    }

    /// Many Gauss rules between two angles.
    fn many(&self, angles: &Angles<R>) -> Result<Estimate<R>> {
        // Over many waves the integrand at one radius may be small by chance.
        let x = self.x;
        let radii: [R; 8] = std::array::from_fn(|i| x.clone() - x.clone().times(i as i64).over(19));
        let noise = self.integrand.noise(&self.profile, &radii);
        let tolerance = self.to(&self.attainable(&noise)).with_noise(&noise);
        let estimate = strides(&angles.lower, &angles.upper, self.quadrature.strides, |from, to| {
            let stride = angles.part(from, to);
            match self.weight(&stride) {
                Some(beta) => self.gauss(&stride, &beta, tolerance.clone()),
                None => self.double_exponential(&stride),
            }
        })?;
        let size = |r: &R| self.integrand.at(&self.profile, &r.lit(1), r).abs();
        let sizes = radii.iter().fold(x.lit(0), |sum, r| sum + size(r)).over(radii.len() as i64);
        Ok(Estimate { error: sizes * noise + &estimate.error, ..estimate })
    }

    fn double_exponential(&self, angles: &Angles<R>) -> Result<Estimate<R>> {
        let largest = self.at(&self.x.lit(1)).abs();
        if gauss::underflows(&largest) {
            return Ok(Estimate { error: largest, ..Estimate::exact(self.x.lit(0)) });
        }
        // The noise at the end of the interval need not be that of the integral, so it is accepted only at the finest
        // rule.
        let noise = self.noise(angles);
        let tolerance = self.to(&self.tolerance()).or_finest_below(self.attainable(&noise));
        let estimate = tanh_sinh(&angles.lower, &angles.upper, tolerance, |angle| Ok(self.sample(angles, angle)))?;
        Ok(with_noise(estimate, &noise))
    }
}

/// The error including the contribution of a relative noise of the integrand.
fn with_noise<R: Special>(estimate: Estimate<R>, noise: &R) -> Estimate<R> {
    Estimate { error: estimate.value.abs() * noise + &estimate.error, ..estimate }
}

fn finite<R: Special>(estimate: Estimate<R>) -> Result<Estimate<R>> {
    if estimate.value.is_finite() {
        Ok(estimate)
    } else {
        let log10 = estimate.value.abs().approx().log10();
        Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 })
    }
}

/// The errors of the calculus, with g as their quantity.
fn in_our_terms(error: Error, evaluations: usize) -> Error {
    let quantity = Quantity::TransformedProfile;
    match error {
        Error::NoConvergence { error, .. } => Error::NoConvergence { quantity, evaluations, error },
        Error::Domain { quantity: Quantity::Integrand, .. } => Error::OutOfRange { quantity, log10: f64::INFINITY },
        other => other,
    }
}
