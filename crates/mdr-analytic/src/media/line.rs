//! Line contact: an even profile f(x) on an elastic half-plane, under a force per length.
//!
//! With F/E* for the depth and N(b) = ∫₀ᵇ x f'(x)/√(b² − x²) dx for the transformed profile, the equilibria F/E* = N(b) −
//! √(2πwb/E*) are those of (1.13), so every fold at fixed grips is one under a dead load here. A depth exists only against a
//! point at a distance on the surface.

use mdr_core::contact::{Control, Error, Material, Quantity, Regime, Result, Stability, Transform};
use mdr_core::number::Real;

use crate::contact::PowerLawContact;
use crate::kappa::Kappa;
use crate::power_law::PowerLaw;
use crate::range::representable;

const REFERENCE: Quantity = Quantity::Parameter("the reference distance L");

/// c_n = nκ_{n+1}/(n+1) = πn/(2κ_n), the factor in N(b) = c_n C bⁿ of a power law f = C|x|ⁿ in line contact.
///
/// ```
/// use mdr_analytic::media::line_factor;
/// assert!((line_factor(&2.0)? - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless n is positive and finite.
pub fn line_factor<R: Kappa>(n: &R) -> Result<R> {
    let kappa = crate::kappa::kappa(n)?;
    Ok(n.pi() * n / kappa.times(2))
}

/// The coefficient C at n = 1/2 that separates contacts that shrink under a dead load from those that spread over the whole
/// surface: √(2πw/E*)/c_{1/2} = 1.66925…√(2πw/E*), in √m. The number is twice Gauss's constant.
///
/// ```
/// use mdr_analytic::media::line_threshold;
/// use mdr_core::contact::Material;
/// let unit = Material::new(2.0 * std::f64::consts::PI, 1.0)?;
/// assert!((line_threshold(&unit)? - 1.6692536833481464).abs() < 1e-15);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn line_threshold<R: Real>(material: &Material<R>) -> Result<R> {
    let root = crate::threshold::threshold(material, &Control::Indentation)?;
    // 1/c_{1/2} = 2ϖ/π, and the threshold of the half-space is (2/ϖ)√(2πw/E*).
    let constant = crate::threshold::lemniscate_constant(&root);
    Ok(root * constant.square() / constant.pi())
}

/// S = πE*/(2 arcosh(L/b)), the stiffness per length of a flat strip of half-width b against a point of the surface at the
/// distance L from its middle, in Pa.
///
/// # Errors
/// [`Error::Domain`] unless b and L are positive and finite and L > b.
pub fn line_stiffness<R: Real>(material: &Material<R>, b: &R, reference: &R) -> Result<R> {
    Ok(material.effective_modulus().pi() * material.effective_modulus() / arcosh_quotient(b, reference)?.times(2))
}

/// The depth of a cylinder of radius R against a point of the surface at the distance L, in m:
/// δ = (2/π)(F/E*) arcosh(L/b) + (L/2R)(L − √(L² − b²)), with the force per length F at the half-width b.
///
/// ```
/// use mdr_analytic::media::cylinder_depth;
/// // Without a force only the shape is left: b²/4R for a distant reference.
/// let depth = cylinder_depth(&1.0, &0.1, &0.0, &1e4)?;
/// assert!((depth / 0.0025 - 1.0).abs() < 1e-6);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// `reduced_force` is F/E*, in m.
///
/// # Errors
/// [`Error::Domain`] unless R, b and L are positive and finite, L > b, and F/E* is finite.
pub fn cylinder_depth<R: Real>(radius: &R, b: &R, reduced_force: &R, reference: &R) -> Result<R> {
    let radius = Error::require_positive(Quantity::Radius, radius.clone())?;
    Error::require_finite(Quantity::Force, reduced_force)?;
    let pulled = arcosh_quotient(b, reference)? * reduced_force * b.lit(2) / b.pi();
    // L − √(L² − b²) = b²/(L + √(L² − b²)).
    let leg = ((reference.clone() - b) * (reference.clone() + b)).sqrt();
    Ok(pulled + b.square() * (reference.clone() / (leg + reference)) / radius.times(2))
}

/// arcosh(L/b).
fn arcosh_quotient<R: Real>(b: &R, reference: &R) -> Result<R> {
    let b = Error::require_positive(Quantity::ContactRadius, b.clone())?;
    let reference = Error::require_positive(REFERENCE, reference.clone())?;
    let beyond = reference.clone() - &b;
    if !(beyond > b.lit(0)) {
        return Err(Error::domain(REFERENCE, &reference, "beyond the half-width of the contact"));
    }
    let leg = (beyond.clone() * (reference + &b)).sqrt();
    Ok(((beyond + leg) / b).ln_1p())
}

/// A power law f = C|x|ⁿ in line contact with a half-plane, under a force per length.
///
/// ```
/// use mdr_analytic::media::LineContact;
/// use mdr_core::contact::Material;
/// // The cylinder: F = −3(πE*w²R/16)^{1/3}.
/// let cylinder = LineContact::cylinder(1.0, Material::new(1.0, 0.01)?)?;
/// let (_, force) = cylinder.critical()?;
/// assert!((force + 3.0 * (std::f64::consts::PI * 1e-4 / 16.0).cbrt()).abs() < 1e-15);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LineContact<R> {
    /// The half-space contact with the coefficient c_nC/κ_n, whose depth is F/E*.
    reduced: PowerLawContact<R>,
}

