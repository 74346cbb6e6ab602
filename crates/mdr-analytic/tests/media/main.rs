//! Closed forms of media other than the half-space: published values, identities and limits.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod graded;
mod line;
mod wave;

use mdr_core::contact::{Quantity, Result};
use mdr_core::number::certify::certify;
use mdr_core::number::{Interval, Literal, Precision, Real};

/// Numbers of a scene over intervals, with 27 proved digits, against printed values of as many digits or more.
pub(crate) fn prove<const K: usize>(expected: [&str; K], f: impl Fn(Precision) -> Result<[Interval; K]>) {
    let quantities = [Quantity::Parameter("a number of the test"); K];
    let found = certify(quantities, 27, Precision::new(140), |precision| Ok(f(precision)?.map(Into::into)));
    for (decimal, expected) in found.unwrap().iter().zip(expected) {
        let [found, expected] = [decimal.to_string(), expected.to_owned()].map(|text| exact(&text));
        // A printed value is right to its last digit, so both are within half a unit of theirs.
        let error = ((found - &expected) / &expected).abs();
        assert!(error < error.lit(10).powi(-26), "{decimal} against {expected}");
    }
}

fn exact(text: &str) -> Interval {
    Interval::from_literal(Precision::new(400), &text.parse::<Literal>().unwrap())
}

/// A decimal as an enclosure.
pub(crate) fn number(precision: Precision, text: &str) -> Interval {
    Interval::from_literal(precision, &text.parse::<Literal>().unwrap())
}
