//! A critical state as rows of a table, and in a sentence.

use mdr_core::contact::{ControlKind, Regime};

use super::{CriticalAnswer, CriticalFold, CriticalState};
use crate::answer::{FlatRow, Value, columns};

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

    /// What happens at the critical state, in a sentence or two.
    pub fn explanation(&self) -> String {
        let kind = self.law.control.kind();
        let controlled = match kind {
            ControlKind::Force => "force",
            ControlKind::Machine => "position d + F/k",
            ControlKind::Indentation => "indentation depth",
        };
        let folds = self.folds.as_ref().map_or(1, Vec::len);
        match self.regime {
            Regime::ScaleFree if kind == ControlKind::Machine => {
                "Scale-free (n = 1/2) on a machine: below the threshold of C no contact is stable; from there to three times \
                 the threshold a contact is stable up to the radius of a fold, beyond which it spreads over the whole \
                 surface; above, every contact is stable."
                    .to_owned()
            }
            Regime::ScaleFree => format!(
                "Scale-free (n = 1/2): no radius is singled out. At zero {} a contact of any radius shrinks to nothing \
                 when C is above the threshold, and spreads over the whole surface when C is below.",
                kind.name()
            ),
            Regime::PullOff if folds > 1 => format!(
                "Pull-off (n > 1/2), multistable with {folds} folds of the {controlled}: on unloading the one of the \
                 largest radius is met first; beyond it the contact jumps to a smaller radius or breaks."
            ),
            Regime::PullOff => format!(
                "Pull-off (n > 1/2): when the {controlled} falls below that of this state, no equilibrium is left and \
                 the contact breaks."
            ),
            Regime::CompleteContact => format!(
                "Complete contact (n < 1/2): when the {controlled} rises above that of this state, no equilibrium is \
                 left and the contact spreads over the whole surface."
            ),
        }
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
        let text =
            |key| cells.iter().find(|(name, _)| name == key).map_or_else(String::new, |(_, cell)| cell.to_string());
        let added: Vec<String> = keys.iter().map(text).collect();
        answer.rows().into_iter().map(move |row| row.0.into_iter().chain(added.clone()).collect())
    });
    std::iter::once(header.collect()).chain(rows).collect()
}
