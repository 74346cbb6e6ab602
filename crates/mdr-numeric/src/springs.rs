//! The procedure of the paper taken literally: an elastic foundation of discrete springs.
//!
//! Springs are at xᵢ = iΔx, i = −N…N, each of stiffness ½S'(xᵢ)Δx, which is E*Δx on a half-space (1.2). The transformed profile g(x) is pressed into them.
//! The outermost spring in contact detaches when its elongation g(xᵢ) − d exceeds Δl(xᵢ), the rule of Heß (1.4); the
//! next one attaches when its own would be smaller. The force is the sum of the spring forces.
//!
//! Pulling and pressing proceed from event to event, each at its exact indentation, so there is no step size. The
//! remaining error is that of the spacing:
//! * the critical radius is that of a spring, with an error up to Δx/2: first order;
//! * the critical indentation is the extremum of dᵢ = g(xᵢ) − Δl(xᵢ), a smooth function sampled within Δx/2 of it:
//!   second order, error ≤ d''(a_c)Δx²/8;
//! * the force is the trapezoidal sum plus one more half strip E*Δx(d − g(a)) at either edge: at the critical radius
//!   its error is −E*Δl(a_c)Δx and F'(a)|_d = −2E*Δl per unit of the error of the radius: first order.

use mdr_core::contact::{Control, Error, Fold, FoldKind, Material, Outcome, Quantity, Result, Transform};
use mdr_core::number::Real;

use crate::medium::Medium;

/// Springs under a transformed profile.
///
/// ```
/// use mdr_core::contact::{Control, Material, Outcome, Shape};
/// use mdr_numeric::{springs::Foundation, transform::Quadrature};
/// let (ball, glue) = (Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?, Material::new(1.0, 1.0)?);
/// let foundation = Foundation::new(&ball, &glue, 1e-3, 2000)?;
/// let breaks = foundation.pull(2000, &Control::Indentation)?;
/// assert_eq!(breaks.len(), 1);
/// assert_eq!(breaks[0].outcome, Outcome::Detached);
/// let jkr = (std::f64::consts::PI / 8.0).cbrt(); // a³ = πwR²/(8E*)
/// assert!((breaks[0].instability.contact_radius - jkr).abs() <= 0.5e-3);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
pub struct Foundation<R> {
    spacing: R,
    /// The modulus times Δx: E*Δx.
    stiffness: R,
    /// Σ of the shares of the springs −i…i in it, their number on a half-space.
    shares: Vec<R>,
    /// g at the springs i = 0…N of one side.
    profile: Vec<R>,
    /// dᵢ = g − Δl: above this indentation spring i is attached once its inner neighbour is.
    critical: Vec<R>,
    /// Σ of share times g over the springs −i…i.
    heights: Vec<R>,
}

/// A cascade: springs that detach or attach one after the other at a fixed controlled value.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cascade<R> {
    /// The state at which it starts.
    pub instability: Fold<R>,
    /// The outcome of the cascade.
    pub outcome: Outcome<R>,
}

impl<R: Real> Foundation<R> {
    /// Springs at 0, ±Δx, …, ±NΔx for N = `reach`.
    ///
    /// # Errors
    /// [`Error::Domain`] unless Δx is positive and finite and N at least 1; errors of the transform at NΔx.
    pub fn new(transform: &dyn Transform<R>, material: &Material<R>, spacing: R, reach: usize) -> Result<Self> {
        Self::on(&material.into(), transform, material.work_of_adhesion(), spacing, reach)
    }

    /// Springs at 0, ±Δx, …, ±NΔx for N = `reach` of another medium, whose transformed profile is given.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Shape};
    /// use mdr_numeric::{medium::Medium, springs::Foundation, transform::Powers};
    /// // A ball on a Winkler foundation, where g = f, breaks under a dead load at −2πwR.
    /// let ball = Powers::winkler([(2.0, 0.5)])?;
    /// let springs = Foundation::on(&Medium::winkler(1.0)?, &ball, &1e-2, 1e-4, 10_000)?;
    /// let pull_off = &springs.pull(10_000, &Control::Force)?[0].instability;
    /// assert!((pull_off.force / (-2.0 * std::f64::consts::PI * 1e-2) - 1.0).abs() < 1e-3);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless Δx is positive and finite and N at least 1; errors of the transform at NΔx.
    pub fn on(medium: &Medium<R>, transform: &dyn Transform<R>, work: &R, spacing: R, reach: usize) -> Result<Self> {
        let spacing = Error::require_positive(Quantity::Spacing, spacing)?;
        if reach == 0 {
            return Err(Error::domain(Quantity::Parameter("the number of springs"), &spacing.lit(0), "at least 1"));
        }
        let zero = spacing.lit(0);
        let (mut profile, mut critical, mut heights) = (vec![zero.clone()], vec![zero.clone()], vec![zero]);
        // The strip in the middle is that of a contact of half the spacing.
        let first = medium.reduced_stiffness(&spacing.clone().over(2)) / &spacing;
        let mut shares = vec![first];
        for i in 1..=reach {
            let x = spacing.clone().times(i64::try_from(i).unwrap_or(i64::MAX));
            let height = transform.g(&x)?;
            let elongation = medium.elongation(work, &x);
            heights.push(medium.weighted(&x, height.clone()).times(2) + &heights[i - 1]);
            shares.push(medium.weighted(&x, x.lit(1)).times(2) + &shares[i - 1]);
            critical.push(height.clone() - elongation);
            profile.push(height);
        }
        let stiffness = spacing.clone() * medium.modulus();
        Ok(Foundation { spacing, stiffness, shares, profile, critical, heights })
    }

