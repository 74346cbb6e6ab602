//! The records of an answer. Lengths in metres, forces in newtons, energies in joules, pressures in pascals.

use mdr_core::contact::{self, FoldKind, Stability, Status};
use mdr_core::named;
use mdr_core::number::Literal;
use mdr_numeric::admissible::Verdict;
use mdr_numeric::path::EventKind;

use super::record::{Cell, Numbers, Part, Row, record};
use super::value::{Number, Promise, Value};

/// Whether a state is admissible: whether the surfaces are apart everywhere outside the contact.
#[derive(Clone, Debug, PartialEq)]
pub enum Admission<N = Number> {
    /// The surfaces are apart everywhere outside the contact.
    Admissible,
    /// They would overlap: the contact is not simply connected, and the theory does not hold.
    Interpenetrating {
        /// A radius where they do, with the gap there, and why a path ends for that.
        at: Option<Overlap<N>>,
        /// A possible remedy.
        why: Option<String>,
    },
    /// It could not be decided.
    Unknown {
        /// The reason.
        why: &'static str,
    },
}

impl<N> Admission<N> {
    /// From the verdict of the search, with its radius and gap as short decimals.
    pub(crate) fn of(verdict: Verdict) -> Self {
        match verdict {
            Verdict::Admissible => Admission::Admissible,
            Verdict::Interpenetrating { radius, gap } => Admission::overlapping(Overlap::near(radius, gap)),
            Verdict::Undecided(why) => Admission::Unknown { why },
        }
    }

    pub(crate) fn overlapping(at: Option<Overlap<N>>) -> Self {
        Admission::Interpenetrating { at, why: None }
    }
}

/// The energy that is lost in an event.
#[derive(Clone, Debug, PartialEq)]
pub enum Dissipation<N = Number> {
    /// A finite energy, in joules.
    Finite(Value<N>),
    /// An energy without bound: a dead load falls, or an infinite surface comes into contact.
    Unbounded,
}

/// A number that has its key only where it is there: the position of a machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Optional<N = Number>(pub Option<Value<N>>);

impl<N> Part<N> for Optional<N> {
    type With<M> = Optional<M>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Optional<M> {
        Optional(self.0.map(f))
    }

    fn put<'a>(&'a self, key: &'static str, row: &mut Row<'a, N>) {
        if let Some(value) = &self.0 {
            value.put(key, row);
        }
    }
}

/// The stability of a state on the curve, or the reason why it is not decided.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveStability(pub Value<Stability>);

record! {
    /// Where the surfaces of a state that is not admissible touch or overlap.
    Overlap {
        /// The radius.
        r: Value<N>,
        /// The gap there, not above zero.
        gap: Value<N>,
    }

    /// The transformed profile at a radius.
    TransformSample {
        /// The radius x.
        x: Literal,
        /// g(x).
        g: Value<N>,
        /// g'(x).
        slope: Value<N>,
        /// ∫₀ˣ g, in m².
        integral: Value<N>,
    }

    /// A fold of the controlled quantity: where a branch of equilibria loses its stability.
    Fold {
        /// a.
        contact_radius: Value<N>,
        /// d.
        indentation: Value<N>,
        /// F.
        force: Value<N>,
        /// Whether the controlled quantity has a minimum or a maximum there, along increasing contact radii.
        kind: FoldKind,
        /// Whether the state is admissible.
        admissible: Admission<N>,
    }

    /// An equilibrium.
    Equilibrium in "equilibria" {
        /// a.
        contact_radius: Value<N>,
        /// d.
        indentation: Value<N>,
        /// F.
        force: Value<N>,
        /// Neutral at a fold.
        stability: Stability,
        /// Whether the state is admissible.
        admissible: Admission<N>,
    }

    /// The equilibrium with a given contact radius.
    CurvePoint {
        /// a.
        contact_radius: Literal,
        /// d = g(a) − Δl(a).
        indentation: Value<N>,
        /// F.
        force: Value<N>,
        /// Neutral at a fold.
        stability: CurveStability,
        /// Whether the state is admissible; `None` if it has no indentation depth.
        admissible: Option<Admission<N>>,
    }

