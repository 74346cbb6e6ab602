//! The transform of a profile: choice of the rule, pieces between kinks, errors.

use std::sync::OnceLock;

use mdr_core::calculus::{
    Estimate, Tolerance, gauss_jacobi,
    quadrature::{pieces, tanh_sinh},
    roundoff_tolerance,
};
use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::Special;

use super::gauss::{self, Ladder};
use super::integrand::{Integrand, kink_jump};
use super::strides::strides;

/// How the integrals over θ are done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Gauss–Jacobi of growing size where the profile states its tip exponent or the piece does not touch the tip, and
    /// tanh-sinh where that does not converge.
    #[default]
    Automatic,
    /// Tanh-sinh, for any profile.
    TanhSinh,
    /// Gauss–Jacobi with this many nodes on each piece, unconditionally: the fastest; look at the error estimate first.
    Gauss {
        /// Nodes a piece; 12 for power profiles in f64.
        nodes: usize,
    },
}

/// The MDR-transformed profile g of a profile given as a function, by quadrature.
///
/// Accuracy: the [tolerance](Quadrature::with_tolerance), by default 32 unit roundoffs of ∫|…|, or where it is larger the
/// condition number r φ'/φ of the integrand at r = x times the roundoff of r, as near the equator of a sphere. A transform
/// below the range of the arithmetic is 0 or nearly so, with an estimated error of its own size.
///
/// ```
/// use mdr_core::contact::Transform;
/// use mdr_numeric::{profiles::Cone, transform::Quadrature};
/// let cone = Quadrature::new(Cone::new(0.1)?);
/// assert!((cone.g(&2.0)? / (0.1 * std::f64::consts::PI) - 1.0).abs() < 1e-14); // (π/2) x tanθ
/// assert!(cone.g(&-1.0).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct Quadrature<R, P> {
    profile: P,
    rule: Rule,
    tolerance: Option<R>,
    kinks: Vec<R>,
    ladder: Option<Ladder<R>>,
    fixed: OnceLock<Fixed<R>>,
    /// Pieces that an integral may be cut into.
    strides: i64,
}

/// Waves in the narrowest piece; a rule can do some forty.
const WAVES: i64 = 20;
/// Waves that are integrated over unless more are asked for.
const PATIENCE: i64 = 500;

/// A rule of the caller's size, and one of half that size to compare with.
struct Fixed<R> {
    fine: Vec<gauss::Node<R>>,
    coarse: Vec<gauss::Node<R>>,
}

impl<R: Special, P: Profile<R>> Quadrature<R, P> {
    /// The transform of `profile` with the [automatic](Rule::Automatic) rule.
    ///
    /// The profile must be continuous with f(0) = 0, and smooth between its kinks.
    pub fn new(profile: P) -> Self {
        let ladder = profile.tip_exponent().map(Ladder::new);
        Quadrature {
            rule: Rule::default(),
            tolerance: None,
            kinks: profile.kinks(),
            ladder,
            fixed: OnceLock::new(),
            strides: PATIENCE / WAVES,
            profile,
        }
    }

    /// The same with a named rule.
    pub fn with_rule(self, rule: Rule) -> Self {
        Quadrature { rule, fixed: OnceLock::new(), ..self }
    }

    /// The same with a relative tolerance; below 32 unit roundoffs it has no effect.
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn with_tolerance(self, tolerance: R) -> Result<Self> {
        let tolerance = Some(Error::require_positive(Quantity::Parameter("the tolerance"), tolerance)?);
        Ok(Quadrature { tolerance, ..self })
    }

    /// The same for profiles with up to about this many waves inside x, 500 unless it is said otherwise; beyond it says
    /// [`NoConvergence`](Error::NoConvergence).
    ///
    /// A wave costs some twenty heights in `f64`. A search for folds visits hundreds of radii out to where quadrature
    /// fails, and takes the longer the later that is.
    pub fn with_waves(self, count: u32) -> Self {
        Quadrature { strides: (i64::from(count) / WAVES).max(1), ..self }
    }

    /// The profile.
    pub fn profile(&self) -> &P {
        &self.profile
    }

    /// g(x) with its error and the number of heights evaluated.
    ///
    /// # Errors
    /// As [`Transform::g`].
    pub fn g_estimate(&self, x: &R) -> Result<Estimate<R>> {
        self.estimate(x, Integrand::Transform)
    }

