//! Derivations as a LaTeX document.

use super::{Document, Judgement, StepJudgement, errata, heading, joined, place, prose, step_verdict, summary};

const BEGIN: &str = r"\documentclass{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{amsmath}
\newcommand{\lt}{<}
\newcommand{\gt}{>}
\begin{document}
\sloppy
";
const END: &str = r"\end{document}";

impl Document<'_> {
    /// A whole document.
    pub fn latex(self) -> String {
        let body = match self {
            Document::All(judgements) => {
                let entries: Vec<_> = judgements.iter().map(entry).collect();
                format!("{}\n\n{}", entries.join("\n\n"), escaped(&summary(judgements)))
            }
            Document::One(judgement) => entry(judgement),
            Document::Errata(judgements) => {
                let items = errata(judgements).map(|(judgement, erratum, evidence)| {
                    let steps: Vec<_> = evidence.into_iter().map(step).collect();
                    format!("{}\n{}\n\n{}", section(judgement), words(erratum.text), steps.join("\n\n"))
                });
                items.collect::<Vec<_>>().join("\n\n")
            }
        };
        format!("{BEGIN}\n{body}\n\n{END}")
    }
}

fn section(judgement: &Judgement) -> String {
    format!(r"\section*{{{}}}", escaped(&heading(judgement)))
}

fn entry(judgement: &Judgement) -> String {
    let entry = judgement.entry;
    let mut parts = vec![section(judgement)];
    let (verdict, assumptions) = (judgement.verdict(), joined(entry.assumptions, words));
    let basis = words(&judgement.basis_in_words());
    parts.push(format!(r"Verdict: \textbf{{{verdict}}}{basis}. Assumes: {assumptions}."));
    let theorems = entry.theorems().map(|theorem| {
        format!(r"\texttt{{{}}} ({}): {}", escaped(theorem.name), escaped(theorem.file), words(theorem.says))
    });
    let theorems: Vec<_> = theorems.collect();
    if !theorems.is_empty() {
        parts.push(format!("Theorems, checked by Coq: {}.", theorems.join("; ")));
    }
    parts.push(r"\begin{enumerate}".to_owned());
    parts.extend(judgement.steps.iter().map(|one| format!("\\item {}", step(one))));
    parts.push(r"\end{enumerate}".to_owned());
    parts.extend(entry.erratum.map(|erratum| format!(r"\textbf{{Erratum.}} {}", words(erratum.text))));
    if !entry.references.is_empty() {
        parts.push(format!("\nReferences: {}.", joined(entry.references, escaped)));
    }
    parts.join("\n")
}

fn step(step: &StepJudgement) -> String {
    let mut text = words(step.step.why);
    if let Ok(Some(statement)) = step.step.statement() {
        text += &format!("\n\\[ {} \\]\n", statement.tex());
    }
    text + &format!(r" \textbf{{{}}}{}.", escaped(&step_verdict(step)), escaped(&place(step)))
}

fn words(text: &str) -> String {
    prose::render(text, escaped, |_, tex| format!("${tex}$"))
}

/// With TeX for the characters that it reads in another way or does not have.
fn escaped(text: &str) -> String {
    let of = |c: char| prose::signs().find(|sign| sign.character.starts_with(c)).map(|sign| sign.tex);
    text.chars().map(|c| of(c).map_or_else(|| c.to_string(), str::to_owned)).collect()
}
