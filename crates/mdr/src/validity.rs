//! Whether the theory holds for a contact: Tabor's number, the correction by Maugis and Dugdale, and the slope at the edge.
//!
//! The theory of this library is that of adhesion of short range (JKR). It is for a contact whose edge opens, before it breaks,
//! by far more than the range z₀ of the attraction: the generalised Tabor number μ = Δl(a)/(c_T z₀), c_T = √(2π(9π/8)^(1/3)), is
//! large. For a paraboloid it is Tabor's own (Rw²/(E*²z₀³))^(1/3). Formulas and sources are in [`mdr_numeric::dugdale`].

#[cfg(feature = "mp")]
mod digits;

use std::cell::OnceCell;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Control, Error, Fold, FoldKind, Result, Status};
use mdr_core::named;
use mdr_core::number::{Literal, Real};
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation, tabor_number};
use mdr_numeric::folds::Folds;

use crate::answer::record::{Numbers, Row, constant_parts, record};
use crate::answer::{Admission, Cell, Optional, Promise, Value};
use crate::run::{Counts, lack};
use crate::scene::{Profile, Scene};
use crate::solve::model::{Model, SceneReal};
use crate::solve::search::{Search, doubles};
use crate::solve::verdict;

named! {
    /// The theory of adhesion that a Tabor number calls for.
    pub enum AdhesionRegime {
        /// μ > 5: short range, the theory of this library.
        Jkr = "JKR",
        /// 0.1 ≤ μ ≤ 5: neither limit; Maugis–Dugdale.
        Transition = "transition",
        /// μ < 0.1: long range, the attraction does not deform the bodies.
        Dmt = "DMT",
        /// There is no instability under a dead load, and no Tabor number.
        Unknown = "unknown",
    }
}

impl AdhesionRegime {
    fn of(tabor: f64) -> Self {
        match tabor {
            mu if mu > 5.0 => AdhesionRegime::Jkr,
            mu if mu < 0.1 => AdhesionRegime::Dmt,
            mu if mu.is_nan() => AdhesionRegime::Unknown,
            _ => AdhesionRegime::Transition,
        }
    }

    /// The consequence for the numbers of the short-range theory, in a sentence.
    pub fn advice(self) -> &'static str {
        match self {
            AdhesionRegime::Jkr => "the theory of short range holds: the Tabor number is above 5",
            AdhesionRegime::Transition => {
                "neither limit holds: between Tabor numbers of 0.1 and 5 take the pull-off force by Maugis and Dugdale"
            }
            AdhesionRegime::Dmt => {
                "the theory of short range does not hold: the Tabor number is below 0.1, the attraction acts around the contact \
                 and hardly deforms the bodies (DMT)"
            }
            AdhesionRegime::Unknown => {
                "there is no instability under a dead load, whose contact radius a Tabor number could be taken at"
            }
        }
    }
}

record! {
    /// The validity of the short-range theory for a contact, by the range of adhesion z₀, all of it under a dead load.
    Validity {
        /// z₀, in m.
        range_of_adhesion: Literal = "range of adhesion" in "m",
        /// The generalised Tabor number μ at `contact_radius`.
        tabor: Value<N> = "Tabor number" in "",
        /// The regime of adhesion at this μ.
        regime: AdhesionRegime,
        /// a at the pull-off of the short-range theory; where there is none, at the fold beyond which the contact spreads.
        contact_radius: Value<N> = "contact radius" in "m",
        /// The pull-off force F of the short-range theory: exactly 0 if a contact shrinks to nothing first (n < 1/2); `None` if
        /// the contact never breaks.
        jkr_pull_off: Option<Value<N>> = "JKR pull-off force" in "N",
        /// The pull-off force F by Maugis and Dugdale.
        maugis_dugdale_pull_off: Value<N> = "Maugis-Dugdale pull-off force" in "N",
        /// Their ratio less one; `None` if the short-range pull-off force is 0 or there is none.
        correction: Option<Value<N>> = "Maugis-Dugdale / JKR - 1" in "",
        /// a of that state, within which the surfaces touch.
        maugis_dugdale_contact_radius: Value<N> = "Maugis-Dugdale contact radius" in "m",
        /// c of that state, up to which they attract each other.
        maugis_dugdale_outer_radius: Value<N> = "radius of the attraction" in "m",
        /// d of that state.
        maugis_dugdale_indentation: Value<N> = "Maugis-Dugdale indentation" in "m",
        /// g'(a) at `contact_radius`: the half-space requires slopes far below 1. For a paraboloid it is 2a/R.
        slope: Value<N> = "slope g'(a)" in "",
        /// a/R at `contact_radius`, of a profile with a radius of curvature R.
        a_over_r: Optional<N> = "a/R" in "",
        /// Whether the state at `contact_radius` is admissible.
        admissible: Option<Admission<N>>,
    }
}

