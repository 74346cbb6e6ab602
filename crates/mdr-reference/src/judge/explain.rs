//! Which mistaken convention explains the answers that are not right.

use std::collections::HashSet;
use std::fmt;

use crate::judge::convention::{Convention, normal};
use crate::judge::{Judged, Report, Verdict, patterns};
use crate::record::Record;

/// How many questions with different inputs, and different answers, a convention must explain: fewer may agree by chance,
/// and a program that always prints the same number may agree with any.
pub(crate) const LEAST: usize = 3;

/// The relative difference up to which an answer agrees with the prediction of a convention: that of six printed digits.
const AGREES: f64 = 1e-5;

/// The relative difference from the certified value below which a prediction is not used: ten times that of agreement. A π of
/// 3.14 changes the contact radius of a sphere by 1.7 · 10⁻⁴.
const DIFFERS: f64 = 1e-4;

/// What computing in doubles may change in an answer, over the condition of its question.
const ROUNDING: f64 = 1e-14;

/// The digits of a double that are compared.
const DIGITS: f64 = 15.0;

/// A mistaken convention, or several indistinguishable ones, that would explain the answers.
///
/// A convention is reported if it explains at least three different answers, to questions with different inputs, each to
/// five digits or more.
/// An answer vetoes a convention if it is about a state of which the convention explains another answer, and is not what a program
/// with that convention would answer: right where it would be wrong, wrong where it would be right, or wrong in another way. Only
/// several units and signs may be mistaken together, each in its own answers. A convention is left out, too, when another one
/// explains all that it does, and more. Beside conventions there are three ways of losing digits, of which any answer can be a counterexample:
/// single precision, values that are clamped, and an absolute tolerance.
///
/// ```
/// use mdr_reference::{Answer, Filter, judge};
/// let spheres: Filter = "formula=critical control=force quantity=contact_radius flag=si".parse()?;
/// // a³ = 9πwR²/(8E*), R = 1/(2C), by a program that takes E* for K = 4E*/3.
/// let report = judge(spheres.select(), |question| {
///     let (c, e_star, w) = (question.input_f64("C")?, question.input_f64("E*")?, question.input_f64("w")?);
///     let radius = 0.5 / c;
///     let cube = 1.5 * std::f64::consts::PI * w * radius * radius / e_star;
///     (question.input("n") == Some("2")).then(|| Answer::from(cube.cbrt()))
/// });
/// let found = report.explanations();
/// assert!(found[0].names.contains(&"modulus-from-k".to_owned()), "{}", found[0]);
/// assert_eq!((found[0].explained, found[0].not_right), (6, 6));
/// # Ok::<(), mdr_reference::FilterError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Explanation {
    /// Stable names of the conventions; more than one where each explains the same answers.
    pub names: Vec<String>,
    /// The statement of each, in the same order.
    pub statements: Vec<String>,
    /// How many answers agree with it.
    pub explained: usize,
    /// To how many of the answers that are not right it has something to say.
    pub applicable: usize,
    /// How many answers are not right.
    pub not_right: usize,
    /// How many different inputs the explained answers have.
    pub inputs: usize,
    /// To how many digits all of them agree at least, at most 15.
    pub digits: u32,
}

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (explained, not_right) = (self.explained, self.not_right);
        match explained == not_right {
            true => write!(f, "all {explained} answers that are not right agree")?,
            false => {
                let applicable = self.applicable;
                write!(f, "{explained} of {not_right} answers that are not right ({applicable} can be tested) agree")?;
            }
        }
        if self.digits > 0 {
            write!(f, " to {} digits", self.digits)?;
        }
        write!(f, " if {}", self.statements.join("; or if "))
    }
}

/// An answer, with two numbers to compare.
struct Compared<'a> {
    record: &'a Record,
    certified: f64,
    answer: f64,
}

/// The answers that one convention explains.
struct Match {
    convention: Convention,
    explanation: Explanation,
    /// The places of the explained answers.
    explained: Vec<usize>,
    /// How many different predictions there are for them.
    answers: usize,
}

impl Report<'_> {
    /// The mistaken conventions that explain answers which are not right, the most telling first. Most reports have none.
    pub fn explanations(&self) -> Vec<Explanation> {
        let (right, not_right): (Vec<_>, Vec<_>) =
            self.judged.iter().partition(|judged| judged.mark.verdict == Verdict::Right);
        let [right, wrong] =
            [&right, &not_right].map(|list| list.iter().filter_map(|&judged| Compared::of(judged)).collect::<Vec<_>>());
        let matches = Convention::all().into_iter().map(|convention| Match::of(convention, &wrong, not_right.len()));
        let telling = matches.filter(|matched| matched.explanation.inputs.min(matched.answers) >= LEAST);
        let mut matches: Vec<Match> = telling.filter(|matched| !matched.is_contradicted(&wrong, &right)).collect();
        // A veto may take away what excuses another answer.
        loop {
            let vetoed: Vec<bool> = matches.iter().map(|matched| matched.is_vetoed(&wrong, &matches)).collect();
            if !vetoed.contains(&true) {
                break;
            }
            let mut kept = vetoed.into_iter().map(|vetoed| !vetoed);
            matches.retain(|_| kept.next().unwrap_or(true));
        }
        matches.sort_by_key(|matched| std::cmp::Reverse(matched.explained.len()));
        let mut found: Vec<Match> = Vec::new();
        for matched in matches {
            match found.iter_mut().find(|known| contains(&known.explained, &matched.explained)) {
                Some(known) if known.explained == matched.explained => known.explanation.or(matched.explanation),
                Some(_) => {}
                None => found.push(matched),
            }
        }
        let mut found: Vec<Explanation> = found.into_iter().map(|matched| matched.explanation).collect();
        found.extend(patterns::found(&self.judged, not_right.len()));
        found
    }
}

