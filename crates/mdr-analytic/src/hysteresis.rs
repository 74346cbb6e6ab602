//! Two works of adhesion, w₁ of an edge that advances and w₂ of one that recedes, for power laws with n > 1/2.
//!
//! The edge is pinned while Δl₁ < g − d < Δl₂. A contact breaks at the fold of w₂ if its radius is at least that of this fold;
//! a smaller one breaks as soon as its edge is set free, with the force of w₂ at its own radius: the pull-off force depends on
//! the preload. An advancing edge of w₁ = s²w₂ has at the radius of that fold the load that is needed.

use mdr_core::contact::{Control, Error, Material, Quantity, Regime, Result};
use mdr_core::number::Real;

use crate::contact::PowerLawContact;
use crate::state::State;

/// The energies lost in a loop under controlled indentation, in J; the work of the loop is their sum.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopWork<R> {
    /// Lost in the jump into contact at d = 0, driven by w₁.
    pub jump_in: R,
    /// (w₂ − w₁)πa², with a the radius at the reversal: lost by the receding edge.
    pub hysteresis: R,
    /// Lost in the pull-off, driven by w₂.
    pub pull_off: R,
}

/// The least ratio w₁/w₂ at which a power law that is pressed by nothing, F = 0 or d = 0, has its full pull-off: 9/(4(n+1)²)
/// under a dead load, 1/(4n²) under fixed grips.
///
/// ```
/// use mdr_analytic::least_ratio_for_full_pull_off;
/// use mdr_core::contact::Control;
/// assert_eq!(least_ratio_for_full_pull_off(&2.0, &Control::Force)?, 0.25); // a paraboloid
/// assert_eq!(least_ratio_for_full_pull_off(&1.0, &Control::Force)?, 0.5625); // a cone
/// assert_eq!(least_ratio_for_full_pull_off(&2.0, &Control::Indentation)?, 0.0625);
/// # Ok::<(), mdr_core::contact::Error>(())
/// ```
///
/// # Errors
/// [`Error::Domain`] unless n > 1/2, and on a machine, where it depends on the stiffness.
pub fn least_ratio_for_full_pull_off<R: Real>(exponent: &R, control: &Control<R>) -> Result<R> {
    if !(*exponent > exponent.ratio(1, 2) && exponent.is_finite()) {
        return Err(Error::domain(Quantity::Exponent, exponent, "finite and above 1/2 for a contact that breaks"));
    }
    let [lambda, double] = touched(exponent, control)?;
    Ok((lambda / double).square())
}

impl<R: Real> PowerLawContact<R> {
    /// The load from which the full pull-off follows if an advancing edge gains w₁ = `advancing` and the work of adhesion of this
    /// contact is w₂: |F_F|(3 − 2(n+1)s)/(2n − 1) in N under a dead load, |d_c|(1 − 2ns)/(2n − 1) in m under fixed grips,
    /// s = √(w₁/w₂). A load below zero means that touching is enough.
    ///
    /// ```
    /// use mdr_analytic::{PowerLaw, PowerLawContact};
    /// use mdr_core::contact::{Control, Material};
    /// let ball = PowerLawContact::new(PowerLaw::new(2.0, 0.5)?, Material::new(1.0, 0.04)?);
    /// // 3πw₂R(1/2 − √(w₁/w₂)).
    /// let load = ball.preload_for_full_pull_off(&0.0025, &Control::Force)?;
    /// assert!((load / (0.12 * std::f64::consts::PI * 0.25) - 1.0).abs() < 1e-14);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless n > 1/2 and 0 ≤ w₁ ≤ w₂, and on a machine; [`Error::OutOfRange`].
    pub fn preload_for_full_pull_off(&self, advancing: &R, control: &Control<R>) -> Result<R> {
        self.require_pull_off()?;
        let ratio = self.ratio_to(advancing)?.sqrt();
        let [lambda, double] = touched(self.profile().exponent(), control)?;
        let critical = self.critical(control)?;
        let value = if *control == Control::Force { critical.force } else { critical.indentation };
        Ok(-value / self.profile().excess() * (lambda - double * &ratio))
    }

    /// The state in which a contact breaks that was pressed to the radius a: the critical state if a is at least its radius,
    /// else that of the equilibrium with a, d = g − Δl and F = 2E*(ad − ∫g). The work of adhesion of this contact is that of the
    /// receding edge.
    ///
    /// ```
    /// use mdr_analytic::{PowerLaw, PowerLawContact};
    /// use mdr_core::contact::{Control, Material};
    /// let ball = PowerLawContact::new(PowerLaw::new(2.0, 0.5)?, Material::new(1.0, 0.04)?);
    /// let breaks = ball.pull_off_from(&0.2, &Control::Force)?;
    /// assert!((breaks.force / -0.079_013_192_795_700_19 - 1.0).abs() < 1e-14);
    /// assert_eq!(ball.pull_off_from(&1.0, &Control::Force)?, ball.critical(&Control::Force)?);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless n > 1/2 and a is positive and finite; [`Error::Undecided`] if the order of the two radii is not
    /// certain; [`Error::OutOfRange`].
    pub fn pull_off_from(&self, radius: &R, control: &Control<R>) -> Result<State<R>> {
        if self.reaches_fold(radius, control)? {
            return self.critical(control);
        }
        let (indentation, force) = (self.indentation(radius)?, self.force(radius)?);
        Ok(State { contact_radius: radius.clone(), indentation, force })
    }