constant_parts! {
    AdhesionRegime: |regime, key, row| row.cells.push((key, Cell::Word(regime.name())));
}

impl Validity {
    /// The row of the validity, whose cells have the keys of an answer.
    pub fn row(&self) -> Row<'_> {
        self.rows().remove(0)
    }

    /// How far its numbers can be trusted. In certified digits every digit is proved, on a homogeneous half-space of shapes, formulas
    /// and their sums: at `contact_radius` there is a fold, and a minimum of the force along the states with a ring has these numbers.
    /// That no other minimum is lower is found by a search in f64, as `regime` and `admissible` are. Where a proof does not succeed, the
    /// numbers are doubles.
    pub fn promise(&self) -> Promise {
        let numbers = [&self.tabor, &self.contact_radius, &self.maugis_dugdale_pull_off, &self.slope];
        numbers.into_iter().find_map(Value::promise).unwrap_or(Promise::F64)
    }

    /// The consequence for the numbers, in sentences.
    pub fn advice(&self) -> String {
        let change = self.correction.as_ref().and_then(Value::to_f64).map_or_else(String::new, |correction| {
            format!("; adhesion of finite range changes the pull-off force by {:+.2} %", 100.0 * correction)
        });
        let steep = self.slope.to_f64().filter(|slope| *slope > STEEP).map_or_else(String::new, |slope| {
            format!("; the slope g'(a) = {slope:.2} is not small, as the theory of the half-space assumes")
        });
        let sharp = match &self.jkr_pull_off {
            Some(Value::Given(_)) => {
                "; a pull-off force of exactly 0 is the limit of short range, take that by Maugis and Dugdale"
            }
            _ => "",
        };
        format!("{}{change}{sharp}{steep}", self.regime.advice())
    }
}

/// The slope of a paraboloid at a/R = 0.3, above which a contact is not small.
const STEEP: f64 = 0.6;

/// The validity of the theory by the range of adhesion of a scene; `None` without one.
///
/// # Errors
/// A number of the scene that is out of its domain; [`Error::Stopped`].
pub(crate) fn of(scene: &Scene, counts: &Counts) -> Result<Option<Validity>> {
    let Some(range) = &scene.range_of_adhesion else { return Ok(None) };
    // Pull-off is that of a dead load, whatever the scene controls.
    let scene = &scene.clone().control(Control::Force);
    Ok(Some(match scene.arithmetic {
        #[cfg(feature = "mp")]
        crate::scene::Arithmetic::Certified { digits } if scene.has_proofs() => {
            digits::of(scene, range, digits, counts)?
        }
        _ => Found::new(scene, range, Search::new(scene, counts)?)?.in_doubles()?,
    }))
}

/// What a search in f64 finds, from which other arithmetics start.
struct Found<'s> {
    scene: &'s Scene,
    range: &'s Literal,
    search: Search<'s>,
    /// The folds of the short-range theory under a dead load.
    folds: Result<Folds<f64>>,
    pull_off: OnceCell<Result<Option<CohesiveState<f64>>>>,
}

impl<'s> Found<'s> {
    fn new(scene: &'s Scene, range: &'s Literal, search: Search<'s>) -> Result<Self> {
        let folds = lack(search.folds().cloned())?;
        Ok(Found { scene, range, search, folds, pull_off: OnceCell::new() })
    }

    /// The pull-off by Maugis and Dugdale, which is looked for once; `None` if the contact does not break.
    fn pull_off(&self) -> &Result<Option<CohesiveState<f64>>> {
        self.pull_off.get_or_init(|| {
            let model = &self.search.model;
            let contact = Dugdale::new(model.contact(), &separation(&model.number(self.range)))?;
            contact.pull_off(&radii(&self.folds))
        })
    }

    /// The fold at which the contact breaks or spreads.
    fn fold(&self) -> Result<Fold<f64>> {
        self.folds.as_ref().map_err(Clone::clone).and_then(instability)
    }

    fn in_doubles(&self) -> Result<Validity> {
        let record = self.record(&self.search.model, self.fold(), |_| self.pull_off().clone())?;
        Ok(doubles(record.convert(Estimate::exact)))
    }

