//! A contact: a profile on a medium, with its adhesion and its control. Its equilibria form the curve a ↦ (d, F).

mod folding;
mod partials;

use std::sync::Arc;

use mdr_core::contact::{Control, Edge, Error, Material, Quantity, Result, Transform};
use mdr_core::number::Real;

use crate::medium::{Adhesion, Medium};

pub use partials::Input;

/// A contact: the transformed profile, the medium below it, the adhesion at its edge, and the control.
///
/// Its states satisfy (1.5) and (1.6), parametrised by the contact radius. Equilibria are points of this curve at a given value
/// of the controlled quantity; folds are the extrema of that quantity along it. A contact owns or shares its parts, and copies of
/// it are cheap.
///
/// ```
/// use mdr_core::contact::{Control, Shape};
/// use mdr_numeric::{contact::Contact, folds, transform::Quadrature};
/// use mdr_numeric::medium::{Adhesion, Medium};
/// let ball = Quadrature::of([Shape::Paraboloid { radius: 0.01 }])?;
/// let contact = Contact::new(ball, Medium::half_space(1e6)?, Adhesion::new(0.05)?, Control::Force);
/// let pull_off = &folds::find(&contact)?[0];
/// assert!((pull_off.force / (-1.5 * std::f64::consts::PI * 0.05 * 0.01) - 1.0).abs() < 1e-13);
/// // The tension at fixed grips, with the same profile, medium and adhesion.
/// let at_grips = &folds::find(&contact.with_control(Control::Indentation))?[0];
/// assert!(at_grips.force > pull_off.force);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
#[derive(Clone)]
pub struct Contact<R: Real> {
    transform: Arc<dyn Transform<R>>,
    medium: Medium<R>,
    adhesion: Adhesion<R>,
    control: Control<R>,
}

impl<R: Real> Contact<R> {
    /// A profile on a medium, under the given control. The transformed profile is that of the medium; an `Arc` of a transform is
    /// also a transform.
    pub fn new(
        transform: impl Transform<R> + 'static,
        medium: Medium<R>,
        adhesion: Adhesion<R>,
        control: Control<R>,
    ) -> Self {
        Contact { transform: Arc::new(transform), medium, adhesion, control }
    }

    /// A profile that others may use as well, on a half-space of the effective modulus of the material, with its work of
    /// adhesion.
    pub fn half_space<T>(transform: &Arc<T>, material: &Material<R>, control: &Control<R>) -> Self
    where
        T: Transform<R> + ?Sized + 'static,
    {
        Self::new(Arc::clone(transform), material.into(), material.into(), control.clone())
    }

    /// A profile behind a shared pointer, which is called without a detour.
    pub fn sharing(
        transform: Arc<dyn Transform<R>>,
        medium: Medium<R>,
        adhesion: Adhesion<R>,
        control: Control<R>,
    ) -> Self {
        Contact { transform, medium, adhesion, control }
    }

    /// The contact with its transformed profile replaced: by one that counts its evaluations, for example.
    #[must_use]
    pub fn with_transform(&self, transform: Arc<dyn Transform<R>>) -> Self {
        Contact { transform, ..self.clone() }
    }

    /// The contact with one of its two works of adhesion: the folds, branches and states are those of this edge.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Edge, Shape};
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::{contact::Contact, transform::Quadrature};
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
    /// let contact = Contact::new(ball, Medium::half_space(1.0)?, Adhesion::hysteretic(0.0, 0.04)?, Control::Force);
    /// // An advancing edge without adhesion is that of Hertz: d = a²/R.
    /// assert!((contact.at(Edge::Advancing).indentation(&0.5)? - 0.25).abs() < 1e-15);
    /// assert!(contact.at(Edge::Receding).indentation(&0.5)? < 0.0);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    #[must_use]
    pub fn at(&self, edge: Edge) -> Self {
        Contact { adhesion: self.adhesion.at(edge), ..self.clone() }
    }

    /// The contact of the same profile, medium and adhesion under another control.
    #[must_use]
    pub fn with_control(&self, control: Control<R>) -> Self {
        Contact { control, ..self.clone() }
    }

    /// The transformed profile.
    pub fn transform(&self) -> &dyn Transform<R> {
        &*self.transform
    }

    /// The transformed profile, to be shared.
    pub fn shared_transform(&self) -> &Arc<dyn Transform<R>> {
        &self.transform
    }

    /// The elastic medium below the profile.
    pub fn medium(&self) -> &Medium<R> {
        &self.medium
    }

    /// The adhesion at the edge.
    pub fn adhesion(&self) -> &Adhesion<R> {
        &self.adhesion
    }

    /// The outer radius of a profile with a vertical edge there.
    pub fn vertical_edge(&self) -> Option<R> {
        self.transform.outer_radius().filter(|_| self.transform.vertical_edge())
    }

    /// The controlled quantity.
    pub fn control(&self) -> &Control<R> {
        &self.control
    }

    /// The modulus of the medium, in Pa; E* of a half-space.
    pub fn modulus(&self) -> &R {
        self.medium.modulus()
    }

