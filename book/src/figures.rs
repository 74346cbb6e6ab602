//! The figures of the paper, at the entries that they show: from the headings and pictures of docs/figures.md.

use std::path::Path;

use maud::{Markup, html};

use crate::error::Result;
use crate::text::read;

/// Which entry each picture belongs to.
const PLACES: [(&str, &str); 7] = [
    ("figure-1a.svg", "1.9"),
    ("figure-1b.svg", "1.10"),
    ("figure-2.svg", "1.10"),
    ("figure-3.svg", "1.11"),
    ("figure-4.svg", "wavy"),
    ("figure-5.svg", "wave"),
    ("hysteresis.svg", "hysteresis"),
];

/// The pictures with their titles.
pub(crate) struct Figures(Vec<(&'static str, &'static str, String)>);

impl Figures {
    /// Reads the titles that the pictures themselves carry.
    pub(crate) fn read(root: &Path) -> Result<Self> {
        let mut figures = Vec::new();
        for (file, entry) in PLACES {
            let svg = read(root, &format!("docs/figures/{file}"))?;
            let title = svg
                .split_once("<title>")
                .and_then(|(_, rest)| rest.split_once("</title>"))
                .map_or(file, |(title, _)| title);
            figures.push((file, entry, title.to_owned()));
        }
        Ok(Figures(figures))
    }

    /// The pictures of an entry.
    pub(crate) fn of(&self, entry: &str) -> Vec<Markup> {
        let found = self.0.iter().filter(|(_, of, _)| *of == entry);
        found
            .map(|(file, _, title)| {
                html! { figure.plot { a href="figures.html" { img src={ "figures/figures-" (file) } alt=(title) loading="lazy"; } figcaption { (title) ", computed" } } }
            })
            .collect()
    }
}