    /// The position of spring i, in m.
    pub fn position(&self, i: usize) -> R {
        self.spacing.clone().times(i64::try_from(i).unwrap_or(i64::MAX))
    }

    /// The sum of the spring forces with the springs −i…i in contact at indentation `d`, in N.
    ///
    /// # Errors
    /// [`Error::Domain`] when there is no spring i, or d is not finite.
    pub fn force(&self, i: usize, d: &R) -> Result<R> {
        self.check(i, d)?;
        Ok(self.force_on(i, d))
    }

    fn force_on(&self, i: usize, d: &R) -> R {
        (d.clone() * &self.shares[i] - &self.heights[i]) * &self.stiffness
    }

    /// Elongation of spring i at indentation `d`, in m; negative when it is compressed.
    ///
    /// # Errors
    /// [`Error::Domain`] when there is no spring i, or d is not finite.
    pub fn elongation(&self, i: usize, d: &R) -> Result<R> {
        self.check(i, d)?;
        Ok(self.profile[i].clone() - d)
    }

    fn check(&self, i: usize, d: &R) -> Result<()> {
        if i >= self.profile.len() {
            let quantity = Quantity::Parameter("the number of a spring");
            let requirement = "at most that of the outermost spring";
            return Err(Error::Domain { quantity, value: i.to_string(), requirement });
        }
        Error::require_finite(Quantity::Indentation, d)
    }

    /// Pulls with the springs up to `start` in contact until the contact breaks. Springs detach one by one; if the loss
    /// of one makes others follow at the same value, that is an instability. Returns all of them in order.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the stiffness of a machine is positive and finite.
    pub fn pull(&self, start: usize, control: &Control<R>) -> Result<Vec<Cascade<R>>> {
        control.check()?;
        let mut cascades = Vec::new();
        let mut i = start.min(self.profile.len() - 1);
        while i > 0 {
            let value = self.detaching(i, control);
            let mut rest = i - 1;
            while rest > 0 && self.detaching(rest, control) >= value {
                rest -= 1;
            }
            if rest + 1 < i || rest == 0 {
                let outcome = if rest == 0 { Outcome::Detached } else { Outcome::Jump { to: self.position(rest) } };
                cascades.push(self.cascade(i, &self.critical[i], FoldKind::Minimum, outcome));
            }
            i = rest;
        }
        Ok(cascades)
    }

    /// Presses with the springs up to `start` in contact until all are. Springs attach one by one; if one makes others
    /// follow at the same value, that is an instability. Returns all of them in order; one that reaches the last spring
    /// is complete contact.
    ///
    /// # Errors
    /// [`Error::Domain`] unless the stiffness of a machine is positive and finite.
    pub fn press(&self, start: usize, control: &Control<R>) -> Result<Vec<Cascade<R>>> {
        control.check()?;
        let last = self.profile.len() - 1;
        let mut cascades = Vec::new();
        let mut i = start;
        while i < last {
            let value = self.attaching(i, control);
            let mut rest = i + 1;
            while rest < last && self.attaching(rest, control) <= value {
                rest += 1;
            }
            if rest > i + 1 {
                let outcome =
                    if rest == last { Outcome::CompleteContact } else { Outcome::Jump { to: self.position(rest) } };
                cascades.push(self.cascade(i, &self.critical[i + 1], FoldKind::Maximum, outcome));
            }
            i = rest;
        }
        Ok(cascades)
    }

    /// The controlled quantity at which the outermost spring i detaches.
    fn detaching(&self, i: usize, control: &Control<R>) -> R {
        let d = &self.critical[i];
        control.controlled(d, &self.force_on(i, d))
    }

    /// The controlled quantity at which the spring outside the outermost spring i attaches.
    fn attaching(&self, i: usize, control: &Control<R>) -> R {
        let d = &self.critical[i + 1];
        control.controlled(d, &self.force_on(i, d))
    }

    fn cascade(&self, i: usize, d: &R, kind: FoldKind, outcome: Outcome<R>) -> Cascade<R> {
        let instability =
            Fold { contact_radius: self.position(i), indentation: d.clone(), force: self.force_on(i, d), kind };
        Cascade { instability, outcome }
    }
}
