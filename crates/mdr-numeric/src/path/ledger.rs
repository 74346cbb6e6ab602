//! The energy balance of a loading path.
//!
//! The work of the control is ∫F dd along the curve of equilibria, on a machine ∫F dD with its spring, and under
//! controlled force F(d₂ − d₁) in a jump. The energy dissipated in a jump from a₁ to a₂ at a fixed controlled value is
//! E* ∫_{a₂}^{a₁} [(d(a) − g(a))² − Δl(a)²] da, with d(a) the indentation at radius a and that value. The stored
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
use super::{Event, EventKind, Path, State};
use crate::branch::Branched;
use crate::curve::{Curve, log10_of_product, negligible};
use crate::energy::Energy;
use crate::equilibrium::Branches;

/// The energy dissipated in an event.
#[derive(Clone, Debug, PartialEq)]
pub enum Loss<R> {
    /// This energy, in J.
    Finite(Estimate<R>),
    /// More than any number: a body pulled off by a dead load falls without end; on a half-space complete contact
    /// spreads without end.
    Unbounded,
}

/// The energies of one event.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry<R> {
    /// The work done by the control since the previous event, in J.
    pub work: Estimate<R>,
    /// The work done by the control in the event, in J: F(d₂ − d₁) under controlled force, else 0.
    pub work_in_event: R,
    /// The energy dissipated in the event.
    pub lost: Loss<R>,
}

/// The energies of the events of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Ledger<R> {
    /// One for each event of the path.
    pub entries: Vec<Entry<R>>,
}

/// The energy balance of a path, in J.
#[derive(Clone, Debug, PartialEq)]
pub struct Balance<R> {
    /// The work of the control. On a closed path, which ends in its initial state, it equals the dissipation: the
    /// hysteresis of the cycle.
    pub work: R,
    /// The energy dissipated in all events.
    pub lost: R,
    /// The increase of the energy stored in the contact and in the spring of a machine.
    pub stored: R,
    /// work − lost − stored.
    pub residual: R,
    /// A bound of the residual: the estimated errors of the quadratures, and the rounding of their integrands. It
    /// assumes that g, g' and the mean of g are accurate to 64 unit roundoffs.
    pub bound: R,
}

/// Roundings of g, g', the mean of g and quantities derived from them, in unit roundoffs.
const ROUNDINGS: i64 = 64;

impl<R: Real> Ledger<R> {
    /// The energies of a path that was followed on the given branches.
    ///
    /// Each jump is integrated between its own two radii only, in pieces between the folds and kinks there.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Material, Shape};
    /// use mdr_numeric::path::{Ledger, Loss, Path, Start};
    /// use mdr_numeric::{curve::Curve, equilibrium::Branches, transform::Quadrature};
    /// // The paraboloid loses 2/5 of πa²w when it is pulled off at fixed grips.
    /// let (ball, control) = (Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?, Control::Indentation);
    /// let material = Material::new(1.0, 1e-3)?;
    /// let branches = Branches::new(Curve::new(&ball, &material, &control))?;
    /// let path = Path::follow(&branches, &Start::Largest, &[0.0, -0.1])?;
    /// let ledger = Ledger::new(&path, &branches)?;
    /// let Loss::Finite(lost) = &ledger.entries[1].lost else { panic!("finite at fixed grips") };
    /// let a = path.events[1].before.contact().expect("in contact").contact_radius;
    /// assert!((lost.value / (std::f64::consts::PI * a * a * 1e-3) - 0.4).abs() < 1e-13);
    /// let balance = ledger.balance(&path, &branches)?.expect("nothing unbounded");
    /// assert!(balance.residual.abs() <= balance.bound);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this
    /// arithmetic.
    pub fn new(path: &Path<R>, branches: &Branches<'_, R>) -> Result<Self> {
        let books = Books::new(branches);
        let mut entries = Vec::with_capacity(path.events.len());
        let mut last: Option<&Event<R>> = None;
        for event in &path.events {
            let work = match last {
                Some(last) => books.work(&last.after, &event.before)?,
                None => Estimate::exact(event.value.lit(0)),
            };
            let (work_in_event, lost) = books.event(event)?;
            entries.push(Entry { work, work_in_event, lost });
            last = Some(event);
        }
        Ok(Ledger { entries })
    }

