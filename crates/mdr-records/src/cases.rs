//! The cases, read from the data of this crate.

use std::collections::BTreeMap;

use mdr::prelude::{Literal, Shape, Start};
use mdr_core::contact::Control;
use rug::Integer;
use rug::ops::Pow;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde::de::value::StrDeserializer;

use crate::contact::Contact;
use crate::{Failure, RecordError, Result};

/// The files of the release, and the cases of each.
const FILES: [(&str, &str); 5] = [
    ("critical.jsonl", include_str!("../data/critical.toml")),
    ("equilibria.jsonl", include_str!("../data/equilibria.toml")),
    ("profiles.jsonl", include_str!("../data/profiles.toml")),
    ("edges.jsonl", include_str!("../data/edges.toml")),
    ("worst.jsonl", include_str!("../data/worst.toml")),
];

/// What is asked; docs/reference/README.md has the formula of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Kind {
    Kappa,
    Critical,
    MachineFolds,
    Folds,
    DoubleRoot,
    Equilibrium,
    EquilibriumShare,
    Equilibria,
    Landing,
    Past,
    Threshold,
    Energy,
    Transform,
    State,
    FlatPunchPullOff,
    Domain,
    Outside,
    Interpenetrating,
}

/// On which side of the critical radius of a power law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Side {
    Inner,
    Outer,
}

/// What is published with the records of a kind.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct Formula {
    /// The first word of the identifiers.
    pub(crate) id: String,
    pub(crate) name: String,
    /// The rigorous one first.
    pub(crate) methods: Vec<String>,
    pub(crate) proof: Vec<String>,
    pub(crate) refs: Vec<String>,
}

/// A question about a contact.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) file: &'static str,
    pub(crate) kind: Kind,
    pub(crate) formula: Formula,
    pub(crate) name: String,
    pub(crate) contact: Contact,
    /// Whether the records name what is controlled.
    pub(crate) has_control: bool,
    pub(crate) flags: Vec<String>,
    /// Where it is asked: a radius, a value of the controlled quantity, the number of a fold. Empty where that is no question.
    pub(crate) at: String,
    /// The same for the identifiers.
    pub(crate) label: String,
    pub(crate) side: Option<Side>,
    /// A loading path whose first jump is asked for.
    pub(crate) path: Vec<Literal>,
    pub(crate) start: Start,
    /// The release of the records in which its values were last changed.
    pub(crate) release: u32,
    /// In place of the identifier that follows from the case.
    pub(crate) id: Option<String>,
    /// The only one that is a record.
    pub(crate) quantity: Option<String>,
}

impl Case {
    /// Where it is asked.
    pub(crate) fn value(&self) -> Result<Literal> {
        number(&self.at)
    }
}

/// The file of what other files name.
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

/// A case for each of its contacts, for each of its controls, for each of `at`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
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
    side: Option<Side>,
    #[serde(default)]
    path: Vec<String>,
    start: Option<String>,
    release: Option<u32>,
    /// Where it is not that of the kind.
    formula: Option<String>,
    id: Option<String>,
    quantity: Option<String>,
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
    /// Of those of a case, if not all.
    controls: Option<Vec<String>>,
    /// The radii between which all folds are proved.
    range: Option<[String; 2]>,
    /// Parameters, E* and w.
    #[serde(flatten)]
    numbers: BTreeMap<String, String>,
}

/// All cases in the order of their records.
///
/// # Errors
/// What the data have no meaning for.
pub(crate) fn all() -> std::result::Result<Vec<Case>, RecordError> {
    let wrong = |file: &str| {
        let case = file.to_owned();
        move |source| RecordError { case, source }
    };
    let names: Names = read(include_str!("../data/contacts.toml")).map_err(wrong("contacts.toml"))?;
    let mut cases = Vec::new();
    for (file, text) in FILES {
        let rows: File = read(text).map_err(wrong(file))?;
        for row in &rows.case {
            cases.extend(row.cases(file, &names).map_err(wrong(file))?);
        }
    }
    Ok(cases)
}

fn read<T: DeserializeOwned>(text: &str) -> Result<T> {
    toml::from_str(text).map_err(|error| Failure::Data(error.to_string()))
}

fn number(text: &str) -> Result<Literal> {
    text.parse().map_err(|error| Failure::Data(format!("{text}: {error}")))
}

