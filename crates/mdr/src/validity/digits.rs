//! The validity of the short-range theory in certified digits: enclosures, else two precisions, else doubles.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Error, Fold, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation};
use mdr_numeric::proof::{EnclosedCurve, EnclosedPullOff};
use rug::Float;

use super::{Found, Validity, instability};
use crate::answer::record::Numbers;
use crate::run::{Counts, lack};
use crate::scene::Scene;
use crate::solve::digits::{MOST_OF_INTEGRALS, agree, decide_within, start};
use crate::solve::model::Model;
use crate::solve::proof::decided;
use crate::solve::refine::refined;
use crate::solve::rigorous::Formulas;
use crate::solve::search::Search;

/// Bits of a contact radius at which f64 finds the force stationary.
const KNOWN: i64 = 24;
/// Bits within which a fold is that of f64.
const SAME_FOLD: i64 = 30;

/// The validity of a scene whose g can be enclosed.
///
/// # Errors
/// A number of the scene that is out of its domain; [`Error::Stopped`].
pub(super) fn of(scene: &Scene, range: &Literal, digits: u32, counts: &Counts) -> Result<Validity> {
    let search = if scene.is_closed() { Search::of_lengths(scene, counts) } else { Search::new(scene, counts) };
    let found = Found::new(scene, range, search?)?;
    if let Some(proved) = found.proved(digits, counts)? {
        return Ok(proved);
    }
    if scene.is_closed() { found.agreed(digits, counts) } else { found.in_doubles() }
}

impl Found<'_> {
    /// Digits that are proved; `None` if not all are.
    fn proved(&self, digits: u32, counts: &Counts) -> Result<Option<Validity>> {
        let Ok(pull_off) = &self.pull_off else { return Ok(None) };
        if !self.scene.pressed_into().is_half_space() || self.scene.has_two_works() {
            return Ok(None);
        }
        let Some(formulas) = decided(Formulas::of(&self.scene.profile))?.flatten() else { return Ok(None) };
        let fold = match self.fold() {
            Err(error) if !matches!(error, Error::NoEquilibrium { .. }) => return Ok(None),
            fold => fold,
        };
        let first = Precision::new(start(digits).bits() + pull_off.as_ref().map_or(0, lost_bits));
        let found = lack(decide_within(MOST_OF_INTEGRALS, first, digits, |precision| {
            let model = Model::<Interval>::new(self.scene, precision, counts)?;
            let curve = EnclosedCurve::new(
                model.contact(),
                Model::<Dual<Interval>>::new(self.scene, precision, counts)?.contact(),
            );
            let fold = match &fold {
                Ok(fold) => Ok(enclosed(&curve, fold, &model.double(fold.contact_radius))?),
                Err(error) => Err(error.clone()),
            };
            let state = match pull_off {
                Some(near) => {
                    let contact = Dugdale::new(model.contact(), &separation(&model.number(self.range)))?;
                    let profile = formulas.continued(precision)?;
                    let proof = EnclosedPullOff::new(&contact, &profile);
                    Some(proof.near(near.contact_radius, near.outer_radius)?)
                }
                None => None,
            };
            Ok(self.record(&model, fold, |_| Ok(state))?.convert(Enclosure::from))
        }))?;
        Ok(found.ok().filter(|validity| !validity.row().is_open()))
    }

    /// Digits on which two precisions agree, near the radii that were found in f64.
    fn agreed(&self, digits: u32, counts: &Counts) -> Result<Validity> {
        agree(digits, |precision| {
            let model = Model::<Float>::new(self.scene, precision, counts)?;
            let folds = self.folds.as_ref().map_err(Clone::clone).and_then(|folds| refined(&model, folds));
            let record =
                self.record(&model, folds.as_ref().map_err(Clone::clone).and_then(instability), |contact| match &self
                    .pull_off
                {
                    Ok(Some(state)) => contact.pull_off_near(&model.double(state.contact_radius), KNOWN).map(Some),
                    Ok(None) => Ok(None),
                    Err(error) => Err(error.clone()),
                });
            Ok(record?.convert(Estimate::exact))
        })
    }
}

/// The fold that was found in f64, as an enclosure.
fn enclosed(curve: &EnclosedCurve, found: &Fold<f64>, radius: &Interval) -> Result<Fold<Interval>> {
    let near = radius.clone().inflate(&(radius.lit(2).powi(-SAME_FOLD) * radius));
    // Its other numbers are not looked at.
    let (indentation, force) = (near.clone(), near.clone());
    curve.refine(&Fold { contact_radius: near, indentation, force, kind: found.kind })
}

/// The bits that a narrow ring takes from the force and from its change against the theory of short range.
fn lost_bits(state: &CohesiveState<f64>) -> u32 {
    let octaves = (state.contact_radius / (state.outer_radius - state.contact_radius)).log2();
    (3.0 * octaves - 20.0).clamp(0.0, 200.0) as u32
}
