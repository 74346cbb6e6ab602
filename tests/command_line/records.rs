//! `mdr reference`.

use serde_json::Value;

use crate::{mdr, output};

#[test]
fn a_table_of_all_records() {
    let table = output("reference --filter id~/");
    let records = mdr_reference::records().len();
    assert!(table.contains(&format!("{records} of {records} records")), "{table}");
    assert!(table.contains("-4.7123889803846898576…"));
}

/// The README counts them.
#[test]
fn the_readme_counts_the_records() {
    let readme = include_str!("../../README.md");
    assert!(readme.contains(&format!("publishes {} [certified records]", mdr_reference::records().len())));
}

/// The inputs that the help names are inputs of records, each with a column of its own in CSV.
#[test]
fn filters_take_inputs() {
    let help = output("reference --help");
    for (term, column, value) in [("n=2", "input_n", "2"), ("w1=0", "input_w1", "0")] {
        assert!(help.contains(term), "{term}");
        let csv = output(&format!("reference --filter {term} --format csv"));
        let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let place = rows.next().unwrap().iter().position(|name| *name == column).unwrap();
        assert!(rows.all(|row| row[place] == value), "{term}");
    }
}

#[test]
fn one_record_in_full() {
    let text = output("reference --filter id=critical/jkr-unit/force/force --format json");
    let record: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(record["mid"], "-4.7123889803846898576939650749192543262957540990627");
    assert_eq!(record["f64"], "-0x1.2d97c7f3321d2p+2");
    let csv = output("reference --filter id=critical/jkr-unit/force/force --format csv");
    assert_eq!(csv.lines().count(), 2);
}

#[test]
fn exports_and_refuses() {
    let folder = std::env::temp_dir().join(format!("mdr-records-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let file = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    output(&format!("reference --export {}", file("all.jsonl")));
    let written = std::fs::read_to_string(file("all.jsonl")).unwrap();
    assert!(written.lines().eq(mdr_reference::lines()));
    output(&format!("reference --filter difficulty=higher --export {}", file("hard.csv")));
    assert!(std::fs::read_to_string(file("hard.csv")).unwrap().starts_with("id,release,profile,formula,"));
    let refused = mdr(&format!("reference --export {}", file("all.xls"))).assert().code(2).stdout_eq("");
    assert!(refused.get_output().stderr.starts_with(b"error: --export: must end in .jsonl or .csv"));
    mdr("reference --filter colour=red").assert().code(2).stdout_eq("");
    mdr("reference --filter id=none").assert().code(2).stdout_eq("");
    let nothing = ["--filter", "control=force control=indentation", "--format", "json"];
    mdr("reference").args(nothing).assert().code(2).stdout_eq("");
    std::fs::remove_dir_all(folder).unwrap();
}

/// The tables to copy: on standard output what the files of docs/reference hold, and in a file by its extension.
#[test]
fn tables_to_copy() {
    let list = output("reference --table");
    assert!(list.contains("jkr-sphere") && list.contains("43"), "{list}");
    assert!(output("reference --table jkr-sphere").contains("-4.71238898038469"));
    let published = |extension: &str| {
        std::fs::read_to_string(crate::root().join(format!("docs/reference/jkr-sphere.{extension}"))).unwrap()
    };
    for (flags, extension) in [
        ("--format csv", "csv"),
        ("--format json", "json"),
        ("--language c", "h"),
        ("--language python", "py"),
        ("--language fortran", "f90"),
        ("--language julia", "jl"),
    ] {
        assert_eq!(output(&format!("reference --table jkr-sphere {flags}")), published(extension), "{flags}");
        let file = std::env::temp_dir().join(format!("mdr-table-{}.{extension}", std::process::id()));
        let said = output(&format!("reference --table jkr-sphere --export {}", file.display()));
        assert!(said.ends_with(": 43 rows\n"), "{said}");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), published(extension));
        std::fs::remove_file(file).unwrap();
    }
    for (refused, why) in [
        ("--table jkr", "error: --table: must be one of jkr-sphere, got jkr\n"),
        (
            "--table jkr-sphere --export table.xls",
            "error: --export: must end in .csv, .json, .h, .py, .f90 or .jl, got table.xls\n",
        ),
    ] {
        mdr(&format!("reference {refused}")).assert().code(2).stdout_eq("").stderr_eq(why);
    }
    for refused in ["--language c", "--table --filter id~jkr", "--table jkr-sphere --language c --format csv"] {
        mdr(&format!("reference {refused}")).assert().code(2).stdout_eq("");
    }
}

/// Without a filter there is a line for each family, and all records are in one of them.
#[test]
fn the_summary_counts_every_record() {
    let summary = output("reference");
    let (table, total) = summary.rsplit_once("\n\n").unwrap();
    let counts = table.lines().skip(1).map(|line| line.split_whitespace().nth(1).unwrap().parse::<usize>().unwrap());
    let records = output("reference --format json").lines().count();
    assert_eq!(counts.sum::<usize>(), records);
    assert!(total.starts_with(&format!("{records} records")) && summary.lines().count() < 25, "{summary}");
}
