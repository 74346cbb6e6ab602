//! What contestants find, and how it is judged.

use mdr_core::number::Interval;
use mdr_core::number::certify::Decimal;
use rug::Float;

use super::super::Outcome;

/// A number in the form in which it was found.
pub(in super::super) enum Found {
    /// As a double.
    Double(f64),
    /// As a number.
    Number(Float),
    /// Between two.
    Enclosure(Interval),
    /// In decimals.
    Decimal(Decimal),
}

impl Found {
    /// An enclosure is worth what its worse end is.
    fn judged(&self, truth: &Interval) -> Outcome {
        match self {
            Found::Double(value) => Outcome::of(value, truth),
            Found::Number(value) => Outcome::of(value, truth),
            Found::Enclosure(interval) => {
                Outcome::worst([interval.lower(), interval.upper()].map(|end| Outcome::of(end, truth)))
            }
            Found::Decimal(decimal) => match Float::parse(decimal.to_string()) {
                Ok(text) => Outcome::of(&Float::with_val(truth.lower().prec(), text), truth),
                Err(error) => Outcome::Failed(error.to_string()),
            },
        }
    }
}

/// The worst of several numbers.
pub(in super::super) fn judged(found: &[Found], truths: &[Interval]) -> Outcome {
    Outcome::worst(found.iter().zip(truths).map(|(found, truth)| found.judged(truth)))
}
