//! Error against run time: several methods answer the same question with growing effort, and each answer is compared with
//! an enclosure of the truth that none of them had a part in.
//!
//! A [`Diagram`] is one question, a [`Curve`] one contestant, a [`Point`] one setting of its effort. Right digits and
//! numbers of evaluations are a pure function of the source and are gated by a stored baseline; times are measured only
//! when the [`Clock`] runs, and are never gated.

mod baseline;
mod clock;
mod fold;
mod grid;
mod judge;
mod kappa;
mod outside;
mod precision;
pub mod speed;
mod transform;

pub use baseline::{Baseline, Regression};
pub use clock::{Clock, Time};
pub use judge::{Answer, ceiling};

use std::rc::Rc;

use serde::{Deserialize, Serialize};

use self::outside::Outsiders;

/// How far a set of diagrams goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Effort {
    /// Seconds: what a test can afford.
    Quick,
    /// Minutes: what a report shows.
    Full,
}

/// What becomes of an attempt.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// −log₁₀ of the relative error. Below zero when not even the order of magnitude is right.
    Digits(f64),
    /// At least so many digits are right: the error is below the width of the enclosure of the truth.
    AtLeast(f64),
    /// No answer, and why. It is drawn at the edge of the diagram.
    Failed(String),
    /// No answer as long as somebody waited, and how long that was. It is drawn as a failure is.
    Stopped(String),
    /// Done, and all that was checked holds: only time and size are told.
    Passed,
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// What was set, for a reader: "12 nodes", "50 digits", "4096 springs".
    pub setting: String,
    /// What was reached.
    pub outcome: Outcome,
    /// Evaluations of the integrand, function or spring that the method is made of, where they are counted.
    pub evaluations: Option<u64>,
    /// How long one answer took; none when the clock was off.
    pub time: Option<Time>,
}

/// The arithmetic of a contestant, and so what it promises.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Arithmetic {
    /// Double precision.
    Double,
    /// Arbitrary precision without proof.
    Mp,
    /// An enclosure.
    Certified,
}

/// One contestant on one question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Curve {
    /// The name of the method, as in the legend.
    pub contestant: String,
    /// Its arithmetic.
    pub arithmetic: Arithmetic,
    /// Whether another project's code gave the answers (and so may be absent from a report).
    pub outside: bool,
    /// By growing effort.
    pub points: Vec<Point>,
}

/// How a diagram is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum View {
    /// Time to the right, relative error upwards.
    Error,
    /// Digits to the right, time upwards: what precision costs.
    Digits,
    /// Evaluations to the right, time upwards: what size costs.
    Size,
}

impl Curve {
    /// A contestant of this workspace or of a crate that it uses.
    pub fn new(contestant: impl Into<String>, arithmetic: Arithmetic, points: Vec<Point>) -> Self {
        Curve { contestant: contestant.into(), arithmetic, outside: false, points }
    }
}

/// One question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Diagram {
    /// Stable name, and the stem of its files: "transform-power-0.25".
    pub id: String,
    /// The task it belongs to: "kappa", "transform", "fold", "precision", "grid".
    pub task: String,
    /// What is asked, in one line.
    pub title: String,
    /// Where the truth comes from, and why no contestant shares code with it.
    pub truth: String,
    /// How it is drawn.
    pub view: View,
    /// Digits that the question leaves in double precision whatever the method, −log₁₀(u·max(1, condition)).
    pub ceiling: Option<f64>,
    /// The contestant that a user of this workspace gets.
    pub shipped: String,
    /// The contestants.
    pub curves: Vec<Curve>,
    /// Who or what is missing, and why, a sentence each.
    pub omissions: Vec<String>,
}

/// A task: a family of questions.
#[derive(Clone, Copy)]
pub struct Task {
    /// "kappa", "transform", "fold", "precision", "grid".
    pub name: &'static str,
    /// What it is about, in one line.
    pub claim: &'static str,
    diagrams: fn(&mut Setup) -> Vec<Diagram>,
}

impl Task {
    /// Answers its questions.
    pub fn diagrams(&self, setup: &mut Setup) -> Vec<Diagram> {
        setup.outsiders.begin();
        (self.diagrams)(setup)
    }
}

/// How a contest is held: the effort, the clock, and who takes part of other projects.
pub struct Setup {
    effort: Effort,
    clock: Clock,
    outsiders: Outsiders,
    questions: Option<Rc<[precision::Question]>>,
}

impl Setup {
    /// Contestants of other projects are looked for when the first is asked, and only where the clock runs.
    pub fn new(effort: Effort, clock: Clock) -> Self {
        Setup { effort, clock, outsiders: Outsiders::new(effort, clock), questions: None }
    }
}

/// All tasks, in the order of the report.
pub fn tasks() -> &'static [Task] {
    &[kappa::KAPPA, transform::TRANSFORM, fold::FOLD, precision::PRECISION, grid::GRID]
}
