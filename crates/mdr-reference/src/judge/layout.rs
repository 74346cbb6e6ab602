//! A report as JSON lines, as rows of a table, and as text.

use std::fmt;

use crate::json::{Json, notation, object, text, texts};
use crate::judge::{Class, Explanation, Judged, Range, Report, Verdict};

/// The names of [`fields`].
const FIELDS: [&str; 10] =
    ["id", "line", "verdict", "reason", "status_matches", "lre", "excess_loss", "claim", "condition", "difficulty"];

fn fields<'a>(judged: &'a Judged<'_>, range: fn(Option<(f64, f64)>) -> Json<'static>) -> [Json<'a>; 10] {
    let Judged { record, line, mark, .. } = judged;
    let range = |ends: Option<Range>| range(ends.map(|Range { low, high }| (low, high)));
    [
        text(&record.id),
        notation(line),
        text(mark.verdict.name()),
        text(&mark.reason),
        notation(mark.status_matches),
        range(mark.lre),
        range(mark.excess_loss),
        text(mark.claim.name()),
        notation(record.total_condition()),
        text(record.difficulty.name()),
    ]
}

/// A line of JSON.
fn line<'a>(fields: impl IntoIterator<Item = (&'a str, Json<'a>)>) -> String {
    object([("schema", text("mdr.judge/1"))].into_iter().chain(fields)).to_string()
}

impl Report<'_> {
    /// One JSON object per line, schema `mdr.judge/1`: the answers, worst first, then the rejected lines, then the
    /// summary.
    pub fn to_json_lines(&self) -> String {
        let answers = self.judged.iter().map(|judged| line(FIELDS.into_iter().zip(fields(judged, pair))));
        let refused = self
            .first_refused()
            .map(|(kind, number, why)| line([("refused", text(kind)), ("line", notation(number)), ("why", text(why))]));
        answers.chain(refused).chain([self.summary_line()]).collect::<Vec<_>>().join("\n")
    }

    fn summary_line(&self) -> String {
        let classes = self.classes().map(|class| {
            let [right, inaccurate, wrong] = class.verdicts.map(notation);
            let counts = [
                ("questions", notation(class.questions)),
                ("right", right),
                ("inaccurate", inaccurate),
                ("wrong", wrong),
                ("lre_least_median", pair(class.digits)),
                ("excess_loss_median_largest", pair(class.excess_loss)),
            ];
            (class.difficulty.name(), object(counts))
        });
        let (failures, explanations) = (self.failures(), self.explanations());
        let counts = [
            ("questions", notation(self.questions())),
            ("answered", notation(self.answered())),
            ("unanswered", notation(self.unanswered())),
            ("set_aside", notation(self.set_aside)),
        ];
        let judgement = [
            ("classes", object(classes)),
            ("physical", Json::List(self.physical().map(notation).to_vec())),
            ("failures", texts(&failures)),
            ("passed", Json::Bool(self.passed())),
            ("hypotheses", Json::List(explanations.iter().map(hypothesis).collect())),
        ];
        let refused = self.refused().map(|(kind, refused)| (kind, notation(refused.count)));
        line([("summary", object(counts.into_iter().chain(refused).chain(judgement)))])
    }

    /// A row of names, then one for each answer, worst first, then one for each rejected line, with the kind of
    /// rejection as verdict and the error as reason. Ranges take two columns.
    pub fn to_rows(&self) -> Vec<Vec<String>> {
        let header = FIELDS.iter().flat_map(|name| match *name {
            "lre" | "excess_loss" => vec![format!("{name}_low"), format!("{name}_high")],
            name => vec![name.to_owned()],
        });
        let header: Vec<_> = header.collect();
        let columns = header.len();
        let answers = self.judged.iter().map(|judged| {
            let whole = |ends: Option<(f64, f64)>| {
                let (low, high) = ends.map_or_else(Default::default, |(low, high)| (low.to_string(), high.to_string()));
                Json::List(vec![Json::Text(low.into()), Json::Text(high.into())])
            };
            let cells = fields(judged, whole).into_iter().flat_map(|field| match field {
                Json::List(ends) => ends,
                field => vec![field],
            });
            cells.map(|cell| cell.as_text().unwrap_or_default().to_owned()).collect()
        });
        let refused = self.first_refused().map(|(kind, line, why)| {
            let mut row = [String::new(), line.to_string(), kind.to_owned(), why.to_owned()].to_vec();
            row.resize(columns, String::new());
            row
        });
        std::iter::once(header.clone()).chain(answers).chain(refused).collect()
    }

    /// The first rejected lines of each kind: the kind, the number of the line, and the error.
    fn first_refused(&self) -> impl Iterator<Item = (&'static str, u64, &str)> {
        let refused = self.refused().into_iter();
        refused.flat_map(|(kind, refused)| refused.first.iter().map(move |(line, why)| (kind, *line, why.as_str())))
    }

    /// The text after the table of classes: the rejected lines, the counts, and why the answers do not pass, if they do
    /// not.
    pub fn summary(&self) -> String {
        let mut text = String::new();
        for (kind, refused) in self.refused().into_iter().filter(|(_, refused)| refused.count > 0) {
            refused.first.iter().for_each(|(line, why)| text.push_str(&format!("line {line}: {kind}: {why}\n")));
            let rest = refused.count - refused.first.len() as u64;
            text.push_str(&if rest > 0 { format!("{rest} more lines {kind}\n\n") } else { "\n".to_owned() });
        }
        let [right, inaccurate, wrong] = Verdict::ALL.map(|verdict| self.count(verdict));
        let (answered, questions) = (self.answered(), self.questions());
        text.push_str(&format!(
            "{answered} of {questions} questions answered: {right} right, {inaccurate} inaccurate, {wrong} wrong; {} not \
             answered",
            self.unanswered()
        ));
        text.push_str(&match self.set_aside {
            0 => String::new(),
            1 => "; 1 answer to another record set aside".to_owned(),
            many => format!("; {many} answers to other records set aside"),
        });
        let [right, inaccurate, wrong] = self.physical();
        if inaccurate + wrong > 0 {
            text.push_str(&format!("\nof real contacts: {right} right, {inaccurate} inaccurate, {wrong} wrong"));
        }
        for explanation in self.explanations() {
            text.push_str(&format!("\n{explanation}"));
        }
        let failures = self.failures();
        if !failures.is_empty() {
            text.push_str(&format!("\nnot passed: {}", failures.join("; ")));
        }
        text
    }
}

