//! Named special cases.

use mdr_core::contact::{Error, Material, Quantity, Result};
use mdr_core::number::{Real, Special};

use crate::contact::{PowerLawContact, detachment_elongation, ln_edge_length};
use crate::kappa::Kappa;
use crate::power_law::PowerLaw;
use crate::range::{product, representable};
use crate::state::State;

impl<R: Kappa> PowerLaw<R> {
    /// The paraboloid r²/(2R) of Johnson, Kendall and Roberts (1971), R in m: n = 2, κ = 2, g = x²/R.
    ///
    /// ```
    /// use mdr_analytic::{PowerLawContact, PowerLaw};
    /// use mdr_core::contact::{Control, Material};
    /// let ball = PowerLawContact::new(PowerLaw::paraboloid(1.0)?, Material::new(1.0, 1.0)?);
    /// // Fixed grips: F = −(5/6)πwR.
    /// let critical = ball.critical(&Control::Indentation)?;
    /// assert!((critical.force / (-5.0 / 6.0 * std::f64::consts::PI) - 1.0).abs() < 1e-14);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless R is positive and finite; [`Error::OutOfRange`] when 1/2R is not.
    pub fn paraboloid(radius: R) -> Result<Self> {
        let radius = Error::require_positive(Quantity::Radius, radius)?;
        let coefficient =
            representable(Quantity::Coefficient, radius.clone().inv().over(2), || -(radius.ln() + radius.lit(2).ln()))?;
        Self::new(radius.lit(2), coefficient)
    }

    /// The cone r tanθ, θ its inclination to the surface: n = 1, κ = π/2.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the slope tanθ is positive and finite.
    pub fn cone(slope: R) -> Result<Self> {
        Self::new(slope.lit(1), slope)
    }

    /// The cone with half angle α at its tip (in radians): the slope is cot α.
    ///
    /// # Errors
    /// [`Error::Domain`] unless 0 < α < π/2.
    pub fn cone_with_half_angle(half_angle: R) -> Result<Self>
    where
        R: Special,
    {
        let right = half_angle.pi().over(2);
        if half_angle > half_angle.lit(0) && half_angle < right {
            Self::cone(half_angle.cos() / half_angle.sin())
        } else {
            let quantity = Quantity::Parameter("the half angle of the cone");
            Err(Error::domain(quantity, &half_angle, "between 0 and π/2"))
        }
    }
}

/// Kendall's flat punch (1971): a cylinder of radius b, pulled off at d = −Δl(b) = −√(2πwb/E*) and
/// F = 2E*bd = −√(8πE*wb³) under either control. The limit n → ∞ of C = b⁻ⁿ.
///
/// ```
/// use mdr_analytic::flat_punch_pull_off;
/// use mdr_core::contact::Material;
/// let critical = flat_punch_pull_off(&1.0, &Material::new(1.0, 1.0)?)?;
/// assert!((critical.force + (8.0 * std::f64::consts::PI).sqrt()).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless b is positive and finite; [`Error::OutOfRange`].
pub fn flat_punch_pull_off<R: Real>(radius: &R, material: &Material<R>) -> Result<State<R>> {
    let b = Error::require_positive(Quantity::Radius, radius.clone())?;
    let ln_indentation = || (ln_edge_length(material) + b.ln()).over(2) + b.lit(2).ln();
    let indentation = -detachment_elongation(material, &b)?;
    let modulus = material.effective_modulus();
    let ln_force = || modulus.ln() + b.ln() + b.lit(2).ln() + ln_indentation();
    let force = representable(Quantity::Force, product([&indentation, modulus, &b]).times(2), ln_force)?;
    Ok(State { contact_radius: b, indentation, force })
}

impl<R: Real> PowerLawContact<R> {
    /// Kendall's punch with the radius C⁻^{1/n} that this profile approaches for n → ∞.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the radius, the indentation depth or the force is out of range.
    pub fn flat_punch_limit(&self) -> Result<State<R>> {
        let profile = self.profile();
        let ln_radius = -(profile.coefficient().ln() / profile.exponent());
        let radius = representable(Quantity::Radius, ln_radius.exp(), || ln_radius.clone())?;
        flat_punch_pull_off(&radius, self.material())
    }
}