    /// g'(x) with its error; see [`g_estimate`](Self::g_estimate).
    ///
    /// # Errors
    /// As [`Transform::slope`].
    pub fn slope_estimate(&self, x: &R) -> Result<Estimate<R>> {
        let mut estimate = self.estimate(x, Integrand::Slope)?;
        for kink in self.kinks.iter().filter(|kink| *kink < x) {
            if let Some(jump) = kink_jump(&self.profile, kink) {
                // The end of a piece moves with x: sin²θ_b [Df]/cosθ_b at sinθ_b = b/x.
                let sine = kink.clone() / x;
                let cosine = ((x.clone() - kink) / x * (sine.lit(1) + &sine)).sqrt();
                estimate.value += &(sine.square() * jump / cosine / x);
            }
        }
        Ok(estimate)
    }

    /// (1/x)∫₀ˣ g with its error; see [`g_estimate`](Self::g_estimate).
    ///
    /// # Errors
    /// As [`Transform::mean`].
    pub fn mean_estimate(&self, x: &R) -> Result<Estimate<R>> {
        self.estimate(x, Integrand::Height)
    }

    /// I[φ] at x.
    fn estimate(&self, x: &R, integrand: Integrand) -> Result<Estimate<R>> {
        self.check(x)?;
        let result =
            if self.kinks.iter().any(|kink| kink < x) { self.pieces(x, integrand) } else { self.whole(x, integrand) };
        result.and_then(finite).map_err(in_our_terms)
    }

    fn check(&self, x: &R) -> Result<()> {
        if !(*x > x.lit(0) && x.is_finite()) {
            return Err(Error::domain(Quantity::Radius, x, "positive and finite"));
        }
        match self.profile.outer_radius() {
            Some(outer) if *x > outer || (*x == outer && !self.profile.wall()) => {
                Err(Error::domain(Quantity::Radius, x, "below the outer radius of the profile"))
            }
            _ => Ok(()),
        }
    }

    /// The tolerance, or what the rounding of r leaves attainable: a steep profile knows its own height no better.
    fn attainable(&self, x: &R, noise: &R) -> R {
        let (tolerance, attainable) = (self.tolerance(x), noise.clone().times(16));
        if tolerance > attainable { tolerance } else { attainable }
    }

    fn tolerance(&self, x: &R) -> R {
        let floor = roundoff_tolerance(x);
        self.tolerance.clone().filter(|tolerance| *tolerance > floor).unwrap_or(floor)
    }

    /// What the rounding of r = x sinθ does to the integrand, relative, at r = x, where it is largest.
    fn noise(&self, x: &R, integrand: Integrand) -> R {
        integrand.noise(&self.profile, std::slice::from_ref(x))
    }

    /// φ(x sinθ); 0 below sinθ = u, where no more than u² of the integral can be and where powers of r might leave the range.
    fn sample(&self, x: &R, sine: &R, integrand: Integrand) -> R {
        if *sine < sine.unit_roundoff() {
            return sine.lit(0);
        }
        integrand.at(&self.profile, sine, x)
    }

    /// I[φ] over the quarter circle in one piece.
    fn whole(&self, x: &R, integrand: Integrand) -> Result<Estimate<R>> {
        match (self.rule, &self.ladder) {
            (Rule::Gauss { nodes }, _) => self.fixed(x, nodes, integrand),
            (Rule::Automatic, Some(ladder)) => {
                let noise = self.noise(x, integrand);
                let sample = |s: &R| integrand.at(&self.profile, s, x);
                // Where more than half of the digits are noise, slow convergence might pass for it.
                let attainable = self.attainable(x, &noise).lesser(&x.unit_roundoff().sqrt());
                ladder
                    .integrate(&self.tolerance(x), &attainable, &noise, sample)
                    .map_or_else(|| self.patient(x, &x.lit(0), &quarter(x), integrand), Ok)
            }
            _ => self.patient(x, &x.lit(0), &quarter(x), integrand),
        }
    }