    /// An event of a loading path. A value that does not apply is missing: there is no contact radius where the surfaces are
    /// apart.
    PathEvent {
        /// The kind of event.
        event: EventKind,
        /// D = d + F/k, on a machine.
        position: Optional<N>,
        /// d before the event.
        indentation: Option<Value<N>>,
        /// F before the event.
        force: Option<Value<N>>,
        /// a before the event.
        contact_radius: Option<Value<N>>,
        /// a after it.
        to_contact_radius: Option<Value<N>>,
        /// d after it.
        to_indentation: Option<Value<N>>,
        /// F after it.
        to_force: Option<Value<N>>,
        /// Whether the states of the event are admissible.
        admissible: Admission<N>,
        /// The energy lost in the event.
        dissipated: Option<Dissipation<N>>,
    }

    /// A sample of the loading path.
    ForceSample {
        /// From 1; the next one begins at a jump and where the direction changes.
        segment: usize,
        /// `approach` while the controlled quantity rises, `retract` while it falls.
        direction: &'static str,
        /// D = d + F/k, on a machine.
        position: Optional<N>,
        /// d; `None` for bodies apart under a dead load.
        indentation: Option<Value<N>>,
        /// F; 0 of bodies apart.
        force: Value<N>,
        /// a; `None` for bodies apart.
        contact_radius: Option<Value<N>>,
    }

    /// The characteristic values of a force curve; a quantity that the path does not reach has no value.
    CurveSummary {
        /// F at the fold from which the contact breaks. Where it shrinks to a point from a smaller contact, to which it has jumped
        /// before, F at the fold of that jump.
        pull_off_force: Option<Value<N>>,
        /// F just after the surfaces have jumped into contact; where contact begins continuously, after the first jump of the
        /// contact that grows from there.
        jump_in_force: Option<Value<N>>,
        /// The minimum of F along the path, at an end of a stretch between two events or at a fold of F on it.
        minimum_force: Option<Value<N>>,
        /// The energy lost in all events, in joules; `None` if it has no bound.
        hysteresis: Option<Value<N>>,
    }

    /// The energy balance of a path: work = dissipated + stored.
    Balance {
        /// Done by the control.
        work: Value<N>,
        /// Lost in all events.
        dissipated: Value<N>,
        /// The increase of the stored energy from the start to the end.
        stored: Value<N>,
    }

    /// The numbers of an equilibrium in a record that says more of it.
    PlainState {
        /// a.
        contact_radius: Value<N>,
        /// d.
        indentation: Value<N>,
        /// F.
        force: Value<N>,
        /// Neutral at a fold.
        stability: Stability,
    }

    /// The energy of a state.
    EnergyState {
        /// The state.
        state: PlainState<N>,
        /// The potential energy Π of (1.10).
        energy: Value<N>,
        /// dF/dd along the equilibria, in N/m.
        stiffness: Value<N>,
        /// Whether the state is admissible.
        admissible: Admission<N>,
    }
}

impl<N> Overlap<N> {
    /// A ring that was found in f64, rounded to six digits without a zero at the end.
    fn near(radius: f64, gap: f64) -> Option<Self> {
        let short = |x: f64| {
            let rounded = format!("{x:.5e}").parse::<f64>().ok()?;
            let text = if rounded == 0.0 { "0".to_owned() } else { format!("{rounded:e}") };
            text.parse().ok().map(Value::Given)
        };
        Some(Overlap { r: short(radius)?, gap: short(gap)? })
    }
}

impl<N> Fold<N> {
    pub(crate) fn new(fold: contact::Fold<N>, verdict: Verdict) -> Self {
        let contact::Fold { contact_radius, indentation, force, kind } = fold;
        Fold {
            contact_radius: Value::Known(contact_radius),
            indentation: Value::Known(indentation),
            force: Value::Known(force),
            kind,
            admissible: Admission::of(verdict),
        }
    }
}

