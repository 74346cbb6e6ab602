//! Energies of a path on a periodic medium, where a contact may become complete: differences of potential energies.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Result};
use mdr_core::number::Real;

use super::ContactState;
use super::energy::{Dissipation, EnergyIntegrals, ROUNDINGS, spring_energy};
use crate::energy::{Complete, Energy};

impl<R: Real> EnergyIntegrals<'_, R> {
    /// The complete contact of a periodic medium.
    pub(super) fn complete(&self) -> Result<Option<Complete<R>>> {
        self.curve.medium().period().map(|wavelength| Complete::of(self.curve, wavelength)).transpose()
    }

    /// The work of a dead load in the jump to complete contact, and the energy lost in it.
    pub(super) fn completed(&self, before: &ContactState<R>, value: &R) -> Result<(R, Dissipation<R>)> {
        let lost = self.difference(before, &ContactState::Complete, value)?;
        let work = match (self.curve.control(), self.complete()?, before.contact()) {
            (Control::Force, Some(complete), Some(before)) => (complete.indentation - &before.indentation) * value,
            _ => value.lit(0),
        };
        Ok((work, Dissipation::Finite(lost)))
    }

    /// The energy lost between two states at a fixed value, as a difference of potential energies.
    pub(super) fn difference(
        &self,
        before: &ContactState<R>,
        after: &ContactState<R>,
        value: &R,
    ) -> Result<Estimate<R>> {
        let (before, after) = (self.total(before, Some(value))?, self.total(after, Some(value))?);
        Ok(Estimate { value: before.value - &after.value, error: before.error + &after.error, evaluations: 0 })
    }

    /// Π of a state of a periodic medium with F²/2K of a machine, and at a fixed value with that of a dead load, −Fd.
    pub(super) fn total(&self, state: &ContactState<R>, value: Option<&R>) -> Result<Estimate<R>> {
        let zero = self.curve.modulus().lit(0);
        let (potential, d, force) = match state {
            ContactState::Contact(rest) if rest.contact_radius > zero => {
                let energy = Energy::new(self.curve.clone())?;
                let potential = energy.potential(&rest.contact_radius, &rest.indentation)?;
                (potential, rest.indentation.clone(), rest.force.clone())
            }
            ContactState::Contact(_) | ContactState::Detached => return Ok(self.none()),
            ContactState::Complete => {
                let Some(Complete { indentation, potential }) = self.complete()? else { return Ok(self.none()) };
                let force = match (self.curve.control(), value) {
                    (Control::Machine { stiffness }, Some(value)) => (value.clone() - &indentation) * stiffness,
                    (Control::Force, Some(value)) => value.clone(),
                    _ => zero.clone(),
                };
                (potential, indentation, force)
            }
        };
        let rest = match (self.curve.control(), value) {
            (Control::Machine { stiffness }, _) => spring_energy(&force, stiffness),
            (Control::Force, Some(value)) => -(d.clone() * value),
            _ => zero,
        };
        // The terms of Π are of the magnitude of the energy of its edge, wA, and of Fd.
        let size = potential.abs() + rest.abs() + (d * &force).abs() + self.curve.adhesion().work();
        let error = size.unit_roundoff().times(ROUNDINGS) * size;
        Ok(Estimate { value: potential + rest, error, evaluations: 0 })
    }
}
