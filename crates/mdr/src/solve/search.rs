//! A scene in f64: folds are searched by a survey of the tangency ratio.

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Budget, Edge, Fold, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::folds::{self, Folds, OutOfRangeFold, SearchQuality};

use super::model::Model;
use super::states::States;
use super::weight::weight;
use super::{Once, admissible, once};
use crate::answer::record::Numbers;
use crate::answer::{Completeness, List, Number, Promise, Value};
use crate::run::Counts;
use crate::scene::Scene;

/// The heights of a formula that a search may evaluate before its folds are proved, a second or two of work: more than any but waves without
/// end take, of which the first folds are proved.
#[cfg(feature = "mp")]
const BEFORE_PROOF: u64 = 2_500_000;

/// The part of the budget, inverse, that a search for the folds of a formula may take.
const PART_OF_SEARCH: u64 = 3;

/// The contact in f64; its folds are searched when something needs them, and once.
pub(crate) struct Search<'s> {
    pub(crate) scene: &'s Scene,
    pub(crate) model: Model<f64>,
    folds: Once<Folds<f64>>,
    admissibility: OnceCell<Arc<Admissibility>>,
    /// Whether a fold is of use without its force, which is out of range.
    radii_suffice: bool,
    /// What has to be said beside how folds were searched.
    remark: Option<String>,
    /// Whether a proof of its folds was begun and not finished.
    is_open: bool,
    budget: Arc<Budget>,
}

impl<'s> Search<'s> {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn new(scene: &'s Scene, counts: &Counts) -> Result<Self> {
        Ok(Search::with(scene, Model::new(scene, (), counts)?, false, counts[0].budget()))
    }

    /// The lengths of the contact alone, for other arithmetics to start from. Folds whose force is out of range are among them.
    ///
    /// # Errors
    /// A number that no double holds; a parameter out of its domain. See [`Model::in_units_of_modulus`].
    #[cfg(feature = "mp")]
    pub(crate) fn of_lengths(scene: &'s Scene, counts: &Counts) -> Result<Self> {
        Ok(Search::with(scene, Model::in_units_of_modulus(scene, counts)?, true, counts[0].budget()))
    }

    /// The contact in SI units, with the folds that were found at its lengths.
    ///
    /// # Errors
    /// A number that is out of the range of doubles; errors of the transform at a fold.
    #[cfg(feature = "mp")]
    pub(crate) fn in_units(&self, counts: &Counts) -> Result<Self> {
        let search = Search::new(self.scene, counts)?;
        let (curve, found) = (search.model.contact(), self.folds()?);
        let scale = self.scene.scale_of_forces().nearest_f64();
        let state = |fold: &Fold<f64>| {
            let force = scale * fold.force;
            // Without another evaluation where the number is one: the budget may be spent.
            if force.is_normal() {
                return Ok(Fold { force, ..fold.clone() });
            }
            let (indentation, force) = curve.state(&fold.contact_radius)?;
            Ok(Fold { indentation, force, ..fold.clone() })
        };
        let folds = found.folds.iter().map(state).collect::<Result<_>>()?;
        Ok(Search { folds: OnceCell::from(Ok(Folds { folds, ..found.clone() })), ..search })
    }

    fn with(scene: &'s Scene, model: Model<f64>, radii_suffice: bool, budget: &Arc<Budget>) -> Self {
        let (folds, admissibility, budget) = (OnceCell::new(), OnceCell::new(), Arc::clone(budget));
        Search { scene, model, folds, admissibility, radii_suffice, remark: None, is_open: false, budget }
    }

    /// With what is known of the admissible states, something to be said beside how folds were searched, and whether a proof was left
    /// open.
    #[cfg(feature = "mp")]
    pub(crate) fn knowing(self, admissibility: Arc<Admissibility>, remark: Option<String>, is_open: bool) -> Self {
        Search { admissibility: OnceCell::from(admissibility), remark, is_open, ..self }
    }

