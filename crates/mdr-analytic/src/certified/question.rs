//! The inputs of a certified answer.

use mdr_core::contact::{Body, Control, Elasticity, Error, Material, Quantity, Result};
use mdr_core::number::{Interval, Literal, Precision};
use rug::Rational;

use super::exact;
use super::monomial::Monomials;
use crate::contact::PowerLawContact;
use crate::power_law::PowerLaw;

/// A power law f = C rⁿ on a material under a control, with exact inputs that have been checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    pub(super) exponent: Rational,
    pub(super) coefficient: Rational,
    pub(super) effective_modulus: Rational,
    pub(super) work_of_adhesion: Rational,
    pub(super) control: Control<Rational>,
    /// The critical state as products of powers, if it has that form.
    pub(super) monomials: Option<Monomials>,
}

impl Question {
    /// From n, C (m^(1−n)), E* (Pa) or two bodies, w (J/m²) and the control with its stiffness (N/m).
    ///
    /// # Errors
    /// [`Error::Domain`], with the quantity and its value as given, unless n, C, the moduli, w and k are positive and
    /// Poisson's ratios within (−1, 1/2].
    pub fn new(
        exponent: &Literal,
        coefficient: &Literal,
        elasticity: &Elasticity,
        work_of_adhesion: &Literal,
        control: &Control<Literal>,
    ) -> Result<Self> {
        let exponent = positive(Quantity::Exponent, exponent)?;
        let coefficient = positive(Quantity::Coefficient, coefficient)?;
        let effective_modulus = match elasticity {
            Elasticity::Effective(modulus) => positive(Quantity::EffectiveModulus, modulus)?,
            Elasticity::Bodies(bodies) => (compliance(&bodies[0])? + compliance(&bodies[1])?).recip(),
        };
        let work_of_adhesion = positive(Quantity::WorkOfAdhesion, work_of_adhesion)?;
        let control = control.try_map(|stiffness| positive(Quantity::Stiffness, stiffness))?;
        let monomials = Monomials::new(&exponent, &coefficient, &effective_modulus, &work_of_adhesion, &control);
        Ok(Question { exponent, coefficient, effective_modulus, work_of_adhesion, control, monomials })
    }

    /// E*, in Pa: as given, or computed exactly from the two bodies by (1.3).
    pub fn effective_modulus(&self) -> &Rational {
        &self.effective_modulus
    }

    /// d at the critical state, if it is rational: for a cone, and at n = 3/2 under a dead load.
    pub fn exact_indentation(&self) -> Option<Rational> {
        exact::indentation(self, &self.control)
    }

    /// Whether the force is exactly stationary along the equilibria at a depth: the fold of a dead load.
    pub fn is_fold_of_force(&self, indentation: &Rational) -> bool {
        exact::indentation(self, &Control::<()>::Force).as_ref() == Some(indentation)
    }

    /// The contact over intervals.
    pub(super) fn contact(&self, precision: Precision) -> Result<PowerLawContact<Interval>> {
        let enclose = |value| Interval::from_rational(precision, value);
        let kappa = exact::kappa_interval(precision, &self.exponent);
        let profile = PowerLaw::with_kappa(enclose(&self.exponent), enclose(&self.coefficient), kappa)?;
        let material = Material::new(enclose(&self.effective_modulus), enclose(&self.work_of_adhesion))?;
        Ok(PowerLawContact::new(profile, material))
    }

    /// The control over intervals.
    pub(super) fn control(&self, precision: Precision) -> Control<Interval> {
        self.control.map(|stiffness| Interval::from_rational(precision, stiffness))
    }
}

fn positive(quantity: Quantity, literal: &Literal) -> Result<Rational> {
    if literal.is_zero() || literal.is_negative() {
        return Err(Error::Domain { quantity, value: literal.to_string(), requirement: "positive and finite" });
    }
    Ok(literal.to_rational())
}

/// (1 − ν²)/E.
fn compliance(body: &Body<Literal>) -> Result<Rational> {
    let modulus = positive(Quantity::YoungsModulus, &body.youngs_modulus)?;
    let nu = body.poissons_ratio.to_rational();
    if nu <= -1 || nu > 0.5 {
        let value = body.poissons_ratio.to_string();
        return Err(Error::Domain { quantity: Quantity::PoissonsRatio, value, requirement: "within (-1, 1/2]" });
    }
    Ok((Rational::from(1) - nu.square()) / modulus)
}
