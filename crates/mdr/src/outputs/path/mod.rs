//! The output `path`: the events of the loading path, and the balance of its energy.

pub(crate) mod edges;
#[cfg(feature = "mp")]
mod edges_energies;
#[cfg(feature = "mp")]
mod edges_proof;
#[cfg(feature = "mp")]
mod energies;
mod events;
#[cfg(feature = "mp")]
mod law;
#[cfg(feature = "mp")]
mod proof;
#[cfg(feature = "mp")]
mod start;

use mdr_core::calculus::Estimate;
#[cfg(feature = "mp")]
use mdr_core::contact::Status;
use mdr_core::contact::{Control, Edge, Result};
use mdr_core::number::Literal;
#[cfg(feature = "mp")]
use mdr_core::number::Precision;
use mdr_numeric::folds::SearchQuality;
use mdr_numeric::path::EventKind;

use super::room::{Content, Facts, Open, Request, Room as IsRoom, Subject, Table, not_wanted};
use super::{Output, Want};
use crate::answer::record::{Numbers, Part, Row, record};
use crate::answer::{Admission, Cell, Column, Completeness, List, Number, NumberStyle, Optional, Promise, Value};
#[cfg(feature = "mp")]
use crate::scene::{Arithmetic, Scene};
use crate::solve::search::{Search, doubles};
use crate::solve::states::States;
#[cfg(feature = "mp")]
use crate::solve::{
    certified::Certified,
    digits::{decide, guarded, raised, start},
    power_law::{self, PowerLaw},
    proof::FoldProof,
};

#[cfg(feature = "mp")]
pub(crate) use edges_proof::{Pair, with_path as with_path_between};
#[cfg(feature = "mp")]
pub(crate) use proof::{breaks_at_zero_depth, with_path, written};
#[cfg(feature = "mp")]
pub(crate) use start::refuse_at_once;

pub(crate) use events::{beyond_noise, changes, follow, is_arrival, quantities};

/// The energy that is lost in an event.
#[derive(Clone, Debug, PartialEq)]
pub enum Dissipation<N = Number> {
    /// A finite energy, in joules.
    Finite(Value<N>),
    /// An energy without bound: a dead load falls, or an infinite surface comes into contact.
    Unbounded,
}

impl<N> Part<N> for Dissipation<N> {
    type With<M> = Dissipation<M>;

    fn map_part<M>(self, f: &mut dyn FnMut(Value<N>) -> Value<M>) -> Self::With<M> {
        match self {
            Dissipation::Finite(value) => Dissipation::Finite(f(value)),
            Dissipation::Unbounded => Dissipation::Unbounded,
        }
    }

    fn put<'a>(&'a self, key: &'static str, row: &mut Row<'a, N>) {
        match self {
            Dissipation::Finite(value) => value.put(key, row),
            Dissipation::Unbounded => row.cells.push((key, Cell::Word("unbounded"))),
        }
    }

    fn put_absent(key: &'static str, row: &mut Row<'_, N>) {
        Value::put_absent(key, row);
    }
}

record! {
    /// An event of a loading path. A value that does not apply is missing: there is no contact radius where the surfaces are
    /// apart.
    PathEvent {
        /// The kind of event.
        event: EventKind,
        /// D = d + F/k, on a machine.
        position: Optional<N> = "position" in "m",
        /// d before the event.
        indentation: Option<Value<N>> = "indentation" in "m",
        /// F before the event.
        force: Option<Value<N>> = "force" in "N",
        /// a before the event.
        contact_radius: Option<Value<N>> = "contact radius" in "m",
        /// a after it.
        to_contact_radius: Option<Value<N>> = "to radius" in "m",
        /// d after it.
        to_indentation: Option<Value<N>> = "to indentation" in "m",
        /// F after it.
        to_force: Option<Value<N>> = "to force" in "N",
        /// Whether the states of the event are admissible.
        admissible: Admission<N>,
        /// The energy lost in the event; with two works of adhesion, in its jump.
        dissipated: Option<Dissipation<N>> = "dissipated" in "J",
        /// With two works of adhesion w₁ and w₂, (w₂ − w₁) times the area that the edge has receded since the previous event and
        /// in this one: an energy that is lost besides.
        hysteresis: Optional<N> = "hysteresis" in "J",
        /// With two works of adhesion, the edge whose work of adhesion the event has: of a jump, the one that drives it; the edge
        /// that stops, or begins to move.
        edge: Option<Edge>,
    }

