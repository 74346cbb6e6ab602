//! The bibliography: `book/bibliography.tsv`, one work a line.

use std::path::Path;

use maud::{Markup, html};

use crate::error::{Error, Result};
use crate::text::read;

/// A work: its key, the words that a reference to it contains, its description, and its identifier if that was looked up.
struct Work {
    key: String,
    part: String,
    text: String,
    identifier: Option<String>,
}

/// All works.
pub(crate) struct Bibliography(Vec<Work>);

impl Bibliography {
    pub(crate) fn read(root: &Path) -> Result<Self> {
        let file = "book/bibliography.tsv";
        let text = read(root, file)?;
        let works = text.lines().filter(|line| !line.starts_with('#') && !line.is_empty()).map(|line| {
            let cells: Vec<_> = line.split('\t').map(str::to_owned).collect();
            let [key, part, text, identifier] =
                <[String; 4]>::try_from(cells).map_err(|_| Error::page(file, format!("four cells: {line}")))?;
            Ok(Work { key, part, text, identifier: Some(identifier).filter(|identifier| identifier != "-") })
        });
        works.collect::<Result<_>>().map(Bibliography)
    }

    /// The key of the work that a reference names.
    pub(crate) fn key(&self, reference: &str) -> Option<&str> {
        self.0.iter().find(|work| reference.contains(&work.part)).map(|work| work.key.as_str())
    }

    pub(crate) fn page(&self) -> Markup {
        html! {
            p { "Identifiers are given where they could be looked up." }
            dl.works { @for work in &self.0 {
                dt id=(work.key) { (work.key) }
                dd { (work.text)
                    @if let Some(identifier) = &work.identifier {
                        @let address = if identifier.starts_with("10.") { format!("https://doi.org/{identifier}") } else { identifier.clone() };
                        " " a rel="external" href=(address) { (identifier) } } }
            } }
        }
    }
}
