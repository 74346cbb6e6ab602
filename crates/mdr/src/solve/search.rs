//! A scene in f64: folds are searched by a survey of the tangency ratio.

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Fold, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::folds::{self, Folds, OutOfRangeFold, SearchQuality};

use super::model::Model;
use super::states::States;
use super::{Once, admissible, once, outputs, sample};
use crate::answer::record::Numbers;
use crate::answer::{Completeness, Field, List, LoadingPath, Number, Output, Promise, Value};
use crate::run::Counts;
use crate::scene::{Scene, Want};

/// The contact in f64; its folds are searched when something needs them, and once.
pub(crate) struct Search<'s> {
    scene: &'s Scene,
    pub(crate) model: Model<f64>,
    folds: Once<Folds<f64>>,
    admissibility: OnceCell<Arc<Admissibility>>,
    /// Whether a fold is of use without its force, which is out of range.
    radii_suffice: bool,
}

impl<'s> Search<'s> {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn new(scene: &'s Scene, counts: &Counts) -> Result<Self> {
        Ok(Search::with(scene, Model::new(scene, (), counts)?, false))
    }

    /// The lengths of the contact alone, for other arithmetics to start from. Folds whose force is out of range are among them.
    ///
    /// # Errors
    /// A number that no double holds; a parameter out of its domain. See [`Model::in_units_of_modulus`].
    #[cfg(feature = "mp")]
    pub(crate) fn of_lengths(scene: &'s Scene, counts: &Counts) -> Result<Self> {
        Ok(Search::with(scene, Model::in_units_of_modulus(scene, counts)?, true))
    }

    fn with(scene: &'s Scene, model: Model<f64>, radii_suffice: bool) -> Self {
        Search { scene, model, folds: OnceCell::new(), admissibility: OnceCell::new(), radii_suffice }
    }

    /// The admissible states: searched when they are needed, and once, around the folds that were found.
    pub(crate) fn admissibility(&self) -> Arc<Admissibility> {
        let search = || {
            let rises = self.model.transform().rises();
            let folds = self.folds().ok().filter(|_| !rises);
            let radii: Vec<f64> =
                folds.into_iter().flat_map(|folds| folds.iter().map(|fold| fold.contact_radius)).collect();
            let length = self.model.contact().material_length();
            let transform = Arc::clone(self.model.contact().shared_transform());
            Arc::new(admissible::of_scene(self.scene, transform, length, &radii))
        };
        Arc::clone(self.admissibility.get_or_init(search))
    }

    /// # Errors
    /// Errors of the transform at a fold; see [`folds::find`].
    pub(crate) fn folds(&self) -> Result<&Folds<f64>> {
        once(&self.folds, || {
            let curve = self.model.contact();
            let mut found = folds::find(&curve)?;
            for OutOfRangeFold { contact_radius, kind, error } in std::mem::take(&mut found.out_of_range) {
                if !self.radii_suffice {
                    return Err(error);
                }
                let indentation = curve.indentation(&contact_radius)?;
                found.folds.push(Fold { contact_radius, indentation, force: f64::NAN, kind });
            }
            found.folds.sort_by(|one, other| one.contact_radius.total_cmp(&other.contact_radius));
            Ok(found)
        })
    }

    /// # Errors
    /// Errors of the transform and of the quadratures.
    pub(crate) fn output(&self, want: &Want) -> Result<Output> {
        let field = |field, states: &[Literal], at: &[Literal]| {
            Ok(Output::Field(field, list(self.states()?.fields(self.scene, field, states, at)?)))
        };
        Ok(match want {
            Want::Transform { at } => {
                Output::Transform(list(outputs::transform(&self.model, at)?.convert(Estimate::exact)))
            }
            Want::Folds { .. } => {
                let judged = |fold: &Fold<f64>| outputs::fold(&self.model, fold.clone(), &self.admissibility());
                let folds: Vec<_> = self.folds()?.folds.iter().map(judged).collect();
                Output::Folds(list(folds.convert(Estimate::exact)).complete(self.completeness()?))
            }
            Want::Curve { at } => {
                let radii = if at.is_empty() { &self.radii()? } else { at };
                let points = outputs::curve(&self.model, radii, &self.admissibility())?;
                Output::Curve(list(points.convert(Estimate::exact)))
            }
            Want::Equilibria { at } => {
                Output::Equilibria(list(self.states()?.equilibria(at)?).complete(self.completeness()?))
            }
            Want::Path => {
                let path = doubles(self.states()?.path(self.scene)?);
                Output::Path(Box::new(LoadingPath::new(Promise::Double, path, self.completeness()?)))
            }
            Want::Pressure { states, at } => return field(Field::Pressure, states, at),
            Want::Gap { states, at } => return field(Field::Gap, states, at),
            Want::Displacement { states, at } => return field(Field::Displacement, states, at),
            Want::ForceCurve { points } => {
                Output::ForceCurve(Box::new(self.states()?.force_curve(self.scene, *points as usize)?))
            }
            Want::Energy { states } => Output::Energy(list(self.states()?.energies(self.scene, states)?)),
        })
    }

    fn states(&self) -> Result<States<'_, f64>> {
        Ok(States::new(&self.model, self.folds()?.clone(), self.admissibility()))
    }

    /// The contact radii to which the path of the scene leads, and those of the equilibria at its values, as far as they are
    /// found, and if the scene requests any.
    #[cfg(feature = "mp")]
    pub(crate) fn visited(&self) -> Vec<f64> {
        let wants = &self.scene.wants;
        let moves = wants.contains(&Want::Path);
        let values = wants.iter().find(|want| want.kind() == crate::answer::OutputKind::Equilibria).map(Want::values);
        match self.states() {
            Ok(states) if moves || values.is_some() => {
                states.visited(moves.then_some(self.scene), values.unwrap_or_default())
            }
            _ => Vec::new(),
        }
    }

    /// The contact radii of `curve` where the scene names none.
    pub(crate) fn radii(&self) -> Result<Vec<Literal>> {
        sample::radii(&self.model, self.folds()?)
    }

    pub(crate) fn completeness(&self) -> Result<Completeness> {
        Ok(match self.folds()?.completeness {
            SearchQuality::Resolved => not_proved("searched over all radii in f64"),
            SearchQuality::Doubtful => not_proved("searched in f64, and not resolved everywhere: folds may be missing"),
        })
    }
}

/// A list that is not proved to be complete.
pub(crate) fn not_proved(why: &str) -> Completeness {
    Completeness { proved: false, from: None, to: None, why: why.to_owned() }
}

fn list<T: Numbers<Estimate<f64>>>(records: Vec<T>) -> List<T::With<Number>> {
    List::new(Promise::Double, doubles(records))
}

/// Doubles as they are printed; one that is no number is out of range.
pub(crate) fn doubles<T: Numbers<Estimate<f64>>>(records: T) -> T::With<Number> {
    records.resolve(|Estimate { value, .. }| {
        if value.is_finite() {
            Value::Known(Number::Double(value))
        } else {
            Value::Unknown { status: Status::Overflow, log10: None, why: None }
        }
    })
}
