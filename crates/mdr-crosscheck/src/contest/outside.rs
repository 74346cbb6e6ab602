//! Contestants of other projects, asked through a script in Python: `python/contestants.py` of this crate.
//!
//! The interpreter is the one that the environment variable `MDR_PYTHON` names, or else `target/python/bin/python`, which
//! `make contestants` sets up. Where there is none, or a package is missing, their curves are absent and that is said.
//! Times are taken inside Python, so its start and the conversation are not in them; errors are judged here.

use std::env;
use std::io::{BufRead, BufReader, Lines, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use mdr_core::number::Interval;
use rug::Float;
use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::{Arithmetic, Clock, Curve, Outcome, Point, Time};

/// The script, so that a program finds it wherever it runs.
const SCRIPT: &str = include_str!("../../python/contestants.py");

/// Where `make contestants` puts the packages.
const DEFAULT: &str = "target/python/bin/python";

/// A running script. It ends with its owner.
pub(super) struct Python {
    child: Child,
    questions: ChildStdin,
    answers: Lines<BufReader<ChildStdout>>,
    /// The packages that are there, with their versions.
    versions: Map<String, Value>,
    asked: u64,
}

/// What was answered.
#[derive(Debug, PartialEq)]
pub(super) enum Reply {
    /// Numbers in decimals.
    Found {
        /// The numbers.
        values: Vec<String>,
        /// Evaluations, where they are counted.
        evaluations: Option<u64>,
        /// The time, if it was asked for.
        time: Option<Time>,
    },
    /// No number, and why.
    Failed(String),
    /// No contestant: the package that is missing.
    Absent(String),
}

/// A line of the script.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Line {
    id: u64,
    values: Vec<String>,
    evaluations: Option<u64>,
    #[serde(flatten)]
    time: Option<Time>,
    failed: Option<String>,
    absent: Option<String>,
}

impl Python {
    /// Starts the script; why not, otherwise.
    pub(super) fn start() -> Result<Python, String> {
        let named = env::var_os("MDR_PYTHON");
        let default = Path::new(DEFAULT).exists().then(|| DEFAULT.into());
        let Some(program) = named.or(default) else {
            return Err("Contestants of other projects: MDR_PYTHON names no interpreter.".to_owned());
        };
        let shown = Path::new(&program).file_name().unwrap_or(&program).to_string_lossy().into_owned();
        Self::run(Command::new(&program)).map_err(|error| format!("Contestants of other projects: {shown}: {error}."))
    }

    fn run(mut program: Command) -> Result<Python, String> {
        let mut child = program
            .args(["-c", SCRIPT])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|error| error.to_string())?;
        let (Some(questions), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err("there are no pipes to it".to_owned());
        };
        let mut python =
            Python { child, questions, answers: BufReader::new(output).lines(), versions: Map::new(), asked: 0 };
        let mut first: Map<String, Value> = serde_json::from_str(&python.line()?).map_err(|error| error.to_string())?;
        if let Some(Value::Object(versions)) = first.remove("versions") {
            python.versions = versions;
        }
        Ok(python)
    }

    fn line(&mut self) -> Result<String, String> {
        match self.answers.next() {
            Some(Ok(line)) => Ok(line),
            Some(Err(error)) => Err(error.to_string()),
            None => Err("it ended without an answer".to_owned()),
        }
    }

    /// "name version" of a package.
    pub(super) fn package(&self, name: &str) -> String {
        match self.versions.get(name).and_then(Value::as_str) {
            Some(version) => format!("{name} {version}"),
            None => name.to_owned(),
        }
    }

    /// Puts one question and waits for its answer.
    pub(super) fn ask(&mut self, mut question: Map<String, Value>, clock: &Clock) -> Reply {
        self.asked += 1;
        let runs = match clock {
            Clock::Off => 0,
            Clock::Runs(runs) => *runs,
        };
        question.insert("id".to_owned(), json!(self.asked));
        question.insert("runs".to_owned(), json!(runs));
        let answer = writeln!(self.questions, "{}", Value::Object(question))
            .and_then(|()| self.questions.flush())
            .map_err(|error| error.to_string())
            .and_then(|()| self.line())
            .and_then(|line| serde_json::from_str::<Line>(&line).map_err(|error| error.to_string()));
        match answer {
            Err(error) => Reply::Failed(error),
            Ok(Line { id, .. }) if id != self.asked => Reply::Failed("the answer to another question".to_owned()),
            Ok(Line { absent: Some(package), .. }) => Reply::Absent(package),
            Ok(Line { failed: Some(reason), .. }) => Reply::Failed(reason),
            Ok(Line { values, evaluations, time, .. }) => Reply::Found { values, evaluations, time },
        }
    }
}

impl Drop for Python {
    fn drop(&mut self) {
        // Without a question to wait for it would end by itself; not while it computes.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A contestant of another project, and what it is asked: questions by growing effort, each with its setting.
pub(super) struct Outsider {
    /// The name of the method.
    pub(super) name: &'static str,
    /// The package as it is called where packages are had.
    pub(super) package: &'static str,
    /// Its arithmetic.
    pub(super) arithmetic: Arithmetic,
    /// The settings and the questions.
    pub(super) questions: Vec<(String, Map<String, Value>)>,
}

/// The contestants of other projects as far as they are there. They take part only where times are taken: their errors
/// are theirs, and no baseline depends on what is installed.
pub(super) struct Outsiders<'a> {
    python: Option<Result<Python, String>>,
    clock: &'a Clock,
}

impl<'a> Outsiders<'a> {
    /// Starts the script where the clock runs.
    pub(super) fn new(clock: &'a Clock) -> Self {
        Outsiders { python: (*clock != Clock::Off).then(Python::start), clock }
    }

