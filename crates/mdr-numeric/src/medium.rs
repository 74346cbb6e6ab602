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
//!   2a g'/Δl = 2p + 2q/(1 + K/S): at fixed grips (K → ∞), under a dead load (K → 0), and on a machine of stiffness K.
//!
//! | medium | size | S | A' | Δl | q | p |
//! |---|---|---|---|---|---|---|
//! | half-space | radius a | 2E*a | 2πa | √(2πaw/E*) | 1 | 1/2 |
//! | graded, E ∝ zᵏ | radius a | 2c a^(1+k)/(1+k) | 2πa | √(2πw a^(1−k)/c) | 1 + k | (1 − k)/2 |
//! | Winkler | radius a | πK_w a² | 2πa | √(2w/K_w) | 2 | 0 |
//! | half-plane, per length | half-width b | E*, or πE*/(2 arcosh(L/b)) | 2 | (E*/S)√(2πwb/E*) | see below | 1/2 − q |
//! | half-plane, one strip a period | b = (λ/π) tan(πa/λ) | πE*/(λΛ) | 2/(λ(1 + t²)) | Λ√(2wb/(πE*)) | 2/(Λ(1 + t²)) | 1/2 − q |
//!
//! with t = πb/λ and Λ = ln(1 + 1/t²). The size of the strips is not their half-width a < λ/2 but b, which is a where that is
//! small and grows without bound towards complete contact: [`Medium::contact_radius`] has a.
//!
//! A half-plane has no indentation depth unless it is measured against a point of its surface at a distance L. Without one d
//! stands for F/E*, with S = E* and q = 0: (1.13) with F/E* for d. With one, q = 1/(arcosh(L/b)√(1 − b²/L²)).
//!
//! These functions stand here and nowhere else in this crate.

mod condition;
mod size;

use mdr_core::contact::{Edge, Error, Material, Quantity, Result};
use mdr_core::number::{Dual, Real};

use size::root_of_length;
pub(crate) use size::{arcosh_ratio, openness, phase};

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
    /// A half-space whose modulus is a power of the depth, E ∝ zᵏ.
    #[non_exhaustive]
    Graded {
        /// c, in N/m^(2+k).
        coefficient: R,
        /// k, within (−1, 1).
        exponent: R,
    },
    /// A foundation of independent springs.
    #[non_exhaustive]
    Winkler {
        /// K_w, in Pa/m.
        modulus: R,
    },
    /// A half-plane in line contact; forces are per length, in N/m.
    #[non_exhaustive]
    Plane {
        /// The effective modulus E*, in Pa.
        modulus: R,
        /// The distance L of the point of the surface from which the depth is measured, in m.
        reference: Option<R>,
    },
    /// A half-plane in contact along one strip a period; forces are per area, in Pa.
    #[non_exhaustive]
    Periodic {
        /// The effective modulus E*, in Pa.
        modulus: R,
        /// The period λ, in m.
        wavelength: R,
    },
}

/// The binary order of magnitude of the longest length from which a search begins, and of the shortest inverse.
const LONGEST: i64 = 500;

