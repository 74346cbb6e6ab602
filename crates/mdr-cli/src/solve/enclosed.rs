//! Folds, equilibria and paths over enclosures: each digit and each decision proved, and nothing missed on a range of radii.

use mdr_core::contact::{Control, Equilibrium, Error, Instability, Quantity, Result};
use mdr_core::number::certify::Enclosure;
use mdr_core::number::{Dual, Interval, Literal, Precision, Real};
use mdr_numeric::branch::Branched;
use mdr_numeric::equilibrium::Branches;
use mdr_numeric::folds::{Completeness, Folds};
use mdr_numeric::path::{Event, EventKind, Path};
use mdr_numeric::proof::{EnclosedBranches, EnclosedCurve, ProvedFolds};
use rug::Float;
use rug::float::Round;

use super::answer::{Complete, Output, Promise};
use super::certified::Certified;
use super::contact::Contact;
use super::digits::{estimated, guarded, proved, proved_from, raised, start};
use super::record::{Field, Record};
use super::{outputs, path, sample};
use crate::number::Number;
use crate::scene::{HeldBy, Want};

/// Bits in which folds are isolated; they are sharpened afterwards.
const ISOLATION: u32 = 64;
/// Evaluations that the isolation may spend between two kinks.
const BUDGET: usize = 4_000_000;
/// The same between two rows of a table, where an evaluation is a sum over all rows and one fold the rule.
const BUDGET_OF_ROWS: usize = 10_000;

/// How many times the bits of the digits are tried to show that no fold lies outside the range of the proof.
const ENOUGH: u32 = 16;

/// The contact over enclosures, and over enclosures with derivatives.
struct Enclosed {
    plain: Contact<Interval>,
    moving: Contact<Dual<Interval>>,
}

impl Enclosed {
    fn new(certified: &Certified<'_>, precision: Precision) -> Result<Self> {
        Ok(Enclosed { plain: certified.contact(precision)?, moving: certified.contact(precision)? })
    }

    fn curve(&self) -> EnclosedCurve<'_> {
        EnclosedCurve::new(self.plain.curve(), self.moving.curve())
    }
}

/// All folds on a range of radii, in a precision that tells them apart.
pub(super) struct Isolated {
    proved: ProvedFolds,
    complete: Complete,
}

impl Isolated {
    /// On the range that the scene names, else on one that holds what f64 has found.
    ///
    /// # Errors
    /// As [`EnclosedCurve::folds`].
    pub(super) fn new(certified: &Certified<'_>) -> Result<Self> {
        let range = match &certified.scene.output.range {
            Some(range) => range.ends.clone(),
            None => {
                let rough = certified.rough()?;
                sample::range(rough.contact(), rough.folds()?, &rough.visited())?
            }
        };
        let mut enclosed = Enclosed::new(certified, Precision::new(ISOLATION))?;
        // Cells as close to a rim as folds may be.
        let bits = ISOLATION.max(3 * enclosed.curve().octaves_to_rim()? - ISOLATION);
        let precision = Precision::new(bits);
        if bits > ISOLATION {
            enclosed = Enclosed::new(certified, precision)?;
        }
        let [lower, upper] = range.each_ref().map(|end| Interval::from_literal(precision, end));
        let budget = if certified.scene.profile.is_closed() { BUDGET } else { BUDGET_OF_ROWS };
        let proved = enclosed.curve().folds(lower.lower(), upper.upper(), budget)?;
        let [from, to] = range;
        let to = match enclosed.plain.curve().wall() {
            Some(wall) if *wall.lower() < *upper.upper() => Number::Double(wall.approx()).to_string(),
            _ if proved.range.1 < *upper.lower() => proved.range.1.to_string_radix_round(10, Some(10), Round::Down),
            _ => to.to_string(),
        };
        let (from, to) = (Some(from.to_string()), Some(to));
        let complete = Complete { proved: proved.is_complete(), from, to, why: reason(&proved.undecided) };
        Ok(Isolated { proved, complete })
    }

    /// Whether the folds are proved to be all in the range.
    pub(super) fn is_complete(&self) -> bool {
        self.complete.proved
    }

    /// What is known about the folds.
    pub(super) fn complete(&self) -> &Complete {
        &self.complete
    }
}

