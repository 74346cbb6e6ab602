//! The power law f(r) = C rⁿ.

use mdr_core::contact::{Error, Quantity, Regime, Result, Transform};
use mdr_core::number::Real;

use crate::kappa::Kappa;
use crate::range::{ordinary, product, representable};

/// The profile f(r) = C rⁿ with its factor κ_n, computed once.
///
/// n > 0 is dimensionless, C > 0 in m^(1−n). Its MDR transform is g(x) = κ_n C xⁿ (1.12).
///
/// ```
/// use mdr_analytic::PowerLaw;
/// use mdr_core::contact::{Regime, Transform};
/// let ball = PowerLaw::new(2.0, 0.5)?; // r²/2R with R = 1
/// assert_eq!(ball.regime()?, Regime::PullOff);
/// assert!((ball.g(&3.0)? - 9.0).abs() < 1e-14); // x²/R
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PowerLaw<R> {
    exponent: R,
    coefficient: R,
    kappa: R,
}

impl<R: Kappa> PowerLaw<R> {
    /// From n and C.
    ///
    /// # Errors
    /// [`Error::Domain`] unless both are positive and finite.
    #[inline(always)]
    pub fn new(exponent: R, coefficient: R) -> Result<Self> {
        let exponent = Error::require_positive(Quantity::Exponent, exponent)?;
        let kappa = R::kappa(&exponent);
        Self::with_kappa(exponent, coefficient, kappa)
    }
}

impl<R: Real> PowerLaw<R> {
    /// From n, C and a κ_n computed elsewhere.
    ///
    /// # Errors
    /// [`Error::Domain`] unless all are positive and finite.
    #[inline(always)]
    pub fn with_kappa(exponent: R, coefficient: R, kappa: R) -> Result<Self> {
        Ok(PowerLaw {
            exponent: Error::require_positive(Quantity::Exponent, exponent)?,
            coefficient: Error::require_positive(Quantity::Coefficient, coefficient)?,
            kappa: Error::require_positive(Quantity::Kappa, kappa)?,
        })
    }

    /// n.
    pub fn exponent(&self) -> &R {
        &self.exponent
    }

    /// C, in m^(1−n).
    pub fn coefficient(&self) -> &R {
        &self.coefficient
    }

    /// κ_n.
    pub fn kappa(&self) -> &R {
        &self.kappa
    }

    /// The kind of instability, from the order of n and 1/2.
    ///
    /// # Errors
    /// [`Error::Undecided`] when n is an interval around 1/2.
    #[inline(always)]
    pub fn regime(&self) -> Result<Regime> {
        use std::cmp::Ordering::*;
        match self.exponent.partial_cmp(&self.exponent.ratio(1, 2)) {
            Some(Greater) => Ok(Regime::PullOff),
            Some(Equal) => Ok(Regime::ScaleFree),
            Some(Less) => Ok(Regime::CompleteContact),
            None => Err(Error::undecided(Quantity::Exponent, &self.exponent, "whether it is above or below 1/2")),
        }
    }

    /// 2n − 1, the exponent of the length scale: positive in the pull-off regime.
    #[inline(always)]
    pub(crate) fn excess(&self) -> R {
        self.exponent.clone().times(2) - self.exponent.lit(1)
    }

    /// κ_n C.
    #[inline(always)]
    pub(crate) fn strength(&self) -> R {
        self.kappa.clone() * &self.coefficient
    }

    /// κ_n C x^power · factor · scale, unchecked.
    #[inline(always)]
    pub(crate) fn monomial(&self, x: &R, power: &R, factor: &R, scale: &R) -> R {
        let grown = x.pow(power);
        let factor = factor.clone() * &self.kappa;
        if ordinary(&grown) {
            return product([&grown, &self.coefficient, &factor, scale]);
        }
        // With a quarter of the power each of the three other factors leads back by at most the whole range.
        let quarter = x.pow(&power.clone().over(4));
        product([&quarter, &quarter, &quarter, &quarter, &self.coefficient, &factor, scale])
    }

    /// ln of κ_n C x^power · factor.
    pub(crate) fn ln_monomial(&self, x: &R, power: &R, factor: &R) -> R {
        x.ln() * power + self.coefficient.ln() + (factor.clone() * &self.kappa).ln()
    }

    /// κ_n C x^power · factor, checked for range.
    fn checked(&self, x: &R, power: R, factor: R) -> Result<R> {
        let x = Error::require_positive(Quantity::Radius, x.clone())?;
        let value = self.monomial(&x, &power, &factor, &x.lit(1));
        representable(Quantity::TransformedProfile, value, || self.ln_monomial(&x, &power, &factor))
    }
}

/// g(x) = κ_n C xⁿ (1.12), g' = n κ_n C xⁿ⁻¹ and G = κ_n C xⁿ⁺¹/(n+1), for x > 0.
impl<R: Real> Transform<R> for PowerLaw<R> {
    fn g(&self, x: &R) -> Result<R> {
        self.checked(x, self.exponent.clone(), x.lit(1))
    }

    fn slope(&self, x: &R) -> Result<R> {
        self.checked(x, self.exponent.clone() - x.lit(1), self.exponent.clone())
    }

    fn integral(&self, x: &R) -> Result<R> {
        let next = self.exponent.clone() + x.lit(1);
        self.checked(x, next.clone(), next.inv())
    }

    /// κ_n C xⁿ/(n+1).
    fn mean(&self, x: &R) -> Result<R> {
        let next = self.exponent.clone() + x.lit(1);
        self.checked(x, self.exponent.clone(), next.inv())
    }

    /// κ_n C xⁿ n/(n+1).
    fn above_mean(&self, x: &R) -> Result<R> {
        let next = self.exponent.clone() + x.lit(1);
        self.checked(x, self.exponent.clone(), self.exponent.clone() / next)
    }

    fn rises(&self) -> bool {
        true
    }
}
