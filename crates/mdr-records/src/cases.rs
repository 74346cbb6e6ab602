//! The cases, read from the data of this crate.

use std::collections::BTreeMap;

use mdr::prelude::{Literal, Shape};
use mdr_core::contact::Control;
use rug::Integer;
use rug::ops::Pow;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use crate::contact::CaseContact;
use crate::{Answer, Failure, KINDS, RecordError, Result};

/// The files of the release, and the cases of each.
const FILES: [(&str, &str); 5] = [
    ("critical.jsonl", include_str!("../data/critical.toml")),
    ("equilibria.jsonl", include_str!("../data/equilibria.toml")),
    ("profiles.jsonl", include_str!("../data/profiles.toml")),
    ("edges.jsonl", include_str!("../data/edges.toml")),
    ("worst.jsonl", include_str!("../data/worst.toml")),
];

/// A question about a contact.
pub(crate) struct Case {
    /// Answers it.
    pub(crate) records: Answer,
    pub(crate) formula: Formula,
    /// The name of the contact.
    pub(crate) name: String,
    pub(crate) contact: CaseContact,
    pub(crate) flags: Vec<String>,
    /// Whether the records name the controlled quantity.
    pub(crate) has_control: bool,
    /// Where it is asked: a radius, a value of the controlled quantity, the number of a fold. Empty where that is no
    /// question.
    pub(crate) at: String,
    /// The part of the identifiers for `at`.
    pub(crate) label: String,
    /// The row of the data.
    pub(crate) row: Row,
}

/// The properties of a formula that are published with the records of a kind.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Formula {
    /// The first word of the identifiers, where it is not the kind.
    pub(crate) id: Option<String>,
    /// The name of the formula, where it is not the kind.
    pub(crate) name: Option<String>,
    /// The rigorous one first.
    pub(crate) methods: Vec<String>,
    #[serde(default)]
    pub(crate) proof: Vec<String>,
    pub(crate) refs: Vec<String>,
}

/// A case for each of its contacts, for each of its controls, for each of `at`.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Row {
    kind: String,
    /// By their names, or one by its profile.
    #[serde(default)]
    contacts: Vec<String>,
    profile: Option<ContactRow>,
    name: Option<String>,
    /// `indentation`, `force`, or `k=…` in N/m.
    #[serde(default)]
    controls: Vec<String>,
    #[serde(default)]
    at: Vec<At>,
    /// Where it is not that of the kind.
    formula: Option<String>,
    /// On which side of the critical radius: `inner` or `outer`.
    #[serde(default)]
    pub(crate) side: String,
    /// A loading path from the state with the smallest or largest radius, whose first jump is asked for.
    #[serde(default)]
    pub(crate) path: Vec<String>,
    pub(crate) start: Option<String>,
    /// The release of the records in which the values were last changed.
    pub(crate) release: Option<u32>,
    /// In place of the identifier that follows from the case, in the second release.
    pub(crate) id: Option<String>,
    /// The only one that is a record.
    pub(crate) quantity: Option<String>,
}

/// A value, or a label with its value.
#[derive(Clone, Deserialize)]
#[serde(untagged)]
enum At {
    Plain(String),
    Labelled([String; 2]),
}

#[derive(Clone, Deserialize)]
struct ContactRow {
    /// The names of the terms of the profile, with a plus between them; a power law without.
    kind: Option<String>,
    #[serde(default)]
    flags: Vec<String>,
    /// The label of the record of its κ, which contacts of the same exponent share.
    kappa: Option<String>,
    /// Its controls, where they are not all controls of the case.
    controls: Option<Vec<String>>,
    /// The radii between which all folds are proved.
    range: Option<[String; 2]>,
    /// Parameters, E* and w.
    #[serde(flatten)]
    numbers: BTreeMap<String, String>,
}

/// The formulas and contacts that the cases name.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Names {
    formula: BTreeMap<String, Formula>,
    contact: BTreeMap<String, ContactRow>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    case: Vec<Row>,
}

/// All cases in the order of their records, each with its file.
///
/// # Errors
/// [`RecordError`] for data without a meaning.
pub(crate) fn all() -> std::result::Result<Vec<(&'static str, Case)>, RecordError> {
    let wrong = |file: &str| {
        let case = file.to_owned();
        move |source| RecordError { case, source }
    };
    let names: Names = read(include_str!("../data/contacts.toml")).map_err(wrong("contacts.toml"))?;
    let mut cases = Vec::new();
    for (file, text) in FILES {
        let rows: File = read(text).map_err(wrong(file))?;
        for row in &rows.case {
            cases.extend(row.cases(&names).map_err(wrong(file))?.into_iter().map(|case| (file, case)));
        }
    }
    Ok(cases)
}

pub(crate) fn read<T: DeserializeOwned>(text: &str) -> Result<T> {
    toml::from_str(text).map_err(|error| Failure::Data(error.to_string()))
}

pub(crate) fn number(text: &str) -> Result<Literal> {
    text.parse().map_err(|error| Failure::Data(format!("{text}: {error}")))
}