/// Why folds are all, or are not.
fn reason(undecided: &[(Float, Float)]) -> String {
    if undecided.is_empty() {
        return "enclosures of the tangency condition leave no room for another fold".to_owned();
    }
    let gap = |(lower, upper): &(Float, Float)| format!("{:.8e} to {:.8e}", lower.to_f64(), upper.to_f64());
    let shown: Vec<_> = undecided.iter().take(3).map(gap).collect();
    let more = if undecided.len() > 3 { format!(" and {} more", undecided.len() - 3) } else { String::new() };
    format!("undecided at contact radii {}{more}", shown.join(", "))
}

/// The range that the scene names.
fn limits<'s>(certified: &Certified<'s>) -> Option<&'s [Literal; 2]> {
    certified.scene.output.range.as_ref().map(|range| &range.ends)
}

/// # Errors
/// As [`EnclosedCurve::sharpen`].
pub(super) fn folds(certified: &Certified<'_>, isolated: &Isolated) -> Result<Output> {
    let records = proved(certified.digits, |precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let curve = enclosed.curve();
        let admissibility = certified.admissibility()?;
        let sharp = |fold: &Instability<Interval>| Ok(enclose(outputs::fold(curve.sharpen(fold)?, &admissibility)));
        isolated.proved.folds.iter().map(sharp).collect()
    })?;
    Ok(Output::new(Want::Folds, Promise::Certified, records).complete(isolated.complete.clone()))
}

/// What is proved of all equilibria at the values of a scene.
///
/// # Errors
/// As [`Branched::equilibria`].
pub(super) fn equilibria(certified: &Certified<'_>, isolated: &Isolated) -> Result<Option<Output>> {
    let values = &certified.scene.output.values;
    let mut why = "one equilibrium at most between two folds, and the folds are proved to be all".to_owned();
    if limits(certified).is_some() {
        why += "; equilibria with other radii are not listed";
    }
    let complete = Complete { why, ..isolated.complete.clone() };
    let output = |records| Output::new(Want::Equilibria, Promise::Certified, records).complete(complete);
    Ok(equilibria_at(certified, isolated, values)?.map(output))
}

/// All equilibria in the range at each value, and those met beyond it unless the scene names the range; none where that cannot
/// be proved.
///
/// # Errors
/// As [`Branched::equilibria`].
pub(super) fn equilibria_at(
    certified: &Certified<'_>,
    isolated: &Isolated,
    values: &[Literal],
) -> Result<Option<Vec<Record<Number>>>> {
    let limits = limits(certified);
    let records = proved(certified.digits, |precision| {
        let enclosed = Enclosed::new(certified, precision)?;
        let branches = EnclosedBranches::new(enclosed.curve(), &isolated.proved)?;
        let admissibility = certified.admissibility()?;
        let at = |literal: &Literal| {
            let mut states = Vec::new();
            for state in branches.equilibria(&enclosed.plain.number(literal))? {
                if limits.map_or(Ok(true), |limits| is_within(&state, limits))? {
                    states.push(held(
                        enclose(outputs::equilibrium(state, &admissibility)),
                        &certified.scene.held.by,
                        literal,
                    ));
                }
            }
            let none = states.is_empty();
            let record = outputs::at_value(literal, "equilibria", states);
            Ok(match limits {
                Some([lower, upper]) if none => record.because(format!(
                    "no equilibrium with a contact radius within the range from {lower} to {upper} m"
                )),
                _ => record,
            })
        };
        values.iter().map(at).collect()
    });
    decided(records)
}

/// Whether a state lies within a range of contact radii.
fn is_within(state: &Equilibrium<Interval>, [lower, upper]: &[Literal; 2]) -> Result<bool> {
    let radius = &state.contact_radius;
    let [lower, upper] = [lower, upper].map(|end| Interval::from_literal(radius.ctx(), end));
    if *radius < lower || *radius > upper {
        Ok(false)
    } else if *radius >= lower && *radius <= upper {
        Ok(true)
    } else {
        let what = "whether an equilibrium lies within the range of the scene";
        Err(Error::Undecided { quantity: Quantity::ContactRadius, bits: radius.precision(), what })
    }
}

