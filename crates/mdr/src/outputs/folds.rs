//! The output `folds`: where branches of equilibria lose their stability.

#[cfg(feature = "mp")]
use mdr_analytic::certified;
use mdr_core::contact::{self, Edge, FoldKind, Regime, Result, Status};
use mdr_core::number::Literal;
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, Precision, certify::Enclosure};
use mdr_numeric::admissible::GapVerdict;
#[cfg(feature = "mp")]
use mdr_numeric::proof::EnclosedCurve;

use super::key::Key;
use super::room::{Facts, Open, Request, Room as IsRoom, Subject};
use super::{Output, OutputKind, Want};
#[cfg(feature = "mp")]
use crate::answer::Number;
#[cfg(feature = "mp")]
use crate::answer::record::Numbers;
use crate::answer::record::record;
use crate::answer::{Admission, List, Promise, Value};
use crate::scene::{Arithmetic, Scene};
use crate::solve::model::{Model, SceneReal};
use crate::solve::search::{self, Search};
use crate::solve::verdict;
#[cfg(feature = "mp")]
use crate::solve::{
    certified::Certified,
    digits::{as_far_as_known, start},
    power_law::{self, PowerLaw},
    proof::{self, Enclosed, FoldProof},
};

record! {
    /// A fold of the controlled quantity: where a branch of equilibria loses its stability.
    Fold {
        /// a.
        contact_radius: Value<N> = "contact radius" in "m",
        /// d.
        indentation: Value<N> = "indentation" in "m",
        /// F.
        force: Value<N> = "force" in "N",
        /// Whether the controlled quantity has a minimum or a maximum there, along increasing contact radii.
        kind: FoldKind,
        /// Whether the state is admissible.
        admissible: Admission<N>,
        /// With two works of adhesion, the edge whose fold it is.
        edge: Option<Edge>,
    }
}

impl<N> Fold<N> {
    pub(crate) fn new(fold: contact::Fold<N>, verdict: GapVerdict) -> Self {
        let contact::Fold { contact_radius, indentation, force, kind } = fold;
        Fold {
            contact_radius: Value::Known(contact_radius),
            indentation: Value::Known(indentation),
            force: Value::Known(force),
            kind,
            admissible: Admission::of(verdict),
            edge: None,
        }
    }
}

impl Fold {
    /// The quantities of the state, in the order of a, d and F.
    pub fn values(&self) -> [&Value; 3] {
        [&self.contact_radius, &self.indentation, &self.force]
    }

    /// `Ok`, or the status of the first quantity out of range.
    pub fn status(&self) -> Status {
        self.values().into_iter().map(Value::status).find(|status| *status != Status::Ok).unwrap_or(Status::Ok)
    }
}

pub(super) const FACTS: Facts = Facts {
    of: Subject::Contact,
    key: Some(Key::Range),
    question: |keys, _| Want::Folds { range: keys.range.as_ref().map(|(range, _)| range.clone()) },
    unused: no_range,
};

/// Why a range of contact radii for the proof of folds is of no use, where it is of none.
fn no_range(scene: &Scene, kind: OutputKind, _drawn: bool) -> Option<&'static str> {
    let moves = scene.has(|kind| matches!(kind, OutputKind::Equilibria | OutputKind::Path));
    if !moves && !scene.has(|other| other == kind) {
        return Some("neither folds nor equilibria nor a path are wanted");
    }
    if scene.arithmetic == Arithmetic::F64 {
        return Some("nothing is proved in f64");
    }
    #[cfg(feature = "mp")]
    if scene.pressed_into().is_half_space() && scene.profile.exact_power_law(Literal::to_rational).is_some() {
        return Some("the folds of a power law are a closed form, on all radii");
    }
    let searched = !scene.is_enclosed() && scene.exact_rows().is_none();
    searched.then_some("folds of a function, of a table on this medium, or of a quadrature, are searched, not proved")
}

pub(super) struct Room<'w> {
    pub(super) range: &'w Option<[Literal; 2]>,
}

impl<'w> Request<'w> for Room<'w> {
    fn range(&self) -> Option<&'w [Literal; 2]> {
        self.range.as_ref()
    }
}

impl<'w> IsRoom<'w> for Room<'w> {
    #[cfg(feature = "mp")]
    fn by_law(&self, law: &PowerLaw<'_>) -> Result<Option<Output>> {
        let folds = List::new(Promise::Certified, of_answer(law.question.answer(law.digits)?));
        Ok(Some(Output::Folds(folds.complete(power_law::complete()))))
    }

    #[cfg(feature = "mp")]
    fn proved(&self, certified: &Certified<'_>) -> Result<Option<Output>> {
        let folds = match certified.fold_proof()? {
            None => certified.some_folds()?,
            folds => folds,
        };
        folds.map(|folds| proved(certified, folds).map(Output::Folds)).transpose()
    }

    fn searched(&self, search: &Search<'_>) -> Result<Output> {
        let admissibility = search.admissibility();
        let judged = |fold: &contact::Fold<f64>| {
            let verdict = verdict(&admissibility, &fold.contact_radius, &fold.indentation);
            Fold { admissible: Admission::of(verdict), ..shown(&search.model, fold.clone()) }
        };
        let folds: Vec<_> = search.folds()?.folds.iter().map(judged).collect();
        Ok(Output::Folds(search::list(folds).complete(search.completeness()?)))
    }

    fn of_edges(&self, outputs: [Output; 2]) -> Option<Output> {
        let [Output::Folds(advancing), Output::Folds(receding)] = outputs else { return None };
        let of = |edge: Edge| move |fold: Fold| Fold { edge: Some(edge), ..fold };
        let [advancing, receding] = [advancing.map(of(Edge::Advancing)), receding.map(of(Edge::Receding))];
        Some(Output::Folds(advancing.and(receding)))
    }

    fn undecided(&self, open: &Open<'_>) -> Output {
        Output::Folds(List::new(Promise::F64, Vec::new()).complete(open.completeness()))
    }
}

