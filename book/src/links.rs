//! Where the links of the project's documents lead in the book.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use mdr_symbolic::derivations::{Entry, entries};

use crate::error::{Error, Result};
use crate::markdown::anchor;

/// The documents that are pages of the book: the file, the page, the part of the contents.
pub(crate) const DOCUMENTS: [(&str, &str, Shelf); 22] = [
    ("docs/validity.md", "validity", Shelf::Front),
    ("docs/theory.md", "theory", Shelf::Front),
    ("docs/figures.md", "figures", Shelf::Front),
    ("docs/errata.md", "errata", Shelf::Front),
    ("docs/reference/README.md", "reference", Shelf::Numbers),
    ("docs/certificates.md", "certificates", Shelf::Numbers),
    ("docs/judged.md", "judged", Shelf::Numbers),
    ("docs/accuracy.md", "accuracy", Shelf::Numbers),
    ("docs/report/README.md", "report", Shelf::Numbers),
    ("docs/compare.md", "compare", Shelf::Numbers),
    ("docs/bugs-found.md", "bugs-found", Shelf::Numbers),
    ("docs/conformance.md", "conformance", Shelf::Numbers),
    ("docs/soundness.md", "soundness", Shelf::Numbers),
    ("docs/proofs/README.md", "proofs", Shelf::Numbers),
    ("docs/scenes.md", "scenes", Shelf::Program),
    ("docs/fit.md", "fit", Shelf::Program),
    ("docs/python.md", "python", Shelf::Program),
    ("docs/jkr.md", "jkr", Shelf::Program),
    ("docs/capi.md", "capi", Shelf::Program),
    ("docs/explorer.md", "explorer-help", Shelf::Program),
    ("docs/design.md", "design", Shelf::Program),
    ("docs/contributing.md", "contributing", Shelf::Program),
];

/// A part of the contents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shelf {
    Front,
    Numbers,
    Program,
}

/// The longest file that is shown as a page, in bytes.
const LONGEST: u64 = 250_000;

/// The heading of an entry: an equation by its number in brackets.
pub(crate) fn heading(entry: &Entry) -> String {
    if is_equation(entry) { format!("({}) {}", entry.id, entry.title) } else { entry.title.to_owned() }
}

/// Whether the entry is an equation of the paper.
pub(crate) fn is_equation(entry: &Entry) -> bool {
    entry.id.starts_with(|c: char| c.is_ascii_digit())
}

/// The links of one document, and the files that all documents so far have asked for.
pub(crate) struct Links<'a> {
    root: &'a Path,
    document: String,
    wanted: &'a mut BTreeSet<String>,
}

impl<'a> Links<'a> {
    /// The links of a document, given by its path from the root.
    pub(crate) fn new(root: &'a Path, document: &str, wanted: &'a mut BTreeSet<String>) -> Self {
        Links { root, document: document.to_owned(), wanted }
    }

    /// The document.
    pub(crate) fn name(&self) -> &str {
        &self.document
    }

    /// Where a link leads in the book; `None` for a folder, which the book has not.
    pub(crate) fn resolve(&mut self, target: &str) -> Result<Option<String>> {
        if target.starts_with('#')
            || target.contains("://")
            || target.starts_with("mailto:")
            || target.contains(".html")
        {
            return Ok(Some(target.to_owned()));
        }
        let (path, fragment) = target.split_once('#').map_or((target, None), |(path, fragment)| (path, Some(fragment)));
        let folder = Path::new(&self.document).parent().unwrap_or(Path::new(""));
        let path = normal(&folder.join(path));
        let hash = fragment.map_or(String::new(), |fragment| format!("#{fragment}"));
        if path == "docs/derivations.md" {
            return Ok(Some(fragment.map_or_else(|| "contents.html".to_owned(), derivation)));
        }
        if path == "README.md" {
            return Ok(Some("index.html".to_owned()));
        }
        if let Some((_, page, _)) = DOCUMENTS.iter().find(|(file, ..)| *file == path) {
            return Ok(Some(format!("{page}.html{hash}")));
        }
        let full = self.root.join(&path);
        if full.is_dir() {
            return Ok(None);
        }
        match self.file(&path)? {
            Some(page) => Ok(Some(format!("{page}{hash}"))),
            None => Err(Error::page(&self.document, format!("the link {target} leads nowhere"))),
        }
    }

    /// The page of a file of the project, if the text is the path of one.
    pub(crate) fn source(&mut self, text: &str) -> Result<Option<String>> {
        let file = text.contains('/') && text.rsplit('/').next().is_some_and(|name| name.contains('.'));
        if file && !text.contains([' ', '*', ':']) && !text.starts_with(['/', '.', '~']) {
            self.file(text)
        } else {
            Ok(None)
        }
    }

    fn file(&mut self, path: &str) -> Result<Option<String>> {
        let Ok(about) = self.root.join(path).metadata() else { return Ok(None) };
        if !about.is_file() {
            return Ok(None);
        }
        self.wanted.insert(path.to_owned());
        Ok(Some(if is_picture(path) || about.len() > LONGEST {
            published(path)
        } else {
            format!("{}.html", published(path))
        }))
    }
}

/// Whether a file is published as it is.
pub(crate) fn is_picture(path: &str) -> bool {
    path.ends_with(".svg") || path.ends_with(".png")
}

/// The place of a file in the book: flat, so that every page finds its assets in the same way.
pub(crate) fn published(path: &str) -> String {
    let name = path.trim_start_matches("docs/").replace('/', "-");
    if is_picture(path) { format!("figures/{name}") } else { format!("source-{name}") }
}

/// The page of an entry, from its anchor in docs/derivations.md.
fn derivation(fragment: &str) -> String {
    let anchored = |entry: &&Entry| {
        let heading = if is_equation(entry) { heading(entry) } else { format!("{} ({})", entry.title, entry.id) };
        anchor(&heading) == fragment
    };
    entries()
        .iter()
        .find(anchored)
        .map_or_else(|| format!("contents.html#{fragment}"), |entry| format!("{}.html", entry.id))
}

/// A path without `.` and `..`.
fn normal(path: &Path) -> String {
    let mut parts = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(parts.pop()),
            Component::CurDir => {}
            part => parts.push(part),
        }
    }
    parts.to_string_lossy().into_owned()
}
