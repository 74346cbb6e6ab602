//! Reading TOML so that every complaint has a file, a line and a key.

use std::cell::RefCell;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use mdr_core::number::Literal;
use mdr_numeric::table;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{Failure, Result};

/// A scene file, and the numbers that have been read from it.
pub(super) struct Document {
    path: PathBuf,
    text: String,
    numbers: RefCell<Vec<(Literal, Place)>>,
}

/// Where something stands in a scene.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    file: String,
    line: usize,
    key: String,
}

impl Place {
    /// The complaint `file:line: key: why`.
    pub(crate) fn refuse(&self, why: impl Into<String>) -> Failure {
        Failure::Scene { file: self.file.clone(), line: self.line, key: self.key.clone(), why: why.into() }
    }
}

impl Document {
    /// The file, or standard input for `-`.
    pub(super) fn open(path: &Path) -> Result<Self> {
        if path == Path::new("-") {
            let mut text = String::new();
            let read = std::io::stdin().read_to_string(&mut text);
            read.map_err(|error| Failure::file("standard input", error))?;
            return Ok(Self::from_text("<stdin>", text));
        }
        let text = std::fs::read_to_string(path).map_err(|error| Failure::file(path.display().to_string(), error))?;
        Ok(Self::from_text(path, text))
    }

    pub(super) fn from_text(path: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Document { path: path.into(), text: text.into(), numbers: RefCell::default() }
    }

    /// A file named in the scene: relative to the folder of the scene.
    pub(super) fn beside(&self, file: &str) -> PathBuf {
        self.path.parent().unwrap_or(Path::new("")).join(file)
    }

    pub(super) fn parse(&self) -> Result<DeTable<'_>> {
        DeTable::parse(&self.text).map(Spanned::into_inner).map_err(|error| {
            let why = error.message().lines().next().unwrap_or("not TOML").to_owned();
            self.place(error.span().unwrap_or(0..0), "not TOML").refuse(why)
        })
    }

    /// How many numbers have been read.
    pub(super) fn numbers_read(&self) -> usize {
        self.numbers.borrow().len()
    }

    /// The numbers that have been read, each with its place.
    pub(super) fn take_numbers(&self) -> Vec<(Literal, Place)> {
        self.numbers.take()
    }

    fn place(&self, span: Range<usize>, key: &str) -> Place {
        let before = &self.text[..span.start.min(self.text.len())];
        let line = 1 + before.bytes().filter(|byte| *byte == b'\n').count();
        Place { file: self.path.display().to_string(), line, key: key.to_owned() }
    }
}

/// A table of the document, from which keys are taken by name. [`finish`](Section::finish) refuses what nobody took.
pub(super) struct Section<'a> {
    document: &'a Document,
    /// `profile` or `profile.term`; empty at the top.
    name: String,
    span: Range<usize>,
    table: &'a DeTable<'a>,
    asked: RefCell<Vec<&'static str>>,
}

impl<'a> Section<'a> {
    pub(super) fn top(document: &'a Document, table: &'a DeTable<'a>) -> Self {
        Section { document, name: String::new(), span: 0..0, table, asked: RefCell::default() }
    }

