//! The statements of all steps in Coq.

use super::{Claim, Entry, Step, entries};
use crate::formula::Definition;
use crate::table::rows;

/// The text before the statements.
const BEGIN: &str = include_str!("../../data/statements.v");

impl Step {
    /// The statement as a proposition of Coq; `None` for a step that only cites.
    pub fn coq(&self) -> Option<String> {
        let statement = self.statement().ok()??;
        Some(statement.coq(self.domains, self.claim, self.point))
    }
}

impl Entry {
    /// The name of a step in Coq, which counts from 1 as the pages do.
    pub fn step_in_coq(&self, index: usize) -> String {
        let id: String = self.id.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        format!("step_{id}_{}", index + 1)
    }

    fn coq(&self) -> String {
        let step = |(i, step): (usize, &Step)| {
            let word = step.verdict().word();
            let name = self.step_in_coq(i);
            match step.coq() {
                Some(statement) => format!("(* {word} *)\nDefinition {name} : Prop :=\n  {statement}.\n"),
                None => format!("(* {name}: {word} *)\n"),
            }
        };
        let steps: String = self.steps.iter().enumerate().map(step).collect();
        format!("\n(** ** {}: {} *)\n{steps}", self.id, self.title)
    }
}

/// The statements of entries, after the formulas that have a name: those of all entries are docs/proofs/Statements.v.
///
/// ```
/// let coq = mdr_symbolic::derivations::statements_in_coq(mdr_symbolic::derivations::entry("1.4"));
/// assert!(coq.contains("Definition step_1_4_4 : Prop :=\n  forall (E w a : R), 0 < E -> "));
/// ```
pub fn statements_in_coq(entries: impl IntoIterator<Item = &'static Entry>) -> String {
    let named = Definition::all().filter_map(Definition::coq_definition).collect::<Vec<_>>().join("\n");
    let steps: String = entries.into_iter().map(Entry::coq).collect();
    format!("{BEGIN}\n(** ** The formulas that have a name *)\n{named}\n{steps}")
}

/// The statements that docs/proofs/Steps.v leaves out, each with the reason: the table that `make proofs` compares with it.
const LEFT_OUT: &str = include_str!("../../data/left_out.tsv");

/// The statements that docs/proofs/StepTheorems.v proves though no normal form does, each with the theorem that it follows from.
const BY_THEOREM: &str = include_str!("../../data/by_theorem.tsv");

impl Step {
    /// The name of the statement in Coq.
    fn name_in_coq(&self) -> Option<String> {
        let find = |entry: &'static Entry| {
            let index = entry.steps.iter().position(|step| std::ptr::eq(step, self))?;
            Some(entry.step_in_coq(index))
        };
        entries().iter().find_map(find)
    }

    /// The theorem of `theorems.tsv` from which a step follows that intervals enclose or sample; an empty name for a step that has
    /// a proof of its own, `None` for a step without a proof in docs/proofs/StepTheorems.v.
    pub fn by_theorem(&self) -> Option<&'static str> {
        if self.claim != Claim::Enclosed {
            return None;
        }
        let name = self.name_in_coq()?;
        rows(BY_THEOREM).find(|[step, _]| *step == name).map(|[_, theorem]| theorem)
    }

    /// The name of the statement in Coq, where it is proved: in docs/proofs/Steps.v for every step that normal forms decide, but
    /// for those of `left_out.tsv`, and in docs/proofs/StepTheorems.v for those of `by_theorem.tsv`.
    pub fn proved_in_coq(&self) -> Option<String> {
        let name = self.name_in_coq()?;
        let left_out = || LEFT_OUT.lines().any(|line| line.split('\t').next() == Some(&name));
        let proved = (self.claim == Claim::Proved && !left_out()) || self.by_theorem().is_some();
        proved.then_some(name)
    }
}
