//! Pressure, gap, displacement and energy of states, for any arithmetic that is not an enclosure.

use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{self, Error, Result, Stability, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::{Admissibility, Verdict};
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::energy::Energy;
use mdr_numeric::equilibrium::{Equilibria, SearchedBranches};
use mdr_numeric::fields::Fields;
use mdr_numeric::folds::{Folds, SearchQuality};
use mdr_numeric::path::{ContactState, Path};

use super::model::{Model, SceneReal};
use super::outputs::equilibrium;
use super::path;
use super::sample::decimal;
use crate::answer::record::Numbers;
use crate::answer::types::PathNumbers;
use crate::answer::{Admission, AtValue, EnergyState, Equilibrium, Field, FieldSample, FieldState, Overlap, Value};
use crate::scene::Scene;

/// Radii of a pressure over the contact radius, when the scene names none.
const INSIDE: [(i64, i64); 6] = [(0, 1), (1, 4), (1, 2), (3, 4), (9, 10), (99, 100)];
/// Radii of a gap or displacement over the contact radius, when the scene names none.
const OUTSIDE: [(i64, i64); 6] = [(101, 100), (11, 10), (5, 4), (3, 2), (2, 1), (4, 1)];
/// How many octaves from the folds equilibria are looked for.
const REACH: i64 = 1000;

/// A contact and its folds.
pub(crate) struct States<'a, R: SceneReal> {
    pub(super) model: &'a Model<R>,
    pub(super) branches: SearchedBranches<R>,
}

impl<'a, R: SceneReal> States<'a, R> {
    pub(crate) fn new(model: &'a Model<R>, folds: Folds<R>, admissibility: Arc<Admissibility>) -> Self {
        States { model, branches: branches(model, folds, REACH).with_admissibility(admissibility) }
    }

    fn verdict(&self, state: &contact::Equilibrium<R>) -> Verdict {
        self.branches.admissibility().of(state.contact_radius.approx(), state.indentation.approx())
    }

    /// All equilibria at a value of the controlled quantity, which they have exactly, and how they were searched.
    fn at(&self, literal: &Literal) -> Result<(Vec<contact::Equilibrium<R>>, SearchQuality)> {
        let value = self.model.number(literal);
        let Equilibria { equilibria, completeness } = self.branches.search(&value)?;
        Ok((equilibria.into_iter().map(|state| self.with_value(state, &value)).collect(), completeness))
    }

    /// A state with the exact value of the controlled quantity, which at a fold is that of the fold.
    fn with_value(&self, state: contact::Equilibrium<R>, value: &R) -> contact::Equilibrium<R> {
        match state.stability {
            Stability::Neutral => state,
            _ => state.controlled(self.model.control(), value.clone()),
        }
    }

    /// The record of each state at a value. If its equilibria cannot be computed the value is `undecided`; other values are
    /// unaffected.
    fn described_at<T>(
        &self,
        literal: &Literal,
        describe: impl Fn(contact::Equilibrium<R>) -> Result<T>,
    ) -> Result<AtValue<T>> {
        match self.at(literal) {
            Ok((states, completeness)) => {
                let mut at = AtValue::new(literal, states.into_iter().map(describe).collect::<Result<_>>()?);
                if completeness == SearchQuality::Doubtful && at.status == Status::NoEquilibrium {
                    at.status = Status::Undecided;
                }
                Ok(at)
            }
            Err(error @ (Error::Undecided { .. } | Error::NoConvergence { .. } | Error::BudgetSpent { .. })) => {
                Ok(AtValue::open(literal, &error))
            }
            Err(error) => Err(error),
        }
    }

    /// All equilibria at values of the controlled quantity.
    ///
    /// # Errors
    /// Errors of [`SearchedBranches::search`] that concern more than one value.
    pub(crate) fn equilibria(&self, values: &[Literal]) -> Result<Vec<AtValue<Equilibrium<Estimate<R>>>>> {
        let describe =
            |state| Ok(equilibrium(self.model, state, self.branches.admissibility()).convert(Estimate::exact));
        values.iter().map(|literal| self.described_at(literal, describe)).collect()
    }

    /// The contact radii of the path, if there is one, and of the equilibria at the values, as far as they are found.
    #[cfg(feature = "mp")]
    pub(crate) fn visited(&self, moved: Option<&Scene>, values: &[Literal]) -> Vec<f64> {
        let path = moved.and_then(|scene| path::follow(self.model, &self.branches, scene).ok());
        let events = path.into_iter().flat_map(|path| path.events);
        let on_path = events
            .flat_map(|event| [event.before, event.after])
            .filter_map(|state| Some(state.contact()?.contact_radius.approx()).filter(|radius| *radius > 0.0));
        let at_values =
            values.iter().flat_map(|value| self.at(value).map_or_else(|_| Vec::new(), |(states, _)| states));
        on_path.chain(at_values.map(|state| state.contact_radius.approx())).filter(|a| a.is_finite()).collect()
    }

    /// The events of the path and the balance of its energy.
    ///
    /// # Errors
    /// No stable equilibrium at the first way point; errors of the transform; an energy that is not representable. See
    /// [`path::follow`] and [`path::with_energy`].
    pub(crate) fn path(&self, scene: &Scene) -> Result<PathNumbers<Estimate<R>>> {
        path::with_energy(&path::follow(self.model, &self.branches, scene)?, &scene.path, &self.branches)
    }

