//! The states of a contact that are searched, for any arithmetic that is not an enclosure.

use std::sync::Arc;

use mdr_core::contact::{self, Error, Result, Stability};
use mdr_core::number::Literal;
use mdr_numeric::admissible::{Admissibility, GapVerdict};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::equilibrium::{Equilibria, SearchedBranches};
use mdr_numeric::folds::{Folds, SearchQuality};
use mdr_numeric::path::{ContactState, Path};

use super::model::{Model, SceneReal};
use super::verdict;
use crate::answer::AtValue;
use crate::scene::{Scene, Start};

/// How many octaves from the folds equilibria are looked for.
const REACH: i64 = 1000;

/// A contact and its folds.
pub(crate) struct States<'a, R: SceneReal> {
    pub(crate) scene: &'a Scene,
    pub(crate) model: &'a Model<R>,
    pub(crate) branches: SearchedBranches<R>,
}

impl<'a, R: SceneReal> States<'a, R> {
    pub(crate) fn new(
        scene: &'a Scene,
        model: &'a Model<R>,
        folds: Folds<R>,
        admissibility: Arc<Admissibility>,
    ) -> Self {
        States { scene, model, branches: branches(model, folds, REACH).with_admissibility(admissibility) }
    }

    /// Which states are admissible.
    pub(crate) fn admissibility(&self) -> &Admissibility {
        self.branches.admissibility()
    }

    /// Whether a state is admissible.
    pub(crate) fn verdict(&self, state: &contact::Equilibrium<R>) -> GapVerdict {
        verdict(self.admissibility(), &state.contact_radius, &state.indentation)
    }

    /// All equilibria at a value of the controlled quantity, which they have exactly, and how they were searched.
    fn at(&self, literal: &Literal) -> Result<(Vec<contact::Equilibrium<R>>, SearchQuality)> {
        let value = self.model.number(literal);
        let Equilibria { equilibria, completeness } = self.branches.search(&value)?;
        Ok((equilibria.into_iter().map(|state| self.with_value(state, &value)).collect(), completeness))
    }

    /// A state with the exact value of the controlled quantity, which at a fold is that of the fold.
    pub(crate) fn with_value(&self, state: contact::Equilibrium<R>, value: &R) -> contact::Equilibrium<R> {
        match state.stability {
            Stability::Neutral => state,
            _ => state.controlled(self.model.control(), value.clone()),
        }
    }

    /// The record of each state at a value. If its equilibria cannot be computed the value is `undecided`; other values are
    /// unaffected.
    pub(crate) fn described_at<T>(
        &self,
        literal: &Literal,
        describe: impl Fn(contact::Equilibrium<R>) -> Result<T>,
    ) -> Result<AtValue<T>> {
        match self.at(literal) {
            Ok((states, completeness)) => {
                let at = AtValue::new(literal, states.into_iter().map(describe).collect::<Result<_>>()?);
                Ok(if completeness == SearchQuality::Doubtful { at.doubted() } else { at })
            }
            Err(error @ (Error::Undecided { .. } | Error::NoConvergence { .. } | Error::BudgetSpent { .. })) => {
                Ok(AtValue::open(literal, &error))
            }
            Err(error) => Err(error),
        }
    }

    /// The contact radii of the equilibria at values, as far as they are found.
    #[cfg(feature = "mp")]
    pub(crate) fn radii_at(&self, values: &[Literal]) -> Vec<f64> {
        let states = values.iter().flat_map(|value| self.at(value).map_or_else(|_| Vec::new(), |(states, _)| states));
        states.map(|state| state.contact_radius.approx()).filter(|a| a.is_finite()).collect()
    }

    /// The record of every equilibrium at the values; without values, of the state in which the path starts.
    ///
    /// # Errors
    /// Errors that concern more than one value.
    pub(crate) fn described<T>(
        &self,
        values: &[Literal],
        describe: impl Fn(contact::Equilibrium<R>) -> Result<T>,
    ) -> Result<Vec<AtValue<T>>> {
        match (values, self.scene.path.first()) {
            ([], Some(first)) => {
                let state = self.first(first)?;
                let at = AtValue::new(first, state.into_iter().map(describe).collect::<Result<_>>()?);
                Ok(vec![if self.may_miss_start() { at.doubted() } else { at }])
            }
            (values, _) => values.iter().map(|literal| self.described_at(literal, &describe)).collect(),
        }
    }

    /// Whether the path may have a state to start from where none is found.
    pub(crate) fn may_miss_start(&self) -> bool {
        self.scene.start != Start::Detached && self.branches.completeness() == SearchQuality::Doubtful
    }

    /// The equilibrium in which the path starts; `None` if it cannot start, or if the surfaces are apart.
    fn first(&self, first: &Literal) -> Result<Option<contact::Equilibrium<R>>> {
        let value = self.model.number(first);
        match Path::first(&self.branches, &self.model.start(&self.scene.start)?, &value) {
            Ok(ContactState::Contact(state)) => Ok(Some(self.with_value(state, &value))),
            Ok(_) | Err(Error::NoEquilibrium { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }
}

/// The branches between radii that many octaves below the folds and above; around w/E* where there is no fold.
pub(crate) fn branches<R: SceneReal>(model: &Model<R>, folds: Folds<R>, octaves: i64) -> SearchedBranches<R> {
    let length = model.contact().material_length();
    let first = folds.folds.first().map_or(&length, |fold| &fold.contact_radius);
    let last = folds.folds.last().map_or(&length, |fold| &fold.contact_radius);
    let [lower, upper] = [length.lit(2).powi(-octaves) * first, length.lit(2).powi(octaves) * last];
    SearchedBranches::cut_at(model.contact(), folds).within(lower, upper)
}
