//! Contestants of other projects, asked through a script in Python: `python/contestants.py` of this crate.
//!
//! The interpreter is the one that the environment variable `MDR_PYTHON` names, or else `target/python/bin/python`, which
//! `make contestants` sets up. Where there is none, or a package is missing, their curves are absent and that is said.
//! Times are taken inside Python, so its start and the conversation are not in them; errors are judged here. One process
//! answers all questions of a report. An answer that takes too long is given up and its process ended; the next question
//! starts another.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use mdr_core::number::Interval;
use rug::Float;
use serde::Deserialize;
use serde_json::{Map, Value, json};

use super::{Arithmetic, Clock, Curve, Effort, Outcome, Point, Time};

/// The script, so that a program finds it wherever it runs.
const SCRIPT: &str = include_str!("../../python/contestants.py");

/// Where `make contestants` puts the packages.
const DEFAULT: &str = "target/python/bin/python";

/// Packages are found and loaded in this time, or not at all.
const START: Duration = Duration::from_secs(60);

/// A running script. It ends with its owner.
struct Python {
    child: Child,
    questions: ChildStdin,
    /// Its lines, read by a thread so that waiting for them can end.
    answers: Receiver<std::io::Result<String>>,
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
    /// It was not waited for any longer, or not asked at all.
    Stopped(String),
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
    fn start() -> Result<Python, String> {
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
        let (sender, answers) = channel();
        // Ends with the pipe, or with whoever listens.
        std::thread::spawn(move || BufReader::new(output).lines().try_for_each(|line| sender.send(line)));
        let mut python = Python { child, questions, answers, versions: Map::new(), asked: 0 };
        let line = python.line(START).ok_or("it did not begin in time")??;
        let mut first: Map<String, Value> = serde_json::from_str(&line).map_err(|error| error.to_string())?;
        if let Some(Value::Object(versions)) = first.remove("versions") {
            python.versions = versions;
        }
        Ok(python)
    }

    /// The next line; none where it does not come in time.
    fn line(&self, limit: Duration) -> Option<Result<String, String>> {
        match self.answers.recv_timeout(limit) {
            Ok(line) => Some(line.map_err(|error| error.to_string())),
            Err(RecvTimeoutError::Disconnected) => Some(Err("it ended without an answer".to_owned())),
            Err(RecvTimeoutError::Timeout) => None,
        }
    }

    /// "name version" of a package.
    fn package(&self, name: &str) -> String {
        match self.versions.get(name).and_then(Value::as_str) {
            Some(version) => format!("{name} {version}"),
            None => name.to_owned(),
        }
    }

