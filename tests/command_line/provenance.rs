//! Every head of JSON, comment of CSV and drawing names the release and the commit that computed it.

use std::path::Path;

use serde_json::Value;

use crate::{mdr, output, raw, root};

/// An empty folder for one test.
fn folder(name: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("provenance").join(name);
    drop(std::fs::remove_dir_all(&folder));
    std::fs::create_dir_all(&folder).unwrap();
    folder.display().to_string()
}

/// The release, and in brackets a commit of this repository if it is one; a `+` marks changes.
fn is_program(text: &str) -> bool {
    let release = concat!("mdr ", env!("CARGO_PKG_VERSION"));
    let commit = text.strip_prefix(release).and_then(|rest| rest.strip_prefix(" (")?.strip_suffix(')'));
    let digits = |commit: &str| commit.trim_end_matches('+').chars().all(|digit| digit.is_ascii_hexdigit());
    text == release || commit.is_some_and(|commit| commit.len() >= 7 && digits(commit))
}

#[test]
fn every_head_of_json_names_the_program() {
    let commands = [
        "critical --n 2 --c 1 --e-star 1 --work 1 --format json",
        "solve examples/scenes/paraboloid.toml --f64 --format json",
        "fit examples/fits/tip.toml --format json",
        "verify --quick --only kappa-product --format json",
        &format!("figures --out {} --format json", folder("figures")),
    ];
    for command in commands {
        let text = raw(command);
        for line in text.lines() {
            let value: Value = serde_json::from_str(line).unwrap();
            assert!(value["program"].as_str().is_some_and(is_program), "{command}: {}", value["program"]);
            assert!(line.starts_with("{\"schema\":\"mdr.") && line.matches("\"program\":").count() == 1, "{line}");
        }
        assert!(!output(command).contains("\"program\""), "{command}");
    }
}

/// The answers of a batch, and the refusals among them.
#[test]
fn every_line_of_a_batch_names_the_program() {
    let file = Path::new(&folder("batch")).join("batch.jsonl");
    std::fs::write(&file, "{\"n\":2,\"c\":1,\"e_star\":1,\"work\":1}\n{\"n\":0}\n").unwrap();
    let assert = mdr(&format!("critical --batch {} --f64 --format json", file.display())).assert().code(1);
    let text = String::from_utf8(assert.get_output().stdout.clone()).unwrap();
    assert_eq!(text.lines().count(), 2);
    for line in text.lines() {
        let value: Value = serde_json::from_str(line).unwrap();
        assert!(value["program"].as_str().is_some_and(is_program), "{line}");
    }
}

#[test]
fn files_of_csv_and_drawings_name_the_program() {
    let folder = folder("files");
    raw(&format!("solve examples/scenes/paraboloid.toml --f64 --out {folder}"));
    raw(&format!("solve docs/figures/cycle.toml --plot {folder}/cycle.svg"));
    // Over its own files, which are recognised below the comment.
    raw(&format!("solve docs/figures/cycle.toml --plot {folder}/cycle.svg"));
    let mut files = 0;
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let text = std::fs::read_to_string(&path).unwrap();
        if path.extension().is_some_and(|extension| extension == "svg") {
            let drawing = roxmltree::Document::parse(&text).unwrap();
            let found = drawing.descendants().find(|node| node.has_tag_name("metadata")).and_then(|node| node.text());
            assert!(found.is_some_and(is_program), "{found:?}");
        } else {
            let first = text.lines().next().unwrap();
            assert!(first.strip_prefix("# ").is_some_and(is_program), "{}: {first}", path.display());
        }
        files += 1;
    }
    assert!(files >= 3, "{files}");
    // A table on standard output begins with its header, as it always has.
    assert!(raw("solve examples/scenes/paraboloid.toml --f64 --format csv").starts_with("output,"));
}

/// A citation has the commit beside the release.
#[test]
fn a_citation_names_the_commit() {
    let cited: Value = serde_json::from_str(&raw("cite --format json")).unwrap();
    let head: Value =
        serde_json::from_str(&raw("critical --n 2 --c 1 --e-star 1 --work 1 --f64 --format json")).unwrap();
    let commit = cited["program"]["commit"].as_str().map_or_else(String::new, |commit| format!(" ({commit})"));
    assert_eq!(head["program"], format!("mdr {}{commit}", env!("CARGO_PKG_VERSION")));
    // In a repository with git, which is where the tests run.
    assert_eq!(commit.is_empty(), !root().join(".git").exists() || option_env!("MDR_COMMIT").is_some());
}
