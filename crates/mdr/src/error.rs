//! Why a scene has no answer.

use std::{fmt, io};

use mdr_core::contact;
use mdr_core::number::LiteralError;
use mdr_core::text::{excerpt, printable};

/// A result of this crate.
pub type Result<T> = std::result::Result<T, Error>;

/// Where something stands in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The name of the file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
}

/// `file:line`.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", excerpt(&self.file), self.line)
    }
}

/// The reason why a scene has no answer: which input is wrong, its place, and a valid input.
///
/// ```
/// use mdr::prelude::*;
/// let scene = "[profile]\nkind = \"sphere\"\nradius = -1\n[output]\nwant = [\"transform\"]\ntransform.at = [1]";
/// let error = Scene::from_toml(scene, "tip.toml", &mdr::no_files).unwrap_err();
/// assert_eq!(error.to_string(), "tip.toml:3: profile.radius: must be positive, got -1");
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An input of the scene is refused.
    #[error("{}{}: {}", place.as_ref().map_or_else(String::new, |place| format!("{place}: ")), excerpt(key), printable(why))]
    Scene {
        /// The place of the input; `None` in a scene that was built in Rust.
        place: Option<Place>,
        /// The key with the names of its tables: `profile.radius`.
        key: String,
        /// The fault, and a valid input.
        why: String,
    },
    /// The question has no answer: a quantity out of its domain, no equilibrium, a decision that stays open.
    #[error("{0}")]
    Contact(#[source] contact::Error),
    /// A file could not be read.
    #[error("{}: {}", excerpt(name), printable(&source.to_string()))]
    Io {
        /// The name of the file.
        name: String,
        /// The reason.
        source: io::Error,
    },
    /// Certified digits in a build without the feature `mp`.
    #[error("{what} needs the feature `mp` (GMP and MPFR), which this build is without; ask for f64")]
    NeedsMp {
        /// The request that needs the feature.
        what: &'static str,
    },
    /// The run was [stopped](crate::Stop).
    #[error("stopped before the answer was complete")]
    Stopped,
}

impl From<contact::Error> for Error {
    fn from(error: contact::Error) -> Self {
        match error {
            contact::Error::Stopped => Error::Stopped,
            error => Error::Contact(error),
        }
    }
}

/// A text that is no number, in a scene that is built.
impl From<LiteralError> for Error {
    fn from(error: LiteralError) -> Self {
        Error::Scene { place: None, key: "a number of the scene".to_owned(), why: error.to_string() }
    }
}
