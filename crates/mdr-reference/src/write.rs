//! Conversion of records to JSON Lines and CSV, and from JSON Lines.

use std::borrow::Cow;

use crate::decimal::Decimal;
use crate::json::{Json, notation, object, read, text, texts};
use crate::record::{Certified, Method, Record};

impl Record {
    /// The record on one line, without a line break. It ends with a hash of the preceding text: FNV-1a of 64 bits,
    /// against accidents, not against forgery.
    pub fn to_json(&self) -> String {
        let body = self.body();
        let hash = fnv(body.as_bytes());
        format!("{body},\"hash\":\"{hash:016x}\"}}")
    }

    /// All fields except the hash, without a closing bracket.
    fn body(&self) -> String {
        let fields = FIELDS.map(|(name, field)| format!("\"{name}\":{}", field(self)));
        format!("{{{}", fields.join(","))
    }

    /// The record of a line.
    ///
    /// # Errors
    /// A message about the fault of the line: its form, a field, or a hash that does not match the content.
    pub fn from_json(line: &str) -> Result<Record, String> {
        let json = read(line)?;
        let fields = Fields(&json);
        let value = match fields.optional("mid")? {
            None => None,
            Some(mid) => Some(Certified {
                mid: decimal(mid, "mid")?,
                rad: decimal(fields.text("rad")?, "rad")?,
                digits: fields.parsed("digits")?,
            }),
        };
        let condition = fields.entries("condition")?.into_iter();
        let condition = condition.map(|(key, value)| Ok((key, number(&value, "condition")?)));
        let inputs = fields.entries("inputs")?.into_iter();
        let inputs = inputs.map(|(name, text)| decimal(text, &name).map(|text| (name, text)));
        let log10 = fields.optional("log10")?;
        let record = Record {
            id: fields.text("id")?,
            release: fields.parsed("release")?,
            profile: fields.text("profile")?,
            formula: fields.text("formula")?,
            inputs: inputs.collect::<Result<_, String>>()?,
            quantity: fields.text("quantity")?,
            unit: fields.text("unit")?,
            control: fields.optional("control")?,
            status: fields.text("status")?.parse()?,
            value,
            log10: log10.map(|text| number(&text, "log10")).transpose()?,
            scale: fields.optional("scale")?.map(|text| decimal(text, "scale")).transpose()?,
            condition: condition.collect::<Result<_, String>>()?,
            difficulty: fields.text("difficulty")?.parse()?,
            methods: fields.methods()?,
            proof: fields.texts("proof")?,
            flags: fields.texts("flags")?,
            refs: fields.texts("refs")?,
        };
        if fields.optional("f64")? != record.hexadecimal() {
            return Err("f64 is not the double nearest to mid".to_owned());
        }
        let hash = format!("{:016x}", fnv(record.body().as_bytes()));
        if fields.text("hash")? == hash { Ok(record) } else { Err(format!("the hash of this content is {hash}")) }
    }

    /// The header of [`Record::to_csv`]: the fields of a line of JSON, in their order.
    pub const CSV_HEADER: [&str; 22] = {
        let (mut names, mut i) = (["hash"; 22], 0);
        while i < FIELDS.len() {
            names[i] = FIELDS[i].0;
            i += 1;
        }
        names
    };

    /// The record as the fields of a row, lists separated by blanks; the first method is rigorous. The hash is that of
    /// the line of JSON.
    pub fn to_csv(&self) -> [String; 22] {
        let hash = format!("{:016x}", fnv(self.body().as_bytes()));
        let separator = |name: &str| if name == "refs" { "; " } else { " " };
        let mut cells = FIELDS.iter().map(|(name, field)| cell(&field(self), separator(name))).chain([hash]);
        std::array::from_fn(|_| cells.next().unwrap_or_default())
    }
}

/// Reads a field from a record.
type Take = for<'a> fn(&'a Record) -> Json<'a>;