    /// The energies lost under controlled indentation from first touch to a reversal at the radius a and back, if an advancing
    /// edge gains w₁ = `advancing`, which may be 0, and the work of adhesion of this contact is w₂.
    ///
    /// ```
    /// use mdr_analytic::{PowerLaw, PowerLawContact};
    /// use mdr_core::contact::Material;
    /// let ball = PowerLawContact::new(PowerLaw::new(2.0, 0.5)?, Material::new(1.0, 0.04)?);
    /// let lost = ball.loop_work(&0.01, &0.45)?;
    /// assert!((lost.jump_in / 0.002_979_117_975_583_265 - 1.0).abs() < 1e-14);
    /// assert!((lost.hysteresis / 0.019_085_175_370_557_934 - 1.0).abs() < 1e-14);
    /// assert!((lost.pull_off / 0.003_152_703_338_918_832 - 1.0).abs() < 1e-14);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Domain`] unless n > 1/2, 0 ≤ w₁ ≤ w₂ and a is finite and at least the radius after the jump into contact;
    /// [`Error::Undecided`] if the order of radii is not certain; [`Error::OutOfRange`].
    pub fn loop_work(&self, advancing: &R, radius: &R) -> Result<LoopWork<R>> {
        self.require_pull_off()?;
        let share = radius.lit(1) - self.ratio_to(advancing)?;
        let radius = Error::require_positive(Quantity::ContactRadius, radius.clone())?;
        let jump_in = if *advancing > radius.lit(0) {
            let material = Material::new(self.material().effective_modulus().clone(), advancing.clone())?;
            let inward = PowerLawContact::new(self.profile().clone(), material);
            if radius < inward.radius_at_zero_indentation()? {
                let requirement = "at least the radius after the jump into contact";
                return Err(Error::domain(Quantity::ContactRadius, &radius, requirement));
            }
            inward.energy_lost_at_jump_in()?
        } else {
            radius.lit(0)
        };
        let pull_off = if self.reaches_fold(&radius, &Control::Indentation)? {
            self.energy_lost_at_pull_off()?
        } else {
            self.energy(&radius, &self.indentation(&radius)?)?
        };
        let hysteresis = share * self.material().work_of_adhesion() * radius.pi() * radius.square();
        Ok(LoopWork { jump_in, hysteresis, pull_off })
    }

    fn require_pull_off(&self) -> Result<()> {
        self.require(&[Regime::PullOff], "above 1/2 for a contact that breaks")
    }

    /// Whether a contact of this radius passes the fold when it shrinks.
    fn reaches_fold(&self, radius: &R, control: &Control<R>) -> Result<bool> {
        self.require_pull_off()?;
        let radius = Error::require_positive(Quantity::ContactRadius, radius.clone())?;
        let fold = self.critical(control)?.contact_radius;
        match radius.partial_cmp(&fold) {
            Some(order) => Ok(order.is_ge()),
            None => Err(Error::undecided(Quantity::ContactRadius, &radius, "whether it is below that of the fold")),
        }
    }

    /// w₁/w₂, at most 1.
    fn ratio_to(&self, advancing: &R) -> Result<R> {
        let receding = self.material().work_of_adhesion();
        if *advancing >= advancing.lit(0) && advancing <= receding {
            return Ok(advancing.clone() / receding);
        }
        let requirement = "of an advancing edge at least 0 and at most that of the receding one";
        Err(Error::domain(Quantity::WorkOfAdhesion, advancing, requirement))
    }
}

/// λ of the fold, N a^(n−1/2) = λ√B, and that of the contact which is pressed by nothing: 3 and 2(n + 1) under a dead load, 1
/// and 2n under fixed grips.
fn touched<R: Real>(exponent: &R, control: &Control<R>) -> Result<[R; 2]> {
    match control {
        Control::Indentation => Ok([exponent.lit(1), exponent.clone().times(2)]),
        Control::Force => Ok([exponent.lit(3), (exponent.lit(1) + exponent).times(2)]),
        Control::Machine { stiffness } => {
            let requirement = "absent: on a machine what is needed depends on the stiffness; follow the path";
            Err(Error::domain(Quantity::Stiffness, stiffness, requirement))
        }
    }
}