impl<N> Equilibrium<N> {
    pub(crate) fn new(state: contact::Equilibrium<N>, verdict: Verdict) -> Self {
        let PlainState { contact_radius, indentation, force, stability } = state.into();
        Equilibrium { contact_radius, indentation, force, stability, admissible: Admission::of(verdict) }
    }
}

impl<N> From<contact::Equilibrium<N>> for PlainState<N> {
    fn from(state: contact::Equilibrium<N>) -> Self {
        let contact::Equilibrium { contact_radius, indentation, force, stability } = state;
        PlainState {
            contact_radius: Value::Known(contact_radius),
            indentation: Value::Known(indentation),
            force: Value::Known(force),
            stability,
        }
    }
}

named! {
    /// A quantity along the surface of a state.
    pub enum Field {
        /// The normal pressure within the contact, tension negative.
        Pressure = "pressure",
        /// The distance of the surfaces outside the contact.
        Gap = "gap",
        /// The normal displacement of the surface outside the contact.
        Displacement = "displacement",
    }
}

/// A field at a radius.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldSample<N = Number> {
    /// The radius, as the scene gives it, or chosen by the program.
    pub r: Value<N>,
    /// The value of the field, in pascals or metres.
    pub value: Value<N>,
}

/// A field along the surface of a state.
#[derive(Clone, Debug, PartialEq)]
pub struct FieldState<N = Number> {
    /// The state.
    pub state: PlainState<N>,
    /// The kind of field.
    pub field: Field,
    /// The samples, by the radii of the scene.
    pub samples: Vec<FieldSample<N>>,
    /// Whether the state is admissible.
    pub admissible: Admission<N>,
}

impl<N> Numbers<N> for FieldState<N> {
    type With<M> = FieldState<M>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> FieldState<M> {
        let FieldState { state, field, samples, admissible } = self;
        let state = state.map_part(f);
        let samples = samples.into_iter().map(|FieldSample { r, value }| FieldSample { r: f(r), value: f(value) });
        let samples = samples.collect();
        FieldState { state, field, samples, admissible: admissible.map_part(f) }
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        let name = self.field.name();
        let samples = self.samples.iter();
        let samples = samples.map(|sample| Row::new().with("r", &sample.r).with(name, &sample.value)).collect();
        let mut row = Row::new().with("", &self.state);
        row.cells.push((name, Cell::Rows(samples)));
        vec![row.with("", &self.admissible)]
    }
}

/// The results at one value of the controlled quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct AtValue<T> {
    /// The value, as it was given.
    pub value: Literal,
    /// The states at it, by increasing contact radius.
    pub items: Vec<T>,
    /// Whether it is proved that these are all, where that is not the same for every value.
    pub proved: Option<bool>,
    /// [`Status::NoEquilibrium`], or [`Status::Undecided`] where the states could not be computed.
    pub status: Status,
    /// The reason for the status.
    pub why: Option<String>,
}

impl<T> AtValue<T> {
    pub(crate) fn new(value: &Literal, items: Vec<T>) -> Self {
        let status = if items.is_empty() { Status::NoEquilibrium } else { Status::Ok };
        AtValue { value: value.clone(), items, proved: None, status, why: None }
    }

    /// The states could not be computed, for the reason that the error gives.
    pub(crate) fn open(value: &Literal, error: &contact::Error) -> Self {
        AtValue { status: Status::Undecided, why: Some(error.to_string()), ..AtValue::new(value, Vec::new()) }
    }
}

impl<N, T: Numbers<N>> Numbers<N> for AtValue<T> {
    type With<M> = AtValue<T::With<M>>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        let AtValue { value, items, proved, status, why } = self;
        AtValue { value, items: items.map_values(f), proved, status, why }
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        let mut row = Row::new().with("value", &self.value);
        row.cells.push((T::KEY, Cell::Rows(self.items.rows())));
        row.cells.extend(self.proved.map(|proved| ("proved", Cell::Flag(proved))));
        row.mark = (self.status != Status::Ok).then_some(self.status);
        row.why = self.why.as_deref();
        vec![row]
    }
}

