//! `mdr verify`.

use serde_json::Value;

use crate::{mdr, output};

fn lines(arguments: &str) -> Vec<Value> {
    output(&format!("verify {arguments} --format json"))
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

#[test]
fn every_check_holds() {
    // The whole of it is `make verify ARGS=--quick`.
    let rows = lines("--quick --shard 1/8");
    assert!(rows.len() >= 10, "only {} checks", rows.len());
    for line in rows {
        assert_eq!(line["schema"], "mdr.verify/1");
        let row = &line["row"];
        assert_eq!(row["verdict"], "pass", "{row}");
        assert!(row["cases"].as_u64().unwrap() > 0);
    }
}

#[test]
fn a_table_with_the_verdict() {
    let table = output("verify --quick --shard 1/16");
    for part in [
        "check",
        "cases",
        "worst error",
        "allowed",
        "verdict",
        "pass",
        " 0 failed",
        "  u         relative error 2^-p at p bits",
    ] {
        assert!(table.contains(part), "{part:?} in\n{table}");
    }
    assert!(!table.contains('\u{1b}'), "no colours in a pipe");
}

#[test]
fn rows_for_a_spreadsheet() {
    let csv = output("verify --quick --shard 2/16 --format csv");
    assert!(csv.starts_with("check,claim,equations,cases,"), "{csv}");
    assert!(csv.lines().count() > 10);
}

/// A few checks, which is enough for the mechanics.
const RUN: &str = "--quick --seed 5 --only kappa-gamma,effective-modulus,jkr";

/// Shards are parts of the whole: merged, they are the run in one piece, bit for bit; incomplete, they are refused.
#[test]
fn shards_merge() {
    let directory = std::env::temp_dir().join(format!("mdr-shards-{}", std::process::id()));
    std::fs::create_dir_all(&directory).unwrap();
    let files: Vec<_> = (1..=3)
        .map(|shard| {
            let path = directory.join(format!("{shard}.jsonl"));
            std::fs::write(&path, output(&format!("verify {RUN} --shard {shard}/3 --format json"))).unwrap();
            path.to_str().unwrap().to_owned()
        })
        .collect();
    let merged = output(&format!("verify --format json --merge {} {} {}", files[2], files[0], files[1]));
    assert_eq!(merged, output(&format!("verify {RUN} --format json")));
    let incomplete = mdr(&format!("verify --merge {} {}", files[0], files[1])).assert().code(2).stdout_eq("");
    assert!(incomplete.get_output().stderr.starts_with(b"error: --merge: "));
    let failed = std::fs::read_to_string(&files[0]).unwrap().replace(r#""failed":0"#, r#""failed":1"#);
    std::fs::write(&files[0], failed).unwrap();
    mdr(&format!("verify --merge {}", files.join(" "))).assert().code(1);
    std::fs::remove_dir_all(directory).unwrap();
}

#[test]
fn other_seeds_take_other_cases() {
    let with_seed = |seed| lines(&format!("--quick --only effective-modulus --seed {seed}"));
    assert_ne!(with_seed(1), with_seed(2));
    assert_eq!(with_seed(1), with_seed(1));
    assert_eq!(with_seed(1).len(), 1);
}
