//! The output `equilibria`: all equilibria at values of the controlled quantity.

use mdr_core::contact::{self, Edge, Result, Stability};
#[cfg(feature = "mp")]
use mdr_core::contact::{Error, Quantity};
use mdr_core::number::Literal;
#[cfg(feature = "mp")]
use mdr_core::number::Real;
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, certify::Enclosure};
use mdr_numeric::admissible::{Admissibility, GapVerdict};
#[cfg(feature = "mp")]
use mdr_numeric::{branch::EquilibriumBranches, proof::ProvedBranches};

use super::key::Key;
use super::room::{Facts, Open, Request, Room as IsRoom, Subject};
use super::{Output, OutputKind, Want};
#[cfg(feature = "mp")]
use crate::answer::record::Numbers;
use crate::answer::record::record;
use crate::answer::{Admission, AtValue, PlainState, Value};
#[cfg(feature = "mp")]
use crate::answer::{Completeness, List, Promise};
use crate::scene::Scene;
use crate::solve::model::{Model, SceneReal};
use crate::solve::search::{self, Search};
use crate::solve::states::States;
use crate::solve::verdict;
#[cfg(feature = "mp")]
use crate::solve::{
    certified::Certified,
    power_law::{self, PowerLaw},
    proof::{self, Enclosed, FoldProof},
    sample,
};

record! {
    /// An equilibrium.
    Equilibrium in "equilibria" {
        /// a.
        contact_radius: Value<N> = "contact radius" in "m",
        /// d.
        indentation: Value<N> = "indentation" in "m",
        /// F.
        force: Value<N> = "force" in "N",
        /// Neutral at a fold.
        stability: Stability,
        /// Whether the state is admissible.
        admissible: Admission<N>,
        /// With two works of adhesion, the edge that is in equilibrium.
        edge: Option<Edge>,
    }
}

impl<N> Equilibrium<N> {
    pub(crate) fn new(state: contact::Equilibrium<N>, verdict: GapVerdict) -> Self {
        let PlainState { contact_radius, indentation, force, stability } = state.into();
        Equilibrium { contact_radius, indentation, force, stability, admissible: Admission::of(verdict), edge: None }
    }
}

pub(super) const FACTS: Facts = Facts {
    of: Subject::Contact,
    key: Some(Key::Values),
    question: |keys, _| Want::Equilibria { at: keys.values.clone() },
    unused: no_states,
};

/// Why values of the controlled quantity are of no use, where they are of none.
fn no_states(scene: &Scene, kind: OutputKind, drawn: bool) -> Option<&'static str> {
    let describes = |other: OutputKind| other == kind || other.is_of_states();
    (!drawn && !scene.has(describes)).then_some("no states are wanted")
}

pub(super) struct Room<'w> {
    pub(super) at: &'w [Literal],
}

impl<'w> Request<'w> for Room<'w> {
    fn values(&self) -> &'w [Literal] {
        self.at
    }

    fn missing(&self) -> Option<&'static str> {
        self.at.is_empty().then_some("values: [output.equilibria] at = [\"…\"]")
    }
}

impl<'w> IsRoom<'w> for Room<'w> {
    /// At each value the states of both edges, by increasing radius.
    fn of_edges(&self, outputs: [Output; 2]) -> Option<Output> {
        let [Output::Equilibria(advancing), Output::Equilibria(receding)] = outputs else { return None };
        let of = |edge: Edge| {
            move |at: AtValue<Equilibrium>| {
                let items = at.items.into_iter().map(|state| Equilibrium { edge: Some(edge), ..state }).collect();
                AtValue { items, ..at }
            }
        };
        Some(Output::Equilibria(advancing.map(of(Edge::Advancing)).with(receding.map(of(Edge::Receding)))))
    }

    #[cfg(feature = "mp")]
    fn visited(&self, search: &Search<'_>) -> Vec<f64> {
        let radii = search.states().map_or_else(|_| Vec::new(), |states| states.radii_at(self.at));
        // Of waves without end there is one more state in each.
        let end = sample::end_of_proof(search).ok().flatten().unwrap_or(f64::INFINITY);
        radii.into_iter().filter(|radius| *radius < end).collect()
    }

    #[cfg(feature = "mp")]
    fn by_law(&self, law: &PowerLaw<'_>) -> Result<Option<Output>> {
        let items = law.at_values(self.at, |curve, point, value| {
            Ok(Equilibrium::new(law.state(curve, point, Some(value)), GapVerdict::Admissible))
        })?;
        Ok(Some(Output::Equilibria(List::new(Promise::Certified, items).complete(power_law::complete()))))
    }

    /// Proved where the folds are; each value for itself if not all can be.
    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        let Some(folds) = certified.fold_proof()?.filter(|folds| folds.complete.proved) else {
            return Ok(proved_in_part(certified, self.at)?.map(Output::Equilibria));
        };
        let list = match proved_at(certified, folds, self.at)? {
            Some(items) => List::new(Promise::Certified, items).complete(complete(folds)),
            None if self.at.len() > 1 => one_by_one(certified, folds, self.at)?,
            None => return Ok(None),
        };
        Ok(Some(Output::Equilibria(list)))
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let items = at_values(&search.states()?, self.at)?;
        Ok(Output::Equilibria(search::list(items).complete(search.completeness()?)))
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        Output::Equilibria(open.at_values(self.at).complete(open.completeness()))
    }
}

/// All equilibria at values of the controlled quantity.
///
/// # Errors
/// Errors of the search that concern more than one value.
fn at_values(states: &States<'_, f64>, values: &[Literal]) -> Result<Vec<AtValue<Equilibrium<f64>>>> {
    let describe = |state| Ok(judged(states.model, state, states.admissibility()));
    values.iter().map(|literal| states.described_at(literal, describe)).collect()
}

