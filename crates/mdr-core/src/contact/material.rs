//! The material parameters of the contact: E* and w.

use super::{Error, Quantity, Result};
use crate::number::{Exact, Literal, LiteralError, Real};

/// One elastic body.
#[derive(Clone, Debug, PartialEq)]
pub struct Body<R> {
    /// Young's modulus E, in Pa.
    pub youngs_modulus: R,
    /// Poisson's ratio ν in (−1, 1/2].
    pub poissons_ratio: R,
}

impl<R: Real> Body<R> {
    /// An elastic body.
    ///
    /// # Errors
    /// [`Error::Domain`] unless E > 0 is finite and −1 < ν ≤ 1/2.
    #[inline(always)]
    pub fn new(youngs_modulus: R, poissons_ratio: R) -> Result<Self> {
        let youngs_modulus = Error::require_positive(Quantity::YoungsModulus, youngs_modulus)?;
        if poissons_ratio > poissons_ratio.lit(-1) && poissons_ratio <= poissons_ratio.ratio(1, 2) {
            Ok(Body { youngs_modulus, poissons_ratio })
        } else {
            Err(Error::domain(Quantity::PoissonsRatio, &poissons_ratio, "within (-1, 1/2]"))
        }
    }

    /// (1 − ν²)/E.
    fn compliance(&self) -> R {
        let nu = &self.poissons_ratio;
        (nu.lit(1) - nu) * (nu.lit(1) + nu) / &self.youngs_modulus
    }
}

/// Effective modulus and work of adhesion of a pair of bodies.
///
/// ```
/// use mdr_core::contact::{Body, Material};
/// // A rigid-like steel ball on soft rubber: E* is that of the rubber.
/// let m = Material::from_bodies(&Body::new(1e6, 0.5)?, &Body::new(2e11, 0.3)?, 0.05)?;
/// assert!((m.effective_modulus() / 1.3333e6 - 1.0).abs() < 1e-4);
/// assert!(Material::new(1e6, -0.05).is_err());
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Material<R> {
    effective_modulus: R,
    work_of_adhesion: R,
}

impl<R: Real> Material<R> {
    /// From the effective modulus E* (Pa) and the work of adhesion w = Δγ (J/m²).
    ///
    /// # Errors
    /// [`Error::Domain`] unless both are positive and finite.
    pub fn new(effective_modulus: R, work_of_adhesion: R) -> Result<Self> {
        Ok(Material {
            effective_modulus: Error::require_positive(Quantity::EffectiveModulus, effective_modulus)?,
            work_of_adhesion: Error::require_positive(Quantity::WorkOfAdhesion, work_of_adhesion)?,
        })
    }

    /// From two bodies: 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂ (1.3).
    ///
    /// # Errors
    /// [`Error::Domain`] unless the effective modulus and the work of adhesion are positive and finite.
    pub fn from_bodies(first: &Body<R>, second: &Body<R>, work_of_adhesion: R) -> Result<Self> {
        Self::new((first.compliance() + second.compliance()).inv(), work_of_adhesion)
    }

    /// E*, in Pa.
    pub fn effective_modulus(&self) -> &R {
        &self.effective_modulus
    }

    /// w = Δγ, in J/m². It is the full work of separation, not half of it.
    pub fn work_of_adhesion(&self) -> &R {
        &self.work_of_adhesion
    }
}

/// The elastic part of the material, as the user gives it.
#[derive(Clone, Debug, PartialEq)]
pub enum Elasticity {
    /// E*, in Pa.
    Effective(Literal),
    /// Two bodies, combined by (1.3).
    Bodies(Box<[Body<Literal>; 2]>),
}

impl Elasticity {
    /// E*, in Pa.
    ///
    /// # Errors
    /// [`LiteralError`] unless it is a finite number.
    pub fn effective(modulus: impl Exact) -> std::result::Result<Self, LiteralError> {
        Ok(Elasticity::Effective(modulus.exact()?))
    }

    /// Two bodies, combined by (1.3).
    pub fn bodies(first: Body<Literal>, second: Body<Literal>) -> Self {
        Elasticity::Bodies(Box::new([first, second]))
    }
}
