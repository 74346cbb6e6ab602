//! One contact: its critical state, and columns of states.

use std::collections::HashMap;
use std::io;

use mdr::answer::Field;
use mdr::columns::{Choice, ContactColumns, EdgeColumns, Event, State, States};
use mdr::critical::{PowerLaw, critical};
use mdr::prelude::{Arithmetic, Control, Edge, Literal, Scene, Start, Status, Stop, Value, Want};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::{of_contact, of_library, raise};
use crate::interrupt::{detached, interruptible};
use crate::power_law::{certified_answer, state_of};
use crate::scene::Digits;

pub(crate) type Column<'py> = Bound<'py, PyArray1<f64>>;
pub(crate) type Codes<'py> = Bound<'py, PyArray1<i8>>;
type Flags<'py> = Bound<'py, PyArray1<bool>>;
pub(crate) type Values<'py> = PyReadonlyArray1<'py, f64>;
/// a, d and F.
type Row = (f64, f64, f64);
pub(crate) type Columns<'py> = (Column<'py>, Column<'py>, Column<'py>);
/// Kind, value, before, after, dissipated, the part of it that a receding edge has lost, edge.
type Happening = (&'static str, f64, Row, Row, f64, f64, Option<&'static str>);

/// Columns on all branches, admissible, stable, status.
type Found<'py> = (Columns<'py>, Flags<'py>, Flags<'py>, Codes<'py>);
/// Events, columns of the curve, balance.
type Drawn<'py> = (Vec<Happening>, Columns<'py>, Option<[f64; 3]>);

/// Profile and material: a scene, and the same in f64.
#[pyclass(frozen, module = "mdr._core", name = "Contact")]
pub(crate) struct ContactClass {
    scene: Scene,
    law: Option<PowerLaw>,
    /// With two works of adhesion, that of the receding edge.
    columns: ContactColumns,
    /// With two works of adhesion, for histories.
    edges: Option<EdgeColumns>,
}

#[pymethods]
impl ContactClass {
    /// From a scene as JSON, with the contents of the files that it names.
    #[new]
    fn new(py: Python<'_>, scene: &str, files: HashMap<String, Vec<u8>>) -> PyResult<Self> {
        let at_hand = |name: &str| files.get(name).cloned().ok_or_else(|| io::Error::from(io::ErrorKind::NotFound));
        let read = || {
            let scene = Scene::from_json(scene, "", &at_hand)?;
            let edges = if scene.has_two_works() { Some(EdgeColumns::new(&scene)?) } else { None };
            let columns = match &edges {
                Some(edges) => edges.at(Edge::Receding).clone(),
                None => ContactColumns::new(&scene)?,
            };
            Ok(ContactClass { law: PowerLaw::of(&scene), scene, columns, edges })
        };
        detached(py, read)?.map_err(of_library)
    }

    /// g, g' and ∫g at radii.
    fn transform<'py>(&self, py: Python<'py>, x: Values<'py>) -> PyResult<Columns<'py>> {
        let x = x.as_slice()?;
        let [g, slope, integral] =
            interruptible(py, |stop| self.columns.until(stop).transform(x))?.map_err(of_contact)?;
        Ok((column(py, g), column(py, slope), column(py, integral)))
    }

    /// a, d and F of the critical state in f64: of a power law in closed form, else where the contact comes off.
    #[pyo3(signature = (held, stiffness = None))]
    fn critical(&self, py: Python<'_>, held: &str, stiffness: Option<&str>) -> PyResult<Row> {
        let control = exact_control(held, stiffness)?;
        match &self.law {
            Some(law) => {
                let law = PowerLaw { control, ..law.clone() };
                let answer = detached(py, || critical(&law, Arithmetic::F64))?.map_err(of_library)?;
                let [a, d, force] = state_of(&answer)?.values();
                Ok((
                    number("the contact radius a", a)?,
                    number("the indentation depth d", d)?,
                    number("the normal force F", force)?,
                ))
            }
            None => self.pull_off(py, held, nearest_stiffness(&control)),
        }
    }