/// An equilibrium, and whether it is admissible.
fn judged<R: SceneReal>(
    model: &Model<R>,
    state: contact::Equilibrium<R>,
    admissibility: &Admissibility,
) -> Equilibrium<R> {
    let verdict = verdict(admissibility, &state.contact_radius, &state.indentation);
    let state = Equilibrium::new(model.shown(state), verdict);
    Equilibrium { indentation: model.depth(state.indentation), ..state }
}

#[cfg(feature = "mp")]
fn in_doubles_at(certified: &Certified<'_>, values: &[Literal]) -> Result<Vec<AtValue<Equilibrium>>> {
    at_values(&certified.plain()?.states()?, values).map(|items| search::list(items).items)
}

/// Each value for itself: proved where that can be, and whether it is.
#[cfg(feature = "mp")]
fn one_by_one(certified: &Certified<'_>, folds: &FoldProof, values: &[Literal]) -> Result<List<AtValue<Equilibrium>>> {
    let at = |value: &Literal| {
        let values = std::slice::from_ref(value);
        let proved = proved_at(certified, folds, values)?;
        let flag = Some(proved.is_some());
        let items = proved.map_or_else(|| in_doubles_at(certified, values), Ok)?;
        Ok(items.into_iter().map(|item| AtValue { proved: flag, ..item }).collect::<Vec<_>>())
    };
    let items = values.iter().map(at).collect::<Result<Vec<_>>>()?.concat();
    let mut searched = certified.plain()?.completeness()?;
    searched.why = format!("at the values that are not marked as proved {}", searched.why);
    Ok(List::new(Promise::F64, items).complete(searched))
}

/// The completeness of proved equilibria.
#[cfg(feature = "mp")]
fn complete(folds: &FoldProof) -> Completeness {
    let mut why = "one equilibrium at most between two folds, and the folds are proved to be all".to_owned();
    if folds.limits.is_some() {
        why += "; equilibria with other radii are not listed";
    }
    Completeness { why, ..folds.complete.clone() }
}

/// The equilibria at radii where the folds are proved, of a proof that leaves other radii undecided; `None` if a search finds more of them.
///
/// # Errors
/// A value out of its domain; errors of the transform and of the search.
#[cfg(feature = "mp")]
fn proved_in_part(certified: &Certified<'_>, values: &[Literal]) -> Result<Option<List<AtValue<Equilibrium>>>> {
    let Some(folds) = certified.some_folds()? else { return Ok(None) };
    let Some(items) = proved_at(certified, folds, values)? else { return Ok(None) };
    let searched = in_doubles_at(certified, values)?;
    let is_more = |(proved, searched): (&AtValue<Equilibrium>, &AtValue<Equilibrium>)| {
        !proved.items.is_empty() && proved.items.len() >= searched.items.len()
    };
    let is_chosen = items.iter().zip(&searched).all(is_more);
    Ok(is_chosen.then(|| List::new(Promise::Certified, items).complete(folds.complete.clone())))
}

/// All equilibria in the range at each value, and those met beyond it unless the scene names the range; `None` if they cannot be
/// proved.
///
/// # Errors
/// A value out of its domain; errors of the transform. See [`EquilibriumBranches::equilibria`].
#[cfg(feature = "mp")]
fn proved_at(
    certified: &Certified<'_>,
    folds: &FoldProof,
    values: &[Literal],
) -> Result<Option<Vec<AtValue<Equilibrium>>>> {
    let limits = folds.limits.as_ref();
    let items = certified.decide(|precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let parts = ProvedBranches::of_parts(&enclosed.curve(), &folds.proved)?;
        let admissibility = certified.admissibility()?;
        let found = |literal: &Literal| {
            let value = enclosed.value.number(literal);
            parts.iter().map(|branches| branches.equilibria(&value)).collect::<Result<Vec<_>>>()
        };
        // All states before the first gap: they have digits without a verdict, which may take what is left of the budget.
        let found = values.iter().map(found).collect::<Result<Vec<_>>>()?;
        let at = |(literal, found): (&Literal, Vec<Vec<contact::Equilibrium<Interval>>>)| {
            let mut states = Vec::new();
            for state in found.into_iter().flatten() {
                if limits.map_or(Ok(true), |limits| {
                    is_within(&enclosed.value.contact_radius(&state.contact_radius), limits)
                })? {
                    let mut state = judged(&enclosed.value, state, &admissibility).convert(Enclosure::from);
                    let control = &certified.scene.control;
                    proof::controlled_exactly(control, literal, &mut state.indentation, &mut state.force);
                    states.push(state);
                }
            }
            let why = match limits {
                Some([lower, upper]) if states.is_empty() => {
                    Some(format!("no equilibrium with a contact radius within the range from {lower} to {upper} m"))
                }
                _ => None,
            };
            Ok(AtValue { why, ..AtValue::new(literal, states) })
        };
        values.iter().zip(found).map(at).collect::<Result<Vec<_>>>()
    });
    proof::decided(items)
}

/// Whether a state lies within a range of contact radii.
#[cfg(feature = "mp")]
fn is_within(radius: &Interval, [lower, upper]: &[Literal; 2]) -> Result<bool> {
    let [lower, upper] = [lower, upper].map(|end| Interval::from_literal(radius.ctx(), end));
    if *radius < lower || *radius > upper {
        Ok(false)
    } else if *radius >= lower && *radius <= upper {
        Ok(true)
    } else {
        let what = "whether an equilibrium lies within the range of the scene";
        Err(Error::undecided(Quantity::ContactRadius, radius, what))
    }
}
