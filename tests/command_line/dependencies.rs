//! docs/dependencies.md names every dependency of every package, and none that is not there.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use toml::de::{DeTable, DeValue};

use crate::root;

const DOCUMENT: &str = include_str!("../../docs/dependencies.md");

/// A dependency and the package that has it.
type Use = (String, String);

/// The manifests of the workspace, each with the name that the document has for its package.
fn manifests() -> Vec<(String, PathBuf)> {
    let crates = std::fs::read_dir(root().join("crates")).unwrap().map(|entry| entry.unwrap().path());
    let short = |folder: &Path| folder.file_name().unwrap().to_str().unwrap().trim_start_matches("mdr-").to_owned();
    let mut found: Vec<_> = crates.map(|folder| (short(&folder), folder.join("Cargo.toml"))).collect();
    found.push(("example".to_owned(), root().join("examples/jkr/Cargo.toml")));
    found.push(("tests".to_owned(), root().join("tests/Cargo.toml")));
    found
}

/// What the manifests list under `key`, but for packages of the workspace.
fn listed(key: &str) -> BTreeSet<Use> {
    let mut uses = BTreeSet::new();
    for (package, manifest) in manifests() {
        let text = std::fs::read_to_string(manifest).unwrap();
        let table = DeTable::parse(&text).unwrap();
        let Some(DeValue::Table(dependencies)) = table.get_ref().get(key).map(|value| value.get_ref()) else {
            continue;
        };
        let names = dependencies.keys().map(|name| name.get_ref().to_string()).filter(|name| !name.starts_with("mdr-"));
        uses.extend(names.map(|name| (name, package.clone())));
    }
    uses
}

/// What the table below a heading of the document names: dependencies in the first column, packages in the second.
fn named(heading: &str) -> BTreeSet<Use> {
    let packages: Vec<_> = manifests().into_iter().map(|(package, _)| package).collect();
    let (_, text) = DOCUMENT.split_once(heading).unwrap();
    let table = text.lines().skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|'));
    let mut uses = BTreeSet::new();
    for row in table.skip(2) {
        let [names, users, _] = row.trim_matches('|').split('|').collect::<Vec<_>>()[..] else { panic!("{row}") };
        let users: Vec<_> =
            packages.iter().filter(|package| users.split([' ', ',', ';']).any(|word| word == *package)).collect();
        for name in names.split('`').skip(1).step_by(2) {
            uses.extend(users.iter().map(|user| (name.to_owned(), (*user).clone())));
        }
    }
    uses
}

#[test]
fn the_document_names_each_dependency_with_the_crates_that_have_it() {
    assert_eq!(named("## What the crates link"), listed("dependencies"));
    assert_eq!(named("## What only tests and benchmarks use"), listed("dev-dependencies"));
}
