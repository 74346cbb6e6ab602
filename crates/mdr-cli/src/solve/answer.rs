//! What `mdr solve` answers, and its JSON.

use mdr_core::contact::Status;
use mdr_numeric::admissible::{Basis, Verdict};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use super::record::{Field, Record};
use crate::number::Number;
use crate::scene::Want;

/// Names the keys of the answer and their meaning.
const SCHEMA: &str = "mdr.solve/1";

/// How far a number can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Promise {
    /// Hardware numbers, within a stated error.
    Double,
    /// Arbitrary precision with an estimated error: two precisions agree on the digits that are printed.
    Estimated,
    /// Every printed digit is proved.
    Certified,
}

impl Promise {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Promise::Double => "f64",
            Promise::Estimated => "mp",
            Promise::Certified => "certified",
        }
    }
}

/// Whether a list is complete.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Complete {
    /// Whether that is proved, on the range.
    pub(crate) proved: bool,
    /// The contact radii of the range; null is no end.
    pub(crate) from: Option<String>,
    pub(crate) to: Option<String>,
    /// By what, or why not.
    pub(crate) why: String,
}

/// One output that was wanted.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Output {
    pub(crate) want: Want,
    pub(crate) promise: Promise,
    /// What has a promise of its own.
    pub(crate) exceptions: Vec<(&'static str, Promise)>,
    pub(crate) complete: Option<Complete>,
    pub(crate) records: Vec<Record<Number>>,
    /// The energy of a path, where it is finite.
    pub(crate) balance: Option<Record<Number>>,
}

impl Output {
    pub(crate) fn new(want: Want, promise: Promise, records: Vec<Record<Number>>) -> Self {
        Output { want, promise, exceptions: Vec::new(), complete: None, records, balance: None }
    }

    /// From the one record of [`States::path`](super::states::States::path).
    pub(crate) fn path(promise: Promise, mut records: Vec<Record<Number>>) -> Self {
        let whole = records.pop().unwrap_or_default();
        let balance = whole.clone().into_records("balance").pop();
        Output { balance, ..Output::new(Want::Path, promise, whole.into_records("events")) }
    }

    /// The same path with the energies of another computation of it.
    pub(crate) fn with_energy_of(self, other: Output) -> Self {
        let lost = other.records.iter().map(|record| record.get("dissipated").cloned());
        let pair = |(record, energy): (Record<Number>, Option<_>)| match energy {
            Some(energy) => record.replacing("dissipated", energy),
            None => record,
        };
        let records = self.records.into_iter().zip(lost.chain(std::iter::repeat(None))).map(pair).collect();
        let energies = [Some("path.dissipated"), other.balance.as_ref().map(|_| "balance")];
        let exceptions = energies.into_iter().flatten().map(|field| (field, other.promise)).collect();
        Output { records, exceptions, balance: other.balance, ..self }
    }

    /// The same path where its energies are not known.
    pub(crate) fn without_energy(self, why: &str) -> Self {
        let open = || Field::Marked { status: Status::Undecided, log10: None, why: Some(why.to_owned()) };
        let lacks = |record: &Record<Number>, key| matches!(record.get(key), Some(Field::Absent) | None);
        let is_last = |record: &Record<Number>| {
            matches!(record.get("event"), Some(Field::Word("detached" | "complete-contact" | "undecided")))
        };
        // Surfaces that leave each other under a dead load, or come to touch everywhere, have no energy balance.
        let is_finite = !self.records.iter().any(|record| is_last(record) && lacks(record, "to_indentation"));
        let balance =
            || ["work", "dissipated", "stored"].into_iter().fold(Record::new(), |all, key| all.with(key, open()));
        let mark = |record: Record<Number>| {
            if lacks(&record, "to_force") { record } else { record.replacing("dissipated", open()) }
        };
        let records = self.records.into_iter().map(mark).collect();
        Output { records, balance: is_finite.then(balance), ..self }
    }

    pub(crate) fn complete(self, complete: Complete) -> Self {
        Output { complete: Some(complete), ..self }
    }
}

