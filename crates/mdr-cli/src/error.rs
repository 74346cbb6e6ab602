//! Why the program stops without an answer, and with which exit status.

use std::fmt;
use std::io::{self, Write};

use mdr_core::contact::{Error as ContactError, Quantity};
use mdr_core::text::{excerpt, printable};

/// The result of a command.
pub(crate) type Result<T> = std::result::Result<T, Failure>;

/// Why a command failed. Its text follows `error: ` on standard error.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A flag with an invalid value.
    Flag {
        /// With its dashes.
        flag: &'static str,
        /// The reason.
        why: String,
        /// As it was typed; `None` when the flag is missing or the reason names the value.
        got: Option<String>,
    },
    /// A scene, or another computation, without an answer.
    Answer(mdr::Error),
    /// A file could not be read or written.
    File {
        /// Its name; standard output also has one.
        name: String,
        /// The reason.
        source: io::Error,
    },
}

impl Failure {
    /// A flag whose value is refused.
    pub(crate) fn flag(flag: &'static str, why: impl fmt::Display, got: &str) -> Self {
        Failure::Flag { flag, why: why.to_string(), got: Some(got.to_owned()) }
    }

    /// A flag whose value is refused for a reason that names it.
    pub(crate) fn refused(flag: &'static str, why: impl fmt::Display) -> Self {
        Failure::Flag { flag, why: why.to_string(), got: None }
    }

    /// A flag that is needed and was not given.
    pub(crate) fn missing(flag: &'static str, why: impl fmt::Display) -> Self {
        Failure::Flag { flag, why: format!("missing: {why}"), got: None }
    }

    /// A question that was asked by flags: a refused input is a refused flag.
    pub(crate) fn of_flag(error: mdr::Error) -> Self {
        match &error {
            mdr::Error::Contact(ContactError::Domain { quantity, value, requirement }) => match flag_of(*quantity) {
                Some(flag) => Failure::flag(flag, format_args!("must be {requirement}"), value),
                None => Failure::Answer(error),
            },
            _ => Failure::Answer(error),
        }
    }

    /// A file, or standard output, that cannot be used.
    pub(crate) fn file(name: impl Into<String>, source: impl Into<io::Error>) -> Self {
        Failure::File { name: name.into(), source: source.into() }
    }
}

/// Says on standard error why something failed.
pub(crate) fn complain(why: impl fmt::Display) {
    // A closed standard error changes nothing.
    let _ = io::stderr().write_fmt(format_args!("error: {why}\n"));
}

impl From<mdr::Error> for Failure {
    fn from(error: mdr::Error) -> Self {
        Failure::Answer(error)
    }
}

impl From<ContactError> for Failure {
    fn from(error: ContactError) -> Self {
        Failure::of_flag(error.into())
    }
}

/// The flag that gives a quantity.
fn flag_of(quantity: Quantity) -> Option<&'static str> {
    Some(match quantity {
        Quantity::Exponent => "--n",
        Quantity::Coefficient => "--c",
        Quantity::EffectiveModulus => "--e-star",
        Quantity::YoungsModulus => "--e1",
        Quantity::WorkOfAdhesion => "--work",
        Quantity::Stiffness => "--stiffness",
        Quantity::Digits => "--digits",
        _ => return None,
    })
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Flag { flag, why, got: None } => write!(f, "{flag}: {}", printable(why)),
            Failure::Flag { flag, why, got: Some(got) } if got.is_empty() => {
                write!(f, "{flag}: {}, got an empty text", printable(why))
            }
            Failure::Flag { flag, why, got: Some(got) } => {
                write!(f, "{flag}: {}, got {}", printable(why), excerpt(got))
            }
            Failure::Answer(error) => printable(&error.to_string()).fmt(f),
            Failure::File { name, source } => write!(f, "{}: {}", excerpt(name), printable(&source.to_string())),
        }
    }
}
