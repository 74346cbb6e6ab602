//! Judged derivations as documents: text for a terminal, Markdown with mathematics that GitHub renders, and LaTeX.

mod latex;
mod markdown;
mod prose;
mod text;

use mdr_symbolic::derivations::{Erratum, TheoremBasis, Verdict};
use mdr_symbolic::{Decision, Domain};

use super::{AGREEMENT, Judgement, MutantVerdict, Mutants, StepJudgement};

/// The choice of derivations that a document contains.
///
/// ```
/// use mdr_crosscheck::derivations::{Document, judge};
/// let judgement = judge(mdr_symbolic::derivations::entry("1.4").expect("an equation of the paper"));
/// let page = Document::One(&judgement).markdown();
/// assert!(page.starts_with("# (1.4)") && page.contains("**proved**"));
/// ```
#[derive(Clone, Copy, Debug)]
pub enum Document<'a> {
    /// All derivations, with an introduction and an overview.
    All(&'a [Judgement]),
    /// The steps of one entry.
    One(&'a Judgement),
    /// The corrections to the paper, with the steps that show them.
    Errata(&'a [Judgement]),
}

/// The heading of an entry: an equation by its number in brackets.
fn heading(judgement: &Judgement) -> String {
    let entry = judgement.entry;
    match entry.id.starts_with(|c: char| c.is_ascii_digit()) {
        true => format!("({}) {}", entry.id, entry.title),
        false => format!("{} ({})", entry.title, entry.id),
    }
}

/// The verdict on a step: one word, and why where it failed.
fn step_verdict(step: &StepJudgement) -> String {
    let survivors: Vec<_> = step.mutants.with(MutantVerdict::Survives).map(|mutant| mutant.text()).collect();
    match &step.failure {
        Some(failure) => format!("FAILED: {failure}"),
        None if !survivors.is_empty() => format!("FAILED: this is not refuted either: {}", survivors.join("; ")),
        None => step.step.verdict().word().to_owned(),
    }
}

/// Where a step holds, with a blank before it: its domains and, for a step at one point, the values there.
fn place(step: &StepJudgement) -> String {
    let bits = if step.step.verdict() == Verdict::Agrees { format!(" to {AGREEMENT} bits") } else { String::new() };
    if !step.step.point.is_empty() {
        let values: Vec<_> = step.step.point.iter().map(|(name, value)| format!("{} = {value}", shown(name))).collect();
        return format!(" at {}{bits}", values.join(", "));
    }
    let domains: Vec<_> = step.step.domains.iter().copied().map(Domain::text).collect();
    match step.step.verdict() {
        Verdict::Cited | Verdict::Definition => String::new(),
        Verdict::Enclosed | Verdict::Agrees => format!(" in numbers{bits}"),
        Verdict::Sampled => {
            format!(" for {}, certain at {} of {} points", domains.join(" and "), step.certain, step.points)
        }
        Verdict::Theorem => {
            let by = step.step.by_theorem().filter(|name| !name.is_empty()).map(|name| format!(", by {name}"));
            let coq = step.step.proved_in_coq().map(|name| format!(", in Coq {name}")).unwrap_or_default();
            format!(" for {}{coq}{}", domains.join(" and "), by.unwrap_or_default())
        }
        _ => {
            let coq = step.step.proved_in_coq().map(|name| format!(", in Coq {name}")).unwrap_or_default();
            format!(" for {}{coq}", domains.join(" and "))
        }
    }
}

/// Several texts in a sentence.
fn joined(texts: &[&str], write: impl Fn(&str) -> String) -> String {
    texts.iter().map(|text| write(text)).collect::<Vec<_>>().join("; ")
}

/// The hypotheses on the symbols of every statement of an entry.
fn hypotheses(judgement: &Judgement) -> String {
    let names = |statement: &'static str| statement.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\''));
    let mut used = judgement.steps.iter().filter_map(|step| step.step.statement).flat_map(names);
    let profile = if used.any(|name| ["g", "g'", "G", "Q", "d_g", "F_g"].contains(&name)) {
        "; g is continuous at a, differentiable where its slope occurs, and a is no kink and no vertical edge"
    } else {
        ""
    };
    format!("every symbol is a positive real number{profile}")
}

/// The modulus has its star.
fn shown(name: &str) -> &str {
    if name == "E" { "E*" } else { name }
}

