//! The theorems of docs/proofs, which Coq's kernel has checked.

use super::Entry;
use crate::table::rows;

/// A theorem, with its statement in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Theorem {
    /// The id of the entry to which it belongs.
    pub entry: &'static str,
    /// Its name in Coq.
    pub name: &'static str,
    /// The file below docs/proofs.
    pub file: &'static str,
    /// The statement in words.
    pub says: &'static str,
}

/// The table that `make proofs` compares with the files.
const TABLE: &str = include_str!("../../data/theorems.tsv");

/// All of them, in the order of the paper.
pub fn theorems() -> impl Iterator<Item = Theorem> {
    rows(TABLE).map(|[entry, name, file, says]| Theorem { entry, name, file, says })
}

/// What the theorems of an entry are about: a theorem of algebra is none of physics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TheoremBasis {
    /// They follow from the energy of the foundation.
    Derived,
    /// They are algebra with a law that is taken from the literature.
    CitedLaw(&'static str),
    /// They turn a definition into another form.
    Definition(&'static str),
}

/// The entries that are not derived from the energy.
const BASIS: &str = include_str!("../../data/basis.tsv");

impl TheoremBasis {
    /// The basis in words, to stand after the word "theorem".
    pub fn words(self) -> String {
        match self {
            TheoremBasis::Derived => "derived".to_owned(),
            TheoremBasis::CitedLaw(law) => format!("algebra of a cited law: {law}"),
            TheoremBasis::Definition(of) => format!("algebra of a definition: {of}"),
        }
    }

    /// The basis in one or two words.
    pub fn word(self) -> &'static str {
        match self {
            TheoremBasis::Derived => "derived",
            TheoremBasis::CitedLaw(_) => "cited law",
            TheoremBasis::Definition(_) => "definition",
        }
    }
}

impl Entry {
    /// What the theorems of the entry rest on; `None` for an entry without a theorem.
    ///
    /// ```
    /// use mdr_symbolic::derivations::{TheoremBasis, entry};
    /// let basis = |id| entry(id).and_then(|entry| entry.basis());
    /// assert_eq!(basis("1.5"), Some(TheoremBasis::Derived));
    /// assert_eq!(basis("1.2"), Some(TheoremBasis::CitedLaw("the stiffness of the flat punch")));
    /// assert_eq!(basis("maugis-dugdale"), None);
    /// ```
    pub fn basis(&self) -> Option<TheoremBasis> {
        self.theorems().next()?;
        let row = rows(BASIS).find(|[entry, _, _]| *entry == self.id);
        Some(match row {
            Some([_, "law", law]) => TheoremBasis::CitedLaw(law),
            Some([_, _, of]) => TheoremBasis::Definition(of),
            None => TheoremBasis::Derived,
        })
    }

    /// The theorems that belong to the entry.
    pub fn theorems(&self) -> impl Iterator<Item = Theorem> {
        theorems().filter(|theorem| theorem.entry == self.id)
    }
}
