//! The path between two works of adhesion, and its energy.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{self, Edge, Error, Result};
use mdr_core::number::Literal;
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::fields::Fields;
use mdr_numeric::path::{EdgeEnergies, Edges, Path};

use super::events::{self, balance, dissipated, plus, unknown, work};
use super::{Balance, PathEvent, PathNumbers};
use crate::answer::record::Numbers;
use crate::answer::{AtValue, Optional, Value};
use crate::scene::Scene;
use crate::solve::model::{Model, SceneReal};
use crate::solve::search::Search;
use crate::solve::states::States;

/// The path of a scene with two works of adhesion, between the branches of an advancing and of a receding edge.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform. See [`Path::follow_edges`].
pub(crate) fn follow<R: SceneReal, B: EquilibriumBranches<R>>(
    model: &Model<R>,
    [advancing, receding]: [&B; 2],
    scene: &Scene,
) -> Result<Path<R>> {
    let way: Vec<R> = scene.path.iter().map(|point| model.number(point)).collect();
    let edges = Edges::new(&model.contact(), advancing, receding);
    let start = model.start(&scene.start)?;
    Path::follow_edges(&edges, &start, &way, Some(&ranks(&scene.path)))
}

/// The places of way points in their order, equal for equal numbers.
fn ranks(way: &[Literal]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..way.len()).collect();
    order.sort_by(|one, other| way[*one].compare(&way[*other]));
    let mut ranks = vec![0; way.len()];
    for pair in order.windows(2) {
        ranks[pair[1]] = ranks[pair[0]] + usize::from(way[pair[1]].compare(&way[pair[0]]).is_ne());
    }
    ranks
}

/// What `use_them` makes of the states of an advancing and of a receding edge, in f64.
///
/// # Errors
/// Errors of the searches and of `use_them`.
pub(crate) fn with_both<T>(
    search: &Search<'_>,
    use_them: impl FnOnce([&States<'_, f64>; 2], [&Search<'_>; 2]) -> Result<T>,
) -> Result<T> {
    let scenes = [Edge::Advancing, Edge::Receding].map(|edge| search.scene.at(edge));
    let [advancing, receding] = [search.at(&scenes[0], Edge::Advancing), search.at(&scenes[1], Edge::Receding)];
    use_them([&advancing.states()?, &receding.states()?], [&advancing, &receding])
}

/// A state, and the edge that could move: with two works of adhesion it may be pinned.
pub(crate) struct Held<R> {
    pub(crate) state: contact::Equilibrium<R>,
    pub(crate) edge: Option<Edge>,
    pinned: bool,
}

impl<R: SceneReal> Held<R> {
    /// A state in equilibrium at the work of adhesion of the scene, which may be that of one edge.
    pub(crate) fn on_edge(state: contact::Equilibrium<R>, edge: Option<Edge>) -> Self {
        Held { state, edge, pinned: false }
    }

    /// # Errors
    /// Errors of the transform at the contact radius.
    pub(crate) fn fields(&self, contact: Contact<R>) -> Result<Fields<R>> {
        let contact = self.edge.map_or_else(|| contact.clone(), |edge| contact.at(edge));
        if self.pinned { Fields::pinned(contact, &self.state) } else { Fields::of(contact, &self.state) }
    }
}

/// The record of the state in which a path between two works of adhesion starts.
///
/// # Errors
/// Errors of the transform, of the search and of `describe`.
pub(crate) fn first<R: SceneReal, T>(
    [advancing, receding]: [&States<'_, R>; 2],
    describe: impl Fn(&States<'_, R>, Held<R>) -> Result<T>,
) -> Result<Vec<AtValue<T>>> {
    let model = receding.model;
    let Some(value) = receding.scene.path.first() else { return Ok(Vec::new()) };
    let edges = Edges::new(&model.contact(), &advancing.branches, &receding.branches);
    let number = model.number(value);
    let held = match edges.first(&model.start(&receding.scene.start)?, &number) {
        Ok((edge, state)) => state.contact().cloned().map(|state| {
            let state = if edge.is_some() { receding.with_value(state, &number) } else { state };
            Held { state, edge, pinned: edge.is_none() }
        }),
        Err(Error::NoEquilibrium { .. }) => None,
        Err(error) => return Err(error),
    };
    let at = AtValue::new(value, held.into_iter().map(|held| describe(receding, held)).collect::<Result<_>>()?);
    let is_doubted = [advancing, receding].iter().any(|states| states.may_miss_start());
    Ok(vec![if is_doubted { at.doubted() } else { at }])
}

/// The events of the path and the balance of its energy.
///
/// # Errors
/// Errors of [`follow`] and of [`with_energy`].
pub(super) fn numbers<R: SceneReal>([advancing, receding]: [&States<'_, R>; 2]) -> Result<PathNumbers<Estimate<R>>> {
    let branches = [&advancing.branches, &receding.branches];
    let path = follow(receding.model, branches, receding.scene)?;
    with_energy(&path, &receding.scene.path, branches)
}

/// The events of a path with the energy lost in each jump and by a receding edge, and the balance of its energy.
///
/// # Errors
/// Errors of the transform; an error if an energy is not representable.
pub(super) fn with_energy<R: SceneReal>(
    path: &Path<R>,
    way: &[Literal],
    [advancing, receding]: [&SearchedBranches<R>; 2],
) -> Result<PathNumbers<Estimate<R>>> {
    let energies = EdgeEnergies::new(advancing, receding);
    let mut jumps = Vec::with_capacity(path.events.len());
    let mut hysteresis = Vec::with_capacity(path.events.len());
    for (event, loss) in path.events.iter().zip(energies.by_jumps(path)) {
        jumps.push(dissipated(event, loss)?);
    }
    for lost in energies.by_receding(path) {
        hysteresis.push(lost.map_or_else(unknown, |lost| Ok(Value::Known(of_area(lost))))?);
    }
    let balance = balance(path, way, energies.stored(path), &jumps)?;
    let balance = balance.map(|balance| split(balance, &hysteresis));
    let events = events::of_contact(receding.curve(), path, receding.admissibility()).convert(Estimate::exact);
    let losses = jumps.into_iter().zip(hysteresis);
    let events = events.into_iter().zip(losses).map(|(event, (dissipated, hysteresis))| PathEvent {
        dissipated,
        hysteresis: Optional(Some(hysteresis)),
        ..event
    });
    Ok(PathNumbers { events: events.collect(), balance })
}

/// A product with an area: some roundings.
fn of_area<R: SceneReal>(value: R) -> Estimate<R> {
    let error = value.abs() * value.unit_roundoff().times(8);
    Estimate { value, error, evaluations: 0 }
}

/// The balance of the energy with what is lost in jumps and by a receding edge.
fn split<R: SceneReal>(balance: Balance<Estimate<R>>, lost: &[Value<Estimate<R>>]) -> Balance<Estimate<R>> {
    let jumps = balance.dissipated;
    let mut hysteresis = lost.iter().cloned();
    let first = hysteresis.next();
    let hysteresis = first.map(|first| hysteresis.fold(first, |sum, lost| plus(&sum, &lost)));
    let dissipated = hysteresis.as_ref().map_or_else(|| jumps.clone(), |lost| plus(&jumps, lost));
    Balance {
        work: work(&dissipated, &balance.stored),
        dissipated,
        stored: balance.stored,
        jumps: Optional(Some(jumps)),
        hysteresis: Optional(hysteresis),
    }
}