impl<R: Kappa> LineContact<R> {
    /// From n, C (m^(1−n)), E* and w.
    ///
    /// # Errors
    /// [`Error::Domain`] unless n and C are positive and finite.
    pub fn new(exponent: R, coefficient: R, material: Material<R>) -> Result<Self> {
        let factor = line_factor(&exponent)?;
        let coefficient = Error::require_positive(Quantity::Coefficient, coefficient)?;
        let kappa = crate::kappa::kappa(&exponent)?;
        let profile = PowerLaw::with_kappa(exponent, coefficient * factor / &kappa, kappa)?;
        Ok(LineContact { reduced: PowerLawContact::new(profile, material) })
    }

    /// The cylinder x²/2R, R in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless R is positive and finite; [`Error::OutOfRange`] when 1/2R is not representable.
    pub fn cylinder(radius: R, material: Material<R>) -> Result<Self> {
        let profile = PowerLaw::paraboloid(radius)?;
        Self::new(profile.exponent().clone(), profile.coefficient().clone(), material)
    }
}

impl<R: Real> LineContact<R> {
    /// The kind of instability under a dead load, from the order of n and 1/2.
    ///
    /// # Errors
    /// [`Error::Undecided`] when n is an interval around 1/2.
    pub fn regime(&self) -> Result<Regime> {
        self.reduced.regime()
    }

    /// F(b) = E*(c_n C bⁿ − √(2πwb/E*)), the force per length of the equilibrium of half-width b, in N/m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless b is positive and finite; [`Error::OutOfRange`].
    pub fn force(&self, b: &R) -> Result<R> {
        self.scaled(&self.reduced.indentation(b)?)
    }

    /// dF/db along the equilibria, in Pa.
    ///
    /// # Errors
    /// [`Error::Domain`] unless b is positive and finite; [`Error::OutOfRange`].
    pub fn force_slope(&self, b: &R) -> Result<R> {
        self.scaled(&self.reduced.indentation_slope(b)?)
    }

    /// The half-width b_c = (πw/(2E*n²c_n²C²))^{1/(2n−1)} and the force per length F_c = −((2n−1)/2n)√(2πE*w b_c) at the fold
    /// under a dead load. For n > 1/2 the contact breaks there, for n < 1/2 it spreads over the whole surface, at a pressing
    /// force.
    ///
    /// # Errors
    /// [`Error::Domain`] at n = 1/2, see [`line_threshold`]; [`Error::OutOfRange`].
    pub fn critical(&self) -> Result<(R, R)> {
        let state = self.reduced.critical(&Control::Indentation)?;
        let force = self.scaled(&state.indentation)?;
        Ok((state.contact_radius, force))
    }

    /// The half-widths of all equilibria at a force per length, increasing, with their stability under a dead load.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the force is finite; [`Error::Undecided`] over intervals; [`Error::OutOfRange`].
    pub fn half_widths(&self, force: &R) -> Result<Vec<(R, Stability)>> {
        Error::require_finite(Quantity::Force, force)?;
        let reduced = force.clone() / self.reduced.material().effective_modulus();
        let found = self.reduced.equilibria(&Control::Indentation, &reduced)?;
        Ok(found.as_slice().iter().map(|state| (state.contact_radius.clone(), state.stability)).collect())
    }

    /// G(b, F) = (E*N(b) − F)²/(2πE*b), the energy release rate of any state, in J/m²; w in equilibrium. Under a dead load the
    /// potential changes by 2(G − w) with the half-width.
    ///
    /// # Errors
    /// [`Error::Domain`] unless b is positive and F is finite; [`Error::OutOfRange`].
    pub fn energy_release_rate(&self, b: &R, force: &R) -> Result<R> {
        Error::require_finite(Quantity::Force, force)?;
        let modulus = self.reduced.material().effective_modulus();
        let missing = self.reduced.profile().g(b)? - force.clone() / modulus;
        Ok(missing.square() * modulus / (b.pi() * b).times(2))
    }

    /// The energy lost per length when the surfaces touch without a force and jump into contact: (2 − 1/n) w b₀, with the
    /// half-width b₀ at F = 0, in J/m.
    ///
    /// # Errors
    /// [`Error::Domain`] for n ≤ 1/2, where a line of contact does not grow by itself; [`Error::OutOfRange`].
    pub fn energy_lost_at_jump_in(&self) -> Result<R> {
        let n = self.reduced.profile().exponent();
        let half_width = self.reduced.radius_at_zero_indentation()?;
        if self.regime()? != Regime::PullOff {
            return Err(Error::domain(Quantity::Exponent, n, "above 1/2 for a contact that jumps in"));
        }
        let lost = half_width.clone() * self.reduced.material().work_of_adhesion() * (n.lit(2) - n.clone().inv());
        representable(Quantity::Energy, lost, || half_width.ln() + self.reduced.material().work_of_adhesion().ln())
    }

    /// E* times a length.
    fn scaled(&self, length: &R) -> Result<R> {
        let modulus = self.reduced.material().effective_modulus();
        if *length == length.lit(0) {
            return Ok(length.clone());
        }
        representable(Quantity::Force, length.clone() * modulus, || length.abs().ln() + modulus.ln())
    }
}