impl Row {
    fn cases(&self, file: &'static str, names: &Names) -> Result<Vec<Case>> {
        let mut contacts = Vec::new();
        for name in &self.contacts {
            let contact = names.contact.get(name).ok_or_else(|| Failure::Data(format!("no contact {name}")))?;
            contacts.push((Some(name), contact));
        }
        contacts.extend(self.profile.iter().map(|contact| (self.name.as_ref(), contact)));
        let mut cases = Vec::new();
        for (name, row) in contacts {
            let contact = row.contact()?;
            let name = name.cloned().unwrap_or_else(|| contact.profile_name().to_owned());
            let controls: Vec<_> = self.controls.iter().map(|control| Some(control.as_str())).collect();
            let controls = if controls.is_empty() { vec![None] } else { controls };
            if let (Some(label), "critical") = (&row.kappa, self.kind.as_str()) {
                cases.push(self.case(file, names, "kappa", label, row, None, None)?);
            }
            for control in controls {
                let is_record = |control| row.controls.as_ref().is_none_or(|known| known.iter().any(|x| x == control));
                if !control.is_none_or(is_record) {
                    continue;
                }
                let at: Vec<_> = self.at.iter().map(Some).collect();
                for at in if at.is_empty() { vec![None] } else { at } {
                    cases.push(self.case(file, names, &self.kind, &name, row, control, at)?);
                }
            }
        }
        Ok(cases)
    }

    #[expect(clippy::too_many_arguments, reason = "one case of the product of three lists")]
    fn case(
        &self,
        file: &'static str,
        names: &Names,
        kind: &str,
        name: &str,
        row: &ContactRow,
        control: Option<&str>,
        at: Option<&At>,
    ) -> Result<Case> {
        let data = |error: toml::de::Error| Failure::Data(error.to_string());
        let kind_of = Kind::deserialize(StrDeserializer::<toml::de::Error>::new(kind)).map_err(data)?;
        let (label, at) = match at {
            None => Default::default(),
            Some(At::Labelled([label, value])) => (label.clone(), value.clone()),
            Some(At::Plain(text)) => match kind_of {
                Kind::EquilibriumShare | Kind::DoubleRoot => (format!("tau={text}"), power_of_two(text)?),
                _ => (text.clone(), text.clone()),
            },
        };
        let by_control = format!("{kind}-{}", control.unwrap_or_default());
        let keys = [self.formula.as_deref(), Some(at.as_str()), Some(&by_control), Some(kind)];
        let formula = keys.into_iter().flatten().find_map(|key| Some((key, names.formula.get(key)?)));
        let (key, formula) = formula.ok_or_else(|| Failure::Data(format!("no formula {kind}")))?;
        let or_key = |text: &String| if text.is_empty() { key.to_owned() } else { text.clone() };
        let formula = Formula { id: or_key(&formula.id), name: or_key(&formula.name), ..formula.clone() };
        let control_of = match control.map(|control| (control, control.strip_prefix("k="))) {
            None | Some(("indentation", _)) => Control::Indentation,
            Some(("force", _)) => Control::Force,
            Some((_, Some(stiffness))) => Control::Machine { stiffness: number(stiffness)? },
            Some((unknown, None)) => return Err(Failure::Data(format!("no control {unknown}"))),
        };
        let start = match self.start.as_deref() {
            None | Some("largest") => Start::Largest,
            Some("smallest") => Start::Smallest,
            Some(unknown) => return Err(Failure::Data(format!("no start {unknown}"))),
        };
        Ok(Case {
            file,
            kind: kind_of,
            formula,
            name: name.to_owned(),
            contact: Contact { control: control_of, ..row.contact()? },
            has_control: control.is_some(),
            flags: row.flags.clone(),
            at,
            label,
            side: self.side,
            path: self.path.iter().map(|point| number(point)).collect::<Result<_>>()?,
            start,
            release: self.release.unwrap_or(if self.id.is_some() { 2 } else { 1 }),
            id: self.id.clone(),
            quantity: self.quantity.clone(),
        })
    }
}

impl ContactRow {
    /// Under fixed grips.
    fn contact(&self) -> Result<Contact> {
        let mut numbers = self.numbers.clone();
        let terms = self.kind.as_deref().unwrap_or("power").split(" + ");
        let mut term = |kind: &str| {
            let blank = Shape::by_name(kind).ok_or_else(|| Failure::Data(format!("no profile {kind}")))?;
            blank.try_map(|key, ()| {
                number(&numbers.remove(key).ok_or_else(|| Failure::Data(format!("{kind} needs {key}")))?)
            })
        };
        let terms: Vec<Shape<Literal>> = terms.map(&mut term).collect::<Result<_>>()?;
        let mut material = |key| number(numbers.remove(key).as_deref().unwrap_or("1"));
        let (e_star, work_of_adhesion) = (material("e_star")?, material("w")?);
        if let Some(unknown) = numbers.keys().next() {
            return Err(Failure::Data(format!("the profile has no {unknown}")));
        }
        let range = self.range.as_ref().map(|[from, to]| Ok::<_, Failure>([number(from)?, number(to)?])).transpose()?;
        Ok(Contact { terms, e_star, work_of_adhesion, control: Control::Indentation, range })
    }
}

/// 2⁻ᵏ, written `2^-k`, as a decimal; another text as it is.
fn power_of_two(text: &str) -> Result<String> {
    let Some(k) = text.strip_prefix("2^-") else { return Ok(text.to_owned()) };
    let k: u32 = k.parse().map_err(|error| Failure::Data(format!("{text}: {error}")))?;
    Ok(format!("0.{:0>width$}", Integer::from(5).pow(k).to_string(), width = k as usize))
}
