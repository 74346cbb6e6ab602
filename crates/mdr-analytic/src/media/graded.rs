//! Power laws on a half-space whose modulus grows with depth as a power, E(z) = E₀(z/z₀)ᵏ: states, slopes and energy.

use mdr_core::contact::{Error, Material, Quantity, Regime, Result, Transform};
use mdr_core::number::{Gamma, Real};

use crate::contact::PowerLawContact;
use crate::kappa::Kappa;
use crate::power_law::PowerLaw;
use crate::range::{difference, ordinary, product, representable};

/// k, for errors.
pub(super) const GRADING: Quantity = Quantity::Parameter("the grading exponent k");
const COEFFICIENT: Quantity = Quantity::Parameter("the coefficient c of the graded half-space");
const MODULUS: Quantity = Quantity::Parameter("the modulus of the foundation");

/// κ(n, k) = Γ(1+n/2)Γ((1+k)/2)/Γ((n+1+k)/2), the factor in g(x) = κ(n, k) C xⁿ on a half-space with E ∝ zᵏ. It is κ_n
/// of (1.12) at k = 0, and 1 on a Winkler foundation, k = 1.
///
/// ```
/// let quarter = mdr_analytic::media::graded_kappa(&2.0, &0.3)?;
/// assert!((quarter - 2.0 / 1.3).abs() < 1e-15); // κ(2, k) = 2/(1 + k)
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless n is positive and finite and −1 < k ≤ 1.
pub fn graded_kappa<R: Kappa + Gamma>(n: &R, k: &R) -> Result<R> {
    let n = Error::require_positive(Quantity::Exponent, n.clone())?;
    let (zero, one) = (n.lit(0), n.lit(1));
    if *k == zero {
        return Ok(R::kappa(&n));
    }
    if *k == one {
        return Ok(one);
    }
    require_grading(k)?;
    // Γ(1+n/2) of a double leaves the range beyond n = 340.
    const LARGEST: f64 = 300.0;
    let next = n.clone().over(2) + &one;
    let weight = (one + k).over(2);
    let whole = n.clone().over(2) + &weight;
    if n.approx() < LARGEST {
        return Ok(next.gamma() * weight.gamma() / whole.gamma());
    }
    Ok((next.ln_gamma() - whole.ln_gamma()).exp() * weight.gamma())
}

/// Refuses k outside of (−1, 1).
fn require_grading<R: Real>(k: &R) -> Result<()> {
    if *k > k.lit(-1) && *k < k.lit(1) {
        return Ok(());
    }
    Err(Error::domain(GRADING, k, "within (-1, 1); a Winkler foundation is the medium for k = 1"))
}

/// An elastic half-space with the modulus E(z) = E₀(z/z₀)ᵏ, or a Winkler foundation, with its work of adhesion.
///
/// A flat punch of radius a has the stiffness S = 2c a^{1+k}/(1+k), and edge springs detach at Δl = √(2πw a^{1−k}/c). The
/// coefficient c, in N/m^(2+k), is E* at k = 0, and π times the modulus of the foundation (Pa/m) at k = 1.
///
/// ```
/// use mdr_analytic::media::GradedHalfSpace;
/// let medium = GradedHalfSpace::new(0.3, 1.0, 0.01)?;
/// assert!((medium.punch_stiffness(&2.0)? - 2.0 * 2.0_f64.powf(1.3) / 1.3).abs() < 1e-14);
/// assert!(GradedHalfSpace::new(1.0, 1.0, 0.01).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GradedHalfSpace<R> {
    grading: R,
    coefficient: R,
    work_of_adhesion: R,
}

impl<R: Real> GradedHalfSpace<R> {
    /// From k, c (N/m^(2+k)) and w (J/m²).
    ///
    /// # Errors
    /// [`Error::Domain`] unless −1 < k < 1, and c and w are positive and finite.
    pub fn new(grading: R, coefficient: R, work_of_adhesion: R) -> Result<Self> {
        require_grading(&grading)?;
        Ok(GradedHalfSpace {
            grading,
            coefficient: Error::require_positive(COEFFICIENT, coefficient)?,
            work_of_adhesion: Error::require_positive(Quantity::WorkOfAdhesion, work_of_adhesion)?,
        })
    }

    /// The foundation of Winkler: independent springs of the given modulus (Pa/m), with w in J/m². It is k = 1 and c = π
    /// times the modulus; the transformed profile is the profile itself.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the modulus and w are positive and finite.
    pub fn winkler(modulus: R, work_of_adhesion: R) -> Result<Self> {
        let modulus = Error::require_positive(MODULUS, modulus)?;
        Ok(GradedHalfSpace {
            grading: modulus.lit(1),
            coefficient: modulus.pi() * modulus,
            work_of_adhesion: Error::require_positive(Quantity::WorkOfAdhesion, work_of_adhesion)?,
        })
    }

    /// k.
    pub fn grading(&self) -> &R {
        &self.grading
    }

    /// c, in N/m^(2+k).
    pub fn coefficient(&self) -> &R {
        &self.coefficient
    }

