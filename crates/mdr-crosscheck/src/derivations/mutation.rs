//! The mutants of a step, and the verdict on each.

use std::iter::Sum;

use mdr_core::named;
use mdr_symbolic::derivations::Step;
use mdr_symbolic::{Decision, Domain, Error, Statement};

use super::{POINTS, Truth, points, truth};

named! {
    /// The verdict on a mutant, over all domains of its step the least favourable; the best first.
    #[derive(PartialOrd, Ord)]
    pub enum MutantVerdict {
        /// Its normal forms differ, or their difference has the other sign.
        NormalForm = "refuted by normal forms",
        /// Rigorous intervals contradict it at a random point.
        Enclosure = "refuted by enclosures",
        /// A side has certainly no value at any random point: a division by 0, a root of a negative number, an integral that
        /// diverges.
        Meaningless = "meaningless",
        /// Neither normal forms nor intervals decide: a side has no finite enclosure, or the two sides overlap without agreeing.
        Undecided = "undecided",
        /// It holds, by normal forms or as far as intervals can show: the statement says less than it seems to.
        Survives = "NOT refuted",
    }
}

/// The distinct mutants of a step, or of several, and the verdict on each.
#[derive(Clone, Debug, Default)]
pub struct Mutants(Vec<(Statement, MutantVerdict)>);

impl Mutants {
    pub(super) fn of(step: &Step, statement: &Statement) -> Result<Self, Error> {
        let verdict = |mutant: &Statement| {
            let verdicts = step.domains.iter().map(|domain| verdict(step, statement, mutant, *domain));
            verdicts.max().unwrap_or(MutantVerdict::Undecided)
        };
        let mutants = step.mutants()?.into_iter();
        Ok(Mutants(
            mutants.map(|mutant| (verdict(&mutant), mutant)).map(|(verdict, mutant)| (mutant, verdict)).collect(),
        ))
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many had this verdict.
    pub fn count(&self, verdict: MutantVerdict) -> usize {
        self.with(verdict).count()
    }

    /// The mutants with this verdict.
    pub fn with(&self, verdict: MutantVerdict) -> impl Iterator<Item = &Statement> {
        self.0.iter().filter(move |(_, other)| *other == verdict).map(|(mutant, _)| mutant)
    }
}

impl Sum for Mutants {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        Mutants(parts.flat_map(|part| part.0).collect())
    }
}

/// Normal forms first, intervals at the points of the statement where they do not decide.
fn verdict(step: &Step, statement: &Statement, mutant: &Statement, domain: Domain) -> MutantVerdict {
    match mutant.decide(domain) {
        Decision::Proved { .. } => MutantVerdict::Survives,
        Decision::Refuted { .. } => MutantVerdict::NormalForm,
        Decision::Undecided(_) if mutant.divides_by_zero(domain) => MutantVerdict::Meaningless,
        Decision::Undecided(_) => by_intervals(step, statement, mutant, domain),
    }
}

fn by_intervals(step: &Step, statement: &Statement, mutant: &Statement, domain: Domain) -> MutantVerdict {
    let count = if !step.point.is_empty() || mutant.is_number() { 1 } else { POINTS };
    let mut verdict = MutantVerdict::Meaningless;
    for point in points(step, statement, domain).take(count as usize) {
        match truth(mutant, domain, &point) {
            Ok(Truth::False) => return MutantVerdict::Enclosure,
            Ok(Truth::Certain) => verdict = MutantVerdict::Survives,
            Ok(Truth::Possible | Truth::Unknown) => verdict = verdict.max(MutantVerdict::Undecided),
            Ok(Truth::Undefined) => {}
            // Exact algebra finds no value, at any point.
            Err(Error::DivisionByZero) => return verdict,
            // Exact algebra has to carry out a part of it, and cannot.
            Err(_) => return verdict.max(MutantVerdict::Undecided),
        }
    }
    verdict
}
