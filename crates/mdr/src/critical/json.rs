//! A critical state as JSON, schema `mdr.critical/1`: keys and their order are published.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::{CriticalAnswer, CriticalFold, CriticalState, Inputs};
use crate::answer::Value;

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
        state(&mut map, self.state.as_ref())?;
        number(&mut map, "threshold_c", self.threshold.as_ref().map(|threshold| &threshold.c))?;
        if let Some(threshold) = &self.threshold {
            number(&mut map, "ratio", Some(&threshold.ratio))?;
        }
        if let Some(folds) = &self.folds {
            map.serialize_entry("folds", folds)?;
        }
        if let Some(validity) = &self.validity {
            let promise = validity.promise().name();
            map.serialize_entry("promise", &std::collections::BTreeMap::from([("validity", promise)]))?;
            map.serialize_entry("validity", validity)?;
        }
        map.end()
    }
}

/// A number and, where it is out of range, its log10; null where there is none.
fn number<M: SerializeMap>(map: &mut M, key: &str, value: Option<&Value>) -> Result<(), M::Error> {
    map.serialize_entry(key, &value)?;
    match value.and_then(Value::log10) {
        Some(log10) => map.serialize_entry(&format!("log10_{key}"), &log10),
        None => Ok(()),
    }
}

fn state<M: SerializeMap>(map: &mut M, state: Option<&CriticalState>) -> Result<(), M::Error> {
    let values = state.map(CriticalState::values).map_or([None; 3], |values| values.map(Some));
    ["contact_radius", "indentation", "force"].iter().zip(values).try_for_each(|(key, value)| number(map, key, value))
}

impl Serialize for CriticalFold {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        state(&mut map, Some(&self.state))?;
        map.serialize_entry("kind", self.kind.name())?;
        map.serialize_entry("status", &self.state.status().to_string())?;
        map.end()
    }
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
