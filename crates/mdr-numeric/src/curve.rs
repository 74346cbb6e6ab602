//! The curve of equilibria a ↦ (d, F), and the direction of change of the contact off it.

use mdr_core::contact::{Control, Error, Material, Quantity, Result, Transform};
use mdr_core::number::Real;

/// The states of (1.5) and (1.6), parametrised by the contact radius.
///
/// Equilibria are points of this curve at a given value of the controlled quantity; folds are the extrema of that
/// quantity along it.
#[derive(Clone, Copy)]
pub struct EquilibriumCurve<'a, R: Real> {
    transform: &'a dyn Transform<R>,
    material: &'a Material<R>,
    control: &'a Control<R>,
}

impl<'a, R: Real> EquilibriumCurve<'a, R> {
    /// The curve of a profile in contact, under the given control.
    pub fn new(transform: &'a dyn Transform<R>, material: &'a Material<R>, control: &'a Control<R>) -> Self {
        EquilibriumCurve { transform, material, control }
    }

    /// The transformed profile.
    pub fn transform(&self) -> &'a dyn Transform<R> {
        self.transform
    }

    /// The outer radius of a profile with a vertical edge there.
    pub fn vertical_edge(&self) -> Option<R> {
        self.transform.outer_radius().filter(|_| self.transform.vertical_edge())
    }

    /// The controlled quantity.
    pub fn control(&self) -> &'a Control<R> {
        self.control
    }

    /// E* and w.
    pub fn material(&self) -> &'a Material<R> {
        self.material
    }

    /// E*, in Pa.
    pub fn effective_modulus(&self) -> &'a R {
        self.material.effective_modulus()
    }

    /// ℓ = w/E*, the length scale of the material, in m.
    pub fn material_length(&self) -> R {
        self.material.work_of_adhesion().clone() / self.material.effective_modulus()
    }

    /// Δl(a) = √(2πaw/E*), the rule of Heß (1.4), in m.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite.
    pub fn detachment_elongation(&self, a: &R) -> Result<R> {
        Ok(self.elongation(&Error::require_positive(Quantity::ContactRadius, a.clone())?))
    }

    /// The same for a > 0, written as a√(2πℓ/a), which stays in range if the product aw does not.
    pub(crate) fn elongation(&self, a: &R) -> R {
        a.clone() * self.root(a)
    }

    /// √(2πℓ/a) = Δl/a.
    fn root(&self, a: &R) -> R {
        relative_elongation(a, &self.material_length())
    }

    /// d(a) = g(a) − Δl(a) (1.5), in m.
    ///
    /// # Errors
    /// As [`Transform::g`].
    pub fn indentation(&self, a: &R) -> Result<R> {
        let elongation = self.elongation(a);
        Ok(self.transform.g_within(a, &negligible(&elongation))? - elongation)
    }

    /// F(a) = 2E* ∫₀ᵃ (d − g) dx (1.6) = 2E*a (g − Δl − mean of g), in N.
    ///
    /// # Errors
    /// As [`Transform::above_mean`].
    pub fn force(&self, a: &R) -> Result<R> {
        Ok(self.edge_stiffness(a) * self.depth_below_mean(a)?)
    }

    /// d minus the mean of g, in equilibrium.
    fn depth_below_mean(&self, a: &R) -> Result<R> {
        Ok(self.transform.above_mean(a)? - self.elongation(a))
    }

    /// The force of (1.6) at a contact radius and an indentation that need not be in equilibrium.
    pub(crate) fn force_at(&self, a: &R, d: &R) -> Result<R> {
        Ok(self.edge_stiffness(a) * (d.clone() - self.transform.mean(a)?))
    }

    /// 2E*a, the stiffness of the contact at fixed radius, in N/m.
    pub(crate) fn edge_stiffness(&self, a: &R) -> R {
        (a.clone() * self.material.effective_modulus()).times(2)
    }

    /// The controlled quantity along the curve.
    ///
    /// # Errors
    /// As [`Transform::mean`].
    pub fn controlled(&self, a: &R) -> Result<R> {
        let d = self.indentation(a)?;
        match self.control {
            Control::Indentation => Ok(d),
            control => Ok(control.controlled(&d, &self.force(a)?)),
        }
    }

    /// The indentation at radius `a`, a fixed `value` of the controlled quantity and this mean of g, equilibrium or not: d
    /// itself, F/(2E*a) + mean g, or (kD + 2E*a·mean g)/(k + 2E*a).
    pub(crate) fn held_against(&self, a: &R, value: &R, mean: impl FnOnce() -> Result<R>) -> Result<R> {
        let stiffness = self.edge_stiffness(a);
        Ok(match self.control {
            Control::Indentation => value.clone(),
            Control::Force => value.clone() / stiffness + mean()?,
            Control::Machine { stiffness: k } => {
                let whole = k.clone() + &stiffness;
                k.clone() / &whole * value + stiffness / whole * mean()?
            }
        })
    }

    /// Indentation and force in equilibrium at radius `a`, which was found at this `value` of the controlled quantity.
    ///
    /// On a machine softer than the contact the force is that of its spring, k(D − d): as 2E*a times a difference of
    /// lengths it would lose log₁₀(2E*a/k) digits.
    ///
    /// # Errors
    /// As [`EquilibriumCurve::state`].
    pub(crate) fn state_at(&self, a: &R, value: &R) -> Result<(R, R)> {
        match self.soft_spring(a) {
            Some(k) => {
                let d = self.indentation(a)?;
                let force = spring_force(k, value.clone() - &d)?;
                Ok((d, force))
            }
            None => self.state(a),
        }
    }

    /// The stiffness of a machine, if it is less than that of the contact.
    fn soft_spring(&self, a: &R) -> Option<&'a R> {
        match self.control {
            Control::Machine { stiffness } if *stiffness < self.edge_stiffness(a) => Some(stiffness),
            _ => None,
        }
    }

    /// Indentation and force at radius `a` and a fixed `value` of the controlled quantity, equilibrium or not.
    ///
    /// # Errors
    /// As [`EquilibriumCurve::state`].
    pub(crate) fn equilibrium_at(&self, a: &R, value: &R) -> Result<(R, R)> {
        let d = self.held_against(a, value, || self.transform.mean(a))?;
        let force = match (self.control, self.soft_spring(a)) {
            (Control::Force, _) => value.clone(),
            (_, Some(k)) => spring_force(k, value.clone() - &d)?,
            _ => self.force_of(a, &(d.clone() - self.transform.mean(a)?))?,
        };
        Ok((d, force))
    }

    /// The direction of change g(a) − d − Δl(a) at a fixed `value` of the controlled quantity: the contact shrinks
    /// where it is positive (1.8), grows where it is negative (1.9) and is in equilibrium where it vanishes.
    ///
    /// # Errors
    /// As [`Control::check_value`] and [`Transform::mean`].
    pub fn direction(&self, a: &R, value: &R) -> Result<R> {
        self.control.check_value(value)?;
        self.direction_at(a, value)
    }

    /// The same at a value that has been checked.
    pub(crate) fn direction_at(&self, a: &R, value: &R) -> Result<R> {
        self.direction_within(a, value, &negligible(&self.elongation(a)))
    }

    /// The same, with g and its mean to the absolute error `needed`.
    pub(crate) fn direction_within(&self, a: &R, value: &R, needed: &R) -> Result<R> {
        let held = self.held_against(a, value, || self.transform.mean_within(a, needed))?;
        Ok(self.transform.g_within(a, needed)? - self.elongation(a) - held)
    }

    /// Whether g − d < −Δl at radius `a`, so that growth requires energy, at a value that has been checked.
    pub(crate) fn is_pushed_back(&self, a: &R, value: &R) -> Result<bool> {
        Ok(self.direction_at(a, value)? + self.elongation(a).times(2) < a.lit(0))
    }

    /// The tangency ratio g'(a)/Δl'(a): under controlled indentation it is 1 at a fold (1.10).
    ///
    /// # Errors
    /// As [`Transform::slope`].
    pub fn tangency(&self, a: &R) -> Result<R> {
        Ok(self.tangency_of(self.transform.slope(a)?, a))
    }

    /// The same, with a given g'.
    pub(crate) fn tangency_of(&self, slope: R, a: &R) -> R {
        slope.times(2) / self.root(a)
    }

    /// The value of the [tangency ratio](EquilibriumCurve::tangency) at which the controlled quantity is stationary.
    ///
    /// With d' = g' − Δl' and, from (1.6) along the curve, F' = 2E*(a d' − Δl), the condition d' + F'/k = 0 reads
    /// g'/Δl' = (k + 6E*a)/(k + 2E*a): 1 for fixed grips (k → ∞), 3 for a dead load (k → 0). Equilibria are stable where
    /// the ratio exceeds it.
    ///
    /// # Errors
    /// [`Error::Domain`] unless a and the stiffness of a machine are positive and finite.
    pub fn threshold(&self, a: &R) -> Result<R> {
        self.control.check()?;
        Ok(self.threshold_at(&Error::require_positive(Quantity::ContactRadius, a.clone())?))
    }

    /// The same for a > 0, unchecked.
    pub(crate) fn threshold_at(&self, a: &R) -> R {
        match self.control {
            Control::Indentation => a.lit(1),
            Control::Force => a.lit(3),
            Control::Machine { stiffness: k } => {
                // 1 + 2/(1 + k/(2E*a)), which stays in range at both ends.
                let share = (k.clone() / self.edge_stiffness(a) + a.lit(1)).inv();
                share.times(2) + a.lit(1)
            }
        }
    }

    /// Indentation and force at radius `a`.
    ///
    /// # Errors
    /// As [`Transform::mean`]; [`Error::OutOfRange`] if the force is not representable in this arithmetic.
    pub fn state(&self, a: &R) -> Result<(R, R)> {
        let d = self.indentation(a)?;
        let force = self.force_of(a, &self.depth_below_mean(a)?)?;
        Ok((d, force))
    }

    /// 2E*a times the indentation minus the mean of g, or [`Error::OutOfRange`].
    pub(crate) fn force_of(&self, a: &R, excess: &R) -> Result<R> {
        let force = self.edge_stiffness(a) * excess;
        let factors = || [a.lit(2), a.clone(), self.material.effective_modulus().clone(), excess.abs()];
        in_range(Quantity::Force, force, excess, factors)
    }
}