    /// The energy balance; `None` if a term is unbounded. It adds the energies stored at the beginning and at the end
    /// of the path, integrals over the whole contact.
    ///
    /// # Errors
    /// As [`Ledger::new`].
    pub fn balance(&self, path: &Path<R>, branches: &Branches<'_, R>) -> Result<Option<Balance<R>>> {
        Books::new(branches).balance(path, &self.entries)
    }
}

/// The increase of the energy stored in the contact and in the spring of a machine along a path, in J; `None` for
/// complete contact.
///
/// # Errors
/// As [`Ledger::new`].
pub fn stored<R: Real>(path: &Path<R>, branches: &Branches<'_, R>) -> Result<Option<Estimate<R>>> {
    Books::new(branches).more_stored(path)
}

impl<R: Real> Loss<R> {
    /// The energies of the events of a path, computed separately, so that one may fail alone.
    ///
    /// # Errors
    /// As [`Ledger::new`].
    pub fn of_each(path: &Path<R>, branches: &Branches<'_, R>) -> Vec<Result<Self>> {
        let books = Books::new(branches);
        path.events.iter().map(|event| Ok(books.event(event)?.1)).collect()
    }
}

struct Books<'a, 'c, R: Real> {
    curve: &'a Curve<'c, R>,
    breaks: Breaks<R>,
}

impl<'a, 'c, R: Real> Books<'a, 'c, R> {
    fn new(branches: &'a Branches<'c, R>) -> Self {
        let folds = branches.folds().iter().map(|fold| fold.contact_radius.clone());
        let curve = branches.curve();
        Books { curve, breaks: Breaks::new(curve.transform(), folds) }
    }

    /// The work of the control between two states on one branch.
    fn work(&self, from: &State<R>, to: &State<R>) -> Result<Estimate<R>> {
        let (State::Contact(from), State::Contact(to)) = (from, to) else { return Ok(self.none()) };
        let mut work = self.along_curve(&from.contact_radius, &to.contact_radius)?;
        if let Some(wall) = self.curve.wall() {
            // At a vertical edge the contact is a linear spring from the end of the curve on.
            let corner = self.curve.state(&wall)?;
            for (state, sign) in [(from, -1), (to, 1)] {
                if state.contact_radius == wall {
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
        let slopes = |a: &R| -> Result<(R, R)> {
            Ok((self.curve.transform().slope(a)?, self.curve.elongation(a) / a.clone().times(2)))
        };
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
    fn event(&self, event: &Event<R>) -> Result<(R, Loss<R>)> {
        let zero = event.value.lit(0);
        let dead_load = *self.curve.control() == Control::Force;
        match event.kind {
            EventKind::CompleteContact => Ok((zero, Loss::Unbounded)),
            EventKind::Detached if dead_load && event.fold.is_some() => Ok((zero, Loss::Unbounded)),
            EventKind::Jump | EventKind::JumpIn | EventKind::Detached => {
                let lost = self.lost(&event.before, &event.after, &event.value)?;
                let work = match (&event.before, &event.after) {
                    (State::Contact(before), State::Contact(after)) if dead_load => {
                        (after.indentation.clone() - &before.indentation) * &event.value
                    }
                    _ => zero,
                };
                Ok((work, Loss::Finite(lost)))
            }
            _ => Ok((zero, Loss::Finite(self.none()))),
        }
    }

    /// E* ∫_{a₂}^{a₁} δ(δ + 2Δl) da with the direction of change δ = g − d − Δl at the fixed value.
    fn lost(&self, before: &State<R>, after: &State<R>, value: &R) -> Result<Estimate<R>> {
        let radius = |state: &State<R>| state.contact().map_or(value.lit(0), |rest| rest.contact_radius.clone());
        let (from, to) = (radius(after), radius(before));
        if from == to {
            return Ok(self.none());
        }
        // In units of Δl at the larger end: the product of two small lengths may underflow where the energy does not.
        let unit = self.curve.elongation(if from > to { &from } else { &to });
        let needed = negligible(&unit);
        let lost = self.breaks.integrate(&from, &to, |a| {
            let change = self.curve.direction_within(a, value, &needed)?;
            Ok((self.curve.elongation(a).times(2) + &change) / &unit * (change / &unit))
        })?;
        let size = self.breaks.roughly(&from, &to, |a| {
            let change = self.curve.direction_within(a, value, &needed)?.abs() + self.curve.elongation(a);
            let held = self.curve.held_against(a, value, || self.curve.transform().mean_within(a, &needed))?;
            let lengths = self.terms_near_kinks(a, &needed)? + held.abs();
            Ok(change / &unit * (lengths / &unit))
        })?;
        let energy = |length: &R| self.energy(length, &unit);
        let error = energy(&lost.error) + energy(&size.abs()) * size.unit_roundoff().times(2 * ROUNDINGS);
        let value = energy(&lost.value);
        if lost.value != value.lit(0) && value.unit_roundoff() * &value == value.lit(0) {
            let log10 = log10_of_product([self.curve.effective_modulus().clone(), lost.value, unit.clone(), unit]);
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10 });
        }
        Ok(Estimate { value, error, evaluations: lost.evaluations })
    }

    /// E* times a length and the square of `unit`, in an order that avoids underflow of small lengths.
    fn energy(&self, length: &R, unit: &R) -> R {
        self.curve.effective_modulus().clone() * unit * length * unit
    }

    /// The magnitude of the lengths that make up d and the force at radius `a`, including the rounding of a itself.
    fn terms(&self, a: &R) -> Result<R> {
        self.terms_with(a, &a.lit(1), &a.lit(0))
    }

    /// The same if g' may have an inverse root or a pole at a kink: there g varies over the distance from it instead of
    /// the radius, and the accumulated rounding is bounded.
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
    fn rounding(&self, size: R) -> R {
        size.abs() * size.unit_roundoff().times(ROUNDINGS) * self.curve.effective_modulus()
    }

    fn balance(&self, path: &Path<R>, entries: &[Entry<R>]) -> Result<Option<Balance<R>>> {
        let Some(stored) = self.more_stored(path)? else { return Ok(None) };
        let (mut work, mut lost, mut bound) = (stored.value.lit(0), stored.value.lit(0), stored.error);
        for (entry, event) in entries.iter().zip(&path.events) {
            let Loss::Finite(loss) = &entry.lost else { return Ok(None) };
            work += &(entry.work.value.clone() + &entry.work_in_event);
            lost += &loss.value;
            bound += &(entry.work.error.clone() + &loss.error + self.landing(event)?);
        }
        let stored = stored.value;
        let residual = work.clone() - &lost - &stored;
        if !residual.is_finite() {
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10: work.approx().abs().log10() });
        }
        Ok(Some(Balance { work, lost, stored, residual, bound }))
    }

