//! Folds, equilibria and paths over enclosures: each digit and each decision proved, and nothing missed on a range of radii.

use mdr_core::contact::{self, Control, Error, Quantity, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::admissible::Admissibility;
use mdr_numeric::branch::EquilibriumBranches;
use mdr_numeric::contact::Contact;
use mdr_numeric::equilibrium::SearchedBranches;
use mdr_numeric::folds::{Folds, SearchQuality};
use mdr_numeric::medium::Adhesion;
use mdr_numeric::path::{Event, Path};
use mdr_numeric::proof::{EnclosedCurve, ProvedBranches, ProvedFolds};
use rug::Float;
use rug::float::Round;

use super::certified::Certified;
use super::digits::{agree, decide, decide_from, guarded, raised, start};
use super::model::Model;
use super::{outputs, path, sample};
use crate::answer::record::Numbers;
use crate::answer::types::PathNumbers;
use crate::answer::{AtValue, Completeness, Equilibrium, Fold, List, LoadingPath, Number, PathEvent, Promise, Value};

/// Bits in which folds are isolated; they are sharpened afterwards.
const ISOLATION: u32 = 64;
/// Evaluations that the isolation may spend between two kinks.
const BUDGET: usize = 4_000_000;
/// The budget between two rows of a table, where an evaluation is a sum over all rows and one fold the rule.
const BUDGET_OF_ROWS: usize = 10_000;

/// How many times the bits of the digits are tried to show that no fold lies outside the range of the proof.
const ENOUGH: u32 = 16;

/// The contact over enclosures, and over enclosures with derivatives.
struct Enclosed {
    value: Model<Interval>,
    dual: Model<Dual<Interval>>,
}

impl Enclosed {
    fn new(certified: &Certified<'_>, precision: Precision) -> Result<Self> {
        Ok(Enclosed { value: certified.model(precision)?, dual: certified.model(precision)? })
    }

    fn curve(&self) -> EnclosedCurve {
        EnclosedCurve::new(self.value.contact(), self.dual.contact())
    }
}

/// All folds on a range of radii, in a precision that separates them.
pub(super) struct FoldProof {
    proved: ProvedFolds,
    /// The completeness of the folds in the range.
    pub(super) complete: Completeness,
}

impl FoldProof {
    /// On the range that the scene names, else on a range with all folds that were found in f64.
    ///
    /// # Errors
    /// A range out of its domain; errors of the transform. See [`EnclosedCurve::folds`].
    pub(super) fn new(certified: &Certified<'_>) -> Result<Self> {
        let range = range(certified)?;
        let mut enclosed = Enclosed::new(certified, Precision::new(ISOLATION))?;
        // Cells as close to an equator as folds may be.
        let bits = ISOLATION.max(3 * enclosed.curve().octaves_to_equator()? - ISOLATION);
        let precision = Precision::new(bits);
        if bits > ISOLATION {
            enclosed = Enclosed::new(certified, precision)?;
        }
        let [lower, upper] = range.each_ref().map(|end| Interval::from_literal(precision, end));
        let budget = if certified.scene.profile.is_closed() { BUDGET } else { BUDGET_OF_ROWS };
        let proved = enclosed.curve().folds(lower.lower(), upper.upper(), budget)?;
        let [from, to] = range;
        let to = match enclosed.value.contact().vertical_edge() {
            Some(wall) if *wall.lower() < *upper.upper() => Number::Double(wall.approx()).to_string(),
            _ if proved.range.1 < *upper.lower() => proved.range.1.to_string_radix_round(10, Some(10), Round::Down),
            _ => to.to_string(),
        };
        let (from, to) = (Some(from.to_string()), Some(to));
        let complete = Completeness { proved: proved.is_complete(), from, to, why: reason(&proved.undecided) };
        Ok(FoldProof { proved, complete })
    }
}

/// The range that the scene names, else one with all folds that were found in f64.
fn range(certified: &Certified<'_>) -> Result<[Literal; 2]> {
    if let Some(range) = &certified.scene.range {
        return Ok(range.clone());
    }
    let search = certified.search()?;
    let by_integrals = certified.scene.profile.has_formula();
    sample::range(&search.model, search.folds()?, &search.visited(), by_integrals)
}

/// The work of adhesion over E*, in powers of two, at which folds are the extrema of g but for 2^−2000 of a length.
const NEARLY_NONE: i64 = -4000;

/// Admissibility from extrema of g that are proved to be all on the range of the folds, g rising beyond; `None` if they are not.
/// They are the folds of a contact with next to no adhesion.
///
/// # Errors
/// Errors of the search for folds; a parameter out of its domain.
pub(super) fn isolated(certified: &Certified<'_>, searched: &Admissibility) -> Result<Option<Admissibility>> {
    let range = range(certified)?;
    let precision = Precision::new(ISOLATION);
    let enclosed = Enclosed::new(certified, precision)?;
    let plain = nearly_free(&enclosed.value.contact())?;
    let curve = EnclosedCurve::new(plain.clone(), nearly_free(&enclosed.dual.contact())?);
    let [lower, upper] = range.each_ref().map(|end| Interval::from_literal(precision, end));
    let Some(found) = decided(curve.folds(lower.lower(), upper.upper(), BUDGET_OF_ROWS))? else { return Ok(None) };
    let far = Float::with_val(ISOLATION, Float::i_exp(1, 1 << 20));
    let beyond = Interval::new(found.range.1.clone(), far);
    let rises_beyond = plain.transform().outer_radius().is_some()
        || plain.transform().slope(&beyond).is_ok_and(|slope| *slope.lower() >= 0);
    if !found.is_complete() || !rises_beyond {
        return Ok(None);
    }
    let extrema: Vec<f64> = found.folds.iter().chain(&found.poles).map(|fold| fold.contact_radius.approx()).collect();
    let range = [&found.range.0, &found.range.1].map(Float::to_f64);
    Ok(Some(searched.with_extrema(&plain, &extrema, range)))
}

/// The contact at fixed grips with next to no adhesion.
fn nearly_free<R: Real>(contact: &Contact<R>) -> Result<Contact<R>> {
    let work = contact.modulus().lit(2).powi(NEARLY_NONE) * contact.modulus();
    let transform = std::sync::Arc::clone(contact.shared_transform());
    Ok(Contact::sharing(transform, contact.medium().clone(), Adhesion::new(work)?, Control::Indentation))
}

/// Why folds are all, or are not.
fn reason(undecided: &[(Float, Float)]) -> String {
    if undecided.is_empty() {
        return "enclosures of the tangency condition leave no room for another fold".to_owned();
    }
    // As many digits as tell the two ends apart.
    let gap = |(lower, upper): &(Float, Float)| {
        let pair = |digits| [lower, upper].map(|end| format!("{:.digits$e}", end.to_f64()));
        let [from, to] = Some(pair(8)).filter(|[from, to]| from != to).unwrap_or_else(|| pair(16));
        format!("{from} to {to}")
    };
    let shown: Vec<_> = undecided.iter().take(3).map(gap).collect();
    let more = if undecided.len() > 3 { format!(" and {} more", undecided.len() - 3) } else { String::new() };
    format!("undecided at contact radii {}{more}", shown.join(", "))
}

/// # Errors
/// A fold that no precision refines; errors of the transform. See [`EnclosedCurve::refine`].
pub(super) fn folds(certified: &Certified<'_>, folds: &FoldProof) -> Result<List<Fold>> {
    let items = decide(certified.digits, |precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let curve = enclosed.curve();
        let admissibility = certified.admissibility()?;
        let refined = |fold: &contact::Fold<Interval>| Ok(outputs::fold(curve.refine(fold)?, &admissibility));
        let refined: Result<Vec<Fold<Interval>>> = folds.proved.folds.iter().map(refined).collect();
        Ok(refined?.convert(Enclosure::from))
    })?;
    Ok(List::new(Promise::Certified, items).complete(folds.complete.clone()))
}

