//! The page of an equation: as printed, corrected, why, the proof, numbers, code.

use maud::{Markup, PreEscaped, html};
use mdr_crosscheck::derivations::{Judgement, MutantVerdict, StepJudgement};
use mdr_symbolic::derivations::{Entry, Theorem, Verdict};
use mdr_symbolic::{Decision, Domain, Formula, Statement};

use crate::book::Book;
use crate::conformance::Row;
use crate::error::{Error, Result};
use crate::links::{heading, is_equation};
use crate::markdown::{Math, escaped};
use crate::spine;
use crate::text::Text;
use crate::values;

/// The longest witness that is shown, in characters of TeX.
const LONGEST: usize = 400;

/// Names that depend on n.
const WITH_N: [&str; 18] = [
    "n", "κ", "κ_Γ", "kappa", "N", "C", "d_n", "F_n", "U_n", "a_c", "d_c", "F_c", "a_F", "d_F", "F_F", "a_0", "a_z",
    "C_ρ",
];

/// A small link to a part of a page.
pub(crate) fn permalink(id: &str, what: &str) -> Markup {
    html! { a.perma href={ "#" (id) } aria-label={ "Link to " (what) } { "¶" } }
}

/// A verdict, by word, sign and border.
pub(crate) fn badge(verdict: &str) -> Markup {
    html! { span.badge.(verdict) { (verdict) } }
}

/// How an entry stands, as corrected if the printed form is refuted: by its weakest step, and as a theorem where Coq's kernel has
/// checked one and no step is weaker than a proof.
pub(crate) fn standing(entry: &Entry) -> Verdict {
    let weakest = entry.weakest();
    let is_proved = weakest <= Verdict::Enclosed || weakest == Verdict::Definition;
    if is_proved && entry.theorems().next().is_some() { Verdict::Theorem } else { weakest }
}

/// The badges of an entry: one with a correction is refuted as printed, and proved as corrected.
pub(crate) fn badges(judgement: &Judgement) -> Markup {
    let entry = judgement.entry;
    let standing = standing(entry);
    let word = standing.word();
    html! {
        @if entry.refuted { span.badge.refuted { "refuted as printed" } span.badge.(word) { (word) " as corrected" } }
        @else { (badge(word)) }
        @if standing != Verdict::Theorem && entry.theorems().next().is_some() { span.badge.theorem { "theorem in part" } }
        @if entry.erratum.is_some() && !entry.refuted { span.badge.note { "erratum" } }
    }
}

