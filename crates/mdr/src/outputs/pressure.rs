//! The output `pressure`: the normal pressure of states within the contact.

use mdr_core::contact::Result;
#[cfg(feature = "mp")]
use mdr_core::number::Interval;
use mdr_core::number::Literal;
use mdr_numeric::fields::Fields;
#[cfg(feature = "mp")]
use mdr_numeric::proof::EnclosedFields;

use super::fields::{Field, FieldRoom, FieldState};
use super::key::Key;
use super::room::{Facts, Subject, not_wanted};
use super::{Output, Want};
use crate::answer::{AtValue, List};

pub(super) const FACTS: Facts = Facts {
    of: Subject::States,
    key: Some(Key::Radii(|value, unit| value.not_negative(unit))),
    question: |keys, kind| Want::Pressure { states: keys.values.clone(), at: keys.radii(kind) },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) states: &'w [Literal],
    pub(super) at: &'w [Literal],
}

impl<'w> FieldRoom<'w> for Room<'w> {
    const FIELD: Field = Field::Pressure;
    const OUTPUT: fn(List<AtValue<FieldState>>) -> Output = Output::Pressure;
    const FRACTIONS: [(i64, i64); 6] = [(0, 1), (1, 4), (1, 2), (3, 4), (9, 10), (99, 100)];

    fn question(&self) -> [&'w [Literal]; 2] {
        [self.states, self.at]
    }

    fn value(fields: &Fields<f64>, r: &f64) -> Result<f64> {
        fields.pressure(r)
    }

    #[cfg(feature = "mp")]
    fn enclosed(fields: &EnclosedFields<'_>, r: &Interval) -> Result<Interval> {
        fields.pressure(r)
    }

    #[cfg(feature = "mp")]
    fn is_in_doubles(fields: &EnclosedFields<'_>, r: &Interval) -> bool {
        fields.is_at_kink(r)
    }
}
