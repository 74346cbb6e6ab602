//! The validity of the short-range theory in certified digits: enclosures, else doubles.

use mdr_core::contact::{Error, Fold, Result, Status};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::dugdale::{CohesiveState, Dugdale, separation};
use mdr_numeric::proof::{EnclosedCurve, EnclosedPullOff};

use super::{Found, Validity};
use crate::answer::Value;
use crate::answer::record::Numbers;
use crate::run::{Counts, lack};
use crate::scene::Scene;
use crate::solve::digits::{MOST_OF_INTEGRALS, decide_within, start};
use crate::solve::model::Model;
use crate::solve::proof::decided;
use crate::solve::rigorous::Formulas;
use crate::solve::search::Search;

/// Bits within which a fold is that of f64.
const SAME_FOLD: i64 = 30;

/// The validity of a scene whose g can be enclosed.
///
/// # Errors
/// A number of the scene that is out of its domain; [`Error::Stopped`].
pub(super) fn of(scene: &Scene, range: &Literal, digits: u32, counts: &Counts) -> Result<Validity> {
    if scene.is_closed() {
        let found = Found::new(scene, range, Search::of_lengths(scene, counts)?)?;
        let proved = found.proved(digits, counts)?;
        return proved.map_or_else(|| Found::new(scene, range, Search::new(scene, counts)?)?.in_doubles(), Ok);
    }
    // First the doubles, which a proof that spends the budget could cost.
    let found = Found::new(scene, range, Search::new(scene, counts)?)?;
    let doubles = found.in_doubles()?;
    Ok(found.proved(digits, counts)?.unwrap_or(doubles))
}

impl Found<'_> {
    /// Digits that are proved; `None` if not all are.
    fn proved(&self, digits: u32, counts: &Counts) -> Result<Option<Validity>> {
        let pull_off = match self.pull_off() {
            // A ring that would reach beyond the profile: the other numbers have digits.
            Err(error) if !matches!(error, Error::Domain { .. }) => return Ok(None),
            found => found.as_ref().map(Option::as_ref).map_err(Clone::clone),
        };
        if !self.scene.pressed_into().is_half_space() {
            return Ok(None);
        }
        let Some(formulas) = decided(Formulas::of(&self.scene.profile))?.flatten() else { return Ok(None) };
        let fold = match self.fold() {
            Err(error) if !matches!(error, Error::NoEquilibrium { .. }) => return Ok(None),
            fold => fold,
        };
        let lost = pull_off.as_ref().ok().copied().flatten().map_or(0, lost_bits);
        let first = Precision::new(start(digits).bits() + lost);
        let proof = Proof { found: self, formulas, fold, pull_off, counts };
        let validity = lack(decide_within(MOST_OF_INTEGRALS, first, digits, |precision| proof.record(precision)))?;
        let has_all = |validity: &Validity| match (&proof.fold, &proof.pull_off) {
            (Ok(_), Ok(Some(_))) => validity.row().status() == Status::Ok,
            _ => !validity.row().is_open(),
        };
        Ok(validity.ok().filter(has_all))
    }
}

/// What is enclosed: the fold and the pull-off that were found in f64.
struct Proof<'p> {
    found: &'p Found<'p>,
    formulas: Formulas,
    fold: Result<Fold<f64>>,
    pull_off: Result<Option<&'p CohesiveState<f64>>>,
    counts: &'p Counts,
}

impl Proof<'_> {
    fn record(&self, precision: Precision) -> Result<Validity<Enclosure>> {
        let Found { scene, range, .. } = self.found;
        let model = Model::<Interval>::new(scene, precision, self.counts)?;
        let slopes = Model::<Dual<Interval>>::new(scene, precision, self.counts)?;
        let curve = EnclosedCurve::new(model.contact(), slopes.contact());
        let fold = match &self.fold {
            Ok(fold) => Ok(enclosed(&curve, fold, &model.double(fold.contact_radius))?),
            Err(error) => Err(error.clone()),
        };
        let state = match &self.pull_off {
            Ok(Some(near)) => {
                let contact = Dugdale::new(model.contact(), &separation(&model.number(range)))?;
                let profile = self.formulas.continued(precision)?;
                let proof = EnclosedPullOff::new(&contact, &profile);
                Ok(Some(proof.near(near.contact_radius, near.outer_radius)?))
            }
            Ok(None) => Ok(None),
            Err(error) => Err(error.clone()),
        };
        let inside = match &fold {
            Ok(fold) => slope_inside(&model, &fold.contact_radius)?,
            Err(_) => None,
        };
        let mut record = self.found.record(&model, fold, |_| state)?;
        if let Some(slope) = inside {
            record.slope = Value::Known(slope);
        }
        Ok(record.convert(Enclosure::from))
    }
}

/// The fold that was found in f64, as an enclosure.
fn enclosed(curve: &EnclosedCurve, found: &Fold<f64>, radius: &Interval) -> Result<Fold<Interval>> {
    let near = radius.clone().inflate(&(radius.lit(2).powi(-SAME_FOLD) * radius));
    // Its other numbers are not looked at.
    let (indentation, force) = (near.clone(), near.clone());
    curve.refine(&Fold { contact_radius: near, indentation, force, kind: found.kind })
}

/// Bounds of g' next to a kink of g, on its inner side, where a radius cannot be told from one; `None` elsewhere, and without bounds.
fn slope_inside(model: &Model<Interval>, a: &Interval) -> Result<Option<Interval>> {
    let transform = model.transform();
    let Some(index) = transform.kinks().iter().position(|kink| kink.overlaps(a)) else { return Ok(None) };
    let margin = a.unit_roundoff();
    let inside = transform.kink(index, &margin)?.map(|kink| kink.inside);
    Ok(inside.and_then(|slopes| Some(slopes.least?.hull(&slopes.greatest?))))
}

/// The bits that a narrow ring takes from the force and from its change against the theory of short range.
fn lost_bits(state: &CohesiveState<f64>) -> u32 {
    let octaves = (state.contact_radius / (state.outer_radius - state.contact_radius)).log2();
    (3.0 * octaves - 20.0).clamp(0.0, 200.0) as u32
}