    /// Puts one question and waits for its answer; none where it does not come in time.
    fn ask(&mut self, mut question: Map<String, Value>, clock: &Clock, limit: Duration) -> Option<Reply> {
        self.asked += 1;
        let runs = match clock {
            Clock::Off => 0,
            Clock::Runs(runs) => *runs,
        };
        question.insert("id".to_owned(), json!(self.asked));
        question.insert("runs".to_owned(), json!(runs));
        question.insert("limit".to_owned(), json!(limit.as_secs_f64()));
        let sent = writeln!(self.questions, "{}", Value::Object(question)).and_then(|()| self.questions.flush());
        let line = match sent {
            Ok(()) => self.line(limit)?,
            Err(error) => Err(error.to_string()),
        };
        let line = line.and_then(|line| serde_json::from_str::<Line>(&line).map_err(|error| error.to_string()));
        Some(match line {
            Err(error) => Reply::Failed(error),
            Ok(Line { id, .. }) if id != self.asked => Reply::Failed("the answer to another question".to_owned()),
            Ok(Line { absent: Some(package), .. }) => Reply::Absent(package),
            Ok(Line { failed: Some(reason), .. }) => Reply::Failed(reason),
            Ok(Line { values, evaluations, time, .. }) => Reply::Found { values, evaluations, time },
        })
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
pub(super) struct Outsiders {
    clock: Clock,
    /// The running script, or why there is none. Nothing before the first question and after one that was given up.
    python: Option<Result<Python, String>>,
    /// How long one answer is waited for.
    patience: Duration,
    /// How long all answers of one task may take.
    allowance: Duration,
    /// What is left of it.
    left: Duration,
}

impl Outsiders {
    pub(super) fn new(effort: Effort, clock: Clock) -> Self {
        let [patience, allowance] = match effort {
            Effort::Quick => [2, 15],
            Effort::Full => [4, 30],
        };
        let [patience, allowance] = [patience, allowance].map(Duration::from_secs);
        Outsiders { clock, python: None, patience, allowance, left: allowance }
    }

    /// All of the time is there again: a new task.
    pub(super) fn begin(&mut self) {
        self.left = self.allowance;
    }

    /// Whether there is somebody to ask; why not, if that is worth a word.
    pub(super) fn present(&mut self) -> Result<(), Option<String>> {
        if self.clock == Clock::Off {
            return Err(None);
        }
        match self.python.get_or_insert_with(Python::start) {
            Ok(_) => Ok(()),
            Err(reason) => Err(Some(reason.clone())),
        }
    }

    /// Puts one question and waits for its answer, but not too long.
    pub(super) fn ask(&mut self, question: Map<String, Value>, clock: &Clock) -> Reply {
        if self.left.is_zero() {
            let seconds = self.allowance.as_secs();
            return Reply::Stopped(format!("not asked: the {seconds} s of other projects in this task were over"));
        }
        let python = match self.python.get_or_insert_with(Python::start) {
            Ok(python) => python,
            Err(reason) => return Reply::Failed(reason.clone()),
        };
        let begin = Instant::now();
        let reply = python.ask(question, clock, self.patience);
        self.left = self.left.saturating_sub(begin.elapsed());
        reply.unwrap_or_else(|| {
            // It still computes.
            self.python = None;
            Reply::Stopped(format!("stopped after {} s", self.patience.as_secs()))
        })
    }

    /// "name version" of a package.
    pub(super) fn package(&mut self, name: &str) -> String {
        match self.python.get_or_insert_with(Python::start) {
            Ok(python) => python.package(name),
            Err(_) => name.to_owned(),
        }
    }

    /// The curves of those who are there, and a sentence for each who is not. The worst of several numbers counts.
    pub(super) fn curves(&mut self, outsiders: Vec<Outsider>, truths: &[Interval]) -> (Vec<Curve>, Vec<String>) {
        if let Err(reason) = self.present() {
            return (Vec::new(), reason.into_iter().collect());
        }
        let (mut curves, mut omissions) = (Vec::new(), Vec::new());
        for outsider in outsiders {
            match self.curve(outsider, truths) {
                Ok(curve) => curves.push(curve),
                Err(reason) => omissions.push(reason),
            }
        }
        (curves, omissions)
    }

    /// By growing effort, up to the first answer that was not waited for.
    fn curve(&mut self, outsider: Outsider, truths: &[Interval]) -> Result<Curve, String> {
        let Outsider { name, package, arithmetic, questions } = outsider;
        let contestant = format!("{name} ({})", self.package(package));
        let clock = self.clock;
        let mut points: Vec<Point> = Vec::new();
        for (setting, question) in questions {
            let (outcome, evaluations, time) = match self.ask(question, &clock) {
                Reply::Absent(package) => return Err(format!("{name}: the package {package} is not installed.")),
                Reply::Failed(reason) => (Outcome::Failed(reason), None, None),
                Reply::Stopped(reason) => (Outcome::Stopped(reason), None, None),
                Reply::Found { values, evaluations, time } => (judged(&values, truths, arithmetic), evaluations, time),
            };
            let stopped = matches!(outcome, Outcome::Stopped(_));
            points.push(Point { setting, outcome, evaluations, time });
            if stopped {
                break;
            }
        }
        Ok(Curve { contestant, arithmetic, outside: true, points })
    }
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
    fn plain() -> Option<Outsiders> {
        let mut program = Command::new("python3");
        program.arg("-S");
        let python = Python::run(program).ok()?;
        Some(Outsiders { python: Some(Ok(python)), ..Outsiders::new(Effort::Quick, Clock::Runs(1)) })
    }

    #[test]
    fn missing_packages_are_told_and_nonsense_is_answered() {
        let Some(mut others) = plain() else { return };
        assert!(others.package("python").starts_with("python 3"));
        let kappa = |by: &str| question! { "ask": "kappa", "by": by, "n": "3/10", "digits": 50 };
        assert_eq!(others.ask(kappa("arb"), &Clock::Off), Reply::Absent("python-flint".to_owned()));
        assert!(matches!(others.ask(question! { "ask": "weather" }, &Clock::Off), Reply::Failed(_)));
        assert_eq!(others.ask(kappa("mpmath"), &Clock::Off), Reply::Absent("mpmath".to_owned()));
        let arb = Outsider {
            name: "Arb",
            package: "python-flint",
            arithmetic: Arithmetic::Certified,
            questions: vec![(String::new(), kappa("arb"))],
        };
        assert_eq!(others.curve(arb, &[]), Err("Arb: the package python-flint is not installed.".to_owned()));
    }

    /// Nobody waits for an answer for ever: the process is ended, and the series with it.
    #[test]
    fn what_takes_too_long_is_stopped() {
        let mut silent = Command::new("sh");
        silent.args(["-c", r#"echo '{"versions": {}}'; exec sleep 600"#]);
        let mut others = Outsiders::new(Effort::Quick, Clock::Runs(1));
        others.python = Some(Python::run(silent));
        others.patience = Duration::from_millis(20);
        let asked = || question! { "ask": "kappa", "by": "arb", "n": "3/10", "digits": 50 };
        let slow = Outsider {
            name: "slow",
            package: "python",
            arithmetic: Arithmetic::Mp,
            questions: vec![("one".to_owned(), asked()), ("two".to_owned(), asked())],
        };
        let curve = others.curve(slow, &[]).unwrap();
        assert_eq!(curve.points.len(), 1);
        assert_eq!(curve.points[0].outcome, Outcome::Stopped("stopped after 0 s".to_owned()));
        assert!(others.python.is_none());
        others.left = Duration::ZERO;
        assert!(matches!(others.ask(asked(), &Clock::Off), Reply::Stopped(reason) if reason.contains("15 s")));
        others.begin();
        assert!(!others.left.is_zero());
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
