//! Equilibria at a value.

use mdr_analytic::{Contact, Equilibria};
use mdr_core::contact::{Control, Equilibrium, Result};
use mdr_core::number::Real;

use super::{Form, Theory, given};

/// Radius, d and F.
type State = [Form; 3];

const AT_VALUE: State = [Form::EquilibriumRadius, Form::EquilibriumIndentation, Form::EquilibriumForce];
const AT_DISTANCE: State = [Form::DistanceRadius, Form::DistanceIndentation, Form::DistanceForce];

impl Theory {
    pub(crate) fn equilibria<R: Real>(
        &self,
        contact: &Contact<R>,
        control: &Control<R>,
        value: &R,
    ) -> Result<Vec<Equilibrium<R>>> {
        Ok(self.bent(contact, AT_VALUE, &contact.equilibria(control, value)?))
    }

    pub(crate) fn equilibria_at_distance<R: Real>(
        &self,
        contact: &Contact<R>,
        control: &Control<R>,
        distance: &R,
    ) -> Result<Vec<Equilibrium<R>>> {
        Ok(self.bent(contact, AT_DISTANCE, &contact.equilibria_at_distance(control, distance)?))
    }

    fn bent<R: Real>(&self, contact: &Contact<R>, forms: State, found: &Equilibria<R>) -> Vec<Equilibrium<R>> {
        let inputs = given(contact);
        let bent = |state: &Equilibrium<R>| Equilibrium {
            contact_radius: self.bend(forms[0], state.contact_radius.clone(), &inputs),
            indentation: self.bend(forms[1], state.indentation.clone(), &inputs),
            force: self.bend(forms[2], state.force.clone(), &inputs),
            stability: state.stability,
        };
        found.as_slice().iter().map(bent).collect()
    }
}
