//! Scenes, and numbers with their digits.

use std::collections::HashMap;
use std::io;

use mdr::Run;
use mdr::prelude::{Arithmetic, Scene, Shape};
use mdr::units::{NumberError, SiUnit};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

use crate::errors::of_library;
use crate::interrupt::interruptible;

/// The answer to a scene as JSON. `form` is `file`, `toml` or `json`; files named in a text are looked up in `files` and then
/// on the disk.
#[pyfunction]
#[pyo3(signature = (form, text, files, digits, f64))]
pub(crate) fn solve(
    py: Python<'_>,
    form: &str,
    text: &str,
    files: HashMap<String, Vec<u8>>,
    digits: Option<u32>,
    f64: bool,
) -> PyResult<String> {
    let arithmetic = match (digits, f64) {
        (None, true) => Some(Arithmetic::F64),
        (digits, false) => digits.map(|digits| Arithmetic::Certified { digits }),
        (Some(_), true) => return Err(PyValueError::new_err("give digits or f64, not both")),
    };
    let answer = interruptible(py, |stop| {
        let scene = read(form, text, &files)?.in_arithmetic(arithmetic);
        let mut answer = scene.solve_with(&mut Run::new(&mut (), stop.clone()))?;
        answer.notes.extend(scene.unused(false));
        Ok(mdr_provenance::json(&answer.to_json()).into_owned())
    })?;
    answer.map_err(of_library)
}

/// The picture of a scene as SVG; arguments as those of `solve`.
#[pyfunction]
pub(crate) fn draw(py: Python<'_>, form: &str, text: &str, files: HashMap<String, Vec<u8>>) -> PyResult<String> {
    let picture = interruptible(py, |_| {
        let scene = read(form, text, &files)?;
        Ok(mdr_provenance::svg(&mdr_plot::scene(scene.profile().name(), &scene.diagram()?).svg()).into_owned())
    })?;
    picture.map_err(of_library)
}

/// A number as text without its unit, in SI, where the unit of the key is known and one is given; any other text as it is. What
/// is refused is called by its name.
#[pyfunction]
pub(crate) fn in_si(text: &str, key: &str, name: &str) -> PyResult<String> {
    let unit = match key {
        "e" | "e_star" => Some(SiUnit::Pascal),
        "work_of_adhesion" => Some(SiUnit::JoulePerSquareMetre),
        "stiffness" => Some(SiUnit::NewtonPerMetre),
        "range_of_adhesion" | "offset" | "smooth" | "contact_point" => Some(SiUnit::Metre),
        "parameters" => Some(SiUnit::Unstated),
        "medium.length" => Some(SiUnit::Metre),
        "medium.modulus" => Some(SiUnit::Pascal),
        "medium.foundation" => Some(SiUnit::PascalPerMetre),
        "medium.coefficient" => Some(SiUnit::Coefficient),
        key => Shape::unit_of_key(key),
    };
    match unit.map(|unit| unit.read(text)) {
        Some(Ok(number)) => Ok(number.to_string()),
        None | Some(Err(NumberError::Literal(_))) => Ok(text.to_owned()),
        Some(Err(error @ NumberError::Dimension { .. })) => Err(PyValueError::new_err(error.of(name))),
        Some(Err(error)) => Err(PyValueError::new_err(format!("{name}: {text:?} is {error}"))),
    }
}

fn read(form: &str, text: &str, files: &HashMap<String, Vec<u8>>) -> mdr::Result<Scene> {
    match form {
        "file" => Scene::open(text),
        "toml" => Scene::from_toml(text, "", &at_hand(files)),
        _ => Scene::from_json(text, "", &at_hand(files)),
    }
}

/// Finds a named file among `files`, and then on the disk.
pub(crate) fn at_hand(files: &HashMap<String, Vec<u8>>) -> impl Fn(&str) -> io::Result<Vec<u8>> {
    |name| files.get(name).cloned().map_or_else(|| mdr::files::named(name), Ok)
}

/// The class `decimal.Decimal`.
pub(crate) struct Digits<'py>(&'py Bound<'py, PyType>);

impl<'py> Digits<'py> {
    pub(crate) fn new(py: Python<'py>) -> PyResult<Self> {
        static DECIMAL: PyOnceLock<Py<PyType>> = PyOnceLock::new();
        DECIMAL.import(py, "decimal", "Decimal").map(Digits)
    }

    /// Every digit of a text.
    pub(crate) fn of(&self, text: &str) -> PyResult<Bound<'py, PyAny>> {
        self.0.call1((text,))
    }
}
