//! Where the numbers of a contact stand in its scene.

use std::ops::Range;

use mdr_core::contact::{self, Quantity};
use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::NumberError;

use crate::error::{Error, Place, Result};

/// A key of a scene, and where it stands if it was read from a file.
#[derive(Clone, Debug)]
pub struct Location {
    pub(crate) place: Option<Place>,
    pub(crate) key: String,
}

impl Location {
    /// A key of a scene that was built.
    pub fn built(key: &str) -> Self {
        Location { place: None, key: key.to_owned() }
    }

    /// The key, with its table: `profile.radius`.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The complaint about a text that is no number in the unit of the key.
    pub fn no_number(&self, text: &str, error: &NumberError) -> Error {
        match error {
            NumberError::Dimension { .. } => self.refuse(error.of(self.key.rsplit('.').next().unwrap_or_default())),
            error => self.refuse(format!("`{}` is {error}", excerpt(text))),
        }
    }

    /// A number that must be above zero.
    ///
    /// # Errors
    /// A number that is not.
    pub fn require_positive(&self, number: Literal) -> Result<Literal> {
        if number.is_zero() || number.is_negative() {
            return Err(self.refuse(format!("must be positive, got {}", excerpt(&number.to_string()))));
        }
        Ok(number)
    }

    /// The complaint `file:line: key: why`.
    pub fn refuse(&self, why: impl Into<String>) -> Error {
        Error::Scene { place: self.place.clone(), key: self.key.clone(), why: why.into() }
    }
}

/// The places of a scene that a complaint about its contact can point at.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    /// The places of inputs that were read from a file, by their keys.
    pub(super) read: Vec<(&'static str, Location)>,
    /// All numbers, in the order in which they were read.
    pub(super) numbers: Vec<(Literal, Location)>,
    /// The range of the numbers of the profile in `numbers`.
    pub(super) parameters: Range<usize>,
}

impl Places {
    /// The place of an input, by the key it has where the scene is built.
    pub(crate) fn of(&self, key: &'static str) -> Location {
        self.read_at(key).unwrap_or_else(|| Location::built(key))
    }

    /// The place of an input that was read from a file, by its key.
    pub(crate) fn read_at(&self, key: &str) -> Option<Location> {
        self.read.iter().find(|(known, _)| *known == key).map(|(_, place)| place.clone())
    }

    /// A complaint about an input, at its place; the error itself when it is about something else.
    pub(crate) fn complaint(&self, error: contact::Error) -> Error {
        use contact::Error::Domain;
        let place = match &error {
            Domain { quantity: Quantity::EffectiveModulus, .. } => Some(self.of("material.e_star")),
            Domain { quantity: Quantity::WorkOfAdhesion, .. } => Some(self.of("material.work_of_adhesion")),
            Domain { quantity: Quantity::Stiffness, .. } => Some(self.of("control.stiffness")),
            Domain { value, .. } => {
                let parameters = &self.numbers[self.parameters.clone()];
                let given = parameters.iter().find(|(number, _)| number.to_string() == *value);
                given.map(|(_, place)| place.clone())
            }
            _ => None,
        };
        place.map_or_else(|| error.clone().into(), |place| place.refuse(error.to_string()))
    }

    /// A complaint about the contact as a whole: at the profile, unless it is about another input.
    pub(crate) fn complaint_about_profile(&self, error: contact::Error) -> Error {
        match self.complaint(error) {
            Error::Contact(error) => self.of("profile").refuse(error.to_string()),
            failure => failure,
        }
    }

    /// A number of the profile that no double can hold.
    #[cfg(feature = "mp")]
    pub(crate) fn parameter_beyond_doubles(&self) -> Option<&Literal> {
        self.numbers[self.parameters.clone()].iter().map(|(number, _)| number).find(|number| double(number).is_none())
    }

    /// Refuses the first number of the scene that no double can hold.
    pub(crate) fn require_doubles(&self, remedy: &str) -> Result<()> {
        match self.numbers.iter().find(|(number, _)| double(number).is_none()) {
            None => Ok(()),
            Some((number, place)) => {
                let number = number.to_string();
                Err(place.refuse(format!("out of the range of f64 ({remedy}), got {}", excerpt(&number))))
            }
        }
    }
}

/// The nearest double; `None` if the number is out of the range of doubles.
pub(crate) fn double(number: &Literal) -> Option<f64> {
    let nearest = number.nearest_f64();
    (nearest.is_finite() && (nearest == 0.0) == number.is_zero()).then_some(nearest)
}