    /// The energy balance of a path: work = dissipated + stored, and with two works of adhesion dissipated = jumps + hysteresis.
    Balance {
        /// Done by the control.
        work: Value<N>,
        /// Lost in all events.
        dissipated: Value<N> = "dissipated" in "J",
        /// The increase of the stored energy from the start to the end; with two works of adhesion, with the smaller one for the
        /// area in contact.
        stored: Value<N>,
        /// With two works of adhesion, the energy lost in jumps.
        jumps: Optional<N> = "jumps" in "J",
        /// With two works of adhesion w₁ and w₂, (w₂ − w₁) times the area that the edge has receded.
        hysteresis: Optional<N> = "hysteresis" in "J",
    }
}

impl Balance {
    /// The energy of a path in a sentence.
    pub fn sentence(&self, style: &NumberStyle) -> String {
        let part = |value: &Value| match value {
            Value::Unknown { log10: Some(log10), .. } => format!("about 10^{log10:.6} J"),
            Value::Unknown { status, why: Some(why), .. } => format!("{status} ({why})"),
            Value::Unknown { status, .. } => status.to_string(),
            value => style.quantity(&value.to_string(), "J"),
        };
        let [work, dissipated, stored] = [&self.work, &self.dissipated, &self.stored].map(part);
        let split = match (&self.jumps, &self.hysteresis) {
            (Optional(Some(jumps)), Optional(Some(hysteresis))) => {
                format!(" ({} in jumps, {} by the receding edge)", part(jumps), part(hysteresis))
            }
            _ => String::new(),
        };
        format!(
            "Energy: work of the control {work}, dissipated {dissipated}{split}, stored {stored} more than at the start."
        )
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

    fn columns() -> Vec<Column> {
        <PathEvent<N> as Numbers<N>>::columns()
    }
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

    /// The path with these of its energies, which are those of `followed`: by enclosures, else in f64.
    ///
    /// # Errors
    /// Errors of `enclosed`.
    #[cfg(feature = "mp")]
    fn with_energies<F>(
        self,
        energies: Energies,
        mut followed: F,
        enclosed: impl FnOnce(&mut F) -> Result<Option<PathNumbers<Number>>>,
        in_doubles: impl FnOnce() -> Result<PathNumbers<Number>>,
    ) -> Result<Self> {
        if energies == Energies::None {
            return Ok(self);
        }
        Ok(match enclosed(&mut followed)? {
            Some(proved) => self.with_proved_energy_of(proved),
            None if energies == Energies::Proved => self,
            None => self.with_energy_in_doubles(in_doubles()),
        })
    }

    /// Takes the energies from another computation of the same path, with the same promise.
    #[cfg(feature = "mp")]
    fn with_proved_energy_of(self, other: PathNumbers<Number>) -> Self {
        LoadingPath { energy: None, ..self.with_energy_of(Promise::Certified, other) }
    }

    /// Takes the energies from the path that f64 finds, if it has the same events, or the reason why there are none.
    #[cfg(feature = "mp")]
    fn with_energy_in_doubles(self, other: Result<PathNumbers<Number>>) -> Self {
        let kinds = |events: &[PathEvent]| events.iter().map(|event| event.event).collect::<Vec<_>>();
        match other {
            Ok(other) if kinds(&other.events) == kinds(&self.events.items) => self.with_energy_of(Promise::F64, other),
            Ok(_) => self.without_energy("energies are not enclosed, and f64 finds other events"),
            Err(mdr_core::contact::Error::NoEquilibrium { .. }) => self
                .without_energy("energies are not enclosed, and f64 does not find the state in which the path starts"),
            Err(error) => self.without_energy(&error.to_string()),
        }
    }

    /// Takes the energies from another computation of the same path.
    #[cfg(feature = "mp")]
    fn with_energy_of(mut self, promise: Promise, other: PathNumbers<Number>) -> Self {
        for (event, other) in self.events.items.iter_mut().zip(other.events) {
            (event.dissipated, event.hysteresis) = (other.dissipated, other.hysteresis);
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
        let (jumps, hysteresis) = (Optional(None), Optional(None));
        let balance =
            is_finite.then(|| Balance { work: open(), dissipated: open(), stored: open(), jumps, hysteresis });
        LoadingPath { balance, ..self }
    }
}

impl Content for LoadingPath {
    fn list(&self) -> &dyn Table {
        &self.events
    }

    fn beside(&self) -> Vec<(&'static str, Vec<Row<'_>>)> {
        self.balance.iter().map(|balance| ("balance", balance.rows())).collect()
    }

    fn exceptions(&self) -> Vec<(&'static str, Promise)> {
        let dissipated = self.energy.map(|promise| ("path.dissipated", promise));
        let balance = self.balance.as_ref().and(self.energy).map(|promise| ("balance", promise));
        dissipated.into_iter().chain(balance).collect()
    }

    fn sentences(&self, style: &NumberStyle) -> Vec<String> {
        self.balance.iter().map(|balance| balance.sentence(style)).collect()
    }

    #[cfg(feature = "mp")]
    fn resolve(&mut self, promise: Promise, f: fn(Number) -> Value) {
        self.events.resolve(promise, f);
        self.balance = self.balance.take().resolve(f);
        self.energy = None;
    }
}

pub(super) const FACTS: Facts = Facts { of: Subject::Path, key: None, question: |_, _| Want::Path, unused: not_wanted };

pub(super) struct Room;

impl<'w> Request<'w> for Room {
    fn needs_start(&self) -> bool {
        true
    }
}

impl<'w> IsRoom<'w> for Room {
    #[cfg(feature = "mp")]
    fn visited(&self, search: &Search<'_>) -> Vec<f64> {
        visited(search)
    }

    #[cfg(feature = "mp")]
    fn by_law(&self, law: &PowerLaw<'_>) -> Result<Option<Output>> {
        let path = decide(law.digits, |precision| law::events(law, &law.curve(precision)?))?;
        Ok(Some(LoadingPath::new(Promise::Certified, path, power_law::complete()).into()))
    }

    /// Proved where the folds are, except for the energy.
    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        let energies = if has_energies(certified) { Energies::All } else { Energies::None };
        let path = if certified.scene.has_two_works() {
            with_pair(certified, |pair| proved_between_edges(certified, pair, energies))?
        } else {
            let none = start::without_folds(certified)?;
            let folds = none.as_ref().map_or_else(|| certified.fold_proof(), |none| Ok(Some(none)))?;
            folds.map_or(Ok(None), |folds| proved(certified, folds, energies))?
        };
        Ok(path.map(Output::from))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let (path, complete) = searched_path(search)?;
        Ok(LoadingPath::new(Promise::F64, path, complete).into())
    }

    #[cfg(feature = "mp")]
    fn has_open_numbers(&self, output: &Output) -> bool {
        let Output::Path(path) = output else { return false };
        path.balance.as_ref().is_some_and(|balance| balance.stored.status() == Status::Undecided)
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        let path = PathNumbers { events: vec![undecided(open)], balance: None };
        LoadingPath::new(Promise::F64, path, open.completeness()).into()
    }
}

impl From<LoadingPath> for Output {
    fn from(path: LoadingPath) -> Self {
        Output::Path(Box::new(path))
    }
}

/// The path in f64, of one edge or between two, and how far its folds are known.
///
/// # Errors
/// Errors of [`numbers`] and of [`edges::numbers`].
fn searched_path(search: &Search<'_>) -> Result<(PathNumbers<Number>, Completeness)> {
    if !search.scene.has_two_works() {
        return Ok((doubles(numbers(&search.states()?)?), search.completeness()?));
    }
    edges::with_both(search, |states, searches| {
        let [advancing, receding] = [searches[0].completeness()?, searches[1].completeness()?];
        let is_doubtful = searches[0].folds()?.completeness == SearchQuality::Doubtful;
        Ok((doubles(edges::numbers(states)?), if is_doubtful { advancing } else { receding }))
    })
}

/// The events of the path and the balance of its energy, unless the scene does not want it.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform; an energy that is not representable. See
/// [`follow`] and [`events::with_energy`].
fn numbers(states: &States<'_, f64>) -> Result<PathNumbers<Estimate<f64>>> {
    let path = follow(states.model, &states.branches, states.scene)?;
    if states.scene.energies == Some(false) {
        return Ok(PathNumbers { events: events::alone(&path, &states.branches), balance: None });
    }
    events::with_energy(&path, &states.scene.path, &states.branches)
}

/// The digits up to which the energies of a path are computed unless the scene says otherwise.
#[cfg(feature = "mp")]
const DIGITS_WITH_ENERGIES: u32 = 50;

/// Whether the energies of a path are wanted.
#[cfg(feature = "mp")]
fn has_energies(certified: &Certified<'_>) -> bool {
    certified.scene.energies.unwrap_or(certified.digits <= DIGITS_WITH_ENERGIES)
}

/// What has to be said of a path without its energies.
#[cfg(feature = "mp")]
pub(crate) fn note(scene: &Scene, outputs: &[Output]) -> Option<String> {
    let is_without = |output: &Output| match output {
        Output::Path(path) => {
            let changes = |event: &PathEvent| event.dissipated.is_none() && changes(event.event);
            path.balance.is_none() && path.events.items.iter().any(changes)
        }
        _ => false,
    };
    let is_long = matches!(scene.arithmetic, Arithmetic::Certified { digits } if digits > DIGITS_WITH_ENERGIES);
    (is_long && scene.energies.is_none() && outputs.iter().any(is_without)).then(|| {
        "beyond 50 digits the energies of a path are computed where they are wanted: [output] energies = \"yes\""
            .to_owned()
    })
}

/// The contact radii through which a path in f64 goes.
#[cfg(feature = "mp")]
pub(crate) fn visited(search: &Search<'_>) -> Vec<f64> {
    let events = followed(search).into_iter().flat_map(|path| path.events);
    let states = events.flat_map(|event| [event.before, event.after]);
    let radii = states.filter_map(|state| Some(state.contact()?.contact_radius));
    radii.filter(|radius| *radius > 0.0 && radius.is_finite()).collect()
}

/// Which energies of a path are computed.
#[cfg(feature = "mp")]
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Energies {
    None,
    /// Those that enclosures decide.
    Proved,
    /// Else in f64.
    All,
}

#[cfg(feature = "mp")]
impl Energies {
    /// The precision of the states to begin with: as the energies will need them, if they are computed.
    fn precision_of_states(self, digits: u32) -> Precision {
        let of_digits = start(digits);
        if self == Energies::None { of_digits } else { guarded(raised(of_digits)) }
    }
}

/// The path over enclosures, with these of its energies; `None` if it cannot be proved.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform.
#[cfg(feature = "mp")]
pub(crate) fn proved(certified: &Certified<'_>, folds: &FoldProof, energies: Energies) -> Result<Option<LoadingPath>> {
    let Some((path, followed)) = proof::path(certified, folds, energies)? else { return Ok(None) };
    let enclosed = |followed: &mut proof::Followed| followed.proved_energy(certified, folds);
    path.with_energies(energies, followed, enclosed, || Ok(searched_path(certified.plain()?)?.0)).map(Some)
}

/// The path of a search in f64, of one edge or between two.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform.
#[cfg(feature = "mp")]
pub(crate) fn followed(search: &Search<'_>) -> Result<mdr_numeric::path::Path<f64>> {
    if search.scene.works.is_some() {
        return edges::with_both(search, |[advancing, receding], _| {
            edges::follow(receding.model, [&advancing.branches, &receding.branches], receding.scene)
        });
    }
    let states = search.states()?;
    follow(states.model, &states.branches, states.scene)
}

/// What `use_them` makes of the contact at the work of adhesion of each edge.
#[cfg(feature = "mp")]
pub(crate) fn with_edges<T>(
    certified: &Certified<'_>,
    use_them: impl FnOnce([&Certified<'_>; 2]) -> Result<T>,
) -> Result<T> {
    let [advancing, receding] = [Edge::Advancing, Edge::Receding].map(|edge| certified.scene.at(edge));
    let of = |scene| Certified::new(scene, certified.digits, certified.counts);
    use_them([&of(&advancing), &of(&receding)])
}

/// What `use_them` makes of the contact at the work of adhesion of each edge with all its folds; `None` where these are not proved.
#[cfg(feature = "mp")]
pub(crate) fn with_pair<T>(
    certified: &Certified<'_>,
    use_them: impl FnOnce(&Pair<'_, '_>) -> Result<Option<T>>,
) -> Result<Option<T>> {
    with_edges(certified, |edges| match (edges[0].fold_proof()?, edges[1].fold_proof()?) {
        (Some(advancing), Some(receding)) => use_them(&Pair { edges, folds: [advancing, receding] }),
        _ => Ok(None),
    })
}

/// The path between two works of adhesion over enclosures, with these of its energies; `None` if it cannot be proved.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform.
#[cfg(feature = "mp")]
pub(crate) fn proved_between_edges(
    whole: &Certified<'_>,
    pair: &Pair<'_, '_>,
    energies: Energies,
) -> Result<Option<LoadingPath>> {
    let Some((path, followed)) = edges_proof::path(pair, energies)? else { return Ok(None) };
    let enclosed = |followed: &mut edges_proof::Followed| followed.proved_energy(pair);
    path.with_energies(energies, followed, enclosed, || Ok(searched_path(whole.plain()?)?.0)).map(Some)
}

/// The one event of a path that could not be followed.
fn undecided(open: &Open<'_>) -> PathEvent {
    let held = |is_held: bool| if is_held { open.start() } else { Some(open.value()) };
    let control: &Control<Literal> = open.control();
    PathEvent {
        event: EventKind::Undecided,
        position: Optional(open.start().filter(|_| matches!(control, Control::Machine { .. }))),
        indentation: held(matches!(control, Control::Indentation)),
        force: held(matches!(control, Control::Force)),
        contact_radius: Some(open.value()),
        to_contact_radius: None,
        to_indentation: None,
        to_force: None,
        admissible: Admission::Unknown { why: "the path could not be followed" },
        dissipated: None,
        hysteresis: Optional(None),
        edge: None,
    }
}
