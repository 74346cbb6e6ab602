//! Marks the answers of other programs.

mod answer;
mod mark;
mod report;

pub use answer::Answer;
pub use mark::{Claim, Limits, Mark, Range, Verdict, mark};
pub use report::{Class, Judged, Report};

use std::collections::HashMap;
use std::io::{self, BufRead, Read};

use crate::record::Record;

/// Lines that could not be judged: how many, and the first few with their reason.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refused {
    /// How many.
    pub count: u64,
    /// Line number, counted from 1, and what is wrong, of the first ten.
    pub first: Vec<(u64, String)>,
}

impl Refused {
    fn add(&mut self, line: u64, why: impl FnOnce() -> String) {
        self.count += 1;
        if self.first.len() < 10 {
            self.first.push((line, why()));
        }
    }
}

/// The longest line that is read: one mebibyte, a hundred times what a value with ten thousand digits needs.
const LONGEST: u64 = 1 << 20;

/// Judges answers as they come. What it keeps does not grow with their number.
///
/// ```
/// use mdr_reference::{Judge, Limits, records};
/// let mut judge = Judge::new(records(), Limits::default());
/// let answers = r#"{"id":"critical/jkr-unit/force/force","value":"-4.71238898038468985769","error":"1e-19"}
/// not an answer"#;
/// judge.read(answers.as_bytes())?;
/// let report = judge.report();
/// assert_eq!((report.answered(), report.malformed.count), (1, 1));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Judge<'a> {
    records: &'a [Record],
    index: HashMap<&'a str, usize>,
    limits: Limits,
    marks: Vec<Option<(u64, Mark)>>,
    lines: u64,
    malformed: Refused,
    unknown: Refused,
    repeated: Refused,
}

impl<'a> Judge<'a> {
    /// A judge of answers to the questions of these records.
    pub fn new(records: &'a [Record], limits: Limits) -> Self {
        let index = records.iter().enumerate().map(|(index, record)| (record.id.as_str(), index)).collect();
        Judge {
            records,
            index,
            limits,
            marks: vec![None; records.len()],
            lines: 0,
            malformed: Refused::default(),
            unknown: Refused::default(),
            repeated: Refused::default(),
        }
    }

    /// Judges the answers on all lines. Empty lines pass; lines that are no answers are counted, and the others judged.
    ///
    /// # Errors
    /// Those of reading.
    pub fn read(&mut self, mut from: impl BufRead) -> io::Result<()> {
        let mut line = Vec::new();
        loop {
            line.clear();
            if (&mut from).take(LONGEST).read_until(b'\n', &mut line)? == 0 {
                return Ok(());
            }
            if line.len() as u64 == LONGEST && !line.ends_with(b"\n") {
                self.lines += 1;
                self.malformed.add(self.lines, || format!("longer than {LONGEST} bytes"));
                from.skip_until(b'\n')?;
            } else {
                self.line(&line);
            }
        }
    }

    /// Judges the answer on the next line.
    pub fn line(&mut self, line: &[u8]) {
        self.lines += 1;
        let number = self.lines;
        // Some programs begin a file with a byte order mark.
        let line = if number == 1 { line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line) } else { line };
        if line.trim_ascii().is_empty() {
            return;
        }
        let text = std::str::from_utf8(line).map_err(|_| "not UTF-8".to_owned());
        match text.and_then(Answer::from_json) {
            Ok((id, answer)) => self.answer(number, &id, &answer),
            Err(why) => self.malformed.add(number, || why),
        }
    }

    /// Judges an answer; of several to one question the first counts.
    fn answer(&mut self, line: u64, id: &str, answer: &Answer) {
        let Some(&index) = self.index.get(id) else {
            self.unknown.add(line, || id.chars().take(80).collect());
            return;
        };
        if self.marks[index].is_some() {
            self.repeated.add(line, || id.to_owned());
        } else {
            self.marks[index] = Some((line, mark(&self.records[index], answer, &self.limits)));
        }
    }

    /// What has been found.
    pub fn report(self) -> Report<'a> {
        let judged = self.records.iter().zip(self.marks);
        let judged = judged.filter_map(|(record, mark)| mark.map(|(line, mark)| Judged { record, line, mark }));
        Report {
            malformed: self.malformed,
            unknown: self.unknown,
            repeated: self.repeated,
            ..Report::new(self.records.iter().collect(), judged.collect())
        }
    }
}

/// Puts the questions of `records` to a solver and judges its answers; `None` is a question it does not take.
///
/// ```
/// use mdr_reference::{Answer, Filter, judge};
/// let jkr: Filter = "profile=power control=force quantity=force id~jkr".parse()?;
/// let report = judge(jkr.select(), |question| {
///     // f = C r², R = 1/(2C): F = −(3/2)πwR
///     let radius = 0.5 / question.input_f64("C");
///     Some(Answer::from(-1.5 * std::f64::consts::PI * question.input_f64("w") * radius))
/// });
/// assert!(report.passed(), "{report}");
/// # Ok::<(), mdr_reference::FilterError>(())
/// ```
pub fn judge<'a>(
    records: impl IntoIterator<Item = &'a Record>,
    mut solver: impl FnMut(&Record) -> Option<Answer>,
) -> Report<'a> {
    let mut questions = Vec::new();
    let mut judged = Vec::new();
    for record in records {
        questions.push(record);
        if let Some(answer) = solver(record) {
            judged.push(Judged {
                record,
                line: questions.len() as u64,
                mark: mark(record, &answer, &Limits::default()),
            });
        }
    }
    Report::new(questions, judged)
}
