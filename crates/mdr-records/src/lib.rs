//! Generates the certified records of `mdr-reference`.
//!
//! The cases are data: `data/*.toml` name contacts and the quantities wanted. Each is answered by [`mdr`] to fifty
//! proved digits, with |d ln value/d ln input| from dual numbers, and confirmed by a second method that shares no closed
//! form with the first, only the definitions of d and F: quadrature of the heights f(r). [`generate`] gives the files of the
//! release, bit for bit the same on every machine.
//!
//! ```no_run
//! for (file, content) in mdr_records::generate()? {
//!     println!("{file}: {} records", content.lines().count());
//! }
//! # Ok::<(), mdr_records::RecordError>(())
//! ```
//!
//! Fits of data sets are proved by the normal equations, and confirmed by residuals from quadrature.
//!
//! Two kinds of answers are no scene: equilibria at a share of the critical value, which is no decimal, come from
//! `mdr-analytic`; and where surfaces would overlap an enclosure of the gap is written here.

#![forbid(unsafe_code)]

mod builder;
mod cases;
mod certificates;
mod confirm;
mod contact;
mod edges;
mod energy;
mod equilibria;
mod fits;
mod folds;
mod loops;
mod loops_confirm;
mod media;
mod media_certificates;
mod media_confirm;
mod patches;
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

use cases::Case;

pub use certificates::certificates;

/// The significant digits of every record.
const DIGITS: u32 = 50;

/// Why a record cannot be certified.
#[derive(Debug, ThisError)]
#[error("{case}: {source}")]
pub struct RecordError {
    case: String,
    source: Failure,
}

/// Why a case fails.
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
    let certified = || cases.par_iter().map(|(file, case)| (*file, case.certified())).collect::<Vec<_>>();
    let fits = || mdr_reference::data_sets().par_iter().map(fits::records).collect::<Vec<_>>();
    let (records, (fits, media)) = rayon::join(certified, || rayon::join(fits, generate_media));
    let mut files: Vec<(&'static str, String)> = Vec::new();
    for (file, records) in records {
        if files.last().is_none_or(|(name, _)| *name != file) {
            files.push((file, String::new()));
        }
        if let Some((_, content)) = files.last_mut() {
            content.extend(records?.iter().map(|record| record.to_json() + "\n"));
        }
    }
    let mut content = String::new();
    for records in fits {
        content.extend(records?.iter().map(|record| record.to_json() + "\n"));
    }
    files.push((fits::FILE, content));
    files.extend(media?);
    Ok(files)
}

/// The files of the release about media other than the half-space, and about loops.
///
/// # Errors
/// The first question that cannot be certified, or whose second method disagrees.
pub fn generate_media() -> std::result::Result<Vec<(&'static str, String)>, RecordError> {
    let lines = |records: Vec<Record>| records.iter().map(|record| record.to_json() + "\n").collect();
    media::FILES.par_iter().map(|(file, questions)| Ok((*file, lines(media::records(questions)?)))).collect()
}

/// Answers a case.
type Answer = fn(&Case) -> Result<Vec<Record>>;

/// The kinds of cases, by their names in the data; docs/reference/README.md has the formula of each.
const KINDS: [(&str, Answer); 18] = [
    ("kappa", profiles::kappa),
    ("transform", profiles::transform),
    ("state", profiles::state),
    ("flat-punch-pull-off", profiles::pull_off),
    ("critical", folds::critical),
    ("double-root", folds::double_root),
    ("machine-folds", folds::on_machine),
    ("folds", folds::all),
    ("equilibrium", equilibria::at_value),
    ("equilibrium-share", equilibria::at_share),
    ("past", equilibria::none),
    ("equilibria", equilibria::all),
    ("landing", equilibria::landing),
    ("energy", energy::record),
    ("threshold", threshold::records),
    ("domain", edges::domain),
    ("outside", edges::outside),
    ("interpenetrating", edges::interpenetrating),
];

impl Case {
    /// Certifies and confirms its records.
    fn certified(&self) -> std::result::Result<Vec<Record>, RecordError> {
        let records = (self.records)(self).and_then(|records| {
            let chosen = self.chosen(records);
            if chosen.is_empty() { Err(Failure::Missing("such quantity")) } else { Ok(chosen) }
        });
        let formula = self.formula.name.as_deref().unwrap_or_default();
        records.map_err(|source| RecordError { case: format!("{formula} of {} {}", self.name, self.label), source })
    }

    /// The records of the quantity that the case names, under its identifier.
    fn chosen(&self, mut records: Vec<Record>) -> Vec<Record> {
        records.retain(|record| self.row.quantity.as_ref().is_none_or(|quantity| record.quantity == *quantity));
        for record in &mut records {
            record.release = self.row.release.unwrap_or(if self.row.id.is_some() { 2 } else { 1 });
            if let Some(id) = &self.row.id {
                record.id.clone_from(id);
                record.flags.push("worst".to_owned());
            }
        }
        records
    }
}

/// The proved digits of values.
fn decimals<const K: usize>(values: [&Value; K]) -> Result<[Decimal; K]> {
    let digits = |value: &Value| match value {
        Value::Known(Number::Certified(decimal)) => Some(decimal.clone()),
        _ => None,
    };
    let known: Option<Vec<Decimal>> = values.into_iter().map(digits).collect();
    known.and_then(|known| known.try_into().ok()).ok_or(Failure::Missing("proof of every digit"))
}

/// The number that a decimal is.
fn float(ctx: Precision, value: &Decimal) -> Float {
    let parsed = Float::parse(value.to_string());
    parsed.map_or_else(|_| Float::with_val(ctx.bits(), f64::NAN), |text| Float::with_val(ctx.bits(), text))
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