/// All equilibria at values, with their completeness; `None` if they cannot be proved.
///
/// # Errors
/// A value out of its domain; errors of the transform. See [`EquilibriumBranches::equilibria`].
pub(super) fn equilibria(
    certified: &Certified<'_>,
    folds: &FoldProof,
    values: &[Literal],
) -> Result<Option<List<AtValue<Equilibrium>>>> {
    let mut why = "one equilibrium at most between two folds, and the folds are proved to be all".to_owned();
    if certified.scene.range.is_some() {
        why += "; equilibria with other radii are not listed";
    }
    let complete = Completeness { why, ..folds.complete.clone() };
    let list = |items| List::new(Promise::Certified, items).complete(complete);
    Ok(equilibria_at(certified, folds, values)?.map(list))
}

/// All equilibria in the range at each value, and those met beyond it unless the scene names the range; `None` if they cannot be
/// proved.
///
/// # Errors
/// A value out of its domain; errors of the transform. See [`EquilibriumBranches::equilibria`].
pub(super) fn equilibria_at(
    certified: &Certified<'_>,
    folds: &FoldProof,
    values: &[Literal],
) -> Result<Option<Vec<AtValue<Equilibrium>>>> {
    let limits = certified.scene.range.as_ref();
    let items = decide(certified.digits, |precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let branches = ProvedBranches::new(enclosed.curve(), &folds.proved)?;
        let admissibility = certified.admissibility()?;
        let at = |literal: &Literal| {
            let mut states = Vec::new();
            for state in branches.equilibria(&enclosed.value.number(literal))? {
                if limits.map_or(Ok(true), |limits| is_within(&state, limits))? {
                    let mut state = outputs::equilibrium(state, &admissibility).convert(Enclosure::from);
                    match certified.scene.control {
                        Control::Indentation => state.indentation = exactly(literal),
                        Control::Force => state.force = exactly(literal),
                        Control::Machine { .. } => {}
                    }
                    states.push(state);
                }
            }
            let why = match limits {
                Some([lower, upper]) if states.is_empty() => {
                    Some(format!("no equilibrium with a contact radius within the range from {lower} to {upper} m"))
                }
                _ => None,
            };
            Ok(AtValue { why, ..AtValue::new(literal, states) })
        };
        values.iter().map(at).collect::<Result<Vec<_>>>()
    });
    decided(items)
}