    /// The length of the material, in m, from which searches begin: w/E* on a half-space.
    pub fn material_length(&self) -> R {
        self.medium.length(self.adhesion.scale())
    }

    /// Δl(a), the elongation at which the springs at the edge detach (1.4), in m: see [`Medium::elongation`].
    ///
    /// # Errors
    /// [`Error::Domain`] unless a is positive and finite.
    pub fn detachment_elongation(&self, a: &R) -> Result<R> {
        Ok(self.elongation(&Error::require_positive(Quantity::ContactRadius, a.clone())?))
    }

    /// Δl(a) for a > 0, unchecked.
    pub(crate) fn elongation(&self, a: &R) -> R {
        if self.adhesion.vanishes() { a.lit(0) } else { self.unit_elongation(a) }
    }

    /// Δl(a), or that of the other edge where it vanishes: a unit of displacements.
    pub(crate) fn unit_elongation(&self, a: &R) -> R {
        self.medium.elongation(self.adhesion.scale(), a)
    }

    /// Δl'(a) for a > 0, unchecked.
    pub(crate) fn elongation_slope(&self, a: &R) -> R {
        if self.adhesion.vanishes() {
            return a.lit(0);
        }
        self.medium.elongation_slope(self.adhesion.work(), a)
    }

    /// d(a) = g(a) − Δl(a) (1.5), in m.
    ///
    /// # Errors
    /// Errors of the transform at a; see [`Transform::g`].
    pub fn indentation(&self, a: &R) -> Result<R> {
        let elongation = self.elongation(a);
        Ok(self.transform.g_within(a, &negligible(&elongation))? - elongation)
    }

    /// F(a) = S(a)(g − Δl − mean of g) (1.6), in N, with the stiffness S of the medium.
    ///
    /// # Errors
    /// Errors of the transform at a; see [`Transform::above_mean`].
    pub fn force(&self, a: &R) -> Result<R> {
        Ok(self.stiffness(a) * self.depth_below_mean(a)?)
    }

    /// d minus the mean of g, in equilibrium.
    fn depth_below_mean(&self, a: &R) -> Result<R> {
        Ok(self.transform.above_mean(a)? - self.elongation(a))
    }

    /// The force of (1.6) at a contact radius and an indentation that need not be in equilibrium.
    pub(crate) fn force_at(&self, a: &R, d: &R) -> Result<R> {
        Ok(self.stiffness(a) * (d.clone() - self.transform.mean(a)?))
    }

    /// The limit of the controlled quantity at the tip, a → 0. It is 0 but on a Winkler foundation, whose springs hold to
    /// d = −Δl however small the contact.
    pub(crate) fn tip_value(&self, like: &R) -> R {
        match (self.medium(), self.control()) {
            (Medium::Winkler { .. }, Control::Indentation | Control::Machine { .. }) => -self.elongation(&like.lit(1)),
            _ => like.lit(0),
        }
    }

    /// S(a), the stiffness of the contact at fixed radius, in N/m.
    pub fn stiffness(&self, a: &R) -> R {
        self.medium.stiffness(a)
    }

    /// dF/dd along the equilibria of an edge that moves, in N/m; `None` at a fold of the indentation. Without adhesion the edge moves
    /// where g(a) = d, and F = ∫S'(d − g) grows by S.
    ///
    /// # Errors
    /// Errors of the transform at a; see [`Transform::slope`].
    pub(crate) fn stiffness_along(&self, a: &R) -> Result<Option<R>> {
        let stiffness = self.stiffness(a);
        if self.adhesion.vanishes() {
            return Ok(Some(stiffness));
        }
        let slope = self.transform.slope(a)?;
        Ok(self.medium.stiffening(self.adhesion.work(), slope, a).map(|ratio| ratio * stiffness))
    }

    /// The controlled quantity along the curve.
    ///
    /// # Errors
    /// Errors of the transform at a; see [`Transform::g`].
    pub fn controlled(&self, a: &R) -> Result<R> {
        let d = self.indentation(a)?;
        match &self.control {
            Control::Indentation => Ok(d),
            control => Ok(control.controlled(&d, &self.force(a)?)),
        }
    }

    /// The indentation at radius `a`, a fixed `value` of the controlled quantity and this mean of g, equilibrium or not: d
    /// itself, F/S + mean g, or (kD + S·mean g)/(k + S).
    pub(crate) fn held_against(&self, a: &R, value: &R, mean: impl FnOnce() -> Result<R>) -> Result<R> {
        let stiffness = self.stiffness(a);
        Ok(match &self.control {
            Control::Indentation => value.clone(),
            Control::Force => value.clone() / stiffness + mean()?,
            Control::Machine { stiffness: k } => {
                let whole = k.clone() + &stiffness;
                k.clone() / &whole * value + stiffness / whole * mean()?
            }
        })
    }

    /// What [`held_against`](Contact::held_against) is more than the mean of g where a contact may become complete: F/S, or
    /// k(D − mean g)/(k + S); `None` at a given indentation and on other media.
    fn excess_held_on_waves(&self, a: &R, value: &R) -> Result<Option<R>> {
        if !self.medium().becomes_complete() {
            return Ok(None);
        }
        let stiffness = self.stiffness(a);
        Ok(match &self.control {
            Control::Indentation => None,
            Control::Force => Some(value.clone() / stiffness),
            Control::Machine { stiffness: k } => {
                Some((value.clone() - self.transform.mean(a)?) * k / (k.clone() + stiffness))
            }
        })
    }

