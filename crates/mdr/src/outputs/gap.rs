//! The output `gap`: the distance of the surfaces of states outside the contact.

use mdr_core::contact::{Equilibrium, Result};
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, certify::Enclosure};
use mdr_core::number::{Literal, Real};
use mdr_numeric::admissible::GapVerdict;
use mdr_numeric::fields::Fields;
#[cfg(feature = "mp")]
use mdr_numeric::proof::EnclosedFields;

use super::fields::{Field, FieldRoom, FieldState, OUTSIDE};
use super::key::Key;
use super::room::{Facts, Subject, not_wanted};
use super::{Output, Want};
use crate::answer::{Admission, AtValue, List, Overlap, Value};
use crate::solve::sample::decimal;
use crate::solve::states::States;

pub(super) const FACTS: Facts = Facts {
    of: Subject::States,
    key: Some(Key::Radii(|value, unit| value.positive(unit))),
    question: |keys, kind| Want::Gap { states: keys.values.clone(), at: keys.radii(kind) },
    unused: not_wanted,
};

pub(super) struct Room<'w> {
    pub(super) states: &'w [Literal],
    pub(super) at: &'w [Literal],
}

impl<'w> FieldRoom<'w> for Room<'w> {
    const FIELD: Field = Field::Gap;
    const OUTPUT: fn(List<AtValue<FieldState>>) -> Output = Output::Gap;
    const FRACTIONS: [(i64, i64); 6] = OUTSIDE;

    fn question(&self) -> [&'w [Literal]; 2] {
        [self.states, self.at]
    }

    fn value(fields: &Fields<f64>, r: &f64) -> Result<f64> {
        fields.gap(r)
    }

    #[cfg(feature = "mp")]
    fn enclosed(fields: &EnclosedFields<'_>, r: &Interval) -> Result<Interval> {
        fields.gap(r)
    }

    /// With its gap where it is below zero.
    #[cfg(feature = "mp")]
    fn proved_admission(verdict: GapVerdict, fields: &EnclosedFields<'_>) -> Result<Admission<Enclosure>> {
        let number = |r: &Literal| Interval::from_literal(fields.precision(), r);
        with_gap(verdict, |r| fields.gap(&number(r)), Enclosure::from)
    }

    /// Whether a state is admissible; with its gap where it is below zero.
    fn admission(states: &States<'_, f64>, fields: &Fields<f64>, state: &Equilibrium<f64>) -> Result<Admission<f64>> {
        with_gap(states.verdict(state), |r| fields.gap(&states.model.number(r)), |gap| gap)
    }
}

/// A verdict, with the gap at a radius where it is below zero. The radius is as short as it may be: any other one is as good.
fn with_gap<R: Real, N>(
    verdict: GapVerdict,
    gap: impl Fn(&Literal) -> Result<R>,
    shown: impl FnOnce(R) -> N,
) -> Result<Admission<N>> {
    let GapVerdict::Interpenetrating { radius, .. } = &verdict else {
        return Ok(Admission::of(verdict));
    };
    for digits in 3..=17 {
        let r = decimal(*radius, digits)?;
        if let Ok(gap) = gap(&r)
            && gap < gap.lit(0)
        {
            let (r, gap) = (Value::Given(r), Value::Known(shown(gap)));
            return Ok(Admission::overlapping(Some(Overlap { r, gap })));
        }
    }
    Ok(Admission::of(verdict))
}