/// Whether a state lies within a range of contact radii.
fn is_within(state: &contact::Equilibrium<Interval>, [lower, upper]: &[Literal; 2]) -> Result<bool> {
    let radius = &state.contact_radius;
    let [lower, upper] = [lower, upper].map(|end| Interval::from_literal(radius.ctx(), end));
    if *radius < lower || *radius > upper {
        Ok(false)
    } else if *radius >= lower && *radius <= upper {
        Ok(true)
    } else {
        let what = "whether an equilibrium lies within the range of the scene";
        Err(Error::undecided(Quantity::ContactRadius, radius, what))
    }
}

/// A path that was followed over enclosures.
pub(super) struct Followed {
    path: Path<Interval>,
    folds: Vec<contact::Fold<Interval>>,
    control: Control<Interval>,
    bits: u32,
}

impl Followed {
    /// Every decision on the path is certain.
    ///
    /// # Errors
    /// No stable equilibrium at the first way point; errors of the transform, see [`Path::follow`]; [`Error::Unproved`] if more
    /// bits do not help.
    fn new(certified: &Certified<'_>, folds: &FoldProof, precision: Precision) -> Result<Self> {
        let enclosed = Enclosed::new(certified, precision)?;
        let branches = ProvedBranches::new(enclosed.curve(), &folds.proved)?;
        let branches = branches.with_admissibility(certified.admissibility()?);
        let control = enclosed.value.control();
        let unproved = || {
            let (from, to) = ("0".to_owned(), "infinity".to_owned());
            Error::Unproved { quantity: control.quantity(), from, to, remedy: "name a wider range of radii" }
        };
        let path = match path::follow(&enclosed.value, &branches, certified.scene) {
            // There is none in the range of the proof, whatever the precision.
            Err(Error::NoEquilibrium { .. }) => return Err(unproved()),
            path => path?,
        };
        let asked_for = start(certified.digits).bits();
        branches.check(&path).map_err(|error| match error {
            // The rest of the radii is long, and not a matter of bits.
            Error::Undecided { bits, .. } if bits >= ENOUGH * asked_for => unproved(),
            error => error,
        })?;
        let folds = branches.folds().iter().filter(|fold| fold.indentation.is_finite()).cloned().collect();
        Ok(Followed { path, folds, control: control.clone(), bits: precision.bits() })
    }

