//! The elastic medium, as a row of independent springs.
//!
//! The method of dimensionality reduction needs three functions of the size a of a contact: the stiffness S(a) of a flat
//! punch of that size, the area A(a), and the depth g(a) without adhesion. Springs of stiffness S'(x)dx under the profile
//! g(x) then carry the contact (V. L. Popov and M. Heß, Method of Dimensionality Reduction in Contact Mechanics and Friction,
//! Springer 2015):
//!
//! * the force is F = ∫₀ᵃ S'(x)(d − g(x)) dx = S(a)(d − mean of g), with S' as the weight of the mean;
//! * the energy is Π = ½∫₀ᵃ S'(x)(d − g(x))² dx − w A(a);
//! * the springs at the edge detach at the elongation Δl(a) = √(2w A'(a)/S'(a)), the rule of Heß (1.4);
//! * with q = d ln S/d ln a and p = d ln Δl/d ln a, the controlled quantity is stationary where
//!   g'/Δl' = 1 + (q/p)/(1 + K/S): at fixed grips (K → ∞), under a dead load (K → 0), and on a machine of stiffness K.
//!
//! | medium | S(a) | A(a) | q | p |
//! |---|---|---|---|---|
//! | half-space | 2E*a | πa² | 1 | 1/2 |
//!
//! These functions stand here and nowhere else in this crate.

use mdr_core::contact::{Control, Edge, Error, Material, Quantity, Result};
use mdr_core::number::Real;

/// An elastic medium, with its properties in one arithmetic.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Medium<R> {
    /// A homogeneous half-space.
    #[non_exhaustive]
    HalfSpace {
        /// The effective modulus E*, in Pa.
        modulus: R,
    },
}

impl<R: Real> Medium<R> {
    /// A homogeneous half-space of the effective modulus E*, in Pa.
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// let rubber = Medium::half_space(1e6)?;
    /// assert_eq!(rubber.stiffness(&1e-3), 2000.0); // 2E*a, in N/m
    /// assert!(Medium::half_space(-1.0).is_err());
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless E* is positive and finite.
    pub fn half_space(modulus: R) -> Result<Self> {
        Ok(Medium::HalfSpace { modulus: Error::require_positive(Quantity::EffectiveModulus, modulus)? })
    }

    /// The modulus E*, in Pa: the scale of all stresses.
    pub fn modulus(&self) -> &R {
        match self {
            Medium::HalfSpace { modulus } => modulus,
        }
    }

    /// The medium with a modulus of one, in doubles: forces and works of adhesion are then divided by the modulus, and lengths
    /// are unchanged, also if a modulus is out of the range of doubles.
    pub(crate) fn of_unit_modulus(&self) -> Medium<f64> {
        match self {
            Medium::HalfSpace { .. } => Medium::HalfSpace { modulus: 1.0 },
        }
    }

    /// S(a) = dF/dd, the stiffness of a contact whose radius a is fixed, in N/m.
    pub fn stiffness(&self, a: &R) -> R {
        match self {
            Medium::HalfSpace { modulus } => (a.clone() * modulus).times(2),
        }
    }

    /// The factors whose product is S(a): a product that is out of range keeps a logarithm.
    pub(crate) fn stiffness_factors(&self, a: &R) -> [R; 3] {
        match self {
            Medium::HalfSpace { modulus } => [a.lit(2), a.clone(), modulus.clone()],
        }
    }

    /// Half of S'(x), the stiffness of the springs at x, in Pa: half a spring's stiffness times its squared elongation is its
    /// energy.
    pub fn half_stiffness_slope(&self, _x: &R) -> R {
        match self {
            Medium::HalfSpace { modulus } => modulus.clone(),
        }
    }

    /// The factors whose product is the area A(a), in m²: a product that is out of range keeps a logarithm.
    pub(crate) fn area_factors(&self, a: &R) -> [R; 3] {
        match self {
            Medium::HalfSpace { .. } => [a.pi(), a.clone(), a.clone()],
        }
    }

    /// The length of the material at the work of adhesion w, in m, from which searches begin: w/E*.
    pub fn length(&self, work: &R) -> R {
        match self {
            Medium::HalfSpace { modulus } => work.clone() / modulus,
        }
    }

    /// Δl(a) = √(2w A'/S') at the work of adhesion w (1.4), in m, for a > 0.
    ///
    /// On a half-space it is √(2πaw/E*), written as a√(2πℓ/a) with ℓ = w/E*, which stays in range if the product aw does not.
    pub fn elongation(&self, work: &R, a: &R) -> R {
        a.clone() * self.relative_elongation(work, a)
    }

