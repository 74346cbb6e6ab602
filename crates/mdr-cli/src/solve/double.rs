//! A scene in f64.

use std::cell::OnceCell;
use std::sync::Arc;

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Instability, Result, Status};
use mdr_core::number::Literal;
use mdr_numeric::admissible::{Admissibility, search_range};
use mdr_numeric::folds::{self, Beyond, Completeness, Folds};

use super::answer::{Complete, Output, Promise};
use super::contact::{Contact, Tally};
use super::digits::rounded;
use super::record::{Field, Record};
use super::states::States;
use super::{outputs, sample};
use crate::number::Number;
use crate::scene::{Scene, Want};

/// The contact in f64; its folds are searched when something needs them, and once.
pub(crate) struct Double<'s> {
    scene: &'s Scene,
    contact: Contact<f64>,
    folds: OnceCell<Folds<f64>>,
    admissibility: OnceCell<Arc<Admissibility<'static>>>,
    /// Whether a fold is of use without its force, which is out of range.
    radii_do: bool,
}

impl<'s> Double<'s> {
    /// # Errors
    /// As [`Contact::new`].
    pub(crate) fn new(scene: &'s Scene, tally: &Arc<Tally>) -> Result<Self> {
        Ok(Double::with(scene, Contact::new(scene, (), tally)?, false))
    }

    /// The lengths of the contact alone, for other arithmetics to start from. Folds whose force is out of range are among them.
    ///
    /// # Errors
    /// As [`Contact::in_units_of_modulus`].
    pub(crate) fn rough(scene: &'s Scene, tally: &Arc<Tally>) -> Result<Self> {
        Ok(Double::with(scene, Contact::in_units_of_modulus(scene, tally)?, true))
    }

    fn with(scene: &'s Scene, contact: Contact<f64>, radii_do: bool) -> Self {
        Double { scene, contact, folds: OnceCell::new(), admissibility: OnceCell::new(), radii_do }
    }

    /// Which states are admissible: searched when something needs it, and once, around the folds that are known.
    pub(crate) fn admissibility(&self) -> Arc<Admissibility<'static>> {
        let search = || {
            let rises = self.contact.transform().rises();
            let folds = self.folds().ok().filter(|_| !rises);
            let radii: Vec<f64> =
                folds.into_iter().flat_map(|folds| folds.iter().map(|fold| fold.contact_radius)).collect();
            let length = self.contact.curve().material_length();
            Arc::new(Admissibility::new(self.contact.shared(), search_range(length, &radii)))
        };
        Arc::clone(self.admissibility.get_or_init(search))
    }

    pub(crate) fn contact(&self) -> &Contact<f64> {
        &self.contact
    }

    /// # Errors
    /// As [`folds::find`].
    pub(crate) fn folds(&self) -> Result<&Folds<f64>> {
        if let Some(folds) = self.folds.get() {
            return Ok(folds);
        }
        let curve = self.contact.curve();
        let mut found = folds::find(&curve)?;
        for Beyond { contact_radius, kind, error } in std::mem::take(&mut found.beyond) {
            if !self.radii_do {
                return Err(error);
            }
            let indentation = curve.indentation(&contact_radius)?;
            found.folds.push(Instability { contact_radius, indentation, force: f64::NAN, kind });
        }
        found.folds.sort_by(|one, other| one.contact_radius.total_cmp(&other.contact_radius));
        Ok(self.folds.get_or_init(|| found))
    }

    /// # Errors
    /// Those of the transform and of the quadratures.
    pub(crate) fn output(&self, want: Want) -> Result<Output> {
        let wanted = &self.scene.output;
        let records = match want {
            Want::Transform => rounded(outputs::transform(&self.contact, &wanted.transform)?),
            Want::Folds => {
                let judged = |fold: &Instability<f64>| outputs::fold(fold.clone(), &self.admissibility());
                rounded(self.folds()?.folds.iter().map(judged).collect())
            }
            Want::Curve => rounded(outputs::curve(&self.contact, &self.radii()?, &self.admissibility())?),
            Want::Equilibria => self.states()?.equilibria(&wanted.values)?,
            Want::Path => self.states()?.path(&self.scene.held)?,
            Want::Pressure | Want::Gap | Want::Displacement | Want::Energy => {
                self.states()?.fields(self.scene, &wanted.values, want)?
            }
        };
        let records = records
            .into_iter()
            .map(|record: Record<Estimate<f64>>| record.map(&mut |number| double(number.value)))
            .collect();
        Ok(match want {
            Want::Path => Output::path(Promise::Double, records).complete(self.completeness()?),
            Want::Folds | Want::Equilibria => {
                Output::new(want, Promise::Double, records).complete(self.completeness()?)
            }
            _ => Output::new(want, Promise::Double, records),
        })
    }

    fn states(&self) -> Result<States<'_, f64>> {
        Ok(States::new(&self.contact, self.folds()?.clone(), self.admissibility()))
    }

    /// The contact radii to which the path of the scene leads, and those of the equilibria at its values, as far as they are
    /// found, and where the scene wants any.
    pub(crate) fn visited(&self) -> Vec<f64> {
        let (held, wanted) = (&self.scene.held, &self.scene.output);
        let [moves, rests] = [Want::Path, Want::Equilibria].map(|want| wanted.wants(|other| other == want));
        match self.states() {
            Ok(states) if moves || rests => {
                states.visited(moves.then_some(held), if rests { &wanted.values } else { &[] })
            }
            _ => Vec::new(),
        }
    }

    /// The contact radii of `curve`.
    pub(crate) fn radii(&self) -> Result<Vec<Literal>> {
        let given = &self.scene.output.curve;
        if given.is_empty() { sample::radii(&self.contact, self.folds()?) } else { Ok(given.clone()) }
    }

    pub(crate) fn completeness(&self) -> Result<Complete> {
        Ok(match self.folds()?.completeness {
            Completeness::Resolved => not_proved("searched over all radii in f64"),
            Completeness::Doubtful => not_proved("searched in f64, and not resolved everywhere: folds may be missing"),
        })
    }
}

/// A list that is not proved to be complete.
pub(crate) fn not_proved(why: &str) -> Complete {
    Complete { proved: false, from: None, to: None, why: why.to_owned() }
}

/// A double as it is printed; one that is no number is out of range.
fn double(value: f64) -> Field<Number> {
    if value.is_finite() {
        Field::Number(Number::Double(value))
    } else {
        Field::Marked { status: Status::Overflow, log10: None, why: None }
    }
}
