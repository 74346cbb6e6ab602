//! The energy of a path with two works of adhesion.
//!
//! The stored energy is Π = U − w₁A(a): what a contact gains when it advances. In equilibrium it is changed by the work of the
//! control alone while the edge advances or is pinned; while it recedes, w₂ − w₁ is lost for each unit of area, the hysteresis.
//! In a jump at the work of adhesion w the energy ∫(G − w) dA is lost besides. So
//!
//! work = Π(end) − Π(start) + jumps + (w₂ − w₁)·(area receded),
//!
//! and the area receded of a closed path is that which was swept out and back.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Edge, Equilibrium, Error, Quantity, Result};
use mdr_core::number::{Real, Special};

use super::super::energy::{Balance, Dissipation, EnergyIntegrals, spring_energy};
use super::super::{ContactState, Event, EventKind, Path};
use crate::contact::log10_of_product;
use crate::equilibrium::SearchedBranches;

/// The energies of the events of a path that was followed between two [edges](super::Edges).
pub struct EdgeEnergies<'a, R: Special> {
    advancing: EnergyIntegrals<'a, R>,
    receding: EnergyIntegrals<'a, R>,
}

/// What is lost in an event, and on the way to it.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeLoss<R> {
    /// The energy lost in a jump, at the work of adhesion of the edge that drives it.
    pub jump: Dissipation<R>,
    /// (w₂ − w₁) times the area that the edge has receded since the previous event and in this one, in J.
    pub hysteresis: R,
}

/// Checks that two radii of a moving edge differ by more than their roundings.
///
/// # Errors
/// [`Error::Undecided`] where they do not.
fn check_moved<R: Real>(from: &ContactState<R>, to: &ContactState<R>) -> Result<()> {
    let (Some(from), Some(to)) = (from.contact(), to.contact()) else { return Ok(()) };
    let [a, b] = [from, to].map(|rest| &rest.contact_radius);
    if *a > a.lit(0) && (a.clone() - b).abs() <= a.unit_roundoff().times(8) * a {
        return Err(Error::undecided(Quantity::Energy, a, "how far the edge recedes: less than radii are rounded"));
    }
    Ok(())
}

impl<'a, R: Special> EdgeEnergies<'a, R> {
    /// From the branches of each edge.
    pub fn new(advancing: &'a SearchedBranches<R>, receding: &'a SearchedBranches<R>) -> Self {
        EdgeEnergies { advancing: EnergyIntegrals::new(advancing), receding: EnergyIntegrals::new(receding) }
    }