/// The period of a medium or a profile, for errors.
pub(crate) const WAVELENGTH: Quantity = Quantity::Parameter("the wavelength");

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

    /// A half-space graded with the depth as E ∝ zᵏ: `coefficient` c, in N/m^(2+k), and `exponent` k (V. L. Popov, M. Heß and
    /// E. Willert, Handbook of Contact Mechanics, Springer 2019, chapter 9). The stiffness of a contact is 2c a^(1+k)/(1+k).
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// // k → 0 is the half-space, c = E*.
    /// assert_eq!(Medium::graded(1e6, 0.0)?.stiffness(&1e-3), 2000.0);
    /// assert!(Medium::graded(1e6, 1.0).is_err());
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless c is positive and finite, and k within (−1, 1).
    pub fn graded(coefficient: R, exponent: R) -> Result<Self> {
        if !(exponent > exponent.lit(-1) && exponent < exponent.lit(1)) {
            return Err(Error::domain(Quantity::Parameter("the exponent k"), &exponent, "within (-1, 1)"));
        }
        let coefficient = Error::require_positive(Quantity::Parameter("the coefficient c"), coefficient)?;
        Ok(Medium::Graded { coefficient, exponent })
    }

    /// A Winkler foundation: springs that do not act on one another, of `modulus` K_w in Pa/m.
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// let mattress = Medium::winkler(1e9)?;
    /// assert!((mattress.stiffness(&1e-3) / (std::f64::consts::PI * 1e3) - 1.0).abs() < 1e-15);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless K_w is positive and finite.
    pub fn winkler(modulus: R) -> Result<Self> {
        let quantity = Quantity::Parameter("the modulus of the foundation");
        Ok(Medium::Winkler { modulus: Error::require_positive(quantity, modulus)? })
    }

    /// A half-plane of the effective modulus E*, in Pa, in line contact; forces are per length, in N/m. Depths are measured
    /// against the point of the surface at a distance `reference` L, in m, if it is given.
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// // A depth grows with the logarithm of the distance from which it is measured.
    /// let [near, far] = [1e-2, 1e-1].map(|distance| Medium::plane(1e6, Some(distance)));
    /// assert!(far?.stiffness(&1e-3) < near?.stiffness(&1e-3));
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless E* and L are positive and finite.
    pub fn plane(modulus: R, reference: Option<R>) -> Result<Self> {
        let modulus = Error::require_positive(Quantity::EffectiveModulus, modulus)?;
        let distance = |reference| Error::require_positive(Quantity::Parameter("the reference distance"), reference);
        Ok(Medium::Plane { modulus, reference: reference.map(distance).transpose()? })
    }

    /// A half-plane of the effective modulus E*, in Pa, in contact along one strip in each period λ, in m; forces are per area,
    /// in Pa (K. L. Johnson, Int. J. Solids Struct. 32 (1995) 423).
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// let waves = Medium::periodic(1e6, 1e-3)?;
    /// // Half of the surface is in contact at a = λ/4.
    /// let size = waves.size(&0.25e-3);
    /// assert!((waves.contact_radius(&size) / 0.25e-3 - 1.0).abs() < 1e-15);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless E* and λ are positive and finite.
    pub fn periodic(modulus: R, wavelength: R) -> Result<Self> {
        let modulus = Error::require_positive(Quantity::EffectiveModulus, modulus)?;
        Ok(Medium::Periodic { modulus, wavelength: Error::require_positive(WAVELENGTH, wavelength)? })
    }

    /// The modulus that is the scale of all forces: E* in Pa, c of a graded half-space in N/m^(2+k), K_w in Pa/m.
    pub fn modulus(&self) -> &R {
        match self {
            Medium::HalfSpace { modulus }
            | Medium::Graded { coefficient: modulus, .. }
            | Medium::Winkler { modulus }
            | Medium::Plane { modulus, .. }
            | Medium::Periodic { modulus, .. } => modulus,
        }
    }

    /// Whether a contact may become complete, as between waves.
    pub(crate) fn becomes_complete(&self) -> bool {
        matches!(self, Medium::Periodic { .. })
    }

    /// Whether it is a homogeneous half-space.
    pub fn is_half_space(&self) -> bool {
        matches!(self, Medium::HalfSpace { .. })
    }

    /// Whether the depth of a contact is defined: that of a line contact is only against a reference.
    pub fn has_depth(&self) -> bool {
        !matches!(self, Medium::Plane { reference: None, .. })
    }

    /// k of a half-space graded as E ∝ zᵏ, which is 0 without a grading; `None` for another medium.
    pub fn exponent(&self, like: &R) -> Option<R> {
        match self {
            Medium::HalfSpace { .. } => Some(like.lit(0)),
            Medium::Graded { exponent, .. } => Some(exponent.clone()),
            _ => None,
        }
    }

    /// q of a contact that is a disc, whose stiffness S is as a^q: 1 on a half-space, 1 + k on a graded one, 2 on a Winkler foundation; `None`
    /// in line contact.
    pub fn order_of_discs(&self) -> Option<R> {
        match self {
            Medium::HalfSpace { modulus } => Some(modulus.lit(1)),
            Medium::Graded { exponent, .. } => Some(exponent.lit(1) + exponent),
            Medium::Winkler { modulus } => Some(modulus.lit(2)),
            _ => None,
        }
    }

    /// The period of a medium in contact along strips, in m.
    pub fn period(&self) -> Option<&R> {
        match self {
            Medium::Periodic { wavelength, .. } => Some(wavelength),
            _ => None,
        }
    }

    /// Whether a contact has an elastic energy of its own: that of a line contact grows with the size of the body.
    pub fn has_energy(&self) -> bool {
        !matches!(self, Medium::Plane { .. })
    }

    /// The medium with a modulus of one, in doubles: forces and works of adhesion are then divided by the modulus, and lengths
    /// are unchanged, also if a modulus is out of the range of doubles.
    pub(crate) fn of_unit_modulus(&self) -> Medium<f64> {
        match self {
            Medium::HalfSpace { .. } => Medium::HalfSpace { modulus: 1.0 },
            Medium::Graded { exponent, .. } => Medium::Graded { coefficient: 1.0, exponent: exponent.approx() },
            Medium::Winkler { .. } => Medium::Winkler { modulus: 1.0 },
            Medium::Plane { reference, .. } => {
                Medium::Plane { modulus: 1.0, reference: reference.as_ref().map(Real::approx) }
            }
            Medium::Periodic { wavelength, .. } => Medium::Periodic { modulus: 1.0, wavelength: wavelength.approx() },
        }
    }

    /// The size at which the medium ends: the reference distance of a line contact.
    pub fn outer_size(&self) -> Option<&R> {
        match self {
            Medium::Plane { reference, .. } => reference.as_ref(),
            _ => None,
        }
    }

    /// S = dF/dd, the stiffness of a contact whose size is fixed: in N/m, per length in Pa, per area in Pa/m.
    #[inline]
    pub fn stiffness(&self, a: &R) -> R {
        match self {
            Medium::HalfSpace { modulus } => (a.clone() * modulus).times(2),
            _ => self.reduced_stiffness(a) * self.modulus(),
        }
    }

    /// S over the modulus.
    pub(crate) fn reduced_stiffness(&self, a: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => a.clone().times(2),
            Medium::Graded { exponent, .. } => {
                let power = exponent.lit(1) + exponent;
                a.pow(&power).times(2) / power
            }
            Medium::Winkler { .. } => a.square() * a.pi(),
            Medium::Plane { .. } => self.depth_per_force(a).inv(),
            Medium::Periodic { wavelength, .. } => a.pi() / wavelength / openness(a, wavelength),
        }
    }

    /// The factors whose product is S(a): a product that is out of range keeps a logarithm.
    pub(crate) fn stiffness_factors(&self, a: &R) -> [R; 3] {
        match self {
            Medium::HalfSpace { modulus } => [a.lit(2), a.clone(), modulus.clone()],
            _ => [a.lit(1), self.reduced_stiffness(a), self.modulus().clone()],
        }
    }

    /// Half of the stiffness S'(x) of the springs at x: half a spring's stiffness times its squared elongation is its energy. For
    /// a line contact S²/(πE*x), with which the springs at the edge have the energy release rate 2w of its two edges.
    pub fn half_stiffness_slope(&self, x: &R) -> R {
        match self {
            Medium::HalfSpace { modulus } => modulus.clone(),
            _ => self.spring_share(x) * self.modulus(),
        }
    }

    /// Half of S'(x) over the modulus.
    fn spring_share(&self, x: &R) -> R {
        match self {
            Medium::HalfSpace { .. } => x.lit(1),
            Medium::Graded { exponent, .. } => x.pow(exponent),
            Medium::Winkler { .. } => x.pi() * x,
            Medium::Plane { .. } => self.reduced_stiffness(x).square() / (x.pi() * x),
            Medium::Periodic { wavelength, .. } => {
                let ratio = self.reduced_stiffness(x);
                ratio.square() * wavelength / (x.pi() * x) / (phase(x, wavelength).square() + x.lit(1))
            }
        }
    }

    /// An integrand over springs, which is weighted with half of S' over the modulus; on a half-space, where that is 1, it is
    /// unchanged.
    pub(crate) fn weighted(&self, x: &R, value: R) -> R {
        match self {
            Medium::HalfSpace { .. } => value,
            _ => self.spring_share(x) * value,
        }
    }

    /// An integrand over springs at x within a contact of size a, weighted with S'(x)/S'(a).
    pub(crate) fn weighted_relative(&self, x: &R, a: &R, value: R) -> R {
        match self {
            Medium::HalfSpace { .. } => value,
            Medium::Graded { exponent, .. } => (x.clone() / a).pow(exponent) * value,
            Medium::Winkler { .. } => x.clone() / a * value,
            _ => self.spring_share(x) / self.spring_share(a) * value,
        }
    }

    /// The slope of an integrand over springs at a moving x, weighted with S'(x)/S'(a) at a fixed a; S' is a power of x.
    pub(crate) fn weighted_change(&self, x: &Dual<R>, a: &R, value: Dual<R>) -> R {
        if let Medium::HalfSpace { .. } = self {
            return value.slope;
        }
        let order = self.stiffness_order(a) - a.lit(1);
        let growth = if x.slope == x.value { order } else { order * &x.slope / &x.value };
        self.weighted_relative(&x.value, a, value.value * growth + value.slope)
    }

    /// The factors whose product is the area of a disc of radius a, in m²: a product that is out of range keeps a logarithm.
    pub(crate) fn disc_factors(&self, a: &R) -> [R; 3] {
        [a.pi(), a.clone(), a.clone()]
    }

    /// The factors whose product is half of A'(a).
    pub(crate) fn half_area_slope_factors(&self, a: &R) -> [R; 2] {
        match self {
            Medium::Plane { .. } => [a.lit(1), a.lit(1)],
            Medium::Periodic { wavelength, .. } => {
                [wavelength.clone().inv(), (phase(a, wavelength).square() + a.lit(1)).inv()]
            }
            _ => [a.pi(), a.clone()],
        }
    }

    /// The length of the material at the work of adhesion w, in m, from which searches begin: w/E* on a half-space.
    pub fn length(&self, work: &R) -> R {
        match self {
            Medium::HalfSpace { modulus } | Medium::Plane { modulus, .. } => work.clone() / modulus,
            Medium::Graded { exponent, .. } => {
                let length = self.reduced_work(work).pow(&(exponent.lit(1) + exponent).inv());
                // With k → −1 the power may leave any range, and a search may begin anywhere.
                let [least, most] = [-LONGEST, LONGEST].map(|bits| length.lit(2).powi(bits));
                if length.is_finite() { length.greater(&least).lesser(&most) } else { most }
            }
            Medium::Winkler { .. } => self.reduced_work(work).sqrt(),
            Medium::Periodic { wavelength, .. } => wavelength.clone(),
        }
    }

    /// The work of adhesion over the modulus at which a contact is about as large as this length, in units of the medium: the
    /// inverse of [`Medium::length`] for a modulus of one.
    ///
    /// ```
    /// use mdr_numeric::medium::Medium;
    /// let springs = Medium::winkler(1.0)?;
    /// assert_eq!(springs.length(&springs.work_of_length(&1e-3)), 1e-3);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    pub fn work_of_length(&self, length: &R) -> R {
        match self {
            Medium::HalfSpace { .. } | Medium::Plane { .. } | Medium::Periodic { .. } => length.clone(),
            Medium::Graded { exponent, .. } => length.pow(&(exponent.lit(1) + exponent)),
            Medium::Winkler { .. } => length.square(),
        }
    }

    /// The work of adhesion over the modulus.
    pub fn reduced_work(&self, work: &R) -> R {
        work.clone() / self.modulus()
    }

    /// Δl(a) at the work of adhesion w (1.4), in m, for a > 0; the table of the [module](self) has it for each medium.
    ///
    /// On a half-space it is √(2πaw/E*), written as a√(2πℓ/a) with ℓ = w/E*, which stays in range if the product aw does not.
    pub fn elongation(&self, work: &R, a: &R) -> R {
        a.clone() * self.relative_elongation(work, a)
    }

    /// Δl(a)/a.
    fn relative_elongation(&self, work: &R, a: &R) -> R {
        let ratio = self.reduced_work(work);
        match self {
            Medium::HalfSpace { .. } => root_of_length(ratio, a),
            Medium::Graded { exponent, .. } => {
                let power = exponent.lit(1) + exponent;
                let square = (ratio.clone() / a.pow(&power) * a.pi()).times(2);
                let normal = square.is_finite() && square.clone() * a.unit_roundoff() > a.lit(0);
                if normal { square.sqrt() } else { a.pi().times(2).sqrt() * ratio.sqrt() / a.pow(&power.over(2)) }
            }
            Medium::Winkler { .. } => ratio.times(2).sqrt() / a,
            Medium::Plane { .. } => root_of_length(ratio, a) * self.depth_per_force(a),
            Medium::Periodic { wavelength, .. } => root_of_length(ratio, a) / a.pi() * openness(a, wavelength),
        }
    }

    /// E*/S of a line contact: 1 without a reference, else (2/π) arcosh(L/b).
    fn depth_per_force(&self, b: &R) -> R {
        match self {
            Medium::Plane { reference: Some(reference), .. } => (arcosh_ratio(reference, b) / b.pi()).times(2),
            _ => b.lit(1),
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