    /// w, in J/m².
    pub fn work_of_adhesion(&self) -> &R {
        &self.work_of_adhesion
    }

    /// S = 2c a^{1+k}/(1+k), the stiffness of a flat punch, in N/m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn punch_stiffness(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let whole = self.whole();
        representable(Quantity::Stiffness, self.stiffness(&a), || {
            (self.coefficient.clone().times(2) / &whole).ln() + a.ln() * &whole
        })
    }

    /// Δl(a) = √(2πw a^{1−k}/c), the elongation at which the springs at the edge detach, in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn detachment_elongation(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        representable(Quantity::Indentation, self.elongation(&a), || {
            (self.ln_edge() + a.ln() * self.rest()).over(2) + a.lit(2).ln()
        })
    }

    /// S(a), unchecked.
    pub(super) fn stiffness(&self, a: &R) -> R {
        let whole = self.whole();
        a.pow(&whole) * &self.coefficient / whole * a.lit(2)
    }

    /// Δl(a), unchecked.
    pub(super) fn elongation(&self, a: &R) -> R {
        (self.edge_root() * a.pow(&self.rest().over(2))).times(2)
    }

    /// √B, B = πw/(2c).
    pub(super) fn edge_root(&self) -> R {
        let edge = self.work_of_adhesion.pi() * &self.work_of_adhesion / self.coefficient.clone().times(2);
        if ordinary(&edge) {
            return edge.sqrt();
        }
        self.work_of_adhesion.sqrt() / self.coefficient.sqrt() * self.coefficient.pi().over(2).sqrt()
    }

    /// ln B.
    pub(super) fn ln_edge(&self) -> R {
        self.coefficient.pi().over(2).ln() + self.work_of_adhesion.ln() - self.coefficient.ln()
    }

    /// 1 + k.
    pub(super) fn whole(&self) -> R {
        self.grading.lit(1) + &self.grading
    }

    /// 1 − k.
    pub(super) fn rest(&self) -> R {
        self.grading.lit(1) - &self.grading
    }

    /// Whether the medium is a homogeneous half-space, and then its material.
    fn homogeneous(&self) -> Option<Result<Material<R>>> {
        (self.grading == self.grading.lit(0))
            .then(|| Material::new(self.coefficient.clone(), self.work_of_adhesion.clone()))
    }
}

/// A power law f = C rⁿ in adhesive contact with a [graded half-space](GradedHalfSpace) or a Winkler foundation.
///
/// With B = πw/(2c) and N = nκ(n, k)C the folds follow from N a^{n−(1−k)/2} = λ√B, with λ = 1 − k under fixed grips and 3 + k
/// under a dead load. At k = 0 every number is that of [`PowerLawContact`], in every bit.
///
/// ```
/// use mdr_analytic::media::{GradedContact, GradedHalfSpace};
/// use mdr_core::contact::Control;
/// // The sphere: −(3 + k)/2 · πwR under a dead load.
/// let medium = GradedHalfSpace::new(0.3, 1.0, 0.01)?;
/// let sphere = GradedContact::new(2.0, 0.5, medium)?;
/// let force = sphere.critical(&Control::Force)?.force;
/// assert!((force / (-1.65 * std::f64::consts::PI * 0.01) - 1.0).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct GradedContact<R> {
    pub(super) profile: PowerLaw<R>,
    pub(super) medium: GradedHalfSpace<R>,
    /// The contact at k = 0.
    pub(super) homogeneous: Option<PowerLawContact<R>>,
}

impl<R: Kappa + Gamma> GradedContact<R> {
    /// From n, C (m^(1−n)) and the medium.
    ///
    /// # Errors
    /// [`Error::Domain`] unless n and C are positive and finite.
    pub fn new(exponent: R, coefficient: R, medium: GradedHalfSpace<R>) -> Result<Self> {
        let kappa = graded_kappa(&exponent, medium.grading())?;
        Self::with_kappa(exponent, coefficient, kappa, medium)
    }
}

impl<R: Real> GradedContact<R> {
    /// From n, C (m^(1−n)), a κ(n, k) computed elsewhere, and the medium.
    ///
    /// # Errors
    /// [`Error::Domain`] unless n, C and κ are positive and finite.
    pub fn with_kappa(exponent: R, coefficient: R, kappa: R, medium: GradedHalfSpace<R>) -> Result<Self> {
        let profile = PowerLaw::with_kappa(exponent, coefficient, kappa)?;
        let homogeneous = medium.homogeneous().transpose()?;
        let homogeneous = homogeneous.map(|material| PowerLawContact::new(profile.clone(), material));
        Ok(GradedContact { profile, medium, homogeneous })
    }

    /// n, C and κ(n, k), as the power law whose transform is g = κ(n, k) C xⁿ.
    pub fn profile(&self) -> &PowerLaw<R> {
        &self.profile
    }

    /// The medium.
    pub fn medium(&self) -> &GradedHalfSpace<R> {
        &self.medium
    }

