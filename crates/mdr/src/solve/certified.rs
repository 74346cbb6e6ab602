//! A scene in certified digits: enclosures of closed forms, of integrals and of sums over rows.

use std::cell::{OnceCell, RefCell};
use std::sync::Arc;

use mdr_core::contact::{Error, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Precision, Real};
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::contact::Contact;
use mdr_numeric::folds::Folds;
use mdr_numeric::proof::{CurveInDoubles, EnclosedEnergy};

use super::digits::{MOST, MOST_OF_DECISIONS, MOST_OF_INTEGRALS, decide_within, start};
use super::model::{Model, SceneReal, counted};
use super::proof::{self, FoldProof};
use super::rigorous::{Formulas, with_energies, without_energies};
use super::rows::PROVED_ROWS;
use super::search::Search;
use super::weight::weight_in_doubles;
use super::{Once, once};
use crate::answer::record::Numbers;
use crate::answer::{Number, Output};
use crate::run::Counts;
use crate::scene::Scene;

/// Answers a scene with certified digits. An f64 search supplies starting points and never contributes a digit.
pub(crate) struct Certified<'s> {
    pub(crate) scene: &'s Scene,
    pub(crate) digits: u32,
    pub(crate) counts: &'s Counts,
    search: Once<Search<'s>>,
    plain: Once<Search<'s>>,
    folds: Once<Option<FoldProof>>,
    /// Why a proof of the folds was begun and left everything open.
    left_open: OnceCell<Error>,
    admissibility: Once<Arc<Admissibility>>,
    formulas: Once<Option<Formulas>>,
    in_doubles: OnceCell<Option<CurveInDoubles>>,
    /// An output of which a part is proved, for where nothing else has more of it.
    kept: RefCell<Option<Output>>,
}

impl<'s> Certified<'s> {
    pub(crate) fn new(scene: &'s Scene, digits: u32, counts: &'s Counts) -> Self {
        let (search, plain, folds, left_open) = (OnceCell::new(), OnceCell::new(), OnceCell::new(), OnceCell::new());
        let (admissibility, formulas, in_doubles) = (OnceCell::new(), OnceCell::new(), OnceCell::new());
        let kept = RefCell::new(None);
        Certified { scene, digits, counts, search, plain, folds, left_open, admissibility, formulas, in_doubles, kept }
    }

    /// Keeps an output of which only a part is proved.
    pub(crate) fn keep(&self, output: Option<Output>) {
        self.kept.replace(output);
    }

    /// What was kept of the output.
    pub(crate) fn take_kept(&self) -> Option<Output> {
        self.kept.take()
    }

    /// The profile as formulas; `None` if it is none, or their kinks are not known.
    ///
    /// # Errors
    /// Errors that do not leave the question open; see [`Formulas::of`].
    pub(crate) fn formulas(&self) -> Result<Option<&Formulas>> {
        once(&self.formulas, || Ok(proof::decided(Formulas::of(&self.scene.profile))?.flatten())).map(Option::as_ref)
    }

    /// The contact over intervals of doubles, which helps where an evaluation takes many operations: of a table, unless its numbers leave
    /// the range of doubles.
    pub(crate) fn curve_in_doubles(&self) -> Option<&CurveInDoubles> {
        let found = self.in_doubles.get_or_init(|| {
            let table = self.scene.table_on_half_space()?;
            let weight = weight_in_doubles(&self.scene.profile);
            let (plain, dual) = (self.scene.contact_of_table(table).ok()?, self.scene.contact_of_table(table).ok()?);
            let plain = counted(&plain, &self.counts[Interval::INDEX], weight);
            let dual = counted(&dual, &self.counts[Dual::<Interval>::INDEX], 3 * weight);
            Some(CurveInDoubles::new(plain, dual))
        });
        found.as_ref()
    }

