//! What `mdr critical` answers, and how it is written.

use mdr_core::contact::{FoldKind, Regime, Status};
use serde::{Serialize, Serializer};

use crate::number::Number;

/// One quantity of a critical state.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Entry {
    /// A number.
    Value(Number),
    /// Out of the range of f64; the log10 of its magnitude.
    Beyond {
        /// `Overflow` or `Underflow`.
        status: Status,
        /// log10 of the magnitude.
        log10: f64,
    },
    /// There is none.
    Absent,
}

impl Entry {
    fn status(&self) -> Status {
        match self {
            Entry::Beyond { status, .. } => *status,
            _ => Status::Ok,
        }
    }

    /// log10 of the magnitude of a result out of range.
    pub(crate) fn log10(&self) -> Option<f64> {
        match self {
            Entry::Beyond { log10, .. } => Some(*log10),
            _ => None,
        }
    }
}

impl std::fmt::Display for Entry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Entry::Value(number) => number.fmt(f),
            Entry::Beyond { status, log10 } => write!(f, "{status}: about 10^{log10:.6}"),
            Entry::Absent => f.write_str("none"),
        }
    }
}

impl Serialize for Entry {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Entry::Value(number) => number.serialize(serializer),
            _ => serializer.serialize_none(),
        }
    }
}

/// Radius, depth and force of a critical state.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct State {
    pub(crate) contact_radius: Entry,
    #[serde(skip_serializing_if = "Option::is_none")]
    log10_contact_radius: Option<f64>,
    pub(crate) indentation: Entry,
    #[serde(skip_serializing_if = "Option::is_none")]
    log10_indentation: Option<f64>,
    pub(crate) force: Entry,
    #[serde(skip_serializing_if = "Option::is_none")]
    log10_force: Option<f64>,
}

impl State {
    pub(crate) fn new([contact_radius, indentation, force]: [Entry; 3]) -> Self {
        State {
            log10_contact_radius: contact_radius.log10(),
            log10_indentation: indentation.log10(),
            log10_force: force.log10(),
            contact_radius,
            indentation,
            force,
        }
    }

    /// No critical state.
    pub(crate) fn absent() -> Self {
        State::new([Entry::Absent, Entry::Absent, Entry::Absent])
    }

    pub(crate) fn entries(&self) -> [&Entry; 3] {
        [&self.contact_radius, &self.indentation, &self.force]
    }

    /// That of the first quantity that is out of range, else ok.
    pub(crate) fn status(&self) -> Status {
        first_trouble(self.entries())
    }
}

fn first_trouble<const K: usize>(entries: [&Entry; K]) -> Status {
    entries.map(Entry::status).into_iter().find(|status| *status != Status::Ok).unwrap_or(Status::Ok)
}

/// What decides at n = 1/2.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Threshold {
    /// The C of (1.19) under this control; absent elsewhere.
    pub(crate) threshold_c: Entry,
    #[serde(skip_serializing_if = "Option::is_none")]
    log10_threshold_c: Option<f64>,
    /// C over the threshold.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) ratio: Option<Entry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    log10_ratio: Option<f64>,
}

impl Threshold {
    pub(crate) fn new(threshold_c: Entry, ratio: Entry) -> Self {
        Threshold {
            log10_threshold_c: threshold_c.log10(),
            log10_ratio: ratio.log10(),
            threshold_c,
            ratio: Some(ratio),
        }
    }

    /// Not at n = 1/2.
    pub(crate) fn absent() -> Self {
        Threshold { threshold_c: Entry::Absent, log10_threshold_c: None, ratio: None, log10_ratio: None }
    }

    /// That of the first number that is out of range, else ok.
    pub(crate) fn status(&self) -> Status {
        first_trouble([&self.threshold_c, self.ratio.as_ref().unwrap_or(&Entry::Absent)])
    }
}

/// A fold of the quantity controlled by a machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Fold {
    #[serde(flatten)]
    pub(crate) state: State,
    /// Of the controlled quantity, as a function of the contact radius.
    #[serde(serialize_with = "fold_kind")]
    pub(crate) kind: FoldKind,
    #[serde(serialize_with = "text")]
    pub(crate) status: Status,
}

/// The inputs, in the order of the flags; as written in a certified answer, as doubles in an f64 answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Inputs {
    pub(crate) n: Number,
    pub(crate) c: Number,
    #[serde(flatten)]
    pub(crate) bodies: Option<Bodies>,
    /// As given, or derived from the two bodies.
    pub(crate) e_star: Number,
    pub(crate) work: Number,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) stiffness: Option<Number>,
}

/// The elastic constants of two bodies.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Bodies {
    pub(crate) e1: Number,
    pub(crate) nu1: Number,
    pub(crate) e2: Number,
    pub(crate) nu2: Number,
}

/// The answer, with the keys and their order as published in the schema.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Answer {
    pub(crate) schema: &'static str,
    pub(crate) arithmetic: &'static str,
    /// `None` in f64.
    pub(crate) digits: Option<u32>,
    pub(crate) control: &'static str,
    #[serde(serialize_with = "text")]
    pub(crate) regime: Regime,
    pub(crate) inputs: Inputs,
    pub(crate) kappa: Number,
    #[serde(serialize_with = "text")]
    pub(crate) status: Status,
    #[serde(flatten)]
    pub(crate) state: State,
    #[serde(flatten)]
    pub(crate) threshold: Threshold,
    /// On a machine: all folds, by increasing radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) folds: Option<Vec<Fold>>,
}

fn text<S: Serializer>(value: &impl ToString, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&value.to_string())
}

fn fold_kind<S: Serializer>(kind: &FoldKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(kind.name())
}
