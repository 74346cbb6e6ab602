//! The output `displacement`: the normal displacement of the surface of states, outside the contact.

use mdr_core::contact::Result;
#[cfg(feature = "mp")]
use mdr_core::number::Interval;
use mdr_core::number::Literal;
use mdr_numeric::fields::Fields;
#[cfg(feature = "mp")]
use mdr_numeric::proof::EnclosedFields;

use super::fields::{Field, FieldRoom, FieldState, OUTSIDE};
use super::key::Key;
use super::room::{Facts, Subject, not_wanted};
use super::{Output, Want};
use crate::answer::{AtValue, List};

pub(super) const FACTS: Facts = Facts {
    of: Subject::States,
    key: Some(Key::Radii(|value, unit| value.positive(unit))),
    question: |keys, kind| Want::Displacement { states: keys.values.clone(), at: keys.radii(kind) },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) states: &'w [Literal],
    pub(super) at: &'w [Literal],
}

impl<'w> FieldRoom<'w> for Room<'w> {
    const FIELD: Field = Field::Displacement;
    const OUTPUT: fn(List<AtValue<FieldState>>) -> Output = Output::Displacement;
    const FRACTIONS: [(i64, i64); 6] = OUTSIDE;

    fn question(&self) -> [&'w [Literal]; 2] {
        [self.states, self.at]
    }

    fn value(fields: &Fields<f64>, r: &f64) -> Result<f64> {
        fields.displacement(r)
    }

    #[cfg(feature = "mp")]
    fn enclosed(fields: &EnclosedFields<'_>, r: &Interval) -> Result<Interval> {
        fields.displacement(r)
    }
}
