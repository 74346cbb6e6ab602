//! `mdr derive`: the derivations, each step with its verdict.

use clap::{Args, ValueEnum};
use mdr_crosscheck::derivations::{Document, Judgement, judge, judge_all, summary};
use mdr_symbolic::derivations::{Entry, entries, entry, statements_in_coq};

use crate::error::{Failure, Result};
use crate::flags::nearest;
use crate::output::Output;
use crate::table::{CellStyle, cell, render, table};

/// The derivation of every equation, each step with its verdict: theorem, proved, sampled, refuted, cited.
///
/// Without an id: all of them. Every statement is parsed, proved, evaluated, mutated and printed from one and the same
/// formula.
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/derive.txt"))]
pub(crate) struct Derive {
    /// Number of an equation, name of a result, or a word to search for
    #[arg(value_name = "ID", allow_hyphen_values = true, conflicts_with = "errata")]
    id: Option<String>,

    /// Corrections to the paper
    #[arg(long)]
    errata: bool,

    /// Shape of the derivations
    #[arg(long, value_enum, default_value_t = Shape::Text)]
    format: Shape,
}

/// How derivations are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Shape {
    /// For a terminal
    Text,
    /// For a page, with formulas in TeX
    Markdown,
    /// A whole document
    Latex,
    /// The statements of the steps, which docs/proofs proves; nothing is checked
    Coq,
}

impl Derive {
    /// Writes the derivations on `out`; returns whether the claim of every step holds.
    pub(crate) fn run(&self, out: &mut Output<impl std::io::Write>) -> Result<bool> {
        if self.format == Shape::Coq {
            out.text(statements_in_coq(self.entries()?).trim_end())?;
            return Ok(true);
        }
        let judgements = match &self.id {
            None if !self.errata => judge_all(),
            _ => self.entries()?.into_iter().map(judge).collect(),
        };
        let document = match &judgements[..] {
            [one] if self.id.is_some() => Document::One(one),
            all if self.errata => Document::Errata(all),
            all => Document::All(all),
        };
        out.text(match (self.format, document) {
            (Shape::Text, Document::All(judgements)) => overview(judgements),
            (Shape::Text, document) => document.text(),
            (Shape::Markdown, document) => document.markdown(),
            (Shape::Latex, document) => document.latex(),
            (Shape::Coq, _) => String::new(),
        })?;
        Ok(judgements.iter().all(Judgement::holds))
    }

    /// The wanted entries.
    fn entries(&self) -> Result<Vec<&'static Entry>> {
        let asked = |entry: &&Entry| !self.errata || entry.erratum.is_some();
        match &self.id {
            Some(id) => find(id),
            None => Ok(entries().iter().filter(asked).collect()),
        }
    }
}

/// All entries, a line each.
fn overview(judgements: &[Judgement]) -> String {
    let mut table = table(&["id", "what", "steps", "mutants", "verdict"]);
    for judgement in judgements {
        let tone = if judgement.holds() { CellStyle::Good } else { CellStyle::Bad };
        table.add_row([
            cell(judgement.entry.id, CellStyle::Strong),
            cell(judgement.entry.title, CellStyle::Plain),
            cell(judgement.tally(), CellStyle::Faint),
            cell(judgement.mutants().len(), CellStyle::Faint),
            cell(judgement.verdict_and_basis(), tone),
        ]);
    }
    format!("{}\n\n{}", render(&table), summary(judgements))
}

/// The entry of an id, which may stand in brackets as in the paper; else all entries that speak of it.
fn find(id: &str) -> Result<Vec<&'static Entry>> {
    let bare = id.trim_start_matches('(').trim_end_matches(')');
    let found = entry(bare).map_or_else(|| search(bare), |entry| vec![entry]);
    if found.is_empty() {
        let nearest = nearest(bare, entries().iter().map(|entry| entry.id)).map_or("1.1", |(id, _)| id);
        let reason = format_args!("no such derivation; the nearest is {nearest}, `mdr derive` lists all");
        return Err(Failure::flag("ID", reason, id));
    }
    Ok(found)
}

/// The entries that have a text of three letters at least between the ends of words, in capitals or not.
fn search(text: &str) -> Vec<&'static Entry> {
    let wanted = text.trim().to_lowercase();
    // What everybody calls a theory by, and no step does.
    let wanted = match wanted.as_str() {
        "jkr" => "johnson, kendall".to_owned(),
        "dmt" => "derjaguin".to_owned(),
        _ => wanted,
    };
    if wanted.chars().filter(|c| c.is_alphabetic()).count() < 3 {
        return Vec::new();
    }
    let ends = |c: Option<char>| !c.is_some_and(char::is_alphanumeric);
    let holds = |text: &str| {
        let text = text.to_lowercase();
        let mut places = text.match_indices(&wanted);
        places.any(|(at, found)| ends(text[..at].chars().next_back()) && ends(text[at + found.len()..].chars().next()))
    };
    let speaks = |entry: &&Entry| {
        let steps = entry.steps.iter().map(|step| step.why);
        let others = entry.assumptions.iter().chain(entry.references).copied();
        [entry.id, entry.title].into_iter().chain(others).chain(steps).any(holds)
    };
    entries().iter().filter(speaks).collect()
}