    fn of(&self, edge: Edge) -> &EnergyIntegrals<'a, R> {
        match edge {
            Edge::Advancing => &self.advancing,
            Edge::Receding => &self.receding,
        }
    }

    /// The losses of each event of a path, computed separately, so that one may fail alone.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn losses(&self, path: &Path<R>) -> Vec<Result<EdgeLoss<R>>> {
        let of = |(hysteresis, jump): (Result<R>, Result<_>)| Ok(EdgeLoss { hysteresis: hysteresis?, jump: jump? });
        self.by_receding(path).into_iter().zip(self.by_jumps(path)).map(of).collect()
    }

    /// What is lost in each event itself, as in [`EdgeLoss`]; it is known where what a receding edge loses is not.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn by_jumps(&self, path: &Path<R>) -> Vec<Result<Dissipation<R>>> {
        path.events.iter().map(|event| Ok(self.event(event)?.1)).collect()
    }

    /// What a receding edge loses on the way to each event and in it, as in [`EdgeLoss`]; it is known where the energy of a jump is
    /// not.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if an energy is not representable in this arithmetic; [`Error::Undecided`] where a receding edge has moved less
    /// than radii are rounded.
    pub fn by_receding(&self, path: &Path<R>) -> Vec<Result<R>> {
        let last = path.events.first().into_iter().chain(&path.events);
        let stays = path.stays(self.receding.curve.vertical_edge().as_ref());
        let of = |((last, event), stays): ((&Event<R>, &Event<R>), bool)| {
            if !stays && event.value < last.value {
                check_moved(&last.after, &event.before)?;
            }
            Ok(self.hysteresis(&last.after, &event.before)? + self.hysteresis(&event.before, &event.after)?)
        };
        last.zip(&path.events).zip(stays).map(of).collect()
    }

    /// The increase of the energy stored in the contact and in the spring of a machine along a path, in J; `None` for complete
    /// contact.
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn stored(&self, path: &Path<R>) -> Result<Option<Estimate<R>>> {
        let (Some(first), Some(last)) = (path.events.first(), path.events.last()) else { return Ok(None) };
        let (Some(start), Some(end)) = (self.stored_in(&first.after)?, self.stored_in(&last.after)?) else {
            return Ok(None);
        };
        Ok(Some(Estimate { value: end.value - &start.value, error: start.error + &end.error, evaluations: 0 }))
    }

    /// The balance of the energy of a path; `None` if a term is unbounded. The work is an integral of its own, so that the
    /// balance is a check of the path.
    ///
    /// ```
    /// use mdr_core::contact::{Control, Edge, Shape};
    /// use mdr_numeric::medium::{Adhesion, Medium};
    /// use mdr_numeric::path::{EdgeEnergies, Edges, Path, Start};
    /// use mdr_numeric::{contact::Contact, equilibrium::SearchedBranches, transform::Quadrature};
    /// let ball = Quadrature::of([Shape::Paraboloid { radius: 1.0 }])?;
    /// let adhesion = Adhesion::hysteretic(0.01, 0.04)?;
    /// let contact = Contact::new(ball, Medium::half_space(1.0)?, adhesion, Control::Indentation);
    /// let advancing = SearchedBranches::new(contact.at(Edge::Advancing))?;
    /// let receding = SearchedBranches::new(contact.at(Edge::Receding))?;
    /// let edges = Edges::new(&contact, &advancing, &receding);
    /// let path = Path::follow_edges(&edges, &Start::Detached, &[-0.2, 0.0, -0.2], None)?;
    /// let balance = EdgeEnergies::new(&advancing, &receding).balance(&path)?.expect("nothing unbounded");
    /// // The contact has advanced in one jump, to the radius at d = 0, and has been pulled off from there.
    /// let a = 0.397_551_402_071_898_54_f64;
    /// assert!((balance.hysteresis / (0.03 * std::f64::consts::PI * a * a) - 1.0).abs() < 1e-14);
    /// assert!(balance.residual.abs() <= balance.bound);
    /// # Ok::<(), mdr_core::contact::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the transform and of the quadrature; [`Error::OutOfRange`] if an energy is not representable in this arithmetic.
    pub fn balance(&self, path: &Path<R>) -> Result<Option<Balance<R>>> {
        let Some(stored) = self.stored(path)? else { return Ok(None) };
        let zero = stored.value.lit(0);
        let (mut work, mut dissipated, mut hysteresis) = (zero.clone(), zero.clone(), zero);
        let mut bound = stored.error;
        let mut last: Option<&Event<R>> = None;
        for (event, loss) in path.events.iter().zip(self.losses(path)) {
            let (EdgeLoss { jump, hysteresis: lost }, (at_once, _)) = (loss?, self.event(event)?);
            let Dissipation::Finite(jump) = jump else { return Ok(None) };
            if let Some(last) = last.replace(event) {
                let along = self.work(&last.after, &event.before)?;
                work += &along.value;
                bound += &along.error;
            }
            bound += &(jump.error + lost.abs() * lost.unit_roundoff().times(8) + self.receding.after_jump(event)?);
            work += &at_once;
            dissipated += &jump.value;
            hysteresis += &lost;
        }
        let stored = stored.value;
        let residual = work.clone() - &dissipated - &hysteresis - &stored;
        if !residual.is_finite() {
            return Err(Error::OutOfRange { quantity: Quantity::Energy, log10: work.approx().abs().log10() });
        }
        Ok(Some(Balance { work, dissipated, hysteresis, stored, residual, bound }))
    }

    /// The work of the control between the states of two events.
    fn work(&self, from: &ContactState<R>, to: &ContactState<R>) -> Result<Estimate<R>> {
        let (Some(before), Some(after)) = (from.contact(), to.contact()) else { return Ok(self.receding.none()) };
        if before.contact_radius > after.contact_radius {
            self.receding.work(from, to)
        } else if before.contact_radius < after.contact_radius {
            self.advancing.work(from, to)
        } else {
            self.pinned(before, after)
        }
    }

    /// ∫F dd at a fixed radius, where F is linear in d; on a machine with the energy of its spring.
    fn pinned(&self, from: &Equilibrium<R>, to: &Equilibrium<R>) -> Result<Estimate<R>> {
        let mean_force = (from.force.clone() + &to.force).over(2);
        let mut value = (to.indentation.clone() - &from.indentation) * mean_force;
        let mut error = value.lit(0);
        if value != error {
            let lengths = self.receding.terms(&from.contact_radius)? + from.indentation.abs() + to.indentation.abs();
            let force = self.receding.curve.stiffness(&from.contact_radius) * &lengths;
            error = force.clone() * lengths * force.unit_roundoff().times(64);
        }
        if let Control::Machine { stiffness } = self.receding.curve.control() {
            let [before, after] = [from, to].map(|state| spring_energy(&state.force, stiffness));
            error += &((before.clone() + &after) * before.unit_roundoff().times(64));
            value += &(after - before);
        }
        Ok(Estimate { value, error, evaluations: 0 })
    }

    /// The work of the control in an event, and the energy that is lost in a jump.
    fn event(&self, event: &Event<R>) -> Result<(R, Dissipation<R>)> {
        let falls = event.kind == EventKind::Detached && *self.receding.curve.control() == Control::Force;
        if falls && event.before.contact().is_some_and(|rest| rest.contact_radius > rest.contact_radius.lit(0)) {
            return Ok((event.value.lit(0), Dissipation::Unbounded));
        }
        self.of(event.edge.unwrap_or(Edge::Receding)).event(event)
    }

    /// (w₂ − w₁) times the area between two states, if the edge recedes.
    fn hysteresis(&self, from: &ContactState<R>, to: &ContactState<R>) -> Result<R> {
        let none = self.receding.none().value;
        let Some(from) = from.contact().map(|rest| &rest.contact_radius) else { return Ok(none) };
        let to = match to {
            ContactState::Contact(rest) => rest.contact_radius.clone(),
            ContactState::Detached => none.clone(),
            ContactState::Complete => return Ok(none),
        };
        if *from <= to {
            return Ok(none);
        }
        let adhesion = self.receding.curve.adhesion();
        let loss = adhesion.of(Edge::Receding).clone() - adhesion.of(Edge::Advancing);
        let area = self.area(from)? - self.area(&to)?;
        let energy = loss * &area;
        if energy.is_finite() && (energy.clone() * energy.unit_roundoff() != none || area == none) {
            return Ok(energy);
        }
        let log10 = log10_of_product([adhesion.of(Edge::Receding).clone(), area.abs()]);
        Err(Error::OutOfRange { quantity: Quantity::Energy, log10 })
    }

    /// A(a).
    fn area(&self, a: &R) -> Result<R> {
        let [one, two, three] = self.receding.curve.medium().area_factors(a);
        let area = one * two * three;
        if area.is_finite() {
            return Ok(area);
        }
        let log10 = log10_of_product(self.receding.curve.medium().area_factors(a));
        Err(Error::OutOfRange { quantity: Quantity::Energy, log10 })
    }

    /// Π = U − w₁A, and F²/2k of a machine; `None` for complete contact.
    fn stored_in(&self, state: &ContactState<R>) -> Result<Option<Estimate<R>>> {
        let Some(mut stored) = self.receding.stored(state)? else { return Ok(None) };
        if let Some(rest) = state.contact().filter(|rest| rest.contact_radius > rest.contact_radius.lit(0)) {
            // From U − w₂A, whose unit of length is never 0.
            let adhesion = self.receding.curve.adhesion();
            let more = adhesion.of(Edge::Receding).clone() - adhesion.of(Edge::Advancing);
            let more = more * self.area(&rest.contact_radius)?;
            stored.error += &(more.clone() * more.unit_roundoff().times(8));
            stored.value += &more;
        }
        Ok(Some(stored))
    }
}