    /// Its events and its balance with their energies, at two precisions. The states are those that are proved: nothing is
    /// searched again.
    ///
    /// # Errors
    /// Errors of the transform; an energy that is not representable. See [`path::with_energy`].
    pub(super) fn with_energy(mut self, certified: &Certified<'_>, folds: &FoldProof) -> Result<PathNumbers<Number>> {
        agree(certified.digits, |precision| {
            if self.bits < guarded(precision).bits() {
                self = Followed::new(certified, folds, guarded(precision))?;
            }
            let model: Model<Float> = certified.model(precision)?;
            let rounded = |number: &Interval| Float::with_val(precision.bits(), number.mid());
            let folds = self.folds.iter().map(|fold| fold.map(rounded)).collect();
            let (poles, out_of_range) = (Vec::new(), Vec::new());
            let folds = Folds { folds, poles, out_of_range, completeness: SearchQuality::Resolved };
            let branches =
                SearchedBranches::cut_at(model.contact(), folds).with_admissibility(certified.admissibility()?);
            path::with_energy(&self.path.map(rounded), &certified.scene.path, &branches)
        })
    }
}

/// The path without its energy, every decision of it proved; `None` if one cannot be proved.
///
/// # Errors
/// No stable equilibrium at the first way point; errors of the transform. See [`Path::follow`].
pub(super) fn path(certified: &Certified<'_>, folds: &FoldProof) -> Result<Option<(LoadingPath, Followed)>> {
    let scene = certified.scene;
    // As precise as the energies will need the states.
    let precision = guarded(raised(start(certified.digits)));
    let mut last = None;
    let events = decide_from(precision, certified.digits, |precision| {
        let followed = last.insert(Followed::new(certified, folds, precision)?);
        let events = path::events(&followed.control, &followed.path, &*certified.admissibility()?);
        let mut events = events.convert(Enclosure::from);
        let mut way = scene.path.iter();
        for (record, event) in events.iter_mut().zip(&followed.path.events) {
            if path::is_arrival(event.kind)
                && let Some(literal) = way.next()
            {
                set_exact(record, event, &scene.control, literal);
            }
        }
        Ok(events)
    });
    let why = "every decision on the path is certain, and its folds are proved to be all";
    let complete = Completeness { why: why.to_owned(), ..folds.complete.clone() };
    let path = |events| LoadingPath::new(Promise::Certified, PathNumbers { events, balance: None }, complete);
    Ok(decided(events)?.map(path).zip(last))
}

/// The exact value of the controlled quantity at a way point. Surfaces apart carry no load, whatever is applied.
fn set_exact(
    record: &mut PathEvent<Enclosure>,
    event: &Event<Interval>,
    control: &Control<Literal>,
    literal: &Literal,
) {
    let value = match control {
        Control::Indentation => &mut record.indentation,
        Control::Force if event.before.contact().is_none() => return,
        Control::Force => &mut record.force,
        Control::Machine { .. } => &mut record.position.0,
    };
    if let Some(Value::Known(_)) = value {
        *value = Some(exactly(literal));
    }
}

fn exactly(literal: &Literal) -> Value<Enclosure> {
    Value::Known(Enclosure::Exact(literal.to_rational()))
}

/// `None` if the question stays open.
pub(super) fn decided<T>(result: Result<T>) -> Result<Option<T>> {
    match result {
        Err(Error::Undecided { .. } | Error::Unproved { .. }) => Ok(None),
        result => result.map(Some),
    }
}