/// The answer to a scene.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Answer {
    /// `None` in f64.
    pub(crate) digits: Option<u32>,
    pub(crate) profile: &'static str,
    /// None where nothing is held.
    pub(crate) control: Option<&'static str>,
    /// How the scene was read, where that may surprise.
    pub(crate) notes: Vec<String>,
    /// In the order of the scene.
    pub(crate) outputs: Vec<Output>,
    /// How it was decided which states are admissible, where there are states.
    pub(crate) admissibility: Option<Basis>,
}

impl Answer {
    /// The arithmetic that was asked for.
    pub(crate) fn arithmetic(&self) -> &'static str {
        if self.digits.is_some() { Promise::Certified.name() } else { Promise::Double.name() }
    }
}

impl Serialize for Answer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("schema", SCHEMA)?;
        map.serialize_entry("arithmetic", self.arithmetic())?;
        map.serialize_entry("digits", &self.digits)?;
        map.serialize_entry("profile", self.profile)?;
        map.serialize_entry("control", &self.control)?;
        if !self.notes.is_empty() {
            map.serialize_entry("notes", &self.notes)?;
        }
        map.serialize_entry("promise", &Promises(self))?;
        map.serialize_entry("complete", &Completes(&self.outputs))?;
        for output in &self.outputs {
            map.serialize_entry(output.want.name(), &output.records)?;
            if let Some(balance) = &output.balance {
                map.serialize_entry("balance", balance)?;
            }
        }
        if let Some(basis) = self.admissibility {
            map.serialize_entry("admissibility", described(basis))?;
        }
        map.end()
    }
}

/// How admissibility was decided, in words.
pub(crate) fn described(basis: Basis) -> &'static str {
    match basis {
        Basis::Bound => {
            "every state is, by the form of the profile: its g falls nowhere, so that no gap closes outside of a contact"
        }
        Basis::Searched => {
            "decided in f64 from the extrema of g, which were searched and resolved, and from the gap wherever g is below the \
             indentation"
        }
        Basis::Doubtful => {
            "decided in f64; the extrema of g were not resolved everywhere: an overlap that is found is one, and where none is \
             found it is not known"
        }
    }
}

/// The promise of each output, and of the fields that have their own.
struct Promises<'a>(&'a Answer);

impl Serialize for Promises<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for output in &self.0.outputs {
            map.serialize_entry(output.want.name(), output.promise.name())?;
            for (field, promise) in &output.exceptions {
                map.serialize_entry(field, promise.name())?;
            }
        }
        if let Some(basis) = self.0.admissibility {
            let promise =
                if basis == Basis::Bound && self.0.digits.is_some() { Promise::Certified } else { Promise::Double };
            map.serialize_entry("admissible", promise.name())?;
        }
        map.end()
    }
}

/// What is known about the completeness of each list for which it is a question.
struct Completes<'a>(&'a [Output]);

impl Serialize for Completes<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().filter_map(|output| Some((output.want.name(), output.complete.as_ref()?))))
    }
}

impl Serialize for Record<Number> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (key, field) in self.fields() {
            map.serialize_entry(key, field)?;
            if let Field::Marked { log10: Some(log10), .. } = field {
                map.serialize_entry(&format!("log10_{key}"), log10)?;
            }
        }
        map.serialize_entry("status", &self.status().to_string())?;
        if let Some(why) = self.why() {
            map.serialize_entry("why", &why)?;
        }
        match self.verdict() {
            Some(Verdict::Admissible) => map.serialize_entry("admissible", &true)?,
            Some(Verdict::Interpenetrating { .. }) => map.serialize_entry("admissible", &false)?,
            Some(Verdict::Undecided(_)) => map.serialize_entry("admissible", &None::<bool>)?,
            None => {}
        }
        map.end()
    }
}

impl Serialize for Field<Number> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Field::Number(number) => number.serialize(serializer),
            Field::Given(literal) => serializer.serialize_str(&literal.to_string()),
            Field::Marked { .. } | Field::Absent => serializer.serialize_none(),
            Field::Word(word) => serializer.serialize_str(word),
            Field::Flag(flag) => serializer.serialize_bool(*flag),
            Field::Records(records) => records.serialize(serializer),
        }
    }
}
