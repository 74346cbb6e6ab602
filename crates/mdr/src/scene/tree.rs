//! Scene files as a tree of values, so that every complaint has a file, a line and a key. TOML and JSON give the same tree.

use std::cell::RefCell;
use std::io;
use std::ops::Range;

use mdr_core::number::Literal;
use mdr_core::text::excerpt;
use mdr_core::units::{NumberError, SiUnit};

use super::place::Location;
use crate::error::{Error, Place, Result};

/// Reads a file that a scene names, relative to the scene.
pub type Files<'f> = &'f dyn Fn(&str) -> io::Result<Vec<u8>>;

/// A value with its bytes in the text.
#[derive(Debug)]
pub(crate) struct Node {
    pub(crate) span: Range<usize>,
    pub(crate) content: Content,
    /// The name of its type: `string`, `integer`.
    pub(crate) type_name: &'static str,
}

#[derive(Debug)]
pub(crate) enum Content {
    Text(String),
    /// As it is written.
    Number(String),
    List(Vec<Node>),
    Table(Vec<Entry>),
    Other,
}

/// A key of a table with its value.
#[derive(Debug)]
pub(crate) struct Entry {
    pub(crate) key: String,
    pub(crate) span: Range<usize>,
    pub(crate) value: Node,
}

/// How deep tables and lists may be nested, counted from the scene, which is 0: a term of a sum within a sum is 4 deeper.
pub(crate) const DEEPEST: usize = 64;

/// The most entries of a list; those of measured rows have a limit of their own.
pub(crate) const MOST_ENTRIES: usize = 100_000;

/// A scene file, and the numbers that have been read from it.
pub(crate) struct Document<'f> {
    name: String,
    /// Where its lines end.
    line_ends: Vec<usize>,
    /// `TOML` or `JSON`.
    format: &'static str,
    files: Files<'f>,
    /// With their places.
    pub(super) numbers: RefCell<Vec<(Literal, Location)>>,
}

impl<'f> Document<'f> {
    pub(crate) fn new(name: &str, text: &str, format: &'static str, files: Files<'f>) -> Self {
        let line_ends = text.match_indices('\n').map(|(end, _)| end).collect();
        Document { name: name.to_owned(), line_ends, format, files, numbers: RefCell::default() }
    }

    pub(crate) fn place(&self, span: Range<usize>, key: &str) -> Location {
        let line = 1 + self.line_ends.partition_point(|end| *end < span.start);
        Location { place: Some(Place { file: self.name.clone(), line }), key: key.to_owned() }
    }
}

/// A table of the document, from which keys are taken by name. [`finish`](Section::finish) refuses what nobody took.
pub struct Section<'a> {
    pub(super) document: &'a Document<'a>,
    /// `profile` or `profile.term`; empty at the top.
    name: String,
    span: Range<usize>,
    entries: &'a [Entry],
    asked: RefCell<Vec<&'static str>>,
}

impl<'a> Section<'a> {
    pub(crate) fn top(document: &'a Document<'a>, root: &'a Node) -> Result<Self> {
        let value = InputValue { document, key: String::new(), node: root };
        let mut section = value.section()?;
        section.span = 0..0;
        Ok(section)
    }

