//! Power laws: κ and critical states, one or many.

use mdr::answer::Fold;
use mdr::batch;
use mdr::columns::States;
use mdr::critical::{CriticalAnswer, PowerLaw, critical};
use mdr::prelude::{Arithmetic, Control, Elasticity, Literal, Status};
use pyo3::prelude::*;

use crate::contact::{Codes, Column, Columns, Values, column, columns, control, literal};
use crate::errors::{of_contact, of_library, raise};
use crate::interrupt::{abandonable, detached};
use crate::scene::Digits;

/// κ_n, in f64 or as a Decimal.
#[pyfunction]
#[pyo3(signature = (n, digits = None))]
pub(crate) fn kappa<'py>(py: Python<'py>, n: &str, digits: Option<u32>) -> PyResult<Bound<'py, PyAny>> {
    let one = Literal::from(1);
    let law = PowerLaw {
        n: literal(n)?,
        c: one.clone(),
        elasticity: Elasticity::Effective(one.clone()),
        work_of_adhesion: one,
        control: Control::Indentation,
    };
    match digits {
        Some(digits) => Digits::new(py)?.of(&certified_answer(py, law, digits)?.kappa.to_string()),
        None => {
            let answer = detached(py, || critical(&law, Arithmetic::F64))?.map_err(of_library)?;
            Ok(answer.kappa.to_f64().into_pyobject(py)?.into_any())
        }
    }
}

/// κ_n and then a, d, F and status of the critical states of many power laws.
#[pyfunction]
#[pyo3(signature = (n, c, e_star, work_of_adhesion, held, stiffness = None))]
pub(crate) fn critical_states<'py>(
    py: Python<'py>,
    n: Values<'py>,
    c: Values<'py>,
    e_star: Values<'py>,
    work_of_adhesion: Values<'py>,
    held: &str,
    stiffness: Option<f64>,
) -> PyResult<(Column<'py>, Columns<'py>, Codes<'py>)> {
    let control = control(held, stiffness)?;
    let material = batch::Materials::Each {
        effective_modulus: e_star.as_slice()?,
        work_of_adhesion: work_of_adhesion.as_slice()?,
    };
    let points = batch::Points { exponent: n.as_slice()?, coefficient: c.as_slice()?, material };
    let len = points.exponent.len();
    let compute = || {
        let [mut kappa, mut contact_radius, mut indentation, mut force] = [(); 4].map(|()| vec![0.0; len]);
        let mut status = vec![Status::Ok; len];
        let mut states = batch::States {
            kappa: &mut kappa,
            contact_radius: &mut contact_radius,
            indentation: &mut indentation,
            force: &mut force,
            status: &mut status,
        };
        batch::critical_states(&points, &control, &mut states)?;
        Ok((kappa, States { contact_radius, indentation, force, status }))
    };
    let (kappa, states) = detached(py, compute)?.map_err(of_contact)?;
    let (columns, codes) = columns(py, states);
    Ok((column(py, kappa), columns, codes))
}

/// The answer in certified digits; of many, which take long, until a signal.
pub(crate) fn certified_answer(py: Python<'_>, law: PowerLaw, digits: u32) -> PyResult<CriticalAnswer> {
    /// They take a tenth of a millisecond, no more than a thread.
    const FEW: u32 = 1000;
    let work = move || critical(&law, Arithmetic::Certified { digits });
    if digits <= FEW { detached(py, work) } else { abandonable(py, work) }?.map_err(of_library)
}

/// The critical state, which there is unless n = 1/2.
pub(crate) fn state_of(answer: &CriticalAnswer) -> PyResult<&Fold> {
    let why = "there is no critical state under this control: at n = 1/2 the coefficient C decides, against a threshold, and \
               on a machine there may be no instability";
    answer.state.as_ref().ok_or_else(|| raise("NoEquilibriumError", (why,)))
}
