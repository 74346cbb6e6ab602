//! Derivations for a terminal.

use mdr_crosscheck::derivations::{Fate, Judgement};

use super::{Extent, document, errata, prose};
use crate::table::{Tone, cell, render, table};

/// Columns of prose.
const WIDTH: usize = 100;

pub(super) fn write(extent: Extent<'_>) -> String {
    match extent {
        Extent::All(judgements) => overview(judgements),
        Extent::One(judgement) => entry(judgement),
        Extent::Errata(judgements) => {
            let items = errata::items(judgements).into_iter().map(|(judgement, erratum)| {
                format!("{}\n{}", document::heading(judgement), wrapped(&words(erratum.text), "  "))
            });
            items.collect::<Vec<_>>().join("\n\n")
        }
    }
}

fn overview(judgements: &[Judgement]) -> String {
    let mut table = table(&["id", "what", "steps", "mutants", "verdict"]);
    for judgement in judgements {
        let tone = if judgement.holds() { Tone::Good } else { Tone::Bad };
        table.add_row([
            cell(judgement.entry.id, Tone::Strong),
            cell(judgement.entry.title, Tone::Plain),
            cell(document::tally(judgement), Tone::Faint),
            cell(judgement.mutants().len(), Tone::Faint),
            cell(document::verdict(judgement), tone),
        ]);
    }
    format!("{}\n\n{}", render(&table), document::summary(judgements))
}

fn entry(judgement: &Judgement) -> String {
    let entry = judgement.entry;
    let mut lines = vec![format!("{}: {}", document::heading(judgement), document::verdict(judgement))];
    lines.extend(entry.assumptions.iter().map(|assumption| format!("  assumes {}", words(assumption))));
    lines.push(wrapped(&format!("where {}", document::hypotheses(judgement)), "  "));
    lines.extend(document::theorems(judgement, |theorem| {
        wrapped(&format!("theorem {} ({}): {}", theorem.name, theorem.file, theorem.says), "  ")
    }));
    for (i, step) in judgement.steps.iter().enumerate() {
        let place = document::place(step);
        let blank = if place.is_empty() { "" } else { " " };
        lines.push(format!("\n{}. {}{blank}{place}", i + 1, document::step_verdict(step)));
        if let Ok(Some(statement)) = step.step.statement() {
            lines.push(format!("     {}", statement.text()));
        }
        if let Some(witness) = document::witness(step) {
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
    let mutants = judgement.mutants();
    lines.push(format!("\n{}", document::mutants(&mutants)));
    for fate in [Fate::Meaningless, Fate::Undecided] {
        let named = mutants.with(fate).map(|mutant| format!("{}: {}", fate.words(), mutant.text()));
        lines.extend(named.map(|mutant| wrapped(&mutant, "  ")));
    }
    lines.join("\n")
}

fn words(text: &str) -> String {
    prose::render(text, str::to_owned, |math| math.text())
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
