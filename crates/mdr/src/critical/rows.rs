//! A critical state as rows of a table.

use super::{CriticalAnswer, CriticalFold, CriticalState};
use crate::answer::{FlatRow, NumberStyle, Value, columns, find, title};

/// A row of the table of critical states: what stands below each of [`CriticalRow::COLUMNS`], empty where there is nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CriticalRow(pub [String; 24]);

impl CriticalRow {
    /// The titles, which are keys of the JSON as well.
    pub const COLUMNS: [&str; 24] = [
        "arithmetic",
        "digits",
        "control",
        "regime",
        "n",
        "c",
        "e1",
        "nu1",
        "e2",
        "nu2",
        "e_star",
        "work",
        "stiffness",
        "kappa",
        "status",
        "contact_radius",
        "indentation",
        "force",
        "log10_contact_radius",
        "log10_indentation",
        "log10_force",
        "kind",
        "threshold_c",
        "ratio",
    ];

    /// What stands below a title.
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
    /// let rows = critical(&law, Arithmetic::Double)?.rows();
    /// assert_eq!((rows.len(), rows[0].get("control"), rows[0].get("status")), (1, Some("indentation"), Some("ok")));
    /// # Ok::<(), mdr::Error>(())
    /// ```
    pub fn rows(&self) -> Vec<CriticalRow> {
        match self.folds.as_deref() {
            Some(folds) if !folds.is_empty() => {
                folds.iter().map(|fold| self.row(Some(&fold.state), Some(fold))).collect()
            }
            _ => vec![self.row(self.state.as_ref(), None)],
        }
    }

    fn row(&self, state: Option<&CriticalState>, fold: Option<&CriticalFold>) -> CriticalRow {
        let text = |value: Option<&Value>| match value {
            Some(Value::Unknown { .. }) | None => String::new(),
            Some(value) => value.to_string(),
        };
        let log10 =
            |value: Option<&Value>| value.and_then(Value::log10).map_or_else(String::new, |log10| log10.to_string());
        let body =
            |body: usize, constant: usize| text(self.inputs.bodies.as_ref().map(|bodies| &bodies[body][constant]));
        let [radius, indentation, force] = state.map_or([None; 3], |state| state.values().map(Some));
        let threshold = self.threshold.as_ref();
        CriticalRow([
            self.arithmetic.promise().name().to_owned(),
            self.arithmetic.digits().map_or_else(String::new, |digits| digits.to_string()),
            self.law.control.kind().name().to_owned(),
            self.regime.to_string(),
            self.inputs.n.to_string(),
            self.inputs.c.to_string(),
            body(0, 0),
            body(0, 1),
            body(1, 0),
            body(1, 1),
            self.inputs.e_star.to_string(),
            self.inputs.work.to_string(),
            text(self.inputs.stiffness.as_ref()),
            self.kappa.to_string(),
            fold.map_or(self.status, |fold| fold.state.status()).to_string(),
            text(radius),
            text(indentation),
            text(force),
            log10(radius),
            log10(indentation),
            log10(force),
            fold.map_or_else(String::new, |fold| fold.kind.name().to_owned()),
            text(threshold.map(|threshold| &threshold.c)),
            text(threshold.map(|threshold| &threshold.ratio)),
        ])
    }
}

/// One table for several answers, the titles first: [`CriticalRow::COLUMNS`], then those of [`Validity`](crate::Validity) with
/// `validity_` before their keys where an answer has one.
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
const OVERVIEW: [(&str, &str, &str, bool); 7] = [
    ("n", "n", "", false),
    ("kappa", "kappa_n", "", true),
    ("contact_radius", "contact radius", "m", true),
    ("indentation", "indentation", "m", true),
    ("force", "force", "N", true),
    ("kind", "fold", "", false),
    ("status", "status", "", false),
];

/// What [`overview`] tells of [`Validity`](crate::Validity) where an answer has one.
const OF_VALIDITY: [&str; 3] = ["tabor", "regime", "maugis_dugdale_pull_off"];

/// The main columns of [`spreadsheet`] for a reader, in the units of `style`; the titles first.
pub fn overview(answers: &[CriticalAnswer], style: &NumberStyle) -> Vec<Vec<String>> {
    let asked = answers.iter().any(|answer| answer.validity.is_some());
    let added = if asked { &OF_VALIDITY[..] } else { &[] };
    let own = OVERVIEW.iter().map(|(_, name, unit, _)| (*name, *unit));
    let titles = own.chain(added.iter().map(|key| title(key, None)));
    let mut table = vec![titles.map(|(name, unit)| style.titled(name, unit)).collect()];
    for answer in answers {
        let validity = answer.validity.as_ref().map(|validity| validity.table()).unwrap_or_default();
        let added = added.iter().map(|key| find(&validity, key).map(|cell| style.cell(cell, title(key, None).1)));
        let added: Vec<String> = added.map(Option::unwrap_or_default).collect();
        for row in answer.rows() {
            let own = OVERVIEW.iter().map(|(key, _, unit, is_number)| {
                let text = row.get(key).unwrap_or_default();
                if *is_number { style.number(text, unit) } else { text.to_owned() }
            });
            table.push(own.chain(added.iter().cloned()).collect());
        }
    }
    table
}
