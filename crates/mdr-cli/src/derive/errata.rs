//! What is to be corrected in the paper.

use mdr_crosscheck::derivations::{Judgement, StepJudgement};
use mdr_symbolic::derivations::Erratum;

/// The entries with an erratum.
pub(super) fn items(judgements: &[Judgement]) -> Vec<(&Judgement, Erratum)> {
    judgements.iter().filter_map(|judgement| Some((judgement, judgement.entry.erratum?))).collect()
}

/// The steps that show it.
pub(super) fn evidence(judgement: &Judgement, erratum: Erratum) -> Vec<&StepJudgement> {
    erratum.shown_by.iter().filter_map(|index| judgement.steps.get(*index)).collect()
}
