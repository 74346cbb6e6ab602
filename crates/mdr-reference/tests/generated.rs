//! The published schema is fit for code generation: types that a generator has made of it read every published record.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

#[path = "generated/record.rs"]
mod record;

use std::collections::BTreeSet;

use mdr_reference::records;
use record::{Control, Record, Status};

#[test]
fn generated_types_read_every_record() {
    for known in records() {
        let line = known.to_json();
        let read: Record = serde_json::from_str(&line).unwrap_or_else(|error| panic!("{}: {error}", known.id));
        assert_eq!((&read.id, i64::from(known.release)), (&known.id, read.release), "{line}");
        assert_eq!(read.inputs.len(), known.inputs.len(), "{line}");
        let control = read.control.as_ref().map(|control| match control {
            Control::Force => "force",
            Control::Indentation => "indentation",
            Control::Machine => "machine",
        });
        assert_eq!(control, known.control.as_deref(), "{line}");
        assert_eq!(matches!(read.status, Status::StatusOk), known.status.name() == "ok", "{line}");
        assert_eq!(read.mid.is_some(), read.rad.is_some(), "{line}");
        // What was read is written again with all its fields.
        let written: serde_json::Value = serde_json::to_value(&read).unwrap();
        let line: serde_json::Value = serde_json::from_str(&line).unwrap();
        let [one, other] = [&line, &written].map(|value| value.as_object().unwrap().keys().collect::<BTreeSet<_>>());
        assert_eq!(one, other, "{}", known.id);
    }
}
