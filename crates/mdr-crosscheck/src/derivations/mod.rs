//! The derivations of `mdr-symbolic`, judged: normal forms where they decide, rigorous intervals at random rational points
//! where they do not, and counter-examples for refuted statements.
//!
//! Values are enclosed in intervals of [`BITS`] bits. A step that is
//!
//! * *proved* holds by normal forms; as an independent check of the algebra both sides, evaluated as they are written
//!   without its help (derivatives by dual numbers, integrals by quadrature), have to overlap at [`SPOT_CHECKS`] points;
//! * *enclosed* is an inequality of numbers, or at one point, that intervals prove; an equality there *agrees*: the two sides
//!   overlap to [`AGREEMENT`] bits;
//! * *sampled* is false at none of [`POINTS`] random points and certain at one of them at least, which proves nothing.
//!   [`SamplePoints`] says where they lie;
//! * *refuted* fails by normal forms, and there is a point where its two sides certainly differ.
//!
//! Each statement that is proved or enclosed is also mutated ([`Mutants`]): with one sign, exponent or factor wrong, or with the
//! opposite sense, it must not hold. [`Document`] writes the verdicts.

mod direct;
mod document;
mod ends;
mod functions;
mod mutation;
mod point;
mod turn;

use mdr_core::number::{Interval, Real};
use mdr_symbolic::derivations::{Claim, Entry, Step, entries};
use mdr_symbolic::formula::evaluate;
use mdr_symbolic::{Domain, Error, Relation, Statement};

use direct::Direct;
pub use document::{Document, summary};
pub(crate) use functions::hypergeometric;
pub use mutation::{MutantVerdict, Mutants};
pub use point::{OCTAVES, SamplePoint, SamplePoints};

/// Bits of the intervals.
pub const BITS: u32 = 96;
/// Random points at which a step is enclosed.
pub const POINTS: u32 = 30;
/// Random points at which a proved step is evaluated.
pub const SPOT_CHECKS: u32 = 3;
/// Bits to which two sides that overlap have to be known to count as certain.
pub const AGREEMENT: i64 = 12;

/// The verdicts on an entry.
#[derive(Debug)]
#[non_exhaustive]
pub struct Judgement {
    /// The entry.
    pub entry: &'static Entry,
    /// Its steps in order.
    pub steps: Vec<StepJudgement>,
}

/// The verdicts on a step.
#[derive(Debug)]
#[non_exhaustive]
pub struct StepJudgement {
    /// The step.
    pub step: &'static Step,
    /// Why its claim does not hold; `None` when it does.
    pub failure: Option<String>,
    /// SamplePoints at which it was evaluated.
    pub points: u32,
    /// SamplePoints at which it was certain, of those.
    pub certain: u32,
    /// The verdicts on its mutants.
    pub mutants: Mutants,
}

impl Judgement {
    /// Whether the claim of every step holds, and no mutant survives.
    pub fn holds(&self) -> bool {
        self.steps.iter().all(StepJudgement::holds)
    }

    /// Mutants of all steps.
    pub fn mutants(&self) -> Mutants {
        self.steps.iter().map(|step| step.mutants.clone()).sum()
    }
}

impl StepJudgement {
    /// Whether the claim of the step holds, and no mutant survives.
    pub fn holds(&self) -> bool {
        self.failure.is_none() && self.mutants.count(MutantVerdict::Survives) == 0
    }
}

/// Judges every entry.
pub fn judge_all() -> Vec<Judgement> {
    use rayon::prelude::*;
    entries().par_iter().map(judge).collect()
}

/// Judges an entry. The random points depend on the statement alone.
pub fn judge(entry: &'static Entry) -> Judgement {
    Judgement { entry, steps: entry.steps.iter().map(judge_step).collect() }
}

fn judge_step(step: &'static Step) -> StepJudgement {
    let mut judgement = StepJudgement { step, failure: None, points: 0, certain: 0, mutants: Mutants::default() };
    if let Err(error) = judgement.decide() {
        judgement.failure = Some(error.to_string());
    }
    judgement
}

/// The verdict of intervals on a statement at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Truth {
    Certain,
    Possible,
    False,
    /// A side has no finite enclosure.
    Unknown,
    /// A side has certainly no value.
    Undefined,
}