    /// a, d and F of the critical state in certified digits, as Decimals.
    #[pyo3(signature = (held, digits, stiffness = None))]
    fn certified<'py>(
        &self,
        py: Python<'py>,
        held: &str,
        digits: u32,
        stiffness: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let control = exact_control(held, stiffness)?;
        let arithmetic = Arithmetic::Certified { digits };
        let texts = match &self.law {
            Some(law) => {
                let law = PowerLaw { control, ..law.clone() };
                let answer = certified_answer(py, law, digits)?;
                state_of(&answer)?.values().map(ToString::to_string)
            }
            None => {
                let (near, ..) = self.pull_off(py, held, nearest_stiffness(&control))?;
                let scene =
                    self.scene.clone().control(control).want(Want::Folds { range: None }).arithmetic(arithmetic);
                let fold = interruptible(py, |stop| nearest_fold(&scene, near, stop))?.map_err(of_library)?;
                fold.ok_or_else(|| raise("NoEquilibriumError", ("the contact comes off without a fold",)))?
            }
        };
        let decimal = Digits::new(py)?;
        texts.iter().map(|text| decimal.of(text)).collect()
    }

    /// a, d and F where the contact comes off.
    #[pyo3(signature = (held, stiffness = None))]
    fn pull_off(&self, py: Python<'_>, held: &str, stiffness: Option<f64>) -> PyResult<Row> {
        let control = control(held, stiffness)?;
        interruptible(py, |stop| self.columns.until(stop).pull_off(&control))?.map(row).map_err(of_contact)
    }

    /// a, d, F and kind of all folds.
    #[pyo3(signature = (held, stiffness = None))]
    fn folds(
        &self,
        py: Python<'_>,
        held: &str,
        stiffness: Option<f64>,
    ) -> PyResult<Vec<(f64, f64, f64, &'static str)>> {
        let control = control(held, stiffness)?;
        let folds = interruptible(py, |stop| self.columns.until(stop).folds(&control))?.map_err(of_contact)?;
        Ok(folds.iter().map(|fold| (fold.contact_radius, fold.indentation, fold.force, fold.kind.name())).collect())
    }

    /// a, d, F and status with each radius.
    fn curve<'py>(&self, py: Python<'py>, radii: Values<'py>) -> PyResult<(Columns<'py>, Codes<'py>)> {
        let radii = radii.as_slice()?;
        let states = interruptible(py, |stop| self.columns.until(stop).curve(radii))?.map_err(of_contact)?;
        Ok(columns(py, states))
    }

    /// The pressure, gap or displacement of the equilibrium with a radius.
    fn field<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        contact_radius: f64,
        radii: Values<'py>,
    ) -> PyResult<Column<'py>> {
        let radii = radii.as_slice()?;
        let field = match name {
            "pressure" => Field::Pressure,
            "gap" => Field::Gap,
            "displacement" => Field::Displacement,
            _ => return Err(PyValueError::new_err(format!("no field: {name}"))),
        };
        let values = interruptible(py, |stop| self.columns.until(stop).field(field, contact_radius, radii))?;
        Ok(column(py, values.map_err(of_contact)?))
    }

    /// a, d, F and status of the stable equilibrium at each value.
    #[pyo3(signature = (values, held, stiffness, largest))]
    fn states<'py>(
        &self,
        py: Python<'py>,
        values: Values<'py>,
        held: &str,
        stiffness: Option<f64>,
        largest: bool,
    ) -> PyResult<(Columns<'py>, Codes<'py>)> {
        let (values, control) = (values.as_slice()?, control(held, stiffness)?);
        let columns = [(); 3].map(|()| PyArray1::zeros(py, values.len(), false));
        let status = PyArray1::zeros(py, values.len(), false);
        let mut held = columns.each_ref().map(|column| column.readwrite());
        let mut codes = status.readwrite();
        let [a, d, force] = &mut held;
        let mut rows = Rows {
            numbers: [a.as_slice_mut()?, d.as_slice_mut()?, force.as_slice_mut()?],
            codes: codes.as_slice_mut()?,
            filled: 0,
        };
        let choice = choice(largest);
        let ask =
            |stop: &Stop| self.columns.until(stop).states_by_blocks(&control, values, choice, |block| rows.fill(block));
        self.asked(py, &control, values.len(), ask)?.map_err(of_contact)?;
        let [a, d, force] = columns;
        Ok(((a, d, force), status))
    }

    /// a, d, F and status of the stable equilibrium at one value, which without arrays takes a tenth of the time.
    #[pyo3(signature = (value, held, stiffness, largest))]
    fn state(
        &self,
        py: Python<'_>,
        value: f64,
        held: &str,
        stiffness: Option<f64>,
        largest: bool,
    ) -> PyResult<(Row, i8)> {
        let (control, choice) = (control(held, stiffness)?, choice(largest));
        let states = self.asked(py, &control, 1, |stop| self.columns.until(stop).states(&control, &[value], choice))?;
        let states = states.map_err(of_contact)?;
        Ok(((states.contact_radius[0], states.indentation[0], states.force[0]), code(&states.status[0])))
    }

    /// a, d, F and admissible on each branch at each value, one branch after the other; which are stable; the status.
    #[pyo3(signature = (values, held, stiffness = None))]
    fn equilibria<'py>(
        &self,
        py: Python<'py>,
        values: Values<'py>,
        held: &str,
        stiffness: Option<f64>,
    ) -> PyResult<Found<'py>> {
        let (values, control) = (values.as_slice()?, control(held, stiffness)?);
        let found =
            self.asked(py, &control, values.len(), |stop| self.columns.until(stop).equilibria(&control, values))?;
        let found = found.map_err(of_contact)?;
        let [a, d, force] = [found.contact_radius, found.indentation, found.force].map(|rows| column(py, rows));
        let [admissible, stable] = [found.admissible, found.stable].map(|flags| PyArray1::from_vec(py, flags));
        Ok(((a, d, force), admissible, stable, codes(py, &found.status)))
    }

    /// a, d, F and status in the order of values, and the events between them.
    #[pyo3(signature = (values, held, stiffness, start))]
    fn follow<'py>(
        &self,
        py: Python<'py>,
        values: Values<'py>,
        held: &str,
        stiffness: Option<f64>,
        start: &str,
    ) -> PyResult<(Columns<'py>, Codes<'py>, Vec<Happening>)> {
        let (values, control, start) = (values.as_slice()?, control(held, stiffness)?, start_of(start)?);
        let history = interruptible(py, |stop| match &self.edges {
            Some(edges) => edges.until(stop).follow(&control, values, &start),
            None => self.columns.until(stop).follow(&control, values, &start),
        })?;
        let history = history.map_err(of_contact)?;
        let (columns, codes) = columns(py, history.states);
        Ok((columns, codes, history.jumps.iter().map(happening).collect()))
    }

    /// Events, a curve of a, d and F, and the balance of energy.
    #[pyo3(signature = (way, held, stiffness, start, samples))]
    fn path<'py>(
        &self,
        py: Python<'py>,
        way: Values<'py>,
        held: &str,
        stiffness: Option<f64>,
        start: &str,
        samples: usize,
    ) -> PyResult<Drawn<'py>> {
        let (way, control, start) = (way.as_slice()?, control(held, stiffness)?, start_of(start)?);
        let path = interruptible(py, |stop| match &self.edges {
            Some(edges) => edges.until(stop).path(&control, way, &start, samples),
            None => self.columns.until(stop).path(&control, way, &start, samples),
        })?;
        let path = path.map_err(of_contact)?;
        let curve = |of: fn(&State) -> f64| column(py, path.curve.iter().map(of).collect());
        let curve = (curve(|s| s.contact_radius), curve(|s| s.indentation), curve(|s| s.force));
        Ok((path.events.iter().map(happening).collect(), curve, path.balance))
    }
}

