//! The faults of docs/soundness.tsv: each has a test that exists, and docs/soundness.md shows them all.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Fault, source, change, and the tests that failed with it, as `file::name`.
fn rows() -> Vec<[String; 4]> {
    let text = fs::read_to_string(root().join("docs/soundness.tsv")).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split('\t').map(str::to_owned).collect::<Vec<_>>().try_into().unwrap()).collect()
}

/// Whether a test of this name is there: a function, or a property of a macro that ends in one.
fn is_there(test: &str) -> bool {
    let (file, name) = test.rsplit_once("::").unwrap();
    let text = fs::read_to_string(root().join(file)).unwrap_or_default();
    let row = file.ends_with(".tsv") && text.lines().any(|line| line.split('\t').next() == Some(name));
    row || text.contains(&format!("fn {name}("))
        || text.lines().any(|line| line.trim().starts_with(&format!("{name}: ")))
}

#[test]
fn every_fault_has_tests_that_exist() {
    let rows = rows();
    let faults: BTreeSet<&str> = rows.iter().map(|row| row[0].as_str()).collect();
    assert_eq!(faults.len(), rows.len(), "a fault is there twice");
    assert!(rows.len() >= 15, "{}", rows.len());
    for [fault, source, change, tests] in &rows {
        assert!(root().join(source).is_file(), "{fault}: {source}");
        assert!(!change.is_empty(), "{fault}");
        assert!(!tests.is_empty(), "{fault}: nothing catches it");
        for test in tests.split(' ') {
            assert!(is_there(test), "{fault}: {test}");
        }
    }
    assert!(!is_there("tests/soundness.rs::gone") && !is_there("tests/gone.rs::every_fault_has_tests_that_exist"));
}

/// The page that the book prints has the rows of the list, in their order.
#[test]
fn the_page_shows_the_list() {
    let page = fs::read_to_string(root().join("docs/soundness.md")).unwrap();
    let shown: Vec<Vec<String>> = page
        .lines()
        .filter(|line| line.starts_with("| ") && !line.starts_with("| fault |"))
        .map(|line| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect())
        .collect();
    let listed: Vec<Vec<String>> = rows()
        .into_iter()
        .map(|[fault, source, change, tests]| {
            let short = |path: &str| format!("`{path}`");
            let tests: Vec<_> = tests.split(' ').map(short).collect();
            vec![fault, short(&source), change, tests.join(" ")]
        })
        .collect();
    assert_eq!(shown, listed, "docs/soundness.md is not what docs/soundness.tsv says");
}
