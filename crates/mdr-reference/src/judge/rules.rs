//! The rules that answers as a whole must satisfy.

use crate::judge::{Answer, Limits, Report};
use crate::record::Record;

/// The rules for a pass. By default: at least one answer, none wrong or inaccurate, and no line that is not an answer.
///
/// ```
/// use mdr_reference::{Answer, Filter, Rules};
/// let spheres: Filter = "formula=critical profile=power control=force quantity=force id~jkr".parse()?;
/// let rough = |rules: Rules| rules.judge(spheres.select(), |_| Some(Answer::from(-4.712)));
/// assert_eq!(rough(Rules::default()).failures(), ["1 inaccurate"]);
/// assert!(rough(Rules { accept_inaccurate: true, complete: true, ..Rules::default() }).passed());
/// # Ok::<(), mdr_reference::FilterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rules {
    /// The limits between right, inaccurate and wrong.
    pub limits: Limits,
    /// Inaccurate answers pass.
    pub accept_inaccurate: bool,
    /// Lines pass that are not answers, answer questions that do not exist, or answer a question again.
    pub lenient: bool,
    /// Every question must be answered.
    pub complete: bool,
}

impl Rules {
    /// Judges the answers of a solver to the questions; `None` is a question that the solver does not support.
    pub fn judge<'a>(
        &self,
        questions: impl IntoIterator<Item = &'a Record>,
        mut solver: impl FnMut(&Record) -> Option<Answer>,
    ) -> Report<'a> {
        let report = Report::new(questions.into_iter().collect(), *self);
        let questions = report.questions.iter().enumerate();
        let judged = questions.filter_map(|(place, record)| {
            let answer = solver(record)?;
            Some(report.judgement(place, place as u64 + 1, &answer))
        });
        let judged = judged.collect();
        report.with(judged)
    }
}

/// Judges the answers of a solver to the questions by the default [`Rules`]; `None` is a question that the solver does
/// not support.
///
/// ```
/// use mdr_reference::{Answer, Filter, judge};
/// let jkr: Filter = "profile=power control=force quantity=force id~jkr".parse()?;
/// let report = judge(jkr.select(), |question| {
///     // f = C r², R = 1/(2C): F = −(3/2)πwR
///     let radius = 0.5 / question.input_f64("C")?;
///     Some(Answer::from(-1.5 * std::f64::consts::PI * question.input_f64("w")? * radius))
/// });
/// assert!(report.passed(), "{report}");
/// # Ok::<(), mdr_reference::FilterError>(())
/// ```
pub fn judge<'a>(
    questions: impl IntoIterator<Item = &'a Record>,
    solver: impl FnMut(&Record) -> Option<Answer>,
) -> Report<'a> {
    Rules::default().judge(questions, solver)
}
