//! The energy balance of a loading path.
//!
//! The work of the control is ∫F dd along the curve of equilibria, on a machine ∫F dD with its spring, and under
//! controlled force F(d₂ − d₁) in a jump. The energy dissipated in a jump from a₁ to a₂ at a fixed controlled value is
//! ½∫_{a₂}^{a₁} S'(a) [(d(a) − g(a))² − Δl(a)²] da, with d(a) the indentation at radius a and that value. The stored
//! energy, Π(a, d) and F²/2k in the spring, is an integral over the whole contact. The three are computed from
//! different integrands, so that
//!
//! work − lost = Π(end) − Π(start)
//!
//! is a check of the path; its residual is compared with a bound.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Equilibrium, Error, Quantity, Result};
use mdr_core::number::Real;

use super::integral::Breaks;
use super::{ContactState, Event, EventKind, Path};
use crate::branch::EquilibriumBranches;
use crate::contact::{Contact, log10_of_product, negligible};
use crate::energy::Energy;
use crate::equilibrium::SearchedBranches;

/// The energy dissipated in an event.
#[derive(Clone, Debug, PartialEq)]
pub enum Dissipation<R> {
    /// A finite energy, in J.
    Finite(Estimate<R>),
    /// More than any number: a body pulled off by a dead load falls without end; on a half-space complete contact
    /// spreads without end.
    Unbounded,
}

/// The energies of one event.
#[derive(Clone, Debug, PartialEq)]
pub struct EventEnergy<R> {
    /// The work done by the control since the previous event, in J.
    pub work: Estimate<R>,
    /// The work done by the control in the event, in J: F(d₂ − d₁) under controlled force, else 0.
    pub work_in_event: R,
    /// The energy dissipated in the event.
    pub dissipated: Dissipation<R>,
}

/// The energies of the events of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathEnergy<R> {
    /// The energies of the events, one entry for each event of the path.
    pub entries: Vec<EventEnergy<R>>,
}

/// The energy balance of a path, in J.
#[derive(Clone, Debug, PartialEq)]
pub struct Balance<R> {
    /// The work of the control. On a closed path, which ends in its initial state, it equals the dissipation: the
    /// hysteresis of the cycle.
    pub work: R,
    /// The energy dissipated in all events; with two works of adhesion, in all jumps.
    pub dissipated: R,
    /// The energy lost by an edge that recedes at more work than it gained, (w₂ − w₁) times the area; 0 with one work of adhesion.
    pub hysteresis: R,
    /// The increase of the energy stored in the contact and in the spring of a machine.
    pub stored: R,
    /// work − dissipated − hysteresis − stored.
    pub residual: R,
    /// A bound of the residual: the estimated errors of the quadratures, and the rounding of their integrands. It
    /// assumes that g, g' and the mean of g are accurate to 64 unit roundoffs.
    pub bound: R,
}

/// Roundings of g, g', the mean of g and quantities derived from them, in unit roundoffs.
pub(super) const ROUNDINGS: i64 = 64;

impl<R: Real> PathEnergy<R> {
    /// The energies of a path that was followed on the given branches.
    ///
    /// Each jump is integrated between its own two radii only, in pieces between the folds and kinks there.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use mdr_core::contact::{Control, Material, Shape};
    /// use mdr_numeric::path::{PathEnergy, Dissipation, Path, Start};
    /// use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
    /// // The paraboloid loses 2/5 of πa²w when it is pulled off at fixed grips.
    /// let (ball, control) = (Arc::new(Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?), Control::Indentation);
    /// let material = Material::new(1.0, 1e-3)?;
    /// let branches = SearchedBranches::new(Contact::half_space(&ball, &material, &control))?;
    /// let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.1])?;
    /// let energies = PathEnergy::new(&path, &branches)?;
    /// let Dissipation::Finite(lost) = &energies.entries[1].dissipated else { panic!("finite at fixed grips") };
    /// let a = path.events[1].before.contact().expect("in contact").contact_radius;
    /// assert!((lost.value / (std::f64::consts::PI * a * a * 1e-3) - 0.4).abs() < 1e-13);
    /// let balance = energies.balance(&path, &branches)?.expect("nothing unbounded");
    /// assert!(balance.residual.abs() <= balance.bound);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn new(path: &Path<R>, branches: &SearchedBranches<R>) -> Result<Self> {
        let integrals = EnergyIntegrals::new(branches);
        let mut entries = Vec::with_capacity(path.events.len());
        let mut last: Option<&Event<R>> = None;
        for event in &path.events {
            let work = match last {
                Some(last) => integrals.work(&last.after, &event.before)?,
                None => Estimate::exact(event.value.lit(0)),
            };
            let (work_in_event, dissipated) = integrals.event(event)?;
            entries.push(EventEnergy { work, work_in_event, dissipated });
            last = Some(event);
        }
        Ok(PathEnergy { entries })
    }

    /// The energy balance; `None` if a term is unbounded. It adds the energies stored at the beginning and at the end
    /// of the path, integrals over the whole contact.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn balance(&self, path: &Path<R>, branches: &SearchedBranches<R>) -> Result<Option<Balance<R>>> {
        EnergyIntegrals::new(branches).balance(path, &self.entries)
    }
}

