//! The derivations: every equation of the paper and its consequences, step by step.
//!
//! They are written in `data/derivations.txt`. An [`Entry`] has a stable id, assumptions, steps and references. A [`Step`]
//! makes a [`Claim`] about a statement. Claims that normal forms decide are checked here ([`Step::check`]); claims that need an integral or a number are
//! checked by rigorous intervals elsewhere, through the evaluation of the statement.

mod coq;
mod read;
mod theorem;
mod verdict;

pub use coq::statements_in_coq;
pub use theorem::{Theorem, TheoremBasis, theorems};
pub use verdict::Verdict;

use std::sync::LazyLock;

use read::read;

use crate::domain::Domain;
use crate::error::Result;
use crate::statement::{Decision, Statement};

/// The claim of a step. Whether and how it is shown is its [`Verdict`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Claim {
    /// True, by normal forms.
    Proved,
    /// True within rigorous intervals at many random points; nothing exact is claimed.
    Enclosed,
    /// False, by normal forms and by a counter-example.
    Refuted,
    /// Taken from the literature.
    Cited,
}

/// One step of a derivation.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// The claim.
    pub claim: Claim,
    /// The domains, on each of which the statement is decided.
    pub domains: &'static [Domain],
    /// The statement; `None` for a step that only cites.
    pub statement: Option<&'static str>,
    /// Values for n and symbols if the statement is about one point: names and rationals.
    pub point: &'static [(&'static str, &'static str)],
    /// The reason and its meaning. Formulas are written between backquotes.
    pub why: &'static str,
}

/// An equation of the paper, or a related result.
#[derive(Clone, Copy, Debug, Default)]
pub struct Entry {
    /// The number of the equation, or a name.
    pub id: &'static str,
    /// The subject.
    pub title: &'static str,
    /// Whether the equation does not hold as it is printed; its steps show that, and prove the correction.
    pub refuted: bool,
    /// Assumptions in addition to those of the theory as a whole.
    pub assumptions: &'static [&'static str],
    /// The derivation.
    pub steps: &'static [Step],
    /// The correction of the paper, if one is needed.
    pub erratum: Option<Erratum>,
    /// Literature.
    pub references: &'static [&'static str],
}

/// A correction of the paper.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Erratum {
    /// The correction. Formulas are written between backquotes.
    pub text: &'static str,
    /// The steps that show it, counted from 0.
    pub shown_by: &'static [usize],
}

impl Step {
    /// The statement, parsed; `None` for a step that only cites.
    ///
    /// # Errors
    /// None for the steps of this crate, all of which are parsed in its tests.
    pub fn statement(&self) -> Result<Option<Statement>> {
        self.statement.map(str::parse).transpose()
    }

    /// The decision by normal forms, on each domain. Empty for a step that is enclosed or cited.
    ///
    /// # Errors
    /// None for the steps of this crate, whose statements all parse.
    pub fn check(&self) -> Result<Vec<(Domain, Decision)>> {
        match (self.claim, self.statement()?) {
            (Claim::Proved | Claim::Refuted, Some(statement)) => {
                Ok(self.domains.iter().map(|domain| (*domain, statement.decide(*domain))).collect())
            }
            _ => Ok(Vec::new()),
        }
    }

    /// The domains on which the decision by normal forms contradicts the claim of the step. Empty for a step that is
    /// enclosed or cited.
    ///
    /// # Errors
    /// None for the steps of this crate, whose statements all parse.
    pub fn contradictions(&self) -> Result<Vec<(Domain, Decision)>> {
        let as_claimed = |decision: &Decision| match self.claim {
            Claim::Refuted => matches!(decision, Decision::Refuted { .. }),
            _ => matches!(decision, Decision::Proved { .. }),
        };
        Ok(self.check()?.into_iter().filter(|(_, decision)| !as_claimed(decision)).collect())
    }

    /// Whether normal forms confirm the claim of the step on each of its domains. True for a step that is enclosed or
    /// cited.
    ///
    /// # Errors
    /// None for the steps of this crate, whose statements all parse.
    pub fn holds(&self) -> Result<bool> {
        Ok(self.contradictions()?.is_empty())
    }

    /// The mutants of a statement that is proved or enclosed ([`Statement::mutants`]), all of which must be false.
    /// Empty for a step that is refuted or cited.
    ///
    /// # Errors
    /// None for the steps of this crate, whose statements all parse.
    pub fn mutants(&self) -> Result<Vec<Statement>> {
        let holds = matches!(self.claim, Claim::Proved | Claim::Enclosed);
        Ok(self.statement()?.filter(|_| holds).map(|statement| statement.mutants()).unwrap_or_default())
    }
}

/// The entries, or the line of the file that cannot be read.
static ENTRIES: LazyLock<std::result::Result<Vec<Entry>, String>> =
    LazyLock::new(|| read(include_str!("../../data/derivations.txt")));

/// All entries, in the order of the paper; further results follow the equation they belong to.
pub fn entries() -> &'static [Entry] {
    ENTRIES.as_deref().unwrap_or_default()
}

/// The entry with this id.
pub fn entry(id: &str) -> Option<&'static Entry> {
    entries().iter().find(|entry| entry.id == id)
}
