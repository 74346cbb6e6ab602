//! An answer in words, beside its tables: reasons, sums, promises, and completeness.

use std::borrow::Cow;

use mdr_core::contact::Status;

use super::{Completeness, NumberStyle, Output, Row};

/// Reasons that belong to one output.
const MOST_REASONS: usize = 5;

impl Output {
    /// How far the list can be trusted, behind its name in a heading: its promise, and "undecided" where it is not decided whether
    /// anything is missing. A list without a state promises nothing then.
    pub fn standing(&self) -> Cow<'static, str> {
        let promise = self.promise().name();
        let is_open = |row: &Row<'_>| row.status() == Status::Undecided;
        match self.complete() {
            Some(complete) if complete.undecided && self.rows().iter().all(is_open) => Cow::Borrowed("undecided"),
            Some(complete) if complete.undecided => Cow::Owned(format!("{promise}; undecided whether all")),
            _ => Cow::Borrowed(promise),
        }
    }

    /// All that belongs below its table, a paragraph each: why numbers are missing, its [sentences](Output::sentences),
    /// numbers with a promise of their own, and whether the list is complete.
    pub fn remarks(&self, style: &NumberStyle) -> Vec<String> {
        let reasons = self.reasons();
        let mut remarks: Vec<String> =
            reasons.iter().take(MOST_REASONS).map(|(status, why)| format!("{status}: {why}.")).collect();
        if reasons.len() > MOST_REASONS {
            remarks.push(format!("and {} more reasons.", reasons.len() - MOST_REASONS));
        }
        remarks.extend(self.sentences(style));
        let exceptions = self.exceptions();
        if let Some((_, promise)) = exceptions.first() {
            let fields: Vec<&str> = exceptions.iter().map(|(field, _)| *field).collect();
            remarks.push(format!("With the promise {}: {}.", promise.name(), fields.join(", ")));
        }
        remarks.extend(self.complete().map(Completeness::sentence));
        remarks
    }
}

impl Completeness {
    /// Whether the list is complete, where, and why, in a sentence.
    pub fn sentence(&self) -> String {
        let range = match (&self.from, &self.to) {
            (Some(from), Some(to)) => format!(" for contact radii from {from} to {to} m"),
            (Some(_), None) => " for all contact radii".to_owned(),
            _ => String::new(),
        };
        let proved = if self.proved { "Proved complete" } else { "Not proved complete" };
        format!("{proved}{range}: {}.", self.why)
    }
}
