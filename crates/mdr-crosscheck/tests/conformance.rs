//! What docs/conformance.md names exists: functions, checks, tests and entries of the derivations.

#![allow(clippy::unwrap_used, reason = "the sources of the workspace are there")]

#[allow(dead_code, reason = "this test needs the files alone")]
mod sources;

use std::fs;
use std::path::{Path, PathBuf};

use mdr_symbolic::derivations::entries;
use sources::sources;

/// The crates that a path of the table may begin with, or be meant in.
const CRATES: [&str; 5] = ["mdr-analytic", "mdr-numeric", "mdr-core", "mdr", "mdr-crosscheck"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The sources of a crate.
fn texts(name: &str) -> Vec<String> {
    sources(&root().join("crates").join(name).join("src"))
        .iter()
        .map(|file| fs::read_to_string(file).unwrap())
        .collect()
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether a name is a word of a text.
fn mentions(text: &str, name: &str) -> bool {
    text.match_indices(name)
        .any(|(at, _)| !text[..at].ends_with(is_word) && !text[at + name.len()..].starts_with(is_word))
}

/// Whether a text declares a name: an item, or a variant of an enum.
fn declares(text: &str, name: &str) -> bool {
    let code = text.lines().map(str::trim_start).filter(|line| !line.starts_with("//"));
    code.into_iter().any(|line| {
        let item = ["fn", "struct", "enum", "trait", "mod", "type", "const", "static"].iter().any(|kind| {
            line.split_once(&format!("{kind} ")).is_some_and(|(before, after)| {
                !before.ends_with(is_word) && after.split(|c| !is_word(c)).next() == Some(name)
            })
        });
        let variant =
            line.strip_prefix(name).is_some_and(|rest| [",", " {", "("].iter().any(|end| rest.starts_with(end)));
        item || variant
    })
}

/// Whether there is what a path names: its last segment is declared in the crate, in a file that knows the type before it.
fn exists(path: &str) -> bool {
    let mut segments: Vec<&str> = path.split("::").collect();
    let of_crate = |segment: &str| CRATES.into_iter().find(|name| name.replace('-', "_") == segment);
    let crates = match of_crate(segments[0]) {
        Some(name) => {
            segments.remove(0);
            vec![name]
        }
        None => CRATES.to_vec(),
    };
    let texts: Vec<String> = crates.into_iter().flat_map(texts).collect();
    let [.., last] = segments[..] else { return true };
    let owner =
        segments.len().checked_sub(2).map(|at| segments[at]).filter(|owner| owner.starts_with(char::is_uppercase));
    let modules = segments[..segments.len() - 1].iter().filter(|segment| segment.starts_with(char::is_lowercase));
    let known = |module: &&str| texts.iter().any(|text| declares(text, module));
    modules.into_iter().all(known)
        && texts.iter().any(|text| declares(text, last) && owner.is_none_or(|owner| mentions(text, owner)))
}

/// The code spans of a cell.
fn spans(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// Function, checks, tests, verdict and physics of each row; a row may end before its physics.
fn rows(document: &str) -> Vec<[String; 5]> {
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let rows = document.lines().filter(|line| line.starts_with('|') && !line.starts_with("|---")).map(cells);
    rows.filter(|cells| !cells.iter().any(|cell| cell == "function"))
        .map(|cells| {
            // A row of the paper begins with an equation.
            let verdict = if cells[0].starts_with("(1.") { 2 } else { 1 };
            let at = |index: usize| cells.get(verdict + index).cloned().unwrap_or_default();
            [at(1), at(2), at(3), at(0), at(4)]
        })
        .collect()
}

#[test]
fn every_name_of_the_table_exists() {
    let document = fs::read_to_string(root().join("docs/conformance.md")).unwrap();
    let rows = rows(&document);
    assert!(rows.len() > 40, "{} rows", rows.len());
    let quoted = |sources: &[String], name: &str| sources.iter().any(|text| text.contains(&format!("\"{name}\"")));
    let checks = texts("mdr-crosscheck");
    let is_entry = |id: &str| entries().iter().any(|entry| entry.id == id);
    let mut gone = Vec::new();
    for [function, check, test, verdict, physics] in &rows {
        gone.extend(spans(function).filter(|path| !exists(path)).map(|path| format!("function {path}")));
        let named = spans(check).chain(spans(physics));
        gone.extend(named.filter(|name| !quoted(&checks, name)).map(|name| format!("check {name}")));
        gone.extend(spans(test).filter(|path| !root().join(path).is_file()).map(|path| format!("test {path}")));
        gone.extend(spans(verdict).filter(|id| !is_entry(id)).map(|id| format!("entry {id}")));
    }
    assert!(gone.is_empty(), "docs/conformance.md names what there is not: {gone:?}");
}

/// The physics of a row is a check by the kernel of a medium, a reference to rows that have one, or said to be missing; and every
/// check by a kernel is the physics of a row.
#[test]
fn the_physics_of_each_row_is_a_kernel() {
    let document = fs::read_to_string(root().join("docs/conformance.md")).unwrap();
    let rows = rows(&document);
    let mut found = std::collections::BTreeSet::new();
    for [function, .., physics] in &rows {
        let named: Vec<_> = spans(physics).collect();
        let stated = physics.is_empty() || physics == "definition" || physics.starts_with("by (1.");
        assert!(stated || !named.is_empty(), "{function}: {physics}");
        assert!(named.iter().all(|name| name.ends_with("-kernel")), "{function}: {physics}");
        found.extend(named);
    }
    let kernels = mdr_crosscheck::check_names().into_iter().filter(|name| name.ends_with("-kernel"));
    assert_eq!(found, kernels.collect());
}

#[test]
fn a_name_that_is_gone_is_found() {
    for path in
        ["path::Ledger", "mdr_numeric::path::Ledger", "PowerLawContact::fates", "mdr_analytic::dugdale", "double::gone"]
    {
        assert!(!exists(path), "{path}");
    }
    for path in
        ["mdr_numeric::path::PathEnergy", "PowerLawContact::fate", "Control::Force", "profiles::FlatPunch", "struve"]
    {
        assert!(exists(path), "{path}");
    }
}
