//! The output `gap`: the distance of the surfaces of states outside the contact.

use mdr_core::calculus::Estimate;
use mdr_core::contact::{Equilibrium, Result};
use mdr_core::number::Literal;
#[cfg(feature = "mp")]
use mdr_core::number::{Interval, Real, certify::Enclosure};
use mdr_numeric::admissible::Verdict;
use mdr_numeric::fields::Fields;
#[cfg(feature = "mp")]
use mdr_numeric::proof::EnclosedFields;

use super::fields::{Field, FieldRoom, FieldState, OUTSIDE, estimate};
use super::key::Key;
use super::room::{Facts, Subject, not_wanted};
use super::{Output, Want};
use crate::answer::{Admission, AtValue, List, Overlap, Value};
use crate::solve::model::SceneReal;
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

    fn value<R: SceneReal>(fields: &Fields<R>, r: &R) -> Result<Estimate<R>> {
        estimate(fields.gap_estimate(r), || fields.gap(r))
    }

    #[cfg(feature = "mp")]
    fn enclosed(fields: &EnclosedFields<'_>, r: &Interval) -> Result<Interval> {
        fields.gap(r)
    }

    /// With its gap where it is below zero.
    #[cfg(feature = "mp")]
    fn proved_admission(verdict: Verdict, fields: &EnclosedFields<'_>) -> Result<Admission<Enclosure>> {
        let Verdict::Interpenetrating { radius, .. } = &verdict else {
            return Ok(Admission::of(verdict));
        };
        for digits in 3..=17 {
            let literal = decimal(*radius, digits)?;
            let gap = fields.gap(&Interval::from_literal(fields.precision(), &literal));
            if let Ok(gap) = gap
                && gap < gap.lit(0)
            {
                let gap = Value::Known(gap.into());
                return Ok(Admission::overlapping(Some(Overlap { r: Value::Given(literal), gap })));
            }
        }
        Ok(Admission::of(verdict))
    }

    /// Whether a state is admissible; with its gap where it is below zero.
    fn admission<R: SceneReal>(
        states: &States<'_, R>,
        fields: &Fields<R>,
        state: &Equilibrium<R>,
    ) -> Result<Admission<Estimate<R>>> {
        let verdict = states.verdict(state);
        let Verdict::Interpenetrating { radius, .. } = &verdict else {
            return Ok(Admission::of(verdict));
        };
        // As short as it may be: any radius with a negative gap is as good as another.
        for digits in 3..=17 {
            let literal = decimal(*radius, digits)?;
            let gap = fields.gap(&states.model.number(&literal));
            if gap.as_ref().is_ok_and(|gap| *gap < gap.lit(0)) {
                let gap = Value::from_result(gap.map(Estimate::exact))?;
                return Ok(Admission::overlapping(Some(Overlap { r: Value::Given(literal), gap })));
            }
        }
        Ok(Admission::of(verdict))
    }
}
