//! Where the numbers of a contact stand in its scene.

use std::ops::Range;

use mdr_core::contact::{self, Quantity};
use mdr_core::number::Literal;

use crate::error::{Error, Place, Result};

/// A key of a scene, and where it stands if it was read from a file.
#[derive(Clone, Debug)]
pub(crate) struct Location {
    pub(crate) place: Option<Place>,
    pub(crate) key: String,
}

impl Location {
    /// A key of a scene that was built.
    pub(crate) fn built(key: &str) -> Self {
        Location { place: None, key: key.to_owned() }
    }

    /// The complaint `file:line: key: why`.
    pub(crate) fn refuse(&self, why: impl Into<String>) -> Error {
        Error::Scene { place: self.place.clone(), key: self.key.clone(), why: why.into() }
    }
}

/// The places of a scene that a complaint about its contact can point at.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    pub(crate) modulus: Location,
    pub(crate) work: Location,
    pub(crate) stiffness: Location,
    /// The table `[control]`.
    pub(crate) control: Location,
    /// The key `start` in it, where it is given.
    pub(crate) start: Option<Location>,
    /// The list of what is wanted.
    pub(crate) want: Location,
    /// The range of contact radii for the proof of folds.
    pub(crate) range: Location,
    pub(crate) profile: Location,
    /// All numbers, in the order in which they were read.
    pub(crate) numbers: Vec<(Literal, Location)>,
    /// Those of the profile among them.
    pub(crate) parameters: Range<usize>,
}

impl Places {
    /// Of a scene that was built.
    pub(crate) fn built(numbers: Vec<(Literal, Location)>, parameters: Range<usize>) -> Self {
        let at = Location::built;
        Places {
            modulus: at("material.e_star"),
            work: at("material.work_of_adhesion"),
            stiffness: at("control.stiffness"),
            control: at("control"),
            start: None,
            want: at("output.want"),
            range: at("output.folds.range"),
            profile: at("profile"),
            numbers,
            parameters,
        }
    }

    /// One more number of the scene.
    pub(super) fn add(&mut self, number: Literal, place: Location) {
        self.numbers.push((number, place));
    }

    /// A complaint about an input, at its place; the error itself when it is about something else.
    pub(crate) fn complaint(&self, error: contact::Error) -> Error {
        use contact::Error::Domain;
        let place = match &error {
            Domain { quantity: Quantity::EffectiveModulus, .. } => Some(&self.modulus),
            Domain { quantity: Quantity::WorkOfAdhesion, .. } => Some(&self.work),
            Domain { quantity: Quantity::Stiffness, .. } => Some(&self.stiffness),
            Domain { value, .. } => {
                let given =
                    self.numbers[self.parameters.clone()].iter().find(|(number, _)| number.to_string() == *value);
                given.map(|(_, place)| place)
            }
            _ => None,
        };
        place.map_or_else(|| error.clone().into(), |place| place.refuse(error.to_string()))
    }

    /// A complaint about the contact as a whole: at the profile, unless it is about another input.
    pub(crate) fn complaint_about_profile(&self, error: contact::Error) -> Error {
        match self.complaint(error) {
            Error::Contact(error) => self.profile.refuse(error.to_string()),
            failure => failure,
        }
    }

    /// A complaint about the profile.
    pub(crate) fn refuse_profile(&self, why: &str) -> Error {
        self.profile.refuse(why)
    }

    /// A number of the profile that no double can hold.
    #[cfg(feature = "mp")]
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

fn first_beyond_doubles(numbers: &[(Literal, Location)]) -> Option<&(Literal, Location)> {
    numbers.iter().find(|(number, _)| double(number).is_none())
}

/// The nearest double; none of what no double can hold.
pub(crate) fn double(number: &Literal) -> Option<f64> {
    let nearest = number.nearest_f64();
    (nearest.is_finite() && (nearest == 0.0) == number.is_zero()).then_some(nearest)
}