    /// The rule of the caller's size; its error is the distance from the rule of half that size, hence far too large. One node
    /// has none to compare with, and an error as large as the integral.
    fn fixed(&self, x: &R, count: usize, integrand: Integrand) -> Result<Estimate<R>> {
        let rules = self.fixed_rules(x, count)?;
        let (value, magnitude, fine) = self.sum(&rules.fine, x, integrand);
        let (coarse, _, fewer) = self.sum(&rules.coarse, x, integrand);
        let distance = if count == 1 { magnitude.clone() } else { (value.clone() - coarse).abs() };
        let error = distance + magnitude.unit_roundoff().times(4) * &magnitude;
        Ok(Estimate { value, error, evaluations: fine + fewer })
    }

    fn fixed_rules(&self, x: &R, count: usize) -> Result<&Fixed<R>> {
        if self.fixed.get().is_none() {
            let p = self.profile.tip_exponent().unwrap_or_else(|| x.lit(0));
            let made = Fixed { fine: gauss::nodes(&p, count)?, coarse: gauss::nodes(&p, count.div_ceil(2))? };
            // Another thread may have been faster; its rules are the same.
            let _ = self.fixed.set(made);
        }
        self.fixed.get().ok_or(Error::NoConvergence {
            quantity: Quantity::TransformedProfile,
            evaluations: 0,
            error: 1.0,
        })
    }

    fn sum(&self, nodes: &[gauss::Node<R>], x: &R, integrand: Integrand) -> (R, R, usize) {
        gauss::sum(nodes, x.lit(0), |s| integrand.at(&self.profile, s, x))
    }

    /// I[φ] piece by piece in θ between the kinks.
    fn pieces(&self, x: &R, integrand: Integrand) -> Result<Estimate<R>> {
        let inside: Vec<R> = self.kinks.iter().filter(|kink| *kink < x).map(|kink| (kink.clone() / x).asin()).collect();
        pieces(&x.lit(0), &quarter(x), &inside, |from, to| self.piece(x, from, to, integrand))
    }

    fn piece(&self, x: &R, lower: &R, upper: &R, integrand: Integrand) -> Result<Estimate<R>> {
        match (self.rule, self.weight(lower)) {
            (Rule::TanhSinh, _) | (Rule::Automatic, None) => self.patient(x, lower, upper, integrand),
            (Rule::Automatic, Some(beta)) => self
                .gauss(x, lower, upper, &beta, Tolerance::new(&self.tolerance(x)), integrand)
                .or_else(|_| self.patient(x, lower, upper, integrand)),
            (Rule::Gauss { nodes }, beta) => {
                let rule = gauss_jacobi::rule(nodes, &x.lit(0), &beta.unwrap_or_else(|| x.lit(0)))?;
                rule.integrate_with_estimate(|t| Ok(self.weighted(x, lower, upper, t, rule.beta(), integrand)))
            }
        }
    }

    /// β of the Gauss–Jacobi rule for a piece that begins at this angle; none at a tip of unknown shape.
    fn weight(&self, lower: &R) -> Option<R> {
        if *lower == lower.lit(0) { self.profile.tip_exponent().map(|p| p.lit(1) + p) } else { Some(lower.lit(0)) }
    }

    /// Gauss–Jacobi in t = (θ − θ₀)/(θ₁ − θ₀) with the weight tᵝ.
    fn gauss(
        &self,
        x: &R,
        lower: &R,
        upper: &R,
        beta: &R,
        tolerance: Tolerance<R>,
        integrand: Integrand,
    ) -> Result<Estimate<R>> {
        gauss_jacobi::integrate(&x.lit(0), beta, tolerance, |t| Ok(self.weighted(x, lower, upper, t, beta, integrand)))
    }

    /// The integrand in t with tᵝ taken out.
    fn weighted(&self, x: &R, lower: &R, upper: &R, t: &R, beta: &R, integrand: Integrand) -> R {
        let width = upper.clone() - lower;
        let sine = (width.clone() * t + lower).sin();
        let value = self.sample(x, &sine, integrand) * sine * width;
        if *beta == beta.lit(0) { value } else { value / t.pow(beta) }
    }

    /// Tanh-sinh, and where that does not converge [strides](super::strides): a hundred waves are too many for one rule.
    fn patient(&self, x: &R, lower: &R, upper: &R, integrand: Integrand) -> Result<Estimate<R>> {
        match self.double_exponential(x, lower, upper, integrand) {
            Err(Error::NoConvergence { .. }) if self.rule == Rule::Automatic => self.many(x, lower, upper, integrand),
            result => result,
        }
    }

