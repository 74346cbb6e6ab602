//! Derivations as pages, with mathematics that GitHub renders.

use mdr_symbolic::Symbol;
use mdr_symbolic::formula::Definition;

use super::{Document, errata, heading, hypotheses, joined, place, prose, step_verdict, summary, witness};
use crate::derivations::{AGREEMENT, Judgement, MutantVerdict, OCTAVES, POINTS, StepJudgement};

/// The longest witness that is shown, in characters of TeX.
const LONGEST: usize = 260;

impl Document<'_> {
    /// A page, with formulas in TeX.
    pub fn markdown(self) -> String {
        match self {
            Document::All(judgements) => page(judgements),
            Document::One(judgement) => entry(judgement, "#"),
            Document::Errata(judgements) => errata_page(judgements),
        }
    }
}

/// The text before the notation, with the numbers that it names.
fn introduction() -> String {
    let numbers = [
        ("{AGREEMENT}", AGREEMENT.to_string()),
        ("{POINTS}", POINTS.to_string()),
        ("{lowest}", OCTAVES.start().to_string()),
        ("{highest}", (OCTAVES.end() + 1).to_string()),
    ];
    let text = include_str!("../../../text/derivations.md").to_owned();
    numbers.iter().fold(text, |text, (name, number)| text.replace(name, number))
}

fn page(judgements: &[Judgement]) -> String {
    let mut page = introduction();
    page += &notation();
    page += "\n## Overview\n\n| id | what | steps | mutants | verdict |\n|---|---|---|---|---|\n";
    for judgement in judgements {
        page += &format!(
            "| [{}](#{}) | {} | {} | {} | {} |\n",
            judgement.entry.id,
            anchor(&heading(judgement)),
            judgement.entry.title,
            judgement.tally(),
            judgement.mutants().len(),
            judgement.verdict_and_basis()
        );
    }
    page += &format!("\n{}\n", summary(judgements));
    for judgement in judgements {
        page += "\n";
        page += &entry(judgement, "##");
        page += "\n";
        for [name, file, caption] in figures(judgement.entry.id) {
            page += &format!("\n![{name}](figures/{file})\n\n{name}, [computed](figures.md): {caption}\n");
        }
    }
    page.trim_end().to_owned()
}

/// The figures of the paper, computed, that belong to an entry: their names, their files in `docs/figures`, their captions.
fn figures(id: &str) -> impl Iterator<Item = [&'static str; 3]> {
    include_str!("../../../data/figures.tsv").lines().filter_map(move |line| {
        let [entry, figure @ ..]: [&str; 4] = line.split('\t').collect::<Vec<_>>().try_into().ok()?;
        (entry == id).then_some(figure)
    })
}

/// The symbols that stand in the paper or need a word, and the definitions in use.
fn notation() -> String {
    let mut lines = String::new();
    for name in ["E", "w", "C", "κ", "a", "d", "k", "g", "g'", "G", "Q"] {
        if let Some(symbol) = Symbol::named(name) {
            lines += &format!("* $`{}`$: {}\n", symbol.tex(), escaped(symbol.meaning()));
        }
    }
    for name in ["B", "N", "Δl", "d_g", "F_g", "d_n", "F_n", "λ"] {
        let definition = Definition::named(name).and_then(|known| Some((known, known.formula().ok()?)));
        if let Some((definition, formula)) = definition {
            lines += &format!("* $`{} = {}`$\n", definition.tex(), formula.tex());
        }
    }
    lines + include_str!("../../../text/notation.md")
}

fn errata_page(judgements: &[Judgement]) -> String {
    let mut page = include_str!("../../../text/errata.md").to_owned();
    for (judgement, erratum, evidence) in errata(judgements) {
        let heading = heading(judgement);
        page += &format!("\n## {heading}\n\n{}\n", words(erratum.text));
        for step in evidence {
            page += &format!("\n{}\n", self::step(step));
        }
        page += &format!("\nDerivation: [{}](derivations.md#{})\n", judgement.entry.id, anchor(&heading));
    }
    page.trim_end().to_owned()
}

fn entry(judgement: &Judgement, level: &str) -> String {
    let entry = judgement.entry;
    let mut section = format!(
        "{level} {}\n\nVerdict: **{}**{}.",
        heading(judgement),
        judgement.verdict(),
        judgement.basis_in_words()
    );
    if !entry.assumptions.is_empty() {
        section += &format!(" Assumes: {}.", joined(entry.assumptions, words));
    }
    section += &format!(" Where {}.", hypotheses(judgement));
    let theorems = entry.theorems().map(|theorem| {
        let (name, file) = (theorem.name, theorem.file);
        format!("* [`{name}`](proofs/{file}): {}", escaped(theorem.says))
    });
    let theorems: Vec<_> = theorems.collect();
    if !theorems.is_empty() {
        section += &format!("\n\nTheorems, checked by Coq:\n\n{}", theorems.join("\n"));
    }
    for (i, step) in judgement.steps.iter().enumerate() {
        let marker = format!("{}. ", i + 1);
        section += &format!("\n\n{marker}{}", indented(&self::step(step), marker.len()));
    }
    if let Some(erratum) = entry.erratum {
        section += &format!("\n\n**Erratum.** {}", words(erratum.text));
    }
    let mutants = judgement.mutants();
    for (verdict, name) in [(MutantVerdict::Meaningless, "Meaningless"), (MutantVerdict::Undecided, "Undecided")] {
        let named: Vec<_> = mutants.with(verdict).map(|mutant| format!("$`{}`$", mutant.tex())).collect();
        if !named.is_empty() {
            section += &format!("\n\n{name} mutants: {}.", named.join("; "));
        }
    }
    if !entry.references.is_empty() {
        section += &format!("\n\nReferences: {}.", joined(entry.references, escaped));
    }
    section
}

/// The text with all lines but the first moved to the right: it belongs to an item of a list.
fn indented(text: &str, width: usize) -> String {
    let indent = " ".repeat(width);
    let mut lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!("{indent}{line}") });
    let first = lines.next().unwrap_or_default();
    let rest: Vec<_> = std::iter::once(first.trim_start().to_owned()).chain(lines).collect();
    rest.join("\n")
}

/// Prose, statement, witness and verdict of a step.
fn step(step: &StepJudgement) -> String {
    let mut text = words(step.step.why);
    if let Ok(Some(statement)) = step.step.statement() {
        text += &format!("\n\n```math\n{}\n```\n", statement.tex());
    }
    text += &format!("\n**{}**{}", escaped(&step_verdict(step)), escaped(&place(step)));
    let witness = witness(step).map(|witness| witness.describe(&|_, tex| format!("$`{tex}`$")));
    match witness.filter(|witness| witness.chars().count() <= LONGEST) {
        Some(witness) => text + &format!(": {witness}."),
        None => text + ".",
    }
}

fn words(text: &str) -> String {
    prose::render(text, escaped, |_, tex| format!("$`{tex}`$"))
}

/// Stars, underscores and signs of less than are no markup here.
fn escaped(text: &str) -> String {
    text.replace('*', "\\*").replace('_', "\\_").replace('<', "&lt;")
}

/// The anchor that GitHub gives a heading.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}