    /// The effect of the rounding of d in the states of an event: the force times that rounding.
    fn landing(&self, event: &Event<R>) -> Result<R> {
        let mut total = event.value.lit(0);
        for state in [&event.before, &event.after] {
            if let Some(rest) = state.contact().filter(|rest| rest.contact_radius > total.lit(0)) {
                let stiffness = rest.contact_radius.clone().times(2);
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
    fn stored(&self, state: &State<R>) -> Result<Option<Estimate<R>>> {
        let rest = match state {
            State::Contact(rest) if rest.contact_radius > rest.contact_radius.lit(0) => rest,
            State::Contact(_) | State::Detached => return Ok(Some(self.none())),
            State::Complete => return Ok(None),
        };
        let a = &rest.contact_radius;
        let energy = Energy::new(self.curve.transform(), self.curve.material())?;
        // Piece by piece between the folds, because thousands of waves are too many for one rule.
        let mut error = a.lit(0);
        let mut value = energy.potential_by(a, &rest.indentation, |square| {
            let integral = self.breaks.integrate(&a.lit(0), a, square)?;
            error = integral.error;
            Ok(integral.value / a)
        })?;
        // In units of Δl(a)² = 2πaw/E*.
        error *= &(self.curve.elongation(a).square() * self.curve.effective_modulus());
        let lengths = self.terms(a)? + rest.indentation.abs();
        error += &self.rounding(lengths.square() * a);
        if let Control::Machine { stiffness } = self.curve.control() {
            let spring = spring_energy(&rest.force, stiffness);
            error += &(spring.unit_roundoff().times(ROUNDINGS) * &spring);
            value += &spring;
        }
        Ok(Some(Estimate { value, error, evaluations: 0 }))
    }

    fn none(&self) -> Estimate<R> {
        Estimate::exact(self.curve.effective_modulus().lit(0))
    }
}

/// F²/2k.
fn spring_energy<R: Real>(force: &R, stiffness: &R) -> R {
    force.clone() / stiffness * force.clone().over(2)
}
