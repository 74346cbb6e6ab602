//! Derivations as pages, with mathematics that GitHub renders.

use mdr_symbolic::Symbol;
use mdr_symbolic::formula::Definition;

use super::figures::{self, Figure};
use super::{Document, errata, heading, hypotheses, place, prose, step_verdict, summary, theorems, witness};
use crate::derivations::{AGREEMENT, Fate, Judgement, OCTAVES, POINTS, StepJudgement};

/// The longest witness that is shown, in characters of TeX.
const LONGEST: usize = 260;

pub(super) fn write(extent: Document<'_>) -> String {
    match extent {
        Document::All(judgements) => page(judgements),
        Document::One(judgement) => entry(judgement, "#"),
        Document::Errata(judgements) => errata_page(judgements),
    }
}

fn introduction() -> String {
    let (lowest, highest) = (OCTAVES.start(), OCTAVES.end() + 1);
    format!(
        "\
# Derivations

This page is written by `mdr derive --format markdown`; a test fails when it is out of date. `mdr derive ID` shows one entry \
on the terminal.

The sentence of a step is the argument, its formula is what is checked. Each step carries its verdict:

* **proved**: both sides have the same normal form in an exact algebra of sums of powers whose coefficients and exponents \
are rational functions of $`n`$ (crate `mdr-symbolic`, whose documentation tells what that proves and why); an inequality is \
proved when all coefficients of the difference have one sign on the whole domain;
* **enclosed**: an inequality of two numbers, or at one point, that rigorous intervals prove; **agrees**: an equality there, of \
which the two sides overlap and are known to {AGREEMENT} bits or more: no more than that is known of it;
* **sampled**: rigorous intervals at {POINTS} random rational points contradict the statement at none and confirm it at as \
many as are counted, an equality to {AGREEMENT} bits or more; elsewhere the enclosure is too wide. This is no proof. Every octave of \
$`n`$ from $`2^{{{lowest}}}`$ to $`2^{{{highest}}}`$ has an equal chance (for $`n`$ > 1/2 every octave of $`n - \\frac12`$; for \
$`n`$ &lt; 1/2 every octave of $`n`$ or of $`\\frac12 - n`$), and the symbols lie between 0.1 and 10, an angle below π/2. An \
integral is summed by the midpoint rule with its error; beside an end it is that of the power of the distance with which the \
integrand goes there, times an enclosed factor;
* **refuted**: the normal forms differ, and intervals show it at a point;
* **cited**: taken from the literature;
* **definition**: both sides are the same formula once all names are written out. It shows nothing, and does not count.

Where a step names its statement in Coq ([statements](proofs/Statements.v)), Coq's kernel has checked it too ([proofs](proofs/Steps.v)).

An entry is a **theorem** where Coq's kernel has checked its claim, by the theorems that it names ([proofs](proofs/README.md)); it is \
**refuted** where the equation as printed is; else its verdict is that of its weakest step.

What is proved or enclosed is also mutated. An equality has one sign, exponent or factor changed at a time, an inequality its \
sense; a dimension gets one length too many. No mutant may hold. Each is refuted by normal forms or by an enclosure at one of \
the points, or it is meaningless: it divides by 0, takes a root of a negative number or has a divergent integral, by exact algebra \
on the whole domain or at all of the points. An integral diverges where the integrand goes to infinity like the power −1 of the \
distance from an end or faster, with one sign. What is meaningless, and what neither can decide, is named at the end of its entry.

## Notation

"
    )
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
            judgement.verdict()
        );
    }
    page += &format!("\n{}\n", summary(judgements));
    for judgement in judgements {
        page += "\n";
        page += &entry(judgement, "##");
        page += "\n";
        for Figure { name, file, caption, .. } in figures::of(judgement.entry.id) {
            page += &format!("\n![{name}](figures/{file})\n\n{name}, [computed](figures.md): {caption}\n");
        }
    }
    page.trim_end().to_owned()
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
    lines
        + "\nThe force is $`F`$, positive when compressive; $`d`$ is positive when pressed in. $`d(a)`$ and $`F(a)`$ belong to the \
           equilibria of any profile, $`d_n(a)`$ and $`F_n(a)`$ to those of a power law, $`d_c`$ and $`F_c`$ to its critical state under \
           controlled indentation, $`d_F`$ and $`F_F`$ under controlled force.\n"
}

fn errata_page(judgements: &[Judgement]) -> String {
    let mut page = "\
# Errata of the paper

V. L. Popov, *Surface profiles with zero and finite adhesion force and adhesion instabilities*. This page is written by `mdr \
derive --errata --format markdown`; a test fails when it is out of date. The full derivations are in \
[derivations.md](derivations.md).
"
    .to_owned();
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
    let mut section = format!("{level} {}\n\nVerdict: **{}**.", heading(judgement), judgement.verdict());
    if !entry.assumptions.is_empty() {
        let assumptions: Vec<_> = entry.assumptions.iter().map(|text| words(text)).collect();
        section += &format!(" Assumes: {}.", assumptions.join("; "));
    }
    section += &format!(" Where {}.", hypotheses(judgement));
    let theorems = theorems(judgement, |theorem| {
        let (name, file) = (theorem.name, theorem.file);
        format!("* [`{name}`](proofs/{file}): {}", escaped(theorem.says))
    });
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
    for (fate, name) in [(Fate::Meaningless, "Meaningless"), (Fate::Undecided, "Undecided")] {
        let named: Vec<_> = mutants.with(fate).map(|mutant| format!("$`{}`$", mutant.tex())).collect();
        if !named.is_empty() {
            section += &format!("\n\n{name} mutants: {}.", named.join("; "));
        }
    }
    if !entry.references.is_empty() {
        let references: Vec<_> = entry.references.iter().map(|reference| escaped(reference)).collect();
        section += &format!("\n\nReferences: {}.", references.join("; "));
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
    let place = place(step);
    let blank = if place.is_empty() { "" } else { " " };
    text += &format!("\n**{}**{blank}{}", escaped(&step_verdict(step)), escaped(&place));
    let witness = witness(step).map(|witness| witness.describe(&|_, tex| format!("$`{tex}`$")));
    match witness.filter(|witness| witness.chars().count() <= LONGEST) {
        Some(witness) => text + &format!(": {witness}."),
        None => text + ".",
    }
}

fn words(text: &str) -> String {
    prose::render(text, escaped, |math| format!("$`{}`$", math.tex()))
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