/// The witness of a proof or of a refutation by normal forms on the first domain.
fn witness(step: &StepJudgement) -> Option<mdr_symbolic::Witness> {
    match step.step.check().ok()?.into_iter().next()?.1 {
        Decision::Proved { because } | Decision::Refuted { because } => Some(because),
        Decision::Undecided(_) => None,
    }
}

/// Counts of everything, as one sentence.
pub fn summary(judgements: &[Judgement]) -> String {
    let steps = || judgements.iter().flat_map(|judgement| &judgement.steps);
    let counts = tally(steps().filter(|step| step.holds()));
    let failed = steps().filter(|step| !step.holds()).count();
    let failed = if failed == 0 { String::new() } else { format!(", {failed} FAILED") };
    let mutants: Mutants = judgements.iter().map(Judgement::mutants).sum();
    let verdicts = verdicts(&mutants, |verdict| mutants.count(verdict) > 0 || verdict == MutantVerdict::Undecided);
    format!(
        "{} entries, {} with theorems of Coq; {} steps: {counts}{failed}. {} distinct mutants: {verdicts}.",
        judgements.len(),
        judgements.iter().filter(|judgement| judgement.entry.theorems().next().is_some()).count(),
        steps().count(),
        mutants.len()
    )
}

/// How many steps have each verdict, where some have it.
fn tally<'a>(steps: impl Iterator<Item = &'a StepJudgement> + Clone) -> String {
    let count = |verdict| steps.clone().filter(|step| step.step.verdict() == verdict).count();
    let counts = Verdict::ALL.into_iter().filter(|verdict| count(*verdict) > 0);
    counts.map(|verdict| format!("{} {}", count(verdict), verdict.word())).collect::<Vec<_>>().join(", ")
}

/// How many mutants had each of some verdicts.
fn verdicts(mutants: &Mutants, shown: impl Fn(MutantVerdict) -> bool) -> String {
    let verdicts = MutantVerdict::ALL.into_iter().filter(|verdict| shown(*verdict));
    verdicts.map(|verdict| format!("{} {}", mutants.count(verdict), verdict.name())).collect::<Vec<_>>().join(", ")
}

/// The number of distinct mutants, and the verdicts on them.
fn mutants(mutants: &Mutants) -> String {
    let occurs = |verdict| mutants.count(verdict) > 0;
    match (mutants.len(), &MutantVerdict::ALL.into_iter().filter(|verdict| occurs(*verdict)).collect::<Vec<_>>()[..]) {
        (1, [verdict]) => format!("1 mutant, {}.", verdict.name()),
        (count, [verdict]) => format!("{count} distinct mutants, all {}.", verdict.name()),
        (count, _) => format!("{count} distinct mutants: {}.", verdicts(mutants, occurs)),
    }
}

impl Judgement {
    /// The verdict on the entry as one word.
    pub fn verdict(&self) -> &'static str {
        if self.holds() { self.entry.verdict().word() } else { "FAILED" }
    }

    /// What the theorems of the entry rest on, where its verdict is that of a theorem.
    fn basis(&self) -> Option<TheoremBasis> {
        (self.holds() && self.entry.verdict() == Verdict::Theorem).then(|| self.entry.basis()).flatten()
    }

    /// The verdict, with the basis of a theorem that is not derived from the energy, briefly.
    pub fn verdict_and_basis(&self) -> String {
        match self.basis() {
            Some(basis) if basis != TheoremBasis::Derived => format!("{} ({})", self.verdict(), basis.word()),
            _ => self.verdict().to_owned(),
        }
    }

    /// The basis of a theorem in words, after a comma.
    fn basis_in_words(&self) -> String {
        self.basis().map(|basis| format!(", {}", basis.words())).unwrap_or_default()
    }

    /// How many steps of each kind, briefly.
    pub fn tally(&self) -> String {
        tally(self.steps.iter())
    }
}

/// The entries with an erratum, each with the steps that show it.
fn errata(judgements: &[Judgement]) -> impl Iterator<Item = (&Judgement, Erratum, Vec<&StepJudgement>)> {
    judgements.iter().filter_map(|judgement| {
        let erratum = judgement.entry.erratum?;
        let evidence = erratum.shown_by.iter().filter_map(|index| judgement.steps.get(*index)).collect();
        Some((judgement, erratum, evidence))
    })
}
