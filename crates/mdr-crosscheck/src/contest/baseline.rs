//! What the quick contest reached when somebody last looked: right digits and evaluations, which are the same in every run.
//! A change that loses digits or needs more evaluations is caught; times are not looked at.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};

use super::{Clock, Diagram, Effort, Outcome, Setup, tasks};

/// Digits that may be lost: elementary functions differ between systems in the last bit, and the luck of roundings with them.
const SLACK: f64 = 0.5;

/// Evaluations that may be added, as a share.
const GROWTH: f64 = 0.1;

/// What was reached, by diagram, contestant and setting. Contestants from outside are not in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Baseline(BTreeMap<[String; 3], Reached>);

/// One line of a baseline.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Line {
    diagram: String,
    contestant: String,
    setting: String,
    #[serde(flatten)]
    reached: Reached,
}

/// What one setting reached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Reached {
    /// Right digits, rounded down to tenths; none for a failure.
    digits: Option<f64>,
    evaluations: Option<u64>,
}

/// What is worse than in the baseline, or not in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Regression {
    at: [String; 3],
    what: String,
}

impl fmt::Display for Regression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [diagram, contestant, setting] = &self.at;
        write!(f, "{diagram}, {contestant}, {setting}: {}", self.what)
    }
}

impl Baseline {
    /// How many settings there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Of the quick contest, now.
    pub fn now() -> Self {
        let mut setup = Setup::new(Effort::Quick, Clock::Off);
        let diagrams: Vec<_> = tasks().iter().flat_map(|task| task.diagrams(&mut setup)).collect();
        Self::of(&diagrams)
    }

    /// Of these diagrams.
    pub fn of(diagrams: &[Diagram]) -> Self {
        let mut reached = BTreeMap::new();
        for diagram in diagrams {
            for curve in diagram.curves.iter().filter(|curve| !curve.outside) {
                for point in &curve.points {
                    let key = [diagram.id.clone(), curve.contestant.clone(), point.setting.clone()];
                    let digits = match point.outcome {
                        Outcome::Passed => Some(0.0),
                        _ => point.outcome.digits().map(|digits| (10.0 * digits).floor() / 10.0),
                    };
                    reached.insert(key, Reached { digits, evaluations: point.evaluations });
                }
            }
        }
        Baseline(reached)
    }

    /// One line of JSON for each setting.
    ///
    /// # Errors
    /// None that is known: texts and numbers are JSON.
    pub fn to_json_lines(&self) -> serde_json::Result<String> {
        let mut text = String::new();
        for (key, reached) in &self.0 {
            let [diagram, contestant, setting] = key.clone();
            text += &serde_json::to_string(&Line { diagram, contestant, setting, reached: *reached })?;
            text.push('\n');
        }
        Ok(text)
    }

    /// Reads what [`to_json_lines`](Self::to_json_lines) wrote.
    ///
    /// # Errors
    /// For a line that is none of them.
    pub fn from_json_lines(text: &str) -> serde_json::Result<Self> {
        let lines = text.lines().filter(|line| !line.trim().is_empty()).map(serde_json::from_str);
        lines
            .map(|line| {
                line.map(|Line { diagram, contestant, setting, reached }| ([diagram, contestant, setting], reached))
            })
            .collect::<serde_json::Result<_>>()
            .map(Baseline)
    }

    /// Where `now` is worse than this: more than half a digit lost, more than a tenth of the evaluations added, an answer
    /// become a failure or gone; and what this baseline does not know yet.
    pub fn regressions(&self, now: &Baseline) -> Vec<Regression> {
        let mut found = Vec::new();
        let mut complain = |at: &[String; 3], what: String| found.push(Regression { at: at.clone(), what });
        for (key, old) in &self.0 {
            let Some(new) = now.0.get(key) else {
                complain(key, "is gone".to_owned());
                continue;
            };
            match (old.digits, new.digits) {
                (Some(old), Some(new)) if new < old - SLACK => complain(key, format!("{new} digits, were {old}")),
                (Some(old), None) => complain(key, format!("fails, had {old} digits")),
                _ => {}
            }
            match (old.evaluations, new.evaluations) {
                (Some(old), Some(new)) if new as f64 > (1.0 + GROWTH) * old as f64 => {
                    complain(key, format!("{new} evaluations, were {old}"));
                }
                (Some(old), None) if new.digits.is_some() => complain(key, format!("no count, was {old}")),
                _ => {}
            }
        }
        for key in now.0.keys().filter(|key| !self.0.contains_key(*key)) {
            complain(key, "is not in the baseline".to_owned());
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn baseline(entries: &[(&str, Option<f64>, Option<u64>)]) -> Baseline {
        let entry = |&(setting, digits, evaluations): &(&str, _, _)| {
            (["d".to_owned(), "c".to_owned(), setting.to_owned()], Reached { digits, evaluations })
        };
        Baseline(entries.iter().map(entry).collect())
    }

    fn complaints(old: &Baseline, new: &Baseline) -> Vec<String> {
        old.regressions(new).iter().map(|regression| regression.what.clone()).collect()
    }

    #[test]
    fn what_is_worse_is_found() {
        let old = baseline(&[("one", Some(10.0), Some(100)), ("two", None, None)]);
        assert!(old.regressions(&old).is_empty());
        for (digits, count, complaint) in [
            (Some(9.5), 110, None),
            (Some(16.0), 1, None),
            (Some(9.4), 100, Some("9.4 digits, were 10")),
            (Some(10.0), 111, Some("111 evaluations, were 100")),
            (None, 100, Some("fails, had 10 digits")),
        ] {
            let new = baseline(&[("one", digits, Some(count)), ("two", None, None)]);
            assert_eq!(complaints(&old, &new), complaint.into_iter().collect::<Vec<_>>());
        }
        let new = baseline(&[("two", Some(3.0), Some(7)), ("three", None, None)]);
        assert_eq!(complaints(&old, &new), ["is gone", "is not in the baseline"]);
        let uncounted = baseline(&[("one", Some(10.0), None), ("two", None, None)]);
        assert_eq!(complaints(&old, &uncounted), ["no count, was 100"]);
    }

    #[test]
    fn lines_are_read_again() {
        let old = baseline(&[("one", Some(10.1), Some(100)), ("two", None, None)]);
        let text = old.to_json_lines().unwrap();
        assert_eq!(
            text.lines().next(),
            Some(r#"{"diagram":"d","contestant":"c","setting":"one","digits":10.1,"evaluations":100}"#)
        );
        assert_eq!(Baseline::from_json_lines(&text).unwrap(), old);
        assert!(Baseline::from_json_lines("{}").is_err());
    }
}
