//! Errors of the library as exceptions of the Python package.
//!
//! They are classes in Python with a base of the package and one of the standard library; `create_exception!` can give one base
//! only.

use std::io;

use mdr::ContactError;
use pyo3::call::PyCallArgs;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

/// An exception of `mdr._errors` by its name.
pub(crate) fn raise<A>(name: &str, arguments: A) -> PyErr
where
    A: for<'py> PyCallArgs<'py>,
{
    Python::attach(|py| {
        let module = py.import("mdr._errors");
        let made = module.and_then(|module| module.getattr(name)).and_then(|class| class.call1(arguments));
        made.map_or_else(|error| error, PyErr::from_value)
    })
}

/// An error about a contact, as a Python exception.
pub(crate) fn of_contact(error: ContactError) -> PyErr {
    let text = error.to_string();
    match error {
        ContactError::Domain { quantity, value, requirement } => {
            raise("DomainError", (text, quantity.to_string(), value, requirement))
        }
        ContactError::OutOfRange { quantity, log10 } => raise("OutOfRangeError", (text, quantity.to_string(), log10)),
        ContactError::NoEquilibrium { .. } => raise("NoEquilibriumError", (text,)),
        ContactError::NoConvergence { .. } => raise("NoConvergenceError", (text,)),
        ContactError::Undecided { bits, .. } => raise("UndecidedError", (text, bits)),
        ContactError::Stopped => PyKeyboardInterrupt::new_err(text),
        _ => raise("Error", (text,)),
    }
}

/// An error about a scene, as a Python exception. A scene that is no file is called "", and its complaints have no place.
pub(crate) fn of_library(error: mdr::Error) -> PyErr {
    let text = error.to_string();
    match error {
        mdr::Error::Contact(error) => of_contact(error),
        mdr::Error::Stopped => PyKeyboardInterrupt::new_err(text),
        mdr::Error::Io { name, source } => io::Error::new(source.kind(), format!("{name}: {source}")).into(),
        mdr::Error::Scene { place, key, why } => match place.filter(|place| !place.file.is_empty()) {
            Some(place) => raise("SceneError", (text, Some(place.file), Some(place.line), key)),
            None => raise("SceneError", (format!("{key}: {why}"), None::<String>, None::<usize>, key)),
        },
        _ => raise("Error", (text,)),
    }
}
