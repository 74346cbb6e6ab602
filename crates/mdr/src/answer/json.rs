//! The answer as JSON, schema `mdr.solve/1`: keys and their order are published.

use mdr_numeric::admissible::Basis;
use serde::ser::{Error as _, SerializeMap};
use serde::{Serialize, Serializer};

use super::{Answer, Cell, Number, Promise, Row, Value, described};

/// Names the keys of the answer and their meaning.
const SCHEMA: &str = "mdr.solve/1";

impl Answer {
    /// The answer as one line of JSON, schema `mdr.solve/1`. Certified digits are text, doubles are JSON numbers; a value without
    /// a number is null, with its status beside it.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }
}

impl Serialize for Answer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("schema", SCHEMA)?;
        map.serialize_entry("arithmetic", self.promise().name())?;
        map.serialize_entry("digits", &self.arithmetic.digits())?;
        map.serialize_entry("profile", self.profile)?;
        map.serialize_entry("control", &self.control.map(|control| control.name()))?;
        if let Some(medium) = self.medium {
            map.serialize_entry("medium", medium)?;
            map.serialize_entry("force_unit", self.force_unit)?;
        }
        if !self.notes.is_empty() {
            map.serialize_entry("notes", &self.notes)?;
        }
        map.serialize_entry("promise", &Entries(promises(self)))?;
        let complete = self.outputs.iter().filter_map(|output| Some((output.kind().name(), output.complete()?)));
        map.serialize_entry("complete", &Entries(complete.collect()))?;
        for output in &self.outputs {
            map.serialize_entry(output.kind().name(), &output.rows())?;
            for (key, rows) in output.beside() {
                map.serialize_entry(key, rows.first().ok_or_else(|| S::Error::custom("one record"))?)?;
            }
        }
        if let Some(basis) = self.admissibility {
            map.serialize_entry("admissibility", &described(basis))?;
            if let Basis::Unproved { width, .. } = basis {
                map.serialize_entry("admissibility_resolved_width", &width)?;
            }
        }
        if let Some(validity) = &self.validity {
            map.serialize_entry("validity", validity)?;
        }
        map.end()
    }
}

/// The promise of each output, and of the fields that have their own.
fn promises(answer: &Answer) -> Vec<(&'static str, &'static str)> {
    let mut promises = Vec::new();
    for output in &answer.outputs {
        promises.push((output.kind().name(), output.promise()));
        promises.extend(output.exceptions());
    }
    let of_basis = |basis| if matches!(basis, Basis::Bound | Basis::Proved) { answer.promise() } else { Promise::F64 };
    promises.extend(answer.admissibility.map(|basis| ("admissible", of_basis(basis))));
    promises.extend(answer.validity.as_ref().map(|validity| ("validity", validity.promise())));
    promises.into_iter().map(|(field, promise)| (field, promise.name())).collect()
}

/// Values by their keys.
struct Entries<V>(Vec<(&'static str, V)>);

impl<V: Serialize> Serialize for Entries<V> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

impl Serialize for crate::Validity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.row().serialize(serializer)
    }
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        serialize_cells(&mut map, &self.cells)?;
        map.serialize_entry("status", &self.status().to_string())?;
        if let Some(why) = self.why() {
            map.serialize_entry("why", &why)?;
        }
        if let Some(admissible) = self.admissible {
            map.serialize_entry("admissible", &admissible)?;
        }
        map.end()
    }
}

/// Cells under their keys, and beside a number that is out of range its log10.
pub(crate) fn serialize_cells<M: SerializeMap>(map: &mut M, cells: &[(&str, Cell<'_>)]) -> Result<(), M::Error> {
    for (key, cell) in cells {
        map.serialize_entry(key, cell)?;
        if let Some(log10) = cell.log10() {
            map.serialize_entry(&format!("log10_{key}"), &log10)?;
        }
    }
    Ok(())
}

impl Serialize for Cell<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Cell::Value(value) => value.serialize(serializer),
            Cell::UnknownStability(_) | Cell::Absent => serializer.serialize_none(),
            Cell::Literal(literal) => serializer.serialize_str(&literal.to_string()),
            Cell::Flag(flag) => serializer.serialize_bool(*flag),
            Cell::Count(count) => count.serialize(serializer),
            Cell::Word(word) => serializer.serialize_str(word),
            Cell::Rows(rows) => rows.serialize(serializer),
        }
    }
}

/// A number or null.
impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::Known(number) => number.serialize(serializer),
            Value::Given(literal) => serializer.serialize_str(&literal.to_string()),
            Value::Unknown { .. } => serializer.serialize_none(),
        }
    }
}

/// Digits as text, a double as a JSON number.
impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Number::Certified(decimal) => serializer.serialize_str(&decimal.to_string()),
            // −0 is written as 0.
            Number::F64(value) => serializer.serialize_f64(*value + 0.0),
        }
    }
}
