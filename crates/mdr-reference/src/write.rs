//! Records to JSON Lines and CSV, and back from JSON Lines.

use crate::json::{Json, quoted, read};
use crate::record::{Certified, Method, Record};

impl Record {
    /// The record on one line, without the line's end. It ends with a hash of all that stands before: FNV-1a of 64 bits,
    /// against accidents, not against forgery.
    pub fn to_json(&self) -> String {
        let body = self.body();
        let hash = fnv(body.as_bytes());
        format!("{body},\"hash\":\"{hash:016x}\"}}")
    }

    /// All fields but the hash, and no closing bracket.
    fn body(&self) -> String {
        let or_null = |text: Option<String>| text.unwrap_or_else(|| "null".to_owned());
        let text = |text: Option<&str>| or_null(text.map(quoted));
        let value = self.value.as_ref();
        let texts = |list: &[String]| list.iter().map(|text| quoted(text)).collect::<Vec<_>>().join(",");
        let pairs = |list: Vec<(&String, String)>| {
            list.iter().map(|(key, value)| format!("{}:{value}", quoted(key))).collect::<Vec<_>>().join(",")
        };
        let methods: Vec<_> = self
            .methods
            .iter()
            .map(|Method { name, rigorous }| format!("{{\"name\":{},\"rigorous\":{rigorous}}}", quoted(name)))
            .collect();
        let fields = [
            ("id", quoted(&self.id)),
            ("release", self.release.to_string()),
            ("profile", quoted(&self.profile)),
            ("formula", quoted(&self.formula)),
            ("inputs", format!("{{{}}}", pairs(self.inputs.iter().map(|(k, v)| (k, quoted(v))).collect()))),
            ("quantity", quoted(&self.quantity)),
            ("unit", quoted(&self.unit)),
            ("control", text(self.control.as_deref())),
            ("status", quoted(self.status.name())),
            ("mid", text(value.map(|value| value.mid.as_str()))),
            ("rad", text(value.map(|value| value.rad.as_str()))),
            ("digits", or_null(value.map(|value| value.digits.to_string()))),
            ("log10", or_null(self.log10.map(|log10| log10.to_string()))),
            ("f64", text(self.hexadecimal().as_deref())),
            ("scale", text(self.scale.as_deref())),
            ("condition", format!("{{{}}}", pairs(self.condition.iter().map(|(k, v)| (k, v.to_string())).collect()))),
            ("difficulty", quoted(self.difficulty.name())),
            ("methods", format!("[{}]", methods.join(","))),
            ("proof", format!("[{}]", texts(&self.proof))),
            ("flags", format!("[{}]", texts(&self.flags))),
            ("refs", format!("[{}]", texts(&self.refs))),
        ];
        let fields: Vec<_> = fields.iter().map(|(key, value)| format!("\"{key}\":{value}")).collect();
        format!("{{{}", fields.join(","))
    }

    /// The record that stands on a line.
    ///
    /// # Errors
    /// What is wrong with the line: its form, a field, or a hash that belongs to another content.
    pub fn from_json(line: &str) -> Result<Record, String> {
        let json = read(line)?;
        let fields = Fields(&json);
        let value = match fields.optional("mid")? {
            None => None,
            Some(mid) => Some(Certified { mid, rad: fields.text("rad")?, digits: fields.parsed("digits")? }),
        };
        let condition = fields.entries("condition")?.into_iter();
        let condition = condition.map(|(key, value)| Ok((key, number(&value, "condition")?)));
        let log10 = fields.optional("log10")?;
        let record = Record {
            id: fields.text("id")?,
            release: fields.parsed("release")?,
            profile: fields.text("profile")?,
            formula: fields.text("formula")?,
            inputs: fields.entries("inputs")?,
            quantity: fields.text("quantity")?,
            unit: fields.text("unit")?,
            control: fields.optional("control")?,
            status: fields.text("status")?.parse()?,
            value,
            log10: log10.map(|text| number(&text, "log10")).transpose()?,
            scale: fields.optional("scale")?,
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
    pub const CSV_HEADER: [&str; 22] = [
        "id",
        "release",
        "profile",
        "formula",
        "inputs",
        "quantity",
        "unit",
        "control",
        "status",
        "mid",
        "rad",
        "digits",
        "log10",
        "f64",
        "scale",
        "condition",
        "difficulty",
        "methods",
        "proof",
        "flags",
        "refs",
        "hash",
    ];

    /// The record as the fields of a row, lists separated by blanks; of the methods the first is rigorous. The hash is that of
    /// the line of JSON.
    pub fn to_csv(&self) -> [String; 22] {
        let value = self.value.as_ref();
        let inputs: Vec<_> = self.inputs.iter().map(|(key, value)| format!("{key}={value}")).collect();
        let condition: Vec<_> = self.condition.iter().map(|(key, value)| format!("{key}={value}")).collect();
        let methods: Vec<_> = self.methods.iter().map(|method| method.name.as_str()).collect();
        [
            self.id.clone(),
            self.release.to_string(),
            self.profile.clone(),
            self.formula.clone(),
            inputs.join(" "),
            self.quantity.clone(),
            self.unit.clone(),
            self.control.clone().unwrap_or_default(),
            self.status.to_string(),
            value.map(|value| value.mid.clone()).unwrap_or_default(),
            value.map(|value| value.rad.clone()).unwrap_or_default(),
            value.map(|value| value.digits.to_string()).unwrap_or_default(),
            self.log10.map(|log10| log10.to_string()).unwrap_or_default(),
            self.hexadecimal().unwrap_or_default(),
            self.scale.clone().unwrap_or_default(),
            condition.join(" "),
            self.difficulty.to_string(),
            methods.join(" "),
            self.proof.join(" "),
            self.flags.join(" "),
            self.refs.join("; "),
            format!("{:016x}", fnv(self.body().as_bytes())),
        ]
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
        let entry = |(name, value): &(std::borrow::Cow<'_, str>, Json<'_>)| {
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
    text.parse().map_err(|_| format!("{key} is no number"))
}

/// FNV-1a (Fowler, Noll & Vo), 64 bits.
fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x100_0000_01b3))
}
