//! The derivations: every equation of the paper and what follows from them, step by step.
//!
//! An [`Entry`] has a stable id, assumptions, steps and references. A [`Step`] makes a [`Claim`] about a statement. What
//! can be decided by normal forms is decided here ([`Step::check`]); what needs an integral or a number is left to
//! rigorous intervals, for which the statement offers its evaluation.

mod energy;
mod equilibrium;
mod force;
mod kappa;
mod limits;
mod machine;
mod machine_folds;
mod power_law;
mod springs;
mod theorem;
mod thresholds;
mod transform;
mod universal;
mod verdict;

pub use theorem::{Theorem, theorems};
pub use verdict::Verdict;

use crate::domain::Domain;
use crate::error::Result;
use crate::statement::{Decision, Statement};

/// What a step claims. What is shown of it is its [`Verdict`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Claim {
    /// It holds, by normal forms.
    Proved,
    /// It holds within rigorous intervals at many random points; nothing exact is claimed.
    Enclosed,
    /// It does not hold, by normal forms and by a counter-example.
    Refuted,
    /// It is taken from the literature.
    Cited,
}

/// One step of a derivation.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// What is claimed.
    pub claim: Claim,
    /// Where; the statement is decided on each.
    pub domains: &'static [Domain],
    /// The statement; none for a step that only cites.
    pub statement: Option<&'static str>,
    /// Values for n and symbols where the statement is about one point: names and rationals.
    pub point: &'static [(&'static str, &'static str)],
    /// Why, and what it means. Formulas stand between backquotes.
    pub why: &'static str,
}

/// An equation of the paper, or a result beside it.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The number of the equation, or a name.
    pub id: &'static str,
    /// What it is about.
    pub title: &'static str,
    /// Whether the equation does not hold as it is printed; its steps show that, and prove the correction.
    pub refuted: bool,
    /// Beyond what holds for the theory as a whole.
    pub assumptions: &'static [&'static str],
    /// The derivation.
    pub steps: &'static [Step],
    /// What is to be corrected in the paper.
    pub erratum: Option<Erratum>,
    /// Literature.
    pub references: &'static [&'static str],
}

/// A correction of the paper.
#[derive(Clone, Copy, Debug)]
pub struct Erratum {
    /// What is to be corrected. Formulas stand between backquotes.
    pub text: &'static str,
    /// The steps that show it, counted from 0.
    pub shown_by: &'static [usize],
}

const POSITIVE: &[Domain] = &[Domain::Positive];
const BOTH: &[Domain] = &[Domain::Above, Domain::Below];
const ABOVE: &[Domain] = &[Domain::Above];
const BELOW: &[Domain] = &[Domain::Below];
const HALF: &[Domain] = &[Domain::Half];

impl Step {
    const fn new(claim: Claim, domains: &'static [Domain], statement: &'static str, why: &'static str) -> Self {
        Step { claim, domains, statement: Some(statement), point: &[], why }
    }

    const fn proved(domains: &'static [Domain], statement: &'static str, why: &'static str) -> Self {
        Self::new(Claim::Proved, domains, statement, why)
    }

    const fn enclosed(domains: &'static [Domain], statement: &'static str, why: &'static str) -> Self {
        Self::new(Claim::Enclosed, domains, statement, why)
    }

    const fn refuted(domains: &'static [Domain], statement: &'static str, why: &'static str) -> Self {
        Self::new(Claim::Refuted, domains, statement, why)
    }

    const fn cited(why: &'static str) -> Self {
        Step { claim: Claim::Cited, domains: &[], statement: None, point: &[], why }
    }

    const fn at(
        point: &'static [(&'static str, &'static str)],
        domains: &'static [Domain],
        statement: &'static str,
        why: &'static str,
    ) -> Self {
        Step { claim: Claim::Enclosed, domains, statement: Some(statement), point, why }
    }

    /// The statement, parsed; none for a step that only cites.
    ///
    /// # Errors
    /// Never for the steps of this crate, all of which are parsed in its tests.
    pub fn statement(&self) -> Result<Option<Statement>> {
        self.statement.map(str::parse).transpose()
    }

    /// What normal forms say, on each domain. Empty for a step that is enclosed or cited.
    ///
    /// # Errors
    /// As [`Step::statement`].
    pub fn check(&self) -> Result<Vec<(Domain, Decision)>> {
        match (self.claim, self.statement()?) {
            (Claim::Proved | Claim::Refuted, Some(statement)) => {
                Ok(self.domains.iter().map(|domain| (*domain, statement.decide(*domain))).collect())
            }
            _ => Ok(Vec::new()),
        }
    }

    /// Where normal forms do not say what the step claims, and what they say instead. Empty for a step that is enclosed or
    /// cited.
    ///
    /// # Errors
    /// As [`Step::statement`].
    pub fn contradictions(&self) -> Result<Vec<(Domain, Decision)>> {
        let as_claimed = |decision: &Decision| match self.claim {
            Claim::Refuted => matches!(decision, Decision::Refuted { .. }),
            _ => matches!(decision, Decision::Proved { .. }),
        };
        Ok(self.check()?.into_iter().filter(|(_, decision)| !as_claimed(decision)).collect())
    }

    /// Whether normal forms say what the step claims, on each of its domains. True for a step that is enclosed or cited.
    ///
    /// # Errors
    /// As [`Step::statement`].
    pub fn holds(&self) -> Result<bool> {
        Ok(self.contradictions()?.is_empty())
    }

    /// The mutants of a statement that is proved or enclosed ([`Statement::mutants`]), none of which may hold. What is refuted
    /// or cited has none.
    ///
    /// # Errors
    /// As [`Step::statement`].
    pub fn mutants(&self) -> Result<Vec<Statement>> {
        let holds = matches!(self.claim, Claim::Proved | Claim::Enclosed);
        Ok(self.statement()?.filter(|_| holds).map(|statement| statement.mutants()).unwrap_or_default())
    }
}

/// All entries, in the order of the paper; what goes beyond it follows the equation it belongs to.
pub fn entries() -> &'static [Entry] {
    static ENTRIES: &[Entry] = &[
        transform::TRANSFORM,
        springs::SPRINGS,
        springs::MODULUS,
        springs::HESS,
        equilibrium::INDENTATION,
        equilibrium::FORCE,
        equilibrium::BALANCE,
        equilibrium::SHRINKS,
        equilibrium::GROWS,
        equilibrium::TANGENCY,
        equilibrium::REGIMES,
        transform::POWER,
        kappa::RECURRENCES,
        kappa::GROWTH,
        kappa::SERIES,
        kappa::ELLIPTIC,
        power_law::INDENTATION,
        power_law::TANGENCY,
        power_law::RADIUS,
        power_law::FORCE,
        power_law::PULL_OFF,
        power_law::CRITICAL,
        thresholds::HALF,
        thresholds::THRESHOLD,
        thresholds::UNDER_FORCE,
        force::CRITICAL,
        machine::CRITICAL,
        machine_folds::FOLDS,
        machine_folds::HALF,
        universal::CURVES,
        energy::PULL_OFF,
        energy::JUMP_IN,
        limits::KENDALL,
        limits::WAVY,
    ];
    ENTRIES
}

/// The entry of this id.
pub fn entry(id: &str) -> Option<&'static Entry> {
    entries().iter().find(|entry| entry.id == id)
}