    /// Whether the energies of states can be enclosed: by closed forms, or for contacts that are discs by integrals over the profile.
    ///
    /// # Errors
    /// Errors that do not leave the question open; see [`Formulas::of`].
    pub(crate) fn encloses_energies(&self) -> Result<bool> {
        Ok(self.scene.has_closed_energies() || self.scene.medium.has_discs() && self.formulas()?.is_some())
    }

    /// What `ask` finds out with the energies of a contact of the scene over enclosures.
    ///
    /// # Errors
    /// Errors of `ask`; a profile whose energies cannot be [enclosed](Certified::encloses_energies).
    pub(crate) fn with_energy<T>(
        &self,
        contact: &Contact<Interval>,
        ask: impl FnOnce(&EnclosedEnergy<'_>) -> Result<T>,
    ) -> Result<T> {
        if self.scene.has_closed_energies() {
            return with_energies(contact, None, ask);
        }
        let formulas = self.formulas()?.ok_or_else(without_energies)?;
        let profile = formulas.continued(contact.modulus().ctx())?.on(contact.medium()).ok_or_else(without_energies)?;
        with_energies(contact, Some(&profile), ask)
    }

    /// Which states are admissible: by the form of the profile, by enclosures of the gap, by proved extrema of g, else in f64.
    ///
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain; see [`Certified::search`].
    pub(crate) fn admissibility(&self) -> Result<Arc<Admissibility>> {
        let found = once(&self.admissibility, || {
            let rises = self.model::<Interval>(start(self.digits))?.transform().rises();
            if rises {
                return Ok(Arc::new(Admissibility::of_rising()));
            }
            let searched = self.search()?.admissibility();
            if searched.holds_by_form() {
                return Ok(searched);
            }
            if let Some(gaps) = proof::gaps(self)? {
                return Ok(Arc::new(searched.as_ref().clone().with_gaps(gaps)));
            }
            // A formula may rise, though its form does not say so.
            let rising = if self.scene.is_by_integrals() { proof::of_proved_rise(self)? } else { None };
            Ok(rising.map_or(searched, Arc::new))
        });
        found.cloned()
    }

    /// The contact in f64, with its search.
    ///
    /// # Errors
    /// A parameter of the profile or the material that is out of its domain.
    pub(crate) fn search(&self) -> Result<&Search<'s>> {
        once(&self.search, || Search::of_lengths(self.scene, self.counts))
    }

    /// The contact in another arithmetic.
    pub(crate) fn model<R: SceneReal>(&self, ctx: R::Ctx) -> Result<Model<R>> {
        Model::new(self.scene, ctx, self.counts)
    }