    /// The record of every equilibrium at the values; without values, of the state in which the path starts.
    fn described<T>(
        &self,
        scene: &Scene,
        values: &[Literal],
        describe: impl Fn(contact::Equilibrium<R>) -> Result<T>,
    ) -> Result<Vec<AtValue<T>>> {
        match (values, scene.path.first()) {
            ([], Some(first)) => {
                let state = self.first(scene, first)?;
                Ok(vec![AtValue::new(first, state.into_iter().map(describe).collect::<Result<_>>()?)])
            }
            (values, _) => values.iter().map(|literal| self.described_at(literal, &describe)).collect(),
        }
    }

    /// The equilibrium in which the path starts; `None` if it cannot start, or if the surfaces are apart.
    fn first(&self, scene: &Scene, first: &Literal) -> Result<Option<contact::Equilibrium<R>>> {
        let value = self.model.number(first);
        match Path::first(&self.branches, &scene.start.map(|radius| self.model.number(radius)), &value) {
            Ok(ContactState::Contact(state)) => Ok(Some(self.with_value(state, &value))),
            Ok(_) | Err(Error::NoEquilibrium { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// A field of every equilibrium at the values, or at the start of the path.
    ///
    /// # Errors
    /// Errors that concern more than one value.
    pub(crate) fn fields(
        &self,
        scene: &Scene,
        field: Field,
        values: &[Literal],
        radii: &[Literal],
    ) -> Result<Vec<AtValue<FieldState<Estimate<R>>>>> {
        self.described(scene, values, |state| {
            let fields = Fields::of(self.model.contact(), &state)?;
            let samples = self.samples(field, &fields, radii, &state.contact_radius)?;
            let admissible = self.admission(field, &fields, &state)?;
            Ok(FieldState {
                state: self.model.shown(state).map(|number| Estimate::exact(number.clone())).into(),
                field,
                samples,
                admissible,
            })
        })
    }

    /// Energy and stiffness of every equilibrium at the values, or at the start of the path.
    ///
    /// # Errors
    /// Errors that concern more than one value.
    pub(crate) fn energies(&self, scene: &Scene, values: &[Literal]) -> Result<Vec<AtValue<EnergyState<Estimate<R>>>>> {
        self.described(scene, values, |state| {
            let fields = Fields::of(self.model.contact(), &state)?;
            let energy = Energy::new(self.model.contact())?;
            let potential = energy.potential(&state.contact_radius, &state.indentation);
            let admissible = Admission::of(self.verdict(&state));
            let energy = Value::from_result(potential)?;
            let stiffness = Value::from_result(fields.stiffness())?;
            Ok(EnergyState { state: self.model.shown(state).into(), energy, stiffness, admissible }
                .convert(Estimate::exact))
        })
    }
    /// A field at the radii of the scene, else at fractions of the contact radius.
    fn samples(
        &self,
        field: Field,
        fields: &Fields<R>,
        radii: &[Literal],
        a: &R,
    ) -> Result<Vec<FieldSample<Estimate<R>>>> {
        let value = |r: &R| {
            let value = match field {
                Field::Pressure => estimate(fields.pressure_estimate(r), || fields.pressure(r)),
                Field::Gap => estimate(fields.gap_estimate(r), || fields.gap(r)),
                Field::Displacement => estimate(fields.displacement_estimate(r), || fields.displacement(r)),
            };
            Value::from_result(value)
        };
        let fractions = if field == Field::Pressure { &INSIDE } else { &OUTSIDE };
        let chosen = fractions.iter().filter(|_| radii.is_empty()).map(|&(numerator, denominator)| {
            let r = a.clone().times(numerator).over(denominator);
            (Value::Known(Estimate::exact(r.clone())), r)
        });
        let given = radii.iter().map(|literal| (Value::Given(literal.clone()), self.model.number(literal)));
        chosen.chain(given).map(|(r, at)| Ok(FieldSample { r, value: value(&at)? })).collect()
    }

    /// Whether a state is admissible; with its gap where it is wanted and below zero.
    fn admission(
        &self,
        field: Field,
        fields: &Fields<R>,
        state: &contact::Equilibrium<R>,
    ) -> Result<Admission<Estimate<R>>> {
        let verdict = self.verdict(state);
        let (Field::Gap, Verdict::Interpenetrating { radius, .. }) = (field, &verdict) else {
            return Ok(Admission::of(verdict));
        };
        // As short as it may be: any radius with a negative gap is as good as another.
        for digits in 3..=17 {
            let literal = decimal(*radius, digits)?;
            let gap = fields.gap(&self.model.number(&literal));
            if gap.as_ref().is_ok_and(|gap| *gap < gap.lit(0)) {
                let gap = Value::from_result(gap.map(Estimate::exact))?;
                return Ok(Admission::overlapping(Some(Overlap { r: Value::Given(literal), gap })));
            }
        }
        Ok(Admission::of(verdict))
    }
}

/// A field with its error if digits are decided by it; digits of doubles are not.
fn estimate<R: SceneReal>(estimate: Result<Estimate<R>>, settled: impl FnOnce() -> Result<R>) -> Result<Estimate<R>> {
    if R::INDEX == f64::INDEX { settled().map(Estimate::exact) } else { estimate }
}

/// The branches between radii that many octaves below the folds and above; around w/E* where there is no fold.
pub(crate) fn branches<R: SceneReal>(model: &Model<R>, folds: Folds<R>, octaves: i64) -> SearchedBranches<R> {
    let length = model.contact().material_length();
    let first = folds.folds.first().map_or(&length, |fold| &fold.contact_radius);
    let last = folds.folds.last().map_or(&length, |fold| &fold.contact_radius);
    let [lower, upper] = [length.lit(2).powi(-octaves) * first, length.lit(2).powi(octaves) * last];
    SearchedBranches::cut_at(model.contact(), folds).within(lower, upper)
}
