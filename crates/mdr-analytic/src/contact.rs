//! A power law in adhesive contact: equilibria (1.4), (1.5), (1.13), (1.16), their slopes and the energy.

use mdr_core::contact::{Error, Material, Quantity, Regime, Result};
use mdr_core::number::Real;

use crate::power_law::PowerLaw;
use crate::range::{difference, ln_difference, ln_sum, ordinary, product, representable, sum};

/// Δl(a) = √(2πaw/E*), the elongation at which the springs at the edge detach (1.4), for a > 0, in m.
///
/// # Errors
/// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
pub fn detachment_elongation<R: Real>(material: &Material<R>, a: &R) -> Result<R> {
    let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
    let elongation = edge_root(material, &edge_length(material)) * a.sqrt();
    representable(Quantity::Indentation, elongation.times(2), || {
        (ln_edge_length(material) + a.ln()).over(2) + a.lit(2).ln()
    })
}

/// B = πw/(2E*), the length in Δl(a) = 2√(Ba), in m. It may be out of range where Δl is not.
#[inline(always)]
pub(crate) fn edge_length<R: Real>(material: &Material<R>) -> R {
    let pi = material.work_of_adhesion().pi();
    pi * material.work_of_adhesion() / material.effective_modulus().clone().times(2)
}

/// √B, also if B is out of range: √w/√E* leaves it at twice the exponent.
#[inline(always)]
pub(crate) fn edge_root<R: Real>(material: &Material<R>, edge_length: &R) -> R {
    if ordinary(edge_length) {
        return edge_length.sqrt();
    }
    let (e, w) = (material.effective_modulus(), material.work_of_adhesion());
    w.sqrt() / e.sqrt() * w.pi().over(2).sqrt()
}

/// ln B.
pub(crate) fn ln_edge_length<R: Real>(material: &Material<R>) -> R {
    let (e, w) = (material.effective_modulus(), material.work_of_adhesion());
    w.pi().over(2).ln() + w.ln() - e.ln()
}

const INDENTATION_SLOPE: Quantity = Quantity::Parameter("the slope d' of the indentation depth");
const FORCE_SLOPE: Quantity = Quantity::Parameter("the slope F' of the normal force");

/// A power-law profile pressed against an elastic half-space, with adhesion.
///
/// An equilibrium is determined by its contact radius a. With B = πw/(2E*) and N = nκ_nC the elongation at the edge is
/// Δl = 2√(Ba), and critical states follow from N a^{n−1/2} = λ√B with λ = 1 under fixed grips and λ = 3 under a dead
/// load.
///
/// ```
/// use mdr_analytic::{PowerLawContact, PowerLaw};
/// use mdr_core::contact::{Control, Material};
/// let ball = PowerLawContact::new(PowerLaw::new(2.0, 0.5)?, Material::new(1.0, 1.0)?);
/// // Johnson, Kendall and Roberts: F = −(3/2)πwR under a dead load.
/// let critical = ball.critical(&Control::Force)?;
/// assert!((critical.force / (-1.5 * std::f64::consts::PI) - 1.0).abs() < 1e-14);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PowerLawContact<R> {
    profile: PowerLaw<R>,
    material: Material<R>,
    /// B = πw/(2E*), in m. It may be out of range where its root is not.
    pub(crate) edge_length: R,
    /// √B, in √m.
    pub(crate) edge_root: R,
}

impl<R: Real> PowerLawContact<R> {
    /// The given profile on the given material.
    #[inline(always)]
    pub fn new(profile: PowerLaw<R>, material: Material<R>) -> Self {
        let edge_length = edge_length(&material);
        let edge_root = edge_root(&material, &edge_length);
        PowerLawContact { profile, material, edge_length, edge_root }
    }

    /// The profile.
    pub fn profile(&self) -> &PowerLaw<R> {
        &self.profile
    }

    /// The material.
    pub fn material(&self) -> &Material<R> {
        &self.material
    }

    /// The kind of instability, from the order of n and 1/2.
    ///
    /// # Errors
    /// [`Error::Undecided`] when n is an interval around 1/2.
    #[inline(always)]
    pub fn regime(&self) -> Result<Regime> {
        self.profile.regime()
    }

