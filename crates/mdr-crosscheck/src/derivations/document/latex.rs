//! Derivations as a LaTeX document.

use super::{Document, Judgement, StepJudgement, errata, heading, place, prose, step_verdict, summary, theorems};

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

pub(super) fn write(extent: Document<'_>) -> String {
    let body = match extent {
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

fn section(judgement: &Judgement) -> String {
    format!(r"\section*{{{}}}", escaped(&heading(judgement)))
}

fn entry(judgement: &Judgement) -> String {
    let entry = judgement.entry;
    let mut parts = vec![section(judgement)];
    let assumptions: Vec<_> = entry.assumptions.iter().map(|text| words(text)).collect();
    let verdict = judgement.verdict();
    parts.push(format!(r"Verdict: \textbf{{{verdict}}}. Assumes: {}.", assumptions.join("; ")));
    let theorems = theorems(judgement, |theorem| {
        format!(r"\texttt{{{}}} ({}): {}", escaped(theorem.name), escaped(theorem.file), words(theorem.says))
    });
    if !theorems.is_empty() {
        parts.push(format!("Theorems, checked by Coq: {}.", theorems.join("; ")));
    }
    parts.push(r"\begin{enumerate}".to_owned());
    parts.extend(judgement.steps.iter().map(|one| format!("\\item {}", step(one))));
    parts.push(r"\end{enumerate}".to_owned());
    parts.extend(entry.erratum.map(|erratum| format!(r"\textbf{{Erratum.}} {}", words(erratum.text))));
    if !entry.references.is_empty() {
        let references: Vec<_> = entry.references.iter().map(|reference| escaped(reference)).collect();
        parts.push(format!("\nReferences: {}.", references.join("; ")));
    }
    parts.join("\n")
}

fn step(step: &StepJudgement) -> String {
    let mut text = words(step.step.why);
    if let Ok(Some(statement)) = step.step.statement() {
        text += &format!("\n\\[ {} \\]\n", statement.tex());
    }
    let place = place(step);
    let blank = if place.is_empty() { "" } else { " " };
    text + &format!(r" \textbf{{{}}}{blank}{}.", escaped(&step_verdict(step)), escaped(&place))
}

fn words(text: &str) -> String {
    prose::render(text, escaped, |math| format!("${}$", math.tex()))
}

/// Characters that TeX reads in another way or does not have.
const CHARACTERS: &[(char, &str)] = &[
    ('_', r"\_"),
    ('^', r"\textasciicircum{}"),
    ('{', r"\{"),
    ('}', r"\}"),
    ('<', "$<$"),
    ('>', "$>$"),
    ('ε', r"$\varepsilon$"),
    ('κ', r"$\kappa$"),
    ('λ', r"$\lambda$"),
    ('Λ', r"$\Lambda$"),
    ('μ', r"$\mu$"),
    ('ν', r"$\nu$"),
    ('ρ', r"$\rho$"),
    ('π', r"$\pi$"),
    ('σ', r"$\sigma$"),
    ('θ', r"$\theta$"),
    ('φ', r"$\varphi$"),
    ('δ', r"$\delta$"),
    ('γ', r"$\gamma$"),
    ('Δ', r"$\Delta$"),
    ('Γ', r"$\Gamma$"),
    ('Π', r"$\Pi$"),
    ('Σ', r"$\Sigma$"),
    ('√', r"$\surd$"),
    ('∫', r"$\int$"),
    ('∞', r"$\infty$"),
    ('≤', r"$\le$"),
    ('≥', r"$\ge$"),
    ('≈', r"$\approx$"),
    ('≠', r"$\ne$"),
    ('−', "$-$"),
    ('·', r"$\cdot$"),
    ('…', r"\dots{}"),
    ('“', "``"),
    ('”', "''"),
    ('–', "--"),
    ('ⁿ', "$^n$"),
    ('²', "$^2$"),
    ('³', "$^3$"),
    ('⁴', "$^4$"),
    ('⁻', "$^-$"),
    ('ᵏ', "$^k$"),
    ('₀', "$_0$"),
    ('₁', "$_1$"),
    ('₂', "$_2$"),
];

fn escaped(text: &str) -> String {
    let of = |c: char| CHARACTERS.iter().find(|(known, _)| *known == c).map(|(_, tex)| *tex);
    text.chars().map(|c| of(c).map_or_else(|| c.to_string(), str::to_owned)).collect()
}