    /// The value of a key, if it is there.
    pub fn optional(&self, key: &'static str) -> Option<InputValue<'a>> {
        let mut asked = self.asked.borrow_mut();
        if !asked.contains(&key) {
            asked.push(key);
        }
        let entry = self.entries.iter().find(|entry| entry.key == key)?;
        Some(InputValue { document: self.document, key: self.full(key), node: &entry.value })
    }

    /// The value of a key.
    ///
    /// # Errors
    /// A key that is not there, with the place of the table.
    pub fn required(&self, key: &'static str) -> Result<InputValue<'a>> {
        self.optional(key).ok_or_else(|| self.missing(&[key]))
    }

    /// Exactly one of several keys that say the same in different ways; its position in `keys` with its value.
    ///
    /// # Errors
    /// None of the keys, or more than one.
    pub fn one_of(&self, keys: &[&'static str]) -> Result<(usize, InputValue<'a>)> {
        let mut given = keys.iter().enumerate().filter_map(|(index, key)| Some((index, self.optional(key)?)));
        match (given.next(), given.next()) {
            (Some(found), None) => Ok(found),
            (Some((first, _)), Some((_, second))) => {
                Err(second.refuse(format!("cannot be given together with `{}`", keys[first])))
            }
            (None, _) => Err(self.missing(keys)),
        }
    }

    /// The table under a key.
    ///
    /// # Errors
    /// A key that is not there, or is no table.
    pub fn section(&self, key: &'static str) -> Result<Section<'a>> {
        self.required(key)?.section()
    }

    /// A table that may be left out.
    ///
    /// # Errors
    /// A value that is no table.
    pub fn optional_section(&self, key: &'static str) -> Result<Option<Section<'a>>> {
        self.optional(key).map(|table| table.section()).transpose()
    }

    /// Where the table begins.
    pub fn place(&self) -> Location {
        self.document.place(self.span.clone(), &self.name)
    }

    /// The place of the first of these keys that is there, else of the table.
    pub fn place_of(&self, keys: &[&'static str]) -> Location {
        let given = keys.iter().find_map(|key| self.optional(key));
        given.map_or_else(|| self.place(), |value| value.place())
    }

    /// Every entry of the table, for tables whose keys are the user's own names.
    pub fn entries(&self) -> impl Iterator<Item = (String, InputValue<'a>)> {
        self.entries.iter().map(|entry| {
            let value = InputValue { document: self.document, key: self.full(&entry.key), node: &entry.value };
            (entry.key.clone(), value)
        })
    }

    /// Refuses the first key that was never asked for, with the nearest name that was.
    ///
    /// # Errors
    /// A key that nobody asked for.
    pub fn finish(&self) -> Result<()> {
        let asked = self.asked.borrow();
        match self.entries.iter().find(|entry| !asked.iter().any(|known| *known == entry.key)) {
            None => Ok(()),
            Some(Entry { key, span, .. }) => {
                Err(self.document.place(span.clone(), &self.full(key)).refuse(unknown_name("key", key, &asked)))
            }
        }
    }

    /// None of `keys` is there: a near miss is the likelier mistake.
    fn missing(&self, keys: &[&str]) -> Error {
        if let Some(entry) = self.entries.iter().find(|entry| nearest(&entry.key, keys).is_some()) {
            let place = self.document.place(entry.span.clone(), &self.full(&entry.key));
            return place.refuse(unknown_name("key", &entry.key, keys));
        }
        let place = if self.name.is_empty() { "the scene".to_owned() } else { format!("[{}]", excerpt(&self.name)) };
        let name = if self.name.is_empty() { keys[0] } else { &self.name };
        let why = format!("missing key `{}` in {place}", keys.join("` or `"));
        self.document.place(self.span.clone(), name).refuse(why)
    }

    fn full(&self, key: &str) -> String {
        if self.name.is_empty() { key.to_owned() } else { format!("{}.{key}", self.name) }
    }
}

/// A value with the key it stands under.
pub struct InputValue<'a> {
    document: &'a Document<'a>,
    key: String,
    node: &'a Node,
}

impl<'a> InputValue<'a> {
    /// The complaint `file:line: key: why` about this value.
    pub fn refuse(&self, why: impl Into<String>) -> Error {
        self.place().refuse(why)
    }

    /// Where it stands.
    pub fn place(&self) -> Location {
        self.document.place(self.node.span.clone(), &self.key)
    }

    /// The bytes of a file that is named here.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn bytes(&self, file: &str) -> Result<Vec<u8>> {
        (self.document.files)(file).map_err(|error| self.refuse_file(file, &error))
    }

    /// The complaint about a file that is named here, by its path.
    pub fn refuse_file(&self, file: &str, why: &dyn std::fmt::Display) -> Error {
        let folder = std::path::Path::new(&self.document.name).parent().unwrap_or(std::path::Path::new(""));
        let file = folder.join(file).display().to_string();
        self.refuse(format!("{}: {why}", excerpt(&file)))
    }

    /// It is not what is expected.
    fn expected(&self, what: &str) -> Error {
        self.refuse(format!("expected {what}, got a {} {}", self.document.format, self.node.type_name))
    }

    /// An exact number: a number, whose decimals are kept, or a string such as "1e-4", "1/3", or "5 um" in a unit of the dimension of
    /// `unit`.
    ///
    /// # Errors
    /// What is no number, or has a unit of another dimension.
    pub fn number(&self, unit: SiUnit) -> Result<Literal> {
        let number = self.row_number(unit)?;
        self.document.numbers.borrow_mut().push((number.clone(), self.place()));
        Ok(number)
    }

    /// A number of measured data, whose place is not kept for later complaints.
    ///
    /// # Errors
    /// What is no number, or has a unit of another dimension.
    pub fn row_number(&self, unit: SiUnit) -> Result<Literal> {
        let (Content::Text(text) | Content::Number(text)) = &self.node.content else {
            return Err(self.expected("a number"));
        };
        unit.read(text).map_err(|error| self.place().no_number(text, &error))
    }

    /// Why its number has a unit that cannot be its own, if it has.
    pub fn refused_unit(&self, unit: SiUnit) -> Option<Error> {
        let text = self.text().ok()?;
        let error = unit.read(text).err().filter(|error| !matches!(error, NumberError::Literal(_)))?;
        Some(self.place().no_number(text, &error))
    }

    /// A number above zero.
    ///
    /// # Errors
    /// A number that is not above zero, or is none.
    pub fn positive(&self, unit: SiUnit) -> Result<Literal> {
        self.place().require_positive(self.number(unit)?)
    }

    /// Zero or a number above it.
    ///
    /// # Errors
    /// A number below zero, or none.
    pub fn not_negative(&self, unit: SiUnit) -> Result<Literal> {
        let number = self.number(unit)?;
        if number.is_negative() {
            return Err(self.refuse(format!("must not be negative, got {}", excerpt(&number.to_string()))));
        }
        Ok(number)
    }

    /// A list of numbers of a unit, each read by `read`.
    ///
    /// # Errors
    /// A value that is no list, and what `read` refuses.
    pub fn numbers(&self, unit: SiUnit, read: fn(&InputValue<'a>, SiUnit) -> Result<Literal>) -> Result<Vec<Literal>> {
        self.list()?.iter().map(|value| read(value, unit)).collect()
    }

    /// Whether it is a table of keys.
    pub fn is_table(&self) -> bool {
        matches!(self.node.content, Content::Table(_))
    }

    /// The text of a string.
    ///
    /// # Errors
    /// A value that is no string.
    pub fn text(&self) -> Result<&'a str> {
        match &self.node.content {
            Content::Text(text) => Ok(text),
            _ => Err(self.expected("a string")),
        }
    }

    /// One of several names.
    ///
    /// # Errors
    /// A string that is none of the names, with the nearest.
    pub fn choice<T: Copy>(&self, what: &str, choices: &[(&'static str, T)]) -> Result<T> {
        let text = self.text()?;
        choices.iter().find(|(name, _)| *name == text).map(|(_, choice)| *choice).ok_or_else(|| {
            let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
            self.refuse(unknown_name(what, text, &names))
        })
    }

    /// A whole number within bounds.
    ///
    /// # Errors
    /// Another number, or none.
    pub fn whole(&self, least: u32, most: u32) -> Result<u32> {
        let number = self.number(SiUnit::One)?;
        let whole = number.to_string().parse::<u32>().ok().filter(|value| (least..=most).contains(value));
        let given = number.to_string();
        whole.ok_or_else(|| {
            self.refuse(format!("must be a whole number from {least} to {most}, got {}", excerpt(&given)))
        })
    }

    /// A list of at most 100 000 entries.
    ///
    /// # Errors
    /// A value that is no list, or a longer one.
    pub fn list(&self) -> Result<Vec<InputValue<'a>>> {
        self.list_of(MOST_ENTRIES, "ask for fewer, or in several scenes")
    }

    /// A list of so many entries at `most`, or of fewer by the `remedy`.
    ///
    /// # Errors
    /// A value that is no list, or a longer one.
    pub fn list_of(&self, most: usize, remedy: &str) -> Result<Vec<InputValue<'a>>> {
        match &self.node.content {
            Content::List(items) if items.len() > most => {
                Err(self.refuse(format!("a list of {} entries; at most {most} are read: {remedy}", items.len())))
            }
            Content::List(items) => {
                let item = |node| InputValue { document: self.document, key: self.key.clone(), node };
                Ok(items.iter().map(item).collect())
            }
            _ => Err(self.expected("a list")),
        }
    }

    /// The table that it is.
    ///
    /// # Errors
    /// A value that is no table.
    pub fn section(&self) -> Result<Section<'a>> {
        match &self.node.content {
            Content::Table(entries) => Ok(Section {
                document: self.document,
                name: self.key.clone(),
                span: self.node.span.clone(),
                entries,
                asked: RefCell::default(),
            }),
            _ if self.key.is_empty() => {
                let why = format!("expected keys with values, got a {} {}", self.document.format, self.node.type_name);
                Err(self.document.place(self.node.span.clone(), "the whole text").refuse(why))
            }
            _ => Err(self.expected(&format!("a table [{}]", excerpt(&self.key)))),
        }
    }
}

/// "unknown key `wavelenght`; did you mean `wavelength`?", or the list of names when none is near.
pub(crate) fn unknown_name(what: &str, name: &str, known: &[&str]) -> String {
    unknown(what, name, known, &format!("`{}`", known.join("`, `")))
}

/// The complaint about an unknown name: `did you mean …?`, or an excerpt of the list of known names, which may come from an input.
pub fn unknown_name_of_input(what: &str, name: &str, known: &[&str]) -> String {
    unknown(what, name, known, &excerpt(&format!("`{}`", known.join("`, `"))).to_string())
}

fn unknown(what: &str, name: &str, known: &[&str], all: &str) -> String {
    match nearest(name, known) {
        Some(candidate) => format!("unknown {what} `{}`; did you mean `{}`?", excerpt(name), excerpt(candidate)),
        None => format!("unknown {what} `{}`; expected one of {all}", excerpt(name)),
    }
}

/// The known name that differs from `name` by a slip of the finger or two.
fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    /// A longer name is no slip, and the distance takes memory as the product of the lengths.
    const LONGEST: usize = 100;
    if name.len() > LONGEST {
        return None;
    }
    let known: Vec<&str> = known.iter().filter(|candidate| candidate.len() <= LONGEST).copied().collect();
    let distance = |candidate: &&str| strsim::damerau_levenshtein(name, candidate);
    let candidate = *known.iter().min_by_key(|candidate| distance(candidate))?;
    (1..=2.min(name.chars().count() / 3)).contains(&distance(&candidate)).then_some(candidate)
}