/// The increase of the energy stored in the contact and in the spring of a machine along a path, in J; `None` for
/// complete contact.
///
/// # Errors
/// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
pub fn stored<R: Real>(path: &Path<R>, branches: &SearchedBranches<R>) -> Result<Option<Estimate<R>>> {
    EnergyIntegrals::new(branches).more_stored(path)
}

impl<R: Real> Dissipation<R> {
    /// The energies of the events of a path, computed separately, so that one may fail alone.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn of_each(path: &Path<R>, branches: &SearchedBranches<R>) -> Vec<Result<Self>> {
        let integrals = EnergyIntegrals::new(branches);
        path.events.iter().map(|event| Ok(integrals.event(event)?.1)).collect()
    }
}

pub(super) struct EnergyIntegrals<'a, R: Real> {
    pub(super) curve: &'a Contact<R>,
    breaks: Breaks<R>,
}

impl<'a, R: Real> EnergyIntegrals<'a, R> {
    pub(super) fn new(branches: &'a SearchedBranches<R>) -> Self {
        let folds = branches.folds().iter().map(|fold| fold.contact_radius.clone());
        let curve = branches.curve();
        EnergyIntegrals { curve, breaks: Breaks::new(curve.transform(), folds) }
    }

    /// The work of the control between two states on one branch.
    pub(super) fn work(&self, from: &ContactState<R>, to: &ContactState<R>) -> Result<Estimate<R>> {
        let (ContactState::Contact(from), ContactState::Contact(to)) = (from, to) else { return Ok(self.none()) };
        let mut work = self.along_curve(&from.contact_radius, &to.contact_radius)?;
        if let Some(outer_edge) = self.curve.vertical_edge() {
            // At a vertical edge the contact is a linear spring from the end of the curve on.
            let corner = self.curve.state(&outer_edge)?;
            for (state, sign) in [(from, -1), (to, 1)] {
                if state.contact_radius == outer_edge {
                    let mean_force = (corner.1.clone() + &state.force).over(2);
                    let along = (state.indentation.clone() - &corner.0) * mean_force;
                    work.error += &(along.abs() * along.unit_roundoff().times(ROUNDINGS));
                    work.value += &along.times(sign);
                }
            }
        }
        if let Control::Machine { stiffness } = self.curve.control() {
            let spring = |state: &Equilibrium<R>| spring_energy(&state.force, stiffness);
            let (before, after) = (spring(from), spring(to));
            work.error += &((before.clone() + &after) * before.unit_roundoff().times(ROUNDINGS));
            work.value += &(after - before);
        }
        Ok(work)
    }

    /// ∫F dd = ∫F(a) (g' − Δl') da.
    fn along_curve(&self, from: &R, to: &R) -> Result<Estimate<R>> {
        if from == to {
            return Ok(self.none());
        }
        let slopes =
            |a: &R| -> Result<(R, R)> { Ok((self.curve.transform().slope(a)?, self.curve.elongation_slope(a))) };
        let mut work = self.breaks.integrate(from, to, |a| {
            let (rise, fall) = slopes(a)?;
            Ok(self.curve.force(a)? * (rise - fall))
        })?;
        let size = self.breaks.roughly(from, to, |a| {
            let (rise, fall) = slopes(a)?;
            Ok(self.terms_near_kinks(a, &a.lit(0))? * a * (rise.abs() + fall))
        })?;
        work.error += &self.rounding(size.times(2));
        Ok(work)
    }

