//! The condition of folds: the tangency ratio and its critical value.

use mdr_core::contact::{Control, Error, Quantity, Result};
use mdr_core::number::Real;

use super::Contact;

impl<R: Real> Contact<R> {
    /// The tangency ratio 2a g'(a)/Δl(a). On a half-space it is g'(a)/Δl'(a), and under controlled indentation 1 at a fold
    /// (1.10). On media where Δl may fall, line and periodic contacts, it is raised by 2q/(1 + S/K), and so is its critical value.
    ///
    /// # Errors
    /// Errors of the transform at a; see [`Transform::slope`](mdr_core::contact::Transform::slope).
    pub fn tangency(&self, a: &R) -> Result<R> {
        Ok(self.tangency_of(self.transform.slope(a)?, a))
    }

    /// The tangency ratio for a given g'; at an edge without adhesion, that of the other edge.
    pub(crate) fn tangency_of(&self, slope: R, a: &R) -> R {
        self.medium.tangency(self.adhesion.scale(), slope, a, &self.control)
    }

    /// A function that is 1 at a fold, and larger where equilibria are stable: the tangency ratio over its critical value. Where that
    /// is 0, at an edge without adhesion and on a Winkler foundation at fixed grips, where Δl is constant, the folds are where g' = 0,
    /// and it is 1 + sin φ with tan φ = ag'/g, which does not tend to 1 at the tip.
    pub(crate) fn fold_ratio(&self, a: &R) -> Result<R> {
        let critical = self.critical_ratio_at(a);
        if critical != a.lit(0) {
            return Ok(self.tangency(a)? / critical);
        }
        // S/K of a machine on a Winkler foundation leaves the range of the arithmetic before a does, and the ratio with it.
        if !self.adhesion.vanishes() && matches!(self.control, Control::Machine { .. }) {
            let log10 = a.ln().approx() * 2.0 * std::f64::consts::LOG10_E;
            return Err(Error::OutOfRange { quantity: Quantity::Stiffness, log10 });
        }
        let (slope, height) = (self.transform.slope(a)?, self.transform.g(a)?);
        let out_of_range = || {
            let log10 = a.ln().approx() * std::f64::consts::LOG10_E;
            Err(Error::OutOfRange { quantity: Quantity::Indentation, log10 })
        };
        let has_digits = |x: &R| a.unit_roundoff().square() * x.abs() > a.lit(0);
        if !height.is_finite() {
            return out_of_range();
        }
        if !has_digits(&(slope.clone() * a)) && !has_digits(&height) {
            // A flat is neutral and comes to rest at its end. What rises from the tip on is there below the range of the arithmetic.
            return self.flat()?.map_or_else(out_of_range, |end| Ok(a.lit(if *a < end { 0 } else { 2 })));
        }
        if slope == a.lit(0) {
            return Ok(a.lit(1));
        }
        let sine = ((height / a / &slope).square() + a.lit(1)).sqrt().inv();
        Ok(a.lit(1) + if slope > a.lit(0) { sine } else { -sine })
    }

    /// The radius up to which g = 0 from the tip on, and nowhere beyond: surfaces without adhesion touch on all of it at d = 0.
    ///
    /// # Errors
    /// Errors of the transform.
    pub(crate) fn flat(&self) -> Result<Option<R>> {
        let Some(end) = self.transform.kinks().into_iter().next().or(self.transform.outer_radius()) else {
            return Ok(None);
        };
        let (inside, zero) = (end.clone().over(2), end.lit(0));
        let flat = self.transform.g(&inside)? == zero && self.transform.slope(&inside)? == zero;
        Ok(Some(end).filter(|_| flat))
    }

    /// The value of the [tangency ratio](Contact::tangency) at which the controlled quantity is stationary.
    ///
    /// With d' = g' − Δl' and F' = S d' − S' Δl along the curve, d' + F'/K = 0 reads 2a g'/Δl = 2p + 2q/(1 + K/S), where q and
    /// p are the orders of S and Δl in a. On a half-space, where 2p = 1 and 2q = 2, it is 1 for fixed grips (K → ∞) and 3 for a
    /// dead load (K → 0). Equilibria are stable where the ratio exceeds it.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a and the stiffness of a machine are positive and finite.
    pub fn critical_ratio(&self, a: &R) -> Result<R> {
        self.control.check()?;
        Ok(self.critical_ratio_at(&Error::require_positive(Quantity::ContactRadius, a.clone())?))
    }

    /// The critical tangency ratio for a > 0, unchecked. At an edge without adhesion folds are where g' = 0.
    pub(crate) fn critical_ratio_at(&self, a: &R) -> R {
        if self.adhesion.vanishes() {
            return a.lit(0);
        }
        self.medium.critical_ratio(a, &self.control)
    }
}