impl Book<'_> {
    /// The text of a step or an assumption, whose formulas stand between backquotes.
    pub(crate) fn prose(&self, text: &str) -> Result<String> {
        let mut out = String::new();
        for (i, part) in text.split('`').enumerate() {
            let tex = (i % 2 == 1).then(|| {
                let statement = part.parse::<Statement>().map(|statement| statement.tex());
                statement.or_else(|_| part.parse::<Formula>().map(|formula| formula.tex())).ok()
            });
            out += &match tex.flatten() {
                Some(tex) => self.tex.inline(&tex)?,
                None => self.typed(part)?,
            };
        }
        Ok(out)
    }

    /// Words in which `$…$` is TeX.
    fn typed(&self, text: &str) -> Result<String> {
        let parts = text.split('$').enumerate();
        parts.map(|(i, part)| if i % 2 == 1 { self.tex.inline(part) } else { Ok(escaped(part)) }).collect()
    }

    /// The page of an entry, and its words for the search.
    pub(crate) fn entry(&mut self, judgement: &Judgement) -> Result<Markup> {
        let entry = judgement.entry;
        if !judgement.holds() {
            return Err(Error::page(entry.id, "a step is not what it claims to be; `mdr derive` tells which"));
        }
        let text = Text::read(self.root, entry.id)?;
        let name = format!("book/text/{}.md", entry.id);
        let why = self.markdown(&name, &text.why, Math::Dollars)?;
        let assumptions = entry.assumptions.iter().map(|text| self.prose(text)).collect::<Result<Vec<_>>>()?.join("; ");
        let erratum = entry.erratum.map(|erratum| self.prose(erratum.text)).transpose()?;
        let steps = self.steps(judgement, false)?;
        let against = self.steps(judgement, true)?;
        let rows = self.conformance.iter().filter(|row| row.is_about(entry)).cloned().collect::<Vec<_>>();
        let code = self.code(&rows)?;
        let numbers = values::of_entry(entry, &text.numbers)?;
        let references = entry.references.iter().map(|text| self.reference(text)).collect::<Result<Vec<_>>>()?;
        let figures = self.figures.of(entry.id);
        let live = spine::of_entry(entry.id)?;
        let theorems: Vec<_> = entry.theorems().collect();
        let proofs = self.theorems(&theorems)?;
        Ok(html! {
            header.eqhead {
                h1 { @if is_equation(entry) { span.no { "(" (entry.id) ")" } } (entry.title) }
                p.badges { (badges(judgement)) @if !assumptions.is_empty() { span.assumes { "Assumes " (PreEscaped(&assumptions)) } } }
            }
            (self.formulas(&text)?)
            @if let Some(erratum) = erratum {
                aside.erratum { p { b { "Erratum. " } (PreEscaped(erratum)) " " a href="errata.html" { "All errata" } } }
            }
            section #why { h2 { "Why" (permalink("why", "the argument")) } (PreEscaped(why.html)) }
            @if let Some(figure) = live { (figure) }
            @for figure in figures { (figure) }
            section #proof {
                h2 { "The proof, step by step" (permalink("proof", "the proof")) }
                p.hint { "The sentence is the argument, the formula is what a program has checked. " a href="verdicts.html" { "What the marks promise." } }
                (steps)
            }
            @if !against.0.is_empty() {
                section #refutation { h2 { "Why the printed form fails" (permalink("refutation", "the refutation")) } (against) }
            }
            @if !theorems.is_empty() {
                section #coq { h2 { "Checked by Coq’s kernel" (permalink("coq", "the theorems")) } (proofs) }
            }
            section #numbers { h2 { "Numbers" (permalink("numbers", "the numbers")) } (numbers) }
            section #code { h2 { "In the code" (permalink("code", "the code")) } (code)
                p.ask { "The derivation on a terminal: " code { "mdr derive " (entry.id) } } }
            @if !references.is_empty() {
                section #references { h2 { "References" (permalink("references", "the references")) } ul { @for text in references { li { (PreEscaped(text)) } } } }
            }
        })
    }

    /// The equation in its boxes.
    fn formulas(&self, text: &Text) -> Result<Markup> {
        let display = |tex: &String| self.tex.display(tex).map(PreEscaped);
        let printed = text.printed.as_ref().map(display).transpose()?;
        let corrected = text.corrected.as_ref().map(display).transpose()?;
        let result = text.result.as_ref().map(display).transpose()?;
        let both = corrected.is_some();
        Ok(html! {
            @if let Some(math) = printed {
                figure.equation.printed[both] #printed { figcaption { @if both { "As printed" } @else { "The equation" } (permalink("printed", "the equation")) } (math) }
            }
            @if let Some(math) = corrected {
                figure.equation.right #corrected { figcaption { "Corrected" (permalink("corrected", "the corrected equation")) } (math) }
            }
            @if let Some(math) = result {
                figure.equation #result { figcaption { "The result" (permalink("result", "the result")) } (math) }
            }
        })
    }

    /// The steps of the proof, or those that show why the printed form fails. Each keeps its number.
    fn steps(&self, judgement: &Judgement, against: bool) -> Result<Markup> {
        let steps = judgement.steps.iter().enumerate().filter(|(_, step)| is_against(judgement, step) == against);
        let items = steps.map(|(i, step)| self.step(i + 1, step)).collect::<Result<Vec<_>>>()?;
        Ok(html! { @if !items.is_empty() { ol.steps { @for item in items { (item) } } } })
    }

    fn step(&self, number: usize, step: &StepJudgement) -> Result<Markup> {
        let verdict = step.step.verdict().word();
        let statement = step.step.statement().ok().flatten();
        let formula = statement.map(|statement| self.tex.display(&statement.tex())).transpose()?;
        let text = self.prose(step.step.why)?;
        let witness = self.witness(step)?;
        let mutants = step.mutants.len();
        let meaningless = step.mutants.count(MutantVerdict::Meaningless);
        let id = format!("step-{number}");
        Ok(html! {
            li #(id) class=(verdict) data-step=(number) data-verdict=(verdict) value=(number) {
                p { (PreEscaped(text)) (permalink(&id, &format!("step {number}"))) }
                @if let Some(formula) = formula { (PreEscaped(formula)) }
                @if verdict == "cited" { p.cite { (badge(verdict)) " from the literature" } } @else {
                    details {
                        summary { (badge(verdict)) " " (place(step)) }
                        @if let Some(witness) = witness { p.how { (PreEscaped(witness)) "." } }
                        @if mutants > 0 {
                            p.how { "With one sign, exponent or factor changed it is no longer true: " (mutants) " of " (mutants) " such mutants do not hold"
                                @if meaningless > 0 { ", " (meaningless) " of them because they have no value" } "." }
                        }
                    }
                }
            }
        })
    }

    /// The result of normal forms, in words and formulas.
    fn witness(&self, step: &StepJudgement) -> Result<Option<String>> {
        let Some((_, decision)) = step.step.check().ok().and_then(|found| found.into_iter().next()) else {
            return Ok(None);
        };
        let (Decision::Proved { because } | Decision::Refuted { because }) = decision else { return Ok(None) };
        let text = because.describe(&|_, tex| format!("${tex}$"));
        if text.chars().count() > LONGEST { Ok(None) } else { self.typed(&text).map(Some) }
    }

    fn theorems(&mut self, theorems: &[Theorem]) -> Result<Markup> {
        let mut items = Vec::new();
        for theorem in theorems {
            let target = self.source(&format!("docs/proofs/{}", theorem.file))?;
            items.push((format!("{target}#{}", theorem.name), theorem.name, self.typed(theorem.says)?));
        }
        Ok(
            html! { ul.theorems { @for (target, name, says) in items { li { a href=(target) { code { (name) } } " " (PreEscaped(says)) } } } },
        )
    }

    fn code(&mut self, rows: &[Row]) -> Result<Markup> {
        let mut parts = Vec::new();
        for row in rows {
            let mut cell = |text: &str| self.line("docs/conformance.md", text);
            parts.push((cell(&row.what)?, cell(&row.function)?, cell(&row.checks)?, cell(&row.tests)?));
        }
        Ok(html! {
            @if parts.is_empty() { p { "A step on the way: no function computes it alone." } }
            @for (what, function, checks, tests) in parts {
                dl.code {
                    dt { "what" } dd { (PreEscaped(what)) } dt { "function" } dd { (PreEscaped(function)) }
                    @if !checks.is_empty() { dt { "checks of " code { "mdr verify" } } dd { (PreEscaped(checks)) } }
                    @if !tests.is_empty() { dt { "tests" } dd { (PreEscaped(tests)) } }
                }
            }
            p { a href="conformance.html" { "All equations, functions, checks and tests" } }
        })
    }
}

