//! From TOML and JSON text to one tree.

use std::path::{Path, PathBuf};

use mdr_core::text::excerpt;

#[cfg(feature = "toml")]
use super::tree::Node;
use super::tree::{DEEPEST, Document, Files, Section};
use crate::error::{Error, Result};
use crate::files;

/// The text of a file or a pipe, read once.
pub struct Source {
    name: String,
    text: String,
    /// Where the files are that it names.
    folder: PathBuf,
    #[cfg_attr(not(feature = "serde"), expect(dead_code, reason = "without serde no text is read as JSON"))]
    is_json: bool,
}

impl Source {
    /// A `.toml` or `.json` file; what has another name is JSON where it begins with a brace.
    ///
    /// # Errors
    /// A file that cannot be read, is no text or too large.
    pub fn open(path: &Path) -> Result<Source> {
        let name = path.display().to_string();
        let read = files::argument(path).and_then(files::text);
        let text = read.map_err(|source| Error::Io { name: name.clone(), source })?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let named = |format: &str| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case(format));
        let is_json = named("json") || !named("toml") && is_json(&text);
        Ok(Source { name, text, folder, is_json })
    }

    /// What `read` makes of it. The files that it names are beside it.
    ///
    /// # Errors
    /// With name, line and key.
    pub fn read<T>(&self, read: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
        let files = |file: &str| files::named(self.folder.join(file));
        #[cfg(feature = "serde")]
        if self.is_json {
            return json(&self.text, &self.name, &files, read);
        }
        toml(&self.text, &self.name, &files, read)
    }
}

/// Whether a text is JSON: no TOML begins with a brace.
pub(crate) fn is_json(text: &str) -> bool {
    text.trim_start().starts_with('{')
}

/// Opens a `.toml` or `.json` file. The files that it names are beside it.
///
/// # Errors
/// A file that cannot be read; with name, line and key what `read` refuses.
pub fn open<T>(path: &Path, read: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
    Source::open(path)?.read(read)
}

/// Nothing is nested so deep.
fn too_deep() -> String {
    format!("nested deeper than {DEEPEST} levels of tables and lists; a sum may have all its terms in one list")
}

/// A text without the byte order mark with which some editors begin it.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// What `read` makes of a text in TOML, whose numbers keep their text.
///
/// # Errors
/// With name, line and key; always in a build without the feature `toml`.
#[cfg(feature = "toml")]
pub fn toml<T>(text: &str, name: &str, files: Files<'_>, read: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
    let text = without_mark(text);
    let document = Document::new(name, text, "TOML", files);
    read(&Section::top(&document, &toml_node(text, &document)?)?)
}

/// An error: this build is without the feature `toml`.
///
/// # Errors
/// Always.
#[cfg(not(feature = "toml"))]
pub fn toml<T>(_: &str, name: &str, _: Files<'_>, _: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
    let source = std::io::Error::new(std::io::ErrorKind::Unsupported, "this build is without the feature `toml`");
    Err(Error::Io { name: name.to_owned(), source })
}

/// What `read` makes of a text in JSON, with the keys of TOML; numbers keep their text.
///
/// # Errors
/// A text that is no JSON or is nested too deep, and what `read` refuses, with name, line and key.
#[cfg(feature = "serde")]
pub fn json<T>(text: &str, name: &str, files: Files<'_>, read: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
    let text = without_mark(text);
    let document = Document::new(name, text, "JSON", files);
    if let Some(at) = json::too_deep(text) {
        return Err(document.place(at..at, "not JSON").refuse(too_deep()));
    }
    let root = json::parse(text).map_err(|error| {
        let before: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
        document.place(before..before, "not JSON").refuse(excerpt(&error.to_string()).to_string())
    })?;
    read(&Section::top(&document, &root)?)
}

