//! Generates the certified records of `mdr-reference`.
//!
//! The cases are data: `data/*.toml` name contacts and what is asked of them. Each is answered by [`mdr`] to fifty proved
//! digits, with |d ln value/d ln input| from dual numbers, and confirmed by a second method that shares no formula with the
//! first: quadrature of the heights f(r). [`generate`] gives the files of the release, bit for bit the same on every machine.
//!
//! Three kinds of values are no scene, and come from `mdr-analytic`: equilibria at a share of the critical value, which is no
//! decimal; κ of an exponent without a contact; and the sign of the gap where surfaces would overlap.

#![forbid(unsafe_code)]

mod builder;
mod cases;
mod confirm;
mod contact;
mod edges;
mod energy;
mod equilibria;
mod folds;
mod profiles;
mod sensitivity;
mod threshold;

use mdr::prelude::{Number, Value};
use mdr_core::contact::Error as ContactError;
use mdr_core::number::{Decimal, Precision};
use mdr_reference::Record;
use rayon::prelude::*;
use rug::Float;
use thiserror::Error as ThisError;

use cases::{Case, Kind};

/// The significant digits of every record.
const DIGITS: u32 = 50;

/// Why a record cannot be certified.
#[derive(Debug, ThisError)]
#[error("{case}: {source}")]
pub struct RecordError {
    case: String,
    source: Failure,
}

/// What is wrong with a case.
#[derive(Debug, ThisError)]
enum Failure {
    #[error(transparent)]
    Scene(#[from] mdr::Error),
    #[error(transparent)]
    Contact(#[from] ContactError),
    #[error("cannot read the case: {0}")]
    Data(String),
    #[error("there is no {0}")]
    Missing(&'static str),
    #[error("the second method has another value of {0}")]
    Unconfirmed(&'static str),
}

type Result<T> = std::result::Result<T, Failure>;

impl Failure {
    /// An error unless the second method agrees.
    fn unless(what: &'static str, agrees: bool) -> Result<()> {
        if agrees { Ok(()) } else { Err(Failure::Unconfirmed(what)) }
    }
}

/// The files of the release: name and content.
///
/// # Errors
/// The first case that cannot be certified, or whose second method disagrees.
pub fn generate() -> std::result::Result<Vec<(&'static str, String)>, RecordError> {
    let cases = cases::all()?;
    let records: Vec<_> = cases.par_iter().map(|case| (case.file, case.records())).collect();
    let mut files: Vec<(&'static str, String)> = Vec::new();
    for (file, records) in records {
        if files.last().is_none_or(|(name, _)| *name != file) {
            files.push((file, String::new()));
        }
        if let Some((_, content)) = files.last_mut() {
            content.extend(records?.iter().map(|record| record.to_json() + "\n"));
        }
    }
    Ok(files)
}

impl Case {
    /// Certifies and confirms its records.
    fn records(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let records = match self.kind {
            Kind::Kappa => profiles::kappa(self),
            Kind::Transform => profiles::transform(self),
            Kind::State => profiles::state(self),
            Kind::FlatPunchPullOff => profiles::pull_off(self),
            Kind::Critical | Kind::DoubleRoot | Kind::MachineFolds | Kind::Folds => folds::records(self),
            Kind::Equilibrium | Kind::EquilibriumShare => equilibria::of_power_law(self),
            Kind::Equilibria => equilibria::all(self),
            Kind::Landing => equilibria::landing(self),
            Kind::Past => equilibria::none(self),
            Kind::Energy => energy::record(self),
            Kind::Threshold => threshold::records(self),
            Kind::Domain => edges::domain(self),
            Kind::Outside => edges::outside(self),
            Kind::Interpenetrating => edges::interpenetrating(self),
        };
        let chosen = records
            .map(|records| self.chosen(records))
            .and_then(|records| if records.is_empty() { Err(Failure::Missing("such quantity")) } else { Ok(records) });
        chosen.map_err(|source| RecordError { case: format!("{:?} of {}", self.kind, self.name), source })
    }

    /// The quantity that the case asks for, under the identifier that it gives.
    fn chosen(&self, mut records: Vec<Record>) -> Vec<Record> {
        records.retain(|record| self.quantity.as_ref().is_none_or(|quantity| record.quantity == *quantity));
        for record in &mut records {
            record.release = self.release;
            if let Some(id) = &self.id {
                record.id.clone_from(id);
                record.flags.push("worst".to_owned());
            }
        }
        records
    }
}

/// The proved digits of a value.
fn decimal(value: &Value) -> Result<Decimal> {
    match value {
        Value::Known(Number::Certified(decimal)) => Ok(decimal.clone()),
        _ => Err(Failure::Missing("proof of every digit")),
    }
}

/// The number that a decimal is.
fn float(ctx: Precision, value: &Decimal) -> Float {
    let parsed = Float::parse(value.to_string());
    parsed.map_or_else(|_| Float::with_val(ctx.bits(), f64::NAN), |text| Float::with_val(ctx.bits(), text))
}