/// Whether a step is about the form that is printed and wrong: it is refuted, or a counter-example at a point.
fn is_against(judgement: &Judgement, step: &StepJudgement) -> bool {
    step.step.verdict() == Verdict::Refuted || (judgement.entry.refuted && !step.step.point.is_empty())
}

/// Where a step holds: its domains if n occurs, the values at a point, or how many points there are.
fn place(step: &StepJudgement) -> String {
    if !step.step.point.is_empty() {
        let values: Vec<_> =
            step.step.point.iter().map(|(name, value)| format!("{} = {value}", modulus(name))).collect();
        return format!("at {}", values.join(", "));
    }
    let domains: Vec<_> = step.step.domains.iter().copied().map(Domain::text).collect();
    let statement = step.step.statement.unwrap_or_default();
    let mut names = statement.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    let everywhere = !names.any(|name| WITH_N.contains(&name));
    match step.step.verdict() {
        Verdict::Enclosed | Verdict::Agrees => "in rigorous intervals".to_owned(),
        Verdict::Sampled => {
            let place = if everywhere { String::new() } else { format!("for {}, ", domains.join(" and ")) };
            format!("{place}certain at {} of {} random points: no proof", step.certain, step.points)
        }
        Verdict::Theorem if everywhere => "by Coq".to_owned(),
        Verdict::Theorem => format!("by Coq, for {}", domains.join(" and ")),
        Verdict::Refuted => format!("for {}, by exact algebra and at a point", domains.join(" and ")),
        _ if everywhere => "by exact algebra".to_owned(),
        _ => format!("by exact algebra, for {}", domains.join(" and ")),
    }
}

/// The modulus has its star.
fn modulus(name: &str) -> &str {
    if name == "E" { "E*" } else { name }
}

/// The title of a page.
pub(crate) fn title(judgement: &Judgement) -> String {
    heading(judgement.entry)
}
