//! The chapters, which follow the paper, and the entries of each.

use mdr_symbolic::derivations::{Entry, entries};

/// A chapter: the name of its page and of its text, its title, its entries.
pub(crate) struct Chapter {
    pub(crate) page: &'static str,
    pub(crate) title: &'static str,
    entries: &'static [&'static str],
}

const fn chapter(page: &'static str, title: &'static str, entries: &'static [&'static str]) -> Chapter {
    Chapter { page, title, entries }
}

/// All chapters. An entry that none of them names belongs to the last but one.
pub(crate) const CHAPTERS: [Chapter; 12] = [
    chapter("method", "The method", &["1.1", "1.2", "1.3", "1.4", "1.5", "1.6"]),
    chapter("equilibrium", "Equilibrium and stability", &["1.7", "1.8", "1.9", "1.10", "paper-statements"]),
    chapter("power-laws", "Power laws and their two regimes", &["1.11"]),
    chapter("kappa", "The factor κ", &["1.12", "kappa-recurrences", "kappa-growth", "kappa-series", "kappa-elliptic"]),
    chapter(
        "critical",
        "The critical state",
        &["1.13", "1.14", "1.15", "1.16", "1.17", "critical-indentation", "universal-curves"],
    ),
    chapter("half", "The exponent one half", &["1.18", "1.19", "threshold-force"]),
    chapter(
        "control",
        "Dead loads and machines",
        &["critical-force", "critical-machine", "machine-folds", "machine-half"],
    ),
    chapter("waviness", "Waviness", &["wavy", "wave", "wave-approach"]),
    chapter("media", "Other media", &["media", "graded", "line-contact"]),
    chapter("energy", "Energy and hysteresis", &["work-pull-off", "work-jump-in", "hysteresis"]),
    chapter("profiles", "The library of profiles", &["kendall"]),
    chapter("limits", "Limits of the theory", &["maugis-dugdale"]),
];

impl Chapter {
    /// Its entries.
    pub(crate) fn entries(&self) -> Vec<&'static Entry> {
        let named = |entry: &Entry| CHAPTERS.iter().any(|chapter| chapter.entries.contains(&entry.id));
        let rest = |entry: &Entry| self.page == CHAPTERS[CHAPTERS.len() - 2].page && !named(entry);
        let ordered = self.entries.iter().filter_map(|id| entries().iter().find(|entry| entry.id == *id));
        ordered.chain(entries().iter().filter(|entry| rest(entry))).collect()
    }
}

/// All entries in the order of the book.
pub(crate) fn order() -> Vec<&'static Entry> {
    CHAPTERS.iter().flat_map(Chapter::entries).collect()
}
