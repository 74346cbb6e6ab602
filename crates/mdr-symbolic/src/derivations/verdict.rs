//! The verdict on a step, or on an entry as a whole.

use super::{Claim, Entry, Step};
use crate::statement::{Relation, Statement};

/// The verdict on a step or an entry, from the strongest to the weakest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// A theorem that Coq's kernel has checked.
    Theorem,
    /// Equal normal forms: a proof for all values of the symbols.
    Proved,
    /// An inequality of two numbers, or at one point, in rigorous intervals: a proof.
    Enclosed,
    /// Two numbers, or two sides at one point, whose enclosures overlap: they agree to so many bits, and no more is known.
    Agrees,
    /// No random point contradicts it: no proof.
    Sampled,
    /// It does not hold, by normal forms and by a counter-example.
    Refuted,
    /// It is taken from the literature.
    Cited,
    /// It repeats a definition, and shows nothing.
    Definition,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Verdict; 8] = [
        Verdict::Theorem,
        Verdict::Proved,
        Verdict::Enclosed,
        Verdict::Agrees,
        Verdict::Sampled,
        Verdict::Refuted,
        Verdict::Cited,
        Verdict::Definition,
    ];

    /// The verdict as one word.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Theorem => "theorem",
            Verdict::Proved => "proved",
            Verdict::Enclosed => "enclosed",
            Verdict::Agrees => "agrees",
            Verdict::Sampled => "sampled",
            Verdict::Refuted => "refuted",
            Verdict::Cited => "cited",
            Verdict::Definition => "definition",
        }
    }
}

impl Statement {
    /// Whether it is about numbers, the same at every point.
    pub fn is_number(&self) -> bool {
        self.left.is_number() && self.right.is_number()
    }

    /// Whether both sides are one formula once all names are written out.
    ///
    /// ```
    /// use mdr_symbolic::Statement;
    /// assert!("B = π*w/(2*E)".parse::<Statement>()?.repeats_a_definition());
    /// assert!(!"Δl = 2*sqrt(B*a)".parse::<Statement>()?.repeats_a_definition());
    /// # Ok::<(), mdr_symbolic::Error>(())
    /// ```
    pub fn repeats_a_definition(&self) -> bool {
        self.relation == Relation::Equal && self.left.unfolded() == self.right.unfolded()
    }
}

impl Step {
    /// The verdict on the step, provided that it holds.
    pub fn verdict(&self) -> Verdict {
        let statement = self.statement().ok().flatten();
        let single = !self.point.is_empty() || statement.as_ref().is_some_and(Statement::is_number);
        let repeats = statement.as_ref().is_some_and(Statement::repeats_a_definition);
        let equal = statement.is_some_and(|statement| statement.relation == Relation::Equal);
        match self.claim {
            Claim::Proved if repeats => Verdict::Definition,
            Claim::Proved => Verdict::Proved,
            Claim::Refuted => Verdict::Refuted,
            Claim::Cited => Verdict::Cited,
            Claim::Enclosed if self.by_theorem().is_some() => Verdict::Theorem,
            Claim::Enclosed if single && equal => Verdict::Agrees,
            Claim::Enclosed if single => Verdict::Enclosed,
            Claim::Enclosed => Verdict::Sampled,
        }
    }
}

impl Entry {
    /// The verdict on the entry: refuted if the equation as printed is; a theorem if Coq has checked its claim; else the
    /// verdict on its weakest step.
    pub fn verdict(&self) -> Verdict {
        if self.refuted {
            return Verdict::Refuted;
        }
        if self.theorems().next().is_some() {
            return Verdict::Theorem;
        }
        self.weakest()
    }

    /// The verdict of the weakest step that counts: a step that refutes the printed form, or repeats a definition, does not. An
    /// entry of which no step counts shows nothing: its verdict is that of a definition.
    pub fn weakest(&self) -> Verdict {
        let steps = self.steps.iter().map(Step::verdict);
        let counts = |verdict: &Verdict| !matches!(verdict, Verdict::Refuted | Verdict::Definition);
        steps.filter(counts).max().unwrap_or(Verdict::Definition)
    }
}