/// An explanation as a JSON object.
fn hypothesis(explanation: &Explanation) -> Json<'_> {
    object([
        ("names", texts(&explanation.names)),
        ("statements", texts(&explanation.statements)),
        ("explained", notation(explanation.explained)),
        ("applicable", notation(explanation.applicable)),
        ("not_right", notation(explanation.not_right)),
        ("inputs", notation(explanation.inputs)),
        ("digits", notation(explanation.digits)),
    ])
}

/// `[first,second]` to three decimals, with null for a value that is not finite.
fn pair(pair: Option<(f64, f64)>) -> Json<'static> {
    let end = |x: f64| if x.is_finite() { notation(fixed(x, 3)) } else { Json::Null };
    pair.map_or(Json::Null, |(first, second)| Json::List(vec![end(first), end(second)]))
}

/// Rounded to this number of decimals; a zero has no sign.
fn fixed(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| byte == b'0' || byte == b'.') => zero.to_owned(),
        _ => text,
    }
}

/// To a tenth; an infinite value means that the answer may be exact.
fn tenths(x: f64) -> String {
    if x.is_finite() { fixed(x, 1) } else { "exact".to_owned() }
}

/// To a tenth: one number if both ends are the same, `> x` without an upper end, `< x` without a lower end, `exact`
/// without either.
///
/// ```
/// use mdr_reference::Range;
/// assert_eq!(Range { low: 3.52, high: 3.68 }.to_string(), "3.5 to 3.7");
/// assert_eq!(Range { low: -1e-12, high: 1e-12 }.to_string(), "0.0");
/// assert_eq!(Range { low: 49.7, high: f64::INFINITY }.to_string(), "> 49.7");
/// ```
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = (tenths(self.low), tenths(self.high));
        match (self.low.is_finite(), self.high.is_finite()) {
            (true, true) if low == high => f.pad(&low),
            (true, true) => f.pad(&format!("{low} to {high}")),
            (true, false) => f.pad(&format!("> {low}")),
            (false, true) => f.pad(&format!("< {high}")),
            (false, false) => f.pad("exact"),
        }
    }
}

impl Class {
    /// The header of [`Class::cells`].
    pub const HEADER: [&str; 9] =
        ["difficulty", "questions", "right", "inaccurate", "wrong", "least digits", "median", "median loss", "largest"];

    /// The class as a row of a table: the least numbers of correct digits and the largest numbers of lost digits, to a
    /// tenth.
    pub fn cells(&self) -> [String; 9] {
        let pair = |pair: Option<(f64, f64)>| pair.map_or(Default::default(), |(a, b)| [a, b].map(tenths));
        let ([least, digits], [loss, largest]): ([String; 2], [String; 2]) =
            (pair(self.digits), pair(self.excess_loss));
        let [right, inaccurate, wrong] = self.verdicts.map(|count| count.to_string());
        let (difficulty, questions) = (self.difficulty.to_string(), self.questions.to_string());
        [difficulty, questions, right, inaccurate, wrong, least, digits, loss, largest]
    }
}

/// For a test or a terminal: the classes, the ten worst answers, and the summary.
impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let header = Class::HEADER.map(str::to_owned);
        for row in [header].into_iter().chain(self.classes().map(|class| class.cells())) {
            let cells = row.iter().zip(Class::HEADER).map(|(cell, name)| format!("{cell:<width$}", width = name.len()));
            writeln!(f, "{}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
        }
        writeln!(f)?;
        for judged in self.judged.iter().filter(|judged| judged.mark.verdict != Verdict::Right).take(10) {
            writeln!(f, "{}: {}: {}", judged.record.id, judged.mark.verdict.name(), judged.mark.reason)?;
        }
        f.write_str(&self.summary())
    }
}
