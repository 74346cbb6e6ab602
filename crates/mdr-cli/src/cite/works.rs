//! Works on which an answer rests, as in the bibliography of the book.

use std::fmt::Write as _;

use serde::Serialize;
use serde_json::Value;

/// A work, and what it is cited for.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub(super) struct Work {
    /// Its key in a bibliography.
    pub(super) key: &'static str,
    /// What it is cited for.
    pub(super) why: &'static str,
    authors: &'static [&'static str],
    title: &'static str,
    /// Null of a text without one.
    journal: Option<&'static str>,
    volume: Option<u32>,
    year: Option<u32>,
    pages: Option<&'static str>,
    doi: Option<&'static str>,
}

pub(super) const POPOV: Work = Work {
    key: "Popov",
    why: "Theory",
    authors: &["V. L. Popov"],
    title: "Surface profiles with zero and finite adhesion force and adhesion instabilities",
    journal: None,
    volume: None,
    year: None,
    pages: None,
    doi: None,
};

const JKR: Work = Work {
    key: "JKR1971",
    why: "Adhesive contact of a paraboloid",
    authors: &["K. L. Johnson", "K. Kendall", "A. D. Roberts"],
    title: "Surface energy and the contact of elastic solids",
    journal: Some("Proceedings of the Royal Society of London A"),
    volume: Some(324),
    year: Some(1971),
    pages: Some("301-313"),
    doi: Some("10.1098/rspa.1971.0141"),
};

const GUDURU: Work = Work {
    key: "Guduru2007",
    why: "Wavy paraboloid",
    authors: &["P. R. Guduru"],
    title: "Detachment of a rigid solid from an elastic wavy surface: theory",
    journal: Some("Journal of the Mechanics and Physics of Solids"),
    volume: Some(55),
    year: Some(2007),
    pages: Some("445-472"),
    doi: None,
};

const MAUGIS: Work = Work {
    key: "Maugis1992",
    why: "Finite range of adhesion",
    authors: &["D. Maugis"],
    title: "Adhesion of spheres: the JKR-DMT transition using a Dugdale model",
    journal: Some("Journal of Colloid and Interface Science"),
    volume: Some(150),
    year: Some(1992),
    pages: Some("243-269"),
    doi: None,
};

/// The works of an answer beside the theory.
pub(super) fn of(answer: &Value) -> Vec<&'static Work> {
    let profile = answer.get("profile").and_then(Value::as_str);
    let exponent = answer.pointer("/inputs/n").and_then(Value::as_str);
    let mut works = Vec::new();
    if profile == Some("paraboloid") || exponent == Some("2") {
        works.push(&JKR);
    }
    if profile == Some("wavy-paraboloid") {
        works.push(&GUDURU);
    }
    if answer.get("validity").is_some_and(|validity| !validity.is_null()) {
        works.push(&MAUGIS);
    }
    works
}

impl Work {
    /// A reference in one line.
    pub(super) fn text(&self) -> String {
        let mut text = format!("{}, {}", self.authors.join(", "), self.title);
        // Writing to a string cannot fail.
        if let Some(journal) = self.journal {
            let _ = write!(text, ", {journal}");
        }
        if let Some(volume) = self.volume {
            let _ = write!(text, " {volume}");
        }
        if let Some(year) = self.year {
            let _ = write!(text, " ({year})");
        }
        if let Some(pages) = self.pages {
            let _ = write!(text, " {}", pages.replace('-', "–"));
        }
        text.push('.');
        if let Some(doi) = self.doi {
            let _ = write!(text, " https://doi.org/{doi}");
        }
        text
    }

    /// An entry of a bibliography.
    pub(super) fn bibtex(&self) -> String {
        let fields = [
            ("author", Some(self.authors.join(" and "))),
            ("title", Some(format!("{{{}}}", self.title))),
            ("journal", self.journal.map(str::to_owned)),
            ("volume", self.volume.map(|volume| volume.to_string())),
            ("year", self.year.map(|year| year.to_string())),
            ("pages", self.pages.map(|pages| pages.replace('-', "--"))),
            ("doi", self.doi.map(str::to_owned)),
        ];
        let kind = if self.journal.is_some() { "article" } else { "unpublished" };
        let mut text = format!("@{kind}{{{},\n", self.key);
        for (name, value) in fields {
            if let Some(value) = value {
                let _ = writeln!(text, "  {name} = {{{value}}},");
            }
        }
        if self.journal.is_none() {
            text += "  note = {the text at hand names no journal and no date},\n";
        }
        text + "}\n"
    }
}
