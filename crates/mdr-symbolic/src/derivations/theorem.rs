//! The theorems of docs/proofs, which Coq's kernel has checked.

use super::Entry;

/// A theorem, with its statement in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Theorem {
    /// The id of the entry to which it belongs.
    pub entry: &'static str,
    /// Its name in Coq.
    pub name: &'static str,
    /// The file below docs/proofs.
    pub file: &'static str,
    /// What it says.
    pub says: &'static str,
}

/// The table that `make proofs` compares with the files.
const TABLE: &str = include_str!("../../data/theorems.tsv");

/// All of them, in the order of the paper.
pub fn theorems() -> impl Iterator<Item = Theorem> {
    TABLE.lines().filter(|line| !line.starts_with('#')).filter_map(|line| {
        let mut cells = line.split('\t');
        Some(Theorem { entry: cells.next()?, name: cells.next()?, file: cells.next()?, says: cells.next()? })
    })
}

impl Entry {
    /// The theorems that belong to the entry.
    pub fn theorems(&self) -> impl Iterator<Item = Theorem> {
        theorems().filter(|theorem| theorem.entry == self.id)
    }
}