    /// Δl(a) = √(2πaw/E*) (1.4), in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn detachment_elongation(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        representable(Quantity::Indentation, self.elongation(&a), || self.ln_elongation(&a))
    }

    /// d(a) = κ_n C aⁿ − Δl(a) (1.5), (1.13), in m. The relative accuracy decreases near its zero, where the terms
    /// cancel.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn indentation(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let (n, one) = (self.profile.exponent(), a.lit(1));
        let g = self.profile.monomial(&a, n, &one, &one);
        difference(Quantity::Indentation, g, self.elongation(&a), || {
            [self.profile.ln_monomial(&a, n, &one), self.ln_elongation(&a)]
        })
    }

    /// F(a) = 2E* a (n/(n+1) κ_n C aⁿ − Δl(a)) (1.6), (1.16), in N.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn force(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let n = self.profile.exponent();
        let share = n.clone() / (n.lit(1) + n);
        let (pressed, elongation) = (self.profile.monomial(&a, n, &share, &a.lit(1)), self.elongation(&a));
        let modulus = self.material.effective_modulus().clone();
        if ordinary(&pressed) && ordinary(&elongation) {
            return self.force_of_depth(&a, pressed - &elongation);
        }
        // Each term separately: one that is out of range may return to it with the stiffness, or be negligible.
        let two = a.lit(2);
        let root = a.sqrt();
        let adhesive = product([&modulus, &a, &self.edge_root, &root, &a.lit(4)]);
        let next = n.clone() + a.lit(1);
        let pressed = self.profile.monomial(&a, &next, &share.times(2), &modulus);
        let share = n.clone() / &next;
        difference(Quantity::Force, pressed, adhesive, || {
            let ln_stiffness = modulus.ln() + a.ln() + two.ln();
            [self.profile.ln_monomial(&a, n, &share) + &ln_stiffness, self.ln_elongation(&a) + ln_stiffness]
        })
    }

    /// 2E*a·depth; only an exact zero gives 0.
    #[inline(always)]
    fn force_of_depth(&self, a: &R, depth: R) -> Result<R> {
        let modulus = self.material.effective_modulus();
        if depth == a.lit(0) {
            return Ok(depth);
        }
        representable(Quantity::Force, product([modulus, a, &depth]).times(2), || {
            (modulus.ln() + a.ln() + depth.abs().ln()) + a.lit(2).ln()
        })
    }

    /// F = 2E*a(nd − Δl)/(n+1) of the equilibrium with a and d.
    #[inline(always)]
    pub(crate) fn force_at_indentation(&self, a: &R, d: &R) -> Result<R> {
        let n = self.profile.exponent();
        let next = n.lit(1) + n;
        let (pressed, elongation) = (d.clone() * n, self.elongation(a));
        if ordinary(&pressed) && ordinary(&elongation) {
            return self.force_of_depth(a, (pressed - elongation) / next);
        }
        let modulus = self.material.effective_modulus().clone().times(2) / next;
        let pressed = product([&modulus, a, d, n]);
        let adhesive = product([&modulus, a, &self.edge_root, &a.sqrt(), &a.lit(2)]);
        sum(Quantity::Force, pressed, -adhesive, || {
            let ln_total = if *d > a.lit(0) { ln_difference } else { ln_sum };
            ln_total(&(d.abs().ln() + n.ln()), &self.ln_elongation(a)) + modulus.ln() + a.ln()
        })
    }

    /// d = ((n+1)F/(2E*a) + Δl)/n of the equilibrium with a and F.
    #[inline(always)]
    pub(crate) fn indentation_at_force(&self, a: &R, force: &R) -> Result<R> {
        let n = self.profile.exponent();
        let next = n.lit(1) + n;
        let modulus = self.material.effective_modulus().clone().times(2);
        let stiffness = modulus.clone() * a;
        let (pressed, elongation) = (force.clone() * &next / &stiffness, self.elongation(a));
        if ordinary(&stiffness) && ordinary(&pressed) && ordinary(&elongation) {
            return Ok((pressed + elongation) / n);
        }
        let (share, root) = (n.clone().inv(), a.sqrt());
        // The root of the stiffness stays in range, and so does its reciprocal.
        let softness = (modulus.sqrt() * &root).inv();
        let pressed = product([&softness, &softness, force, &next, &share]);
        let elongation = product([&self.edge_root, &root, &share, &a.lit(2)]);
        sum(Quantity::Indentation, pressed, elongation, || {
            let ln_total = if *force < a.lit(0) { ln_difference } else { ln_sum };
            let ln_pressed = force.abs().ln() + next.ln() - modulus.ln() - a.ln();
            ln_total(&ln_pressed, &self.ln_elongation(a)) - n.ln()
        })
    }

    /// d'(a) = N aⁿ⁻¹ − √(B/a) along the equilibria; its zero is the condition (1.10), (1.14).
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn indentation_slope(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let (n, one) = (self.profile.exponent(), a.lit(1));
        let power = n.clone() - &one;
        let slope = self.profile.monomial(&a, &power, n, &one);
        difference(INDENTATION_SLOPE, slope, self.edge_root.clone() / a.sqrt(), || {
            [self.profile.ln_monomial(&a, &power, n), (ln_edge_length(&self.material) - a.ln()).over(2)]
        })
    }

    /// F'(a) = 2E*(a d'(a) − Δl(a)) = 2E* a (N aⁿ⁻¹ − 3√(B/a)) along the equilibria, in N/m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite; [`Error::OutOfRange`].
    pub fn force_slope(&self, a: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        let n = self.profile.exponent();
        let modulus = self.material.effective_modulus().clone().times(2);
        let pressed = self.profile.monomial(&a, n, n, &modulus);
        let adhesive = product([&modulus, &self.edge_root, &a.sqrt()]).times(3);
        difference(FORCE_SLOPE, pressed, adhesive, || {
            let ln_adhesive = (ln_edge_length(&self.material) + a.ln()).over(2) + a.lit(3).ln();
            [self.profile.ln_monomial(&a, n, n), ln_adhesive].map(|ln| ln + modulus.ln())
        })
    }

    /// The potential energy Π(a, d) = E*∫₀ᵃ(d−g)² dx − πa²w of any state, in equilibrium or not, in J.
    ///
    /// The integral is a[(d − g/(n+1))² + n²g²/((2n+1)(n+1)²)] with g = g(a): a sum of squares.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and d finite; [`Error::OutOfRange`].
    pub fn energy(&self, a: &R, d: &R) -> Result<R> {
        let a = Error::require_positive(Quantity::ContactRadius, a.clone())?;
        if !d.is_finite() {
            return Err(Error::domain(Quantity::Indentation, d, "finite"));
        }
        let (n, one) = (self.profile.exponent(), a.lit(1));
        let next = n.clone() + &one;
        let mean = self.profile.monomial(&a, n, &next.clone().inv(), &one);
        let below = d.clone() - &mean;
        let spread = mean.clone() * n / (n.clone().times(2) + &one).sqrt();
        // The roots of the three terms leave the range only if the terms do.
        let (e, w) = (self.material.effective_modulus(), self.material.work_of_adhesion());
        let stiffness = e.sqrt() * a.sqrt();
        let elastic = (stiffness.clone() * &below).square() + (stiffness * &spread).square();
        let adhesion = (w.sqrt() * &a).square() * a.pi();
        difference(Quantity::Energy, elastic, adhesion, || {
            let ln_mean = self.profile.ln_monomial(&a, n, &next.inv());
            let ln_spread = ln_mean.clone() + n.ln() - (n.clone().times(2) + &one).ln().over(2);
            let zero = a.lit(0);
            let ln_below = if below.is_finite() && below != zero { below.abs().ln() } else { ln_mean };
            let ln_square = if below == zero && mean != zero {
                ln_spread.times(2)
            } else {
                let gap = ln_below.lesser(&ln_spread) - ln_below.greater(&ln_spread);
                ln_below.greater(&ln_spread).times(2) + gap.times(2).exp().ln_1p()
            };
            [ln_square + e.ln() + a.ln(), a.pi().ln() + w.ln() + a.ln().times(2)]
        })
    }

    /// Δl(a), unchecked.
    #[inline(always)]
    pub(crate) fn elongation(&self, a: &R) -> R {
        (self.edge_root.clone() * a.sqrt()).times(2)
    }

    fn ln_elongation(&self, a: &R) -> R {
        (ln_edge_length(&self.material) + a.ln()).over(2) + a.lit(2).ln()
    }

    /// N = nκ_nC.
    #[inline(always)]
    pub(crate) fn slope_coefficient(&self) -> R {
        self.profile.strength() * self.profile.exponent()
    }
}