impl ContactClass {
    /// Closed forms of power laws take nanoseconds a value, and a state after others microseconds: a thread is not worth its start.
    fn asked<T: Send>(
        &self,
        py: Python<'_>,
        control: &Control<f64>,
        values: usize,
        work: impl FnOnce(&Stop) -> T + Send,
    ) -> PyResult<T> {
        let is_short = match (&self.law, control) {
            (Some(_), Control::Indentation | Control::Force) => true,
            _ => values <= FEW && self.columns.is_prepared(control),
        };
        if is_short { detached(py, || work(&Stop::default())) } else { interruptible(py, work) }
    }
}

/// So many searches take less time than a signal may wait.
const FEW: usize = 4;

/// Columns of states that are filled block by block.
struct Rows<'a> {
    /// a, d and F.
    numbers: [&'a mut [f64]; 3],
    codes: &'a mut [i8],
    filled: usize,
}

impl Rows<'_> {
    fn fill(&mut self, block: &States) {
        let rows = self.filled..self.filled + block.status.len();
        let columns = [&block.contact_radius, &block.indentation, &block.force];
        for (numbers, column) in self.numbers.iter_mut().zip(columns) {
            numbers[rows.clone()].copy_from_slice(column);
        }
        enter_codes(&mut self.codes[rows.clone()], &block.status);
        self.filled = rows.end;
    }
}

/// The fold that is nearest to a radius, in certified digits.
fn nearest_fold(scene: &Scene, radius: f64, stop: &Stop) -> mdr::Result<Option<[String; 3]>> {
    let answer = scene.solve_with(&mut mdr::Run::new(&mut (), stop.clone()))?;
    let folds = answer.folds().map_or(&[][..], |folds| &folds.items);
    let distance = |value: &Value| value.to_f64().map_or(f64::INFINITY, |a| (a / radius).ln().abs());
    let nearest =
        folds.iter().min_by(|one, other| distance(&one.contact_radius).total_cmp(&distance(&other.contact_radius)));
    Ok(nearest.map(|fold| [&fold.contact_radius, &fold.indentation, &fold.force].map(ToString::to_string)))
}