    /// The contact in f64 and SI units, for what cannot be proved.
    ///
    /// # Errors
    /// A number that no double holds; errors of the search.
    pub(crate) fn plain(&self) -> Result<&Search<'s>> {
        once(&self.plain, || {
            let is_closed =
                |folds: &Result<_>| matches!(folds, Ok(Some(FoldProof { complete, .. })) if !complete.undecided);
            let is_open = self.folds.get().is_some_and(|folds| !is_closed(folds));
            Ok(self.search()?.in_units(self.counts)?.knowing(self.admissibility()?, self.remark(), is_open))
        })
    }

    /// Why more is not proved, where that is known.
    fn remark(&self) -> Option<String> {
        if let Some(rows) = self.scene.profile.rows().filter(|rows| *rows > PROVED_ROWS) {
            return Some(format!("; tables are proved up to {PROVED_ROWS} rows, this has {rows}"));
        }
        let folds = match self.folds.get()? {
            Err(Error::BudgetSpent { .. }) => {
                return Some(
                    "; the budget was spent before this was proved, and a larger one may decide it".to_owned(),
                );
            }
            Ok(None) => {
                let why = |error| format!("; a proof was begun, and left undecided: {error}");
                return self.left_open.get().map(why);
            }
            folds => folds.as_ref().ok()?.as_ref()?,
        };
        if folds.complete.undecided {
            return Some(format!("; a proof was begun, and is {}", folds.complete.why));
        }
        let [from, to] = [&folds.complete.from, &folds.complete.to].map(|end| end.as_deref().unwrap_or("infinity"));
        Some(format!("; the folds are proved to be all within radii from {from} to {to} m, and not every state is"))
    }

    /// The contact in f64 and SI units, with all its folds.
    pub(crate) fn in_doubles(&self) -> Result<(Model<f64>, Folds<f64>)> {
        Ok((self.model(())?, self.plain()?.folds()?.clone()))
    }

    /// The digits of enclosures, decided at growing precision; `None` if the profile has no enclosures, or if they leave it open
    /// for a formula.
    ///
    /// # Errors
    /// Errors of `f`.
    pub(crate) fn proved<T: Numbers<Enclosure>>(
        &self,
        f: impl FnMut(Precision) -> Result<T>,
    ) -> Result<Option<T::With<Number>>> {
        if self.scene.is_closed() {
            return self.decide(f).map(Some);
        }
        if !self.scene.has_proofs() {
            return Ok(None);
        }
        proof::decided(decide_within(MOST_OF_INTEGRALS, start(self.digits), self.digits, f))
    }

    /// Evaluates `f` at growing precision until every number has its digits, beginning with a given precision: see
    /// [`decide_within`], with fewer bits at most where g is an integral.
    ///
    /// # Errors
    /// Errors of `f`; [`Error::Undecided`](mdr_core::contact::Error::Undecided) only when it is the last attempt that returns it.
    pub(crate) fn decide_from<T: Numbers<Enclosure>>(
        &self,
        precision: Precision,
        f: impl FnMut(Precision) -> Result<T>,
    ) -> Result<T::With<Number>> {
        let most = if self.scene.is_closed() { MOST } else { MOST_OF_DECISIONS };
        decide_within(most, precision, self.digits, f)
    }

    /// Likewise, beginning with the bits of the digits.
    ///
    /// # Errors
    /// The errors of [`decide_from`](Certified::decide_from).
    pub(crate) fn decide<T: Numbers<Enclosure>>(
        &self,
        f: impl FnMut(Precision) -> Result<T>,
    ) -> Result<T::With<Number>> {
        self.decide_from(start(self.digits), f)
    }

    /// The folds on which proofs rest: of closed forms, and of formulas and of tables that are short, where they leave nothing
    /// undecided. A longer or a rougher table, and a formula with more waves than can be looked at, is better searched.
    ///
    /// # Errors
    /// A range out of its domain; errors of the transform. See [`FoldProof::new`].
    pub(crate) fn fold_proof(&self) -> Result<Option<&FoldProof>> {
        let is_closed = self.scene.is_closed() && self.scene.exact_rows().is_none();
        Ok(self.proof_of_folds()?.filter(|folds| is_closed || folds.complete.proved))
    }

    /// The folds of a proof that may leave something undecided, as where its budget ended, unless a search finds more of them.
    ///
    /// # Errors
    /// The errors of [`fold_proof`](Certified::fold_proof); errors of the search.
    pub(crate) fn some_folds(&self) -> Result<Option<&FoldProof>> {
        let Some(folds) = self.proof_of_folds()? else { return Ok(None) };
        let count = folds.proved.folds.len();
        Ok((count > 0 && count >= self.search()?.folds()?.folds.len()).then_some(folds))
    }

    /// What a proof finds of the folds, whether or not it leaves something undecided.
    fn proof_of_folds(&self) -> Result<Option<&FoldProof>> {
        let folds = once(&self.folds, || {
            Ok(match self.scene.exact_rows() {
                None if self.scene.is_closed() => Some(FoldProof::new(self)?),
                None if self.scene.is_enclosed() => match FoldProof::new(self) {
                    Err(error) if proof::is_open(&error) => {
                        let _ = self.left_open.set(error);
                        None
                    }
                    proof => Some(proof?),
                },
                Some(_) if self.scene.is_short_table() => Some(FoldProof::new(self)?),
                _ => None,
            })
        });
        folds.map(Option::as_ref)
    }
}
