//! From TOML and JSON text to one tree.

use std::path::Path;

use super::tree::{Document, Files, Node, Section};
use crate::error::{Error, Result};

/// Opens a `.toml` or `.json` file. The files that it names are beside it.
///
/// # Errors
/// A file that cannot be read; as [`toml`].
pub(crate) fn open<T>(path: &Path, read: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
    let name = path.display().to_string();
    let text = std::fs::read_to_string(path).map_err(|source| Error::Io { name: name.clone(), source })?;
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    let files = |file: &str| std::fs::read(folder.join(file));
    match path.extension() {
        #[cfg(feature = "serde")]
        Some(extension) if extension.eq_ignore_ascii_case("json") => json(&text, &name, &files, read),
        _ => toml(&text, &name, &files, read),
    }
}

/// What `read` makes of a text in TOML, whose numbers keep their text.
///
/// # Errors
/// With name, line and key; always in a build without the feature `toml`.
#[cfg(feature = "toml")]
pub(crate) fn toml<T>(
    text: &str,
    name: &str,
    files: Files<'_>,
    read: impl FnOnce(&Section<'_>) -> Result<T>,
) -> Result<T> {
    let document = Document::new(name, text, "TOML", files);
    read(&Section::top(&document, &toml_node(text, &document)?)?)
}

#[cfg(not(feature = "toml"))]
pub(crate) fn toml<T>(_: &str, name: &str, _: Files<'_>, _: impl FnOnce(&Section<'_>) -> Result<T>) -> Result<T> {
    let source = std::io::Error::new(std::io::ErrorKind::Unsupported, "this build is without the feature `toml`");
    Err(Error::Io { name: name.to_owned(), source })
}

/// The same of a text in JSON, with the keys of TOML; numbers keep their text.
///
/// # Errors
/// As [`toml`].
#[cfg(feature = "serde")]
pub(crate) fn json<T>(
    text: &str,
    name: &str,
    files: Files<'_>,
    read: impl FnOnce(&Section<'_>) -> Result<T>,
) -> Result<T> {
    let document = Document::new(name, text, "JSON", files);
    let root = json::parse(text).map_err(|error| {
        let before: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
        document.place(before..before, "not JSON").refuse(error.to_string())
    })?;
    read(&Section::top(&document, &root)?)
}

#[cfg(feature = "toml")]
fn toml_node(text: &str, document: &Document<'_>) -> Result<Node> {
    use toml::de::{DeTable, DeValue};

    use super::tree::{Content, Entry};

    fn node(span: std::ops::Range<usize>, value: &DeValue<'_>) -> Node {
        let content = match value {
            DeValue::String(text) => Content::Text(text.to_string()),
            DeValue::Integer(integer) if integer.radix() == 10 => Content::Number(integer.as_str().to_owned()),
            DeValue::Float(float) => Content::Number(float.as_str().to_owned()),
            DeValue::Array(items) => {
                Content::List(items.iter().map(|item| node(item.span(), item.get_ref())).collect())
            }
            DeValue::Table(table) => Content::Table(entries(table)),
            _ => Content::Other,
        };
        Node { span, content, type_name: value.type_str() }
    }

    fn entries(table: &DeTable<'_>) -> Vec<Entry> {
        let entry = |(key, value): (&toml::Spanned<_>, &toml::Spanned<DeValue<'_>>)| {
            let name: &std::borrow::Cow<'_, str> = key.get_ref();
            Entry { key: name.to_string(), span: key.span(), value: node(value.span(), value.get_ref()) }
        };
        table.iter().map(entry).collect()
    }

    match DeTable::parse(text) {
        Ok(table) => Ok(Node { span: 0..0, content: Content::Table(entries(table.get_ref())), type_name: "table" }),
        Err(error) => {
            let why = error.message().lines().next().unwrap_or("not TOML").to_owned();
            Err(document.place(error.span().unwrap_or(0..0), "not TOML").refuse(why))
        }
    }
}

#[cfg(feature = "serde")]
mod json {
    use std::fmt;

    use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
    use serde_json::value::RawValue;

    use super::super::tree::{Content, Entry, Node};

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
                    while let Some((key, value)) = map.next_entry::<String, &'de RawValue>()? {
                        if entries.iter().any(|(known, _)| *known == key) {
                            return Err(serde::de::Error::custom(format!("duplicate key `{key}`")));
                        }
                        entries.push((key, value));
                    }
                    Ok(Entries(entries))
                }
            }

            deserializer.deserialize_map(Collect)
        }
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