/// An entry of a table of the data, or of this crate.
fn known<T>(what: &str, key: &str, entry: Option<T>) -> Result<T> {
    entry.ok_or_else(|| Failure::Data(format!("no {what} {key}")))
}

impl Case {
    /// The kind of the case in the data.
    pub(crate) fn kind(&self) -> &str {
        &self.row.kind
    }

    /// Where it is asked.
    pub(crate) fn value(&self) -> Result<Literal> {
        number(&self.at)
    }
}

impl Row {
    fn cases(&self, names: &Names) -> Result<Vec<Case>> {
        let mut contacts: Vec<_> = self.profile.iter().map(|contact| (self.name.as_ref(), contact)).collect();
        for name in &self.contacts {
            contacts.push((Some(name), known("contact", name, names.contact.get(name))?));
        }
        let mut cases = Vec::new();
        for (name, contact) in contacts {
            if let (Some(label), "critical") = (&contact.kappa, self.kind.as_str()) {
                cases.push(self.case(names, contact, "kappa", Some(label), None, None)?);
            }
            let is_asked = |control: &&String| contact.controls.as_ref().is_none_or(|of| of.contains(control));
            for control in or_none(self.controls.iter().filter(is_asked).map(String::as_str), &self.controls) {
                for at in or_none(self.at.iter(), &self.at) {
                    cases.push(self.case(names, contact, &self.kind, name, control, at)?);
                }
            }
        }
        Ok(cases)
    }

    /// One of the cases.
    fn case(
        &self,
        names: &Names,
        row: &ContactRow,
        kind: &str,
        name: Option<&String>,
        control: Option<&str>,
        at: Option<&At>,
    ) -> Result<Case> {
        let contact = row.contact(control)?;
        let (label, at) = match at {
            None => Default::default(),
            Some(At::Labelled([label, value])) => (label.clone(), value.clone()),
            Some(At::Plain(text)) => (text.clone(), power_of_two(text)?),
        };
        let by_control = format!("{kind}-{}", control.unwrap_or_default());
        let keys = [self.formula.as_deref(), Some(at.as_str()), Some(&by_control), Some(kind)];
        let formula = keys.into_iter().flatten().find_map(|key| Some((key, names.formula.get(key)?)));
        let (key, formula) = known("formula", kind, formula)?;
        let or_key = |text: &Option<String>| text.clone().or_else(|| Some(key.to_owned()));
        let formula = Formula { id: or_key(&formula.id), name: or_key(&formula.name), ..formula.clone() };
        let records = KINDS.into_iter().find(|(known, _)| *known == kind).map(|(_, records)| records);
        Ok(Case {
            records: known("kind", kind, records)?,
            formula,
            name: name.cloned().unwrap_or_else(|| contact.profile_name().to_owned()),
            contact,
            flags: row.flags.clone(),
            has_control: control.is_some(),
            at,
            label,
            row: self.clone(),
        })
    }
}

/// Each item of a list that may be filtered; a single `None` if the list itself is empty.
fn or_none<T, S>(items: impl Iterator<Item = T>, list: &[S]) -> impl Iterator<Item = Option<T>> {
    items.map(Some).chain(list.is_empty().then_some(None))
}

impl ContactRow {
    fn contact(&self, control: Option<&str>) -> Result<CaseContact> {
        let mut numbers = self.numbers.clone();
        let mut term = |kind: &str| {
            let blank = known("profile", kind, Shape::by_name(kind))?;
            blank.try_map(|key, ()| number(&known("parameter", key, numbers.remove(key))?))
        };
        let terms = self.kind.as_deref().unwrap_or("power").split(" + ");
        let terms: Vec<Shape<Literal>> = terms.map(&mut term).collect::<Result<_>>()?;
        let mut material = |key| number(numbers.remove(key).as_deref().unwrap_or("1"));
        let (e_star, work_of_adhesion) = (material("e_star")?, material("w")?);
        let control = match control.unwrap_or("indentation") {
            "indentation" => Control::Indentation,
            "force" => Control::Force,
            other => Control::Machine { stiffness: number(known("control", other, other.strip_prefix("k="))?)? },
        };
        let range = self.range.as_ref().map(|[from, to]| Ok::<_, Failure>([number(from)?, number(to)?])).transpose()?;
        match numbers.keys().next() {
            Some(unknown) => known("use for", unknown, None),
            None => Ok(CaseContact { terms, e_star, work_of_adhesion, control, range }),
        }
    }
}

/// 2⁻ᵏ, written `2^-k`, as a decimal; another text as it is.
fn power_of_two(text: &str) -> Result<String> {
    let Some(k) = text.strip_prefix("2^-") else { return Ok(text.to_owned()) };
    let k: u32 = k.parse().map_err(|error| Failure::Data(format!("{text}: {error}")))?;
    Ok(format!("0.{:0>width$}", Integer::from(5).pow(k).to_string(), width = k as usize))
}