/// The completeness of a list.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Completeness {
    /// Whether it is proved that nothing is missing within the range.
    pub proved: bool,
    /// The smallest contact radius of the range; `None` if it is not limited.
    pub from: Option<String>,
    /// The largest contact radius of the range; `None` if it is not limited.
    pub to: Option<String>,
    /// The basis of the proof, or the reason why there is none.
    pub why: String,
}

/// The items of an output.
#[derive(Clone, Debug, PartialEq)]
pub struct List<T> {
    /// The items, in their order.
    pub items: Vec<T>,
    /// How far the numbers of the items can be trusted.
    pub promise: Promise,
    /// Whether the list is complete; `None` if not meaningful.
    pub complete: Option<Completeness>,
}

impl<T> List<T> {
    pub(crate) fn new(promise: Promise, items: Vec<T>) -> Self {
        List { items, promise, complete: None }
    }

    pub(crate) fn complete(self, complete: Completeness) -> Self {
        List { complete: Some(complete), ..self }
    }
}

/// The events of a path and the balance of its energy, in one arithmetic.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PathNumbers<N> {
    pub(crate) events: Vec<PathEvent<N>>,
    pub(crate) balance: Option<Balance<N>>,
}

impl<N> Numbers<N> for PathNumbers<N> {
    type With<M> = PathNumbers<M>;

    fn map_values<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> PathNumbers<M> {
        PathNumbers { events: self.events.map_values(f), balance: self.balance.map_values(f) }
    }

    fn rows(&self) -> Vec<Row<'_, N>> {
        let mut rows = self.events.rows();
        rows.extend(self.balance.rows());
        rows
    }
}

/// The loading path as a measurement shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceCurve {
    /// The samples, in the order of the path.
    pub samples: List<ForceSample>,
    /// Pull-off force, jump-in, minimum force and hysteresis.
    pub summary: CurveSummary,
}

/// A loading path.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadingPath {
    /// The events, in their order.
    pub events: List<PathEvent>,
    /// The energy balance; `None` if a term of it has no bound, or the path could not be followed to its end.
    pub balance: Option<Balance>,
    /// How far the energies can be trusted, where that is less than the rest.
    pub energy: Option<Promise>,
}

impl LoadingPath {
    pub(crate) fn new(promise: Promise, path: PathNumbers<Number>, complete: Completeness) -> Self {
        let PathNumbers { events, balance } = path;
        LoadingPath { events: List::new(promise, events).complete(complete), balance, energy: None }
    }

    /// Takes the energies from another computation of the same path.
    #[cfg(feature = "mp")]
    pub(crate) fn with_energy_of(mut self, promise: Promise, other: PathNumbers<Number>) -> Self {
        for (event, other) in self.events.items.iter_mut().zip(other.events) {
            event.dissipated = other.dissipated;
        }
        LoadingPath { balance: other.balance, energy: Some(promise), ..self }
    }

    /// Marks the energies of the path as undecided, for the reason `why`.
    #[cfg(feature = "mp")]
    pub(crate) fn without_energy(mut self, why: &str) -> Self {
        let open = || Value::unknown(Status::Undecided, why);
        // Surfaces that part under a dead load, or come to touch everywhere, have no energy balance.
        let ends = |event: &PathEvent| {
            matches!(event.event, EventKind::Detached | EventKind::CompleteContact | EventKind::Undecided)
        };
        let is_finite = !self.events.items.iter().any(|event| ends(event) && event.to_indentation.is_none());
        for event in self.events.items.iter_mut().filter(|event| event.to_force.is_some()) {
            event.dissipated = Some(Dissipation::Finite(open()));
        }
        let balance = is_finite.then(|| Balance { work: open(), dissipated: open(), stored: open() });
        LoadingPath { balance, ..self }
    }
}