    pub(super) fn document(&self) -> &'a Document {
        self.document
    }

    pub(super) fn optional(&self, key: &'static str) -> Option<Value<'a>> {
        self.asked.borrow_mut().push(key);
        let value = self.table.get(key)?;
        Some(Value { document: self.document, key: self.full(key), span: value.span(), value: value.get_ref() })
    }

    pub(super) fn required(&self, key: &'static str) -> Result<Value<'a>> {
        self.optional(key).ok_or_else(|| self.missing(&[key]))
    }

    /// Exactly one of several keys that say the same in different ways; its position in `keys` with its value.
    pub(super) fn one_of(&self, keys: &[&'static str]) -> Result<(usize, Value<'a>)> {
        let mut given = keys.iter().enumerate().filter_map(|(index, key)| Some((index, self.optional(key)?)));
        match (given.next(), given.next()) {
            (Some(found), None) => Ok(found),
            (Some((first, _)), Some((_, second))) => {
                Err(second.refuse(format!("cannot be given together with `{}`", keys[first])))
            }
            (None, _) => Err(self.missing(keys)),
        }
    }

    pub(super) fn section(&self, key: &'static str) -> Result<Section<'a>> {
        self.required(key)?.section()
    }

    /// A table that may be left out.
    pub(super) fn optional_section(&self, key: &'static str) -> Result<Option<Section<'a>>> {
        self.optional(key).map(|table| table.section()).transpose()
    }

    /// Where the table begins.
    pub(super) fn place(&self) -> Place {
        self.document.place(self.span.clone(), &self.name)
    }

    /// The place of the first of these keys that is there, else of the table.
    pub(super) fn place_of(&self, keys: &[&'static str]) -> Place {
        let given = keys.iter().find_map(|key| self.optional(key));
        given.map_or_else(|| self.place(), |value| value.place())
    }

    /// Every entry of the table, for tables whose keys are the user's own names.
    pub(super) fn entries(&self) -> impl Iterator<Item = (String, Value<'a>)> {
        self.table.iter().map(|(key, value)| {
            let name = key.get_ref().to_string();
            (
                name.clone(),
                Value { document: self.document, key: self.full(&name), span: value.span(), value: value.get_ref() },
            )
        })
    }

    /// Refuses the first key that was never asked for, with the nearest name that was.
    pub(super) fn finish(&self) -> Result<()> {
        let asked = self.asked.borrow();
        let unknown = self.table.iter().find(|(key, _)| !asked.iter().any(|known| *known == key.get_ref().as_ref()));
        match unknown {
            None => Ok(()),
            Some((key, _)) => {
                let why = unknown_name("key", key.get_ref(), &asked);
                Err(self.document.place(key.span(), &self.full(key.get_ref())).refuse(why))
            }
        }
    }

    /// None of `keys` is there: a near miss is the likelier mistake.
    fn missing(&self, keys: &[&str]) -> Failure {
        let near = self.table.iter().find(|(given, _)| nearest(given.get_ref(), keys).is_some());
        if let Some((given, _)) = near {
            let place = self.document.place(given.span(), &self.full(given.get_ref()));
            return place.refuse(unknown_name("key", given.get_ref(), keys));
        }
        let place = if self.name.is_empty() { "the scene".to_owned() } else { format!("[{}]", self.name) };
        let name = if self.name.is_empty() { keys[0] } else { &self.name };
        let why = format!("missing key `{}` in {place}", keys.join("` or `"));
        self.document.place(self.span.clone(), name).refuse(why)
    }

    fn full(&self, key: &str) -> String {
        if self.name.is_empty() { key.to_owned() } else { format!("{}.{key}", self.name) }
    }
}

/// A value with the key it stands under.
pub(super) struct Value<'a> {
    document: &'a Document,
    key: String,
    span: Range<usize>,
    value: &'a DeValue<'a>,
}

impl<'a> Value<'a> {
    /// This value is refused.
    pub(super) fn refuse(&self, why: impl Into<String>) -> Failure {
        self.place().refuse(why)
    }

    pub(super) fn place(&self) -> Place {
        self.document.place(self.span.clone(), &self.key)
    }

    /// An exact number: a TOML number, whose decimals are kept, or a string such as "1e-4" or "1/3".
    pub(super) fn number(&self) -> Result<Literal> {
        let text = match self.value {
            DeValue::String(text) => text.as_ref(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str(),
            DeValue::Float(float) => float.as_str(),
            other => return Err(self.refuse(format!("expected a number, got a TOML {}", other.type_str()))),
        };
        let number: Literal = text.parse().map_err(|error| self.refuse(format!("`{text}` is {error}")))?;
        self.document.numbers.borrow_mut().push((number.clone(), self.place()));
        Ok(number)
    }

    /// A length: a number, or one with its unit, `"2 nm"`, in metres.
    pub(super) fn length(&self) -> Result<Literal> {
        match self.value {
            DeValue::String(text) if text.ends_with(|c: char| !c.is_ascii_digit() && c != '.') => {
                let unit = "expected a number, alone or with a unit of length, such as \"2 nm\"";
                let number = table::length(text).ok_or_else(|| self.refuse(format!("{unit}, got `{text}`")))?;
                self.document.numbers.borrow_mut().push((number.clone(), self.place()));
                Ok(number)
            }
            _ => self.number(),
        }
    }

    /// A number above zero.
    pub(super) fn positive(&self) -> Result<Literal> {
        let number = self.number()?;
        if number.is_zero() || number.is_negative() {
            return Err(self.refuse(format!("must be positive, got {number}")));
        }
        Ok(number)
    }

    /// Zero or a number above it.
    pub(super) fn not_negative(&self) -> Result<Literal> {
        let number = self.number()?;
        if number.is_negative() {
            return Err(self.refuse(format!("must not be negative, got {number}")));
        }
        Ok(number)
    }

    /// A list of numbers, each read by `read`.
    pub(super) fn numbers(&self, read: fn(&Value<'a>) -> Result<Literal>) -> Result<Vec<Literal>> {
        self.list()?.iter().map(read).collect()
    }

    pub(super) fn text(&self) -> Result<&'a str> {
        match self.value {
            DeValue::String(text) => Ok(text.as_ref()),
            other => Err(self.refuse(format!("expected a string, got a TOML {}", other.type_str()))),
        }
    }

    /// One of several names.
    pub(super) fn choice<T: Copy>(&self, what: &str, choices: &[(&'static str, T)]) -> Result<T> {
        let text = self.text()?;
        choices.iter().find(|(name, _)| *name == text).map(|(_, choice)| *choice).ok_or_else(|| {
            let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
            self.refuse(unknown_name(what, text, &names))
        })
    }

    pub(super) fn whole(&self, least: u32, most: u32) -> Result<u32> {
        let number = self.number()?;
        let whole = number.to_string().parse::<u32>().ok().filter(|value| (least..=most).contains(value));
        whole.ok_or_else(|| self.refuse(format!("must be a whole number from {least} to {most}, got {number}")))
    }

    pub(super) fn list(&self) -> Result<Vec<Value<'a>>> {
        match self.value {
            DeValue::Array(items) => Ok(items.iter().map(|item| self.item(item)).collect()),
            other => Err(self.refuse(format!("expected a list, got a TOML {}", other.type_str()))),
        }
    }

    pub(super) fn section(&self) -> Result<Section<'a>> {
        match self.value {
            DeValue::Table(table) => Ok(Section {
                document: self.document,
                name: self.key.clone(),
                span: self.span.clone(),
                table,
                asked: RefCell::default(),
            }),
            other => Err(self.refuse(format!("expected a table [{}], got a TOML {}", self.key, other.type_str()))),
        }
    }

    fn item(&self, item: &'a Spanned<DeValue<'a>>) -> Value<'a> {
        Value { document: self.document, key: self.key.clone(), span: item.span(), value: item.get_ref() }
    }
}

/// "unknown key `wavelenght`; did you mean `wavelength`?", or the list of names when none is near.
fn unknown_name(what: &str, name: &str, known: &[&str]) -> String {
    match nearest(name, known) {
        Some(candidate) => format!("unknown {what} `{name}`; did you mean `{candidate}`?"),
        None => format!("unknown {what} `{name}`; expected one of `{}`", known.join("`, `")),
    }
}

/// The known name that differs from `name` by a slip of the finger or two.
fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let distance = |candidate: &&str| strsim::damerau_levenshtein(name, candidate);
    let candidate = *known.iter().min_by_key(|candidate| distance(candidate))?;
    (1..=2.min(name.chars().count() / 3)).contains(&distance(&candidate)).then_some(candidate)
}