/// The rounding error of Δl: smaller errors of g are negligible against it.
pub(crate) fn negligible<R: Real>(elongation: &R) -> R {
    elongation.unit_roundoff() * elongation
}

/// The force of the spring of a machine, or [`Error::OutOfRange`].
fn spring_force<R: Real>(stiffness: &R, stretch: R) -> Result<R> {
    in_range(Quantity::Force, stretch.clone() * stiffness, &stretch, || [stiffness.clone(), stretch.abs()])
}

/// A force or an energy, if it is representable; it vanishes with `reduced`, and is the product of the factors.
pub(crate) fn in_range<R: Real, const N: usize>(
    quantity: Quantity,
    value: R,
    reduced: &R,
    factors: impl FnOnce() -> [R; N],
) -> Result<R> {
    let vanished = value == value.lit(0) && *reduced != reduced.lit(0);
    if vanished || !value.is_finite() {
        return Err(Error::OutOfRange { quantity, log10: log10_of_product(factors()) });
    }
    Ok(value)
}

/// log₁₀ of the magnitude of a product that the arithmetic cannot represent.
pub(crate) fn log10_of_product<R: Real, const N: usize>(factors: [R; N]) -> f64 {
    factors.iter().map(|x| x.abs().ln().approx()).sum::<f64>() / std::f64::consts::LN_10
}

/// Δl/a = √(2πℓ/a), also if the quotient itself is out of range.
pub(crate) fn relative_elongation<R: Real>(a: &R, material_length: &R) -> R {
    let square = (material_length.clone() / a * a.pi()).times(2);
    let normal = square.is_finite() && square.clone() * a.unit_roundoff() > a.lit(0);
    if normal { square.sqrt() } else { a.pi().times(2).sqrt() * material_length.sqrt() / a.sqrt() }
}
