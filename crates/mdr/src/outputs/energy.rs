//! The output `energy`: potential energy and stiffness of states.

use mdr_core::contact::{Edge, Result};
use mdr_core::number::Literal;
use mdr_numeric::energy::Energy;
#[cfg(feature = "mp")]
use {
    mdr_analytic::certified::{CertifiedPoint, Curve, Scaled},
    mdr_core::contact::{Control, Equilibrium, Error, Quantity, Stability, Status},
    mdr_core::number::certify::Enclosure,
    mdr_core::number::{Interval, Real},
    rug::Rational,
};

use super::path::edges::{self, Held};
use super::room::{Facts, Open, Request, Room as IsRoom, Subject, not_wanted};
use super::{Output, Want};
use crate::answer::record::record;
use crate::answer::{Admission, AtValue, PlainState, Value};
use crate::solve::search::{self, Search};
use crate::solve::states::States;
#[cfg(feature = "mp")]
use crate::solve::verdict;
#[cfg(feature = "mp")]
use crate::{
    answer::{List, Promise},
    scene::Scene,
    solve::certified::Certified,
    solve::power_law::{self, PowerLaw},
    solve::rigorous::{self, Described, Proved},
};

record! {
    /// The energy of a state.
    EnergyState {
        /// The state.
        state: PlainState<N>,
        /// The potential energy Π of (1.10), with two works of adhesion the energy stored: with the smaller one.
        energy: Value<N> = "energy" in "J",
        /// dF/dd along the equilibria, in N/m; of an edge that is pinned, at its radius.
        stiffness: Value<N> = "stiffness" in "N/m",
        /// Whether the state is admissible.
        admissible: Admission<N>,
        /// With two works of adhesion, the edge that is in equilibrium; missing where it is pinned.
        edge: Option<Edge>,
    }
}

pub(super) const FACTS: Facts = Facts {
    of: Subject::States,
    key: None,
    question: |keys, _| Want::Energy { states: keys.values.clone() },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) states: &'w [Literal],
}

impl<'w> Request<'w> for Room<'w> {
    fn values(&self) -> &'w [Literal] {
        self.states
    }
}

impl<'w> IsRoom<'w> for Room<'w> {
    #[cfg(feature = "mp")]
    fn by_law(&self, law: &PowerLaw<'_>) -> Result<Option<Output>> {
        let items = law.described(self.states, |curve, point, value| of_law(law, curve, point, value))?;
        Ok(Some(Output::Energy(List::new(Promise::Certified, items))))
    }

    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        let is_enclosed = certified.encloses_energies()?;
        let energy = |proved: &Proved<'_>, state: &_, record| of_proved(certified, proved, state, record);
        let open =
            |proved: &Proved<'_>, state: &_, record, error: &_| open_energy(certified, proved, state, record, error);
        let list = |items| Output::Energy(List::new(Promise::Certified, items));
        let Described { all, some } = rigorous::described_in_part(certified, is_enclosed, self.states, energy, open)?;
        certified.keep(some.map(list));
        Ok(all.map(list))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let items = if search.scene.has_two_works() {
            edges::with_both(search, |edges, _| edges::first(edges, described))?
        } else {
            energies(&search.states()?, self.states)?
        };
        Ok(Output::Energy(search::list(items)))
    }

    #[cfg(feature = "mp")]
    fn has_open_numbers(&self, output: &Output) -> bool {
        let Output::Energy(list) = output else { return false };
        let is_open = |at: &AtValue<EnergyState>| {
            at.status == Status::Undecided || at.items.iter().any(|state| state.energy.status() == Status::Undecided)
        };
        list.items.iter().any(is_open)
    }

    fn of_edges(&self, outputs: [Output; 2]) -> Option<Output> {
        let [Output::Energy(advancing), Output::Energy(receding)] = outputs else { return None };
        Some(Output::Energy(advancing.with(receding)))
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        Output::Energy(open.at_values(self.states))
    }
}

/// Energy and stiffness of every equilibrium at the values, or at the start of the path.
///
/// # Errors
/// Errors that concern more than one value.
fn energies(states: &States<'_, f64>, values: &[Literal]) -> Result<Vec<AtValue<EnergyState<f64>>>> {
    states.described(values, |state| described(states, Held::on_edge(state, states.scene.edge)))
}