/// A fold as an answer shows it; whether it is admissible is not asked yet.
fn shown<R: SceneReal>(model: &Model<R>, fold: contact::Fold<R>) -> Fold<R> {
    let contact_radius = model.contact_radius(&fold.contact_radius);
    let fold = Fold::new(contact::Fold { contact_radius, ..fold }, GapVerdict::Undecided("it was not asked"));
    Fold { indentation: model.depth(fold.indentation), ..fold }
}

/// # Errors
/// A fold that no precision refines; errors of the transform. See
/// [`EnclosedCurve::refine`](mdr_numeric::proof::EnclosedCurve::refine).
#[cfg(feature = "mp")]
fn proved(certified: &Certified<'_>, folds: &FoldProof) -> Result<List<Fold>> {
    let mut curves = Curves { certified, known: Vec::new() };
    // One fold after the other: of thousands a few need more bits than the others.
    let decided = folds.proved.folds.iter().map(|fold| {
        let record = |model: &Model<_>, refined| {
            let mut record = shown(model, refined).convert(Enclosure::from);
            if certified.scene.breaks_at_zero_depth(&fold.contact_radius) {
                record.indentation = proof::exactly(&0.into());
            }
            vec![record]
        };
        let refined = certified.decide(|precision| {
            let Known { curve, enclosed, .. } = curves.at(precision)?;
            Ok(record(&enclosed.value, curve.refine(fold)?))
        });
        match refined {
            // As many digits as are known already.
            Err(contact::Error::BudgetSpent { .. }) => {
                let digits = digits_of(fold).min(certified.digits);
                let Known { enclosed, .. } = curves.at(start(digits))?;
                Ok(as_far_as_known(digits, record(&enclosed.value, fold.clone())))
            }
            refined => refined,
        }
    });
    let refined = decided.collect::<Result<Vec<_>>>()?.into_iter().flatten();
    // Whether they are admissible is asked once all have their digits, for it may take all that is left of the budget.
    let admissibility = certified.admissibility()?;
    let judged = |(refined, fold): (Fold, &contact::Fold<_>)| {
        let verdict = verdict(&admissibility, &fold.contact_radius, &fold.indentation);
        Fold { admissible: Admission::of(verdict), ..refined }
    };
    let items = refined.zip(&folds.proved.folds).map(judged).collect();
    Ok(List::new(Promise::Certified, items).complete(folds.complete.clone()))
}

/// The digits to which all quantities of a fold are enclosed.
#[cfg(feature = "mp")]
fn digits_of(fold: &contact::Fold<Interval>) -> u32 {
    let bits = [&fold.contact_radius, &fold.indentation, &fold.force].map(Interval::accuracy_bits).into_iter().min();
    // The last one may be a tie.
    let digits = bits.unwrap_or(0).clamp(0, 1 << 20) as f64 * std::f64::consts::LOG10_2 - 1.0;
    (digits as u32).max(1)
}

/// The curve over enclosures in each precision that has been needed.
#[cfg(feature = "mp")]
struct Curves<'c, 's> {
    certified: &'c Certified<'s>,
    known: Vec<Known>,
}

#[cfg(feature = "mp")]
struct Known {
    precision: Precision,
    curve: EnclosedCurve,
    enclosed: Enclosed,
}

#[cfg(feature = "mp")]
impl Curves<'_, '_> {
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    fn at(&mut self, precision: Precision) -> Result<&Known> {
        let place = match self.known.iter().position(|known| known.precision == precision) {
            Some(place) => place,
            None => {
                let enclosed = Enclosed::new(self.certified, precision)?;
                self.known.push(Known { precision, curve: enclosed.curve(), enclosed });
                self.known.len() - 1
            }
        };
        Ok(&self.known[place])
    }
}

/// The folds of a power law by its closed forms: of a machine all of them, else the critical state.
#[cfg(feature = "mp")]
pub(crate) fn of_answer(answer: certified::Answer) -> Vec<Fold> {
    let kind = kind(answer.regime);
    let critical = answer.critical.map(|state| contact::Fold {
        contact_radius: state.contact_radius,
        indentation: state.indentation,
        force: state.force,
        kind,
    });
    let folds = if answer.folds.is_empty() { critical.into_iter().collect() } else { answer.folds };
    let written = |fold| Fold::new(fold, GapVerdict::Admissible).convert(Number::Certified);
    folds.into_iter().map(written).collect()
}

/// The kind of the fold of a power law under fixed grips or a dead load.
pub(crate) fn kind(regime: Regime) -> FoldKind {
    match regime {
        Regime::CompleteContact => FoldKind::Maximum,
        _ => FoldKind::Minimum,
    }
}
