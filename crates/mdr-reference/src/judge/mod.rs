//! Judges the answers of other programs.

mod answer;
mod convention;
mod digits;
mod explain;
mod layout;
mod lines;
mod mark;
mod patterns;
mod report;
mod rules;

pub(crate) use convention::maugis_unit;

pub use answer::{Answer, ClaimError};
pub use explain::Explanation;
pub use mark::{Claim, Limits, Mark, Range, Verdict, mark};
pub use report::{Class, Judged, Report};
pub use rules::{Rules, judge};

use std::collections::HashMap;
use std::io::{self, BufRead, Read};

use self::lines::{Field, Line};
use crate::catalogue;
use crate::record::Record;
use crate::text::excerpt;

/// Lines that could not be judged: their number, and the first few with the reason.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refused {
    /// The number of lines.
    pub count: u64,
    /// Line number, counted from 1, and the error, of the first ten; quoted text is cut to 80 characters, without
    /// control characters.
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

/// The longest line that is read: one mebibyte, a hundred times the length of a value with ten thousand digits.
const LONGEST: u64 = 1 << 20;

/// Judges answers one by one, with memory independent of their number.
///
/// ```
/// use mdr_reference::{Judge, Rules, records};
/// let mut judge = Judge::new(records(), Rules::default());
/// let answers = r#"{"id":"critical/jkr-unit/force/force","value":"-4.71238898038468985769","error":"1e-19"}
/// not an answer"#;
/// judge.read(answers.as_bytes())?;
/// let report = judge.report();
/// assert_eq!((report.answered(), report.malformed.count), (1, 1));
/// assert_eq!(report.failures(), ["malformed line 2"]);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Judge<'a> {
    /// The index of a question; `None` for records that are not among the questions.
    index: HashMap<&'a str, Option<usize>>,
    judged: Vec<Option<Judged<'a>>>,
    lines: u64,
    /// The fields of lines without braces, and whether a header may still name them.
    fields: (Vec<Field>, bool),
    /// Without the answers.
    report: Report<'a>,
}

impl<'a> Judge<'a> {
    /// A judge of answers to these questions. Answers to other records of the release are counted and not judged.
    pub fn new(questions: impl IntoIterator<Item = &'a Record>, rules: Rules) -> Self {
        let questions: Vec<_> = questions.into_iter().collect();
        let all = catalogue::records().iter().map(|record| (record.id.as_str(), None));
        let asked = questions.iter().enumerate().map(|(place, record)| (record.id.as_str(), Some(place)));
        Judge {
            index: all.chain(asked).collect(),
            judged: vec![None; questions.len()],
            lines: 0,
            fields: (lines::PLAIN.to_vec(), true),
            report: Report::new(questions, rules),
        }
    }

    /// Judges the answers on all lines: objects of JSON, `id value`, or CSV, whose header may name `id`, `value`, `error` and `status` in
    /// any order. Empty lines and comments, which begin with #, are skipped; lines that are not answers are counted.
    ///
    /// # Errors
    /// Errors of reading.
    pub fn read(&mut self, mut from: impl BufRead) -> io::Result<()> {
        let mut line = Vec::new();
        loop {
            line.clear();
            if (&mut from).take(LONGEST).read_until(b'\n', &mut line)? == 0 {
                return Ok(());
            }
            if line.len() as u64 == LONGEST && !line.ends_with(b"\n") {
                self.lines += 1;
                self.report.malformed.add(self.lines, || format!("longer than {LONGEST} bytes"));
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
        let text = std::str::from_utf8(line).map_err(|_| format!("not UTF-8; {}", lines::EXPECTED));
        let (fields, may_be_header) = &self.fields;
        let read = text.and_then(|text| lines::read(text, fields, *may_be_header));
        // Comments may stand above a header.
        let is_comment = matches!(read, Ok(Line::Comment));
        self.fields.1 &= is_comment;
        match read {
            Ok(Line::Answer(id, answer)) => self.answer(number, &id, &answer),
            Ok(Line::Header(fields)) => self.fields.0 = fields,
            Ok(Line::Comment) => {}
            Err(why) => self.report.malformed.add(number, || why),
        }
    }

    /// Judges an answer; of several answers to one question the first counts.
    fn answer(&mut self, line: u64, id: &str, answer: &Answer) {
        let Judge { index, judged, report, .. } = self;
        match index.get(id) {
            None => report.unknown.add(line, || excerpt(id)),
            Some(None) => report.set_aside += 1,
            Some(&Some(place)) if judged[place].is_some() => report.repeated.add(line, || excerpt(id)),
            Some(&Some(place)) => judged[place] = Some(report.judgement(place, line, answer)),
        }
    }

    /// The report.
    pub fn report(self) -> Report<'a> {
        self.report.with(self.judged.into_iter().flatten().collect())
    }
}
