//! Types of a record as a generator makes them of docs/reference/record.schema.json, unchanged below these lines:
//!
//! ```sh
//! npx quicktype@26.0.0 --src-lang schema docs/reference/record.schema.json --lang rust --top-level Record
//! ```

#![allow(missing_docs, dead_code, unreachable_pub, clippy::all, reason = "generated; not every field is read")]
#![cfg_attr(rustfmt, rustfmt_skip)]

use serde::{Serialize, Deserialize};
use std::collections::HashMap;

/// One JSON object a line. README.md beside this file says what the fields mean.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Record {
    pub condition: HashMap<String, f64>,

    pub control: Option<Control>,

    pub difficulty: Difficulty,

    pub digits: Option<i64>,

    pub f64: Option<String>,

    pub flags: Vec<String>,

    pub formula: String,

    pub hash: String,

    pub id: String,

    pub inputs: HashMap<String, String>,

    pub log10: Option<f64>,

    pub methods: Vec<Method>,

    pub mid: Option<String>,

    pub profile: String,

    pub proof: Vec<String>,

    pub quantity: String,

    pub rad: Option<String>,

    pub refs: Vec<String>,

    pub release: i64,

    pub scale: Option<String>,

    pub status: Status,

    pub unit: String,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Control {
    Force,

    Indentation,

    Machine,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Difficulty {
    Average,

    Higher,

    Lower,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Method {
    pub name: String,

    pub rigorous: bool,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    #[serde(rename = "domain-error")]
    DomainError,

    Fold,

    #[serde(rename = "no-equilibrium")]
    NoEquilibrium,

    #[serde(rename = "not-admissible")]
    NotAdmissible,

    Overflow,

    #[serde(rename = "ok")]
    StatusOk,

    Underflow,
}