/// A path that was followed over enclosures.
pub(super) struct Followed {
    path: Path<Interval>,
    folds: Vec<Instability<Interval>>,
    control: Control<Interval>,
    bits: u32,
}

impl Followed {
    /// Every decision on the path is certain.
    ///
    /// # Errors
    /// As [`Path::follow`]; [`Error::Unproved`] where more bits do not help.
    fn new(certified: &Certified<'_>, isolated: &Isolated, precision: Precision) -> Result<Self> {
        let enclosed = Enclosed::new(certified, precision)?;
        let branches = EnclosedBranches::new(enclosed.curve(), &isolated.proved)?;
        let branches = branches.with_admissibility(certified.admissibility()?);
        let control = enclosed.plain.control();
        let unproved = || {
            let (from, to) = ("0".to_owned(), "infinity".to_owned());
            Error::Unproved { quantity: control.quantity(), from, to, remedy: "name a wider range of radii" }
        };
        let path = match path::follow(&enclosed.plain, &branches, &certified.scene.held) {
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
    /// As [`path::with_energy`].
    pub(super) fn with_energy(mut self, certified: &Certified<'_>, isolated: &Isolated) -> Result<Vec<Record<Number>>> {
        estimated(certified.digits, |precision| {
            if self.bits < guarded(precision).bits() {
                self = Followed::new(certified, isolated, guarded(precision))?;
            }
            let contact: Contact<Float> = certified.contact(precision)?;
            let rounded = |number: &Interval| Float::with_val(precision.bits(), number.mid());
            let folds = self.folds.iter().map(|fold| fold.map(rounded)).collect();
            let (poles, beyond) = (Vec::new(), Vec::new());
            let folds = Folds { folds, poles, beyond, completeness: Completeness::Resolved };
            let branches = Branches::cut_at(contact.curve(), folds).with_admissibility(certified.admissibility()?);
            path::with_energy(&self.path.map(rounded), &certified.scene.held, &branches)
        })
    }
}

/// The events of the path without their energy; none where a decision cannot be proved.
///
/// # Errors
/// As [`Path::follow`].
pub(super) fn path(certified: &Certified<'_>, isolated: &Isolated) -> Result<Option<(Output, Followed)>> {
    let scene = certified.scene;
    // As precise as the energies will need the states.
    let precision = guarded(raised(start(certified.digits)));
    let mut last = None;
    let records = proved_from(precision, certified.digits, |precision| {
        let followed = last.insert(Followed::new(certified, isolated, precision)?);
        let path = &followed.path;
        let records = path::records(&followed.control, path, &*certified.admissibility()?).into_iter();
        let records = records.map(|record| enclose(record).with("dissipated", Field::Absent));
        let mut way = scene.held.path.iter();
        let exact = |(record, event): (Record<Enclosure>, &Event<Interval>)| match event.kind {
            EventKind::Start | EventKind::WayPoint | EventKind::End => match way.next() {
                Some(literal) => held(record, &scene.held.by, literal),
                None => record,
            },
            _ => record,
        };
        Ok(records.zip(&path.events).map(exact).collect())
    });
    let why = "every decision on the path is certain, and its folds are proved to be all";
    let complete = Complete { why: why.to_owned(), ..isolated.complete.clone() };
    let output = |records| Output::new(Want::Path, Promise::Certified, records).complete(complete);
    Ok(decided(records)?.map(output).zip(last))
}

/// None where the question stays open.
fn decided<T>(result: Result<T>) -> Result<Option<T>> {
    match result {
        Err(Error::Undecided { .. } | Error::Unproved { .. }) => Ok(None),
        result => result.map(Some),
    }
}

fn enclose(record: Record<Interval>) -> Record<Enclosure> {
    record.convert(Enclosure::from)
}

/// The same state with the exact value of what is controlled. Surfaces apart carry no load, whatever is applied.
fn held(record: Record<Enclosure>, by: &HeldBy, value: &Literal) -> Record<Enclosure> {
    let in_contact = matches!(record.get("contact_radius"), Some(Field::Number(_)));
    let key = match by {
        HeldBy::Indentation => "indentation",
        HeldBy::Force if !in_contact => return record,
        HeldBy::Force => "force",
        HeldBy::Machine { .. } => "position",
    };
    record.replacing(key, Field::Number(Enclosure::Exact(value.to_rational())))
}
