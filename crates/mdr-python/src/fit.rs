//! Fits: columns in, columns and JSON out.

use std::collections::HashMap;

use mdr_fit::{Fit, FittedRow, Leg, Problem};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::contact::{Column, Values};
use crate::errors::of_library;
use crate::interrupt::interruptible;
use crate::scene::at_hand;

/// A fit that is made. Rows leave it as columns; all else as JSON.
#[pyclass(frozen, module = "mdr._core")]
pub(crate) struct Fitted {
    /// Without its rows.
    fit: Fit,
    rows: Vec<FittedRow>,
}

/// x, y, Y of the curve, residual and contact radius of each row; its label, whether it is of a leg that retracts, and whether its edge is
/// pinned.
type Columns<'py> = ([Column<'py>; 5], Bound<'py, PyArray1<i64>>, [Bound<'py, PyArray1<bool>>; 2]);

#[pymethods]
impl Fitted {
    /// The answer as JSON, without its rows.
    fn head(&self) -> String {
        self.fit.to_json()
    }

    /// The answer as JSON.
    fn json(&self) -> String {
        mdr_provenance::json(&self.whole().to_json()).into_owned()
    }

    /// The picture as SVG.
    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        let fit = self.whole();
        interruptible(py, |_| mdr_provenance::svg(&mdr_plot::fit(fit.profile, &fit).svg()).into_owned())
    }

    fn columns<'py>(&self, py: Python<'py>) -> Columns<'py> {
        let column = |of: fn(&FittedRow) -> f64| PyArray1::from_iter(py, self.rows.iter().map(of));
        let flags = |of: fn(&FittedRow) -> bool| PyArray1::from_iter(py, self.rows.iter().map(of));
        let radius = |row: &FittedRow| row.contact_radius.unwrap_or(f64::NAN);
        (
            [
                column(|row| row.x),
                column(|row| row.y),
                column(|row| row.fitted[1]),
                column(|row| row.residual),
                column(radius),
            ],
            PyArray1::from_iter(py, self.rows.iter().map(|row| i64::from(row.label))),
            [flags(|row| row.leg == Leg::Retract), flags(|row| row.pinned)],
        )
    }
}

impl Fitted {
    fn whole(&self) -> Fit {
        let mut fit = self.fit.clone();
        fit.rows.clone_from(&self.rows);
        fit
    }
}

/// The fit of a problem, given as JSON without its rows, and of the columns x and y with the leg of each row.
#[pyfunction]
#[pyo3(signature = (problem, files, x, y, legs))]
pub(crate) fn fit(
    py: Python<'_>,
    problem: &str,
    files: HashMap<String, Vec<u8>>,
    x: Values<'_>,
    y: Values<'_>,
    legs: Option<Vec<String>>,
) -> PyResult<Fitted> {
    let leg = |(index, name): (usize, &String)| {
        let unknown = || PyValueError::new_err(format!("leg[{index}]: a leg is `approach` or `retract`, got {name:?}"));
        Leg::named(name).ok_or_else(unknown)
    };
    let legs = legs.map(|legs| legs.iter().enumerate().map(leg).collect::<PyResult<Vec<Leg>>>()).transpose()?;
    let (x, y) = (x.as_slice()?.to_vec(), y.as_slice()?.to_vec());
    let fitted = interruptible(py, move |_| {
        let problem = Problem::from_json_with_rows(problem, "", &at_hand(&files), [&x, &y], legs.as_deref())?;
        // The problem has the rows of its own.
        drop((x, y));
        problem.fit()
    })?;
    let mut fit = fitted.map_err(of_library)?;
    let rows = std::mem::take(&mut fit.rows);
    Ok(Fitted { fit, rows })
}