    /// Many Gauss rules between two angles.
    fn many(&self, x: &R, lower: &R, upper: &R, integrand: Integrand) -> Result<Estimate<R>> {
        // Over many waves the integrand at one radius may happen to be small.
        let radii: [R; 8] = std::array::from_fn(|i| x.clone() - x.clone().times(i as i64).over(19));
        let noise = integrand.noise(&self.profile, &radii);
        let tolerance = Tolerance::new(&self.attainable(x, &noise)).with_noise(&noise);
        let estimate = strides(lower, upper, self.strides, |from, to| match self.weight(from) {
            Some(beta) => self.gauss(x, from, to, &beta, tolerance.clone(), integrand),
            None => self.double_exponential(x, from, to, integrand),
        })?;
        let size = |r: &R| integrand.at(&self.profile, &r.lit(1), r).abs();
        let sizes = radii.iter().fold(x.lit(0), |sum, r| sum + size(r)).over(radii.len() as i64);
        Ok(Estimate { error: sizes * noise + &estimate.error, ..estimate })
    }

    fn double_exponential(&self, x: &R, lower: &R, upper: &R, integrand: Integrand) -> Result<Estimate<R>> {
        let largest = integrand.at(&self.profile, &x.lit(1), x).abs();
        if gauss::underflows(&largest) {
            return Ok(Estimate { value: x.lit(0), error: largest, evaluations: 1 });
        }
        let to = |tolerance: Tolerance<R>| {
            tanh_sinh(lower, upper, tolerance, |theta| {
                let sine = theta.sin();
                Ok(self.sample(x, &sine, integrand) * sine)
            })
        };
        let tolerance = Tolerance::new(&self.tolerance(x));
        match to(tolerance.clone()) {
            // The noise at the end of the interval need not be that of the integral, so it is no excuse from the start.
            Err(Error::NoConvergence { quantity, evaluations, error }) => {
                let noise = self.noise(x, integrand);
                let attainable = self.attainable(x, &noise);
                // The finest rule is the best there is.
                if !(error <= attainable.approx()) {
                    return Err(Error::NoConvergence { quantity, evaluations, error });
                }
                let estimate = to(tolerance.or_noise_below(attainable))?;
                Ok(Estimate { error: estimate.value.abs() * noise + &estimate.error, ..estimate })
            }
            result => result,
        }
    }
}

impl<R: Special, P: Profile<R>> Transform<R> for Quadrature<R, P> {
    fn g(&self, x: &R) -> Result<R> {
        Ok(self.g_estimate(x)?.value)
    }

    fn slope(&self, x: &R) -> Result<R> {
        Ok(self.slope_estimate(x)?.value)
    }

    fn integral(&self, x: &R) -> Result<R> {
        let mean = self.mean(x)?;
        let integral = mean.clone() * x;
        if !integral.is_finite() {
            let log10 = (mean.abs().ln().approx() + x.ln().approx()) / std::f64::consts::LN_10;
            return Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 });
        }
        Ok(integral)
    }

    fn mean(&self, x: &R) -> Result<R> {
        Ok(self.mean_estimate(x)?.value)
    }

    /// I(Df): no difference of two integrals.
    fn above_mean(&self, x: &R) -> Result<R> {
        Ok(self.estimate(x, Integrand::Rise)?.value)
    }

    fn outer_radius(&self) -> Option<R> {
        self.profile.outer_radius()
    }

    fn wall(&self) -> bool {
        self.profile.wall()
    }

    fn kinks(&self) -> Vec<R> {
        self.kinks.clone()
    }
}

/// π/2.
fn quarter<R: Special>(like: &R) -> R {
    like.pi().over(2)
}

fn finite<R: Special>(estimate: Estimate<R>) -> Result<Estimate<R>> {
    if estimate.value.is_finite() {
        Ok(estimate)
    } else {
        let log10 = estimate.value.abs().approx().log10();
        Err(Error::OutOfRange { quantity: Quantity::TransformedProfile, log10 })
    }
}

/// The errors of the calculus, said of g.
fn in_our_terms(error: Error) -> Error {
    let quantity = Quantity::TransformedProfile;
    match error {
        Error::NoConvergence { evaluations, error, .. } => Error::NoConvergence { quantity, evaluations, error },
        Error::Domain { quantity: Quantity::Integrand, .. } => Error::OutOfRange { quantity, log10: f64::INFINITY },
        other => other,
    }
}
