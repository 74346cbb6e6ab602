//! Stability ladders: how the error of a function in double precision grows while its question becomes hard.
//!
//! A [`Ladder`] leads one function in one dangerous direction: towards n = 1/2, to the fold, to the edge of a face, to the
//! ends of the range of doubles. On each [`Rung`] the error of our answer stands beside the cost of the question itself,
//! max(1, condition) roundoffs, and beside the error of the formula as textbooks write it. The truth is an enclosure of the
//! exact result for the doubles given, at a precision that rises until it is far narrower than a double. Which inputs lead a
//! function where is a line of `data/ladders.tsv`.
//!
//! The **excess loss** log₁₀(error/(u·max(1, condition))) distinguishes a bad algorithm from a badly conditioned question.
//! Acceptance ([`Ladder::accepted`]): no NaN, no infinity and no zero where there is a number, and an excess loss of one
//! digit at most.

mod approach;
mod measure;
mod worst;

use mdr_core::named;
use rayon::prelude::*;
use serde::Serialize;

use self::approach::cases;
use crate::Level;

pub use worst::{Worst, WorstError, worst_inputs};

named! {
    /// Where a ladder leads: the pictures are drawn by family.
    #[derive(PartialOrd, Ord, Serialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum Family {
        /// n → 1/2 from both sides.
        Half = "half",
        /// n → 0.
        SmallExponent = "small-exponent",
        /// n → ∞.
        LargeExponent = "large-exponent",
        /// To a fold, or to folds that merge.
        Fold = "fold",
        /// To a zero of the result.
        Zero = "zero",
        /// To the ends of the range of doubles.
        Scale = "scale",
        /// x → the radius of an edge, b/x → 1.
        Edge = "edge",
        /// x → 0.
        Tip = "tip",
        /// x → ∞.
        Far = "far",
        /// The wavelength → 0.
        Wavelength = "wavelength",
        /// The stiffness of the machine → 0 and ∞.
        Stiffness = "stiffness",
    }
}

impl Family {
    /// For a reader.
    pub const fn title(self) -> &'static str {
        match self {
            Family::Half => "the exponent tends to 1/2",
            Family::SmallExponent => "the exponent tends to 0",
            Family::LargeExponent => "the exponent tends to infinity",
            Family::Fold => "the state tends to a fold",
            Family::Zero => "the result tends to a zero",
            Family::Scale => "an input tends to the ends of the range of doubles",
            Family::Edge => "the radius tends to an edge",
            Family::Tip => "the radius tends to 0",
            Family::Far => "the radius tends to infinity",
            Family::Wavelength => "the wavelength tends to 0",
            Family::Stiffness => "the stiffness of the machine tends to 0 and to infinity",
        }
    }
}

/// One function in one direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ladder {
    /// The function and, where it gives more than a number, the number: "double::critical, dead load, F".
    pub function: String,
    /// The family of its direction.
    pub family: Family,
    /// Its direction, such as "n → 1/2 from above".
    pub toward: String,
    /// The parameter of the rungs, such as "|n − 1/2|".
    pub axis: String,
    /// The names of the inputs.
    pub inputs: Vec<String>,
    /// The formula that naive errors belong to, where there is one.
    pub naive: Option<String>,
    /// In the order of the direction.
    pub rungs: Vec<Rung>,
}

/// One question.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Rung {
    /// Where on the ladder.
    pub parameter: f64,
    /// The inputs of the function, to the last bit.
    pub inputs: Vec<f64>,
    /// Σ|xᵢ ∂f/∂xᵢ|/|f| over the inputs, without an n that is a whole number; `None` if the result is 0.
    pub condition: Option<f64>,
    /// The result of the library's function.
    pub found: Found,
    /// The error of the naive formula in ulp, infinite where it gives no number.
    pub naive_ulp: Option<f64>,
}

/// The outcome of a question.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Found {
    /// A number.
    Number {
        /// Its error, in units in the last place of the correctly rounded result.
        ulp: f64,
        /// log₁₀(error/(u·max(1, condition))); −∞ where there is no error at all.
        excess: f64,
    },
    /// An exact result is out of the range of doubles, and was said to be, with its log₁₀.
    Beyond {
        /// log₁₀ of (the error of the log₁₀ over the cost of rounding there); −∞ if the function reports that the log₁₀ is
        /// unknown.
        excess: f64,
    },
    /// A result below the least double, rounded to 0 by a function that is documented to do so.
    Flushed,
    /// There is no such number, and it was said.
    Refused,
    /// There is a number, but the function says in a typed error that it could not find it.
    Declined(String),
    /// NaN, an infinity, a zero, a number where there is none: wrong in silence.
    Wrong(String),
}

/// The digits that may be lost beyond the cost of the question itself.
pub const MOST_EXCESS: f64 = 1.0;

impl Rung {
    /// The excess loss; `None` if there is no number.
    pub fn excess(&self) -> Option<f64> {
        match self.found {
            Found::Number { excess, .. } | Found::Beyond { excess } => Some(excess),
            _ => None,
        }
    }

    /// The error in units in the last place; `None` if there is no number in the range of doubles.
    pub fn ulp(&self) -> Option<f64> {
        match self.found {
            Found::Number { ulp, .. } => Some(ulp),
            _ => None,
        }
    }

    /// Whether the answer is no worse than it may be.
    pub fn accepted(&self) -> bool {
        match &self.found {
            Found::Number { excess, .. } | Found::Beyond { excess } => *excess <= MOST_EXCESS,
            Found::Flushed | Found::Refused => true,
            Found::Declined(_) | Found::Wrong(_) => false,
        }
    }
}

impl Ladder {
    /// Whether all rungs are.
    pub fn accepted(&self) -> bool {
        self.rungs.iter().all(Rung::accepted)
    }

    /// The rung with the largest excess loss; one that is not accepted otherwise comes first.
    pub fn worst(&self) -> Option<&Rung> {
        let key =
            |rung: &Rung| if rung.accepted() { rung.excess().unwrap_or(f64::NEG_INFINITY) } else { f64::INFINITY };
        self.rungs.iter().max_by(|a, b| key(a).total_cmp(&key(b)))
    }

    /// The largest error of the naive formula in ulp.
    pub fn worst_naive(&self) -> Option<f64> {
        self.rungs.iter().filter_map(|rung| rung.naive_ulp).max_by(f64::total_cmp)
    }
}

/// All ladders, in the order of the functions.
pub fn ladders(level: Level) -> Vec<Ladder> {
    ladders_of(level, "")
}

/// The ladders of the functions whose names contain a word.
pub fn ladders_of(level: Level, word: &str) -> Vec<Ladder> {
    let all = level != Level::Quick;
    let cases: Vec<_> = cases().into_iter().filter(|(routine, ..)| routine.name.contains(word)).collect();
    cases.par_iter().map(|(routine, approach, last)| approach.ladder(routine, *last, all)).collect()
}

/// The public functions of f64 that have a ladder, such as "double::kappa" or "Sphere::g".
pub fn functions() -> Vec<String> {
    let mut names: Vec<_> = cases().iter().map(|(routine, ..)| routine.function().to_owned()).collect();
    names.dedup();
    names
}
