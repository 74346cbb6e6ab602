//! The judgement of many answers.

use crate::difficulty::Difficulty;
use crate::judge::{Answer, Mark, Refused, Rules, Verdict, mark};
use crate::number::Number;
use crate::record::Record;

/// An answer with its question and its mark.
#[derive(Clone, Debug)]
pub struct Judged<'a> {
    /// The question.
    pub record: &'a Record,
    /// The line of the answer, counted from 1.
    pub line: u64,
    /// The judgement.
    pub mark: Mark,
    /// The double nearest to the answer; `None` if it is no finite number.
    pub value: Option<f64>,
}

/// All answers of one difficulty.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Class {
    /// The difficulty.
    pub difficulty: Difficulty,
    /// Questions of this difficulty.
    pub questions: usize,
    /// Answers that are right, inaccurate and wrong.
    pub verdicts: [usize; 3],
    /// The smallest and the median number of correct digits (lower ends of the ranges).
    pub digits: Option<(f64, f64)>,
    /// The median and the largest excess loss (upper ends of the ranges).
    pub excess_loss: Option<(f64, f64)>,
}

/// The result of a judge.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    pub(crate) questions: Vec<&'a Record>,
    pub(crate) rules: Rules,
    /// All answers, by verdict with the wrong ones first; of each verdict those about real contacts first, then the worst.
    pub judged: Vec<Judged<'a>>,
    /// Lines that are not answers.
    pub malformed: Refused,
    /// Answers to questions that do not exist.
    pub unknown: Refused,
    /// Second and further answers to a question.
    pub repeated: Refused,
    /// The number of answers to records that are not among the questions.
    pub set_aside: u64,
}

impl Refused {
    /// `malformed lines 2, 5, 9, …: 17 in all`
    fn in_short(&self, kind: &str) -> String {
        const NAMED: usize = 5;
        let lines: Vec<_> = self.first.iter().take(NAMED).map(|(line, _)| line.to_string()).collect();
        let plural = if self.count == 1 { "" } else { "s" };
        let rest = if self.count > NAMED as u64 { format!(", …: {} in all", self.count) } else { String::new() };
        format!("{kind} line{plural} {}{rest}", lines.join(", "))
    }
}

impl<'a> Report<'a> {
    /// A report without answers.
    pub(crate) fn new(questions: Vec<&'a Record>, rules: Rules) -> Self {
        let none = Refused::default;
        let judged = Vec::new();
        Report { questions, rules, judged, malformed: none(), unknown: none(), repeated: none(), set_aside: 0 }
    }

    /// An answer to the question in this place.
    pub(crate) fn judgement(&self, place: usize, line: u64, answer: &Answer) -> Judged<'a> {
        let record = self.questions[place];
        let value = match &answer.value {
            Some(Number::Finite(value)) => Some(value.nearest()),
            _ => None,
        };
        let value = value.filter(|value| value.is_finite());
        Judged { record, line, mark: mark(record, answer, &self.rules.limits), value }
    }

    /// The report with these answers, in the order of the questions.
    pub(crate) fn with(self, mut judged: Vec<Judged<'a>>) -> Self {
        // The worst first; of answers with the same verdict those about real contacts matter most.
        let badness = |Judged { record, mark, .. }: &Judged<'_>| {
            let loss = mark.excess_loss.map_or(f64::INFINITY, |loss| loss.low.max(-1e9));
            (mark.verdict, record.is_physical(), loss)
        };
        judged.sort_by(|a, b| badness(b).partial_cmp(&badness(a)).unwrap_or(std::cmp::Ordering::Equal));
        Report { judged, ..self }
    }

    /// Whether the answers pass by the [`Rules`].
    pub fn passed(&self) -> bool {
        self.failures().is_empty()
    }

    /// Why the answers do not pass: one text for each broken rule.
    pub fn failures(&self) -> Vec<String> {
        let Rules { accept_inaccurate, lenient, complete, .. } = self.rules;
        let [inaccurate, wrong] = [Verdict::Inaccurate, Verdict::Wrong].map(|verdict| self.count(verdict));
        let refused = self.refused().into_iter().filter(|(_, refused)| refused.count > 0 && !lenient);
        let broken = [
            (self.answered() == 0).then(|| "no question was answered".to_owned()),
            (wrong > 0).then(|| format!("{wrong} wrong")),
            (inaccurate > 0 && !accept_inaccurate).then(|| format!("{inaccurate} inaccurate")),
            (complete && self.unanswered() > 0).then(|| format!("{} not answered", self.unanswered())),
        ];
        broken.into_iter().flatten().chain(refused.map(|(kind, refused)| refused.in_short(kind))).collect()
    }

    /// The number of answers that were judged.
    pub fn answered(&self) -> usize {
        self.judged.len()
    }

    /// The number of questions.
    pub fn questions(&self) -> usize {
        self.questions.len()
    }

    /// The number of questions without an answer.
    pub fn unanswered(&self) -> usize {
        self.questions() - self.answered()
    }

    /// The lines that were not judged, by reason.
    pub fn refused(&self) -> [(&'static str, &Refused); 3] {
        [("malformed", &self.malformed), ("unknown", &self.unknown), ("repeated", &self.repeated)]
    }

    /// The answers with this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.judged.iter().filter(|judged| judged.mark.verdict == verdict).count()
    }

    /// The answers about real contacts that are right, inaccurate and wrong.
    pub fn physical(&self) -> [usize; 3] {
        let count = |verdict| {
            let has = |judged: &&Judged<'_>| judged.record.is_physical() && judged.mark.verdict == verdict;
            self.judged.iter().filter(has).count()
        };
        Verdict::ALL.map(count)
    }

    /// The answers by class.
    pub fn classes(&self) -> [Class; 3] {
        Difficulty::ALL.map(|difficulty| {
            let questions = self.questions.iter().filter(|record| record.difficulty == difficulty).count();
            let answers = || self.judged.iter().filter(move |judged| judged.record.difficulty == difficulty);
            let count = |verdict| answers().filter(|judged| judged.mark.verdict == verdict).count();
            let sorted = |part: fn(&Mark) -> Option<f64>| {
                let mut values: Vec<f64> = answers().filter_map(|judged| part(&judged.mark)).collect();
                values.sort_by(f64::total_cmp);
                values
            };
            let digits = sorted(|mark| mark.lre.map(|range| range.low));
            let losses = sorted(|mark| mark.excess_loss.map(|range| range.high));
            let median = |values: &[f64]| values.get(values.len() / 2).copied();
            Class {
                difficulty,
                questions,
                verdicts: Verdict::ALL.map(count),
                digits: digits.first().copied().zip(median(&digits)),
                excess_loss: median(&losses).zip(losses.last().copied()),
            }
        })
    }
}