    /// The contact at the work of adhesion of one edge; `scene` is that of the edge.
    pub(crate) fn at<'t>(&self, scene: &'t Scene, edge: Edge) -> Search<'t> {
        Search::with(scene, self.model.at(edge), self.radii_suffice, &self.budget)
    }

    /// The admissible states: searched when they are needed, and once, around the folds that were found.
    pub(crate) fn admissibility(&self) -> Arc<Admissibility> {
        let search = || {
            let radii = if self.model.transform().rises() { Vec::new() } else { self.notable_radii() };
            let length = self.model.contact().material_length();
            let transform = Arc::clone(self.model.contact().shared_transform());
            Arc::new(admissible::on_medium(&self.scene.profile, &self.scene.medium, transform, length, &radii))
        };
        Arc::clone(self.admissibility.get_or_init(search))
    }

    /// Contact radii around which g matters: of the folds that were found, or the ends of the range on which folds are to be proved.
    fn notable_radii(&self) -> Vec<f64> {
        match &self.scene.range {
            Some(range) if self.radii_suffice => range.iter().map(Literal::nearest_f64).collect(),
            _ => self.folds().ok().into_iter().flat_map(|folds| folds.iter().map(|fold| fold.contact_radius)).collect(),
        }
    }

    /// # Errors
    /// Errors of the transform at a fold; see [`folds::find`].
    pub(crate) fn folds(&self) -> Result<&Folds<f64>> {
        once(&self.folds, || {
            let curve = self.model.contact();
            let mut found = match self.most_heights() {
                Some(heights) => folds::find_within(&curve, heights),
                None => folds::find(&curve),
            }?;
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

    /// The most heights of a formula for a search: fewer where a proof by integrals follows it, and of waves without end no more than leave
    /// something of the budget for states.
    fn most_heights(&self) -> Option<u64> {
        #[cfg(feature = "mp")]
        if self.radii_suffice && self.scene.takes_integrals() {
            return Some(BEFORE_PROOF);
        }
        let left = self.budget.left().filter(|_| self.scene.profile.has_formula())?;
        Some(left / PART_OF_SEARCH / weight(&self.scene.profile, 0, f64::MANTISSA_DIGITS).max(1))
    }

    /// The equilibria around the folds.
    ///
    /// # Errors
    /// Errors of the transform at a fold; see [`folds::find`].
    pub(crate) fn states(&self) -> Result<States<'_, f64>> {
        Ok(States::new(self.scene, &self.model, self.folds()?.clone(), self.admissibility()))
    }

    /// The contact radii to which the outputs of the scene lead, as far as they are found.
    #[cfg(feature = "mp")]
    pub(crate) fn visited(&self) -> Vec<f64> {
        self.scene.wants.iter().flat_map(|want| want.room().visited(self)).collect()
    }

    /// Whether the search for folds found them all; no proof.
    ///
    /// # Errors
    /// Errors of the transform at a fold; see [`folds::find`].
    pub(crate) fn completeness(&self) -> Result<Completeness> {
        let why = match self.folds()?.completeness {
            SearchQuality::Resolved => "searched over all radii in f64",
            SearchQuality::Doubtful => "searched in f64, and not resolved everywhere: folds may be missing",
        };
        let complete = not_proved(&format!("{why}{}", self.remark.as_deref().unwrap_or_default()));
        Ok(Completeness { undecided: self.is_open, ..complete })
    }
}

/// A list that is not proved to be complete.
pub(crate) fn not_proved(why: &str) -> Completeness {
    Completeness { proved: false, from: None, to: None, why: why.to_owned(), undecided: false }
}

/// A list of doubles, each marked where it is out of range.
pub(crate) fn list<T: Numbers<f64>>(records: Vec<T>) -> List<T::With<Number>> {
    List::new(Promise::F64, records.resolve(double))
}

/// Doubles as they are printed; one that is no number is out of range.
pub(crate) fn doubles<T: Numbers<Estimate<f64>>>(records: T) -> T::With<Number> {
    records.resolve(|Estimate { value, .. }| double(value))
}

fn double(value: f64) -> Value {
    if value.is_finite() {
        Value::Known(Number::F64(value))
    } else {
        Value::Unknown { status: Status::Overflow, log10: None, why: None }
    }
}
