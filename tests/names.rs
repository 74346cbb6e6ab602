//! The name of a public type is unique in the workspace: a reader who finds `Row` in a search must not ask which of nine it is.
//!
//! Names that modules share on purpose are listed here with the reason.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Why modules share names.
const CRATE: &str = "each crate has its own error and result, as is usual in Rust";
const DATA: &str = "mdr-reference stands alone, and has the vocabulary of records and judgements for other programs";
const ALGEBRA: &str = "mdr-symbolic stands alone; its expressions are those of an algebra, its verdicts those of steps";
const COLUMNS: &str = "mdr::columns mirrors the answers of scenes in f64, and Python and C have these names";
const DOOR: &str =
    "the library restates what its parts compute: inputs with places and exact numbers, outputs with promises";
const WING: &str = "the two wings and the library answer one question, and never meet";

/// A name, how many public types have it, and why.
const SHARED: &[(&str, usize, &str)] = &[
    ("Answer", 3, DATA),
    ("Claim", 2, DATA),
    ("Decimal", 2, DATA),
    ("Dissipation", 2, DOOR),
    ("Equilibria", 3, WING),
    ("Error", 4, CRATE),
    ("Event", 2, COLUMNS),
    ("Expression", 2, ALGEBRA),
    ("Family", 2, DATA),
    ("Formula", 2, ALGEBRA),
    ("Function", 2, ALGEBRA),
    ("LoadingPath", 2, COLUMNS),
    ("Mark", 2, DATA),
    ("PowerLaw", 2, DOOR),
    ("Profile", 2, DOOR),
    ("Result", 4, CRATE),
    ("Scene", 2, DOOR),
    ("State", 2, COLUMNS),
    ("States", 2, COLUMNS),
    ("Status", 2, DATA),
    ("Table", 2, DATA),
    ("Verdict", 2, ALGEBRA),
];

/// The public types that a source declares, also inside macros; tests in it are left out.
fn declared(source: &str) -> Vec<&str> {
    let code = source.split("#[cfg(test)]").next().unwrap();
    let kinds = ["pub struct ", "pub enum ", "pub trait ", "pub type ", "pub union "];
    let rest = code.lines().filter_map(|line| kinds.iter().find_map(|kind| line.trim_start().strip_prefix(kind)));
    rest.map(|rest| rest.split(|letter: char| !(letter.is_alphanumeric() || letter == '_')).next().unwrap())
        .filter(|name| !name.is_empty())
        .collect()
}

/// The sources of all packages.
fn sources() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let crates = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path().join("src"));
    let mut folders: Vec<PathBuf> = crates.chain([root.join("book/src")]).collect();
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    assert!(found.len() > 300, "{}", found.len());
    found
}

#[test]
fn public_names_of_types_are_unique() {
    let mut places: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for path in sources() {
        let source = fs::read_to_string(&path).unwrap();
        for name in declared(&source) {
            places.entry(name.to_owned()).or_default().push(path.display().to_string());
        }
    }
    assert!(places.len() > 200, "{}", places.len());
    let allowed = |name: &str| SHARED.iter().find(|(shared, ..)| *shared == name).map_or(1, |(_, count, _)| *count);
    let wrong: Vec<_> = places.iter().filter(|(name, places)| places.len() > allowed(name)).collect();
    assert!(wrong.is_empty(), "rename these, or say in tests/names.rs why modules share them: {wrong:#?}");
    let stale: Vec<_> =
        SHARED.iter().filter(|(name, ..)| places.get(*name).is_none_or(|places| places.len() < 2)).collect();
    assert!(stale.is_empty(), "unique by now: {stale:#?}");
}

#[test]
fn declarations_are_seen() {
    let source = "pub struct Row<R> {\npub(crate) struct Hidden;\n    pub enum Kind {\n// pub struct No;\npub type Answer = u8;\n\
                  pub trait Real: Clone {\npub struct $name {\n#[cfg(test)]\nmod tests { pub struct Tested; }";
    assert_eq!(declared(source), ["Row", "Kind", "Answer", "Real"]);
}

/// A reader lands on a comment from a search: it does not lean on the one before it.
#[test]
fn comments_stand_alone() {
    let begins = |line: &str| {
        let text = ["///", "//!"].iter().find_map(|mark| line.trim_start().strip_prefix(mark)).unwrap_or_default();
        ["The same", "Those of", "As ["].iter().any(|start| text.trim_start().starts_with(start))
    };
    assert!(begins("    /// The same for a machine.") && !begins("/// On the same branch."));
    let mut found = Vec::new();
    for path in sources() {
        let source = fs::read_to_string(&path).unwrap();
        let leaning = |line: &&str| begins(line) || line.contains("///") && line.to_lowercase().contains("none where");
        found.extend(source.lines().filter(leaning).map(|line| format!("{}: {}", path.display(), line.trim())));
    }
    assert!(found.is_empty(), "comments that do not stand alone:\n{}", found.join("\n"));
}
