//! `mdr report`: its files, and the page that shows them.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::mdr;

/// An empty directory of this test.
fn directory(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    // It may be there from an earlier run.
    let _ = std::fs::remove_dir_all(&path);
    path
}

/// A quick report with everything that a reader opens.
#[test]
fn a_quick_report() {
    let path = directory("report");
    let run = mdr(&format!("report --quick --format json --out {}", path.display())).assert().success();
    let lines: Vec<Value> = str::from_utf8(&run.get_output().stdout)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert!(lines.iter().all(|line| line["schema"] == "mdr.report/3"));
    let read = |name: &str| std::fs::read_to_string(path.join(name)).unwrap();
    let page = read("README.md");
    for part in ["## Error against run time\n", "## Stability ladders\n", "    mdr report --quick\n", "Machine: "] {
        assert!(page.contains(part), "{part} in\n{page}");
    }
    let links: Vec<_> = page.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()).collect();
    assert_eq!(links.len(), 6, "two files of data and four pictures: {links:?}");
    assert!(links.iter().all(|link| path.join(link).is_file()), "{links:?}");
    assert_eq!(std::fs::read_dir(&path).unwrap().count(), 7);

    // Every answer and every ladder is a row of the data and in the lines of JSON.
    let rows = |name: &str| {
        csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_path(path.join(name))
            .unwrap()
            .into_records()
            .map(Result::unwrap)
    };
    let points = lines.iter().filter_map(|line| line["comparison"]["series"].as_array()).flatten();
    let points: Vec<_> = points.flat_map(|series| series["points"].as_array().unwrap()).collect();
    assert_eq!(rows("work-precision.csv").count(), points.len());
    assert!(points.iter().all(|point| point["seconds"].as_f64().is_some_and(|seconds| seconds > 0.0)));
    assert!(points.iter().all(|point| point["digits"].is_number() != point["failed"].is_string()), "{points:?}");
    assert_eq!(rows("ladders.csv").count(), lines.iter().filter(|line| line["ladder"].is_object()).count());

    // Every method is named at its row, every question above its panel.
    for line in lines.iter().filter(|line| line["comparison"].is_object()) {
        let comparison = &line["comparison"];
        let task = comparison["id"].as_str().unwrap().split('-').next().unwrap();
        let svg = read(&format!("{task}.svg"));
        let document = roxmltree::Document::parse(&svg).unwrap();
        // A long text has several lines, and an index or an exponent its own element.
        let bare = |text: &str| text.replace(|letter: char| letter.is_whitespace() || "_^()".contains(letter), "");
        let drawn = document.descendants().filter(|node| node.has_tag_name("text"));
        let drawn = drawn.flat_map(|node| node.descendants().filter(|part| part.is_text()));
        let drawn = bare(&drawn.filter_map(|part| part.text()).collect::<String>());
        let methods = comparison["series"].as_array().unwrap().iter().map(|series| {
            let by = if series["ours"] == true { "" } else { " (textbook)" };
            format!("{}{by}", series["method"].as_str().unwrap())
        });
        for text in methods.chain([comparison["title"].as_str().unwrap().to_owned()]) {
            assert!(drawn.contains(&bare(&text)), "{text} in {task}.svg: {drawn}");
        }
    }
}

#[test]
fn a_directory_that_cannot_be_made_is_named() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml/report");
    let run = mdr(&format!("report --out {file}")).assert().code(2).stdout_eq("");
    let error = String::from_utf8(run.get_output().stderr.clone()).unwrap();
    assert!(error.starts_with(&format!("error: --out {file}: ")), "{error}");
}
