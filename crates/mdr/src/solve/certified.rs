//! A scene in certified digits: enclosures where g is a closed form, two precisions elsewhere.

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Interval, Literal, Precision};
use mdr_numeric::admissible::{Admissibility, Basis};
use mdr_numeric::folds::Folds;
use rug::Float;

use super::digits::{MOST_OF_INTEGRALS, agree, decide, decide_within, start};
use super::model::{Model, SceneReal};
use super::proof::{self, FoldProof};
use super::refine::refined;
use super::search::{Search, not_proved};
use super::states::States;
use super::{Once, once, outputs};
use crate::answer::record::Numbers;
use crate::answer::{
    AtValue, Completeness, EnergyState, Equilibrium, Field, FieldState, List, LoadingPath, Number, Output, Promise,
};
use crate::run::Counts;
use crate::scene::{Scene, Want};

/// Up to this many rows the folds of a table are proved, within some seconds: the cost grows with the square of the rows.
const PROVED_ROWS: usize = 100;

/// Answers a scene with certified digits. An f64 search supplies starting points and never contributes a digit.
pub(crate) struct Certified<'s> {
    pub(super) scene: &'s Scene,
    pub(super) digits: u32,
    counts: &'s Counts,
    search: Once<Search<'s>>,
    folds: Once<Option<FoldProof>>,
    admissibility: Once<Arc<Admissibility>>,
}

/// The states at values, in the arithmetic of an estimate.
type Estimated<T> = Vec<AtValue<T>>;

impl<'s> Certified<'s> {
    pub(crate) fn new(scene: &'s Scene, digits: u32, counts: &'s Counts) -> Self {
        let (search, folds, admissibility) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        Certified { scene, digits, counts, search, folds, admissibility }
    }

    /// Which states are admissible: by the form of the profile, by the proved extrema of g of a formula, else in f64.
    ///
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain; see [`Certified::search`].
    pub(super) fn admissibility(&self) -> Result<Arc<Admissibility>> {
        let found = once(&self.admissibility, || {
            let rises = self.model::<Float>(start(self.digits))?.transform().rises();
            if rises {
                return Ok(Arc::new(Admissibility::of_rising()));
            }
            let searched = self.search()?.admissibility();
            let profile = &self.scene.profile;
            let open = profile.has_formula() && profile.is_enclosed() && searched.basis() != Basis::Bound;
            Ok(if open { proof::isolated(self, &searched)?.map_or(searched, Arc::new) } else { searched })
        });
        found.cloned()
    }

    /// # Errors
    /// Errors of the transform, of the quadratures and of the proofs.
    pub(crate) fn output(&self, want: &Want) -> Result<Output> {
        Ok(match want {
            Want::Transform { at } => Output::Transform(self.transform(at)?),
            Want::Curve { at } if at.is_empty() => Output::Curve(self.curve(&self.search()?.radii()?)?),
            Want::Curve { at } => Output::Curve(self.curve(at)?),
            Want::Folds { .. } => Output::Folds(self.all_folds()?),
            Want::Equilibria { at } => Output::Equilibria(self.equilibria(at)?),
            Want::Path => Output::Path(Box::new(self.path()?)),
            Want::Pressure { states, at } => self.field(Field::Pressure, states, at)?,
            Want::Gap { states, at } => self.field(Field::Gap, states, at)?,
            Want::Displacement { states, at } => self.field(Field::Displacement, states, at)?,
            Want::ForceCurve { points } => {
                let (model, folds) = self.in_doubles()?;
                let states = States::new(&model, folds, self.admissibility()?);
                Output::ForceCurve(Box::new(states.force_curve(self.scene, *points as usize)?))
            }
            Want::Energy { states } => {
                let energies = |at: &States<'_, Float>, states: &[Literal]| at.energies(self.scene, states);
                let items: Vec<AtValue<EnergyState>> = self.estimated_at(states, &energies)?;
                Output::Energy(List::new(Promise::Estimated, items))
            }
        })
    }

    fn field(&self, field: Field, states: &[Literal], radii: &[Literal]) -> Result<Output> {
        let fields = |at: &States<'_, Float>, states: &[Literal]| at.fields(self.scene, field, states, radii);
        let items: Vec<AtValue<FieldState>> = self.estimated_at(states, &fields)?;
        Ok(Output::Field(field, List::new(Promise::Estimated, items)))
    }