    /// Δl(a)/a.
    fn relative_elongation(&self, work: &R, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => {
                let length = self.length(work);
                let square = (length.clone() / a * a.pi()).times(2);
                let normal = square.is_finite() && square.clone() * a.unit_roundoff() > a.lit(0);
                if normal { square.sqrt() } else { a.pi().times(2).sqrt() * length.sqrt() / a.sqrt() }
            }
        }
    }

    /// Δl'(a) = p Δl/a.
    pub(crate) fn elongation_slope(&self, work: &R, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => self.elongation(work, a) / a.clone().times(2),
        }
    }

    /// The tangency ratio g'/Δl' (1.10), for a given g'(a).
    pub(crate) fn tangency(&self, work: &R, slope: R, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => slope.times(2) / self.relative_elongation(work, a),
        }
    }

    /// q/p: the order of S in a over that of Δl.
    fn order_ratio(&self) -> i64 {
        match self {
            Medium::HalfSpace { .. } => 2,
        }
    }

    /// The tangency ratio at which the controlled quantity is stationary, 1 + (q/p)/(1 + K/S).
    pub(crate) fn critical_ratio(&self, a: &R, control: &Control<R>) -> R {
        match control {
            Control::Indentation => a.lit(1),
            Control::Force => a.lit(1 + self.order_ratio()),
            Control::Machine { stiffness } => {
                // In this form it stays in range at both ends.
                let share = (stiffness.clone() / self.stiffness(a) + a.lit(1)).inv();
                share.times(self.order_ratio()) + a.lit(1)
            }
        }
    }
}

/// The work of adhesion at the edge of a contact, in J/m²: w₁ gained by an edge that advances, w₂ needed by one that recedes.
///
/// Surfaces that have touched often hold more firmly than they attract, w₁ < w₂. Between the two the edge is pinned: see
/// [`Path::follow_edges`](crate::path::Path::follow_edges). All other functions of a contact take one work of adhesion, that of
/// its [edge](Adhesion::at); without another word, that of the receding one.
///
/// ```
/// use mdr_core::contact::Edge;
/// use mdr_numeric::medium::Adhesion;
/// let sticky = Adhesion::hysteretic(0.01, 0.04)?;
/// assert_eq!((*sticky.work(), *sticky.at(Edge::Advancing).work()), (0.04, 0.01));
/// assert!(Adhesion::hysteretic(0.04, 0.01).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Adhesion<R> {
    /// w, of the edge that is considered.
    work: R,
    /// w₂.
    receding: R,
    /// w₁.
    advancing: R,
}

impl<R: Real> Adhesion<R> {
    /// An edge that needs the same work w to recede as it gains when it advances, in J/m².
    ///
    /// # Errors
    /// [`Error::Domain`] unless w is positive and finite.
    pub fn new(work: R) -> Result<Self> {
        Ok(Self::reversible(Error::require_positive(Quantity::WorkOfAdhesion, work)?))
    }

    /// An edge that gains w₁ when it advances and needs w₂ to recede, in J/m². At w₁ = 0 contact without adhesion is pressed on,
    /// as Hertz has it.
    ///
    /// # Errors
    /// [`Error::Domain`] unless w₂ is positive and finite, and 0 ≤ w₁ ≤ w₂.
    pub fn hysteretic(advancing: R, receding: R) -> Result<Self> {
        let receding = Error::require_positive(Quantity::WorkOfAdhesion, receding)?;
        if advancing >= receding.lit(0) && advancing <= receding {
            Ok(Adhesion { work: receding.clone(), receding, advancing })
        } else {
            let requirement = "of an advancing edge at least 0 and at most that of a receding edge: an edge that recedes \
                               at less work than it gained would heat the surfaces without end";
            Err(Error::domain(Quantity::WorkOfAdhesion, &advancing, requirement))
        }
    }

    fn reversible(work: R) -> Self {
        Adhesion { work: work.clone(), receding: work.clone(), advancing: work }
    }

    /// w of the edge that is considered, in J/m².
    pub fn work(&self) -> &R {
        &self.work
    }

    /// The adhesion, with one edge considered.
    #[must_use]
    pub fn at(&self, edge: Edge) -> Self {
        Adhesion { work: self.of(edge).clone(), ..self.clone() }
    }

    /// w₁ or w₂, in J/m².
    pub fn of(&self, edge: Edge) -> &R {
        match edge {
            Edge::Advancing => &self.advancing,
            Edge::Receding => &self.receding,
        }
    }

    /// Whether w₁ < w₂, so that an edge can be pinned.
    pub fn is_hysteretic(&self) -> bool {
        self.advancing != self.receding
    }

    /// Whether the edge that is considered has no adhesion, w₁ = 0.
    pub(crate) fn vanishes(&self) -> bool {
        self.work == self.work.lit(0)
    }

    /// A work of adhesion that is not zero, as a scale: w, or w₂ where that is 0.
    pub(crate) fn scale(&self) -> &R {
        if self.vanishes() { &self.receding } else { &self.work }
    }
}

/// A half-space of the effective modulus of the material.
impl<R: Real> From<&Material<R>> for Medium<R> {
    fn from(material: &Material<R>) -> Self {
        Medium::HalfSpace { modulus: material.effective_modulus().clone() }
    }
}

impl<R: Real> From<&Material<R>> for Adhesion<R> {
    fn from(material: &Material<R>) -> Self {
        Adhesion::reversible(material.work_of_adhesion().clone())
    }
}