/// Energy and stiffness of one state.
///
/// # Errors
/// Errors that concern more than one value.
fn described(states: &States<'_, f64>, held: Held<f64>) -> Result<EnergyState<f64>> {
    let fields = held.fields(states.model.contact())?;
    let Held { state, edge, .. } = held;
    let energy = Energy::new(states.model.contact().at(Edge::Advancing))?;
    let potential = energy.potential(&state.contact_radius, &state.indentation);
    let admissible = Admission::of(states.verdict(&state));
    let energy = Value::from_result(potential)?;
    let stiffness = Value::from_result(fields.stiffness())?;
    Ok(EnergyState { state: states.model.plain(state), energy, stiffness, admissible, edge })
}

/// Π and dF/dd of a state that is proved.
#[cfg(feature = "mp")]
fn of_proved(
    certified: &Certified<'_>,
    proved: &Proved<'_>,
    state: &Equilibrium<Interval>,
    record: PlainState<Enclosure>,
) -> Result<EnergyState<Enclosure>> {
    let radius = &state.contact_radius;
    let energy = proved.potential(state)? + held(certified.scene, radius);
    let stiffness = Value::from_result(along(state, &certified.scene.control, proved.stiffness(radius)))?;
    with_numbers(certified, proved, state, record, [Value::Known(energy.into()), stiffness])
}

/// A state that is proved, without its energy.
///
/// # Errors
/// [`Certified::admissibility`].
#[cfg(feature = "mp")]
fn open_energy(
    certified: &Certified<'_>,
    proved: &Proved<'_>,
    state: &Equilibrium<Interval>,
    record: PlainState<Enclosure>,
    error: &Error,
) -> Result<EnergyState<Enclosure>> {
    let unknown = || Value::unknown(Status::Undecided, error.to_string());
    with_numbers(certified, proved, state, record, [unknown(), unknown()])
}

/// A state that is proved, with its energy and its stiffness.
///
/// # Errors
/// [`Certified::admissibility`].
#[cfg(feature = "mp")]
fn with_numbers(
    certified: &Certified<'_>,
    proved: &Proved<'_>,
    state: &Equilibrium<Interval>,
    record: PlainState<Enclosure>,
    [energy, stiffness]: [Value<Enclosure>; 2],
) -> Result<EnergyState<Enclosure>> {
    let verdict = verdict(&*certified.admissibility()?, &state.contact_radius, &state.indentation);
    Ok(EnergyState { state: record, energy, stiffness, admissible: Admission::of(verdict), edge: proved.edge })
}

/// dF/dd of a state, which at a fold is known without a division.
#[cfg(feature = "mp")]
fn along(state: &Equilibrium<Interval>, control: &Control<Literal>, stiffness: Result<Interval>) -> Result<Enclosure> {
    match (state.stability, control) {
        (Stability::Neutral, Control::Indentation) => {
            let requirement = "off the fold of the indentation";
            Err(Error::domain(Quantity::ContactRadius, &state.contact_radius, requirement))
        }
        (Stability::Neutral, Control::Force) => Ok(Rational::new().into()),
        _ => stiffness.map(Enclosure::from),
    }
}

/// Π and dF/dd of a power law.
#[cfg(feature = "mp")]
fn of_law(
    law: &PowerLaw<'_>,
    curve: &Curve,
    point: &CertifiedPoint,
    value: &Rational,
) -> Result<EnergyState<Enclosure>> {
    let at_fold = || {
        let requirement = "off the fold of the indentation";
        Error::domain(Quantity::ContactRadius, &point.radius().interval(), requirement)
    };
    let stationary = law.scene.control == Control::Indentation && law.question.is_fold_of_force(value);
    let stiffness = match curve.stiffness(point) {
        Some(_) if stationary => Ok(Rational::new().into()),
        stiffness => stiffness.map(|stiffness| stiffness.enclosure()).ok_or_else(at_fold),
    };
    let held = held(law.scene, &point.radius().interval());
    Ok(EnergyState {
        state: law.state(curve, point, Some(value)).into(),
        energy: Value::Known(curve.energy(point).plus(&Scaled::from(held)).enclosure()),
        stiffness: Value::from_result(stiffness)?,
        admissible: Admission::Admissible,
        edge: law.scene.edge,
    })
}

/// (w₂ − w₁)πa² at a receding edge, by which the energy stored exceeds Π with its own work of adhesion.
#[cfg(feature = "mp")]
fn held(scene: &Scene, radius: &Interval) -> Interval {
    let works = scene.works.as_ref().filter(|_| scene.edge == Some(Edge::Receding));
    let number = |work: &Literal| power_law::number(scene, work);
    let more = works.map_or_else(Rational::new, |works| number(&works[1]) - number(&works[0]));
    radius.square() * radius.pi() * Interval::from_rational(radius.ctx(), &more)
}
