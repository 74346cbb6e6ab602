//! A critical state as rows of a table.

use super::CriticalAnswer;
use crate::Validity;
use crate::answer::{FlatRow, Fold, NumberStyle, Value, columns, find};

/// A row of the table of critical states: the text below each of [`CriticalRow::COLUMNS`], empty where there is nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CriticalRow(pub [String; 24]);

/// Each column with the text below it, for an answer and one of its states.
macro_rules! columns {
    ($answer:ident, $state:ident, $fold:ident: $($title:literal = $text:expr,)*) => {
        impl CriticalRow {
            /// The titles, which are keys of the JSON as well.
            pub const COLUMNS: [&str; 24] = [$($title),*];

            fn of($answer: &CriticalAnswer, $state: Option<&Fold>, $fold: Option<&Fold>) -> Self {
                CriticalRow([$($text),*])
            }
        }
    };
}

columns! { answer, state, fold:
    "arithmetic" = answer.arithmetic.promise().name().to_owned(),
    "digits" = known(answer.arithmetic.digits()),
    "control" = answer.law.control.kind().name().to_owned(),
    "regime" = answer.regime.to_string(),
    "n" = answer.inputs.n.to_string(),
    "c" = answer.inputs.c.to_string(),
    "e1" = text(answer.inputs.bodies.as_ref().map(|bodies| &bodies[0][0])),
    "nu1" = text(answer.inputs.bodies.as_ref().map(|bodies| &bodies[0][1])),
    "e2" = text(answer.inputs.bodies.as_ref().map(|bodies| &bodies[1][0])),
    "nu2" = text(answer.inputs.bodies.as_ref().map(|bodies| &bodies[1][1])),
    "e_star" = answer.inputs.e_star.to_string(),
    "work" = answer.inputs.work.to_string(),
    "stiffness" = text(answer.inputs.stiffness.as_ref()),
    "kappa" = answer.kappa.to_string(),
    "status" = fold.map_or(answer.status, |fold| fold.status()).to_string(),
    "contact_radius" = text(state.map(|state| &state.contact_radius)),
    "indentation" = text(state.map(|state| &state.indentation)),
    "force" = text(state.map(|state| &state.force)),
    "log10_contact_radius" = known(state.and_then(|state| state.contact_radius.log10())),
    "log10_indentation" = known(state.and_then(|state| state.indentation.log10())),
    "log10_force" = known(state.and_then(|state| state.force.log10())),
    "kind" = known(fold.map(|fold| fold.kind)),
    "threshold_c" = text(answer.threshold.as_ref().map(|threshold| &threshold.c)),
    "ratio" = text(answer.threshold.as_ref().map(|threshold| &threshold.ratio)),
}

/// A number that may be out of range.
fn text(value: Option<&Value>) -> String {
    known(value.filter(|value| !matches!(value, Value::Unknown { .. })))
}