    /// The work of the control in an event, and the dissipated energy.
    pub(super) fn event(&self, event: &Event<R>) -> Result<(R, Dissipation<R>)> {
        let zero = event.value.lit(0);
        let dead_load = *self.curve.control() == Control::Force;
        match event.kind {
            EventKind::CompleteContact if self.complete()?.is_some() => self.completed(&event.before, &event.value),
            EventKind::CompleteContact => Ok((zero, Dissipation::Unbounded)),
            EventKind::Detached if dead_load && event.fold.is_some() => Ok((zero, Dissipation::Unbounded)),
            EventKind::Jump | EventKind::JumpIn | EventKind::Detached => {
                let dissipated = self.dissipated(&event.before, &event.after, &event.value)?;
                let work = match (&event.before, &event.after) {
                    (ContactState::Contact(before), ContactState::Contact(after)) if dead_load => {
                        (after.indentation.clone() - &before.indentation) * &event.value
                    }
                    _ => zero,
                };
                Ok((work, Dissipation::Finite(dissipated)))
            }
            _ => Ok((zero, Dissipation::Finite(self.none()))),
        }
    }

    /// E* ∫_{a₂}^{a₁} δ(δ + 2Δl) da with the direction of change δ = g − d − Δl at the fixed value.
    pub(super) fn dissipated(
        &self,
        before: &ContactState<R>,
        after: &ContactState<R>,
        value: &R,
    ) -> Result<Estimate<R>> {
        let radius = |state: &ContactState<R>| state.contact().map_or(value.lit(0), |rest| rest.contact_radius.clone());
        let (from, to) = (radius(after), radius(before));
        if from == to {
            return Ok(self.none());
        }
        if from == from.lit(0) || to == to.lit(0) {
            let medium = self.curve.medium();
            if medium.period().is_some() {
                return self.difference(before, after, value);
            }
            if medium.outer_size().is_some() {
                let requirement =
                    "left out: against a reference it is not available for a line contact that opens or closes";
                return Err(Error::domain(Quantity::Parameter("the energy lost"), value, requirement));
            }
        }
        // In units of Δl at the larger end: the product of two small lengths may underflow where the energy does not.
        let unit = self.curve.unit_elongation(if from > to { &from } else { &to });
        let needed = negligible(&unit);
        let dissipated = self.breaks.integrate(&from, &to, |a| {
            let change = self.curve.direction_within(a, value, &needed)?;
            let square = (self.curve.elongation(a).times(2) + &change) / &unit * (change / &unit);
            Ok(self.curve.medium().weighted(a, square))
        })?;
        let size = self.breaks.roughly(&from, &to, |a| {
            let change = self.curve.direction_within(a, value, &needed)?.abs() + self.curve.elongation(a);
            let held = self.curve.held_against(a, value, || self.curve.transform().mean_within(a, &needed))?;
            let lengths = self.terms_near_kinks(a, &needed)? + held.abs();
            Ok(self.curve.medium().weighted(a, change / &unit * (lengths / &unit)))
        })?;
        let energy = |length: &R| self.energy(length, &unit);
        let error = energy(&dissipated.error) + energy(&size.abs()) * size.unit_roundoff().times(2 * ROUNDINGS);
        let value = energy(&dissipated.value);
        if dissipated.value != value.lit(0) && value.unit_roundoff() * &value == value.lit(0) {
            let log10 = log10_of_product([self.curve.modulus().clone(), dissipated.value, unit.clone(), unit]);
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10 });
        }
        Ok(Estimate { value, error, evaluations: dissipated.evaluations })
    }

    /// E* times a length and the square of `unit`, in an order that avoids underflow of small lengths.
    fn energy(&self, length: &R, unit: &R) -> R {
        self.curve.modulus().clone() * unit * length * unit
    }

    /// The magnitude of the lengths that make up d and the force at radius `a`, including the rounding of a itself.
    pub(super) fn terms(&self, a: &R) -> Result<R> {
        self.terms_with(a, &a.lit(1), &a.lit(0))
    }

    /// The magnitude of the lengths that make up d and the force at radius `a`, if g' may have an inverse root or a pole at a
    /// kink: there g varies over the distance from the kink instead of the radius, and the accumulated rounding is bounded.
    fn terms_near_kinks(&self, a: &R, needed: &R) -> Result<R> {
        self.terms_with(a, &self.breaks.clearance(a).sqrt(), needed)
    }

    fn terms_with(&self, a: &R, share_of_rise: &R, needed: &R) -> Result<R> {
        let transform = self.curve.transform();
        let rise = transform.slope(a)? * a * share_of_rise;
        let lengths = transform.g_within(a, needed)?.abs() + transform.mean_within(a, needed)?.abs();
        Ok(lengths + rise.abs() + self.curve.elongation(a))
    }

    /// The rounding of an energy E*·`size`.
    pub(super) fn rounding(&self, size: R) -> R {
        size.abs() * size.unit_roundoff().times(ROUNDINGS) * self.curve.modulus()
    }

    fn balance(&self, path: &Path<R>, entries: &[EventEnergy<R>]) -> Result<Option<Balance<R>>> {
        let Some(stored) = self.more_stored(path)? else { return Ok(None) };
        let (mut work, mut dissipated, mut bound) = (stored.value.lit(0), stored.value.lit(0), stored.error);
        for (entry, event) in entries.iter().zip(&path.events) {
            let Dissipation::Finite(loss) = &entry.dissipated else { return Ok(None) };
            work += &(entry.work.value.clone() + &entry.work_in_event);
            dissipated += &loss.value;
            bound += &(entry.work.error.clone() + &loss.error + self.after_jump(event)?);
        }
        let stored = stored.value;
        let residual = work.clone() - &dissipated - &stored;
        if !residual.is_finite() {
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10: work.approx().abs().log10() });
        }
        let hysteresis = residual.lit(0);
        Ok(Some(Balance { work, dissipated, hysteresis, stored, residual, bound }))
    }

    /// The effect of the rounding of d in the states of an event: the force times that rounding.
    pub(super) fn after_jump(&self, event: &Event<R>) -> Result<R> {
        let mut total = event.value.lit(0);
        for state in [&event.before, &event.after] {
            if let Some(rest) = state.contact().filter(|rest| rest.contact_radius > total.lit(0)) {
                let stiffness = self.curve.medium().reduced_stiffness(&rest.contact_radius);
                let lengths = self.terms(&rest.contact_radius)? + rest.indentation.abs();
                total += &self.rounding(stiffness * lengths.square());
            }
        }
        Ok(total)
    }

    /// The increase of the stored energy along a path; `None` for complete contact.
    fn more_stored(&self, path: &Path<R>) -> Result<Option<Estimate<R>>> {
        let (Some(first), Some(last)) = (path.events.first(), path.events.last()) else { return Ok(None) };
        let (Some(start), Some(end)) = (self.stored(&first.after)?, self.stored(&last.after)?) else {
            return Ok(None);
        };
        let evaluations = start.evaluations + end.evaluations;
        Ok(Some(Estimate { value: end.value - &start.value, error: start.error + &end.error, evaluations }))
    }

    /// Π, and F²/2k of a machine; `None` for complete contact.
    pub(super) fn stored(&self, state: &ContactState<R>) -> Result<Option<Estimate<R>>> {
        let rest = match state {
            ContactState::Contact(rest) if rest.contact_radius > rest.contact_radius.lit(0) => rest,
            ContactState::Contact(_) | ContactState::Detached => return Ok(Some(self.none())),
            ContactState::Complete => return Ok(None),
        };
        if !self.curve.medium().has_energy() {
            return Ok(None);
        }
        if self.curve.medium().period().is_some() {
            return self.total(state, None).map(Some);
        }
        let a = &rest.contact_radius;
        let energy = Energy::new(self.curve.clone())?;
        // Piece by piece between the folds, because thousands of waves are too many for one rule.
        let mut error = a.lit(0);
        let mut value = energy.potential_by(a, &rest.indentation, |square| {
            let integral = self.breaks.integrate(&a.lit(0), a, square)?;
            error = integral.error;
            Ok(integral.value / a)
        })?;
        // In units of Δl(a)² times half of S'.
        error *= &self.curve.medium().weighted(a, self.curve.elongation(a).square() * self.curve.modulus());
        let lengths = self.terms(a)? + rest.indentation.abs();
        error += &self.rounding(self.curve.medium().weighted(a, lengths.square() * a));
        if let Control::Machine { stiffness } = self.curve.control() {
            let spring = spring_energy(&rest.force, stiffness);
            error += &(spring.unit_roundoff().times(ROUNDINGS) * &spring);
            value += &spring;
        }
        Ok(Some(Estimate { value, error, evaluations: 0 }))
    }

    pub(super) fn none(&self) -> Estimate<R> {
        Estimate::exact(self.curve.modulus().lit(0))
    }
}

/// F²/2k.
pub(super) fn spring_energy<R: Real>(force: &R, stiffness: &R) -> R {
    force.clone() / stiffness * force.clone().over(2)
}