/// All fields except the hash, in order.
const FIELDS: [(&str, Take); 21] = [
    ("id", |record| text(&record.id)),
    ("release", |record| notation(record.release)),
    ("profile", |record| text(&record.profile)),
    ("formula", |record| text(&record.formula)),
    ("inputs", |record| object(record.inputs.iter().map(|(name, value)| (&**name, text(value))))),
    ("quantity", |record| text(&record.quantity)),
    ("unit", |record| text(&record.unit)),
    ("control", |record| record.control.as_deref().map_or(Json::Null, text)),
    ("status", |record| text(record.status.name())),
    ("mid", |record| record.value.as_ref().map_or(Json::Null, |value| text(&value.mid))),
    ("rad", |record| record.value.as_ref().map_or(Json::Null, |value| text(&value.rad))),
    ("digits", |record| record.value.as_ref().map_or(Json::Null, |value| notation(value.digits))),
    ("log10", |record| record.log10.map_or(Json::Null, notation)),
    ("f64", |record| record.hexadecimal().map_or(Json::Null, |text| Json::Text(text.into()))),
    ("scale", |record| record.scale.as_deref().map_or(Json::Null, text)),
    ("condition", |record| object(record.condition.iter().map(|(name, size)| (&**name, notation(size))))),
    ("difficulty", |record| text(record.difficulty.name())),
    ("methods", |record| Json::List(record.methods.iter().map(method).collect())),
    ("proof", |record| texts(&record.proof)),
    ("flags", |record| texts(&record.flags)),
    ("refs", |record| texts(&record.refs)),
];

fn method(Method { name, rigorous }: &Method) -> Json<'_> {
    object([("name", text(name)), ("rigorous", Json::Bool(*rigorous))])
}

/// A cell of a spreadsheet: pairs without braces, lists with their separator, of objects the names.
fn cell(json: &Json<'_>, separator: &str) -> String {
    match json {
        Json::Null | Json::Bool(_) => String::new(),
        Json::Number(text) | Json::Text(text) => text.to_string(),
        Json::List(items) => {
            let items = items.iter().map(|item| cell(item.get("name").unwrap_or(item), separator));
            items.collect::<Vec<_>>().join(separator)
        }
        Json::Object(entries) => {
            let entries = entries.iter().map(|(name, value)| format!("{name}={}", cell(value, separator)));
            entries.collect::<Vec<_>>().join(" ")
        }
    }
}

/// The fields of a line.
struct Fields<'a, 'b>(&'a Json<'b>);

impl Fields<'_, '_> {
    fn get(&self, key: &str) -> Result<&Json<'_>, String> {
        self.0.get(key).ok_or_else(|| format!("there is no {key}"))
    }

    fn text(&self, key: &str) -> Result<String, String> {
        self.optional(key)?.ok_or_else(|| format!("{key} is null"))
    }

    fn optional(&self, key: &str) -> Result<Option<String>, String> {
        match self.get(key)? {
            Json::Null => Ok(None),
            value => value.as_text().map(|text| Some(text.to_owned())).ok_or_else(|| format!("{key} is no text")),
        }
    }

    fn parsed<T: std::str::FromStr>(&self, key: &str) -> Result<T, String> {
        self.text(key)?.parse().map_err(|_| format!("{key} is no number"))
    }

    fn entries(&self, key: &str) -> Result<Vec<(String, String)>, String> {
        let Json::Object(entries) = self.get(key)? else { return Err(format!("{key} is no object")) };
        let entry = |(name, value): &(Cow<'_, str>, Json<'_>)| {
            value.as_text().map(|text| (name.to_string(), text.to_owned())).ok_or_else(|| format!("{key} has no texts"))
        };
        entries.iter().map(entry).collect()
    }

    fn list(&self, key: &str) -> Result<&[Json<'_>], String> {
        match self.get(key)? {
            Json::List(list) => Ok(list),
            _ => Err(format!("{key} is no list")),
        }
    }

    fn texts(&self, key: &str) -> Result<Vec<String>, String> {
        let text = |value: &Json<'_>| value.as_text().map(str::to_owned).ok_or_else(|| format!("{key} has no texts"));
        self.list(key)?.iter().map(text).collect()
    }

    fn methods(&self) -> Result<Vec<Method>, String> {
        let method = |value: &Json<'_>| {
            let name = Fields(value).text("name")?;
            Ok(Method { name, rigorous: value.get("rigorous") == Some(&Json::Bool(true)) })
        };
        self.list("methods")?.iter().map(method).collect()
    }
}

fn number(text: &str, key: &str) -> Result<f64, String> {
    text.parse().ok().filter(|number: &f64| number.is_finite()).ok_or_else(|| format!("{key} is no number"))
}

/// The text of a number, unchanged.
fn decimal(text: String, key: &str) -> Result<String, String> {
    text.parse::<Decimal>().map_err(|error| format!("{key} is {error}"))?;
    Ok(text)
}

/// FNV-1a (Fowler, Noll & Vo), 64 bits.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}