impl Explanation {
    /// Another convention with the same answers.
    fn or(&mut self, other: Explanation) {
        self.names.extend(other.names);
        self.statements.extend(other.statements);
        self.digits = self.digits.min(other.digits);
    }
}

impl Match {
    fn of(convention: Convention, wrong: &[Compared<'_>], not_right: usize) -> Self {
        let (mut explained, mut applicable, mut worst) = (Vec::new(), 0, 0.0_f64);
        let (mut inputs, mut answers) = (HashSet::new(), HashSet::new());
        for (place, wrong) in wrong.iter().enumerate() {
            let Some(predicted) = wrong.predicted(&convention) else { continue };
            let difference = ((wrong.answer - predicted) / predicted).abs();
            applicable += 1;
            if difference <= AGREES {
                explained.push(place);
                inputs.insert(&wrong.record.inputs);
                answers.insert(rounded(predicted));
                worst = worst.max(difference);
            }
        }
        let explanation = Explanation {
            names: vec![convention.name.clone()],
            statements: vec![convention.statement.clone()],
            explained: explained.len(),
            applicable,
            not_right,
            inputs: inputs.len(),
            // The digits that agree at the largest difference.
            digits: (-worst.log10()).min(DIGITS).floor() as u32,
        };
        Match { convention, explanation, explained, answers: answers.len() }
    }

    /// Whether it makes wrong an answer that is right, about a state of which it explains another answer.
    fn is_contradicted(&self, wrong: &[Compared<'_>], right: &[Compared<'_>]) -> bool {
        let states: HashSet<_> = self.explained.iter().map(|&place| wrong[place].state()).collect();
        let mut of_states = right.iter().filter(|answer| states.contains(&answer.state()));
        of_states.any(|answer| answer.predicted(&self.convention).is_some())
    }

    /// Whether a wrong answer about a state of which it explains another one is wrong in another way.
    fn is_vetoed(&self, wrong: &[Compared<'_>], matches: &[Match]) -> bool {
        let states: HashSet<_> = self.explained.iter().map(|&place| wrong[place].state()).collect();
        let mut others = wrong
            .iter()
            .enumerate()
            .filter(|(place, answer)| states.contains(&answer.state()) && self.explained.binary_search(place).is_err());
        others.any(|(place, answer)| {
            let leaves = self.convention.leaves(answer.record);
            let excused = || {
                let of_notation = |other: &&Match| other.convention.is_of_notation();
                let mut explaining = matches.iter().filter(of_notation);
                let explained = explaining.any(|other| other.explained.binary_search(&place).is_ok());
                leaves && self.convention.is_of_notation() && explained
            };
            let expected = match leaves {
                true => Some(answer.certified),
                false => self.convention.predict(answer.record, answer.certified),
            };
            expected.is_some_and(|expected| answer.is_other_than(expected)) && !excused()
        })
    }
}

impl<'a> Compared<'a> {
    /// `None` unless both are normal doubles.
    fn of(judged: &Judged<'a>) -> Option<Self> {
        Some(Compared { record: judged.record, certified: normal(judged.record)?, answer: judged.value? })
    }

    /// The state that the question is about. Its radius, depth and force come from one computation.
    fn state(&self) -> (&str, Option<&str>, &[(String, String)]) {
        (&self.record.formula, self.record.control.as_deref(), &self.record.inputs)
    }

    /// Whether it is a number, and neither `expected` nor that with the rounding errors of its question.
    fn is_other_than(&self, expected: f64) -> bool {
        let tolerance = AGREES.max(ROUNDING * self.record.total_condition());
        self.answer.is_finite() && ((self.answer - expected) / expected).abs() > tolerance
    }

    /// The prediction of a convention; `None` if there is none, or if it is the certified value itself.
    fn predicted(&self, convention: &Convention) -> Option<f64> {
        let predicted = convention.predict(self.record, self.certified)?;
        (((predicted - self.certified) / self.certified).abs() > DIFFERS).then_some(predicted)
    }
}

/// A number to six digits, for comparing two numbers.
fn rounded(value: f64) -> String {
    format!("{value:.5e}")
}

/// Whether all places of the second list, in order, are in the first.
fn contains(all: &[usize], some: &[usize]) -> bool {
    some.iter().all(|place| all.binary_search(place).is_ok())
}
