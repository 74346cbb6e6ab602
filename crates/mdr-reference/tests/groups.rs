//! Where each group of records comes from: `data/groups.json` says what the records of a file say about one question.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{env, fs};

use mdr_reference::Record;
use serde_json::{Value, json};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data")
}

/// The files of records, by their names.
fn files() -> Vec<(String, Vec<Record>)> {
    let mut files: Vec<_> = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "jsonl"));
    files.sort();
    let records =
        |path: &PathBuf| fs::read_to_string(path).unwrap().lines().map(|l| Record::from_json(l).unwrap()).collect();
    files.iter().map(|path| (path.file_name().unwrap().to_str().unwrap().to_owned(), records(path))).collect()
}

/// The texts of all records of a group, each once.
fn all<'a, T: Ord>(group: &[&'a Record], texts: impl Fn(&'a Record) -> Vec<T>) -> Vec<T> {
    group.iter().flat_map(|record| texts(record)).collect::<BTreeSet<_>>().into_iter().collect()
}

fn description(file: &str, formula: &str, group: &[&Record]) -> Value {
    let methods = |rigorous: bool| {
        all(group, |record| {
            record.methods.iter().filter(|method| method.rigorous == rigorous).map(|method| &method.name).collect()
        })
    };
    json!({
        "file": file,
        "formula": formula,
        "records": group.len(),
        "releases": all(group, |record| vec![record.release]),
        "certified_by": methods(true),
        "confirmed_by": methods(false),
        "confirmed_outside_by": if formula == "fit" { "tests/confirm_fits.py" } else { "tests/confirm_records.py" },
        "proof": all(group, |record| record.proof.iter().collect()),
        "refs": all(group, |record| record.refs.iter().collect()),
        "generated_by": "mdr reference --generate",
        "licence": "CC0-1.0",
    })
}

/// `MDR_RENEW=1 cargo test -p mdr-reference --test groups` writes it anew.
#[test]
fn the_groups_are_those_of_the_records() {
    let mut groups = Vec::new();
    for (file, records) in files() {
        let mut formulas: BTreeMap<&str, Vec<&Record>> = BTreeMap::new();
        records.iter().for_each(|record| formulas.entry(&record.formula).or_default().push(record));
        groups.extend(formulas.iter().map(|(formula, group)| description(&file, formula, group).to_string()));
    }
    let written = format!("[\n{}\n]\n", groups.join(",\n"));
    let path = folder().join("groups.json");
    if env::var_os("MDR_RENEW").is_some() {
        fs::write(&path, &written).unwrap();
    }
    assert_eq!(fs::read_to_string(&path).unwrap(), written);
}

/// Each group with a number has a rigorous method, a second one, a derivation and a source; all files are published.
#[test]
fn each_group_has_its_provenance() {
    let groups: Vec<Value> = serde_json::from_str(&fs::read_to_string(folder().join("groups.json")).unwrap()).unwrap();
    let count: u64 = groups.iter().map(|group| group["records"].as_u64().unwrap()).sum();
    assert_eq!(count as usize, mdr_reference::records().len());
    for group in &groups {
        for key in ["certified_by", "refs", "releases"] {
            assert!(!group[key].as_array().unwrap().is_empty(), "{key}: {group}");
        }
    }
}
