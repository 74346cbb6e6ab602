//! Any even periodic profile on a half-plane, by quadrature.
//!
//! A strip |x| < a in each period λ carries without adhesion the mean pressure (E*/λ)M, M = ∫₀ᵃ f'(x) sinX/√(s − sin²X) dx with
//! X = πx/λ and s = sin²(πa/λ) (K. L. Johnson, Contact Mechanics, Cambridge 1985, chapter 13). With sinX = √s sinφ
//!
//! * g minus its mean is (Λ/π)M, M = (λ/π)∫₀^{π/2} f' tanX dφ, Λ = −ln s;
//! * g' = (Λ/π)M';
//! * the mean is (2λ/π²)∫₀^{π/2} f' (π/2 − φ) √s cosφ/cosX dφ.

use mdr_core::calculus::{Estimate, Tolerance, quadrature::tanh_sinh_pieces, roundoff_tolerance};
use mdr_core::contact::{Error, Profile, Quantity, Result, Transform};
use mdr_core::number::{Dual, Special};

use super::integrand::kink_jump;
use crate::medium::{WAVELENGTH, openness, phase};

/// A periodic profile with one contact in each period, on a [periodic](crate::medium::Medium::Periodic) medium; sizes are those of
/// the medium.
///
/// ```
/// use mdr_core::contact::{Profile, Transform};
/// use mdr_core::number::Lift;
/// use mdr_numeric::transform::{Periodic, Wave};
/// struct Cosine;
/// impl Profile<f64> for Cosine {
///     fn height<S: Lift<f64>>(&self, r: &S) -> S {
///         (r.pi() * r).sin().square().times(2) // 1 − cos 2πr
///     }
/// }
/// let (by_quadrature, closed) = (Periodic::new(Cosine, 1.0)?, Wave::new(1.0, 1.0)?);
/// assert!((by_quadrature.g(&0.4)? / closed.g(&0.4)? - 1.0).abs() < 1e-13);
/// assert!((by_quadrature.slope(&0.4)? / closed.slope(&0.4)? - 1.0).abs() < 1e-13);
/// assert!(Periodic::new(Cosine, 0.7).is_err()); // of another period
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Periodic<R, P> {
    profile: P,
    wavelength: R,
    kinks: Vec<R>,
}

/// Radii at which the form of a profile is checked.
const CHECKED: i64 = 400;

impl<R: Special, P: Profile<R>> Periodic<R, P> {
    /// A profile with the period λ, in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless λ is positive and finite; unless f repeats after λ and is even around λ/2; and unless it rises from
    /// 0 to λ/2: otherwise there may be more than one contact in a period.
    pub fn new(profile: P, wavelength: R) -> Result<Self> {
        let wavelength = Error::require_positive(WAVELENGTH, wavelength)?;
        let half = wavelength.clone().over(2);
        let at = |step: i64| half.clone().times(step).over(CHECKED);
        let top = (1..=CHECKED).map(|step| profile.height(&at(step)).abs());
        let top = top.fold(half.lit(0), |top, height| top.greater(&height));
        let tolerance = (top.unit_roundoff().times(1 << 20)) * &top;
        for step in 1..CHECKED {
            let x = at(step);
            let height = profile.height(&x);
            let mirrored = [wavelength.clone() - &x, wavelength.clone() + &x].map(|x| profile.height(&x) - &height);
            if mirrored.iter().any(|change| !(change.abs() <= tolerance)) {
                let requirement = "the period of an even profile, f(λ − x) = f(λ + x) = f(x): this profile is not periodic with it; take \
                     its own period, or kind = \"wave\"";
                return Err(Error::domain(WAVELENGTH, &wavelength, requirement));
            }
            if !(profile.height(&Dual::variable(x.clone())).slope >= x.lit(0)) {
                let requirement = "beyond half of the wavelength, or there may be more than one contact in a period: take the \
                                   period of one contact, or kind = \"wave\"";
                return Err(Error::domain(
                    Quantity::Parameter("the first radius at which the profile falls"),
                    &x,
                    requirement,
                ));
            }
        }
        let mut kinks = profile.kinks();
        kinks.retain(|kink| *kink < half);
        Ok(Periodic { profile, wavelength, kinks })
    }

