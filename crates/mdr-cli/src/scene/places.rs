//! Where the numbers of a contact stand in its scene.

use std::ops::Range;

use mdr_core::contact::{Error, Quantity};
use mdr_core::number::Literal;

use super::Place;
use crate::error::{Failure, Result};

/// The places of a scene that a complaint about its contact can point at.
#[derive(Debug)]
pub(crate) struct Places {
    pub(super) modulus: Place,
    pub(super) work: Place,
    pub(super) stiffness: Place,
    /// The table `[control]`.
    pub(crate) control: Place,
    pub(super) profile: Place,
    /// All numbers, in the order in which they were read.
    pub(super) numbers: Vec<(Literal, Place)>,
    /// Those of the profile among them.
    pub(super) parameters: Range<usize>,
}

impl Places {
    /// A complaint about an input, at its place; the error itself when it is about something else.
    pub(crate) fn complaint(&self, error: Error) -> Failure {
        let place = match &error {
            Error::Domain { quantity: Quantity::EffectiveModulus, .. } => Some(&self.modulus),
            Error::Domain { quantity: Quantity::WorkOfAdhesion, .. } => Some(&self.work),
            Error::Domain { quantity: Quantity::Stiffness, .. } => Some(&self.stiffness),
            Error::Domain { value, .. } => {
                let given =
                    self.numbers[self.parameters.clone()].iter().find(|(number, _)| number.to_string() == *value);
                given.map(|(_, place)| place)
            }
            _ => None,
        };
        place.map_or_else(|| Failure::Contact(error.clone()), |place| place.refuse(error.to_string()))
    }

    /// A complaint about the contact as a whole: at the profile, unless it is about another input.
    pub(crate) fn complaint_about_profile(&self, error: Error) -> Failure {
        match self.complaint(error) {
            Failure::Contact(error) => self.profile.refuse(error.to_string()),
            failure => failure,
        }
    }

    /// A number of the profile that no double can hold.
    pub(crate) fn parameter_beyond_doubles(&self) -> Option<&Literal> {
        first_beyond_doubles(&self.numbers[self.parameters.clone()]).map(|(number, _)| number)
    }

    /// Refuses the first number of the scene that no double can hold.
    pub(crate) fn require_doubles(&self, remedy: &str) -> Result<()> {
        match first_beyond_doubles(&self.numbers) {
            None => Ok(()),
            Some((number, place)) => Err(place.refuse(format!("out of the range of f64 ({remedy}), got {number}"))),
        }
    }
}

fn first_beyond_doubles(numbers: &[(Literal, Place)]) -> Option<&(Literal, Place)> {
    numbers.iter().find(|(number, _)| double(number).is_none())
}

/// The nearest double; none of what no double can hold.
pub(crate) fn double(number: &Literal) -> Option<f64> {
    let nearest = number.nearest_f64();
    (nearest.is_finite() && (nearest == 0.0) == number.is_zero()).then_some(nearest)
}