#[cfg(feature = "toml")]
fn toml_node(text: &str, document: &Document<'_>) -> Result<Node> {
    use toml::de::{DeTable, DeValue};

    use super::tree::{Content, Entry};

    /// `None` if it is nested too deep.
    fn node(span: std::ops::Range<usize>, value: &DeValue<'_>, depth: usize) -> Option<Node> {
        if depth > DEEPEST {
            return None;
        }
        let content = match value {
            DeValue::String(text) => Content::Text(text.to_string()),
            DeValue::Integer(integer) if integer.radix() == 10 => Content::Number(integer.as_str().to_owned()),
            DeValue::Float(float) => Content::Number(float.as_str().to_owned()),
            DeValue::Array(items) => {
                let items = items.iter().map(|item| node(item.span(), item.get_ref(), depth + 1));
                Content::List(items.collect::<Option<_>>()?)
            }
            DeValue::Table(table) => Content::Table(entries(table, depth)?),
            _ => Content::Other,
        };
        Some(Node { span, content, type_name: value.type_str() })
    }

    fn entries(table: &DeTable<'_>, depth: usize) -> Option<Vec<Entry>> {
        let entry = |(key, value): (&toml::Spanned<_>, &toml::Spanned<DeValue<'_>>)| {
            let name: &std::borrow::Cow<'_, str> = key.get_ref();
            let value = node(value.span(), value.get_ref(), depth + 1)?;
            Some(Entry { key: name.to_string(), span: key.span(), value })
        };
        table.iter().map(entry).collect()
    }

    if let Some(at) = super::depth::too_deep(text) {
        return Err(document.place(at..at, "not TOML").refuse(too_deep()));
    }
    match DeTable::parse(text) {
        Ok(table) => match entries(table.get_ref(), 0) {
            Some(entries) => Ok(Node { span: 0..0, content: Content::Table(entries), type_name: "table" }),
            None => Err(document.place(0..0, "not TOML").refuse(too_deep())),
        },
        Err(error) => {
            let why = excerpt(error.message().lines().next().unwrap_or("not TOML")).to_string();
            Err(document.place(error.span().unwrap_or(0..0), "not TOML").refuse(why))
        }
    }
}

#[cfg(feature = "serde")]
mod json {
    use std::collections::HashSet;
    use std::fmt;

    use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
    use serde_json::value::RawValue;

    use super::super::tree::{Content, DEEPEST, Entry, Node};

    /// A table as its entries in their order; a key that is given twice is refused.
    struct Entries<'a>(Vec<(String, &'a RawValue)>);

    impl<'de> Deserialize<'de> for Entries<'de> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            struct Collect;

            impl<'de> Visitor<'de> for Collect {
                type Value = Entries<'de>;

                fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                    f.write_str("a table")
                }

                fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                    let mut entries: Vec<(String, &RawValue)> = Vec::new();
                    let mut known = HashSet::new();
                    while let Some((key, value)) = map.next_entry::<String, &'de RawValue>()? {
                        if !known.insert(key.clone()) {
                            let why = format!("duplicate key `{}`", mdr_core::text::excerpt(&key));
                            return Err(serde::de::Error::custom(why));
                        }
                        entries.push((key, value));
                    }
                    Ok(Entries(entries))
                }
            }

            deserializer.deserialize_map(Collect)
        }
    }

    /// The first byte that is nested too deep, by the brackets outside of strings.
    pub(crate) fn too_deep(text: &str) -> Option<usize> {
        let (mut depth, mut quoted, mut escaped) = (0_usize, false, false);
        text.bytes().position(|byte| {
            match byte {
                _ if escaped => escaped = false,
                b'\\' if quoted => escaped = true,
                b'"' => quoted = !quoted,
                b'[' | b'{' if !quoted => depth += 1,
                b']' | b'}' if !quoted => depth = depth.saturating_sub(1),
                _ => {}
            }
            // The scene itself is the first level.
            depth > DEEPEST + 1
        })
    }

    pub(crate) fn parse(text: &str) -> serde_json::Result<Node> {
        node(text, serde_json::from_str(text)?)
    }

    fn node(text: &str, value: &RawValue) -> serde_json::Result<Node> {
        let raw = value.get();
        // The raw value is a part of the text.
        let start = (raw.as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
        let (content, type_name) = match raw.as_bytes().first() {
            Some(b'"') => (Content::Text(serde_json::from_str(raw)?), "string"),
            Some(b'[') => {
                let items: Vec<&RawValue> = serde_json::from_str(raw)?;
                (Content::List(items.into_iter().map(|item| node(text, item)).collect::<Result<_, _>>()?), "array")
            }
            Some(b'{') => {
                let Entries(entries) = serde_json::from_str(raw)?;
                let entry = |(key, value)| {
                    let value = node(text, value)?;
                    Ok(Entry { key, span: value.span.clone(), value })
                };
                (Content::Table(entries.into_iter().map(entry).collect::<serde_json::Result<_>>()?), "object")
            }
            Some(b't' | b'f') => (Content::Other, "boolean"),
            Some(b'n') => (Content::Other, "null"),
            _ => (Content::Number(raw.to_owned()), "number"),
        };
        Ok(Node { span: start..start + raw.len(), content, type_name })
    }
}