    /// ∫₀^{π/2} of a function of φ, sinφ, cosφ and X, cosX at a size.
    fn integral(&self, b: &R, f: impl Fn(&Angle<R>) -> R) -> Result<Estimate<R>> {
        let t = phase(&Error::require_positive(Quantity::ContactRadius, b.clone())?, &self.wavelength);
        let root = (t.square() + t.lit(1)).sqrt();
        let (sine, cosine) = (t / &root, root.inv());
        let zero = b.lit(0);
        let breaks: Vec<R> = self
            .kinks
            .iter()
            .map(|kink| phase(kink, &self.wavelength).sin() / &sine)
            .filter(|ratio| *ratio < ratio.lit(1))
            .map(|ratio| ratio.asin())
            .collect();
        let goal = roundoff_tolerance(b).times(4);
        let tolerance = Tolerance::new(&goal).or_noise_below(b.unit_roundoff().sqrt());
        let quarter = b.pi().over(2);
        tanh_sinh_pieces(&zero, &quarter, &breaks, tolerance, |phi| {
            let (up, across) = phi.sin_and_cos();
            let position = up.clone() * &sine;
            let open = (across.square() + (cosine.clone() * &up).square()).sqrt();
            let x = (position.clone() / &open).atan() * &self.wavelength / b.pi();
            let angle = Angle {
                left: quarter.clone() - phi,
                x,
                sine: up,
                cosine: across,
                position,
                open,
                closed: sine.clone(),
                rest: cosine.clone(),
            };
            Ok(f(&angle))
        })
    }

    fn slope_of(&self, x: &R) -> R {
        self.profile.height(&Dual::variable(x.clone())).slope
    }

    /// λ/π.
    fn per_phase(&self) -> R {
        self.wavelength.clone() / self.wavelength.pi()
    }
}

/// A place within a strip.
struct Angle<R> {
    /// π/2 − φ.
    left: R,
    /// x.
    x: R,
    /// sinφ.
    sine: R,
    /// cosφ.
    cosine: R,
    /// sinX.
    position: R,
    /// cosX.
    open: R,
    /// √s = sin(πa/λ).
    closed: R,
    /// cos(πa/λ).
    rest: R,
}

impl<R: Special, P: Profile<R>> Transform<R> for Periodic<R, P> {
    fn g(&self, b: &R) -> Result<R> {
        Ok(self.above_mean(b)? + self.mean(b)?)
    }

    fn slope(&self, b: &R) -> Result<R> {
        let per_phase = self.per_phase();
        let smooth = self.integral(b, |at| {
            let f = self.profile.height(&Dual::variable(Dual::variable(at.x.clone()))).slope;
            let tangent = at.position.clone() / &at.open;
            let growth = f.slope * &per_phase * tangent + f.value / at.open.square();
            growth * &at.rest * &at.sine / &at.open
        })?;
        let t = phase(b, &self.wavelength);
        let mut total = smooth.value;
        for kink in &self.kinks {
            let place = phase(kink, &self.wavelength);
            let root = (t.square() + t.lit(1)).sqrt();
            let ratio = place.sin() / (t.clone() / root);
            if ratio < ratio.lit(1) {
                let tangent = ratio.clone() / ((ratio.lit(1) - &ratio) * (ratio.lit(1) + &ratio)).sqrt();
                let jump = kink_jump(&self.profile, kink).value / kink;
                total += &(jump * place.sin() / place.cos() * tangent / &t);
            }
        }
        let growth = (t.square() + t.lit(1)).inv() / &per_phase;
        Ok(total * &per_phase * growth * openness(b, &self.wavelength) / b.pi())
    }

    /// x times the mean.
    fn integral(&self, b: &R) -> Result<R> {
        Ok(self.mean(b)? * b)
    }

    fn mean(&self, b: &R) -> Result<R> {
        let share = self.integral(b, |at| self.slope_of(&at.x) * &at.left * &at.closed * &at.cosine / &at.open)?;
        Ok((share.value * self.per_phase() / b.pi()).times(2))
    }

    fn above_mean(&self, b: &R) -> Result<R> {
        let load = self.integral(b, |at| self.slope_of(&at.x) * &at.position / &at.open)?;
        Ok(load.value * self.per_phase() * openness(b, &self.wavelength) / b.pi())
    }

    fn kinks(&self) -> Vec<R> {
        self.kinks
            .iter()
            .map(|kink| phase(kink, &self.wavelength))
            .map(|x| x.sin() / x.cos() * self.per_phase())
            .collect()
    }
}
