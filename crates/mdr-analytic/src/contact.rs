//! A power law in adhesive contact: equilibria (1.4), (1.5), (1.13), (1.16), their slopes and the energy.

use mdr_core::contact::{Error, Material, Quantity, Regime, Result, Transform};
use mdr_core::number::Real;

use crate::power_law::PowerLaw;

/// Δl(a) = √(2πaw/E*), the elongation at which the springs at the edge let go (1.4), for a > 0, in m.
///
/// # Errors
/// [`Error::Domain`] unless a is positive and finite.
pub fn detachment_elongation<R: Real>(material: &Material<R>, a: &R) -> Result<R> {
    let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
    Ok((edge_length(material) * &a).sqrt().times(2))
}

/// B = πw/(2E*), the length in Δl(a) = 2√(Ba), in m.
#[inline(always)]
pub(crate) fn edge_length<R: Real>(material: &Material<R>) -> R {
    let pi = material.work_of_adhesion().pi();
    pi * material.work_of_adhesion() / material.effective_modulus().clone().times(2)
}

/// A power-law profile pressed against an elastic half-space, with adhesion.
///
/// Every equilibrium is labelled by its contact radius a. With B = πw/(2E*) and N = nκ_nC the elongation at the edge is
/// Δl = 2√(Ba), and critical states follow from N a^{n−1/2} = λ√B with λ = 1 under fixed grips and λ = 3 under a dead
/// load.
///
/// ```
/// use mdr_analytic::{Contact, PowerLaw};
/// use mdr_core::contact::{Control, Material};
/// let ball = Contact::new(PowerLaw::new(2.0, 0.5)?, Material::new(1.0, 1.0)?);
/// // Johnson, Kendall and Roberts: F = −(3/2)πwR under a dead load.
/// let critical = ball.critical(&Control::Force)?;
/// assert!((critical.force / (-1.5 * std::f64::consts::PI) - 1.0).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Contact<R> {
    profile: PowerLaw<R>,
    material: Material<R>,
    /// B = πw/(2E*), in m.
    edge_length: R,
}

impl<R: Real> Contact<R> {
    /// The given profile on the given material.
    #[inline(always)]
    pub fn new(profile: PowerLaw<R>, material: Material<R>) -> Self {
        let edge_length = edge_length(&material);
        Contact { profile, material, edge_length }
    }

    /// The profile.
    pub fn profile(&self) -> &PowerLaw<R> {
        &self.profile
    }

    /// The material.
    pub fn material(&self) -> &Material<R> {
        &self.material
    }

    /// The kind of instability: n against 1/2.
    ///
    /// # Errors
    /// As [`PowerLaw::regime`].
    #[inline(always)]
    pub fn regime(&self) -> Result<Regime> {
        self.profile.regime()
    }

    /// Δl(a) = √(2πaw/E*) (1.4), in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite.
    pub fn detachment_elongation(&self, a: &R) -> Result<R> {
        detachment_elongation(&self.material, a)
    }

    /// d(a) = κ_n C aⁿ − Δl(a) (1.5), (1.13), in m. Near its zero, as any difference, it is as accurate as a is.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn indentation(&self, a: &R) -> Result<R> {
        Ok(self.profile.g(a)? - self.detachment_elongation(a)?)
    }

    /// F(a) = 2E* a (n/(n+1) κ_n C aⁿ − Δl(a)) (1.6), (1.16), in N.
    ///
    /// # Errors
    /// As [`Contact::indentation`].
    pub fn force(&self, a: &R) -> Result<R> {
        let n = self.profile.exponent();
        let pressed = self.profile.g(a)? * n / (n.lit(1) + n);
        let line_stiffness = self.line_stiffness(a);
        Ok((pressed - self.detachment_elongation(a)?) * &line_stiffness)
    }

    /// d'(a) = N aⁿ⁻¹ − √(B/a) along the equilibria; its zero is the condition (1.10), (1.14).
    ///
    /// # Errors
    /// As [`Contact::indentation`].
    pub fn indentation_slope(&self, a: &R) -> Result<R> {
        Ok(self.profile.slope(a)? - (self.edge_length.clone() / a).sqrt())
    }

    /// F'(a) = 2E*(a d'(a) − Δl(a)) = 2E* a (N aⁿ⁻¹ − 3√(B/a)) along the equilibria, in N/m.
    ///
    /// # Errors
    /// As [`Contact::indentation`].
    pub fn force_slope(&self, a: &R) -> Result<R> {
        let tension = (self.edge_length.clone() / a).sqrt().times(3);
        let line_stiffness = self.line_stiffness(a);
        Ok((self.profile.slope(a)? - tension) * &line_stiffness)
    }

    /// The potential energy Π(a, d) = E*∫₀ᵃ(d−g)² dx − πa²w of any state, in equilibrium or not, in J.
    ///
    /// The integral is a[(d − g/(n+1))² + n²g²/((2n+1)(n+1)²)] with g = g(a): a sum of squares.
    ///
    /// # Errors
    /// As [`Contact::indentation`].
    pub fn energy(&self, a: &R, d: &R) -> Result<R> {
        let n = self.profile.exponent();
        let g = self.profile.g(a)?;
        let mean = g / (n.lit(1) + n);
        let spread = (mean.clone() * n).square() / (n.clone().times(2) + n.lit(1));
        let elastic = ((d.clone() - &mean).square() + &spread) * self.material.effective_modulus();
        let adhesion = a.pi() * a * self.material.work_of_adhesion();
        Ok((elastic - &adhesion) * a)
    }

    /// B = πw/(2E*), in m.
    pub(crate) fn edge_length(&self) -> &R {
        &self.edge_length
    }

    /// N = nκ_nC.
    #[inline(always)]
    pub(crate) fn slope_coefficient(&self) -> R {
        self.profile.strength() * self.profile.exponent()
    }

    /// 2E*a, the stiffness of a contact of fixed radius a, in N/m.
    fn line_stiffness(&self, a: &R) -> R {
        self.material.effective_modulus().clone().times(2) * a
    }
}