    /// The contact in f64, with its search.
    ///
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(super) fn search(&self) -> Result<&Search<'s>> {
        once(&self.search, || Search::of_lengths(self.scene, self.counts))
    }

    /// The contact in another arithmetic.
    pub(super) fn model<R: SceneReal>(&self, ctx: R::Ctx) -> Result<Model<R>> {
        Model::new(self.scene, ctx, self.counts)
    }

    /// The contact in f64 and SI units, with all its folds.
    pub(super) fn in_doubles(&self) -> Result<(Model<f64>, Folds<f64>)> {
        let model: Model<f64> = self.model(())?;
        let folds = refined(&model, self.search()?.folds()?)?;
        Ok((model, folds))
    }

    /// The digits of enclosures, decided at growing precision; `None` if the profile has no enclosures, or if they leave it open
    /// for a formula.
    ///
    /// # Errors
    /// Errors of `f`.
    pub(super) fn proved<T: Numbers<Enclosure>>(
        &self,
        f: impl FnMut(Precision) -> Result<T>,
    ) -> Result<Option<T::With<Number>>> {
        let profile = &self.scene.profile;
        if profile.is_closed() {
            return decide(self.digits, f).map(Some);
        }
        if !profile.is_enclosed() {
            return Ok(None);
        }
        proof::decided(decide_within(MOST_OF_INTEGRALS, start(self.digits), self.digits, f))
    }

    /// g at radii: proved where it has enclosures.
    fn transform(&self, radii: &[Literal]) -> Result<List<crate::answer::TransformSample>> {
        let proved = self.proved(|precision| {
            Ok(outputs::transform(&self.model::<Interval>(precision)?, radii)?.convert(Enclosure::from))
        })?;
        if let Some(items) = proved {
            return Ok(List::new(Promise::Certified, items));
        }
        let items = agree(self.digits, |precision| {
            Ok(outputs::transform(&self.model::<Float>(precision)?, radii)?.convert(Estimate::exact))
        })?;
        Ok(List::new(Promise::Estimated, items))
    }

    /// The equilibria with given radii: proved where g has enclosures.
    fn curve(&self, radii: &[Literal]) -> Result<List<crate::answer::CurvePoint>> {
        let proved = self.proved(|precision| {
            let model = self.model::<Interval>(precision)?;
            Ok(outputs::curve(&model, radii, &*self.admissibility()?)?.convert(Enclosure::from))
        })?;
        if let Some(items) = proved {
            return Ok(List::new(Promise::Certified, items));
        }
        let items = agree(self.digits, |precision| {
            let model = self.model::<Float>(precision)?;
            Ok(outputs::curve(&model, radii, &*self.admissibility()?)?.convert(Estimate::exact))
        })?;
        Ok(List::new(Promise::Estimated, items))
    }

    /// All folds: proved where that can be.
    fn all_folds(&self) -> Result<List<crate::answer::Fold>> {
        if let Some(folds) = self.fold_proof()? {
            return proof::folds(self, folds);
        }
        let items = agree(self.digits, |precision| {
            let model = self.model::<Float>(precision)?;
            let admissibility = self.admissibility()?;
            let folds = refined(&model, self.search()?.folds()?)?.folds.into_iter();
            Ok(folds.map(|fold| outputs::fold(fold, &admissibility)).collect::<Vec<_>>().convert(Estimate::exact))
        })?;
        Ok(List::new(Promise::Estimated, items).complete(self.searched()?))
    }

    /// All equilibria: proved where the folds are.
    fn equilibria(&self, values: &[Literal]) -> Result<List<AtValue<Equilibrium>>> {
        if let Some(folds) = self.fold_proof()? {
            if let Some(list) = proof::equilibria(self, folds, values)? {
                return Ok(list);
            }
            if folds.complete.proved && values.len() > 1 {
                return self.equilibria_one_by_one(folds, values);
            }
        }
        let items = self.estimated_equilibria(values)?;
        Ok(List::new(Promise::Estimated, items).complete(self.searched()?))
    }

    fn estimated_equilibria(&self, values: &[Literal]) -> Result<Vec<AtValue<Equilibrium>>> {
        self.estimated_at(values, &|states, values| states.equilibria(values))
    }

    /// The results at values, at two precisions; where these do not agree, each value for itself.
    fn estimated_at<T>(
        &self,
        values: &[Literal],
        compute: &impl Fn(&States<'_, Float>, &[Literal]) -> Result<Estimated<T>>,
    ) -> Result<Vec<AtValue<Printed<T>>>>
    where
        T: Numbers<Estimate<Float>> + Clone,
    {
        match (self.estimated(|states| compute(states, values)), values) {
            (Err(error @ Error::Undecided { .. }), [value]) => Ok(vec![AtValue::open(value, &error)]),
            (Err(Error::Undecided { .. }), [_, _, ..]) => {
                let each = values.iter().map(|value| self.estimated_at(std::slice::from_ref(value), compute));
                Ok(each.collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
            }
            (items, _) => items,
        }
    }

    /// Each value for itself: proved where that can be, and whether it is.
    fn equilibria_one_by_one(&self, folds: &FoldProof, values: &[Literal]) -> Result<List<AtValue<Equilibrium>>> {
        let at = |value: &Literal| {
            let values = std::slice::from_ref(value);
            let proved = proof::equilibria_at(self, folds, values)?;
            let flag = Some(proved.is_some());
            let items = proved.map_or_else(|| self.estimated_equilibria(values), Ok)?;
            Ok(items.into_iter().map(|item| AtValue { proved: flag, ..item }).collect::<Vec<_>>())
        };
        let items = values.iter().map(at).collect::<Result<Vec<_>>>()?.concat();
        let mut searched = self.searched()?;
        searched.why = format!("at the values that are not marked as proved {}", searched.why);
        Ok(List::new(Promise::Estimated, items).complete(searched))
    }

    /// The path: proved where the folds are, except for the energy.
    fn path(&self) -> Result<LoadingPath> {
        let folds = self.fold_proof()?;
        if let Some(folds) = folds
            && let Some((proved, followed)) = proof::path(self, folds)?
        {
            return Ok(match followed.with_energy(self, folds) {
                Ok(path) => proved.with_energy_of(Promise::Estimated, path),
                Err(error) => proved.without_energy(&error.to_string()),
            });
        }
        let estimated = self.estimated(|states| states.path(self.scene))?;
        let mut searched = self.searched()?;
        if let Some(Completeness { proved: true, from, to, .. }) = folds.map(|folds| &folds.complete) {
            let [from, to] = [from, to].map(|end| end.as_deref().unwrap_or("infinity").to_owned());
            searched.why += &format!("; not every state of the path is proved within radii from {from} to {to} m");
        }
        Ok(LoadingPath::new(Promise::Estimated, estimated, searched))
    }

    /// The folds on which proofs rest: of closed forms, and of formulas and of tables that are short, where they leave nothing
    /// undecided. A longer or a rougher table, and a formula with more waves than can be looked at, is better searched.
    fn fold_proof(&self) -> Result<Option<&FoldProof>> {
        let profile = &self.scene.profile;
        let folds = once(&self.folds, || {
            Ok(match profile.rows() {
                None if profile.is_closed() => Some(FoldProof::new(self)?),
                None if profile.is_enclosed() => {
                    proof::decided(FoldProof::new(self))?.filter(|folds| folds.complete.proved)
                }
                Some(rows) if rows <= PROVED_ROWS => Some(FoldProof::new(self)?).filter(|folds| folds.complete.proved),
                _ => None,
            })
        });
        folds.map(Option::as_ref)
    }

    /// The results at states that were found in f64.
    fn estimated<T: Numbers<Estimate<Float>> + Clone>(
        &self,
        compute: impl Fn(&States<'_, Float>) -> Result<T>,
    ) -> Result<Printed<T>> {
        let folds = self.search()?.folds()?;
        agree(self.digits, |precision| {
            let model = self.model::<Float>(precision)?;
            let folds = refined(&model, folds)?;
            compute(&States::new(&model, folds, self.admissibility()?))
        })
    }

    fn searched(&self) -> Result<Completeness> {
        let search = self.search()?.completeness()?;
        let long = match self.scene.profile.rows() {
            Some(rows) if rows > PROVED_ROWS => {
                format!("; tables are proved up to {PROVED_ROWS} rows, this has {rows}")
            }
            _ => String::new(),
        };
        Ok(not_proved(&format!("{}; found in f64, then sharpened{long}", search.why)))
    }
}

/// Records with their digits decided.
type Printed<T> = <<T as Numbers<Estimate<Float>>>::With<Enclosure> as Numbers<Enclosure>>::With<Number>;
