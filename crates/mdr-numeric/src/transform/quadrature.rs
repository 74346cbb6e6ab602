//! The transform of a profile by quadrature, with its options.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use mdr_core::calculus::{Estimate, roundoff_tolerance};
use mdr_core::contact::{Error, Profile, Quantity, Result, Shape, Transform};
use mdr_core::number::Special;

use super::gauss::{self, Ladder};
use super::integral::Integral;
use super::integrand::Integrand;
use crate::profiles::Heights;

/// The rule for the integrals over θ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rule {
    /// Gauss–Jacobi of increasing size if the profile states its tip exponent or the piece does not touch the tip, and
    /// tanh-sinh if that does not converge.
    #[default]
    Automatic,
    /// Tanh-sinh, for any profile.
    TanhSinh,
    /// Gauss–Jacobi with this many nodes on each piece, unconditionally: the fastest; check the error estimate first.
    Gauss {
        /// Nodes per piece; 12 for power profiles in f64.
        nodes: usize,
    },
}

/// The MDR-transformed profile g of a profile given as a function, by quadrature.
///
/// Accuracy: the [tolerance](Quadrature::with_tolerance), by default 32 unit roundoffs of ∫|…|, or if it is larger the
/// condition number r φ'/φ of the integrand at r = x times the roundoff of r, as near the equator of a sphere. A
/// transform that underflows is 0 or nearly so, with an estimated error of its own magnitude.
///
/// ```
/// use mdr_core::contact::{Flank, Shape, Transform};
/// use mdr_numeric::transform::Quadrature;
/// let cone = Quadrature::of([Shape::Cone { flank: Flank::Slope(0.1) }])?;
/// assert!((cone.g(&2.0)? / (0.1 * std::f64::consts::PI) - 1.0).abs() < 1e-14); // (π/2) x tanθ
/// assert!(cone.g(&-1.0).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Quadrature<R, P> {
    pub(super) profile: P,
    pub(super) rule: Rule,
    tolerance: Option<R>,
    pub(super) kinks: Vec<R>,
    pub(super) ladder: Option<Ladder<R>>,
    /// The rule with the number of nodes set by the caller, and one of half that size to compare with.
    fixed: OnceLock<Result<[Vec<gauss::Node<R>>; 2]>>,
    /// The most pieces of an integral.
    pub(super) strides: i64,
    /// The radii below which the integrands, in their order, are lost to rounding.
    lost: Option<[R; 4]>,
    /// Heights evaluated so far.
    heights: Arc<AtomicU64>,
}

/// Waves in the narrowest piece; a rule can integrate about forty.
const WAVES: i64 = 20;
/// The default number of waves.
const PATIENCE: i64 = 500;

