//! The extension module `mdr._core`. It moves numbers between Python and the library and has no physics; the public package
//! is the typed Python around it.

mod contact;
mod errors;
mod fit;
mod interrupt;
mod power_law;
mod reference;
mod scene;

use pyo3::prelude::*;

/// The functions and classes that the Python package is made of.
#[pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::contact::ContactClass;
    #[pymodule_export]
    use super::fit::{Fitted, fit};
    #[pymodule_export]
    use super::power_law::{critical_states, kappa};
    #[pymodule_export]
    use super::reference::{judge_lines, lines, numbers, select};
    #[pymodule_export]
    use super::scene::{draw, in_si, solve};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("CERTIFIED", cfg!(feature = "mp"))?;
        module.add("MAX_DIGITS", mdr::scene::MAX_DIGITS)?;
        module.add("PROGRAM", mdr_provenance::program())?;
        module.add("VERSION", env!("CARGO_PKG_VERSION"))
    }
}
