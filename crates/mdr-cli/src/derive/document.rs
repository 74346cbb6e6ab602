//! What text, Markdown and LaTeX have in common.

use mdr_crosscheck::derivations::{Fate, Judgement, Mutants, StepJudgement, is_number};
use mdr_symbolic::derivations::Claim;
use mdr_symbolic::{Decision, Domain};

/// The heading of an entry: an equation by its number in brackets.
pub(super) fn heading(judgement: &Judgement) -> String {
    let entry = judgement.entry;
    match entry.id.starts_with(|c: char| c.is_ascii_digit()) {
        true => format!("({}) {}", entry.id, entry.title),
        false => format!("{} ({})", entry.title, entry.id),
    }
}

/// The verdict on an entry as one word.
pub(super) fn verdict(judgement: &Judgement) -> &'static str {
    if judgement.holds() { judgement.entry.verdict.word() } else { "FAILED" }
}

/// The verdict on a step: one word, and why where it failed.
pub(super) fn step_verdict(step: &StepJudgement) -> String {
    let survivors: Vec<_> = step.mutants.with(Fate::Survives).map(|mutant| mutant.text()).collect();
    match &step.failure {
        Some(failure) => format!("FAILED: {failure}"),
        None if !survivors.is_empty() => format!("FAILED: this is not refuted either: {}", survivors.join("; ")),
        None => step.step.claim.word().to_owned(),
    }
}

/// Where a step holds: its domains and, for a step at one point, the values there.
pub(super) fn place(step: &StepJudgement) -> String {
    if !step.step.point.is_empty() {
        let values: Vec<_> = step.step.point.iter().map(|(name, value)| format!("{} = {value}", shown(name))).collect();
        return format!("at {}", values.join(", "));
    }
    let domains: Vec<_> = step.step.domains.iter().copied().map(Domain::text).collect();
    match step.step.claim {
        Claim::Cited => String::new(),
        Claim::Enclosed if matches!(step.step.statement(), Ok(Some(statement)) if is_number(&statement)) => {
            "in numbers".to_owned()
        }
        Claim::Enclosed => {
            format!("for {}, certain at {} of {} points", domains.join(" and "), step.certain, step.points)
        }
        _ => format!("for {}", domains.join(" and ")),
    }
}

/// The modulus has its star.
fn shown(name: &str) -> &str {
    if name == "E" { "E*" } else { name }
}

/// What normal forms show on the first domain: the witness of a proof or of a refutation.
pub(super) fn witness(step: &StepJudgement) -> Option<mdr_symbolic::Witness> {
    match step.step.check().ok()?.into_iter().next()?.1 {
        Decision::Proved { because } | Decision::Refuted { because } => Some(because),
        Decision::Undecided(_) => None,
    }
}

/// Counts of everything, as one sentence.
pub(super) fn summary(judgements: &[Judgement]) -> String {
    let steps = || judgements.iter().flat_map(|judgement| &judgement.steps);
    let claims = [Claim::Proved, Claim::Enclosed, Claim::Refuted, Claim::Cited];
    let count = |claim| steps().filter(|step| step.step.claim == claim && step.holds()).count();
    let counts: Vec<_> = claims.map(|claim| format!("{} {}", count(claim), claim.word())).into();
    let failed = steps().filter(|step| !step.holds()).count();
    let failed = if failed == 0 { String::new() } else { format!(", {failed} FAILED") };
    let mutants: Mutants = judgements.iter().map(Judgement::mutants).sum();
    let fates = fates(&mutants, |fate| mutants.count(fate) > 0 || fate == Fate::Undecided);
    format!(
        "{} entries, {} steps: {}{failed}. {} distinct mutants: {fates}.",
        judgements.len(),
        steps().count(),
        counts.join(", "),
        mutants.len()
    )
}

/// How many mutants had each of some fates.
fn fates(mutants: &Mutants, told: impl Fn(Fate) -> bool) -> String {
    let fates = Fate::ALL.into_iter().filter(|fate| told(*fate));
    fates.map(|fate| format!("{} {}", mutants.count(fate), fate.words())).collect::<Vec<_>>().join(", ")
}

/// How many distinct mutants there were, and what became of them.
pub(super) fn mutants(mutants: &Mutants) -> String {
    let occurs = |fate| mutants.count(fate) > 0;
    match (mutants.len(), &Fate::ALL.into_iter().filter(|fate| occurs(*fate)).collect::<Vec<_>>()[..]) {
        (1, [fate]) => format!("1 mutant, {}.", fate.words()),
        (count, [fate]) => format!("{count} distinct mutants, all {}.", fate.words()),
        (count, _) => format!("{count} distinct mutants: {}.", fates(mutants, occurs)),
    }
}

/// How many steps of each kind, briefly.
pub(super) fn tally(judgement: &Judgement) -> String {
    let claims = [Claim::Proved, Claim::Enclosed, Claim::Refuted, Claim::Cited];
    let count = |claim| judgement.steps.iter().filter(|step| step.step.claim == claim).count();
    let counts = claims.into_iter().filter(|claim| count(*claim) > 0);
    counts.map(|claim| format!("{} {}", count(claim), claim.word())).collect::<Vec<_>>().join(", ")
}