/// A double, or the exception that says how large the number is.
fn number(quantity: &'static str, value: &Value) -> PyResult<f64> {
    match (value.to_f64(), value.log10()) {
        (Some(number), _) => Ok(number),
        (None, log10) => {
            let log10 = log10.unwrap_or(f64::NAN);
            let text =
                format!("{quantity} is out of the range of doubles: its log10 is {log10}; ask for digits instead");
            Err(raise("OutOfRangeError", (text, quantity, log10)))
        }
    }
}

pub(crate) fn literal(text: &str) -> PyResult<Literal> {
    text.parse().map_err(|error| PyValueError::new_err(format!("{text}: {error}")))
}

pub(crate) fn control(held: &str, stiffness: Option<f64>) -> PyResult<Control<f64>> {
    controlled(held, stiffness, |stiffness| Control::machine(stiffness).map_err(of_contact))
}

fn exact_control(held: &str, stiffness: Option<&str>) -> PyResult<Control<Literal>> {
    controlled(held, stiffness, |text| Ok(Control::Machine { stiffness: literal(text)? }))
}

/// The control by its name in Python; only a machine has a stiffness.
fn controlled<S, N>(
    name: &str,
    stiffness: Option<S>,
    machine: impl FnOnce(S) -> PyResult<Control<N>>,
) -> PyResult<Control<N>> {
    match (name, stiffness) {
        ("indentation", None) => Ok(Control::Indentation),
        ("force", None) => Ok(Control::Force),
        ("position", Some(stiffness)) => machine(stiffness),
        _ => Err(PyValueError::new_err(format!("no control: {name}"))),
    }
}

/// The stiffness of a machine, as a double.
fn nearest_stiffness(control: &Control<Literal>) -> Option<f64> {
    match control {
        Control::Machine { stiffness } => Some(stiffness.nearest_f64()),
        _ => None,
    }
}

fn start_of(name: &str) -> PyResult<Start<f64>> {
    match name {
        "largest" => Ok(Start::Largest),
        "smallest" => Ok(Start::Smallest),
        "detached" => Ok(Start::Detached),
        _ => Err(PyValueError::new_err(format!("start must be 'largest', 'smallest' or 'detached', got {name:?}"))),
    }
}

pub(crate) fn column(py: Python<'_>, values: Vec<f64>) -> Column<'_> {
    PyArray1::from_vec(py, values)
}

pub(crate) fn columns(py: Python<'_>, states: States) -> (Columns<'_>, Codes<'_>) {
    let [a, d, force] = [states.contact_radius, states.indentation, states.force].map(|values| column(py, values));
    ((a, d, force), codes(py, &states.status))
}

/// The number of a status in `mdr.Status`.
fn code(status: &Status) -> i8 {
    match status {
        Status::Ok => 0,
        Status::Fold => 1,
        Status::NoEquilibrium => 2,
        Status::Overflow => 3,
        Status::Underflow => 4,
        Status::DomainError => 5,
        Status::NotAdmissible => 6,
        _ => 7,
    }
}

fn codes<'py>(py: Python<'py>, statuses: &[Status]) -> Codes<'py> {
    let mut codes = vec![0; statuses.len()];
    enter_codes(&mut codes, statuses);
    PyArray1::from_vec(py, codes)
}

/// The numbers of statuses in place of zeros; nearly all stay zero, and are looked at many at once.
fn enter_codes(codes: &mut [i8], statuses: &[Status]) {
    for (codes, statuses) in codes.chunks_mut(64).zip(statuses.chunks(64)) {
        if statuses.iter().fold(false, |any, status| any | (*status != Status::Ok)) {
            codes.iter_mut().zip(statuses).for_each(|(to, status)| *to = code(status));
        }
    }
}

fn choice(largest: bool) -> Choice {
    if largest { Choice::Largest } else { Choice::Smallest }
}

fn row(state: State) -> Row {
    (state.contact_radius, state.indentation, state.force)
}

fn happening(event: &Event) -> Happening {
    let edge = event.edge.map(|edge| edge.name());
    (event.kind.name(), event.value, row(event.before), row(event.after), event.dissipated, event.hysteresis, edge)
}

const _: fn() = || {
    fn shared<T: Send + Sync + 'static>() {}
    shared::<ContactClass>();
};
