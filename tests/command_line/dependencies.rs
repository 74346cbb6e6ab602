//! docs/dependencies.md names every dependency of every package, and none that is not there; and the packages of the
//! workspace depend on each other only along the arrows of the design.

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
    found.push(("book".to_owned(), root().join("book/Cargo.toml")));
    found.push(("tests".to_owned(), root().join("tests/Cargo.toml")));
    found
}

/// What a manifest lists under `key`.
fn dependencies(manifest: &Path, key: &str) -> Vec<String> {
    let text = std::fs::read_to_string(manifest).unwrap();
    let table = DeTable::parse(&text).unwrap();
    match table.get_ref().get(key).map(|value| value.get_ref()) {
        Some(DeValue::Table(dependencies)) => dependencies.keys().map(|name| name.get_ref().to_string()).collect(),
        _ => Vec::new(),
    }
}

/// What the manifests list under `key`, but for packages of the workspace.
fn listed(key: &str) -> BTreeSet<Use> {
    let uses = manifests().into_iter().flat_map(|(package, manifest)| {
        let names = dependencies(&manifest, key).into_iter().filter(|name| !name.starts_with("mdr-"));
        names.map(move |name| (name, package.clone())).collect::<Vec<_>>()
    });
    uses.collect()
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

/// Closed forms and the numerical route never see each other: that separation is the verification. Published data and the
/// algebra stand alone.
#[test]
fn the_packages_see_only_what_the_design_lets_them_see() {
    let arrows: &[(&str, &[&str])] = &[
        ("core", &[]),
        ("analytic", &["core"]),
        ("numeric", &["core"]),
        ("symbolic", &[]),
        ("provenance", &[]),
        ("reference", &[]),
        ("crosscheck", &["analytic", "core", "numeric", "symbolic"]),
        ("mdr", &["analytic", "core", "numeric"]),
        ("fit", &["analytic", "contact", "core", "numeric"]),
        ("plot", &["contact", "fit", "reference"]),
        ("records", &["analytic", "contact", "core", "fit", "numeric", "reference"]),
        ("python", &["contact", "fit", "plot", "provenance", "reference"]),
        ("capi", &["contact"]),
        ("book", &["contact", "crosscheck", "fit", "plot", "reference", "symbolic"]),
        (
            "cli",
            &[
                "analytic",
                "contact",
                "core",
                "crosscheck",
                "fit",
                "numeric",
                "plot",
                "provenance",
                "records",
                "reference",
                "symbolic",
            ],
        ),
    ];
    for (package, manifest) in manifests() {
        let Some((_, seen)) = arrows.iter().find(|(name, _)| *name == package) else {
            assert!(["example", "tests"].contains(&package.as_str()), "no arrows are known of {package}");
            continue;
        };
        let found = dependencies(&manifest, "dependencies");
        let mut found: Vec<_> = found.iter().filter_map(|name| name.strip_prefix("mdr-")).collect();
        found.sort_unstable();
        assert_eq!(found, *seen, "dependencies of {package}");
    }
}

/// Where all tests of a package are one program, a file that is no module of it would never run. The folder `private` has
/// modules of the source.
#[test]
fn every_file_of_tests_is_a_module_of_their_program() {
    for (package, manifest) in manifests() {
        let folder = manifest.with_file_name("tests");
        let Ok(program) = std::fs::read_to_string(folder.join("main.rs")) else { continue };
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap();
            let is_module = path.is_dir() || path.extension().is_some_and(|extension| extension == "rs");
            let listed =
                ["main", "private"].contains(&name) || program.lines().any(|line| line == format!("mod {name};"));
            assert!(listed || !is_module, "{package}: tests/{name} is not in tests/main.rs");
        }
    }
}