    /// (1 − k)/2: above this exponent the contact breaks, below it spreads over the whole surface.
    pub fn threshold_exponent(&self) -> R {
        self.medium.rest().over(2)
    }

    /// The kind of instability, from the order of n and (1 − k)/2.
    ///
    /// # Errors
    /// [`Error::Undecided`] when that is uncertain over intervals.
    pub fn regime(&self) -> Result<Regime> {
        use std::cmp::Ordering::*;
        let excess = self.excess();
        match excess.partial_cmp(&excess.lit(0)) {
            Some(Greater) => Ok(Regime::PullOff),
            Some(Equal) => Ok(Regime::ScaleFree),
            Some(Less) => Ok(Regime::CompleteContact),
            None => {
                Err(Error::undecided(Quantity::Exponent, self.exponent(), "whether it is above or below (1 - k)/2"))
            }
        }
    }

    /// d(a) = κ(n, k) C aⁿ − Δl(a), in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn indentation(&self, a: &R) -> Result<R> {
        if let Some(contact) = &self.homogeneous {
            return contact.indentation(a);
        }
        let elongation = self.medium.detachment_elongation(a)?;
        Ok(self.profile.g(a)? - elongation)
    }

    /// F(a) = S(a) (n g(a)/(n+1+k) − Δl(a)), in N.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn force(&self, a: &R) -> Result<R> {
        if let Some(contact) = &self.homogeneous {
            return contact.force(a);
        }
        let pressed = self.profile.g(a)? * self.exponent() / self.sum();
        let depth = pressed - self.medium.detachment_elongation(a)?;
        if depth == a.lit(0) {
            return Ok(depth);
        }
        let stiffness = self.medium.punch_stiffness(a)?;
        representable(Quantity::Force, product([&stiffness, &depth]), || stiffness.ln() + depth.abs().ln())
    }

    /// d'(a) = N aⁿ⁻¹ − (1−k)√B a^{−(1+k)/2} along the equilibria.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn indentation_slope(&self, a: &R) -> Result<R> {
        if let Some(contact) = &self.homogeneous {
            return contact.indentation_slope(a);
        }
        let elongation = self.medium.detachment_elongation(a)?;
        Ok(self.profile.slope(a)? - elongation * self.medium.rest() / a.clone().times(2))
    }

    /// F'(a) = S d' − S'Δl along the equilibria, in N/m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn force_slope(&self, a: &R) -> Result<R> {
        if let Some(contact) = &self.homogeneous {
            return contact.force_slope(a);
        }
        let elongation = self.medium.detachment_elongation(a)?;
        let lost = elongation * (self.medium.whole().times(2) + self.medium.rest()) / a.clone().times(2);
        let slope = self.profile.slope(a)? - lost;
        if slope == a.lit(0) {
            return Ok(slope);
        }
        let stiffness = self.medium.punch_stiffness(a)?;
        let quantity = Quantity::Parameter("the slope F' of the normal force");
        representable(quantity, product([&stiffness, &slope]), || stiffness.ln() + slope.abs().ln())
    }

    /// Π(a, d) = c∫₀ᵃ xᵏ(d − g)² dx − πa²w of any state, in equilibrium or not, in J.
    ///
    /// The integral is a^{1+k}[(d − m)²/(1+k) + n²g²/((2n+1+k)(n+1+k)²)] with m = (1+k)g/(n+1+k), the mean of g with the weight xᵏ.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and d finite; [`Error::OutOfRange`].
    pub fn energy(&self, a: &R, d: &R) -> Result<R> {
        if let Some(contact) = &self.homogeneous {
            return contact.energy(a, d);
        }
        Error::require_finite(Quantity::Indentation, d)?;
        let stiffness = self.medium.punch_stiffness(a)?.over(2);
        let (n, share) = (self.exponent(), self.profile.g(a)? / self.sum());
        let below = d.clone() - share.clone() * self.medium.whole();
        let spread = self.medium.whole() / (n.clone() + self.sum());
        let about = share * n;
        let square = below.square() + about.square() * &spread;
        // A square may leave the range where its product with the stiffness does not.
        let elastic = if ordinary(&square) {
            square * &stiffness
        } else {
            product([&stiffness, &below, &below]) + product([&stiffness, &about, &about, &spread])
        };
        let work = self.medium.work_of_adhesion();
        let adhesion = product([a, a, &a.pi(), work]);
        difference(Quantity::Energy, elastic, adhesion, || {
            let larger = below.abs().greater(&about.abs());
            let shares = (below / &larger).square() + (about / &larger).square() * &spread;
            [larger.ln().times(2) + shares.ln() + stiffness.ln(), a.ln().times(2) + a.pi().ln() + work.ln()]
        })
    }

    pub(super) fn exponent(&self) -> &R {
        self.profile.exponent()
    }

    /// n + 1 + k.
    pub(super) fn sum(&self) -> R {
        self.medium.whole() + self.exponent()
    }

    /// 2n − 1 + k, which decides the regime.
    pub(super) fn excess(&self) -> R {
        self.exponent().clone().times(2) - self.medium.rest()
    }
}
