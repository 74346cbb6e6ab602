//! The figures of the paper, at the entries that they show: from the headings and pictures of docs/figures.md.

use std::collections::BTreeMap;
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

/// Gives each image of a picture whose panels can stand below each other the proportions that it then has, as a variable of its
/// style: in a narrow page it would else keep those of the sheet, and be too small to read.
pub(crate) fn stack(files: &mut BTreeMap<String, Vec<u8>>) {
    let stacked: Vec<(String, String)> = files
        .iter()
        .filter(|(name, _)| name.ends_with(".svg"))
        .filter_map(|(name, bytes)| Some((format!("src=\"{name}\""), ratio(str::from_utf8(bytes).ok()?)?.to_owned())))
        .collect();
    for (_, bytes) in files.iter_mut().filter(|(name, _)| name.ends_with(".html")) {
        let Ok(mut page) = String::from_utf8(bytes.clone()) else { continue };
        for (source, ratio) in &stacked {
            if page.contains(source) {
                page = page.replace(source, &format!("{source} style=\"--stacked:{ratio}\""));
            }
        }
        *bytes = page.into_bytes();
    }
}

/// Width over height of a picture whose panels stand below each other.
fn ratio(svg: &str) -> Option<&str> {
    let (_, rest) = svg.split_once("{width:100%;aspect-ratio:")?;
    rest.split_once('}').map(|(ratio, _)| ratio)
}

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
