//! Derivations for a terminal.

use super::{
    Document, Judgement, MutantVerdict, errata, heading, hypotheses, mutants, place, prose, step_verdict, witness,
};

/// Columns of prose.
const WIDTH: usize = 100;

impl Document<'_> {
    /// Lines of at most 100 columns; of all derivations, the entries one after the other.
    pub fn text(self) -> String {
        match self {
            Document::All(judgements) => judgements.iter().map(entry).collect::<Vec<_>>().join("\n\n"),
            Document::One(judgement) => entry(judgement),
            Document::Errata(judgements) => {
                let items = errata(judgements).map(|(judgement, erratum, _)| {
                    format!("{}\n{}", heading(judgement), wrapped(&words(erratum.text), "  "))
                });
                items.collect::<Vec<_>>().join("\n\n")
            }
        }
    }
}

fn entry(judgement: &Judgement) -> String {
    let entry = judgement.entry;
    let mut lines = vec![format!("{}: {}{}", heading(judgement), judgement.verdict(), judgement.basis_in_words())];
    lines.extend(entry.assumptions.iter().map(|assumption| format!("  assumes {}", words(assumption))));
    lines.push(wrapped(&format!("where {}", hypotheses(judgement)), "  "));
    lines.extend(
        entry
            .theorems()
            .map(|theorem| wrapped(&format!("theorem {} ({}): {}", theorem.name, theorem.file, theorem.says), "  ")),
    );
    for (i, step) in judgement.steps.iter().enumerate() {
        lines.push(format!("\n{}. {}{}", i + 1, step_verdict(step), place(step)));
        if let Ok(Some(statement)) = step.step.statement() {
            lines.push(format!("     {}", statement.text()));
        }
        if let Some(witness) = witness(step) {
            lines.push(wrapped(&witness.describe(&|text, _| text.to_owned()), "     "));
        }
        lines.push(wrapped(&words(step.step.why), "   "));
    }
    if let Some(erratum) = entry.erratum {
        lines.push(format!("\nErratum\n{}", wrapped(&words(erratum.text), "   ")));
    }
    if !entry.references.is_empty() {
        lines.push("\nReferences".to_owned());
        lines.extend(entry.references.iter().map(|reference| wrapped(reference, "   ")));
    }
    let all = judgement.mutants();
    lines.push(format!("\n{}", mutants(&all)));
    for verdict in [MutantVerdict::Meaningless, MutantVerdict::Undecided] {
        let named = all.with(verdict).map(|mutant| format!("{}: {}", verdict.name(), mutant.text()));
        lines.extend(named.map(|mutant| wrapped(&mutant, "  ")));
    }
    lines.join("\n")
}

fn words(text: &str) -> String {
    prose::render(text, str::to_owned, |text, _| text.to_owned())
}

/// The text broken into indented lines.
fn wrapped(text: &str, indent: &str) -> String {
    let mut lines = vec![indent.to_owned()];
    for word in text.split_whitespace() {
        let line = lines.last().map_or(0, |line| line.chars().count());
        if line + word.chars().count() >= WIDTH && line > indent.len() {
            lines.push(indent.to_owned());
        }
        if let Some(line) = lines.last_mut() {
            if line.len() > indent.len() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines.join("\n")
}
