//! The program `mdr`, as a user meets it.

#![allow(clippy::unwrap_used, reason = "in a test a panic is a verdict")]

mod bad_input;
mod budgets;
mod certificate;
mod cite;
mod critical;
mod decimal;
mod dependencies;
mod derive;
mod doors;
mod doubles;
mod equator;
mod figures;
mod fit;
mod help;
mod judge;
mod plot;
mod power_laws;
mod precision;
mod provenance;
mod reader;
mod readme;
mod records;
mod reference;
mod report;
mod scene_kinks;
mod scene_needs;
mod solve;
mod solve_costs;
mod solve_paths;
mod solve_statuses;
mod solve_tables;
mod sweeps;
mod units;
mod validity;
mod verify;

use std::path::{Path, PathBuf};

use serde_json::Value;
use snapbox::cmd::Command;

/// The folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// `mdr` with the arguments of a line, called from the folder of the repository.
fn mdr(arguments: &str) -> Command {
    Command::new(env!("CARGO_BIN_EXE_mdr")).args(arguments.split_whitespace()).current_dir(root())
}

/// The standard output of a successful `mdr`, without the program that it names: no golden depends on a commit.
fn output(arguments: &str) -> String {
    without_program(&raw(arguments))
}

/// The standard output of a successful `mdr`, as it is.
fn raw(arguments: &str) -> String {
    let assert = mdr(arguments).assert().success().stderr_eq("");
    String::from_utf8(assert.get_output().stdout.clone()).unwrap()
}

/// JSON, CSV or SVG without the release and the commit of the program.
fn without_program(text: &str) -> String {
    let mut text = text.to_owned();
    for (start, end) in [("\"program\":\"mdr ", "\","), ("<metadata>mdr ", "</metadata>"), ("# mdr ", "\n")] {
        while let Some(at) = text.find(start) {
            let length = text[at..].find(end).unwrap() + end.len();
            text.replace_range(at..at + length, "");
        }
    }
    text
}

/// The answer of `mdr critical`.
fn critical(arguments: &str) -> Value {
    let text = output(&format!("critical {arguments} --format json"));
    assert_eq!(text.lines().count(), 1, "one object, one line");
    serde_json::from_str(&text).unwrap()
}

/// The text under a key.
fn text<'a>(answer: &'a Value, key: &str) -> &'a str {
    answer[key].as_str().unwrap_or_else(|| panic!("{key} is no text in {answer}"))
}

/// The answer of `mdr solve` to a scene from standard input.
fn solved(scene: &str, flags: &str) -> Value {
    let assert = mdr(&format!("solve - {flags} --format json")).stdin(scene).assert().success().stderr_eq("");
    serde_json::from_slice(&assert.get_output().stdout).unwrap()
}

/// A number, written as text or not.
fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap_or_else(|| panic!("{value}")).parse().unwrap())
}

/// The events of a path, by name.
fn events(answer: &Value) -> Vec<&str> {
    answer["path"].as_array().unwrap().iter().map(|event| event["event"].as_str().unwrap()).collect()
}