impl StepJudgement {
    fn decide(&mut self) -> Result<(), Error> {
        let step = self.step;
        let Some(statement) = step.statement()? else { return Ok(()) };
        if let Some((domain, decision)) = step.contradictions()?.first() {
            self.failure = Some(format!("for {} normal forms say {}", domain.text(), decision.text()));
            return Ok(());
        }
        if statement.relation != Relation::SameDimension {
            for domain in step.domains {
                self.evaluate(&statement, *domain)?;
            }
        }
        self.mutants = Mutants::of(step, &statement)?;
        Ok(())
    }

    /// Intervals at the points of the step on a domain.
    fn evaluate(&mut self, statement: &Statement, domain: Domain) -> Result<(), Error> {
        let count = match self.step.claim {
            _ if !self.step.point.is_empty() || statement.is_number() => 1,
            Claim::Enclosed => POINTS,
            _ => SPOT_CHECKS,
        };
        let mut truths = Vec::new();
        for point in points(self.step, statement, domain).take(count as usize) {
            truths.push(truth_as_written(statement, domain, &point)?);
        }
        self.points += count;
        self.certain += truths.iter().map(|truth| u32::from(*truth == Truth::Certain)).sum::<u32>();
        let (certain, false_somewhere) = (truths.contains(&Truth::Certain), truths.contains(&Truth::False));
        let failure = match self.step.claim {
            Claim::Refuted if !false_somewhere => "no counter-example was found",
            Claim::Proved | Claim::Enclosed if false_somewhere => "false at a point",
            Claim::Proved | Claim::Enclosed if !certain => "certain at no point",
            _ => return Ok(()),
        };
        self.failure.get_or_insert_with(|| format!("{failure} for {}", domain.text()));
        Ok(())
    }
}

/// The points of a step. They depend on its statement alone.
fn points(step: &Step, statement: &Statement, domain: Domain) -> SamplePoints {
    SamplePoints::new(&statement.text(), domain, step.point)
}

/// The verdict of intervals on a statement at a point, without normal forms.
fn truth_as_written(statement: &Statement, domain: Domain, point: &SamplePoint) -> Result<Truth, Error> {
    let side = |side| evaluate(side, domain, &Direct::<Interval>::new(point, []));
    let (left, right) = (side(&statement.left)?, side(&statement.right)?);
    Ok(if point.is_undefined() { Truth::Undefined } else { compare(&left, statement.relation, &right) })
}

/// The verdict of intervals on a statement at a point, after normal forms have carried out its derivatives and integrals.
fn truth(statement: &Statement, domain: Domain, point: &SamplePoint) -> Result<Truth, Error> {
    let sides = |statement: &Statement| -> Result<_, Error> {
        Ok((evaluate(&statement.left, domain, point)?, evaluate(&statement.right, domain, point)?))
    };
    // What diverges for some n of the domain may exist for this one; an integral that does not is one without a value.
    let sides = match sides(statement) {
        Err(Error::Integral { .. }) => sides(&statement.at_exponent(point.exponent())),
        sides => sides,
    };
    match sides {
        Err(Error::Integral { .. }) => Ok(Truth::Undefined),
        _ if point.is_undefined() => Ok(Truth::Undefined),
        sides => sides.map(|(left, right)| compare(&left, statement.relation, &right)),
    }
}

fn compare(left: &Interval, relation: Relation, right: &Interval) -> Truth {
    use std::cmp::Ordering::{Greater, Less};
    let known = left.is_finite() && right.is_finite();
    match (relation, left.partial_cmp(right)) {
        _ if !known => Truth::Unknown,
        (Relation::Less, Some(Less)) | (Relation::Greater, Some(Greater)) => Truth::Certain,
        (Relation::Less | Relation::Greater, Some(_)) => Truth::False,
        (Relation::Less | Relation::Greater, None) => Truth::Possible,
        (Relation::Equal | Relation::SameDimension, _) => equal(left, right),
    }
}

/// Two sides that overlap are certain when the width of the difference is small against the larger side; a side that is
/// exactly 0 gives no measure, and an overlap is all there is to see.
fn equal(left: &Interval, right: &Interval) -> Truth {
    if !left.overlaps(right) {
        return Truth::False;
    }
    let size = left.abs().hull(&right.abs());
    let width = left.hull(right).radius();
    let zero = [left, right].iter().any(|side| side.is_point() && side.contains_zero());
    let scaled = rug::Float::with_val(BITS, &width << u32::try_from(AGREEMENT).unwrap_or(0));
    if zero || scaled <= *size.upper() { Truth::Certain } else { Truth::Possible }
}
