//! The judgement of many answers.

use std::fmt;

use crate::difficulty::Difficulty;
use crate::json::quoted;
use crate::judge::{Mark, Range, Refused, Verdict};
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
}

/// All answers of one difficulty.
#[derive(Clone, Debug, PartialEq)]
pub struct Class {
    /// The difficulty.
    pub difficulty: Difficulty,
    /// Questions of this difficulty.
    pub questions: usize,
    /// Answers that are right, inaccurate and wrong.
    pub verdicts: [usize; 3],
    /// The smallest and the median number of right digits (lower ends of the ranges).
    pub digits: Option<(f64, f64)>,
    /// The median and the largest excess loss (lower ends).
    pub excess_loss: Option<(f64, f64)>,
}

/// What a judge found.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    pub(crate) questions: Vec<&'a Record>,
    /// All answers, the worst first.
    pub judged: Vec<Judged<'a>>,
    /// Lines that are no answers.
    pub malformed: Refused,
    /// Answers to questions that do not exist.
    pub unknown: Refused,
    /// Second and further answers to a question.
    pub repeated: Refused,
}

impl<'a> Report<'a> {
    /// A report of these answers to these questions.
    pub(crate) fn new(questions: Vec<&'a Record>, mut judged: Vec<Judged<'a>>) -> Self {
        let badness = |judged: &Judged<'_>| judged.mark.badness();
        judged.sort_by(|a, b| badness(b).partial_cmp(&badness(a)).unwrap_or(std::cmp::Ordering::Equal));
        let none = Refused::default;
        Report { questions, judged, malformed: none(), unknown: none(), repeated: none() }
    }

    /// Whether there are answers, and none is wrong.
    pub fn passed(&self) -> bool {
        self.answered() > 0 && self.count(Verdict::Wrong) == 0
    }

    /// The number of answers that were judged.
    pub fn answered(&self) -> usize {
        self.judged.len()
    }

    /// The number of questions.
    pub fn questions(&self) -> usize {
        self.questions.len()
    }

    /// The answers with this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.judged.iter().filter(|judged| judged.mark.verdict == verdict).count()
    }

    /// The answers class by class.
    pub fn classes(&self) -> [Class; 3] {
        Difficulty::ALL.map(|difficulty| {
            let questions = self.questions.iter().filter(|record| record.difficulty == difficulty).count();
            let answers = || self.judged.iter().filter(move |judged| judged.record.difficulty == difficulty);
            let count = |verdict| answers().filter(|judged| judged.mark.verdict == verdict).count();
            let sorted = |part: fn(&Mark) -> Option<Range>| {
                let mut values: Vec<f64> = answers().filter_map(|judged| part(&judged.mark)).map(|r| r.low).collect();
                values.sort_by(f64::total_cmp);
                values
            };
            let (digits, losses) = (sorted(|mark| mark.lre), sorted(|mark| mark.excess_loss));
            let median = |values: &[f64]| values.get(values.len() / 2).copied();
            Class {
                difficulty,
                questions,
                verdicts: [Verdict::Right, Verdict::Inaccurate, Verdict::Wrong].map(count),
                digits: digits.first().copied().zip(median(&digits)),
                excess_loss: median(&losses).zip(losses.last().copied()),
            }
        })
    }

    /// One JSON object a line, schema `mdr.judge/1`: the answers, worst first, then the refused lines, then the summary.
    pub fn to_json_lines(&self) -> String {
        let mut lines: Vec<String> = self.judged.iter().map(answer_line).collect();
        for (kind, refused) in self.refused() {
            lines.extend(refused.first.iter().map(|(line, why)| {
                format!("{{{SCHEMA},\"refused\":\"{kind}\",\"line\":{line},\"why\":{}}}", quoted(why))
            }));
        }
        lines.push(self.summary_line());
        lines.join("\n")
    }

    /// The lines that were not judged, by the reason.
    pub fn refused(&self) -> [(&'static str, &Refused); 3] {
        [("malformed", &self.malformed), ("unknown", &self.unknown), ("repeated", &self.repeated)]
    }

    fn summary_line(&self) -> String {
        let classes = self.classes().map(|class| {
            let [right, inaccurate, wrong] = class.verdicts;
            let pair = |pair: Option<(f64, f64)>| pair.map_or("null".to_owned(), |(a, b)| range(a, b));
            format!(
                "\"{}\":{{\"questions\":{},\"right\":{right},\"inaccurate\":{inaccurate},\"wrong\":{wrong},\
                 \"lre_least_median\":{},\"excess_loss_median_largest\":{}}}",
                class.difficulty,
                class.questions,
                pair(class.digits),
                pair(class.excess_loss)
            )
        });
        let refused = self.refused().map(|(kind, refused)| format!("\"{kind}\":{}", refused.count));
        format!(
            "{{{SCHEMA},\"summary\":{{\"questions\":{},\"answered\":{},{},\"classes\":{{{}}},\"passed\":{}}}}}",
            self.questions(),
            self.answered(),
            refused.join(","),
            classes.join(","),
            self.passed()
        )
    }
}

const SCHEMA: &str = "\"schema\":\"mdr.judge/1\"";

fn answer_line(judged: &Judged<'_>) -> String {
    let Judged { record, line, mark } = judged;
    let optional = |value: Option<Range>| value.map_or("null".to_owned(), |value| range(value.low, value.high));
    format!(
        "{{{SCHEMA},\"id\":{},\"line\":{line},\"verdict\":\"{}\",\"reason\":{},\"status_matches\":{},\"lre\":{},\
         \"excess_loss\":{},\"claim\":\"{}\",\"condition\":{},\"difficulty\":\"{}\"}}",
        quoted(&record.id),
        mark.verdict.name(),
        quoted(&mark.reason),
        mark.status_matches,
        optional(mark.lre),
        optional(mark.excess_loss),
        mark.claim.name(),
        record.total_condition(),
        record.difficulty
    )
}

/// `[low,high]`, with null where there is no bound.
fn range(low: f64, high: f64) -> String {
    let end = |x: f64| if x.is_finite() { format!("{x:.3}") } else { "null".to_owned() };
    format!("[{},{}]", end(low), end(high))
}

/// For a test or a terminal: the classes, then the ten worst answers.
impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "difficulty  questions  right  inaccurate  wrong  digits least/median  excess loss median/largest"
        )?;
        for class in self.classes() {
            let [right, inaccurate, wrong] = class.verdicts;
            let pair = |pair: Option<(f64, f64)>| pair.map_or("-".to_owned(), |(a, b)| format!("{a:.1} / {b:.1}"));
            let (digits, loss) = (pair(class.digits), pair(class.excess_loss));
            writeln!(
                f,
                "{:<10}  {:>9}  {right:>5}  {inaccurate:>10}  {wrong:>5}  {digits:>19}  {loss:>26}",
                class.difficulty, class.questions
            )?;
        }
        for judged in self.judged.iter().filter(|judged| judged.mark.verdict != Verdict::Right).take(10) {
            writeln!(f, "{}: {}: {}", judged.record.id, judged.mark.verdict.name(), judged.mark.reason)?;
        }
        for (kind, refused) in self.refused().into_iter().filter(|(_, refused)| refused.count > 0) {
            writeln!(f, "{} lines {kind}", refused.count)?;
        }
        Ok(())
    }
}