fn known(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

impl CriticalRow {
    /// The text below a title.
    pub fn get(&self, title: &str) -> Option<&str> {
        let column = Self::COLUMNS.iter().position(|known| *known == title)?;
        Some(&self.0[column])
    }
}

impl AsRef<[String]> for CriticalRow {
    fn as_ref(&self) -> &[String] {
        &self.0
    }
}

impl CriticalAnswer {
    /// A row for the critical state, or for each fold on a machine.
    ///
    /// ```
    /// use mdr::critical::{PowerLaw, critical};
    /// use mdr::prelude::*;
    /// let law = PowerLaw::from_keys(|key| match key {
    ///     "n" => Some("2"),
    ///     "c" | "e_star" | "work" => Some("1"),
    ///     _ => None,
    /// })?;
    /// let rows = critical(&law, Arithmetic::F64)?.rows();
    /// assert_eq!((rows.len(), rows[0].get("control"), rows[0].get("status")), (1, Some("indentation"), Some("ok")));
    /// # Ok::<(), mdr::Error>(())
    /// ```
    pub fn rows(&self) -> Vec<CriticalRow> {
        match self.folds.as_deref() {
            Some(folds) if !folds.is_empty() => {
                folds.iter().map(|fold| CriticalRow::of(self, Some(fold), Some(fold))).collect()
            }
            _ => vec![CriticalRow::of(self, self.state.as_ref(), None)],
        }
    }
}

/// One table for several answers, the titles first: [`CriticalRow::COLUMNS`], then the keys of [`Validity`](crate::Validity) with
/// the prefix `validity_`, if an answer has one.
pub fn spreadsheet(answers: &[CriticalAnswer]) -> Vec<Vec<String>> {
    let validity = |answer: &CriticalAnswer| answer.validity.as_ref().map(|validity| validity.table());
    let tables: Vec<FlatRow> = answers.iter().filter_map(validity).collect();
    let keys = if tables.is_empty() { Vec::new() } else { columns(&tables) };
    let header =
        CriticalRow::COLUMNS.map(str::to_owned).into_iter().chain(keys.iter().map(|key| format!("validity_{key}")));
    let rows = answers.iter().flat_map(|answer| {
        let cells = validity(answer).unwrap_or_default();
        let added = keys.iter().map(|key| find(&cells, key).map_or_else(String::new, ToString::to_string));
        let added: Vec<String> = added.collect();
        answer.rows().into_iter().map(move |row| row.0.into_iter().chain(added.clone()).collect())
    });
    std::iter::once(header.collect()).chain(rows).collect()
}

/// The columns of [`overview`]: key, title, unit, and whether it is a number.
const OVERVIEW: [(&str, &str, &str, bool); 9] = [
    ("n", "n", "", false),
    ("kappa", "kappa_n", "", true),
    ("contact_radius", "contact radius", "m", true),
    ("indentation", "indentation", "m", true),
    ("force", "force", "N", true),
    ("threshold_c", "threshold of C", "m^(1/2)", true),
    ("ratio", "C / threshold", "", true),
    ("kind", "fold", "", false),
    ("status", "status", "", false),
];

/// The columns of [`OVERVIEW`] that only n = 1/2 has.
const OF_HALF: [&str; 2] = ["threshold_c", "ratio"];

/// The keys of [`Validity`](crate::Validity) that [`overview`] shows, if an answer has one.
const OF_VALIDITY: [&str; 3] = ["tabor", "regime", "maugis_dugdale_pull_off"];

/// The main columns of [`spreadsheet`] for a reader, in the units of `style`; the titles first.
pub fn overview(answers: &[CriticalAnswer], style: &NumberStyle) -> Vec<Vec<String>> {
    let asked = answers.iter().any(|answer| answer.validity.is_some());
    let added = if asked { &OF_VALIDITY[..] } else { &[] };
    let scale_free = answers.iter().any(|answer| answer.threshold.is_some());
    let shown: Vec<_> = OVERVIEW.iter().filter(|(key, ..)| scale_free || !OF_HALF.contains(key)).collect();
    let own = shown.iter().map(|(_, name, unit, _)| (*name, *unit));
    let titles = own.chain(added.iter().map(|key| Validity::title(key)));
    let mut table = vec![titles.map(|(name, unit)| style.titled(name, unit)).collect()];
    for answer in answers {
        let validity = answer.validity.as_ref().map(|validity| validity.table()).unwrap_or_default();
        let added = added.iter().map(|key| find(&validity, key).map(|cell| style.cell(cell, Validity::title(key).1)));
        let added: Vec<String> = added.map(Option::unwrap_or_default).collect();
        for row in answer.rows() {
            let own = shown.iter().map(|(key, _, unit, is_number)| {
                let text = row.get(key).unwrap_or_default();
                if *is_number { style.number(text, unit) } else { text.to_owned() }
            });
            table.push(own.chain(added.iter().cloned()).collect());
        }
    }
    table
}
