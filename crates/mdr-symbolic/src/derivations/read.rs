//! Reads the entries from `data/derivations.txt`, whose format is described at its head.
//!
//! The entries live as long as the program, as if they stood in the source.

use super::{Claim, Entry, Erratum, Step};
use crate::domain::Domain;

/// An entry and the lists that are not complete yet.
#[derive(Default)]
struct Draft {
    entry: Entry,
    assumptions: Vec<&'static str>,
    steps: Vec<Step>,
    references: Vec<&'static str>,
}

impl Draft {
    fn finish(self) -> Entry {
        let Draft { entry, assumptions, steps, references } = self;
        Entry { assumptions: assumptions.leak(), steps: steps.leak(), references: references.leak(), ..entry }
    }

    /// Takes in a field; `None` if it is unknown or not in its place.
    fn take(&mut self, keyword: &str, detail: &str, text: &'static str) -> Option<()> {
        let step = |claim, domains, statement, why| Step { claim, domains, statement, point: &[], why };
        match (keyword, detail) {
            ("title", "") => self.entry.title = text,
            ("printed", "") => self.entry.refuted = text == "refuted",
            ("assume", "") => self.assumptions.push(text),
            ("cited", "") => self.steps.push(step(Claim::Cited, &[], None, text)),
            ("proved", domain) => self.steps.push(step(Claim::Proved, domains(domain)?, Some(text), "")),
            ("enclosed", domain) => self.steps.push(step(Claim::Enclosed, domains(domain)?, Some(text), "")),
            ("refuted", domain) => self.steps.push(step(Claim::Refuted, domains(domain)?, Some(text), "")),
            // Names and values: `n = 2, E = 1`.
            ("at", "") => {
                let values = text.split(", ").map(|pair| pair.split_once(" = "));
                self.steps.last_mut()?.point = values.collect::<Option<Vec<_>>>()?.leak();
            }
            ("why", "") => self.steps.last_mut()?.why = text,
            ("erratum", steps) => {
                let shown_by = steps.split(' ').map(|step| step.parse::<usize>().ok()?.checked_sub(1));
                self.entry.erratum = Some(Erratum { text, shown_by: shown_by.collect::<Option<Vec<_>>>()?.leak() });
            }
            ("reference", "") => self.references.push(text),
            _ => return None,
        }
        Some(())
    }
}

/// The entries of a text.
///
/// # Errors
/// The line that cannot be read.
pub(super) fn read(text: &'static str) -> Result<Vec<Entry>, String> {
    let mut drafts: Vec<Draft> = Vec::new();
    for (head, text) in fields(text)? {
        let (keyword, detail) = head.split_once(' ').unwrap_or((head, ""));
        if keyword == "entry" {
            drafts.push(Draft { entry: Entry { id: text, ..Entry::default() }, ..Draft::default() });
        } else {
            let taken = drafts.last_mut().and_then(|draft| draft.take(keyword, detail, text));
            taken.ok_or_else(|| format!("{head}: {text}"))?;
        }
    }
    Ok(drafts.into_iter().map(Draft::finish).collect())
}

/// The keyword before the colon of each field, and its text on one line.
fn fields(text: &'static str) -> Result<Vec<(&'static str, &'static str)>, String> {
    let mut fields: Vec<(&str, String)> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        match (line.strip_prefix("    "), fields.last_mut(), line.split_once(": ")) {
            (Some(more), Some((_, text)), _) => *text = format!("{text} {more}"),
            (None, _, Some((head, text))) => fields.push((head, text.to_owned())),
            _ => return Err(line.to_owned()),
        }
    }
    Ok(fields.into_iter().map(|(head, text)| (head, &*text.leak())).collect())
}

fn domains(name: &str) -> Option<&'static [Domain]> {
    Some(match name {
        "positive" => &[Domain::Positive],
        "above" => &[Domain::Above],
        "below" => &[Domain::Below],
        "half" => &[Domain::Half],
        "both" => &[Domain::Above, Domain::Below],
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn a_field_out_of_place_is_refused() {
        for (text, line) in [
            ("title: a\n", "title: a"),
            ("entry: 1\nsubject: a\n", "subject: a"),
            ("entry: 1\nproved never: a = a\n", "proved never: a = a"),
            ("entry: 1\nwhy: a\n", "why: a"),
            ("entry: 1\nproved half: a = a\nat: a\n", "at: a"),
            ("entry: 1\nerratum 0: a\n", "erratum 0: a"),
            ("    a\n", "    a"),
            ("entry\n", "entry"),
        ] {
            assert_eq!(read(text).unwrap_err(), line);
        }
    }

    #[test]
    fn every_entry_is_read() {
        assert_eq!(super::super::ENTRIES.as_ref().map(Vec::len), Ok(42));
    }
}