impl<R: Special> Quadrature<R, Heights<R>> {
    /// The transform of the sum of some shapes of the library.
    ///
    /// # Errors
    /// [`Error::Domain`] if a parameter of a shape is out of its domain; see [`Heights::new`].
    pub fn of(terms: impl Into<Vec<Shape<R>>>) -> Result<Self> {
        Heights::new(terms).map(Quadrature::new)
    }
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
            lost: None,
            heights: Arc::default(),
            profile,
        }
    }

    /// Sets the quadrature rule.
    pub fn with_rule(self, rule: Rule) -> Self {
        Quadrature { rule, fixed: OnceLock::new(), ..self }
    }

    /// Sets the relative tolerance; below 32 unit roundoffs it has no effect.
    ///
    /// # Errors
    /// [`Error::Domain`] unless it is positive and finite.
    pub fn with_tolerance(self, tolerance: R) -> Result<Self> {
        let tolerance = Some(Error::require_positive(Quantity::Parameter("the tolerance"), tolerance)?);
        Ok(Quadrature { tolerance, ..self })
    }

    /// Sets the number of waves inside x that the quadrature can resolve, about 500 by default; with more the result is
    /// [`NoConvergence`](Error::NoConvergence).
    ///
    /// A wave costs about twenty heights in `f64`. A search for folds evaluates hundreds of radii out to where
    /// quadrature fails, so its cost increases with this number.
    pub fn with_waves(self, count: u32) -> Self {
        Quadrature { strides: (i64::from(count) / WAVES).max(1), ..self }
    }

    /// Leaves out radii below which [terms cancel](super::lost_below) in the heights, the rises, the integrands of g and those of g': there the
    /// result is [`NoConvergence`](Error::NoConvergence).
    #[must_use]
    pub fn lost_below(self, radii: [R; 4]) -> Self {
        Quadrature { lost: Some(radii), ..self }
    }

    /// The profile.
    pub fn profile(&self) -> &P {
        &self.profile
    }

    /// g(x) with its error and the number of heights evaluated, including those for the error and for rules that did
    /// not converge.
    ///
    /// x and the kinks are taken to be exact: their own rounding is not in the error.
    ///
    /// # Errors
    /// Errors of the transform at x: a radius outside the profile, or a quadrature that does not converge.
    pub fn g_estimate(&self, x: &R) -> Result<Estimate<R>> {
        self.estimate(x, Integrand::Transform)
    }

    /// g'(x) with its error; see [`g_estimate`](Self::g_estimate).
    ///
    /// # Errors
    /// Errors of the transform at x: a radius outside the profile, or a quadrature that does not converge.
    pub fn slope_estimate(&self, x: &R) -> Result<Estimate<R>> {
        self.estimate(x, Integrand::Slope)
    }

    /// (1/x)∫₀ˣ g with its error; see [`g_estimate`](Self::g_estimate).
    ///
    /// # Errors
    /// Errors of the transform at x: a radius outside the profile, or a quadrature that does not converge.
    pub fn mean_estimate(&self, x: &R) -> Result<Estimate<R>> {
        self.estimate(x, Integrand::Height)
    }

    fn estimate(&self, x: &R, integrand: Integrand) -> Result<Estimate<R>> {
        self.estimate_within(x, integrand, x.lit(0))
    }

    fn estimate_within(&self, x: &R, integrand: Integrand, needed: R) -> Result<Estimate<R>> {
        self.check(x)?;
        if self.lost.as_ref().is_some_and(|lost| *x < lost[integrand as usize]) {
            let quantity = Quantity::TransformedProfile;
            return Err(Error::NoConvergence { quantity, evaluations: 0, error: 1.0 });
        }
        let estimate = Integral::new(self, x, integrand, needed).estimate();
        let heights = match &estimate {
            Ok(estimate) => estimate.evaluations,
            Err(Error::NoConvergence { evaluations, .. }) => *evaluations,
            Err(_) => 0,
        };
        self.heights.fetch_add(heights as u64, Ordering::Relaxed);
        estimate
    }

    fn check(&self, x: &R) -> Result<()> {
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

    pub(super) fn tolerance(&self, x: &R) -> R {
        let floor = roundoff_tolerance(x);
        self.tolerance.clone().filter(|tolerance| *tolerance > floor).unwrap_or(floor)
    }

    pub(super) fn fixed_rules(&self, x: &R, count: usize) -> Result<&[Vec<gauss::Node<R>>; 2]> {
        let rules = self.fixed.get_or_init(|| {
            let p = self.profile.tip_exponent().unwrap_or_else(|| x.lit(0));
            Ok([gauss::nodes(&p, count)?, gauss::nodes(&p, count.div_ceil(2))?])
        });
        rules.as_ref().map_err(Clone::clone)
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

    fn g_within(&self, x: &R, needed: &R) -> Result<R> {
        Ok(self.estimate_within(x, Integrand::Transform, needed.clone())?.value)
    }

    fn mean_within(&self, x: &R, needed: &R) -> Result<R> {
        Ok(self.estimate_within(x, Integrand::Height, needed.clone())?.value)
    }

    /// I(Df), which is not a difference of two integrals.
    fn above_mean(&self, x: &R) -> Result<R> {
        Ok(self.estimate(x, Integrand::Rise)?.value)
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