    /// The running script; why there is none, if that is worth a word.
    pub(super) fn python(&mut self) -> Result<&mut Python, Option<String>> {
        match &mut self.python {
            None => Err(None),
            Some(Err(reason)) => Err(Some(reason.clone())),
            Some(Ok(python)) => Ok(python),
        }
    }

    /// The curves of those who are there, and a sentence for each who is not. The worst of several numbers counts.
    pub(super) fn curves(&mut self, outsiders: Vec<Outsider>, truths: &[Interval]) -> (Vec<Curve>, Vec<String>) {
        let clock = self.clock;
        let python = match self.python() {
            Ok(python) => python,
            Err(reason) => return (Vec::new(), reason.into_iter().collect()),
        };
        let (mut curves, mut omissions) = (Vec::new(), Vec::new());
        for outsider in outsiders {
            match curve(python, outsider, truths, clock) {
                Ok(curve) => curves.push(curve),
                Err(reason) => omissions.push(reason),
            }
        }
        (curves, omissions)
    }
}

fn curve(python: &mut Python, outsider: Outsider, truths: &[Interval], clock: &Clock) -> Result<Curve, String> {
    let Outsider { name, package, arithmetic, questions } = outsider;
    let mut points: Vec<Point> = Vec::new();
    for (setting, question) in questions {
        let (outcome, evaluations, time) = match python.ask(question, clock) {
            Reply::Absent(package) => return Err(format!("{name}: the package {package} is not installed.")),
            Reply::Failed(reason) => (Outcome::Failed(reason), None, None),
            Reply::Found { values, evaluations, time } => (judged(&values, truths, arithmetic), evaluations, time),
        };
        points.push(Point { setting, outcome, evaluations, time });
    }
    Ok(Curve { contestant: format!("{name} ({})", python.package(package)), arithmetic, outside: true, points })
}

/// The worst of several numbers in decimals.
pub(super) fn judged(values: &[String], truths: &[Interval], arithmetic: Arithmetic) -> Outcome {
    if values.len() != truths.len() {
        return Outcome::Failed(format!("{} numbers instead of {}", values.len(), truths.len()));
    }
    let judge = |(value, truth): (&String, &Interval)| match (arithmetic, value.parse::<f64>(), Float::parse(value)) {
        (Arithmetic::Double, Ok(value), _) => Outcome::of(&value, truth),
        (_, _, Ok(value)) => Outcome::of(&Float::with_val(truth.lower().prec(), value), truth),
        _ => Outcome::Failed(format!("not a number: {value}")),
    };
    Outcome::worst(values.iter().zip(truths).map(judge))
}

/// An object with these fields.
macro_rules! question {
    ($($key:literal: $value:expr),* $(,)?) => {{
        let mut fields = serde_json::Map::new();
        $(fields.insert($key.to_owned(), serde_json::json!($value));)*
        fields
    }};
}
pub(super) use question;

#[cfg(test)]
mod tests {
    use super::*;
    use mdr_core::number::{Precision, Real};

    /// The interpreter without packages is enough to talk; where there is none there is nothing to test.
    fn plain() -> Option<Python> {
        let mut program = Command::new("python3");
        program.arg("-S");
        Python::run(program).ok()
    }

    #[test]
    fn missing_packages_are_told_and_nonsense_is_answered() {
        let Some(mut python) = plain() else { return };
        assert!(python.package("python").starts_with("python 3"));
        let kappa = |by: &str| question! { "ask": "kappa", "by": by, "n": "3/10", "digits": 50 };
        assert_eq!(python.ask(kappa("arb"), &Clock::Off), Reply::Absent("python-flint".to_owned()));
        assert!(matches!(python.ask(question! { "ask": "weather" }, &Clock::Off), Reply::Failed(_)));
        assert_eq!(python.ask(kappa("mpmath"), &Clock::Off), Reply::Absent("mpmath".to_owned()));
        let arb = Outsider {
            name: "Arb",
            package: "python-flint",
            arithmetic: Arithmetic::Certified,
            questions: vec![(String::new(), kappa("arb"))],
        };
        let curve = curve(&mut python, arb, &[], &Clock::Off);
        assert_eq!(curve, Err("Arb: the package python-flint is not installed.".to_owned()));
    }

    #[test]
    fn what_cannot_be_started_is_told() {
        assert!(Python::run(Command::new("/nowhere/python")).is_err());
    }

    #[test]
    fn an_answer_with_a_time_is_read() {
        let line = r#"{"id": 3, "values": ["1.5", "2"], "evaluations": 7, "median": 2e-6, "least": 1e-6, "most": 3e-6, "runs": 5}"#;
        let line: Line = serde_json::from_str(line).unwrap();
        assert_eq!((line.id, line.evaluations, line.time.map(|time| time.runs)), (3, Some(7), Some(5)));
        let line: Line = serde_json::from_str(r#"{"id": 4, "values": ["1"]}"#).unwrap();
        assert_eq!((line.time, line.failed), (None, None));
    }

    #[test]
    fn numbers_are_judged_as_what_they_are() {
        let third = Interval::from_int(Precision::new(300), 1).over(3);
        let judge =
            |text: &str, arithmetic| judged(&[text.to_owned()], std::slice::from_ref(&third), arithmetic).digits();
        assert!(judge("0.3333333333333333", Arithmetic::Double).is_some_and(|digits| digits > 15.9));
        assert!(judge("0.3333333333333333", Arithmetic::Mp).is_some_and(|digits| (digits - 16.0).abs() < 0.1));
        assert_eq!(judge("nan", Arithmetic::Mp), None);
        assert_eq!(judged(&[], std::slice::from_ref(&third), Arithmetic::Mp).digits(), None);
    }
}
