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

impl Entry {
    /// The theorems that belong to the entry.
    pub fn theorems(&self) -> impl Iterator<Item = Theorem> {
        theorems().filter(|theorem| theorem.entry == self.id)
    }
}
