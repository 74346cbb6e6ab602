//! A critical state as JSON, schema `mdr.critical/1`: keys and their order are published.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::{CriticalAnswer, Inputs, Threshold};
use crate::answer::json::serialize_cells;
use crate::answer::{Cell, Fold, Row};

/// Names the keys of the answer and their meaning.
const SCHEMA: &str = "mdr.critical/1";

impl Serialize for CriticalAnswer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("schema", SCHEMA)?;
        map.serialize_entry("arithmetic", self.arithmetic.promise().name())?;
        map.serialize_entry("digits", &self.arithmetic.digits())?;
        map.serialize_entry("control", self.law.control.kind().name())?;
        map.serialize_entry("regime", &self.regime.to_string())?;
        map.serialize_entry("inputs", &self.inputs)?;
        map.serialize_entry("kappa", &self.kappa)?;
        map.serialize_entry("status", &self.status.to_string())?;
        let mut cells = match &self.state {
            Some(state) => row(state).cells.into_iter().filter(|(key, _)| *key != "kind").collect::<Vec<_>>(),
            None => ["contact_radius", "indentation", "force"].map(|key| (key, Cell::Absent)).into(),
        };
        match &self.threshold {
            Some(Threshold { c, ratio }) => {
                cells.extend([("threshold_c", Cell::Value(c)), ("ratio", Cell::Value(ratio))])
            }
            None => cells.push(("threshold_c", Cell::Absent)),
        }
        serialize_cells(&mut map, &cells)?;
        if let Some(folds) = &self.folds {
            map.serialize_entry("folds", &folds.iter().map(row).collect::<Vec<_>>())?;
        }
        if let Some(validity) = &self.validity {
            let promise = validity.promise().name();
            map.serialize_entry("promise", &std::collections::BTreeMap::from([("validity", promise)]))?;
            map.serialize_entry("validity", validity)?;
        }
        map.end()
    }
}

/// A fold as a row that says nothing of its admissibility: every state of a power law is admissible.
fn row(fold: &Fold) -> Row<'_> {
    let mut row = Row::new().with("", fold);
    row.admissible = None;
    row
}

impl Serialize for Inputs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("n", &self.n)?;
        map.serialize_entry("c", &self.c)?;
        for ([e, nu], [modulus, ratio]) in [["e1", "nu1"], ["e2", "nu2"]].into_iter().zip(self.bodies.iter().flatten())
        {
            map.serialize_entry(e, modulus)?;
            map.serialize_entry(nu, ratio)?;
        }
        map.serialize_entry("e_star", &self.e_star)?;
        map.serialize_entry("work", &self.work)?;
        if let Some(stiffness) = &self.stiffness {
            map.serialize_entry("stiffness", stiffness)?;
        }
        map.end()
    }
}