    /// Indentation and force in equilibrium at radius `a`, which was found at this `value` of the controlled quantity.
    ///
    /// On a machine softer than the contact the force is that of its spring, k(D − d): as S(a) times a difference of lengths it
    /// would lose log₁₀(S/k) digits.
    /// On a much stiffer one with d far below g and Δl, of which it would be the difference, d is D − F/k.
    ///
    /// # Errors
    /// Errors of the transform at a; [`Error::OutOfRange`] if the force is not representable in this arithmetic.
    pub(crate) fn state_at(&self, a: &R, value: &R) -> Result<(R, R)> {
        match self.soft_spring(a) {
            Some(k) => {
                let d = self.indentation(a)?;
                let force = spring_force(k, value.clone() - &d)?;
                Ok((d, force))
            }
            None => {
                let (d, force) = self.state(a)?;
                Ok((self.held_by_stiff_machine(a, value, &force).unwrap_or(d), force))
            }
        }
    }

    /// D − F/k, where both are far below the lengths of which d is the difference.
    fn held_by_stiff_machine(&self, a: &R, value: &R, force: &R) -> Option<R> {
        let Control::Machine { stiffness } = &self.control else { return None };
        let given = force.clone() / stiffness;
        let is_small = (value.abs() + given.abs()).times(16) < self.elongation(a);
        (is_small && self.stiffness(a).times(16) < *stiffness).then(|| value.clone() - given)
    }

    /// The stiffness of a machine, if it is less than that of the contact.
    fn soft_spring(&self, a: &R) -> Option<&R> {
        match &self.control {
            Control::Machine { stiffness } if *stiffness < self.stiffness(a) => Some(stiffness),
            _ => None,
        }
    }

    /// Indentation and force at radius `a` and a fixed `value` of the controlled quantity, equilibrium or not.
    ///
    /// # Errors
    /// Errors of the transform at a; [`Error::OutOfRange`] if the force is not representable in this arithmetic.
    pub(crate) fn equilibrium_at(&self, a: &R, value: &R) -> Result<(R, R)> {
        let d = self.held_against(a, value, || self.transform.mean(a))?;
        let force = match (&self.control, self.soft_spring(a)) {
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
    /// [`Error::Domain`] unless `value` is finite and the stiffness of a machine positive and finite; errors of the transform at
    /// a.
    pub fn direction(&self, a: &R, value: &R) -> Result<R> {
        self.control.check_value(value)?;
        self.direction_at(a, value)
    }

    /// The [direction of change](Contact::direction) at a value that has been checked.
    pub(crate) fn direction_at(&self, a: &R, value: &R) -> Result<R> {
        self.direction_within(a, value, &negligible(&self.elongation(a)))
    }

    /// The [direction of change](Contact::direction), from g and its mean to the absolute error `needed`.
    ///
    /// On a periodic medium g, its mean and d all tend to one height, and Δl to 0, where a contact is nearly complete: at a given
    /// force, or on a machine, their differences are taken instead.
    pub(crate) fn direction_within(&self, a: &R, value: &R, needed: &R) -> Result<R> {
        if let Some(excess) = self.excess_held_on_waves(a, value)? {
            let (above, elongation) = (self.transform.above_mean(a)?, self.elongation(a));
            // Beyond the range of the numbers, where all of them vanish, Δl does so first.
            if !self.adhesion.vanishes() {
                let smallest = elongation.clone() * &elongation.unit_roundoff();
                in_range(Quantity::TransformedProfile, smallest, &above, || [elongation.clone()])?;
            }
            return Ok(above - elongation - excess);
        }
        let held = self.held_against(a, value, || self.transform.mean_within(a, needed))?;
        Ok(self.transform.g_within(a, needed)? - self.elongation(a) - held)
    }

    /// Whether g − d < −Δl at radius `a`, so that growth requires energy, at a value that has been checked.
    pub(crate) fn is_pushed_back(&self, a: &R, value: &R) -> Result<bool> {
        Ok(self.direction_at(a, value)? + self.elongation(a).times(2) < a.lit(0))
    }

    /// Indentation and force at radius `a`.
    ///
    /// # Errors
    /// Errors of the transform at a; [`Error::OutOfRange`] if the force is not representable in this arithmetic.
    pub fn state(&self, a: &R) -> Result<(R, R)> {
        let d = self.indentation(a)?;
        let force = self.force_of(a, &self.depth_below_mean(a)?)?;
        Ok((d, force))
    }

    /// S(a) times the indentation minus the mean of g, or [`Error::OutOfRange`].
    pub(crate) fn force_of(&self, a: &R, excess: &R) -> Result<R> {
        let force = self.stiffness(a) * excess;
        let factors = || {
            let [two, radius, modulus] = self.medium.stiffness_factors(a);
            [two, radius, modulus, excess.abs()]
        };
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