    /// The record, from a contact, its fold and its pull-off in an arithmetic.
    fn record<R: SceneReal>(
        &self,
        model: &Model<R>,
        fold: Result<Fold<R>>,
        pull_off: impl FnOnce(&Dugdale<R>) -> Result<Option<CohesiveState<R>>>,
    ) -> Result<Validity<R>> {
        let (curve, z0) = (model.contact(), model.number(self.range));
        let fold = lack(fold)?;
        let at = |of: &dyn Fn(&R) -> Result<R>| {
            value(fold.as_ref().map_err(Clone::clone).and_then(|fold| of(&fold.contact_radius)))
        };
        let tabor = at(&|a| tabor_number(&curve, a, &z0))?;
        let regime = match &tabor {
            Value::Known(tabor) => AdhesionRegime::of(tabor.approx()),
            _ => AdhesionRegime::Unknown,
        };
        let jkr = match &fold {
            Ok(fold) if fold.kind == FoldKind::Minimum => Some(Value::Known(fold.force.clone())),
            _ => vanishes(model, fold.as_ref().ok())?.then(|| Value::Given(0.into())),
        };
        let state = lack(Dugdale::new(curve, &separation(&z0)).and_then(|dugdale| pull_off(&dugdale)))?;
        let part = |part: fn(&CohesiveState<R>) -> &R| match &state {
            Ok(Some(state)) => Ok(Value::Known(part(state).clone())),
            Ok(None) => Ok(Value::unknown(Status::NoEquilibrium, "the contact spreads by itself and does not break")),
            Err(error) => value(Err(error.clone())),
        };
        let force = part(|state| &state.force)?;
        let correction = match (&force, &jkr) {
            (Value::Known(force), Some(Value::Known(jkr))) => Some(Value::Known(force.clone() / jkr - jkr.lit(1))),
            _ => None,
        };
        let curvature = match self.scene.profile() {
            Profile::Shape(shape) => shape.curvature_radius(),
            _ => None,
        };
        let a_over_r = curvature.map(|radius| at(&|a| Ok(a.clone() / model.number(radius)))).transpose()?;
        let admissibility = self.search.admissibility();
        let admissible = fold
            .as_ref()
            .ok()
            .map(|fold| Admission::of(verdict(&admissibility, &fold.contact_radius, &fold.indentation)));
        Ok(Validity {
            range_of_adhesion: self.range.clone(),
            tabor,
            regime,
            contact_radius: at(&|a| Ok(a.clone()))?,
            jkr_pull_off: jkr,
            maugis_dugdale_pull_off: force,
            correction,
            maugis_dugdale_contact_radius: part(|state| &state.contact_radius)?,
            maugis_dugdale_outer_radius: part(|state| &state.outer_radius)?,
            maugis_dugdale_indentation: part(|state| &state.indentation)?,
            slope: at(&|a| model.transform().slope(a))?,
            a_over_r: Optional(a_over_r),
            admissible,
        })
    }
}

/// Where the search for the pull-off begins.
fn radii<R: Real>(folds: &Result<Folds<R>>) -> Vec<R> {
    folds.iter().flat_map(|folds| folds.iter().map(|fold| fold.contact_radius.clone())).collect()
}

/// The state at which the contact breaks under a dead load: the lowest minimum of the force; else the fold beyond which it
/// spreads.
fn instability<R: Real>(folds: &Folds<R>) -> Result<Fold<R>> {
    let mut minima: Vec<_> = folds.iter().filter(|fold| fold.kind == FoldKind::Minimum).collect();
    minima.sort_by(|one, other| mdr_core::number::order(&one.force, &other.force));
    let found = minima.first().copied().or(folds.last()).cloned();
    found.ok_or(Error::NoEquilibrium { quantity: mdr_core::contact::Quantity::Force, value: "a fold".to_owned() })
}

/// Whether a contact without a minimum of the force is stable under a dead load down to the smallest radii: the force then tends
/// to zero as the contact does.
fn vanishes<R: SceneReal>(model: &Model<R>, fold: Option<&Fold<R>>) -> Result<bool> {
    let curve = model.contact();
    let scale = fold.map_or_else(|| curve.material_length(), |fold| fold.contact_radius.clone());
    let near = scale.lit(2).powi(-30) * scale;
    Ok(lack(curve.tangency(&near))?.is_ok_and(|ratio| ratio > near.lit(3)))
}

/// A number that may be lacking; an error that concerns the whole computation is returned.
fn value<R>(result: Result<R>) -> Result<Value<R>> {
    match result {
        Err(Error::Undecided { what, .. }) => Ok(Value::unknown(Status::Undecided, what)),
        Err(Error::NoEquilibrium { .. }) => Ok(Value::unknown(Status::NoEquilibrium, AdhesionRegime::Unknown.advice())),
        result => Value::from_result(result),
    }
}
