//! `mdr report`: its files, and the page that shows them.

use std::path::{Path, PathBuf};

use snapbox::str;

use crate::mdr;

/// An empty directory of this test.
fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // It may be there from an earlier run.
    let _ = std::fs::remove_dir_all(&path);
    path
}

/// A quick report on one task, with everything that a reader opens.
#[test]
fn a_report_on_one_task() {
    let path = directory("report-kappa");
    let run = mdr(&format!("report --quick --only kappa --format csv --out {}", path.display())).assert().success();
    let csv = String::from_utf8(run.get_output().stdout.clone()).unwrap();
    // Times are those of the day: the first ten columns.
    let rows: Vec<Vec<String>> = csv::Reader::from_reader(csv.as_bytes())
        .records()
        .map(|row| row.unwrap().iter().map(str::to_owned).collect())
        .collect();
    let shown: String = rows.iter().take(6).map(|row| row[..10].join(" | ") + "\n").collect();
    snapbox::assert_data_eq!(
        shown,
        str![[r#"
kappa | kappa-1e-6 | shipped, f64 | f64 | false | f64 | at-least | 15.95 |  | 
kappa | kappa-1e-6 | extended precision | f64 | false | 64 bits | at-least | 15.95 |  | 
kappa | kappa-1e-6 | extended precision | f64 | false | 128 bits | at-least | 15.95 |  | 
kappa | kappa-1e-6 | extended precision | f64 | false | 256 bits | at-least | 15.95 |  | 
kappa | kappa-1e-6 | Γ quotient, pxfm | f64 | false | f64 | at-least | 15.95 |  | 
kappa | kappa-1e-6 | Γ quotient, statrs | f64 | false | f64 | digits | 15.34 |  | 

"#]]
    );
    assert!(rows.iter().all(|row| row[10..13].iter().all(|time| time.parse::<f64>().is_ok_and(|time| time > 0.0))));
    let overview = std::fs::read_to_string(path.join("README.md")).unwrap();
    for part in
        ["## kappa\n", "](kappa-summary.svg)", "| question | 6 | 12 | 15 |", "    mdr report --quick --only kappa\n"]
    {
        assert!(overview.contains(part), "{part} in\n{overview}");
    }
    assert!(!overview.contains("interrupted") && overview.contains("`mdr report --only fold`"), "{overview}");
    let page = std::fs::read_to_string(path.join("kappa.md")).unwrap();
    let links: Vec<_> = [&overview, &page].into_iter().flat_map(|page| links(page)).collect();
    assert!(links.len() >= 18, "{page}");
    for link in &links {
        assert!(path.join(link).is_file(), "{link}");
    }
    for svg in links.iter().filter(|link| link.ends_with(".svg")) {
        let text = std::fs::read_to_string(path.join(svg)).unwrap();
        assert!(text.len() < 100_000, "{svg}: {} bytes", text.len());
        roxmltree::Document::parse(&text).unwrap();
    }
    for part in [
        "# kappa\n",
        "## What failed or was stopped\n",
        "## What was left out\n",
        "    mdr report --quick --only kappa\n",
    ] {
        assert!(page.contains(part), "{part}");
    }
    let json: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path.join("report.json")).unwrap()).unwrap();
    assert_eq!((&json["schema"], &json["tasks"][0]["made"]["effort"]), (&"mdr.report/2".into(), &"quick".into()));
    let diagrams = json["tasks"][0]["diagrams"].as_array().unwrap();
    assert!(diagrams.iter().all(|diagram| path.join(format!("{}.csv", diagram["id"].as_str().unwrap())).is_file()));
    let points = diagrams.iter().flat_map(|diagram| diagram["curves"].as_array().unwrap());
    let points: usize = points.map(|curve| curve["points"].as_array().unwrap().len()).sum();
    assert_eq!(points, rows.len(), "every point is on standard output");
}

/// The files that a page links to.
fn links(page: &str) -> Vec<&str> {
    let links = page.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
    links.filter(|link| !link.starts_with('#')).collect()
}

/// The ladders alone: a picture and data of each family, and one table. What is known of another task stays.
#[test]
fn a_report_on_the_ladders_beside_another() {
    let path = directory("report-ladders");
    for task in ["kappa", "ladders"] {
        mdr(&format!("report --quick --only {task} --out {}", path.display())).assert().success();
    }
    let page = std::fs::read_to_string(path.join("ladders.md")).unwrap();
    assert_eq!(links(&page).len(), 25, "{page}");
    let overview = std::fs::read_to_string(path.join("README.md")).unwrap();
    for link in links(&page).into_iter().chain(links(&overview)) {
        assert!(path.join(link).is_file(), "{link}");
    }
    assert!(page.starts_with("# ladders\n") && !page.contains(" | open: "), "{page}");
    for part in ["\n## kappa\n", "\n## ladders\n", "](kappa-summary.svg)", "](ladders-summary.svg)"] {
        assert!(overview.contains(part), "{part} in\n{overview}");
    }
}

/// A directory with a report of another version is left as it is.
#[test]
fn a_report_that_is_not_understood_is_not_overwritten() {
    let path = directory("report-other");
    std::fs::create_dir_all(&path).unwrap();
    std::fs::write(path.join("report.json"), "{}").unwrap();
    let run = mdr(&format!("report --quick --only kappa --out {}", path.display())).assert().code(2).stdout_eq("");
    let error = String::from_utf8(run.get_output().stderr.clone()).unwrap();
    assert!(error.contains("report.json") && error.contains("choose another --out"), "{error}");
    assert!(!path.join("README.md").exists());
}

#[test]
fn a_task_that_is_none_is_refused() {
    let run = mdr("report --only kapa").assert().code(2).stdout_eq("");
    let error = String::from_utf8(run.get_output().stderr.clone()).unwrap();
    assert!(error.starts_with("error: --only: must be one of kappa"), "{error}");
}

#[test]
fn a_directory_that_cannot_be_made_is_named() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml/report");
    let run = mdr(&format!("report --only kappa --out {file}")).assert().code(2).stdout_eq("");
    let error = String::from_utf8(run.get_output().stderr.clone()).unwrap();
    assert!(error.starts_with(&format!("error: --out {file}: ")), "{error}");
}

/// The baseline of the documents is read, and a change for the worse is told.
#[test]
fn a_baseline_that_asks_for_more_is_not_met() {
    let checked_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/report/baseline.jsonl");
    let text = std::fs::read_to_string(checked_in).unwrap();
    let better = Path::new(env!("CARGO_TARGET_TMPDIR")).join("better.jsonl");
    let line = text.lines().find(|line| line.contains("Brouncker") && line.contains("kappa-0.25")).unwrap();
    let (before, _) = line.split_once(",\"digits\":").unwrap();
    std::fs::write(&better, text.replace(line, &format!("{before},\"digits\":99.9,\"evaluations\":1}}"))).unwrap();
    let run = mdr(&format!("report --check {}", better.display())).assert().code(1).stderr_eq("");
    let told = String::from_utf8(run.get_output().stdout.clone()).unwrap();
    let lines: Vec<_> = told.lines().collect();
    assert!(
        lines.len() == 3 && lines[0].contains("digits, were 99.9") && lines[1].contains("evaluations, were 1"),
        "{told}"
    );
    assert!(lines[2].ends_with(" settings compared, 2 worse or unknown"), "{told}");
}
