//! What a directory of reports holds: one section a task, each with how it was made. A task that is done is written at once,
//! so that a report that is interrupted leaves what it has, and a report on some tasks leaves the others alone.

use std::path::Path;

use mdr_crosscheck::contest::speed::Race;
use mdr_crosscheck::contest::{Diagram, Effort, tasks};
use serde::{Deserialize, Serialize};
use serde_json::{Number, Value};

use super::footer::Machine;
use super::{ladders, speed};
use crate::error::{Failure, Result};

/// The name and the version of the format.
pub(super) const SCHEMA: &str = "mdr.report/2";

/// The file that has everything.
const FILE: &str = "report.json";

/// All that is known in a directory.
#[derive(Serialize, Deserialize)]
pub(super) struct Findings {
    pub(super) schema: String,
    /// Tasks of the last report that were not done when this was written.
    pub(super) unfinished: Vec<String>,
    /// In the order of the page.
    pub(super) tasks: Vec<Section>,
}

/// One task.
#[derive(Serialize, Deserialize)]
pub(super) struct Section {
    pub(super) name: String,
    /// What it is about.
    pub(super) claim: String,
    pub(super) made: Made,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) diagrams: Vec<Diagram>,
    /// This workspace beside other projects.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) races: Vec<Race>,
    /// Who could not race, and why.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) absent: Vec<String>,
    /// Of the stability ladders the numbers; all rungs are in files of their own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) ladders: Option<ladders::Summary>,
}

/// How a section was made.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Made {
    /// How it was asked for.
    pub(super) command: String,
    pub(super) effort: Effort,
    /// Timed runs of every answer, where they are not too long.
    pub(super) runs: usize,
    pub(super) machine: Machine,
}

impl Section {
    /// A task of which nothing is done.
    pub(super) fn new(name: &str, made: Made) -> Self {
        let task = tasks().iter().find(|task| task.name == name).map(|task| task.claim);
        let claim = task.unwrap_or(if name == ladders::NAME { ladders::CLAIM } else { speed::CLAIM });
        let (diagrams, races, absent) = (Vec::new(), Vec::new(), Vec::new());
        Section { name: name.to_owned(), claim: claim.to_owned(), made, diagrams, races, absent, ladders: None }
    }
}

impl Findings {
    /// What an earlier report left in the directory; nothing where there was none.
    ///
    /// # Errors
    /// For a file that cannot be read as one of this format.
    pub(super) fn load(directory: &Path) -> Result<Self> {
        let path = directory.join(FILE);
        let failed = |error| Failure::file(path.display().to_string(), error);
        let text = match std::fs::read_to_string(&path) {
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Self::default()),
            text => text.map_err(failed)?,
        };
        let other = |what: String| {
            failed(std::io::Error::other(format!("{what}: no {SCHEMA}; remove the file, or choose another --out")))
        };
        let findings: Findings = serde_json::from_str(&text).map_err(|error| other(error.to_string()))?;
        if findings.schema == SCHEMA { Ok(findings) } else { Err(other(findings.schema)) }
    }

    /// Puts the section in the place of an earlier one, in this order of names.
    pub(super) fn put(&mut self, section: Section, order: &[&str]) {
        self.unfinished.retain(|name| *name != section.name);
        self.tasks.retain(|earlier| earlier.name != section.name);
        self.tasks.push(section);
        self.tasks.sort_by_key(|section| order.iter().position(|name| *name == section.name));
    }

    pub(super) fn save(&self, directory: &Path) -> Result<()> {
        let failed = |error: serde_json::Error| Failure::file(FILE, std::io::Error::other(error));
        let mut value = serde_json::to_value(self).map_err(failed)?;
        round(&mut value);
        super::write(directory, FILE, format!("{value}\n"))
    }
}

impl Default for Findings {
    fn default() -> Self {
        Findings { schema: SCHEMA.to_owned(), unfinished: Vec::new(), tasks: Vec::new() }
    }
}

/// Four digits of times and of digits say all that there is to say.
fn round(value: &mut Value) {
    match value {
        Value::Array(values) => values.iter_mut().for_each(round),
        Value::Object(fields) => fields.values_mut().for_each(round),
        Value::Number(number) if number.is_f64() => {
            let rounded = number.as_f64().and_then(|number| format!("{number:.3e}").parse().ok());
            if let Some(rounded) = rounded.and_then(Number::from_f64) {
                *number = rounded;
            }
        }
        _ => {}
    }
}

#[cfg(test)]
pub(super) mod tests {
    use mdr_crosscheck::contest::View;

    use super::super::diagram::tests::contest;
    use super::*;

    pub(in super::super) fn section(name: &str) -> Section {
        let made =
            Made { command: "mdr report --quick".to_owned(), effort: Effort::Quick, runs: 3, machine: Machine::here() };
        let diagrams = vec![contest(View::Error), contest(View::Size)];
        Section { claim: "what is tested".to_owned(), diagrams, ..Section::new(name, made) }
    }

    fn directory(name: &str) -> std::path::PathBuf {
        let path = std::env::temp_dir().join(format!("mdr-report-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        path
    }

    #[test]
    fn a_section_is_replaced_and_the_others_are_kept() {
        let path = directory("kept");
        let mut findings = Findings::load(&path).unwrap();
        findings.unfinished = vec!["one".to_owned(), "three".to_owned()];
        for name in ["three", "one"] {
            findings.put(section(name), &["one", "two", "three"]);
        }
        findings.save(&path).unwrap();
        let mut again = Findings::load(&path).unwrap();
        assert!(again.unfinished.is_empty());
        let newer = Section { claim: "newer".to_owned(), ..section("one") };
        again.put(newer, &["one", "two", "three"]);
        let told: Vec<_> = again.tasks.iter().map(|section| (&*section.name, &*section.claim)).collect();
        assert_eq!(told, [("one", "newer"), ("three", "what is tested")]);
        // All but the last digits of times.
        let reached = |findings: &Findings| {
            let curves = findings.tasks.iter().flat_map(|section| &section.diagrams[0].curves);
            curves.flat_map(|curve| curve.points.iter().map(|point| point.outcome.clone())).collect::<Vec<_>>()
        };
        assert_eq!(reached(&again), reached(&findings));
        std::fs::remove_dir_all(path).unwrap();
    }

    /// Nothing that is not understood is overwritten.
    #[test]
    fn another_format_is_refused() {
        let path = directory("other");
        for text in ["{}", "", r#"{"schema":"mdr.report/1","unfinished":[],"tasks":[]}"#] {
            std::fs::write(path.join(FILE), text).unwrap();
            assert!(Findings::load(&path).is_err(), "{text}");
        }
        std::fs::remove_dir_all(path).unwrap();
    }

    #[test]
    fn four_digits() {
        let mut value = serde_json::json!({"a": [1.234_567e-8, 3], "b": "0.123456"});
        round(&mut value);
        assert_eq!(value, serde_json::json!({"a": [1.235e-8, 3], "b": "0.123456"}));
    }
}
