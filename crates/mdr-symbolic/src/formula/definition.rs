//! The named formulas of the derivations.

use std::sync::LazyLock;

use super::Formula;
use crate::error::Result;
use crate::table::rows;

/// A named formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Definition(usize);

struct Entry {
    name: &'static str,
    text: &'static str,
    tex: &'static str,
    coq: &'static str,
    formula: &'static str,
}

/// All definitions, from `data/definitions.tsv`.
static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let entry = |[name, text, tex, coq, formula]: [&'static str; 5]| Entry { name, text, tex, coq, formula };
    rows(include_str!("../../data/definitions.tsv")).map(entry).collect()
});

/// The formulas of the definitions, parsed.
static FORMULAS: LazyLock<Vec<Result<Formula>>> =
    LazyLock::new(|| ENTRIES.iter().map(|entry| entry.formula.parse()).collect());

impl Definition {
    /// The definition with this name.
    pub fn named(name: &str) -> Option<Self> {
        ENTRIES.iter().position(|entry| entry.name == name).map(Definition)
    }

    /// Every definition.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..ENTRIES.len()).map(Definition)
    }

    /// As text for a reader.
    pub fn text(self) -> &'static str {
        ENTRIES[self.0].text
    }

    /// In TeX.
    pub fn tex(self) -> &'static str {
        ENTRIES[self.0].tex
    }

    /// In Coq.
    pub(crate) fn coq(self) -> &'static str {
        ENTRIES[self.0].coq
    }

    /// The defining formula.
    ///
    /// # Errors
    /// None for the definitions of this crate, all of which are parsed in its tests.
    pub fn formula(self) -> Result<&'static Formula> {
        FORMULAS[self.0].as_ref().map_err(Clone::clone)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_definition_is_a_formula() {
        for definition in Definition::all() {
            assert!(definition.formula().is_ok(), "{}: {:?}", definition.text(), definition.formula());
        }
    }
}
